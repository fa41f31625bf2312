"""Files appear whole or not at all, and none is overwritten unless that is asked for."""

from __future__ import annotations

import contextlib
import os
import tempfile
from collections.abc import Iterator
from pathlib import Path

__all__ = ["refuse_existing", "whole", "write_whole"]


def refuse_existing(*paths: Path, force: bool = False) -> None:
    """Raise FileExistsError with a sentence if one of the files is there already; call it before work."""
    there = [str(p) for p in paths if p.exists()]
    if there and not force:
        raise FileExistsError(f"{', '.join(there)} exists. Give --force to overwrite, or another place with --out.")


@contextlib.contextmanager
def whole(path: Path, *, force: bool = False) -> Iterator[Path]:
    """A temporary path beside ``path`` to write to; it becomes ``path`` at the end, or goes on failure."""
    refuse_existing(path, force=force)
    path.parent.mkdir(parents=True, exist_ok=True)
    handle, name = tempfile.mkstemp(dir=path.parent, prefix=f".{path.stem}-", suffix=path.suffix)
    os.close(handle)
    temporary = Path(name)
    try:
        yield temporary
        temporary.chmod(0o666 & ~_umask())
        temporary.replace(path)
    finally:
        temporary.unlink(missing_ok=True)


def write_whole(path: Path, content: str | bytes, *, force: bool = False) -> Path:
    """Write text (UTF-8) or bytes to ``path`` in one piece."""
    with whole(path, force=force) as temporary:
        temporary.write_bytes(content if isinstance(content, bytes) else content.encode())
    return path


def _umask() -> int:
    current = os.umask(0)
    os.umask(current)
    return current

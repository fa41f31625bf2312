"""Files appear whole or not at all, and none is overwritten unless that is asked for."""

from __future__ import annotations

import contextlib
import os
import shutil
import tempfile
from collections.abc import Iterator
from pathlib import Path

__all__ = ["refuse_existing", "whole", "whole_folder", "write_whole"]

MARKER = ".drawbar"


def refuse_existing(*paths: Path, force: bool = False) -> None:
    """Raise OSError with a sentence if one of the files is there already, or cannot be; call it before work."""
    for path in paths:
        above = next(p for p in path.absolute().parents if p.exists())
        if not above.is_dir():
            raise NotADirectoryError(f"{above} is a file, and {path.name} cannot go into it. Give a folder with --out.")
    there = [str(p) for p in paths if p.exists()]
    if there and not force:
        verb = "exists" if len(there) == 1 else "exist"
        raise FileExistsError(f"{', '.join(there)} {verb}. Give --force to overwrite, or another place with --out.")


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


@contextlib.contextmanager
def whole_folder(path: Path, *, force: bool = False) -> Iterator[Path]:
    """A temporary folder beside ``path`` to fill; it becomes ``path`` at the end, or goes on failure.

    With ``force`` an existing folder is replaced, but only one that was written this way before: it
    holds a marker, so that a slip of the keyboard cannot delete what is not ours.
    """
    occupied = path.exists() and (not path.is_dir() or any(path.iterdir()))
    if occupied and not force:
        raise FileExistsError(f"{path} exists. Give --force to overwrite, or another place with --out.")
    if occupied and not (path / MARKER).is_file():
        raise FileExistsError(
            f"{path} holds other files, which --force will not delete. Give another place with --out."
        )
    path.parent.mkdir(parents=True, exist_ok=True)
    temporary = Path(tempfile.mkdtemp(dir=path.parent, prefix=f".{path.name}-"))
    try:
        yield temporary
        (temporary / MARKER).write_text("written whole by drawbar\n")
        temporary.chmod(0o777 & ~_umask())
        if path.exists():
            old = Path(tempfile.mkdtemp(dir=path.parent, prefix=f".{path.name}-old-"))
            path.replace(old / path.name)
            temporary.replace(path)
            shutil.rmtree(old)
        else:
            temporary.replace(path)
    finally:
        shutil.rmtree(temporary, ignore_errors=True)

"""Every tissue, film and wheel there is, by name: laws, ready-made presets, and small TOML files.

A tissue, film or wheel is named on a command line in one of three ways::

    foam-2004                               a preset
    fitted-liver.toml                       a file, as written by an identification
    "Winkler(stiffness=225 kPa/m)"          a law with its quantities, units allowed

A quantity that is a series of numbers stands in brackets, on the command line as in a file, each number with
its own unit or in SI (in a file, quote what has a unit)::

    "Prony(stiffness=100 kPa/m, branch_stiffnesses=[1e5, 2e5], relaxation_times=[100 ms, 1 s])"
"""

from __future__ import annotations

import importlib
import inspect
import pkgutil
import re
import tomllib
from pathlib import Path
from typing import Any

import drawbar.film
import drawbar.sources
import drawbar.tissue
import drawbar.wheel
from drawbar.files import write_whole
from drawbar.film.base import Film
from drawbar.quantity import Quantity, parameters, quantities
from drawbar.rig.sensors import Sensors
from drawbar.tissue.base import Tissue
from drawbar.units import si
from drawbar.variables import nearest
from drawbar.wheel.base import Wheel

__all__ = ["KINDS", "find", "laws", "presets", "save", "sensors", "to_toml"]

KINDS: dict[str, type] = {"tissue": Tissue, "film": Film, "wheel": Wheel}

_CALL = re.compile(r"\s*([A-Za-z_]\w*)\s*\((.*)\)\s*$", re.DOTALL)
_COMMA = re.compile(r",(?![^\[(]*[\])])")  # one that is not inside brackets


def laws(kind: str) -> dict[str, type]:
    """The laws of a kind (``tissue``, ``film``, ``wheel``) by name: every file of the kind's folder."""
    folder = {"tissue": drawbar.tissue, "film": drawbar.film, "wheel": drawbar.wheel}[kind]
    for module in pkgutil.iter_modules(folder.__path__):
        importlib.import_module(f"{folder.__name__}.{module.name}")
    if kind == "wheel":
        return {"Wheel": Wheel}
    return dict(sorted(KINDS[kind].registry.items()))  # type: ignore[attr-defined]


def presets(kind: str) -> dict[str, Any]:
    """The ready-made values of a kind by name: every ``PRESETS`` entry of the sources."""
    found = {}
    for module in pkgutil.iter_modules(drawbar.sources.__path__):
        source = importlib.import_module(f"drawbar.sources.{module.name}")
        found |= {p.name: p for p in getattr(source, "PRESETS", ()) if isinstance(p.law, KINDS[kind])}
    return found


def find(kind: str, given: Any) -> Any:
    """The tissue, film or wheel that a name, a file or a law's call stands for.

    Raises
    ------
    ValueError
        Nothing goes by that name, or a quantity is misspelt, missing or out of bounds.

    >>> find("tissue", "Winkler(stiffness=225 kPa/m)")
    Winkler(stiffness=225000.0)
    """
    if isinstance(given, KINDS[kind]):
        return given
    text = str(given).strip()
    ready = presets(kind)
    if text in ready:
        return ready[text].law
    call = _CALL.match(text)
    if call:
        return _build(kind, call[1], _arguments(call[2], text), text)
    if text.endswith(".toml") or Path(text).exists():
        return _from_toml(kind, Path(text))
    names = [*ready, *laws(kind)]
    hint = nearest(text, names)
    example = {"tissue": "'Winkler(stiffness=225 kPa/m)'", "film": "'Couette(viscous_coefficient=1e4)'",
               "wheel": "'Wheel(radius=7.5 mm, width=20 mm)'"}[kind]  # fmt: skip
    raise ValueError(
        f"no {kind} is called '{text}'.{hint} Give a preset ({', '.join(ready) or 'there is none'}), "
        f"a .toml file, or a law such as {example}. 'drawbar laws' lists them all."
    )


def sensors(given: str | None) -> Sensors:
    """A rig's sensors from text such as ``force_noise=5 mN, angle_noise=0.1 deg``; None is a perfect rig."""
    if given is None:
        return Sensors()
    call = _CALL.match(given)
    return _fill(Sensors, _arguments(call[2] if call else given, given), f"--noise '{given}'")


def _arguments(text: str, whole: str) -> dict[str, str]:
    arguments = {}
    for part in filter(None, (p.strip() for p in _COMMA.split(text))):
        name, equals, number = part.partition("=")
        if not equals:
            raise ValueError(f"'{part}' in '{whole}' is not name=number. Write for example stiffness=225 kPa/m.")
        arguments[name.strip()] = number.strip()
    return arguments


def _build(kind: str, law: str, arguments: dict[str, Any], where: str) -> Any:
    known = laws(kind)
    if law not in known:
        raise ValueError(f"'{law}' in {where} is not a {kind} law.{nearest(law, known)} There are: {', '.join(known)}.")
    return _fill(known[law], arguments, where)


def _fill(law: type, arguments: dict[str, Any], where: str) -> Any:
    """A frozen value from text or numbers by quantity; what is misspelt, missing or wrong is named."""
    declared = quantities(law)
    for name in arguments:
        if name == "diameter":
            raise ValueError(f"'diameter' in {where}: wheels are given by radius, half of it.")
        if name not in declared:
            raise ValueError(
                f"'{name}' in {where} is not a quantity of {law.__name__}.{nearest(name, declared)} "
                f"It has: {', '.join(declared)}."
            )
    fields = inspect.signature(law).parameters
    missing = [n for n in declared if n not in arguments and fields[n].default is inspect.Parameter.empty]
    if missing:
        example = ", ".join(f"{n}=... {declared[n].unit}" for n in missing)
        raise ValueError(f"{law.__name__} in {where} lacks {', '.join(missing)}. Add {example}.")
    try:
        return law(**{name: _number(v, declared[name]) for name, v in arguments.items()})
    except (TypeError, ValueError) as error:
        raise ValueError(f"{where}: {error}") from None


def _number(given: Any, declared: Quantity) -> Any:
    """A number in SI, or a tuple of them for a series."""
    if not declared.series:
        return si(given, declared.unit)
    if isinstance(given, str):
        given = [one for one in (p.strip() for p in given.strip().strip("[]()").split(",")) if one]
    return tuple(si(one, declared.unit) for one in given) if isinstance(given, list) else given


def _from_toml(kind: str, path: Path) -> Any:
    """A file with one table, ``[tissue]``, ``[film]`` or ``[wheel]``: its ``law`` and its quantities."""
    if path.is_dir():
        raise ValueError(f"{path} is a folder. Give a .toml file.")
    try:
        content = tomllib.loads(path.read_text(encoding="utf-8-sig"))
    except FileNotFoundError:
        raise ValueError(f"{path} does not exist. Give the path of a .toml file.") from None
    except (UnicodeDecodeError, tomllib.TOMLDecodeError) as error:
        raise ValueError(f"{path} is not a TOML file: {error}.") from None
    for key in content:
        if key not in {*KINDS, "fit"}:
            raise ValueError(f"{path}: '{key}' is not known.{nearest(key, KINDS)} Allowed: {', '.join(KINDS)}, fit.")
    if kind not in content:
        raise ValueError(f"{path} has no [{kind}] table, only {', '.join(content) or 'nothing'}. Give a {kind} file.")
    table = dict(content[kind])
    law = table.pop("law", None)
    if law is None:
        hint = "".join(nearest("law", [k]) and f" '{k}' is not known: did you mean 'law'?" for k in table)
        raise ValueError(f'{path}: [{kind}] names no law.{hint} Add for example law = "{next(iter(laws(kind)))}".')
    return _build(kind, str(law), table, str(path))


def to_toml(kind: str, law: Any, *, comments: tuple[str, ...] = ()) -> str:
    """A law as the text of a small TOML file that :func:`find` reads; every line in SI with its unit."""
    lines = [f"# {line}" for line in comments]
    lines += [f"[{kind}]", f'law = "{type(law).__name__}"']
    for (name, quantity), number in zip(quantities(law).items(), parameters(law), strict=True):
        if number is not None:
            written = list(number) if quantity.series else float(number)
            lines.append(f"{name} = {written!r}  # {quantity.unit}")
    return "\n".join(lines) + "\n"


def save(kind: str, law: Any, path: str | Path, *, comments: tuple[str, ...] = (), force: bool = False) -> Path:
    """Write a law to a TOML file that ``--tissue``, ``--film`` and ``--wheel`` accept.

    Raises
    ------
    FileExistsError
        The file exists and ``force`` is not given.
    """
    return write_whole(Path(path), to_toml(kind, law, comments=comments), force=force)

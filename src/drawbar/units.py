"""Units at the border: text to SI and back. Inside, everything is SI floats.

>>> round(si("58 mm", "m"), 12), round(si("28 gf", "N"), 4)
(0.058, 0.2746)
"""

from __future__ import annotations

import functools
import re
from typing import Any

__all__ = ["factor", "series", "si"]

_ANGLE = re.compile("radian|degree|arc|turn|revolution|grade")
_QUANTITY = re.compile(r"\s*([-+]?(?:\d+[.,]?\d*|[.,]\d+)(?:[eE][-+]?\d+)?)\s*(.*?)\s*$")


@functools.cache
def _registry() -> Any:
    import pint  # late: a quarter of a second, needed only where text comes in

    return pint.UnitRegistry(cache_folder=None)


@functools.cache
def factor(given: str, wanted: str) -> float:
    """The number that turns values in the unit ``given`` into values in the SI unit ``wanted``.

    Raises
    ------
    ValueError
        The unit is unknown or of another dimension; the sentence names both.
    """
    given = given.strip()
    if given == wanted:
        return 1.0  # also spares the import of pint
    if given == "%" and wanted == "1":
        return 0.01
    registry = _registry()
    try:
        ratio = (1.0 * _unit(given)).to(_unit(wanted))
    except Exception as error:  # pint raises a family of its own, and Python's for odd text
        raise ValueError(_refusal(given, wanted, error, registry)) from None
    # To a units library radians are plain numbers, so 1/s would pass for rad/s and degrees for a ratio.
    if wanted in {"1", "rad", "rad/s"} and bool(_ANGLE.search(str(_unit(given)))) == (wanted == "1"):
        raise ValueError(
            f"unit '{given}' does not convert to {wanted} for sure: an angle is rad, deg or turn, a ratio is 1 or %. "
            "For revolutions write rpm or turn/s."
        )
    return float(ratio.magnitude)


def _unit(text: str) -> Any:
    """A unit as laboratories write it: Nm, mm2, rev/min and [-] too."""
    text = text.strip().replace("·", "*")
    text = re.sub(r"\b([mµuk]?N)m\b", r"\1 m", text)
    text = re.sub(r"\b([cmµuk]?m)([23])\b", r"\1^\2", text)
    text = re.sub(r"\brev\b", "turn", text)
    return _registry().Unit("dimensionless" if text in {"1", "", "-"} else text)


def _refusal(given: str, wanted: str, error: Exception, registry: Any) -> str:
    if type(error).__name__ != "DimensionalityError":
        return f"unit '{given}' is not known. Give a unit that converts to {wanted}."
    hint = ""
    if wanted == "N" and registry.Unit(given).is_compatible_with("kg"):
        hint = f" A mass is not a force: if the weight of that mass is meant, write {given}f."
    return f"unit '{given}' does not convert to {wanted}.{hint or f' Give a unit that converts to {wanted}.'}"


def si(text: str | float, unit: str) -> float:
    """A number, or text such as ``58 mm``, as a float in the SI ``unit``. A bare number is SI already.

    Raises
    ------
    ValueError
        The text is not a number with a unit, or the unit does not convert.
    """
    if isinstance(text, (int, float)) and not isinstance(text, bool):
        return float(text)
    match = _QUANTITY.match(str(text))
    if match is None:
        raise ValueError(f"'{text}' is not a number with a unit. Write for example '1.5 {unit}'.")
    number = float(match[1].replace(",", "."))
    return number * factor(match[2], unit) if match[2] else number


def series(text: str | float, unit: str) -> list[float]:
    """A list of numbers in the SI ``unit``: ``0.1,0.2``, ``5:25:5 mm/s`` (from, to, how many), or both.

    A unit at the end counts for every number that has none of its own.

    >>> series("10,20:40:3 mm", "m")
    [0.01, 0.02, 0.03, 0.04]

    Raises
    ------
    ValueError
        A part is not a number with a unit, or a range is not ``from:to:how many``.
    """
    if isinstance(text, (int, float)):
        return [float(text)]
    *parts, last = (part.strip() for part in text.split(","))
    match = _QUANTITY.match(last.rpartition(":")[2])
    common = match[2] if match else ""
    numbers: list[float] = []
    for part in [*parts, last]:
        if ":" not in part:
            own = _QUANTITY.match(part)
            numbers.append(si(part if own is None or own[2] else f"{part} {common}", unit))
            continue
        ends = part.removesuffix(common).split(":")
        if len(ends) != 3 or not ends[2].strip().isdigit() or int(ends[2]) < 2:
            raise ValueError(f"'{part}' is not a range. Write from:to:how many, for example 0.5:1.5:3.")
        low, high = (si(f"{end.strip()} {common}", unit) for end in ends[:2])
        step = (high - low) / (int(ends[2]) - 1)
        numbers.extend(low + step * i for i in range(int(ends[2])))
    return numbers

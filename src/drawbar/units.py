"""Units at the border: text to SI and back. Inside, everything is SI floats.

>>> round(si("58 mm", "m"), 12), round(si("28 gf", "N"), 4)
(0.058, 0.2746)
"""

from __future__ import annotations

import functools
import re
from typing import Any

__all__ = ["factor", "si"]

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
    if given.strip() in {wanted, ""} and wanted == "1":
        return 1.0
    if given.strip() == "%" and wanted == "1":
        return 0.01
    registry = _registry()
    try:
        ratio = (1.0 * _unit(given)).to(_unit(wanted))
    except Exception as error:  # pint raises a family of its own, and Python's for odd text
        raise ValueError(_refusal(given, wanted, error, registry)) from None
    return float(ratio.magnitude)


def _unit(text: str) -> Any:
    return _registry().Unit("dimensionless" if text.strip() in {"1", ""} else text.replace("·", "*"))


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

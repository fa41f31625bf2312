"""How a physical quantity is declared: unit, symbol, bounds, meaning, checked when a value is built.

A declaration is written once, as a field of a frozen value, and serves the check, the error text, the
bounds of a fit, the label of a plot, the row of ``drawbar laws``.

>>> from drawbar.quantity import quantity, value
>>> @value
... class Spring:
...     stiffness: float = quantity("N/m", symbol="k", above=0, meaning="force per extension")
>>> Spring(stiffness=-2.0)
Traceback (most recent call last):
    ...
ValueError: stiffness must be > 0 N/m, got -2. It is force per extension.
"""

from __future__ import annotations

import dataclasses
import math
from collections.abc import Callable
from typing import Any, TypeVar, dataclass_transform

import numpy as np

__all__ = ["Quantity", "check", "parameters", "quantities", "quantity", "value"]

T = TypeVar("T")


@dataclasses.dataclass(frozen=True, kw_only=True)
class Quantity:
    """What is known of a physical quantity before it has a value. Bounds are in ``unit`` (SI)."""

    unit: str
    symbol: str = ""
    meaning: str = ""
    advice: str = ""
    source: str = ""
    minimum: float = -math.inf
    above: float = -math.inf
    maximum: float = math.inf
    below: float = math.inf
    series: bool = False

    @property
    def allowed(self) -> str:
        """The bounds in words: ``> 0 Pa/m``."""
        unit = "" if self.unit == "1" else f" {self.unit}"
        limits = []
        if self.above > -math.inf:
            limits.append(f"> {self.above:g}{unit}")
        if self.minimum > -math.inf:
            limits.append(f">= {self.minimum:g}{unit}")
        if self.maximum < math.inf:
            limits.append(f"<= {self.maximum:g}{unit}")
        if self.below < math.inf:
            limits.append(f"< {self.below:g}{unit}")
        return " and ".join(limits) or f"a finite number{unit and ' in' + unit}"


def quantity(
    unit: str,
    *,
    symbol: str = "",
    meaning: str = "",
    advice: str = "",
    source: str = "",
    minimum: float = -math.inf,
    above: float = -math.inf,
    maximum: float = math.inf,
    below: float = math.inf,
    series: bool = False,
    default: Any = dataclasses.MISSING,
) -> Any:
    """Declare a field of a :func:`value` as a physical quantity in an SI ``unit``.

    ``above`` and ``below`` are strict bounds, ``minimum`` and ``maximum`` include the bound. ``meaning``
    completes "It is ..."; ``advice`` says what to do when the check fails; ``source`` says where a
    default comes from. A ``series`` is a tuple of numbers, each within the bounds, kept as one entry.
    """
    declared = Quantity(
        unit=unit, symbol=symbol, meaning=meaning, advice=advice, source=source,
        minimum=minimum, above=above, maximum=maximum, below=below, series=series,
    )  # fmt: skip
    return dataclasses.field(default=default, metadata={"quantity": declared})


def check(name: str, given: Any, declared: Quantity) -> Any:
    """Return ``given`` as a float or a float array, or raise a sentence that says what is wrong.

    Arrays (NumPy or anything that behaves like one) are kept as they are and checked throughout; of a
    series a tuple of floats is kept.

    Raises
    ------
    TypeError
        ``given`` is not a number or an array of numbers.
    ValueError
        A value is NaN, infinite or out of bounds.
    """
    if declared.series:
        return _series(name, given, declared)
    if isinstance(given, (list, tuple)):
        given = np.asarray(given)
    if isinstance(given, (str, bytes, bool)) or given is None or not hasattr(np.asarray(given).dtype, "kind"):
        raise TypeError(_sentence(name, declared, repr(given)) + f" Give a number in {declared.unit}.")
    numbers = np.asarray(given)
    if numbers.dtype.kind not in "fiu":
        raise TypeError(_sentence(name, declared, repr(given)) + f" Give a number in {declared.unit}.")
    bad = ~np.isfinite(numbers)
    bad |= (numbers < declared.minimum) | (numbers <= declared.above)
    bad |= (numbers > declared.maximum) | (numbers >= declared.below)
    if np.any(bad):
        first = numbers[bad].flat[0] if numbers.ndim else numbers[()]
        raise ValueError(_sentence(name, declared, f"{first:g}"))
    return float(given) if numbers.ndim == 0 and not hasattr(given, "dims") else given


def _series(name: str, given: Any, declared: Quantity) -> tuple[float, ...]:
    if not isinstance(given, (list, tuple, np.ndarray)) or np.ndim(given) != 1 or len(given) == 0:
        unit = "" if declared.unit == "1" else f" in {declared.unit}"
        raise TypeError(f"{name} must be a tuple of numbers{unit}, got {given!r}. Write a single number x as (x,).")
    one = dataclasses.replace(declared, series=False)
    return tuple(float(check(f"{name}[{i}]", number, one)) for i, number in enumerate(given))


def _sentence(name: str, declared: Quantity, given: str) -> str:
    meaning = f" It is {declared.meaning}." if declared.meaning else ""
    advice = f" {declared.advice}" if declared.advice else ""
    return f"{name} must be {declared.allowed}, got {given}.{meaning}{advice}"


@dataclass_transform(kw_only_default=True, frozen_default=True, field_specifiers=(quantity,))
def value(cls: type[T]) -> type[T]:
    """Make ``cls`` a frozen, keyword-only dataclass whose quantities are checked when it is built.

    A field whose default is None may stay None; a class that fills such a field from others does so in
    its own ``__post_init__``, which runs after the check.
    """
    fill: Callable[[Any], None] | None = cls.__dict__.get("__post_init__")

    def __post_init__(self: Any) -> None:  # noqa: N807
        for field in dataclasses.fields(self):
            declared = field.metadata.get("quantity")
            given = getattr(self, field.name)
            if declared is not None and not (given is None and field.default is None):
                object.__setattr__(self, field.name, check(field.name, given, declared))
        if fill is not None:
            fill(self)

    cls.__post_init__ = __post_init__  # type: ignore[attr-defined]
    return dataclasses.dataclass(frozen=True, kw_only=True)(cls)


def quantities(of: Any) -> dict[str, Quantity]:
    """The declared quantities of a value or of its class, by name, in the order of declaration."""
    return {f.name: f.metadata["quantity"] for f in dataclasses.fields(of) if "quantity" in f.metadata}


def parameters(of: Any) -> tuple[Any, ...]:
    """The numbers of a value, in the order of declaration: what its kernels take after the state."""
    return tuple(getattr(of, name) for name in quantities(of))

"""What an identification returns: the fitted law, how sure it is, and what speaks against it."""

from __future__ import annotations

import dataclasses
import math
from collections.abc import Mapping
from pathlib import Path
from typing import Any

import numpy as np
import xarray as xr

from drawbar.catalogue import save
from drawbar.quantity import Quantity
from drawbar.study.identify.least_squares import Solution

__all__ = ["CONFIDENCE", "Estimate", "Fit", "estimates_of", "rounded"]

CONFIDENCE = 0.95
"""Of every interval."""


@dataclasses.dataclass(frozen=True)
class Estimate:
    """A fitted number: its standard error and 95 % interval, in the unit of ``quantity``."""

    value: float
    standard_error: float
    interval: tuple[float, float]
    quantity: Quantity
    at_bound: bool = False


@dataclasses.dataclass(frozen=True, kw_only=True)
class Fit:
    """A law fitted to measurements, and how sure it is.

    ``kind`` ('tissue' or 'film') says what the ``law`` is, ``fitted_to`` which variable it was fitted to.
    ``warnings`` are sentences on what may be wrong with the fit, ``notes`` on how it was made.
    ``nuisances`` are numbers of the rig, not of the law, that were fitted along; ``by_set`` are the
    estimates of each set alone, where sets were fitted one by one. ``data`` holds a row for each
    fitted observation: ``measured``, ``fitted``, ``residual`` and what they depend on.
    """

    kind: str
    law: Any
    fitted_to: str
    estimates: Mapping[str, Estimate]
    nuisances: Mapping[str, Estimate]
    by_set: Mapping[str, Estimate]
    correlation: Mapping[tuple[str, str], float]
    r_squared: float
    residual_spread: float
    residual_unit: str
    observations: int
    notes: tuple[str, ...]
    warnings: tuple[str, ...]
    data: xr.Dataset

    @property
    def values(self) -> dict[str, float]:
        """The fitted numbers of the law by name, SI."""
        return {name: e.value for name, e in self.estimates.items()}

    @property
    def standard_errors(self) -> dict[str, float]:
        """Their standard errors."""
        return {name: e.standard_error for name, e in self.estimates.items()}

    @property
    def intervals(self) -> dict[str, tuple[float, float]]:
        """Their 95 % intervals (Student's t), cut at the physical bound."""
        return {name: e.interval for name, e in self.estimates.items()}

    def report(self) -> str:
        """The fit as text: a table of the estimates, how good it is, notes and warnings."""
        lines = [f"{type(self.law).__name__} fitted to {self.observations} observations of {self.fitted_to}", ""]
        lines += _table({**self.estimates, **self.nuisances}, first="parameter")
        if self.by_set:
            lines += ["", *_table(self.by_set, first="set")]
        lines += ["", f"R² {self.r_squared:.5g}, residual spread {self.residual_spread:.3g} {self.residual_unit}"]
        lines += [
            f"correlation of {a} and {b}: {c:+.3f}"
            for (a, b), c in self.correlation.items()
            if {a, b} <= self.estimates.keys()
        ]
        for title, sentences in (("notes", self.notes), ("warnings", self.warnings)):
            lines += ["", f"{title}:", *(f"  - {s}" for s in sentences)] if sentences else []
        return "\n".join(lines) + "\n"

    def save(self, path: str | Path, *, force: bool = False) -> Path:
        """Write the law to a TOML file that ``--tissue`` or ``--film`` accepts, the report as its comments.

        Raises
        ------
        FileExistsError
            The file exists and ``force`` is not given.
        """
        comments = ("Fitted by drawbar identify.", *self.report().splitlines())
        return save(self.kind, self.law, path, comments=comments, force=force)


def _table(estimates: Mapping[str, Estimate], *, first: str) -> list[str]:
    rows = [(first, "estimate", "standard error", f"{CONFIDENCE:.0%} interval".replace("%", " %"), "unit")]
    for name, e in estimates.items():
        value, error, low, high = (rounded(x, e) for x in (e.value, e.standard_error, *e.interval))
        rows.append((name, value, error, f"{low} to {high}", e.quantity.unit + " (at its bound)" * e.at_bound))
    widths = [max(len(row[i]) for row in rows) for i in range(len(rows[0]))]
    return ["  ".join(cell.ljust(w) for cell, w in zip(row, widths, strict=True)).rstrip() for row in rows]


def rounded(number: float, of: Estimate) -> str:
    """To two digits of the standard error, and six of the estimate at most."""
    if not math.isfinite(number):
        return "without limit"
    places = [math.floor(math.log10(x)) - d for x, d in ((of.standard_error, 1), (abs(of.value), 5)) if x > 0.0]
    place = max(places, default=0)
    return f"{round(number, -place) + 0.0:.{max(-place, 0)}f}" if place > -9 else f"{number:.2g}"


def estimates_of(
    free: Solution, found: Solution, quantities: Mapping[str, Quantity]
) -> tuple[dict[str, Estimate], dict[tuple[str, str], float]]:
    """Estimates by name, and the correlations of those that were free at the end.

    A parameter that was held at its bound has the interval from there to the upper end of the fit
    without bounds, and that fit's standard error.
    """
    from scipy import stats

    def of(solution: Solution, name: str) -> tuple[float, float, float]:
        value = float(solution.values[solution.names.index(name)])
        i = solution.free.index(name)
        reach = float(stats.t.isf(0.5 * (1.0 - CONFIDENCE), solution.degrees_of_freedom))
        error = float(np.sqrt(solution.covariance[i, i]))
        return value, error, reach * error

    estimates = {}
    for name in found.names:
        held = name not in found.free
        value, error, reach = of(free if held else found, name)
        low, high = value - reach, value + reach
        minimum = quantities[name].minimum
        at = 0.0 if held else value
        estimates[name] = Estimate(at, error, (max(low, minimum), max(high, minimum)), quantities[name], held)
    root = np.sqrt(np.diag(found.covariance))
    correlation = found.covariance / np.outer(root, root)
    pairs = {
        (a, b): float(correlation[i, j])
        for i, a in enumerate(found.free)
        for j, b in enumerate(found.free)
        if i < j
    }  # fmt: skip
    return estimates, pairs

"""Least squares by lmfit, with what is known of its result: covariances, leverages, spreads."""

from __future__ import annotations

import dataclasses
import warnings
from collections.abc import Callable, Mapping
from typing import Any

import numpy as np

__all__ = ["ROUNDING", "Solution", "bounded", "least_squares"]

ROUNDING = 1e-10
"""Readings are taken to be no better than this part of the largest: a perfect rig's fit has a spread too."""


@dataclasses.dataclass(frozen=True)
class Solution:
    """Where least squares ended. ``jacobian`` has the columns of the ``free`` parameters only."""

    names: tuple[str, ...]
    free: tuple[str, ...]
    values: np.ndarray
    covariance: np.ndarray
    jacobian: np.ndarray
    residuals: np.ndarray
    scale: float

    @property
    def degrees_of_freedom(self) -> int:
        return self.residuals.size - len(self.free)

    @property
    def sum_of_squares(self) -> float:
        """Of the residuals, at least what rounding leaves."""
        return float(self.residuals @ self.residuals) + self.residuals.size * (ROUNDING * self.scale) ** 2

    @property
    def spread(self) -> float:
        """Standard deviation of an observation about the law."""
        return float(np.sqrt(self.sum_of_squares / self.degrees_of_freedom))

    @property
    def exact(self) -> bool:
        """Whether nothing but rounding is left over: then there is nothing to test."""
        return bool(np.max(np.abs(self.residuals)) <= 10.0 * ROUNDING * self.scale)

    @property
    def leverages(self) -> np.ndarray:
        """How much each observation determines its own fitted value, 0 to 1."""
        return np.sum(np.linalg.qr(self.jacobian)[0] ** 2, axis=1)

    def extended(self, columns: np.ndarray) -> Solution:
        """With more regressors (n, q), linear around this solution: their names are empty."""
        jacobian = np.column_stack([self.jacobian, columns])
        basis = np.linalg.qr(jacobian)[0]
        residuals = self.residuals - basis @ (basis.T @ self.residuals)
        free = (*self.free, *[""] * columns.shape[1])
        return dataclasses.replace(self, jacobian=jacobian, residuals=residuals, free=free)

    def uneven(self) -> Solution:
        """The same with standard errors that hold when the spread differs between observations (HC3).

        (JᵀJ)⁻¹ Jᵀ diag(e²/(1 - h)²) J (JᵀJ)⁻¹, e the residuals and h the leverages.

        Source: J. G. MacKinnon, H. White, J. Econometrics 29 (1985) 305-325.
        """
        inverse = np.linalg.pinv(self.jacobian)
        own = self.residuals / np.maximum(1.0 - self.leverages, 1e-6)
        covariance = (inverse * (own**2 + (ROUNDING * self.scale) ** 2)) @ inverse.T
        return dataclasses.replace(self, covariance=covariance)


def least_squares(
    measured: np.ndarray,
    predict: Callable[[np.ndarray], np.ndarray],
    jacobian: Callable[[np.ndarray], np.ndarray],
    start: Mapping[str, float],
    *,
    held: tuple[str, ...] = (),
) -> Solution:
    """Least squares by lmfit's Levenberg-Marquardt, with the model's own derivative, without bounds.

    Parameters
    ----------
    measured
        The observations, (n,).
    predict, jacobian
        Of all parameters, in the order of ``start``: the model (n,) and its derivatives (n, p).
    start
        First guesses by name.
    held
        Names held at zero.

    Raises
    ------
    ValueError
        The data cannot tell some of the parameters apart.
    """
    import lmfit  # late: a third of a second

    names = tuple(start)
    free = [i for i, name in enumerate(names) if name not in held]
    parameters = lmfit.Parameters()
    for name in names:
        parameters.add(name, value=0.0 if name in held else start[name], vary=name not in held)

    def values(given: Any) -> np.ndarray:
        return np.array([given[name].value for name in names])

    _refuse_twins(jacobian(values(parameters))[:, free], [names[i] for i in free])
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")  # of numbers without spread: a perfect rig's
        result: Any = lmfit.minimize(
            lambda p: predict(values(p)) - measured,
            parameters,
            Dfun=lambda p: jacobian(values(p))[:, free],
            ftol=1e-15,
            xtol=1e-14,
        )
    found = values(result.params)
    slopes = jacobian(found)[:, free]
    residuals = measured - predict(found)
    scale = float(np.max(np.abs(measured)))
    solution = Solution(names, tuple(names[i] for i in free), found, np.empty(0), slopes, residuals, scale)
    inverse = np.linalg.pinv(slopes)
    return dataclasses.replace(solution, covariance=inverse @ inverse.T * solution.spread**2)


def _refuse_twins(jacobian: np.ndarray, names: list[str]) -> None:
    """Refuse parameters whose effects on the observations are multiples or sums of each other."""
    size = np.linalg.norm(jacobian, axis=0)
    for i, name in enumerate(names):
        if size[i] == 0.0:
            raise ValueError(f"nothing in these data depends on {name}. Leave it out, or measure where it matters.")
    _, strength, directions = np.linalg.svd(jacobian / size, full_matrices=False)
    if strength[-1] < 1e-7 * strength[0]:
        twins = [name for name, part in zip(names, directions[-1], strict=True) if abs(part) > 0.1]
        raise ValueError(
            f"these data cannot tell {' and '.join(twins)} apart: they act alike at every setting. "
            "Measure at more settings (loads, speeds), or fit fewer of them."
        )


def bounded(
    measured: np.ndarray,
    predict: Callable[[np.ndarray], np.ndarray],
    jacobian: Callable[[np.ndarray], np.ndarray],
    start: Mapping[str, float],
    *,
    positive: tuple[str, ...],
) -> tuple[Solution, Solution]:
    """The fit without bounds, and the fit in which no ``positive`` parameter is below zero.

    Of those that came out negative, the one that is furthest below in units of its standard error is
    held at zero and the rest fitted again, until none is negative. What is left has the standard errors
    of a law without those that are held.

    Raises
    ------
    ValueError
        Nothing would be left.
    """
    free = found = least_squares(measured, predict, jacobian, start)
    held: tuple[str, ...] = ()
    while True:
        errors = np.sqrt(np.diag(found.covariance))
        below = {
            name: found.values[found.names.index(name)] / error
            for name, error in zip(found.free, errors, strict=True)
            if name in positive and found.values[found.names.index(name)] < 0.0
        }
        if not below:
            return free, found
        if len(found.free) == 1:
            raise ValueError(
                f"{', '.join(positive)} would all be below zero. Check the signs of the columns that were measured."
            )
        held = (*held, min(below, key=lambda name: below[name]))
        found = least_squares(measured, predict, jacobian, start, held=held)

"""What residuals say against a fit: trends that the law cannot follow, far-out readings, uneven spread."""

from __future__ import annotations

import numpy as np

from drawbar.study.identify.fit import Estimate
from drawbar.study.identify.least_squares import Solution

__all__ = ["DOUBT", "added", "far_out", "local_spread", "sentence_of_p", "undetermined"]

DOUBT = 0.003
"""Level of each test that can raise a warning. A fit is put to three or four of them, so that about one
clean data set in a hundred raises a false alarm."""

UNEVEN = 0.05
"""Level at which the spread counts as uneven. No alarm hangs on it: standard errors that allow for an
uneven spread are right for an even one too, only a little less sharp."""


def added(solution: Solution, columns: np.ndarray, *, uneven: bool = False) -> tuple[float, np.ndarray]:
    """Whether more regressors would explain the residuals: p of the F-test, and their coefficients.

    The test is of the parts of ``columns`` (n, q) that the law's own derivatives do not span; linear
    around the solution. With ``uneven`` spread, Wald's form of it with the HC3 covariance. A p of 1 if
    there is nothing to add or nothing to explain.
    """
    from scipy import stats

    basis = np.linalg.qr(solution.jacobian)[0]
    columns = columns / np.maximum(np.linalg.norm(columns, axis=0), 1e-300)
    fresh = columns - basis @ (basis.T @ columns)
    left, strength, right = np.linalg.svd(fresh, full_matrices=False)
    keep = strength > 1e-6  # of columns of length 1
    left = left[:, keep]
    freedom = solution.degrees_of_freedom - left.shape[1]
    nothing = np.zeros(columns.shape[1])
    if solution.exact or not keep.any() or freedom < 1:
        return 1.0, nothing
    parts = left.T @ solution.residuals
    rest = solution.residuals - left @ parts
    floor = solution.sum_of_squares - float(solution.residuals @ solution.residuals)
    if uneven:
        leverages = solution.leverages + np.sum(left**2, axis=1)
        own = rest / np.maximum(1.0 - leverages, 1e-6)
        weight = parts @ np.linalg.solve((left.T * (own**2 + floor)) @ left, parts)
    else:
        weight = float(parts @ parts) / (float(rest @ rest) + floor) * freedom
    p = float(stats.f.sf(weight / parts.size, parts.size, freedom))
    return p, right[keep].T @ (parts / strength[keep])


def local_spread(solution: Solution, drivers: np.ndarray) -> tuple[bool, np.ndarray]:
    """Whether the spread of the residuals depends on the ``drivers`` (n, q), and a spread for each.

    Squared residuals are regressed on the drivers, and the F-test of that regression is taken (the
    form of the Breusch-Pagan test that does not lean on normal residuals). Where the spread is even,
    every observation has the same. A quiet observation is given the
    common spread: its own is too uncertain to call it far out.

    Source: R. Koenker, J. Econometrics 17 (1981) 107-112.
    """
    from scipy import stats

    n = solution.residuals.size
    same = np.full(n, solution.spread)
    squares = solution.residuals**2 / np.maximum(1.0 - solution.leverages, 1e-6)
    design = np.column_stack([np.ones(n), drivers / np.maximum(np.max(np.abs(drivers), axis=0), 1e-300)])
    rank = int(np.linalg.matrix_rank(design))
    if solution.exact or rank < 2 or n - rank < 3:
        return False, same
    smooth = design @ np.linalg.lstsq(design, squares, rcond=None)[0]
    rest, whole = np.sum((squares - smooth) ** 2), np.sum((squares - squares.mean()) ** 2)
    weight = (whole - rest) / (rank - 1) / (max(rest, 1e-300) / (n - rank))
    if stats.f.sf(weight, rank - 1, n - rank) > UNEVEN:
        return False, same
    return True, np.sqrt(np.maximum(smooth, squares.mean()))


def far_out(solution: Solution, spreads: np.ndarray) -> list[int]:
    """Observations whose residual is too far out for one of so many (Student's t, each against the rest).

    Where the spread is uneven, each spread counts as known from a tenth of the observations.
    """
    from scipy import stats

    n, freedom = solution.residuals.size, solution.degrees_of_freedom - 1
    if solution.exact or freedom < 2:
        return []
    own = solution.residuals / spreads / np.sqrt(np.maximum(1.0 - solution.leverages, 1e-6))
    own = own / np.sqrt(np.sum((solution.residuals / spreads) ** 2) / (freedom + 1))
    far = np.abs(own) * np.sqrt(freedom / np.maximum(freedom + 1 - own**2, 1e-12))
    if np.ptp(spreads) > 0.0:
        freedom = max(freedom // 10, 2)
    return [int(i) for i in np.flatnonzero(2.0 * n * stats.t.sf(far, freedom) < DOUBT)]


def undetermined(name: str, estimate: Estimate, advice: str) -> str | None:
    """A sentence if a parameter's interval is wider than the parameter, else None."""
    if estimate.at_bound or 2.0 * estimate.standard_error < abs(estimate.value):
        return None
    low, high = estimate.interval
    unit = "" if estimate.quantity.unit == "1" else f" {estimate.quantity.unit}"
    reach = (
        f"between {low:.3g} and {high:.3g}{unit}" if high < np.inf else f"above {low:.3g}{unit}, without upper limit"
    )
    return (
        f"{name} is not determined by these data: {estimate.value:.3g} ± {estimate.standard_error:.2g}{unit}, "
        f"{reach}. {advice}"
    )


def sentence_of_p(p: float) -> str:
    """``p = 0.02``, or ``p < 1e-6``."""
    return f"p = {p:.2g}" if p >= 1e-6 else "p < 1e-6"

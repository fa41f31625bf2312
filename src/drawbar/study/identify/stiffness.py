"""A tissue's stiffness from weights on a plate, or from a wheel pressed in: the paper's section VI.B."""

from __future__ import annotations

import dataclasses
from collections.abc import Mapping, Sequence

import numpy as np
import xarray as xr

from drawbar.quantity import Quantity, quantities
from drawbar.study.identify.doubts import DOUBT, added, far_out, local_spread, sentence_of_p, undetermined
from drawbar.study.identify.fit import CONFIDENCE, Estimate, Fit, rounded
from drawbar.study.identify.least_squares import ROUNDING, Solution, least_squares
from drawbar.study.identify.press import Press, press_of
from drawbar.study.identify.reduce import Rows, gather, one_label
from drawbar.tissue.winkler import Winkler
from drawbar.variables import OBSERVATION, VARIABLES, declare

__all__ = ["identify_stiffness"]

STIFFNESS = quantities(Winkler)["stiffness"]


def identify_stiffness(dataset: xr.Dataset | Sequence[xr.Dataset]) -> Fit:
    """Fit Winkler's stiffness k to plate tests, or to a wheel pressed into the tissue.

    Plate: w = c p with p = m g / A. Wheel: N = k L r² (φ - ½ sin 2φ), and k L (π r²/2 + 2 r y) in deep
    contact, solved for the sinkage. The loads are known and the depth is what is read with an error, so
    the compliance c = 1/k is fitted to the depths, and k's interval is that of c, inverted.

    Each set (``trial``: another place or orientation of the plate, or another log) is fitted by itself.
    The result is the mean of their compliances, and its standard error follows from how far the sets
    lie apart, with Student's t of their number less one: where tissue differs from place to place, more
    readings in one place do not make its mean surer. (Pooling them unless a test at 1 % finds a difference
    would hold the truth in as little as 77 % of cases.) A single set is taken as it is.

    Parameters
    ----------
    dataset
        One or several, with ``applied_mass`` [kg] or ``applied_force`` [N], ``plate_area`` [m²],
        ``deflection`` [m] and, for sets, ``trial``; or with ``normal_load`` [N], ``wheel_radius`` [m],
        ``wheel_width`` [m] and ``sinkage`` [m].

    Returns
    -------
    Fit
        ``values['stiffness']`` [Pa/m]; ``by_set``; ``law`` is a :class:`~drawbar.Winkler`. It warns when
        the readings do not start at zero or do not rise as the law does, a reading is far out, or the
        stiffness is not determined; it notes whether the sets differ.

    Raises
    ------
    ValueError
        Columns are missing, there are fewer than three readings, all loads are equal, or the depth
        falls as the load rises.

    Valid for: the law itself; a plate test of a tissue with surface tension gives the stiffness of plate
    and rim together.

    Source: Rentschler et al. 2004, section VI.B and equations (1), (4), (12).

    >>> import drawbar
    >>> log = drawbar.plate_test(drawbar.Winkler(stiffness=225e3), applied_mass=[0.02, 0.1, 0.2], plate_area=2.5e-3)
    >>> round(identify_stiffness(log).values["stiffness"])
    225000
    """
    columns, notes, warnings = gather(dataset)
    one_label(columns, "tissue")
    press = press_of(columns)
    sets = _sets(columns, press)
    start = press.guess()
    pooled = _solve(press, np.zeros(press.depth.size, dtype=int), start)
    within = _solve(press, sets, start) if sets.max() else pooled
    straight = press.predict(np.full(sets.size, float(pooled.values[0])))
    uneven, spreads = local_spread(within, np.column_stack([straight, press.load]))
    if uneven:
        within, pooled = within.uneven(), pooled.uneven()
        notes.append("the readings scatter more at some loads than at others; the standard errors allow for that.")
    labels = columns["trial"] if sets.max() else np.full(sets.size, "")
    by_set = {
        str(labels[np.argmax(sets == s)]): _inverse(c, e, within.degrees_of_freedom)
        for s, (c, e) in enumerate(zip(within.values, np.sqrt(np.diag(within.covariance)), strict=True))
    }
    compliance, estimate = _over_sets(within)
    if sets.max():
        notes.append(
            f"the standard error is that of the mean of {len(by_set)} sets, from how far they lie apart"
            + (": two sets tell little of that, a third would narrow the interval." if len(by_set) == 2 else ".")
        )
        notes += _apart(pooled, sets, by_set, uneven)
    fitted = press.predict(np.full(sets.size, compliance))
    residual = press.depth - fitted
    doubts = [
        *_shape(press.reading, within, sets, straight, uneven),
        _far(press.reading, within, spreads),
        undetermined("stiffness", estimate, "Weigh more, in more sets, or read more finely."),
    ]
    return Fit(
        kind="tissue",
        law=Winkler(stiffness=estimate.value),
        fitted_to=press.reading,
        estimates={"stiffness": estimate},
        nuisances={},
        by_set=by_set if sets.max() else {},
        correlation={},
        r_squared=1.0 - float(residual @ residual) / float(np.sum((press.depth - press.depth.mean()) ** 2)),
        residual_spread=float(np.sqrt(residual @ residual / (residual.size - 1))),
        residual_unit="m",
        observations=residual.size,
        notes=tuple(notes),
        warnings=(*warnings, *(d for d in doubts if d)),
        data=_data(press, fitted, columns),
    )


def _sets(columns: Rows, press: Press) -> np.ndarray:
    """The number of each reading's set, 0 for all if they cannot be fitted one by one."""
    one = np.zeros(press.depth.size, dtype=int)
    if "trial" not in columns:
        return one
    _, sets = np.unique(columns["trial"].astype(str), return_inverse=True)
    loads = [np.count_nonzero(press.load[sets == s] > 0.0) for s in range(sets.max() + 1)]
    return sets if min(loads) >= 2 else one


def _solve(press: Press, sets: np.ndarray, start: float) -> Solution:
    """A compliance for each set."""
    own = np.eye(int(sets.max()) + 1)[sets]
    # In units of the first guess, so that the solver sees numbers near 1.
    solution = least_squares(
        press.depth,
        lambda c: press.predict(start * c[sets]),
        lambda c: own * (start * press.slope(start * c[sets]))[:, None],
        {f"set_{s}": 1.0 for s in range(own.shape[1])},
    )
    return dataclasses.replace(
        solution,
        values=start * solution.values,
        covariance=start**2 * solution.covariance,
        jacobian=solution.jacobian / start,
    )


def _over_sets(within: Solution) -> tuple[float, Estimate]:
    """The mean compliance, and the stiffness with its standard error and interval."""
    count = within.values.size
    mean = float(within.values.mean())
    if count == 1:
        return mean, _inverse(mean, float(np.sqrt(within.covariance[0, 0])), within.degrees_of_freedom)
    error = max(float(within.values.std(ddof=1)), ROUNDING * abs(mean)) / np.sqrt(count)
    return mean, _inverse(mean, float(error), count - 1)


def _inverse(compliance: float, error: float, degrees_of_freedom: int) -> Estimate:
    """k = 1/c, its standard error k² times that of c, and the interval of c inverted."""
    from scipy import stats

    reach = float(stats.t.isf(0.5 * (1.0 - CONFIDENCE), degrees_of_freedom)) * error
    low, high = 1.0 / (compliance + reach), 1.0 / (compliance - reach) if compliance > reach else np.inf
    return Estimate(1.0 / compliance, error / compliance**2, (max(low, 0.0), high), STIFFNESS)


def _apart(pooled: Solution, sets: np.ndarray, by_set: Mapping[str, Estimate], uneven: bool) -> list[str]:
    """A sentence if the sets differ by more than their readings scatter. The interval allows for it."""
    own = np.eye(int(sets.max()) + 1)[sets]
    p, _ = added(pooled, own * pooled.jacobian, uneven=uneven)
    if p >= DOUBT:
        return []
    ends = [pick(by_set, key=lambda name: by_set[name].value) for pick in (min, max)]
    soft, stiff = (f"{rounded(by_set[name].value, by_set[name])} Pa/m (set {name})" for name in ends)
    return [
        f"the sets differ by more than the readings scatter ({sentence_of_p(p)}), from {soft} to {stiff}: the tissue "
        "is not the same everywhere. The interval is for its mean."
    ]


def _shape(reading: str, within: Solution, sets: np.ndarray, straight: np.ndarray, uneven: bool) -> list[str]:
    """Sentences if the readings do not rise with the law, or not from zero."""
    own = np.eye(int(sets.max()) + 1)[sets]
    p, (curvature,) = added(within.extended(own), straight[:, None] ** 2, uneven=uneven)
    if p < DOUBT:
        how = "less than in proportion: it stiffens" if curvature < 0 else "more than in proportion: it softens"
        return [
            f"the tissue gives way {how} under load ({sentence_of_p(p)}), which one stiffness cannot follow. "
            f"The fit is a mean over the {reading} measured; give the range that matters."
        ]
    p, offsets = added(within, own, uneven=uneven)
    if p < DOUBT:
        offsets = offsets / np.sqrt(own.sum(axis=0))
        largest = float(offsets[np.argmax(np.abs(offsets))])
        return [
            f"the readings do not start at zero: at no load {reading} would be {largest * 1e3:+.3g} mm "
            f"({sentence_of_p(p)}), and the stiffness is off by what that takes. Zero the gauge with the empty "
            "plate on, or subtract the reading at no load."
        ]
    return []


def _far(reading: str, within: Solution, spreads: np.ndarray) -> str | None:
    """A sentence if some readings are too far from the rest."""
    rows = ", ".join(str(i + 1) for i in far_out(within, spreads))
    return f"the {reading} in row {rows} is far from the rest. Check the reading." if rows else None


def _data(press: Press, fitted: np.ndarray, columns: Rows) -> xr.Dataset:
    """The readings beside the fit, for drawing the paper's Fig. 8."""
    table = {"measured": press.depth, "fitted": fitted, "residual": press.depth - fitted, **press.regressors}
    labels = [n for n in ("tissue", "trial") if n in columns]
    table |= {n: columns[n] for n in labels}
    unit = VARIABLES[press.reading].unit
    extra = {n: Quantity(unit=unit, meaning=f"{press.reading}, {n}") for n in ("measured", "fitted", "residual")}
    extra["contact_pressure"] = Quantity(unit="Pa", symbol="p", meaning="weight over the plate's area")
    return declare({n: (OBSERVATION, c) for n, c in table.items()}, coords=labels, attrs={"reading": press.reading},
                   extra=extra)  # fmt: skip

"""A film's friction from drags of a locked wheel: the paper's section VI.A."""

from __future__ import annotations

import functools
from collections.abc import Callable, Sequence

import numpy as np
import xarray as xr

from drawbar.film.couette_coulomb import CouetteCoulomb
from drawbar.quantity import Quantity, quantities
from drawbar.study.identify.coulomb import CHOICES, Choice, choose
from drawbar.study.identify.doubts import DOUBT, added, far_out, local_spread, sentence_of_p, undetermined
from drawbar.study.identify.drags import OFFSET, Drags, beside_fit, drags_of
from drawbar.study.identify.fit import Estimate, Fit, estimates_of
from drawbar.study.identify.least_squares import Solution, bounded, least_squares
from drawbar.study.identify.reduce import gather, one_label

__all__ = ["identify_film"]

QUANTITIES: dict[str, Quantity] = {
    **quantities(CouetteCoulomb),
    OFFSET: Quantity(unit="N", meaning="the load cell's zero error"),
}


def identify_film(dataset: xr.Dataset | Sequence[xr.Dataset], coulomb: str = "auto") -> Fit:
    """Fit Coulomb plus viscous friction to drags of a locked wheel, forward and reverse.

    With ω = 0 the film slips at V = -v cos θ, and the drawbar force is, contact by contact,
    F = F₀ - sign(v) [τ₀ 2 L r sin φ + μ_c N] - (μ/h) L r v (φ + ½ sin 2φ): equation (17) with the
    Coulomb terms of the same arc (∫ p dx = N). F₀ is the load cell's zero error, fitted along when the
    wheel was dragged both ways; friction is taken to be the same in both, as the source does.

    The contact angle is each run's own reading. Its error enters as scatter of that run, which the standard
    errors then hold; averaged over the runs of a load it would be one error that they all share and
    that no residual shows (then 71 % of intervals hold μ/h, with each run's own 93 %, at a zero error
    of 2 mrad a run on a 15 cm lever). What it leaves is a bias of second order: there, a third of a
    standard error.

    Parameters
    ----------
    dataset
        One or several, with ``drawbar_force`` [N], ``slide_speed`` [m/s], ``normal_load`` [N],
        ``wheel_radius``, ``wheel_width`` [m], and ``contact_half_angle`` [rad] or what gives it
        (``sinkage``, or ``lever_angle`` and ``lever_length``). Rows whose wheel turns are set aside and
        counted. A log with ``time`` is reduced to a mean for each run (:func:`reduce_histories`).
    coulomb
        The Coulomb term: 'yield_stress' τ₀, 'friction_coefficient' μ_c, 'both', 'none', or 'auto': what the
        loads support (:func:`drawbar.study.identify.coulomb.choose`). Intervals take the choice as given: a true
        term too weak to be chosen is then in the others.

    Returns
    -------
    Fit
        ``values`` of what was fitted among ``viscous_coefficient`` [Pa s/m], ``yield_stress`` [Pa] and
        ``friction_coefficient`` [1]; ``nuisances['force_offset']`` [N]; ``law`` is a
        :class:`~drawbar.CouetteCoulomb`. ``data`` also holds the mean ``shear_stress`` on the contact and
        the ``slip_velocity`` at which a purely viscous film has it. It warns when a number is not
        determined or ended at its bound, when the residuals bend with slide_speed or normal_load or differ
        between directions, and when a run is far out.

    Raises
    ------
    ValueError
        Columns are missing, no locked and sliding runs are left, there are too few, they have one speed
        only (unless ``coulomb='none'``), the force pushes along the motion, or the loads cannot tell the
        terms that were asked for apart.

    Source: Rentschler et al. 2004, section VI.A and equations (14), (17).

    >>> import drawbar
    >>> film = drawbar.CouetteCoulomb(viscous_coefficient=1e4, yield_stress=40.0)
    >>> log = drawbar.drawbar_test(drawbar.Wheel(radius=0.0075, width=0.02), drawbar.Winkler(stiffness=415e3), film,
    ...     normal_load=[0.14, 0.27, 0.41], speed=[-0.02, -0.01, 0.01, 0.02], wheel_speed=0.0)
    >>> {name: round(number, 3) for name, number in identify_film(log).values.items()}
    {'viscous_coefficient': 10000.0, 'yield_stress': 40.0}
    """
    if coulomb not in ("auto", *CHOICES):
        raise ValueError(f"coulomb must be one of auto, {', '.join(CHOICES)}, got '{coulomb}'.")
    columns, notes, warnings = gather(dataset)
    for label in ("tissue", "film"):
        one_label(columns, label)
    drags, remarks = drags_of(columns)
    notes += remarks
    _refuse(drags, coulomb)
    solve = functools.cache(lambda choice: least_squares(drags.force, *drags.linear(_unknowns(drags, choice))))
    choice, uneven = _choice(drags, coulomb, solve)
    positive = ("viscous_coefficient", *CHOICES[choice.name])
    free, found = bounded(drags.force, *drags.linear(_unknowns(drags, choice.name)), positive=positive)
    _, spreads = _local_spread(drags, found)
    if uneven:
        free, found = free.uneven(), found.uneven()
        notes.append("the force scatters more in some runs than in others; the standard errors allow for that.")
    if choice.reason and not choice.unsure:
        notes.append(choice.reason)
    estimates, correlation = estimates_of(free, found, QUANTITIES)
    terms = {name: e for name, e in estimates.items() if name != OFFSET}
    doubts = [
        choice.reason if choice.unsure else None,
        *(_unsettled(name, e, free) for name, e in terms.items() if not found.exact),
        *(_twins(pair, c) for pair, c in correlation.items() if abs(c) > 0.99 and OFFSET not in pair),
        *_trends(drags, found, choice.name, uneven),
        _far(drags, found, spreads),
    ]
    residual = found.residuals
    return Fit(
        kind="film",
        law=CouetteCoulomb(**{"yield_stress": 0.0, **{name: e.value for name, e in terms.items()}}),
        fitted_to="drawbar_force",
        estimates=terms,
        nuisances={OFFSET: estimates[OFFSET]} if OFFSET in estimates else {},
        by_set={},
        correlation=correlation,
        r_squared=1.0 - float(residual @ residual) / float(np.sum((drags.force - drags.force.mean()) ** 2)),
        residual_spread=found.spread,
        residual_unit="N",
        observations=residual.size,
        notes=tuple(notes),
        warnings=(*warnings, *(d for d in doubts if d)),
        data=beside_fit(drags, residual, estimates[OFFSET].value if OFFSET in estimates else 0.0),
    )


def _refuse(drags: Drags, coulomb: str) -> None:
    """Refuse what the runs cannot answer."""
    count, needed = drags.force.size, 2 + len(_unknowns(drags, "yield_stress" if coulomb == "auto" else coulomb))
    if count < needed:
        raise ValueError(
            f"{count} runs are too few to fit {needed - 2} numbers and their errors. Give at least {needed}."
        )
    if coulomb != "none" and not drags.speeds_differ:
        raise ValueError(
            f"all {count} runs have one speed, {np.abs(drags.speed).mean():.3g} m/s: viscous and Coulomb friction "
            "cannot be told apart. Drag at two or more speeds, or give coulomb='none' for viscous friction alone."
        )
    if coulomb == "both" and not drags.loads_differ:
        raise ValueError(
            f"all {count} runs have one load, {drags.load.mean():.3g} N: a yield stress and a friction coefficient "
            "cannot be told apart. Drag under two or more loads, or give coulomb='yield_stress'."
        )


def _unknowns(drags: Drags, choice: str) -> tuple[str, ...]:
    """What is fitted. The zero error only where the wheel was dragged both ways, which tells it from friction."""
    return ("viscous_coefficient", *CHOICES[choice], *((OFFSET,) if drags.both_ways else ()))


def _local_spread(drags: Drags, found: Solution) -> tuple[bool, np.ndarray]:
    """The scatter may grow with speed (shorter runs, fewer samples) and with what an error of the angle does."""
    values = dict(zip(found.names, found.values, strict=True))
    return local_spread(found, np.stack([np.abs(drags.speed), drags.sensitivity(values) ** 2], axis=1))


def _choice(drags: Drags, coulomb: str, solve: Callable[[str], Solution]) -> tuple[Choice, bool]:
    """The Coulomb term, and whether the scatter is uneven about the fullest law that it was chosen from."""
    if coulomb != "auto":
        return Choice(coulomb, "", unsure=False), _local_spread(drags, solve(coulomb))[0]
    why = ""
    if not drags.loads_differ:
        why = f"all runs have one load, {drags.load.mean():.3g} N"
    elif drags.force.size < len(_unknowns(drags, "both")) + 2:
        why = f"{drags.force.size} runs are too few for a test"
    if why:
        reason = (
            f"{why}: nothing tells a yield stress from a friction coefficient. The source's Coulomb friction is taken "
            "as a constant yield stress; the law is sure only near this load. Drag under loads far apart."
        )
        return Choice("yield_stress", reason, unsure=True), _local_spread(drags, solve("yield_stress"))[0]
    uneven, _ = _local_spread(drags, solve("both"))
    return choose(solve, drags.regressors, uneven=uneven), uneven


def _unsettled(name: str, estimate: Estimate, free: Solution) -> str | None:
    """A sentence if the parameter was held at its bound, or is not determined."""
    if not estimate.at_bound:
        return undetermined(name, estimate, "Drag at more speeds, more often, or with a finer load cell.")
    unit = "" if estimate.quantity.unit == "1" else f" {estimate.quantity.unit}"
    value = free.values[free.names.index(name)]
    return (
        f"{name} ended at its bound, 0{unit}: without it the fit would give {value:.3g} ± "
        f"{estimate.standard_error:.2g}{unit}. It was held at 0 and the rest fitted again; its interval "
        f"reaches up to {estimate.interval[1]:.3g}{unit}."
    )


def _twins(pair: tuple[str, str], correlation: float) -> str:
    """A sentence on two parameters that act almost alike."""
    return (
        f"{pair[0]} and {pair[1]} can hardly be told apart (correlation {correlation:+.3f}): what one gains the other "
        "loses. Drag at loads or speeds further apart, or fit one of them."
    )


def _trends(drags: Drags, found: Solution, choice: str, uneven: bool) -> list[str]:
    """Sentences on what the residuals follow that the law does not."""
    speed, load, ways = np.abs(drags.speed), drags.load, drags.ways
    terms = drags.regressors
    viscous, coulomb = terms["viscous_coefficient"], terms["yield_stress"]
    suspects: dict[str, list[np.ndarray]] = {}
    if choice == "none":
        suspects["does not vanish with slide_speed: a Coulomb term is missing. Give coulomb='auto'."] = [coulomb]
    if drags.speeds_differ:
        suspects["bends with slide_speed, as of a film that thins or thickens."] = [viscous * speed]
    if drags.loads_differ:
        suspects["depends on normal_load otherwise than the law does (or the angle is read badly)."] = [
            ways * load,
            ways * load**2,
            viscous * load,
        ]
    if drags.both_ways:
        suspects["differs between forward and reverse, which the law takes to be alike."] = [
            ways * viscous,
            ways * coulomb,
        ]
    trends = []
    for what, columns in suspects.items():
        p, _ = added(found, np.stack(columns, axis=1), uneven=uneven)
        if p < DOUBT:
            trends.append(f"the residuals show a trend ({sentence_of_p(p)}): the force {what}")
    return trends[:1] if choice == "none" else trends


def _far(drags: Drags, found: Solution, spreads: np.ndarray) -> str | None:
    """A sentence if some runs are too far from the rest."""
    runs = ", ".join(f"{i + 1} ({drags.load[i]:.3g} N, {drags.speed[i]:.3g} m/s)" for i in far_out(found, spreads))
    return f"the drawbar_force of run {runs} is far from the rest. Look at that run." if runs else None

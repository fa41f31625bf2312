"""Tissue as columns fixed in the ground, each with its own memory: the value that a wheel leaves behind."""

from __future__ import annotations

import dataclasses
from typing import Any

import numpy as np

from drawbar.contact.column import Law, Tables, tables_of
from drawbar.contact.footprint import FOOTPRINT, footprint_kernel
from drawbar.contact.sweep import SUMS, foresee, lay_arcs, shift_window, sweep_kernel, window_of

__all__ = ["Ground", "advance", "arrays", "forces"]


@dataclasses.dataclass(frozen=True)
class Ground:
    """What the tissue remembers, column by column. Column j stands at ``first + j spacing`` [m].

    A column that is not ``pressed`` relaxes freely; its numbers hold at the time ``since`` when it was last
    looked at, and follow exactly from there.
    """

    first: float
    spacing: float
    time: float
    """now [s]; pressed columns hold at this time"""
    deflection: np.ndarray
    """w [m], positive down, of every column"""
    strains: np.ndarray
    """e_i [m] of every column and branch that has a stiffness"""
    pressed: np.ndarray
    since: np.ndarray

    @classmethod
    def fresh(cls, first: float, last: float, spacing: float, law: Law, time: float = 0.0) -> Ground:
        """Undisturbed tissue from ``first`` to ``last`` [m]."""
        count = round((last - first) / spacing) + 1
        zero = np.zeros(count)
        return cls(first, spacing, time, zero, np.zeros((count, law.times.size)), zero > 0, np.full(count, time))

    def rows(self, law: Law) -> np.ndarray:
        """The columns' memory as kernels keep it: strains of the pressed, amplitudes of the free."""
        rows = np.zeros((self.pressed.size, max(law.rates.size, law.times.size, 1)))
        flows = self.deflection[:, None] - self.strains
        amplitudes = self.deflection[:, None] * law.from_surface + flows @ law.from_flow.T
        rows[:, : law.rates.size] = amplitudes
        rows[self.pressed, : law.times.size] = self.strains[self.pressed]
        return rows

    def after(
        self, time: float, w: np.ndarray, rows: np.ndarray, pressed: np.ndarray, since: np.ndarray, law: Law
    ) -> Ground:
        """This ground at a later time, from the arrays that the kernels changed."""
        strains = w[:, None] - rows[:, : law.rates.size] @ law.flow.T
        strains[pressed] = rows[pressed, : law.times.size]
        return Ground(self.first, self.spacing, time, w, strains, pressed, since)

    def recovered(self, law: Law) -> Ground:
        """The same ground with every free column brought to the present."""
        rows = self.rows(law)
        free = ~self.pressed
        rows[free, : law.rates.size] *= np.exp(-np.outer(self.time - self.since[free], law.rates))
        w = np.where(free, rows[:, : law.rates.size] @ law.lift, self.deflection)
        return self.after(self.time, w, rows, self.pressed.copy(), np.full(free.size, self.time), law)


def no_shear(slip_velocity: Any, pressure: Any) -> Any:
    """A film that does nothing: moving the ground along needs none."""
    return 0.0 * slip_velocity


def advance(
    ground: Ground, law: Law, *, radius: float, travel: tuple[float, float], sinkage: tuple[float, float],
    duration: float, compiled: bool = True,
) -> Ground:  # fmt: skip
    """The ground after a wheel has moved over it in a straight line for ``duration`` [s].

    Exact for tops that move linearly: each column's does so between ``sinkage[0]`` at ``travel[0]`` and
    ``sinkage[1]`` at ``travel[1]`` [m]; a wheel in the air has a sinkage below zero. The given ground is
    not changed.

    >>> from drawbar.contact.column import law_of
    >>> law = law_of(2e5, 0.0, [1e5], [0.5])
    >>> ground = Ground.fresh(-0.01, 0.01, 1e-4, law)
    >>> pressed = advance(ground, law, radius=0.0075, travel=(0.0, 0.0), sinkage=(0.0, 1e-3), duration=0.1,
    ...                   compiled=False)
    >>> f"{pressed.deflection[100]:.3g} m, {pressed.strains[100, 0]:.4g} m"
    '0.001 m, 0.0009063 m'
    """
    tables = tables_of(law, duration)
    state, since, spare = arrays(ground, law, tables)
    lay_arcs(state, (0, since.size), 0.5 * (travel[0] + travel[1]), radius)
    lo, hi = window_of(ground.first, ground.spacing, since.size, *travel, max(sinkage), radius)
    shift_window(state, since, np.zeros(law.rates.size), (0, 0), (lo, hi), ground.time, law, tables)
    kernel = sweep_kernel(no_shear, compiled=compiled)
    kernel(True, state, (lo, hi), (*travel, *sinkage), 0.0, radius, law, tables, (), False, spare, np.zeros(SUMS))
    end = ground.time + duration
    since[lo:hi] = end
    return ground.after(end, state[2], state[3], state[4], since, law)


def forces(
    ground: Ground, law: Law, *, radius: float, travel: float, sinkage: float, sink_rate: float = 0.0,
    speed: float = 0.0, wheel_speed: float = 0.0, shear_stress: Any = no_shear, film: tuple[float, ...] = (),
) -> dict[str, float]:  # fmt: skip
    """What a ground does at its present time to a wheel that stands on it, per width.

    ``sinkage`` and ``travel`` must be those that the ground was last advanced to. Forces in N/m, torque in
    N, loss in W/m, peak pressure in Pa; ``rear`` and ``front`` are the edges' angles [rad], backwards and
    forwards whatever the motion. ``shear_stress`` and ``film`` are a film law's kernel and numbers.
    """
    now = ground.recovered(law)
    state, _, _ = arrays(now, law, tables_of(law, 1.0))
    window = window_of(now.first, now.spacing, now.pressed.size, travel, travel, sinkage, radius)
    out = np.zeros(len(FOOTPRINT))
    motion = (travel, sinkage, sink_rate, speed, wheel_speed)
    footprint_kernel(shear_stress)(state, window, motion, radius, law, film, out)
    return dict(zip(FOOTPRINT, out.tolist(), strict=True))


def arrays(ground: Ground, law: Law, tables: Tables) -> tuple[Any, np.ndarray, np.ndarray]:
    """Fresh arrays for the kernels: the columns, when each was last looked at, and scratch.

    The columns are (first, spacing, w, rows, pressed, now, end, arcs); ``now`` and ``end`` are what each will
    give in the coming step (see :func:`drawbar.contact.sweep.foresee`), ``arcs`` the wheel's over each.
    """
    w, rows, pressed = ground.deflection.copy(), ground.rows(law), ground.pressed.copy()
    state = (ground.first, ground.spacing, w, rows, pressed, np.zeros(w.size), np.zeros(w.size), np.zeros((w.size, 3)))
    for j in np.flatnonzero(pressed):
        foresee(j, rows, True, state[5], state[6], tables)
    return state, ground.since.copy(), np.zeros((2, 2 * rows.shape[1] + 2))

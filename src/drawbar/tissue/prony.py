"""Generalised Maxwell tissue: a Prony series of relaxation times."""

from __future__ import annotations

from typing import Any

import numpy as np

from drawbar.quantity import quantity, value
from drawbar.tissue.base import Tissue
from drawbar.tissue.memory import Series

__all__ = ["Prony"]


@value
class Prony(Series, Tissue):
    """Elastic columns beside any number of relaxing branches (generalised Maxwell).

    K(t) = k + Σ k_i exp(-t/τ_i). Creep has as many retardation times, each between two relaxation times
    or beyond the longest; they come from a symmetric eigenvalue problem, not from stepping in time.

    Valid for: as :class:`~drawbar.Winkler`, for times between about a third of the shortest relaxation time
    and three times the longest; outside, the tissue is taken as elastic, which is the series' choice and not
    the tissue's. Deep contact included.

    Source: Tschoegl 1989 (generalised Maxwell model).

    >>> tissue = Prony(stiffness=1e5, branch_stiffnesses=(1e5, 2e5), relaxation_times=(0.1, 1.0))
    >>> round(float(tissue.relaxation(0.1)), 1)
    317755.4
    """

    stiffness: float = quantity(
        "Pa/m", symbol="k", minimum=0, meaning="long-term foundation modulus: pressure per indentation held for ever",
        advice="Check the unit and the sign of the load column.",
    )  # fmt: skip
    branch_stiffnesses: tuple[float, ...] = quantity(
        "Pa/m", symbol="kᵢ", minimum=0, series=True, meaning="foundation modulus of one branch",
        advice="A branch that stiffens as it waits would create energy: leave it out of the fit.",
    )  # fmt: skip
    relaxation_times: tuple[float, ...] = quantity(
        "s", symbol="τᵢ", above=0, series=True, meaning="relaxation time of one branch",
        advice="Give the times as they are, not their logarithms.",
    )  # fmt: skip

    def __post_init__(self) -> None:
        branches, times = self.branch_stiffnesses, self.relaxation_times
        if len(branches) != len(times):
            raise ValueError(
                f"branch_stiffnesses and relaxation_times must be of one length, got {len(branches)} and "
                f"{len(times)}. Give each branch its stiffness and its time."
            )
        again = sorted({t for t in times if times.count(t) > 1})
        if again:
            raise ValueError(
                f"relaxation_times must differ from each other, got {again[0]:g} s more than once. "
                "Add up the branch_stiffnesses of equal times into one branch."
            )
        if not np.all(self.stiffness + sum(branches) > 0.0):
            raise ValueError(
                "stiffness and branch_stiffnesses must not all be 0 Pa/m: such a tissue carries nothing. "
                "Give at least one of them."
            )

    @staticmethod
    def spectrum(stiffness: Any, branch_stiffnesses: Any, relaxation_times: Any) -> Any:
        return stiffness, 0.0, branch_stiffnesses, relaxation_times

"""The standard linear solid: one relaxation time."""

from __future__ import annotations

from typing import Any

from drawbar.quantity import quantity, value
from drawbar.tissue.base import Tissue
from drawbar.tissue.memory import Series

__all__ = ["StandardLinearSolid"]


@value
class StandardLinearSolid(Series, Tissue):
    """Elastic columns beside one relaxing branch: stiff when fast, soft when slow, lossy in between.

    K(t) = k + k₁ exp(-t/τ). Creep J(t) = 1/k - (1/k - 1/(k + k₁)) exp(-t/ρ) with the retardation time
    ρ = τ (k + k₁)/k. Rolling is elastic on k at very low speed, elastic on k + k₁ at very high speed. On a
    shallow arc at fixed load with k₁ = k the resistance coefficient is at most 0.13177 a₀/R, where
    V τ = 0.3450 a₀; a₀ is the half length of the contact on k alone.

    Valid for: as :class:`~drawbar.Winkler`, within about a decade of rates around 1/τ; real tissue spreads
    its loss over many (:class:`~drawbar.Prony`, :class:`~drawbar.SpringPot`). Deep contact included: both
    vertical faces give a finite work.

    Source: Tschoegl 1989 (standard three-parameter model); rolling as in Wang, Sliker, Qi,
    Rentschler 2013.

    >>> tissue = StandardLinearSolid(stiffness=2e5, branch_stiffness=2e5, relaxation_time=0.1)
    >>> float(tissue.relaxation(0.0)), round(float(tissue.complex_modulus(10.0).imag))
    (400000.0, 100000)
    """

    stiffness: float = quantity(
        "Pa/m", symbol="k", above=0, meaning="long-term foundation modulus: pressure per indentation held for ever",
        advice="Check the unit and the sign of the load column.",
    )  # fmt: skip
    branch_stiffness: float = quantity(
        "Pa/m", symbol="k₁", minimum=0, meaning="part of the foundation modulus that relaxes"
    )
    relaxation_time: float = quantity("s", symbol="τ", above=0, meaning="time in which that part falls to 1/e")

    @staticmethod
    def spectrum(stiffness: Any, branch_stiffness: Any, relaxation_time: Any) -> Any:
        return stiffness, 0.0, (branch_stiffness,), (relaxation_time,)

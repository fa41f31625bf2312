"""Kelvin-Voigt tissue: a spring beside a dashpot."""

from __future__ import annotations

from typing import Any

from drawbar.quantity import quantity, value
from drawbar.tissue.base import Tissue
from drawbar.tissue.memory import Series

__all__ = ["KelvinVoigt"]


@value
class KelvinVoigt(Series, Tissue):
    """Elastic columns, each beside a dashpot: it creeps to its depth, and does not relax.

    p = k w + c w'. Creep J(t) = (1 - exp(-t k/c))/k, complex modulus k + i ω c; the relaxation function is
    k after an impulse c δ(t). Rolling at speed V, with λ = V c/k, ends at b = sqrt(λ² + a²) - λ behind the
    axle on a shallow arc of half length a in front.

    Valid for: as :class:`~drawbar.Winkler`, over the narrow band of rates at which c was measured, since its
    loss grows with the rate without bound. Not for deep contact: the vertical front face is met at an
    infinite rate.

    Source: Tschoegl 1989 (Kelvin-Voigt model); on columns as in Wang, Sliker, Qi, Rentschler 2013.

    >>> tissue = KelvinVoigt(stiffness=225e3, viscosity=11250.0)   # retardation time 50 ms
    >>> round(tissue.stiffness * float(tissue.creep(0.05)), 6)
    0.632121
    """

    stiffness: float = quantity(
        "Pa/m", symbol="k", above=0, meaning="foundation modulus: pressure per indentation",
        advice="Check the unit and the sign of the load column.",
    )  # fmt: skip
    viscosity: float = quantity("Pa s/m", symbol="c", minimum=0, meaning="pressure per rate of indentation")

    deep = False

    @staticmethod
    def spectrum(stiffness: Any, viscosity: Any) -> Any:
        return stiffness, viscosity, (0.0 * stiffness,), (1.0,)

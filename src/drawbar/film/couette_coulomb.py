"""A viscous film with dry friction under it: what section VI of the paper fits to its drags."""

from __future__ import annotations

from typing import Any

import numpy as np

from drawbar.elementwise import where
from drawbar.film.base import Film
from drawbar.quantity import quantity, value

__all__ = ["CouetteCoulomb"]


@value
class CouetteCoulomb(Film):
    """Coulomb plus viscous friction.

    τ = (τ₀ + μ_c p) s(V) + (μ/h) V, where s is the sign of V or, with a ``regularisation_speed`` V_r,
    the smooth s = V / sqrt(V² + V_r²). A yield stress τ₀ does not depend on the load, a friction
    coefficient μ_c does; which one a tissue shows is a question for measurement.

    Valid for: sliding. At rest the exact sign (V_r = 0) gives no stress instead of the static range;
    that is right for imposed speeds, while free motion from rest asks for V_r > 0.

    Source: Rentschler et al. 2004, section VI.A (the text says "combination of coulomb and viscous
    friction" and gives no equation; the split of the Coulomb term is this project's).

    >>> round(float(CouetteCoulomb.shear_stress(-0.02, 500.0, 1e4, 30.0, 0.1, 0.0)), 9)
    -280.0
    """

    viscous_coefficient: float = quantity(
        "Pa s/m", symbol="µ/h", minimum=0, meaning="viscosity of the film over its thickness"
    )
    yield_stress: float = quantity(
        "Pa", symbol="τ₀", minimum=0, meaning="shear stress of slow sliding, whatever the load"
    )
    friction_coefficient: float = quantity(
        "1", symbol="µ_c", minimum=0, default=0.0, meaning="shear stress of slow sliding per pressure"
    )
    regularisation_speed: float = quantity(
        "m/s", symbol="V_r", minimum=0, default=0.0,
        meaning="slip velocity over which the Coulomb term rises; 0 takes the exact sign",
    )  # fmt: skip

    @staticmethod
    def shear_stress(
        slip_velocity: Any,
        pressure: Any,
        viscous_coefficient: Any,
        yield_stress: Any,
        friction_coefficient: Any,
        regularisation_speed: Any,
    ) -> Any:
        """τ = (τ₀ + μ_c p) V / sqrt(V² + V_r²) + (μ/h) V."""
        speed = np.sqrt(slip_velocity * slip_velocity + regularisation_speed * regularisation_speed)
        direction = slip_velocity / where(speed > 0.0, speed, 1.0)
        return (yield_stress + friction_coefficient * pressure) * direction + viscous_coefficient * slip_velocity

    @property
    def continuous_at_rest(self) -> bool:
        dry = np.any(np.asarray(self.yield_stress) > 0) or np.any(np.asarray(self.friction_coefficient) > 0)
        return not dry or bool(np.all(np.asarray(self.regularisation_speed) > 0))

"""A lubricated film that carries its load by contact when slow and by pressure in the liquid when fast."""

from __future__ import annotations

import dataclasses
from typing import Any

import numpy as np

from drawbar.elementwise import where
from drawbar.film.base import Film, checked_range
from drawbar.quantity import quantity, value

__all__ = ["Stribeck"]


@value
class Stribeck(Film):
    """Boundary, mixed and hydrodynamic friction in slip velocity, pressure and viscosity.

    τ = μ_b p V/U / (1 + η U / (p ℓ)) + (η/h) V, with U = sqrt(V² + V_r²) and p = 0 for a negative pressure.

    The first term is boundary friction under the share of the load that contact still carries: one half once
    η U/p reaches the ``transition_length`` ℓ, that is at the speed V_s = p ℓ/η. More load moves the
    transition to higher speed, more viscosity to lower. The second term is a full film of constant thickness.
    With V_r = 0 the friction coefficient τ/p is a function of Hersey's number H = η V/p (a length here)
    alone: μ_b / (1 + H/ℓ) + H/h. If μ_b h > ℓ it has a minimum of 2 sqrt(μ_b ℓ/h) - ℓ/h at
    H = ℓ (sqrt(μ_b h/ℓ) - 1), otherwise it rises throughout. Without boundary friction (μ_b = 0) the law is
    :class:`~drawbar.film.couette.Couette` with µ/h = η/h. It dissipates in every state.

    Friction falls with speed between the branches, so a given torque may have several wheel speeds. At rest
    the exact sign (V_r = 0) gives no stress instead of the static range; that is right for imposed speeds,
    while free motion from rest asks for V_r > 0.

    Valid for: steady sliding (the film has time to form) of one pair of surfaces, inside the
    ``slip_velocity_range`` [m/s] and ``pressure_range`` [Pa] of the measurement behind the numbers; both are
    (low, high), are read by :meth:`range` and are no part of the law's equality. The constant thickness is
    this law's simplification: a self-acting film thickens with H, so that friction far beyond the minimum is
    an upper estimate.

    Source: that friction follows η V/p is Stribeck's and Hersey's finding. A boundary friction that falls as
    1/(1 + (V/V_s)²) is Hess and Soom's (1990); the first power, the transition speed in proportion to p/η and
    the sum with a film of constant thickness are this project's.

    >>> round(float(Stribeck.shear_stress(0.01, 100.0, 0.08, 1e-3, 1e-7, 1e-5, 0.0)), 9)
    5.0
    """

    boundary_friction_coefficient: float = quantity(
        "1", symbol="µ_b", minimum=0, meaning="shear stress of very slow sliding per pressure"
    )
    viscosity: float = quantity("Pa s", symbol="η", minimum=0, meaning="viscosity of the liquid in the film")
    transition_length: float = quantity(
        "m", symbol="ℓ", above=0,
        meaning="viscosity times slip velocity per pressure at which boundary friction has halved",
    )  # fmt: skip
    film_thickness: float = quantity(
        "m", symbol="h", above=0, meaning="thickness of the sheared film once it carries the load"
    )
    regularisation_speed: float = quantity(
        "m/s", symbol="V_r", minimum=0, default=0.0,
        meaning="slip velocity over which the boundary friction rises; 0 takes the exact sign",
    )  # fmt: skip
    slip_velocity_range: tuple[float, float] | None = dataclasses.field(default=None, repr=False, compare=False)
    pressure_range: tuple[float, float] | None = dataclasses.field(default=None, repr=False, compare=False)

    def __post_init__(self) -> None:
        for name, unit in (("slip_velocity_range", "m/s"), ("pressure_range", "Pa")):
            object.__setattr__(self, name, checked_range(name, getattr(self, name), unit))

    @staticmethod
    def shear_stress(
        slip_velocity: Any,
        pressure: Any,
        boundary_friction_coefficient: Any,
        viscosity: Any,
        transition_length: Any,
        film_thickness: Any,
        regularisation_speed: Any,
    ) -> Any:
        """τ = μ_b p V/U / (1 + η U / (p ℓ)) + (η/h) V, with U = sqrt(V² + V_r²)."""
        load = np.maximum(pressure, 0.0)
        speed = np.sqrt(slip_velocity * slip_velocity + regularisation_speed * regularisation_speed)
        contact = load * transition_length
        total = contact + viscosity * speed
        share = contact / where(total > 0.0, total, 1.0)
        direction = slip_velocity / where(speed > 0.0, speed, 1.0)
        return boundary_friction_coefficient * load * share * direction + viscosity / film_thickness * slip_velocity

    @property
    def continuous_at_rest(self) -> bool:
        dry = np.any(np.asarray(self.boundary_friction_coefficient) > 0)
        return not dry or bool(np.all(np.asarray(self.regularisation_speed) > 0))

    def range(self) -> dict[str, tuple[float, float] | None]:
        return {"slip_velocity": self.slip_velocity_range, "pressure": self.pressure_range}

"""A Newtonian film of constant thickness: the paper's peritoneal fluid."""

from __future__ import annotations

from typing import Any

import numpy as np

from drawbar.film.base import Film
from drawbar.quantity import quantity, value

__all__ = ["Couette"]


@value
class Couette(Film):
    """Plane Couette flow: shear stress proportional to slip velocity, whatever the pressure.

    τ = (μ/h) V. ``viscous_coefficient`` is μ/h, the viscosity over the film thickness.

    Valid for: a full film of constant thickness (no contact through it), laminar, Newtonian.

    Source: Rentschler et al. 2004, equation (13).

    >>> Couette.shear_stress(0.0254, 500.0, 1e4)
    254.0
    """

    viscous_coefficient: float = quantity(
        "Pa s/m", symbol="µ/h", minimum=0, meaning="viscosity of the film over its thickness"
    )

    @staticmethod
    def shear_stress(slip_velocity: Any, pressure: Any, viscous_coefficient: Any) -> Any:
        """τ = (μ/h) V."""
        return viscous_coefficient * slip_velocity

    @staticmethod
    def arc(
        rear: Any, front: Any, vx: Any, vy: Any, omega: Any, radius: Any, viscous_coefficient: Any
    ) -> tuple[Any, Any, Any, Any, Any]:
        """Exact integrals of τ over the arc; for rear = -front they are equations (15) and (17)."""
        rim = radius * omega
        angle = front - rear
        sine = np.sin(front) - np.sin(rear)  # ∫ cos
        cosine = np.cos(rear) - np.cos(front)  # ∫ sin
        square = 0.5 * angle + 0.25 * (np.sin(2.0 * front) - np.sin(2.0 * rear))  # ∫ cos²
        mixed = 0.5 * (np.sin(front) ** 2 - np.sin(rear) ** 2)  # ∫ sin cos
        scale = viscous_coefficient * radius
        along = scale * (rim * sine - vx * square)
        upward = scale * (rim * cosine - vx * mixed)
        side = -scale * vy * angle
        torque = scale * radius * (rim * angle - vx * sine)
        return along, upward, side, torque, omega * torque - vx * along - vy * side

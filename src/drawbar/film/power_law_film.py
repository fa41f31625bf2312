"""A film that thins as it is sheared faster: mucus, peritoneal fluid with its long molecules."""

from __future__ import annotations

from typing import Any

import numpy as np

from drawbar.elementwise import where
from drawbar.film.base import Film
from drawbar.quantity import quantity, value

__all__ = ["PowerLawFilm"]


@value
class PowerLawFilm(Film):
    """Plane flow of a shear-thinning film, whatever the pressure.

    τ = (μ/h) V (U/V₀)^(n-1), with U = sqrt(V² + V_r²).

    (μ/h) is the ``viscous_coefficient`` at the ``reference_speed`` V₀, so that its unit does not hang on the
    ``flow_index`` n. It is the power law τ = m (V/h)^n with m = μ (V₀/h)^(1-n). Below the
    ``regularisation_speed`` V_r the film is Newtonian, with the coefficient (μ/h) (V_r/V₀)^(n-1); V_r = 0 is
    the exact power law, whose stress still starts from zero but with an infinite slope. n = 1 is
    :class:`~drawbar.film.couette.Couette` exactly.

    Valid for: a full film of constant thickness, laminar, in steady shear (no elasticity of the liquid), over
    the speeds at which n was measured, well below those at which a thinning liquid reaches its least viscosity.

    Source: the Ostwald-de Waele power law; the regularised form is Carreau's equation without its plateau at
    high rates. The choice of V₀ in place of a consistency is this project's.

    >>> round(float(PowerLawFilm.shear_stress(0.04, 500.0, 1e4, 0.01, 0.5, 0.0)), 9)
    200.0
    """

    viscous_coefficient: float = quantity(
        "Pa s/m", symbol="µ/h", minimum=0,
        meaning="apparent viscosity of the film at the reference speed, over its thickness",
    )  # fmt: skip
    reference_speed: float = quantity(
        "m/s", symbol="V₀", above=0, meaning="slip velocity at which viscous_coefficient is stated"
    )
    flow_index: float = quantity(
        "1", symbol="n", above=0, maximum=1,
        meaning="exponent of the shear stress in the slip velocity; 1 is a Newtonian film",
        advice="Less than 1 thins; a film that thickens with speed is not this law.",
    )  # fmt: skip
    regularisation_speed: float = quantity(
        "m/s", symbol="V_r", minimum=0, default=0.0,
        meaning="slip velocity below which the film is Newtonian; 0 takes the exact power law",
    )  # fmt: skip

    @staticmethod
    def shear_stress(
        slip_velocity: Any,
        pressure: Any,
        viscous_coefficient: Any,
        reference_speed: Any,
        flow_index: Any,
        regularisation_speed: Any,
    ) -> Any:
        """τ = (μ/h) V (sqrt(V² + V_r²)/V₀)^(n-1)."""
        speed = np.sqrt(slip_velocity * slip_velocity + regularisation_speed * regularisation_speed)
        thinning = where(speed > 0.0, speed / reference_speed, 1.0) ** (flow_index - 1.0)
        return viscous_coefficient * slip_velocity * thinning

"""The wheel: a rigid cylinder. Radius, never diameter."""

from __future__ import annotations

from drawbar.quantity import quantity, value

__all__ = ["Wheel"]


@value
class Wheel:
    """A smooth rigid wheel.

    ``mass`` is what moves up and down and along with it; ``inertia`` is about its axle and, when it is
    not given, that of a solid cylinder, J = m r²/2. Neither matters in steady rolling.

    The default mass is the whole robot's, as in the source's equation (9).

    Source: Rentschler et al. 2004, sections III and VII.B (28 g; the wheel width is not printed).

    >>> Wheel(radius=0.0075, width=0.020).inertia
    7.875e-07
    """

    radius: float = quantity(
        "m", symbol="r", above=0, maximum=0.5, meaning="the wheel's radius, half its diameter",
        advice="Is the number a diameter, or in millimetres? Wheels here are SI, at most 1 m across.",
    )  # fmt: skip
    width: float = quantity("m", symbol="L", above=0, maximum=1.0, meaning="the wheel's width along its axle")
    mass: float = quantity(
        "kg", symbol="m", above=0, default=0.028, meaning="the mass that moves with the wheel",
        source="Rentschler et al. 2004, section VII.B: the robot weighs 28 g",
    )  # fmt: skip
    inertia: float | None = quantity(
        "kg m^2",
        symbol="J",
        above=0,
        default=None,
        meaning="moment of inertia about the axle (m r²/2 if not given)",
    )

    def __post_init__(self) -> None:
        if self.inertia is None:
            object.__setattr__(self, "inertia", 0.5 * self.mass * self.radius * self.radius)

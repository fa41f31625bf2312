"""What a rig's sensors add to the truth: noise of each sample, a zero error of each run."""

from __future__ import annotations

from drawbar.quantity import quantity, value

__all__ = ["Sensors"]


@value
class Sensors:
    """Load cell, torque sensor, inclinometer on the lever, and the plate test's dial gauge.

    A noise is the standard deviation of a single sample (white, normal); a bias is the standard
    deviation of a zero error that is drawn once for each run. None of them is printed in the 2004
    paper: the defaults are a perfect rig.
    """

    force_noise: float = quantity("N", minimum=0, default=0.0, meaning="load cell: standard deviation of a sample")
    force_bias: float = quantity("N", minimum=0, default=0.0, meaning="load cell: zero error of a run")
    torque_noise: float = quantity("N m", minimum=0, default=0.0, meaning="torque: standard deviation of a sample")
    angle_noise: float = quantity("rad", minimum=0, default=0.0, meaning="inclinometer: standard deviation of a sample")
    angle_bias: float = quantity("rad", minimum=0, default=0.0, meaning="inclinometer: zero error of a run")
    deflection_noise: float = quantity(
        "m", minimum=0, default=0.0, meaning="dial gauge: standard deviation of a reading"
    )
    sampling_rate: float = quantity("1/s", above=0, maximum=1e5, default=100.0, meaning="samples per second")
    lever_length: float = quantity(
        "m",
        above=0,
        default=0.15,
        meaning="from the lever's pivot to the wheel's axle",
        source="assumed, not printed",
    )

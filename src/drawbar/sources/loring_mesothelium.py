"""What Loring and colleagues print on the friction of a rat's abdominal wall, and a film fitted to it.

S. H. Loring, R. E. Brown, A. Gouldstone, J. P. Butler: *Lubrication regimes in mesothelial sliding*.
"""

from __future__ import annotations

import math

from drawbar.film.stribeck import Stribeck
from drawbar.sources.number import Number, Preset

__all__ = ["ASSUMED", "CITATION", "FITTED", "MISFIT", "POINTS", "PRESETS", "PRINTED"]

CITATION = "S. H. Loring, R. E. Brown, A. Gouldstone, J. P. Butler: Lubrication regimes in mesothelial sliding"

PRINTED: dict[str, Number] = {
    "low_speed": Number(0.00041, "m/s", "0.041 cm/s", "abstract"),
    "low_speed_friction": Number(0.078, "1", "0.078 at 0.041 cm/s", "abstract"),
    "middle_speed": Number(0.0123, "m/s", "1.23 cm/s", "abstract"),
    "middle_speed_friction": Number(0.034, "1", "0.034 at 1.23 cm/s", "abstract"),
    "high_speed": Number(0.0614, "m/s", "6.14 cm/s", "abstract"),
    "high_speed_friction": Number(0.045, "1", "0.045 at 6.14 cm/s", "abstract"),
    "pressure_low": Number(50.0, "Pa", "50-200 Pa", "abstract"),
    "pressure_high": Number(200.0, "Pa", "50-200 Pa", "abstract"),
}
"""Mean friction coefficients of the abdominal wall on glass in saline, and the normal stresses."""

POINTS: tuple[tuple[float, float], ...] = tuple(
    (PRINTED[f"{name}_speed"].value, PRINTED[f"{name}_speed_friction"].value) for name in ("low", "middle", "high")
)
"""(slip velocity [m/s], friction coefficient) of the three printed points."""

ASSUMED: dict[str, Number] = {
    "viscosity": Number(1e-3, "Pa s", "not printed (saline)", "assumed: water's 1 mPa s"),
    "pressure": Number(
        math.sqrt(PRINTED["pressure_low"].value * PRINTED["pressure_high"].value), "Pa",
        "not printed (a mean over 50-200 Pa)", "assumed: the geometric mean of the printed range",
    ),
    "regularisation_speed": Number(
        1e-5, "m/s", "not printed", "assumed: a fortieth of the slowest printed speed, so that free motion may start"
    ),
}  # fmt: skip
"""What the fit needs and the abstract does not print."""

FITTED: dict[str, Number] = {
    "boundary_friction_coefficient": Number(0.0834, "1", "not printed", "fitted to the three points"),
    "transition_length": Number(5.70e-8, "m", "not printed", "fitted; in proportion to the assumed viscosity/pressure"),
    "film_thickness": Number(1.62e-5, "m", "not printed", "fitted; in proportion to the assumed viscosity/pressure"),
}
"""Three numbers from three points: they meet the points by construction, which tests nothing."""

MISFIT = 4e-5
"""Largest deviation of the fitted law from a printed friction coefficient; these have two digits."""

PRESETS: tuple[Preset, ...] = (
    Preset(
        "mesothelium-loring",
        Stribeck(
            **{name: number.value for name, number in FITTED.items()},
            viscosity=ASSUMED["viscosity"].value,
            regularisation_speed=ASSUMED["regularisation_speed"].value,
            slip_velocity_range=(PRINTED["low_speed"].value, PRINTED["high_speed"].value),
            pressure_range=(PRINTED["pressure_low"].value, PRINTED["pressure_high"].value),
        ),
        "fitted to the three printed friction coefficients of rat abdominal wall on glass in saline, Loring et al. "
        "(met to 4e-5, with no point left to test it; its minimum, 0.031 at 2.2 cm/s, lies below the 0.034 printed "
        "at 1.23 cm/s); 1 mPa s and 100 Pa are assumptions, the printed loads are 50-200 Pa",
    ),
)

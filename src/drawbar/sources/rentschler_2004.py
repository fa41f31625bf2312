"""What Rentschler and colleagues print in 2004, and nothing that they do not.

M. Rentschler, J. Dumpert, A. Hadzialic, S. R. Platt, D. Oleynikov, K. Iagnemma, S. Farritor:
*Theoretical and Experimental Analysis of In Vivo Wheeled Mobility*, draft DETC2004-57468 (2004).

Figures are not digitised: of a measurement this holds only what the text says in words or numbers.
"""

from __future__ import annotations

import dataclasses

from drawbar.film.couette import Couette
from drawbar.sources.number import Number, Preset
from drawbar.tissue.winkler import Winkler
from drawbar.wheel.base import Wheel

__all__ = [
    "ASSUMED",
    "CITATION",
    "DRAG_SPEEDS",
    "LOADS",
    "OUTCOMES",
    "PLATE_MASSES",
    "PRESETS",
    "PRINTED",
    "SPEED_RATIOS",
    "Number",
    "Outcome",
    "Preset",
]

CITATION = (
    "M. Rentschler, J. Dumpert, A. Hadzialic, S. R. Platt, D. Oleynikov, K. Iagnemma, S. Farritor: Theoretical "
    "and Experimental Analysis of In Vivo Wheeled Mobility, draft DETC2004-57468, 2004"
)

GRAVITY = 9.81
"""m/s². The paper writes g; its mg for 28 g is 0.27 N (section VIII.C)."""


PRINTED: dict[str, Number] = {
    "foam_stiffness": Number(225_000.0, "Pa/m", "225,000 (N/m²)/m", "section VI.B"),
    "liver_stiffness": Number(415_000.0, "Pa/m", "415,000 (N/m²)/m", "section VI.B"),
    "slide_speed": Number(0.0254, "m/s", "2.54 cm/s", "section VII.A"),
    "travel": Number(0.20, "m", "approximately 20 cm", "section VII.A"),
    "repeats": Number(10, "1", "a set of ten tests", "section VII.A"),
    "robot_mass": Number(0.028, "kg", "28 grams", "section VII.B"),
    "robot_diameter": Number(0.015, "m", "15 mm in diameter", "section III"),
    "robot_length": Number(0.085, "m", "85 mm long", "section III"),
    "plate_mass_low": Number(0.020, "kg", "between 20 and 200 grams", "section VI.B"),
    "plate_mass_high": Number(0.200, "kg", "between 20 and 200 grams", "section VI.B"),
    "plate_sets": Number(3, "1", "three separate sets, the plate's orientation changed", "section VI.B"),
    "drag_speeds": Number(5, "1", "five different linear velocities", "section VI.A"),
    "drag_loads": Number(3, "1", "three normal forces", "section VI.A"),
    "drag_repeats": Number(3, "1", "repeated three times", "section VI.A"),
    "female_liver_force": Number(0.05, "N", "only 0.05 N, at N = W", "section VIII.C"),
    "male_liver_force": Number(0.1, "N", "approximately 0.1 N, at N = W and a slip ratio of 0.5", "section VIII.D"),
    "simulation_over_measurement": Number(3.0, "1", "a factor of approximately three", "section VII.B"),
}
"""Numbers that the paper prints."""

WEIGHT = PRINTED["robot_mass"].value * GRAVITY
"""The robot's weight W, 0.27468 N."""

LOADS = (0.5, 1.0, 1.5)
"""Normal loads on one wheel, in units of W (section VII.B)."""

SPEED_RATIOS = (0.5, 1.0, 1.5)
"""v/(rω), the paper's "slip ratio", equation (20): 0.5 pulls, 1.5 skids (section VII.A)."""

ASSUMED: dict[str, Number] = {
    "wheel_width": Number(0.020, "m", "not printed", "assumed: two wheels of 20 mm leave 45 mm of the 85 mm body"),
    "foam_viscous_coefficient": Number(
        1.0e4, "Pa s/m", "not printed", "assumed: water's 1 mPa s over a film of 0.1 µm"
    ),
    "liver_viscous_coefficient": Number(
        1.0e4, "Pa s/m", "not printed (section VIII.B: lower than on foam)", "assumed: as on foam"
    ),
    "yield_stress": Number(20.0, "Pa", "not printed", "assumed: the shear of 2 mm/s in that film"),
    "plate_area": Number(2.5e-3, "m^2", "not printed", "assumed: 50 mm × 50 mm"),
    "lever_damper": Number(0.5, "N s/m", "not printed", "assumed: settles the wheel in a fraction of a second"),
    "drag_speed_low": Number(0.005, "m/s", "not printed", "assumed: a fifth of the rig's 2.54 cm/s"),
    "drag_speed_high": Number(0.0254, "m/s", "not printed", "assumed: the rig's 2.54 cm/s"),
}
"""Inputs that the paper does not print. These are this project's choices, to be replaced by one's own;
none was read off a figure."""


PLATE_MASSES = tuple(
    PRINTED["plate_mass_low"].value + (PRINTED["plate_mass_high"].value - PRINTED["plate_mass_low"].value) * i / 9
    for i in range(10)
)
"""kg. The printed range in ten equal steps; how many steps there were is assumed."""

DRAG_SPEEDS = tuple(
    ASSUMED["drag_speed_low"].value
    + (ASSUMED["drag_speed_high"].value - ASSUMED["drag_speed_low"].value) * i / (PRINTED["drag_speeds"].value - 1)
    for i in range(int(PRINTED["drag_speeds"].value))
)
"""m/s. Five, as printed, between assumed ends."""


@dataclasses.dataclass(frozen=True)
class Outcome:
    """A printed outcome: which measurement, in the paper's sense, and where it stands."""

    name: str
    tissue: str
    wheel: str
    statement: str
    where: str


OUTCOMES: tuple[Outcome, ...] = (
    Outcome("P1", "foam", "smooth", "drawbar positive at speed ratio 0.5, about zero at 1, negative at 1.5", "VII.B, VIII.B, Fig. 11"),  # noqa: E501
    Outcome("P2", "foam", "smooth", "the force's magnitude grows with the normal load", "VII.B, VIII.B, Fig. 10 and 11"),  # noqa: E501
    Outcome("P3", "foam", "smooth", "the simulation is about three times the measurement, which is a scaled copy of it", "VII.B, Fig. 10 and 11"),  # noqa: E501
    Outcome("P4", "foam", "all", "female and male wheels pull almost the same as the smooth one", "VIII.C, VIII.D, Fig. 14 and 16"),  # noqa: E501
    Outcome("P5", "liver", "smooth", "forces two to three times lower than on foam", "VIII.B, Fig. 13"),
    Outcome("P6", "liver", "smooth", "all nine forces negative, also at speed ratios 1 and 0.5", "VIII.B, Fig. 13"),
    Outcome("P7", "liver", "female", "+0.05 N at speed ratio 0.5 and N = W", "VIII.C, Fig. 15"),
    Outcome("P8", "liver", "male", "about +0.1 N at speed ratio 0.5 and N = W", "VIII.D, Fig. 17"),
    Outcome("P9", "liver", "male", "at speed ratio 0.5 the same force at 0.5, 1 and 1.5 W", "VIII.D, Fig. 17"),
    Outcome("P10", "liver", "all", "the male wheel is best, by a factor of two", "VIII.E"),
)  # fmt: skip


PRESETS: tuple[Preset, ...] = (
    Preset(
        "foam-2004",
        Winkler(stiffness=PRINTED["foam_stiffness"].value),
        "stiffness as printed, Rentschler et al. 2004, section VI.B",
    ),
    Preset(
        "bovine-liver-2004",
        Winkler(stiffness=PRINTED["liver_stiffness"].value),
        "stiffness as printed, Rentschler et al. 2004, section VI.B",
    ),
    Preset(
        "robot-2004",
        Wheel(
            radius=PRINTED["robot_diameter"].value / 2,
            width=ASSUMED["wheel_width"].value,
            mass=PRINTED["robot_mass"].value,
        ),
        "radius and mass as printed, Rentschler et al. 2004, sections III and VII.B; the width is not printed: "
        "20 mm is an assumption, give your own",
    ),
    Preset(
        "film-assumed",
        Couette(viscous_coefficient=ASSUMED["foam_viscous_coefficient"].value),
        "NOT from the paper, which does not print µ/h: water's 1 mPa s over 0.1 µm is an assumption, give your own",
    ),
)

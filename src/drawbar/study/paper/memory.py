"""What a tissue's memory would do to the paper's liver: the mechanism that an elastic law cannot have.

An exploration, not a fit and not a verdict: the exponent of liver's power law is swept, since the paper
prints no relaxation. Everything else is as in the paper's model.
"""

from __future__ import annotations

import numpy as np
import xarray as xr
from scipy.special import gamma

from drawbar.film.couette import Couette
from drawbar.motion.steady import grid, steady
from drawbar.sources.rentschler_2004 import ASSUMED, LOADS, PRINTED, SPEED_RATIOS, WEIGHT
from drawbar.study.paper.model import STIFFNESS, wheel_of_width
from drawbar.tissue.spring_pot import SpringPot
from drawbar.tissue.winkler import Winkler

__all__ = ["EXPONENTS", "FILMS", "READING_TIME", "memory_sweep", "power_curve", "same_plate_reading"]

EXPONENTS = np.array([0.0, 0.02, 0.05, 0.1, 0.15, 0.2, 0.25, 0.3])
"""Exponents of the power law; 0 is the paper's elastic tissue."""

FILMS = np.geomspace(1e3, 1e5, 13)
"""Film coefficients µ/h [Pa s/m], two decades about the assumed one."""

READING_TIME = 10.0
"""Seconds after which a plate's deflection is taken to have been read: assumed, the paper prints none."""


def same_plate_reading(stiffness: float, exponent: float) -> Winkler | SpringPot:
    """The spring-pot that a plate test read after :data:`READING_TIME` takes for this stiffness [Pa/m].

    Under a constant weight a spring-pot creeps as J(t) = t^α / (C Γ(1-α) Γ(1+α)); the test reads
    1/J, so C = k t^α / (Γ(1-α) Γ(1+α)). An exponent of 0 is Winkler.
    """
    if exponent == 0.0:
        return Winkler(stiffness=stiffness)
    creep = gamma(1.0 - exponent) * gamma(1.0 + exponent)
    return SpringPot(coefficient=stiffness * READING_TIME**exponent / creep, exponent=exponent)


def memory_sweep(tissue: str = "liver") -> xr.Dataset:
    """Drawbar force and rolling resistance [N] of the smooth wheel over exponent, film, load and speed ratio.

    Every exponent gives the same plate reading, the printed stiffness. ``negative`` counts how many of the
    nine forces are negative: nine is the paper's outcome P6.
    """
    wheel = wheel_of_width(ASSUMED["wheel_width"].value)
    axes = {
        "viscous_coefficient": xr.DataArray(FILMS, dims="viscous_coefficient"),
        "load_ratio": xr.DataArray(list(LOADS), dims="load_ratio"),
        "speed_ratio": xr.DataArray(list(SPEED_RATIOS), dims="speed_ratio"),
    }
    parts = []
    for exponent in EXPONENTS:
        result = steady(
            wheel,
            same_plate_reading(STIFFNESS[tissue], float(exponent)),
            Couette(viscous_coefficient=axes["viscous_coefficient"]),  # type: ignore[arg-type]
            normal_load=axes["load_ratio"] * WEIGHT,
            speed=PRINTED["slide_speed"].value,
            speed_ratio=axes["speed_ratio"],
        )
        parts.append(result[["drawbar_force", "rolling_resistance"]].reset_coords(drop=True))
    data = xr.concat(parts, "exponent").assign_coords(
        exponent=EXPONENTS, viscous_coefficient=FILMS, load_ratio=list(LOADS), speed_ratio=list(SPEED_RATIOS)
    )
    data["negative"] = (data.drawbar_force < 0).sum(["load_ratio", "speed_ratio"])
    data.negative.attrs = {"units": "1", "long_name": "how many of the nine forces are negative"}
    data.exponent.attrs = {"units": "1", "long_name": "exponent of the tissue's power law; 0 is elastic"}
    data.viscous_coefficient.attrs = {"units": "Pa s/m", "long_name": "film coefficient µ/h"}
    data.attrs = {"tissue": tissue, "reading_time": READING_TIME, "wheel_width": wheel.width}
    return data


def power_curve(tissue: str = "liver", exponent: float = 0.2) -> xr.Dataset:
    """Steady rolling at N = W over the speed ratio, with every power of the ledger."""
    film = Couette(viscous_coefficient=ASSUMED["liver_viscous_coefficient"].value)
    law = same_plate_reading(STIFFNESS[tissue], exponent)
    ratios = grid(speed_ratio=np.linspace(SPEED_RATIOS[0], SPEED_RATIOS[-1], 41))
    wheel = wheel_of_width(ASSUMED["wheel_width"].value)
    return steady(wheel, law, film, normal_load=WEIGHT, speed=PRINTED["slide_speed"].value, **ratios)

"""The paper's own model against its printed outcomes: elastic tissue, viscous film, smooth wheel."""

from __future__ import annotations

import numpy as np
import xarray as xr

from drawbar.contact.closed_form import drawbar_number
from drawbar.film.couette import Couette
from drawbar.motion.steady import grid, steady
from drawbar.sources.rentschler_2004 import ASSUMED, LOADS, PRINTED, SPEED_RATIOS, WEIGHT
from drawbar.study.paper.outcomes import LOWER, Verdict, at_assumed_width, judge
from drawbar.tissue.filonenko_borodich import FilonenkoBorodich
from drawbar.tissue.winkler import Winkler
from drawbar.wheel.base import Wheel

__all__ = ["NAME", "WIDTHS", "drawbar_maps", "laws", "tension_error", "verdicts", "wheel_of_width"]

NAME = "elastic tissue, viscous film (2004)"

WIDTHS = np.arange(5, 43) * 1e-3
"""Wheel widths [m] swept, since the paper prints none: two must fit on a body of 85 mm."""

STIFFNESS = {"foam": PRINTED["foam_stiffness"].value, "liver": PRINTED["liver_stiffness"].value}


def wheel_of_width(width: float) -> Wheel:
    """The robot's smooth wheel at some width [m]."""
    return Wheel(radius=PRINTED["robot_diameter"].value / 2, width=width, mass=PRINTED["robot_mass"].value)


def laws(tissue: str) -> tuple[Winkler, Couette]:
    """The tissue with its printed stiffness, and the assumed film."""
    film = Couette(viscous_coefficient=ASSUMED[f"{tissue}_viscous_coefficient"].value)
    return Winkler(stiffness=STIFFNESS[tissue]), film


def drawbar_maps() -> dict[tuple[str, str], xr.DataArray]:
    """Drawbar force [N] of the smooth wheel on foam and liver, over width, load (N/W) and speed ratio.

    Both tissues carry the same assumed film, so that what differs is what is printed: the stiffness.
    """
    axes = grid(load_ratio=np.array(LOADS), speed_ratio=np.array(SPEED_RATIOS))
    width = xr.DataArray(WIDTHS, dims="wheel_width")
    wheel = Wheel(radius=PRINTED["robot_diameter"].value / 2, width=width)  # type: ignore[arg-type]
    film = Couette(viscous_coefficient=ASSUMED["foam_viscous_coefficient"].value)
    maps = {}
    for tissue, stiffness in STIFFNESS.items():
        result = steady(
            wheel,
            Winkler(stiffness=stiffness),
            film,
            normal_load=axes["load_ratio"] * WEIGHT,
            speed=PRINTED["slide_speed"].value,
            speed_ratio=axes["speed_ratio"],
        )
        force = result.drawbar_force.reset_coords(drop=True)
        coords = {"wheel_width": WIDTHS, "load_ratio": list(LOADS), "speed_ratio": list(SPEED_RATIOS)}
        maps[tissue, "smooth"] = force.transpose(*coords).assign_coords(coords)
    return maps


def verdicts(maps: dict[tuple[str, str], xr.DataArray]) -> tuple[Verdict, ...]:
    """P1 to P10 as the paper's model gives them in its :func:`drawbar_maps`, with reasons in words."""
    return judge(NAME, maps, _reasons(maps))


def _reasons(maps: dict[tuple[str, str], xr.DataArray]) -> dict[str, str]:
    foam, liver = (at_assumed_width(maps[t, "smooth"]) for t in ("foam", "liver"))
    share = float((abs(foam.sel(speed_ratio=1.0)) / foam.sel(speed_ratio=0.5)).max())
    ratio = abs(foam) / abs(liver)
    low, high = (float(f(ratio.sel(speed_ratio=[0.5, 1.5]))) for f in (np.min, np.max))
    least = _least_pull()
    no_tread = "the model knows smooth wheels only"
    dropped = f"{LOWER[0] / high:.1f} to {LOWER[1] / low:.1f} times"
    thrice = " : ".join(
        f"{float(f / liver.sel(load_ratio=1.0, speed_ratio=0.5)):.2f}" for f in liver.sel(speed_ratio=0.5)
    )
    return {
        "P1": "the signs follow from equation (17); at speed ratio 1 the force is up to "
        f"{share:.0%} of that at 0.5, since the rim away from the lowest point moves forward slower than the axle",
        "P2": "at speed ratio 0.5 the contact, and with it the force, grows with the load until it is deep; at 1.5 "
        "the force by (17) falls with load once cos φ < 2/3, and in deep contact load no longer matters",
        "P3": "the model is the simulation: against itself it has no factor of three, and with stiffness and film "
        "fixed by bench tests nothing in it is left to give one. Its force is proportional to µ/h, so a film "
        "coefficient three times too high does exactly this; a resistance of the tissue would shift the curve, "
        "not scale it",
        "P4": no_tread,
        "P5": f"by stiffness alone, with one film on both, foam pulls {low:.2f} to {high:.2f} times as hard as liver "
        f"at speed ratios 0.5 and 1.5; two to three needs a film coefficient {dropped} lower on liver, which the "
        "paper names as the cause and does not print",
        "P6": f"by (17) the force at speed ratio 0.5 is at least {least:.2f} φ (µ/h) L r v for every contact angle φ, "
        f"so it is positive whatever the parameters; {int((liver < 0).sum())} of 9 forces are negative, at speed "
        "ratio 1.5. An offset is missing: a rolling resistance of the tissue, which an elastic law cannot have",
        "P7": no_tread,
        "P8": no_tread,
        "P9": f"{no_tread}; its own smooth wheel gives forces at 0.5, 1 and 1.5 W in the ratio {thrice}",
        "P10": no_tread,
    }


def _least_pull() -> float:
    """The least of F/φ at speed ratio 0.5 over all contact angles, in units of (µ/h) L r v."""
    phi = np.linspace(1e-6, np.pi / 2, 2001)
    return float(np.min(drawbar_number(phi, 0.5) / phi))


def tension_error(stiffness: float = STIFFNESS["foam"]) -> xr.Dataset:
    """What dropping the tension T costs: sinkage and drawbar force without T over those with it, less 1.

    Over ℓ/r = sqrt(T/k)/r from 0.001 to 1 and the three loads, at speed ratio 0.5 and the assumed width.
    The paper argues that T is small from the surface being flat beside the wheel; it prints no value.
    """
    wheel = wheel_of_width(ASSUMED["wheel_width"].value)
    film = Couette(viscous_coefficient=ASSUMED["foam_viscous_coefficient"].value)
    ratio = xr.DataArray(np.geomspace(1e-3, 1.0, 61), dims="decay_ratio")
    settings = {
        "normal_load": WEIGHT * xr.DataArray(list(LOADS), dims="load_ratio"),
        "speed": PRINTED["slide_speed"].value,
    }
    settings["speed_ratio"] = 0.5
    taut = FilonenkoBorodich(stiffness=stiffness, tension=stiffness * (ratio * wheel.radius) ** 2)  # type: ignore[arg-type]
    kept = steady(wheel, taut, film, **settings)
    dropped = steady(wheel, Winkler(stiffness=stiffness), film, **settings)
    errors = {}
    for name in ("sinkage", "drawbar_force"):
        error = (dropped[name] / kept[name] - 1.0).reset_coords(drop=True)
        errors[f"{name}_error"] = error.assign_attrs(units="1", long_name=f"relative error in {name} without tension")
    data = xr.Dataset(errors).assign_coords(decay_ratio=ratio.values, load_ratio=list(LOADS))
    data.decay_ratio.attrs = {"units": "1", "long_name": "ℓ/r = sqrt(T/k)/r"}
    data.load_ratio.attrs = {"units": "1", "long_name": "normal load over the robot's weight"}
    return data

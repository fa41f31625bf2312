"""Wheeled mobility on living tissue: how hard a wheel pulls on a soft, wet organ.

>>> import drawbar
>>> result = drawbar.steady(
...     drawbar.Wheel(radius=0.0075, width=0.020),
...     drawbar.Winkler(stiffness=225e3),
...     drawbar.Couette(viscous_coefficient=1e4),
...     normal_load=0.27468, speed=0.0254, speed_ratio=0.5,
... )
>>> round(float(result.drawbar_force), 4)
0.0883
"""

from __future__ import annotations

import importlib
from typing import TYPE_CHECKING, Any

__version__ = "0.1.0"

if TYPE_CHECKING:
    from drawbar.catalogue import find as find
    from drawbar.catalogue import save as save
    from drawbar.contact.wrench import State as State
    from drawbar.contact.wrench import Wrench as Wrench
    from drawbar.contact.wrench import wrench as wrench
    from drawbar.film.base import Film as Film
    from drawbar.film.couette import Couette as Couette
    from drawbar.film.couette_coulomb import CouetteCoulomb as CouetteCoulomb
    from drawbar.film.frictionless import Frictionless as Frictionless
    from drawbar.film.power_law_film import PowerLawFilm as PowerLawFilm
    from drawbar.film.stribeck import Stribeck as Stribeck
    from drawbar.motion.planar import simulate as simulate
    from drawbar.motion.steady import grid as grid
    from drawbar.motion.steady import steady as steady
    from drawbar.rig.drawbar_test import drawbar_test as drawbar_test
    from drawbar.rig.load import load as load
    from drawbar.rig.plate_test import plate_test as plate_test
    from drawbar.rig.sensors import Sensors as Sensors
    from drawbar.study.compare.compare import compare as compare
    from drawbar.study.identify.film import identify_film as identify_film
    from drawbar.study.identify.stiffness import identify_stiffness as identify_stiffness
    from drawbar.study.paper.reproduce import reproduce as reproduce
    from drawbar.tissue.base import Tissue as Tissue
    from drawbar.tissue.filonenko_borodich import FilonenkoBorodich as FilonenkoBorodich
    from drawbar.tissue.kelvin_voigt import KelvinVoigt as KelvinVoigt
    from drawbar.tissue.prony import Prony as Prony
    from drawbar.tissue.spring_pot import SpringPot as SpringPot
    from drawbar.tissue.standard_linear_solid import StandardLinearSolid as StandardLinearSolid
    from drawbar.tissue.winkler import Winkler as Winkler
    from drawbar.wheel.base import Wheel as Wheel

# Names are fetched when they are first used, so that a command line that needs none of the physics
# starts at once.
_HOMES = {
    "Couette": "film.couette",
    "CouetteCoulomb": "film.couette_coulomb",
    "Film": "film.base",
    "FilonenkoBorodich": "tissue.filonenko_borodich",
    "Frictionless": "film.frictionless",
    "PowerLawFilm": "film.power_law_film",
    "KelvinVoigt": "tissue.kelvin_voigt",
    "Prony": "tissue.prony",
    "Sensors": "rig.sensors",
    "SpringPot": "tissue.spring_pot",
    "StandardLinearSolid": "tissue.standard_linear_solid",
    "State": "contact.wrench",
    "Stribeck": "film.stribeck",
    "Tissue": "tissue.base",
    "Wheel": "wheel.base",
    "Winkler": "tissue.winkler",
    "Wrench": "contact.wrench",
    "compare": "study.compare.compare",
    "drawbar_test": "rig.drawbar_test",
    "find": "catalogue",
    "grid": "motion.steady",
    "identify_film": "study.identify.film",
    "identify_stiffness": "study.identify.stiffness",
    "load": "rig.load",
    "plate_test": "rig.plate_test",
    "reproduce": "study.paper.reproduce",
    "save": "catalogue",
    "simulate": "motion.planar",
    "steady": "motion.steady",
    "wrench": "contact.wrench",
}

__all__ = sorted([*_HOMES, "__version__"])  # pyright: ignore[reportUnsupportedDunderAll]


def __getattr__(name: str) -> Any:
    if name not in _HOMES:
        raise AttributeError(f"module 'drawbar' has no attribute '{name}'")
    found = getattr(importlib.import_module(f"drawbar.{_HOMES[name]}"), name)
    globals()[name] = found
    return found


def __dir__() -> list[str]:
    return list(__all__)

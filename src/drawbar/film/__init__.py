"""Shear laws: what traction a film answers to a slip velocity under a pressure. One law, one file."""

from drawbar.film.base import Film
from drawbar.film.couette import Couette
from drawbar.film.couette_coulomb import CouetteCoulomb
from drawbar.film.frictionless import Frictionless
from drawbar.film.power_law_film import PowerLawFilm
from drawbar.film.stribeck import Stribeck

__all__ = ["Couette", "CouetteCoulomb", "Film", "Frictionless", "PowerLawFilm", "Stribeck"]

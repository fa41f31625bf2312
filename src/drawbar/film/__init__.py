"""Shear laws: what traction a film answers to a slip velocity under a pressure. One law, one file."""

from drawbar.film.base import Film
from drawbar.film.couette import Couette
from drawbar.film.couette_coulomb import CouetteCoulomb
from drawbar.film.frictionless import Frictionless

__all__ = ["Couette", "CouetteCoulomb", "Film", "Frictionless"]

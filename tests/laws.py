"""One plausible example of every law: what the contract tests run on. A new law adds a line here."""

from drawbar.film.couette import Couette
from drawbar.film.couette_coulomb import CouetteCoulomb
from drawbar.film.frictionless import Frictionless
from drawbar.tissue.filonenko_borodich import FilonenkoBorodich
from drawbar.tissue.winkler import Winkler
from drawbar.wheel.base import Wheel

WHEEL = Wheel(radius=0.0075, width=0.020)

TISSUES = (
    Winkler(stiffness=225e3),
    FilonenkoBorodich(stiffness=225e3, tension=0.8),
    FilonenkoBorodich(stiffness=225e3, tension=0.0),
)

FILMS = (
    Frictionless(),
    Couette(viscous_coefficient=1e4),
    CouetteCoulomb(viscous_coefficient=1e4, yield_stress=40.0),
    CouetteCoulomb(viscous_coefficient=0.0, yield_stress=10.0, friction_coefficient=0.1),
    CouetteCoulomb(viscous_coefficient=2e3, yield_stress=10.0, friction_coefficient=0.1, regularisation_speed=1e-3),
)

"""One plausible example of every law: what the contract tests run on. A new law adds a line here."""

from drawbar.film.couette import Couette
from drawbar.film.couette_coulomb import CouetteCoulomb
from drawbar.film.frictionless import Frictionless
from drawbar.film.power_law_film import PowerLawFilm
from drawbar.film.stribeck import Stribeck
from drawbar.tissue.filonenko_borodich import FilonenkoBorodich
from drawbar.tissue.kelvin_voigt import KelvinVoigt
from drawbar.tissue.prony import Prony
from drawbar.tissue.spring_pot import SpringPot
from drawbar.tissue.standard_linear_solid import StandardLinearSolid
from drawbar.tissue.winkler import Winkler
from drawbar.wheel.base import Wheel

WHEEL = Wheel(radius=0.0075, width=0.020)

ELASTIC = (
    Winkler(stiffness=225e3),
    FilonenkoBorodich(stiffness=225e3, tension=0.8),
    FilonenkoBorodich(stiffness=225e3, tension=0.0),
)

MEMORY = (
    KelvinVoigt(stiffness=225e3, viscosity=3e3),
    StandardLinearSolid(stiffness=225e3, branch_stiffness=225e3, relaxation_time=0.1),
    Prony(stiffness=225e3, branch_stiffnesses=(225e3, 1e5), relaxation_times=(0.05, 2.0)),
    SpringPot(coefficient=225e3, exponent=0.2, stiffness=5e4),
)

TISSUES = ELASTIC + MEMORY

FILMS = (
    Frictionless(),
    Couette(viscous_coefficient=1e4),
    CouetteCoulomb(viscous_coefficient=1e4, yield_stress=40.0),
    CouetteCoulomb(viscous_coefficient=0.0, yield_stress=10.0, friction_coefficient=0.1),
    CouetteCoulomb(viscous_coefficient=2e3, yield_stress=10.0, friction_coefficient=0.1, regularisation_speed=1e-3),
    Stribeck(
        boundary_friction_coefficient=0.08,
        viscosity=1e-3,
        transition_length=1e-7,
        film_thickness=1.4e-5,
        regularisation_speed=1e-4,
    ),
    PowerLawFilm(viscous_coefficient=5e3, reference_speed=0.02, flow_index=0.6, regularisation_speed=1e-4),
)

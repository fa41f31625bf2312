"""Do the films behave as lubrication says: limits, minimum, load and viscosity, thinning, printed points?"""

import importlib
import pkgutil

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from scipy.optimize import brentq, least_squares, minimize_scalar

import drawbar
from drawbar import sources
from drawbar.catalogue import find, presets
from drawbar.film.couette import Couette
from drawbar.film.couette_coulomb import CouetteCoulomb
from drawbar.film.power_law_film import PowerLawFilm
from drawbar.film.stribeck import Stribeck
from drawbar.quantity import parameters
from drawbar.sources import loring_mesothelium as loring
from drawbar.units import si
from laws import FILMS, WHEEL

LORING = loring.PRESETS[0].law
EXACT = Stribeck(boundary_friction_coefficient=0.08, viscosity=1e-3, transition_length=6e-8, film_thickness=1.6e-5)


def log_floats(low, high):
    return st.floats(np.log(low), np.log(high)).map(np.exp)


def stress(film, slip, pressure):
    return type(film).shear_stress(slip, pressure, *parameters(film))


def friction(film, slip, pressure):
    return stress(film, slip, pressure) / pressure


slips = st.one_of(st.just(0.0), log_floats(1e-12, 10.0), log_floats(1e-12, 10.0).map(lambda v: -v))
pressures = st.one_of(st.just(0.0), log_floats(1e-300, 1e6), log_floats(1e-9, 1e5).map(lambda p: -p))
stribecks = st.builds(
    Stribeck,
    boundary_friction_coefficient=st.floats(0.0, 2.0),
    viscosity=st.one_of(st.just(0.0), log_floats(1e-5, 10.0)),
    transition_length=log_floats(1e-12, 1e-2),
    film_thickness=log_floats(1e-9, 1e-2),
    regularisation_speed=st.one_of(st.just(0.0), log_floats(1e-9, 1e-2)),
)
power_laws = st.builds(
    PowerLawFilm,
    viscous_coefficient=st.floats(0.0, 1e6),
    reference_speed=log_floats(1e-6, 1.0),
    flow_index=st.floats(0.01, 1.0),
    regularisation_speed=st.one_of(st.just(0.0), log_floats(1e-9, 1e-2)),
)


# Every state ----------------------------------------------------------------------------------------


@given(st.one_of(stribecks, power_laws), slips, pressures)
def test_the_film_is_finite_odd_and_only_dissipates(film, slip, pressure):
    forward = stress(film, slip, pressure)
    assert np.isfinite(forward)
    assert forward * slip >= 0.0
    assert stress(film, -slip, pressure) == -forward
    assert stress(film, 0.0, pressure) == 0.0


@given(stribecks, slips, st.floats(-1e5, 0.0))
def test_an_unloaded_stribeck_film_is_couette(film, slip, pressure):
    viscous = stress(Couette(viscous_coefficient=film.viscosity / film.film_thickness), slip, pressure)
    assert stress(film, slip, pressure) == pytest.approx(viscous, rel=1e-15)


# Stribeck -------------------------------------------------------------------------------------------


@given(log_floats(1e-6, 1.0), st.floats(1.0, 1e4))
def test_without_boundary_friction_it_is_couette(slip, pressure):
    film = Stribeck(boundary_friction_coefficient=0.0, viscosity=1e-3, transition_length=1e-7, film_thickness=1e-5)
    assert stress(film, slip, pressure) == pytest.approx(100.0 * slip, rel=1e-15)


def test_without_viscosity_it_is_coulomb_friction():
    film = Stribeck(boundary_friction_coefficient=0.1, viscosity=0.0, transition_length=1e-7, film_thickness=1e-5)
    dry = CouetteCoulomb(viscous_coefficient=0.0, yield_stress=0.0, friction_coefficient=0.1)
    slip = np.array([-0.1, -1e-6, 0.0, 1e-3, 1.0])
    assert stress(film, slip, 300.0) == pytest.approx(stress(dry, slip, 300.0))


def test_slow_friction_does_not_depend_on_the_load_and_fast_shear_stress_does_not_either():
    loads = np.array([50.0, 500.0, 5000.0])
    slow = 1e-6 * EXACT.transition_length * loads[0] / EXACT.viscosity  # H = 1e-6 ℓ at most
    assert friction(EXACT, slow, loads) == pytest.approx(EXACT.boundary_friction_coefficient, rel=2e-6)
    # H/ℓ = 1e6 and more: what is left of the boundary term is μ_b (ℓ/H) / (H/h), about 1e-9 of the whole.
    fast = 1e6 * EXACT.transition_length * loads[-1] / EXACT.viscosity
    assert stress(EXACT, fast, loads) == pytest.approx(EXACT.viscosity / EXACT.film_thickness * fast, rel=1e-8)


@given(log_floats(1e-6, 1.0), log_floats(1.0, 1e4), log_floats(1e-3, 1e3), log_floats(1e-3, 1e3))
def test_friction_depends_on_viscosity_times_speed_over_pressure_alone(slip, pressure, more_load, more_viscosity):
    thick = Stribeck(
        boundary_friction_coefficient=EXACT.boundary_friction_coefficient,
        viscosity=EXACT.viscosity * more_viscosity,
        transition_length=EXACT.transition_length,
        film_thickness=EXACT.film_thickness,
    )
    same = friction(thick, slip * more_load / more_viscosity, pressure * more_load)
    assert same == pytest.approx(friction(EXACT, slip, pressure), rel=1e-13)


def test_friction_falls_to_its_stated_minimum_and_rises_again():
    b, length, h = EXACT.boundary_friction_coefficient, EXACT.transition_length, EXACT.film_thickness
    per_speed = EXACT.viscosity / 100.0
    lowest = minimize_scalar(lambda x: friction(EXACT, np.exp(x), 100.0), bounds=(-12, 2), options={"xatol": 1e-10})
    # A minimum is located to the square root of rounding.
    assert np.exp(lowest.x) * per_speed == pytest.approx(length * (np.sqrt(b * h / length) - 1), rel=1e-6)
    assert lowest.fun == pytest.approx(2 * np.sqrt(b * length / h) - length / h, rel=1e-12)
    slow, fast = np.geomspace(1e-6, np.exp(lowest.x), 200), np.geomspace(np.exp(lowest.x), 1.0, 200)
    assert np.all(np.diff(friction(EXACT, slow, 100.0)) < 0)
    assert np.all(np.diff(friction(EXACT, fast, 100.0)) > 0)


def test_without_a_thick_film_there_is_no_minimum():
    film = Stribeck(boundary_friction_coefficient=0.01, viscosity=1e-3, transition_length=1e-6, film_thickness=1e-5)
    assert np.all(np.diff(friction(film, np.geomspace(1e-6, 1.0, 200), 100.0)) > 0)


def test_boundary_friction_has_halved_at_the_transition_speed_which_grows_with_load():
    for pressure in (50.0, 200.0):
        speed = pressure * EXACT.transition_length / EXACT.viscosity
        viscous = EXACT.viscosity / EXACT.film_thickness * speed
        assert stress(EXACT, speed, pressure) - viscous == pytest.approx(0.04 * pressure, rel=1e-13)


# The printed points -----------------------------------------------------------------------------------


def test_the_preset_meets_the_three_printed_points_within_its_stated_misfit():
    speeds, printed = np.array(loring.POINTS).T
    found = friction(LORING, speeds, loring.ASSUMED["pressure"].value)
    assert np.max(np.abs(found - printed)) < loring.MISFIT
    assert loring.ASSUMED["pressure"].value == pytest.approx(100.0)


def test_the_fit_found_again_gives_the_stated_numbers():
    speeds, printed = np.array(loring.POINTS).T
    stated = np.array([number.value for number in loring.FITTED.values()])
    pressure, viscosity = (loring.ASSUMED[name].value for name in ("pressure", "viscosity"))

    def misfit(logarithm):
        b, length, h = np.exp(logarithm)
        numbers = (b, viscosity, length, h, loring.ASSUMED["regularisation_speed"].value)
        return Stribeck.shear_stress(speeds, pressure, *numbers) / pressure - printed

    start = np.log([0.05, 1e-8, 1e-4])
    found = least_squares(misfit, start, xtol=1e-15, ftol=1e-15, gtol=1e-15)
    assert np.max(np.abs(found.fun)) < 1e-9  # three numbers meet three points
    assert np.exp(found.x) == pytest.approx(stated, rel=1e-3)  # stated to three digits


def test_the_preset_has_its_minimum_where_its_note_says():
    lowest = minimize_scalar(lambda v: friction(LORING, v, 100.0), bounds=(1e-3, 0.1))
    assert lowest.fun == pytest.approx(0.031, abs=5e-4)
    assert lowest.x == pytest.approx(0.022, abs=5e-4)


def test_the_preset_is_found_by_name_with_the_range_of_its_data():
    assert presets("film")["mesothelium-loring"].law is find("film", "mesothelium-loring")
    assert LORING.range() == {"slip_velocity": (0.00041, 0.0614), "pressure": (50.0, 200.0)}
    assert all(limits is None for film in FILMS for limits in film.range().values())


def test_the_preset_carries_a_rolling_wheel_and_lets_it_start_from_rest():
    tissue = find("tissue", "bovine-liver-2004")
    pull = drawbar.steady(WHEEL, tissue, LORING, normal_load=0.2, speed=0.0254, speed_ratio=0.5)
    assert 0.0 < float(pull.drawbar_force) < 0.0834 * 0.2 * 1.5
    run = drawbar.simulate(
        WHEEL, tissue, LORING, normal_load=0.2, drawbar_force=0.0, wheel_torque=2e-5, duration=0.2, damper=0.5
    )
    assert float(run.wheel_speed[-1]) > 0.0


# The shear-thinning film ------------------------------------------------------------------------------


@given(slips, log_floats(1e-6, 1.0), st.sampled_from([0.0, 1e-4]))
def test_a_flow_index_of_one_is_couette_exactly(slip, reference, regularisation):
    film = PowerLawFilm(
        viscous_coefficient=1e4, reference_speed=reference, flow_index=1.0, regularisation_speed=regularisation
    )
    assert stress(film, slip, 100.0) == stress(Couette(viscous_coefficient=1e4), slip, 100.0)


@pytest.mark.parametrize("index", [0.2, 0.5, 0.8, 1.0])
def test_stress_grows_with_the_flow_index_and_far_below_the_regularisation_speed_with_one(index):
    film = PowerLawFilm(viscous_coefficient=1e4, reference_speed=0.02, flow_index=index, regularisation_speed=1e-5)

    def slope(speeds):
        return np.polyfit(np.log(speeds), np.log(stress(film, speeds, 0.0)), 1)[0]

    # (V_r/V)² = 1e-4 of curvature is left at the slow end of the first range, the fast end of the second.
    assert slope(np.geomspace(1e-3, 1.0, 50)) == pytest.approx(index, abs=1e-4)
    assert slope(np.geomspace(1e-9, 1e-7, 50)) == pytest.approx(1.0, abs=1e-4)


def test_at_the_reference_speed_the_coefficient_is_the_stated_one_whatever_the_index():
    for index in (0.1, 0.6, 1.0):
        film = PowerLawFilm(viscous_coefficient=1e4, reference_speed=0.02, flow_index=index)
        assert stress(film, 0.02, 0.0) == pytest.approx(200.0, rel=1e-15)
        speed = brentq(lambda v, film=film: stress(film, v, 0.0) - 100.0, 1e-9, 1.0, xtol=1e-300)
        assert speed == pytest.approx(0.02 * 0.5 ** (1 / index), rel=1e-12)


# Rest, ranges, refusals -------------------------------------------------------------------------------


def test_a_film_says_whether_it_is_continuous_at_rest():
    assert not EXACT.continuous_at_rest
    assert LORING.continuous_at_rest
    assert find("film", "Stribeck(boundary_friction_coefficient=0, viscosity=1 mPa s, transition_length=0.1 um, "
                        "film_thickness=10 um)").continuous_at_rest  # fmt: skip
    assert PowerLawFilm(viscous_coefficient=1e4, reference_speed=0.02, flow_index=0.3).continuous_at_rest
    with pytest.raises(ValueError, match=r"Stribeck jumps at zero slip.*regularisation_speed"):
        drawbar.simulate(
            WHEEL, drawbar.Winkler(stiffness=2e5), EXACT, normal_load=0.2, drawbar_force=0.0, wheel_torque=1e-4
        )


@pytest.mark.parametrize("film", FILMS, ids=repr)
def test_a_film_that_says_so_rises_without_a_jump(film):
    if film.continuous_at_rest:
        assert abs(stress(film, 1e-30, 500.0)) < 1e-6


@pytest.mark.parametrize(
    ("wrong", "sentence"),
    [
        ({"boundary_friction_coefficient": -0.1}, r"boundary_friction_coefficient must be >= 0, got -0.1"),
        ({"viscosity": -1.0}, r"viscosity must be >= 0 Pa s, got -1. It is viscosity of the liquid"),
        ({"transition_length": 0.0}, r"transition_length must be > 0 m, got 0"),
        ({"film_thickness": np.inf}, r"film_thickness must be > 0 m, got inf"),
        ({"slip_velocity_range": (0.06, 0.0004)}, r"slip_velocity_range must be two numbers .* in m/s .*got \(0.06"),
        ({"slip_velocity_range": 0.06}, r"slip_velocity_range must be two numbers .*leave it out if"),
        ({"pressure_range": (-50.0, 200.0)}, r"pressure_range must be two numbers .* in Pa with 0 <= low < high"),
        ({"pressure_range": ("low", "high")}, r"pressure_range must be two numbers"),
    ],
)
def test_a_wrong_stribeck_film_is_refused_in_a_sentence(wrong, sentence):
    numbers = {
        "boundary_friction_coefficient": 0.1,
        "viscosity": 1e-3,
        "transition_length": 1e-7,
        "film_thickness": 1e-5,
    }
    with pytest.raises(ValueError, match=sentence):
        Stribeck(**(numbers | wrong))


@pytest.mark.parametrize(
    ("wrong", "sentence"),
    [
        ({"viscous_coefficient": -1.0}, r"viscous_coefficient must be >= 0 Pa s/m, got -1"),
        ({"reference_speed": 0.0}, r"reference_speed must be > 0 m/s, got 0"),
        ({"flow_index": 0.0}, r"flow_index must be > 0 and <= 1, got 0.*exponent"),
        ({"flow_index": 1.2}, r"flow_index must be > 0 and <= 1, got 1.2.*Less than 1 thins"),
    ],
)
def test_a_wrong_power_law_film_is_refused_in_a_sentence(wrong, sentence):
    numbers = {"viscous_coefficient": 1e4, "reference_speed": 0.02, "flow_index": 0.5}
    with pytest.raises(ValueError, match=sentence):
        PowerLawFilm(**(numbers | wrong))


# The sources ------------------------------------------------------------------------------------------


@pytest.mark.parametrize("name", [m.name for m in pkgutil.iter_modules(sources.__path__) if m.name != "number"])
def test_every_source_has_a_citation_and_every_number_a_known_unit_and_a_place(name):
    source = importlib.import_module(f"drawbar.sources.{name}")
    assert source.CITATION
    assert getattr(source, "PRINTED", None) or source.STATEMENTS
    for table in ("PRINTED", "ASSUMED", "FITTED"):
        for key, number in getattr(source, table, {}).items():
            assert np.isfinite(number.value), key
            assert number.printed, key
            assert number.where, key
            assert si(f"1 {number.unit}", number.unit) == 1.0, key

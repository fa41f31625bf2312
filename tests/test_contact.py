"""Is the contact force right? Closed forms, limits, symmetry, energy, and what every law must obey."""

import dataclasses

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from scipy.differentiate import derivative

from drawbar.catalogue import laws
from drawbar.contact import closed_form
from drawbar.contact.bind import bind
from drawbar.contact.kernel import Forces, arc_of_nodes, contact_kernel, energy_kernel, support_of_nodes
from drawbar.contact.shear import add_shear
from drawbar.contact.wrench import State, wrench
from drawbar.film.couette import Couette
from drawbar.film.couette_coulomb import CouetteCoulomb
from drawbar.film.frictionless import Frictionless
from drawbar.quantity import parameters
from drawbar.tissue.filonenko_borodich import FilonenkoBorodich
from drawbar.tissue.winkler import Winkler
from drawbar.wheel.base import Wheel
from laws import ELASTIC, FILMS, MEMORY, TISSUES, WHEEL

ROUNDING = 1e-10  # what the closed forms are asked to be met to


def log_floats(low, high):
    return st.floats(np.log(low), np.log(high)).map(np.exp)


radii, widths = log_floats(1e-3, 0.1), log_floats(1e-3, 0.1)
stiffnesses, coefficients = log_floats(1e3, 1e7), log_floats(1.0, 1e6)
speeds = st.floats(0.001, 0.5)
speed_ratios = st.floats(0.1, 5.0)


@given(radii, widths, stiffnesses, coefficients, speeds, speed_ratios, st.floats(0.01, 1.5))
def test_shallow_contact_equals_equations_4_15_and_17(r, width, k, c, v, ratio, phi):
    state = State(sinkage=r * (1 - np.cos(phi)), vx=v, omega=v / (r * ratio))
    found = wrench(Wheel(radius=r, width=width), Winkler(stiffness=k), Couette(viscous_coefficient=c), state)
    # 1 - cos φ in the state and φ - sin 2φ/2 in equation (4) both cancel like 1e-16/φ².
    cancellation = ROUNDING + 1e-14 / phi**2
    assert found.reaction == pytest.approx(closed_form.reaction_shallow(phi, k, width, r), rel=cancellation)
    force, torque = c * width * r * v, c * width * r * r * v
    assert found.drawbar_force == pytest.approx(
        force * closed_form.drawbar_number(phi, ratio), rel=cancellation, abs=1e-12 * force * (1 + 1 / ratio)
    )
    assert found.wheel_torque == pytest.approx(
        torque * closed_form.torque_number(phi, ratio), rel=cancellation, abs=1e-12 * torque * (1 + 1 / ratio)
    )
    assert found.contact_half_angle == pytest.approx(phi, rel=cancellation)
    assert found.front_edge == pytest.approx(r * np.sin(phi), rel=cancellation, abs=1e-8 * r)


@given(radii, widths, stiffnesses, st.floats(1.0, 4.0), speeds, speed_ratios)
def test_deep_contact_equals_equation_12(r, width, k, depth, v, ratio):
    wheel, film = Wheel(radius=r, width=width), Couette(viscous_coefficient=1e4)
    found = wrench(wheel, Winkler(stiffness=k), film, State(sinkage=r * depth, vx=v, omega=v / (r * ratio)))
    assert found.reaction == pytest.approx(closed_form.reaction_deep(r * depth, k, width, r), rel=ROUNDING)
    force = 1e4 * width * r * v
    assert found.drawbar_force == pytest.approx(
        force * closed_form.drawbar_number(np.pi / 2, ratio), rel=ROUNDING, abs=1e-12 * force * (1 + 1 / ratio)
    )


@given(radii, widths, stiffnesses, log_floats(0.02, 5.0), st.floats(0.02, 1.5))
def test_tension_equals_its_closed_form(r, width, k, ratio, phi):
    length = ratio * r
    tissue = FilonenkoBorodich(stiffness=k, tension=k * length**2)
    sinkage = r * (1 - np.cos(phi)) + length * np.tan(phi)
    found = wrench(Wheel(radius=r, width=width), tissue, Frictionless(), State(sinkage=sinkage))
    assert found.reaction == pytest.approx(closed_form.reaction_tension(phi, k, width, r, length), rel=ROUNDING)
    assert found.contact_half_angle == pytest.approx(phi, rel=ROUNDING)


def test_golden_numbers():
    assert closed_form.reaction_shallow(0.75, 1, 1, 1) == pytest.approx(0.251253, abs=5e-7)
    assert closed_form.drawbar_number(0.75, np.array([0.5, 1.0, 1.5])) == pytest.approx(
        [1.477808, 0.114530, -0.339896], abs=5e-7
    )
    assert closed_form.torque_number(0.75, np.array([0.5, 1.0, 1.5])) == pytest.approx(
        [1.636722, 0.136722, -0.363278], abs=5e-7
    )
    assert closed_form.zero_drawbar_speed_ratio(0.75) == pytest.approx(1.09172, abs=5e-6)
    assert closed_form.reaction_tension(0.75, 1, 1, 1, 0.25) == pytest.approx(0.685208, abs=5e-7)


@pytest.mark.parametrize("tissue", [Winkler(stiffness=2e5), FilonenkoBorodich(stiffness=2e5, tension=1.0)])
@pytest.mark.parametrize("sinkage", [1e-5, 1e-3, 5e-3, 7.5e-3, 12e-3])
def test_the_sum_over_nodes_equals_the_laws_own_integral(tissue, sinkage):
    law, numbers, r = type(tissue), parameters(tissue), 0.0075
    half = law.half_angle(sinkage, r, *numbers)
    by_nodes = bind(support_of_nodes, pressure=law.pressure)(sinkage, -half, half, r, numbers)
    # 1/cos²φ of the tension term near a vertical edge is the only integrand that ten nodes miss.
    rel = 1e-12 if law is Winkler else (1e-10 if np.cos(half) > 0.5 else 1e-5)
    assert by_nodes[0] == pytest.approx(law.support(sinkage, half, r, *numbers), rel=rel)
    assert by_nodes[1] == pytest.approx(0.0, abs=1e-12 * abs(by_nodes[0]))


@given(st.floats(1e-5, 0.012), st.floats(-0.1, 0.1), st.floats(-0.05, 0.05), st.floats(-20.0, 20.0))
def test_the_films_sum_over_nodes_equals_its_own_integral(sinkage, vx, vy, omega):
    r, numbers = 0.0075, (1e4,)
    half = Winkler.half_angle(sinkage, r, 1.0)
    node = bind(add_shear, shear_stress=Couette.shear_stress)
    nodes = bind(arc_of_nodes, pressure=Winkler.pressure, add_shear=node)
    by_nodes = nodes(sinkage, -half, half, vx, vy, omega, r, (1.0,), numbers)
    exact = Couette.arc(-half, half, vx, vy, omega, r, *numbers)
    scale = 1e4 * r * half * (abs(vx) + abs(vy) + r * abs(omega) + 1e-9)
    assert np.allclose(by_nodes, exact, rtol=1e-11, atol=1e-12 * scale)


@given(st.floats(1e-5, 0.0075), st.floats(0.001, 0.1), st.floats(0.0, 300.0), st.floats(0.0, 1.0))
def test_a_locked_wheel_with_dry_friction_drags_as_by_hand(sinkage, v, yield_stress, friction):
    """F = -(2 τ₀ L r sin φ + μ_c N), whatever the speed: slip has one sign along the arc."""
    film = CouetteCoulomb(viscous_coefficient=0.0, yield_stress=yield_stress, friction_coefficient=friction)
    found = wrench(WHEEL, Winkler(stiffness=2e5), film, State(sinkage=sinkage, vx=v))
    by_hand = 2 * yield_stress * WHEEL.width * found.front_edge + friction * found.reaction
    assert found.drawbar_force == pytest.approx(-by_hand, rel=ROUNDING, abs=1e-15)


def test_dry_friction_saturates_between_its_bounds_where_slip_changes_sign():
    """Slow driving: front and rear slip backward, the bottom forward; the exact split of the arc counts."""
    film, v, r = CouetteCoulomb(viscous_coefficient=0.0, yield_stress=50.0), 0.02, WHEEL.radius
    turn = 0.4
    state = State(sinkage=0.004, vx=v, omega=v * np.cos(turn) / r)
    found = wrench(WHEEL, Winkler(stiffness=2e5), film, state)
    phi = found.contact_half_angle
    by_hand = 50.0 * WHEEL.width * r * 2 * (np.sin(phi) - 2 * np.sin(turn))
    assert found.drawbar_force == pytest.approx(by_hand, rel=ROUNDING)


def test_vanishing_tension_is_winkler_at_first_order_in_the_decay_length():
    """dN/dℓ at fixed sinkage is that of the flank, so the error falls in proportion to ℓ."""
    base = wrench(WHEEL, Winkler(stiffness=2e5), Frictionless(), State(sinkage=0.003)).reaction
    errors = []
    for length in (1e-5, 1e-6):
        tissue = FilonenkoBorodich(stiffness=2e5, tension=2e5 * length**2)
        errors.append(wrench(WHEEL, tissue, Frictionless(), State(sinkage=0.003)).reaction - base)
    assert errors[0] > errors[1] > 0
    # the edge w(a) = ℓ tan φ shrinks the contact by O(ℓ) and adds 2aℓ tan φ: first order cancels to ℓ²
    assert np.log10(errors[0] / errors[1]) == pytest.approx(2.0, abs=0.05)
    exact = wrench(WHEEL, FilonenkoBorodich(stiffness=2e5, tension=0.0), Frictionless(), State(sinkage=0.010))
    deep = wrench(WHEEL, Winkler(stiffness=2e5), Frictionless(), State(sinkage=0.010))
    assert exact.reaction == pytest.approx(deep.reaction, rel=ROUNDING)


# What every law must obey ---------------------------------------------------------------------------


def test_every_law_has_an_example_here():
    assert {type(t).__name__ for t in TISSUES} == set(laws("tissue"))
    assert {type(f).__name__ for f in FILMS} == set(laws("film"))


def by_name(law):
    return repr(law)


every_pair = [
    pytest.mark.parametrize("tissue", TISSUES, ids=by_name),
    pytest.mark.parametrize("film", FILMS, ids=by_name),
]


def for_every_pair(test):
    for mark in every_pair:
        test = mark(test)
    return test


STATES = State(
    sinkage=np.array([[-1e-3], [0.0], [1e-9], [2e-3], [7.5e-3], [7.6e-3], [0.02]]),
    vx=np.array([0.0254, 0.0254, 0.0254, 0.0, 0.0, -0.02, 1e-12]),
    omega=np.array([6.0, 3.0, 0.0, 0.0, 4.0, -1.0, 1e-9]),
)


@for_every_pair
def test_nothing_is_felt_out_of_contact_and_everything_is_finite(tissue, film):
    state = STATES if tissue.deep else dataclasses.replace(STATES, sinkage=np.minimum(STATES.sinkage, 0.007))
    found = wrench(WHEEL, tissue, film, state)
    for name, number in vars(found).items():
        assert np.all(np.isfinite(number)), name
        assert np.all(np.broadcast_to(number, (7, 7))[:2] == 0.0), name


@for_every_pair
def test_power_is_accounted_for_and_film_and_tissue_only_dissipate(tissue, film):
    state = STATES if tissue.deep else dataclasses.replace(STATES, sinkage=np.minimum(STATES.sinkage, 0.007))
    found = wrench(WHEEL, tissue, film, state)
    motor, drawbar = found.wheel_torque * state.omega, found.drawbar_force * state.vx
    loss = found.film_loss + found.tissue_loss
    scale = np.abs(motor) + np.abs(drawbar) + loss + 1e-12 * np.max(loss)
    # The tissue's loss is its own dissipation, summed apart from the resistance.
    assert np.all(np.abs(motor - drawbar - loss) <= (1e-12 if tissue in ELASTIC else 1e-6) * scale)
    assert np.all(found.film_loss >= 0.0)
    assert np.all(found.tissue_loss >= 0.0)
    if tissue in ELASTIC:  # gives all of it back
        assert np.all(found.rolling_resistance == 0.0)


@for_every_pair
def test_mirrored_motion_mirrors_the_wrench(tissue, film):
    state = State(sinkage=0.003, vx=0.02, vy=0.003, omega=4.0)
    mirror = State(sinkage=0.003, vx=-0.02, vy=-0.003, omega=-4.0)
    here, there = wrench(WHEEL, tissue, film, state), wrench(WHEEL, tissue, film, mirror)
    for name in ("drawbar_force", "side_force", "wheel_torque"):
        assert getattr(there, name) == pytest.approx(-getattr(here, name), rel=1e-13)
    assert there.reaction == pytest.approx(here.reaction, rel=1e-13)
    assert here.side_force * state.vy <= 0.0


@for_every_pair
def test_broadcasting_equals_looping_and_the_compiled_kernel_equals_the_plain_one(tissue, film):
    plain = contact_kernel(type(tissue), type(film))
    compiled = contact_kernel(type(tissue), type(film), compiled=True)
    numbers = (WHEEL.radius, WHEEL.width, parameters(tissue), parameters(film))
    together = Forces(*plain(STATES.sinkage, STATES.vx, 0.0, STATES.omega, *numbers))
    scale = np.array([np.max(np.abs(f)) for f in together]) + 1e-300
    for i, j in np.ndindex(7, 7):
        state = (float(STATES.sinkage[i, 0]), float(STATES.vx[j]), 0.0, float(STATES.omega[j]))
        one = np.array(plain(*state, *numbers))
        cell = np.array([np.broadcast_to(f, (7, 7))[i, j] for f in together])
        assert np.all(np.abs(one - cell) <= 1e-14 * scale)
        assert np.all(np.abs(np.array(compiled(*state, *numbers)) - one) <= 1e-13 * scale)


def test_every_pair_of_laws_is_cached_under_its_own_name():
    """Two laws with equally many numbers compile to the same signature: only the name tells them apart."""
    pairs = {(type(t), type(f)) for t in TISSUES for f in FILMS}
    for by_way_of in (True, False):  # bound compiled from the start, or plain first
        names = set()
        for tissue, film in pairs:
            kernel = contact_kernel(tissue, film, compiled=by_way_of)
            names.add(
                kernel.py_func.__name__
                if by_way_of
                else bind(uses_contact, compiled=True, contact=kernel).py_func.__name__
            )
        assert len(names) == len(pairs)


def uses_contact(*state):
    return contact(*state)  # noqa: F821


@pytest.mark.parametrize("tissue", MEMORY, ids=by_name)
def test_a_tissue_with_memory_resists_rolling_leans_forward_and_refuses_what_it_cannot(tissue):
    found = wrench(WHEEL, tissue, Frictionless(), State(sinkage=0.003, vx=0.0254))
    assert found.rolling_resistance > 0.0
    assert found.drawbar_force == -found.rolling_resistance
    assert 0.0 < -found.rear_edge < found.front_edge
    back = wrench(WHEEL, tissue, Frictionless(), State(sinkage=0.003, vx=-0.0254))
    assert back.drawbar_force == found.rolling_resistance
    assert (back.front_edge, back.rear_edge) == (-found.rear_edge, -found.front_edge)
    if not tissue.deep:
        with pytest.raises(ValueError, match=r"no finite answer to the sudden indentation.*Give less"):
            wrench(WHEEL, tissue, Frictionless(), State(sinkage=0.008, vx=0.0254))


@pytest.mark.parametrize("tissue", ELASTIC, ids=by_name)
@pytest.mark.parametrize("sinkage", [1e-4, 2e-3, 7.4e-3, 9e-3])
def test_the_reaction_is_the_derivative_of_the_stored_energy(tissue, sinkage):
    energy, numbers = energy_kernel(type(tissue)), parameters(tissue)
    slope = derivative(lambda d: energy(d, 0.0075, 0.02, numbers), sinkage, initial_step=sinkage / 20)
    reaction = wrench(WHEEL, tissue, Frictionless(), State(sinkage=sinkage)).reaction
    assert reaction == pytest.approx(float(slope.df), rel=1e-7)  # the difference formula's own reach


@pytest.mark.parametrize("tissue", ELASTIC, ids=by_name)
def test_the_force_is_continuous_from_touch_down_to_deep_contact(tissue):
    depth = np.concatenate([np.linspace(-1e-4, 1e-4, 2001), np.linspace(7.4e-3, 7.6e-3, 2001)])
    found = wrench(WHEEL, tissue, FILMS[1], State(sinkage=depth, vx=0.02, omega=4.0))
    for name in ("reaction", "wheel_torque"):
        number = getattr(found, name)
        assert np.max(np.abs(np.diff(number)[np.diff(depth) < 1e-6])) < 0.05 * np.max(np.abs(number))


@given(st.floats(-1.0, 1.0), st.floats(0.0, 1e5))
@settings(max_examples=50)
def test_every_film_opposes_slip_and_is_odd(slip, pressure):
    for film in FILMS:
        forward = type(film).shear_stress(slip, pressure, *parameters(film))
        backward = type(film).shear_stress(-slip, pressure, *parameters(film))
        assert forward * slip >= 0.0
        assert backward == -forward


def test_an_elastic_tissue_takes_no_ground():
    with pytest.raises(ValueError, match=r"ground must be None.*remembers nothing.*Leave it out"):
        wrench(WHEEL, TISSUES[0], FILMS[0], State(sinkage=0.001), ground=object())  # type: ignore[arg-type]

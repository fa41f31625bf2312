"""Does steady rolling carry the load, meet the closed forms, and broadcast as promised?"""

import numpy as np
import pytest
import xarray as xr
from hypothesis import given
from hypothesis import strategies as st

import drawbar
from drawbar.contact import closed_form
from drawbar.motion.flags import explain
from drawbar.tissue.winkler import kepler_half_angle, segment
from laws import ELASTIC, FILMS, MEMORY, WHEEL

FOAM, COUETTE = ELASTIC[0], FILMS[1]


@given(st.floats(1e-9, np.pi / 2))
def test_keplers_equation_is_inverted_to_rounding(phi):
    assert kepler_half_angle(segment(phi)) == pytest.approx(phi, rel=2e-14)


@pytest.mark.parametrize("tissue", ELASTIC, ids=repr)
@given(load=st.floats(-9, 4).map(lambda e: 10.0**e))
def test_the_sinkage_carries_the_load(tissue, load):
    result = drawbar.steady(WHEEL, tissue, FILMS[0], normal_load=load, speed=0.0, wheel_speed=0.0)
    state = drawbar.State(sinkage=float(result.sinkage))
    # Under tension and a huge load the edge is nearly vertical, where its slope loses digits.
    assert drawbar.wrench(WHEEL, tissue, FILMS[0], state).reaction == pytest.approx(load, rel=1e-9)


def test_a_law_without_an_inverse_is_solved_for():
    class Hardening(drawbar.Winkler):
        sinkage_under = None
        support = None

    try:
        found = drawbar.steady(
            WHEEL, Hardening(stiffness=225e3), COUETTE, normal_load=[0.1, 2.0], speed=0.02, speed_ratio=1.0
        )
    finally:
        del drawbar.Tissue.registry["Hardening"]
    known = drawbar.steady(WHEEL, FOAM, COUETTE, normal_load=[0.1, 2.0], speed=0.02, speed_ratio=1.0)
    assert found.sinkage.values == pytest.approx(known.sinkage.values, rel=1e-9)
    assert found.drawbar_force.values == pytest.approx(known.drawbar_force.values, rel=1e-9)


@given(st.floats(0.01, 5.0), st.floats(0.1, 3.0))
def test_drawbar_and_torque_follow_equations_15_and_17(load, ratio):
    result = drawbar.steady(WHEEL, FOAM, COUETTE, normal_load=load, speed=0.0254, speed_ratio=ratio)
    phi = float(result.contact_half_angle)
    force = 1e4 * WHEEL.width * WHEEL.radius * 0.0254
    assert float(result.drawbar_force) == pytest.approx(
        force * closed_form.drawbar_number(phi, ratio), rel=1e-10, abs=1e-12
    )
    torque = force * WHEEL.radius * closed_form.torque_number(phi, ratio)
    assert float(result.wheel_torque) == pytest.approx(torque, rel=1e-10, abs=1e-14)
    assert float(result.slip) == pytest.approx(1 - ratio)


def test_a_viscous_film_does_not_pull_at_its_own_speed_ratio_which_is_above_one():
    phi = float(drawbar.steady(WHEEL, FOAM, COUETTE, normal_load=0.1, speed=0.02, speed_ratio=1.0).contact_half_angle)
    ratio = closed_form.zero_drawbar_speed_ratio(phi)
    assert ratio > 1.05
    result = drawbar.steady(WHEEL, FOAM, COUETTE, normal_load=0.1, speed=0.02, speed_ratio=ratio)
    assert float(result.drawbar_force) == pytest.approx(0.0, abs=1e-15)


@pytest.mark.parametrize("film", FILMS[1:], ids=repr)
@pytest.mark.parametrize("torque", [0.0, 2e-5, -2e-5])
def test_an_imposed_torque_is_what_the_motor_gives(film, torque):
    result = drawbar.steady(WHEEL, FOAM, film, normal_load=[0.1, 0.4], speed=0.0254, wheel_torque=torque)
    loads, omega = result.normal_load, result.wheel_speed
    again = drawbar.steady(WHEEL, FOAM, film, normal_load=loads, speed=0.0254, wheel_speed=omega)
    assert again.wheel_torque.values == pytest.approx(torque, abs=1e-12)


def test_a_torque_that_dry_friction_cannot_bear_is_refused():
    with pytest.raises(RuntimeError, match=r"no wheel speed was found for 1 of 2.*beyond what the film.*Give less"):
        drawbar.steady(WHEEL, FOAM, FILMS[3], normal_load=[0.1, 40.0], speed=0.02, wheel_torque=1e-3)


def test_numbers_give_0d_results_with_units():
    result = drawbar.steady(WHEEL, FOAM, COUETTE, normal_load=0.2, speed=0.02, speed_ratio=0.5)
    assert all(v.dims == () for v in result.data_vars.values())
    assert all("units" in v.attrs for v in result.variables.values())
    assert result.drawbar_force.attrs["units"] == "N"


def test_a_map_equals_its_points():
    ratios, loads = [0.5, 1.0, 1.5], [0.1, 0.2, 0.3, 0.4]
    axes = drawbar.grid(normal_load=loads, speed_ratio=ratios)
    table = drawbar.steady(WHEEL, FOAM, FILMS[3], speed=0.0254, **axes)
    assert dict(table.sizes) == {"normal_load": 4, "speed_ratio": 3}
    for load in loads:
        for ratio in ratios:
            one = drawbar.steady(WHEEL, FOAM, FILMS[3], speed=0.0254, normal_load=load, speed_ratio=ratio)
            cell = table.sel(normal_load=load, speed_ratio=ratio)
            xr.testing.assert_allclose(one.drop_vars(["speed_ratio"]), cell.drop_vars(["speed_ratio"]), rtol=1e-12)


def test_plain_arrays_broadcast_as_in_numpy_and_law_parameters_may_vary():
    loads, stiffness = np.array([0.1, 0.2, 0.3]), np.array([1e5, 2e5, 4e5])
    pairs = drawbar.steady(
        WHEEL, drawbar.Winkler(stiffness=stiffness), COUETTE, normal_load=loads, speed=0.02, speed_ratio=0.5
    )
    assert dict(pairs.sizes) == {"point": 3}
    assert pairs.stiffness.attrs["units"] == "Pa/m"
    table = drawbar.steady(
        WHEEL, drawbar.Winkler(stiffness=stiffness), COUETTE, normal_load=loads[:, None], speed=0.02, speed_ratio=0.5
    )
    assert table.drawbar_force.dims == ("normal_load", "stiffness")
    assert np.diag(table.drawbar_force) == pytest.approx(pairs.drawbar_force.values, rel=1e-14)


def test_blocks_do_not_show(monkeypatch):
    loads = np.linspace(0.01, 1.0, 100)
    whole = drawbar.steady(WHEEL, FOAM, FILMS[3], normal_load=loads, speed=0.02, speed_ratio=0.9)
    monkeypatch.setattr("drawbar.motion.steady.BLOCK", 7)
    xr.testing.assert_identical(
        whole, drawbar.steady(WHEEL, FOAM, FILMS[3], normal_load=loads, speed=0.02, speed_ratio=0.9)
    )


@pytest.mark.parametrize(
    ("wrong", "sentence"),
    [
        ({"normal_load": -0.1}, r"normal_load must be >= 0 N, got -0.1"),
        ({"normal_load": np.nan}, r"normal_load must be >= 0 N, got nan"),
        ({"normal_load": "0.2"}, r"normal_load must be .* got '0.2'.*Give a number in N"),
        ({"speed_ratio": 0.0}, r"speed_ratio must not be 0.*give speed=0 and wheel_speed"),
        (
            {"wheel_speed": 1.0},
            r"give exactly one of speed_ratio, wheel_speed, wheel_torque; got speed_ratio, wheel_speed",
        ),
        ({"speed_ratio": None}, r"exactly one .* got none"),
        ({"normal_load": [0.1, 0.2], "speed": [0.1, 0.2, 0.3]}, r"arrays do not broadcast.*drawbar.grid"),
    ],
)
def test_wrong_input_is_told_what_is_allowed(wrong, sentence):
    right = {"normal_load": 0.2, "speed": 0.02, "speed_ratio": 0.5}
    with pytest.raises((ValueError, TypeError), match=sentence):
        drawbar.steady(WHEEL, FOAM, COUETTE, **(right | wrong))


def test_flags_are_raised_where_they_should_be_and_say_so_in_words():
    """Loads around those at which the axle goes under, k L π r²/2, and the wheel drowns, k L (π/2 + 2) r²."""
    unit = 225e3 * WHEEL.width * WHEEL.radius**2
    loads = unit * np.array([0.9 * np.pi / 2, 1.1 * np.pi / 2, 0.9 * (np.pi / 2 + 2), 1.1 * (np.pi / 2 + 2)])
    result = drawbar.steady(WHEEL, FOAM, COUETTE, normal_load=loads, speed=0.02, speed_ratio=0.5)
    assert result.flags.values.tolist() == [0, 1, 1, 3]
    told = explain(result)
    assert "the axle is below the surface" in told[0]
    assert "(in 3 of 4)" in told[0]
    measured = drawbar.Stribeck(
        boundary_friction_coefficient=0.08, viscosity=1e-3, transition_length=1e-7, film_thickness=1e-5,
        slip_velocity_range=(0.001, 0.015), pressure_range=(50.0, 1e3),
    )  # fmt: skip
    result = drawbar.steady(WHEEL, FOAM, measured, normal_load=[0.02, 0.3], speed=0.02, speed_ratio=[0.9, 0.5])
    names = result.flags.attrs["flag_meanings"].split()
    raised = [{n for i, n in enumerate(names) if flags & 2**i} for flags in result.flags.values.tolist()]
    assert raised == [set(), {"film_speed_out_of_range", "film_pressure_out_of_range"}]


@pytest.mark.parametrize("tissue", MEMORY, ids=repr)
def test_steady_rolling_on_a_tissue_with_memory_balances_its_powers(tissue):
    result = drawbar.steady(
        WHEEL, tissue, FILMS[2], speed=0.0254, **drawbar.grid(normal_load=[0.05, 0.1], speed_ratio=[0.5, 1.0, 1.5])
    )
    left = result.motor_power - result.drawbar_power - result.film_loss - result.tissue_loss
    assert float(abs(left / (result.film_loss + result.tissue_loss)).max()) < 1e-6
    assert np.all(result.rolling_resistance > 0)
    assert np.all(-result.rear_edge < result.front_edge)
    state = drawbar.State(sinkage=float(result.sinkage[0, 0]), vx=0.0254, omega=float(result.wheel_speed[0, 0]))
    assert drawbar.wrench(WHEEL, tissue, FILMS[2], state).reaction == pytest.approx(0.05, rel=1e-8)
    free = drawbar.steady(WHEEL, tissue, FILMS[1], normal_load=0.1, speed=0.0254, wheel_torque=0.0)
    assert float(free.wheel_torque) == pytest.approx(0.0, abs=1e-12)
    assert float(free.drawbar_force) < -float(free.rolling_resistance)


def test_a_law_without_an_instant_answer_refuses_deep_contact():
    with pytest.raises(ValueError, match=r"KelvinVoigt has no finite answer.*Give less load, a wider wheel"):
        drawbar.steady(WHEEL, MEMORY[0], COUETTE, normal_load=2.0, speed=0.0254, speed_ratio=1.0)


def test_two_laws_may_call_a_quantity_by_one_name():
    """A tissue's viscosity and a film's are different things."""
    tissue = drawbar.KelvinVoigt(stiffness=225e3, viscosity=3e3)
    film = drawbar.Stribeck(
        boundary_friction_coefficient=0.1, viscosity=1e-3, transition_length=1e-7, film_thickness=1e-5
    )
    result = drawbar.steady(WHEEL, tissue, film, normal_load=0.1, speed=0.0254, speed_ratio=0.5)
    state = drawbar.State(sinkage=float(result.sinkage), vx=0.0254, omega=float(result.wheel_speed))
    known = drawbar.wrench(WHEEL, tissue, film, state)
    assert known.reaction == pytest.approx(0.1, rel=1e-8)
    assert float(result.drawbar_force) == pytest.approx(float(known.drawbar_force), rel=1e-9)
    several = drawbar.KelvinVoigt(stiffness=225e3, viscosity=np.array([1e3, 3e3]))
    table = drawbar.steady(WHEEL, several, film, normal_load=0.1, speed=0.0254, speed_ratio=0.5)
    assert table.drawbar_force.dims == ("tissue_viscosity",)
    assert float(table.drawbar_force[1]) == pytest.approx(float(result.drawbar_force), rel=1e-9)
    assert table.tissue_viscosity.attrs["units"] == "Pa s/m"

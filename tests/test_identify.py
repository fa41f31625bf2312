"""Does the identification find what was put in, within its own interval, and say when it cannot?"""

import json
import re

import numpy as np
import pytest
import xarray as xr

import drawbar
from drawbar.study.identify.coverage import PARAMETERS, coverage
from drawbar.study.identify.reduce import reduce_histories
from laws import WHEEL

LIVER = drawbar.Winkler(stiffness=415e3)
FILM = drawbar.CouetteCoulomb(viscous_coefficient=1e4, yield_stress=40.0)
FRICTION = drawbar.CouetteCoulomb(viscous_coefficient=1e4, yield_stress=0.0, friction_coefficient=0.1)
BOTH = drawbar.CouetteCoulomb(viscous_coefficient=1e4, yield_stress=40.0, friction_coefficient=0.1)
DIAL = drawbar.Sensors(deflection_noise=3e-5)
CELL = drawbar.Sensors(force_bias=1e-3)  # a zero error of each run: the same scatter at every speed
MASSES = tuple(np.linspace(0.02, 0.2, 10))
LOADS, SPEEDS = (0.14, 0.27, 0.41), (0.005, 0.01, 0.015, 0.02, 0.025)


def plates(tissue=LIVER, *, masses=MASSES, sets=3, sensors=DIAL, seed=1, **settings):
    return drawbar.plate_test(
        tissue, applied_mass=masses, plate_area=2.5e-3, sets=sets, sensors=sensors, seed=seed, **settings
    )


def drags(film=FILM, *, loads=LOADS, speeds=SPEEDS, ways=(1, -1), sensors=CELL, seed=3, wheel_speed=0.0, repeats=3):
    speed = np.multiply.outer(ways, speeds).ravel()
    return drawbar.drawbar_test(
        WHEEL, LIVER, film, normal_load=loads, speed=speed, wheel_speed=wheel_speed, repeats=repeats,
        sensors=sensors, seed=seed,
    )  # fmt: skip


def changed(log, **columns):
    return log.assign({name: (log[name].dims, values) for name, values in columns.items()})


def holds(fit, **truth):
    return all(fit.intervals[name][0] <= number <= fit.intervals[name][1] for name, number in truth.items())


# What was put in is found ---------------------------------------------------------------------------


@pytest.mark.parametrize("sensors", [DIAL, drawbar.Sensors()], ids=["noisy", "perfect"])
def test_a_stiffness_is_found_within_its_interval(sensors):
    fit = drawbar.identify_stiffness(plates(sensors=sensors))
    assert holds(fit, stiffness=415e3)
    assert fit.law == drawbar.Winkler(stiffness=fit.values["stiffness"])
    assert fit.warnings == ()


@pytest.mark.parametrize(
    ("film", "terms"),
    [
        (FILM, ["yield_stress"]),
        (FRICTION, ["friction_coefficient"]),
        (BOTH, ["yield_stress", "friction_coefficient"]),
    ],
)
@pytest.mark.parametrize("sensors", [CELL, drawbar.Sensors()], ids=["noisy", "perfect"])
def test_a_film_is_found_within_its_intervals_with_the_coulomb_term_that_it_has(film, terms, sensors):
    fit = drawbar.identify_film(drags(film, sensors=sensors))
    assert list(fit.values) == ["viscous_coefficient", *terms]
    assert holds(fit, **{name: getattr(film, name) for name in fit.values})
    assert fit.warnings == ()
    assert any("the loads support" in note for note in fit.notes)


def test_a_wheel_pressed_in_gives_the_same_stiffness_as_a_plate_shallow_and_deep():
    log = drags(loads=(0.02, 0.1, 0.5, 2.0, 5.0), sensors=drawbar.Sensors())
    assert float(log.sinkage.max()) > WHEEL.radius
    assert drawbar.identify_stiffness(log).values["stiffness"] == pytest.approx(415e3, rel=1e-9)
    assert holds(drawbar.identify_stiffness(drags(sensors=drawbar.Sensors(angle_bias=1e-3))), stiffness=415e3)


def test_intervals_hold_the_truth_as_often_as_they_promise(tmp_path):
    result = coverage(tmp_path, count=40)
    # 33 or fewer of 40 happens once in 10 000 series if each interval holds in 95 % of cases.
    assert all(result[name]["covered"] >= 34 for name in PARAMETERS)
    assert result["warned"]["stiffness"] <= 3


def test_a_study_that_was_stopped_goes_on_where_it_was(tmp_path):
    whole = coverage(tmp_path / "whole", count=3)
    coverage(tmp_path / "stopped", count=2)
    log = tmp_path / "stopped" / "campaigns.jsonl"
    log.write_text(log.read_text()[:-40])
    seen = []
    assert coverage(tmp_path / "stopped", count=3, progress=lambda *done: seen.append(done)) == whole
    assert seen == [(1, 3), (2, 3), (3, 3)]
    assert json.loads((tmp_path / "stopped" / "coverage.json").read_text()) == whole


# Against an independent route, and by symmetry ------------------------------------------------------


def test_one_set_is_the_line_through_the_origin_of_an_independent_route():
    log = plates(sets=1)
    pressure = log.applied_mass.values * 9.80665 / 2.5e-3
    compliance, rest, *_ = np.linalg.lstsq(pressure[:, None], log.deflection.values, rcond=None)
    error = np.sqrt(rest[0] / (pressure.size - 1) / (pressure @ pressure))
    fit = drawbar.identify_stiffness(log)
    assert fit.values["stiffness"] == pytest.approx(1 / compliance[0], rel=1e-9)
    assert fit.standard_errors["stiffness"] == pytest.approx(error / compliance[0] ** 2, rel=1e-6)


def test_a_film_is_the_least_squares_of_an_independent_route():
    log = drags()
    v, phi = log.slide_speed.values, log.contact_half_angle.values
    area = WHEEL.width * WHEEL.radius
    design = np.stack(
        [-area * v * (phi + np.sin(phi) * np.cos(phi)), -2 * area * np.sin(phi) * np.sign(v), np.ones(v.size)], axis=1
    )
    values, rest, *_ = np.linalg.lstsq(design, log.drawbar_force.values, rcond=None)
    errors = np.sqrt(np.diag(np.linalg.inv(design.T @ design)) * rest[0] / (v.size - 3))
    fit = drawbar.identify_film(log, coulomb="yield_stress")
    assert not any("scatters more" in note for note in fit.notes)
    assert list(fit.values.values()) == pytest.approx(values[:2], rel=1e-9)
    assert list(fit.standard_errors.values()) == pytest.approx(errors[:2], rel=1e-6)
    assert fit.nuisances["force_offset"].value == pytest.approx(values[2], rel=1e-6)


def test_sets_count_as_places_not_as_readings():
    fit = drawbar.identify_stiffness(plates(spread=0.1))
    compliances = np.array([1 / each.value for each in fit.by_set.values()])
    assert fit.values["stiffness"] == pytest.approx(1 / compliances.mean())
    error = compliances.std(ddof=1) / np.sqrt(3) / compliances.mean() ** 2
    assert fit.standard_errors["stiffness"] == pytest.approx(error)
    assert any("the sets differ" in note for note in fit.notes)
    assert holds(fit, stiffness=415e3)


def test_logs_put_together_are_sets_of_one():
    whole = plates(sets=2)
    parts = [whole.isel(observation=whole.trial.values == trial) for trial in (1, 2)]
    assert drawbar.identify_stiffness(parts).intervals == drawbar.identify_stiffness(whole).intervals


def test_stiffness_and_friction_scale_with_the_loads_and_forces():
    log, twice = plates(), plates()
    twice["applied_mass"] = 2 * log.applied_mass
    assert drawbar.identify_stiffness(twice).values["stiffness"] == pytest.approx(
        2 * drawbar.identify_stiffness(log).values["stiffness"]
    )
    log = drags()
    one = drawbar.identify_film(log)
    two = drawbar.identify_film(changed(log, drawbar_force=2 * log.drawbar_force.values))
    assert two.values == pytest.approx({name: 2 * number for name, number in one.values.items()})


def test_a_rig_turned_round_finds_the_same_film_and_the_opposite_zero_error():
    log = drags()
    one = drawbar.identify_film(log)
    other = drawbar.identify_film(
        changed(log, drawbar_force=-log.drawbar_force.values, slide_speed=-log.slide_speed.values)
    )
    assert other.values == pytest.approx(one.values)
    assert other.nuisances["force_offset"].value == pytest.approx(-one.nuisances["force_offset"].value)


def test_standard_errors_allow_for_scatter_that_grows_with_speed():
    fit = drawbar.identify_film(drags(sensors=drawbar.Sensors(force_noise=5e-3)))
    assert any("scatters more" in note for note in fit.notes)
    assert holds(fit, viscous_coefficient=1e4, yield_stress=40.0)


# What the fit says against itself -------------------------------------------------------------------


def _bent(log):
    return changed(log, deflection=log.deflection.values * (1 - 150 * log.deflection.values))


WARNINGS = {
    "it stiffens under load": lambda: drawbar.identify_stiffness(_bent(plates())),
    "do not start at zero": lambda: drawbar.identify_stiffness(
        changed(plates(), deflection=plates().deflection.values + 1e-4)
    ),
    "deflection in row 8 is far": lambda: drawbar.identify_stiffness(
        changed(plates(), deflection=plates().deflection.values + 3e-4 * (np.arange(30) == 7))
    ),
    "stiffness is not determined .* without upper limit": lambda: drawbar.identify_stiffness(
        plates(sensors=drawbar.Sensors(deflection_noise=5e-3), sets=1)
    ),
    r"force of run 11 \(0.27 N, 0.005 m/s\) is far": lambda: drawbar.identify_film(
        changed(drags(), drawbar_force=drags().drawbar_force.values + 0.02 * (np.arange(90) == 10))
    ),
    "bends with slide_speed": lambda: drawbar.identify_film(
        changed(drags(), drawbar_force=drags().drawbar_force.values * (1 - 8 * abs(drags().slide_speed.values)))
    ),
    "depends on normal_load": lambda: drawbar.identify_film(
        drags(FRICTION), "yield_stress"
    ),
    "differs between forward and reverse": lambda: drawbar.identify_film(
        changed(drags(), drawbar_force=drags().drawbar_force.values * (1 + 0.2 * (drags().slide_speed.values > 0)))
    ),
    "a Coulomb term is missing": lambda: drawbar.identify_film(drags(), "none"),
    "yield_stress ended at its bound": lambda: drawbar.identify_film(
        changed(drags(), drawbar_force=drags().drawbar_force.values + 0.02 * np.sign(drags().slide_speed.values)), "yield_stress"
    ),
    "yield_stress is not determined": lambda: drawbar.identify_film(drags(sensors=drawbar.Sensors(force_bias=0.03))),
    "cannot tell a yield stress from a friction": lambda: drawbar.identify_film(
        drags(loads=(0.25, 0.27), sensors=drawbar.Sensors(force_bias=2e-3))
    ),
    "all runs have one load": lambda: drawbar.identify_film(drags(loads=0.27)),
    "can hardly be told apart": lambda: drawbar.identify_film(
        drags(BOTH, loads=(0.25, 0.27), sensors=drawbar.Sensors(force_bias=1e-4)), "both"
    ),
}  # fmt: skip


@pytest.mark.parametrize("words", WARNINGS)
def test_a_fit_says_in_words_what_is_wrong(words):
    fit = WARNINGS[words]()
    assert any(re.search(words, warning) for warning in fit.warnings), fit.warnings
    assert all(sentence in fit.report() for sentence in (*fit.warnings, *fit.notes))


def test_false_alarms_are_rare():
    stiff = [drawbar.identify_stiffness(plates(seed=seed)).warnings for seed in range(60)]
    film = [drawbar.identify_film(drags(seed=seed)).warnings for seed in range(60)]
    assert sum(map(bool, stiff)) <= 3
    assert sum(map(bool, film)) <= 3


def test_a_parameter_at_its_bound_keeps_the_upper_end_of_the_free_fit_and_the_rest_is_fitted_again():
    log = drags(drawbar.CouetteCoulomb(viscous_coefficient=1e4, yield_stress=0.0))
    log = changed(log, drawbar_force=log.drawbar_force.values + 3e-4 * np.sign(log.slide_speed.values))
    held, alone = drawbar.identify_film(log, "yield_stress"), drawbar.identify_film(log, "none")
    assert held.values["yield_stress"] == 0.0
    assert held.intervals["yield_stress"][0] == 0.0
    assert held.values["viscous_coefficient"] == pytest.approx(alone.values["viscous_coefficient"])
    assert held.standard_errors["viscous_coefficient"] == pytest.approx(alone.standard_errors["viscous_coefficient"])


# What a log may hold --------------------------------------------------------------------------------


def test_runs_whose_wheel_turns_are_set_aside_and_counted():
    turning = drags(wheel_speed=[0.0, 2.0], sensors=drawbar.Sensors())
    fit = drawbar.identify_film(turning)
    assert fit.observations == 90
    assert any("90 of 180 runs were set aside" in note for note in fit.notes)
    assert holds(fit, viscous_coefficient=1e4, yield_stress=40.0)


def _histories(log, samples=40, swing=0.0):
    """Each run as samples over time, with a start that has not settled and an optional swing of the sinkage."""
    time = np.linspace(0.0, 8.0, samples)
    rows = log.isel(observation=np.repeat(np.arange(log.sizes["observation"]), samples))
    late = np.tile(time, log.sizes["observation"])
    return changed(
        rows.assign(time=("observation", late)),
        drawbar_force=rows.drawbar_force.values * (1 + (late < 1.9)),
        sinkage=rows.sinkage.values * (1 + swing * np.sin(2.0 * late)),
    )


def test_histories_count_as_one_mean_for_each_run_after_settling():
    log = drags()
    reduced = reduce_histories(_histories(log))
    for name in ("drawbar_force", "sinkage", "slide_speed", "normal_load", "trial"):
        xr.testing.assert_allclose(reduced[name].variable, log[name].variable)
    fit = drawbar.identify_film(_histories(log))
    assert fit.values == pytest.approx(drawbar.identify_film(log).values)
    assert fit.warnings == ()
    bouncing = drawbar.identify_film(_histories(log, swing=0.2))
    assert any("had not settled" in warning for warning in bouncing.warnings)


def test_the_fitted_law_is_a_file_that_the_command_line_takes(tmp_path):
    for fit in (drawbar.identify_stiffness(plates()), drawbar.identify_film(drags())):
        path = fit.save(tmp_path / f"{fit.kind}.toml")
        assert drawbar.find(fit.kind, str(path)) == fit.law
        assert "95 % interval" in path.read_text()
        with pytest.raises(FileExistsError, match="--force"):
            fit.save(path)
        fit.save(path, force=True)


def test_a_fit_carries_what_its_figure_needs():
    data = drawbar.identify_film(drags(sensors=drawbar.Sensors())).data
    line = FILM.shear_stress(data.slip_velocity.values, 0.0, 1e4, 40.0, 0.0, 0.0)
    assert data.shear_stress.values == pytest.approx(line, rel=1e-6)
    data = drawbar.identify_stiffness(plates()).data
    np.testing.assert_allclose(data.measured - data.fitted, data.residual)
    assert all(variable.attrs["units"] for variable in data.data_vars.values())


# Bad input ------------------------------------------------------------------------------------------

REFUSED = {
    r"lacks deflection \[m\] \(how far the plate sinks\)": lambda: drawbar.identify_stiffness(plates().drop_vars("deflection")),
    "all 6 loads are equal": lambda: drawbar.identify_stiffness(plates(masses=(0.1, 0.1))),
    "2 readings are too few": lambda: drawbar.identify_stiffness(plates(masses=(0.1, 0.2), sets=1)),
    "deflection falls as the load rises": lambda: drawbar.identify_stiffness(changed(plates(), deflection=-plates().deflection.values)),
    "several kinds of tissue: foam, liver": lambda: drawbar.identify_stiffness([plates(labels={"tissue": t}) for t in ("foam", "liver")]),
    "deflection is not a finite number in 1 of 30 rows, first in row 4": lambda: drawbar.identify_stiffness(
        changed(plates(), deflection=np.where(np.arange(30) == 3, np.nan, plates().deflection.values))
    ),
    "no log": lambda: drawbar.identify_stiffness([]),
    r"lacks wheel_width \[m\] \(the film's force is per width\)": lambda: drawbar.identify_film(drags().drop_vars("wheel_width")),
    "none of the 90 runs is a drag of a locked wheel": lambda: drawbar.identify_film(drags(wheel_speed=2.0)),
    "4 runs are too few to fit 3 numbers": lambda: drawbar.identify_film(drags(loads=0.2, speeds=(0.01, 0.02), repeats=1)),
    "one speed, 0.02 m/s": lambda: drawbar.identify_film(drags(speeds=0.02)),
    "one load, 0.2 N": lambda: drawbar.identify_film(drags(loads=0.2), coulomb="both"),
    "goes with the motion": lambda: drawbar.identify_film(changed(drags(), drawbar_force=-drags().drawbar_force.values)),
    "coulomb must be one of auto, none": lambda: drawbar.identify_film(drags(), coulomb="dry"),
    "count must be at least 1": lambda: coverage("nowhere", count=0),
}  # fmt: skip


@pytest.mark.parametrize("words", REFUSED)
def test_what_cannot_be_fitted_is_refused_in_a_sentence(words):
    with pytest.raises(ValueError, match=words):
        REFUSED[words]()


def test_one_speed_is_enough_for_a_film_without_coulomb_friction():
    fit = drawbar.identify_film(drags(drawbar.Couette(viscous_coefficient=1e4), speeds=0.02), coulomb="none")
    assert holds(fit, viscous_coefficient=1e4)

"""Does the virtual rig measure what the model says, with the noise it was given, in the rig's own format?"""

import numpy as np
import pytest

import drawbar
from drawbar.rig.derive import derived
from drawbar.rig.drawbar_test import drawbar_test_at
from laws import ELASTIC, FILMS, WHEEL

FOAM, COUETTE = ELASTIC[0], FILMS[1]
SETTINGS = {"normal_load": [0.14, 0.27, 0.41], "speed": 0.0254, "speed_ratio": [0.5, 1.0, 1.5]}
NOISY = drawbar.Sensors(force_noise=0.01, force_bias=0.002, angle_noise=0.004, torque_noise=1e-5)


def test_a_perfect_rig_measures_steady_rolling():
    rows = drawbar.drawbar_test(WHEEL, FOAM, COUETTE, **SETTINGS, repeats=2)
    assert dict(rows.sizes) == {"observation": 18}
    for i in range(18):
        one = rows.isel(observation=i)
        known = drawbar.steady(
            WHEEL, FOAM, COUETTE, normal_load=float(one.normal_load), speed=0.0254, speed_ratio=float(one.speed_ratio)
        )
        for name in ("drawbar_force", "wheel_torque", "sinkage", "contact_half_angle"):
            assert float(one[name]) == pytest.approx(float(known[name]), rel=1e-12), name


def test_noise_falls_with_the_samples_of_a_run_and_a_zero_error_does_not():
    noise = drawbar.drawbar_test(
        WHEEL,
        FOAM,
        COUETTE,
        normal_load=0.2,
        speed=0.02,
        speed_ratio=1.0,
        repeats=2000,
        sensors=drawbar.Sensors(force_noise=0.03),
    )
    samples = 0.20 / 0.02 * 100
    # the standard deviation of 2000 draws is known to 1/sqrt(4000) = 1.6 %
    assert float(noise.drawbar_force.std()) == pytest.approx(0.03 / np.sqrt(samples), rel=0.06)
    bias = drawbar.drawbar_test(
        WHEEL,
        FOAM,
        COUETTE,
        normal_load=0.2,
        speed=0.02,
        speed_ratio=1.0,
        repeats=2000,
        sensors=drawbar.Sensors(force_bias=0.003),
    )
    assert float(bias.drawbar_force.std()) == pytest.approx(0.003, rel=0.06)


def test_the_same_seed_gives_the_same_run_and_another_does_not():
    def run(seed):
        return drawbar.drawbar_test(WHEEL, FOAM, COUETTE, **SETTINGS, repeats=2, sensors=NOISY, seed=seed)

    assert run(1).identical(run(1))
    assert np.all(run(1).drawbar_force != run(2).drawbar_force)
    first, second = (run(1).drawbar_force.values[i : i + 9] for i in (0, 9))
    assert np.all(first != second)


def test_reverse_locked_and_free_rolling_are_runs_like_any_other():
    drags = drawbar.drawbar_test(WHEEL, FOAM, COUETTE, normal_load=0.2, speed=[-0.02, 0.02], wheel_speed=0.0)
    back, forth = drags.drawbar_force.values
    assert forth < 0 < back
    assert back == pytest.approx(-forth, rel=1e-14)
    assert np.all(np.isnan(drags.speed_ratio))
    free = drawbar.drawbar_test(WHEEL, FOAM, COUETTE, normal_load=0.2, speed=0.02, wheel_torque=0.0)
    assert float(free.wheel_torque[0]) == pytest.approx(0.0, abs=1e-15)
    assert float(free.speed_ratio[0]) > 1.0


def test_a_time_history_settles_to_the_steady_value_and_carries_its_noise():
    run = drawbar.drawbar_test(
        WHEEL,
        FOAM,
        COUETTE,
        normal_load=0.27,
        speed=0.0254,
        speed_ratio=0.5,
        history=True,
        damper=0.5,
        sensors=NOISY,
        repeats=3,
    )
    assert "0.5 N s/m" in run.attrs["damping"]
    assert float(run.time.max()) == pytest.approx(0.20 / 0.0254, abs=0.01)
    steady = drawbar.steady(WHEEL, FOAM, COUETTE, normal_load=0.27, speed=0.0254, speed_ratio=0.5)
    for trial in (1, 2, 3):
        late = run.drawbar_force.values[(run.trial.values == trial) & (run.time.values > 2.0)]
        bound = 4 * (0.002 + 0.01 / np.sqrt(late.size))
        assert late.mean() == pytest.approx(float(steady.drawbar_force), abs=bound)
        assert late.std() == pytest.approx(0.01, rel=0.15)


def test_the_rig_runs_at_a_logs_own_settings():
    log = drawbar.drawbar_test(WHEEL, FOAM, COUETTE, **SETTINGS, labels={"wheel": "smooth"})
    again = drawbar_test_at(log, WHEEL, FOAM, COUETTE)
    assert again.drawbar_force.values == pytest.approx(log.drawbar_force.values, rel=1e-12)
    assert list(again.wheel.values) == ["smooth"] * 9
    with pytest.raises(ValueError, match=r"the log lacks wheel_speed.*rim_speed or speed_ratio"):
        drawbar_test_at(log.drop_vars(["wheel_speed"]), WHEEL, FOAM, COUETTE)


@pytest.mark.parametrize("tissue", ELASTIC, ids=repr)
def test_a_plates_work_is_the_energy_it_stores(tissue):
    """For a linear law the work F w / 2 is the energy under the plate and along its rim."""
    area, mass = 1e-3, 0.1
    plate = drawbar.plate_test(tissue, applied_mass=mass, plate_area=area, sets=1)
    w = plate.deflection.values
    numbers = [getattr(tissue, name) for name in ("stiffness", "tension") if hasattr(tissue, name)]
    stored = area * tissue.energy_density(w, 0.0, *numbers) + 4 * np.sqrt(area) * tissue.edge_energy(w, *numbers)
    assert 0.5 * mass * 9.80665 * w[0] == pytest.approx(float(stored[0]), rel=1e-12)


def test_columns_follow_from_others_by_geometry():
    phi = np.array([0.0, 0.4, 1.2])
    known = derived({"contact_half_angle": phi, "wheel_radius": 0.0075})
    assert known["sinkage"] == pytest.approx(0.0075 * (1 - np.cos(phi)), abs=1e-15)
    lever = derived(
        {"lever_angle": np.array([0.01]), "lever_length": np.array([0.15]), "wheel_radius": np.array([0.0075])}
    )
    assert lever["sinkage"] == pytest.approx(0.15 * np.sin(0.01))
    assert 0.0075 * (1 - np.cos(lever["contact_half_angle"])) == pytest.approx(lever["sinkage"])
    locked = derived(
        {"slide_speed": np.array([0.01]), "wheel_speed": np.array([0.0]), "wheel_radius": np.array([0.0075])}
    )
    assert np.isnan(locked["speed_ratio"][0])
    measured = derived({"sinkage": np.array([1.0]), "lever_angle": np.array([0.1]), "lever_length": np.array([1.0])})
    assert measured["sinkage"][0] == 1.0


@pytest.mark.parametrize(
    ("wrong", "sentence"),
    [
        ({"repeats": 0}, r"repeats must be at least 1"),
        ({"normal_load": [-0.1]}, r"normal_load must be >= 0 N"),
        ({"speed": 0.0, "speed_ratio": None, "wheel_speed": 1.0, "history": True}, r"needs a speed other than 0"),
    ],
)
def test_wrong_input_is_told_what_is_allowed(wrong, sentence):
    with pytest.raises(ValueError, match=sentence):
        drawbar.drawbar_test(WHEEL, FOAM, COUETTE, **(SETTINGS | wrong))

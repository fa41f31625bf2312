"""Does a comparison find what was put between two data sets, and say honestly when it cannot?"""

from __future__ import annotations

import math

import numpy as np
import pytest
import xarray as xr
from hypothesis import given
from hypothesis import strategies as st

import drawbar
from drawbar.study.compare.agreement import agreement, mean_interval
from drawbar.study.compare.compare import compare
from drawbar.study.compare.comparison import Comparison
from drawbar.variables import declare

W = 0.27468
WHEEL = drawbar.Wheel(radius=0.0075, width=0.02)
FOAM = drawbar.Winkler(stiffness=225e3)
FILM = drawbar.Couette(viscous_coefficient=1e4)
LOADS, RATIOS = [0.5 * W, W, 1.5 * W], [0.5, 1.0, 1.5]


def model() -> xr.Dataset:
    return drawbar.steady(WHEEL, FOAM, FILM, speed=0.0254, **drawbar.grid(normal_load=LOADS, speed_ratio=RATIOS))


def changed(by) -> xr.Dataset:
    force = model().drawbar_force
    return model().assign(drawbar_force=by(force).assign_attrs(force.attrs))


def rows(**columns) -> xr.Dataset:
    """Runs as a laboratory would write them."""
    size = len(columns["drawbar_force"])
    data = {"slide_speed": np.full(size, 0.0254), "normal_load": np.full(size, W), **columns}
    names = [n for n in ("wheel", "tissue", "trial") if n in data]
    return declare({n: ("observation", np.asarray(v)) for n, v in data.items()}, coords=names)


def test_a_model_agrees_with_itself():
    found = compare(model(), model())
    assert found.scale.value == pytest.approx(1.0, abs=1e-12)
    assert found.offset.value == 0.0
    assert found.nrmse == 0.0
    assert found.explained_by == "none"
    assert found.verdict == "Model and data are the same in 9 conditions."
    assert found.signs.agree == found.signs.compared == 9
    assert found.over_all.spearman == pytest.approx(1.0)
    assert found.over_all.kendall == pytest.approx(1.0)
    assert found.unmatched == {"model": 0, "data": 0}


def test_a_third_of_the_model_is_a_matter_of_scale():
    found = compare(model(), changed(lambda f: f / 3))
    assert found.scale.inverse.value == pytest.approx(3.0)
    assert found.explained_by == "scale"
    assert "3 times the data" in found.verdict


def test_a_constant_less_than_the_model_is_an_offset():
    found = compare(model(), changed(lambda f: f - 0.03))
    assert found.offset.value == pytest.approx(-0.03)
    assert found.explained_by == "offset"
    assert "0.03 N below the model" in found.verdict


def test_the_papers_factor_is_found_through_noise_and_its_interval_holds_it():
    thin = drawbar.Couette(viscous_coefficient=1e4 / 3)
    noisy = drawbar.Sensors(force_noise=0.02, force_bias=0.002)
    data = drawbar.drawbar_test(
        WHEEL, FOAM, thin, normal_load=LOADS, speed=0.0254, speed_ratio=RATIOS, repeats=10, sensors=noisy, seed=1
    )
    found = compare(model(), data)
    assert found.explained_by == "scale"
    assert found.scale.holds(1 / 3)
    assert not found.offset.holds(-1.0)
    assert set(found.table["data_repeats"].values) == {10}
    assert np.all(np.isfinite(found.table["data_interval"]))
    assert np.all(np.isnan(found.table["model_interval"]))  # a model has no repeats
    assert found.over_all.spread("scaled") < 0.003  # the sensors' own zero errors, over ten runs


def test_values_that_hardly_vary_cannot_tell_a_factor_from_an_offset():
    rng = np.random.default_rng(3)
    m = 1.0 + 0.02 * rng.normal(size=12)
    found = agreement(m, 0.7 * m + 0.05 * rng.normal(size=12))
    assert found.explained_by == "cannot tell"
    assert abs(found.advantage) < 6.0


@given(
    scale=st.floats(0.05, 20.0).filter(lambda s: abs(s - 1.0) > 0.02),
    offset=st.floats(-5.0, 5.0).filter(lambda b: abs(b) > 0.05),
    seed=st.integers(0, 1000),
)
def test_any_factor_and_any_offset_are_found_again(scale, offset, seed):
    m = np.random.default_rng(seed).normal(size=9)
    scaled, shifted = agreement(m, scale * m), agreement(m, m + offset)
    both = agreement(m, scale * m + offset)
    assert scaled.explained_by == "scale"
    assert scaled.scale.value == pytest.approx(scale)
    assert shifted.explained_by == "offset"
    assert shifted.offset.value == pytest.approx(offset)
    assert both.scale_of_both.value == pytest.approx(scale, rel=1e-6)
    assert both.offset_of_both.value == pytest.approx(offset, rel=1e-6)
    assert both.residuals["both"] <= min(both.residuals[r] for r in ("identical", "scaled", "shifted"))


def test_intervals_hold_the_truth_as_often_as_they_say():
    rng = np.random.default_rng(5)
    truth = np.linspace(-1.0, 1.0, 8)
    means, scales, offsets, tries = 0, 0, 0, 600
    for _ in range(tries):
        centre, half = mean_interval(2.0 + rng.normal(size=5))
        means += abs(centre - 2.0) <= half
        scales += agreement(truth, 0.4 * truth + 0.1 * rng.normal(size=8)).scale.holds(0.4)
        offsets += agreement(truth, truth + 0.3 + 0.1 * rng.normal(size=8)).offset.holds(0.3)
    for count in (means, scales, offsets):
        assert 0.92 < count / tries < 0.98  # 95 % ± 3 standard deviations of 600 tries


def test_signs_and_ranks_are_counted_by_hand():
    ratio = [0.5, 0.6, 0.7, 0.8]
    m = rows(drawbar_force=[3.0, 1.0, 2.0, -1.0], speed_ratio=ratio)
    repeats = {"speed_ratio": ratio * 3, "trial": [1] * 4 + [2] * 4 + [3] * 4}
    d = rows(drawbar_force=[3.0, 1.0, 2.0, 0.9, 3.1, -1.0, 2.1, 1.0, 2.9, 0.0, 1.9, 1.1], **repeats)
    found = compare(m, d)
    assert (found.signs.agree, found.signs.compared, found.signs.zero) == (2, 3, 1)  # the second holds zero
    # data rank 3.0, 0.0, 2.0, 1.0 against 3, 1, 2, -1: one pair of six is turned round
    assert found.over_all.kendall == pytest.approx(4 / 6)
    assert found.over_all.spearman == pytest.approx(0.8)


def test_measured_settings_scatter_and_still_match():
    rng = np.random.default_rng(2)
    clean = drawbar.drawbar_test(WHEEL, FOAM, FILM, normal_load=LOADS, speed=0.0254, speed_ratio=RATIOS, repeats=3)
    load, ratio = (clean[n] * (1 + 0.004 * rng.uniform(-1, 1, 27)) for n in ("normal_load", "speed_ratio"))
    scattered = clean.drop_vars(["wheel_speed", "rim_speed"]).assign(normal_load=load, speed_ratio=ratio)
    found = compare(model(), scattered)
    assert set(found.table["data_repeats"].values) == {3}
    assert found.nrmse == pytest.approx(0.0, abs=1e-12)


def test_conditions_without_a_partner_are_counted_and_named():
    wide = drawbar.drawbar_test(WHEEL, FOAM, FILM, normal_load=[*LOADS, 2 * W], speed=0.0254, speed_ratio=[0.5, 1.0])
    found = compare(model(), wide)
    assert found.over_all.count == 6
    assert found.unmatched == {"model": 3, "data": 2}
    assert "Without a partner in the data: normal_load 0.5494 N" in found.report()
    assert "tolerance of 0.25 in normal_load" in found.report()


def test_a_tolerance_may_be_given_by_setting():
    near = model().assign_coords(normal_load=np.array(LOADS) * 1.1)
    with pytest.raises(ValueError, match=r"no condition .* allow a tolerance of 0\.091 in normal_load"):
        compare(model(), near)
    assert compare(model(), near, tolerance={"normal_load": 0.1}).over_all.count == 9
    with pytest.raises(ValueError, match=r"'load' is not a setting\. .*normal_load"):
        compare(model(), near, tolerance={"load": 0.1})


def test_locked_wheels_match_locked_wheels_and_reverse_matches_reverse():
    speeds = [-0.0254, 0.0254]
    data = drawbar.drawbar_test(WHEEL, FOAM, FILM, normal_load=LOADS, speed=speeds, wheel_speed=[0.0, 5.0])
    axes = drawbar.grid(normal_load=LOADS, speed=speeds)
    locked = drawbar.steady(WHEEL, FOAM, FILM, wheel_speed=0.0, **axes)
    found = compare(locked, data)
    assert found.over_all.count == 6
    assert found.unmatched["data"] == 6
    assert found.over_all.residuals["identical"] == 0.0
    assert "speed_ratio of a locked wheel" in found.report()


def test_time_histories_count_as_their_settled_mean():
    run = {"normal_load": LOADS, "speed": 0.0254, "speed_ratio": RATIOS}
    histories = drawbar.drawbar_test(WHEEL, FOAM, FILM, **run, history=True, damper=0.5)
    found = compare(model(), histories)
    assert found.over_all.count == 9
    assert found.nrmse < 1e-4  # what is left of the settling after two of eight seconds
    assert "9 runs" in found.report()
    one = drawbar.simulate(WHEEL, FOAM, FILM, normal_load=W, speed=0.0254, wheel_speed=5.0, damper=0.5)
    steady = drawbar.steady(WHEEL, FOAM, FILM, normal_load=W, speed=0.0254, wheel_speed=5.0)
    assert compare(steady, one).over_all.residuals["identical"] < 1e-10


def test_names_match_where_both_sides_know_them():
    force, wheels = [1.0, 2.0, 4.0, 5.0], ["smooth", "male"] * 2
    data = rows(drawbar_force=force, speed_ratio=[0.5, 0.5, 1.0, 1.0], wheel=wheels)
    knows = rows(drawbar_force=[2.0, 3.0], speed_ratio=[0.5, 1.0], wheel=["smooth"] * 2)
    found = compare(knows, data)
    assert found.table["data"].values.tolist() == [1.0, 4.0]
    assert found.unmatched["data"] == 2
    knows_not = knows.drop_vars("wheel")
    beside = compare(knows_not, data)
    assert beside.over_all.count == 4
    assert "The model does not tell one wheel from another" in beside.report()
    other = compare(knows.assign_coords(wheel=("observation", ["robot-2004"] * 2)), data.isel(observation=[0, 2]))
    assert "wheel differs and was not matched: 'robot-2004' in the model, 'smooth' in the data" in other.report()


def test_nothing_is_averaged_that_is_not_a_repeat():
    data = rows(drawbar_force=[1.0], speed_ratio=[0.5])
    with pytest.raises(ValueError, match=r"the model varies in wheel_width \(0\.01 to 0\.03\).*Select one"):
        compare(rows(drawbar_force=[1.0, 2.0], speed_ratio=[0.5, 0.5], wheel_width=[0.01, 0.03]), data)
    with pytest.raises(ValueError, match="the model varies in wheel"):
        compare(rows(drawbar_force=[1.0, 2.0], speed_ratio=[0.5, 0.5], wheel=["a", "b"]), data)
    several = drawbar.steady(
        WHEEL, FOAM, drawbar.Couette(viscous_coefficient=np.array([1e4, 2e4])), normal_load=W, speed=0.0254,
        speed_ratio=0.5,
    )  # fmt: skip
    with pytest.raises(ValueError, match="the model varies in viscous_coefficient"):
        compare(several, data)


@pytest.mark.parametrize(
    ("m", "d", "said"),
    [
        ([1.0], [2.0], "1 condition cannot tell"),
        ([1.0, 1.0, 1.0], [2.0, 2.0, 2.0], "cannot tell|open"),
        ([0.0, 0.0, 0.0], [2.0, 2.1, 1.9], "an offset explains|no factor"),
        ([0.0, 0.0, 0.0], [0.0, 0.0, 0.0], "the same"),
        ([1.0, 2.0, 3.0], [5.0, 5.0, 5.0], ""),
        ([1.0, 2.0, 3.0], [-1.0, -2.0, -3.0], "-1 times"),
    ],
)
def test_degenerate_cases_are_said_in_words(m, d, said):
    ratio = np.linspace(0.5, 1.5, len(m))
    found = compare(rows(drawbar_force=m, speed_ratio=ratio), rows(drawbar_force=d, speed_ratio=ratio))
    assert isinstance(found, Comparison)
    assert found.verdict
    assert any(word in found.verdict for word in said.split("|"))
    assert "nan" not in found.report()


def test_where_the_measured_values_are_equal_nrmse_is_not_defined():
    ratio = [0.5, 1.0, 1.5]
    found = compare(
        rows(drawbar_force=[1.0, 2.0, 3.0], speed_ratio=ratio), rows(drawbar_force=[5.0] * 3, speed_ratio=ratio)
    )
    assert math.isnan(found.nrmse)
    assert math.isnan(found.over_all.kendall)


def test_data_that_do_not_follow_the_model_are_not_flattered():
    ratio = [0.5, 0.6, 0.7, 0.8, 0.9]
    m = rows(drawbar_force=[1.0, 2.0, 3.0, 4.0, 5.0], speed_ratio=ratio)
    found = compare(m, rows(drawbar_force=[0.1, -0.2, 0.15, -0.1, 0.02], speed_ratio=ratio))
    assert found.scale.holds(0.0)
    assert math.isnan(found.scale.inverse.interval[0])  # one over an interval with zero in it
    assert found.verdict.startswith("The data do not follow the model")


@pytest.mark.parametrize(
    ("m", "d", "options", "sentence"),
    [
        ({}, {}, {"quantity": "drawbar_farce"}, "the model has no numbers called 'drawbar_farce'.*drawbar_force"),
        ({}, {}, {"tolerance": 1.5}, "tolerance must be >= 0 and < 1, got 1.5"),
        ({}, {"speed_ratio": [3.0, 4.0]}, {}, "The model has .*speed_ratio 0.5 to 1; the data have .*3 to 4"),
    ],
)
def test_errors_are_sentences(m, d, options, sentence):
    base = {"drawbar_force": [1.0, 2.0], "speed_ratio": [0.5, 1.0]}
    with pytest.raises(ValueError, match=sentence):
        compare(rows(**base | m), rows(**base | d), **options)


def test_data_without_a_common_setting_are_refused():
    plate = declare({"drawbar_force": ("observation", np.ones(2)), "deflection": ("observation", np.ones(2))})
    with pytest.raises(ValueError, match=r"share no setting\. The model has .*normal_load.* The data has none of them"):
        compare(model(), plate)
    empty = rows(drawbar_force=[], speed_ratio=[])
    with pytest.raises(ValueError, match="the data is empty"):
        compare(model(), empty)


def test_rows_that_lack_the_quantity_are_counted():
    data = rows(drawbar_force=[1.0, np.nan, 2.0], speed_ratio=[0.5, 1.0, 1.5])
    found = compare(rows(drawbar_force=[1.0, 1.0, 2.0], speed_ratio=[0.5, 1.0, 1.5]), data)
    assert found.over_all.count == 2
    assert "Rows of the data without drawbar_force or a setting: 1, left out." in found.notes

"""Does every figure say its units, keep its words apart, and come out the same twice?"""

from __future__ import annotations

import functools
import itertools
import re

import matplotlib
import numpy as np
import pytest
import xarray as xr
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.figure import Figure
from matplotlib.text import Text

import drawbar
from drawbar.sources.rentschler_2004 import LOADS, OUTCOMES, SPEED_RATIOS, WEIGHT
from drawbar.study.compare.compare import compare
from drawbar.study.identify.fit import Fit
from drawbar.study.paper import model as paper_model
from drawbar.study.paper.memory import memory_sweep, power_curve
from drawbar.view import figure
from drawbar.view.style import shown, style

WHEEL = drawbar.Wheel(radius=0.0075, width=0.02, mass=0.028)
FOAM = drawbar.Winkler(stiffness=225e3)
FILM = drawbar.CouetteCoulomb(viscous_coefficient=1e4, yield_stress=20.0)
NOISY = drawbar.Sensors(force_noise=0.05, force_bias=0.002, angle_noise=2e-3, deflection_noise=5e-5)
LOAD = np.array(LOADS) * WEIGHT


@functools.cache
def model() -> xr.Dataset:
    axes = drawbar.grid(normal_load=LOAD, speed_ratio=np.linspace(0.5, 1.5, 11))
    return drawbar.steady(WHEEL, FOAM, FILM, speed=0.0254, **axes).assign_attrs(weight=WEIGHT)


@functools.cache
def runs() -> xr.Dataset:
    return drawbar.drawbar_test(
        WHEEL, FOAM, FILM, normal_load=LOAD, speed=0.0254, speed_ratio=SPEED_RATIOS, repeats=5, sensors=NOISY
    )


@functools.cache
def drags() -> xr.Dataset:
    speeds = [-0.02, -0.01, 0.01, 0.02]
    return drawbar.drawbar_test(
        WHEEL, FOAM, FILM, normal_load=LOAD, speed=speeds, wheel_speed=0.0, repeats=3, sensors=NOISY
    )


@functools.cache
def plates(stiffness: float) -> Fit:
    masses = np.linspace(0.02, 0.2, 6)
    tissue = drawbar.Winkler(stiffness=stiffness)
    log = drawbar.plate_test(
        tissue, applied_mass=masses, plate_area=2.5e-3, spread=0.03, sensors=NOISY, labels={"tissue": f"{stiffness:g}"}
    )
    return drawbar.identify_stiffness(log)


@functools.cache
def transient(**settings: float) -> xr.Dataset:
    return drawbar.simulate(WHEEL, FOAM, drawbar.Couette(viscous_coefficient=1e4), normal_load=WEIGHT, **settings)


@functools.cache
def history() -> xr.Dataset:
    return drawbar.drawbar_test(
        WHEEL, FOAM, FILM, normal_load=WEIGHT, speed=0.0254, speed_ratio=[0.5, 1.5], history=True, damper=0.5,
        travel=0.05, sensors=NOISY,
    )  # fmt: skip


@functools.cache
def paper() -> tuple[xr.Dataset, xr.Dataset]:
    maps = paper_model.drawbar_maps()
    cells = {v.outcome.name: v.cells for v in paper_model.verdicts(maps) if v.cells is not None}
    forces = {f"drawbar_force_{tissue}": force for (tissue, _), force in maps.items()}
    few = slice(None, None, 4)  # every fourth width: the test is of words, not of widths
    return xr.Dataset(cells).isel(wheel_width=few), xr.Dataset(forces).isel(wheel_width=few)


def said(*names: str) -> list:
    return [o for o in OUTCOMES if o.name in names]


FIGURES = {
    "model": lambda w: figure.drawbar_curves(model(), width=w),
    "repeats": lambda w: figure.drawbar_curves(runs(), weight=WEIGHT, title="virtual rig", note="Seed 0.", width=w),
    "drags": lambda w: figure.drawbar_curves(drags(), width=w),
    "sinkage": lambda w: figure.drawbar_curves(model(), quantity="sinkage", width=w),
    "map": lambda w: figure.steady_map(model(), width=w),
    "history": lambda w: figure.history(history(), run=1, title="Fig. 9", width=w),
    "bounce": lambda w: figure.history(transient(speed=0.0254, speed_ratio=0.5, duration=1.0), width=w),
    "driven": lambda w: figure.simulation(
        transient(drawbar_force=0.02, wheel_torque=4e-4, duration=1.0, damper=0.5), width=w, title="From rest"
    ),
    "skidding": lambda w: figure.simulation(transient(speed=0.0254, speed_ratio=1.5, duration=1.0), width=w),
    "stiffness": lambda w: figure.stiffness_fit(plates(225e3), plates(415e3), width=w),
    "film": lambda w: figure.film_fit(drawbar.identify_film(drags()), weight=WEIGHT, width=w),
    "film by load": lambda w: figure.film_fit(drawbar.identify_film(drags(), coulomb="both"), width=w),
    "comparison": lambda w: figure.comparison(compare(model(), runs()), weight=WEIGHT, width=w),
    "signs": lambda w: figure.printed_words(said("P1", "P2", "P3"), model(), width=w),
    "a number": lambda w: figure.printed_words(said("P7"), title="Fig. 15", width=w),
    "words alone": lambda w: figure.printed_words(said("P4"), width=w),
    "widths": lambda w: figure.width_sweep(*paper(), width=w),
    "memory": lambda w: figure.memory_sweep(memory_sweep(), width=w),
    "power": lambda w: figure.power_split(power_curve(), width=w),
    "tension": lambda w: figure.tension_error(paper_model.tension_error(), width=w),
}


@functools.cache
def drawn(name: str, width: float) -> Figure:
    made = FIGURES[name](width)
    with style():
        FigureCanvasAgg(made).draw()
    return made


@pytest.mark.parametrize("name", FIGURES)
def test_every_axis_has_a_unit(name):
    for axes in drawn(name, 7.0).axes:
        assert re.search(r"\[.+\]", axes.get_ylabel()), axes.get_ylabel()
        if axes.get_label() == "<colorbar>":
            continue
        shared = axes.get_shared_x_axes().get_siblings(axes)
        assert any(re.search(r"\[.+\]", one.get_xlabel()) for one in shared), axes.get_title()


def texts(of: Figure) -> list[Text]:
    """The words that stand on a figure by themselves; a legend keeps its own apart."""
    found = [t for t in (of._suptitle, of._supxlabel) if t is not None]  # type: ignore[attr-defined]
    found += list(of.legends)
    for axes in of.axes:
        found += [axes.xaxis.label, axes.yaxis.label, axes.title, axes._left_title, axes._right_title]  # type: ignore[attr-defined]
        found += axes.texts
        found += [axes.get_legend()] if axes.get_legend() else []
        for axis in (axes.xaxis, axes.yaxis):
            low, high = sorted(axis.get_view_interval())
            found += [t.label1 for t in axis.get_major_ticks() if low <= t.get_loc() <= high and t.label1.get_visible()]
    return [t for t in found if t.get_visible() and (not isinstance(t, Text) or t.get_text())]


@pytest.mark.parametrize("width", [3.5, 7.0])
@pytest.mark.parametrize("name", FIGURES)
def test_no_words_overlap_or_leave_the_page(name, width):
    made = drawn(name, width)
    renderer = FigureCanvasAgg(made).get_renderer()
    page = made.bbox
    boxes = [(t, t.get_window_extent(renderer)) for t in texts(made)]
    for t, box in boxes:
        inside = page.x0 - 1 <= box.x0 and box.x1 <= page.x1 + 1 and page.y0 - 1 <= box.y0 and box.y1 <= page.y1 + 1
        assert inside, f"{t} leaves the page"
    for (one, a), (other, b) in itertools.combinations(boxes, 2):
        apart = a.x1 <= b.x0 + 1 or b.x1 <= a.x0 + 1 or a.y1 <= b.y0 + 1 or b.y1 <= a.y0 + 1
        assert apart, f"{one} lies on {other}"


def test_files_are_whole_and_the_same_twice(tmp_path):
    one = figure.save(figure.drawbar_curves(runs(), weight=WEIGHT), tmp_path / "one")
    two = figure.save(figure.drawbar_curves(runs(), weight=WEIGHT), tmp_path / "two")
    assert [p.suffix for p in one] == [".png", ".svg"]
    assert one[1].read_bytes() == two[1].read_bytes()
    assert one[0].read_bytes() == two[0].read_bytes()
    vector = one[1].read_text()
    assert "drawbar force [mN]</text>" in vector  # words stay words
    assert "dc:date" not in vector
    with pytest.raises(FileExistsError, match=r"one\.png.*--force"):
        figure.save(figure.drawbar_curves(runs()), tmp_path / "one")
    figure.save(figure.drawbar_curves(model()), tmp_path / "one", force=True)
    assert one[1].read_bytes() != two[1].read_bytes()


def test_drawing_leaves_no_trace_in_matplotlib():
    before = dict(matplotlib.rcParams)
    figure.drawbar_curves(model())
    assert dict(matplotlib.rcParams) == before


def test_the_users_own_settings_stay_out(tmp_path):
    plain = figure.save(figure.drawbar_curves(model()), tmp_path / "plain")[1].read_bytes()
    with matplotlib.rc_context({"font.size": 30, "axes.grid": True, "svg.fonttype": "path"}):
        assert figure.save(figure.drawbar_curves(model()), tmp_path / "loud")[1].read_bytes() == plain


@pytest.mark.parametrize(
    ("name", "unit", "si", "label", "number"),
    [
        ("drawbar_force", "N", 0.0883, "drawbar force [mN]", 88.3),
        ("drawbar_force", "N", -17.1, "drawbar force [N]", -17.1),
        ("sinkage", "m", 0.00566, "sinkage [mm]", 5.66),
        ("contact_half_angle", "rad", np.pi / 2, "contact half angle [°]", 90.0),
        ("peak_pressure", "Pa", 1274.0, "peak pressure [kPa]", 1.274),
        ("speed_ratio", "1", 0.5, "speed ratio [1]", 0.5),
        ("yield_stress", "Pa", 20.0, "yield stress [Pa]", 20.0),
    ],
)
def test_numbers_and_labels_change_unit_together(name, unit, si, label, number):
    found = shown(xr.DataArray([si], name=name, attrs={"units": unit}))
    assert found.label == label
    assert found.values[0] == pytest.approx(number)
    assert found(2 * si) == pytest.approx(2 * number)


def test_a_curve_shows_the_numbers_of_the_data():
    line = figure.drawbar_curves(model()).axes[0].lines[1]  # the first is the zero line
    assert line.get_label() == "0.137 N (0.5 W)"
    assert line.get_ydata() == pytest.approx(1e3 * model().drawbar_force.isel(normal_load=0).values)


def test_bars_are_the_intervals_of_the_mean():
    bars = figure.drawbar_curves(runs()).axes[0].containers[0]
    table = compare(model(), runs()).table
    (segments,) = (c.get_segments() for c in bars[2])
    half = [0.5 * float(s[1, 1] - s[0, 1]) for s in segments]
    assert half == pytest.approx(1e3 * table["data_interval"].values[:3])


def test_a_figure_of_words_says_so_and_calls_the_model_computed():
    made = drawn("signs", 3.5)
    assert "printed words only" in made.axes[0].get_title(loc="left")
    assert made.legends[0].get_title().get_text().startswith("computed, not from the paper")


def test_the_damping_and_the_ledgers_error_stand_on_the_figures():
    made = {n: drawn(n, 7.0)._supxlabel.get_text() for n in ("history", "bounce", "driven")}  # type: ignore[attr-defined]
    captions = {n: text.replace("\N{NO-BREAK SPACE}", " ") for n, text in made.items()}
    assert "Lever damper 0.5 N" in captions["history"]
    assert "Nothing damps the settling" in captions["bounce"]
    assert "Ledger error at most" in captions["driven"]


@pytest.mark.parametrize(
    ("draw", "sentence"),
    [
        (lambda: figure.drawbar_curves(model(), width=1.0), "width must be between 3 and 12 in, got 1.0"),
        (
            lambda: figure.drawbar_curves(model(), quantity="pull"),
            "the data set has no pull to draw. It has: .*sinkage",
        ),
        (lambda: figure.history(model()), "the data set has no time"),
        (lambda: figure.history(history(), run=2), "run must be between 0 and 1, got 2"),
        (lambda: figure.steady_map(runs()), "a map needs drawbar_force over speed_ratio and normal_load"),
        (lambda: figure.simulation(model()), "Give what drawbar.simulate returns"),
        (lambda: figure.stiffness_fit(), "there is no fit to draw"),
        (lambda: figure.printed_words([]), "there is no outcome to show"),
        (lambda: figure.tension_error(model()), "neither sinkage_error nor drawbar_force_error"),
    ],
)
def test_errors_are_sentences(draw, sentence):
    with pytest.raises(ValueError, match=sentence):
        draw()

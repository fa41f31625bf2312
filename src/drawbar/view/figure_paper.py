"""Figures about the paper: what its words say of a measurement, its unprinted width, its dropped tension."""

from __future__ import annotations

import dataclasses
from collections.abc import Mapping, Sequence

import numpy as np
import xarray as xr
from matplotlib.axes import Axes
from matplotlib.colors import ListedColormap
from matplotlib.figure import Figure
from matplotlib.patches import Patch
from matplotlib.transforms import blended_transform_factory

from drawbar.sources.rentschler_2004 import ASSUMED, PRINTED, SPEED_RATIOS, Outcome
from drawbar.view.curves import curves, draw, scales
from drawbar.view.style import COLOURS, INK, caption, legend, new_figure, number, shown, style, zero_line

__all__ = ["Said", "printed_words", "tension_error", "width_sweep"]

POSITIVE, NEGATIVE, ZERO = "#cfe3f1", "#f6d9c6", "#e6e6e6"
HELD, FAILED, SILENT = "#009E73", "#D55E00", "#f2f2f2"


@dataclasses.dataclass(frozen=True)
class Said:
    """What an outcome's words put on axes of force against speed ratio: signs, and single numbers."""

    signs: Mapping[float, int] = dataclasses.field(default_factory=dict)
    points: Mapping[float, tuple[float, str]] = dataclasses.field(default_factory=dict)


PULL, ROLL, SKID = SPEED_RATIOS

SAID: dict[str, Said] = {
    "P1": Said(signs={PULL: 1, ROLL: 0, SKID: -1}),
    "P6": Said(signs={PULL: -1, ROLL: -1, SKID: -1}),
    "P7": Said(signs={PULL: 1}, points={PULL: (PRINTED["female_liver_force"].value, "0.05 N at N = W")}),
    "P8": Said(signs={PULL: 1}, points={PULL: (PRINTED["male_liver_force"].value, "about 0.1 N at N = W")}),
}
"""By outcome. The others speak of order or of ratios, which have no place on these axes but as words."""


@style()
def printed_words(
    outcomes: Sequence[Outcome], model_curves: xr.Dataset | None = None, *, title: str = "", width: float = 3.5
) -> Figure:
    """A measured figure of which only words are known: what they say, and no more.

    Signs are shaded half-planes at their speed ratio, a printed number is a point, everything else
    stands below as words. The model's curves may be drawn for contrast; they are called computed.

    Parameters
    ----------
    outcomes
        The printed outcomes that speak of this figure.
    model_curves
        A map of drawbar force over speed ratio and normal load.

    Raises
    ------
    ValueError
        There is no outcome.
    """
    if not outcomes:
        raise ValueError("there is no outcome to show. Give those of OUTCOMES that speak of the figure.")
    said = [SAID.get(o.name, Said()) for o in outcomes]
    signs = {ratio: sign for s in said for ratio, sign in s.signs.items()}
    points = {ratio: point for s in said for ratio, point in s.points.items()}
    found = curves(model_curves, "drawbar_force", "speed_ratio") if model_curves is not None else []
    forces = np.array(
        [force for force, _ in points.values()] + [v for c in found for v in (c.mean.min(), c.mean.max())]
    )
    figure = new_figure(width, 0.68 * min(width, 5.0) + (1.1 if found else 0.7))
    axes = figure.add_subplot()
    scale = shown(xr.DataArray(forces if forces.size else np.ones(1), name="drawbar_force"))
    largest = float(np.max(np.abs(scale.values))) * 1.7  # room for words beyond the curves
    axes.set(xlim=(0.3, 1.7), ylim=(-largest, largest), xlabel="speed ratio v/(rω) [1]", ylabel=scale.label)
    axes.set_title(" · ".join(filter(None, (title, "printed words only"))))
    axes.set_xticks(list(SPEED_RATIOS))
    zero_line(axes)
    for ratio, sign in signs.items():
        _half_plane(axes, ratio, sign, largest)
    if found and model_curves is not None:
        x, _ = scales(model_curves, "drawbar_force", "speed_ratio", found)
        draw(axes, found, x, scale, points=False)
        legend(figure, axes, "computed, not from the paper; normal load")
    for ratio, (force, words) in points.items():
        axes.plot(ratio, scale(force), marker="*", markersize=10, color=INK, linestyle="", zorder=5)
        axes.annotate(f"printed: {words}", (ratio, float(scale(force))), xytext=(8, 4), textcoords="offset points",
                      va="center", fontsize=7.5, zorder=4)  # fmt: skip
    if not (signs or points):
        axes.text(0.5, 0.9, "neither sign nor number is printed", transform=axes.transAxes, ha="center", fontsize=7.5)
    if not forces.size:
        axes.set_yticks([0.0])
        axes.set_ylabel("drawbar force [N]\n(no scale printed)")
    caption(figure, "The text says: " + "; ".join(f"{o.statement} ({o.name})" for o in outcomes) + ".")
    return figure


def _half_plane(axes: Axes, ratio: float, sign: int, largest: float) -> None:
    """The half of the axes at a speed ratio where the force lies; a band at zero if it is about none."""
    half = 0.14
    low, high, colour, words = {
        1: (0.0, largest, POSITIVE, "positive"),
        0: (-0.06 * largest, 0.06 * largest, ZERO, "about zero"),
        -1: (-largest, 0.0, NEGATIVE, "negative"),
    }[sign]
    axes.fill_between([ratio - half, ratio + half], low, high, color=colour, linewidth=0, zorder=0)
    across = blended_transform_factory(axes.transData, axes.transAxes)
    at = {1: 0.97, 0: 0.40, -1: 0.03}[sign]
    axes.text(ratio, at, words, transform=across, ha="center", va="top" if sign > 0 else "bottom", fontsize=7.5)
    if sign:
        arrow = {"arrowstyle": "->", "color": INK, "linewidth": 0.9, "shrinkA": 0, "shrinkB": 0}
        axes.annotate("", (ratio, 0.78 * sign * largest), (ratio, 0.62 * sign * largest), arrowprops=arrow)


@style()
def width_sweep(
    cells: xr.Dataset | xr.DataArray, forces: xr.Dataset | None = None, *, title: str = "", width: float = 7.0
) -> Figure:
    """Whether each cell (load × speed ratio) of each outcome holds, against the wheel's width; and the forces.

    Parameters
    ----------
    cells
        One or several variables over ``wheel_width``, ``load_ratio`` and ``speed_ratio``: 1 where the
        outcome is reproduced, 0 where it is not, NaN where it says nothing.
    forces
        Drawbar forces [N] over the same dimensions, drawn below.
    """
    outcomes = cells.to_dataset(name=str(cells.name or "outcome")) if isinstance(cells, xr.DataArray) else cells
    labels, rows, breaks = _rows(outcomes)
    shown_width = shown(outcomes["wheel_width"], name="wheel width")
    names = [str(n) for n in forces.data_vars] if forces is not None else []
    columns = 2 if width >= 5.0 else 1
    below = -(-len(names) // columns)
    tall = 0.13 * len(labels) + 0.4
    figure = new_figure(width, tall + 2.1 * below + 0.7)
    grid = figure.add_gridspec(1 + below, columns, height_ratios=[tall] + [2.0] * below)
    axes = figure.add_subplot(grid[0, :])
    edges = _edges(shown_width.values)
    axes.pcolormesh(edges, np.arange(len(labels) + 1), np.ma.masked_invalid(rows),
                    cmap=ListedColormap([FAILED, HELD]), vmin=0, vmax=1, edgecolors="white", linewidth=0.3)  # fmt: skip
    axes.set_facecolor(SILENT)
    axes.set_yticks(np.arange(len(labels)) + 0.5, labels, fontsize=6.5)
    axes.tick_params(axis="y", length=0)
    axes.invert_yaxis()
    for at in breaks:
        axes.axhline(at, color=INK, linewidth=0.8)
    _assumed(axes)
    axes.set(xlabel=shown_width.label, ylabel="outcome: load, speed ratio [1]", title=title)
    handles = [Patch(color=HELD, label="reproduced"), Patch(color=FAILED, label="not reproduced"),
               axes.lines[-1]]  # fmt: skip
    figure.legend(handles=handles, loc="outside upper left", ncols=3 if width >= 5.0 else 2)
    first: Axes | None = None
    for i, name in enumerate(names):
        assert forces is not None
        first = _forces(figure.add_subplot(grid[1 + i // columns, i % columns], sharey=first), forces[name]) or first
    return figure


def _rows(outcomes: xr.Dataset) -> tuple[list[str], np.ndarray, list[int]]:
    """A row for each cell that an outcome judges, with its label, and where one outcome ends."""
    labels, rows, breaks = [], [], []
    for name, cells in outcomes.data_vars.items():
        breaks.append(len(labels))
        for load in cells["load_ratio"].values:
            for ratio in cells["speed_ratio"].values:
                row = cells.sel(load_ratio=load, speed_ratio=ratio).transpose("wheel_width").values
                if np.isfinite(row).any():
                    labels.append(f"{name}: {load:g} W, {ratio:g}")
                    rows.append(row)
    return labels, np.array(rows, dtype=float).reshape(len(labels), -1), breaks[1:]


def _forces(axes: Axes, force: xr.DataArray) -> Axes:
    """Force against width: a colour for each load, a dash for each speed ratio."""
    y, x = shown(force), shown(force["wheel_width"], name="wheel width")
    zero_line(axes)
    for ratio, dash in zip(force["speed_ratio"].values, ("-", "--", ":", "-."), strict=False):
        for load, colour in zip(force["load_ratio"].values, COLOURS, strict=False):
            line = force.sel(load_ratio=load, speed_ratio=ratio).transpose("wheel_width")
            label = f"{load:g} W" if dash == "-" else None
            axes.plot(x.values, y(line), color=colour, linestyle=dash, linewidth=1.1, label=label)
        middle = float(y(force.sel(speed_ratio=ratio).isel(wheel_width=-1).mean()))
        axes.annotate(number(ratio), (1.0, middle), xycoords=("axes fraction", "data"), xytext=(3, 0),
                      textcoords="offset points", va="center", fontsize=7, annotation_clip=False)  # fmt: skip
    _assumed(axes)
    words = str(force.name).removeprefix("drawbar_force").strip("_")
    axes.set(xlabel=x.label, ylabel=f"drawbar force [{y.unit}]", xlim=(x.values.min(), x.values.max()))
    axes.set_title(f"{words or 'forces'}; right: speed ratio")
    handles = [line for line in axes.lines if str(line.get_label()).endswith(" W")]
    axes.legend(handles=handles, loc="upper left", title="normal load")
    return axes


def _assumed(axes: Axes) -> None:
    axes.axvline(ASSUMED["wheel_width"].value * 1e3, color=INK, linestyle="--", linewidth=0.9,
                 label="assumed here, not printed")  # fmt: skip


def _edges(centres: np.ndarray) -> np.ndarray:
    middle = 0.5 * (centres[1:] + centres[:-1])
    step = np.diff(centres) if centres.size > 1 else np.ones(1)
    return np.concatenate([[centres[0] - 0.5 * step[0]], middle, [centres[-1] + 0.5 * step[-1]]])


@style()
def tension_error(dataset: xr.Dataset, *, title: str = "", width: float = 7.0) -> Figure:
    """Relative error in sinkage and drawbar force made by dropping the tension T, against ℓ/r.

    Parameters
    ----------
    dataset
        ``sinkage_error`` and ``drawbar_force_error`` [1] over ``decay_ratio`` and ``load_ratio``.
    """
    names = [n for n in ("sinkage_error", "drawbar_force_error") if n in dataset]
    if not names:
        raise ValueError("the data set has neither sinkage_error nor drawbar_force_error over decay_ratio.")
    columns = len(names) if width >= 5.0 else 1
    rows = -(-len(names) // columns)
    figure = new_figure(width, 2.3 * rows + 0.5)
    panels = figure.subplots(rows, columns, sharex=True, squeeze=False).reshape(-1)
    ratio = dataset["decay_ratio"].values
    for axes, name in zip(panels, names, strict=True):
        if bool((dataset[name] > 0.0).all()):
            axes.set_yscale("log")
            axes.yaxis.set_major_formatter(lambda value, _: number(value))
        else:
            zero_line(axes)
        for load, colour in zip(dataset["load_ratio"].values, COLOURS, strict=False):
            error = dataset[name].sel(load_ratio=load).transpose("decay_ratio")
            axes.plot(ratio, 100.0 * error, color=colour, label=f"{load:g} W")
        axes.set(xscale="log", ylabel=f"{name.replace('_', ' ')} [%]")
    for axes in panels[-columns:]:
        axes.set_xlabel("decay length over radius ℓ/r = sqrt(T/k)/r [1]")
    panels[0].set_title(title)
    legend(figure, panels[0], "normal load")
    return figure

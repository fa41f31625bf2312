"""Figures of a rig's runs: drawbar force over speed ratio and load, and the time history of a run."""

from __future__ import annotations

import numpy as np
import xarray as xr
from matplotlib.colors import TwoSlopeNorm
from matplotlib.figure import Figure
from matplotlib.ticker import MaxNLocator

from drawbar.study.compare.condition import describe, runs
from drawbar.study.identify.reduce import SETTLING, run_starts
from drawbar.variables import OBSERVATION, tidy
from drawbar.view.curves import abscissa, curves, draw, repeated, scales
from drawbar.view.style import COLOURS, INK, Shown, caption, legend, new_figure, number, shown, style, zero_line

__all__ = ["drawbar_curves", "history", "steady_map"]

SETTINGS = ("normal_load", "slide_speed", "speed_ratio")


@style()
def drawbar_curves(
    dataset: xr.Dataset,
    *,
    quantity: str = "drawbar_force",
    weight: float | None = None,
    title: str = "",
    note: str = "",
    width: float = 3.5,
) -> Figure:
    """Drawbar force against speed ratio, one curve for each normal load.

    A model's map is drawn as lines; repeated runs as points with 95 % intervals of their mean (Student
    t). Runs that have no several speed ratios, such as locked drags, are drawn along the slide speed.

    Parameters
    ----------
    dataset
        A map, or runs of a rig.
    weight
        The robot's weight W [N], to label loads with; taken from the attribute ``weight`` if it is there.
    title, note
        Over and under the axes.
    width
        Of the figure [in]: 3.5 for a column, 7 for a page.
    """
    rows = runs(dataset)
    along = abscissa(rows)
    found = curves(dataset, quantity, along, weight)
    x, y = scales(dataset, quantity, along, found)
    figure = new_figure(width, 0.62 * min(width, 5.0) + 0.5)
    axes = figure.add_subplot()
    zero_line(axes)
    draw(axes, found, x, y, points=repeated(rows))
    axes.set(xlabel=_x_label(x), ylabel=y.label, title=title)
    axes.xaxis.set_major_locator(MaxNLocator(6, steps=[1, 2, 5, 10]))
    if len(found) > 1 or found[0].label:
        legend(figure, axes, "normal load" if "N" in found[0].label else "")
    bars = "Points: mean of the repeats; bars: 95 % interval of the mean." if repeated(rows) else ""
    left_out = int(np.sum(~np.isfinite(rows[along].values)))
    locked = f"Without a {along.replace('_', ' ')}, as locked wheels are, and not drawn: {left_out} runs." * bool(
        left_out
    )
    if note or bars or locked:
        caption(figure, " ".join(filter(None, (note, bars, locked))))
    return figure


def _x_label(x: Shown) -> str:
    return "speed ratio v/(rω) [1]" if x.name == "speed ratio" else x.label


@style()
def steady_map(dataset: xr.Dataset, *, quantity: str = "drawbar_force", title: str = "", width: float = 3.5) -> Figure:
    """Drawbar force over speed ratio and normal load as filled contours; the black line is zero.

    Raises
    ------
    ValueError
        The Dataset is not a map over exactly these two with at least two values of each.
    """
    field = dataset[quantity].squeeze()
    if set(field.dims) != {"speed_ratio", "normal_load"} or min(field.shape) < 2:
        raise ValueError(
            f"a map needs {quantity} over speed_ratio and normal_load, two values of each at least; it has "
            f"{dict(field.sizes)}. Evaluate drawbar.steady with drawbar.grid(normal_load=[...], speed_ratio=[...])."
        )
    field = field.transpose("normal_load", "speed_ratio")
    z, load = shown(field), shown(field["normal_load"])
    low, high = float(np.min(z.values)), float(np.max(z.values))
    largest = max(abs(low), abs(high)) or 1.0
    levels = MaxNLocator(20).tick_values(low, high) if high > low else np.array([low - largest, low + largest])
    figure = new_figure(width, 0.7 * min(width, 5.0) + 0.3)
    axes = figure.add_subplot()
    x = field["speed_ratio"].values
    filled = axes.contourf(
        x, load.values, z.values, levels=levels, cmap="RdBu", norm=TwoSlopeNorm(0, -largest, largest)
    )
    if low < 0.0 < high:
        axes.contour(x, load.values, z.values, levels=[0.0], colors=INK, linewidths=1.2)
    bar = figure.colorbar(filled, ax=axes, pad=0.02, ticks=MaxNLocator(7), spacing="proportional")
    bar.set_label(z.label)
    axes.set(xlabel="speed ratio v/(rω) [1]", ylabel=load.label, title=title)
    return figure


@style()
def history(dataset: xr.Dataset, *, run: int = 0, title: str = "", width: float = 3.5) -> Figure:
    """Drawbar force and sinkage of one run against time, with the running and the steady mean.

    Parameters
    ----------
    dataset
        A time history of the rig, or a transient.
    run
        Which of its runs, from 0.

    Raises
    ------
    ValueError
        The Dataset has no time, or not so many runs.
    """
    if "time" not in dataset.variables:
        raise ValueError("the data set has no time. Make a time history with drawbar.drawbar_test(..., history=True).")
    rows = tidy(dataset)
    of_run = np.cumsum(run_starts({str(n): v.values for n, v in rows.variables.items()})) - 1
    if not 0 <= run <= int(of_run.max()):
        raise ValueError(f"run must be between 0 and {int(of_run.max())}, got {run}.")
    rows = rows.isel({OBSERVATION: of_run == run})
    steady = runs(rows)
    names = [n for n in ("drawbar_force", "sinkage") if n in rows]
    figure = new_figure(width, 0.35 * min(width, 5.0) * len(names) + 0.9)
    panels = figure.subplots(len(names), 1, sharex=True, squeeze=False)[:, 0]
    time = rows["time"].values
    window = 0.05 * (time[-1] - time[0])
    for axes, name in zip(panels, names, strict=True):
        y = shown(rows[name])
        axes.axvspan(time[0], time[0] + SETTLING * (time[-1] - time[0]), color="#eeeeee", zorder=0, linewidth=0)
        zero_line(axes)
        axes.plot(time, y.values, color=COLOURS[5], linewidth=0.6, label="samples")
        axes.plot(time, _running_mean(time, y.values, window), color=COLOURS[0], label=f"running mean, {window:.2g} s")
        mean = float(y(steady[name].values)[0])
        axes.axhline(mean, color=COLOURS[1], linestyle="--", linewidth=1.0, label="steady mean")
        axes.set_ylabel(y.label)
        axes.set_title(f"steady mean {number(mean)} {y.unit}", loc="right", color=COLOURS[1], fontsize=7.5)
    panels[-1].set_xlabel("time [s]")
    panels[0].set_title(title)
    legend(figure, panels[0])
    damping = dataset.attrs.get("damping", "what damps the settling is not stated")
    settings = ", ".join(describe(steady, n).replace("_", " ") for n in SETTINGS if n in steady)
    one = f"Run {run + 1} of {int(of_run.max()) + 1}: " if of_run.max() > 0 else ""
    which = f"{_capital(one + settings)}. " if settings else ""
    caption(figure, f"{which}{_capital(damping)}. Grey: the first quarter, left out of the steady mean.")
    return figure


def _running_mean(time: np.ndarray, values: np.ndarray, window: float) -> np.ndarray:
    """The mean over ``window`` seconds around each sample, over what there is of it at the ends."""
    total = np.concatenate([[0.0], np.cumsum(values)])
    first = np.searchsorted(time, time - 0.5 * window, side="left")
    last = np.searchsorted(time, time + 0.5 * window, side="right")
    return (total[last] - total[first]) / (last - first)


def _capital(text: str) -> str:
    return text[:1].upper() + text[1:]

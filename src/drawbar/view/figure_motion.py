"""Figure of a transient: the equations of motion from touch-down, with the energy ledger."""

from __future__ import annotations

import numpy as np
import xarray as xr
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from drawbar.view.style import COLOURS, INK, Shown, caption, new_figure, shown, style, zero_line

__all__ = ["simulation"]

PANELS = ("sinkage", "drawbar_force", "travel", "slide_speed", "rotation", "wheel_torque")

PUT_IN = ("motor_work", "load_work")
FOUND = {
    "drawbar_work": "drawbar work",
    "film_heat": "film heat",
    "tissue_heat": "tissue heat",
    "damper_heat": "damper heat",
    "elastic_energy": "elastic, change",
    "kinetic_energy": "kinetic, change",
}
"""Where the work goes; of the last two what changed since the start."""


@style()
def simulation(dataset: xr.Dataset, *, title: str = "", width: float = 7.0) -> Figure:
    """Sinkage, drawbar force, travel, speed, rotation and torque against time, and the energy ledger.

    Raises
    ------
    ValueError
        The Dataset is not a transient with its ledger.
    """
    needed = {*PANELS, *PUT_IN, *FOUND, "ledger_error"} - {"tissue_heat"}  # an elastic tissue makes none
    missing = sorted(n for n in needed if n not in dataset)
    if missing:
        raise ValueError(f"the data set has no {', '.join(missing)}. Give what drawbar.simulate returns.")
    columns = 2 if width >= 5.0 else 1
    rows = len(PANELS) // columns
    figure = new_figure(width, 1.15 * rows + 2.6)
    grid = figure.add_gridspec(rows + 1, columns, height_ratios=[1.0] * rows + [1.7])
    time = dataset["time"].values
    first: Axes | None = None
    for i, name in enumerate(PANELS):
        axes = figure.add_subplot(grid[i // columns, i % columns], sharex=first)
        first = first or axes
        y = shown(dataset[name])
        zero_line(axes)
        axes.plot(time, y.values, color=COLOURS[0], linewidth=1.1)
        axes.set_ylabel(f"{y.name}\n[{y.unit}]")
        axes.tick_params(labelbottom=i >= len(PANELS) - columns)
        _room(axes, y)
    ledger = figure.add_subplot(grid[rows, :], sharex=first)
    error = _ledger(ledger, dataset)
    for axes in figure.axes[-columns - 1 :]:
        axes.set_xlabel("time [s]")
    if title:
        figure.suptitle(title, x=0.01, ha="left")
    figure.align_ylabels()
    damping = str(dataset.attrs.get("damping", "what damps the settling is not stated"))
    caption(figure, f"{damping[:1].upper()}{damping[1:]}. {error}")
    return figure


def _room(axes: Axes, y: Shown) -> None:
    """A line that is constant but for rounding is not magnified until the rounding fills the panel."""
    size = float(np.max(np.abs(y.values)))
    if size > 0.0 and np.ptp(y.values) < 1e-6 * size:
        axes.set_ylim(min(0.0, 1.2 * float(np.min(y.values))), max(0.0, 1.2 * float(np.max(y.values))))


def _ledger(axes: Axes, dataset: xr.Dataset) -> str:
    """What was put in as a line, and where it went as lines that add up to it; the error in words."""
    time = dataset["time"].values
    put_in = sum(dataset[n].values for n in PUT_IN)
    found = {
        n: dataset[n].values - (dataset[n].values[0] if n.endswith("energy") else 0.0) for n in FOUND if n in dataset
    }
    y = Shown(np.concatenate([put_in, *found.values()]), "J", "work, energy")
    zero_line(axes)
    axes.plot(time, y(put_in), color=INK, linewidth=2.2, label="motor + load work")
    axes.plot(time, y(sum(found.values())), color=COLOURS[4], linestyle=(0, (2, 2)), label="where it went, sum")
    for (name, label), colour in zip(FOUND.items(), (*COLOURS[:4], *COLOURS[5:7]), strict=True):
        if name in found and np.any(found[name]):
            axes.plot(time, y(found[name]), color=colour, linewidth=1.1, label=label)
    axes.set(ylabel=y.label, title="energy ledger")
    narrow = axes.get_figure(root=True).get_figwidth() < 5.0  # type: ignore[union-attr]
    axes.legend(loc="upper center", bbox_to_anchor=(0.5, -0.28), ncols=2 if narrow else 4)
    error, most = float(np.max(np.abs(dataset["ledger_error"].values))), Shown(np.max(np.abs(put_in)), "J", "put in")
    share = error / (float(most.values) / most.factor)
    return f"Ledger error at most {error:.2g} J, {share:.2g} of the {float(most.values):.3g} {most.unit} put in."

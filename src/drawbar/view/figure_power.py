"""Where the power goes."""

from __future__ import annotations

import numpy as np
import xarray as xr
from matplotlib.figure import Figure

from drawbar.view.style import COLOURS, INK, caption, legend, new_figure, style, zero_line

__all__ = ["power_split"]

PARTS = {"film_loss": "film", "tissue_loss": "tissue", "drawbar_power": "drawbar"}


@style()
def power_split(dataset: xr.Dataset, *, title: str = "", width: float = 3.5) -> Figure:
    """Motor power as the sum of what the film and the tissue lose and what the drawbar gets, stacked.

    Negative drawbar power is what the carriage puts in to push the wheel: it stands below the line, and the
    losses above it exceed the motor's power by as much.

    Parameters
    ----------
    dataset
        A steady map over ``speed_ratio`` alone.
    """
    dims = dataset["motor_power"].dims
    if dims != ("speed_ratio",):
        raise ValueError(
            f"the powers vary over {', '.join(map(str, dims)) or 'nothing'}; this figure takes one "
            "load and several speed ratios. Select the rest, for example dataset.isel(normal_load=0)."
        )
    figure = new_figure(width, 0.75 * width)
    axes = figure.add_subplot()
    ratio = dataset["speed_ratio"].values
    above = np.zeros(ratio.size)
    for (name, label), colour in zip(PARTS.items(), COLOURS, strict=False):
        power = dataset[name].values * 1e3
        up = np.maximum(power, 0.0)
        axes.fill_between(ratio, above, above + up, color=colour, alpha=0.75, linewidth=0, label=label)
        axes.fill_between(ratio, np.minimum(power, 0.0), 0.0, color=colour, alpha=0.75, linewidth=0)
        above = above + up
    axes.plot(ratio, dataset["motor_power"].values * 1e3, color=INK, label="motor")
    axes.set(xlabel="speed ratio v/(rω) [1]", ylabel="power [mW]", xlim=(ratio.min(), ratio.max()), title=title)
    zero_line(axes)
    legend(figure, axes, "")
    parts = dataset[list(PARTS)].to_array().sum("variable")
    error = float(abs(dataset["motor_power"] - parts).max() / abs(parts).max())
    caption(figure, f"Below zero: the carriage pushes. The ledger closes to {error:.0e} of the largest power.")
    return figure

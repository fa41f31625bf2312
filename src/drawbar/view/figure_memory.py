"""What a tissue's memory does to the signs of the paper's liver."""

from __future__ import annotations

import numpy as np
import xarray as xr
from matplotlib.colors import BoundaryNorm
from matplotlib.figure import Figure

from drawbar.sources.rentschler_2004 import ASSUMED
from drawbar.view.style import COLOURS, INK, caption, legend, new_figure, style, zero_line

__all__ = ["memory_sweep"]


@style()
def memory_sweep(dataset: xr.Dataset, *, title: str = "", width: float = 7.0) -> Figure:
    """How many of the nine forces are negative over exponent and film, and the forces at one film.

    Parameters
    ----------
    dataset
        ``negative`` over ``exponent`` and ``viscous_coefficient``, ``drawbar_force`` [N] also over
        ``load_ratio`` and ``speed_ratio``.
    """
    side_by_side = width >= 5.0
    figure = new_figure(width, 3.4 if side_by_side else 6.0)
    left, right = figure.subplots(1, 2) if side_by_side else figure.subplots(2, 1)
    count = dataset["negative"].transpose("viscous_coefficient", "exponent")
    norm = BoundaryNorm(np.arange(-0.5, 10.0), 256)
    mesh = left.pcolormesh(
        np.arange(count.exponent.size),
        count.viscous_coefficient,
        count.values,
        norm=norm,
        cmap="cividis",
        shading="nearest",
    )
    left.set(yscale="log", xlabel="exponent of the power law α [1]", ylabel="film coefficient µ/h [Pa s/m]")
    left.set_xticks(np.arange(count.exponent.size), [f"{a:g}" for a in count.exponent.values])
    left.axhline(ASSUMED["foam_viscous_coefficient"].value, color=INK, linestyle="--", linewidth=0.9)
    figure.colorbar(mesh, ax=left, ticks=np.arange(10), label="negative forces of nine [1]")
    left.set_title(title)
    assumed = dataset.sel(
        viscous_coefficient=ASSUMED["foam_viscous_coefficient"].value, load_ratio=1.0, method="nearest"
    )
    shown = [a for a in (0.0, 0.05, 0.1, 0.2, 0.3) if a in dataset["exponent"].values]
    for exponent, colour in zip(shown, COLOURS, strict=False):
        force = assumed["drawbar_force"].sel(exponent=exponent)
        right.plot(force.speed_ratio, force * 1e3, marker="o", color=colour, label=f"α = {exponent:g}")
    right.set(xlabel="speed ratio v/(rω) [1]", ylabel="drawbar force at N = W [mN]", xticks=dataset.speed_ratio.values)
    zero_line(right)
    legend(figure, right, "")
    caption(
        figure,
        f"{dataset.attrs['tissue'].capitalize()}, smooth wheel, width {dataset.attrs['wheel_width'] * 1e3:g} mm. Every "
        f"exponent gives the printed stiffness to a plate read after {dataset.attrs['reading_time']:g} s (assumed). "
        "Dashed: the assumed film, as on the right.",
    )
    return figure

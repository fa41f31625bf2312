"""Figure of a comparison: model against data, with what a factor or an offset would make of it."""

from __future__ import annotations

import numpy as np
import xarray as xr
from matplotlib.figure import Figure

from drawbar.study.compare.comparison import Comparison
from drawbar.view.curves import load_label
from drawbar.view.style import COLOURS, GREY, INK, MARKERS, Shown, caption, legend, new_figure, number, shown, style

__all__ = ["comparison"]


@style()
def comparison(result: Comparison, *, weight: float | None = None, title: str = "", width: float = 3.5) -> Figure:
    """The data of each condition against the model's, with 95 % bars, and the lines of the three relations.

    Points on the line of equality agree; on the scaled line they differ by a factor, on the shifted one
    by an offset. The verdict is the caption.
    """
    table = result.table
    units = {"units": result.unit}
    both = np.concatenate([_ends(table, "model"), _ends(table, "data")])
    name = result.quantity.replace("_", " ")
    scale = shown(xr.DataArray(both, name=name, attrs=units))
    figure = new_figure(width, 0.8 * min(width, 4.5) + 1.2)
    axes = figure.add_subplot()
    for level in (axes.axhline, axes.axvline):
        level(0.0, color="#dddddd", linewidth=0.6, zorder=0)
    _lines(axes, result, scale)
    groups = _groups(table, weight)
    for i, (label, here) in enumerate(groups.items()):
        bars = {
            side: np.nan_to_num(scale(table[f"{side}_interval"].values[here]), nan=0.0) for side in ("model", "data")
        }
        axes.errorbar(
            scale(table["model"].values[here]), scale(table["data"].values[here]), xerr=bars["model"],
            yerr=bars["data"], linestyle="", color=COLOURS[i % len(COLOURS)], marker=MARKERS[i % len(MARKERS)],
            label=label, zorder=3,
        )  # fmt: skip
    axes.set(xlabel=f"model: {scale.label}", ylabel=f"data: {scale.label}", title=title)
    legend(figure, axes)
    caption(figure, result.verdict)
    return figure


def _ends(table: xr.Dataset, side: str) -> np.ndarray:
    half = np.nan_to_num(table[f"{side}_interval"].values, nan=0.0)
    return np.concatenate([table[side].values - half, table[side].values + half])


def _lines(axes: object, result: Comparison, scale: Shown) -> None:
    """data = model, data = s model, data = model + b, over the model's range and zero."""
    x = np.array([min(0.0, float(result.table["model"].min())), max(0.0, float(result.table["model"].max()))])
    s, b = result.scale.value, result.offset.value
    lines = [(x, INK, "-", "equal")]
    if np.isfinite(s):
        lines.append((s * x, GREY, "--", f"scaled, s = {number(s)}"))
    shift = shown(xr.DataArray(b, name="offset", attrs={"units": result.unit}))
    lines.append((x + b, GREY, ":", f"shifted, b = {number(float(shift.values))} {shift.unit}"))
    for y, colour, dash, label in lines:
        axes.plot(scale(x), scale(y), color=colour, linestyle=dash, linewidth=1.0, label=label)  # type: ignore[attr-defined]


def _groups(table: xr.Dataset, weight: float | None) -> dict[str, np.ndarray]:
    """Conditions by the load, or by a label, if there are few enough to tell colours apart."""
    for name in ("normal_load", "wheel", "tissue"):
        if name not in table.coords:
            continue
        values = table[name].values
        distinct = np.unique(values)
        if 1 < distinct.size <= len(COLOURS):
            return {load_label(v, weight) if name == "normal_load" else str(v): values == v for v in distinct}
    return {"conditions": np.ones(table.sizes["condition"], dtype=bool)}

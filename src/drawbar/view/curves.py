"""A rig's runs as curves: one for each load, a line where a model was asked, points where runs were repeated."""

from __future__ import annotations

import dataclasses

import numpy as np
import xarray as xr
from matplotlib import colormaps
from matplotlib.axes import Axes

from drawbar.study.compare.agreement import mean_interval
from drawbar.study.compare.condition import runs
from drawbar.variables import VARIABLES
from drawbar.view.style import COLOURS, MARKERS, Shown, shown

__all__ = ["Curve", "abscissa", "clustered", "curves", "draw", "load_label", "repeated", "scales"]

GAP = 0.05
"""Measured settings that lie closer than this share of their size are one setting."""

GROUPING = ("wheel", "tissue", "normal_load", "slide_speed", "speed_ratio", "wheel_speed", "wheel_width")


@dataclasses.dataclass(frozen=True)
class Curve:
    """Means over ``x`` in SI, with the half width of their 95 % interval (NaN without repeats)."""

    label: str
    x: np.ndarray
    mean: np.ndarray
    half: np.ndarray


def repeated(rows: xr.Dataset) -> bool:
    """Whether runs were repeated: they then are measurements, and are drawn as points."""
    return "trial" in rows and len(set(rows["trial"].values.tolist())) > 1


def abscissa(rows: xr.Dataset) -> str:
    """The setting to draw along: the first that has several values."""
    for name in ("speed_ratio", "slide_speed", "wheel_speed", "normal_load"):
        if name in rows:
            codes = _clustered(rows, name)
            if np.unique(codes[codes >= 0.0]).size > 1:
                return name
    return "speed_ratio" if "speed_ratio" in rows and np.isfinite(rows["speed_ratio"].values).any() else "slide_speed"


def load_label(load: float, weight: float | None) -> str:
    """A load in newtons and, where the weight is known, in units of it."""
    times = f" ({load / weight:.3g} W)" if weight else ""
    return f"{load:.3g} N{times}"


def curves(dataset: xr.Dataset, quantity: str, x: str | None = None, weight: float | None = None) -> list[Curve]:
    """Every combination of the other settings as one curve along ``x``.

    Raises
    ------
    ValueError
        The quantity is not in the Dataset.
    """
    rows = runs(dataset)
    if quantity not in rows:
        has = ", ".join(str(n) for n in rows.data_vars)
        raise ValueError(f"the data set has no {quantity} to draw. It has: {has}.")
    x = x or abscissa(rows)
    weight = weight or rows.attrs.get("weight")
    implied = {"speed_ratio": {"wheel_speed"}, "wheel_speed": {"speed_ratio"}}.get(x, {"speed_ratio", "wheel_speed"})
    if x == "slide_speed" and np.isnan(rows.get("speed_ratio", xr.DataArray([0.0])).values).all():
        implied = {"speed_ratio"}
    codes = {n: _clustered(rows, n) for n in GROUPING if n in rows and n != x and n not in implied}
    varying = [n for n, c in codes.items() if np.unique(c).size > 1]
    if not varying and "normal_load" in codes:
        varying = ["normal_load"]
    key = np.stack([codes[n] for n in varying], axis=1) if varying else np.zeros((rows[quantity].size, 1))
    along, values = _clustered(rows, x), rows[quantity].values.astype(float)
    found = []
    for one in np.unique(key, axis=0):
        here = np.all(key == one, axis=1) & np.isfinite(rows[x].values.astype(float))
        steps = np.unique(along[here])
        if not steps.size:
            continue
        means = np.array([mean_interval(values[here & (along == step)]) for step in steps])
        at = np.array([np.mean(rows[x].values[here & (along == step)]) for step in steps])
        label = ", ".join(_label(rows, n, here, weight) for n in varying)
        found.append(Curve(label, at, means[:, 0], means[:, 1]))
    return found


def draw(axes: Axes, found: list[Curve], x: Shown, y: Shown, *, points: bool) -> None:
    """Curves in the units of the axes. Of more than there are colours, shades from dark to light, five are named."""
    many = len(found) > len(COLOURS)
    shades = colormaps["cividis"](np.linspace(0.0, 0.9, len(found)))
    named = set(np.linspace(0, len(found) - 1, 5).round().astype(int).tolist()) if many else set(range(len(found)))
    for i, curve in enumerate(found):
        colour = tuple(shades[i]) if many else COLOURS[i]
        marker = MARKERS[i % len(MARKERS)]
        label = curve.label if i in named and curve.label else None
        if not points:
            mark = marker if curve.x.size <= 12 and not many else ""
            axes.plot(x(curve.x), y(curve.mean), color=colour, marker=mark, label=label)
            continue
        half = np.nan_to_num(y(curve.half), nan=0.0)
        axes.errorbar(
            x(curve.x), y(curve.mean), yerr=half, color=colour, marker=marker, linestyle=":", linewidth=0.8, label=label
        )


def scales(dataset: xr.Dataset, quantity: str, x: str, found: list[Curve]) -> tuple[Shown, Shown]:
    """The units of both axes, from all there is to draw."""
    across = np.concatenate([c.x for c in found]) if found else np.zeros(1)
    up = (
        np.concatenate([np.concatenate([c.mean - _bars(c), c.mean + _bars(c)]) for c in found])
        if found
        else np.zeros(1)
    )
    units = {n: VARIABLES[n].unit if n in VARIABLES else str(dataset[n].attrs.get("units", "1")) for n in (x, quantity)}
    return (
        shown(xr.DataArray(across, name=x, attrs={"units": units[x]})),
        shown(xr.DataArray(up, name=quantity, attrs={"units": units[quantity]})),
    )


def _bars(curve: Curve) -> np.ndarray:
    return np.nan_to_num(curve.half, nan=0.0)


def _clustered(rows: xr.Dataset, name: str) -> np.ndarray:
    return clustered(rows[name].values, GAP if repeated(rows) else 1e-9)


def clustered(values: np.ndarray, gap: float = GAP) -> np.ndarray:
    """A number for each value, the same for values with no gap between them; -1 for what is not finite.

    A gap is relative to the larger of its two ends, and near zero to a tenth of the largest magnitude.
    Names get a number each.

    >>> clustered(np.array([0.50, 1.0, 0.51, np.nan])).tolist()
    [0.0, 1.0, 0.0, -1.0]
    """
    if values.dtype.kind not in "fiu":
        return np.unique(values.astype(str), return_inverse=True)[1].astype(float)
    finite = np.flatnonzero(np.isfinite(values))
    order = finite[np.argsort(values[finite], kind="stable")]
    rising = values[order].astype(float)
    size = np.maximum(np.abs(rising), 0.1 * np.max(np.abs(rising), initial=0.0))
    apart = np.diff(rising) > gap * np.maximum(size[1:], size[:-1])
    code = np.full(values.size, -1.0)
    code[order] = np.concatenate([np.zeros(min(1, order.size)), np.cumsum(apart)])
    return code


def _label(rows: xr.Dataset, name: str, here: np.ndarray, weight: float | None) -> str:
    values = rows[name].values[here]
    if values.dtype.kind not in "fiu":
        return str(values[0])
    low, high = float(np.min(values)), float(np.max(values))
    if name == "normal_load":
        scattered = high - low > 0.02 * abs(high)
        return f"{low:.3g} to {high:.3g} N" if scattered else load_label(float(np.mean(values)), weight)
    scaled = shown(xr.DataArray(values, name=name, attrs={"units": VARIABLES[name].unit}))
    unit = "" if scaled.unit == "1" else f" {scaled.unit}"
    word = {"slide_speed": "", "speed_ratio": "speed ratio ", "wheel_speed": "", "wheel_width": "width "}[name]
    return f"{word}{float(np.mean(scaled.values)):.3g}{unit}"

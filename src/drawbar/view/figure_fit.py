"""Figures of identifications: pressure against deflection, and a film's shear stress against slip."""

from __future__ import annotations

import numpy as np
import xarray as xr
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from drawbar.study.identify.fit import Estimate, Fit
from drawbar.view.curves import clustered, load_label
from drawbar.view.style import COLOURS, GREY, INK, MARKERS, Shown, caption, legend, new_figure, shown, style, zero_line

__all__ = ["film_fit", "stiffness_fit"]

SYMBOLS = {"stiffness": "k", "viscous_coefficient": "µ/h", "yield_stress": "τ₀", "friction_coefficient": "µc"}


@style()
def stiffness_fit(*fits: Fit, title: str = "", width: float = 3.5) -> Figure:
    """Pressure against deflection with the fitted line, one colour for each fit, one marker for each set.

    A wheel pressed in is drawn as its load against the sinkage. Like the paper's Fig. 8.

    Raises
    ------
    ValueError
        There is no fit, or fits of plates and of wheels are mixed.
    """
    if not fits:
        raise ValueError("there is no fit to draw. Give what drawbar.identify_stiffness returns.")
    load = "contact_pressure" if "contact_pressure" in fits[0].data else "normal_load"
    if any(load not in fit.data for fit in fits):
        raise ValueError("plate tests and wheels do not share axes. Draw them apart.")
    figure = new_figure(width, 0.72 * min(width, 5.0) + 0.7)
    axes = figure.add_subplot()
    x = _scale([fit.data["measured"] for fit in fits], fits[0].fitted_to)
    y = _scale([fit.data[load] for fit in fits], load.replace("contact_", "").replace("_", " "))
    for i, fit in enumerate(fits):
        name = str(fit.data["tissue"].values[0]) if "tissue" in fit.data else f"fit {i + 1}" if len(fits) > 1 else ""
        _readings(axes, fit, x, y, load, COLOURS[i % len(COLOURS)], name)
    axes.set(xlabel=x.label, ylabel=y.label, title=title)
    axes.set_xlim(left=min(0.0, axes.get_xlim()[0]))
    axes.set_ylim(bottom=0.0)
    legend(figure, axes)
    trials = max(len(set(fit.data["trial"].values.tolist())) if "trial" in fit.data else 1 for fit in fits)
    caption(figure, "A marker for each set; " * (trials > 1) + "the line is the fit, with its 95 % interval above.")
    return figure


def _readings(axes: Axes, fit: Fit, x: Shown, y: Shown, load: str, colour: str, name: str) -> None:
    data = fit.data
    trial = data["trial"].values.astype(str) if "trial" in data else np.full(data["measured"].size, "")
    for i, one in enumerate(np.unique(trial)):
        here = trial == one
        axes.plot(x(data["measured"].values[here]), y(data[load].values[here]), linestyle="", color=colour, alpha=0.75,
                  marker=MARKERS[i % len(MARKERS)], fillstyle="none", markeredgewidth=0.9)  # fmt: skip
    order = np.argsort(data[load].values)
    along = np.concatenate([[0.0], data["fitted"].values[order]])
    up = np.concatenate([[0.0], data[load].values[order]])
    label = _estimate("stiffness", fit.estimates["stiffness"])
    axes.plot(x(along), y(up), color=colour, label=f"{name}: {label}" if name else label)


@style()
def film_fit(fit: Fit, *, weight: float | None = None, title: str = "", width: float = 3.5) -> Figure:
    """Mean shear stress on the contact against slip velocity, forward and reverse, by load, with the fit.

    In these axes all loads fall on one line, unless a friction coefficient was fitted. Like the
    paper's Fig. 7.
    """
    data = fit.data
    stress, slip, load = (data[n].values for n in ("shear_stress", "slip_velocity", "normal_load"))
    figure = new_figure(width, 0.72 * min(width, 5.0) + 1.2)
    axes = figure.add_subplot()
    x = shown(data["slip_velocity"], name="slip velocity, mean over the contact")
    y = shown(data["shear_stress"], name="shear stress")
    zero_line(axes)
    axes.axvline(0.0, color=GREY, linewidth=0.7, zorder=0.5)
    pressure = load * _per_area(data)
    group = clustered(load)
    loads = np.unique(group) if np.unique(group).size <= len(COLOURS) else np.array([])
    by_load = "friction_coefficient" in fit.values and loads.size > 1
    for i, one in enumerate(loads):
        here = group == one
        axes.plot(x(slip[here]), y(stress[here]), linestyle="", color=COLOURS[i], marker=MARKERS[i], fillstyle="none",
                  markeredgewidth=0.9, label=load_label(float(np.mean(load[here])), weight))  # fmt: skip
        if by_load:
            _law(axes, fit, x, y, slip, float(np.nanmean(pressure[here])), COLOURS[i], None)
    if not loads.size:
        axes.plot(x(slip), y(stress), linestyle="", color=COLOURS[0], marker="o", fillstyle="none", label="runs")
    if not by_load:
        _law(axes, fit, x, y, slip, float(np.nanmean(pressure)), INK, "fit")
    axes.set(xlabel=x.label, ylabel=y.label, title=title)
    legend(figure, axes, "normal load")
    found = "; ".join(_estimate(name, e) for name, e in fit.estimates.items())
    ways = " Left: dragged forward, right: in reverse; slip is against the drag." if np.ptp(np.sign(slip)) else ""
    caption(figure, f"{found} (95 % intervals).{ways}")
    return figure


def _per_area(data: xr.Dataset) -> np.ndarray:
    """One over the contact's projected area 2 L r sin φ [1/m²]: load times this is the mean pressure."""
    area = 2.0 * data["wheel_width"] * data["wheel_radius"] * np.sin(data["contact_half_angle"])
    return np.divide(1.0, area.values, out=np.full(area.size, np.nan), where=area.values > 0.0)


def _law(
    axes: Axes, fit: Fit, x: Shown, y: Shown, slip: np.ndarray, pressure: float, colour: str, label: str | None
) -> None:
    """τ = (τ₀ + µc p) sign V + (µ/h) V on each side of zero, as far as the runs go."""
    values = fit.values
    jump = values.get("yield_stress", 0.0) + values.get("friction_coefficient", 0.0) * pressure
    for end in (np.nanmin(slip), np.nanmax(slip)):
        if end == 0.0 or (end == np.nanmax(slip) and end < 0.0) or (end == np.nanmin(slip) and end > 0.0):
            continue
        v = np.array([0.0, end])
        axes.plot(x(v), y(np.sign(end) * jump + values["viscous_coefficient"] * v), color=colour, label=label)
        label = None


def _scale(columns: list[xr.DataArray], name: str) -> Shown:
    both = xr.concat([c.reset_coords(drop=True) for c in columns], "observation")
    return shown(both.assign_attrs(columns[0].attrs), name=name)


def _estimate(name: str, estimate: Estimate) -> str:
    """``k = 225 (215 to 236) kPa/m``."""
    unit, factor = estimate.quantity.unit, 1.0
    if unit.startswith("Pa") and abs(estimate.value) >= 1e3:
        unit, factor = f"k{unit}", 1e-3
    low, high = (f"{factor * v:.4g}" for v in estimate.interval)
    unit = "" if unit == "1" else f" {unit}"
    return f"{SYMBOLS.get(name, name)} = {factor * estimate.value:.4g} ({low} to {high}){unit}"

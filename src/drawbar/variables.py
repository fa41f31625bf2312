"""The glossary as data: every result's name, unit, sign and meaning; it builds and checks Datasets.

A Dataset of ``drawbar`` holds SI floats. Runs of a rig, real or virtual, are *tidy*: one dimension
``observation``, a row each, with labels (``wheel``, ``tissue``, ``trial``) as coordinates on it. Maps that
a model evaluates keep the dimensions of their inputs.
"""

from __future__ import annotations

import difflib
from collections.abc import Iterable, Mapping
from typing import Any

import xarray as xr

from drawbar.quantity import Quantity

__all__ = ["BARRED", "LABELS", "OBSERVATION", "VARIABLES", "declare", "nearest", "tidy"]

OBSERVATION = "observation"

LABELS: dict[str, str] = {
    "wheel": "name of the wheel",
    "tissue": "name of the tissue",
    "film": "name of the film",
    "trial": "repeat of one setting, or set of a plate test",
}
"""Columns that name rather than measure."""


def _q(unit: str, symbol: str, meaning: str, **bounds: Any) -> Quantity:
    return Quantity(unit=unit, symbol=symbol, meaning=meaning, **bounds)


VARIABLES: dict[str, Quantity] = {
    # settings
    "normal_load": _q("N", "N", "vertical load that one wheel carries, positive down", minimum=0),
    "slide_speed": _q("m/s", "v", "speed of the axle over the tissue, forward positive"),
    "wheel_speed": _q("rad/s", "ω", "wheel's rotation, positive when driving forward"),
    "rim_speed": _q("m/s", "rω", "wheel speed times radius, positive when driving forward"),
    "speed_ratio": _q("1", "v/(rω)", "the source's 'slip ratio': axle speed over rim speed; none for a locked wheel"),
    "slip": _q("1", "i", "the field's slip, 1 - v/(rω): positive when driving"),
    "wheel_radius": _q("m", "r", "the wheel's radius, half its diameter", above=0, maximum=0.5),
    "wheel_width": _q("m", "L", "the wheel's width along its axle", above=0, maximum=1.0),
    "lever_length": _q("m", "", "from the lever's pivot to the wheel's axle", above=0),
    "plate_area": _q("m^2", "A", "area of the plate that presses", above=0),
    "applied_mass": _q("kg", "", "mass laid on the plate", minimum=0),
    "applied_force": _q("N", "", "force on the plate, positive down", minimum=0),
    # results
    "time": _q("s", "t", "time since the start of the run"),
    "drawbar_force": _q("N", "F", "net pull along the heading: traction_force - rolling_resistance; negative when the wheel is dragged"),  # noqa: E501
    "traction_force": _q("N", "", "the film's shear along the heading, positive when it pulls"),
    "rolling_resistance": _q("N", "", "the tissue's resistance, against the motion; >= 0 in steady rolling"),
    "side_force": _q("N", "", "force on the wheel along its axle"),
    "reaction": _q("N", "R", "upward force of the tissue on the wheel"),
    "wheel_torque": _q("N m", "T", "torque that the motor gives, positive when driving forward"),
    "sinkage": _q("m", "δ", "depth of the wheel's lowest point below the undisturbed surface, positive down"),
    "sink_rate": _q("m/s", "", "rate of the sinkage, positive down"),
    "deflection": _q("m", "w", "depth of the plate below the undisturbed surface, positive down"),
    "contact_half_angle": _q("rad", "φ", "angle from the wheel's lowest point to the contact's edge"),
    "front_edge": _q("m", "a", "x of the contact's front edge from below the axle, >= 0"),
    "rear_edge": _q("m", "-b", "x of the contact's rear edge from below the axle, <= 0"),
    "lever_angle": _q("rad", "", "angle of the rig's lever below its angle at first touch"),
    "peak_pressure": _q("Pa", "", "highest contact pressure"),
    "travel": _q("m", "x", "distance travelled by the axle"),
    "rotation": _q("rad", "θ", "angle turned by the wheel"),
    "motor_power": _q("W", "", "wheel torque times wheel speed"),
    "drawbar_power": _q("W", "", "drawbar force times slide speed"),
    "film_loss": _q("W", "", "power that the film turns into heat, >= 0"),
    "tissue_loss": _q("W", "", "power that the tissue turns into heat, under the wheel and behind it, >= 0"),
    "flags": _q("1", "", "conditions worth knowing, as a bit mask"),
    "tractive_efficiency": _q("1", "", "drawbar power over motor power, where both are positive"),
    # energies of a transient, since its start
    "motor_work": _q("J", "", "work of the motor"),
    "load_work": _q("J", "", "work of the normal load"),
    "drawbar_work": _q("J", "", "work done on what the wheel pulls"),
    "film_heat": _q("J", "", "energy that the film turned into heat"),
    "tissue_heat": _q("J", "", "energy that the tissue's dashpots turned into heat"),
    "damper_heat": _q("J", "", "energy that the lever's damper turned into heat"),
    "elastic_energy": _q("J", "", "energy stored in the tissue, also behind the wheel"),
    "kinetic_energy": _q("J", "", "energy of the wheel's motion"),
    "ledger_error": _q("J", "", "work put in less energy accounted for; zero but for the solver's error"),
}  # fmt: skip
"""Every number that a Dataset may hold, by name."""

BARRED = (
    "drawbar_force",
    "traction_force",
    "rolling_resistance",
    "reaction",
    "wheel_torque",
    "sinkage",
    "peak_pressure",
)
"""What a transient can carry a numerical error bar for, as ``<name>_error``."""

for _name in BARRED:
    VARIABLES[f"{_name}_error"] = _q(VARIABLES[_name].unit, "", f"numerical error bar of {_name}")


def nearest(name: str, known: Iterable[str]) -> str:
    """`` Did you mean 'x'?`` for the closest known name, or nothing."""
    close = difflib.get_close_matches(name, list(known), n=1, cutoff=0.6)
    return f" Did you mean '{close[0]}'?" if close else ""


def declare(
    data: Mapping[str, Any],
    *,
    coords: Iterable[str] = (),
    attrs: Mapping[str, Any] | None = None,
    extra: Mapping[str, Quantity] | None = None,
) -> xr.Dataset:
    """A Dataset of known variables, each with its ``units``, ``symbol`` and ``long_name``.

    Parameters
    ----------
    data
        By name: a DataArray, or ``(dims, values)``.
    coords
        Which of them are coordinates.
    extra
        Declared quantities that the glossary does not hold, such as a law's parameters.

    Raises
    ------
    KeyError
        A name is not in the glossary.
    """
    known = {**VARIABLES, **(extra or {})}
    dataset = xr.Dataset(dict(data)).set_coords(list(coords))
    for name in dataset.variables:
        key = str(name)
        if key in known:
            quantity = known[key]
            dataset[key].attrs = {"units": quantity.unit, "long_name": quantity.meaning}
            if quantity.symbol:
                dataset[key].attrs["symbol"] = quantity.symbol
        elif key in LABELS:
            dataset[key].attrs = {"long_name": LABELS[key]}
        elif key in data:
            raise KeyError(f"'{key}' is not in the glossary.{nearest(key, known)}")
    dataset.attrs = dict(attrs or {})
    return dataset


def tidy(dataset: xr.Dataset) -> xr.Dataset:
    """Any Dataset of the package as rows: one dimension ``observation``, every variable on it.

    A map over several dimensions becomes a row for each of its cells; attributes are kept. Rows that
    already are come back as they are.
    """
    if set(dataset.sizes) == {OBSERVATION}:
        return dataset
    flat = dataset.reset_index(list(dataset.indexes)).reset_coords()
    full = xr.broadcast(*flat.data_vars.values())
    columns = {
        str(name): xr.DataArray(a.values.reshape(-1), dims=OBSERVATION, attrs=a.attrs)
        for name, a in zip(flat.data_vars, full, strict=True)
    }
    labels = [name for name in columns if name in LABELS]
    return xr.Dataset(columns, attrs=dataset.attrs).set_coords(labels)

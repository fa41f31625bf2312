"""Put two data sets side by side: a model and measurements, or any two runs of rigs."""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np
import xarray as xr

from drawbar.study.compare.agreement import agreement, mean_interval
from drawbar.study.compare.comparison import Comparison, Signs
from drawbar.study.compare.condition import SETTINGS, Pairing, describe, pair, runs
from drawbar.variables import OBSERVATION, VARIABLES, nearest

__all__ = ["compare"]

TOLERANCE = 0.02
"""How far measured settings may lie from the model's, relative to their size."""

FAR = 0.5
"""Settings that differ by more than this share of their size are other settings, not scattered ones."""


def compare(
    model: xr.Dataset,
    data: xr.Dataset,
    quantity: str = "drawbar_force",
    tolerance: float | Mapping[str, float] = TOLERANCE,
) -> Comparison:
    """Put the predictions of a model beside measurements, condition by condition and over all.

    Parameters
    ----------
    model, data
        Any Datasets of the package: maps, runs of a rig, or time histories, which count as one mean per
        run after the first quarter, the settling.
    quantity
        What to compare, in both.
    tolerance
        How far settings may lie apart, relative to their size, to count as the same: measured
        settings scatter. A number of at least 0 and below 1, or one for some settings by name, such as
        ``{"normal_load": 0.2}`` (the others 0.02).

    Returns
    -------
    Comparison
        ``.table``, ``.verdict``, ``.report()``; ``.scale`` s of data ≈ s model, ``.offset`` b of
        data ≈ model + b, ``.explained_by``, ``.nrmse``, ``.signs``, ``.over_all`` with the ranks.
        Conditions without a partner are counted in ``.unmatched``.

    Raises
    ------
    ValueError
        The quantity is missing, no condition matches, or one side varies in something that the other
        does not tell.

    >>> import drawbar
    >>> settings = drawbar.grid(normal_load=[0.14, 0.27], speed_ratio=[0.5, 1.0, 1.5])
    >>> model = drawbar.steady(drawbar.Wheel(radius=0.0075, width=0.02), drawbar.Winkler(stiffness=225e3),
    ...                        drawbar.Couette(viscous_coefficient=1e4), speed=0.0254, **settings)
    >>> found = compare(model, model.assign(drawbar_force=model.drawbar_force / 3))
    >>> print(found.verdict)
    The model is 3 times the data; a factor explains the difference better than an offset. The factor leaves nothing.
    """
    allowed = _tolerances(tolerance)
    sides = {"model": runs(model), "data": runs(data)}
    notes = []
    for side, given in (("model", model), ("data", data)):
        rows = sides[side]
        _refuse_missing(side, rows, quantity)
        if "time" in given.variables and rows.sizes[OBSERVATION] < given["time"].size:
            several = "1 run" if rows.sizes[OBSERVATION] == 1 else f"{rows.sizes[OBSERVATION]} runs"
            notes.append(f"Time histories of the {side}: {several}, each its mean after the settling.")
        sides[side], dropped = _complete(rows, quantity)
        if dropped:
            notes.append(f"Rows of the {side} without {quantity} or a setting: {dropped}, left out.")
    found = pair(sides["model"], sides["data"], allowed)
    if not found.model:
        raise ValueError(_no_match(sides["model"], sides["data"], found))
    for side, left in (("model", found.unmatched_model), ("data", found.unmatched_data)):
        if left:
            rows = sides[side].isel({OBSERVATION: np.concatenate(left)})
            notes.append(f"Without a partner in the {side}: {_has(rows, found)}.")
    name, needed = found.nearest
    if needed < FAR:
        notes.append(f"The nearest of the data without one would need a tolerance of {needed * 1.001:.3g} in {name}.")
    table = _table(sides["model"], sides["data"], quantity, found)
    return Comparison(
        quantity=quantity,
        unit=_unit(quantity, sides["data"]),
        table=table,
        over_all=agreement(table["model"].values, table["data"].values),
        signs=_signs(table),
        unmatched={"model": len(found.unmatched_model), "data": len(found.unmatched_data)},
        notes=(*found.notes, *notes),
    )


def _unit(quantity: str, rows: xr.Dataset) -> str:
    return VARIABLES[quantity].unit if quantity in VARIABLES else str(rows[quantity].attrs.get("units", "1"))


def _refuse_missing(side: str, rows: xr.Dataset, quantity: str) -> None:
    if quantity not in rows or rows[quantity].dtype.kind not in "fiu":
        has = sorted(str(n) for n in rows.data_vars if rows[n].dtype.kind in "fiu")
        hint = nearest(quantity, has)
        raise ValueError(f"the {side} has no numbers called '{quantity}'.{hint} It has: {', '.join(has) or 'none'}.")
    if rows.sizes[OBSERVATION] == 0:
        raise ValueError(f"the {side} is empty. Give at least one run.")


def _complete(rows: xr.Dataset, quantity: str) -> tuple[xr.Dataset, int]:
    """Rows in which nothing is missing. A locked wheel has no speed ratio, and is not missing it."""
    whole = np.isfinite(rows[quantity].values.astype(float))
    for name in ("normal_load", "slide_speed", "wheel_speed"):
        if name in rows:
            whole &= np.isfinite(rows[name].values.astype(float))
    if "speed_ratio" in rows and "wheel_speed" in rows:
        whole &= ~(np.isnan(rows["speed_ratio"].values) & (rows["wheel_speed"].values != 0.0))
    return rows.isel({OBSERVATION: whole}), int(np.sum(~whole))


def _tolerances(given: float | Mapping[str, float]) -> dict[str, float]:
    """The tolerance of each setting; a locked or driven wheel's drive has the one of the speed ratio."""
    by_name = dict(given) if isinstance(given, Mapping) else dict.fromkeys(SETTINGS, given)
    for name, number in by_name.items():
        if name not in SETTINGS:
            raise ValueError(f"'{name}' is not a setting.{nearest(name, SETTINGS)} There are: {', '.join(SETTINGS)}.")
        if not 0.0 <= number < 1.0:
            raise ValueError(f"tolerance must be >= 0 and < 1, got {number}. It is relative to a setting's size.")
    return {name: by_name.get(name, TOLERANCE) for name in SETTINGS}


def _no_match(model: xr.Dataset, data: xr.Dataset, found: Pairing) -> str:
    advice = "Evaluate the model at the settings of the data"
    name, needed = found.nearest
    if needed < FAR:
        advice += f", or allow a tolerance of {needed * 1.001:.3g} in {name}"
    return (
        "no condition of the model matches one of the data within the tolerance. "
        f"The model has {_has(model, found)}; the data have {_has(data, found)}. {advice}."
    )


def _has(rows: xr.Dataset, found: Pairing) -> str:
    return ", ".join(describe(rows, n) for n in found.settings if n in rows) if rows.sizes[OBSERVATION] else "nothing"


def _table(model: xr.Dataset, data: xr.Dataset, quantity: str, found: Pairing) -> xr.Dataset:
    unit = _unit(quantity, data)
    columns: dict[str, tuple[str, np.ndarray, dict[str, str]]] = {}
    for name in found.settings:
        rows, groups = (model, found.model) if name in model else (data, found.data)
        if name in data and rows[name].dtype.kind not in "fiu":  # labels are the data's
            rows, groups = data, found.data
        columns[name] = ("condition", np.array([rows[name].values[g[0]] for g in groups]), dict(rows[name].attrs))
    for side, rows, groups in (("model", model, found.model), ("data", data, found.data)):
        values = rows[quantity].values.astype(float)
        mean, half = np.array([mean_interval(values[g]) for g in groups]).T
        columns[side] = ("condition", mean, {"units": unit, "long_name": f"{quantity} of the {side}, mean"})
        long_name = "half width of the mean's 95 % interval; NaN without repeats"
        columns[f"{side}_interval"] = ("condition", half, {"units": unit, "long_name": long_name})
        columns[f"{side}_repeats"] = ("condition", np.array([g.size for g in groups]), {"units": "1"})
    difference = columns["data"][1] - columns["model"][1]
    columns["difference"] = ("condition", difference, {"units": unit, "long_name": "data - model"})
    return xr.Dataset(columns, attrs={"quantity": quantity}).set_coords(list(found.settings))


def _signs(table: xr.Dataset) -> Signs:
    zero = np.zeros(table.sizes["condition"], dtype=bool)
    for side in ("model", "data"):
        size = np.abs(table[side].values)
        half = np.nan_to_num(table[f"{side}_interval"].values, nan=0.0)
        zero |= size <= np.maximum(half, 1e-9 * np.max(size))
    same = np.sign(table["model"].values) == np.sign(table["data"].values)
    return Signs(agree=int(np.sum(same & ~zero)), compared=int(np.sum(~zero)), zero=int(np.sum(zero)))

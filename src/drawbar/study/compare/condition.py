"""Which rows of two data sets belong together: time histories become runs, runs become conditions."""

from __future__ import annotations

import dataclasses
from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np
import xarray as xr

from drawbar.study.identify.reduce import reduce_histories
from drawbar.variables import LABELS, OBSERVATION, VARIABLES, tidy

__all__ = ["SETTINGS", "Pairing", "describe", "pair", "runs"]

SCATTER = 0.1
"""A setting that is not compared may vary by this share within a condition; more is another setting."""

IMPOSED = ("normal_load", "slide_speed")
DRIVES = ("speed_ratio", "wheel_speed")
SIZES = ("wheel_radius", "wheel_width")
NAMES = ("wheel", "tissue", "film")
SETTINGS: tuple[str, ...] = (*IMPOSED, *DRIVES, *SIZES)


def runs(dataset: xr.Dataset) -> xr.Dataset:
    """Any Dataset of the package as one row for each run.

    Time histories are reduced to their means (:func:`drawbar.study.identify.reduce.reduce_histories`). Settings
    that a Dataset keeps in its attributes, as a transient does its load, become columns.
    """
    rows = tidy(dataset.transpose(..., "time") if "time" in dataset.dims else dataset)
    size = rows.sizes[OBSERVATION]
    for name in SETTINGS:
        if name not in rows and isinstance(rows.attrs.get(name), (int, float)):
            units = {"units": VARIABLES[name].unit}
            rows = rows.assign({name: (OBSERVATION, np.full(size, float(rows.attrs[name])), units)})
    return reduce_histories(rows) if "time" in rows and size else rows


@dataclasses.dataclass(frozen=True)
class Pairing:
    """Rows of the model and of the data that stand for the same condition, and what is left over.

    ``model`` and ``data`` hold the row numbers of each matched condition; ``unmatched_model`` and
    ``unmatched_data`` those of each condition that found no partner. ``nearest`` names the setting that
    keeps the nearest of the unmatched data from a partner, and the tolerance that it would take.
    """

    settings: tuple[str, ...]
    model: tuple[np.ndarray, ...]
    data: tuple[np.ndarray, ...]
    unmatched_model: tuple[np.ndarray, ...]
    unmatched_data: tuple[np.ndarray, ...]
    nearest: tuple[str, float]
    notes: tuple[str, ...]


def pair(model: xr.Dataset, data: xr.Dataset, tolerance: Mapping[str, float]) -> Pairing:
    """Match the conditions of two tables of runs (:func:`runs`).

    A condition is what both have of normal load, slide speed and drive, and the names of wheel, tissue
    and film where the two share any; wheel radius and width count where they vary. The drive is
    compared as rim speed over slide speed, the inverse of the speed ratio, which is 0 for a locked
    wheel, or as wheel speed where one side has nothing else. Two numbers agree within the setting's
    ``tolerance`` of the larger one, and near zero of a tenth of the largest there is.

    Rows with the same numbers are repeats; on a side that numbers its trials, so are rows that agree
    within the tolerance, since measured settings scatter. Each condition of the data goes to the nearest
    one of the model; several that go to the same are its repeats.

    Raises
    ------
    ValueError
        The two share no setting, or one varies in something that the other cannot tell apart.
    """
    drive = _drive(model, data)
    shared = [n for n in (*IMPOSED, drive) if n in model and n in data]
    sizes = [n for n in SIZES if n in model and n in data]
    varying = [n for n in sizes if np.ptp(model[n].values) > 0 or np.ptp(data[n].values) > 0]
    labels = [n for n in NAMES if n in model and n in data]
    common = [n for n in labels if set(model[n].values.tolist()) & set(data[n].values.tolist())]
    notes = [_constant(n, model, data) for n in sizes if n not in varying and not _close(model, data, n, tolerance[n])]
    notes += [_constant(n, model, data) for n in labels if n not in common]
    settings = [*common, *shared, *varying]
    if not [n for n in settings if n in shared]:
        raise ValueError(
            f"the two data sets share no setting. {_has('The model', model)} {_has('The data', data)} "
            "Both need normal_load, slide_speed, and speed_ratio or wheel_speed."
        )
    own = [n for n in NAMES if n in data and n not in common and len(set(data[n].values.tolist())) > 1]
    notes += [f"The model does not tell one {n} from another: its values stand beside each of the data's." for n in own]

    numbers = [*shared, *varying]
    keys = {"model": _keys(model, numbers), "data": _keys(data, numbers)}
    largest = np.max(np.abs(np.concatenate([np.where(np.isfinite(k), k, 0.0) for k in keys.values()])), axis=0)
    allowed = np.array([tolerance[n] for n in numbers])
    model_groups = _groups(model, keys["model"], common, largest, allowed)
    data_groups = _groups(data, keys["data"], [*common, *own], largest, allowed)
    pooled: dict[tuple[Any, ...], list[np.ndarray]] = {}
    left: list[np.ndarray] = []
    closest = (np.inf, "", np.inf)
    centres = np.array([keys["model"][g[0]] for g in model_groups]).reshape(len(model_groups), -1)
    names = np.array([_labels(model, common, g[0]) for g in model_groups]).reshape(len(model_groups), len(common))
    for group in data_groups:
        away = _apart(keys["data"][group[0]], centres, largest)
        worst = _worst(away, allowed)
        worst[np.any(names != np.array(_labels(data, common, group[0]), dtype=object), axis=1)] = np.inf
        nearest = int(np.argmin(worst)) if worst.size else -1
        if nearest >= 0 and worst[nearest] <= 1.0:
            pooled.setdefault((nearest, *_labels(data, own, group[0])), []).append(group)
            continue
        left.append(group)
        if nearest >= 0 and worst[nearest] < closest[0]:
            at = int(np.argmax(away[nearest] > allowed))
            closest = (worst[nearest], numbers[at], float(away[nearest, at]))
    order = sorted(pooled)
    matched_data = tuple(np.sort(np.concatenate(pooled[key])) for key in order)
    used = {key[0] for key in order}
    _refuse_mixture("model", model, model_groups, settings, drive)
    _refuse_mixture("data", data, matched_data, settings + own, drive)
    return Pairing(
        settings=tuple(dict.fromkeys([*own, *settings])),
        model=tuple(model_groups[key[0]] for key in order),
        data=matched_data,
        unmatched_model=tuple(g for i, g in enumerate(model_groups) if i not in used),
        unmatched_data=tuple(left),
        nearest=closest[1:],
        notes=tuple(notes),
    )


def _apart(one: np.ndarray, many: np.ndarray, largest: np.ndarray) -> np.ndarray:
    """How far settings lie apart, relative to their size: a row for each of ``many``, a column per setting."""
    with np.errstate(invalid="ignore", divide="ignore"):
        size = np.maximum(np.maximum(np.abs(one), np.abs(many)), 0.1 * largest)
        apart = np.where(one == many, 0.0, np.abs(one - many) / size)
    return np.nan_to_num(apart, nan=np.inf)


def _worst(apart: np.ndarray, allowed: np.ndarray) -> np.ndarray:
    """The largest share of its tolerance that a row takes up; 1 is just allowed."""
    with np.errstate(invalid="ignore", divide="ignore"):
        return np.max(np.where(apart == 0.0, 0.0, apart / allowed), axis=1, initial=0.0)


def _drive(model: xr.Dataset, data: xr.Dataset) -> str:
    both = [n for n in DRIVES if n in model and n in data]
    spinning = "speed_ratio" in both and any(np.any(side["speed_ratio"].values == 0.0) for side in (model, data))
    return both[-1] if both and spinning else (both or ["speed_ratio"])[0]


def _keys(rows: xr.Dataset, names: Sequence[str]) -> np.ndarray:
    columns = []
    for name in names:
        values = rows[name].values.astype(float)
        if name == "speed_ratio":
            with np.errstate(divide="ignore"):
                values = np.where(np.isnan(values), 0.0, -1.0 / values)  # a minus sorts as the ratio does
        columns.append(values)
    return np.stack(columns, axis=1)


def _labels(rows: xr.Dataset, names: Sequence[str], row: int) -> tuple[Any, ...]:
    return tuple(str(rows[n].values[row]) for n in names)


def _groups(
    rows: xr.Dataset, keys: np.ndarray, labels: Sequence[str], largest: np.ndarray, allowed: np.ndarray
) -> list[np.ndarray]:
    """Row numbers of each condition of one side, sorted by its settings."""
    exact = np.round(keys / np.where(largest > 0, largest, 1.0), 10)
    codes = [np.unique(rows[n].values.astype(str), return_inverse=True)[1] for n in labels]
    _, group = np.unique(np.column_stack([*codes, exact]), axis=0, return_inverse=True)
    group = group.reshape(-1)
    members = np.split(np.argsort(group, kind="stable"), np.cumsum(np.bincount(group))[:-1]) if group.size else []
    if "trial" not in rows or len(set(rows["trial"].values.tolist())) < 2:
        return members
    merged: list[list[np.ndarray]] = []
    centres, named = np.empty((len(members), keys.shape[1])), np.column_stack([np.zeros(len(keys), int), *codes])
    names = np.empty((len(members), named.shape[1]), int)
    for rows_here in members:  # greedily: a condition's first repeat is its centre
        first, count = rows_here[0], len(merged)
        worst = _worst(_apart(keys[first], centres[:count], largest), allowed)
        worst[np.any(names[:count] != named[first], axis=1)] = np.inf
        if count and np.min(worst) <= 1.0:
            merged[int(np.argmin(worst))].append(rows_here)
        else:
            centres[count], names[count] = keys[first], named[first]
            merged.append([rows_here])
    return [np.concatenate(m) for m in merged]


def _refuse_mixture(side: str, rows: xr.Dataset, groups: Sequence[np.ndarray], told: Sequence[str], drive: str) -> None:
    """A condition must not average over different wheels, widths, laws: that would be no repeat."""
    known = {"slip", "rim_speed", *(DRIVES if drive in told else ())}
    settings = {*SETTINGS, *NAMES}
    names = [str(n) for n in rows.variables if n in settings or (n not in VARIABLES and n not in LABELS)]
    for name in names:
        values = rows[name].values
        if name in told or name in known:
            continue
        for group in groups:
            here = values[group]
            if here.dtype.kind not in "fiu":
                differ = len(set(here.tolist())) > 1
            else:
                differ = here.size > 0 and np.ptp(here) > SCATTER * np.max(np.abs(here))
            if differ:
                span = (
                    f"{np.min(here)} to {np.max(here)}" if here.dtype.kind in "fiu" else ", ".join(set(map(str, here)))
                )
                raise ValueError(
                    f"the {side} varies in {name} ({span}) within one condition, and the other side does not tell "
                    f"which is meant. Select one {name} first."
                )


def _close(model: xr.Dataset, data: xr.Dataset, name: str, tolerance: float) -> bool:
    a, b = float(model[name].values[0]), float(data[name].values[0])
    return abs(a - b) <= tolerance * max(abs(a), abs(b))


def _constant(name: str, model: xr.Dataset, data: xr.Dataset) -> str:
    def said(rows: xr.Dataset) -> str:
        values = rows[name].values
        if values.dtype.kind in "fiu":
            return f"{values[0]:g} {VARIABLES[name].unit}"
        return ", ".join(f"'{v}'" for v in dict.fromkeys(values.tolist()))

    return f"{name} differs and was not matched: {said(model)} in the model, {said(data)} in the data."


def _has(side: str, rows: xr.Dataset) -> str:
    has = [describe(rows, n) for n in (*NAMES, *SETTINGS) if n in rows]
    return f"{side} has {', '.join(has) or 'none of them'}."


def describe(rows: xr.Dataset, name: str) -> str:
    """The values of one setting in words: ``normal_load 0.137 to 0.412 N``."""
    values = rows[name].values
    if values.dtype.kind not in "fiu":
        return f"{name} {'/'.join(dict.fromkeys(map(str, values.tolist())))}"
    finite = values[np.isfinite(values)]
    unit = f" {VARIABLES[name].unit}" if VARIABLES[name].unit != "1" else ""
    locked = " (and locked)" if name == "speed_ratio" and finite.size < values.size else ""
    if not finite.size:
        return f"{name} of a locked wheel" if name == "speed_ratio" else f"{name} nan"
    low, high = np.min(finite), np.max(finite)
    return f"{name} {low:.4g}{unit}{locked}" if low == high else f"{name} {low:.4g} to {high:.4g}{unit}{locked}"

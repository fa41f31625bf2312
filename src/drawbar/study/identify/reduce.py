"""From logs to one row for each run: several logs put together, time histories reduced to their means."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

import numpy as np
import xarray as xr

from drawbar.rig.derive import derived
from drawbar.variables import LABELS, OBSERVATION, VARIABLES, declare, tidy

__all__ = ["SETTLING", "Rows", "gather", "one_label", "reduce_histories", "require", "run_starts"]

Rows = dict[str, np.ndarray]
"""Columns by name, SI, all of one length."""

SETTLING = 0.25
"""The first part of a run's time, which is left out of its mean."""

SETTINGS = ("normal_load", "slide_speed", "applied_mass", "applied_force", "plate_area")
JUMP = 0.05
"""A setting that jumps by more than this part of its largest magnitude begins a new run."""


def reduce_histories(dataset: xr.Dataset, settling: float = SETTLING) -> xr.Dataset:
    """One mean for each run of a log of time histories.

    A new run begins where the time does not rise, a label (``trial``, ``wheel``, ...) changes, or a
    setting (load, slide speed, weight) jumps by more than 5 % of its largest magnitude. The first
    ``settling`` of a run's duration is left out; the rest is averaged, sample by sample alike. The
    samples of a run share its zero errors: a run is one observation, however many samples it has.
    ``attrs['unsettled']`` counts the runs whose sinkage still swings: force is not linear in the angle, so
    the mean of one does not belong to the mean of the other.

    Parameters
    ----------
    dataset
        Rows with ``time`` [s].
    settling
        Part of each run's duration to leave out, 0 to 1.

    Returns
    -------
    xarray.Dataset
        Tidy, along ``observation``: a row for each run, without ``time``.

    Raises
    ------
    ValueError
        There is no ``time``, or ``settling`` is not a part.
    """
    rows = tidy(dataset)
    if "time" not in rows.variables:
        raise ValueError("the log has no time [s] column, so there are no histories to reduce.")
    if not 0.0 <= settling < 1.0:
        raise ValueError(f"settling must be >= 0 and < 1, got {settling:g}. It is the part of a run to leave out.")
    columns = {str(n): np.broadcast_to(v.values, rows.sizes[OBSERVATION]) for n, v in rows.variables.items()}
    starts = run_starts(columns)
    run = np.cumsum(starts) - 1
    time = columns["time"]
    first = time[starts]
    last = time[np.append(np.flatnonzero(starts)[1:] - 1, time.size - 1)]
    keep = time >= (first + settling * (last - first))[run]
    count = np.bincount(run[keep])
    reduced: Rows = {}
    for name, column in columns.items():
        if name in LABELS:
            reduced[name] = column[starts]
        elif name in VARIABLES and name != "time":
            reduced[name] = np.bincount(run[keep], weights=column[keep]) / count
    return declare(
        {n: (OBSERVATION, c) for n, c in reduced.items()},
        coords=[n for n in reduced if n in LABELS],
        attrs={
            **rows.attrs,
            "histories": f"{time.size} samples reduced to {count.size} means",
            "unsettled": _unsettled(columns, run, keep),
        },
    )


def _unsettled(columns: Mapping[str, np.ndarray], run: np.ndarray, keep: np.ndarray) -> int:
    """How many runs' depth or angle still swings, by more than 5 %, in the part that is kept.

    A swing is smooth, noise is not: a run swings if its variance exceeds half the mean square of
    successive differences (their ratio is 1 for white noise: von Neumann's ratio) by half.
    """
    name = next((n for n in ("sinkage", "contact_half_angle") if n in columns), None)
    if name is None:
        return 0
    depth, run = columns[name][keep], run[keep]
    count = np.bincount(run)
    mean = np.bincount(run, weights=depth) / count
    variance = np.bincount(run, weights=(depth - mean[run]) ** 2) / count
    steps = np.where(np.diff(run) == 0, np.diff(depth), 0.0) ** 2
    noise = 0.5 * np.bincount(run[1:], weights=steps, minlength=count.size) / np.maximum(count - 1, 1)
    return int(np.count_nonzero((variance > 1.5 * noise) & (variance > (0.05 * mean) ** 2)))


def run_starts(columns: Mapping[str, np.ndarray]) -> np.ndarray:
    """Whether each row is the first of a run."""
    new = np.diff(columns["time"]) <= 0.0
    for name in LABELS:
        if name in columns:
            new |= columns[name][1:] != columns[name][:-1]
    for name in SETTINGS:
        if name in columns:
            new |= np.abs(np.diff(columns[name])) > JUMP * np.max(np.abs(columns[name]))
    return np.concatenate([[True], new])


def gather(datasets: xr.Dataset | Sequence[xr.Dataset]) -> tuple[Rows, list[str], list[str]]:
    """The columns of one or several logs, with what follows from them, and notes and warnings on them.

    Only columns that all logs have are kept. ``trial`` names the log too where there are several, since
    the first trial of one is not the first of another. Time histories are reduced.

    Raises
    ------
    ValueError
        There are no logs or no rows.
    """
    logs = [datasets] if isinstance(datasets, xr.Dataset) else list(datasets)
    if not logs:
        raise ValueError("there is no log to fit to. Give at least one dataset.")
    notes, warnings, parts = [], [], []
    for number, log in enumerate(logs, start=1):
        rows = tidy(log)
        if "time" in rows.variables and rows.sizes.get(OBSERVATION, 0):
            rows = reduce_histories(rows)
            notes.append(
                f"{rows.attrs['histories']}, one for each run; the first {SETTLING:.0%} of a run was left out "
                "as settling."
            )
            if rows.attrs["unsettled"]:
                warnings.append(
                    f"{rows.attrs['unsettled']} of {rows.sizes[OBSERVATION]} runs had not settled: the wheel still "
                    "bounces, and a mean force does not belong to a mean angle. Damp the lever, or cut the log later."
                )
        count = rows.sizes.get(OBSERVATION, 0)
        columns = derived({str(n): np.broadcast_to(v.values, count) for n, v in rows.variables.items()})
        if len(logs) > 1:
            trial = columns.get("trial", np.full(count, ""))
            columns["trial"] = np.array([f"log {number} {t}".strip() for t in trial], dtype=object)
        parts.append(columns)
    gathered = {n: np.concatenate([p[n] for p in parts]) for n in parts[0] if all(n in p for p in parts)}
    if not gathered or not next(iter(gathered.values())).size:
        raise ValueError("the log has no rows. Give a log with measurements.")
    return gathered, notes, warnings


def require(columns: Mapping[str, np.ndarray], purposes: Mapping[str, str]) -> None:
    """Refuse a log that lacks a column, or in which one is not finite, in a sentence that says what it is for.

    Raises
    ------
    ValueError
        A column of ``purposes`` (what each is for, by name) is missing or holds NaN or infinity.
    """
    missing = [name for name in purposes if name not in columns]
    if missing:
        lacks = ", ".join(f"{name} [{VARIABLES[name].unit}] ({purposes[name]})" for name in missing)
        raise ValueError(f"the log lacks {lacks}. Add it as a column, or as a constant with --set.")
    for name in purposes:
        bad = ~np.isfinite(columns[name])
        if bad.any():
            raise ValueError(
                f"{name} is not a finite number in {int(bad.sum())} of {bad.size} rows, first in row "
                f"{int(np.argmax(bad)) + 1}. Take these rows out."
            )


def one_label(columns: Mapping[str, np.ndarray], name: str) -> None:
    """Refuse a log that mixes several tissues or films: each has numbers of its own.

    Raises
    ------
    ValueError
        The label ``name`` has more than one value.
    """
    found = [str(label) for label in np.unique(columns[name].astype(str))] if name in columns else []
    if len(found) > 1:
        raise ValueError(
            f"the log holds several kinds of {name}: {', '.join(found)}. Each has numbers of its own: fit them one by "
            f'one, the first with --where "{name}={found[0]}".'
        )

"""The paper's printed outcomes, judged: criteria as code, verdicts per cell and over the wheel's width.

A *cell* is one load and speed ratio. A model hands in a map of drawbar force over wheel width, normal
load (in units of W) and speed ratio for each tissue and wheel that it can say something about; an
outcome about a wheel that it has no map for is *not addressed by this model*.
"""

from __future__ import annotations

import dataclasses
from collections.abc import Callable, Mapping
from typing import Any

import numpy as np
import xarray as xr

from drawbar.sources.rentschler_2004 import ASSUMED, LOADS, OUTCOMES, PRINTED, SPEED_RATIOS, Outcome

__all__ = [
    "ABOUT_ZERO",
    "CRITERIA",
    "GROWS",
    "LOWER",
    "NOT_ADDRESSED",
    "NOT_REPRODUCED",
    "REPRODUCED",
    "Maps",
    "Verdict",
    "at_assumed_width",
    "judge",
]

REPRODUCED = "reproduced"
NOT_REPRODUCED = "not reproduced"
NOT_ADDRESSED = "not addressed by this model"

ABOUT_ZERO = 0.20
"""|F| is *about zero* up to this share of F at speed ratio 0.5 and the same load."""
GROWS = 0.01
"""|F| *grows* with the load when it exceeds that at the next lower load by more than this share."""
LOWER = (2.0, 3.0)
"""The paper's "factor of two-three lower"."""
SAME_SIZE = 2.0
"""Simulation and measurement have *the same size* within this factor either way."""

Maps = Mapping[tuple[str, str], xr.DataArray]
"""Drawbar force [N] by (tissue, wheel), over ``wheel_width``, ``load_ratio`` (N/W) and ``speed_ratio``."""


@dataclasses.dataclass(frozen=True)
class Verdict:
    """One outcome, one model. ``cells`` holds true, false or NaN (not judged) over width, load, ratio."""

    outcome: Outcome
    model: str
    verdict: str
    reason: str
    criterion: str
    cells: xr.DataArray | None = None
    widths: str = ""

    def as_dict(self) -> dict[str, Any]:
        """What ``outcomes.json`` holds."""
        cells = []
        if self.cells is not None:
            here = at_assumed_width(self.cells)
            cells = [
                {
                    "load": float(load),
                    "speed_ratio": float(ratio),
                    "holds": bool(here.sel(load_ratio=load, speed_ratio=ratio)),
                }
                for load in here.load_ratio.values
                for ratio in here.speed_ratio.values
                if not np.isnan(here.sel(load_ratio=load, speed_ratio=ratio))
            ]
        return {
            "outcome": self.outcome.name,
            "statement": self.outcome.statement,
            "where": self.outcome.where,
            "model": self.model,
            "verdict": self.verdict,
            "reason": self.reason,
            "criterion": self.criterion,
            "widths": self.widths,
            "cells": cells,
        }


def at_assumed_width(over_width: xr.DataArray) -> xr.DataArray:
    """The slice at the width that this project assumes, since the paper prints none."""
    return over_width.sel(wheel_width=ASSUMED["wheel_width"].value, method="nearest")


# Criteria: each answers, cell by cell, with 1 (holds), 0 (fails) or NaN (says nothing there) ---------


def _p1(maps: Maps) -> xr.DataArray:
    force = maps["foam", "smooth"]
    pull, zero, skid = (force.sel(speed_ratio=s, drop=True) for s in SPEED_RATIOS)
    return xr.concat([pull > 0, abs(zero) <= ABOUT_ZERO * pull, skid < 0], force.speed_ratio).astype(float)


def _p2(maps: Maps) -> xr.DataArray:
    size = abs(maps["foam", "smooth"])
    grows = (size > (1 + GROWS) * size.shift(load_ratio=1)).astype(float)
    judged = (size.load_ratio > LOADS[0]) & (size.speed_ratio != 1.0)  # P1 has the force at 1 about zero
    return grows.where(judged)


def _p3(maps: Maps) -> xr.DataArray:
    printed = PRINTED["simulation_over_measurement"].value
    same = float(1 / SAME_SIZE <= printed <= SAME_SIZE)
    force = maps["foam", "smooth"]
    return xr.full_like(force, same).where(force.speed_ratio != 1.0)


def _p5(maps: Maps) -> xr.DataArray:
    ratio = abs(maps["foam", "smooth"]) / abs(maps["liver", "smooth"])
    holds = ((ratio >= LOWER[0]) & (ratio <= LOWER[1])).astype(float)
    return holds.where(ratio.speed_ratio != 1.0)


def _p6(maps: Maps) -> xr.DataArray:
    return (maps["liver", "smooth"] < 0).astype(float)


@dataclasses.dataclass(frozen=True)
class Criterion:
    """What a model must give for an outcome to count as reproduced, in words and in code."""

    text: str
    cells: Callable[[Maps], xr.DataArray] | None
    needs: tuple[tuple[str, str], ...]


CRITERIA: dict[str, Criterion] = {
    "P1": Criterion(
        f"F > 0 at speed ratio 0.5, |F| <= {ABOUT_ZERO:.0%} of F at 0.5 at speed ratio 1, F < 0 at 1.5, at each load",
        _p1, (("foam", "smooth"),)),
    "P2": Criterion(
        f"|F| exceeds that at the next lower load by more than {GROWS:.0%}, at speed ratios 0.5 and 1.5",
        _p2, (("foam", "smooth"),)),
    "P3": Criterion(
        f"simulation over measurement between 1/{SAME_SIZE:g} and {SAME_SIZE:g}, at speed ratios 0.5 and 1.5",
        _p3, (("foam", "smooth"),)),
    "P4": Criterion("|F| of female and male wheels within 20 % of the smooth wheel's, at each load and speed ratio",
        None, (("foam", "female"), ("foam", "male"))),
    "P5": Criterion(
        f"|F| on foam over |F| on liver between {LOWER[0]:g} and {LOWER[1]:g}, same film on both, at speed ratios 0.5 and 1.5",  # noqa: E501
        _p5, (("foam", "smooth"), ("liver", "smooth"))),
    "P6": Criterion("F < 0 at each load and speed ratio", _p6, (("liver", "smooth"),)),
    "P7": Criterion("F within 20 % of +0.05 N at speed ratio 0.5 and N = W", None, (("liver", "female"),)),
    "P8": Criterion("F within 20 % of +0.1 N at speed ratio 0.5 and N = W", None, (("liver", "male"),)),
    "P9": Criterion("F at 0.5, 1 and 1.5 W within 10 % of each other at speed ratio 0.5", None, (("liver", "male"),)),
    "P10": Criterion("F of the male wheel at least 1.5 times that of each other at speed ratio 0.5 and N = W",
        None, (("liver", "female"), ("liver", "male"))),
}  # fmt: skip
"""One criterion for each printed outcome."""


def judge(model: str, maps: Maps, reasons: Mapping[str, str]) -> tuple[Verdict, ...]:
    """Every printed outcome with what a model gives.

    An outcome is *reproduced* when every judged cell holds at the assumed wheel width; ``widths`` says in
    words where in the sweep that is so, for a verdict that flips inside it is none. ``reasons`` are the
    model's own words, by outcome.
    """
    return tuple(_judge_one(o, CRITERIA[o.name], model, maps, reasons[o.name]) for o in OUTCOMES)


def _judge_one(outcome: Outcome, criterion: Criterion, model: str, maps: Maps, reason: str) -> Verdict:
    if criterion.cells is None or any(need not in maps for need in criterion.needs):
        return Verdict(outcome, model, NOT_ADDRESSED, reason, criterion.text)
    cells = criterion.cells(maps).transpose("wheel_width", "load_ratio", "speed_ratio")
    verdict = REPRODUCED if bool((at_assumed_width(cells) != 0).all()) else NOT_REPRODUCED
    return Verdict(outcome, model, verdict, reason, criterion.text, cells, _over_widths(cells))


def _over_widths(cells: xr.DataArray) -> str:
    """In words: at which of the swept widths every judged cell holds, and how many cells hold."""
    holds = (cells != 0).all(["load_ratio", "speed_ratio"]).values
    millimetres = cells.wheel_width.values * 1e3
    swept = f"{millimetres[0]:g} to {millimetres[-1]:g} mm"
    judged = int(at_assumed_width(cells).notnull().sum())
    kept = int((at_assumed_width(cells) == 1).sum())
    here = f"{kept} of {judged} cells at {ASSUMED['wheel_width'].value * 1e3:g} mm"
    if holds.all():
        return f"{here}; all cells at every width from {swept}"
    if not holds.any():
        counts = (cells == 1).sum(["load_ratio", "speed_ratio"]).values
        low, high = counts.min(), counts.max()
        if low == high:
            return f"{here}; as many at every width from {swept}"
        return f"{here}; {low} to {high} of {judged} over widths from {swept}, never all"
    kept_widths = millimetres[holds]
    return f"{here}; all cells only at widths {_ranges(kept_widths)} of {swept}: the verdict hangs on the width"


def _ranges(numbers: np.ndarray) -> str:
    step = 1.5  # the sweep's spacing is 1 mm
    parts = np.split(numbers, np.flatnonzero(np.diff(numbers) > step) + 1)
    return ", ".join(f"{p[0]:g} to {p[-1]:g} mm" if p.size > 1 else f"{p[0]:g} mm" for p in parts)

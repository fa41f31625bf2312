"""Columns that follow from others, by definition: the same for a virtual run and a laboratory's log."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import Any

import numpy as np

from drawbar.tissue.base import geometric_half_angle

__all__ = ["derived"]


def _speed_ratio(slide_speed: Any, rim_speed: Any) -> Any:
    with np.errstate(divide="ignore", invalid="ignore"):
        return np.where(rim_speed != 0.0, slide_speed / rim_speed, np.nan)


def _wheel_speed(speed_ratio: Any, slide_speed: Any, wheel_radius: Any) -> Any:
    with np.errstate(divide="ignore", invalid="ignore"):
        # no speed ratio means a locked wheel
        return np.where(np.isnan(speed_ratio), 0.0, slide_speed / (speed_ratio * wheel_radius))


# What a column follows from, in the order in which they are tried. A measured column is never replaced.
RULES: tuple[tuple[str, tuple[str, ...], Callable[..., Any]], ...] = (
    ("speed_ratio", ("slip",), lambda slip: 1.0 - slip),
    ("wheel_speed", ("rim_speed", "wheel_radius"), lambda rim, r: rim / r),
    ("wheel_speed", ("speed_ratio", "slide_speed", "wheel_radius"), _wheel_speed),
    ("rim_speed", ("wheel_speed", "wheel_radius"), lambda omega, r: omega * r),
    ("speed_ratio", ("slide_speed", "rim_speed"), _speed_ratio),
    ("sinkage", ("lever_angle", "lever_length"), lambda angle, length: length * np.sin(angle)),
    ("sinkage", ("contact_half_angle", "wheel_radius"), lambda phi, r: 2.0 * r * np.sin(0.5 * phi) ** 2),
    ("contact_half_angle", ("sinkage", "wheel_radius"), geometric_half_angle),
)


def derived(columns: Mapping[str, Any]) -> dict[str, Any]:
    """``columns`` (SI arrays by name) with what follows from them added.

    ``wheel_speed`` from rim speed and radius, or from the speed ratio; ``speed_ratio`` = v/(r ω), NaN
    for a locked wheel; ``sinkage`` = lever length × sin(lever angle below first touch), or
    r (1 - cos φ); ``contact_half_angle`` = acos(1 - δ/r), the geometry of equation (6) without tension.

    >>> float(derived({"slide_speed": np.array([0.0254]), "rim_speed": np.array([0.0508])})["speed_ratio"][0])
    0.5
    """
    known = dict(columns)
    for name, sources, rule in RULES:
        if name not in known and all(s in known for s in sources):
            known[name] = rule(*(known[s] for s in sources))
    return known

"""A known load that presses a plate or a wheel into tissue, and the depth that is read."""

from __future__ import annotations

import dataclasses

import numpy as np

from drawbar.rig.plate_test import STANDARD_GRAVITY
from drawbar.study.identify.reduce import Rows, require
from drawbar.tissue.winkler import Winkler

__all__ = ["Press", "press_of"]


@dataclasses.dataclass(frozen=True)
class Press:
    """A load that is known and a depth that is read, and the depth that a compliance gives."""

    reading: str
    depth: np.ndarray
    load: np.ndarray
    radius: np.ndarray | None
    regressors: Rows

    def predict(self, compliance: np.ndarray) -> np.ndarray:
        """w = c p under a plate; the sinkage δ of N = k L r² (φ - ½ sin 2φ) (and deep) under a wheel."""
        if self.radius is None:
            return compliance * self.load
        return Winkler.sinkage_under(self.load * np.maximum(compliance, 0.0), self.radius, 1.0)

    def slope(self, compliance: np.ndarray) -> np.ndarray:
        """dw/dc = p; under a wheel (N/L) / chord, since the area under it grows by its chord, 2 r sin φ."""
        if self.radius is None:
            return self.load + 0.0 * compliance
        half_angle = Winkler.half_angle(self.predict(compliance), self.radius, 1.0)
        chord = 2.0 * self.radius * np.sin(half_angle)
        return np.divide(self.load, chord, out=np.zeros_like(chord), where=chord > 0.0)

    def guess(self) -> float:
        """A compliance to start from: the loads over what compliance 1 would make of the depths."""
        if self.radius is None:
            return float(self.depth @ self.load) / float(self.load @ self.load)
        depth = np.maximum(self.depth, 0.0)
        area = Winkler.support(depth, Winkler.half_angle(depth, self.radius, 1.0), self.radius, 1.0)
        return float(area @ self.load) / float(self.load @ self.load)


def press_of(columns: Rows) -> Press:
    """The readings of a plate, or else of a wheel.

    Raises
    ------
    ValueError
        Columns are missing, there are fewer than three readings, all loads are equal, or the depth
        falls as the load rises.
    """
    wheel = {"normal_load", "wheel_radius", "wheel_width", "sinkage"}
    if "deflection" not in columns and wheel <= columns.keys():
        require(columns, dict.fromkeys(sorted(wheel), "a wheel pressed into the tissue"))
        load = columns["normal_load"] / columns["wheel_width"]
        regressors = {n: columns[n] for n in ("normal_load", "wheel_radius", "wheel_width")}
        press = Press("sinkage", columns["sinkage"], load, columns["wheel_radius"], regressors)
    else:
        weight = "applied_force" if "applied_force" in columns else "applied_mass"
        purposes = {weight: "the load on the plate; applied_force [N] will do too", "plate_area": "makes it a pressure",
                    "deflection": "how far the plate sinks"}  # fmt: skip
        require(columns, purposes)
        force = columns[weight] * (STANDARD_GRAVITY if weight == "applied_mass" else 1.0)
        pressure = force / columns["plate_area"]
        press = Press("deflection", columns["deflection"], pressure, None, {"contact_pressure": pressure})
    if press.depth.size < 3:
        raise ValueError(f"{press.depth.size} readings are too few for a stiffness and its error. Give at least 3.")
    if np.ptp(press.load) <= 1e-6 * np.max(np.abs(press.load)):
        raise ValueError(
            f"all {press.depth.size} loads are equal, so nothing shows how {press.reading} rises with load. "
            "Give readings at two or more loads."
        )
    if float(press.depth @ press.load) <= 0.0:
        raise ValueError(
            f"{press.reading} falls as the load rises: the stiffness would be negative. Depth is positive down; "
            f"turn the sign of the {press.reading} column."
        )
    return press

"""Drags of a locked wheel: what each run measured, and how the film's numbers enter its force."""

from __future__ import annotations

import dataclasses
from collections.abc import Callable, Mapping

import numpy as np
import xarray as xr

from drawbar.quantity import Quantity
from drawbar.study.identify.reduce import Rows, require
from drawbar.variables import LABELS, OBSERVATION, declare

__all__ = ["OFFSET", "Drags", "beside_fit", "drags_of"]

OFFSET = "force_offset"

Model = Callable[[np.ndarray], np.ndarray]

TURNING = 0.01
"""A wheel counts as locked while its rim is slower than this part of the slide: encoders are not perfect."""

ALIKE = 0.05
"""Loads or speeds that differ by less than this part count as one."""

PURPOSES = {
    "drawbar_force": "what the load cell reads",
    "slide_speed": "the slip of a locked wheel, negative in reverse",
    "normal_load": "tells friction from a yield stress",
    "wheel_radius": "gives the contact's length",
    "wheel_width": "the film's force is per width",
    "contact_half_angle": "how far the film reaches; sinkage, or lever_angle with lever_length, will do",
}


@dataclasses.dataclass(frozen=True)
class Drags:
    """Locked and sliding runs, one a row, SI."""

    force: np.ndarray
    speed: np.ndarray
    load: np.ndarray
    half_angle: np.ndarray
    radius: np.ndarray
    width: np.ndarray
    labels: Rows

    @property
    def ways(self) -> np.ndarray:
        """+1 forward, -1 in reverse."""
        return np.sign(self.speed)

    @property
    def both_ways(self) -> bool:
        return bool(np.any(self.speed > 0.0) and np.any(self.speed < 0.0))

    @property
    def loads_differ(self) -> bool:
        return bool(self.load.max() - self.load.min() > ALIKE * self.load.max())

    @property
    def speeds_differ(self) -> bool:
        size = np.abs(self.speed)
        return bool(size.max() - size.min() > ALIKE * size.max())

    @property
    def regressors(self) -> Rows:
        """dF/d(parameter) by name, in equation (17) with ω = 0 and the Coulomb terms of the same arc."""
        area = self.width * self.radius
        phi = self.half_angle
        return {
            "viscous_coefficient": -area * self.speed * (phi + 0.5 * np.sin(2.0 * phi)),
            "yield_stress": -self.ways * 2.0 * area * np.sin(phi),
            "friction_coefficient": -self.ways * self.load,
            OFFSET: np.ones(phi.size),
        }

    def sensitivity(self, values: Mapping[str, float]) -> np.ndarray:
        """dF/dδ [N/m]: what an error of the sinkage, and so of φ (dδ = r sin φ dφ), does to the fitted force."""
        sine, cosine = np.sin(self.half_angle), np.cos(self.half_angle)
        viscous = values["viscous_coefficient"] * self.speed * 2.0 * cosine**2
        coulomb = values.get("yield_stress", 0.0) * self.ways * 2.0 * cosine
        return -self.width * (viscous + coulomb) / np.maximum(sine, 0.01)

    def linear(self, names: tuple[str, ...]) -> tuple[Model, Model, dict[str, float]]:
        """The force as a function of the named parameters, its derivative, and a start: each as if alone."""
        design = np.stack([self.regressors[name] for name in names], axis=1)
        size = float(np.max(np.abs(self.force)))
        start = {n: size / max(float(np.max(np.abs(self.regressors[n]))), 1e-300) for n in names}
        return lambda values: design @ values, lambda values: design + 0.0 * values, start


def drags_of(columns: Mapping[str, np.ndarray]) -> tuple[Drags, list[str]]:
    """The locked, sliding runs of a log, and notes on the rows that were set aside.

    Raises
    ------
    ValueError
        A column is missing or not finite, no such runs are left, or the force pushes along the motion.
    """
    require(columns, PURPOSES)
    notes = []
    speed = columns["slide_speed"]
    count = speed.size
    turning = np.zeros(count, dtype=bool)
    if "wheel_speed" in columns:
        rim = np.nan_to_num(columns["wheel_speed"]) * columns["wheel_radius"]  # NaN: no speed ratio, locked
        turning = np.abs(rim) > TURNING * np.abs(speed)
    else:
        notes.append("the log has no wheel_speed: the wheel is taken to have been locked in every run.")
    standing = (speed == 0.0) & ~turning
    if turning.any():
        notes.append(f"{int(turning.sum())} of {count} runs were set aside: their wheel turned.")
    if standing.any():
        notes.append(f"{int(standing.sum())} of {count} runs were set aside: the slide stood still.")
    keep = ~turning & ~standing
    if not keep.any():
        raise ValueError(
            f"none of the {count} runs is a drag of a locked wheel: in {int(turning.sum())} the wheel turned, in "
            f"{int(standing.sum())} the slide stood still. The film is identified from runs with wheel_speed 0."
        )
    kept = {name: column[keep] for name, column in columns.items()}
    drags = Drags(
        force=kept["drawbar_force"],
        speed=kept["slide_speed"],
        load=kept["normal_load"],
        half_angle=kept["contact_half_angle"],
        radius=kept["wheel_radius"],
        width=kept["wheel_width"],
        labels={name: kept[name] for name in LABELS if name in kept},
    )
    _refuse_pushing(drags)
    if not drags.both_ways:
        notes.append(
            "all drags go one way: a zero error of the load cell would count as Coulomb friction. Drag both ways."
        )
    return drags, notes


def _refuse_pushing(drags: Drags) -> None:
    """Refuse forces that go with the motion by more than their scatter: a sign is wrong."""
    sides = [drags.force[drags.ways == way] for way in (1.0, -1.0) if np.any(drags.ways == way)]
    middle = 0.5 * (sides[0].mean() + sides[1].mean()) if len(sides) == 2 else 0.0
    along = drags.ways * (drags.force - middle)
    if along.mean() > 3.0 * along.std() / np.sqrt(along.size):
        raise ValueError(
            f"the drawbar_force goes with the motion, by {along.mean():.3g} N on average: a dragged locked wheel holds "
            "back, so that forward drags read negative. Turn the sign of the force or of the speed column."
        )


def beside_fit(drags: Drags, residual: np.ndarray, offset: float) -> xr.Dataset:
    """The runs beside the fit, for drawing the paper's Fig. 7.

    All loads fall on one line, τ = (τ₀ + μ_c N / (2 L r sin φ)) sign(V) + (μ/h) V, in the contact's mean
    shear stress τ = (F - F₀) / (2 L r sin φ) over V = -v (φ + ½ sin 2φ) / (2 sin φ).
    """
    terms = drags.regressors
    area = np.abs(terms["yield_stress"])
    touching = area > 0.0
    share = np.divide(terms["viscous_coefficient"], area, out=np.full(area.size, np.nan), where=touching)
    stress = np.divide(drags.force - offset, area, out=np.full(area.size, np.nan), where=touching)
    table = {
        "measured": drags.force, "fitted": drags.force - residual, "residual": residual,
        "slide_speed": drags.speed, "normal_load": drags.load, "contact_half_angle": drags.half_angle,
        "wheel_radius": drags.radius, "wheel_width": drags.width, "slip_velocity": share, "shear_stress": stress,
    }  # fmt: skip
    extra = {n: Quantity(unit="N", meaning=f"drawbar_force, {n}") for n in ("measured", "fitted", "residual")}
    extra["slip_velocity"] = Quantity(unit="m/s", symbol="V", meaning="slip of the film, mean over the contact")
    extra["shear_stress"] = Quantity(unit="Pa", symbol="τ", meaning="shear stress on the wheel, mean over the contact")
    columns = {n: (OBSERVATION, c) for n, c in (table | drags.labels).items()}
    return declare(columns, coords=list(drags.labels), attrs={"reading": "drawbar_force"}, extra=extra)

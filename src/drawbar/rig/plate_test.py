"""The virtual plate test: weights on a rigid plate of known area."""

from __future__ import annotations

from typing import Any

import numpy as np
import xarray as xr

from drawbar.quantity import Quantity, check, parameters
from drawbar.rig.sensors import Sensors
from drawbar.tissue.base import Tissue
from drawbar.variables import OBSERVATION, VARIABLES, declare

__all__ = ["STANDARD_GRAVITY", "plate_test"]

STANDARD_GRAVITY = 9.80665
"""m/s²: turns an applied mass into a force (exact by definition)."""


def plate_test(
    tissue: Tissue,
    *,
    applied_mass: Any,
    plate_area: float,
    sets: int = 3,
    spread: float = 0.0,
    sensors: Sensors | None = None,
    seed: int = 0,
    labels: dict[str, str] | None = None,
) -> xr.Dataset:
    """Lay weights on a square plate, read its deflection, turn the plate and do it again.

    The deflection w carries A p(w) under the plate and the free surface's pull along its rim,
    2 U(w)/w per length with U the law's edge energy (the laws are linear in w).

    Parameters
    ----------
    tissue
        An elastic tissue.
    applied_mass, plate_area
        Masses laid on the plate [kg]; the plate's area [m²].
    sets, spread
        How often the series is done, and the relative standard deviation of the tissue's answer from
        one place or orientation to the next.
    sensors, seed, labels
        As :func:`drawbar.drawbar_test`; the dial gauge's ``deflection_noise``.

    Returns
    -------
    xarray.Dataset
        Tidy, along ``observation``: ``applied_mass``, ``plate_area``, ``deflection``, ``trial`` (the set).
    """
    sensors = sensors or Sensors()
    masses = np.atleast_1d(check("applied_mass", applied_mass, VARIABLES["applied_mass"])).astype(float)
    area = check("plate_area", plate_area, VARIABLES["plate_area"])
    check("spread", spread, Quantity(unit="1", minimum=0, maximum=1))
    if sets < 1:
        raise ValueError(f"sets must be at least 1, got {sets}.")
    if tissue.remembers():
        raise ValueError(
            f"a plate test here takes an elastic tissue, and {type(tissue).__name__} remembers: it creeps."
        )
    one, zero = np.ones(1), np.zeros(1)
    numbers = parameters(tissue)
    rim = 4.0 * np.sqrt(area)
    stiffness = (
        area * type(tissue).pressure(one, zero, zero, *numbers) + rim * 2.0 * type(tissue).edge_energy(one, *numbers)
    )[0]
    rng = np.random.default_rng(seed)
    place = np.exp(spread * rng.normal(size=(sets, 1)))
    deflection = masses * STANDARD_GRAVITY / (stiffness * place)
    deflection = deflection + sensors.deflection_noise * rng.normal(size=deflection.shape)
    columns: dict[str, Any] = {
        "applied_mass": np.tile(masses, sets),
        "plate_area": np.full(deflection.size, area),
        "deflection": deflection.reshape(-1),
        "trial": np.repeat(np.arange(1, sets + 1), masses.size),
    }
    for name, label in (labels or {}).items():
        columns[name] = np.full(deflection.size, label)
    attrs = {"tissue_law": repr(tissue), "origin": "virtual rig", "seed": seed,
             "sensor_deflection_noise": sensors.deflection_noise}  # fmt: skip
    names = [n for n in ("tissue", "trial") if n in columns]
    return declare({n: (OBSERVATION, c) for n, c in columns.items()}, coords=names, attrs=attrs)

"""The virtual drawbar rig: a wheel on a lever, carried over tissue at a set speed."""

from __future__ import annotations

from typing import Any

import numpy as np
import xarray as xr

from drawbar.film.base import Film
from drawbar.motion.flags import explain
from drawbar.motion.planar import simulate
from drawbar.motion.steady import grid, one_drive, steady
from drawbar.quantity import quantities
from drawbar.rig.derive import derived
from drawbar.rig.sensors import Sensors
from drawbar.tissue.base import Tissue
from drawbar.variables import LABELS, OBSERVATION, declare, tidy
from drawbar.wheel.base import Wheel

__all__ = ["TRAVEL", "drawbar_test", "drawbar_test_at"]

TRAVEL = 0.20
"""Length of a run [m]: about 20 cm (Rentschler et al. 2004, section VII.A)."""

MEASURED = ("drawbar_force", "wheel_torque", "sinkage")


def drawbar_test(
    wheel: Wheel,
    tissue: Tissue,
    film: Film,
    *,
    normal_load: Any,
    speed: Any,
    speed_ratio: Any = None,
    wheel_speed: Any = None,
    wheel_torque: Any = None,
    repeats: int = 1,
    sensors: Sensors | None = None,
    seed: int = 0,
    travel: float = TRAVEL,
    history: bool = False,
    damper: float = 0.0,
    labels: dict[str, str] | None = None,
) -> xr.Dataset:
    """Run the virtual rig over every combination of loads, speeds and drives, with repeats.

    Each run drags or lets drive a wheel over ``travel`` of fresh tissue. Without ``history`` a run is
    one observation: the mean of its samples in steady rolling (noise therefore falls with the root of
    their number; a zero error does not). With it, a run is its samples over time, from touch-down.

    Parameters
    ----------
    wheel, tissue, film
        What is on the rig.
    normal_load, speed
        Numbers or lists [N], [m/s]; a negative speed is a reverse drag.
    speed_ratio, wheel_speed, wheel_torque
        Exactly one, a number or a list; ``wheel_speed=0`` locks the wheel, ``wheel_torque=0`` lets it
        roll freely.
    repeats
        Runs of each setting.
    sensors, seed
        What the sensors add, and the seed of chance. None is a perfect rig.
    travel
        Length of a run [m]; sets how many samples a mean holds, and how long a history is.
    history, damper
        Time histories, and the lever's damping [N s/m] that ends the bounce after touch-down (0: it
        goes on; the paper names none).
    labels
        Names of ``wheel``, ``tissue`` and ``film`` in the Dataset.

    Returns
    -------
    xarray.Dataset
        Tidy, along ``observation``: the settings, ``drawbar_force``, ``wheel_torque``, ``sinkage``,
        ``contact_half_angle``, ``trial``, with ``time`` for histories. The same names, units and signs
        as :func:`drawbar.load` gives.

    Raises
    ------
    ValueError
        A number is out of bounds, or a history of a standing carriage is asked for.
    """
    drive, given = one_drive(speed_ratio=speed_ratio, wheel_speed=wheel_speed, wheel_torque=wheel_torque)
    if repeats < 1:
        raise ValueError(f"repeats must be at least 1, got {repeats}.")
    sensors = sensors or Sensors()
    axes = {"normal_load": normal_load, "speed": speed, drive: given}
    settings: dict[str, Any] = grid(**axes)
    truth = _histories if history else _means
    runs, samples, notes = truth(wheel, tissue, film, settings, travel, sensors, damper)
    measured = [
        _measure(runs, samples, trial, sensors, np.random.default_rng([seed, trial])) for trial in range(repeats)
    ]
    columns = {name: np.concatenate([m[name] for m in measured]) for name in measured[0]}
    columns |= {name: np.full(columns["trial"].shape, number) for name, number in
                (("wheel_radius", wheel.radius), ("wheel_width", wheel.width))}  # fmt: skip
    columns = derived(columns)
    for name, label in (labels or {}).items():
        columns[name] = np.full(columns["trial"].shape, label)
    attrs = {"wheel_law": repr(wheel), "tissue_law": repr(tissue), "film_law": repr(film), "origin": "virtual rig",
             "seed": seed, **{f"sensor_{n}": getattr(sensors, n) for n in quantities(sensors)}}  # fmt: skip
    if notes:
        attrs["notes"] = "; ".join(notes)
    if history:
        attrs["damping"] = f"lever damper {damper:g} N s/m" if damper else "nothing damps the settling"
    names = [n for n in ("wheel", "tissue", "film", "trial") if n in columns]
    return declare({n: (OBSERVATION, c) for n, c in columns.items()}, coords=names, attrs=attrs)


def drawbar_test_at(dataset: xr.Dataset, wheel: Wheel, tissue: Tissue, film: Film) -> xr.Dataset:
    """The virtual rig at the settings of a log, row by row: what to put beside a measurement.

    Parameters
    ----------
    dataset
        Rows with ``normal_load``, ``slide_speed`` and ``wheel_speed``, such as :func:`drawbar.load` gives.
    wheel, tissue, film
        What the model takes the wheel, the ground and the film to be.

    Returns
    -------
    xarray.Dataset
        The rows' settings and labels, and the model's ``drawbar_force``, ``wheel_torque``, ``sinkage``
        and ``contact_half_angle`` in steady rolling.

    Raises
    ------
    ValueError
        A setting is missing.
    """
    rows = tidy(dataset)
    needed = ("normal_load", "slide_speed", "wheel_speed")
    missing = [name for name in needed if name not in rows]
    if missing:
        raise ValueError(
            f"the log lacks {', '.join(missing)}. The rig runs at {', '.join(needed)}; a wheel speed also follows "
            "from rim_speed or speed_ratio once wheel_radius is known."
        )
    settings = {name: rows[name].reset_coords(drop=True) for name in needed}
    result = steady(
        wheel, tissue, film, normal_load=settings["normal_load"], speed=settings["slide_speed"],
        wheel_speed=settings["wheel_speed"],
    )  # fmt: skip
    columns = {name: result[name] for name in (*needed, "speed_ratio", *MEASURED, "contact_half_angle")}
    columns |= {name: rows[name] for name in LABELS if name in rows.variables and name != "film"}
    columns = {name: (OBSERVATION, column.values) for name, column in columns.items()}
    attrs = {"wheel_law": repr(wheel), "tissue_law": repr(tissue), "film_law": repr(film), "origin": "virtual rig"}
    return declare(columns, coords=[n for n in LABELS if n in columns], attrs=attrs)


def _means(
    wheel: Wheel,
    tissue: Tissue,
    film: Film,
    settings: dict[str, Any],
    travel: float,
    sensors: Sensors,
    _: float,
) -> tuple[dict[str, np.ndarray], np.ndarray, list[str]]:
    """The true steady values of each setting, how many samples its mean holds, and what is worth knowing."""
    result = steady(wheel, tissue, film, **settings)
    rows = tidy(result)
    columns = {n: rows[n].values for n in ("normal_load", "slide_speed", "wheel_speed", "speed_ratio", *MEASURED)}
    with np.errstate(divide="ignore"):
        seconds = np.minimum(travel / np.abs(columns["slide_speed"]), 3600.0)
    return columns, np.maximum(np.floor(seconds * sensors.sampling_rate), 1.0), explain(result)


def _histories(
    wheel: Wheel,
    tissue: Tissue,
    film: Film,
    settings: dict[str, Any],
    travel: float,
    sensors: Sensors,
    damper: float,
) -> tuple[dict[str, np.ndarray], np.ndarray, list[str]]:
    """The true course of each setting, one sample a row."""
    names = list(settings)
    parts = []
    for point in np.stack(np.meshgrid(*(settings[n].values for n in names), indexing="ij"), -1).reshape(-1, len(names)):
        setting = dict(zip(names, point.tolist(), strict=True))
        if setting["speed"] == 0.0:
            raise ValueError("a time history needs a speed other than 0: the run ends after its travel.")
        run = simulate(wheel, tissue, film, **setting, duration=travel / abs(setting["speed"]),
                       interval=1.0 / sensors.sampling_rate, damper=damper)  # fmt: skip
        columns = {n: run[n].values for n in ("time", "slide_speed", "wheel_speed", *MEASURED)}
        columns["normal_load"] = np.full(run.time.shape, setting["normal_load"])
        parts.append(derived(columns | {"wheel_radius": wheel.radius}))
    keep = ("time", "normal_load", "slide_speed", "wheel_speed", "speed_ratio", *MEASURED)
    columns = {n: np.concatenate([np.broadcast_to(p[n], p["time"].shape) for p in parts]) for n in keep}
    columns["run"] = np.repeat(np.arange(len(parts)), [p["time"].size for p in parts])
    return columns, np.ones(columns["run"].size), []


def _measure(
    truth: dict[str, np.ndarray], samples: np.ndarray, trial: int, sensors: Sensors, rng: np.random.Generator
) -> dict[str, np.ndarray]:
    """One trial of every run as the sensors see it."""
    columns = dict(truth)
    run = columns.pop("run", np.arange(samples.size))

    def seen(true: np.ndarray, noise: float, bias: float) -> np.ndarray:
        zero = rng.normal(0.0, 1.0, int(run.max()) + 1)[run]
        return true + noise / np.sqrt(samples) * rng.normal(0.0, 1.0, true.shape) + bias * zero

    columns["drawbar_force"] = seen(columns["drawbar_force"], sensors.force_noise, sensors.force_bias)
    columns["wheel_torque"] = seen(columns["wheel_torque"], sensors.torque_noise, 0.0)
    if sensors.angle_noise or sensors.angle_bias:
        angle = np.arcsin(np.clip(columns["sinkage"] / sensors.lever_length, -1.0, 1.0))
        angle = seen(angle, sensors.angle_noise, sensors.angle_bias)
        columns["sinkage"] = sensors.lever_length * np.sin(angle)
    columns["trial"] = np.full(run.shape, trial + 1)
    return columns

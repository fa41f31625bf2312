"""The example logs that the package ships, one of each kind: made by the virtual rig, and labelled as such.

``python -m drawbar.study.paper.examples`` makes them anew.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from pathlib import Path

import numpy as np
import xarray as xr

from drawbar.files import refuse_existing, write_whole
from drawbar.rig.drawbar_test import drawbar_test
from drawbar.rig.write import write_csv
from drawbar.sources.rentschler_2004 import ASSUMED, LOADS, PRINTED, SPEED_RATIOS, WEIGHT
from drawbar.study.paper.model import laws, wheel_of_width
from drawbar.study.paper.reproduce import SEED, SENSORS, drags, plates
from drawbar.units import factor

__all__ = ["EXAMPLES", "copy_examples", "example_log"]

FOLDER = Path(__file__).parents[2] / "logs"

DIGITS = 5  # significant, as a laboratory's display would show

# Units as a laboratory would write them.
UNITS = {"deflection": "mm", "plate_area": "mm^2", "applied_mass": "g", "slide_speed": "mm/s", "normal_load": "gf",
         "drawbar_force": "mN", "wheel_radius": "mm", "wheel_width": "mm", "contact_half_angle": "deg",
         "wheel_torque": "mN m", "sinkage": "mm", "time": "s"}  # fmt: skip


def _runs(**options: object) -> xr.Dataset:
    tissue, film = laws("foam")
    settings: dict[str, object] = {"normal_load": np.array(LOADS) * WEIGHT, "speed_ratio": SPEED_RATIOS, "repeats": 3}
    return drawbar_test(
        wheel_of_width(ASSUMED["wheel_width"].value),
        tissue,
        film,
        **{
            "speed": PRINTED["slide_speed"].value,
            "sensors": SENSORS,
            "seed": SEED,
            "labels": {"wheel": "smooth", "tissue": "foam"},
            **settings,
            **options,
        },  # type: ignore[arg-type]
    )


def _history() -> xr.Dataset:
    slow = {name: getattr(SENSORS, name) for name in ("force_noise", "force_bias", "torque_noise", "angle_noise")}
    return _runs(
        normal_load=WEIGHT,
        speed_ratio=0.5,
        repeats=2,
        history=True,
        damper=ASSUMED["lever_damper"].value,
        sensors=type(SENSORS)(**slow, sampling_rate=20.0),
    )


EXAMPLES: Mapping[str, tuple[Callable[[], xr.Dataset], tuple[str, ...]]] = {
    "plates": (lambda: plates("foam"), ("applied_mass", "plate_area", "deflection", "tissue", "trial")),
    "drags": (
        lambda: drags("liver"),
        ("slide_speed", "wheel_speed", "normal_load", "drawbar_force", "contact_half_angle", "wheel_radius",
         "wheel_width", "wheel", "tissue", "trial"),
    ),
    "runs": (
        _runs,
        ("slide_speed", "speed_ratio", "normal_load", "drawbar_force", "wheel_torque", "sinkage", "wheel_radius",
         "wheel_width", "wheel", "tissue", "trial"),
    ),
    "history": (
        _history,
        ("time", "slide_speed", "speed_ratio", "normal_load", "drawbar_force", "sinkage", "wheel_radius",
         "wheel_width", "wheel", "tissue", "trial"),
    ),
}  # fmt: skip
"""By name: how a log is made, and the columns that a laboratory would have logged."""


def example_log(name: str) -> Path:
    """The path of a shipped example log: ``plates``, ``drags``, ``runs`` or ``history``.

    >>> example_log("plates").name
    'plates.csv'
    """
    if name not in EXAMPLES:
        raise ValueError(f"no example log is called '{name}'. There are: {', '.join(EXAMPLES)}.")
    return FOLDER / f"{name}.csv"


def copy_examples(out: Path, *, force: bool = False) -> list[Path]:
    """Copy the example logs to a folder."""
    targets = [out / example_log(name).name for name in EXAMPLES]
    refuse_existing(*targets, force=force)
    return [write_whole(t, example_log(t.stem).read_bytes(), force=force) for t in targets]


def make(name: str, folder: Path) -> Path:
    """Run the virtual rig and write one example log."""
    run, columns = EXAMPLES[name]
    rows = run()[list(columns)]
    for column, unit in UNITS.items():
        if column in rows.variables:
            shown = rows[column].values / factor(unit, rows[column].attrs["units"])
            digits = DIGITS - 1 - np.floor(np.log10(np.maximum(np.abs(shown), 1e-12)))
            rounded = [round(float(v), int(d)) for v, d in zip(shown, digits, strict=True)]
            rows[column] = (rows[column].dims, rounded, {"units": unit})
    rows.attrs = {"origin": "virtual rig"}
    comment = f"made by the virtual rig of drawbar, not in a laboratory; seed {SEED}"
    return write_csv(rows, folder / f"{name}.csv", force=True, comments=[comment])


if __name__ == "__main__":
    for each in EXAMPLES:
        print(make(each, FOLDER))

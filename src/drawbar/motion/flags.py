"""Where a steady result leaves what its laws were made for, or what a tissue is known to bear."""

from __future__ import annotations

import dataclasses
from collections.abc import Callable, Mapping
from typing import Any

import numpy as np
import xarray as xr

from drawbar.film.base import Film
from drawbar.sources import bowel_grasping_2021
from drawbar.tissue.base import Tissue

__all__ = ["FLAGS", "Flag", "explain", "raised"]

Columns = Mapping[str, Any]


@dataclasses.dataclass(frozen=True)
class Flag:
    """A condition worth knowing: its name, what it means in words, and the test on a result's columns."""

    name: str
    meaning: str
    test: Callable[[Columns, Tissue, Film], Any]


def _slip(columns: Columns) -> Any:
    """Largest slip velocity along the arc [m/s]: at the lowest point or at an edge."""
    rim, v = columns["wheel_radius"] * columns["wheel_speed"], columns["slide_speed"]
    edge = np.sqrt(np.maximum(1.0 - (columns["front_edge"] / columns["wheel_radius"]) ** 2, 0.0))
    return np.maximum(np.abs(rim - v), np.abs(rim - v * edge))


def _outside(numbers: Any, limits: tuple[float, float] | None) -> Any:
    return np.zeros(np.shape(numbers), bool) if limits is None else (numbers < limits[0]) | (numbers > limits[1])


STEEP = 1.5
"""rad. Up to here the ledger of a spring-pot closes to 3e-3 at worst (exponent 0.95), to 1e-5 at 1.45 rad."""

INJURY = bowel_grasping_2021.PRINTED["injury_pressure_low"]

FLAGS: tuple[Flag, ...] = (
    Flag(
        "deep_contact",
        "the axle is below the surface: the contact has vertical faces",
        lambda c, *_: c["sinkage"] > c["wheel_radius"],
    ),
    Flag("submerged", "the wheel is deeper than its diameter", lambda c, *_: c["sinkage"] > 2.0 * c["wheel_radius"]),
    Flag(
        "film_speed_out_of_range",
        "the slip velocity is outside the range in which the film was measured",
        lambda c, _, film: _outside(_slip(c), film.range()["slip_velocity"]),
    ),
    Flag(
        "film_pressure_out_of_range",
        "the contact pressure is outside the range in which the film was measured",
        lambda c, _, film: _outside(c["peak_pressure"], film.range()["pressure"]),
    ),
    Flag(
        "steep_edge",
        f"the front edge is steeper than {STEEP} rad, where the loss of a law without instant stiffness is uncertain",
        lambda c, tissue, _: (c["contact_half_angle"] > STEEP) & (not tissue.deep),
    ),
    Flag(
        "injury_pressure",
        f"the peak pressure is above {INJURY.value / 1e3:g} kPa, which injures human bowel grasped for 10 s "
        f"({bowel_grasping_2021.CITATION}); other tissues may bear less",
        lambda c, *_: c["peak_pressure"] > INJURY.value,
    ),
)
"""In the order of their bits, from 1."""


def raised(columns: Columns, tissue: Tissue, film: Film) -> Any:
    """The flags of each operating point as a bit mask, bit i for ``FLAGS[i]``."""
    mask = np.zeros(np.shape(columns["sinkage"]))
    for bit, flag in enumerate(FLAGS):
        mask = mask + np.where(flag.test(columns, tissue, film), 2.0**bit, 0.0)
    return mask


def attributes() -> dict[str, Any]:
    """What a ``flags`` variable carries so that others can read it (CF conventions, section 3.5)."""
    return {
        "long_name": "conditions worth knowing",
        "flag_masks": np.array([2**bit for bit in range(len(FLAGS))]),
        "flag_meanings": " ".join(flag.name for flag in FLAGS),
    }


def explain(dataset: xr.Dataset) -> list[str]:
    """One sentence for each flag that is raised somewhere in a result, with how often."""
    if "flags" not in dataset:
        return []
    masks = np.asarray(dataset["flags"].values).astype(int).ravel()
    told = []
    for bit, flag in enumerate(FLAGS):
        count = int(np.count_nonzero(masks & 2**bit))
        if count:
            told.append(f"{flag.meaning} (in {count} of {masks.size})")
    return told

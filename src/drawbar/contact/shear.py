"""The film at one node of the arc: slip velocity, shear stress, and its share of the wrench."""

from __future__ import annotations

from typing import Any

import numpy as np

from drawbar.contact.bind import unbound
from drawbar.elementwise import where

__all__ = ["add_shear"]

shear_stress = unbound


def add_shear(
    sums: Any,
    cosine: Any,
    sine: Any,
    pressure: Any,
    length: Any,
    rim: Any,
    speed: Any,
    vy: Any,
    radius: Any,
    film: Any,
) -> Any:
    """``sums`` (along, upward, side, torque, loss, each per width) with a node of arc ``length`` added.

    V = r ω - v cos θ along the arc and -v_y across it; the stress acts against the whole slip. A template
    (see :mod:`drawbar.contact.bind`): ``shear_stress`` is the bound film's.
    """
    along, upward, side, torque, loss = sums
    slip = rim - speed * cosine
    size = np.sqrt(slip * slip + vy * vy)
    pull = length * shear_stress(size, pressure, *film) / where(size > 0.0, size, 1.0)
    return (
        along + pull * slip * cosine,
        upward + pull * slip * sine,
        side - pull * vy,
        torque + pull * slip * radius,
        loss + pull * size * size,
    )

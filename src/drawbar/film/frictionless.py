"""No shear at all: the limit that isolates what the tissue does."""

from __future__ import annotations

from typing import Any

from drawbar.film.base import Film
from drawbar.quantity import value

__all__ = ["Frictionless"]


@value
class Frictionless(Film):
    """A film without shear: τ = 0. Valid as the limit of a perfect lubricant."""

    @staticmethod
    def shear_stress(slip_velocity: Any, pressure: Any) -> Any:
        """τ = 0."""
        return 0.0 * slip_velocity

"""Winkler's foundation: independent elastic columns."""

from __future__ import annotations

from typing import Any

import numpy as np

from drawbar.elementwise import where
from drawbar.quantity import quantity, value
from drawbar.tissue.base import Tissue, geometric_half_angle

__all__ = ["Winkler", "kepler_half_angle", "segment"]


def segment(half_angle: Any) -> Any:
    """Area of a circular segment over r²: φ - sin φ cos φ, for φ [rad].

    Below 0.1 rad by its series (2/3) φ³ (1 - φ²/5 + 2φ⁴/105 - φ⁶/945), whose first neglected term
    is below 1e-15 there, since the difference cancels.
    """
    s = half_angle * half_angle
    series = half_angle * s * (2.0 / 3.0) * (1.0 - s / 5.0 * (1.0 - s * (2.0 / 21.0) * (1.0 - s / 18.0)))
    return where(half_angle < 0.1, series, half_angle - np.sin(half_angle) * np.cos(half_angle))


def kepler_half_angle(area: Any) -> Any:
    """The φ [rad] in [0, π/2] whose circular segment has this ``area`` / r²: inverse of :func:`segment`.

    With E = 2φ it is Kepler's equation at eccentricity 1, E - sin E = 2 area. The start is the cube
    root with two terms of its series in M = 2 area, good to 0.4 %; three Halley steps (cubic
    convergence) then reach rounding for every area between 0 and π/2.
    """
    root = np.cbrt(1.5 * np.maximum(area, 0.0))
    phi = root * (1.0 + root * root * (1.0 / 15.0 + root * root * (1.0 / 175.0)))
    phi = np.minimum(phi, 0.5 * np.pi)
    for _ in range(3):
        sine = np.sin(phi)
        first = np.maximum(2.0 * sine * sine, 1e-300)  # d(segment)/dφ = 1 - cos 2φ
        step = (segment(phi) - area) / first
        phi = phi - step / (1.0 - step * np.cos(phi) / np.maximum(sine, 1e-150))
    return phi


@value
class Winkler(Tissue):
    """Elastic tissue without surface tension: pressure proportional to indentation, column by column.

    p = k w. A rigid wheel of radius r and width L at sinkage δ (axle at y = δ - r below the surface)
    carries N = k L [r² (φ - sin φ cos φ)] while y < 0, and N = k L (π r²/2 + 2 r y) in deep contact.

    Valid for: small slopes of the surface; tissue thick against the sinkage; no time dependence. Deep
    contact is the source's own extension (vertical flanks carry no pressure).

    Source: Rentschler et al. 2004, equation (1) with T = 0, (4), (6), (12).

    >>> round(float(Winkler.sinkage_under(13.734, 0.0075, 225000.0)), 6)   # 0.27468 N on 20 mm
    0.00566
    """

    stiffness: float = quantity(
        "Pa/m", symbol="k", above=0, meaning="foundation modulus: pressure per indentation",
        advice="Check the unit and the sign of the load column.",
    )  # fmt: skip

    @staticmethod
    def half_angle(sinkage: Any, radius: Any, stiffness: Any) -> Any:
        return geometric_half_angle(sinkage, radius)

    @staticmethod
    def pressure(deflection: Any, slope: Any, curvature: Any, stiffness: Any) -> Any:
        """p = k w."""
        return stiffness * deflection

    @staticmethod
    def energy_density(deflection: Any, slope: Any, stiffness: Any) -> Any:
        """k w² / 2."""
        return 0.5 * stiffness * deflection * deflection

    @staticmethod
    def edge_energy(deflection: Any, stiffness: Any) -> Any:
        """None: columns outside the contact are at rest."""
        return 0.0 * deflection

    @staticmethod
    def support(sinkage: Any, half_angle: Any, radius: Any, stiffness: Any) -> Any:
        """N/L = k [r² (φ - sin φ cos φ) + 2 r max(y, 0)], y = δ - r."""
        return stiffness * radius * (radius * segment(half_angle) + 2.0 * np.maximum(sinkage - radius, 0.0))

    @staticmethod
    def sinkage_under(reaction: Any, radius: Any, stiffness: Any) -> Any:
        """Inverse of :meth:`support`, to rounding."""
        area = reaction / (stiffness * radius * radius)
        deep = np.maximum(area - 0.5 * np.pi, 0.0)
        phi = kepler_half_angle(np.minimum(area, 0.5 * np.pi))
        return radius * (2.0 * np.sin(0.5 * phi) ** 2 + 0.5 * deep)

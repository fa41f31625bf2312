"""The Filonenko-Borodich foundation: elastic columns under a membrane in tension."""

from __future__ import annotations

from typing import Any

import numpy as np

from drawbar.elementwise import where
from drawbar.quantity import quantity, value
from drawbar.tissue.base import Tissue
from drawbar.tissue.winkler import Winkler, segment

__all__ = ["FilonenkoBorodich"]


@value
class FilonenkoBorodich(Tissue):
    """Elastic tissue under a stretched membrane, whose surface also gives way beside the wheel.

    q = k w - T w''. Outside the contact the free surface decays as exp(-s/ℓ), ℓ = sqrt(T/k); it
    leaves the wheel with continuous slope, which puts the edge at tan φ = w(a)/ℓ. Then
    N = k L [r² (φ - sin φ cos φ) + 2 (a + ℓ) ℓ tan φ], a = r sin φ. The contact never reaches
    φ = π/2 while T > 0: tension removes the deep case. T = 0 is :class:`~drawbar.Winkler`.

    Valid for: as Winkler; the membrane's tension does not change with its deflection.

    Source: Rentschler et al. 2004, equation (1) with T kept (the source drops it after equation (1)),
    solved here with a slope-continuous edge, so that no line force stands at the edge.

    >>> tissue = FilonenkoBorodich(stiffness=225e3, tension=225e3 * (0.25 * 0.0075) ** 2)
    >>> sinkage = FilonenkoBorodich.sinkage_under(0.685208 * 225e3 * 0.0075**2, 0.0075, 225e3, tissue.tension)
    >>> round(float(FilonenkoBorodich.half_angle(sinkage, 0.0075, 225e3, tissue.tension)), 5)
    0.75
    """

    stiffness: float = quantity(
        "Pa/m", symbol="k", above=0, meaning="foundation modulus: pressure per indentation",
        advice="Check the unit and the sign of the load column.",
    )  # fmt: skip
    tension: float = quantity("N/m", symbol="T", minimum=0, meaning="tension of the surface membrane per width")

    @staticmethod
    def half_angle(sinkage: Any, radius: Any, stiffness: Any, tension: Any) -> Any:
        """The root of ℓ tan φ = y + r cos φ, y = δ - r.

        In t = tan φ, f(t) = ℓ t - r / sqrt(1 + t²) - y rises and has one inflection, at t = 1/√2:
        Newton's method from there runs to the root from one side, whatever the numbers. The cap on t
        is the deep contact of vanishing tension.
        """
        length = np.sqrt(tension / stiffness)
        y = sinkage - radius
        t = np.sqrt(0.5) + 0.0 * (sinkage + radius + length)
        for _ in range(60):
            secant = np.sqrt(1.0 + t * t)
            slope = length + radius * t / (secant * secant * secant)
            t = t - (length * t - radius / secant - y) / np.maximum(slope, 1e-300)
            t = np.minimum(np.maximum(t, 0.0), 1e12)
        return where(sinkage > 0.0, np.arctan(t), 0.0)

    @staticmethod
    def pressure(deflection: Any, slope: Any, curvature: Any, stiffness: Any, tension: Any) -> Any:
        """q = k w - T w''."""
        return stiffness * deflection - tension * curvature

    @staticmethod
    def energy_density(deflection: Any, slope: Any, stiffness: Any, tension: Any) -> Any:
        """k w² / 2 + T w'² / 2: the energy whose variation gives equation (1)."""
        return 0.5 * (stiffness * deflection * deflection + tension * slope * slope)

    @staticmethod
    def edge_energy(deflection: Any, stiffness: Any, tension: Any) -> Any:
        """k ℓ w² / 2 = sqrt(k T) w² / 2: columns and membrane of one exponential flank."""
        return 0.5 * np.sqrt(stiffness * tension) * deflection * deflection

    @staticmethod
    def support(sinkage: Any, half_angle: Any, radius: Any, stiffness: Any, tension: Any) -> Any:
        """N/L = k [r² (φ - sin φ cos φ) + 2 (a + ℓ) w_a], w_a = δ - r (1 - cos φ) at the edge."""
        length = np.sqrt(tension / stiffness)
        edge = np.maximum(sinkage - 2.0 * radius * np.sin(0.5 * half_angle) ** 2, 0.0)
        flank = 2.0 * (radius * np.sin(half_angle) + length) * edge
        return stiffness * (radius * radius * segment(half_angle) + flank)

    @staticmethod
    def sinkage_under(reaction: Any, radius: Any, stiffness: Any, tension: Any) -> Any:
        """δ = r (1 - cos φ) + ℓ tan φ at the φ whose support is the ``reaction``.

        Newton's method on ln N over ln tan φ, kept inside a shrinking bracket: N is a sum of powers
        of tan φ, so its logarithm is nearly straight; where it is not, the bracket is halved.
        """
        length = np.sqrt(tension / stiffness)
        target = np.log(np.maximum(reaction, 1e-300) / stiffness)
        low = -110.0 + 0.0 * (target + radius + length)
        high = 30.0 + 0.0 * low
        s = 0.0 * low
        for _ in range(48):
            t = np.exp(s)
            secant = np.sqrt(1.0 + t * t)
            phi = np.arctan(t)
            sine = t / secant
            support = radius * radius * segment(phi) + 2.0 * (radius * sine + length) * length * t
            grows = 2.0 * (radius * sine / secant) ** 2 + 2.0 * length * (
                radius * sine * (1.0 + 1.0 / (secant * secant)) + length
            )
            error = np.log(support) - target
            low = where(error < 0.0, s, low)
            high = where(error < 0.0, high, s)
            step = s - error * support / (t * grows)
            s = where((step > low) & (step < high), step, 0.5 * (low + high))
        t = np.exp(s)
        sinkage = 2.0 * radius * np.sin(0.5 * np.arctan(t)) ** 2 + length * t
        slack = Winkler.sinkage_under(reaction, radius, stiffness)  # without tension there is a deep case
        return where(reaction > 0.0, where(tension > 0.0, sinkage, slack), 0.0)

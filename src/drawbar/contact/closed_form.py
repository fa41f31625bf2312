"""The source's own integrals, written independently of the node sums: oracles for tests and reports.

Everything is per the source's assumptions: a rigid circular wheel, a symmetric contact of half angle φ
[rad], SI units, arrays broadcast. ``speed_ratio`` is v/(r ω), the source's "slip ratio", equation (20).
"""

from __future__ import annotations

from typing import Any

import numpy as np

__all__ = [
    "drawbar_number",
    "reaction_deep",
    "reaction_shallow",
    "reaction_tension",
    "torque_number",
    "zero_drawbar_speed_ratio",
]


def reaction_shallow(phi: Any, stiffness: Any, width: Any, radius: Any) -> Any:
    """N = k L r² (φ - sin 2φ / 2) [N]: equation (4) with (6), axle above the surface.

    Loses digits to cancellation as φ → 0 (relative error about 1e-16/φ²).

    >>> round(float(reaction_shallow(0.75, 1.0, 1.0, 1.0)), 6)
    0.251253
    """
    return stiffness * width * radius**2 * (phi - 0.5 * np.sin(2.0 * phi))


def reaction_deep(sinkage: Any, stiffness: Any, width: Any, radius: Any) -> Any:
    """N = k L (π r²/2 + 2 r y) [N], y = δ - r >= 0: equation (4) with a = r, as in (12)."""
    return stiffness * width * (0.5 * np.pi * radius**2 + 2.0 * radius * (sinkage - radius))


def reaction_tension(phi: Any, stiffness: Any, width: Any, radius: Any, decay_length: Any) -> Any:
    """N = k L [r² (φ - sin φ cos φ) + 2 (a + ℓ) ℓ tan φ] [N], a = r sin φ, ℓ = sqrt(T/k).

    Equation (1) with T kept and a slope-continuous edge (this project's).

    >>> round(float(reaction_tension(0.75, 1.0, 1.0, 1.0, 0.25)), 6)
    0.685208
    """
    sine, cosine = np.sin(phi), np.cos(phi)
    flank = 2.0 * (radius * sine + decay_length) * decay_length * sine / cosine
    return stiffness * width * (radius**2 * (phi - sine * cosine) + flank)


def drawbar_number(phi: Any, speed_ratio: Any) -> Any:
    """F / [(μ/h) L r v] = 2 sin φ / SR - φ - sin 2φ / 2: equation (17) at steady rolling.

    >>> [round(float(drawbar_number(0.75, s)), 6) for s in (0.5, 1.0, 1.5)]
    [1.477808, 0.11453, -0.339896]
    """
    return 2.0 * np.sin(phi) / speed_ratio - phi - 0.5 * np.sin(2.0 * phi)


def torque_number(phi: Any, speed_ratio: Any) -> Any:
    """T / [(μ/h) L r² v] = 2 (φ / SR - sin φ): equation (15) at steady rolling.

    >>> [round(float(torque_number(0.75, s)), 6) for s in (0.5, 1.0, 1.5)]
    [1.636722, 0.136722, -0.363278]
    """
    return 2.0 * (phi / speed_ratio - np.sin(phi))


def zero_drawbar_speed_ratio(phi: Any) -> Any:
    """The speed ratio at which a viscous film neither pulls nor drags: 2 sin φ / (φ + sin 2φ / 2).

    It is above 1: the rim's forward speed is v cos θ short of v away from the lowest point.

    >>> round(float(zero_drawbar_speed_ratio(0.75)), 5)
    1.09172
    """
    return 2.0 * np.sin(phi) / (phi + 0.5 * np.sin(2.0 * phi))

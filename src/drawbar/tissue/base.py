"""What every tissue is: a law that answers an indentation with a pressure.

A law is a frozen value plus *kernels*: static methods that are plain functions of numbers, written with
NumPy's elementwise functions so that the same source serves arrays, single numbers and the compiler.
A kernel takes its state first and then the law's quantities in the order of their declaration.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any, ClassVar

import numpy as np

__all__ = ["Tissue", "geometric_half_angle"]


def geometric_half_angle(sinkage: Any, radius: Any) -> Any:
    """Half contact angle of a circle pressed by ``sinkage`` [m] below an undisturbed plane, rad.

    φ = 2 asin sqrt(δ / 2r), which is acos(1 - δ/r) without its cancellation at small sinkage;
    0 above the surface, π/2 once the axle is below it (deep contact).

    Source: Rentschler et al. 2004, equations (6) and (16).
    """
    return 2.0 * np.arcsin(np.sqrt(np.minimum(np.maximum(sinkage / (2.0 * radius), 0.0), 0.5)))


class Tissue:
    """Base of all tissues. A subclass is one file, decorated with :func:`drawbar.quantity.value`.

    ``registry`` holds every law by class name: defining a subclass is what adds it.
    """

    registry: ClassVar[dict[str, type[Tissue]]] = {}

    def __init_subclass__(cls) -> None:
        Tissue.registry[cls.__name__] = cls

    # Kernels of an elastic law. A law with memory gives `spectrum` or `power_law` in their place.
    half_angle: ClassVar[Callable[..., Any]]
    """Half contact angle [rad] at (sinkage [m], radius [m], ...); 0 out of contact."""

    pressure: ClassVar[Callable[..., Any]]
    """Contact pressure [Pa] under (deflection w [m] down, slope w', curvature w'' [1/m], ...)."""

    energy_density: ClassVar[Callable[..., Any]]
    """Elastic energy per area of surface [J/m²] at (deflection [m], slope, ...)."""

    edge_energy: ClassVar[Callable[..., Any]]
    """Elastic energy per width [J/m] of the free surface beyond one edge at (its deflection [m], ...)."""

    support: ClassVar[Callable[..., Any] | None] = None
    """Exact reaction per width [N/m] at (sinkage, half_angle, radius, ...), or None: sum over nodes."""

    sinkage_under: ClassVar[Callable[..., Any] | None] = None
    """Exact sinkage [m] under (reaction per width [N/m], radius [m], ...), or None: solve for it."""

    spectrum: ClassVar[Callable[..., Any] | None] = None
    """For a tissue with fading memory: (long-term stiffness k, viscosity c, branch stiffnesses k_i,
    relaxation times τ_i) of p = k w + c w' + Σ k_i e_i, e_i' = w' - e_i/τ_i. None: no memory."""

    deep: ClassVar[bool] = True
    """Whether the law has a finite answer to the sudden indentation by the vertical face of deep contact."""

    power_law: ClassVar[Callable[..., Any] | None] = None
    """For a tissue whose memory fades as a power: (long-term stiffness k, coefficient C, exponent α) of the
    relaxation function K(t) = k + C t^{-α}, t in seconds. None: it does not."""

    @classmethod
    def remembers(cls) -> bool:
        """Whether the pressure depends on what came before: then rolling resists and a plate creeps."""
        return cls.spectrum is not None or cls.power_law is not None

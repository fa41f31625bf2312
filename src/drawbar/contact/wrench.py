"""A wheel's state in, the contact's wrench out."""

from __future__ import annotations

import dataclasses
from typing import Any

import numpy as np

from drawbar.contact.kernel import Forces, contact_kernel
from drawbar.elementwise import where
from drawbar.film.base import Film
from drawbar.quantity import parameters, quantity, value
from drawbar.tissue.base import Tissue
from drawbar.wheel.base import Wheel

__all__ = ["State", "Wrench", "refuse_deep", "wrench"]


@value
class State:
    """How a wheel moves against the ground: x along its heading, y along its axle, z out of the tissue.

    Every entry is a float or an array; arrays broadcast against each other and the laws' numbers.
    """

    sinkage: float = quantity("m", symbol="δ", meaning="depth of the wheel's lowest point, positive down")
    sink_rate: float = quantity("m/s", default=0.0, meaning="rate of the sinkage; an elastic tissue does not feel it")
    vx: float = quantity("m/s", default=0.0, meaning="speed of the axle along the heading")
    vy: float = quantity("m/s", default=0.0, meaning="speed of the axle sideways")
    omega: float = quantity("rad/s", symbol="ω", default=0.0, meaning="wheel speed, positive when driving forward")


@dataclasses.dataclass(frozen=True, kw_only=True)
class Wrench:
    """What the contact does to the wheel. Forces in N, torque in N m, power in W, pressure in Pa."""

    reaction: Any
    """upward force on the wheel"""
    drawbar_force: Any
    """force along the heading on the wheel: traction less what the tissue resists, against the motion"""
    traction_force: Any
    """the film's part of it, positive when it pulls"""
    rolling_resistance: Any
    """the tissue's part of it, >= 0"""
    side_force: Any
    """force along the axle"""
    wheel_torque: Any
    """what the motor must give to hold the wheel speed, positive when driving forward"""
    film_loss: Any
    """power that the film turns into heat, >= 0"""
    tissue_loss: Any
    """power that the tissue turns into heat, under the wheel and while it recovers behind it, >= 0"""
    peak_pressure: Any
    """highest contact pressure"""
    contact_half_angle: Any
    """angle from the lowest point to the contact's leading edge [rad]"""
    front_edge: Any
    """x of the front edge from below the axle [m], >= 0"""
    rear_edge: Any
    """x of the rear edge from below the axle [m], <= 0"""


def refuse_deep(tissue: Tissue, depth: Any) -> None:
    """Raise ValueError where a law without an instant answer meets the vertical face of deep contact.

    ``depth`` is the sinkage over the wheel's radius.
    """
    if not tissue.deep and np.any(np.asarray(depth) > 1.0):
        raise ValueError(
            f"{type(tissue).__name__} has no finite answer to the sudden indentation by the vertical face of deep "
            f"contact: the wheel sinks {np.max(depth):.3g} radii. Give less load, a wider wheel, or a law with an "
            "instant stiffness, such as StandardLinearSolid or Prony."
        )


def wrench(wheel: Wheel, tissue: Tissue, film: Film, state: State, ground: None = None) -> Wrench:
    """Force and torque between a wheel and a tissue through a film.

    With φ the half contact angle at the sinkage, p the tissue's pressure under the deflection
    w(θ) = δ - r (1 - cos θ), V = r ω - v_x cos θ the slip velocity and τ the film's shear stress:

    ====================  =============================================
    ``reaction``          L ∫ p dx
    ``traction_force``    L r ∫ τ cos θ dθ
    ``rolling_resistance``  -L ∫ p w' dx
    ``wheel_torque``      L r² ∫ τ dθ
    ``film_loss``         L r ∫ τ V dθ
    ====================  =============================================

    all over the contact, from -φ to φ for an elastic tissue. The sum runs over nodes, or is the law's
    exact integral where it has one. With sideways motion v_y the shear stress acts against the whole
    slip velocity (V, -v_y). A tissue with memory resists by ``rolling_resistance`` against the motion;
    ``tissue_loss`` is what its dashpots and its recovery behind the wheel turn into heat.

    Parameters
    ----------
    wheel, tissue, film
        Frozen values; their numbers may be arrays.
    state
        The motion; out of contact (sinkage <= 0) every force is zero: there is no suction.
    ground
        What the tissue remembers. Without it (None) a tissue with memory is taken as rolling steadily at v_x:
        its columns come undeformed to the front edge and leave where the pressure falls to zero.

    Raises
    ------
    ValueError
        A ``ground`` was given.

    Source: Rentschler et al. 2004, equations (2), (14)-(17).

    >>> import drawbar
    >>> w = wrench(drawbar.Wheel(radius=0.0075, width=0.02), drawbar.Winkler(stiffness=225e3),
    ...            drawbar.Couette(viscous_coefficient=1e4), State(sinkage=0.002, vx=0.0254, omega=6.0))
    >>> f"{w.reaction:.6f} N, {w.drawbar_force:.6f} N, {w.wheel_torque:.6g} N m"
    '0.063032 N, 0.044304 N, 0.000368384 N m'
    """
    if ground is not None:
        raise ValueError(
            f"ground must be None for {type(tissue).__name__}: an elastic tissue remembers nothing, and one with "
            "memory is taken as rolling steadily. Leave it out; drawbar.simulate follows what a tissue remembers."
        )
    numbers = [np.asarray(getattr(state, f.name), dtype=float)[()] for f in dataclasses.fields(state)]
    sinkage, _, vx, vy, omega = numbers
    refuse_deep(tissue, sinkage / wheel.radius)
    kernel = contact_kernel(type(tissue), type(film))
    f = Forces(*kernel(sinkage, vx, vy, omega, wheel.radius, wheel.width, parameters(tissue), parameters(film)))
    leading, trailing = wheel.radius * np.sin(f.front), wheel.radius * np.sin(f.rear)
    forward = np.asarray(vx) >= 0.0
    return Wrench(
        reaction=f.reaction,
        drawbar_force=f.traction_force - f.resistance,
        traction_force=f.traction_force,
        rolling_resistance=np.abs(f.resistance),
        side_force=f.side_force,
        wheel_torque=f.wheel_torque,
        film_loss=f.film_loss,
        tissue_loss=f.tissue_loss,
        peak_pressure=f.peak_pressure,
        contact_half_angle=f.front,
        front_edge=where(forward, leading, -trailing),
        rear_edge=where(forward, trailing, -leading),
    )

"""A wheel's state in, the contact's wrench out."""

from __future__ import annotations

import dataclasses
from typing import Any

import numpy as np

from drawbar.contact.kernel import Forces, contact_kernel
from drawbar.film.base import Film
from drawbar.quantity import parameters, quantity, value
from drawbar.tissue.base import Tissue
from drawbar.wheel.base import Wheel

__all__ = ["State", "Wrench", "wrench"]


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
    """force along the heading on the wheel, ``traction_force - rolling_resistance``"""
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
    peak_pressure: Any
    """highest contact pressure"""
    contact_half_angle: Any
    """angle from the lowest point to the contact's edge [rad]"""
    front_edge: Any
    """x of the front edge from below the axle [m], >= 0"""
    rear_edge: Any
    """x of the rear edge from below the axle [m], <= 0"""


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

    all from -φ to φ. The sum runs over nodes, or is the law's exact integral where it has one. With
    sideways motion v_y the shear stress acts against the whole slip velocity (V, -v_y).

    Parameters
    ----------
    wheel, tissue, film
        Frozen values; their numbers may be arrays.
    state
        The motion; out of contact (sinkage <= 0) every force is zero: there is no suction.
    ground
        What the tissue remembers. The laws here are elastic and remember nothing: None.

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
            f"ground must be None for {type(tissue).__name__}: an elastic tissue remembers nothing. Leave it out."
        )
    numbers = [np.asarray(getattr(state, f.name), dtype=float)[()] for f in dataclasses.fields(state)]
    sinkage, _, vx, vy, omega = numbers
    kernel = contact_kernel(type(tissue), type(film))
    f = Forces(*kernel(sinkage, vx, vy, omega, wheel.radius, wheel.width, parameters(tissue), parameters(film)))
    half_width = wheel.radius * np.sin(f.half_angle)
    return Wrench(
        reaction=f.reaction,
        drawbar_force=f.traction_force - f.rolling_resistance,
        traction_force=f.traction_force,
        rolling_resistance=f.rolling_resistance,
        side_force=f.side_force,
        wheel_torque=f.wheel_torque,
        film_loss=f.film_loss,
        peak_pressure=f.peak_pressure,
        contact_half_angle=f.half_angle,
        front_edge=half_width,
        rear_edge=-half_width,
    )

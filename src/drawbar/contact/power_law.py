"""Steady rolling on tissue whose memory fades as a power of time, with its exact kernel on the exact circle.

A column at x has been under the wheel since it met the front edge a; what it was pressed in at ξ, a time
(ξ - x)/v ago, has relaxed to (ξ - x)^{-α}: p(x) = k w + C v^α ∫_x^a (ξ - x)^{-α} (-w'(ξ)) dξ. Angles are
measured on the wheel from its lowest point, positive to the front.

The singular powers are never sampled. A smooth function times u^{-α} is summed at fixed Gauss nodes with
weights that hold the exact moments of u^{-α} (product integration); so is the tissue's spectrum of relaxation
rates, whose density is a power too. The template is :func:`power_forces` (see :mod:`drawbar.contact.bind`):
``power_law`` and ``add_shear`` are the bound laws'.
"""

from __future__ import annotations

import math
from typing import Any

import numpy as np

from drawbar.contact.bind import unbound
from drawbar.contact.rolling import dissipated, strain_after
from drawbar.elementwise import rows, where
from drawbar.tissue.base import geometric_half_angle

__all__ = ["power_forces"]

power_law = add_shear = unbound

# History: Gauss-Legendre points of [0, 1], and what turns Legendre moments of a weight into node weights.
HISTORY = 10
_x, _w = np.polynomial.legendre.leggauss(HISTORY)
PAST = 0.5 * (_x + 1.0)
FROM_MOMENTS = 0.5 * _w[:, None] * np.polynomial.legendre.legvander(_x, HISTORY - 1) * (2 * np.arange(HISTORY) + 1)

# Arc: Gauss-Legendre on [0, 1] in s, angle = front - (front - rear) s³, since p rises like (front - angle)^{1-α}.
_points, _weights = np.polynomial.legendre.leggauss(10)
NODES = 0.5 * (_points + 1.0)
WEIGHTS = 0.5 * _weights

# Spectrum: Chebyshev points z of (0, 1), relaxation rate = CENTRE z / (1 - z) per passage of the contact.
MODES = 24
CENTRE = 20.0
_z = np.cos(np.pi * (np.arange(MODES) + 0.5) / MODES)
RATES = CENTRE * (1.0 + _z) / (1.0 - _z)
FROM_CHEBYSHEV = np.polynomial.chebyshev.chebvander(_z, MODES - 1) * (2.0 - (np.arange(MODES) == 0)) / MODES

# Panels of the arc on which the deflection is taken as a parabola, closer where the circle is steep.
PANELS = 32
GRADED = 0.5 * (1.0 - np.cos(np.pi * np.arange(PANELS + 1) / PANELS))

# 1/Γ(1 + x) for x in [0, 1] as a polynomial in x - 1/2; it is an entire function.
_nodes = np.cos(np.pi * (np.arange(18) + 0.5) / 18) / 2.0
RECIPROCAL_GAMMA = np.linalg.solve(np.vander(_nodes, increasing=True), [1.0 / math.gamma(1.5 + x) for x in _nodes])


def gamma_of_rest(exponent: Any) -> Any:
    """Γ(1 - α) = Γ(2 - α) / (1 - α)."""
    x = 0.5 - exponent
    reciprocal = 0.0 * x
    for i in range(RECIPROCAL_GAMMA.size):
        reciprocal = reciprocal * x + RECIPROCAL_GAMMA[RECIPROCAL_GAMMA.size - 1 - i]
    return 1.0 / (reciprocal * (1.0 - exponent))


def history_weights(exponent: Any) -> Any:
    """Weights of ∫_0^1 u^{-α} f(u) du at the points PAST, from the Legendre moments of u^{-α}."""
    weights = rows(HISTORY, exponent)
    moment = 1.0 / (1.0 - exponent)
    for m in range(HISTORY):
        for j in range(HISTORY):
            weights[j] = weights[j] + moment * FROM_MOMENTS[j, m]
        moment = -moment * (exponent + m) / (m + 2.0 - exponent)
    return weights


def spectrum_weights(exponent: Any) -> Any:
    """Weights of ∫_0^1 z^{α-1} (1-z)^{-α} f(z) dz over Γ(α) Γ(1-α), at Chebyshev points.

    The Chebyshev moments of this density obey (m+1) M_{m+1} = 2 (2α-1) M_m + (m-1) M_{m-1}, M_{-1} = M_1.
    """
    weights = rows(MODES, exponent)
    before = 2.0 * exponent - 1.0
    moment = 1.0 + 0.0 * exponent
    for m in range(MODES):
        for j in range(MODES):
            weights[j] = weights[j] + moment * FROM_CHEBYSHEV[j, m]
        after = (2.0 * (2.0 * exponent - 1.0) * moment + (m - 1.0) * before) / (m + 1.0)
        before = moment
        moment = after
    return weights


def memory(theta: Any, front: Any, exponent: Any, weights: Any) -> Any:
    """∫_θ^φ (sin ψ - sin θ)^{-α} sin ψ dψ: the pressure of the past over C v^α r^{1-α}.

    With ψ = θ + 2 h, sin ψ - sin θ = 2 h cos(θ + h) sin(h)/h is h, hence u, times a smooth function.
    """
    reach = np.maximum(front - theta, 0.0)
    sine = np.sin(theta)
    total = 0.0 * (reach + exponent)
    for j in range(HISTORY):
        half = np.maximum(0.5 * reach * PAST[j], 1e-150)
        chord = np.cos(theta + half) * np.sin(half)
        total = total + weights[j] * (sine + 2.0 * chord) * np.maximum(chord / half, 1e-150) ** -exponent
    return reach ** (1.0 - exponent) * total


def rear_angle(depth: Any, front: Any, radius: Any, stiffness: Any, strength: Any, exponent: Any, weights: Any) -> Any:
    """Where the pressure k w + c ∫… falls to zero, in (-φ, 0): false position that halves a lazy end."""
    low = -front
    high = 0.0 * front
    p_low = strength * memory(low, front, exponent, weights)
    p_high = stiffness * depth + strength * memory(high, front, exponent, weights)
    rear = low
    for _ in range(12):
        span = p_high - p_low
        rear = where(span > 0.0, low - p_low * (high - low) / where(span > 0.0, span, 1.0), low)
        p = stiffness * (depth - 2.0 * radius * np.sin(0.5 * rear) ** 2)
        p = p + strength * memory(rear, front, exponent, weights)
        # The end that stays has its pressure scaled down as Anderson and Björck do, so that it moves soon.
        kept = where(p > 0.0, 1.0 - p / where(p_high > 0.0, p_high, 1.0), 1.0 - p / where(p_low < 0.0, p_low, -1.0))
        kept = where(kept > 0.0, kept, 0.5)
        p_low = where(p > 0.0, p_low * kept, p)
        p_high = where(p > 0.0, p, p_high * kept)
        low = where(p > 0.0, low, rear)
        high = where(p > 0.0, rear, high)
    return rear


def loss_of_memory(depth: Any, rear: Any, front: Any, radius: Any, exponent: Any) -> Any:
    """What the power law turns into heat, per width and distance, over C v^α.

    The law is a spectrum of branches of rate λ, stiffness C λ^{α-1}/Γ(α) dλ. Each loses ∫ λ e² dt while the
    column is under the wheel, and what it holds at the rear edge, e²/2, after. With λ = q v/D, D the
    length of the contact, q = q₀ z/(1-z), the density in z is q₀^α z^{α-1} (1-z)^{-α}/(1-z); the loss of a
    branch falls as 1-z.
    """
    weights = spectrum_weights(exponent)
    length = np.maximum(radius * (np.sin(front) - np.sin(rear)), 1e-150)
    strains = rows(MODES, length)
    heat = rows(MODES, length)
    angle = front
    w_end = 0.0 * length
    for i in range(PANELS):
        w_start = w_end
        x_start = radius * np.sin(angle)
        angle = front - (front - rear) * GRADED[i + 1]
        w_end = depth - 2.0 * radius * np.sin(0.5 * angle) ** 2
        reach = np.maximum(x_start - radius * np.sin(angle), 1e-150)
        x_mid = x_start - 0.5 * reach
        w_mid = depth - x_mid * x_mid / (radius + np.sqrt(np.maximum(radius * radius - x_mid * x_mid, 0.0)))
        rise = (4.0 * w_mid - 3.0 * w_start - w_end) / reach
        curve = 2.0 * (w_end - 2.0 * w_mid + w_start) / (reach * reach)
        for j in range(MODES):
            fade = length / RATES[j]
            heat[j] = heat[j] + dissipated(strains[j], reach, rise, curve, fade)
            strains[j] = strain_after(strains[j], reach, rise, curve, fade)
    total = 0.0 * (length + exponent)
    for j in range(MODES):
        total = total + weights[j] * (1.0 + RATES[j] / CENTRE) * (heat[j] + 0.5 * strains[j] * strains[j])
    return gamma_of_rest(exponent) * (CENTRE / length) ** exponent * total


def pressure_at(
    s: Any, depth: Any, front: Any, reach: Any, radius: Any, stiffness: Any, strength: Any, exponent: Any, weights: Any
) -> Any:
    """Pressure k w + c ∫… at the angle front - reach s³."""
    theta = front - reach * s * s * s
    p = stiffness * (depth - 2.0 * radius * np.sin(0.5 * theta) ** 2)
    return p + strength * memory(theta, front, exponent, weights)


def power_forces(
    sinkage: Any, vx: Any, vy: Any, omega: Any, radius: Any, width: Any, tissue: Any, film: Any
) -> tuple[Any, ...]:
    """The wrench's parts in the order of :class:`drawbar.contact.kernel.Forces`, steady at the axle's speed v.

    Reaction, resistance and film as in :func:`drawbar.contact.rolling.rolling_forces`. At rest the power
    law has relaxed: only the long-term spring k is left. The tissue loss comes from the law's own spectrum
    (:func:`loss_of_memory`) and the spring's k w²/2 at the rear edge, not from the resistance.

    In deep contact the resistance diverges at the vertical front face: the caller refuses. The numbers
    given there are finite, those of a wheel whose axle is level with the surface.
    """
    stiffness, coefficient, exponent = power_law(*tissue)
    zero = 0.0 * (sinkage + vx + omega + vy + radius + stiffness + coefficient + exponent)
    depth = np.minimum(np.maximum(sinkage, 0.0), radius) + zero
    front = geometric_half_angle(depth, radius) + zero
    exponent = exponent + zero
    heading = where(vx < 0.0, -1.0, 1.0) + zero
    speed = np.abs(vx) + zero
    rim = radius * omega * heading
    weights = history_weights(exponent)
    strength = coefficient * speed**exponent * radius ** (1.0 - exponent)
    # At rest the rear edge is the one that a vanishing speed leads to.
    rear = rear_angle(
        depth, front, radius, stiffness, where(speed > 0.0, strength, 1e-30 * coefficient), exponent, weights
    )
    reach = np.maximum(front - rear, 1e-150)

    # A film law may jump at zero slip: the arc is cut there, and in the middle of what is left.
    moving = speed > 0.0
    turn = np.arccos(np.minimum(np.maximum(where(moving, rim / where(moving, speed, 1.0), 2.0), -1.0), 1.0))
    first = np.cbrt(np.maximum(front - turn, 0.0) / reach)
    second = np.cbrt(np.minimum(front + turn, reach) / reach)
    first = np.minimum(first, second)
    middle = 0.5 * (first + second)
    reaction = zero
    resistance = zero
    sums = (zero, zero, zero, zero, zero)
    peak = zero
    highest = zero + 0.5
    for part in range(4):
        lower = (zero, first, middle, second)[part]
        upper = (first, middle, second, zero + 1.0)[part]
        if not np.any(upper > lower):
            continue
        for i in range(NODES.size):
            s = lower + (upper - lower) * NODES[i]
            theta = front - reach * s * s * s
            c = np.cos(theta)
            sine = np.sin(theta)
            p = pressure_at(s, depth, front, reach, radius, stiffness, strength, exponent, weights)
            length = (upper - lower) * WEIGHTS[i] * 3.0 * s * s * reach * radius
            reaction = reaction + length * p * c
            resistance = resistance + length * p * sine
            sums = add_shear(sums, c, sine, np.maximum(p, 0.0), length, rim, speed, vy, radius, film)
            highest = where(p > peak, s, highest)
            peak = np.maximum(peak, p)
    for gap in (0.1, 0.03, 0.01, 0.01, 0.01):  # the top of a parabola through three points around the highest
        p0 = pressure_at(highest * (1.0 - gap), depth, front, reach, radius, stiffness, strength, exponent, weights)
        p1 = pressure_at(highest, depth, front, reach, radius, stiffness, strength, exponent, weights)
        p2 = pressure_at(highest * (1.0 + gap), depth, front, reach, radius, stiffness, strength, exponent, weights)
        bend = 2.0 * p1 - p0 - p2
        step = np.minimum(np.maximum(0.5 * (p2 - p0) / where(bend > 0.0, bend, 1.0), -1.0), 1.0)
        step = where(bend > 0.0, step, 0.0)
        peak = p1 + 0.25 * (p2 - p0) * step
        highest = highest * (1.0 + gap * step)
    touching = where(front > 0.0, 1.0, 0.0)
    width = width * touching
    w_rear = depth - 2.0 * radius * np.sin(0.5 * rear) ** 2
    lost = coefficient * speed**exponent * loss_of_memory(depth, rear, front, radius, exponent)
    lost = lost + 0.5 * stiffness * w_rear * w_rear
    along, upward, side, torque, film_loss = sums
    return (
        front,
        rear,
        width * (reaction + upward),
        width * along * heading,
        width * resistance * heading,
        width * side,
        width * torque * heading,
        width * film_loss,
        width * speed * lost,
        peak * touching,
    )

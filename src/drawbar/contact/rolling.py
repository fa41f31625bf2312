"""Steady rolling on tissue with a fading memory: columns that relax while the wheel passes over them.

A column enters the contact undeformed at the front edge, follows the wheel's circle, and leaves where its
pressure falls to zero. Its branches are springs k_i in series with dashpots of relaxation time τ_i; over
one panel of the arc the deflection is a parabola in x, for which each branch's strain is integrated
exactly, so that a relaxation time far below the panel's passage costs nothing. Angles are measured on the
wheel from its lowest point, positive to the front; x runs from the front backwards.

These are templates (see :mod:`drawbar.contact.bind`): ``spectrum`` and ``add_shear`` are the bound laws'.
"""

from __future__ import annotations

from typing import Any

import numpy as np

from drawbar.contact.bind import unbound
from drawbar.elementwise import rows, where
from drawbar.tissue.base import geometric_half_angle

__all__ = ["PANELS", "rolling_forces"]

spectrum = add_shear = unbound

# Panels from the front edge to its mirror image, closer where the circle is steep: angle = front × cos(π j / n).
PANELS = 64
GRADED = np.cos(np.pi * np.arange(PANELS + 1) / PANELS)

# Gauss-Legendre on [0, 1] within a panel.
_points, _weights = np.polynomial.legendre.leggauss(3)
NODES = 0.5 * (_points + 1.0)
WEIGHTS = 0.5 * _weights


def bend(z: Any, fade: Any) -> Any:
    """2 (z - 1 + e^{-z}) / z², ``fade`` being e^{-z}; by its series near 0, to 1e-14."""
    small = 1.0
    for n in range(10, 2, -1):
        small = 1.0 - small * z / n
    safe = np.maximum(z, 0.1)
    return where(z < 0.1, small, 2.0 * (safe - 1.0 + fade) / (safe * safe))


def strain_after(strain: Any, distance: Any, rise: Any, curve: Any, length: Any) -> Any:
    """Strain e of a branch after a ``distance`` u in which w grows by rise u + curve u²: e' = w' - e/ℓ."""
    z = distance / length
    fade = np.exp(-z)
    bent = bend(z, fade)
    ramp = 1.0 - 0.5 * z * bent  # (1 - e^{-z}) / z
    return strain * fade + distance * (rise * ramp + curve * distance * bent)


def line_and_rest(strain: Any, rise: Any, curve: Any, length: Any) -> Any:
    """level, tilt, rest of the strain over a panel: e = level + tilt u + rest e^{-u/ℓ}."""
    tilt = 2.0 * curve * length
    level = length * (rise - tilt)
    return level, tilt, strain - level


def carried(strain: Any, reach: Any, rise: Any, curve: Any, length: Any) -> Any:
    """∫ e du and ∫ e w' du over a panel of length ``reach``: a branch's part of reaction and resistance, over k_i.

    Exact, so that a layer far thinner than the panel counts; on a panel far shorter than ℓ the exact terms
    cancel, and three Gauss nodes are exact to 1e-9.
    """
    z = reach / length
    lifts = 0.0 * z
    resists = 0.0 * z
    if np.any(z < 0.2):
        for g in range(NODES.size):
            u = reach * NODES[g]
            e = WEIGHTS[g] * reach * strain_after(strain, u, rise, curve, length)
            lifts = lifts + e
            resists = resists + e * (rise + 2.0 * curve * u)
    level, tilt, rest = line_and_rest(strain, rise, curve, length)
    fade = np.exp(-z)
    once = rest * length * (1.0 - fade)  # ∫ rest e^{-u/ℓ} du
    twice = rest * length * length * (1.0 - fade * (1.0 + z))  # ∫ rest u e^{-u/ℓ} du
    lift = reach * (level + 0.5 * tilt * reach) + once
    resist = reach * (level * (rise + curve * reach) + tilt * reach * (0.5 * rise + curve * reach / 1.5))
    resist = resist + rise * once + 2.0 * curve * twice
    return where(z < 0.2, lifts, lift), where(z < 0.2, resists, resist)


def dissipated(strain: Any, reach: Any, rise: Any, curve: Any, length: Any) -> Any:
    """∫ e²/ℓ du over a panel: what a branch's dashpot turns into heat, over k_i; as :func:`carried`."""
    z = reach / length
    few = 0.0 * z
    if np.any(z < 0.2):
        for g in range(NODES.size):
            e = strain_after(strain, reach * NODES[g], rise, curve, length)
            few = few + WEIGHTS[g] * e * e
    level, tilt, rest = line_and_rest(strain, rise, curve, length)
    fade = np.exp(-z)
    line = z * (level * level + tilt * reach * (level + tilt * reach / 3.0))
    mixed = 2.0 * rest * (level * (1.0 - fade) + tilt * length * (1.0 - fade * (1.0 + z)))
    return where(z < 0.2, z * few, line + mixed + 0.5 * rest * rest * (1.0 - fade * fade))


def pressure_at(distance: Any, start: Any, rise: Any, curve: Any, strains: Any, lengths: Any, columns: Any) -> Any:
    """Pressure at a ``distance`` u into a panel whose deflection is start + rise u + curve u².

    ``columns`` are the stiffness k, the damping c v and the branch stiffnesses k_i.
    """
    stiffness, damping, branches = columns
    p = stiffness * (start + distance * (rise + curve * distance))
    p = p + damping * (rise + 2.0 * curve * distance)
    for i in range(len(branches)):
        p = p + branches[i] * strain_after(strains[i], distance, rise, curve, lengths[i])
    return p


def rolling_forces(
    sinkage: Any, vx: Any, vy: Any, omega: Any, radius: Any, width: Any, tissue: Any, film: Any
) -> tuple[Any, ...]:
    """The wrench's parts in the order of :class:`drawbar.contact.kernel.Forces`.

    Per width, with columns that pass backwards at the axle's speed v:

    - reaction ∫p dx, resistance -∫p w' dx, the film as everywhere with slip velocity r ω - v cos θ;
    - tissue loss v [∫ Σ k_i e_i²/ℓ_i dx + ∫ c v w'² dx + what is stored at the rear edge], ℓ_i = v τ_i:
      the dashpots' own dissipation, and the energy that a column still holds when it leaves and then
      loses. It is not the resistance times the speed, so the ledger of powers can fail.

    In deep contact a column meets the vertical front face and is pressed in at once by w = y: its springs
    answer with K(0⁺) = k + Σ k_i, which resists with K(0⁺) y²/2. At the rear face it is let go at once and
    pushes back while it springs up by p/K(0⁺): p²/(2 K(0⁺)) is regained. A dashpot alone would answer
    without bound: the caller refuses a viscosity there.
    """
    stiffness, viscosity, branches, times = spectrum(*tissue)
    depth = np.maximum(sinkage, 0.0)
    front = geometric_half_angle(sinkage, radius)
    zero = 0.0 * (front + vx + omega + vy + stiffness)
    heading = where(vx < 0.0, -1.0, 1.0) + zero
    speed = np.abs(vx) + zero
    columns = (stiffness, viscosity * speed, branches)
    rim = radius * omega * heading
    rolls = speed > 0.0
    turn = np.arccos(np.minimum(np.maximum(where(rolls, rim / where(rolls, speed, 1.0), 2.0), -1.0), 1.0))
    face = np.maximum(sinkage - radius, 0.0) + zero
    count = len(branches)
    strains = rows(count, zero)
    lengths = rows(count, zero)
    instant = stiffness + zero
    for i in range(count):
        instant = instant + branches[i]
        strains[i] = strains[i] + face
        lengths[i] = np.maximum(speed * times[i], 1e-9 * radius)  # at rest: all relaxed
    reaction = zero
    sums = (zero, zero, zero, zero, zero)
    lost = zero
    stored = zero
    resistance = 0.5 * instant * face * face
    peak = instant * face
    inside = where(front > 0.0, 1.0, 0.0) + zero
    rear = front + zero
    end = front + zero
    w_end = face
    p_end = peak
    for j in range(PANELS):
        w_start = w_end
        begin = end
        x_start = radius * np.sin(begin)
        end = front * GRADED[j + 1]
        w_end = depth - 2.0 * radius * np.sin(0.5 * end) ** 2
        reach = np.maximum(x_start - radius * np.sin(end), 1e-100)
        x_mid = x_start - 0.5 * reach
        w_mid = depth - x_mid * x_mid / (radius + np.sqrt(np.maximum(radius * radius - x_mid * x_mid, 0.0)))
        rise = (4.0 * w_mid - 3.0 * w_start - w_end) / reach
        curve = 2.0 * (w_end - 2.0 * w_mid + w_start) / (reach * reach)
        p_end = where(inside > 0.0, pressure_at(reach, w_start, rise, curve, strains, lengths, columns), p_end)
        leaves = (inside > 0.0) & (p_end <= 0.0)
        part = reach * inside
        if np.any(leaves):
            low = 0.0 * reach
            high = reach
            for _ in range(40):
                middle = 0.5 * (low + high)
                presses = pressure_at(middle, w_start, rise, curve, strains, lengths, columns) > 0.0
                low = where(presses, middle, low)
                high = where(presses, high, middle)
            part = where(leaves, 0.5 * (low + high), part)
        for g in range(NODES.size):
            u = part * NODES[g]
            step = part * WEIGHTS[g]
            slope = rise + 2.0 * curve * u
            pushed = viscosity * speed * slope
            lost = lost + step * pushed * slope
            pushed_back = stiffness * (w_start + u * (rise + curve * u)) + pushed
            resistance = resistance + step * pushed_back * slope
            sine = (x_start - u) / radius
            cosine = np.sqrt(np.maximum(1.0 - sine * sine, 1e-12))
            reaction = reaction + step * (stiffness * (depth - radius * sine * sine / (1.0 + cosine)) + pushed)
        leave = where(leaves, np.arcsin(np.minimum(np.maximum((x_start - part) / radius, -1.0), 1.0)), end)
        leave = where(inside > 0.0, leave, begin)
        cut = np.minimum(np.maximum(where(begin > 0.0, turn, -turn), leave), begin)
        for half in range(2):  # the film in angle, cut where the slip changes its sign
            upper = (begin, cut)[half]
            lower = (cut, leave)[half]
            if not np.any(upper > lower):
                continue
            for g in range(NODES.size):
                theta = lower + (upper - lower) * NODES[g]
                sine = np.sin(theta)
                cosine = np.cos(theta)
                u = np.maximum(x_start - radius * sine, 0.0)
                p = pressure_at(u, w_start, rise, curve, strains, lengths, columns)
                length = (upper - lower) * WEIGHTS[g] * radius
                sums = add_shear(sums, cosine, sine, np.maximum(p, 0.0), length, rim, speed, vy, radius, film)
                peak = np.maximum(peak, where(upper > lower, p, 0.0))
        holds = 0.5 * stiffness * (w_start + part * (rise + curve * part)) ** 2
        for i in range(count):
            lifts, resists = carried(strains[i], part, rise, curve, lengths[i])
            reaction = reaction + branches[i] * lifts
            resistance = resistance + branches[i] * resists
            lost = lost + branches[i] * dissipated(strains[i], part, rise, curve, lengths[i])
            after = strain_after(strains[i], part, rise, curve, lengths[i])
            strains[i] = where(inside > 0.0, after, strains[i])
            holds = holds + 0.5 * branches[i] * strains[i] * strains[i]
        stored = where(inside > 0.0, holds, stored)
        rear = where(inside > 0.0, leave, rear)
        inside = where(leaves, 0.0, inside)
    regained = where(inside > 0.0, 0.5 * p_end * p_end / instant, 0.0)  # at the rear face, if still pressed
    along, upward, side, torque, film_loss = sums
    return (
        front,
        rear,
        width * (reaction + upward),
        width * along * heading,
        width * (resistance - regained) * heading,
        width * side,
        width * torque * heading,
        width * film_loss,
        width * speed * (lost + stored - regained),
        peak,
    )

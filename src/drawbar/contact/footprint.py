"""What columns of tissue do to a wheel at one instant, with edges found between the columns.

Between two pressed columns the pressure is linear in the angle on the wheel, which keeps the integrals of
second order up to a vertical face. An edge that the wheel is closing is where its circle meets the tissue's
free surface, continued; one that it is leaving is where the pressure, continued, falls to zero.

``panel`` is a template (see :mod:`drawbar.contact.bind`): ``shear_stress`` is the bound film's.
"""

from __future__ import annotations

from typing import Any

import numpy as np

from drawbar.contact.bind import bind, unbound
from drawbar.contact.column import Law, springs

__all__ = ["FOOTPRINT", "footprint_kernel"]

shear_stress = unbound

FOOTPRINT = (
    "reaction", "resistance", "along", "upward", "torque", "film_loss", "peak_pressure", "rear", "front",
)  # fmt: skip

GAUSS = 0.5 - 0.5 / np.sqrt(3.0)  # two points on [0, 1]: GAUSS and 1 - GAUSS


def footprint(ground: Any, window: Any, motion: Any, radius: Any, law: Law, film: Any, out: Any) -> None:
    """Forces per width [N/m] and edges [rad] at an instant, into ``out`` (see :data:`FOOTPRINT`).

    ``motion`` is (x, δ, δ', v, ω). Where no column is pressed all is zero.
    """
    first, spacing, _, _, pressed, _, _, _ = ground
    for n in range(out.size):
        out[n] = 0.0
    running = False
    theta = 0.0
    p = 0.0
    for j in range(window[0], window[1]):
        if pressed[j]:
            xi = first + j * spacing - motion[0]
            here = np.arcsin(min(max(xi / radius, -1.0), 1.0))
            stress = node(j, ground, motion, radius, law)
            if running:
                panel(theta, p, here, stress, motion, radius, film, out)
            else:
                edge(j, -1, ground, motion, radius, law, film, out)
            theta = here
            p = stress
            running = True
        elif running:
            edge(j - 1, 1, ground, motion, radius, law, film, out)
            running = False


def node(j: Any, ground: Any, motion: Any, radius: Any, law: Law) -> Any:
    """Pressure [Pa] of a pressed column, with the rate δ' + v tan θ of this instant."""
    first, spacing, w, rows, _, _, _, _ = ground
    x, _, sink, v, _ = motion
    p = springs(rows[j], w[j], law)
    if law.viscosity > 0.0:
        xi = first + j * spacing - x
        p += law.viscosity * (sink + v * xi / np.sqrt(max(radius * radius - xi * xi, 1e-12 * radius * radius)))
    return max(p, 0.0)


def panel(low: Any, p_low: Any, high: Any, p_high: Any, motion: Any, radius: Any, film: Any, out: Any) -> None:
    """Adds the arc between two angles, its pressure linear in the angle; the film is cut where slip turns."""
    if high <= low:
        return
    v = motion[3]
    rim = radius * motion[4]
    tilt = (p_high - p_low) / (high - low)
    s0 = np.sin(low)
    s1 = np.sin(high)
    c0 = np.cos(low)
    c1 = np.cos(high)
    out[0] += radius * (p_high * s1 - p_low * s0 + tilt * (c1 - c0))
    out[1] += radius * (p_low * c0 - p_high * c1 + tilt * (s1 - s0))
    out[6] = max(out[6], p_low, p_high)
    turn = np.arccos(min(max(rim / v, -1.0), 1.0)) if v != 0.0 else 0.0
    start = low
    for part in range(3):
        stop = (min(max(-turn, low), high), min(max(turn, low), high), high)[part]
        if stop <= start:
            continue
        for g in range(2):
            angle = start + (stop - start) * (GAUSS if g == 0 else 1.0 - GAUSS)
            c = np.cos(angle)
            slip = rim - v * c
            stress = shear_stress(abs(slip), p_low + tilt * (angle - low), *film)
            stress *= 0.5 * radius * (stop - start) * (1.0 if slip >= 0.0 else -1.0)
            out[2] += stress * c
            out[3] += stress * np.sin(angle)
            out[4] += stress * radius
            out[5] += stress * slip
        start = stop


def edge(j: Any, side: Any, ground: Any, motion: Any, radius: Any, law: Law, film: Any, out: Any) -> None:
    """Adds the part of a cell between the outermost pressed column j and the contact's edge on that side."""
    first, spacing, w, rows, pressed, _, _, _ = ground
    x, depth, sink, v, _ = motion
    xi = first + j * spacing - x
    p = node(j, ground, motion, radius, law)
    theta = np.arcsin(min(max(xi / radius, -1.0), 1.0))
    beyond = min(max(j + side, 0), w.size - 1)
    u = w[beyond]
    far = w[min(max(j + 2 * side, 0), w.size - 1)]
    outer = xi + side * spacing
    room = max(radius - side * xi, 0.0)
    inner = j - side
    before = node(inner, ground, motion, radius, law) if 0 <= inner < w.size and pressed[inner] else 0.0
    free_rate = 0.0
    for m in range(law.rates.size):
        free_rate -= law.rates[m] * law.lift[m] * rows[beyond, m]
    p_edge = 0.0
    if room < spacing and depth - radius > u:  # the vertical face itself
        reach = room
        if v * side > 0.0:
            p_edge = law.instant * (depth - radius - u)
            out[1] += side * 0.5 * p_edge * (depth - radius - u)
        else:
            inside = np.arcsin(min(max((xi - side * spacing) / radius, -1.0), 1.0))
            p_edge = max(p + (p - before) * (side * 0.5 * np.pi - theta) / (theta - inside), 0.0)
            if v * side < 0.0:
                out[1] += side * 0.5 * p_edge * p_edge / law.instant
        # at rest neither face works
    else:
        rate = sink + v * outer / np.sqrt(max(radius * radius - outer * outer, 1e-12 * radius * radius))
        if rate >= free_rate and side * xi > 0.0:
            reach = 0.5 * spacing
            for _ in range(4):
                meets = min(max(depth - (u - (far - u) * (1.0 - reach / spacing)), 0.0), radius)
                reach = np.sqrt(meets * (2.0 * radius - meets)) - side * xi
                reach = min(max(reach, 0.0), spacing)
            reach = min(reach, room)
            met = side * (side * xi + reach)
            rate = sink + v * met / np.sqrt(max(radius * radius - met * met, 1e-12 * radius * radius))
            p_edge = max(law.viscosity * (rate - free_rate), 0.0)
        elif before > p:
            inside = np.arcsin(min(max((xi - side * spacing) / radius, -1.0), 1.0))
            fades = min(abs(theta + (theta - inside) * p / (before - p)), 0.5 * np.pi)
            reach = min(max(radius * np.sin(fades) - abs(xi), 0.0), spacing) if side * xi > 0.0 else 0.5 * spacing
        else:
            reach = 0.5 * spacing
        reach = min(reach, room)
    at = np.arcsin(min(max((xi + side * reach) / radius, -1.0), 1.0))
    if side > 0:
        panel(theta, p, at, p_edge, motion, radius, film, out)
        out[8] = at
    else:
        panel(at, p_edge, theta, p, motion, radius, film, out)
        if out[7] == 0.0:
            out[7] = at


def footprint_kernel(shear_stress: Any) -> Any:
    """:func:`footprint` for a film's shear stress."""
    strip = bind(panel, shear_stress=shear_stress)
    return bind(footprint, panel=strip, edge=bind(edge, panel=strip))

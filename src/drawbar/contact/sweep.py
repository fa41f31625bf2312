"""One step of a wheel over columns of tissue: what they do to it on average, and what becomes of them.

The wheel's surface above each column moves linearly over a step and the column answers exactly
(:mod:`drawbar.contact.column`), so a short relaxation time sets no limit to the step. The work that a step
does on a column is its impulse times the column's rate, δ' + G v, where G = (ξ₀ + ξ₁)/(c₀ + c₁),
c = sqrt(r² - ξ²), is the wheel's slope between the two places ξ = X - x: reaction Σ I and resistance Σ I G
do that work on the wheel, and no energy is made or lost.

``rub`` is a template (see :mod:`drawbar.contact.bind`): ``shear_stress`` is the bound film's. x is along the
heading, the sinkage δ is positive down. The kernels keep the ground as a tuple of arrays:
first, spacing, w, rows, pressed, now, end, arcs (see :func:`drawbar.contact.columns.arrays`).
"""

from __future__ import annotations

from typing import Any

import numpy as np

from drawbar.contact.bind import bind, unbound
from drawbar.contact.column import Law, pass_over, relax, surface

__all__ = ["SUMS", "age_pool", "foresee", "lay_arcs", "shift_window", "stored", "sweep_kernel", "window_of"]

shear_stress = unbound

SUMS = 14
"""How many sums a sweep gives: mean reaction, mean resistance, work of the faces, d(reaction)/d(sink rate),
d(resistance)/d(sink rate), d(resistance)/d(speed), the film's forces along and upward, its torque over the
radius, its heat, d(along)/d(speed), d(along)/d(rim speed), d(torque over the radius)/d(rim speed), tissue heat."""


def window_of(first: Any, spacing: Any, count: Any, start: Any, end: Any, depth: Any, radius: Any) -> Any:
    """First and last column [lo, hi) that a wheel may touch between two places, at most ``depth`` deep."""
    depth = min(max(depth, 0.0), radius)
    half = np.sqrt(depth * (2.0 * radius - depth)) + 3.0 * spacing
    lo = int(np.floor((min(start, end) - half - first) / spacing))
    hi = int(np.ceil((max(start, end) + half - first) / spacing)) + 1
    return max(lo, 0), min(hi, count)


def shift_window(ground: Any, since: Any, pool: Any, old: Any, new: Any, time: Any, law: Law, tables: Any) -> None:
    """Columns that leave the window go to the ``pool``, those that enter come back from it, up to date.

    The pool holds Σ a_m² of all free columns outside, which is all that their energy needs; each
    column's own amplitudes wait unchanged until it is looked at again.
    """
    _, _, w, rows, pressed, now, end, _ = ground
    for j in range(old[0], old[1]):
        if j < new[0] or j >= new[1]:
            since[j] = time
            for m in range(law.rates.size):
                pool[m] += rows[j, m] * rows[j, m]
    for j in range(new[0], new[1]):
        if j < old[0] or j >= old[1]:
            if not pressed[j]:  # a pressed one is up to date
                relax(rows[j], time - since[j], law)
                for m in range(law.rates.size):
                    pool[m] = max(pool[m] - rows[j, m] * rows[j, m], 0.0)
                w[j] = surface(rows[j], law)
            since[j] = time
            foresee(j, rows, pressed[j], now, end, tables)


def age_pool(pool: Any, law: Law, tables: Any) -> Any:
    """One step of the columns outside the window: their heat [J/m²]."""
    heat = 0.0
    for m in range(law.rates.size):
        heat += tables.free[m, 2] * pool[m]
        pool[m] *= tables.free[m, 0] * tables.free[m, 0]
    return heat


def stored(ground: Any, window: Any, pool: Any, law: Law) -> Any:
    """Energy in all columns [J/m² × columns]: springs of the pressed, modes of the free, the pool."""
    _, _, w, rows, pressed, _, _, _ = ground
    energy = 0.0
    for m in range(law.rates.size):
        energy += 0.5 * law.rates[m] * pool[m]
    for j in range(window[0], window[1]):
        if pressed[j]:
            energy += 0.5 * law.stiffness * w[j] * w[j]
            for i in range(law.times.size):
                energy += 0.5 * law.branches[i] * rows[j, i] * rows[j, i]
        else:
            for m in range(law.rates.size):
                energy += 0.5 * law.rates[m] * rows[j, m] * rows[j, m]
    return energy


def sweep(
    commit: Any, ground: Any, window: Any, motion: Any, rim: Any, radius: Any, law: Law, tables: Any, film: Any,
    steep: Any, spare: Any, out: Any,
) -> None:  # fmt: skip
    """One step over the columns of a window: what they do on average, into ``out`` (see :data:`SUMS`).

    ``motion`` is (x₀, x₁, δ₀, δ₁). With ``commit`` the columns change, else they are left as they were.
    ``rim`` is r ω at mid-step; ``steep`` asks for the film's derivatives too. Sums are means over the step
    [N/m], but ``faces`` and heats, which are energies of the step [J/m].
    """
    first, spacing, w, rows, pressed, now, end, arcs = ground
    x0, x1, depth0, depth1 = motion
    h = tables.step
    sink = (depth1 - depth0) / h
    v = (x1 - x0) / h
    per_step = spacing / h
    steady_heat = law.viscosity * h
    reaction = resistance = faces = heat = stiff0 = stiff1 = stiff2 = 0.0
    rubbed = (0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0)
    for j in range(window[0], window[1]):
        xi0 = first + j * spacing - x0
        xi1 = first + j * spacing - x1
        inside0 = abs(xi0) < radius
        inside1 = abs(xi1) < radius
        c0 = np.sqrt(max(radius * radius - xi0 * xi0, 0.0))
        c1 = np.sqrt(max(radius * radius - xi1 * xi1, 0.0))
        w0 = depth0 - radius + c0
        w1 = depth1 - radius + c1
        enter = 0.0
        leave = h
        if inside0 and inside1:
            slope = (xi0 + xi1) / (c0 + c1)
            rate = sink + slope * v
            if pressed[j]:
                last = law.stiffness * w1 + law.viscosity * rate + end[j] + rate * tables.end_rate
                plain = last >= 0.0
            else:
                plain = w1 <= end[j] and w0 <= w[j]
        elif inside0 or inside1:
            # the face, at ξ = ±r, passes in this step
            xi = xi1 if inside1 else xi0
            face = radius if xi > 0.0 else -radius
            passing = (xi0 - face) / (x1 - x0) * h
            if inside1:
                enter = min(max(passing, 0.0), (1.0 - 1e-9) * h)
                w0 = depth0 + sink * enter - radius
                slope = (face + xi1) / max(c1, 1e-300)
            else:
                leave = min(max(passing, 1e-9 * h), h)
                w1 = depth0 + sink * leave - radius
                slope = (face + xi0) / max(c0, 1e-300)
            rate = sink + slope * v
            plain = not pressed[j] and w1 <= 0.0 and w0 <= 0.0
        else:
            plain = not pressed[j]
            slope = 0.0
            rate = 0.0
        impulse = 0.0
        held = 0.0
        if plain and pressed[j]:
            held = h
            impulse = h * (law.stiffness * w[j] + now[j] + rate * tables.mean_rate)
            if commit:
                heat += hold(j, rate, rows, now, end, tables.held) + steady_heat * rate * rate
                w[j] = w1
        elif plain:
            if commit:
                w[j] = end[j]
                heat += drift(j, rows, end, tables.free)
        else:
            row = spare[0]
            for m in range(rows.shape[1]):
                row[m] = rows[j, m]
            stays, depth, impulse, work, loss, held = pass_over(
                pressed[j], w[j], row, enter, leave, w0, w1, h, law, spare[1]
            )
            faces += work
            if commit:
                heat += loss
                pressed[j] = stays
                w[j] = depth
                for m in range(rows.shape[1]):
                    rows[j, m] = row[m]
                foresee(j, rows, stays, now, end, tables)
        if held > 0.0:
            reaction += impulse
            resistance += impulse * slope
            stiff0 += held
            stiff1 += held * slope
            stiff2 += held * slope * slope
            # the arcs fill the wheel's width at mid-step: what its face cuts off must not be cut off twice
            share = held / (leave - enter)
            mean = max(impulse / held, 0.0)
            rubbed = rub(rubbed, arcs[j, 0], arcs[j, 1], arcs[j, 2], share, mean, v, rim, film, steep)
    out[0] = per_step * reaction
    out[1] = per_step * resistance
    out[2] = spacing * faces
    out[3] = per_step * tables.mean_rate * stiff0
    out[4] = per_step * tables.mean_rate * stiff1
    out[5] = per_step * tables.mean_rate * stiff2
    for n in range(7):
        out[6 + n] = rubbed[n]
    out[9] *= h
    out[13] = spacing * heat


def lay_arcs(ground: Any, window: Any, x: Any, radius: Any) -> None:
    """The wheel's arc over every column of the window: its length, and its extent along and upwards [m].

    The outermost column takes the arc up to the vertical face, however little of its cell is there: near
    the face the arc grows as the root of the distance.
    """
    first, spacing, _, _, _, _, _, arcs = ground
    high = -radius
    angle = -0.5 * np.pi
    height = 0.0
    for j in range(window[0], window[1]):
        xi = first + j * spacing - x
        low = high
        before = angle
        above = height
        if xi <= -radius or xi >= radius:
            arcs[j, 0] = arcs[j, 1] = arcs[j, 2] = 0.0
            continue
        if j == window[0]:
            low = max(xi - 0.5 * spacing, -radius)
            before = np.arcsin(low / radius)
            above = np.sqrt(radius * radius - low * low)
        high = xi + 0.5 * spacing if xi + spacing < radius else radius
        angle = np.arcsin(high / radius)
        height = np.sqrt(radius * radius - high * high)
        arcs[j, 0] = radius * (angle - before)
        arcs[j, 1] = high - low
        arcs[j, 2] = above - height


def rub(
    sums: Any, length: Any, breadth: Any, rise: Any, share: Any, p: Any, v: Any, rim: Any, film: Any, steep: Any
) -> Any:
    """``sums`` with the film over one column's arc added, at the arc's mean slip velocity rω - v cos θ."""
    along, upward, torque, heat, along_v, along_rim, torque_rim = sums
    if length <= 0.0:
        return sums
    cosine = breadth / length
    slip = rim - v * cosine
    size = abs(slip)
    stress = shear_stress(size, p, *film)
    if steep:
        more = 1e-6 * size + 1e-9
        slant = share * (shear_stress(size + more, p, *film) - stress) / more
        along_v -= slant * breadth * cosine
        along_rim += slant * breadth
        torque_rim += slant * length
    stress = share * (stress if slip >= 0.0 else -stress)
    return (
        along + stress * breadth,
        upward + stress * rise,
        torque + stress * length,
        heat + stress * length * slip,
        along_v,
        along_rim,
        torque_rim,
    )


def hold(j: Any, rate: Any, rows: Any, now: Any, end: Any, held: Any) -> Any:
    """A column pressed all through the step: its strains advance, and their share of the coming step's
    mean and last pressure is foreseen; heat [J/m²] of its branches."""
    heat = 0.0
    mean = 0.0
    last = 0.0
    for i in range(held.shape[0]):
        e = rows[j, i]
        heat += e * (held[i, 4] * e + held[i, 5] * rate) + held[i, 6] * rate * rate
        e = held[i, 0] * e + held[i, 1] * rate
        rows[j, i] = e
        mean += held[i, 2] * e
        last += held[i, 3] * e
    now[j] = mean
    end[j] = last
    return heat


def drift(j: Any, rows: Any, end: Any, free: Any) -> Any:
    """A column free all through the step: its amplitudes decay, and its surface at the end of the coming
    step is foreseen; heat [J/m²]."""
    heat = 0.0
    last = 0.0
    for m in range(free.shape[0]):
        a = rows[j, m]
        heat += free[m, 2] * a * a
        a *= free[m, 0]
        rows[j, m] = a
        last += free[m, 1] * a
    end[j] = last
    return heat


def foresee(j: Any, rows: Any, pressed: Any, now: Any, end: Any, tables: Any) -> None:
    """What a column that has just changed its kind will give in the coming step, as above."""
    now[j] = 0.0
    end[j] = 0.0
    if pressed:
        for i in range(tables.held.shape[0]):
            now[j] += tables.held[i, 2] * rows[j, i]
            end[j] += tables.held[i, 3] * rows[j, i]
    else:
        for m in range(tables.free.shape[0]):
            end[j] += tables.free[m, 1] * rows[j, m]


def sweep_kernel(shear_stress: Any, *, compiled: bool = False) -> Any:
    """:func:`sweep` for a film's shear stress."""
    return bind(sweep, compiled=compiled, rub=bind(rub, shear_stress=shear_stress))

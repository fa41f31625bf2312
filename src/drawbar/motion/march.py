"""Equations of motion of a wheel over columns of tissue that remember: one step, and many.

The implicit midpoint rule with the columns' mean forces over the step: second order, stable for any
stiffness of film or tissue, and every step's work adds up to the rounding of its solution. ``march`` is a
template (see :mod:`drawbar.contact.bind`): ``wipe`` and ``stand`` are the sweep over the columns
(:mod:`drawbar.contact.sweep`) and their footprint (:mod:`drawbar.contact.footprint`) for a film.
"""

from __future__ import annotations

import functools
from typing import Any

import numpy as np

from drawbar.contact.bind import bind, unbound
from drawbar.contact.footprint import FOOTPRINT, footprint_kernel
from drawbar.contact.sweep import SUMS, age_pool, lay_arcs, shift_window, stored, sweep_kernel, window_of
from drawbar.film.base import Film

__all__ = ["BODY", "SAMPLE", "march_kernel"]

wipe = stand = unbound

# The body's state; the last six are the ledger's works since the start.
BODY = ("sinkage", "sink_rate", "travel", "slide_speed", "rotation", "wheel_speed",
        "motor_work", "load_work", "drawbar_work", "film_heat", "damper_heat", "tissue_heat")  # fmt: skip
SAMPLE = (*BODY, *FOOTPRINT, "elastic_energy")

DONE, EDGE, DEEP, STUCK = 0, 1, 2, 3  # why a march ends


def solve3(a: Any, b: Any) -> None:
    """Solves a 3×3 system in place by elimination; its diagonal dominates."""
    for i in range(3):
        for n in range(i + 1, 3):
            ratio = a[n, i] / a[i, i]
            for m in range(i, 3):
                a[n, m] -= ratio * a[i, m]
            b[n] -= ratio * b[i]
    for i in (2, 1, 0):
        for m in range(i + 1, 3):
            b[i] -= a[i, m] * b[m]
        b[i] /= a[i, i]


def forces_of(out: Any, travelled: Any, radius: Any, width: Any) -> Any:
    """Mean reaction, traction force, resistance and torque of a step; faces work along the way."""
    faces = out[2] / travelled if travelled != 0.0 else 0.0
    return width * (out[0] + out[7]), width * out[6], width * (out[1] + faces), width * radius * out[8]


def balance(
    rate: Any, v: Any, omega: Any, body: Any, h: Any, given: Any, body_of: Any, held: Any, out: Any, a: Any, b: Any
) -> Any:
    """What is missing from m δ'' = N - R - c δ', m x'' = F - H - D, J ω' = M - T at mid-step, and one
    Newton step towards it: the new mid-step rates and the residuals over their scale."""
    mass, inertia, damper, radius, width, _ = body_of
    load, pull, torque = given
    reaction, traction, resistance, drag = forces_of(out, v * h, radius, width)
    b[0] = 2.0 * mass * (rate - body[1]) / h - load + reaction + damper * rate
    b[1] = 2.0 * mass * (v - body[3]) / h - traction + resistance + pull
    b[2] = 2.0 * inertia * (omega - body[5]) / h - torque + drag
    a[0, 0] = 2.0 * mass / h + damper + width * out[3]
    a[0, 1] = a[1, 0] = width * out[4]
    a[0, 2] = a[2, 0] = 0.0
    a[1, 1] = 2.0 * mass / h + width * (out[5] - out[10])
    a[1, 2] = a[2, 1] = -width * radius * out[11]
    a[2, 2] = 2.0 * inertia / h + width * radius * radius * out[12]
    for n in range(1, 3):
        if held[n - 1]:
            b[n] = 0.0
            for m in range(3):
                a[n, m] = 1.0 if n == m else 0.0
    scale = load + abs(reaction) + abs(traction) + abs(resistance) + abs(pull) + 1e-9
    wrong = max(abs(b[0]), abs(b[1]), abs(b[2]) / radius) / scale
    solve3(a, b)
    return rate - b[0], v - b[1], omega - b[2], wrong


def commands_of(n: Any, commands: Any, held: Any) -> Any:
    """Mean load, pull and torque of step n; a held speed needs none."""
    load = 0.5 * (commands[0, n] + commands[0, n + 1])
    pull = 0.0 if held[0] else 0.5 * (commands[1, n] + commands[1, n + 1])
    torque = 0.0 if held[1] else 0.5 * (commands[2, n] + commands[2, n + 1])
    return load, pull, torque


def march(
    begin: Any, every: Any, body: Any, ground: Any, since: Any, pool: Any, window: Any, commands: Any, held: Any,
    body_of: Any, law: Any, tables: Any, film: Any, spare: Any, samples: Any,
) -> Any:  # fmt: skip
    """Steps from ``begin`` to the end of the commands, or until the ground ends.

    ``commands`` are the load, the speed or pull, and the wheel speed or torque at every step's ends;
    ``held`` says which of the latter two are speeds. Every ``every`` steps a row of ``samples`` is written.
    Returns the step reached, why it ended, and how many steps were not solved to rounding.
    """
    first, spacing, w, _, _, _, _, _ = ground
    mass, inertia, damper, radius, width, deep = body_of
    h = tables.step
    out = np.zeros(SUMS)
    a = np.zeros((3, 3))
    b = np.zeros(3)
    rough = 0
    gain = 0.0  # of the sink rate in the last half step: a guess for the next
    steps = commands.shape[1] - 1
    if begin == 0:
        write(samples[0], body, ground, window, pool, body_of, law, film, out)
    for n in range(begin, steps):
        given = commands_of(n, commands, held)
        rate = body[1] + gain
        v = 0.5 * (commands[1, n] + commands[1, n + 1]) if held[0] else body[3]
        omega = 0.5 * (commands[2, n] + commands[2, n + 1]) if held[1] else body[5]
        deepest = body[0] + 2.0 * h * max(rate, 0.0) + 2.0 * h * h * given[0] / mass
        new = window_of(first, spacing, w.size, body[2], body[2] + 1.5 * v * h, deepest, radius)
        if new[0] == 0 or new[1] == w.size:
            return n, EDGE, rough
        if body[0] >= radius and not deep:
            return n, DEEP, rough
        shift_window(ground, since, pool, window, new, n * h, law, tables)
        window[0] = new[0]
        window[1] = new[1]
        lay_arcs(ground, new, body[2] + 0.5 * v * h, radius)
        steep = not (held[0] and held[1])
        wrong = 1.0
        trials = 0
        while wrong > 1e-6 and trials < 40:  # a Newton step from 1e-6 ends at rounding
            moving = (body[2], body[2] + v * h, body[0], body[0] + rate * h)
            wipe(False, ground, new, moving, radius * omega, radius, law, tables, film, steep, spare, out)
            rate, v, omega, wrong = balance(rate, v, omega, body, h, given, body_of, held, out, a, b)
            trials += 1
        rough += trials == 40
        if not np.isfinite(wrong):
            return n, STUCK, rough
        moving = (body[2], body[2] + v * h, body[0], body[0] + rate * h)
        wipe(True, ground, new, moving, radius * omega, radius, law, tables, film, False, spare, out)
        heat = width * (out[13] + spacing * age_pool(pool, law, tables))
        _, traction, resistance, drag = forces_of(out, v * h, radius, width)
        speed1 = commands[1, n + 1] if held[0] else 2.0 * v - body[3]
        spin1 = commands[2, n + 1] if held[1] else 2.0 * omega - body[5]
        pull = traction - resistance - mass * (speed1 - body[3]) / h if held[0] else given[1]
        torque = drag + inertia * (spin1 - body[5]) / h if held[1] else given[2]
        body[6] += torque * omega * h
        body[7] += given[0] * rate * h
        body[8] += pull * v * h
        body[9] += width * (out[9] + out[7] * rate * h)
        body[10] += damper * rate * rate * h
        body[11] += heat
        gain = rate - body[1]
        body[0] += rate * h
        body[1] = 2.0 * rate - body[1]
        body[2] += v * h
        body[3] = speed1
        body[4] += omega * h
        body[5] = spin1
        if (n + 1) % every == 0:
            write(samples[(n + 1) // every], body, ground, window, pool, body_of, law, film, out)
    return steps, DONE, rough


def write(
    row: Any, body: Any, ground: Any, window: Any, pool: Any, body_of: Any, law: Any, film: Any, out: Any
) -> None:
    """One sample (see :data:`SAMPLE`): the state, the forces of this instant [N], the energy in the tissue."""
    width = body_of[4]
    feet = out[:9]
    instant = (body[2], body[0], body[1], body[3], body[5])
    stand(ground, window, instant, body_of[3], law, film, feet)
    for i in range(12):
        row[i] = body[i]
    for i in range(9):
        row[12 + i] = feet[i] * (width if i < 6 else 1.0)
    row[21] = width * ground[1] * stored(ground, window, pool, law)


@functools.cache
def march_kernel(film: type[Film], *, compiled: bool = True) -> Any:
    """:func:`march` for a film law."""
    writing = bind(write, stand=footprint_kernel(film.shear_stress))
    return bind(march, compiled=compiled, wipe=sweep_kernel(film.shear_stress), write=writing)

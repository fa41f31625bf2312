"""One column of tissue with memory: pressed, let go, relaxing, touched again; exact for linear motion of its top.

The law is p = k w + c w' + Σ k_i e_i with e_i' = w' - e_i/τ_i. A *pressed* column is known by its deflection
w and the strains e_i. A *free* column has p = 0 and is known by the amplitudes a_m of the modes in which it
recovers, each with its own rate: a_m(t) = a_m exp(-λ_m t), surface w = Σ g_m a_m, and the energy it holds is
Σ λ_m a_m²/2. Both kinds of numbers share one row of memory. Rows are changed in place.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any, NamedTuple

import numpy as np

from drawbar.contact.rolling import bend

__all__ = ["Law", "Tables", "law_of", "tables_of"]


class Law(NamedTuple):
    """A tissue's law as the columns need it. Branches have size n, modes size n, or n + 1 with a viscosity."""

    stiffness: float
    viscosity: float
    instant: float
    """K(0⁺) = k + Σ k_i"""
    branches: np.ndarray
    times: np.ndarray
    rates: np.ndarray
    """λ_m: how fast each mode of a free column recovers [1/s]"""
    lift: np.ndarray
    """g_m: w = Σ g_m a_m"""
    flow: np.ndarray
    """what the dashpots have flowed, q_i = w - e_i = Σ_m flow[i, m] a_m"""
    from_surface: np.ndarray
    from_flow: np.ndarray
    """a_m = from_surface[m] w + Σ_i from_flow[m, i] q_i"""


class Tables(NamedTuple):
    """What a full step of the chosen length needs of every branch and mode, computed once."""

    step: float
    held: np.ndarray
    """for each branch, e' = held[0] e + held[1] w'; of the held strain the coming step's mean and last pressure,
    held[2] e and held[3] e; and its heat, held[4] e² + held[5] e w' + held[6] w'²"""
    free: np.ndarray
    """for each mode, a' = free[0] a, the coming step's last surface free[1] a, and the heat free[2] a²"""
    mean_rate: float
    """d(mean pressure)/d(rate) of a column pressed all through the step"""
    end_rate: float
    """d(last pressure)/d(rate), but for k and c"""


def law_of(stiffness: float, viscosity: float, branches: Sequence[float], times: Sequence[float]) -> Law:
    """The law with the modes of its free recovery.

    With the flows q_i = w - e_i and η_i = k_i τ_i a free column is D y' = -H y for the symmetric
    energy H: y = (w, q), D = diag(c, η), or without viscosity y = q with w = Σ k_i q_i / K(0⁺).
    Scaling by sqrt(D) makes it a symmetric eigenproblem. Branches without stiffness are left out.
    """
    k = np.array([b for b in branches if b > 0.0], dtype=float)
    tau = np.array([t for b, t in zip(branches, times, strict=True) if b > 0.0], dtype=float)
    instant = float(stiffness + k.sum())
    eta = k * tau
    if viscosity > 0.0:
        energy = np.zeros((k.size + 1, k.size + 1))
        energy[0, 0] = instant
        energy[0, 1:] = energy[1:, 0] = -k
        energy[1:, 1:] = np.diag(k)
        damping = np.concatenate([[viscosity], eta])
    else:
        energy, damping = np.diag(k) - np.outer(k, k) / instant, eta
    scale = np.sqrt(damping)
    rates, shapes = np.linalg.eigh(energy / np.outer(scale, scale))
    modes = shapes / scale[:, None]
    back = (modes * damping[:, None]).T
    if viscosity > 0.0:
        lift, flow, from_surface, from_flow = modes[0], modes[1:], back[:, 0], back[:, 1:]
    else:
        lift, flow, from_surface, from_flow = k @ modes / instant, modes, np.zeros(k.size), back
    arrays = (np.maximum(rates, 0.0), lift, flow, from_surface, from_flow)
    return Law(float(stiffness), float(viscosity), instant, k, tau, *(np.ascontiguousarray(a) for a in arrays))


def tables_of(law: Law, step: float) -> Tables:
    """The tables of a step [s]."""
    held = np.zeros((law.times.size, 7))
    mean_rate = 0.5 * law.stiffness * step + law.viscosity
    end_rate = 0.0
    for row, k, tau in zip(held, law.branches, law.times, strict=True):
        keep, rise, climb, one, two, three = moments(step, tau)
        row[:4] = keep, rise, k * rise / step, k * keep
        row[4:] = k / tau * one, 2.0 * k / tau * two, k / tau * three
        mean_rate += k * climb / step
        end_rate += k * rise
    decay = np.exp(-law.rates * step)
    free = np.stack([decay, law.lift * decay, 0.5 * law.rates * (1.0 - decay * decay)], axis=1)
    return Tables(step, held, np.ascontiguousarray(free), float(mean_rate), float(end_rate))


def moments(t: Any, time: Any) -> Any:
    """What a branch does over t: e = e₀ E + s R with E = exp(-t/τ), R = τ (1 - E), and

    E, R (which is ∫E dt too), ∫R dt, ∫E² dt, ∫E R dt = R²/2, ∫R² dt, none of which cancels for t << τ.
    """
    z = t / time
    keep = np.exp(-z)
    rise = -time * np.expm1(-z)
    climb = 0.5 * t * t * bend(z, keep)
    if z < 0.03:
        cube = 1.0 / 3.0 - z * (0.25 - z * (7.0 / 60.0 - z * (1.0 / 24.0 - z * (31.0 / 2520.0 - z / 320.0))))
        rise2 = t * t * t * cube
    else:
        rise2 = time * (climb - 0.5 * rise * rise)
    return keep, rise, climb, -0.5 * time * np.expm1(-2.0 * z), 0.5 * rise * rise, rise2


def mix(constant: Any, slope: Any, shares: Any, rates: Any, count: Any, t: Any) -> Any:
    """A + B t + Σ C_m exp(-D_m t)."""
    f = constant + slope * t
    for m in range(count):
        f += shares[m] * np.exp(-rates[m] * t)
    return f


def first_zero(constant: Any, slope: Any, shares: Any, rates: Any, count: Any, low: Any, high: Any) -> Any:
    """The zero of A + B t + Σ C_m exp(-D_m t) between two times at which its signs differ.

    False position with the Illinois halving; the end where the sign has already changed is returned.
    """
    f_low = mix(constant, slope, shares, rates, count, low)
    f_high = mix(constant, slope, shares, rates, count, high)
    if f_low == 0.0 or (f_low > 0.0) == (f_high > 0.0):
        return low
    last = 0
    for _ in range(80):
        t = (low * f_high - high * f_low) / (f_high - f_low)
        f = mix(constant, slope, shares, rates, count, t)
        if f == 0.0:
            return t
        if (f > 0.0) == (f_high > 0.0):
            high, f_high = t, f
            if last == 1:
                f_low *= 0.5
            last = 1
        else:
            low, f_low = t, f
            if last == -1:
                f_high *= 0.5
            last = -1
        if high - low <= 1e-15 * high:
            break
    return high


def surface(row: Any, law: Any) -> Any:
    """Deflection of a free column [m]."""
    w = 0.0
    for m in range(law.rates.size):
        w += law.lift[m] * row[m]
    return w


def relax(row: Any, t: Any, law: Any) -> Any:
    """A free column recovers for a time t; returns what its dashpots turn into heat [J/m²]."""
    heat = 0.0
    for m in range(law.rates.size):
        left = np.exp(-law.rates[m] * t)
        heat += 0.5 * law.rates[m] * row[m] * row[m] * (1.0 - left * left)
        row[m] *= left
    return heat


def take(row: Any, w: Any, law: Any, spare: Any) -> None:
    """A free column is touched at a deflection w: amplitudes become strains. The flows do not jump."""
    for i in range(law.times.size):
        q = 0.0
        for m in range(law.rates.size):
            q += law.flow[i, m] * row[m]
        spare[i] = w - q
    for i in range(law.times.size):
        row[i] = spare[i]


def let_go(row: Any, w: Any, law: Any, spare: Any) -> None:
    """A pressed column is released at a deflection w: strains become amplitudes. The flows do not jump."""
    for m in range(law.rates.size):
        a = law.from_surface[m] * w
        for i in range(law.times.size):
            a += law.from_flow[m, i] * (w - row[i])
        spare[m] = a
    for m in range(law.rates.size):
        row[m] = spare[m]


def springs(row: Any, w: Any, law: Any) -> Any:
    """Pressure of a pressed column's springs [Pa], its viscosity left out."""
    p = law.stiffness * w
    for i in range(law.times.size):
        p += law.branches[i] * row[i]
    return p


def press(row: Any, w: Any, rate: Any, t: Any, law: Any) -> Any:
    """A column pressed from w at a constant rate for a time t: impulse ∫p dt [Pa s] and heat [J/m²]."""
    impulse = t * (law.stiffness * (w + 0.5 * rate * t) + law.viscosity * rate)
    heat = law.viscosity * rate * rate * t
    for i in range(law.times.size):
        keep, rise, climb, one, two, three = moments(t, law.times[i])
        e = row[i]
        impulse += law.branches[i] * (e * rise + rate * climb)
        heat += law.branches[i] / law.times[i] * (e * e * one + 2.0 * e * rate * two + rate * rate * three)
        row[i] = e * keep + rate * rise
    return impulse, heat


def time_of_touch(row: Any, start: Any, rate: Any, reach: Any, law: Any, spare: Any) -> Any:
    """When a wheel's surface at start + rate t meets a free column, 0 <= t <= reach."""
    for m in range(law.rates.size):
        spare[m] = -law.lift[m] * row[m]
    return first_zero(start, rate, spare, law.rates, law.rates.size, 0.0, reach)


def time_of_release(row: Any, w: Any, rate: Any, reach: Any, law: Any, spare: Any) -> Any:
    """When a column's pressure falls to zero: at once if it is negative, ``reach`` if it still presses there."""
    constant = law.stiffness * w + law.viscosity * rate
    start = constant
    end = constant + law.stiffness * rate * reach
    for i in range(law.times.size):
        flowing = rate * law.times[i]
        spare[i] = law.branches[i] * (row[i] - flowing)
        spare[law.rates.size + i] = 1.0 / law.times[i]
        constant += law.branches[i] * flowing
        start += law.branches[i] * row[i]
        keep, rise, _, _, _, _ = moments(reach, law.times[i])
        end += law.branches[i] * (row[i] * keep + rate * rise)
    if end >= 0.0:
        return reach
    if start <= 0.0:
        return 0.0 * reach
    return first_zero(constant, law.stiffness * rate, spare, spare[law.rates.size :], law.times.size, 0.0, reach)


def pass_over(
    pressed: Any, w: Any, row: Any, enter: Any, leave: Any, high: Any, low: Any, step: Any, law: Any, spare: Any
) -> Any:
    """One step of a column in which something happens: it is touched, released, or meets a vertical face.

    The wheel stands over it from ``enter`` to ``leave``, its surface moving linearly from ``high`` to ``low``;
    before and after the column is free. A face that meets it presses it in at once, which takes K(0⁺) Δ²/2;
    one that leaves it lets it spring back at once, which gives p²/(2 K(0⁺)).

    Returns: pressed at the end, deflection, impulse [Pa s], work of the faces [J/m²], heat [J/m²], time in
    contact [s]. ``row`` becomes the column's at the end of the step.
    """
    span = leave - enter
    rate = (low - high) / span
    heat = 0.0
    work = 0.0
    impulse = 0.0
    held = 0.0
    now = enter
    if pressed and enter > 0.0:  # a column outside the wheel's width cannot be held
        let_go(row, w, law, spare)
        pressed = False
    if not pressed:
        heat += relax(row, enter, law)
        u = surface(row, law)
        if high > u:
            if enter > 0.0:
                work += 0.5 * law.instant * (high - u) * (high - u)
                w = high
            else:  # met between two steps: follow from where the tissue is
                w = u
                rate = (low - u) / span
            take(row, w, law, spare)
            pressed = True
        else:
            for m in range(law.rates.size):
                spare[m] = law.lift[m] * row[m]
            if low > mix(0.0, 0.0, spare, law.rates, law.rates.size, span):
                wait = time_of_touch(row, high, rate, span, law, spare)
                heat += relax(row, wait, law)
                w = high + rate * wait
                take(row, w, law, spare)
                pressed = True
                now = enter + wait
    if pressed:
        held = time_of_release(row, w, rate, leave - now, law, spare)
        impulse, loss = press(row, w, rate, held, law)
        heat += loss
        w = low if held == leave - now else w + rate * held
        if held < leave - now or leave < step:
            p = springs(row, w, law)
            if law.viscosity == 0.0:
                work -= 0.5 * p * p / law.instant
            let_go(row, w, law, spare)
            pressed = False
        now = now + held
    if not pressed:
        heat += relax(row, step - now, law)
        w = surface(row, law)
    return pressed, w, impulse, work, heat, held

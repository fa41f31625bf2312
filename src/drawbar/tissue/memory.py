"""What a fading memory does in time and frequency: the mathematics that the viscoelastic tissues share.

A spectrum is a spring k, a dashpot c and branches (a spring k_i in series with a dashpot of relaxation time
τ_i), all side by side: p = k w + c w' + Σ k_i e_i with e_i' = w' - e_i/τ_i.

Source: Tschoegl 1989, The Phenomenological Theory of Linear Viscoelastic Behavior, chapter 3 (series-
parallel models; relaxation and retardation times interlace). The eigenvalue form of :func:`creep` is derived here.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Any

import numpy as np

from drawbar.quantity import parameters

__all__ = ["Series", "complex_modulus", "creep", "relaxation"]


def relaxation(time: Any, stiffness: Any, branches: Sequence[Any], times: Sequence[Any]) -> Any:
    """Pressure [Pa/m] at a ``time`` [s] after a unit step of indentation: K(t) = k + Σ k_i exp(-t/τ_i)."""
    time = np.asarray(time, dtype=float)
    answer = stiffness + 0.0 * time
    for branch, tau in zip(branches, times, strict=True):
        answer = answer + branch * np.exp(-np.maximum(time, 0.0) / tau)
    return np.where(time >= 0.0, answer, 0.0)[()]


def complex_modulus(
    angular_frequency: Any, stiffness: Any, viscosity: Any, branches: Sequence[Any], times: Sequence[Any]
) -> Any:
    """Pressure per indentation [Pa/m, complex] at ω [rad/s]: k + i ω c + Σ k_i i ω τ_i / (1 + i ω τ_i)."""
    iw = 1j * np.asarray(angular_frequency, dtype=float)
    answer = stiffness + iw * viscosity
    for branch, tau in zip(branches, times, strict=True):
        answer = answer + branch * iw * tau / (1.0 + iw * tau)
    return answer[()]


def creep(time: Any, stiffness: Any, viscosity: Any, branches: Sequence[Any], times: Sequence[Any]) -> Any:
    """Indentation [m/Pa] at a ``time`` [s] after a unit step of pressure, exact at every time.

    With d_i = w - e_i the strain of a branch's dashpot and y_i = sqrt(k_i τ_i) d_i, the equations become
    y' = f - A y with a symmetric A, whose eigenvalues 1/ρ_m are the retardation rates:

    - c = 0: A = diag(1/τ) - b bᵀ/K₀, f = b/K₀, w = (1 + bᵀy)/K₀ with b_i = sqrt(k_i/τ_i), K₀ = k + Σ k_i;
    - c > 0: one more unknown y₀ = sqrt(c) w, A₀₀ = K₀/c, A₀ᵢ = -b_i/sqrt(c), A_ii = 1/τ_i, f₀ = 1/sqrt(c).

    Then J(t) = J₀ + Σ f̂_m² ρ_m (1 - exp(-t/ρ_m)), which without a long-term spring (ρ → ∞) flows as
    f̂_m² t. Its relative rounding error is about 1e-16 times the ratio of the longest time to the shortest.
    """
    time = np.asarray(time, dtype=float)
    viscous = np.asarray(viscosity) > 0.0
    with_dashpot = _creep(time, stiffness, np.where(viscous, viscosity, 1.0), branches, times)
    without = _creep(time, stiffness, None, branches, times)
    return np.where(time >= 0.0, np.where(viscous, with_dashpot, without), 0.0)[()]


def _creep(time: Any, stiffness: Any, viscosity: Any, branches: Sequence[Any], times: Sequence[Any]) -> Any:
    numbers = [np.asarray(x, dtype=float) for x in (stiffness, 1.0 if viscosity is None else viscosity)]
    numbers += [np.asarray(x, dtype=float) for x in (*branches, *times)]
    k, c, *rest = np.broadcast_arrays(*numbers)
    k_i = np.stack(rest[: len(branches)], axis=-1)
    tau = np.stack(rest[len(branches) :], axis=-1)
    b = np.sqrt(k_i / tau)
    instant = k + k_i.sum(axis=-1)
    if viscosity is None:
        force = b / instant[..., None]
        matrix = -force[..., :, None] * b[..., None, :]
        start = 1.0 / instant
    else:
        force = np.zeros((*b.shape[:-1], b.shape[-1] + 1))
        force[..., 0] = 1.0 / np.sqrt(c)
        matrix = np.zeros((*force.shape, force.shape[-1]))
        matrix[..., 0, 0] = instant / c
        matrix[..., 0, 1:] = matrix[..., 1:, 0] = -b / np.sqrt(c)[..., None]
        start = 0.0 * instant
    own = np.arange(-tau.shape[-1], 0)
    matrix[..., own, own] += 1.0 / tau
    rates, modes = np.linalg.eigh(matrix)
    weights = np.einsum("...im,...i->...m", modes, force) ** 2
    past = np.maximum(time, 0.0)
    answer = start + 0.0 * past
    for m in range(rates.shape[-1]):
        z = np.maximum(rates[..., m], 0.0) * past
        answer = answer + weights[..., m] * past * np.where(z > 0.0, -np.expm1(-z) / np.where(z > 0.0, z, 1.0), 1.0)
    return answer


class Series:
    """A tissue whose ``spectrum`` says it all: its answers in time and frequency."""

    spectrum: Callable[..., Any]

    def relaxation(self, time: Any) -> Any:
        """Pressure [Pa/m] at a ``time`` [s] after a unit step of indentation; 0 before it.

        A dashpot's impulse at the step itself is left out.
        """
        stiffness, _, branches, times = self.spectrum(*parameters(self))
        return relaxation(time, stiffness, branches, times)

    def creep(self, time: Any) -> Any:
        """Indentation [m/Pa] at a ``time`` [s] after a unit step of pressure; 0 before it."""
        return creep(time, *self.spectrum(*parameters(self)))

    def complex_modulus(self, angular_frequency: Any) -> Any:
        """Pressure per indentation [Pa/m, complex] under an oscillation of ``angular_frequency`` [rad/s].

        Its real part is stored, its imaginary part (>= 0) is lost.
        """
        return complex_modulus(angular_frequency, *self.spectrum(*parameters(self)))

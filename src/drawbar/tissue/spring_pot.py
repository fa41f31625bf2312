"""The spring-pot: tissue whose memory fades as a power of time."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
from scipy.optimize import nnls

from drawbar.quantity import quantity, value
from drawbar.tissue.base import Tissue
from drawbar.tissue.prony import Prony

__all__ = ["SpringPot"]


@value
class SpringPot(Tissue):
    """Columns between spring and dashpot: relaxation by the same fraction in every decade of time.

    K(t) = k + C t^{-α}, t in seconds, so that C is the relaxing stiffness at 1 s whatever the exponent.
    Complex modulus k + C Γ(1-α) (iω)^α. Creep J(t) = t^α / (C Γ(1-α) Γ(1+α)), with a long-term spring
    (1 - E_α(-k t^α / (C Γ(1-α)))) / k, E_α the Mittag-Leffler function. On a shallow arc of half length a in
    front (k = 0) the contact ends at b = (1-α) a and the resistance coefficient is (a/R) α (3-α)/(4-α), at
    every speed.

    Valid for: as :class:`~drawbar.Winkler`, within the times over which the power law was measured (liver:
    0.01-100 s). Not for deep contact: the vertical front face is met at an infinite rate, against a
    stiffness that has no bound at short times.

    Source: Mainardi 2010, Fractional Calculus and Waves in Linear Viscoelasticity, chapter 3 (power laws)
    and appendix E (Mittag-Leffler function and its spectrum). The rolling closed form is derived from K(t).

    >>> tissue = SpringPot(coefficient=2e5, exponent=0.2)
    >>> round(float(tissue.relaxation(32.0)), 6), round(float(tissue.creep(1.0)) * 2e5, 6)
    (100000.0, 0.935489)
    """

    coefficient: float = quantity(
        "Pa/m", symbol="C", above=0, meaning="pressure per indentation 1 s after the indentation, the spring left out"
    )
    exponent: float = quantity(
        "1", symbol="α", above=0, below=1, meaning="power of time by which the pressure relaxes",
        advice="0 would be a spring (Winkler), 1 a dashpot (KelvinVoigt).",
    )  # fmt: skip
    stiffness: float = quantity(
        "Pa/m", symbol="k", minimum=0, default=0.0, meaning="long-term foundation modulus, beside the power law"
    )

    deep = False

    @staticmethod
    def power_law(coefficient: Any, exponent: Any, stiffness: Any) -> Any:
        return stiffness, coefficient, exponent

    def relaxation(self, time: Any) -> Any:
        """Pressure [Pa/m] at a ``time`` [s] after a unit step of indentation; infinite at it, 0 before it."""
        time = np.asarray(time, dtype=float)
        after = self.stiffness + self.coefficient * np.where(time > 0.0, time, 1.0) ** -self.exponent
        return np.where(time > 0.0, after, np.where(time < 0.0, 0.0, np.inf))[()]

    def complex_modulus(self, angular_frequency: Any) -> Any:
        """Pressure per indentation [Pa/m, complex] under an oscillation of ``angular_frequency`` [rad/s]."""
        iw = 1j * np.asarray(angular_frequency, dtype=float)
        return (self.stiffness + self.coefficient * _gamma(1.0 - self.exponent) * iw**self.exponent)[()]

    def creep(self, time: Any) -> Any:
        """Indentation [m/Pa] at a ``time`` [s] after a unit step of pressure; 0 before it."""
        time = np.maximum(np.asarray(time, dtype=float), 0.0)
        numbers = np.broadcast_arrays(time, self.stiffness, self.coefficient, self.exponent)
        return np.vectorize(_creep, otypes=[float])(*numbers)[()]

    def series(self, shortest: float = 1e-3, longest: float = 1e3, terms: int | None = None) -> Prony:
        """A Prony series with this relaxation function between two times [s].

        ``terms`` branches at most, at times spread evenly in their logarithm, with the non-negative
        stiffnesses that are nearest in relative error. By default as many as keep the error below 0.5 %;
        :meth:`series_error` tells it for any. It keeps the long-term ``stiffness``.

        Raises
        ------
        ValueError
            The times are not 0 < ``shortest`` < ``longest``, or fewer than 2 terms are asked for.

        >>> SpringPot(coefficient=1.0, exponent=0.2).series_error() < 0.005
        True
        """
        if not 0.0 < shortest < longest < math.inf:
            raise ValueError(
                f"shortest and longest must be times with 0 < shortest < longest, got {shortest:g} s and "
                f"{longest:g} s. Give the range of times that the motion spans."
            )
        if terms is not None and terms < 2:
            raise ValueError(f"terms must be >= 2, got {terms}. Leave it out to have them chosen.")
        if terms is not None:
            return self._fitted(shortest, longest, terms)
        enough = 2
        while True:
            found = self._fitted(shortest, longest, enough)
            if self._deviation(found, shortest, longest) < 0.005 or enough >= 60:
                return found
            enough += 1

    def series_error(self, shortest: float = 1e-3, longest: float = 1e3, terms: int | None = None) -> float:
        """Largest relative error of the relaxation function of :meth:`series` between the two times."""
        return self._deviation(self.series(shortest, longest, terms), shortest, longest)

    def _fitted(self, shortest: float, longest: float, terms: int) -> Prony:
        """Branches at even steps h in ln τ, the first the further below ``shortest`` the closer they are.

        The last stands for all slower ones, whose stiffnesses fall as e^{-αh} and whose rates as e^{-h} from
        one to the next: it takes their mean rate.
        """
        step = math.log(longest / shortest) / (terms - 1)
        tau = np.geomspace(min(0.4 * step * step, 1.0) * shortest, 3.0 * longest, terms)
        ratio = tau[0] / tau[1]
        tau[-1] *= (1.0 - ratio ** (1.0 + self.exponent)) / (1.0 - ratio**self.exponent)
        t = np.geomspace(shortest, longest, 40 * terms)
        power = self.coefficient * t**-self.exponent
        shape = np.exp(-t[:, None] / tau) / (self.stiffness + power)[:, None]
        scale = float(self.coefficient)
        weights, _ = nnls(shape * scale, power / (self.stiffness + power), maxiter=100 * terms)
        kept = weights > 0.0
        return Prony(
            stiffness=self.stiffness,
            branch_stiffnesses=tuple(weights[kept] * scale),
            relaxation_times=tuple(tau[kept]),
        )

    def _deviation(self, series: Prony, shortest: float, longest: float) -> float:
        t = np.geomspace(shortest, longest, 4001)
        return float(np.max(np.abs(series.relaxation(t) / self.relaxation(t) - 1.0)))


_gamma = np.vectorize(math.gamma, otypes=[float])


def _creep(time: float, stiffness: float, coefficient: float, exponent: float) -> float:
    """(1 - E_α(-z))/k, z = k t^α / (C Γ(1-α)): by the power series of E_α for z < 1/2, else by its spectrum."""
    power = coefficient * math.gamma(1.0 - exponent)
    z = stiffness * time**exponent / power
    if z < 0.5:  # (1 - E_α(-z))/z, which is 1/Γ(1+α) without a spring
        ratio = sum((-z) ** n / math.gamma(1.0 + exponent * (n + 1)) for n in range(60))
        return ratio * time**exponent / power
    return (1.0 - _mittag_leffler(z ** (1.0 / exponent), exponent)) / stiffness


def _mittag_leffler(x: float, exponent: float) -> float:
    """E_α(-x^α) = (sin πα / π) ∫ exp(-x e^u) / (2 (cosh αu + cos πα)) du over all u.

    The trapezoidal rule converges exponentially: the integrand is analytic where |Im u| is below both π/2
    and π (1-α)/α.
    """
    step = 2.0 * math.pi * min(0.5 * math.pi, math.pi * (1.0 - exponent) / exponent) / 32.0
    low, high = -34.0 / exponent, math.log(40.0 / x)
    u = np.arange(min(low, high - 1.0), high, step)
    weight = np.exp(-x * np.exp(u)) / (2.0 * (np.cosh(exponent * u) + math.cos(math.pi * exponent)))
    return math.sin(math.pi * exponent) / math.pi * step * float(weight.sum())

"""How well one list of numbers describes another: by what factor, by what offset, in sign and in rank."""

from __future__ import annotations

import dataclasses
import math

import numpy as np
from scipy.special import stdtrit

__all__ = ["MARGIN", "RELATIONS", "Agreement", "Coefficient", "agreement", "mean_interval"]

MARGIN = 6.0
"""Difference in AICc from which one relation counts as better: an evidence ratio of exp(3), 20 to 1."""

RELATIONS = ("identical", "scaled", "shifted", "both")
"""data ≈ model; data ≈ s model; data ≈ model + b; data ≈ s model + b."""


@dataclasses.dataclass(frozen=True)
class Coefficient:
    """A factor or an offset, its standard error and 95 % interval (Student t); NaN where there is none."""

    value: float
    standard_error: float = math.nan
    interval: tuple[float, float] = (math.nan, math.nan)

    def holds(self, number: float) -> bool:
        """Whether the interval holds a number; without an interval, only its own value."""
        low, high = self.interval
        return self.value == number if math.isnan(low) else low <= number <= high

    @property
    def inverse(self) -> Coefficient:
        """1/value, with the interval's limits turned round; no interval where that would hold infinity."""
        if not math.isfinite(self.value) or self.value == 0.0:
            return Coefficient(math.nan)
        low, high = self.interval
        bounded = not math.isnan(low) and not self.holds(0.0)
        limits = (1.0 / high, 1.0 / low) if bounded else (math.nan, math.nan)
        return Coefficient(1.0 / self.value, self.standard_error / self.value**2, limits)


@dataclasses.dataclass(frozen=True)
class Agreement:
    """The agreement of ``model`` and ``data`` over ``count`` conditions, each weighing the same.

    ``residuals`` are sums of squared residuals by relation (:data:`RELATIONS`), ``aicc`` Akaike's
    criterion with its correction for few conditions, NaN where there are too few. ``advantage`` is
    AICc(shifted) - AICc(scaled), positive where a factor explains more than an offset.
    """

    count: int
    scale: Coefficient
    offset: Coefficient
    scale_of_both: Coefficient
    offset_of_both: Coefficient
    residuals: dict[str, float]
    aicc: dict[str, float]
    advantage: float
    explained_by: str
    nrmse: dict[str, float]
    spearman: float
    kendall: float

    def spread(self, relation: str) -> float:
        """Root mean square of a relation's residuals."""
        return math.sqrt(self.residuals[relation] / self.count)


def mean_interval(values: np.ndarray) -> tuple[float, float]:
    """The mean and the half width of its 95 % interval (Student t); NaN for fewer than two values."""
    if values.size < 2:
        return float(values[0]), math.nan
    return float(np.mean(values)), float(_student(values.size - 1) * np.std(values, ddof=1) / math.sqrt(values.size))


def agreement(model: np.ndarray, data: np.ndarray) -> Agreement:
    """Compare two lists of numbers, condition by condition.

    Least squares, every condition with the same weight: ``s = Σ m d / Σ m²``, ``b = mean(d - m)``.
    ``NRMSE`` is the root mean square difference over the range of the data. ``explained_by`` is

    - ``"none"``: nothing to explain, as s = 1 and b = 0 lie within both intervals;
    - ``"scale"`` or ``"offset"``: its AICc is lower by :data:`MARGIN` at least;
    - ``"cannot tell"``: neither, or fewer than three conditions.

    >>> found = agreement(np.array([3.0, 0.0, -3.0]), np.array([1.0, 0.0, -1.0]))
    >>> found.explained_by, round(found.scale.inverse.value, 9)
    ('scale', 3.0)
    """
    n = model.size
    floor = n * (1e-12 * float(np.max(np.abs([model, data])))) ** 2  # what rounding alone leaves
    scale, scaled = _scale(model, data)
    offset, shifted = _student_mean(data - model)
    scale_of_both, offset_of_both, both = _line(model, data, min(scaled, shifted))
    found = (float(np.sum((data - model) ** 2)), scaled, shifted, both)
    residuals = {name: 0.0 if r <= floor else r for name, r in zip(RELATIONS, found, strict=True)}
    aicc = {name: _aicc(r, n, k, floor) for (name, r), k in zip(residuals.items(), (1, 2, 2, 3), strict=True)}
    low = max(floor, np.finfo(float).tiny)
    advantage = n * math.log(max(residuals["shifted"], low) / max(residuals["scaled"], low))
    extent = float(np.ptp(data))
    nrmse = {
        name: math.sqrt(r / n) / extent if extent > 1e-12 * np.max(np.abs(data)) else math.nan
        for name, r in residuals.items()
    }
    spearman, kendall = _ranks(model, data)
    return Agreement(
        count=n,
        scale=scale,
        offset=offset,
        scale_of_both=scale_of_both,
        offset_of_both=offset_of_both,
        residuals=residuals,
        aicc=aicc,
        advantage=advantage,
        explained_by=_explained(n, residuals["identical"], scale, offset, advantage),
        nrmse=nrmse,
        spearman=spearman,
        kendall=kendall,
    )


def _explained(n: int, identical: float, scale: Coefficient, offset: Coefficient, advantage: float) -> str:
    if identical == 0.0 or (n >= 3 and scale.holds(1.0) and offset.holds(0.0)):
        return "none"
    if n < 3 or abs(advantage) < MARGIN:
        return "cannot tell"
    return "scale" if advantage > 0 else "offset"


def _student(freedom: int) -> float:
    return float(stdtrit(freedom, 0.975))


def _estimate(value: float, variance: float, freedom: int) -> Coefficient:
    if freedom < 1:
        return Coefficient(value)
    error = math.sqrt(max(variance, 0.0) / freedom)
    half = _student(freedom) * error
    return Coefficient(value, error, (value - half, value + half))


def _scale(model: np.ndarray, data: np.ndarray) -> tuple[Coefficient, float]:
    square = float(model @ model)
    if square == 0.0:  # a model of zeros has no factor, and no factor mends it
        return Coefficient(math.nan), float(data @ data)
    s = float(model @ data) / square
    left = float(np.sum((data - s * model) ** 2))
    return _estimate(s, left / square, model.size - 1), left


def _student_mean(difference: np.ndarray) -> tuple[Coefficient, float]:
    b = float(np.mean(difference))
    left = float(np.sum((difference - b) ** 2))
    return _estimate(b, left / difference.size, difference.size - 1), left


def _line(model: np.ndarray, data: np.ndarray, otherwise: float) -> tuple[Coefficient, Coefficient, float]:
    """data ≈ s model + b; where the model is the same throughout, both cannot be told apart."""
    n = model.size
    centred = model - np.mean(model)
    square = float(centred @ centred)
    if n < 2 or square <= n * (1e-9 * np.max(np.abs(model))) ** 2:
        return Coefficient(math.nan), Coefficient(math.nan), otherwise
    s = float(centred @ data) / square
    b = float(np.mean(data) - s * np.mean(model))
    left = float(np.sum((data - s * model - b) ** 2))
    return (
        _estimate(s, left / square, n - 2),
        _estimate(b, left * (1.0 / n + float(np.mean(model)) ** 2 / square), n - 2),
        left,
    )


def _aicc(residual: float, n: int, k: int, floor: float) -> float:
    """n ln(RSS/n) + 2k + 2k(k+1)/(n-k-1), with k counting the residuals' own spread."""
    if n - k - 1 < 1:
        return math.nan
    return n * math.log(max(residual, floor, np.finfo(float).tiny) / n) + 2 * k + 2 * k * (k + 1) / (n - k - 1)


def _ranks(model: np.ndarray, data: np.ndarray) -> tuple[float, float]:
    """Spearman's ρ and Kendall's τ; NaN for fewer than three conditions or where one side is constant."""
    from scipy import stats  # late: slow to import

    def rounded(values: np.ndarray) -> np.ndarray:  # what differs by rounding alone is a tie
        return np.round(values / max(float(np.max(np.abs(values))), np.finfo(float).tiny), 9)

    m, d = rounded(model), rounded(data)
    if m.size < 3 or np.ptp(m) == 0.0 or np.ptp(d) == 0.0:
        return math.nan, math.nan
    return float(np.corrcoef(stats.rankdata(m), stats.rankdata(d))[0, 1]), float(np.asarray(stats.kendalltau(m, d))[0])

"""Which Coulomb term the loads support: a constant yield stress, a friction coefficient, or both."""

from __future__ import annotations

import dataclasses
from collections.abc import Callable, Mapping

import numpy as np

from drawbar.study.identify.doubts import added, sentence_of_p
from drawbar.study.identify.least_squares import Solution

__all__ = ["CHOICES", "Choice", "choose"]

CHOICES: dict[str, tuple[str, ...]] = {
    "none": (),
    "yield_stress": ("yield_stress",),
    "friction_coefficient": ("friction_coefficient",),
    "both": ("yield_stress", "friction_coefficient"),
}
"""The Coulomb terms of each choice."""

SUPPORT = {"yield_stress": 0.05, "friction_coefficient": 0.01}
"""Level at which a term is taken to be needed. The yield stress, taken to be the source's Coulomb friction,
stays in more easily than a friction coefficient comes in beside it: each term that chance lets in or out
biases the others, and this way 99 in 100 films with a yield stress are fitted as what they are."""


@dataclasses.dataclass(frozen=True)
class Choice:
    """What was chosen, why, and whether that deserves a warning rather than a note."""

    name: str
    reason: str
    unsure: bool


def choose(solve: Callable[[str], Solution], columns: Mapping[str, np.ndarray], *, uneven: bool) -> Choice:
    """Let the data choose the Coulomb term.

    A term is needed if the fit without it, but with the other, leaves residuals that it explains (F-test at
    the levels of ``SUPPORT``) and if it comes out positive beside the other. One needed term is taken, two
    are both taken. With none needed the loads cannot tell, and the constant yield stress is taken; whether
    there is any Coulomb term at all is then said too. The corrected Akaike criterion (AICc) of all four
    choices is reported beside it.

    Parameters
    ----------
    solve
        The fit without bounds for a choice by name.
    columns
        The regressors (n,) by parameter.
    uneven
        Whether the spread differs between observations.
    """
    fits = {name: solve(name) for name in CHOICES}
    criteria = {name: aicc(fit) for name, fit in fits.items()}
    other = {"yield_stress": "friction_coefficient", "friction_coefficient": "yield_stress"}
    p, needed = {}, {}
    for term in other:
        p[term], _ = added(fits[other[term]], columns[term][:, None], uneven=uneven)
        both = fits["both"]
        needed[term] = p[term] < SUPPORT[term] and both.values[both.names.index(term)] > 0.0
    table = "AICc above the best: " + ", ".join(
        f"{name.replace('_', ' ')} {c - min(criteria.values()):.1f}" for name, c in criteria.items()
    )
    if all(needed.values()):
        worst = sentence_of_p(max(p.values()))
        reason = f"the loads support both a yield stress and a friction coefficient ({worst} for either to be missing)"
        return Choice("both", f"{reason}. {table}.", unsure=False)
    for term, rival in other.items():
        if needed[term]:
            reason = (
                f"the loads support a {_words(term)} ({sentence_of_p(p[term])} for doing without it) and not a "
                f"{_words(rival)} beside it ({sentence_of_p(p[rival])})"
            )
            return Choice(term, f"{reason}. {table}.", unsure=False)
    any_term = min(added(fits["none"], columns[term][:, None], uneven=uneven)[0] for term in other)
    if any_term >= min(SUPPORT.values()):
        reason = f"the data show no Coulomb term ({sentence_of_p(any_term)}); its bound is given as a yield stress"
        return Choice("yield_stress", f"{reason}. {table}.", unsure=False)
    better = min(other, key=lambda name: criteria[name])
    margin = abs(criteria["yield_stress"] - criteria["friction_coefficient"])
    reason = (
        "the loads cannot tell a yield stress from a friction coefficient "
        f"(a {_words(better)} is better by {margin:.1f} in AICc, which is no proof); the source's Coulomb friction is "
        "taken as a constant yield stress. The law is sure only near these loads; drag at loads further apart"
    )
    return Choice("yield_stress", f"{reason}. {table}.", unsure=True)


def _words(term: str) -> str:
    return term.replace("_", " ")


def aicc(solution: Solution) -> float:
    """n ln(RSS/n) + 2 K + 2 K (K + 1)/(n - K - 1), with K parameters, the spread included.

    Source: C. M. Hurvich, C.-L. Tsai, Biometrika 76 (1989) 297-307.
    """
    n, parameters = solution.residuals.size, len(solution.free) + 1
    penalty = 2 * parameters + 2 * parameters * (parameters + 1) / max(n - parameters - 1, 1)
    return float(n * np.log(solution.sum_of_squares / n) + penalty)

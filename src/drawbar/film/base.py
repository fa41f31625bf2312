"""What every film is: a law that answers a slip velocity under a pressure with a shear stress."""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import Any, ClassVar

__all__ = ["Film", "checked_range"]


class Film:
    """Base of all films between wheel and tissue. A subclass is one file.

    ``registry`` holds every law by class name: defining a subclass is what adds it.
    """

    registry: ClassVar[dict[str, type[Film]]] = {}

    def __init_subclass__(cls) -> None:
        Film.registry[cls.__name__] = cls

    shear_stress: ClassVar[Callable[..., Any]]
    """Shear stress [Pa] on the wheel at (slip velocity V [m/s], pressure [Pa], ...). Odd in V and never
    against it in sign, τ V >= 0: a film only dissipates."""

    arc: ClassVar[Callable[..., Any] | None] = None
    """Exact integrals over a contact arc of (rear, front, vx, vy, omega, radius, ...), or None: sum
    over nodes. Returns per width r∫τ cos θ dθ, r∫τ sin θ dθ, side force, r²∫τ dθ, and r∫τ V dθ."""

    @property
    def continuous_at_rest(self) -> bool:
        """Whether the shear stress rises without a jump from zero slip: what free motion needs."""
        return True

    def range(self) -> dict[str, tuple[float, float] | None]:
        """Where the numbers of this film hold, as (low, high): ``slip_velocity`` [m/s], as a magnitude, and
        ``pressure`` [Pa]. None where no range is stated. Kernels do not read it: a result says when it left it.
        """
        return {"slip_velocity": None, "pressure": None}


def checked_range(name: str, given: Any, unit: str) -> tuple[float, float] | None:
    """``given`` as (low, high) floats in ``unit``, or None.

    Raises
    ------
    ValueError
        It is not two finite numbers with 0 <= low < high.
    """
    if given is None:
        return None
    try:
        low, high = (float(number) for number in given)
    except (TypeError, ValueError):
        low = high = math.nan
    if not 0.0 <= low < high < math.inf:
        raise ValueError(
            f"{name} must be two numbers (low, high) in {unit} with 0 <= low < high, got {given!r}. "
            "It is where the film was measured; leave it out if that is not known."
        )
    return low, high

"""What Kerdok and colleagues print on the creep of perfused porcine liver.

Kerdok et al.: *Effects of perfusion on the viscoelastic characteristics of liver*, J. Biomech. 39 (2006)
2221-2231.
"""

from __future__ import annotations

from drawbar.sources.number import Number

__all__ = ["CITATION", "PRINTED"]

CITATION = (
    "Kerdok et al.: Effects of perfusion on the viscoelastic characteristics of liver, J. Biomech. 39, 2006, 2221-2231"
)

PRINTED: dict[str, Number] = {
    "short_creep_time": Number(1.86, "s", "on the order of 1.86 s", "abstract"),
    "long_creep_time": Number(51.3, "s", "and 51.3 s", "abstract"),
}
"""Time constants of creep; they say little of the 0.04-0.1 s that a wheel at a few cm/s works at."""

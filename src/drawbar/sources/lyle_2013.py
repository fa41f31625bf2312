"""What Lyle and colleagues print on the friction of an edgeless sled on small bowel.

A. B. Lyle, B. S. Terry, J. A. Schoen, M. E. Rentschler: *Preliminary Friction Force Measurements on Small
Bowel Lumen When Eliminating Sled Edge Effects*, Tribology Letters 51 (2013) 377-383.
"""

from __future__ import annotations

from drawbar.sources.number import Number

__all__ = ["CITATION", "PRINTED"]

CITATION = (
    "A. B. Lyle, B. S. Terry, J. A. Schoen, M. E. Rentschler: Preliminary Friction Force Measurements on Small Bowel "
    "Lumen When Eliminating Sled Edge Effects, Tribology Letters 51, 2013, 377-383"
)

PRINTED: dict[str, Number] = {
    "friction_force_low": Number(0.013, "N", "from 0.013 to 0.08 N", "abstract"),
    "friction_force_high": Number(0.08, "N", "from 0.013 to 0.08 N", "abstract"),
    "friction_coefficient_low": Number(0.007, "1", "from 0.007 to 0.054", "abstract"),
    "friction_coefficient_high": Number(0.054, "1", "from 0.007 to 0.054", "abstract"),
}
"""Stainless steel on the inner surface of the small bowel; friction rises with speed."""

"""What Buselli and colleagues print on pillars on colon.

Buselli et al.: *Evaluation of friction enhancement through soft polymer micro-patterns in active capsule
endoscopy*, Measurement Science and Technology 21 (2010) 105802.
"""

from __future__ import annotations

from drawbar.sources.number import Number

__all__ = ["CITATION", "PRINTED"]

CITATION = (
    "Buselli et al.: Evaluation of friction enhancement through soft polymer micro-patterns in active capsule "
    "endoscopy, Measurement Science and Technology 21, 2010, 105802"
)

PRINTED: dict[str, Number] = {
    "friction_gain": Number(1.417, "1", "enhanced friction by 41.7 % with regard to flat surfaces", "abstract"),
    "pillar_aspect_ratio": Number(1.0, "1", "an aspect ratio close to 1", "abstract"),
}
"""Friction of soft pillars on colon over that of a flat surface."""

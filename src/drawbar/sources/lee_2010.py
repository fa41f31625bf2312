"""What Lee and colleagues print on micropatterned surfaces on porcine large intestine.

S.-H. Lee, Y.-T. Kim, S. Yang, E.-S. Yoon, D.-E. Kim, K. Y. Suh: *An Optimal Micropatterned End-Effecter for
Enhancing Frictional Force on Large Intestinal Surface* (2010).
"""

from __future__ import annotations

from drawbar.sources.number import Number

__all__ = ["CITATION", "PRINTED"]

CITATION = (
    "S.-H. Lee, Y.-T. Kim, S. Yang, E.-S. Yoon, D.-E. Kim, K. Y. Suh: An Optimal Micropatterned End-Effecter for "
    "Enhancing Frictional Force on Large Intestinal Surface, 2010"
)

PRINTED: dict[str, Number] = {
    "plain_friction_coefficient": Number(0.58, "1", "average ~0.58", "abstract"),
    "lines_friction_coefficient": Number(1.53, "1", "average ~1.53, lines parallel to the motion", "abstract"),
    "other_friction_coefficient_low": Number(0.72, "1", "average 0.72-0.94", "abstract"),
    "other_friction_coefficient_high": Number(0.94, "1", "average 0.72-0.94", "abstract"),
}
"""Mean friction coefficients of plain, lined and otherwise patterned surfaces."""

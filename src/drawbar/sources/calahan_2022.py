"""What Calahan and colleagues find on pillar arrays on a hydrogel: words, no number.

K. N. Calahan, Y. Qi, K. G. Johannes, M. E. Rentschler, R. Long: *Local lateral contact governs shear traction
of micropatterned surfaces on hydrogel substrates*, Science Advances 8 (2022) eabn2728.
"""

from __future__ import annotations

__all__ = ["CITATION", "STATEMENTS"]

CITATION = (
    "K. N. Calahan, Y. Qi, K. G. Johannes, M. E. Rentschler, R. Long: Local lateral contact governs shear traction of "
    "micropatterned surfaces on hydrogel substrates, Science Advances 8, 2022, eabn2728"
)

STATEMENTS: dict[str, str] = {
    "lateral_contact": "lateral contact of each pillar with the deformed gel governs the shear",
    "leading_edge": "the traction of a pillar depends on how convex its leading edge is",
}
"""Findings in this project's words, from the abstract."""

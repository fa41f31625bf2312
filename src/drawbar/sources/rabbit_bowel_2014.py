"""What a study of sliding on rabbit bowel finds on friction trauma: words, no number.

*Investigation on Friction Trauma of Small Intestine In Vivo Under Reciprocal Sliding Conditions*, Tribology
Letters (2014).
"""

from __future__ import annotations

__all__ = ["CITATION", "STATEMENTS"]

CITATION = (
    "Investigation on Friction Trauma of Small Intestine In Vivo Under Reciprocal Sliding Conditions, Tribology "
    "Letters, 2014"
)

STATEMENTS: dict[str, str] = {
    "sliding_trauma": "the damage of the bowel grows with the total friction energy",
}
"""Findings in this project's words, from the abstract."""

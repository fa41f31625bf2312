"""What Barrie and colleagues print on how long and how hard a colon may be grasped.

Barrie et al.: *An in vivo analysis of safe laparoscopic grasping thresholds for colorectal surgery* (2018).
"""

from __future__ import annotations

from drawbar.sources.number import Number

__all__ = ["CITATION", "PRINTED"]

CITATION = "Barrie et al.: An in vivo analysis of safe laparoscopic grasping thresholds for colorectal surgery, 2018"

PRINTED: dict[str, Number] = {
    "force_time_product": Number(300.0, "N s", "a force-time product over 300 N s", "abstract"),
}
"""Above it, porcine colon shows changes under the microscope."""

"""What a study of surgical grasping prints on the pressure that injures human bowel.

*Tissue stress from laparoscopic grasper use and bowel injury in humans: establishing intraoperative force
boundaries*, BMJ Surgery, Interventions, & Health Technologies 3 (2021) e000084.
"""

from __future__ import annotations

from drawbar.sources.number import Number

__all__ = ["CITATION", "PRINTED"]

CITATION = (
    "Tissue stress from laparoscopic grasper use and bowel injury in humans: establishing intraoperative force "
    "boundaries, BMJ Surgery, Interventions, & Health Technologies 3, 2021, e000084"
)

PRINTED: dict[str, Number] = {
    "injury_pressure_low": Number(329e3, "Pa", "a safety threshold of 329-330 kPa", "abstract"),
    "injury_pressure_high": Number(330e3, "Pa", "a safety threshold of 329-330 kPa", "abstract"),
    "grasp_duration": Number(10.0, "s", "a duration of 10 s", "abstract"),
}
"""A limit of human small bowel and colon, not of liver."""

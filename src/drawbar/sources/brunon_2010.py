"""What Brunon and colleagues print on the failure of the liver's capsule.

Brunon et al.: *Mechanical characterization of liver capsule through uniaxial quasi-static tensile tests until
failure*, J. Biomech. 43 (2010) 2221.
"""

from __future__ import annotations

from drawbar.sources.number import Number

__all__ = ["CITATION", "PRINTED"]

CITATION = (
    "Brunon et al.: Mechanical characterization of liver capsule through uniaxial quasi-static tensile tests until "
    "failure, J. Biomech. 43, 2010, 2221"
)

PRINTED: dict[str, Number] = {
    "failure_tension": Number(300.0, "N/m", "0.3 N/mm", "abstract"),
    "failure_strain": Number(0.47, "1", "47 %", "abstract"),
}
"""Mean load per width and local strain at which Glisson's capsule fails."""

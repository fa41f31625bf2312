"""What Terry and colleagues print on the adhesion of small-bowel mucosa.

B. S. Terry, A. C. Passernig, M. L. Hill, J. A. Schoen, M. E. Rentschler: *Small intestine mucosal adhesivity
to in vivo capsule robot materials*, J. Mech. Behav. Biomed. Mater. 15 (2012) 24-32.
"""

from __future__ import annotations

from drawbar.sources.number import Number

__all__ = ["CITATION", "PRINTED"]

CITATION = (
    "B. S. Terry, A. C. Passernig, M. L. Hill, J. A. Schoen, M. E. Rentschler: Small intestine mucosal adhesivity to "
    "in vivo capsule robot materials, J. Mech. Behav. Biomed. Mater. 15, 2012, 24-32"
)

PRINTED: dict[str, Number] = {
    "tack_energy": Number(1.98, "J/m^2", "0.198 ± 0.070 mJ/cm²", "abstract"),
    "tack_energy_spread": Number(0.70, "J/m^2", "0.198 ± 0.070 mJ/cm²", "abstract"),
    "peel_energy": Number(0.55, "J/m^2", "0.055 ± 0.016 mJ/cm²", "abstract"),
    "peel_energy_spread": Number(0.16, "J/m^2", "0.055 ± 0.016 mJ/cm²", "abstract"),
}
"""Mean separation energies of mucosa from engineering materials; 1 mJ/cm² is 10 J/m²."""

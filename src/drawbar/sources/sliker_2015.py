"""What Sliker and colleagues print on how well traction can be predicted.

L. J. Sliker, M. D. Kern, M. E. Rentschler: *An Automated Traction Measurement Platform and Empirical Model for
Evaluation of Rolling Micropatterned Wheels*, IEEE/ASME Transactions on Mechatronics 20 (2015) 1854.
"""

from __future__ import annotations

from drawbar.sources.number import Number

__all__ = ["CITATION", "PRINTED"]

CITATION = (
    "L. J. Sliker, M. D. Kern, M. E. Rentschler: An Automated Traction Measurement Platform and Empirical Model for "
    "Evaluation of Rolling Micropatterned Wheels, IEEE/ASME Transactions on Mechatronics 20, 2015, 1854"
)

PRINTED: dict[str, Number] = {
    "fitted_error": Number(0.011, "1", "average NRMSE 1.1 % on the data of the fit", "abstract"),
    "predicted_error": Number(0.018, "1", "average NRMSE 1.8 % on data not used in the fit", "abstract"),
    "worst_predicted_error": Number(0.086, "1", "max 8.6 % on data not used in the fit", "abstract"),
}
"""Normalised root-mean-square errors of traction, micropatterned PDMS on synthetic tissue."""

"""Normal laws: what pressure a tissue answers to an indentation and its history. One law, one file."""

from drawbar.tissue.base import Tissue
from drawbar.tissue.filonenko_borodich import FilonenkoBorodich
from drawbar.tissue.kelvin_voigt import KelvinVoigt
from drawbar.tissue.prony import Prony
from drawbar.tissue.spring_pot import SpringPot
from drawbar.tissue.standard_linear_solid import StandardLinearSolid
from drawbar.tissue.winkler import Winkler

__all__ = ["FilonenkoBorodich", "KelvinVoigt", "Prony", "SpringPot", "StandardLinearSolid", "Tissue", "Winkler"]

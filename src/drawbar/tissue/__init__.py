"""Normal laws: what pressure a tissue answers to an indentation. One law, one file."""

from drawbar.tissue.base import Tissue
from drawbar.tissue.filonenko_borodich import FilonenkoBorodich
from drawbar.tissue.winkler import Winkler

__all__ = ["FilonenkoBorodich", "Tissue", "Winkler"]

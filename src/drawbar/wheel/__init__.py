"""Wheels: geometry and mass."""

from drawbar.wheel.base import Wheel

__all__ = ["Wheel"]

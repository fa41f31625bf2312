"""The physics: a state in, a wrench out."""

from drawbar.contact.wrench import State, Wrench, wrench

__all__ = ["State", "Wrench", "wrench"]

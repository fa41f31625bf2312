"""How a source holds what it prints, and how it offers a ready-made law."""

from __future__ import annotations

import dataclasses

__all__ = ["Number", "Preset"]


@dataclasses.dataclass(frozen=True)
class Number:
    """A printed or assumed number in SI, as it is printed, and where."""

    value: float
    unit: str
    printed: str
    where: str


@dataclasses.dataclass(frozen=True)
class Preset:
    """A ready-made wheel, tissue or film: the law, and what of it is printed and what assumed."""

    name: str
    law: object
    note: str

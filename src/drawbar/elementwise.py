"""The one choice that arrays and compiled single numbers spell differently."""

from __future__ import annotations

from typing import Any

import numpy as np

__all__ = ["one_where", "where"]


def where(condition: Any, yes: Any, no: Any) -> Any:
    """``yes`` where the condition holds, else ``no``; a number for numbers, an array for arrays.

    Kernels use it in place of ``numpy.where``, which compiled code answers with an array even for
    single numbers. The compiler takes :func:`one_where` in its stead.
    """
    return np.where(condition, yes, no)[()]


def one_where(condition: Any, yes: Any, no: Any) -> Any:
    """:func:`where` for single numbers."""
    return yes if condition else no

"""The two operations that arrays and compiled single numbers spell differently."""

from __future__ import annotations

from typing import Any

import numpy as np

__all__ = ["TWINS", "rows", "where"]


def where(condition: Any, yes: Any, no: Any) -> Any:
    """``yes`` where the condition holds, else ``no``; a number for numbers, an array for arrays.

    Kernels use it in place of ``numpy.where``, which compiled code answers with an array even for
    single numbers. The compiler takes a branch in its stead.
    """
    return np.where(condition, yes, no)[()]


def _one_where(condition: Any, yes: Any, no: Any) -> Any:
    """:func:`where` for single numbers."""
    return yes if condition else no


def rows(count: int, like: Any) -> Any:
    """``count`` rows of zeros, each of the shape of ``like``: what a kernel keeps for each branch."""
    return np.zeros((count, *np.shape(like)))


def _one_rows(count: int, like: Any) -> Any:
    """:func:`rows` for single numbers."""
    return np.zeros(count)


TWINS = {where: _one_where, rows: _one_rows}
"""What the compiler takes for each of these functions: the same for single numbers."""

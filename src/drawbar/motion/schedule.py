"""Commands that change with time: a number, or (time, value) pairs joined by straight lines."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from drawbar.quantity import Quantity, check

__all__ = ["Command", "is_schedule", "sampled"]

Command = float | Sequence[tuple[float, float]]
"""A constant, or pairs (time [s], value) in rising time; before the first and after the last it is constant."""


def is_schedule(command: object) -> bool:
    """Whether a command changes with time."""
    return isinstance(command, (list, tuple, np.ndarray))


def sampled(name: str, command: Command, declared: Quantity, time: np.ndarray) -> np.ndarray:
    """A command at the given times [s].

    Raises
    ------
    TypeError, ValueError
        It is no number and no list of pairs, its times do not rise, or a value is out of bounds.

    >>> import numpy as np
    >>> sampled("speed", [(0.0, 0.0), (1.0, 0.02)], Quantity(unit="m/s"), np.array([0.0, 0.5, 3.0])).tolist()
    [0.0, 0.01, 0.02]
    """
    if not is_schedule(command):
        return np.full(time.shape, float(check(name, command, declared)))
    pairs = np.asarray(command, dtype=float)
    if pairs.ndim != 2 or pairs.shape[1] != 2:
        raise ValueError(f"{name} must be a number or a list of (time, value) pairs, got an array of {pairs.shape}.")
    check(name, pairs[:, 1], declared)
    if np.any(np.diff(pairs[:, 0]) <= 0.0) or not np.all(np.isfinite(pairs)):
        raise ValueError(f"{name} must have rising times. For a jump, put two times a millisecond apart.")
    return np.interp(time, pairs[:, 0], pairs[:, 1])

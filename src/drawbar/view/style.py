"""How every figure looks: one style, friendly units, whole files that are the same for the same input."""

from __future__ import annotations

import contextlib
import re
import textwrap
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import matplotlib
import numpy as np
from cycler import cycler
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from drawbar.files import refuse_existing, whole
from drawbar.variables import VARIABLES

__all__ = [
    "COLOURS",
    "GREY",
    "INK",
    "MARKERS",
    "Shown",
    "caption",
    "legend",
    "new_figure",
    "number",
    "save",
    "shown",
    "style",
    "zero_line",
]

INK = "#222222"
GREY = "#8c8c8c"

COLOURS = ("#0072B2", "#D55E00", "#009E73", "#CC79A7", "#E69F00", "#56B4E9", "#000000")
"""Okabe and Ito's colours, told apart by colour-blind readers; the darkest first, yellow left out for print."""

MARKERS = ("o", "s", "^", "D", "v", "P", "X")

STYLE: dict[str, Any] = {
    "figure.dpi": 150,
    "savefig.dpi": 150,
    "figure.constrained_layout.use": True,
    "figure.facecolor": "white",
    "font.family": "sans-serif",
    # The first comes with Matplotlib, so the layout is the same everywhere; a reader's SVG may need the others.
    "font.sans-serif": ["DejaVu Sans", "Verdana", "Arial", "sans-serif"],
    "font.size": 8,
    "axes.titlesize": 8.5,
    "axes.labelsize": 8,
    "figure.titlesize": 9,
    "xtick.labelsize": 7.5,
    "ytick.labelsize": 7.5,
    "legend.fontsize": 7.5,
    "legend.frameon": False,
    "legend.handlelength": 1.8,
    "legend.borderaxespad": 0.3,
    "legend.columnspacing": 1.4,
    "axes.titlelocation": "left",
    "axes.edgecolor": INK,
    "axes.labelcolor": INK,
    "axes.linewidth": 0.7,
    "axes.spines.top": False,
    "axes.spines.right": False,
    "axes.prop_cycle": cycler(color=COLOURS),
    "axes.unicode_minus": True,
    "axes.formatter.useoffset": False,
    "xtick.color": INK,
    "ytick.color": INK,
    "xtick.direction": "out",
    "text.color": INK,
    "lines.linewidth": 1.4,
    "lines.markersize": 4,
    "errorbar.capsize": 2.0,
    "svg.fonttype": "none",
    "svg.hashsalt": "drawbar",
}
"""Matplotlib parameters; nothing of the user's own settings comes in."""

DISPLAY: dict[str, tuple[tuple[str, float], ...]] = {
    "N": (("N", 1.0), ("mN", 1e3)),
    "m": (("m", 1.0), ("mm", 1e3)),
    "m/s": (("m/s", 1.0), ("mm/s", 1e3)),
    "rad": (("°", 180.0 / np.pi),),
    "Pa": (("MPa", 1e-6), ("kPa", 1e-3), ("Pa", 1.0)),
    "N m": (("N m", 1.0), ("mN m", 1e3)),
    "W": (("W", 1.0), ("mW", 1e3)),
    "J": (("J", 1.0), ("mJ", 1e3)),
    "kg": (("kg", 1.0), ("g", 1e3)),
    "m^2": (("m²", 1.0), ("mm²", 1e6)),
    "1": (("1", 1.0),),
}
"""By SI unit: what may be shown and by what factor, the coarsest first; the first that keeps numbers above 1."""


@contextlib.contextmanager
def style() -> Iterator[None]:
    """Matplotlib as this package draws; outside nothing has changed. Also a decorator."""
    with matplotlib.rc_context():
        matplotlib.rcdefaults()
        parameters: Any = STYLE
        matplotlib.rcParams.update(parameters)
        yield


class Shown:
    """Numbers in a friendlier unit than SI, and the label that says so."""

    def __init__(self, values: Any, unit: str, name: str) -> None:
        numbers = np.asarray(values, dtype=float)
        finite = np.abs(numbers[np.isfinite(numbers)])
        self.unit, self.factor = _display(unit, float(np.max(finite)) if finite.size else 0.0)
        self.values = numbers * self.factor
        self.name = name

    @property
    def label(self) -> str:
        """``drawbar force [mN]``: every axis says its unit."""
        return f"{self.name} [{self.unit}]"

    def __call__(self, values: Any) -> np.ndarray:
        """Other SI numbers in the same unit."""
        return np.asarray(values, dtype=float) * self.factor


def shown(array: Any, *, name: str | None = None, like: Any = None) -> Shown:
    """A DataArray's numbers and label in a friendly unit, from its ``units`` and its name.

    ``like`` are further numbers on the same axis, so that the unit suits them all.

    >>> import xarray as xr
    >>> force = shown(xr.DataArray([0.0883], name="drawbar_force", attrs={"units": "N"}))
    >>> force.label, float(force.values[0])
    ('drawbar force [mN]', 88.3)
    """
    own = str(array.name) if array.name is not None else "value"
    unit = array.attrs.get("units") or (VARIABLES[own].unit if own in VARIABLES else "1")
    label = name or own.replace("_", " ")
    found = Shown(np.concatenate([np.ravel(array), np.ravel(like)]) if like is not None else array, unit, label)
    found.values = np.asarray(array, dtype=float) * found.factor
    return found


def _display(unit: str, largest: float) -> tuple[str, float]:
    choices = DISPLAY.get(unit)
    if choices is None:
        return unit.replace("^2", "²"), 1.0
    return next((c for c in choices if largest * c[1] >= 1.0), choices[-1] if largest > 0.0 else choices[0])


def new_figure(width: float, height: float) -> Figure:
    """A Figure of its own: no window, no list of open figures, nothing to close.

    Raises
    ------
    ValueError
        The width is not between 3 and 12 inches, where the letters fit.
    """
    if not 3.0 <= width <= 12.0:
        raise ValueError(f"width must be between 3 and 12 in, got {width}. A column is 3.5 in wide, a page 7 in.")
    return Figure(figsize=(width, height))


def caption(figure: Figure, text: str) -> None:
    """A note under the figure, broken to its width."""
    width = int(figure.get_figwidth() * 17.0)  # letters of 7 points to the inch
    text = re.sub(r"(?<=\d) (?=%|(?!of|to)[A-Za-z]{1,2}\b)", "\N{NO-BREAK SPACE}", text)  # a number keeps its unit
    figure.supxlabel("\n".join(textwrap.wrap(text, width)), fontsize=7, color="#444444", x=0.01, ha="left")


def legend(figure: Figure, axes: Axes, title: str = "") -> None:
    """A legend above the axes, in as many columns as fit, where it covers nothing."""
    handles, labels = axes.get_legend_handles_labels()
    if not handles:
        return
    inches = 0.45 + 0.056 * max(map(len, labels))  # handle and letters of one entry
    columns = max(1, min(len(labels), int(figure.get_figwidth() / inches)))
    figure.legend(handles, labels, loc="outside upper left", ncols=columns, title=title or None, alignment="left")


def number(value: float, digits: int = 3) -> str:
    """A number as text with a true minus sign."""
    return f"{value:.{digits}g}".replace("-", "−")


def zero_line(axes: Axes) -> None:
    """Where a force changes its sign."""
    axes.axhline(0.0, color=GREY, linewidth=0.7, zorder=0.5)


def save(figure: Figure, stem: str | Path, *, force: bool = False) -> tuple[Path, Path]:
    """Write ``stem.png`` (150 dpi) and ``stem.svg``, whole; the same figure gives the same bytes.

    Raises
    ------
    FileExistsError
        One of them is there and ``force`` is not given.
    """
    png, svg = (Path(f"{stem}.{end}") for end in ("png", "svg"))
    refuse_existing(png, svg, force=force)
    with style():
        with whole(png, force=force) as temporary:
            figure.savefig(temporary, format="png", metadata={"Software": None})
        with whole(svg, force=force) as temporary:
            figure.savefig(temporary, format="svg", metadata={"Date": None, "Creator": None})
    return png, svg

"""The reproduction as one self-contained HTML page, with every figure and data set beside it."""

from __future__ import annotations

import base64
import importlib.metadata
import json
import platform
from collections.abc import Callable
from pathlib import Path
from typing import Any

import jinja2

from drawbar import __version__
from drawbar.files import write_whole
from drawbar.rig.write import write_netcdf
from drawbar.sources.rentschler_2004 import ASSUMED, CITATION, PRINTED
from drawbar.study.paper.reproduce import SENSORS, SPREAD, Reproduction
from drawbar.view import figure
from drawbar.view.panels import PANELS, Panel

__all__ = ["write_report"]

LIBRARIES = ("numpy", "scipy", "numba", "xarray", "lmfit", "matplotlib")


def write_report(result: Reproduction, folder: Path, progress: Callable[[str, int, int], None] | None = None) -> Path:
    """Write ``report.html``, ``outcomes.json``, figures (PNG, SVG) and data sets (netCDF) to a folder.

    Parameters
    ----------
    result
        What :func:`drawbar.reproduce` returned.
    folder
        An empty or new folder.
    progress
        Called with what is drawn, how many are done, and how many there are.

    Returns
    -------
    Path
        The report: one file that needs no network and no other file.
    """
    drawn = []
    for number, panel in enumerate(PANELS):
        if progress is not None:
            progress(f"drawing {panel.name}", number, len(PANELS))
        drawn.append(_draw(panel, result, folder / "figures"))
    for name, dataset in result.datasets.items():
        write_netcdf(dataset, folder / "data" / f"{name}.nc", force=True)
    outcomes = [v.as_dict() for v in result.verdicts]
    write_whole(folder / "outcomes.json", json.dumps(outcomes, indent=2, ensure_ascii=False) + "\n", force=True)
    if progress is not None:
        progress("writing the report", len(PANELS), len(PANELS))
    return write_whole(folder / "report.html", _page(result, drawn), force=True)


def _draw(panel: Panel, result: Reproduction, folder: Path) -> dict[str, str]:
    _, vector = figure.save(panel.draw(result), folder / panel.name, force=True)
    image = base64.b64encode(vector.read_bytes()).decode()
    return {"name": panel.name, "title": panel.title, "kind": panel.kind, "caption": panel.caption,
            "source": f"data:image/svg+xml;base64,{image}"}  # fmt: skip


def _page(result: Reproduction, drawn: list[dict[str, str]]) -> str:
    loader = jinja2.PackageLoader("drawbar.view", "templates")
    environment = jinja2.Environment(loader=loader, autoescape=True, undefined=jinja2.StrictUndefined,
                                     trim_blocks=True, lstrip_blocks=True)  # fmt: skip
    counts: dict[str, int] = {}
    for v in result.verdicts:
        counts[v.verdict] = counts.get(v.verdict, 0) + 1
    content: dict[str, Any] = {
        "citation": CITATION,
        "version": __version__,
        "software": _software(),
        "counts": counts,
        "verdicts": [v.as_dict() | {"tissue": v.outcome.tissue, "wheel": v.outcome.wheel} for v in result.verdicts],
        "models": list(dict.fromkeys(v.model for v in result.verdicts)),
        "figures": drawn,
        "printed": PRINTED,
        "assumed": ASSUMED,
        "sensors": repr(SENSORS),
        "spread": f"{SPREAD:.0%}",
        "fits": {name.replace("_", ", "): fit.report() for name, fit in result.fits.items()},
        "comparisons": {name.replace("_", " "): c.report() for name, c in result.comparisons.items()},
        "datasets": sorted(result.datasets),
    }
    return environment.get_template("report.html").render(content)


def _software() -> str:
    versions = [f"{name} {importlib.metadata.version(name)}" for name in LIBRARIES]
    return f"drawbar {__version__}, Python {platform.python_version()}, {', '.join(versions)}"

"""Runs written for others: CSV that any program reads, netCDF that keeps everything. Whole or not at all."""

from __future__ import annotations

import re
from collections.abc import Iterable, Mapping
from pathlib import Path
from typing import Any

import numpy as np
import xarray as xr

from drawbar.files import refuse_existing, whole, write_whole
from drawbar.variables import LABELS, VARIABLES, tidy

__all__ = ["write_csv", "write_netcdf"]


def write_csv(dataset: xr.Dataset, path: str | Path, *, force: bool = False, comments: Iterable[str] = ()) -> Path:
    """Write rows that :func:`drawbar.load` reads back: every number bit for bit, in SI.

    Parameters
    ----------
    dataset
        Any Dataset of the package; a map is written as rows (:func:`drawbar.variables.tidy`).
    comments
        Further lines for the top, where the attributes stand as ``# key: value``.

    NaN is an empty cell. Labels are quoted; one that a spreadsheet would take for a formula gets a
    leading apostrophe, which :func:`drawbar.load` takes away.

    Raises
    ------
    FileExistsError
        The file exists and ``force`` is not given.
    ValueError
        A variable is neither a number with a unit nor a label.
    """
    path = Path(path)
    refuse_existing(path, force=force)
    rows = tidy(dataset)
    names = sorted(map(str, rows.variables), key=lambda name: name in LABELS)  # numbers first
    header = ",".join(_header(name, rows[name]) for name in names)
    columns = [_cells(rows[name].values) for name in names]
    lines = [*(f"# {_one_line(key)}: {_one_line(v)}" for key, v in dataset.attrs.items() if _one_line(v)),
             *(f"# {_one_line(comment)}" for comment in comments),
             header, *map(",".join, zip(*columns, strict=True))]  # fmt: skip
    return write_whole(path, "\n".join(lines) + "\n", force=force)


def write_netcdf(dataset: xr.Dataset, path: str | Path, *, force: bool = False) -> Path:
    """Write a Dataset as netCDF 4, dimensions kept. Attributes that netCDF has no type for become text.

    Raises
    ------
    FileExistsError
        The file exists and ``force`` is not given.
    """
    path = Path(path)
    plain = dataset.drop_encoding().assign_attrs(_storable(dataset.attrs))
    for variable in plain.variables.values():
        variable.attrs = _storable(variable.attrs)
    with whole(path, force=force) as temporary:
        plain.to_netcdf(temporary, engine="h5netcdf")
    return path


def _header(name: str, column: xr.DataArray) -> str:
    if name in LABELS:
        return name
    unit = column.attrs.get("units") or (VARIABLES[name].unit if name in VARIABLES else "")
    if not unit or column.dtype.kind not in "fiu":
        raise ValueError(f"'{name}' cannot be written: it is neither a number with units nor a label. Drop it.")
    return f"{name} [{unit}]"


def _cells(values: np.ndarray) -> list[str]:
    """Shortest text that reads back to the same number; names in quotation marks."""
    if values.dtype.kind in "iu":
        return [str(v) for v in values.tolist()]
    if values.dtype.kind == "f":
        return ["" if v != v else repr(v) for v in values.astype(float).tolist()]
    return [_quoted(_one_line(v)) for v in values.tolist()]


def _quoted(text: str) -> str:
    """A label as a CSV cell that stays text in a spreadsheet.

    >>> _quoted('5" =x'), _quoted("=1+1")
    ('"5"" =x"', '"\\'=1+1"')
    """
    guard = "'" if re.match(r"'*[=+\-@]", text) else ""
    return '"' + guard + text.replace('"', '""') + '"'


def _one_line(given: Any) -> str:
    return re.sub(r"[\x00-\x1f\x7f]+", " ", str(given)).strip()


def _storable(attrs: Mapping[Any, Any]) -> dict[str, Any]:
    """Attributes as text, numbers or arrays of numbers."""
    return {str(key): v if _is_storable(v) else str(v) for key, v in attrs.items()}


def _is_storable(given: Any) -> bool:
    if isinstance(given, np.ndarray):
        return given.ndim == 1 and given.dtype.kind in "fiu"
    return isinstance(given, (str, int, float, np.integer, np.floating)) and not isinstance(given, bool)

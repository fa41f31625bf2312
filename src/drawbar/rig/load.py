"""A laboratory's log as the same Dataset that the virtual rig gives."""

from __future__ import annotations

import dataclasses
import re
from collections.abc import Mapping
from pathlib import Path
from typing import Any

import numpy as np
import xarray as xr

from drawbar.quantity import check
from drawbar.rig.derive import derived
from drawbar.rig.table import Table, read_table
from drawbar.units import factor, si
from drawbar.variables import LABELS, OBSERVATION, VARIABLES, declare, nearest, tidy

__all__ = ["MAY_BE_EMPTY", "load"]

MAY_BE_EMPTY = ("speed_ratio", "slip", "tractive_efficiency")
"""What a locked wheel does not have: an empty cell in a log, NaN in a Dataset."""

_HEADER = re.compile(r"\s*([^\[\]]*?)\s*(?:\[([^\[\]]*)\])?\s*")
_EXAMPLES = {"N": "N", "N m": "mN m", "m": "mm", "m/s": "mm/s", "rad": "deg", "m^2": "mm^2", "kg": "g"}
_GUARDED = re.compile(r"'+[=+\-@]")
_INTEGER = re.compile(r"[-+]?\d{1,18}(\.0*)?")
_INTEGRAL = re.compile(r"-?\d{1,18}")
_DECIMAL = re.compile(r"-?\d{1,17}(\.\d{1,20})?(e[-+]\d{2,3})?")


@dataclasses.dataclass(frozen=True)
class _Reading:
    """How a column of a file is read: under which name, and times what. A label has no factor."""

    column: str
    name: str
    factor: float | None


def load(
    path: str | Path,
    map: Mapping[str, str] | None = None,
    set: Mapping[str, Any] | None = None,
    where: Mapping[str, Any] | None = None,
) -> xr.Dataset:
    """Read a log: CSV with ``name [unit]`` in each header cell, or a netCDF file of the package.

    Parameters
    ----------
    path
        The file. Encoding, separator, decimal commas and ``#`` comments are found out.
    map
        Reads a foreign column under our name and unit: ``{'Fx': 'drawbar_force [N]'}``; a leading minus
        turns its sign: ``{'-Fz': 'normal_load [N]'}``. Columns that are neither named here nor ours are
        then set aside and listed in ``attrs['set_aside']``; without a map they are refused.
    set
        Constant columns: ``{'wheel_radius': '58 mm', 'wheel': 'smooth'}``. A bare number is in SI.
    where
        Keeps the rows whose cell, as it stands in the file, equals the value: ``{'beta': '0'}``.
        ``attrs['left_out']`` says how many were left out.

    Returns
    -------
    xarray.Dataset
        Tidy, along ``observation``, SI; labels (``wheel``, ``tissue``, ``film``, ``trial``) are coordinates;
        what follows from the columns is added (:func:`drawbar.rig.derive.derived`). Comments of the form
        ``# key: value`` are attributes; ``origin`` is 'log' unless such a comment says otherwise.

    Raises
    ------
    FileNotFoundError
        There is no such file.
    ValueError
        Anything else that is wrong, with file, line and column.
    """
    path = Path(path)
    if path.suffix == ".nc" and path.is_file():
        if map or set or where:
            raise ValueError(f"{path}: map, set and where are for text tables; a netCDF file is read as it is.")
        return _netcdf(path)
    table = read_table(path)
    whole = len(table.lines)
    for column, wanted in (where or {}).items():
        table = table.only(column, str(wanted))
    readings, set_aside = _readings(table, map or {})
    columns = _columns(table, readings)
    for name, given in (set or {}).items():
        if name in columns:
            raise ValueError(f"{path} has {name} already; set gives what a file lacks. Take {name} out of set.")
        columns[name] = np.full(len(table.lines), _constant(name, given))
    measured, columns = columns.keys(), derived(columns)
    if not {"wheel_speed", "rim_speed"} & measured:
        _refuse_standing(table, columns)
    attrs: dict[str, Any] = {"origin": "log", **{k: _plain(v) for k, v in table.comments.items()}, "file": path.name}
    if set_aside:
        attrs["set_aside"] = ", ".join(set_aside)
    if where:
        why = " or ".join(f"{column} is not {wanted}" for column, wanted in where.items())
        attrs["left_out"] = f"{whole - len(table.lines)} of {whole} rows: {why}"
    labels = [name for name in columns if name in LABELS]
    return declare({n: (OBSERVATION, c) for n, c in columns.items()}, coords=labels, attrs=attrs)


def _readings(table: Table, given: Mapping[str, str]) -> tuple[list[_Reading], list[str]]:
    """How each column is read, and the columns that nobody reads."""
    readings = [_mapped(table, source, target) for source, target in given.items()]
    free = [column for column in table.columns if column not in {r.column for r in readings}]
    set_aside = [column for column in free if given and not _is_ours(column)]
    readings += [_reading(c, c, f"{table.path}, column '{c}'") for c in free if c not in set_aside]
    first: dict[str, str] = {}
    for reading in readings:
        if reading.name in first:
            raise ValueError(
                f"{table.path}: columns '{first[reading.name]}' and '{reading.column}' both give {reading.name}. "
                "Take one out, or read it under another name with a map."
            )
        first[reading.name] = reading.column
    return readings, set_aside


def _mapped(table: Table, source: str, target: str) -> _Reading:
    turned = source.startswith("-") and source not in table.columns
    column = (source[1:] if turned else source).strip()
    table.require(column)
    place = f"map {source}={target}"
    reading = _reading(column, target, place)
    if not turned:
        return reading
    if reading.factor is None:
        raise ValueError(f"{place}: {reading.name} is a label and has no sign. Take the minus away.")
    return dataclasses.replace(reading, factor=-reading.factor)


def _is_ours(column: str) -> bool:
    """Whether a header cell is in our form: a number's name with a unit, a label's without."""
    match = _HEADER.fullmatch(column)
    return match is not None and match[1] in (LABELS if match[2] is None else VARIABLES)


def _reading(column: str, meant: str, place: str) -> _Reading:
    """A column read as what ``name [unit]`` means."""
    match = _HEADER.fullmatch(meant)
    name, unit = match.groups() if match else (meant, None)
    if name in LABELS:
        if unit is not None:
            raise ValueError(f"{place}: {name} is a label and has no unit. Write '{name}'.")
        return _Reading(column, name, None)
    if name not in VARIABLES:
        raise ValueError(f"{place}: {_unknown(meant, foreign=meant == column)}")
    wanted = VARIABLES[name].unit
    if unit is None or not (unit.strip() or wanted == "1"):
        example = _EXAMPLES.get(wanted, wanted)
        raise ValueError(f"{place}: {name} has no unit. Write it in brackets, for example '{name} [{example}]'.")
    try:
        return _Reading(column, name, factor(unit.strip(), wanted))
    except ValueError as error:
        raise ValueError(f"{place}: {error}") from None


def _unknown(name: str, *, foreign: bool = False) -> str:
    """What to do about a name that the glossary does not hold; a foreign column can be mapped."""
    if "diameter" in name.lower():
        return "wheels are given by radius, half the diameter. Write 'wheel_radius [mm]' and halve the numbers."
    bare, _, unit = name.replace("(", "[").replace(")", "]").partition("[")
    hint = nearest(re.sub(r"\W+", "_", bare.strip().lower()), [*VARIABLES, *LABELS])
    if hint and "(" in name:
        hint += f" Units stand in square brackets: [{unit.strip(' ]')}]."
    if foreign:
        remedy = f'Rename or remove the column, or say what it is: --map "{name}=drawbar_force [N]".'
        return f"this is not a name of the glossary.{hint} {remedy}"
    return f"'{name}' is not a name of the glossary.{hint} Give one of its names."


def _columns(table: Table, readings: list[_Reading]) -> dict[str, Any]:
    """The columns that are read, by name: SI floats within their bounds, labels as they are."""
    numbers = [r for r in readings if r.factor is not None]
    optional = [r.column for r in numbers if r.name in MAY_BE_EMPTY]
    floats = table.numbers([r.column for r in numbers], may_be_empty=optional)
    columns: dict[str, Any] = {}
    for reading in readings:
        if reading.factor is None:
            columns[reading.name] = _labels(reading.name, table.texts(reading.column))
        else:
            columns[reading.name] = floats[reading.column] * reading.factor
            _refuse_outside(table, reading, columns[reading.name])
    return columns


def _labels(name: str, cells: list[str]) -> np.ndarray:
    """Names as text, without the apostrophe that guards a spreadsheet from =, +, - and @; trials as integers."""
    if name == "trial" and all(_INTEGER.fullmatch(cell) for cell in cells):
        return np.array([int(cell.partition(".")[0]) for cell in cells])
    return np.array([cell[1:] if _GUARDED.match(cell) else cell for cell in cells])


def _refuse_outside(table: Table, reading: _Reading, values: np.ndarray) -> None:
    """Raise ValueError at the first value out of its quantity's bounds."""
    declared = VARIABLES[reading.name]
    outside = (values < declared.minimum) | (values <= declared.above) | (values > declared.maximum)
    if not outside.any():
        return
    row = int(np.argmax(outside))
    place = table.place(row, reading.column)
    try:
        check(reading.name, values[row], declared)
    except ValueError as error:
        raise ValueError(f"{place}: {error}{_remedy(reading, values[row])}") from None


def _remedy(reading: _Reading, number: float) -> str:
    declared = VARIABLES[reading.name]
    if number > declared.maximum:
        return f" Is it in mm? Then write '{reading.name} [mm]'."
    if number < declared.minimum and reading.factor is not None and reading.factor < 0:
        return " The map turns its sign: take the minus away if the column counts as drawbar does."
    if number < declared.minimum:
        return f' If the column counts the other way: --map "-{reading.column}={reading.name} [{declared.unit}]".'
    return " Correct the cell, or take the row out."


def _constant(name: str, given: Any) -> Any:
    """The value of a constant column: a number in SI, or a label."""
    if name in LABELS:
        return _labels(name, [str(given).strip()])[0]
    place = f"set {name}={given}"
    if name not in VARIABLES:
        raise ValueError(f"{place}: {_unknown(name)}")
    declared = VARIABLES[name]
    try:
        return check(name, si(given, declared.unit), declared)
    except ValueError as error:
        bare = re.fullmatch(r"[\d.,\s]+", str(given)) is not None
        asked = f" Is it in mm? Then write '{given} mm'." if bare and declared.maximum < np.inf else ""
        raise ValueError(f"{place}: {error}{asked}") from None


def _refuse_standing(table: Table, columns: Mapping[str, Any]) -> None:
    """A speed ratio of zero, a wheel that spins on the spot, does not tell how fast it spins."""
    standing = np.flatnonzero(columns.get("speed_ratio", np.ones(0)) == 0.0)
    if standing.size:
        raise ValueError(
            f"{table.path}, line {table.lines[standing[0]]}: speed_ratio 0 is a wheel that spins on the "
            "spot, at an unknown speed. Add a column 'wheel_speed [rad/s]'; for a locked wheel leave speed_ratio empty."
        )


def _plain(text: str) -> Any:
    """A comment's value: the number that is written exactly so, or the text.

    >>> _plain("0.001"), _plain("7"), _plain("007")
    (0.001, 7, '007')
    """
    for kind, written in ((int, _INTEGRAL), (float, _DECIMAL)):
        if written.fullmatch(text) and repr(kind(text)) == text:
            return kind(text)
    return text


def _netcdf(path: Path) -> xr.Dataset:
    """A Dataset that the package wrote, as rows."""
    try:
        dataset = xr.load_dataset(path, engine="h5netcdf")
    except (OSError, ValueError, KeyError) as error:
        raise ValueError(f"{path} is not a netCDF file that can be read: {str(error).splitlines()[0]}.") from None
    known = [n for n in map(str, dataset.variables) if n in VARIABLES]
    if not known:
        raise ValueError(f"{path} holds no variable of drawbar's glossary. Give a file that drawbar wrote, or a CSV.")
    for name in known:
        unit, wanted = dataset[name].attrs.get("units"), VARIABLES[name].unit
        if unit != wanted:
            raise ValueError(f"{path}, variable '{name}': its unit is '{unit}', not '{wanted}'. Convert it.")
    rows = tidy(dataset)
    for name in LABELS.keys() & {*rows.coords}:
        if rows[name].dtype.kind not in "iu":
            rows[name] = rows[name].astype(str)
    return rows.assign_attrs({"origin": "log", **rows.attrs, "file": path.name}).drop_encoding()

"""A text file as a table: header cells, and under each its cells as text, with the lines they stand on.

What laboratories write is coped with here (encodings, separators, decimal commas, comments); what the
columns mean is none of this file's business.
"""

from __future__ import annotations

import codecs
import csv
import dataclasses
import re
from collections.abc import Iterable, Sequence
from pathlib import Path

import numpy as np

from drawbar.variables import nearest

__all__ = ["Table", "read_table"]

_MAGIC = {
    b"PK\x03\x04": "a zip archive, such as an Excel workbook. Save the sheet as CSV",
    b"\xd0\xcf\x11\xe0": "an old Excel workbook. Save the sheet as CSV",
    b"%PDF": "a PDF. Give the table as CSV",
    b"\x89HDF": "an HDF5 or netCDF file. If drawbar wrote it, let its name end in .nc",
    b"CDF": "a classic netCDF file. Give the table as CSV",
    b"\x1f\x8b": "a gzip archive. Unpack it",
}
_MARKS = (  # the longer first: the mark of UTF-32 begins with that of UTF-16
    (codecs.BOM_UTF32_LE, "utf-32"), (codecs.BOM_UTF32_BE, "utf-32"), (codecs.BOM_UTF8, "utf-8-sig"),
    (codecs.BOM_UTF16_LE, "utf-16"), (codecs.BOM_UTF16_BE, "utf-16"),
)  # fmt: skip
_QUOTED_OR_BRACKETED = re.compile(r'"[^"]*"|\[[^\]]*\]|\([^)]*\)')
_BLANK_SEPARATED = re.compile(r'(?:"[^"]*"|[^\s\["]+)(?:\s*\[[^\]]*\])?')
_KEY = re.compile(r"#+\s*([A-Za-z][\w -]*?)\s*:\s+(.*\S)")
_NUMBER = re.compile(r"\s*[-+]?(\d+\.?\d*|\.\d+)([eE][-+]?\d+)?\s*")


@dataclasses.dataclass(frozen=True)
class Table:
    """Columns of text by header cell, the line of each row, and what the comments say."""

    path: Path
    columns: dict[str, Sequence[str]]
    lines: Sequence[int]
    separator: str = ","
    comments: dict[str, str] = dataclasses.field(default_factory=dict)

    def place(self, row: int, column: str) -> str:
        """Where a cell stands, in words."""
        return f"{self.path}, line {self.lines[row]}, column '{column}'"

    def require(self, column: str) -> None:
        """Raise ValueError with the nearest column if there is none of that name."""
        if column not in self.columns:
            raise ValueError(
                f"{self.path} has no column '{column}'.{nearest(column, self.columns)} "
                f"It has: {', '.join(self.columns)}."
            )

    def texts(self, column: str) -> list[str]:
        """The cells of a column of names.

        Raises
        ------
        ValueError
            A cell is empty.
        """
        cells = [cell.strip() for cell in self.columns[column]]
        if "" in cells:
            raise ValueError(f"{self.place(cells.index(''), column)}: the cell is empty. Give each row a name there.")
        return cells

    def numbers(self, columns: Iterable[str], *, may_be_empty: Iterable[str] = ()) -> dict[str, np.ndarray]:
        """Columns as floats, finite but for empty cells (or ``nan``) of ``may_be_empty``, which give NaN.

        Raises
        ------
        ValueError
            A cell is not a finite number, or decimal commas and points are mixed.
        """
        wanted = list(columns)
        comma = self._decimal_comma(wanted)
        return {column: self._floats(column, comma, column in set(may_be_empty)) for column in wanted}

    def only(self, column: str, wanted: str) -> Table:
        """The rows whose cell in ``column`` is ``wanted``: the same number, or else the same text.

        Raises
        ------
        ValueError
            There is no such column, or no such row; the sentence lists what the column has.
        """
        self.require(column)
        comma = self.separator != ","
        value = _number(wanted, comma)
        cells = self.columns[column]
        same = {
            c for c in set(cells) if c.strip() == wanted.strip() or (value is not None and value == _number(c, comma))
        }
        kept = [row for row, cell in enumerate(cells) if cell in same]
        if not kept:
            there = list(dict.fromkeys(cell.strip() for cell in cells))
            more = f" and {len(there) - 12} more" if len(there) > 12 else ""
            raise ValueError(
                f"{self.path}: no row has '{wanted}' in column '{column}'. It has: {', '.join(there[:12])}{more}."
            )
        columns = {name: [whole[row] for row in kept] for name, whole in self.columns.items()}
        return dataclasses.replace(self, columns=columns, lines=[self.lines[row] for row in kept])

    def _decimal_comma(self, columns: list[str]) -> bool:
        """Whether numbers have decimal commas. Both kinds in one file may be thousands: that is refused."""
        if self.separator == ",":
            return False
        with_comma = [c for c in columns if "," in "".join(self.columns[c])]
        with_point = [c for c in columns if "." in "".join(self.columns[c])] if with_comma else []
        if with_point:
            row, cell = _first(self.columns[with_comma[0]], ",")
            _, other = _first(self.columns[with_point[0]], ".")
            raise ValueError(
                f"{self.place(row, with_comma[0])}: '{cell}' has a comma, but '{other}' in column "
                f"'{with_point[0]}' has a decimal point. Use one decimal sign, and none for thousands."
            )
        return bool(with_comma)

    def _floats(self, column: str, comma: bool, may_be_empty: bool) -> np.ndarray:
        cells = self.columns[column]
        texts: Iterable[str] = cells
        if comma:
            texts = [cell.replace(",", ".") for cell in texts]
        if may_be_empty:
            texts = [cell if cell.strip() else "nan" for cell in texts]
        try:
            values = np.fromiter(map(float, texts), float, len(cells))
        except ValueError:
            raise self._bad_cell(column, comma, may_be_empty) from None
        allowed = ~np.isinf(values) if may_be_empty else np.isfinite(values)
        if not allowed.all() or "_" in "".join(cells):  # Python's float takes 1_000
            raise self._bad_cell(column, comma, may_be_empty)
        return values

    def _bad_cell(self, column: str, comma: bool, may_be_empty: bool) -> ValueError:
        """What is wrong with the first cell of a column that is not a finite number."""
        accepted = {"", "nan"} if may_be_empty else set()
        cells = enumerate(self.columns[column])
        row, cell = next((r, c) for r, c in cells if _number(c, comma) is None and c.strip().lower() not in accepted)
        what = f"'{cell.strip()}' is not a finite number" if cell.strip() else "the cell is empty"
        remedy = "Leave it empty for a locked wheel." if may_be_empty else "Correct the cell, or take the row out."
        if "," in cell:
            remedy = "A decimal comma needs another separator than the comma; thousands have none."
        return ValueError(f"{self.place(row, column)}: {what}. {remedy}")


def read_table(path: Path) -> Table:
    """Read a text table with one header line.

    UTF-8, UTF-16 (with its mark) or Latin-1; separated by tabs, semicolons, bars, commas or blanks, found from
    the header; lines that begin with ``#`` are comments, of which ``# key: value`` is kept by its key and
    the rest under ``comment``. Blank lines and separators at the end of lines are ignored.

    Raises
    ------
    FileNotFoundError
        There is no such file.
    ValueError
        It is a folder, empty, not a text table, without data, ragged, or names a column twice.
    """
    text = _decoded(path, _content(path))
    numbered = list(enumerate(text.replace("\r\n", "\n").replace("\r", "\n").split("\n"), 1))
    remarks = [line.strip() for _, line in numbered if line.lstrip().startswith("#")]
    rows = [(number, line) for number, line in numbered if line.strip() and not line.lstrip().startswith("#")]
    separator = ""
    if rows and (declared := re.fullmatch(r"sep=(.)\s*", rows[0][1])):  # Excel's own first line
        separator = declared[1]
        rows = rows[1:]
    if len(rows) < 2:
        what = "has a header but no rows of data" if rows else "is empty"
        raise ValueError(f"{path} {what}. Give a CSV file with a header line and a row for each observation.")
    lines, body = zip(*rows, strict=True)
    separator = separator or _separator(body[0], body[1])
    cells = _split(path, lines, body, separator)
    if separator == " ":
        cells[0] = [cell.replace('"', "") for cell in _BLANK_SEPARATED.findall(body[0])]
    header = _header(path, lines[0], cells[0])
    full, where = _rectangle(path, header, cells[1:], lines[1:])
    if not full:
        raise ValueError(f"{path} has a header but no rows of data. Give a row for each observation.")
    return Table(path, dict(zip(header, zip(*full, strict=True), strict=True)), where, separator, _comments(remarks))


def _content(path: Path) -> bytes:
    if path.is_dir():
        raise ValueError(f"{path} is a folder. Give the path of a CSV or netCDF file.")
    try:
        content = path.read_bytes()
    except FileNotFoundError:
        siblings = [p.name for p in path.parent.iterdir()] if path.parent.is_dir() else []
        hint = nearest(path.name, siblings)
        raise FileNotFoundError(f"{path} does not exist.{hint} Give the path of a CSV or netCDF file.") from None
    except OSError as error:
        raise ValueError(f"{path} cannot be read: {error.strerror}. Check the file and its permissions.") from None
    for magic, what in _MAGIC.items():
        if content.startswith(magic):
            raise ValueError(f"{path} is not a CSV file: it is {what}.")
    return content


def _decoded(path: Path, content: bytes) -> str:
    encoding = next((name for mark, name in _MARKS if content.startswith(mark)), "")
    try:
        text = content.decode(encoding or "utf-8")
    except UnicodeDecodeError:
        if encoding:
            raise ValueError(
                f"{path} is not a CSV file: its first bytes promise {encoding}, its content is not."
            ) from None
        text = content.decode("latin-1")
    text = text.rstrip("\x1a")  # the end of an old DOS file
    if re.search(r"[\x00-\x08\x0e-\x1a]", text):
        raise ValueError(f"{path} is not a CSV file: it holds binary data. Give a text table, best in UTF-8.")
    if text.lstrip()[:1] in {"{", "<"}:
        raise ValueError(f"{path} is not a CSV file: it looks like JSON, HTML or XML. Give the table as CSV.")
    return text


def _separator(header: str, first: str) -> str:
    """The separator of a header line. Commas come late: they may be decimal; blanks last: units have some."""
    bare = _QUOTED_OR_BRACKETED.sub("", header.strip())
    for separator in "\t;|,":
        if separator in bare:
            return separator
    by_blanks = len(_BLANK_SEPARATED.findall(header)) > 1 and len(first.split()) > 1
    return " " if by_blanks else ";"  # a single column: nothing to separate


def _split(path: Path, lines: Sequence[int], body: Sequence[str], separator: str) -> list[list[str]]:
    """Each line as its cells. A quoted cell ends on its line."""
    if separator == " ":
        body = [line.replace("\t", " ").strip() for line in body]

    def parsed(part: Sequence[str], strict: bool = False) -> list[list[str]]:
        try:
            return list(csv.reader(part, delimiter=separator, skipinitialspace=True, strict=strict))
        except csv.Error:
            return []

    cells = parsed(body)
    if len(cells) != len(body):
        line = next((n for n, text in zip(lines, body, strict=True) if not parsed([text], strict=True)), lines[0])
        raise ValueError(
            f"{path}, line {line}: a quotation mark opens a cell and does not close it. Remove or pair it."
        )
    return cells


def _header(path: Path, line: int, cells: list[str]) -> list[str]:
    header = [cell.strip() for cell in cells]
    while header and not header[-1]:
        header.pop()
    if header and all(_NUMBER.fullmatch(cell.replace(",", ".")) for cell in header):
        raise ValueError(
            f"{path}, line {line}: the first line holds only numbers. Begin with a header line, for example "
            "'normal_load [N],drawbar_force [N]'; if there is one behind a #, remove the #."
        )
    named = [cell or f"(unnamed {i})" for i, cell in enumerate(header, 1)]
    if len({*named}) < len(named):
        twice = next(cell for cell in named if named.count(cell) > 1)
        raise ValueError(f"{path}, line {line}: column '{twice}' is there twice. Rename or remove one of them.")
    return named


def _rectangle(
    path: Path, header: list[str], rows: list[list[str]], lines: Sequence[int]
) -> tuple[list[list[str]], list[int]]:
    """Rows of the header's length, without separators at the end and lines of separators alone."""
    width = len(header)
    full, where = [], []
    for row, line in zip(rows, lines, strict=True):
        if len(row) != width and not any(cell.strip() for cell in row[width:]):
            row = row[:width]
        if width > 1 and not any(row):
            continue
        if len(row) != width:
            raise ValueError(
                f"{path}, line {line}: the header has {width} columns, this row {len(row)}. Give every row a cell for "
                "each; a text that holds the separator needs quotation marks, a decimal comma another separator."
            )
        full.append(row)
        where.append(line)
    return full, where


def _comments(remarks: Iterable[str]) -> dict[str, str]:
    """``# key: value`` by its key, other comments under ``comment``."""
    found: dict[str, str] = {}
    for remark in remarks:
        match = _KEY.fullmatch(remark)
        key, text = (re.sub(r"\W+", "_", match[1]), match[2]) if match else ("comment", remark.lstrip("# ").strip())
        if text:
            found[key] = f"{found[key]}; {text}" if key in found else text
    return found


def _number(cell: str, comma: bool) -> float | None:
    """A cell as a finite number, or None."""
    text = cell.replace(",", ".") if comma else cell
    try:
        value = float(text)
    except ValueError:
        return None
    return value if np.isfinite(value) and "_" not in text else None


def _first(cells: Sequence[str], sign: str) -> tuple[int, str]:
    return next((row, cell.strip()) for row, cell in enumerate(cells) if sign in cell)

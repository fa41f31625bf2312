"""What the command line shows: tables, progress, sentences."""

from __future__ import annotations

import contextlib
import dataclasses
import re
from collections.abc import Callable, Iterator
from typing import TYPE_CHECKING, Any

import numpy as np
from rich.console import Console
from rich.table import Table

if TYPE_CHECKING:
    import xarray as xr

    from drawbar.study.paper.outcomes import Verdict

__all__ = ["dataset", "laws", "ledger", "outcomes", "progress", "say", "waiting"]

WIDE = 160
ROWS = 40  # a longer table is cut, and says so

# How a unit is shown: readable sizes of the robot's world. (SI unit: shown unit, factor)
SHOWN = {"m": ("mm", 1e3), "m/s": ("mm/s", 1e3), "N": ("mN", 1e3), "N m": ("mN m", 1e3), "rad": ("deg", 180 / np.pi),
         "W": ("mW", 1e3), "Pa": ("kPa", 1e-3), "kg": ("g", 1e3), "m^2": ("mm^2", 1e6), "J": ("mJ", 1e3)}  # fmt: skip


def _console() -> Console:
    """The terminal as wide as it is; a file or pipe as wide as a table may need."""
    console = Console(highlight=False)
    return console if console.is_terminal else Console(highlight=False, width=WIDE)


def say(text: str) -> None:
    """Print a plain line."""
    _console().print(text, markup=False, soft_wrap=True)


@contextlib.contextmanager
def progress() -> Iterator[Callable[[str, int, int], None]]:
    """A progress bar; yields a function of (what, number done, number in all)."""
    from rich.progress import BarColumn, Progress, TextColumn, TimeElapsedColumn

    columns = (
        TextColumn("{task.description:44}"),
        BarColumn(),
        TextColumn("{task.completed}/{task.total}"),
        TimeElapsedColumn(),
    )
    with Progress(*columns, console=Console(stderr=True)) as bar:
        task = bar.add_task("starting", total=None)

        def step(what: str, done: int, total: int) -> None:
            bar.update(task, description=what, completed=done, total=total)

        yield step


@contextlib.contextmanager
def waiting(what: str) -> Iterator[None]:
    """A spinner while something runs whose length is not known."""
    with Console(stderr=True).status(what):
        yield


def dataset(rows: xr.Dataset, title: str) -> None:
    """A Dataset's rows, varying columns as a table and constant ones as a line."""
    from drawbar.variables import OBSERVATION, tidy

    rows = tidy(rows)
    count = rows.sizes[OBSERVATION]
    varying, constant = [], []
    for name in rows.variables:
        column = rows[str(name)]
        plain = column.values[:1]
        same = bool(np.all((column.values == plain) | (column.values != column.values)))
        (constant if same and count > 1 and name not in _ALWAYS else varying).append(str(name))
    table = Table(title=f"{title}: {count} rows", title_justify="left", caption_justify="left")
    for name in varying:
        table.add_column(_heading(rows[name]), justify="right")
    for i in range(min(count, ROWS)):
        table.add_row(*(_cell(rows[name], i) for name in varying))
    if count > ROWS:
        table.caption = f"the first {ROWS} of {count} rows"
    _console().print(table)
    if constant:
        say("throughout: " + ", ".join(f"{name} {_cell(rows[name], 0, unit=True)}" for name in constant))
    for key in ("set_aside", "left_out", "damping", "notes"):
        if rows.attrs.get(key):
            say(f"{key.replace('_', ' ')}: {rows.attrs[key]}")


_ALWAYS = {"drawbar_force"}

LEDGER = ("motor_work", "load_work", "drawbar_work", "film_heat", "tissue_heat", "damper_heat", "elastic_energy",
          "kinetic_energy", "ledger_error")  # fmt: skip


def _heading(column: xr.DataArray) -> str:
    unit = column.attrs.get("units", "")
    name = str(column.name).replace("_", " ")
    return f"{name}\n[{SHOWN.get(unit, (unit,))[0]}]".replace("[", "\\[") if unit not in ("", "1") else name


def _cell(column: xr.DataArray, i: int, *, unit: bool = False) -> str:
    number = column.values[i]
    if column.dtype.kind not in "fiu":
        return str(number)
    if np.isnan(number):
        return "-"
    shown, factor = SHOWN.get(column.attrs.get("units", ""), (column.attrs.get("units", ""), 1.0))
    text = f"{number * factor:.5g}"
    return f"{text} {shown}".strip() if unit and shown != "1" else text


def ledger(run: xr.Dataset) -> None:
    """Where a transient ended, and where its energy went."""
    last = run.isel(time=-1)
    names = ("sinkage", "travel", "slide_speed", "wheel_speed", "drawbar_force", "wheel_torque", "peak_pressure")
    table = Table(title=f"after {float(last.time):g} s ({run.attrs['damping']})", title_justify="left")
    for name in names:
        table.add_column(_heading(run[name]), justify="right")
    table.add_row(*(_cell(last[name].expand_dims("time"), 0) for name in names))
    _console().print(table)
    bars = [n for n in names if f"{n}_error" in run]
    if bars:
        told = (f"{n.replace('_', ' ')} ± {_cell(last[f'{n}_error'].expand_dims('time'), 0, unit=True)}" for n in bars)
        say(f"numerical error, from half the step and column spacing: {', '.join(told)}")
    energies = Table(title="energy since the start", title_justify="left")
    energies.add_column("what")
    energies.add_column("mJ", justify="right")
    for name in (n for n in LEDGER if n in run):
        change = last[name] - (run[name][0] if name.endswith("_energy") else 0.0)
        energies.add_row(name.replace("_", " "), f"{float(change) * 1e3:.4g}")
    _console().print(energies)


def outcomes(verdicts: tuple[Verdict, ...]) -> None:
    """The paper's printed outcomes with what each model gives, and why."""
    models = list(dict.fromkeys(v.model for v in verdicts))
    title = (
        f"The paper's printed outcomes, by the model: {models[0]}"
        if len(models) == 1
        else "The paper's printed outcomes"
    )
    table = Table(title=title, title_justify="left", show_lines=True, expand=True)
    table.add_column("", no_wrap=True)
    table.add_column("printed", ratio=3)
    table.add_column("verdict", ratio=2)
    table.add_column("why, by which criterion, and over the wheel's width", ratio=7)
    colours = {"reproduced": "green", "not reproduced": "red"}
    for v in verdicts:
        printed = f"{v.outcome.tissue}, {v.outcome.wheel}: {v.outcome.statement}"
        verdict = f"[{colours.get(v.verdict, 'yellow')}]{v.verdict}[/]" + (f"\n({v.model})" if len(models) > 1 else "")
        why = [v.reason, f"criterion: {v.criterion}", v.widths]
        table.add_row(v.outcome.name, printed, verdict, "\n".join(filter(None, why)))
    _console().print(table)


def laws() -> None:
    """Every law with its quantities, and every preset with what it stands on."""
    from drawbar import catalogue
    from drawbar.quantity import quantities
    from drawbar.rig.sensors import Sensors

    kinds: list[tuple[str, dict[str, Any]]] = [(kind, catalogue.laws(kind)) for kind in catalogue.KINDS]
    kinds.append(("sensors (--noise)", {"Sensors": Sensors}))
    for kind, known in kinds:
        for name, law in known.items():
            summary = (law.__doc__ or "").strip().splitlines()[0]
            table = Table(title=f"{kind}: {name}. {summary}", title_justify="left")
            for heading in ("quantity", "symbol", "unit", "allowed", "default", "meaning"):
                table.add_column(heading, no_wrap=heading != "meaning", overflow="fold")
            fields = {f.name: f for f in dataclasses.fields(law)}
            for quantity, declared in quantities(law).items():
                default = fields[quantity].default
                shown = (
                    "required" if default is dataclasses.MISSING else ("derived" if default is None else f"{default:g}")
                )
                source = f" ({declared.source})" if declared.source else ""
                table.add_row(
                    quantity, declared.symbol, declared.unit, declared.allowed, shown, declared.meaning + source
                )
            _console().print(table)
            say(_source_of(law))
            say("")
    table = Table(title="ready-made", title_justify="left")
    for heading in ("name", "kind", "value", "where it comes from"):
        table.add_column(heading)
    for kind in catalogue.KINDS:
        for preset in catalogue.presets(kind).values():
            table.add_row(preset.name, kind, repr(preset.law), preset.note)
    _console().print(table)


def _source_of(law: type) -> str:
    """The *Valid for* and *Source* paragraphs of a law's docstring."""
    plain = re.sub(r":\w+:`~?(?:drawbar\.)?([^`]+)`", r"\1", law.__doc__ or "")  # no markup on a terminal
    paragraphs = [" ".join(p.split()) for p in plain.split("\n\n")]
    return "\n".join(f"  {p}" for p in paragraphs if p.startswith(("Valid", "Source")))

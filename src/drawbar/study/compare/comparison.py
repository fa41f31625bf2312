"""Two data sets side by side, as a value that can say what it holds."""

from __future__ import annotations

import dataclasses
import math

import xarray as xr

from drawbar.study.compare.agreement import MARGIN, RELATIONS, Agreement, Coefficient
from drawbar.study.compare.condition import describe

__all__ = ["Comparison", "Signs"]


@dataclasses.dataclass(frozen=True)
class Signs:
    """In how many conditions the signs agree, of how many, with those that are statistically zero apart."""

    agree: int
    compared: int
    zero: int


@dataclasses.dataclass(frozen=True, eq=False)
class Comparison:
    """Two data sets side by side: condition by condition in ``table``, over all of them in ``over_all``.

    ``table`` has the dimension ``condition``: the settings, ``model`` and ``data`` (means), the half
    width of their 95 % intervals ``model_interval`` and ``data_interval`` (NaN without repeats),
    ``model_repeats``, ``data_repeats`` and ``difference`` (data - model).
    """

    quantity: str
    unit: str
    table: xr.Dataset
    over_all: Agreement
    signs: Signs
    unmatched: dict[str, int]
    notes: tuple[str, ...]

    @property
    def scale(self) -> Coefficient:
        """The factor s of data ≈ s model."""
        return self.over_all.scale

    @property
    def offset(self) -> Coefficient:
        """The offset b of data ≈ model + b."""
        return self.over_all.offset

    @property
    def explained_by(self) -> str:
        """``scale``, ``offset``, ``none`` (neither is needed) or ``cannot tell``."""
        return self.over_all.explained_by

    @property
    def nrmse(self) -> float:
        """Root mean square difference over the range of the measured values."""
        return self.over_all.nrmse["identical"]

    @property
    def verdict(self) -> str:
        """One or two sentences."""
        return _verdict(self)

    def report(self) -> str:
        """Plain aligned text: every condition, then what holds over all of them."""
        return _report(self)


def _percent(number: float) -> str:
    return f"{100 * number:.3g} %" if math.isfinite(number) else "not defined (the measured values are all equal)"


def _number(number: float, unit: str = "") -> str:
    return f"{number:.4g}{unit and ' ' + unit}" if math.isfinite(number) else "not determined"


def _interval(of: Coefficient, unit: str = "") -> str:
    low, high = of.interval
    return "" if math.isnan(low) else f" (95 % interval {low:.4g} to {_number(high, unit)})"


def _error(of: Coefficient, unit: str = "") -> str:
    return "" if math.isnan(of.standard_error) else f"; standard error {of.standard_error:.2g}{unit and ' ' + unit}"


def _sentence(text: str) -> str:
    return text[0].upper() + text[1:]


def _counted(count: int) -> str:
    return "1 condition" if count == 1 else f"{count} conditions"


def _unit(c: Comparison) -> str:
    return "" if c.unit == "1" else c.unit


def _by_factor(found: Agreement) -> str:
    """The factor in words, the way round that the source has it: model over data."""
    inverse = found.scale.inverse
    if math.isnan(inverse.value):
        return "no factor brings the model to the data"
    interval = "" if found.residuals["scaled"] == 0.0 else _interval(inverse)
    return f"the model is {inverse.value:.3g} times the data{interval}"


def _by_offset(found: Agreement, unit: str) -> str:
    side = "above" if found.offset.value > 0 else "below"
    interval = "" if found.residuals["shifted"] == 0.0 else _interval(found.offset, unit)
    return f"the data lie {_number(abs(found.offset.value), unit)} {side} the model{interval}"


def _verdict(c: Comparison) -> str:
    found, unit = c.over_all, _unit(c)
    if found.residuals["identical"] == 0.0:
        return f"Model and data are the same in {_counted(found.count)}."
    if found.explained_by == "none":
        return (
            f"Neither a factor nor an offset separates model and data: factor {_number(found.scale.value)}"
            f"{_interval(found.scale)}, offset {_number(found.offset.value, unit)}{_interval(found.offset, unit)}. "
            f"What differs is scatter: NRMSE {_percent(c.nrmse)}."
        )
    if found.explained_by == "cannot tell":
        why = f"AICc differs by {abs(found.advantage):.2g}, which is within noise (under {MARGIN:g})"
        if found.count < 3:
            why = f"{_counted(found.count)} cannot tell, three are needed"
        factor, offset = _by_factor(found), _by_offset(found, unit)
        best = "scaled" if found.advantage > 0 else "shifted"
        said = f"Whether a factor ({factor}) or an offset ({offset}) separates them is open: {why}."
        if math.isnan(c.nrmse):
            return said
        return f"{said} NRMSE is {_percent(c.nrmse)}, {best} {_percent(found.nrmse[best])}."
    if found.explained_by == "scale" and found.scale.holds(0.0):
        return (
            f"The data do not follow the model: the factor that fits best, {_number(found.scale.value)}"
            f"{_interval(found.scale)}, cannot be told from 0. NRMSE is {_percent(c.nrmse)}."
        )
    if found.explained_by == "scale":
        return _better(c, "factor", "offset", _by_factor(found), "scaled", "shifted")
    return _better(c, "offset", "factor", _by_offset(found, unit), "shifted", "scaled")


def _better(c: Comparison, this: str, that: str, what: str, better: str, worse: str) -> str:
    found = c.over_all
    article = "an" if this == "offset" else "a"
    other = "an" if that == "offset" else "a"
    said = f"{_sentence(what)}; {article} {this} explains the difference better than {other} {that}"
    if found.residuals[better] == 0.0:
        return f"{said}. The {this} leaves nothing."
    ratio = found.spread(worse) / found.spread(better)
    said = f"{said} (residual spread {ratio:.3g} times smaller, AICc lower by {abs(found.advantage):.3g})."
    return f"{said} With it NRMSE goes from {_percent(c.nrmse)} to {_percent(found.nrmse[better])}."


def _report(c: Comparison) -> str:
    found, unit = c.over_all, _unit(c)
    explained = {"scale": "a factor", "offset": "an offset", "none": "neither is needed"}
    facts = {
        "factor s": f"{_number(found.scale.value)}{_interval(found.scale)}{_error(found.scale)}; data = s model",
        "model over data": f"{_number(found.scale.inverse.value)}{_interval(found.scale.inverse)}",
        "offset b": f"{_number(found.offset.value, unit)}{_interval(found.offset, unit)}{_error(found.offset, unit)}; "
        "data = model + b",
        "both": f"factor {_number(found.scale_of_both.value)}, offset {_number(found.offset_of_both.value, unit)}",
        "explained by": explained.get(c.explained_by, c.explained_by),
        "sign": f"agrees in {c.signs.agree} of {_counted(c.signs.compared)}; {c.signs.zero} statistically zero, apart",
        "rank": f"Spearman {_number(found.spearman)}, Kendall {_number(found.kendall)}",
    }
    return "\n".join(
        [
            f"Comparison of {c.quantity}: {_counted(found.count)} matched; without a partner: "
            f"{c.unmatched['model']} of the model, {c.unmatched['data']} of the data.",
            "",
            *_conditions(c),
            "",
            *(f"{name:<17}{text}" for name, text in facts.items()),
            "",
            *_relations(found, unit),
            "",
            c.verdict,
            *c.notes,
        ]
    )


def _relations(found: Agreement, unit: str) -> list[str]:
    spread = f"spread [{unit}]" if unit else "spread"
    body = [["relation", "sum of squares", spread, "NRMSE [%]", "AICc"]]
    for name in RELATIONS:
        numbers = (found.residuals[name], found.spread(name), 100 * found.nrmse[name], found.aicc[name])
        body.append([name, *(f"{v:.4g}" if math.isfinite(v) else "-" for v in numbers)])
    return [*_aligned(body), "NRMSE is the root mean square difference over the range of the measured values."]


def _conditions(c: Comparison) -> list[str]:
    """The table's lines; a setting that is the same throughout is said once."""
    names = [str(n) for n in c.table.coords]
    constant = [n for n in names if len(set(map(str, c.table[n].values.tolist()))) == 1]
    columns = [_setting(c.table[n]) for n in names if n not in constant]
    for side in ("model", "data"):
        columns += _side(c, side)
    difference = [f"{v:.4g}" for v in c.table["difference"].values]
    columns.append(["data - model", *difference])
    same = ", ".join(describe(c.table, n) for n in constant)
    return ([f"At {same}:"] if same else []) + _aligned([list(row) for row in zip(*columns, strict=True)])


def _setting(column: xr.DataArray) -> list[str]:
    name, unit = str(column.name), column.attrs.get("units", "1")
    if column.dtype.kind not in "fiu":
        return [name, *map(str, column.values)]
    none = "locked" if name == "speed_ratio" else "-"
    return [
        name if unit == "1" else f"{name} [{unit}]",
        *(none if math.isnan(v) else f"{v:.4g}" for v in column.values),
    ]


def _side(c: Comparison, side: str) -> list[list[str]]:
    """Mean, and, where there is any, its interval and the number of repeats."""
    unit = _unit(c)
    mean = [f"{side} [{unit}]" if unit else side, *(f"{v:.4g}" for v in c.table[side].values)]
    half, repeats = (c.table[f"{side}_{of}"].values for of in ("interval", "repeats"))
    if all(math.isnan(h) for h in half):
        mean[0] += ", no repeats"
        return [mean]
    spread = ["no repeats" if math.isnan(h) else f"± {h:.2g}" for h in half]
    return [mean, ["95 %", *spread], ["of", *(str(n) for n in repeats)]]


def _aligned(lines: list[list[str]]) -> list[str]:
    widths = [max(len(cell) for cell in column) for column in zip(*lines, strict=True)]
    return ["  ".join(f"{cell:>{w}}" for cell, w in zip(line, widths, strict=True)) for line in lines]

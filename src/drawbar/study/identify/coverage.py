"""Do the 95 % intervals of the identification hold the truth in 95 % of cases? A long study, resumable.

python -m drawbar.study.identify.coverage --out out/coverage --count 200
"""

from __future__ import annotations

import argparse
import json
from collections.abc import Callable, Iterable
from pathlib import Path
from typing import Any

import numpy as np

from drawbar.files import write_whole
from drawbar.film.couette_coulomb import CouetteCoulomb
from drawbar.rig.drawbar_test import drawbar_test
from drawbar.rig.plate_test import plate_test
from drawbar.rig.sensors import Sensors
from drawbar.sources.rentschler_2004 import ASSUMED, DRAG_SPEEDS, LOADS, PLATE_MASSES, PRINTED, WEIGHT
from drawbar.study.identify.film import identify_film
from drawbar.study.identify.fit import Fit
from drawbar.study.identify.stiffness import identify_stiffness
from drawbar.tissue.winkler import Winkler
from drawbar.wheel.base import Wheel

__all__ = ["PARAMETERS", "coverage", "one_campaign", "summary"]

PARAMETERS = ("stiffness", "yield_stress", "viscous_coefficient")
SEED = 2004

WHEEL = Wheel(radius=PRINTED["robot_diameter"].value / 2, width=ASSUMED["wheel_width"].value)
SPEEDS = np.array(DRAG_SPEEDS)


def coverage(
    out: str | Path, count: int = 200, seed: int = SEED, progress: Callable[[int, int], Any] | None = None
) -> dict[str, Any]:
    """Identify ``count`` random tissues and films from noisy virtual logs, and count the intervals that hold.

    Each is the paper's protocol: three sets of ten weights from 20 to 200 g on a plate; a locked wheel
    dragged at five speeds under three loads, three times, forward and reverse. See :func:`one_campaign`.

    Parameters
    ----------
    out
        A folder. ``campaigns.jsonl`` gets a line for each finished data set, so that a study that was
        stopped goes on where it was; ``coverage.json`` gets the result.
    count, seed
        How many, and of which series of chance.
    progress
        Called with the number done and ``count``.

    Returns
    -------
    dict
        For each of ``stiffness``, ``yield_stress``, ``viscous_coefficient``: ``covered``, ``count``,
        ``fraction`` and its exact 95 % binomial interval ``low``, ``high``; ``coulomb``: how often each
        Coulomb term was chosen (the truth has a yield stress); ``warned``: how many data sets of each kind
        raised a warning.

    Raises
    ------
    ValueError
        ``count`` is below 1.
    """
    if count < 1:
        raise ValueError(f"count must be at least 1, got {count}.")
    file = Path(out) / "campaigns.jsonl"
    done = {r["index"]: r for r in _read(file) if r["seed"] == seed and r["index"] < count}
    file.parent.mkdir(parents=True, exist_ok=True)
    with file.open("a", encoding="utf-8") as log:
        if file.stat().st_size and not file.read_bytes().endswith(b"\n"):
            log.write("\n")  # the line that a stop cut off is ignored
        for index in range(count):
            if index not in done:
                done[index] = one_campaign(index, seed)
                log.write(json.dumps(done[index]) + "\n")
                log.flush()
            if progress is not None:
                progress(index + 1, count)
    result = {"seed": seed, **summary(done.values())}
    write_whole(Path(out) / "coverage.json", json.dumps(result, indent=2) + "\n", force=True)
    return result


def _read(file: Path) -> list[dict[str, Any]]:
    """The finished lines of an earlier run."""
    found = []
    for line in file.read_text(encoding="utf-8").splitlines() if file.exists() else ():
        try:
            found.append(json.loads(line))
        except json.JSONDecodeError:  # cut off by a stop
            continue
    return found


def one_campaign(index: int, seed: int = SEED) -> dict[str, Any]:
    """One random tissue and film, its virtual logs, and what the identification makes of them.

    Stiffness 100 to 600 kPa/m and μ/h 3 to 30 kPa s/m (their logarithms uniform), yield stress 5 to 60 Pa;
    places differ in stiffness by 0 to 5 %. A dial gauge good to 10 to 50 µm; a load cell with 2 to 10 mN of
    noise in each sample and 0.3 to 3 mN of zero error in each run, an inclinometer with 0.5 to 2 mrad of
    noise and 0 to 1 mrad of zero error.
    """
    rng = np.random.default_rng([seed, index])
    truth = {
        "stiffness": float(np.exp(rng.uniform(np.log(1e5), np.log(6e5)))),
        "yield_stress": float(rng.uniform(5.0, 60.0)),
        "viscous_coefficient": float(np.exp(rng.uniform(np.log(3e3), np.log(3e4)))),
    }
    sensors = Sensors(
        deflection_noise=rng.uniform(10e-6, 50e-6),
        force_noise=rng.uniform(2e-3, 10e-3),
        force_bias=rng.uniform(0.3e-3, 3e-3),
        angle_noise=rng.uniform(0.5e-3, 2e-3),
        angle_bias=rng.uniform(0.0, 1e-3),
    )
    spread, *seeds = rng.uniform(0.0, 0.05), *rng.integers(2**31, size=2).tolist()
    tissue = Winkler(stiffness=truth["stiffness"])
    film = CouetteCoulomb(viscous_coefficient=truth["viscous_coefficient"], yield_stress=truth["yield_stress"])
    plates = plate_test(
        tissue, applied_mass=PLATE_MASSES, plate_area=ASSUMED["plate_area"].value,
        sets=int(PRINTED["plate_sets"].value), spread=spread, sensors=sensors, seed=seeds[0],
    )  # fmt: skip
    drags = drawbar_test(
        WHEEL, tissue, film, normal_load=np.array(LOADS) * WEIGHT, speed=np.concatenate([SPEEDS, -SPEEDS]),
        wheel_speed=0.0, repeats=int(PRINTED["drag_repeats"].value), sensors=sensors, seed=seeds[1],
    )  # fmt: skip
    fits = {"stiffness": identify_stiffness(plates), "film": identify_film(drags)}
    return {
        "index": index,
        "seed": seed,
        "coulomb": [name for name in fits["film"].values if name != "viscous_coefficient"],
        "warnings": {kind: list(fit.warnings) for kind, fit in fits.items()},
        **{name: _held(fits["stiffness" if name == "stiffness" else "film"], name, truth[name]) for name in PARAMETERS},
    }


def _held(fit: Fit, name: str, truth: float) -> dict[str, Any]:
    """The truth, its estimate and interval, and whether it is in there. A number not fitted is not."""
    if name not in fit.values:
        return {"truth": truth, "estimate": None, "interval": None, "covered": False}
    low, high = fit.intervals[name]
    high = high if np.isfinite(high) else None
    covered = low <= truth and (high is None or truth <= high)
    return {"truth": truth, "estimate": fit.values[name], "interval": [low, high], "covered": bool(covered)}


def summary(campaigns: Iterable[dict[str, Any]]) -> dict[str, Any]:
    """How often the intervals held the truth, which Coulomb term was chosen, how often a fit warned."""
    from scipy import stats

    campaigns = list(campaigns)
    result: dict[str, Any] = {}
    for name in PARAMETERS:
        covered = sum(c[name]["covered"] for c in campaigns)
        exact = stats.binomtest(covered, len(campaigns)).proportion_ci(0.95)
        result[name] = {"covered": covered, "count": len(campaigns), "fraction": covered / len(campaigns),
                        "low": float(exact.low), "high": float(exact.high)}  # fmt: skip
    chosen = [" and ".join(c["coulomb"]) for c in campaigns]
    result["coulomb"] = {name: chosen.count(name) for name in sorted(set(chosen))}
    result["warned"] = {kind: sum(bool(c["warnings"][kind]) for c in campaigns) for kind in ("stiffness", "film")}
    return result


def main() -> None:
    """The command line of ``make coverage``."""
    from rich.progress import Progress

    parser = argparse.ArgumentParser(prog="python -m drawbar.study.identify.coverage", description=__doc__)
    parser.add_argument("--out", type=Path, default=Path("out/coverage"), help="folder for the results")
    parser.add_argument("--count", type=int, default=200, help="how many data sets")
    parser.add_argument("--seed", type=int, default=SEED, help="of chance")
    given = parser.parse_args()
    with Progress() as bar:
        task = bar.add_task("data sets", total=given.count)
        result = coverage(given.out, given.count, given.seed, lambda done, _: bar.update(task, completed=done))
    for name in PARAMETERS:
        r = result[name]
        print(
            f"{name}: {r['fraction']:.1%} of {r['count']} intervals hold the truth ({r['low']:.1%} to {r['high']:.1%})"
        )
    print(f"Coulomb terms chosen: {result['coulomb']}; data sets with a warning: {result['warned']}")
    print(f"written: {given.out / 'coverage.json'}")


if __name__ == "__main__":
    main()

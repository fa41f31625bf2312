"""The paper end to end: rig logs, identification, simulation, comparison, verdicts."""

from __future__ import annotations

import dataclasses
from collections.abc import Callable

import numpy as np
import xarray as xr

from drawbar.film.couette import Couette
from drawbar.film.couette_coulomb import CouetteCoulomb
from drawbar.motion.planar import simulate
from drawbar.motion.steady import grid, steady
from drawbar.rig.drawbar_test import drawbar_test
from drawbar.rig.plate_test import plate_test
from drawbar.rig.sensors import Sensors
from drawbar.sources.rentschler_2004 import ASSUMED, DRAG_SPEEDS, LOADS, PLATE_MASSES, PRINTED, SPEED_RATIOS, WEIGHT
from drawbar.study.compare.compare import Comparison, compare
from drawbar.study.identify.film import identify_film
from drawbar.study.identify.fit import Fit
from drawbar.study.identify.stiffness import identify_stiffness
from drawbar.study.paper.memory import memory_sweep, power_curve
from drawbar.study.paper.model import STIFFNESS, drawbar_maps, tension_error, wheel_of_width
from drawbar.study.paper.model import verdicts as verdicts_of
from drawbar.study.paper.outcomes import Verdict
from drawbar.tissue.winkler import Winkler

__all__ = ["SENSORS", "Reproduction", "drags", "plates", "reproduce"]

SENSORS = Sensors(
    force_noise=0.005, force_bias=0.0005, torque_noise=2e-5, angle_noise=2e-3, angle_bias=5e-4, deflection_noise=5e-5
)
"""What the virtual rig's sensors add (the paper prints none of it): 5 mN and 2 mrad a sample, zero errors
of 0.5 mN and 0.5 mrad a run, 50 µm a dial reading."""

SPREAD = 0.03
"""Relative standard deviation of stiffness between a plate's orientations (assumed)."""

SEED = 2004

FILMS = {
    tissue: CouetteCoulomb(
        viscous_coefficient=ASSUMED[f"{tissue}_viscous_coefficient"].value, yield_stress=ASSUMED["yield_stress"].value
    )
    for tissue in STIFFNESS
}
"""What the virtual locked-wheel drags slide on: the paper fits Coulomb and viscous friction, and prints neither."""


@dataclasses.dataclass(frozen=True)
class Reproduction:
    """Everything the paper did, done again: data sets, fits, comparisons and verdicts by name."""

    datasets: dict[str, xr.Dataset]
    fits: dict[str, Fit]
    comparisons: dict[str, Comparison]
    verdicts: tuple[Verdict, ...]


def plates(tissue: str, seed: int = SEED) -> xr.Dataset:
    """A virtual plate test as in section VI.B: three sets of 20 to 200 g."""
    return plate_test(
        Winkler(stiffness=STIFFNESS[tissue]),
        applied_mass=PLATE_MASSES,
        plate_area=ASSUMED["plate_area"].value,
        sets=int(PRINTED["plate_sets"].value),
        spread=SPREAD,
        sensors=SENSORS,
        seed=seed,
        labels={"tissue": tissue},
    )


def drags(tissue: str, seed: int = SEED) -> xr.Dataset:
    """Virtual locked-wheel drags as in section VI.A: five speeds each way, three loads, three repeats."""
    speeds = np.array(DRAG_SPEEDS)
    return drawbar_test(
        wheel_of_width(ASSUMED["wheel_width"].value),
        Winkler(stiffness=STIFFNESS[tissue]),
        FILMS[tissue],
        normal_load=np.array(LOADS) * WEIGHT,
        speed=np.concatenate([-speeds[::-1], speeds]),
        wheel_speed=0.0,
        repeats=int(PRINTED["drag_repeats"].value),
        sensors=SENSORS,
        seed=seed,
        labels={"wheel": "smooth", "tissue": tissue},
    )


def reproduce(progress: Callable[[str, int, int], None] | None = None) -> Reproduction:
    """Run every simulation, identification and comparison of the 2004 paper.

    Parameters
    ----------
    progress
        Called with the step's name, its number and the number of steps, before each step.

    Returns
    -------
    Reproduction
        Data sets, fits, comparisons and the verdicts on the printed outcomes P1 to P10. The logs are
        the virtual rig's own, so what is identified from them is circular, and called so in the report.

    Source: Rentschler et al. 2004, sections IV, VI, VII and VIII.
    """
    datasets: dict[str, xr.Dataset] = {}
    fits: dict[str, Fit] = {}
    comparisons: dict[str, Comparison] = {}
    verdicts: list[Verdict] = []
    steps: list[tuple[str, Callable[[], None]]] = [
        ("plate tests and stiffness", lambda: _stiffness(datasets, fits)),
        ("locked-wheel drags and film", lambda: _film(datasets, fits)),
        ("drawbar of the smooth wheel", lambda: _drawbar(datasets, comparisons)),
        ("time history of a run", lambda: datasets.update(history=_history())),
        ("transient from touch-down", lambda: datasets.update(transient=_transient())),
        ("tension dropped and kept", lambda: datasets.update(tension=tension_error())),
        ("memory of the tissue, explored", lambda: datasets.update(memory=memory_sweep(), power=power_curve())),
        ("printed outcomes over the wheel's width", lambda: _outcomes(datasets, verdicts)),
    ]
    for number, (name, step) in enumerate(steps):
        if progress is not None:
            progress(name, number, len(steps))
        step()
    return Reproduction(datasets, fits, comparisons, tuple(verdicts))


def _stiffness(datasets: dict[str, xr.Dataset], fits: dict[str, Fit]) -> None:
    for tissue in STIFFNESS:
        datasets[f"plates_{tissue}"] = plates(tissue)
        fits[f"stiffness_{tissue}"] = identify_stiffness(datasets[f"plates_{tissue}"])


def _film(datasets: dict[str, xr.Dataset], fits: dict[str, Fit]) -> None:
    for tissue in STIFFNESS:
        datasets[f"drags_{tissue}"] = drags(tissue)
        fits[f"film_{tissue}"] = identify_film(datasets[f"drags_{tissue}"])


def _drawbar(datasets: dict[str, xr.Dataset], comparisons: dict[str, Comparison]) -> None:
    """Fig. 10, the same on liver, and the virtual rig's own measurement of both."""
    film = Couette(viscous_coefficient=ASSUMED["foam_viscous_coefficient"].value)
    wheel = wheel_of_width(ASSUMED["wheel_width"].value)
    loads, speed = np.array(LOADS) * WEIGHT, PRINTED["slide_speed"].value
    curve = np.linspace(SPEED_RATIOS[0], SPEED_RATIOS[-1], 41)
    for tissue, stiffness in STIFFNESS.items():
        law = Winkler(stiffness=stiffness)
        datasets[f"curve_{tissue}"] = steady(
            wheel, law, film, speed=speed, **grid(normal_load=loads, speed_ratio=curve)
        ).assign_attrs(weight=WEIGHT)
        datasets[f"model_{tissue}"] = steady(
            wheel, law, film, speed=speed, **grid(normal_load=loads, speed_ratio=SPEED_RATIOS)
        )
        datasets[f"rig_{tissue}"] = drawbar_test(
            wheel,
            law,
            film,
            normal_load=loads,
            speed=speed,
            speed_ratio=SPEED_RATIOS,
            repeats=int(PRINTED["repeats"].value),
            sensors=SENSORS,
            seed=SEED,
        )
    comparisons["rig_against_model"] = compare(datasets["model_foam"], datasets["rig_foam"])
    comparisons["liver_against_foam"] = compare(datasets["model_foam"], datasets["model_liver"])


def _history() -> xr.Dataset:
    """One run as in Fig. 9: 20 cm at 2.54 cm/s, N = W, speed ratio 0.5."""
    return drawbar_test(
        wheel_of_width(ASSUMED["wheel_width"].value),
        Winkler(stiffness=STIFFNESS["foam"]),
        Couette(viscous_coefficient=ASSUMED["foam_viscous_coefficient"].value),
        normal_load=WEIGHT,
        speed=PRINTED["slide_speed"].value,
        speed_ratio=0.5,
        travel=PRINTED["travel"].value,
        sensors=SENSORS,
        seed=SEED,
        history=True,
        damper=ASSUMED["lever_damper"].value,
    )


def _transient() -> xr.Dataset:
    """A driven wheel's equations of motion from touch-down: it pulls 0.02 N from rest."""
    return simulate(
        wheel_of_width(ASSUMED["wheel_width"].value),
        Winkler(stiffness=STIFFNESS["foam"]),
        Couette(viscous_coefficient=ASSUMED["foam_viscous_coefficient"].value),
        normal_load=WEIGHT,
        drawbar_force=0.02,
        wheel_torque=4e-4,
        duration=2.0,
        interval=2e-3,
        damper=ASSUMED["lever_damper"].value,
    )


def _outcomes(datasets: dict[str, xr.Dataset], verdicts: list[Verdict]) -> None:
    maps = drawbar_maps()
    datasets["width_sweep"] = xr.Dataset({f"drawbar_force_{tissue}": a for (tissue, _), a in maps.items()})
    verdicts.extend(verdicts_of(maps))
    cells = {v.outcome.name: v.cells for v in verdicts if v.cells is not None}
    datasets["verdict_cells"] = xr.Dataset(cells)

"""How fast: ``make bench``. Medians of several runs on this machine, one core; ratios travel, times do not."""

from __future__ import annotations

import statistics
import subprocess
import sys
import time
from collections.abc import Callable

import numpy as np
from rich.console import Console
from rich.table import Table
from scipy.integrate import solve_ivp

import drawbar

POINTS = 1_000_000


def seconds(run: Callable[[], object], repeats: int = 5) -> float:
    """Median time of a call after one that warms up."""
    run()
    times = []
    for _ in range(repeats):
        start = time.perf_counter()
        run()
        times.append(time.perf_counter() - start)
    return statistics.median(times)


def steady_million(film: Callable[[np.ndarray], drawbar.Film]) -> float:
    """A million operating points: load, stiffness, film, radius, width and speed ratio all vary."""
    rng = np.random.default_rng(0)

    def draw(low: float, high: float) -> np.ndarray:
        return rng.uniform(low, high, POINTS)

    wheel = drawbar.Wheel(radius=draw(5e-3, 10e-3), width=draw(5e-3, 30e-3))  # type: ignore[arg-type]
    tissue = drawbar.Winkler(stiffness=draw(1e5, 5e5))  # type: ignore[arg-type]
    law, load, ratio = film(draw(1e3, 1e5)), draw(0.1, 0.5), draw(0.5, 1.5)
    return seconds(lambda: drawbar.steady(wheel, tissue, law, normal_load=load, speed=0.0254, speed_ratio=ratio), 3)


MEMORY = {
    "standard linear solid": drawbar.StandardLinearSolid(stiffness=4e5, branch_stiffness=4e5, relaxation_time=0.1),
    "three-term series": drawbar.Prony(
        stiffness=4e5, branch_stiffnesses=(1e5, 1e5, 1e5), relaxation_times=(0.01, 0.1, 1.0)
    ),
    "spring-pot": drawbar.SpringPot(coefficient=8e5, exponent=0.2),
}


def steady_memory(tissue: drawbar.Tissue) -> float:
    """Two thousand operating points on a tissue with memory: speeds over two decades."""
    wheel, film = drawbar.find("wheel", "robot-2004"), drawbar.find("film", "film-assumed")
    speeds = np.geomspace(1e-3, 1e-1, 2000)
    return seconds(lambda: drawbar.steady(wheel, tissue, film, normal_load=0.2, speed=speeds, speed_ratio=0.5), 3)


def transient(damper: float) -> float:
    """Eight seconds of the paper's run at a tolerance of 1e-8."""
    laws = (
        drawbar.find("wheel", "robot-2004"),
        drawbar.find("tissue", "foam-2004"),
        drawbar.find("film", "film-assumed"),
    )
    return seconds(lambda: drawbar.simulate(*laws, normal_load=0.27468, speed=0.0254, speed_ratio=0.5, damper=damper))


def transient_in_plain_python(damper: float) -> float:
    """The same run as a user would write it: a Python right-hand side and SciPy's RK45 at the same tolerance."""
    wheel = drawbar.find("wheel", "robot-2004")
    k, c, load, v, omega = 225e3, 1e4, 0.27468, 0.0254, 0.0254 / (0.5 * wheel.radius)
    r, width = wheel.radius, wheel.width

    def rates(_: float, y: np.ndarray) -> list[float]:
        depth = y[0] - r
        a = r if depth >= 0 else np.sqrt(max(r * r - depth * depth, 0.0)) if depth > -r else 0.0
        phi = np.arcsin(a / r)
        reaction = k * width * (a * np.sqrt(r * r - a * a) + r * r * phi + 2 * a * depth)
        along = c * width * r * (2 * r * omega * np.sin(phi) - v * (phi + 0.5 * np.sin(2 * phi)))
        around = 2 * c * width * r * r * (r * omega * phi - v * np.sin(phi))
        return [y[1], (load - reaction - damper * y[1]) / wheel.mass, v, along * v, around * omega]

    start = [1e-9, 1e-4, 0.0, 0.0, 0.0]
    return seconds(lambda: solve_ivp(rates, (0.0, 8.0), start, rtol=1e-8, atol=1e-10), 1)


def command(*words: str) -> float:
    return seconds(
        lambda: subprocess.run([sys.executable, "-m", "drawbar", *words], check=True, capture_output=True), 3
    )


def main() -> None:
    table = Table(title="drawbar benchmarks, one core", title_justify="left")
    for heading in ("what", "median", "rate or ratio", "target"):
        table.add_column(heading)
    for name, film in {
        "Couette": lambda c: drawbar.Couette(viscous_coefficient=c),
        "Couette + Coulomb": lambda c: drawbar.CouetteCoulomb(
            viscous_coefficient=c, yield_stress=10.0, friction_coefficient=0.05
        ),
    }.items():
        took = steady_million(film)
        table.add_row(f"steady, {name}, {POINTS:,} points", f"{took:.2f} s", f"{POINTS / took:,.0f} points/s", "< 2 s")
    for name, tissue in MEMORY.items():
        took = steady_memory(tissue)
        table.add_row(
            f"steady, {name}, 2,000 points", f"{took:.2f} s", f"{2000 / took:,.0f} points/s", "2,000 points/s"
        )
    for label, damper in (("bouncing for ever", 0.0), ("lever damper 0.5 N s/m", 0.5)):
        ours, plain = transient(damper), transient_in_plain_python(damper)
        table.add_row(
            f"8 s transient, {label}", f"{ours * 1e3:.1f} ms", f"{plain / ours:,.0f} × solve_ivp RK45", "< 50 ms"
        )
    table.add_row("drawbar --help", f"{command('--help'):.2f} s", "", "< 0.5 s")
    Console().print(table)


if __name__ == "__main__":
    main()

"""The transient of a wheel on tissue that remembers: touch-down, start, stop, reversal, second pass, dwell."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import xarray as xr

from drawbar.contact.column import Law, law_of, tables_of
from drawbar.contact.columns import Ground, arrays
from drawbar.film.base import Film
from drawbar.motion.march import BODY, DEEP, DONE, EDGE, SAMPLE, march_kernel
from drawbar.motion.schedule import Command, sampled
from drawbar.motion.steady import one_drive
from drawbar.quantity import parameters
from drawbar.tissue.base import Tissue
from drawbar.tissue.spring_pot import SpringPot
from drawbar.tissue.winkler import Winkler
from drawbar.variables import BARRED, VARIABLES, declare
from drawbar.wheel.base import Wheel

__all__ = ["simulate_columns"]


def simulate_columns(
    wheel: Wheel,
    tissue: Tissue,
    film: Film,
    *,
    normal_load: Command,
    speed: Command | None = None,
    drawbar_force: Command | None = None,
    speed_ratio: float | None = None,
    wheel_speed: Command | None = None,
    wheel_torque: Command | None = None,
    duration: float = 8.0,
    interval: float = 0.01,
    start: str = "touch-down",
    damper: float = 0.0,
    columns: int = 400,
    step: float | None = None,
    check: bool = False,
    compiled: bool = True,
) -> xr.Dataset:
    """Motion of a loaded wheel over tissue columns that are fixed in the ground and remember.

    Each column follows p = k w + c w' + Σ k_i e_i, e_i' = w' - e_i/τ_i. It is pressed where the wheel's
    circle is below its surface, let go when its pressure would become negative, and then recovers at
    p = 0 until the wheel meets it again, so a second pass finds the rut of the first. The wheel obeys

        m δ'' = N - R - c δ',   m x'' = F - H - D,   J ω' = M - T

    with reaction R, film traction F, resistance H = -L ∫ p w' dx, drawbar force D, motor torque M and film
    torque T, by the implicit midpoint rule. Over a step every column's top moves linearly and its memory
    is exact, so short relaxation times and thin films set no limit to the step.

    Parameters
    ----------
    normal_load, speed, drawbar_force, wheel_speed, wheel_torque
        As in :func:`drawbar.simulate`, each a number or a list of (time [s], value) pairs joined by
        straight lines: ``speed=[(0, 0.02), (2, 0.02), (2.1, 0)]`` stops after two seconds. With a
        ``drawbar_force`` the wheel starts at the first value of ``speed`` and then finds its own.
    speed_ratio
        One number; needs an imposed speed, and the wheel then turns and stops with it.
    duration, interval
        Length of the run and spacing of the results [s].
    start
        ``"touch-down"``: at the surface, at rest vertically; ``"equilibrium"``: standing where fully
        relaxed tissue carries the load.
    damper
        Viscous damping of the lever [N s/m], >= 0.
    columns
        How many stand side by side over the wheel's diameter, 20 to 20,000.
    step
        Longest time step [s]; if not given, the wheel moves at most one column in a step and the steps
        are a tenth of a radian of its stiffest bounce.
    check
        Run once more with half the step and half the spacing, return that, and beside each force
        ``..._error``: its difference to the coarser run (the largest of five neighbouring samples).
        The error of what is returned is about a third of the bar.
    compiled
        False runs the same source as plain Python, a few hundred times slower.

    Returns
    -------
    xarray.Dataset
        Over ``time`` what :func:`drawbar.simulate` gives, ``rolling_resistance`` (against the motion;
        negative while a wheel that starts or stops is pushed along), the edges, and the ledger
        ``motor_work + load_work = drawbar_work + film_heat + damper_heat + tissue_heat +
        elastic_energy + kinetic_energy`` (the last two less their values at the start). ``tissue_heat``
        is the dashpots' own dissipation, and ``elastic_energy`` holds what is left behind the wheel.
        ``ledger_error`` is what the steps' equations were not solved to; it says nothing of the
        grid, which ``check`` does. With an imposed speed, ``drawbar_force`` is what the carriage feels:
        traction less resistance, less the mass times the commanded acceleration. The film's upward pull
        on a sinking wheel is booked as film heat.

    Raises
    ------
    ValueError
        A number is out of bounds, a drive is missing or double, the film jumps at zero slip in free
        motion, or the tissue's columns are not independent.
    RuntimeError
        A viscous tissue or a spring-pot met a vertical face (sinkage beyond the radius), where its
        resistance has no bound; a wheel free along the way sank past its radius; or the motion diverged.

    Valid for: as :func:`drawbar.simulate`. Errors fall with the square of step and spacing while the
    sinkage is below the radius, and with their power 3/2 beyond, where columns meet a vertical face.

    >>> import drawbar
    >>> from drawbar.tissue.standard_linear_solid import StandardLinearSolid
    >>> tissue = StandardLinearSolid(stiffness=2e5, branch_stiffness=2e5, relaxation_time=0.05)
    >>> run = simulate_columns(drawbar.Wheel(radius=0.0075, width=0.02), tissue, drawbar.Frictionless(),
    ...                        normal_load=0.05, speed=0.0254, speed_ratio=1.0, duration=0.6, damper=2.0)
    >>> f"{-float(run.drawbar_force[-1]) * 1e3:.1f} mN"
    '4.7 mN'
    """
    drive, given = one_drive(speed_ratio=speed_ratio, wheel_speed=wheel_speed, wheel_torque=wheel_torque)
    if speed is None and drawbar_force is None:
        raise ValueError("give speed (imposed by the carriage) or drawbar_force (what the wheel pulls).")
    if drive == "speed_ratio" and (speed is None or drawbar_force is not None):
        raise ValueError("speed_ratio needs an imposed speed. Give speed alone, or wheel_speed in its place.")
    for name, number, low, high, unit in (
        ("duration", duration, 1e-6, 1e6, " s"), ("interval", interval, 1e-6, duration, " s"),
        ("damper", damper, 0.0, 1e6, " N s/m"), ("columns", columns, 20, 20_000, ""),
        ("step", interval if step is None else step, 1e-9, 1e3, " s"),
    ):  # fmt: skip
        if not (isinstance(number, (int, float)) and low <= number <= high):
            raise ValueError(f"{name} must be between {low:g} and {high:g}{unit}, got {number}.")
    if start not in ("touch-down", "equilibrium"):
        raise ValueError(f"start must be 'touch-down' or 'equilibrium', got '{start}'.")
    held = (drawbar_force is None, drive != "wheel_torque")
    if not all(held) and not film.continuous_at_rest:
        raise ValueError(
            f"{type(film).__name__} jumps at zero slip, where free motion may stick. "
            "Give it a regularisation_speed, for example 1e-4 m/s, or impose speed and wheel speed."
        )
    law = column_law(tissue)
    spacing = 2.0 * wheel.radius / columns
    asked = {"normal_load": normal_load, "speed": 0.0 if speed is None else speed,
             "drawbar_force": drawbar_force, drive: given}  # fmt: skip
    samples = max(round(duration / interval), 1)

    def run(refine: int) -> tuple[np.ndarray, np.ndarray, Any]:
        longest = _longest_step(wheel, law, asked, spacing, step, duration / samples)
        every = math.ceil(duration / samples / longest * (1.0 - 1e-9)) * refine
        commands, v0 = _commands(asked, held, wheel, np.linspace(0.0, duration, samples * every + 1))
        rows = _march(wheel, law, film, commands, v0, held, spacing / refine, every, duration, damper,
                             tissue.deep, start, compiled)  # fmt: skip
        numerics = {"step": duration / samples / every, "columns": columns * refine}
        return rows, commands[:, ::every], numerics

    rows, commands, numerics = run(1)
    time = np.linspace(0.0, duration, samples + 1)
    data = _results(wheel, rows, commands, held, time)
    if check:
        coarse = data
        rows, commands, numerics = run(2)
        data = _results(wheel, rows, commands, held, time)
        data |= {f"{name}_error": _bar(data[name] - coarse[name]) for name in BARRED}
    laws = {"wheel_law": repr(wheel), "tissue_law": repr(tissue), "film_law": repr(film)}
    damping = f"lever damper {damper:g} N s/m (not from the source)" if damper else "no lever damper"
    settings = {"motion": "columns", "start": start, "damper": damper, "damping": damping}
    settings |= {"normal_load": normal_load} if isinstance(normal_load, (int, float)) else {}
    return declare(
        {"time": ("time", time), **{name: ("time", column) for name, column in data.items()}},
        attrs=laws | settings | numerics,
    )


def column_law(tissue: Tissue) -> Law:
    """A tissue's law for independent columns.

    Raises
    ------
    ValueError
        It has no such law: a membrane couples its columns.
    """
    if tissue.spectrum is not None:
        stiffness, viscosity, branches, times = tissue.spectrum(*parameters(tissue))
        branches, times = (np.asarray(a, dtype=float).ravel().tolist() for a in (branches, times))
        return law_of(float(stiffness), float(viscosity), branches, times)
    if isinstance(tissue, SpringPot):
        return column_law(tissue.series())
    if isinstance(tissue, Winkler):
        return law_of(float(tissue.stiffness), 0.0, [], [])
    raise ValueError(
        f"{type(tissue).__name__} has no independent columns. Leave columns out, or take Winkler or a tissue "
        "with memory."
    )


def _longest_step(
    wheel: Wheel, law: Law, asked: dict[str, Any], spacing: float, step: float | None, interval: float
) -> float:
    if step is not None:
        return min(step, interval)
    bounce = math.sqrt(law.instant * wheel.width * 2.0 * wheel.radius / wheel.mass)
    fastest = max(np.abs(np.atleast_1d(np.asarray(asked["speed"], dtype=float))[..., -1:]).max(), 1e-12)
    return min(interval, spacing / fastest, 0.1 / bounce)


def _commands(
    asked: dict[str, Any], held: tuple[bool, bool], wheel: Wheel, time: np.ndarray
) -> tuple[np.ndarray, float]:
    """Load, speed or pull, wheel speed or torque at every time, and the first speed."""
    load = sampled("normal_load", asked["normal_load"], VARIABLES["normal_load"], time)
    if np.max(load) <= 0.0:
        raise ValueError("normal_load must be > 0 N at some time, else the wheel does not press.")
    v = sampled("speed", asked["speed"], VARIABLES["slide_speed"], time)
    along = v if held[0] else sampled("drawbar_force", asked["drawbar_force"], VARIABLES["drawbar_force"], time)
    if "speed_ratio" in asked:
        ratio = sampled("speed_ratio", asked["speed_ratio"], VARIABLES["speed_ratio"], time)
        return np.array([load, along, v / (wheel.radius * ratio)]), float(v[0])
    drive = "wheel_speed" if held[1] else "wheel_torque"
    return np.array([load, along, sampled(drive, asked[drive], VARIABLES[drive], time)]), float(v[0])


def _march(
    wheel: Wheel, law: Law, film: Film, commands: np.ndarray, v0: float, held: tuple[bool, bool], spacing: float,
    every: int, duration: float, damper: float, deep: bool, start: str, compiled: bool,
) -> np.ndarray:  # fmt: skip
    """The samples of a run."""
    steps = commands.shape[1] - 1
    tables = tables_of(law, duration / steps)
    travelled = np.zeros(1)
    if held[0]:
        travelled = np.concatenate([[0.0], np.cumsum(0.5 * (commands[1, 1:] + commands[1, :-1]) * tables.step)])
    margin = wheel.radius + 8.0 * spacing + 2.0 * float(np.max(np.abs(np.diff(travelled)), initial=0.0))
    low = spacing * math.floor((float(travelled.min()) - margin) / spacing)
    ground = Ground.fresh(low, float(travelled.max()) + margin, spacing, law)
    body = np.zeros(len(BODY))
    body[3], body[5] = v0 if not held[0] else commands[1, 0], commands[2, 0] if held[1] else 0.0
    if start == "equilibrium":
        body[0], ground = _standing(ground, law, wheel, commands[0, 0])
    state, since, spare = arrays(ground, law, tables)
    window = np.array([0, since.size])  # all are up to date
    pool = np.zeros(law.rates.size)
    samples = np.zeros((steps // every + 1, len(SAMPLE)))
    numbers = (wheel.mass, wheel.inertia, float(damper), wheel.radius, wheel.width, deep)
    of_film = tuple(float(x) for x in parameters(film))
    march = march_kernel(type(film), compiled=compiled)
    reached, why, rough = 0, EDGE, 0
    while why == EDGE:
        reached, why, more = march(
            reached, every, body, state, since, pool, window, commands, held, numbers, law, tables, of_film,
            spare, samples,
        )  # fmt: skip
        rough += more
        if why == EDGE:
            state, since = _wider(state, since, window, math.ceil(4.0 * wheel.radius / spacing) + since.size // 4)
    if why == DEEP:
        raise RuntimeError(
            f"the wheel sank past its radius at {reached * tables.step:.4g} s, where this tissue resists a vertical "
            "face without bound. Give less load, or a StandardLinearSolid or Prony tissue."
        )
    if why != DONE:
        raise RuntimeError(f"the motion diverged at {reached * tables.step:.4g} s. Give a smaller step.")
    if rough:
        raise RuntimeError(
            f"{rough} of {steps} steps could not be solved: a wheel that finds its own speed meets vertical faces "
            "where it sinks past its radius. Impose its speed, or give less load."
        )
    return samples


def _wider(state: Any, since: np.ndarray, window: np.ndarray, more: int) -> tuple[Any, np.ndarray]:
    """The ground with ``more`` fresh columns at either end."""
    first, spacing, *columns = state
    padded = [np.pad(a, [(more, more)] + [(0, 0)] * (a.ndim - 1)) for a in columns]
    window += more
    return (first - more * spacing, spacing, *padded), np.pad(since, more)


def _standing(ground: Ground, law: Law, wheel: Wheel, load: float) -> tuple[float, Ground]:
    """The sinkage at which relaxed columns carry the load, and the ground under it."""
    if law.stiffness <= 0.0:
        raise ValueError("this tissue sinks for ever: it has no long-term stiffness. Start from 'touch-down'.")
    xi = ground.first + ground.spacing * np.arange(ground.pressed.size)
    circle = np.where(np.abs(xi) < wheel.radius, np.sqrt(np.maximum(wheel.radius**2 - xi**2, 0.0)), -np.inf)
    depth = float(Winkler.sinkage_under(load / wheel.width, wheel.radius, law.stiffness))
    for _ in range(50):  # Newton's method on the columns' own sum, which is convex in the depth
        w = np.maximum(depth - wheel.radius + circle, 0.0)
        area = ground.spacing * law.stiffness * wheel.width
        change = (load - area * w.sum()) / (area * max(np.count_nonzero(w), 1))
        depth += change
        if abs(change) < 1e-14 * wheel.radius:
            break
    w = np.maximum(depth - wheel.radius + circle, 0.0)
    # all relaxed: no strain in any branch where pressed, and undisturbed elsewhere
    return depth, Ground(ground.first, ground.spacing, 0.0, w, ground.strains, w > 0.0, ground.since)


def _results(
    wheel: Wheel, rows: np.ndarray, commands: np.ndarray, held: tuple[bool, bool], time: np.ndarray
) -> dict[str, np.ndarray]:
    """Every result by its name."""
    s = dict(zip(SAMPLE, rows.T.copy(), strict=True))
    v, omega = s["slide_speed"], s["wheel_speed"]
    assert wheel.inertia is not None  # filled in when the wheel was built
    kinetic = 0.5 * wheel.mass * (s["sink_rate"] ** 2 + v**2) + 0.5 * wheel.inertia * omega**2
    pull, torque = s["along"] - s["resistance"], s["torque"]
    if held[0] and np.any(np.diff(v)):
        pull = pull - wheel.mass * np.gradient(v, time)
    if held[1] and np.any(np.diff(omega)):
        torque = torque + wheel.inertia * np.gradient(omega, time)
    forward = v >= 0.0
    spent = sum(s[n] for n in ("drawbar_work", "film_heat", "damper_heat", "tissue_heat"))
    elastic = s["elastic_energy"]
    return {
        **{name: s[name] for name in BODY},
        "drawbar_force": pull if held[0] else commands[1],
        "traction_force": s["along"],
        "rolling_resistance": np.where(forward, s["resistance"], -s["resistance"]),
        "wheel_torque": torque if held[1] else commands[2],
        "reaction": s["reaction"] + s["upward"],
        "contact_half_angle": np.where(forward, s["front"], -s["rear"]),
        "front_edge": wheel.radius * np.sin(np.where(forward, s["front"], -s["rear"])),
        "rear_edge": wheel.radius * np.sin(np.where(forward, s["rear"], -s["front"])),
        "peak_pressure": s["peak_pressure"],
        "film_loss": s["film_loss"],
        "elastic_energy": elastic,
        "kinetic_energy": kinetic,
        "ledger_error": s["motor_work"] + s["load_work"] - spent - (elastic - elastic[0]) - (kinetic - kinetic[0]),
    }


def _bar(difference: np.ndarray) -> np.ndarray:
    """|difference|, the largest of five neighbours: it may pass through zero at a sample by chance."""
    padded = np.pad(np.abs(difference), 2, mode="edge")
    return np.lib.stride_tricks.sliding_window_view(padded, 5).max(axis=-1)

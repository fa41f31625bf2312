"""Planar motion: the equations of motion of one wheel, from touch-down or from equilibrium."""

from __future__ import annotations

import functools
from typing import Any

import numpy as np
import xarray as xr
from scipy.integrate import odeint

from drawbar.contact.bind import bind, unbound
from drawbar.contact.kernel import Forces, contact_kernel, energy_kernel
from drawbar.film.base import Film
from drawbar.motion.schedule import Command, is_schedule
from drawbar.motion.steady import one_drive, steady
from drawbar.motion.transient import simulate_columns
from drawbar.quantity import check as checked
from drawbar.quantity import parameters
from drawbar.tissue.base import Tissue
from drawbar.variables import VARIABLES, declare
from drawbar.wheel.base import Wheel

__all__ = ["simulate"]

contact = unbound  # the contact's forces

# The state, in order; the last five are the ledger's works.
STATE = ("sinkage", "sink_rate", "travel", "slide_speed", "rotation", "wheel_speed",
         "motor_work", "load_work", "drawbar_work", "film_heat", "damper_heat")  # fmt: skip


def rates(y: Any, t: float, out: Any, numbers: Any) -> Any:
    """Right-hand side of equations (9), (18), (19) and of the works, into ``out``.

    m δ'' = N - R - c δ';  m x'' = F_shear - F_drawbar;  J θ'' = T_wheel - T_shear. An imposed speed is
    held by the carriage (or motor), which then gives whatever force (or torque) that takes.
    """
    load, damper, hold_speed, pull, hold_wheel, torque, mass, inertia, radius, width, tissue, film = numbers
    forces = contact(y[0], y[3], 0.0, y[5], radius, width, tissue, film)
    _, _, reaction, traction, resistance, _, shear_torque, film_loss, _, _ = forces
    net = traction - resistance
    drawbar = net if hold_speed else pull
    motor = shear_torque if hold_wheel else torque
    out[0] = y[1]
    out[1] = (load - reaction - damper * y[1]) / mass
    out[2] = y[3]
    out[3] = (net - drawbar) / mass
    out[4] = y[5]
    out[5] = (motor - shear_torque) / inertia
    out[6] = motor * y[5]
    out[7] = load * y[1]
    out[8] = drawbar * y[3]
    out[9] = film_loss
    out[10] = damper * y[1] * y[1]
    return out


@functools.cache
def _compiled_rates(tissue: type[Tissue], film: type[Film]) -> Any:
    return bind(rates, compiled=True, contact=contact_kernel(tissue, film))


def simulate(
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
    tolerance: float = 1e-8,
    columns: int | None = None,
    step: float | None = None,
    check: bool = False,
) -> xr.Dataset:
    """Motion of a loaded wheel in its plane: the source's equations (9)-(19), with an energy ledger.

    Vertically the load N presses against the tissue. Along the way either the carriage imposes
    ``speed`` (the drawbar force is what it measures) or the wheel pulls a given ``drawbar_force`` and
    finds its speed, starting from ``speed`` (0 if not given). The motor imposes ``wheel_speed`` (or
    ``speed_ratio``, for an imposed speed), or gives a ``wheel_torque`` from rest.

    The source's vertical equation has no loss: dropped from touch-down the wheel bounces for ever.
    ``damper`` [N s/m] on the lever ends that; it is not in the source, and 0 unless given.

    Parameters
    ----------
    normal_load
        Load on this wheel [N], > 0. It need not be the weight of ``wheel.mass`` (a lever applies it).
    speed, drawbar_force
        At least one [m/s], [N].
    speed_ratio, wheel_speed, wheel_torque
        Exactly one [1], [rad/s], [N m].
    duration, interval
        Length of the run and spacing of the results [s].
    start
        ``"touch-down"``: the wheel's lowest point at the surface, at rest vertically; or
        ``"equilibrium"``: at the sinkage that carries the load.
    damper
        Viscous damping of the lever [N s/m], >= 0.
    tolerance
        Relative local tolerance of the solver (SciPy's LSODA), between 1e-12 and 1e-3.
    columns, step, check
        For a tissue with memory, for commands that change with time, or where ``columns`` is given, the
        motion runs over columns of tissue fixed in the ground:
        :func:`drawbar.motion.transient.simulate_columns` says what these mean and what it returns.

    Returns
    -------
    xarray.Dataset
        Over ``time``: the motion, ``drawbar_force``, ``wheel_torque``, ``reaction``, and the ledger:
        ``motor_work + load_work = drawbar_work + film_heat + damper_heat + elastic_energy +
        kinetic_energy`` (the two energies less their values at the start); ``ledger_error`` is what is
        left over. It checks the energy, not the phase: over 8 s at the default tolerance a damped run is
        good to 1e-8, while an undamped bounce drifts in time by up to 1e-5 of the forces.

    Raises
    ------
    ValueError
        A number is out of bounds, a drive is missing or double, or a film with a jump at zero slip is
        to carry free motion.
    RuntimeError
        The solver gave up; the sentence says at what time.

    Valid for: a rigid wheel, small speeds (no inertia of tissue or film).

    Source: Rentschler et al. 2004, equations (9)-(12) and (18)-(19).

    >>> import drawbar
    >>> run = simulate(drawbar.Wheel(radius=0.0075, width=0.02), drawbar.Winkler(stiffness=225e3),
    ...                drawbar.Couette(viscous_coefficient=1e4), normal_load=0.27468, speed=0.0254,
    ...                speed_ratio=0.5, duration=0.5, start="equilibrium")
    >>> round(float(run.drawbar_force[-1]), 4)
    0.0883
    """
    commands = (normal_load, speed, drawbar_force, wheel_speed, wheel_torque)
    if columns is not None or tissue.remembers() or any(is_schedule(command) for command in commands):
        return simulate_columns(
            wheel, tissue, film, normal_load=normal_load, speed=speed, drawbar_force=drawbar_force,
            speed_ratio=speed_ratio, wheel_speed=wheel_speed, wheel_torque=wheel_torque, duration=duration,
            interval=interval, start=start, damper=damper, columns=400 if columns is None else columns, step=step,
            check=check,
        )  # fmt: skip
    if check or step is not None:
        raise ValueError(
            "step and check are for columns of tissue. Give columns=400 too, or leave them out: without columns the "
            "solver keeps the tolerance."
        )
    drive, given = one_drive(speed_ratio=speed_ratio, wheel_speed=wheel_speed, wheel_torque=wheel_torque)
    if speed is None and drawbar_force is None:
        raise ValueError("give speed (imposed by the carriage) or drawbar_force (what the wheel pulls).")
    if drive == "speed_ratio" and (speed is None or drawbar_force is not None):
        raise ValueError("speed_ratio needs an imposed speed. Give speed alone, or wheel_speed in its place.")
    settings = {"normal_load": normal_load, "slide_speed": speed or 0.0, drive: given}
    settings |= {} if drawbar_force is None else {"drawbar_force": drawbar_force}
    settings = {name: float(checked(name, v, VARIABLES[name])) for name, v in settings.items()}
    _within("normal_load", settings["normal_load"], 1e-9, 1e6, "N")
    _within("duration", duration, 1e-6, 1e6, "s")
    _within("interval", interval, 1e-6, duration, "s")
    _within("damper", damper, 0.0, 1e6, "N s/m")
    _within("tolerance", tolerance, 1e-12, 1e-3, "")
    if start not in ("touch-down", "equilibrium"):
        raise ValueError(f"start must be 'touch-down' or 'equilibrium', got '{start}'.")
    hold_speed, hold_wheel = drawbar_force is None, drive != "wheel_torque"
    if not (hold_speed and hold_wheel) and not film.continuous_at_rest:
        raise ValueError(
            f"{type(film).__name__} jumps at zero slip, where free motion may stick. "
            "Give it a regularisation_speed, for example 1e-4 m/s, or impose speed and wheel speed."
        )

    v = settings["slide_speed"]
    omega = {"wheel_torque": 0.0, "wheel_speed": given}.get(drive)
    omega = v / (wheel.radius * settings["speed_ratio"]) if omega is None else float(omega)
    of_tissue, of_film = (tuple(float(x) for x in parameters(law)) for law in (tissue, film))
    assert wheel.inertia is not None  # filled in when the wheel was built
    numbers = (settings["normal_load"], float(damper), hold_speed, settings.get("drawbar_force", 0.0), hold_wheel,
               settings.get("wheel_torque", 0.0), wheel.mass, wheel.inertia, wheel.radius, wheel.width,
               of_tissue, of_film)  # fmt: skip
    time = np.linspace(0.0, duration, max(round(duration / interval), 1) + 1)
    y0 = np.zeros(len(STATE))
    y0[3], y0[5] = v, omega
    if start == "equilibrium":
        rolling = steady(wheel, tissue, film, normal_load=settings["normal_load"], speed=v, wheel_speed=omega)
        y0[0] = float(rolling.sinkage)
    y = _integrate(_compiled_rates(type(tissue), type(film)), y0, time, numbers, tolerance)
    return _dataset(wheel, tissue, film, time, y, numbers, {"start": start, "tolerance": tolerance})


def _integrate(rates: Any, y0: np.ndarray, time: np.ndarray, numbers: Any, tolerance: float) -> np.ndarray:
    """LSODA at the given times. From exact touch-down the first microseconds are free fall, solved by
    hand: at first touch the contact's size rises as the root of the sinkage, and its slope is infinite."""
    out = np.empty(len(STATE))
    times, first = time, y0
    touch = y0[0] == 0.0
    if touch:
        load, mass = numbers[0], numbers[6]
        free = min(1e-5, 0.5 * (time[1] - time[0]))
        first = y0.copy()
        first[0], first[1] = 0.5 * load / mass * free**2, load / mass * free
        first[2], first[4] = y0[3] * free, y0[5] * free
        first[7] = load * first[0]
        times = np.concatenate([[free], time[1:]])
    scale = np.array([1e-2, 1.0, 1e-1, 1e-1, 1e1, 1e1, 1e-3, 1e-3, 1e-3, 1e-3, 1e-3])  # typical sizes
    y, info = odeint(
        rates, first, times, args=(out, numbers), rtol=tolerance, atol=0.01 * tolerance * scale,
        full_output=True, mxstep=200_000,
    )  # fmt: skip
    if info["message"] != "Integration successful." or not np.all(np.isfinite(y)):
        reached = float(np.max(info["tcur"], initial=0.0))
        raise RuntimeError(
            f"the solver stopped at {reached:.4g} s ({info['message']}). "
            "Loosen the tolerance, or check masses, stiffness and film for extreme values."
        )
    y[0] = y0
    return y


def _dataset(
    wheel: Wheel,
    tissue: Tissue,
    film: Film,
    time: np.ndarray,
    y: np.ndarray,
    numbers: Any,
    attrs: dict[str, Any],
) -> xr.Dataset:
    load, damper, hold_speed, pull, hold_wheel, torque, mass, inertia, radius, width, of_tissue, of_film = numbers
    state = dict(zip(STATE, y.T, strict=True))
    delta, v, omega = state["sinkage"], state["slide_speed"], state["wheel_speed"]
    f = Forces(*contact_kernel(type(tissue), type(film))(delta, v, 0.0, omega, radius, width, of_tissue, of_film))
    elastic = energy_kernel(type(tissue))(delta, radius, width, of_tissue)
    kinetic = 0.5 * mass * (state["sink_rate"] ** 2 + v**2) + 0.5 * inertia * omega**2
    data: dict[str, Any] = {
        **state,
        "drawbar_force": f.traction_force - f.resistance if hold_speed else np.full_like(time, pull),
        "traction_force": f.traction_force,
        "rolling_resistance": np.abs(f.resistance),
        "wheel_torque": f.wheel_torque if hold_wheel else np.full_like(time, torque),
        "reaction": f.reaction,
        "contact_half_angle": f.front,
        "peak_pressure": f.peak_pressure,
        "film_loss": f.film_loss,
        "elastic_energy": elastic,
        "kinetic_energy": kinetic,
        "ledger_error": state["motor_work"] + state["load_work"] - state["drawbar_work"] - state["film_heat"]
        - state["damper_heat"] - (elastic - elastic[0]) - (kinetic - kinetic[0]),
    }  # fmt: skip
    columns = {name: ("time", np.broadcast_to(column, time.shape)) for name, column in data.items()}
    laws = {"wheel_law": repr(wheel), "tissue_law": repr(tissue), "film_law": repr(film)}
    settings = {"normal_load": load, "damper": damper, "motion": "planar"}
    damping = f"lever damper {damper:g} N s/m (not from the source)" if damper else "nothing damps the settling"
    return declare({"time": ("time", time), **columns}, attrs={**laws, **settings, **attrs, "damping": damping})


def _within(name: str, given: float, low: float, high: float, unit: str) -> None:
    if not (isinstance(given, (int, float)) and low <= given <= high):
        raise ValueError(f"{name} must be between {low:g} and {high:g} {unit}, got {given}.".replace(" ,", ","))

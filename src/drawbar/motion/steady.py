"""Steady rolling: algebra, whole maps at once."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import Any

import numpy as np
import xarray as xr
from scipy.optimize import elementwise

from drawbar.contact.kernel import Forces, contact_kernel
from drawbar.film.base import Film
from drawbar.film.frictionless import Frictionless
from drawbar.quantity import check, parameters, quantities
from drawbar.tissue.base import Tissue
from drawbar.variables import VARIABLES, declare
from drawbar.wheel.base import Wheel

__all__ = ["grid", "one_drive", "sinkage_under_load", "steady"]

BLOCK = 16384  # operating points at a time: a dozen arrays of them stay in a core's cache


def grid(**axes: Any) -> dict[str, xr.DataArray]:
    """Named axes for every combination: each list becomes a dimension of its own name.

    >>> {k: v.dims for k, v in grid(normal_load=[0.1, 0.2], speed_ratio=[0.5, 1.0, 1.5]).items()}
    {'normal_load': ('normal_load',), 'speed_ratio': ('speed_ratio',)}
    """
    return {name: xr.DataArray(np.atleast_1d(values), dims=name) for name, values in axes.items()}


def steady(
    wheel: Wheel,
    tissue: Tissue,
    film: Film,
    *,
    normal_load: Any,
    speed: Any,
    speed_ratio: Any = None,
    wheel_speed: Any = None,
    wheel_torque: Any = None,
) -> xr.Dataset:
    """Steady rolling of a loaded wheel: sinkage, drawbar force, torque and where the power goes.

    The normal load is imposed and the sinkage solved for; then the wrench follows from
    :func:`drawbar.wrench` at that sinkage.

    Parameters
    ----------
    wheel, tissue, film
        Frozen values. Their numbers may be arrays.
    normal_load
        Vertical load on this wheel [N], >= 0.
    speed
        Speed of the axle [m/s], forward positive.
    speed_ratio, wheel_speed, wheel_torque
        Exactly one. Speed ratio v/(r ω) [1]; wheel speed ω [rad/s], 0 for a locked wheel; or the
        motor's torque [N m], 0 for a free-rolling wheel.

    Numbers give 0-d results. Arrays broadcast as in NumPy (two of equal length are taken pairwise, along
    ``point``); DataArrays broadcast by the names of their dimensions, so that
    ``steady(..., **drawbar.grid(normal_load=[...], speed_ratio=[...]))`` is a map.

    Returns
    -------
    xarray.Dataset
        SI, each variable with ``units``: ``sinkage``, ``contact_half_angle``, ``front_edge``,
        ``rear_edge``, ``drawbar_force``, ``traction_force``, ``rolling_resistance``, ``wheel_torque``,
        ``peak_pressure``, ``motor_power``, ``drawbar_power``, ``film_loss``, ``tractive_efficiency``,
        ``slip``; the settings are coordinates.

    Raises
    ------
    ValueError
        A number is out of bounds, arrays do not fit, or not exactly one of the three drives is given.
    RuntimeError
        No sinkage or wheel speed was found (never for the package's laws).

    Source: Rentschler et al. 2004, equations (2)-(6), (12), (14)-(17).

    >>> import drawbar
    >>> result = steady(drawbar.Wheel(radius=0.0075, width=0.02), drawbar.Winkler(stiffness=225e3),
    ...                 drawbar.Couette(viscous_coefficient=1e4),
    ...                 normal_load=0.27468, speed=0.0254, speed_ratio=0.5)
    >>> f"{float(result.sinkage) * 1e3:.3f} mm, {float(result.drawbar_force) * 1e3:.1f} mN"
    '5.660 mm, 88.3 mN'
    """
    drive, given = one_drive(speed_ratio=speed_ratio, wheel_speed=wheel_speed, wheel_torque=wheel_torque)
    settings = {"normal_load": normal_load, "slide_speed": speed, drive: given}
    settings = {name: check(name, v, VARIABLES[name]) for name, v in settings.items()}
    laws = {"wheel_radius": wheel.radius, "wheel_width": wheel.width}
    laws |= dict(zip(quantities(tissue), parameters(tissue), strict=True))
    laws |= dict(zip(quantities(film), parameters(film), strict=True))

    arrays = _named(settings | laws)
    full = xr.broadcast(*arrays.values())
    flat = {name: a.values.reshape(-1) for name, a in zip(arrays, full, strict=True)}
    results = _in_blocks(lambda block: _solve(type(tissue), type(film), drive, block), flat)

    dims, shape = full[0].dims, full[0].shape
    data: dict[str, Any] = {name: (dims, a.reshape(shape)) for name, a in results.items()}
    data |= {name: a for name, a in arrays.items() if name in settings or a.ndim}
    coords = [n for n in data if n in arrays or n in ("speed_ratio", "wheel_speed", "slip")]
    names = {"wheel_law": _name(wheel), "tissue_law": _name(tissue), "film_law": _name(film)}
    declared = {**quantities(tissue), **quantities(film)}
    return declare(data, coords=coords, attrs={**names, "motion": "steady"}, extra=declared)


def _name(law: Any) -> str:
    """How a law is written, or its class alone where its numbers are arrays (they are coordinates)."""
    return repr(law) if not any(np.ndim(v) for v in parameters(law)) else type(law).__name__


def one_drive(**drives: Any) -> tuple[str, Any]:
    """The name and value of the single drive that was given.

    Raises
    ------
    ValueError
        None or several were given, or a speed ratio of zero.
    """
    given = [(name, v) for name, v in drives.items() if v is not None]
    if len(given) != 1:
        got = ", ".join(name for name, _ in given) or "none"
        raise ValueError(f"give exactly one of {', '.join(drives)}; got {got}.")
    name, v = given[0]
    if name == "speed_ratio" and np.any(np.asarray(v) == 0):
        raise ValueError("speed_ratio must not be 0. For a wheel that spins on the spot give speed=0 and wheel_speed.")
    return name, v


def _named(inputs: Mapping[str, Any]) -> dict[str, xr.DataArray]:
    """Inputs as DataArrays. Plain arrays broadcast by position; an axis that one input alone spans is
    named after it, an axis that several share is ``point``."""
    plain = {n: np.asarray(v) for n, v in inputs.items() if not isinstance(v, xr.DataArray)}
    try:
        shape = np.broadcast_shapes(*(a.shape for a in plain.values()))
    except ValueError:
        sizes = ", ".join(f"{n} {a.shape}" for n, a in plain.items() if a.ndim)
        raise ValueError(
            f"arrays do not broadcast: {sizes}. For all combinations give drawbar.grid(name=[...], ...)."
        ) from None
    dims = []
    for axis in range(-len(shape), 0):
        spanning = [n for n, a in plain.items() if a.ndim >= -axis and a.shape[axis] > 1]
        name = spanning[0] if len(spanning) == 1 else "point"
        dims.append(name if name not in dims else f"{name}_{-axis}")
    named = {}
    for name, v in inputs.items():
        if isinstance(v, xr.DataArray):
            # What else a result's column carries along would only clash with the other inputs.
            bare = v.reset_coords(drop=True).astype(float)
            named[name] = bare.rename({"speed": "slide_speed"}) if "speed" in v.dims else bare
            continue
        a = plain[name].astype(float)
        own = dims[len(dims) - a.ndim :]
        keep = [i for i, d in enumerate(own) if a.shape[i] > 1 or d == name]
        named[name] = xr.DataArray(a.reshape([a.shape[i] for i in keep]), dims=[own[i] for i in keep])
    return named


def _in_blocks(solve: Callable[[dict[str, Any]], dict[str, Any]], flat: dict[str, np.ndarray]) -> dict[str, np.ndarray]:
    size = next(iter(flat.values())).size
    results: dict[str, np.ndarray] = {}
    for start in range(0, size, BLOCK):
        part = slice(start, start + BLOCK)
        for name, column in solve({n: a[part] for n, a in flat.items()}).items():
            results.setdefault(name, np.empty(size))[part] = column
    return results


def _solve(tissue: type[Tissue], film: type[Film], drive: str, p: dict[str, Any]) -> dict[str, Any]:
    """One block of operating points, everything 1-d, by name."""
    kernel = contact_kernel(tissue, film)
    radius, width, v = p["wheel_radius"], p["wheel_width"], p["slide_speed"]
    of_tissue = tuple(p[name] for name in quantities(tissue))
    of_film = tuple(p[name] for name in quantities(film))
    sinkage = sinkage_under_load(tissue, p["normal_load"], radius, width, of_tissue)
    if drive == "speed_ratio":
        omega = v / (radius * p["speed_ratio"])
    elif drive == "wheel_speed":
        omega = p["wheel_speed"]
    else:
        omega = _omega_under_torque(kernel, p["wheel_torque"], sinkage, v, radius, width, of_tissue, of_film)
    f = Forces(*kernel(sinkage, v, 0.0, omega, radius, width, of_tissue, of_film))
    drawbar = f.traction_force - f.rolling_resistance
    motor, pull = f.wheel_torque * omega, drawbar * v
    rim = radius * omega
    with np.errstate(divide="ignore", invalid="ignore"):
        ratio = np.where(rim != 0.0, v / rim, np.nan)
        efficiency = np.where((pull > 0.0) & (motor > 0.0), pull / motor, np.nan)
    half_width = radius * np.sin(f.half_angle)
    return {
        "sinkage": sinkage, "contact_half_angle": f.half_angle,
        "front_edge": half_width, "rear_edge": -half_width,
        "drawbar_force": drawbar, "traction_force": f.traction_force,
        "rolling_resistance": f.rolling_resistance, "wheel_torque": f.wheel_torque,
        "peak_pressure": f.peak_pressure, "motor_power": motor, "drawbar_power": pull,
        "film_loss": f.film_loss, "tractive_efficiency": efficiency,
        "speed_ratio": ratio, "wheel_speed": omega, "slip": 1.0 - ratio,
    }  # fmt: skip


def sinkage_under_load(tissue: type[Tissue], load: Any, radius: Any, width: Any, numbers: tuple[Any, ...]) -> Any:
    """Sinkage [m] that carries a load [N]: the law's own inverse, or a bracketed root of its support."""
    if tissue.sinkage_under is not None:
        return tissue.sinkage_under(load / width, radius, *numbers)
    kernel = contact_kernel(tissue, Frictionless)

    def excess(sinkage: Any, load: Any, radius: Any, width: Any, *numbers: Any) -> Any:
        return kernel(sinkage, 0.0, 0.0, 0.0, radius, width, numbers, ())[1] - load

    return _root(excess, 0.0 * radius, 0.1 * radius, (load, radius, width, *numbers), "sinkage")


def _omega_under_torque(
    kernel: Any, torque: Any, sinkage: Any, v: Any, radius: Any, width: Any, of_tissue: Any, of_film: Any
) -> Any:
    """Wheel speed [rad/s] at which the film takes the motor's torque: torque rises with wheel speed."""

    def excess(omega: Any, torque: Any, sinkage: Any, v: Any, radius: Any, width: Any, *numbers: Any) -> Any:
        of_tissue, of_film = numbers[:count], numbers[count:]
        return Forces(*kernel(sinkage, v, 0.0, omega, radius, width, of_tissue, of_film)).wheel_torque - torque

    count = len(of_tissue)
    rolling, reach = v / radius, np.abs(v / radius) + 1.0
    args = (torque, sinkage, v, radius, width, *of_tissue, *of_film)
    return _root(excess, rolling - reach, rolling + reach, args, "wheel speed")


def _root(excess: Callable[..., Any], low: Any, high: Any, args: tuple[Any, ...], what: str) -> Any:
    lowest = low if what == "sinkage" else None
    start = elementwise.bracket_root(excess, low, high, xmin=lowest, args=args, maxiter=60)
    found = elementwise.find_root(excess, start.bracket, args=args)
    bad = ~(start.success & found.success)
    if np.any(bad):
        raise RuntimeError(
            f"no {what} was found for {int(np.sum(bad))} of {bad.size} operating points: "
            "the torque or load is beyond what the film or tissue can bear. Give less of it."
        )
    return found.x

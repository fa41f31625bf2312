"""Steady rolling: algebra, whole maps at once."""

from __future__ import annotations

import dataclasses
from collections.abc import Callable, Mapping
from typing import Any

import numpy as np
import xarray as xr
from scipy.optimize import elementwise

from drawbar.contact.kernel import Forces, contact_kernel
from drawbar.contact.wrench import refuse_deep
from drawbar.film.base import Film
from drawbar.motion.flags import attributes, raised
from drawbar.quantity import check, parameters, quantities
from drawbar.tissue.base import Tissue
from drawbar.variables import VARIABLES, declare
from drawbar.wheel.base import Wheel

__all__ = ["grid", "one_drive", "steady"]

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
        ``peak_pressure``, ``motor_power``, ``drawbar_power``, ``film_loss``, ``tissue_loss``,
        ``tractive_efficiency``, ``slip``, and ``flags``, a bit mask of conditions worth knowing
        (:func:`drawbar.motion.flags.explain` says them in words); the settings are coordinates. Motor power is
        drawbar power, film loss and tissue loss.

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
    names = _names(tissue, film)
    for law in (tissue, film):
        numbers = zip(names[id(law)], parameters(law), strict=True)
        laws |= {name: v for name, v in numbers if not isinstance(v, tuple)}

    arrays = _named(settings | laws)
    full = xr.broadcast(*arrays.values())
    flat = {name: a.values.reshape(-1) for name, a in zip(arrays, full, strict=True)}
    results = _in_blocks(lambda numbers: _solve(_Block(tissue, film, numbers), drive), flat)

    dims, shape = full[0].dims, full[0].shape
    data: dict[str, Any] = {name: (dims, a.reshape(shape)) for name, a in results.items()}
    data |= {name: a for name, a in arrays.items() if name in settings or a.ndim}
    coords = [n for n in data if n in arrays or n in ("speed_ratio", "wheel_speed", "slip")]
    written = {"wheel_law": _name(wheel), "tissue_law": _name(tissue), "film_law": _name(film)}
    declared = {n: q for law in (tissue, film) for n, q in zip(names[id(law)], quantities(law).values(), strict=True)}
    dataset = declare(data, coords=coords, attrs={**written, "motion": "steady"}, extra=declared)
    dataset["flags"] = dataset["flags"].astype(np.int32).assign_attrs(attributes())
    return dataset


def _names(tissue: Tissue, film: Film) -> dict[int, list[str]]:
    """What the laws' quantities are called among the inputs: two of one name are told apart by their owner."""
    shared = quantities(tissue).keys() & quantities(film).keys()
    owners = ((tissue, "tissue"), (film, "film"))
    return {id(law): [f"{kind}_{n}" if n in shared else n for n in quantities(law)] for law, kind in owners}


def _name(law: Any) -> str:
    """How a law is written, or its class alone where its numbers are arrays (they are coordinates)."""
    varies = any(np.ndim(v) for v in parameters(law) if not isinstance(v, tuple))
    return type(law).__name__ if varies else repr(law)


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


@dataclasses.dataclass(frozen=True)
class _Block:
    """A block of operating points: two laws, and every number that varies as a 1-d array by name."""

    tissue: Tissue
    film: Film
    numbers: Mapping[str, np.ndarray]

    def of(self, law: Tissue | Film, pick: Any = slice(None)) -> tuple[Any, ...]:
        """A law's numbers at some of the points; a series is the same at all of them."""
        names = zip(_names(self.tissue, self.film)[id(law)], parameters(law), strict=True)
        return tuple(v if isinstance(v, tuple) else self.numbers[name][pick] for name, v in names)

    def forces(self, sinkage: Any, omega: Any, pick: Any = slice(None)) -> Forces:
        """The contact at a sinkage and wheel speed, at all of the points or those picked.

        A tissue with memory is marched through the contact panel by panel: compiled and point by point
        that is faster than on arrays, at any number of points.
        """
        tissue, film = type(self.tissue), type(self.film)
        v, radius, width = (self.numbers[n][pick] for n in ("slide_speed", "wheel_radius", "wheel_width"))
        laws = self.of(self.tissue, pick), self.of(self.film, pick)
        if not tissue.remembers():
            return Forces(*contact_kernel(tissue, film)(sinkage, v, 0.0, omega, radius, width, *laws))
        kernel = contact_kernel(tissue, film, compiled=True)
        state = np.broadcast_arrays(sinkage, v, 0.0, omega, radius, width)
        points = zip(*(a.tolist() for a in state), _rows(laws[0], v.size), _rows(laws[1], v.size), strict=True)
        return Forces(*np.array([kernel(*point) for point in points]).reshape(-1, len(Forces._fields)).T)


def _rows(numbers: tuple[Any, ...], count: int) -> list[tuple[Any, ...]]:
    """A law's numbers point by point; a series, itself a tuple, goes along whole."""
    columns = [[x] * count if isinstance(x, tuple) else x.tolist() for x in numbers]
    return list(zip(*columns, strict=True)) if columns else [()] * count


def _solve(block: _Block, drive: str) -> dict[str, Any]:
    """Steady rolling at every point of a block, by name."""
    radius, v = block.numbers["wheel_radius"], block.numbers["slide_speed"]
    sinkage, omega = _balance(block, drive)
    refuse_deep(block.tissue, sinkage / radius)
    f = block.forces(sinkage, omega)
    drawbar = f.traction_force - f.resistance
    motor, pull = f.wheel_torque * omega, drawbar * v
    rim = radius * omega
    with np.errstate(divide="ignore", invalid="ignore"):
        ratio = np.where(rim != 0.0, v / rim, np.nan)
        efficiency = np.where((pull > 0.0) & (motor > 0.0), pull / motor, np.nan)
    leading, trailing = radius * np.sin(f.front), radius * np.sin(f.rear)
    columns = {
        "sinkage": sinkage, "contact_half_angle": f.front,
        "front_edge": np.where(v >= 0.0, leading, -trailing), "rear_edge": np.where(v >= 0.0, trailing, -leading),
        "drawbar_force": drawbar, "traction_force": f.traction_force,
        "rolling_resistance": np.abs(f.resistance), "wheel_torque": f.wheel_torque,
        "peak_pressure": f.peak_pressure, "motor_power": motor, "drawbar_power": pull,
        "film_loss": f.film_loss, "tissue_loss": f.tissue_loss, "tractive_efficiency": efficiency,
        "speed_ratio": ratio, "wheel_speed": omega, "slip": 1.0 - ratio,
    }  # fmt: skip
    return columns | {"flags": raised({**block.numbers, **columns}, block.tissue, block.film)}


def _balance(block: _Block, drive: str) -> tuple[Any, Any]:
    """Sinkage and wheel speed at which the load is carried and the drive is as imposed.

    An elastic tissue's sinkage does not depend on the wheel speed. With memory the contact is not
    symmetric and the film's shear lifts a little, so the two are found in turn: a contraction, since the
    lift is a small part of the load.
    """
    radius, v = block.numbers["wheel_radius"], block.numbers["slide_speed"]
    if drive != "wheel_torque":
        omega = block.numbers["wheel_speed"] if drive == "wheel_speed" else v / (radius * block.numbers["speed_ratio"])
        return _sinkage_under_load(block, omega), omega
    omega = v / radius
    sinkage = _sinkage_under_load(block, omega)
    for _ in range(50):
        omega = _omega_under_torque(block, sinkage)
        before, sinkage = sinkage, _sinkage_under_load(block, omega)
        if np.all(np.abs(sinkage - before) <= 1e-12 * radius):
            break
    return sinkage, omega


def _sinkage_under_load(block: _Block, omega: Any) -> Any:
    """Sinkage [m] that carries the load: the law's own inverse, or a bracketed root of the reaction."""
    load, radius = block.numbers["normal_load"], block.numbers["wheel_radius"]
    if block.tissue.sinkage_under is not None:
        return block.tissue.sinkage_under(load / block.numbers["wheel_width"], radius, *block.of(block.tissue))

    def excess(stretched: Any, points: Any) -> Any:
        pick = points.astype(int)  # the root finder goes on with those points that need it
        sinkage = radius[pick] * stretched ** (2.0 / 3.0)
        return block.forces(sinkage, omega[pick], pick).reaction - load[pick]

    # The load grows about as the sinkage to the power 3/2, so over that power it is nearly a line.
    one = np.ones_like(radius)
    return radius * _root(excess, 0.0 * one, 0.3 * one, "sinkage") ** (2.0 / 3.0)


def _omega_under_torque(block: _Block, sinkage: Any) -> Any:
    """Wheel speed [rad/s] at which the film takes the motor's torque: torque rises with wheel speed."""
    torque, rolling = block.numbers["wheel_torque"], block.numbers["slide_speed"] / block.numbers["wheel_radius"]

    def excess(omega: Any, points: Any) -> Any:
        pick = points.astype(int)
        return block.forces(sinkage[pick], omega, pick).wheel_torque - torque[pick]

    reach = np.abs(rolling) + 1.0
    return _root(excess, rolling - reach, rolling + reach, "wheel speed")


def _root(excess: Callable[..., Any], low: Any, high: Any, what: str) -> Any:
    lowest = low if what == "sinkage" else None
    args = (np.arange(float(low.size)),)
    start = elementwise.bracket_root(excess, low, high, xmin=lowest, args=args, maxiter=60)
    found = elementwise.find_root(excess, start.bracket, args=args)
    bad = ~(start.success & found.success)
    if np.any(bad):
        raise RuntimeError(
            f"no {what} was found for {int(np.sum(bad))} of {bad.size} operating points: "
            "the torque or load is beyond what the film or tissue can bear. Give less of it."
        )
    return found.x

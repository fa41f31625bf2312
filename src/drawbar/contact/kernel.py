"""Where contact force is computed, and nowhere else.

Geometry gives nodes and weights on the wheel's arc, the laws act at the nodes, the wrench is the sum.
The functions here are templates (see :mod:`drawbar.contact.bind`): ``half_angle``, ``pressure`` and
``add_shear`` are the bound tissue's and film's. They act elementwise, so arrays of operating points
and single compiled points come from the same lines. Angles are measured on the wheel from its lowest
point, positive to the front.
"""

from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np

from drawbar.contact import shear
from drawbar.contact.bind import bind, unbound
from drawbar.contact.power_law import power_forces
from drawbar.contact.rolling import rolling_forces
from drawbar.elementwise import where
from drawbar.film.base import Film
from drawbar.tissue.base import Tissue

__all__ = ["Forces", "contact_kernel", "energy_kernel"]

half_angle = pressure = add_shear = energy_density = edge_energy = unbound
exact_support = exact_arc = support = arc = unbound

# Gauss-Legendre on [0, 1]. Ten nodes integrate the products of two sines or cosines that the paper's
# laws give over a quarter turn to 1e-20; arcs are cut into parts no wider than that.
_points, _weights = np.polynomial.legendre.leggauss(10)
NODES = 0.5 * (_points + 1.0)
WEIGHTS = 0.5 * _weights


class Forces(NamedTuple):
    """What a contact does, per operating point. Angles in rad, forces in N, torque in N m, powers in W.

    The front is where the wheel is going, also in reverse; ``resistance`` is along the heading, against
    the motion.
    """

    front: Any
    rear: Any
    reaction: Any
    traction_force: Any
    resistance: Any
    side_force: Any
    wheel_torque: Any
    film_loss: Any
    tissue_loss: Any
    peak_pressure: Any


def support_of_nodes(sinkage: Any, rear: Any, front: Any, radius: Any, tissue: Any) -> Any:
    """Reaction and rolling resistance per width: L∫p dx and -L∫p w' dx, with dx = r cos θ dθ."""
    reaction = 0.0 * (front + sinkage)
    resistance = 0.0 * reaction
    for part in range(2):
        lower = (rear, 0.0 * rear)[part]
        upper = (0.0 * front, front)[part]
        for i in range(NODES.size):
            theta = lower + (upper - lower) * NODES[i]
            c = np.cos(theta)
            s = np.sin(theta)
            w = sinkage - radius * s * s / (1.0 + c)
            p = pressure(w, -s / c, -1.0 / (radius * c * c * c), *tissue)
            length = (upper - lower) * WEIGHTS[i] * radius
            reaction = reaction + length * p * c
            resistance = resistance + length * p * s
    return reaction, resistance


def support_exact(sinkage: Any, rear: Any, front: Any, radius: Any, tissue: Any) -> Any:
    """The law's own integral; a contact that is symmetric front to rear resists no rolling."""
    return exact_support(sinkage, front, radius, *tissue), 0.0 * front


def arc_of_nodes(
    sinkage: Any, rear: Any, front: Any, vx: Any, vy: Any, omega: Any, radius: Any, tissue: Any, film: Any
) -> Any:
    """Film integrals per width: along, upward, side, torque, and loss.

    The slip velocity V = r ω - v cos θ changes sign at cos θ = r ω / v. The arc is cut there, since a
    film law may jump or bend at zero slip, and in the middle: each part is smooth.
    """
    rim = radius * omega
    moving = vx != 0.0
    cosine = where(moving, rim / where(moving, vx, 1.0), 2.0)
    turn = np.arccos(np.minimum(np.maximum(cosine, -1.0), 1.0))
    rear_turn = np.maximum(rear, -turn)
    front_turn = np.minimum(front, turn)
    zero = 0.0 * (front + vx + vy + omega)
    sums = (zero, zero, zero, zero, zero)
    for part in range(4):
        lower = (rear, rear_turn, 0.0 * rear, front_turn)[part]
        upper = (rear_turn, 0.0 * front, front_turn, front)[part]
        if not np.any(upper > lower):
            continue
        for i in range(NODES.size):
            theta = lower + (upper - lower) * NODES[i]
            c = np.cos(theta)
            s = np.sin(theta)
            w = sinkage - radius * s * s / (1.0 + c)
            p = pressure(w, -s / c, -1.0 / (radius * c * c * c), *tissue)
            length = (upper - lower) * WEIGHTS[i] * radius
            sums = add_shear(sums, c, s, p, length, rim, vx, vy, radius, film)
    return sums


def arc_exact(
    sinkage: Any, rear: Any, front: Any, vx: Any, vy: Any, omega: Any, radius: Any, tissue: Any, film: Any
) -> Any:
    """The film's own integrals over the arc."""
    return exact_arc(rear, front, vx, vy, omega, radius, *film)


def contact_forces(
    sinkage: Any, vx: Any, vy: Any, omega: Any, radius: Any, width: Any, tissue: Any, film: Any
) -> tuple[Any, ...]:
    """The wrench's parts in the order of :class:`Forces`.

    The tissue's columns move vertically with the wheel, so sinking causes no slip: V is the source's
    equation (14). The upward part of the film's shear vanishes for a symmetric contact.
    """
    half = half_angle(sinkage, radius, *tissue)
    normal, resistance = support(sinkage, -half, half, radius, tissue)
    along, upward, side, torque, loss = arc(sinkage, -half, half, vx, vy, omega, radius, tissue, film)
    # An elastic law's pressure is greatest at the bottom or, under tension, at the edge.
    c = np.cos(half)
    bottom = pressure(sinkage, 0.0 * sinkage, -1.0 / radius, *tissue)
    edge = pressure(sinkage - radius * (1.0 - c), -np.sin(half) / c, -1.0 / (radius * c * c * c), *tissue)
    peak = where(half > 0.0, np.maximum(bottom, edge), 0.0)
    return (
        half,
        -half,
        width * (normal + upward),
        width * along,
        width * resistance,
        width * side,
        width * torque,
        width * loss,
        0.0 * loss,
        peak,
    )


def stored_energy(sinkage: Any, radius: Any, width: Any, tissue: Any) -> Any:
    """Elastic energy [J] in the tissue under the wheel and in the free surface beside it."""
    half = half_angle(sinkage, radius, *tissue)
    energy = 0.0 * half
    for i in range(NODES.size):  # front and rear alike: twice the front
        theta = half * NODES[i]
        c = np.cos(theta)
        s = np.sin(theta)
        density = energy_density(sinkage - radius * s * s / (1.0 + c), -s / c, *tissue)
        energy = energy + 2.0 * half * WEIGHTS[i] * radius * c * density
    edge = np.maximum(sinkage - 2.0 * radius * np.sin(0.5 * half) ** 2, 0.0)
    return width * (energy + 2.0 * edge_energy(edge, *tissue))


def contact_kernel(tissue: type[Tissue], film: type[Film], *, compiled: bool = False) -> Any:
    """The contact of two laws: :func:`contact_forces`, by their exact integrals where they give them, or
    :func:`drawbar.contact.rolling.rolling_forces` or :func:`drawbar.contact.power_law.power_forces` for a
    tissue with memory."""
    film_node = bind(shear.add_shear, compiled=compiled, shear_stress=film.shear_stress)
    if tissue.spectrum is not None:
        return bind(rolling_forces, compiled=compiled, spectrum=tissue.spectrum, add_shear=film_node)
    if tissue.power_law is not None:
        return bind(power_forces, compiled=compiled, power_law=tissue.power_law, add_shear=film_node)
    if tissue.support is not None:
        bound_support = bind(support_exact, compiled=compiled, exact_support=tissue.support)
    else:
        bound_support = bind(support_of_nodes, compiled=compiled, pressure=tissue.pressure)
    if film.arc is not None:
        bound_arc = bind(arc_exact, compiled=compiled, exact_arc=film.arc)
    else:
        bound_arc = bind(arc_of_nodes, compiled=compiled, pressure=tissue.pressure, add_shear=film_node)
    return bind(
        contact_forces,
        compiled=compiled,
        half_angle=tissue.half_angle,
        pressure=tissue.pressure,
        support=bound_support,
        arc=bound_arc,
    )


def energy_kernel(tissue: type[Tissue], *, compiled: bool = False) -> Any:
    """:func:`stored_energy` for a tissue law."""
    return bind(
        stored_energy,
        compiled=compiled,
        half_angle=tissue.half_angle,
        energy_density=tissue.energy_density,
        edge_energy=tissue.edge_energy,
    )

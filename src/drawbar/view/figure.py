"""Every figure: a Dataset, a fit or a comparison in, a Matplotlib Figure out.

>>> import drawbar
>>> from drawbar.view import figure
>>> runs = drawbar.steady(drawbar.Wheel(radius=0.0075, width=0.02), drawbar.Winkler(stiffness=225e3),
...                       drawbar.Couette(viscous_coefficient=1e4), speed=0.0254,
...                       **drawbar.grid(normal_load=[0.14, 0.27], speed_ratio=[0.5, 1.0, 1.5]))
>>> figure.drawbar_curves(runs).axes[0].get_ylabel()
'drawbar force [mN]'
"""

from __future__ import annotations

from drawbar.view.figure_compare import comparison
from drawbar.view.figure_fit import film_fit, stiffness_fit
from drawbar.view.figure_memory import memory_sweep
from drawbar.view.figure_motion import simulation
from drawbar.view.figure_paper import printed_words, tension_error, width_sweep
from drawbar.view.figure_power import power_split
from drawbar.view.figure_rig import drawbar_curves, history, steady_map
from drawbar.view.style import save

__all__ = [
    "comparison",
    "drawbar_curves",
    "film_fit",
    "history",
    "memory_sweep",
    "power_split",
    "printed_words",
    "save",
    "simulation",
    "steady_map",
    "stiffness_fit",
    "tension_error",
    "width_sweep",
]

"""The report's figures: for each figure of the paper its place, what stands there, and what it is."""

from __future__ import annotations

import dataclasses
from collections.abc import Callable
from typing import TYPE_CHECKING

from drawbar.sources.rentschler_2004 import OUTCOMES, WEIGHT
from drawbar.view import figure

if TYPE_CHECKING:
    from matplotlib.figure import Figure

    from drawbar.study.paper.reproduce import Reproduction

__all__ = ["PANELS", "Panel"]

COMPUTED = "computed"
VIRTUAL = "virtual data"
WORDS = "printed words only"


@dataclasses.dataclass(frozen=True)
class Panel:
    """One figure: its file's name, its title, what it is (``kind``), its caption, and how it is drawn."""

    name: str
    title: str
    kind: str
    caption: str
    draw: Callable[[Reproduction], Figure]


def _words(*, curves: str, outcomes: tuple[str, ...]) -> Callable[[Reproduction], Figure]:
    said = tuple(o for o in OUTCOMES if o.name in outcomes)
    return lambda r: figure.printed_words(said, model_curves=r.datasets[curves])


CIRCULAR = (
    "The logs are the virtual rig's own, with its noise; what is identified from them is what was put in, so this is "
    "circular and shows only that the identification works. The paper's data are not printed."
)
NO_VALUES = (
    "The paper prints no values of this measurement, only words. Shaded: what the words say. Lines: what the paper's "
    "model computes for the smooth wheel at the assumed width and film."
)

PANELS: tuple[Panel, ...] = (
    Panel("figure_07", "Fig. 7: least-squares fit of the film", VIRTUAL,
          f"Locked wheel dragged over liver at five speeds each way, three loads, three repeats. {CIRCULAR}",
          lambda r: figure.film_fit(r.fits["film_liver"], weight=WEIGHT)),
    Panel("figure_08", "Fig. 8: stiffness of foam and liver", VIRTUAL,
          f"Weights of 20 to 200 g on a plate, three sets each. {CIRCULAR}",
          lambda r: figure.stiffness_fit(r.fits["stiffness_foam"], r.fits["stiffness_liver"])),
    Panel("figure_09", "Fig. 9: time history of a run", COMPUTED,
          "20 cm at 2.54 cm/s, N = W, speed ratio 0.5, with the virtual load cell's noise. The lever's damper, which "
          "ends the bounce after touch-down, is an assumption: the paper's own equation has none.",
          lambda r: figure.history(r.datasets["history"])),
    Panel("figure_10", "Fig. 10: simulated drawbar force, smooth wheel on foam", COMPUTED,
          "Printed stiffness, assumed wheel width and film. The scale of the force axis is that of the assumed film "
          "coefficient, to which every force is proportional; the shape is not.",
          lambda r: figure.drawbar_curves(r.datasets["curve_foam"], weight=WEIGHT)),
    Panel("figure_11", "Fig. 11: measured drawbar force, smooth wheel on foam", WORDS, NO_VALUES,
          _words(curves="curve_foam", outcomes=("P1", "P2", "P3"))),
    Panel("figure_13", "Fig. 13: measured drawbar force, smooth wheel on liver", WORDS, NO_VALUES,
          _words(curves="curve_liver", outcomes=("P5", "P6"))),
    Panel("figure_14", "Fig. 14: measured drawbar force, female wheel on foam", WORDS, NO_VALUES,
          _words(curves="curve_foam", outcomes=("P4",))),
    Panel("figure_15", "Fig. 15: measured drawbar force, female wheel on liver", WORDS, NO_VALUES,
          _words(curves="curve_liver", outcomes=("P7",))),
    Panel("figure_16", "Fig. 16: measured drawbar force, male wheel on foam", WORDS, NO_VALUES,
          _words(curves="curve_foam", outcomes=("P4",))),
    Panel("figure_17", "Fig. 17: measured drawbar force, male wheel on liver", WORDS, NO_VALUES,
          _words(curves="curve_liver", outcomes=("P8", "P9", "P10"))),
    Panel("width_sweep", "Verdicts over the wheel's width", COMPUTED,
          "The paper does not print the wheel's width. Each row is a cell of a criterion, each column a width: a verdict "  # noqa: E501
          "that flips inside the plausible range is none.",
          lambda r: figure.width_sweep(r.datasets["verdict_cells"], r.datasets["width_sweep"])),
    Panel("tension", "What dropping the tension costs", COMPUTED,
          "The paper keeps the membrane's tension T in equation (1) and drops it after. Without T, sinkage and drawbar "
          "force come out too large by this much; the paper prints no T.",
          lambda r: figure.tension_error(r.datasets["tension"])),
    Panel("memory", "What a tissue with memory would do on liver", COMPUTED,
          "The same smooth wheel and viscous film on a tissue that relaxes by a power law. Memory resists rolling and "
          "shifts the curve down; from some exponent on all nine forces are negative, as the paper measured (P6) and "
          "its own model cannot give. An exploration over inputs that the paper does not print: no fit, no verdict.",
          lambda r: figure.memory_sweep(r.datasets["memory"])),
    Panel("power", "Where the power goes on a tissue with memory", COMPUTED,
          "Liver as a power law of exponent 0.2, N = W, otherwise as above. The tissue's loss is summed from its own "
          "dissipation, not as resistance times speed, so the ledger could fail.",
          lambda r: figure.power_split(r.datasets["power"])),
    Panel("transient", "Equations of motion from touch-down, with the energy ledger", COMPUTED,
          "A wheel that starts from rest, gets a constant motor torque and pulls 0.02 N. What the motor and the load "
          "put in is found again as drawbar work, heat, stored and kinetic energy.",
          lambda r: figure.simulation(r.datasets["transient"])),
    Panel("rig_against_model", "The virtual rig against the model behind it", VIRTUAL,
          "Ten noisy repeats of each setting compared with the model that made them: the comparison must find a factor "
          "of one, no offset, and it does not see a difference where there is none.",
          lambda r: figure.comparison(r.comparisons["rig_against_model"], weight=WEIGHT)),
    Panel("liver_against_foam", "Smooth wheel: liver against foam, both computed", COMPUTED,
          "The same film on both: by stiffness alone liver and foam differ little, and the sign never.",
          lambda r: figure.comparison(r.comparisons["liver_against_foam"], weight=WEIGHT)),
)  # fmt: skip
"""Every figure of the report, in order: the paper's 7 to 11 and 13 to 17, then what it does not show."""

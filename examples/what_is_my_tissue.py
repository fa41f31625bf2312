"""What is my tissue's stiffness and my film's friction, and how sure is that? From the shipped example logs."""

import drawbar
from drawbar.study.paper.examples import example_log

stiffness = drawbar.identify_stiffness(drawbar.load(example_log("plates")))
film = drawbar.identify_film(drawbar.load(example_log("drags")))
print(stiffness.report())
print(film.report())

low, high = stiffness.intervals["stiffness"]
result = drawbar.steady(
    drawbar.find("wheel", "robot-2004"), stiffness.law, film.law, normal_load=0.27468, speed=0.0254, speed_ratio=0.5
)
print(f"k between {low:.0f} and {high:.0f} Pa/m; the wheel pulls {float(result.drawbar_force) * 1e3:.1f} mN")

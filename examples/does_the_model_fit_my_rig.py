"""Is my model off by a factor or by an offset? A rig whose film is a third of what the model believes."""

import drawbar

wheel, foam = drawbar.find("wheel", "robot-2004"), drawbar.find("tissue", "foam-2004")
settings = {"normal_load": [0.137, 0.275, 0.412], "speed": 0.0254, "speed_ratio": [0.5, 1.0, 1.5]}
believed = drawbar.drawbar_test(wheel, foam, drawbar.Couette(viscous_coefficient=3e4), **settings)
measured = drawbar.drawbar_test(
    wheel, foam, drawbar.Couette(viscous_coefficient=1e4), **settings,
    repeats=10, sensors=drawbar.Sensors(force_noise=0.005, force_bias=0.0005), seed=1,
)  # fmt: skip
comparison = drawbar.compare(believed, measured)
print(comparison.verdict)

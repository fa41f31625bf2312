"""How hard does the 2004 robot's smooth wheel pull on foam, at three loads and speed ratios?"""

import drawbar

wheel = drawbar.Wheel(radius=0.0075, width=0.020)  # m; the width is an assumption
foam = drawbar.Winkler(stiffness=225e3)  # Pa/m, as printed
film = drawbar.Couette(viscous_coefficient=1e4)  # Pa s/m, an assumption

table = drawbar.steady(
    wheel, foam, film, speed=0.0254,
    **drawbar.grid(normal_load=[0.137, 0.275, 0.412], speed_ratio=[0.5, 1.0, 1.5]),
)  # fmt: skip
print(table.drawbar_force.to_pandas().round(4))
best = table.drawbar_force.max()
print(f"at most {float(best) * 1e3:.1f} mN, where the wheel sinks {float(table.sinkage.max()) * 1e3:.1f} mm")

"""What happens after touch-down, with and without a damper on the lever, and where does the energy go?"""

import drawbar

laws = (drawbar.find("wheel", "robot-2004"), drawbar.find("tissue", "foam-2004"), drawbar.find("film", "film-assumed"))
for damper in (0.0, 0.5):
    run = drawbar.simulate(
        *laws, normal_load=0.27468, drawbar_force=0.02, wheel_torque=4e-4, duration=4.0, damper=damper
    )
    late = run.sel(time=slice(3.0, None))
    swing = float(late.sinkage.max() - late.sinkage.min()) * 1e3
    spent = float(run.motor_work[-1] + run.load_work[-1])
    print(
        f"damper {damper:g} N s/m: sinkage still swings by {swing:.3f} mm, "
        f"speed {float(run.slide_speed[-1]) * 1e3:.1f} mm/s, "
        f"ledger closed to {float(abs(run.ledger_error[-1])) / spent:.0e} of {spent * 1e3:.1f} mJ"
    )

"""A lid on a hinge: how far is it from the frame, at every angle?

usage: hinge.py [PICTURE]
"""

import dataclasses
import sys

import matplotlib
import numpy
import taut2d

matplotlib.use("Agg")
from matplotlib import pyplot  # noqa: E402

frame = [(-30, -30), (60, -30), (60, 6), (50, 6), (50, -20), (-8, -20), (-8, -12), (-17, -12), (-17, 34), (-30, 34)]
lid = [(-2, -2), (48, -2), (48, 3), (6, 3), (6, 14), (-6, 14), (-6, 3), (-2, 3)]

# One degree of the lid is one unit of time.
scene = taut2d.Scene([taut2d.Body("frame", frame), taut2d.Body("lid", lid, taut2d.Sweep(0, 100, pivot=(0, 0)))], (0, 100))
opening = taut2d.check(scene)
print("opening:", opening.outcome)
least = taut2d.clearance(scene)
print(f"never closer than {least.nearest.lo:.6f}, which is at {least.nearest.angle_deg[0]:.3f} degrees")

# The distance at an instant is the least one of a scene that lasts no longer.
angles = numpy.linspace(0, 100, 201)
distances = [taut2d.clearance(dataclasses.replace(scene.with_motion("lid", turned), time=(0, 0))).nearest.lo
             for turned in (taut2d.Keyframes([(0, 0, 0, angle)]) for angle in angles)]

figure, (left, right) = pyplot.subplots(1, 2, figsize=(9, 4), layout="compressed")
scene.plot(left, at=least.nearest.t[0])
left.set_title("where it is closest")
left.plot(*zip(*least.nearest.points), "-", color="#d7191c", linewidth=2)
right.plot(angles, distances)
right.plot(least.nearest.angle_deg[0], least.nearest.hi, "o", color="#d7191c")
right.set(xlabel="angle of the lid, degrees", ylabel="distance to the frame", ylim=(0, None))
figure.savefig(sys.argv[1] if len(sys.argv) > 1 else "hinge.png", dpi=80)

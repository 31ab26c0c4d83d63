"""Which way may a vehicle go? Sixty turns of the wheel, its footprint against a map.

usage: drive.py [PICTURE]
"""

import math
import sys

import matplotlib
import numpy
import taut2d
from taut2d import Body, Keyframes, Outcome, Part, Turn

matplotlib.use("Agg")
from matplotlib import pyplot  # noqa: E402

# Metres. The origin is the middle of the rear axle; a hitch sticks out behind.
footprint = [(-1.0, -0.9), (3.6, -0.9), (3.9, -0.5), (3.9, 0.5), (3.6, 0.9), (-1.0, 0.9), (-1.0, 0.1), (-1.5, 0.1),
             (-1.5, -0.1), (-1.0, -0.1)]
# A hall, in which a pier stands at the left wall, and ten columns, which are one body of many parts.
hall = Part([(-5, -16), (32, -16), (32, 16), (-5, 16)],
            [[(-4, -15), (31, -15), (31, 15), (-4, 15), (-4, 3), (-2.5, 3), (-2.5, -3), (-4, -3)]])
columns = [[(x + 0.6 * math.cos(k * math.pi / 4), y + 0.6 * math.sin(k * math.pi / 4)) for k in range(8)]
           for x, ys in ((11, (-10, -3, 5, 11)), (18, (-7, 2, 9)), (25, (-11, -2.5, 6))) for y in ys]


def way(curvature):
    """Ten metres along an arc, then straight on for ten; the arc is exact, no chain of chords."""
    if curvature == 0:
        return Keyframes([(0, 0, 0), (20, 20, 0)])
    turned = 10 * curvature
    x, y = math.sin(turned) / curvature, (1 - math.cos(turned)) / curvature
    degrees = math.degrees(turned)
    ahead = (20, x + 10 * math.cos(turned), y + 10 * math.sin(turned), degrees)
    return Keyframes([(0, 0, 0), Turn(10, (0, 1 / curvature), degrees), ahead])


ways = [way(curvature) for curvature in numpy.linspace(-0.1, 0.1, 61)]
scenes = [taut2d.Scene([Body("hall", hall), Body("columns", columns), Body("vehicle", footprint, drive)], (0, 20))
          for drive in ways]
answers = taut2d.check_many(scenes)
print("free ways:", numpy.count_nonzero(answers["outcome"] == Outcome.FREE), "of", len(ways))

figure, axes = pyplot.subplots(figsize=(8, 5.5), layout="compressed")
scenes[0].plot(axes, at=0)
for scene, answer in zip(scenes, answers):
    free = answer["outcome"] == Outcome.FREE
    end = 20 if free else answer["t_lo"]
    track = [scene.poses(t)["vehicle"][:2] for t in numpy.linspace(0, end, 40)]
    axes.plot(*zip(*track), color="#2a8a3a" if free else "#d7191c", linewidth=1, zorder=3)
    if not free:
        axes.plot(*answer["point"], ".", color="#d7191c", zorder=4)
axes.set_title("")
axes.legend(loc="upper left", bbox_to_anchor=(1, 1))
figure.savefig(sys.argv[1] if len(sys.argv) > 1 else "drive.png", dpi=80)

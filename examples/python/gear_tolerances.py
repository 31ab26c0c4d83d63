"""How far may a pinion be from its place? 10,000 variants of two gears, each checked for a whole turn.

usage: gear_tolerances.py [PICTURE [VARIANTS]]
"""

import pathlib
import sys

import matplotlib
import numpy
import taut2d
from taut2d import Outcome

matplotlib.use("Agg")
from matplotlib import pyplot  # noqa: E402

variants = int(sys.argv[2]) if len(sys.argv) > 2 else 10000
scene = taut2d.Scene.load(pathlib.Path(__file__).parents[1] / "gears.json")
# 16 apart; a turn of the wheel's 19 teeth is 19/13 turns of the pinion, the other way.
distance, turn = 16, -360 * 19 / 13

# How the pinion is mounted: too far or too near, and turned a little on its shaft.
random = numpy.random.default_rng(2026)
error = random.normal(0.1, 0.12, variants)
phase = random.normal(0, 0.6, variants)
still = numpy.zeros(variants)
keyframes = numpy.stack([numpy.column_stack([still, distance + error, still, phase]),
                         numpy.column_stack([still + 1, distance + error, still, phase + turn])], axis=1)
answers = taut2d.check_many(scene, {"pinion": keyframes})

looks = [(Outcome.FREE, "#5b8c5a", "turns freely"), (Outcome.CONTACT, "#b3622a", "teeth meet"),
         (Outcome.OVERLAP_AT_START, "#7a7a7a", "does not fit")]
figure, axes = pyplot.subplots(figsize=(7, 5), layout="constrained")
for outcome, colour, name in looks:
    those = answers["outcome"] == outcome
    print(f"{name}: {numpy.count_nonzero(those)}")
    axes.plot(error[those], phase[those], ".", color=colour, markersize=3, label=name)
assert not (answers["outcome"] == Outcome.UNDECIDED).any()
axes.set(xlabel="error of the distance", ylabel="error of the phase, degrees")
axes.legend(markerscale=4)
figure.savefig(sys.argv[1] if len(sys.argv) > 1 else "gear_tolerances.png", dpi=80)

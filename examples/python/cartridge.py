"""Shapes from shapely: does a cartridge go into its holder, and how much larger might it be?

usage: cartridge.py [PICTURE]
"""

import sys

import matplotlib
import taut2d
from shapely.geometry import LineString, Point, box
from shapely.ops import unary_union

matplotlib.use("Agg")
from matplotlib import pyplot  # noqa: E402

# A block with a shaft, which goes on to the right under a lip, and a bore that has nothing to do with it.
shaft = unary_union([box(-5, -5, 12, 30), LineString([(0, 0), (15, 0)]).buffer(5)])
holder = box(-20, -15, 40, 22).difference(shaft).difference(Point(30, 12).buffer(4))
# A stem with a head, and a foot that goes under the lip.
cartridge = unary_union([box(-2, 0, 2, 26), box(-6, 24, 6, 30), LineString([(0, 0), (7, 0)]).buffer(4.5)])
down_and_right = taut2d.Keyframes([(0, 0, 40), (1, 0, 0), (2, 8, 0)])


def scene_of(shape):
    return taut2d.Scene([taut2d.Body("holder", holder), taut2d.Body("cartridge", shape, down_and_right)], (0, 2))


scene = scene_of(cartridge)
answer = taut2d.check(scene)
room = taut2d.clearance(scene).nearest
print(f"the cartridge: {answer.outcome}, with {room.lo:.4f} to spare")
thicker = scene_of(cartridge.buffer(0.6))
stuck = taut2d.check(thicker)
print(f"0.6 thicker: {stuck.outcome} at t = {stuck.contact.t[0]:.6f}")

figure, axes = pyplot.subplots(1, 3, figsize=(11, 4), layout="compressed", sharey=True)
scene.plot(axes[0], at=0.4)
scene.plot(axes[1], at=answer)
thicker.plot(axes[2], at=stuck)
for axis, title in zip(axes, ("on its way", "in its place", "0.6 thicker")):
    axis.set_title(title)
figure.savefig(sys.argv[1] if len(sys.argv) > 1 else "cartridge.png", dpi=80)

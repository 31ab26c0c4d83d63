#!/usr/bin/env python3
"""How close do two gears come over a full turn? taut, beside what one would write over another library's distances.

usage: clearance.py [SECONDS [AFRICA SOUTH_AMERICA]]

Gears with 266 and 434 vertices. Three ways: taut2d.clearance() to 1e-6 of the distance; branch and bound over time with
shapely's distances, where no point of either gear is faster than its radius times its angular speed, to the same
bracket, or until SECONDS (60) are over; and the least of 4,096 distances at evenly spread times, which bounds nothing.
Polygons are turned by numpy. With two outlines in WKT, the same of continents in metres: South America drifts 3,100 km
east and turns by 34 degrees.
"""

import heapq
import math
import sys
import time

import numpy
import shapely.geometry
import shapely.wkt
import taut2d

WHEEL, PINION = 19, 31
TOLERANCE = 1e-6


def gears():
    """Those of `taut gen gears --teeth1 19 --teeth2 31`."""
    import json
    import pathlib
    import subprocess
    program = pathlib.Path(__file__).resolve().parents[2] / "build/release/taut"
    text = subprocess.run([program, "gen", "gears", "--teeth1", str(WHEEL), "--teeth2", str(PINION)],
                          stdout=subprocess.PIPE, text=True, check=True).stdout
    return taut2d.Scene.from_json(text), json.loads(text)


def continents(africa, south_america):
    """The second one drifts and turns."""
    texts = [open(path, encoding="utf-8").read() for path in (africa, south_america)]
    rings = [numpy.array(shapely.wkt.loads(text).exterior.coords)[:-1] for text in texts]
    x, y, angle = [-9e6, 3.1e6], [-1.5e6], [0, 0.6]
    bodies = [taut2d.Body("Africa", rings[0]),
              taut2d.Body("South America", rings[1], taut2d.Polynomial(x=x, y=y, rotation=taut2d.Angle(angle)))]
    plain = {"bodies": [{"polygon": rings[0], "motion": {"rotation": {"angle": [0, 0]}}},
                        {"polygon": rings[1], "motion": {"x": x, "y": y, "rotation": {"angle": angle}}}]}
    return taut2d.Scene(bodies, (0, 1)), plain


class Distances:
    """The distance at a time, by shapely."""

    def __init__(self, scene):
        self.rings = [numpy.array(body["polygon"]) for body in scene["bodies"]]
        self.speeds = [body["motion"]["rotation"]["angle"][1] for body in scene["bodies"]]
        motion = scene["bodies"][1]["motion"]
        self.x, self.y = (numpy.polynomial.Polynomial(motion.get(axis, [0])) for axis in "xy")
        # No point moves faster than its radius times the angular speed, and its pivot.
        self.speed = abs(self.x.deriv()(0)) + sum(abs(w) * numpy.hypot(*ring.T).max() for w, ring in zip(self.speeds, self.rings))
        self.asked = 0

    def __call__(self, t):
        self.asked += 1
        placed = []
        for ring, w, at in zip(self.rings, self.speeds, ([0, 0], [self.x(t), self.y(t)])):
            c, s = math.cos(w * t), math.sin(w * t)
            placed.append(shapely.geometry.Polygon(ring @ [[c, s], [-s, c]] + at))
        return placed[0].distance(placed[1])


def branch_and_bound(distance, seconds):
    """The bracket of the least distance, as far as it came."""
    best = distance(0.5)
    queue = [(best - distance.speed / 2, 0.5, 0.5)]
    end = time.perf_counter() + seconds
    while queue and queue[0][0] < best - TOLERANCE * best and time.perf_counter() < end:
        _, middle, half = heapq.heappop(queue)
        for t in (middle - half / 2, middle + half / 2):
            d = distance(t)
            best = min(best, d)
            low = d - distance.speed * half / 2
            if low < best - TOLERANCE * best:
                heapq.heappush(queue, (low, t, half / 2))
    return (max(0, queue[0][0]) if queue else best - TOLERANCE * best), best


def compare(scene, plain, seconds):
    runs = []
    for _ in range(7):
        begin = time.perf_counter()
        nearest = taut2d.clearance(scene, tolerance=TOLERANCE).nearest
        runs.append(time.perf_counter() - begin)
    print(f"taut2d.clearance(): [{nearest.lo:.9f}, {nearest.hi:.9f}] in {1e3 * min(runs):.1f} ms (the best of 7 runs)")
    distance = Distances(plain)
    begin = time.perf_counter()
    lo, hi = branch_and_bound(distance, seconds)
    taken = time.perf_counter() - begin
    print(f"branch and bound: [{lo:.9f}, {hi:.9f}] in {taken:.1f} s, {distance.asked} distances")
    distance = Distances(plain)
    begin = time.perf_counter()
    least = min(distance(t) for t in numpy.linspace(0, 1, 4096))
    print(f"4,096 distances: {least:.9f} in {time.perf_counter() - begin:.2f} s, and no bound")


def main():
    seconds = float(sys.argv[1]) if len(sys.argv) > 1 else 60
    compare(*gears(), seconds)
    if len(sys.argv) > 3:
        compare(*continents(*sys.argv[2:4]), seconds)


if __name__ == "__main__":
    main()

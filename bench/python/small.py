#!/usr/bin/env python3
"""How long small questions take in Python, beside the library in C++, and beside tests of single instants by shapely.

usage: small.py QUESTION_LOOP

Run by `./dev python bench`. Medians of wall time, one thread. "A new scene": the motion is another one each time, and
the shapes are those of before. shapely tests one instant: the pose is new, and the shapes are those of before.
"""

import math
import pathlib
import statistics
import subprocess
import sys
import tempfile
import time

import taut2d

root = pathlib.Path(__file__).resolve().parents[2]


def ring(corners, turned, inner=1.0):
    radii = [1.0, inner] * corners
    angles = [turned + k * 2 * math.pi / corners for k in range(corners)]
    return [(r * math.cos(a), r * math.sin(a)) for r, a in zip(radii, angles)]


def passing(corners, inner):
    still, moving = ring(corners, 0.1, inner), [(x + 4, y) for x, y in ring(corners, 0.37, inner)]
    return taut2d.Scene([taut2d.Body("still", still), taut2d.Body("moving", moving, taut2d.Velocity((-1, 0.1)))], (0, 4))


def cases():
    yield "two octagons", passing(8, 1.0)
    yield "two stars of 16", passing(16, 0.5)
    yield "examples/lid.json", taut2d.Scene.load(root / "examples/lid.json")


def seconds(work, times=500):
    for _ in range(20):
        work()
    taken = []
    for _ in range(times):
        begin = time.perf_counter()
        work()
        taken.append(time.perf_counter() - begin)
    return statistics.median(taken)


def there(program, scene):
    with tempfile.TemporaryDirectory() as folder:
        scene.save(pathlib.Path(folder) / "scene.json")
        printed = subprocess.run([program, pathlib.Path(folder) / "scene.json"], stdout=subprocess.PIPE, text=True, check=True)
    return list(map(float, printed.stdout.split()))


def by_shapely(scene):
    """Intersection, and distance, of the bodies at one instant."""
    from shapely import affinity
    from shapely.geometry import Polygon
    still, moving = (Polygon(body.shape.outline) for body in scene.bodies)
    times = iter(range(10**9))

    def placed():
        t = next(times) % 100 / 100
        return affinity.affine_transform(moving, (math.cos(t), -math.sin(t), math.sin(t), math.cos(t), t, t))
    return seconds(lambda: still.intersects(placed())), seconds(lambda: still.distance(placed()))


def here(scene):
    """check(), clearance(), intervals(); and check() of a scene that is new, with the shapes of before."""
    steps = iter(range(1, 10**9))

    def moved():
        last = scene.bodies[-1]
        return scene.with_motion(last.name, taut2d.Velocity((-1, 0.1 + next(steps) * 1e-6)))
    return [seconds(lambda: question(scene))
            for question in (taut2d.check, taut2d.clearance, taut2d.intervals)] + [seconds(lambda: taut2d.check(moved()))]


def us(value):
    return f"{value * 1e6:.1f}"


def main(program):
    print("| scene | C++: check, clearance, intervals | Python: the same | check, its outcome read | check of a new scene | "
          "shapely, one instant: intersects, distance |\n|---|--:|--:|--:|--:|--:|")
    for name, scene in cases():
        cpp, python = there(program, scene), here(scene)
        read = seconds(lambda: taut2d.check(scene).outcome)
        print(f"| {name} | {', '.join(map(us, cpp))} | {', '.join(map(us, python[:3]))} | {us(read)} | {us(python[3])} | "
              f"{', '.join(map(us, by_shapely(scene)))} |")


if __name__ == "__main__":
    main(sys.argv[1])

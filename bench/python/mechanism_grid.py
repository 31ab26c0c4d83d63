"""Mechanisms beside a grid of poses.

usage: mechanism_grid.py [POSES] SCENE...

For each scene: taut2d.check(), and shapely's polygons at so many (4,096) evenly spread poses, which taut2d computes and
which are not part of the measured time. Both are about the pairs that check() tests. Prints what the grid missed, and
processor times."""
import statistics
import sys
import time

import numpy
import shapely.affinity
import shapely.geometry
import shapely.ops
import taut2d
from taut2d.pictures import poses

def shapes(scene):
    def region(body):
        parts = body.shape if isinstance(body.shape, tuple) else (body.shape,)
        return shapely.ops.unary_union([shapely.geometry.Polygon(part.outline, part.holes) for part in parts])
    return [region(body) for body in scene.bodies]

def tested_pairs(scene):
    """Those of which check() says something, by number."""
    number = {body.name: k for k, body in enumerate(scene.bodies)}
    answer = taut2d.check(scene, pairs="all")
    return [(number[a.bodies[0]], number[a.bodies[1]]) for a in answer.pairs]

def first_overlap(regions, pairs, placed):
    """The number of the first pose at which two of the pairs overlap."""
    for k, instant in enumerate(placed):
        moved = {}
        for pair in pairs:
            for body in pair:
                if body not in moved:
                    p = instant[body]
                    moved[body] = shapely.affinity.affine_transform(regions[body], [p.cos, -p.sin, p.sin, p.cos, p.x, p.y])
        for a, b in pairs:
            if moved[a].intersects(moved[b]) and not moved[a].touches(moved[b]):
                return k
    return None

def main():
    arguments = sys.argv[1:]
    count = int(arguments.pop(0)) if arguments and arguments[0].isdigit() else 4096
    missed, late, exact, grid, collide = [], [], [], [], 0
    for path in arguments:
        scene = taut2d.Scene.load(path)
        begin = time.process_time()
        answer = taut2d.check(scene)
        exact.append(time.process_time() - begin)
        times = numpy.linspace(*scene.time, count).tolist()
        regions, pairs, placed = shapes(scene), tested_pairs(scene), poses(scene, times)
        begin = time.process_time()
        found = first_overlap(regions, pairs, placed)
        grid.append(time.process_time() - begin)
        if answer.outcome not in ("contact", "overlap_at_start"):
            continue
        collide += 1
        if found is None:
            missed.append(path)
        elif answer.contact is not None:
            late.append((times[found] - answer.contact.t[1]) / (scene.time[1] - scene.time[0]))
    print(f"{len(arguments)} scenes, {collide} collide")
    print(f"taut2d.check()       median {statistics.median(exact):.4f} s, most {max(exact):.3f} s")
    print(f"shapely, {count} poses  median {statistics.median(grid):.4f} s, most {max(grid):.3f} s; "
          f"misses {len(missed)} collisions; finds others up to {max(late, default=0):.2g} of the time late")
    for path in missed:
        print("missed:", path)

main()

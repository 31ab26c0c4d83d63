#!/usr/bin/env python3
"""Combinations of two joints: taut2d.envelope() beside grids of poses by shapely and Box2D, CPU time and what they miss.

usage: envelope_grid.py [SCENES [FINE [POSE_GRID]]]

Each scene is an arm of two links with 60 vertices each among 80 vertices of a room with a thin post, 200 in all; the post
is so thin that few combinations collide. A grid of 64 x 64 poses looks at every scene, one of 1,000 x 1,000 at FINE of
them (2; it takes minutes). A grid misses a scene if it finds no collision where there are some, proved by taut. POSE_GRID is the
program taut_pose_grid, which ninja -C build/release taut_pose_grid builds: Box2D's shapes at 4,096 and 10^6 poses of every scene."""

import math
import random
import statistics
import subprocess
import sys
import time

import taut2d
from shapely.affinity import affine_transform
from shapely.geometry import Polygon
from shapely.prepared import prep


def bar(length, width, n, rng):
    """A bar with a wavy outline, n vertices."""
    half = n // 2
    def wave():
        return width * (1 - 0.3 * rng.random())
    lower = [(length * i / (half - 1), -wave()) for i in range(half)]
    upper = [(length * i / (half - 1), wave()) for i in reversed(range(half))]
    return lower + upper


def disc(x, y, r, n):
    return [(x + r * math.cos(2 * math.pi * i / n), y + r * math.sin(2 * math.pi * i / n)) for i in range(n)]


def scene(seed):
    rng = random.Random(seed)
    angle, far = rng.uniform(0.2, 2.6), rng.uniform(3.69, 3.71)
    # Out of reach but for arms that are nearly straight.
    post = disc(far * math.cos(angle), far * math.sin(angle), 0.004, 60)
    floor = bar(10, 0.1, 20, rng)
    room = [[(x - 5, y - 1.5) for x, y in floor], post]
    links = [bar(2, 0.08, 60, rng), bar(1.7, 0.06, 60, rng)]
    return room, links


JOINTS = {"shoulder": (0.0, 150.0), "elbow": (0.0, 120.0)}


def linkage(room, links):
    return taut2d.Linkage(
        [taut2d.Body("room", room), taut2d.Body("upper arm", links[0], taut2d.Revolute((0, 0), "shoulder")),
         taut2d.Body("forearm", links[1], taut2d.Revolute((2, 0), "elbow"), relative_to="upper arm")],
        JOINTS, ignore=[("upper arm", "forearm")])


def grid(room, links, n):
    """Is there a collision among n x n poses?"""
    rooms = [prep(Polygon(part)) for part in room]
    upper, fore = Polygon(links[0]), Polygon([(x + 0, y) for x, y in links[1]])
    for i in range(n):
        a = math.radians(JOINTS["shoulder"][0] + (JOINTS["shoulder"][1] - JOINTS["shoulder"][0]) * i / (n - 1))
        c, s = math.cos(a), math.sin(a)
        arm = affine_transform(upper, [c, -s, s, c, 0, 0])
        if any(part.intersects(arm) for part in rooms):
            return True
        for k in range(n):
            b = math.radians(JOINTS["elbow"][0] + (JOINTS["elbow"][1] - JOINTS["elbow"][0]) * k / (n - 1))
            cb, sb = math.cos(b), math.sin(b)
            # About (2, 0) of the upper arm, then with it.
            ox, oy = 2 - 2 * cb, -2 * sb
            turned = [c * cb - s * sb, -c * sb - s * cb, s * cb + c * sb, -s * sb + c * cb,
                      c * ox - s * oy, s * ox + c * oy]
            if any(part.intersects(affine_transform(fore, turned)) for part in rooms):
                return True
    return False


def box2d_grid(program, room, links, n):
    """The same by Box2D: whether one of n x n poses collides, and the CPU seconds."""
    numbers = [math.radians(x) for x in JOINTS["shoulder"] + JOINTS["elbow"]] + [2, 0, len(room)]
    for part in [*room, *links]:
        numbers += [len(part)] + [c for point in part for c in point]
    said = subprocess.run([program, str(n)], input=" ".join(map(repr, numbers)), stdout=subprocess.PIPE, text=True,
                          check=True).stdout.split()
    return said[0] == "hit", float(said[2])


def report_box2d(times, missed, collide):
    for n, seconds in times.items():
        print(f"Box2D, {n * n:>9,} poses              median {statistics.median(seconds):.3f} s, most "
              f"{max(seconds):.3f}, finds none in {missed[n]} of {collide}")


def measured(ask):
    began = time.process_time()
    return ask(), time.process_time() - began


def main():
    scenes = int(sys.argv[1]) if len(sys.argv) > 1 else 20
    fine = int(sys.argv[2]) if len(sys.argv) > 2 else 2
    program = sys.argv[3] if len(sys.argv) > 3 else None
    times, missed_by_box2d = {64: [], 1000: []}, {64: 0, 1000: 0}
    ours, coarse, missed, collide, shares, dense = [], [], 0, 0, [], []
    for seed in range(scenes):
        room, links = scene(seed)
        links[1] = [(x + 2, y) for x, y in links[1]]
        arm = linkage(room, links)
        answer, seconds = measured(lambda: taut2d.envelope(arm))
        ours.append(seconds)
        found, seconds = measured(lambda: grid(room, links, 64))
        coarse.append(seconds)
        if answer.outcome == "contact":
            collide += 1
            shares.append(answer.colliding)
            missed += not found
        elif found:
            raise SystemExit(f"seed {seed}: the grid collides and the envelope is {answer.outcome}")
        for n in times if program else ():
            hit, seconds = box2d_grid(program, room, links, n)
            times[n].append(seconds)
            missed_by_box2d[n] += answer.outcome == "contact" and not hit
        if seed < fine:
            hit, seconds = measured(lambda: grid(room, links, 1000))
            dense.append((seconds, answer.outcome == "contact" and not hit))
    print(f"{scenes} scenes, 200 vertices, two joints; {collide} of them collide somewhere")
    print(f"  in a share of {min(shares):.1e} to {max(shares):.1e} of all combinations")
    print(f"taut2d.envelope(), tolerance 1e-3   median {statistics.median(ours):.3f} s CPU, most {max(ours):.3f}")
    print(f"shapely,    4,096 poses            median {statistics.median(coarse):.3f} s, "
          f"finds none in {missed} of {collide}")
    if program:
        report_box2d(times, missed_by_box2d, collide)
    for seconds, missed_there in dense:
        print(f"shapely, 1,000,000 poses            {seconds:.1f} s, {'finds none' if missed_there else 'finds one, or there is none'}")


if __name__ == "__main__":
    main()

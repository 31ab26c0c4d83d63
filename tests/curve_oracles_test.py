#!/usr/bin/python3
"""Curves as other programs read them, beside the polygons that taut proves to lie within and around them: no point of
ezdxf's flattening of a drawing, or of svgelements' path, at a thousandth of the tolerance may lie outside of what is
between. usage: curve_oracles_test.py TAUT"""

import json
import math
import os
import random
import subprocess
import sys
import tempfile

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "checker"))
from effort import effort  # noqa: E402

TAUT = sys.argv[1]
EPS = 1e-2
# What both programs round, in coordinates of about 10.
ROUNDING = 1e-9
PATHS = effort(150)
DRAWINGS = effort(40)


def flattened(folder, scene, side):
    """The polygons of the only body, ring by ring."""
    out = os.path.join(folder, "flat.json")
    subprocess.run([TAUT, "flatten", f"--{side}", "--tolerance", repr(EPS), scene, "-o", out], check=True,
                   stdout=subprocess.DEVNULL, stderr=subprocess.PIPE)
    with open(out, encoding="utf-8") as file:
        body = json.load(file)["bodies"][0]
    return body["polygon"] if isinstance(body["polygon"], list) else body["polygon"]["outline"]


def winding(ring, x, y):
    """Is the point inside, and how far is it from the boundary?"""
    inside, nearest = False, math.inf
    for (ax, ay), (bx, by) in zip(ring, ring[1:] + ring[:1]):
        if (ay > y) != (by > y) and x < ax + (y - ay) / (by - ay) * (bx - ax):
            inside = not inside
        ex, ey = bx - ax, by - ay
        share = min(1, max(0, ((x - ax) * ex + (y - ay) * ey) / (ex * ex + ey * ey)))
        nearest = min(nearest, math.hypot(ax + share * ex - x, ay + share * ey - y))
    return inside, nearest


def outside_of_band(points, inner, outer):
    """The first point that is not between, if there is one."""
    for x, y in points:
        within, off = winding(outer, x, y)
        if not within and off > ROUNDING:
            return (x, y), "outside of the outer polygon by", off
        within, off = winding(inner, x, y)
        if within and off > ROUNDING:
            return (x, y), "inside of the inner polygon by", off
        if off > EPS + ROUNDING:
            return (x, y), "farther from the inner polygon than the tolerance:", off
    return None


def judge(folder, scene, points, what):
    inner, outer = (flattened(folder, scene, side) for side in ("inner", "outer"))
    wrong = outside_of_band(points, inner, outer)
    if wrong:
        sys.exit(f"FAILED: {what}: the point {wrong[0]} is {wrong[1]} {wrong[2]}")
    return len(points)


def some(points, count=600):
    """Not all of a fine flattening."""
    points = list(points)
    return points if len(points) <= count else random.sample(points, count)


def corners_of(dice, count):
    return [(dice.uniform(4, 9) * math.cos(2 * math.pi * i / count), dice.uniform(4, 9) * math.sin(2 * math.pi * i / count))
            for i in range(count)]


def random_path(dice):
    """A ring around the origin, of segments of all kinds."""
    corners = corners_of(dice, dice.randint(4, 8))
    text = "M{!r} {!r}".format(*corners[0])
    for a, b in zip(corners, corners[1:] + corners[:1]):
        def beside(share):
            off = dice.uniform(-0.1, 0.25)
            return "{!r} {!r}".format(a[0] + share * (b[0] - a[0]) + off * (b[1] - a[1]),
                                      a[1] + share * (b[1] - a[1]) - off * (b[0] - a[0]))
        end = "{!r} {!r}".format(*b)
        radius = math.dist(a, b) * dice.uniform(0.9, 3)
        text += dice.choice([f"L{end}", f"Q{beside(0.5)} {end}", f"C{beside(0.3)} {beside(0.7)} {end}",
                             f"A{radius!r} {radius!r} 0 0 1 {end}",
                             f"A{radius!r} {radius * dice.uniform(0.7, 1)!r} {dice.uniform(0, 180)!r} 0 {dice.randint(0, 1)} {end}"])
    return text + "Z"


def paths(folder):
    try:
        import svgelements
    except ImportError:
        print("skipped: python3-svgelements is not installed, so there is no other reader of paths to compare with")
        return False
    dice, points, judged = random.Random(21), 0, 0
    while judged < PATHS:
        path = random_path(dice)
        scene = os.path.join(folder, "path.json")
        with open(scene, "w", encoding="utf-8") as file:
            json.dump({"format": "taut-scene/1", "time": [0, 1], "bodies": [{"name": "ring", "polygon": {"path": path}}]}, file)
        if subprocess.run([TAUT, "flatten", "--inner", "--tolerance", repr(EPS), scene], capture_output=True).returncode:
            continue  # its curves meet
        found = []
        for segment in svgelements.Path(path):
            if isinstance(segment, (svgelements.Move, svgelements.Close)):
                continue
            steps = 1 if isinstance(segment, svgelements.Line) else 200
            found += [segment.point(k / steps) for k in range(steps)]
        points += judge(folder, scene, some((p.x, p.y) for p in found), f"path {path}")
        judged += 1
    print(f"all well: {points} points of svgelements on {judged} paths")
    return True


def random_entities(space, dice):
    """One closed outline, as entities of one of some kinds."""
    kind = dice.choice(["circle", "ellipse", "bulges", "spline", "arcs"])
    if kind == "circle":
        return [space.add_circle((dice.uniform(-5, 5), dice.uniform(-5, 5)), dice.uniform(1, 6))]
    if kind == "ellipse":
        angle, axis = dice.uniform(0, 6), dice.uniform(2, 7)
        return [space.add_ellipse((dice.uniform(-5, 5), 1), (axis * math.cos(angle), axis * math.sin(angle)), dice.uniform(0.4, 1))]
    if kind == "bulges":
        corners = [(x, y, dice.uniform(-0.1, 0.4)) for x, y in corners_of(dice, dice.randint(3, 8))]
        return [space.add_lwpolyline(corners, format="xyb", close=True)]
    if kind == "spline":
        # Clamped and closed: it begins and ends at the same point.
        corners = corners_of(dice, dice.randint(6, 12))
        return [space.add_open_spline([(x, y, 0) for x, y in corners + corners[:1]], degree=3)]
    radius, wide = dice.uniform(1, 3), dice.uniform(4, 8)
    return [space.add_arc((wide, 0), radius, -90, 90), space.add_line((wide, radius), (-wide, radius)),
            space.add_arc((-wide, 0), radius, 90, 270), space.add_line((-wide, -radius), (wide, -radius))]


def points_of(entity):
    """As ezdxf flattens it, at a thousandth of the tolerance; not by its paths, in which circles are Bezier curves."""
    if entity.dxftype() == "LWPOLYLINE":
        return [p for part in entity.virtual_entities() for p in points_of(part)]
    if entity.dxftype() == "LINE":
        return [(entity.dxf.start.x, entity.dxf.start.y), (entity.dxf.end.x, entity.dxf.end.y)]
    return [(p.x, p.y) for p in entity.flattening(EPS / 1000)]


def drawings(folder):
    try:
        import ezdxf
    except ImportError:
        print("skipped: python3-ezdxf is not installed, so there is no other reader of DXF to compare with")
        return False
    dice, points, judged = random.Random(22), 0, 0
    while judged < DRAWINGS:
        document = ezdxf.new("R2010")
        entities = random_entities(document.modelspace(), dice)
        drawing, scene = os.path.join(folder, "d.dxf"), os.path.join(folder, "d.json")
        document.saveas(drawing)
        if subprocess.run([TAUT, "import", "--curves", drawing, "-o", scene], capture_output=True).returncode:
            continue  # its curves meet
        found = [p for entity in entities for p in points_of(entity)]
        points += judge(folder, scene, some(found), f"drawing {judged} of {entities[0].dxftype()}")
        judged += 1
    print(f"all well: {points} points of ezdxf {ezdxf.__version__} on {judged} drawings")
    return True


with tempfile.TemporaryDirectory() as scratch:
    # Both are asked, also where one is not there.
    ran = [paths(scratch), drawings(scratch)]
sys.exit(0 if any(ran) else 77)

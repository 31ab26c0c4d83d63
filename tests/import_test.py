#!/usr/bin/env python3
"""Generated DXF drawings: what `taut import` makes of them, beside what ezdxf sees. usage: import_test.py TAUT"""
import json
import math
import random
import subprocess
import sys
import tempfile
from pathlib import Path

try:
    import ezdxf
except ImportError:
    print("skipped: python3-ezdxf is not installed, so there is no other reader of DXF to compare with")
    sys.exit(77)
try:
    from shapely.geometry import LineString
    from shapely.ops import polygonize, unary_union
except ImportError:
    polygonize = None  # areas are then not compared

TAUT = sys.argv[1]
TOLERANCE = 0.01
FINE = 0.0005


def star(rng, n):
    """Corners around the origin, so that no two edges cross."""
    angles = sorted(rng.uniform(0, 2 * math.pi) for _ in range(n))
    angles = [2 * math.pi * (i + 0.6 * a / 2 / math.pi) / n for i, a in enumerate(angles)]
    return [(rng.uniform(6, 10) * math.cos(a), rng.uniform(6, 10) * math.sin(a)) for a in angles]


def add_shape(space, rng, kind, layer):
    """One closed shape around the origin."""
    attributes = {"layer": layer}
    if kind in ("circle", "arc", "lwpolyline", "polyline") and rng.random() < 0.3:
        attributes["extrusion"] = (0, 0, -1)
    if kind == "circle":
        space.add_circle((1, 2), rng.uniform(3, 9), dxfattribs=attributes)
    elif kind == "ellipse":
        space.add_ellipse((1, 2), (rng.uniform(-9, 9), 5), rng.uniform(0.2, 1), dxfattribs=attributes)
    elif kind == "half ellipse":
        e = space.add_ellipse((1, 2), (8, 3), 0.4, rng.uniform(0, 3), rng.uniform(4, 6), dxfattribs=attributes)
        space.add_line(e.start_point, e.end_point, dxfattribs=attributes)
    elif kind == "arc":
        start = rng.uniform(0, 360)
        a = space.add_arc((1, 2), 7, start, (start + rng.uniform(30, 330)) % 360, dxfattribs=attributes)
        space.add_line(a.start_point, a.end_point, dxfattribs={"layer": layer})
    elif kind in ("lwpolyline", "polyline"):
        corners = [(x, y, rng.choice([0, rng.uniform(-0.1, 0.3)])) for x, y in star(rng, rng.randint(3, 9))]
        if kind == "lwpolyline":
            space.add_lwpolyline(corners, format="xyb", close=True, dxfattribs=attributes)
        else:
            space.add_polyline2d(corners, format="xyb", close=True, dxfattribs=attributes)
    elif kind == "hatch":
        hatch = space.add_hatch(dxfattribs=attributes)
        hatch.paths.add_polyline_path([(x, y, 0.1) for x, y in star(rng, 6)], is_closed=True)
        hatch.paths.add_polyline_path([(1, 0), (2, 0), (2, 1)], is_closed=True)
        edges = hatch.paths.add_edge_path()
        edges.add_line((-2, 0), (-1, 0))
        edges.add_arc((-1.5, 0), 0.5, 0, 180, ccw=True)
    elif kind == "solid":
        corners = [(0, 0), (rng.uniform(2, 8), -1), (rng.uniform(3, 9), 6), (-1, rng.uniform(2, 8))]
        # In the order of its corners the third and the fourth change places.
        space.add_solid([corners[0], corners[1], corners[3], corners[2]][:rng.choice([3, 4])], dxfattribs=attributes)
    elif kind == "fit spline":
        points = [(2.0 * i, rng.uniform(1, 6)) for i in range(rng.randint(3, 9))]
        spline = space.add_spline(points, dxfattribs=attributes)
        # Without tangents, ezdxf estimates some, as other programs do in ways of their own.
        spline.dxf.start_tangent, spline.dxf.end_tangent = (1, rng.uniform(0, 1)), (1, rng.uniform(-1, 0))
        ends = [points[0], (0, -9), (points[-1][0], -9), points[-1]]
        for a, b in zip(ends, ends[1:]):
            space.add_line(a, b, dxfattribs=attributes)
    elif kind == "mpolygon":
        polygon = space.add_mpolygon(dxfattribs=attributes)
        polygon.paths.add_polyline_path(star(rng, 7), is_closed=True)
        polygon.paths.add_polyline_path([(-1, -1), (1, -1), (0, 1)], is_closed=True)
    else:
        degree = rng.randint(2, 4)
        control = [(2.0 * i, (i % 2) * rng.uniform(1, 6) + 1) for i in range(rng.randint(degree + 1, 9))]
        if kind == "rational spline":
            weights = [rng.uniform(0.5, 2) for _ in control]
            spline = space.add_rational_spline(control, weights, degree=degree, dxfattribs=attributes)
        else:
            spline = space.add_open_spline(control, degree=degree, dxfattribs=attributes)
        ends = [(*control[0], 0), (0, -3, 0), (*control[-1][:1], -3, 0), (*control[-1], 0)]
        for a, b in zip(ends, ends[1:]):
            space.add_line(a, b, dxfattribs=attributes)


KINDS = ["circle", "ellipse", "half ellipse", "arc", "lwpolyline", "polyline", "spline", "rational spline",
         "fit spline", "hatch", "mpolygon", "solid"]


def drawing(rng):
    doc = ezdxf.new("R2010")
    space = doc.modelspace()
    for i, kind in enumerate(KINDS):
        if rng.random() < 0.5 or kind in ("hatch", "mpolygon"):
            add_shape(space, rng, kind, f"layer {i}")
            continue
        block = doc.blocks.new(f"B{i}", base_point=(rng.uniform(-5, 5), rng.uniform(-5, 5)))
        add_shape(block, rng, kind, "0")
        placed = {"layer": f"layer {i}", "rotation": rng.choice([0, 90, rng.uniform(0, 360)]), "xscale": rng.uniform(0.5, 2)}
        placed["yscale"] = rng.choice([placed["xscale"], -placed["xscale"], rng.uniform(0.5, 2)])
        if kind == "fit spline":
            # ezdxf scales the points, and only then draws a curve through them: by other lengths of chords.
            placed["yscale"] = placed["xscale"]
        if rng.random() < 0.3:
            placed["extrusion"] = (0, 0, -1)
        space.add_blockref(f"B{i}", (rng.uniform(-50, 50), 20), dxfattribs=placed)
    return doc


def flattened(entity):
    """The points of an entity, as ezdxf approximates it: not by its paths, in which circles are Bezier curves."""
    kind = entity.dxftype()
    if kind in ("INSERT", "LWPOLYLINE", "POLYLINE"):
        return [line for inner in entity.virtual_entities() for line in flattened(inner)]
    if kind in ("HATCH", "MPOLYGON"):
        lines = []
        for path in entity.paths:
            if hasattr(path, "vertices"):
                ring = path.vertices
                vertices = ezdxf.new().modelspace().add_lwpolyline(ring, format="xyb", close=True)
                lines += flattened(vertices)
            else:
                for edge in path.edges:
                    if hasattr(edge, "radius"):
                        steps = [math.radians(edge.start_angle + (edge.end_angle - edge.start_angle) * i / 200) for i in range(201)]
                        lines.append([(edge.center[0] + edge.radius * math.cos(a), edge.center[1] + edge.radius * math.sin(a)) for a in steps])
                    else:
                        lines.append([tuple(edge.start)[:2], tuple(edge.end)[:2]])
        return lines
    if kind == "SOLID":
        return [[tuple(p)[:2] for p in entity.wcs_vertices(close=True)]]
    if kind == "LINE":
        return [[tuple(entity.dxf.start)[:2], tuple(entity.dxf.end)[:2]]]
    # It looks at the middle of a segment only, which an inflection passes through.
    more = {"segments": 64} if kind == "SPLINE" else {}
    return [[(p.x, p.y) for p in entity.flattening(FINE, **more)]]


def distance(p, lines):
    best = math.inf
    for line in lines:
        for (ax, ay), (bx, by) in zip(line, line[1:]):
            dx, dy = bx - ax, by - ay
            length = dx * dx + dy * dy
            t = min(1, max(0, ((p[0] - ax) * dx + (p[1] - ay) * dy) / length)) if length else 0
            best = min(best, math.hypot(p[0] - ax - t * dx, p[1] - ay - t * dy))
    return best


def rings_of(body):
    parts = body["parts"] if "parts" in body else [body["polygon"]]
    rings = []
    for part in parts:
        rings += [part["outline"], *part["holes"]] if isinstance(part, dict) else [part]
    return [[*ring, ring[0]] for ring in rings]


def area_of(lines):
    """What lines enclose, by the even-odd rule, and how long they are."""
    rounded = [LineString([(round(x, 6), round(y, 6)) for x, y in line]) for line in lines]
    merged = unary_union(rounded)
    area = 0
    for face in polygonize(merged):
        p = face.representative_point()
        # Across the lines to a point far away.
        ray = LineString([(p.x, p.y), (p.x + 1000, p.y + 1.234567)])
        hits = merged.intersection(ray)
        area += face.area * (len(getattr(hits, "geoms", [hits])) % 2)
    return area, merged.length


def compare(seed, folder):
    doc = drawing(random.Random(seed))
    file = folder / f"{seed}.dxf"
    doc.saveas(file)
    done = subprocess.run([TAUT, "import", str(file), "--json", "-o", str(folder / "out.json"), "--tolerance",
                           str(TOLERANCE), "--by", "layer"], capture_output=True, text=True)
    assert done.returncode == 0, f"seed {seed}: {done.stderr}"
    report = json.loads(done.stdout)
    assert report["files"][0]["deviation"] <= TOLERANCE, f"seed {seed}: {report}"
    assert not report["files"][0]["skipped"], f"seed {seed}: {report}"
    bodies = {b["name"]: rings_of(b) for b in json.loads((folder / "out.json").read_text())["bodies"]}
    layers = {}
    for entity in doc.modelspace():
        layers.setdefault(entity.dxf.layer, []).extend(flattened(entity))
    areas = {b["name"]: b["area"] for b in report["bodies"]}
    assert set(bodies) == set(layers), f"seed {seed}: {sorted(bodies)} instead of {sorted(layers)}"
    for layer, lines in layers.items():
        # Both ways, at the corners of the one and of the other.
        for points, others, bound in ((lines, bodies[layer], TOLERANCE + FINE), (bodies[layer], lines, 2 * FINE)):
            worst = max(distance(p, others) for line in points for p in line[:: max(1, len(line) // 40)])
            assert worst <= bound, f"seed {seed}, {layer} ({KINDS[int(layer[6:])]}): {worst} away"
        if polygonize:
            wanted, around = area_of(lines)
            assert abs(areas[layer] - wanted) <= around * (TOLERANCE + FINE), (
                f"seed {seed}, {layer} ({KINDS[int(layer[6:])]}): an area of {areas[layer]} instead of {wanted}")


with tempfile.TemporaryDirectory() as name:
    for number in range(24):
        compare(number, Path(name))
print(f"all well: 24 drawings of {len(KINDS)} shapes each, the same in ezdxf {ezdxf.__version__}")

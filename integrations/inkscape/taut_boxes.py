"""Transforms and boxes of shapes as Inkscape has them: inkex rounds transforms, and boxes of arcs are wrong in it."""

import math

import inkex
from inkex.paths import Line, Path


def transform_of(element):
    """From an object's coordinates to the drawing's own. (inkex writes what it reads anew, with six digits.)"""
    whole = inkex.Transform()
    for each in [element, *element.iterancestors()]:
        if each.getparent() is not None:
            whole = inkex.Transform(each.attrib.get("transform")) @ whole
    return whole


def box_around(element):
    """In the drawing's own units, without strokes and clips; None if there is nothing in it."""
    return _box(element, transform_of(element.getparent()))


def _box(element, outer):
    inner = outer @ inkex.Transform(element.attrib.get("transform"))
    if isinstance(element, inkex.Use):
        shift = inkex.Transform("translate(%s, %s)" % tuple(element.to_dimensionless(element.get(key, "0"))
                                                           for key in ("x", "y")))
        return _box(element.href, inner @ shift) if element.href is not None else None
    if isinstance(element, inkex.elements._groups.GroupBase):
        boxes = [_box(child, inner) for child in element if isinstance(child, inkex.ShapeElement)]
        return sum((box for box in boxes if box), None)
    path = element.path if isinstance(element, inkex.ShapeElement) else None
    return _without_arcs(path, inner).transform(inner).bounding_box() if path else None


def _without_arcs(path, transform):
    """Lines in place of each arc, through the points that are extreme after the transform: the box is the same."""
    lines = Path()
    for step in path.to_absolute().proxy_iterator():
        if step.letter != "A":
            lines.append(step.command)
            continue
        for point in _extremes(step.previous_end_point, *step.args[:5], step.end_point, transform):
            lines.append(Line(*point))
        lines.append(Line(*step.end_point))
    return lines


def _extremes(start, rx, ry, degrees, large, sweep, end, transform):
    """The points of an arc that are leftmost, rightmost, lowest and highest after the transform, unless its ends are.

    The centre is computed as the appendix of SVG 1.1 on elliptical arcs says (F.6.5).
    """
    rx, ry, turn = abs(rx), abs(ry), math.radians(degrees)
    cos, sin = math.cos(turn), math.sin(turn)
    x, y = (start[0] - end[0]) / 2, (start[1] - end[1]) / 2
    x, y = cos * x + sin * y, cos * y - sin * x
    if rx == 0 or ry == 0 or (x == 0 and y == 0):
        return
    size = math.hypot(x / rx, y / ry)
    rx, ry = rx * max(1, size), ry * max(1, size)
    share = max(0, 1 / min(1, size) ** 2 - 1) ** 0.5 * (-1 if bool(large) == bool(sweep) else 1)
    cx, cy = share * rx * y / ry, -share * ry * x / rx
    begin = math.atan2((y - cy) / ry, (x - cx) / rx)
    way = math.atan2((-y - cy) / ry, (-x - cx) / rx) - begin
    way = way % (2 * math.pi) if sweep else -(-way % (2 * math.pi))
    middle = (start[0] + end[0]) / 2 + cos * cx - sin * cy, (start[1] + end[1]) / 2 + sin * cx + cos * cy
    (a, c, _), (b, d, _) = transform.matrix
    for x, y in ((a, c), (b, d)):
        angle = math.atan2(ry * (y * cos - x * sin), rx * (x * cos + y * sin))
        for at in (angle, angle + math.pi):
            done = (at - begin) % (2 * math.pi) if sweep else (begin - at) % (2 * math.pi)
            if done < abs(way):
                u, v = rx * math.cos(at), ry * math.sin(at)
                yield middle[0] + cos * u - sin * v, middle[1] + sin * u + cos * v

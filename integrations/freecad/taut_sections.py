"""Solids of FreeCAD as bodies of a scene: sections with a plane, or slabs between heights."""

import math

import FreeCAD
import MeshPart
import Part

from taut_command import TautError

UP = FreeCAD.Vector(0, 0, 1)
SAME = 1e-6  # mm: FreeCAD's own shapes fit together to 1e-7
PARALLEL = 1e-9  # radians


class Plane:
    """The plane in which bodies move, with coordinates (x, y) in it and heights above it; lengths are in mm."""

    def __init__(self, placement=None):
        self.placement = placement or FreeCAD.Placement()
        self.inverse = self.placement.inverse()
        self.normal = self.placement.Rotation.multVec(UP)

    @classmethod
    def named(cls, name):
        """XY, XZ or YZ, seen as FreeCAD's top, front and right views see them."""
        turns = {"XY": (FreeCAD.Vector(1, 0, 0), 0), "XZ": (FreeCAD.Vector(1, 0, 0), 90),
                 "YZ": (FreeCAD.Vector(1, 1, 1), 120)}
        return cls(FreeCAD.Placement(FreeCAD.Vector(), FreeCAD.Rotation(*turns[name])))

    @classmethod
    def of(cls, base, normal):
        return cls(FreeCAD.Placement(base, FreeCAD.Rotation(UP, normal)))

    @classmethod
    def of_selected(cls, thing, part=None):
        """The plane of a flat face, seen from outside, or of a sketch, in its own coordinates."""
        if part is not None and isinstance(getattr(part, "Surface", None), Part.Plane):
            u, v = part.ParameterRange[0], part.ParameterRange[2]
            return cls.of(part.valueAt(u, v), part.normalAt(u, v))
        if thing.isDerivedFrom("Part::Part2DObject"):
            return cls(thing.getGlobalPlacement())
        raise TautError("Select a flat face, or a sketch.")

    def to(self, point):
        """(x, y, height) of a point of the model."""
        return self.inverse.multVec(point)

    def shape(self, shape):
        """A copy of a shape in the plane's coordinates."""
        moved = shape.copy()
        moved.Placement = self.inverse * moved.Placement
        return moved


class Outlines:
    """What of an object is a body: parts as scenes have them, and how far they are from the object at most."""

    def __init__(self, tolerance, shape):
        self.tolerance, self.parts, self.deviation, self.notes = tolerance, [], 0, []
        self.level_edges = [edge for edge in shape.Edges if not edge.Degenerated and edge.BoundBox.ZLength < SAME and
                            not isinstance(edge.Curve, (Part.Line, Part.Circle))]

    def add_faces(self, wires, heights=None):
        """What closed wires enclose, in the plane's coordinates."""
        if any(not wire.isClosed() for wire in wires):
            raise TautError("an outline is not closed")
        for face in Part.makeFace(wires, "Part::FaceMakerBullseye").Faces if wires else []:
            path = " ".join(self.path_of(wire) for wire in face.Wires)
            self.add({"path": path, "fill-rule": "evenodd"}, heights)

    def add(self, part, heights):
        self.parts.append(part if heights is None else dict(part, z=list(heights)))

    def path_of(self, wire):
        """Segments that end where the first one begins, since FreeCAD's edges meet to its tolerance only."""
        edges = wire.OrderedEdges
        begin = point_text(edge_points(edges[0], 1, is_reversed(edges[0]))[0])
        segments = [segment for edge in edges for segment in self.segments_of(edge)]
        last = [] if segments[-1][0] == "L" else [segments[-1][0], begin]
        return " ".join(["M", begin] + [word for segment in segments[:-1] for word in segment] + last + ["Z"])

    def segments_of(self, edge):
        """An edge as segments of a path: lines, arcs, and curves up to the third degree are what they are.

        Each is what a path has of it before its end, and the end.
        """
        edge, backwards = self.exact(edge)
        curve = edge.Curve
        if isinstance(curve, (Part.Line, Part.LineSegment)):
            return [("L", point_text(edge_points(edge, 1, backwards)[-1]))]
        if isinstance(curve, (Part.Circle, Part.Ellipse)):
            return arcs_of(edge, curve, backwards)
        if isinstance(curve, (Part.BSplineCurve, Part.BezierCurve)):
            pieces = beziers_of(edge, curve, backwards)
            if all(piece.Degree <= 3 and not piece.isRational() for piece in pieces):
                return [bezier_segment(piece) for piece in pieces]
        # The bound is FreeCAD's own.
        self.deviation = self.tolerance
        points = edge.discretize(Deflection=self.tolerance / 2)
        return [("L", point_text(point)) for point in (points[::-1] if backwards else points)[1:]]

    def exact(self, edge):
        """An edge of a section, and whether it is passed from its end.

        Sections of surfaces other than planes and cylinders are splines near them: an edge of the solid that runs above
        or below such a spline all along is what was drawn.
        """
        backwards = is_reversed(edge)
        if not isinstance(edge.Curve, Part.BSplineCurve):
            return edge, backwards
        points = edge_points(edge, 8, backwards)
        for level in self.level_edges:
            other = level.translated(FreeCAD.Vector(0, 0, points[0].z - level.valueAt(level.FirstParameter).z))
            near = [other.Curve.parameter(point) for point in points]
            ends = edge_points(other, 1, near[6] < near[2])
            if (all(other.Curve.value(at).distanceToPoint(point) < 10 * SAME for at, point in zip(near, points)) and
                    all(end.distanceToPoint(point) < 10 * SAME for end, point in zip(ends, (points[0], points[-1])))):
                return other, near[6] < near[2]
        return edge, backwards

    def add_shadow(self, face, heights):
        """Triangles that are the projection of a face, as far as heights overlap its own."""
        mesh = MeshPart.meshFromShape(Shape=Part.Compound([face]), LinearDeflection=self.tolerance,
                                      AngularDeflection=0.5, Relative=False)
        self.deviation = self.tolerance
        for facet in mesh.Facets:
            (ax, ay, _), (bx, by, _), (cx, cy, _) = facet.Points
            area = (bx - ax) * (cy - ay) - (by - ay) * (cx - ax)
            longest = max(math.hypot(bx - ax, by - ay), math.hypot(cx - bx, cy - by), math.hypot(ax - cx, ay - cy))
            # One on edge has the shadow of its neighbours' sides.
            if abs(area) > SAME * longest:
                self.add({"outline": [[ax, ay], [bx, by], [cx, cy]]}, heights)


def is_reversed(edge):
    return edge.Orientation == "Reversed"


def edge_points(edge, pieces, backwards):
    """Points on an edge from end to end."""
    first, last = edge.FirstParameter, edge.LastParameter
    points = [edge.valueAt(first + (last - first) * k / pieces) for k in range(pieces + 1)]
    return points[::-1] if backwards else points


def point_text(point):
    return "%r %r" % (point.x, point.y)


def arcs_of(edge, curve, backwards):
    """At most a quarter each, so that rounding does not turn one into the rest of its circle."""
    pieces = max(1, math.ceil(abs(edge.LastParameter - edge.FirstParameter) / (math.pi / 2) - 1e-9))
    if isinstance(curve, Part.Circle):
        radii, degrees = (curve.Radius, curve.Radius), 0
    else:
        radii = curve.MajorRadius, curve.MinorRadius
        degrees = math.degrees(math.atan2(curve.XAxis.y, curve.XAxis.x))
    sweep = int((curve.Axis.z > 0) != backwards)
    return [("A %r %r %r 0 %d" % (*radii, degrees, sweep), point_text(point))
            for point in edge_points(edge, pieces, backwards)[1:]]


def beziers_of(edge, curve, backwards):
    spline = curve.copy() if isinstance(curve, Part.BSplineCurve) else curve.toBSpline()
    spline.segment(edge.FirstParameter, edge.LastParameter)
    pieces = spline.toBezier()
    if not backwards:
        return pieces
    for piece in pieces:
        piece.reverse()
    return pieces[::-1]


def bezier_segment(piece):
    poles = [point_text(pole) for pole in piece.getPoles()]
    return " ".join([{1: "L", 2: "Q", 3: "C"}[piece.Degree]] + poles[1:-1]), poles[-1]


def global_shape(thing):
    """An object's shape where it stands in the model, also if it is in a part that was moved."""
    shape = Part.getShape(thing)
    if hasattr(thing, "getGlobalPlacement") and hasattr(thing, "Placement"):
        shape = shape.copy()
        shape.Placement = thing.getGlobalPlacement() * thing.Placement.inverse() * shape.Placement
    return shape


def slope_of(face):
    """Whether a face is level, upright, or neither (sloped), in the plane's coordinates."""
    surface = face.Surface
    if isinstance(surface, Part.Plane):
        normal = surface.Axis
        if math.hypot(normal.x, normal.y) < PARALLEL:
            return "level"
        return "upright" if abs(normal.z) < PARALLEL else "sloped"
    axis = None
    if isinstance(surface, Part.Cylinder):
        axis = surface.Axis
    elif isinstance(surface, Part.SurfaceOfExtrusion):
        axis = surface.Direction
    return "upright" if axis and math.hypot(axis.x, axis.y) < PARALLEL else "sloped"


def flat_outlines(shape, tolerance):
    """Of a sketch or a face in the plane: a body through all heights."""
    heights = [vertex.Point.z for vertex in shape.Vertexes]
    if not shape.Wires or max(heights) - min(heights) > SAME:
        raise TautError("there is no solid in it, and no closed outline in the plane")
    outlines = Outlines(tolerance, shape)
    outlines.add_faces(shape.Wires)
    return outlines


def section(shape, height, tolerance):
    """What a plane at this height cuts out of a shape; both in the plane's coordinates."""
    if not shape.Solids:
        return flat_outlines(shape, tolerance)
    outlines = Outlines(tolerance, shape)
    for face in shape.Faces:
        if slope_of(face) == "level" and abs(face.CenterOfMass.z - height) < SAME:
            raise TautError("a face lies in the cutting plane: move the plane a little")
    for solid in shape.Solids:
        outlines.add_faces(solid.slice(UP, height))
    if not outlines.parts:
        box = shape.BoundBox
        raise TautError("the plane does not cut it: it reaches from %.6g mm to %.6g mm" % (box.ZMin, box.ZMax))
    return outlines


def slabs(shape, tolerance):
    """A shape in layers. Between two heights an upright part is its section; sloped faces get their whole shadow.

    So all of the shape is in the outlines, to the tolerance: what is free of them is free of it.
    """
    if not shape.Solids:
        return flat_outlines(shape, tolerance)
    outlines, heights, sloped = Outlines(tolerance, shape), [], []
    for face in shape.Faces:
        if slope_of(face) == "level":
            heights.append(face.CenterOfMass.z)
        elif slope_of(face) == "sloped":
            box = face.BoundBox
            heights += [box.ZMin, box.ZMax]
            sloped.append((face, box.ZMin, box.ZMax))
    heights = distinct(heights)
    for low, high in zip(heights, heights[1:]):
        for solid in shape.Solids:
            outlines.add_faces(solid.slice(UP, (low + high) / 2), (low, high))
        for face, bottom, top in sloped:
            if bottom < high - SAME and top > low + SAME:
                outlines.add_shadow(face, (low, high))
    if sloped:
        outlines.notes.append("%d sloped or rounded faces count with their whole shadow" % len(sloped))
    return outlines


def distinct(heights):
    result = []
    for height in sorted(heights):
        if not result or height - result[-1] > SAME:
            # Faces that lie on each other, but for FreeCAD's own tolerance, are to do so exactly.
            result.append(round(height, 7))
    return result

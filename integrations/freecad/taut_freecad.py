"""FreeCAD: when does a moving solid first meet another one? Works in the program and in freecadcmd."""

import math
import os

import FreeCAD

from taut_command import Rotation, Taut, TautError, answer_in_words, contact_of, instant_of
from taut_sections import PARALLEL, SAME, UP, Plane, global_shape, section, slabs


class Turn(Rotation):
    """A rotation about an axis of the model, by the right hand's rule."""

    def __init__(self, plane, base, axis, degrees):
        if axis.Length < SAME or plane.normal.cross(axis).Length > PARALLEL * axis.Length:
            raise TautError("The axis is not perpendicular to the plane of the motion.")
        point, along = plane.to(base), axis.dot(plane.normal)
        super().__init__((point.x, point.y), math.copysign(degrees, degrees * along))


class Placements:
    """From placement to placement, evenly, as Placement.slerp() goes: the base moves along straight lines."""

    def __init__(self, plane, placements):
        if len(placements) < 2:
            raise TautError("A motion needs two placements.")
        first, self.keyframes, angle = placements[0], [], 0
        self.pivot = plane.to(first.Base)
        for k, placement in enumerate(placements):
            if k > 0:
                angle += turned_by(plane, placements[k - 1], placement)
            way = plane.to(placement.Base) - self.pivot
            if abs(way.z) > SAME:
                raise TautError("The placements are not in one plane of motion: they differ by %.6g mm along its "
                                "normal." % way.z)
            self.keyframes.append({"t": k, "x": way.x, "y": way.y, "angle_deg": angle})
        self.end = len(placements) - 1
        if all(frame["x"] == frame["y"] == frame["angle_deg"] == 0 for frame in self.keyframes):
            raise TautError("The placements are the same.")

    def in_scene(self):
        return {"keyframes": self.keyframes, "pivot": [self.pivot.x, self.pivot.y]}

    def at(self, t):
        k = min(int(t), self.end - 1)
        a, b = self.keyframes[k], self.keyframes[k + 1]
        return [a[key] + (t - k) * (b[key] - a[key]) for key in ("x", "y", "angle_deg")]

    def in_words(self, t):
        x, y, angle = self.at(t)
        return ("%.9g %% of the way (moved by %.6g mm, turned by %.9g degrees)" %
                (100 * t / self.end, math.hypot(x, y), angle))

    def matrix(self, t):
        x, y, degrees = self.at(t)
        cos, sin = math.cos(math.radians(degrees)), math.sin(math.radians(degrees))
        px, py = self.pivot.x, self.pivot.y
        return cos, sin, -sin, cos, px + x - cos * px + sin * py, py + y - sin * px - cos * py


def turned_by(plane, before, after):
    """Degrees about the plane's normal, the shorter way round."""
    turn = after.Rotation * before.Rotation.inverted()
    degrees = math.degrees(turn.Angle)
    if abs(degrees) < 1e-9:
        return 0
    if turn.Axis.cross(plane.normal).Length > 1e-7:
        raise TautError("The placements are turned out of the plane of the motion.")
    degrees = math.copysign(degrees, turn.Axis.dot(plane.normal))
    return degrees - math.copysign(360, degrees) if abs(degrees) > 180 else degrees


class Result:
    """The answer (the object of its JSON), in words, and a picture if one was asked for."""

    def __init__(self, answer, lines, plane, motion, moving, picture):
        self.answer, self.lines, self.plane, self.motion = answer, lines, plane, motion
        self.moving, self.picture = moving, picture
        self.instant = instant_of(answer, motion.end)
        self.points = contact_of(answer)

    def placement(self):
        """By what moving objects are moved at the contact, or at the end of what is proved."""
        a, b, _, _, e, f = self.motion.matrix(self.instant)
        turn = FreeCAD.Rotation(UP, math.degrees(math.atan2(b, a)))
        return self.plane.placement * FreeCAD.Placement(FreeCAD.Vector(e, f, 0), turn) * self.plane.inverse

    def report(self):
        """Writes the answer to the report view."""
        FreeCAD.Console.PrintMessage("\n".join(["taut:"] + self.lines) + "\n")
        if self.picture:
            FreeCAD.Console.PrintMessage("Picture: %s\n" % self.picture)


def first_contact(bodies, moving, motion, plane=None, height=None, tolerance=0.01, clearance=0, fit=0, command="",
                  seconds=60, picture=""):
    """A Result. Throws TautError, with the reason in words.

    bodies     objects of a document; `moving`, some of them, move together by `motion`: a Turn or Placements
    plane      of the motion (XY)
    height     solids are cut there, in mm above the plane; None: they are divided into layers, each with its heights
    tolerance  in mm: curves that scenes do not have become chords that are at most so far away
    clearance  in mm: the distance to keep; 0: they may touch
    fit        in mm: bodies are shrunk by so much to twice as much, for pins in holes of their size
    command    where taut is, if the system does not find it
    picture    the name of a file for an SVG picture of the bodies at the contact
    """
    plane = plane or Plane()
    if len(bodies) < 2 or not moving or all(body in moving for body in bodies):
        raise TautError("Choose bodies that move, and others that they may hit.")
    scene, notes, deviation = {"format": "taut-scene/1", "time": [0, motion.end], "bodies": []}, [], 0
    for body in bodies:
        try:
            shape = plane.shape(global_shape(body))
            outlines = slabs(shape, tolerance) if height is None else section(shape, height, tolerance)
        except TautError as error:
            raise TautError("%s: %s." % (body.Label, error)) from error
        scene["bodies"].append({"name": unique_name(body, bodies), "parts": outlines.parts,
                                "motion": motion.in_scene() if body in moving else None})
        notes += ["%s: %s." % (body.Label, note) for note in outlines.notes]
        deviation = max(deviation, outlines.deviation)
    with Taut(command, seconds) as taut:
        answer = taut.check(scene, clearance, deviation, fit)
        lines = answer_in_words(answer, motion, "mm", clearance) + notes
        if picture:
            picture = os.path.abspath(picture)
            taut.draw(instant_of(answer, motion.end), picture)
    return Result(answer, lines, plane, motion, moving, picture)


def unique_name(body, bodies):
    return body.Label if [other.Label for other in bodies].count(body.Label) == 1 else body.Name


def add_copies(result):
    """Copies of the moving objects at the contact, and the place, as one group; Undo removes them."""
    document = result.moving[0].Document
    document.openTransaction("taut: first contact")
    group = document.addObject("App::DocumentObjectGroup", "TautContact")
    outcome = result.answer["outcome"].replace("_", " ")
    group.Label = "taut: %s after %s" % (outcome, result.motion.in_words(result.instant))
    for body in result.moving:
        ghost = document.addObject("Part::Feature", "TautGhost")
        ghost.Label = body.Label + " at the contact"
        shape = global_shape(body).copy()
        shape.Placement = result.placement() * shape.Placement
        ghost.Shape = shape
        group.addObject(ghost)
        if FreeCAD.GuiUp:
            ghost.ViewObject.ShapeColor, ghost.ViewObject.Transparency = (0.84, 0.16, 0.16), 60
    document.recompute()
    document.commitTransaction()
    return group

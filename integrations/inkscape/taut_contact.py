#!/usr/bin/env python3
"""Inkscape: when does the moving object first meet another selected one? The answer is a new layer."""

import copy
import re
import textwrap

import inkex
from lxml import etree

from taut_boxes import box_around, transform_of
from taut_command import Rotation, Taut, TautError, Translation, answer_in_words, contact_of, instant_of
from taut_selection import centre_of, drawing_of, millimetres, name_of, named, rotation_centre

RED, BLUE = "#d62828", "#1d3557"


class FirstContact(inkex.EffectExtension):
    def add_arguments(self, pars):
        pars.add_argument("--tab")
        pars.add_argument("--moving", default="")
        pars.add_argument("--motion", default="rotation", choices=["rotation", "translation"])
        pars.add_argument("--angle", type=float, default=90)
        pars.add_argument("--pivot", default="centre", choices=["centre", "object", "point"])
        pars.add_argument("--pivot_object", default="")
        pars.add_argument("--pivot_x", type=float, default=0)
        pars.add_argument("--pivot_y", type=float, default=0)
        pars.add_argument("--right", type=float, default=10)
        pars.add_argument("--down", type=float, default=0)
        pars.add_argument("--clearance", type=float, default=0)
        pars.add_argument("--fit", type=float, default=0)
        pars.add_argument("--curves", type=inkex.Boolean, default=True)
        pars.add_argument("--tolerance", type=float, default=0.01)
        pars.add_argument("--open", default="error", choices=["error", "close", "skip"])
        pars.add_argument("--join", type=float, default=0.02)
        pars.add_argument("--seconds", type=int, default=60)
        pars.add_argument("--taut", default="")

    def effect(self):
        try:
            self.add_answer()
        except TautError as error:
            raise inkex.AbortExtension(str(error)) from error

    def add_answer(self):
        # What inkex reads it may write anew, in other words. So all is read from a copy.
        self.copy = inkex.load_svg(etree.tostring(self.svg)).getroot()
        self.copy.selection.set(*self.options.ids)
        # Scenes are in millimetres, with y upwards: a point (x, y) of the drawing is at (mm x, -mm y).
        self.mm = millimetres(self.copy)
        bodies, moving = self.bodies()
        motion = self.motion_of(moving)
        scene, notes, deviation = {"format": "taut-scene/1", "time": [0, motion.end], "bodies": []}, [], 0
        with Taut(self.options.taut, self.options.seconds) as taut:
            for element, name in bodies:
                body, file = self.read(taut, element, name)
                body["motion"] = motion.in_scene() if element in moving else None
                scene["bodies"].append(body)
                notes += notes_about(name, file)
                # Notes may be about curves that became chords.
                if not self.options.curves or file["notes"] or "as_chords" in file:
                    deviation = max(deviation, file["tolerance"] if file["deviation"] > 0 else 0)
            answer = taut.check(scene, self.options.clearance, deviation, self.options.fit)
        lines = answer_in_words(answer, motion, "mm", self.options.clearance)
        if isinstance(motion, Rotation):
            left, top = self.copy.get_viewbox()[:2]
            lines.append("Turned about (%.6g, %.6g) mm on the page." %
                         (motion.pivot[0] - left * self.mm, -motion.pivot[1] - top * self.mm))
        self.add_layer(answer, motion, moving, [element for element, _ in bodies], lines + notes)

    def bodies(self):
        """Pairs of an object and its name, from below to above, and the list of those that move."""
        selected, pivot = list(self.copy.selection.rendering_order()), None
        if self.options.motion == "rotation" and self.options.pivot == "object":
            pivot = named(self.copy, self.options.pivot_object)
        chosen = [element for element in selected if element is not pivot]
        if len(chosen) < 2:
            raise TautError("Select at least two objects: the one that moves, and what it may hit.%s" %
                            (" The pivot's object is no body." if pivot in selected else ""))
        words = [word for word in self.options.moving.split(",") if word.strip()]
        moving = [named(self.copy, word, chosen) for word in words] or [chosen[-1]]
        if all(element in moving for element in chosen):
            raise TautError("All selected objects move. Select what they may hit, too.")
        names = [name_of(element) for element in chosen]
        unique = [name if names.count(name) == 1 else "%s (%s)" % (name, element.get_id())
                  for name, element in zip(names, chosen)]
        return list(zip(chosen, unique)), moving

    def motion_of(self, moving):
        options = self.options
        if options.motion == "translation":
            return Translation(options.right, -options.down, "mm")
        if options.pivot == "point":
            left, top = self.copy.get_viewbox()[:2]
            x, y = left + options.pivot_x / self.mm, top + options.pivot_y / self.mm
        elif options.pivot == "object":
            x, y = centre_of(named(self.copy, options.pivot_object))
        else:
            x, y = rotation_centre(moving[-1])
        return Rotation((x * self.mm, -y * self.mm), options.angle)

    def read(self, taut, element, name):
        """The body of a scene that an object is, and what the report about it says."""
        options, scene = self.options, element.get_id() + ".json"
        words = ["import", taut.write("object.svg", drawing_of(element)), "-o", taut.path(scene), "--json", "--scale",
                 repr(self.mm), "--by", "group", "--open", options.open, "--join", repr(options.join), "--tolerance",
                 repr(options.tolerance)] + (["--curves"] if options.curves else [])
        report = taut.json_of(*words, codes=(0, 2))
        if report["faults"]:
            fault = report["faults"][0]
            # Places in the file that was made of the object say nothing to its author.
            problem = re.sub(r" (at|in) \S*object\.svg(:\d+:\d+)?", "", fault["problem"])
            raise TautError("%s: %s\nHint: %s" % (name, problem, fault["hint"]))
        bodies = taut.read(scene)["bodies"]
        if len(bodies) != 1:
            raise TautError("%s would be %d bodies: select them one by one." % (name, len(bodies)))
        bodies[0]["name"] = name
        return bodies[0], report["files"][0]

    def add_layer(self, answer, motion, moving, bodies, lines):
        t = instant_of(answer, motion.end)
        layer = inkex.Layer.new("taut: %s after %s" % (answer["outcome"].replace("_", " "), motion.in_words(t)))
        a, b, c, d, e, f = motion.matrix(t)
        moved = inkex.Transform((a, -b, -c, d, e / self.mm, -f / self.mm))
        for element in moving:
            layer.append(ghost_of(element, moved))
        boxes = [box_around(element) for element in bodies]
        box = sum(boxes[1:], boxes[0])
        size = max(box.width, box.height) / 30
        points = [(x / self.mm, -y / self.mm) for x, y in contact_of(answer)]
        marks = [inkex.Circle.new(point, size / 2) for point in points]
        if len(points) == 2:
            marks.append(inkex.Line.new(*points))
        for mark in marks:
            mark.style = inkex.Style({"fill": "none", "stroke": BLUE, "stroke-width": "%gpx" % (size / 8)})
            layer.append(mark)
        layer.append(text_of(lines, size, box.left, box.bottom))
        layer.set("id", self.svg.get_unique_id("taut"))
        self.svg.append(layer)


def notes_about(name, file):
    """Lines about what of an object was not taken as it is drawn."""
    lines = ["%s: %s was left out: it %s." % (name, what["what"], what["reason"]) for what in file["skipped"]]
    if file["gaps"]:
        widest = max(gap["width"] for gap in file["gaps"])
        lines.append("%s: %d gaps were closed, the widest %.3g wide." % (name, len(file["gaps"]), widest))
    return lines + [note.replace("body %s: " % name, name + ": ") for note in file["notes"]]


def ghost_of(element, moved):
    """A copy of a body where it meets another one, in red; without the ids, which are the body's."""
    ghost = copy.deepcopy(element)
    ghost.tail = None
    ghost.attrib["transform"] = "matrix(%r %r %r %r %r %r)" % tuple((moved @ transform_of(element)).to_hexad())
    for part, original in zip(ghost.iter(), element.iter()):
        part.attrib.pop("id", None)
        if isinstance(part, inkex.ShapeElement):
            # What is drawn as lines stays lines.
            lines = original.specified_style().get("fill") == "none"
            part.style.update({"stroke": RED} if lines else {"fill": RED, "stroke": "none"})
    ghost.style["opacity"] = "0.45"
    return ghost


def text_of(lines, size, x, y):
    """Lines below a point. Inkscape places them by the first one and their height, other programs one by one."""
    text = inkex.TextElement(x="%.9g" % x, y="%.9g" % (y + 2 * size))
    text.style = inkex.Style({"font-size": "%gpx" % size, "font-family": "sans-serif", "line-height": "1.3",
                              "fill": BLUE, "stroke": "none"})
    for number, line in enumerate(part for line in lines for part in textwrap.wrap(line, 72)):
        span = inkex.Tspan(line)
        span.update(x="%.9g" % x, y="%.9g" % (y + 2 * size + 1.3 * number * size))
        span.set("sodipodi:role", "line")
        text.append(span)
    return text


if __name__ == "__main__":
    FirstContact().run()

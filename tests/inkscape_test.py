#!/usr/bin/python3
"""The extension of Inkscape, as Inkscape runs it, and in Inkscape itself: inkscape_test.py TAUT ROOT [PICTURE]

With PICTURE, only saves a picture of Inkscape with the dialog and an answer. Contacts are compared with closed forms.
Inkscape itself is started where there is xvfb-run.
"""
import math
import os
import random
import re
import shutil
import subprocess
import sys
import tempfile
import unittest

EXTENSIONS = "/usr/share/inkscape/extensions"
sys.path.insert(0, EXTENSIONS)
try:
    import inkex
    from inkex.elements import load_svg
    from lxml import etree
except ImportError as missing:
    print("skipped: no inkex in %s (%s): `./dev integrations` installs Inkscape" % (EXTENSIONS, missing))
    sys.exit(77)

TAUT, ROOT = os.path.abspath(sys.argv[1]), os.path.abspath(sys.argv[2])
FOLDERS = [os.path.join(ROOT, "integrations"), os.path.join(ROOT, "integrations/inkscape")]
sys.path[:0] = FOLDERS
sys.dont_write_bytecode = True
from taut_boxes import box_around  # noqa: E402

HEAD = ('<svg xmlns="http://www.w3.org/2000/svg" xmlns:svg="http://www.w3.org/2000/svg" '
        'xmlns:xlink="http://www.w3.org/1999/xlink" '
        'xmlns:inkscape="http://www.inkscape.org/namespaces/inkscape" '
        'xmlns:sodipodi="http://sodipodi.sourceforge.net/DTD/sodipodi-0.dtd" %s>')
PAGE = 'width="120mm" height="100mm" viewBox="0 0 120 100"'


def drawing(content, page=PAGE):
    return HEAD % page + content + "</svg>"


class Run:
    """What the extension makes of a drawing and a selection."""

    def __init__(self, svg, ids, **options):
        words = ["--id=" + one for one in ids] + ["--%s=%s" % (key, value) for key, value in options.items()]
        if "taut" not in options:
            words.append("--taut=" + TAUT)
        environment = dict(os.environ, PYTHONPATH=os.pathsep.join([EXTENSIONS, *FOLDERS]), PYTHONDONTWRITEBYTECODE="1")
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "drawing.svg")
            with open(path, "w", encoding="utf-8") as file:
                file.write(svg)
            done = subprocess.run(["/usr/bin/python3", os.path.join(FOLDERS[1], "taut_contact.py"), *words, path],
                                  env=environment, stdout=subprocess.PIPE, stderr=subprocess.PIPE)
        self.code, self.error, self.svg = done.returncode, done.stderr.decode().strip(), None
        if done.stdout:
            self.svg = load_svg(done.stdout.decode()).getroot()
            self.layer = self.svg[-1]
            self.words = " ".join("".join(span.itertext()) for span in self.layer.iter("{*}tspan"))
            self.marks = [tuple(mark.center) for mark in self.layer if isinstance(mark, inkex.Circle)
                          and mark.get("id") is None and mark.style.get("fill") == "none"]

    def number(self):
        """The angle or the way after which it happens."""
        return float(re.search(r"after ([0-9.e+-]+)", self.words).group(1))


# A lever of length 50 and half width 5 that stands upright on its pivot turns clockwise against a wall 55 to its right.
LEVER = ('<g inkscape:groupmode="layer" inkscape:label="Parts" id="layer1" %s>'
         '<rect id="wall" x="80" y="5" width="5" height="75" fill="#457b9d"/>'
         '<circle id="pivot" cx="40" cy="60" r="1" fill="none" stroke="black"/>'
         '<rect id="lever" x="35" y="10" width="10" height="50" fill="#e9c46a" inkscape:label="the lever" '
         'inkscape:transform-center-x="0" inkscape:transform-center-y="-25"/></g>')
LEVER_ANGLE = math.degrees(math.asin(40 / math.hypot(50, 5)) - math.atan2(5, 50))
LEVER_POINT = (80, 60 - (math.hypot(50, 5) ** 2 - 40 ** 2) ** 0.5)


class Contacts(unittest.TestCase):
    def test_a_lever_meets_a_wall_on_pages_of_all_kinds(self):
        for page in (PAGE, 'width="240" height="200" viewBox="0 0 120 100"', 'viewBox="-7 3 120 100"', "",
                     'width="120mm" height="400mm" viewBox="0 0 120 100"', 'width="100%" viewBox="0 0 9 9"'):
            run = Run(drawing(LEVER % "", page), ["lever", "wall"], angle=-90)
            self.assertEqual(run.code, 0, run.error)
            self.assertAlmostEqual(run.number(), LEVER_ANGLE, places=6, msg=page)
            self.assertIn("CONTACT: wall and the lever meet after", run.words)
            self.assertIn("degrees clockwise", run.words)
            self.assertIn("It is proved that before this no bodies collide.", run.words)
            self.assertAlmostEqual(run.marks[0][0], LEVER_POINT[0], places=6)
            self.assertAlmostEqual(run.marks[0][1], LEVER_POINT[1], places=6)

    def test_the_copy_stands_at_the_contact(self):
        run = Run(drawing(LEVER % 'transform="translate(3 1) scale(0.5)"'), ["lever", "wall"], angle=-90)
        ghost = next(one for one in run.layer if one.TAG == "rect")
        corner = inkex.Transform(ghost.attrib.get("transform")).apply_to_point((45, 10))
        self.assertLess(math.dist(corner, run.marks[0]), 1e-6)

    def test_pivots(self):
        svg = drawing(LEVER % "")
        for options in (dict(pivot="object", pivot_object="pivot"), dict(pivot="point", pivot_x=40, pivot_y=60),
                        dict(pivot="centre")):
            for ids in (["lever", "wall"], ["lever", "wall", "pivot"]):
                if "pivot" in ids and options["pivot"] != "object":
                    continue
                self.assertAlmostEqual(Run(svg, ids, angle=-90, **options).number(), LEVER_ANGLE, places=6)
        moved = drawing(LEVER % "", 'width="240mm" height="200mm" viewBox="-10 -20 120 100"')
        run = Run(moved, ["lever", "wall"], angle=-90, pivot="point", pivot_x=100, pivot_y=160)
        self.assertAlmostEqual(run.number(), LEVER_ANGLE, places=6)
        self.assertIn("Turned about (100, 160) mm on the page.", run.words)

    def test_groups_with_transforms_and_the_other_direction(self):
        mirrored = drawing(LEVER % 'transform="translate(120 0) scale(-1 1)"')
        options = dict(pivot="object", pivot_object="pivot")
        run = Run(mirrored, ["lever", "wall"], angle=90, **options)
        self.assertAlmostEqual(run.number(), LEVER_ANGLE, places=6)
        self.assertIn("degrees counterclockwise", run.words)
        turned = drawing('<g transform="translate(10 20)"><g transform="rotate(33) scale(0.5)">%s</g></g>' % LEVER % "")
        self.assertAlmostEqual(Run(turned, ["lever", "wall"], angle=-90, **options).number(), LEVER_ANGLE, places=6)

    def test_an_arc_meets_a_wall(self):
        """A disc of radius 6 that goes around a point 30 away meets a wall 20 beyond it."""
        svg = drawing('<rect id="wall" x="70" y="5" width="5" height="90"/><circle id="disc" cx="50" cy="20" r="6"/>')
        expected = math.degrees(math.asin((20 - 6) / 30))
        options = dict(angle=-90, pivot="point", pivot_x=50, pivot_y=50)
        run = Run(svg, ["wall", "disc"], **options)
        self.assertAlmostEqual(run.number(), expected, places=6)
        self.assertIn("the curves themselves", run.words)
        chords = Run(svg, ["wall", "disc"], curves="false", **options)
        self.assertIn("at most 0.01 mm away: this is about the chords", chords.words)
        # Chords lie within the disc: they come later, by as much as the disc sinks in by 0.01 mm.
        later = math.degrees(math.asin((20 - 6 + 0.01) / 30))
        self.assertTrue(expected - 1e-9 <= chords.number() <= later + 1e-9, chords.number())

    def test_chords_are_free_for_the_curves_only_with_room(self):
        """A disc passes a wall at 0.015 mm, and at 0.025 mm: more than what chords 0.01 mm away leave open."""
        for room, kept in ((0.015, False), (0.025, True)):
            svg = drawing('<rect id="wall" x="0" y="50" width="100" height="5"/>'
                          '<circle id="disc" cx="20" cy="%r" r="10"/>' % (40 - room))
            run = Run(svg, ["wall", "disc"], curves="false", motion="translation", right=60)
            self.assertIn("FREE: no bodies collide up to 60 mm", run.words)
            self.assertIn("so free holds for the curves" if kept else "the curves may collide", run.words)
            exact = Run(svg, ["wall", "disc"], motion="translation", right=60)
            self.assertIn("FREE", exact.words)

    def test_clearance(self):
        """A disc falls onto a plate: 20 - 6 of way, and 3 less if it is to keep 3 mm."""
        svg = drawing('<rect id="plate" x="0" y="50" width="100" height="5"/><circle id="disc" cx="50" cy="30" r="6"/>')
        self.assertAlmostEqual(Run(svg, ["plate", "disc"], motion="translation", right=0, down=40).number(), 14, places=5)
        run = Run(svg, ["plate", "disc"], motion="translation", right=0, down=40, clearance=3)
        self.assertAlmostEqual(run.number(), 11, places=5)
        self.assertEqual(len(run.marks), 2)
        self.assertAlmostEqual(abs(run.marks[0][1] - run.marks[1][1]), 3, places=5)
        run = Run(svg, ["plate", "disc"], motion="translation", right=0, down=40, clearance=15)
        self.assertIn("CLOSER AT THE START: as they are drawn, plate and disc are 14 mm apart", run.words)

    def test_parts_that_fit_exactly(self):
        """A ring turns about a disc of the size of its hole."""
        svg = drawing('<circle id="pin" cx="50" cy="50" r="5"/><path id="ring" fill-rule="evenodd" d="M 40 40 H 60 V 60 H 40 Z '
                      'M 55 50 A 5 5 0 0 0 45 50 A 5 5 0 0 0 55 50 Z"/>')
        options = dict(pivot="point", pivot_x=50, pivot_y=50)
        self.assertIn("UNDECIDED: curves touch", Run(svg, ["pin", "ring"], **options).words)
        run = Run(svg, ["pin", "ring"], fit=0.001, **options)
        self.assertIn("FREE", run.words)
        self.assertIn("All this is about bodies shrunk by 0.001 to 0.002 mm.", run.words)

    def test_outcomes_without_a_contact(self):
        svg = drawing(LEVER % "")
        free = Run(svg, ["lever", "wall"], angle=90)
        self.assertIn("FREE: no bodies collide up to 90 degrees counterclockwise", free.words)
        overlap = Run(drawing('<rect id="a" x="0" y="0" width="9" height="9"/><rect id="b" x="5" y="5" width="9" height="9"/>'),
                      ["a", "b"])
        self.assertIn("OVERLAP AT THE START: a and b overlap", overlap.words)
        x, y = overlap.marks[0]
        self.assertTrue(5 <= x <= 9 and 5 <= y <= 9)

    def test_several_move_and_several_rest(self):
        """Two blocks fall together onto the higher one of two steps: 30 of way."""
        svg = drawing('<rect id="low" x="0" y="60" width="20" height="5"/><rect id="high" x="30" y="40" width="20" height="5"/>'
                      '<rect id="a" x="0" y="5" width="10" height="5"/><rect id="b" x="35" y="5" width="10" height="5"/>')
        run = Run(svg, ["low", "high", "a", "b"], motion="translation", right=0, down=80, moving="a, b")
        self.assertAlmostEqual(run.number(), 30, places=9)
        self.assertIn("CONTACT: high and b meet", run.words)
        self.assertIn("Pairs that were not tested: 1 moving alike, 1 at rest.", run.words)
        self.assertEqual(sum(one.TAG == "rect" for one in run.layer), 2)

    def test_clones_and_style_sheets(self):
        svg = drawing('<style>.hollow { fill: none; stroke: black }</style>'
                      '<g><path id="frame" class="hollow" d="M 0 50 H 100 V 55 H 0 Z"/></g>'
                      '<rect id="tile" x="0" y="0" width="8" height="4"/>'
                      '<use id="clone" xlink:href="#tile" x="10" y="10" transform="scale(2)"/>')
        run = Run(svg, ["frame", "clone"], motion="translation", right=0, down=40)
        self.assertAlmostEqual(run.number(), 50 - 2 * 14, places=9)

    def test_nothing_but_a_layer_is_added(self):
        svg = drawing(LEVER % 'style="opacity:0.9"')
        run = Run(svg, ["lever", "wall"], angle=-90)
        self.assertEqual(run.layer.get("inkscape:groupmode"), "layer")
        ids = [one.get("id") for one in run.svg.iter() if one.get("id")]
        self.assertEqual(len(ids), len(set(ids)))
        run.svg.remove(run.layer)
        before = load_svg(svg).getroot()
        self.assertEqual([(one.tag, dict(one.attrib)) for one in run.svg.iter()],
                         [(one.tag, dict(one.attrib)) for one in before.iter()])


    def test_the_example(self):
        """The lever's side, 5 beside its pin, meets a disc of radius 6 whose centre is 50 away."""
        with open(os.path.join(ROOT, "examples/import/lever.svg"), encoding="utf-8") as file:
            run = Run(file.read().split("?>", 1)[1], ["stop", "lever"], angle=-90, pivot="object", pivot_object="pin")
        self.assertAlmostEqual(run.number(), math.degrees(math.atan2(30, 40) - math.asin(11 / 50)), places=6)
        text = next(run.layer.iter("{*}text"))
        self.assertEqual((text.get("x"), text.get("y")), (text[0].get("x"), text[0].get("y")))


class Errors(unittest.TestCase):
    SVG = drawing('<rect id="plate" x="0" y="50" width="100" height="5"/><rect id="block" x="0" y="0" width="5" height="5"/>'
                  '<path id="open" d="M 20 20 H 30 V 30" fill="none" stroke="black"/><text id="text">abc</text><g id="empty"/>'
                  '<rect id="twice" inkscape:label="plate" x="50" y="0" width="5" height="5"/><image id="image" href="x.png"/>'
                  '<symbol><rect id="hidden" width="5" height="5"/></symbol>')

    def fails(self, ids, message, **options):
        run = Run(self.SVG, ids, **options)
        self.assertNotEqual(run.code, 0)
        self.assertIsNone(run.svg)
        self.assertIn(message, run.error)
        self.assertNotIn("Traceback", run.error)
        self.assertNotIn("object.svg", run.error)

    def test_selection(self):
        self.fails([], "Select at least two objects")
        self.fails(["plate"], "Select at least two objects")
        self.fails(["plate", "block"], "The pivot's object is no body", pivot="object", pivot_object="block")
        self.fails(["plate", "block"], "All selected objects move", moving="plate,block")
        self.fails(["plate", "block"], 'No object among the selected objects is called "nothing"', moving="nothing")
        self.fails(["plate", "block", "twice"], '2 objects among the selected objects are called', moving="plate")
        self.fails(["plate", "block"], "Name the object whose centre is the pivot", pivot="object")

    def test_shapes(self):
        self.fails(["plate", "text"], "text: nothing in the file encloses an area; skipped: <text> is text",
                   motion="translation")
        self.fails(["plate", "open"], "the line is open", motion="translation")
        self.fails(["plate", "image"], "<image> is no path or basic shape", motion="translation")
        self.fails(["plate", "empty"], "there is nothing in it")
        self.fails(["plate", "hidden"], "select objects of the page", motion="translation")
        closed = Run(self.SVG, ["plate", "open"], motion="translation", right=0, down=90, open="close")
        self.assertAlmostEqual(closed.number(), 20, places=9)

    def test_motion(self):
        self.fails(["plate", "block"], "The angle must be", angle=0)
        self.fails(["plate", "block"], "The distance must be", motion="translation", right=0, down=0)

    def test_command(self):
        self.fails(["plate", "block"], "is not the command taut", taut="/nowhere/taut")
        self.fails(["plate", "block"], "is not the command taut", taut=__file__)
        self.fails(["plate", "block"], "/bin/true ended with exit code 0", taut="/bin/true")


class Dialog(unittest.TestCase):
    INX = etree.parse(os.path.join(FOLDERS[1], "taut_contact.inx"))

    def test_is_as_inkscape_wants_it(self):
        schema = etree.RelaxNG(etree.parse(os.path.join(EXTENSIONS, "inkscape.extension.rng")))
        self.assertTrue(schema.validate(self.INX), schema.error_log)

    def test_has_what_the_extension_takes(self):
        """The same names, and the same values if nothing is entered."""
        from taut_contact import FirstContact
        known = vars(FirstContact().arg_parser.parse_args([]))
        offered = {}
        for param in self.INX.iter("{*}param"):
            options = [option.get("value") for option in param.iter("{*}option")]
            offered[param.get("name")] = options[0] if options else (param.text or "").strip()
        del offered["tab"]
        self.assertEqual(set(offered), set(known) - {"tab", "ids", "selected_nodes", "input_file", "output"})
        for name, value in offered.items():
            kind = type(known[name])
            self.assertEqual(value == "true" if kind is bool else kind(value), known[name], name)


class Boxes(unittest.TestCase):
    def test_arcs(self):
        """Arcs made from centres, radii and angles; the box is that of many of their points, but for their distances."""
        rng = random.Random(4)
        for _ in range(200):
            cx, cy, rx, ry, turn = (rng.uniform(*ends) for ends in ((-9, 9), (-9, 9), (1, 9), (1, 9), (0, math.pi)))
            begin, way = rng.uniform(0, 7), rng.uniform(-6.2, 6.2)

            def at(t):
                u, v = rx * math.cos(begin + t * way), ry * math.sin(begin + t * way)
                return (cx + math.cos(turn) * u - math.sin(turn) * v, cy + math.sin(turn) * u + math.cos(turn) * v)

            path = "M %r %r A %r %r %r %d %d %r %r" % (*at(0), rx, ry, math.degrees(turn), abs(way) > math.pi, way > 0, *at(1))
            outer = "rotate(%r) scale(1 %r)" % (rng.uniform(0, 360), rng.uniform(0.3, 3))
            group = load_svg(drawing('<g transform="%s"><path d="%s"/></g>' % (outer, path))).getroot()[0]
            points = [inkex.Transform(outer).apply_to_point(at(i / 2000)) for i in range(2001)]
            box = box_around(group)
            for end, found in ((box.left, min(p.x for p in points)), (box.right, max(p.x for p in points)),
                               (box.top, min(p.y for p in points)), (box.bottom, max(p.y for p in points))):
                self.assertAlmostEqual(end, found, delta=2e-4)


def profile_in(folder):
    """The environment of an Inkscape that has the extension, and finds taut."""
    for inner in ("extensions", "bin"):
        os.makedirs(os.path.join(folder, inner), exist_ok=True)
    for source in FOLDERS:
        for name in os.listdir(source):
            if name.endswith((".py", ".inx")):
                shutil.copy(os.path.join(source, name), os.path.join(folder, "extensions"))
    if not os.path.exists(os.path.join(folder, "bin/taut")):
        os.symlink(TAUT, os.path.join(folder, "bin/taut"))
    return dict(os.environ, INKSCAPE_PROFILE_DIR=folder, PATH=os.path.join(folder, "bin") + ":/usr/bin:/bin")


# What a user does: selects, opens the dialog, and presses Apply. Preferences hold what was entered.
PREFERENCES = """<inkscape version="1"><group id="theme" preferDarkTheme="0" darkTheme="0"/>
<group id="extensions" taut.first-contact.angle="-90" taut.first-contact.pivot="object" taut.first-contact.pivot_object="pin"/>
</inkscape>"""
STEPS = """
inkscape --with-gui --actions="select-by-id:stop,lever;taut.first-contact" "$1" >/dev/null 2>&1 &
inkscape=$!
dialog=$(timeout 20 xdotool search --sync --onlyvisible --name "First Contact")
window=$(xdotool search --onlyvisible --name lever.svg | head -n 1)
xdotool windowsize $window 1660 860 windowmove $window 0 0; sleep 1
xdotool windowmove $dialog 1125 150; sleep 1
xdotool mousemove --window $dialog 480 537 click 1; sleep 3
xdotool mousemove 300 700 windowfocus $window key --window $window 5; sleep 2
import -window root "$2"
kill $inkscape
"""


def save_picture(picture):
    with tempfile.TemporaryDirectory() as folder:
        environment = profile_in(folder)
        with open(os.path.join(folder, "preferences.xml"), "w", encoding="utf-8") as file:
            file.write(PREFERENCES)
        subprocess.run(["xvfb-run", "-a", "-s", "-screen 0 1660x860x24", "bash", "-c", STEPS, "bash",
                        os.path.join(ROOT, "examples/import/lever.svg"), picture], env=environment, timeout=120, check=True)


@unittest.skipUnless(shutil.which("inkscape"), "no Inkscape")
class Inkscape(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.addCleanup(self.folder.cleanup)

    def path(self, name):
        return os.path.join(self.folder.name, name)

    def run_inkscape(self, svg, actions, *words):
        """The drawing after the actions."""
        with open(self.path("in.svg"), "w", encoding="utf-8") as file:
            file.write(svg)
        environment = profile_in(self.folder.name)
        done = subprocess.run([*words, "--actions=%s;export-filename:%s;export-do" % (actions, self.path("out.svg")),
                               self.path("in.svg")], env=environment, stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
                              timeout=120)
        self.assertTrue(os.path.exists(self.path("out.svg")), done.stdout.decode())
        with open(self.path("out.svg"), "rb") as file:
            return load_svg(file.read()).getroot()

    def test_rotation_centre_is_the_cross(self):
        """Inkscape turns the lever about its cross; the extension's copy of it at the end of its motion is there."""
        svg = drawing('<rect id="wall" x="300" y="5" width="5" height="75"/><g transform="translate(5 2) scale(2)">'
                      '<path id="lever" d="M 20 20 H 50 A 5 5 0 0 1 50 30 H 20 Z" inkscape:transform-center-x="3" '
                      'inkscape:transform-center-y="7"/></g>', 'width="120mm" height="100mm" viewBox="-5 -7 240 200"')
        turned = self.run_inkscape(svg, "select-by-id:lever;transform-rotate:-30", "inkscape").getElementById("lever")
        run = Run(svg, ["wall", "lever"], angle=30)
        ghost = next(one for one in run.layer if one.TAG == "path")
        for end in ("left", "right", "top", "bottom"):
            self.assertAlmostEqual(getattr(box_around(turned), end), getattr(box_around(ghost), end), delta=2e-3)

    @unittest.skipUnless(shutil.which("xvfb-run"), "no xvfb-run: extensions need a screen in Inkscape 1.2")
    def test_in_the_program(self):
        """With what the dialog offers: 90 degrees counterclockwise about the cross. Undo removes the layer."""
        svg = drawing('<g transform="translate(120 0) scale(-1 1)">%s</g>' % LEVER % "")
        words = ["xvfb-run", "-a", "inkscape", "--with-gui", "--batch-process"]
        made = self.run_inkscape(svg, "select-by-id:wall,lever;taut.first-contact.noprefs", *words)
        text = " ".join("".join(span.itertext()) for span in made.iter("{*}tspan"))
        self.assertAlmostEqual(float(re.search(r"after ([0-9.]+)", text).group(1)), LEVER_ANGLE, places=6)
        self.assertEqual(made[-1].get("inkscape:groupmode"), "layer")
        undone = self.run_inkscape(svg, "select-by-id:wall,lever;taut.first-contact.noprefs;undo", *words)
        self.assertEqual([one for one in undone.iter("{*}tspan")], [])
        self.assertIsNotNone(undone.getElementById("lever"))


if __name__ == "__main__":
    if len(sys.argv) > 3:
        save_picture(os.path.abspath(sys.argv[3]))
        sys.exit()
    unittest.main(argv=sys.argv[:1])

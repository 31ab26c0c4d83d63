import base64
import dataclasses
import math
import pathlib
import re
import subprocess
import sys
from xml.etree import ElementTree

import pytest
import taut2d
from taut2d import Body, InputError, Keyframes, Part, Scene

matplotlib = pytest.importorskip("matplotlib")
numpy = pytest.importorskip("numpy")
matplotlib.use("Agg")
from matplotlib import pyplot  # noqa: E402

root = pathlib.Path(__file__).resolve().parents[2]
LINK = [(-1, -1), (11, -1), (11, 1), (-1, 1)]
SHELF = Part([(-9, 12), (30, 12), (30, 30), (-9, 30)], [[(20, 20), (25, 20), (22, 25)]])
ARM = Scene([Body("upper", LINK, Keyframes([(0, 0, 0, 0), (1, 0, 0, 90)])),
             Body("lower", LINK, Keyframes([(0, 10, 0, 0), (1, 10, 0, 45)]), "upper"), Body("shelf", SHELF)],
            (0, 1), [("upper", "lower")])


@pytest.fixture(autouse=True)
def figures_are_closed():
    yield
    pyplot.close("all")


def colour_at(axes, x, y):
    """What is seen at a point of the picture."""
    canvas = axes.figure.canvas
    canvas.draw()
    column, row = axes.transData.transform((x, y))
    return tuple(numpy.asarray(canvas.buffer_rgba())[-1 - int(row), int(column)][:3])


def test_poses_are_those_of_the_chain():
    poses = ARM.poses(0.5)
    c, s = math.cos(math.pi / 4), math.sin(math.pi / 4)
    assert poses["upper"] == pytest.approx((0, 0, c, s))
    assert poses["lower"] == pytest.approx((10 * c, 10 * s, math.cos(math.radians(67.5)), math.sin(math.radians(67.5))))
    assert poses["shelf"] == (0, 0, 1, 0)


def test_poses_put_the_vertex_where_the_contact_is():
    for path in sorted((root / "examples").glob("*.json")):
        scene = Scene.load(path)
        contact = taut2d.check(scene).contact
        if contact is None:
            continue
        x, y, cos, sin = scene.poses(contact.t[0])[contact.vertex.body]
        shape = next(b.shape for b in scene.bodies if b.name == contact.vertex.body)
        if isinstance(shape, Part):
            u, v = shape.outline[contact.vertex.index]
            size = max(map(abs, (u, v, x, y)))
            assert (x + u * cos - v * sin, y + u * sin + v * cos) == pytest.approx(contact.point, abs=1e-9 * size)


def test_a_picture_has_bodies_and_holes_where_they_are():
    axes = ARM.plot(at=0)
    assert axes.get_title() == "t = 0" and axes.get_aspect() == 1
    assert [t.get_text() for t in axes.get_legend().get_texts()] == ["upper", "lower", "shelf"]
    white, shelf, upper = colour_at(axes, 22, 21), colour_at(axes, 28, 25), colour_at(axes, 4, 0.5)
    assert white == (255, 255, 255) and shelf != white and upper not in (white, shelf)
    later = ARM.plot(at=0.9)
    assert colour_at(later, 10, -0.5) == white


def test_holes_are_left_out_whichever_way_they_turn():
    square, hole = [(0, 0), (9, 0), (9, 9), (0, 9)], [(3, 3), (6, 3), (6, 6), (3, 6)]
    for outline in (square, square[::-1]):
        for inner in (hole, hole[::-1]):
            axes = Scene([Body("a", Part(outline, [inner])), Body("b", [(20, 0), (21, 0), (20, 1)])], (0, 1)).plot()
            assert colour_at(axes, 4.5, 4.5) == (255, 255, 255) != colour_at(axes, 1.5, 1.5)


def test_contacts_and_overlaps_are_marked():
    answer = taut2d.check(ARM)
    for at in (answer, answer.contact):
        axes = ARM.plot(at=at)
        assert axes.get_title() == f"t = {answer.contact.t[0]:.6g}"
        assert tuple(axes.lines[0].get_xydata()[0]) == answer.contact.point
        assert colour_at(axes, *answer.contact.point) == (0xd7, 0x19, 0x1c)
    assert not ARM.plot(at=0.1).lines
    deep = Scene([Body("a", LINK), Body("b", SHELF), Body("c", LINK)], (0, 1)).with_motion(
        "c", Keyframes([(0, 5, 0, 0), (1, 9, 0, 0)]))
    answer = taut2d.check(deep)
    assert answer.outcome == "overlap_at_start"
    assert len(deep.plot(at=answer).lines) == (answer.overlap_point is not None)
    free = Scene([Body("a", LINK, taut2d.Velocity((0, -1))), Body("b", SHELF)], (0, 3))
    assert free.plot(at=taut2d.check(free)).get_title() == "t = 3"


def test_axes_of_ones_own_are_drawn_into():
    figure, axes = pyplot.subplots(1, 2)
    axes[0].plot([100], [200], "o")
    assert ARM.plot(axes[0]) is axes[0] and not axes[1].patches
    assert axes[0].get_xlim()[1] > 100 and axes[0].get_ylim()[1] > 200


def test_an_animation_ends_with_the_contact(tmp_path):
    answer = taut2d.check(ARM)
    figure, axes = pyplot.subplots()
    animation = ARM.animate(axes, answer, frames=5, seconds=1)
    animation.save(tmp_path / "arm.gif", writer="pillow")
    assert (tmp_path / "arm.gif").stat().st_size > 1000
    seen = []
    for k in range(5):
        animation._func(k)
        seen.append((axes.get_title(), colour_at(axes, *answer.contact.point) == (0xd7, 0x19, 0x1c)))
    assert [marked for _, marked in seen] == [False] * 4 + [True]
    assert seen[0][0] == "t = 0" and seen[4][0] == f"t = {answer.contact.t[0]:.6g}"
    low, high = axes.get_ylim()
    assert low <= -1 and high >= 30


@pytest.mark.parametrize("call, message", [
    (lambda: ARM.plot(at=2), r"at: 2.0 is outside of the scene's time, \[0.0, 1.0\]"), (lambda: ARM.poses(-1), "at: -1.0 is"),
    (lambda: ARM.plot(at="now"), "at: expected a number"), (lambda: ARM.animate(frames=1), "frames: 1 are too few"),
    (lambda: Scene([Body("a", LINK, None, "b"), Body("c", LINK)], (0, 1)).plot(), "a: there is no body"),
    (lambda: Scene([Body("bow", [(0, 0), (1, 1), (1, 0), (0, 1)])], (0, 1)).plot(), "bow: the boundary is not simple")])
def test_what_cannot_be_drawn(call, message):
    with pytest.raises(InputError, match=message):
        call()


def square(x, y):
    return [(x, y), (x + 1, y), (x + 1, y + 1), (x, y + 1)]


# One falls through "a" from t = 4 to 6, the other one rises.
THREE = Scene([Body("a", square(0, 0)), Body("b", square(0, 5), taut2d.Velocity((0, -1))),
               Body("c", square(9, 3), taut2d.Velocity((0, 1)))], (0, 10))


def labels(axes):
    return [text.get_text() for text in axes.get_yticklabels()]


def test_a_chart_of_intervals():
    axes = taut2d.intervals(THREE).plot()
    assert labels(axes) == ["a x b"] and axes.get_xlim() == (0, 10) and axes.get_xlabel() == "t"
    seen = {x: colour_at(axes, x, 0) == (0xd7, 0x19, 0x1c) for x in (3.9, 4.1, 5.9, 6.1)}
    assert seen == {3.9: False, 4.1: True, 5.9: True, 6.1: False}
    gears = taut2d.intervals(Scene.load(root / "examples" / "gears.json"), max_seconds=0).plot()
    assert labels(gears) == ["wheel x pinion"]
    assert [text.get_text() for text in gears.get_legend().get_texts()] == ["undecided"]
    assert taut2d.intervals(THREE.with_motion("b", taut2d.Velocity((0, 2)))).plot().get_title() == "no overlap"


def test_charts_say_what_was_not_tested():
    two_at_rest = THREE.with_motion("b", None)
    untested = "not tested: 1 of 3 pairs (1 at rest)"
    assert taut2d.intervals(two_at_rest).plot().get_title() == f"no overlap of the tested pairs\n{untested}"
    assert taut2d.distance_profile(two_at_rest, 3).plot().get_title() == untested
    assert taut2d.clearance(two_at_rest).plot().get_title() == untested


def test_a_chart_of_distances():
    profile = taut2d.distance_profile(THREE, 21, pairs="all")
    figure, axes = pyplot.subplots(1, 2)
    assert profile.plot(axes[1]) is axes[1] and not axes[0].lines
    assert [text.get_text() for text in axes[1].get_legend().get_texts()] == \
        ["least of all pairs", *(" x ".join(curve.pair) for curve in profile.curves[1:])]
    for line, curve in zip(axes[1].lines, profile.curves):
        assert [tuple(p) for p in line.get_xydata()] == [(t, hi) for t, _, hi in curve.instants]
    assert len(axes[1].collections) == len(profile.curves) and axes[1].get_ylim()[0] == 0


def test_a_chart_of_clearances():
    found = taut2d.clearance(THREE, pairs="all")
    axes = found.plot()
    assert labels(axes) == [" x ".join(pair.pair) for pair in found.pairs]
    assert [bar.get_width() for bar in axes.patches] == [pair.lo for pair in found.pairs]
    apart = taut2d.clearance(THREE.with_motion("b", taut2d.Velocity((0, 1))))
    axes = apart.plot()
    assert labels(axes) == [" x ".join(apart.nearest.pair)] and axes.get_xlim()[1] >= apart.distance[1]


def test_a_chart_makes_a_figure_of_its_own():
    figure, axes = pyplot.subplots()
    link = taut2d.Linkage([Body("a", square(0, 0)), Body("b", square(3, 0), taut2d.Slide((1, 0), by="x"), None),
                           Body("c", square(0, 3), taut2d.Slide((0, 1), by="y"))], {"x": (0, 1), "y": (0, 1)})
    for answer in (taut2d.intervals(THREE), taut2d.clearance(THREE), taut2d.distance_profile(THREE, 3),
                   taut2d.envelope(link, cells=True)):
        assert answer.plot().figure is not figure
    assert not axes.collections and not axes.patches and not axes.lines


def test_there_is_no_chart_without_an_answer():
    nothing = Scene(THREE.bodies, (0, 10), [("a", "*"), ("b", "c")])
    for answer in (taut2d.intervals(nothing), taut2d.clearance(nothing), taut2d.distance_profile(nothing, 3)):
        with pytest.raises(InputError, match="there is nothing to draw: the answer is untested"):
            answer.plot()


def svg_in(page):
    """The picture that a page holds, as a tree of elements."""
    return ElementTree.fromstring(base64.b64decode(re.search(r'src="data:image/svg\+xml;base64,([^"]*)"', page)[1]))


def text_in(svg):
    return " ".join(filter(None, (e.text for e in svg.iter())))


def test_notebooks_show_the_motion():
    svg = svg_in(ARM._repr_html_())
    assert svg.tag.endswith("svg") and any("animate" in e.tag for e in svg.iter())
    assert all(name in text_in(svg) for name in ("upper", "lower", "shelf")) and "contact" not in text_in(svg)
    answer = taut2d.check(ARM)
    page = answer._repr_html_()
    assert page.startswith("<div><b>contact at t = 0.28635</b>: lower &times; shelf<br/>vertex 2 of lower meets edge 0 of "
                           f"shelf, t in [{answer.contact.t[0]!r}, {answer.contact.t[1]!r}]</div>")
    assert "contact at t = 0.28635" in text_in(svg_in(page))


def test_notebooks_show_every_outcome():
    free = Scene([Body("a<b", LINK, taut2d.Velocity((0, -1))), Body("shelf", SHELF)], (0, 3))
    assert taut2d.check(free)._repr_html_().startswith("<div><b>free</b></div><img")
    overlap = taut2d.check(free.with_motion("a<b", Keyframes([(0, 0, 13, 0)])))
    assert overlap._repr_html_().startswith("<div><b>overlap at the start</b>: a&lt;b &times; shelf</div><img")
    limit = taut2d.check(Scene.load(root / "examples" / "gears.json"), max_events=5)
    assert re.match(r"<div><b>undecided from t = 0\.\d+</b>.*the limit of 5 events was reached</div><img", limit._repr_html_())
    bow = Scene([Body("bow", [(0, 0), (1, 1), (1, 0), (0, 1)])], (0, 1))
    assert bow._repr_html_().startswith("<pre>InputError: bow: the boundary is not simple")
    assert dataclasses.replace(limit, scene=None)._repr_html_().endswith("</div>")
    assert svg_in(taut2d.check(Scene([Body("a", LINK), Body("b", SHELF)], (1, 1)))._repr_html_()) is not None


def test_without_matplotlib_an_error_says_what_is_missing():
    program = ("import sys; sys.modules['matplotlib'] = None\nimport taut2d\n"
               "scene = taut2d.Scene([taut2d.Body('a', [(0, 0), (1, 0), (0, 1)])], (0, 1))\nscene.poses(0)\nscene.plot()")
    run = subprocess.run([sys.executable, "-c", program], stderr=subprocess.PIPE, text=True)
    assert run.stderr.rstrip().endswith("matplotlib, which is not installed: on Debian, python3-matplotlib")

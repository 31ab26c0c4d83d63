"""Polygons for curves."""

import math
import pathlib
import subprocess

import pytest
import taut2d
from taut2d import Body, InputError, Part, Path, Scene

root = pathlib.Path(__file__).resolve().parents[2]
DISC = Path("M1 0 A1 1 0 0 1 -1 0 A1 1 0 0 1 1 0 Z")
RING = Path("M3 0 A3 3 0 0 1 -3 0 A3 3 0 0 1 3 0 Z M2 0 A2 2 0 0 0 -2 0 A2 2 0 0 0 2 0 Z")
SQUARE = [(5, 0), (6, 0), (6, 1), (5, 1)]


def distances(ring):
    """How far a ring's vertices, and the middles of its edges, are from the origin."""
    vertices = [math.hypot(x, y) for x, y in ring]
    return vertices + [math.hypot(a + c, b + d) / 2 for (a, b), (c, d) in zip(ring, ring[1:] + ring[:1])]


def test_polygons_are_on_their_side_and_near():
    for tolerance in (0.1, 1e-3, 1e-6):
        outer = taut2d.flatten(Body("a", RING), tolerance).shape
        inner = taut2d.flatten(Body("a", RING), tolerance, side="inner").shape
        assert isinstance(outer, Part) and len(outer.holes) == len(inner.holes) == 1
        for ring, low, high in ((outer.outline, 3, 3 + tolerance), (inner.outline, 3 - tolerance, 3),
                                (outer.holes[0], 2 - tolerance, 2), (inner.holes[0], 2, 2 + tolerance)):
            assert all(low - 1e-15 <= distance <= high + 1e-15 for distance in distances(ring))


def test_all_else_stays(tmp_path):
    (tmp_path / "a.wkt").write_text("POLYGON ((7 7, 9 7, 9 9, 7 7))")
    motion = taut2d.Keyframes([(0, 0, 0), (1, 2, 3)])
    scene = Scene([Body("disc", DISC, motion, id=7), Body("box", SQUARE, taut2d.Sweep(0, 9), relative_to="disc"),
                   Body("file", taut2d.WktFile("a.wkt")), Body("many", [DISC, SQUARE], motion)], (0, 1), [("disc", "box")],
                  {"id": 1}, tmp_path, "test")
    flat = taut2d.flatten(scene, 0.01)
    assert flat.bodies[1:3] == scene.bodies[1:3]
    assert (flat.bodies[0].motion, flat.bodies[0].id) == (motion, 7)
    assert isinstance(flat.bodies[0].shape, Part) and flat.bodies[3].shape == (flat.bodies[0].shape, Part(SQUARE))
    assert (flat.time, flat.ignore, flat.id, flat.folder, flat.at_rest) == \
        (scene.time, scene.ignore, scene.id, scene.folder, "test")
    flat.validate()
    assert taut2d.flatten(flat, 0.01) == flat


def test_straight_paths_become_polygons():
    assert taut2d.flatten(Body("a", Path("M0 0 L1 0 L0 1 Z")), 1).shape == Part([(0, 0), (1, 0), (0, 1)])


def test_it_writes_what_the_command_writes(taut, tmp_path):
    scene = Scene([Body("disc", RING), Body("box", SQUARE, taut2d.Velocity((-1, 0)))], (0, 1))
    scene.save(tmp_path / "scene.json")
    for side in ("outer", "inner"):
        run = subprocess.run([taut, "flatten", "--" + side, "--tolerance", "0.01", str(tmp_path / "scene.json")],
                             stdout=subprocess.PIPE, text=True, check=True)
        assert Scene.from_json(run.stdout).bodies[0].shape == taut2d.flatten(scene, 0.01, side).bodies[0].shape


def test_answers_about_polygons_hold_for_the_curves():
    exact = 5 - 1
    for side in ("outer", "inner"):
        scene = taut2d.flatten(Scene([Body("disc", DISC), Body("box", SQUARE, taut2d.Velocity((-1, 0)))], (0, 10)), 1e-4, side)
        contact = taut2d.check(scene).contact
        assert contact.t[0] <= exact if side == "outer" else contact.t[1] >= exact
        simulation = taut2d.Simulation(scene)
        assert simulation.advance_to(10) == "contact" and simulation.contact.t == taut2d.check(scene, engine="kinetic").contact.t


def test_what_takes_polygons_only_names_it_and_then_works():
    disc, box = Body("disc", DISC), Body("box", SQUARE, taut2d.Velocity((-1, 0)))
    linkage = taut2d.Linkage([disc, Body("box", SQUARE, taut2d.Revolute((5, 0), by="j"))], {"j": (0, 90)})
    square_map = taut2d.StaticMap([Body("box", SQUARE)])
    for what, ask in [(Scene([disc, box], (0, 9)), taut2d.Simulation),
                      (Scene([disc, box], (0, 9)), lambda scene: taut2d.cells(scene, "disc", 0.25)),
                      (disc, lambda body: taut2d.StaticMap([body])), (disc, square_map.prepare),
                      (disc, lambda body: taut2d.Shape(body.shape)), (linkage, taut2d.envelope),
                      (disc, lambda body: taut2d.Shape([Part(SQUARE), body.shape]))]:
        with pytest.raises(InputError) as caught:
            ask(what)
        assert "bounded by curves" in caught.value.problem and "taut2d.flatten(scene, tolerance)" in caught.value.hint
        assert "`taut" not in caught.value.hint and "\x01" not in str(caught.value)
        ask(taut2d.flatten(what, 0.01))


@pytest.mark.parametrize("name", ["cam", "geneva", "hinge", "slot"])
def test_the_example_in_the_message_works(name):
    scene = Scene.load(root / "examples" / "curves" / f"{name}.json")
    asked = (taut2d.Simulation, lambda scene: taut2d.cells(scene, scene.bodies[0].name, 0.25),
             lambda scene: taut2d.StaticMap([Body(scene.bodies[0].name, scene.bodies[0].shape)]))
    for ask in asked:
        with pytest.raises(InputError) as caught:
            ask(scene)
        example = caught.value.hint.rpartition(": for example, ")[2]
        assert eval(example, {"taut2d": taut2d, "scene": scene}).state == "running"
        ask(taut2d.flatten(scene, 0.001))


@pytest.mark.parametrize("make, place", [
    (lambda: taut2d.flatten(Body("a", DISC), 0), "tolerance"), (lambda: taut2d.flatten(Body("a", DISC), -1), "tolerance"),
    (lambda: taut2d.flatten(DISC, 1), "curved"),
    (lambda: taut2d.flatten(Body("a", DISC), 1, "both"), "side"), (lambda: taut2d.flatten(Body("a", DISC), 1e-30), "a"),
    (lambda: taut2d.flatten(Body("a", Path("M0 0 X")), 1), "bodies[0].polygon")])
def test_what_cannot_be_flattened(make, place):
    with pytest.raises(InputError) as caught:
        make()
    assert caught.value.place.startswith(place) and caught.value.hint

"""Questions beyond the first contact, against the command and closed forms."""

import inspect
import json
import subprocess

import numpy as np
import pytest

import taut2d
from conftest import root
from taut2d import _taut2d

SCENES = [*sorted((root / "examples").glob("*.json")),
          *sorted(p for p in (root.parent / "shared" / "worlds").glob("*.json") if ".answer" not in p.name)]


def scene():
    square = [(0, 0), (1, 0), (1, 1), (0, 1)]
    there_and_back = taut2d.Keyframes([taut2d.Keyframe(0, 4, 0.25), taut2d.Keyframe(1, 0, 0.25), taut2d.Keyframe(2, 4, 0.25)])
    return taut2d.Scene([taut2d.Body("rests", square), taut2d.Body("moves", square, there_and_back)], (0, 2))


def printed(*arguments):
    return subprocess.run([*map(str, arguments)], capture_output=True, text=True, check=False).stdout.strip()


@pytest.mark.parametrize("path", SCENES[::5], ids=lambda p: p.stem)
def test_answers_are_those_of_the_command(path, taut):
    world = taut2d.Scene.load(path)
    assert taut2d.intervals(world).json == printed(taut, "intervals", "--json", path)
    assert taut2d.clearance(world, pairs="all").json == printed(taut, "clearance", "--json", "--pairs", "all", path)


def test_intervals_and_range():
    found = taut2d.intervals(scene())
    (overlap,) = found.intervals
    assert overlap.pair == ("rests", "moves") and overlap.enter and overlap.exit
    assert overlap.start[0] <= 0.75 <= overlap.start[1] and overlap.end[0] <= 1.25 <= overlap.end[1]
    free = taut2d.range(scene(), 0.5)
    assert free.start is None and free.end == overlap.start and free.after == overlap
    with pytest.raises(taut2d.InputError) as error:
        taut2d.range(scene(), 1)
    assert "rests and moves overlap" in error.value.problem


def test_clearance():
    assert taut2d.clearance(scene()).nearest.hi == 0
    apart = taut2d.Scene(scene().bodies, (0, 0.5))
    nearest = taut2d.clearance(apart).nearest
    assert nearest.lo <= 1 <= nearest.hi * (1 + 1e-15) and nearest.hi - nearest.lo < 2e-9
    assert nearest.t[0] == pytest.approx(0.5) and len(nearest.points) == 2
    with pytest.raises(taut2d.InputError):
        taut2d.clearance(apart, tolerance=0)


def test_directions():
    slot = [(0, 0), (3, 0), (3, 2), (2, 2), (2, 1), (1, 1), (1, 2), (0, 2)]
    peg = [(1, 1), (2, 1), (2, 3), (1, 3)]
    found = taut2d.separate(taut2d.Scene([taut2d.Body("slot", slot), taut2d.Body("peg", peg)], (0, 1)))
    (body,) = found.bodies
    (arc,) = body.free
    assert found.outcome == "free" and body.body == "peg" and not body.all
    assert arc.point and arc.start_deg[0] <= 90 <= arc.start_deg[1] and arc.start_vertices[0].body == "peg"
    closed = taut2d.Part([(0, 0), (3, 0), (3, 4), (0, 4)], [peg])
    assert taut2d.separate(taut2d.Scene([taut2d.Body("block", closed), taut2d.Body("peg", peg)], (0, 1))).outcome == "locked"
    lid = taut2d.Body("lid", [(0, 3), (3, 3), (3, 4), (0, 4)])
    order = taut2d.separate(taut2d.Scene([taut2d.Body("slot", slot), taut2d.Body("peg", peg), lid], (0, 1)))
    assert [step.body for step in order.order] == ["slot", "peg"]
    assert order.stuck == ()
    overlap = taut2d.separate(taut2d.Scene([taut2d.Body("slot", slot), taut2d.Body("same", slot)], (0, 1)))
    assert overlap.outcome == "overlap_at_start" and overlap.pair == ("slot", "same")


def test_ways_with_turns(taut):
    path = root / "examples/worlds/bent_bar.json"
    scene = taut2d.Scene.load(path)
    assert taut2d.separate(scene).stuck == ("block", "bar")
    found = taut2d.separate(scene, turns=True)
    assert found.outcome == "free" and found.stuck == found.unsure == () and found.rounded == 0
    assert [way.body for way in found.ways] == ["plug", "bar"]
    assert found.ways[1].points[0] == taut2d.WayPoint(0, 0, 0) and found.ways[1].points[-1].deg != 0
    assert found.scene is not None and taut2d.check(found.scene).outcome == "free"
    assert "bodies leave in the order plug, bar" in str(found)
    # The command prints the same, without the scene.
    answer = json.loads(found.json)
    del answer["scene"]
    assert answer == json.loads(printed(taut, "separate", "--turns", "--json", path))
    caught = taut2d.Scene.load(root / "examples/jigsaw_caught.json")
    locked = taut2d.separate(caught, turns=True)
    assert locked.outcome == "locked" and locked.stuck == ("socket", "knob") and 0 < locked.rounded < 1e-12
    assert taut2d.separate(caught, turns=True, max_cells=10).unsure == ("socket", "knob")
    with pytest.raises(taut2d.InputError):
        taut2d.separate(scene, turns=True, tolerance=0)


@pytest.mark.parametrize("path", SCENES[::7], ids=lambda p: p.stem)
def test_directions_are_those_of_the_command(path, taut):
    assert taut2d.separate(taut2d.Scene.load(path)).json == printed(taut, "separate", "--json", path)


def test_proofs_of_worlds():
    lid = taut2d.Body("lid", [(0, 3), (3, 3), (3, 4), (0, 4)], taut2d.Velocity((0, -1)))
    table = [taut2d.Part([(0, 0), (1, 0), (1, 1), (0, 1)]), taut2d.Part([(2, 0), (3, 0), (3, 1), (2, 1)])]
    world = taut2d.Scene([taut2d.Body("table", table), lid], (0, 5))
    proof = taut2d.prove(world)
    proved = taut2d.verify(world, proof)
    assert proof.answer.outcome == "contact" and proved and proved.outcome == "contact" and proved.separations > 0
    plain = scene()
    for engine in ("kinetic", "spacetime", "either", "both"):
        assert taut2d.verify(plain, taut2d.prove(plain, engine=engine)).outcome == "contact"


def test_proofs_of_curves():
    wheel = taut2d.Body("wheel", taut2d.Path("M1 0 A1 1 0 0 1 -1 0 A1 1 0 0 1 1 0 Z"))
    roller = taut2d.Body("roller", taut2d.Path("M12 1 A2 2 0 0 1 8 1 A2 2 0 0 1 12 1 Z"), taut2d.Velocity((-1, 0)))
    discs = taut2d.Scene([wheel, roller], (0, 10))
    proof = taut2d.prove(discs)
    proved = taut2d.verify(discs, proof)
    assert proved and proved.outcome == "contact" and proved.segments > 100
    assert proved.contact.t[0] <= 10 - 8 ** 0.5 <= proved.contact.t[1]
    other = taut2d.Scene([wheel, roller], (0, 11))
    assert taut2d.verify(other, proof).valid is False


def test_margins(taut, tmp_path):
    kept = taut2d.check_clearance(scene(), 0.25)
    assert kept.outcome == "contact" and kept.first.bodies == ("rests", "moves") and kept.t == kept.first.t
    assert kept.t[0] <= 0.6875 <= kept.t[1] and kept.first.distance == 0.25
    first = kept.first
    assert first.vertex is not None and (first.edge is None) != (first.other_vertex is None) and not first.grazing
    path = tmp_path / "scene.json"
    scene().save(path)
    assert kept.json == printed(taut, "check", "--clearance", "0.25", "--json", path)
    far = taut2d.Scene([taut2d.Body("a", [(0, 0), (1, 0), (0, 1)]), taut2d.Body("b", [(3, 0), (4, 0), (4, 1)])], (0, 1))
    assert taut2d.check_clearance(far, 1.5).outcome == "free"
    assert taut2d.check_clearance(far, 2).outcome == "free"
    at_start = taut2d.check_clearance(far, 2, touch="closed")
    assert at_start.outcome == "contact" and at_start.t == (0, 0)
    closer = taut2d.check_clearance(far, 2.5, pairs="all")
    assert closer.outcome == closer.pairs[0].outcome == "closer_at_start" and abs(closer.first.distance - 2) < 1e-9
    assert str(closer).startswith("closer at start: a and b do not keep a distance of 2.5 at the start")
    over = taut2d.Scene([far.bodies[0], taut2d.Body("b", [(0, 0), (1, 0), (1, 1)])], (0, 1))
    assert str(taut2d.check_clearance(over, 2.5)) == "overlap at start: a and b overlap at the start"
    with pytest.raises(taut2d.InputError):
        taut2d.check_clearance(far, 0)


def test_margins_of_their_own(taut, tmp_path):
    own = taut2d.PairClearance(("rests", "moves"), np.array([0.25, 0.5]), origin=0)
    world = taut2d.Scene(scene().bodies, (0, 2), clearances=[own])
    # 3 - 4 t < 0.25 + 0.5 t from 11 / 18 on.
    found = taut2d.check_clearance(world, 9)
    assert found.outcome == "contact" and found.t[0] <= 11 / 18 <= found.t[1] and found.clearances == (own,)
    assert found.first.margin == (0.25, 0.5) and found.first.margin_at == found.first.distance == pytest.approx(0.25 + 11 / 36)
    assert f"do not keep a distance of {found.first.margin_at!r}" in str(found)
    path = tmp_path / "scene.json"
    world.save(path)
    assert found.json == printed(taut, "check", "--clearance", "9", "--json", path)
    assert taut2d.Scene.load(path) == world and eval(repr(own), vars(taut2d)) == own
    early = taut2d.Scene(scene().bodies, (0, 0.5), clearances=[taut2d.PairClearance(["moves", "*"], 0.5)])
    kept = taut2d.check_clearance(early, 9)
    assert kept.outcome == "free" and "their clearances" in str(kept)
    with pytest.raises(taut2d.InputError):
        taut2d.prove_clearance(early, 9)
    for pair, margin, place in [("ab", 1, "pair"), (("a", 1), 1, "pair[1]"), (("a", "b"), "1", "margin"),
                                (("a", "b"), [1, "x"], "margin[1]"), (("a", "b"), float("nan"), "margin")]:
        with pytest.raises(taut2d.InputError) as error:
            taut2d.PairClearance(pair, margin)
        assert error.value.place == place
    for wrong in [taut2d.PairClearance(("rests", "nobody"), 1), taut2d.PairClearance(("rests", "*"), (1, -1)), ("rests", "moves")]:
        with pytest.raises(taut2d.InputError) as error:
            taut2d.check_clearance(taut2d.Scene(scene().bodies, (0, 2), clearances=[wrong]), 1)
        assert error.value.place.endswith("clearances[0]")


def test_proofs_of_a_clearance():
    for clearance, touch in ((0.25, "open"), (0.25, "closed"), (1e-3, "open")):
        proof = taut2d.prove_clearance(scene(), clearance, touch=touch)
        verified = taut2d.verify(scene(), proof)
        assert verified and verified.outcome == proof.answer.outcome == "contact" and verified.clearance == clearance
        assert verified.contact is None and verified.closer.t[0] <= proof.answer.t[1] <= verified.closer.t[1]
        assert verified.closer.vertex == proof.answer.first.vertex
    broken = bytearray(proof.log)
    broken[60] ^= 1
    assert not taut2d.verify(scene(), bytes(broken))
    far = taut2d.Scene([taut2d.Body("a", [(0, 0), (1, 0), (0, 1)]), taut2d.Body("b", [(3, 0), (4, 0), (4, 1)])], (0, 1))
    assert taut2d.verify(far, taut2d.prove_clearance(far, 2)).outcome == "free"
    assert taut2d.verify(far, taut2d.prove_clearance(far, 2, touch="closed")).outcome == "contact"
    assert taut2d.prove_clearance(far, 2.5).log == b""


def test_fit():
    first, second = [(0, 0), (0.1 + 0.2, 0), (0.1 + 0.2, 1), (0, 1)], [(0.3, 0), (1, 0), (1, 1), (0.3, 1)]
    touching = taut2d.Scene([taut2d.Body("a", first), taut2d.Body("b", second)], (0, 1))
    assert taut2d.check(touching).outcome == "overlap_at_start" and taut2d.check(touching).fit == 0
    fitted = taut2d.check(touching, fit=1e-9)
    assert fitted.outcome == "free" and fitted.fit == 1e-9
    for fit in (0, -1, float("nan"), 1e-30, 0.7):
        with pytest.raises(taut2d.InputError):
            taut2d.check(touching, fit=fit)


def test_distance_profile(taut):
    found = taut2d.distance_profile(scene(), 9)
    (curve,) = found.curves
    assert curve.pair == ("rests", "moves") and curve.settled and found.reason is None
    # 3 at the start, 0 from 0.75 to 1.25, and back.
    for t, lo, hi in curve.instants:
        assert lo <= max(0, 4 * abs(1 - t) - 1) <= hi * (1 + 1e-15) and hi - lo < 1e-8
    for start, end, lo, hi in curve.stretches:
        true = [max(0, 4 * abs(1 - t) - 1) for t in (start, end)]
        assert lo <= min(true) and hi >= max(true)
    assert curve.largest[0] <= 3 <= curve.largest[1] * (1 + 1e-15) and curve.largest_at in (0, 2)
    path = root / "examples" / "worlds" / "arm.json"
    printed_json = printed(taut, "clearance", "--profile", 5, "--pairs", "all", "--json", path)
    world = taut2d.distance_profile(taut2d.Scene.load(path), 5, pairs="all")
    assert world.json == printed_json and world.curves[0].pair is None and len(world.curves) > 2
    with pytest.raises(taut2d.InputError):
        taut2d.distance_profile(scene(), 1)


def described(entry):
    """The options that a question takes, and their defaults, as the library says."""
    return {option["name"]: option["words"][0] if "words" in option else option.get("default") for option in entry["options"]}


@pytest.mark.parametrize("entry", json.loads(_taut2d.questions()), ids=lambda entry: entry["name"])
def test_functions_take_the_options_that_the_library_describes(entry):
    parameters = list(inspect.signature(getattr(taut2d, entry["name"])).parameters.values())
    options = {parameter.name: parameter.default for parameter in parameters[1:] if parameter.name != "proof"}
    expected = described(entry)
    if entry["name"] == "flatten":
        # Here it takes linkages and bodies, too, and Ctrl-C ends it.
        assert parameters.pop(0).name == "curved" and expected.pop("max_seconds") is None
    else:
        assert parameters[0].name == entry["about"]
    if entry["name"] == "range":
        options["from"] = options.pop("around")  # a word of Python's
    if entry["name"] == "separate":
        expected.pop("scene")  # Python always asks for it with turns.
    if entry["name"] == "cells":
        options["origin_x"], options["origin_y"] = options.pop("origin")
    assert options.keys() == expected.keys()
    for name, default in options.items():
        # None stands for a default that means: not at all.
        assert default in (None, False, inspect.Parameter.empty) or default == expected[name], name
    assert any(parameter.name == "proof" for parameter in parameters) == entry["reads_log"]


def test_draw(taut):
    path = root / "examples" / "lid.json"
    lid = taut2d.Scene.load(path)
    assert taut2d.draw(lid, at=0.25, width=400).strip() == printed(taut, "draw", "--at", 0.25, "--width", 400, path)
    assert taut2d.draw(lid, animate=True, plain=True).strip() == printed(taut, "draw", "--animate", "--plain", path)
    with pytest.raises(taut2d.InputError, match="within"):
        taut2d.draw(lid, at=1e9)

import dataclasses
import json
import pathlib
import pkgutil
import re
import shutil
import subprocess
import threading
import time
import typing

import pytest
import taut2d
from taut2d import Body, Scene, words

root = pathlib.Path(__file__).resolve().parents[2]
worlds = root.parent / "shared" / "worlds"
ANVIL = Body("anvil", [(0, 0), (4, 0), (4, 1), (0, 1)])
HAMMER = Body("hammer", [(1, 5), (3, 5), (2, 6)], taut2d.Velocity((0, -0.5)))

# Ten million turns of two sticks at right angles, which pass each other closely four times in each: nobody waits for the
# end. One drifts a little, so that they never repeat their places.
LONG = """
import taut2d
stick = [(-1, -0.05), (1, -0.05), (1, 0.05), (-1, 0.05)]
scene = taut2d.Scene([taut2d.Body("a", stick, taut2d.Velocity((1e-9, 0), spin_deg=360)),
                      taut2d.Body("b", [(1.6 - y, x) for x, y in stick], taut2d.Velocity(spin_deg=360, pivot=(1.6, 0)))],
                     (0, 1e7))
"""


def square(x, y):
    return [(x, y), (x + 1, y), (x + 1, y + 1), (x, y + 1)]


def answers_of_the_command(taut, path, *options):
    run = subprocess.run([taut, "check", "--json", *options, str(path)], stdout=subprocess.PIPE, text=True, timeout=120)
    return run.stdout


def scenes(folder):
    return sorted(p for p in folder.glob("*.json") if not p.name.endswith(".answer.json"))


@pytest.mark.parametrize("path", scenes(root / "examples") + scenes(root / "examples" / "continents"),
                         ids=lambda p: p.stem)
def test_examples_have_the_bytes_of_the_command(taut, path):
    scene = Scene.load(path)
    assert taut2d.check(scene).json + "\n" == answers_of_the_command(taut, path)
    assert taut2d.check(scene, touch="closed", engine="spacetime").json + "\n" == \
        answers_of_the_command(taut, path, "--touch", "closed", "--engine", "spacetime")


@pytest.mark.skipif(not worlds.is_dir(), reason="the scenes of worlds are not there")
@pytest.mark.parametrize("path", scenes(worlds), ids=lambda p: p.stem)
def test_worlds_have_the_bytes_of_the_command(taut, path):
    expected = answers_of_the_command(taut, path, "--engine", "spacetime", "--pairs", "all")
    if not expected:
        with pytest.raises(taut2d.InputError):
            taut2d.check(Scene.load(path), engine="spacetime", pairs="all")
        return
    answer = taut2d.check(Scene.load(path), engine="spacetime", pairs="all")
    assert answer.json + "\n" == expected
    assert len(answer.bodies) == 2 or answer.coverage.pairs == len(answer.bodies) * (len(answer.bodies) - 1) / 2


def test_an_answer_has_what_its_json_has():
    answer = taut2d.check(Scene([ANVIL, HAMMER], (0, 10)))
    assert (answer.outcome, answer.free, answer.pair) == ("contact", False, ("anvil", "hammer"))
    contact = answer.contact
    assert contact.t == (8.0, 8.000000000000002)
    assert contact.vertex == taut2d.VertexRef("hammer", 1)
    assert contact.edge == taut2d.EdgeRef("anvil", 2)
    assert (contact.point, contact.normal, contact.grazing, contact.angle_deg) == ((3, 1), (0, 1), False, None)
    assert (answer.touch, answer.time, answer.bodies) == ("open", (0, 10), ("anvil", "hammer"))
    with pytest.raises(dataclasses.FrozenInstanceError):
        answer.outcome = "free"


def test_touching_and_overlap_and_limits():
    touching = taut2d.check(Scene([ANVIL, HAMMER], (0, 8)))
    assert touching.free and touching.touching.vertex.body == "hammer"
    overlap = taut2d.check(Scene([ANVIL, Body("b", [(1, 0.5), (2, 0.5), (1, 3)])], (0, 1)))
    assert overlap.outcome == "overlap_at_start" and len(overlap.overlap_point) == 2
    limited = taut2d.check(Scene.load(root / "examples" / "gears.json"), max_events=5)
    assert limited.outcome == "undecided" and limited.reason == "the limit of 5 events was reached"
    assert 0 < limited.free_until < 1
    assert taut2d.check(Scene.load(root / "examples" / "gears.json"), max_seconds=0).outcome == "undecided"


def test_three_bodies_name_pair_coverage_and_parts():
    base = Body("base", taut2d.Part([(-9, -9), (9, -9), (9, 9), (-9, 9)], [[(-5, -5), (-5, 5), (5, 5), (5, -5)]]))
    ball = Body("ball", [(-1, -1), (1, -1), (1, 1), (-1, 1)], taut2d.Velocity((1, 0)), id=7)
    far = Body("far", [(50, 0), (51, 0), (50, 1)])
    answer = taut2d.check(Scene([base, ball, far], (0, 10), [("far", "*")], id="q"), pairs="all", engine="spacetime")
    assert answer.pair == ("base", "ball") and answer.id == "q"
    assert answer.coverage == taut2d.Coverage(pairs=3, tested=1, apart=0, ignored=2, moving_alike=0, at_rest=0, layers=0)
    assert answer.pairs[0].contact.edge == taut2d.EdgeRef("base", answer.contact.edge.index, 0, 1)
    assert answer.contact.vertex.id == 7
    assert answer.contact.t[0] == 4


def test_options_are_checked():
    scene = Scene([ANVIL, HAMMER], (0, 10))
    for options, place in [({"touch": "ajar"}, "touch"), ({"engine": "steam"}, "engine"), ({"pairs": "some"}, "pairs"),
                           ({"max_seconds": -1}, "max_seconds"), ({"max_events": -1}, "max_events"),
                           ({"max_events": 0.5}, "max_events"), ({"touch": None}, "touch")]:
        with pytest.raises(taut2d.InputError) as caught:
            taut2d.check(scene, **options)
        assert caught.value.place == place


def test_a_proof_has_the_answer_of_a_check():
    scene = Scene.load(root / "examples" / "gears_thick_tooth.json")
    for engine in ["kinetic", "spacetime"]:
        assert taut2d.prove(scene, engine=engine).answer == taut2d.check(scene, engine=engine)
    # Of two engines in turn, the other one may have begun.
    assert taut2d.prove(scene).answer.contact == taut2d.check(scene).contact


def test_an_exact_proof_ends_before_the_contact():
    scene = Scene([ANVIL, HAMMER], (0, 10))
    proof = taut2d.prove(scene, exact=True)
    log = json.loads(proof.log)
    assert log["format"] == "taut-exact/1" and 7.9 < log["until"] < proof.answer.contact.t[0]
    assert not taut2d.verify(scene, proof)



@pytest.mark.parametrize("engine", ["kinetic", "spacetime", "usual"])
def test_a_proof_is_verified(tmp_path, engine):
    scene = Scene.load(root / "examples" / "gears_thick_tooth.json")
    proof = taut2d.prove(scene, engine=engine)
    path = tmp_path / "gears.proof"
    proof.save(path)
    verified = taut2d.verify(scene, proof)
    assert verified and verified == taut2d.verify(scene, proof.log) == taut2d.verify(scene, path)
    assert verified.outcome == "contact" and verified.contact.vertex == proof.answer.contact.vertex
    assert verified.scene_sha256 == proof.scene_sha256
    assert verified.events == (proof.answer.events if proof.answer.engine == "kinetic" else 0)
    damaged = taut2d.verify(scene, proof.log[:-20])
    assert not damaged and damaged.valid is False and damaged.reason
    other = dataclasses.replace(scene, time=(0, 0.5))
    assert taut2d.verify(other, proof).valid is False


def test_the_command_accepts_a_proof(taut, tmp_path):
    path = root / "examples" / "lid.json"
    taut2d.prove(Scene.load(path)).save(tmp_path / "lid.proof")
    run = subprocess.run([taut, "verify", str(path), str(tmp_path / "lid.proof")], stdout=subprocess.PIPE, text=True)
    assert run.returncode == 0 and re.match("VALID", run.stdout)


@pytest.mark.parametrize("call", ["check(scene)", "check(scene, engine='spacetime')", "prove(scene)"])
def test_control_c_ends_a_check(call, interrupt):
    program = LONG + f"print('begun', flush=True)\ntaut2d.{call}\n"
    _, errors = interrupt(program)
    assert errors.rstrip().endswith("KeyboardInterrupt")


def test_checks_run_in_several_threads():
    paths = scenes(root / "examples")
    expected = [taut2d.check(Scene.load(path)).json for path in paths]
    found = [None] * 4

    def work(k):
        found[k] = [taut2d.check(Scene.load(path)).json for path in paths]

    threads = [threading.Thread(target=work, args=(k,)) for k in range(len(found))]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert found == [expected] * len(found)


def test_other_threads_go_on_during_a_check():
    names = {}
    exec(LONG, names)
    done = threading.Event()
    thread = threading.Thread(target=lambda: (taut2d.check(names["scene"], max_seconds=0.5), done.set()))
    thread.start()
    turns = 0
    while not done.is_set():
        turns += 1
        time.sleep(0.01)
    thread.join()
    assert turns > 10


def test_help_has_words_for_everything():
    for name in taut2d.__all__:
        doc = getattr(taut2d, name).__doc__
        assert doc and not doc.startswith(name + "("), name


FALLS, RISES = (Body("b", square(0, 5), taut2d.Velocity((0, v))) for v in (-1, 1))
ARM = taut2d.Linkage([Body("a", square(0, 0)), Body("b", square(2, 0), taut2d.Slide((-1, 0), by="reach"))], {"reach": (0, 2)})
WAY = taut2d.PathProblem(ARM, {"reach": 0}, {"reach": 0.5})
ASK = {"check": taut2d.check, "margin": lambda scene: taut2d.check_clearance(scene, 0.5), "intervals": taut2d.intervals,
       "range": lambda scene: taut2d.range(scene, 0), "clearance": taut2d.clearance,
       "profile": lambda scene: taut2d.distance_profile(scene, 3), "separate": taut2d.separate,
       "envelope": lambda scene: taut2d.envelope(ARM), "path": lambda scene: taut2d.path(WAY)}


@pytest.mark.parametrize("ask", ASK.values(), ids=ASK)
@pytest.mark.parametrize("mover", [FALLS, RISES], ids=["falls", "rises"])
def test_no_answer_has_a_truth_value(ask, mover):
    with pytest.raises(TypeError, match=r'is neither true nor false: write .*answer\.outcome == "'):
        bool(ask(Scene([Body("a", square(0, 0)), mover], (0, 10))))


def test_proofs_have_no_truth_value_but_what_is_verified_has():
    scene = Scene([ANVIL, HAMMER], (0, 10))
    for proof in (taut2d.prove(scene), taut2d.prove_clearance(scene, 0.5)):
        with pytest.raises(TypeError, match="proof.answer.outcome"):
            bool(proof)
        assert taut2d.verify(scene, proof)
    assert not taut2d.verify(scene, b"nothing")


@pytest.mark.parametrize("ask, falls, rises", [
    ("check", "contact: a and b at t in [4.0, 4.000000000000001]\nvertex 1 of b meets edge 2 of a at (1, 1)",
     "free: no two bodies overlap from t = 0.0 to 10.0"),
    ("margin", "contact: a and b do not keep a distance of 0.5 at t in [3.4999999999999996, 3.5000000000000004]\n"
     "nearest points then: (1, 1) and (1, 1.5), at most 0.5 apart", "free: all bodies keep a distance of 0.5"),
    ("intervals", "contact: 1 interval of overlap\nthat is a and b, from t = [4.0, 4.000000000000001] to "
     "[5.999999999999999, 6.0]", "free: no two bodies overlap at any time"),
    ("range", "free: no two bodies overlap from the start to t = [4.0, 4.000000000000001]\na and b overlap after",
     "free: no two bodies overlap from the start to the end"),
    ("clearance", "contact: a and b touch or overlap at t in [", "free: the least distance is [3.99"),
    ("profile", "contact: two bodies touch or overlap\nit is greatest, [", "free: the distance is never below 3.99"),
    ("separate", "free: b leaves in 1 arc of directions", "free: b leaves in 1 arc of directions"),
    ("envelope", "contact: a and b overlap at reach = ", "contact: a and b overlap at reach = "),
    ("path", "path: 1 straight segment", "path: 1 straight segment"),
])
def test_an_answer_is_said_in_words(ask, falls, rises):
    for mover, words in ((FALLS, falls), (RISES, rises)):
        said = str(ASK[ask](Scene([Body("a", square(0, 0)), mover], (0, 10))))
        assert said.startswith(words) and said.count("\n") <= 2 and "not tested" not in said


@pytest.mark.parametrize("ask", sorted(set(ASK) - {"envelope", "path", "separate"}))
def test_words_say_what_was_not_tested(ask):
    bodies = [Body("a", square(0, 0)), Body("c", square(9, 9)), FALLS]
    said = str(ASK[ask](Scene(bodies, (0, 3), [("b", "c")])))
    assert said.startswith("free: ") and said.count("\n") <= 2
    assert said.endswith("\nnot tested: 2 of 3 pairs (1 ignored, 1 at rest)")
    # The sentence about the others is about the others.
    assert "tested pairs" in said.splitlines()[0]
    nothing = str(ASK[ask](Scene([Body("a", square(0, 0)), FALLS], (0, 10), [("a", "*")])))
    assert re.fullmatch(r"untested\nnothing was tested: .*\nnot tested: 1 of 1 pair \(1 ignored\)", nothing)


def test_words_begin_with_what_is_undecided():
    gears = Scene.load(root / "examples" / "gears.json")
    said = str(taut2d.check(gears, max_events=5))
    assert re.fullmatch(r"undecided: wheel and pinion, free until t = 0\.0.*\nthe limit of 5 events was reached", said)
    for ask in (taut2d.check, taut2d.intervals, taut2d.clearance):
        said = str(ask(gears, max_seconds=0))
        assert said.startswith("undecided") and "free" not in said
        assert said.endswith("\nthe time limit was reached\nnot tested: 1 of 1 pair (1 not reached)")


def test_repr_has_all_fields():
    answer = taut2d.check(Scene([ANVIL, HAMMER], (0, 10)))
    assert repr(answer).startswith("Answer(outcome='contact', contact=Contact(t=(8.0, ") and "coverage=Coverage(" in repr(answer)


def test_the_distance_is_a_bracket():
    scene = Scene([Body("a", square(0, 0)), RISES], (0, 10))
    found = taut2d.clearance(scene)
    assert found.distance == (found.nearest.lo, found.nearest.hi) and found.distance[0] <= 4 <= found.distance[1]
    profile = taut2d.distance_profile(scene, 3)
    assert profile.greatest == profile.curves[0].largest and profile.greatest[0] <= 14 <= profile.greatest[1]
    untested = Scene([Body("a", square(0, 0)), RISES], (0, 10), [("a", "b")])
    assert taut2d.clearance(untested).distance is None and taut2d.distance_profile(untested, 3).greatest is None


def test_the_package_has_the_names_that_it_offers():
    modules = {module.name for module in pkgutil.iter_modules(taut2d.__path__)}
    public = {name for name in dir(taut2d) if not name.startswith("_")}
    assert public - modules == set(taut2d.__all__) - modules | {"range"}
    assert len(taut2d.__all__) == len(set(taut2d.__all__)) and set(taut2d.__all__) <= public
    names = {}
    exec("from taut2d import *", names)
    assert set(names) - {"__builtins__"} == set(taut2d.__all__) and "range" not in names
    assert taut2d.range(Scene([ANVIL, HAMMER], (0, 10)), 0).end[0] <= 8


def test_the_words_of_the_types_are_those_of_the_library():
    scene = Scene([ANVIL, HAMMER], (0, 10))
    for touch in typing.get_args(words.Touch):
        assert taut2d.check(scene, touch=touch).touch == touch
    for engine in typing.get_args(words.Engine):
        assert taut2d.check(scene, engine=engine).engine in typing.get_args(words.EngineName)
    for pairs in typing.get_args(words.Pairs):
        assert taut2d.check(scene, pairs=pairs).outcome in typing.get_args(words.OutcomeWord)
    for option, kind in (("touch", words.Touch), ("engine", words.Engine), ("pairs", words.Pairs)):
        with pytest.raises(taut2d.InputError) as caught:
            taut2d.check(scene, **{option: "other"})
        assert sorted(re.findall('"(.*?)"', caught.value.hint)) == sorted(typing.get_args(kind))
    assert {outcome.name.lower() for outcome in taut2d.Outcome} == set(typing.get_args(words.OutcomeWord))
    for at_rest in typing.get_args(words.AtRest):
        assert Scene(scene.bodies, (0, 1), at_rest=at_rest).at_rest == at_rest
    for rule in typing.get_args(words.FillRule):
        assert taut2d.Path("M0 0 L1 0 L0 1 Z", rule).fill_rule == rule
    assert {face.kind for face in taut2d.Simulation(scene).tiling().faces} <= set(typing.get_args(words.FaceKind))


@pytest.mark.skipif(shutil.which("mypy") is None, reason="mypy is not installed")
def test_types_are_right_for_the_package_and_its_users(tmp_path):
    user = tmp_path / "user.py"
    user.write_text(LONG + """
answer: taut2d.Answer = taut2d.check(scene)
scene.bodies[0].name.upper()
rows = taut2d.VelocityRows([(0, 1)], spin_deg=[3])
moved: taut2d.Scene = scene.with_motion("a", rows[0])
taut2d.check_many(moved, {"a": rows}, shapes={"b": [taut2d.Shape(stick)]})["outcome"].mean()
taut2d.sweep(scene, {"a": rows}, to="folder").array().tobytes()
moved.poses(0)["a"].cos.hex()
moved.plot(at=answer)
moved.view().save("page.html")
end: taut2d.Range = taut2d.range(scene, 0)
if answer.outcome == "overlap_at_start" or answer.touch == "closed" or end.outcome == "untested":
    taut2d.Simulation(scene, touch=answer.touch)
# A word that means nothing is noticed: mypy complains of comments that ignore nothing.
taut2d.check(scene, touch="shut")  # type: ignore[arg-type]
taut2d.check(scene, engine="fast")  # type: ignore[arg-type]
taut2d.clearance(scene, pairs="some")  # type: ignore[arg-type]
taut2d.Scene(scene.bodies, (0, 1), at_rest="ask")  # type: ignore[arg-type]
taut2d.Simulation(scene).state == "stopped"  # type: ignore[comparison-overlap]
answer.outcome == "collision"  # type: ignore[comparison-overlap]
""")
    run = subprocess.run(["mypy", "--cache-dir", str(tmp_path), "--config-file", str(root / "pyproject.toml"),
                          str(root / "python/taut2d"), str(user)], stdout=subprocess.PIPE, text=True)
    assert run.returncode == 0, run.stdout


def test_no_verdict_where_nothing_was_tested():
    falls = taut2d.Body("b", square(0, 5), taut2d.Velocity((0, -1)))
    scene = Scene([Body("a", square(0, 0)), falls], (0, 10), [("a", "*")])
    for answer in (taut2d.check(scene), taut2d.check_clearance(scene, 1), taut2d.clearance(scene), taut2d.intervals(scene),
                   taut2d.range(scene, 0), taut2d.separate(scene), taut2d.distance_profile(scene, 3),
                   taut2d.prove(scene).answer, taut2d.check(Scene([falls], (0, 10)))):
        assert answer.outcome == "untested"
        assert "nothing was tested" in answer.reason
        assert answer.coverage.untested == answer.coverage.pairs
    assert not taut2d.check(scene).free
    assert taut2d.prove(scene).log == b""
    simulation = taut2d.Simulation(scene)
    simulation.advance_to(10)
    assert simulation.state == "untested" and simulation.coverage.ignored == 1


def test_pairs_at_rest():
    bodies = [Body("a", square(0, 0)), Body("b", square(0.5, 0.5))]
    assert taut2d.check(Scene(bodies, (0, 1))).outcome == "overlap_at_start"
    bodies.append(Body("c", square(0, 5), taut2d.Velocity((0, 1))))
    skipped = taut2d.check(Scene(bodies, (0, 1)))
    assert skipped.free and skipped.coverage.at_rest == 1 and skipped.coverage.untested == 1
    scene = Scene(bodies, (0, 1), at_rest="test")
    assert Scene.from_json(scene.to_json()) == scene
    tested = taut2d.check(scene)
    assert tested.outcome == "overlap_at_start" and tested.pair == ("a", "b") and tested.coverage.untested == 0
    many = taut2d.check_many([Scene(bodies, (0, 1)), scene])
    assert list(many["untested"]) == [1, 0]
    with pytest.raises(taut2d.InputError):
        Scene(bodies, (0, 1), at_rest="ask")

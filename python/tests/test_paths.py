"""Ways and proofs that there are none: the command's bytes, errors, scenes of ways."""

import pathlib
import json
import subprocess

import pytest
import taut2d

examples = pathlib.Path(__file__).resolve().parents[2] / "examples" / "paths"


def door(width):
    table = taut2d.Body("table", [(-1, -0.5), (1, -0.5), (1, 0.5), (-1, 0.5)], taut2d.Free("x", "y", "turn"))
    wall = taut2d.Body("wall", [taut2d.Part([(0, width / 2), (0.2, width / 2), (0.2, 4), (0, 4)]),
                                taut2d.Part([(0, -4), (0.2, -4), (0.2, -width / 2), (0, -width / 2)])])
    room = taut2d.Linkage([table, wall], {"x": (-3, 3), "y": (-2, 2), "turn": (0, 360)})
    return taut2d.PathProblem(room, {"x": -2, "y": 0.5, "turn": 90}, {"x": (1.5, 3)}, ["turn"])


def test_a_way_is_an_ordinary_scene():
    for touch, clearance in (("open", 0), ("closed", 0), ("open", 0.05)):
        answer = taut2d.path(door(1.2), touch=touch, clearance=clearance)
        assert answer.outcome == "path" and answer.waypoints[0] == {"x": -2, "y": 0.5, "turn": 90}
        assert answer.waypoints[-1]["x"] >= 1.5 and not answer.exact and answer.cells == ()
        scene = door(1.2).scene(answer.waypoints)
        assert scene.time[1] == len(answer.waypoints) - 1
        assert taut2d.check(scene, touch=touch).outcome == "free"
        if clearance:
            assert taut2d.check_clearance(scene, clearance).outcome == "free"


def test_none_and_undecided():
    none = taut2d.path(door(0.95), cells=True)
    assert none.outcome == "none" and none.waypoints == () and "colliding" in {cell.state for cell in none.cells}
    assert str(none).startswith("none: no way")
    tight = taut2d.path(door(1), tolerance=0.02)
    assert tight.outcome == "undecided" and tight.tight.pair == ("table", "wall") and "wall" in str(tight)
    first, second = tight.tight.features
    assert {first.vertex.body, first.edge.body} == {second.vertex.body, second.edge.body} == {"table", "wall"}
    assert first.distance <= second.distance < 0.1
    assert taut2d.path(door(0.95), max_cells=5).outcome == "undecided"
    assert taut2d.path(door(0.95), max_seconds=0).outcome == "undecided"


@pytest.mark.parametrize("name, code", [("arm", 0), ("bracket", 0), ("piano", 0), ("piano_long", 1)])
def test_equals_the_command(taut, tmp_path, name, code):
    path = examples / f"{name}.json"
    printed = subprocess.run([taut, "path", "--json", path], capture_output=True, text=True)
    assert printed.returncode == code
    problem = taut2d.PathProblem.load(path)
    assert taut2d.path(problem).json + "\n" == printed.stdout
    again = tmp_path / "again.json"
    problem.save(again)
    assert taut2d.PathProblem.load(again) == problem == taut2d.PathProblem.from_json(problem.to_json())


def test_proofs(taut, tmp_path):
    path = examples / "piano_long.json"
    problem = taut2d.PathProblem.load(path)
    proof = taut2d.prove_path(problem)
    assert proof.answer.outcome == "none"
    verified = taut2d.verify_path(problem, proof)
    assert verified and verified.scene_sha256 == proof.scene_sha256
    assert 0 < verified.colliding < verified.cells and 0 < verified.reached < verified.cells
    # The command takes the log, and writes the same one.
    saved = tmp_path / "piano.proof"
    proof.save(saved)
    printed = subprocess.run([taut, "verify", "--json", path, saved], capture_output=True, text=True)
    assert printed.returncode == 0 and json.loads(printed.stdout)["cells"] == verified.cells
    written = tmp_path / "written.proof"
    subprocess.run([taut, "prove", path, "-o", written], capture_output=True)
    assert written.read_bytes() == proof.log
    assert taut2d.verify_path(problem, saved) == taut2d.verify_path(problem, proof.log) == verified
    # Of another problem, or damaged, it proves nothing.
    other = taut2d.PathProblem(problem.linkage, {**problem.start, "x": problem.start["x"] + 0.001}, problem.goal, problem.periodic)
    assert taut2d.verify_path(other, proof).valid is False
    assert not taut2d.verify_path(problem, proof.log[:-1]) and taut2d.verify_path(problem, b"").reason
    assert taut2d.verify_path(problem, proof, max_seconds=0).valid is None
    with pytest.raises(TypeError):
        bool(proof)
    way = taut2d.prove_path(taut2d.PathProblem.load(examples / "piano.json"))
    assert way.answer.outcome == "path" and way.log == b""
    with pytest.raises(ValueError):
        way.save(saved)
    with pytest.raises(taut2d.InputError):
        taut2d.prove_path(problem.linkage)


@pytest.mark.parametrize("form", [taut2d.Scene, taut2d.Linkage, taut2d.PathProblem])
def test_files_that_are_no_text(form, tmp_path):
    path = tmp_path / "latin.json"
    path.write_bytes(b'{"format": "taut-scene/1", "id": "\xe9"}')
    with pytest.raises(taut2d.InputError, match="not UTF-8"):
        form.load(path)
    with pytest.raises(OSError):
        form.load(tmp_path / "missing.json")


def test_plot():
    pytest.importorskip("matplotlib").use("Agg")
    reach = taut2d.PathProblem.load(examples / "reach.json")
    axes = taut2d.path(reach, cells=True).plot()
    assert (axes.get_xlabel(), axes.get_ylabel()) == ("shoulder", "elbow") and len(axes.collections) == 3 and not axes.lines
    near = taut2d.PathProblem(reach.linkage, reach.start, {"shoulder": (0, 10)})
    answer = taut2d.path(near, cells=True)
    (way,) = answer.plot().lines
    assert list(way.get_xdata()) == [at["shoulder"] for at in answer.waypoints]
    for without in (taut2d.path(reach), taut2d.path(taut2d.PathProblem.load(examples / "piano.json"), cells=True)):
        with pytest.raises(taut2d.InputError):
            without.plot()


def test_errors():
    problem = door(1.2)
    for change in (dict(goal="inside"), dict(goal={"x": "far"}), dict(start={"x": "near"}), dict(start=[1]), dict(linkage=3)):
        with pytest.raises(taut2d.InputError):
            taut2d.PathProblem(**{**vars(problem), **change})
    for change in (dict(start={"x": 0}), dict(start={"x": 0, "y": 2, "turn": 0}), dict(goal={"z": 1}), dict(periodic=["x"])):
        with pytest.raises(taut2d.InputError):
            taut2d.path(taut2d.PathProblem(**{**vars(problem), **change}))
    with pytest.raises(taut2d.InputError):
        taut2d.path(problem.linkage)
    with pytest.raises(taut2d.InputError):
        taut2d.Free()
    with pytest.raises(taut2d.InputError):
        taut2d.path(problem, tolerance=0)


def test_short_ways():
    problem = door(1.2)
    answer = taut2d.path(problem, shortest=True, within=0.5, max_seconds=60)
    assert answer.outcome == "path" and answer.length is not None and answer.reason is None
    assert answer.length.shortest_at_least <= answer.length.way <= 1.5 * answer.length.shortest_at_least
    assert set(answer.length.weights) == {"x", "y", "turn"} and abs(answer.length.weights["x"] - 1) < 1e-12
    assert taut2d.path(problem).length is None
    with pytest.raises(taut2d.InputError, match="within"):
        taut2d.path(problem, within=-1)

"""Mechanisms: scenes with joints, locks, and what their joints do."""

import json
import math
import subprocess

import pytest

import taut2d
from conftest import root

EXAMPLES = sorted((root / "examples" / "mechanisms").glob("*.json"))


def slider_crank(**drive):
    bar = [(0, 0), (1, 0), (0, 1)]
    bodies = [taut2d.Body("base", [(-9, -9), (-8, -9), (-9, -8)]), taut2d.Body("crank", bar, z=(0, 1)),
              taut2d.Body("rod", bar, z=(1, 2)), taut2d.Body("piston", bar, z=(2, 3))]
    return taut2d.Scene(bodies, (0, 1), mechanism={
        "ground": "base",
        "joints": {"A": {"revolute": ["base", "crank"], "at": [0, 0]}, "B": {"revolute": ["crank", "rod"], "at": [0, 3]},
                   "C": {"revolute": ["rod", "piston"], "at": [4, 0]}, "S": {"slide": ["base", "piston"], "direction": [1, 0]}},
        "drive": drive})


@pytest.mark.parametrize("path", EXAMPLES, ids=lambda p: p.stem)
def test_answers_are_those_of_the_command(path, taut):
    def printed(*arguments):
        return subprocess.run([*map(str, arguments)], capture_output=True, text=True, check=False).stdout.strip()

    scene = taut2d.Scene.load(path)
    assert taut2d.Scene.from_json(scene.to_json()) == scene
    assert taut2d.check(scene).json == printed(taut, "check", "--json", path)
    assert taut2d.mechanism(scene, instants=3).json == printed(taut, "mechanism", "--json", "--instants", 3, path)


def test_ranges_of_joints():
    found = taut2d.mechanism(slider_crank(A={"from_deg": 0, "to_deg": 360}), instants=5)
    assert found.outcome == "moves" and found.mobility == 1 and found.loops == 1 and found.lock is None
    ranges = {joint.joint: joint for joint in found.joints}
    # Crank 3, rod 5: from 8 to 2, drawn at 4.
    assert ranges["S"].unit == "length" and ranges["S"].greatest.lo <= 4 <= ranges["S"].greatest.hi
    assert ranges["S"].least.lo <= -2 <= ranges["S"].least.hi and ranges["S"].least.hi - ranges["S"].least.lo < 1e-7
    assert found.instants == (0, 0.25, 0.5, 0.75, 1)
    at_half = dict(zip(ranges, found.values[2]))
    assert at_half["A"][0] <= 180 <= at_half["A"][1] and at_half["S"][0] <= 0 <= at_half["S"][1]
    with pytest.raises(TypeError):
        bool(found)


def test_locks():
    scene = slider_crank(S={"from": 0, "to": 5})
    answer = taut2d.check(scene, touch="open")
    assert answer.lock is not None and answer.lock.kind == "dead point"
    assert answer.lock.t[0] <= 0.8 <= answer.lock.t[1]
    motion = taut2d.mechanism(scene)
    assert motion.outcome == "locked" and motion.lock == answer.lock and "dead point" in str(motion)
    assert set(motion.lock.links) >= {"crank", "rod"}
    assert taut2d.intervals(scene).lock == answer.lock
    assert math.isclose(json.loads(answer.json)["lock"]["t"][0], 0.8, abs_tol=1e-9)


def test_errors():
    with pytest.raises(taut2d.InputError) as error:
        taut2d.check(slider_crank())
    assert "mobility is 1" in error.value.problem
    with pytest.raises(taut2d.InputError) as error:
        taut2d.mechanism(taut2d.Scene(slider_crank(A={"from_deg": 0, "to_deg": 9}).bodies, (0, 1)))
    assert "mechanism" in str(error.value)


def test_drives_with_ranges():
    """A linkage of a mechanism: what intervals() says of the turn, and a way of three drives at once."""
    turning = taut2d.Scene.load(root / "examples/mechanisms/crank_rocker.json")
    linkage = taut2d.Linkage(turning.bodies, mechanism={**turning.mechanism, "drive": {"A": (0, 360)}})
    answer = taut2d.envelope(linkage, cells=True)
    assert answer.outcome == "contact" and set(answer.witness.values) == {"A"}
    assert len(taut2d.intervals(turning).intervals) == 1
    colliding = [cell for cell in answer.cells if cell.state == "colliding"]
    assert min(cell.lo[0] for cell in colliding) == pytest.approx(236.02, abs=0.5)
    assert max(cell.hi[0] for cell in colliding) == pytest.approx(289.23, abs=0.5)
    problem = taut2d.PathProblem.load(root / "examples/paths/excavator.json")
    assert problem.linkage.joints == {} and problem.to_json() == taut2d.PathProblem.from_json(problem.to_json()).to_json()
    found = taut2d.path(problem)
    assert found.outcome == "path" and set(found.waypoints[0]) == {"lift", "elbow", "curl"}
    assert taut2d.check(problem.scene(found.waypoints)).outcome == "free"
    # From before the pose in which links collide to behind it.
    linkage = taut2d.Linkage(turning.bodies, mechanism={**turning.mechanism, "drive": {"A": (0, 300)}})
    blocked = taut2d.PathProblem(linkage, start={"A": 0}, goal={"A": 300})
    proof = taut2d.prove_path(blocked)
    assert proof.answer.outcome == "none" and taut2d.verify_path(blocked, proof).valid

"""Questions beyond the first contact, against the command and closed forms."""

import subprocess

import pytest

import taut2d
from conftest import root

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

"""Linkages and their envelopes: closed forms, the command's bytes, errors, pictures."""

import json
import pathlib
import subprocess

import pytest
import taut2d

square = [(0, 0), (1, 0), (1, 1), (0, 1)]
examples = pathlib.Path(__file__).resolve().parents[2] / "examples" / "linkages"


def slider(hi=8.0):
    return taut2d.Linkage([taut2d.Body("wall", [(4, -1), (5, -1), (5, 3), (4, 3)]),
                           taut2d.Body("box", square, taut2d.Slide((1, 0), "x"))], {"x": (0, hi)})


def test_closed_form():
    answer = taut2d.envelope(slider())
    assert answer.outcome == "contact" and answer.witness.pair == ("wall", "box")
    assert 3 < answer.witness.values["x"] < 5 and answer.cells == ()
    assert answer.colliding <= 0.25 and answer.free <= 0.75 and answer.undecided < 0.01
    assert taut2d.envelope(slider(2.99)).outcome == "free"


def test_cells_are_a_partition():
    turns = taut2d.Linkage([taut2d.Body("wall", [(1, -3), (2, -3), (2, 3), (1, 3)]),
                            taut2d.Body("bar", [(-.1, -.1), (2, -.1), (2, .1), (-.1, .1)],
                                        taut2d.Revolute((0, 0), "turn", times=0.5, plus=10)),
                            taut2d.Body("tip", [(2, -.1), (2.1, -.1), (2.1, .1)], taut2d.Revolute((2, 0), "tip"),
                                        relative_to="bar")],
                           {"turn": (0, 180), "tip": (-90, 90)}, ignore=[("bar", "tip")])
    answer = taut2d.envelope(turns, tolerance=0.01, cells=True)
    area = {state: 0.0 for state in ("free", "colliding", "undecided")}
    for cell in answer.cells:
        area[cell.state] += (cell.hi[0] - cell.lo[0]) * (cell.hi[1] - cell.lo[1]) / (180 * 180)
    for state, share in area.items():
        assert share == pytest.approx(getattr(answer, state), abs=1e-9)
    assert sum(area.values()) == pytest.approx(1)


@pytest.mark.parametrize("name", ["loader", "door", "lift"])
def test_equals_the_command(taut, tmp_path, name):
    path = examples / f"{name}.json"
    printed = subprocess.run([taut, "envelope", "--json", path], capture_output=True, text=True)
    assert printed.returncode == 1
    linkage = taut2d.Linkage.load(path)
    assert taut2d.envelope(linkage).json + "\n" == printed.stdout
    again = tmp_path / "again.json"
    linkage.save(again)
    assert taut2d.Linkage.load(again) == linkage == taut2d.Linkage.from_json(linkage.to_json())


def test_errors():
    for joints in ({}, {"x": (1, 0)}, {"a": (0, 1), "b": (0, 1), "c": (0, 1), "d": (0, 1), "e": (0, 1)}):
        with pytest.raises(taut2d.InputError) as caught:
            taut2d.envelope(taut2d.Linkage(slider().bodies, joints))
        assert "joint" in str(caught.value)
    with pytest.raises(taut2d.InputError):
        taut2d.Linkage(slider().bodies, {"x": (0, 1, 2)})
    with pytest.raises(taut2d.InputError):
        taut2d.Linkage(slider().bodies, [("x", (0, 1))])
    with pytest.raises(taut2d.InputError):
        taut2d.Slide((1, 0), 3)
    with pytest.raises(taut2d.InputError):
        taut2d.envelope(slider(), tolerance=0)
    with pytest.raises(taut2d.InputError):
        taut2d.envelope(taut2d.Scene(slider().bodies, (0, 1)))
    # A scene in time has no joints, and says so.
    with pytest.raises(taut2d.InputError):
        taut2d.check(taut2d.Scene(slider().bodies, (0, 1)))
    with pytest.raises(taut2d.InputError) as caught:
        taut2d.Scene.from_json(slider().to_json())
    assert "envelope" in str(caught.value)
    limited = taut2d.envelope(taut2d.Linkage.load(examples / "lift.json"), max_seconds=0)
    assert limited.outcome == "undecided" and limited.reason


def test_locks_of_two_drives():
    linkage = taut2d.Linkage.load(examples.parent / "paths" / "five_bar.json")
    answer = taut2d.envelope(linkage, tolerance=0.1, cells=True)
    assert 0 < answer.may_lock < answer.undecided and not answer.other_poses
    assert {cell.state for cell in answer.cells if cell.may_lock} == {"undecided"}
    said = json.loads(answer.json) | {"other_poses": True}
    assert taut2d.linkages._envelope_from_json(json.dumps(said)).other_poses


def test_plot():
    pyplot = pytest.importorskip("matplotlib.pyplot")
    pyplot.switch_backend("Agg")
    answer = taut2d.envelope(taut2d.Linkage.load(examples / "loader.json"), tolerance=0.02, cells=True)
    axes = answer.plot()
    assert axes.get_xlabel() == "lift" and axes.get_ylabel() == "tilt" and len(axes.collections) == 3
    pyplot.close("all")
    with pytest.raises(taut2d.InputError):
        taut2d.envelope(slider(), cells=True).plot()
    assert json.loads(answer.json)["outcome"] == "contact"

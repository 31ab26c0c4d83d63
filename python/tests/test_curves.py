"""Bodies bounded by curves."""

import json
import math

import pytest
import taut2d

DISC = "M1 0 A1 1 0 0 1 -1 0 A1 1 0 0 1 1 0 Z"



def scene_of(shape):
    roller = {"name": "roller", "polygon": shape._json(), "motion": {"x": [10, -1], "y": [1]}}
    text = {"format": "taut-scene/1", "time": [0, 10],
            "bodies": [{"name": "wheel", "polygon": taut2d.Path(DISC)._json()}, roller]}
    return taut2d.Scene.from_json(json.dumps(text))


def test_a_circle_meets_a_circle_when_it_does():
    answer = taut2d.check(scene_of(taut2d.Path(DISC)))
    exact = 10 - math.sqrt(3)
    assert answer.contact.t[0] <= exact <= answer.contact.t[1]
    assert answer.contact.t[1] - answer.contact.t[0] <= 1e-8
    assert 0 <= answer.contact.vertex.at <= 1 and answer.contact.vertex.index in (0, 1)
    assert answer.geometry.tolerance < 1e-6 and answer.geometry.segments > 8


def test_the_time_is_told_as_well_as_was_asked_for():
    coarse = taut2d.check(scene_of(taut2d.Path(DISC)), time_tolerance=1e-3)
    fine = taut2d.check(scene_of(taut2d.Path(DISC)))
    assert coarse.geometry.segments < fine.geometry.segments
    assert coarse.contact.t[0] <= fine.contact.t[0] <= fine.contact.t[1] <= coarse.contact.t[1]


def test_segments_may_be_tuples():
    arcs = [((1, 0), (1, 1), 0, False, True, (-1, 0)), (-1 + 0j, 1 + 1j, 0, False, True, 1 + 0j)]
    of_tuples = taut2d.check(scene_of(taut2d.Path(arcs)))
    assert of_tuples.contact.t == taut2d.check(scene_of(taut2d.Path(DISC))).contact.t
    with pytest.raises(taut2d.InputError, match="segment of 5 members"):
        taut2d.Path([(0, 1, 2, 3, 4)])


def test_scenes_keep_their_paths():
    scene = scene_of(taut2d.Path(DISC, "evenodd"))
    again = taut2d.Scene.from_json(scene.to_json())
    assert again.bodies[1].shape == taut2d.Path(DISC, "evenodd")


def test_what_takes_polygons_only_refuses_with_a_remedy():
    with pytest.raises(taut2d.InputError, match=r"taut2d\.flatten\(scene"):
        taut2d.Simulation(scene_of(taut2d.Path(DISC)))
    with pytest.raises(taut2d.InputError, match="before"):
        taut2d.check(scene_of(taut2d.Path("M0 0 X")))


def test_clearance_is_a_bracket():
    found = taut2d.clearance(scene_of(taut2d.Path("M1 3 A1 1 0 0 1 -1 3 A1 1 0 0 1 1 3 Z")))
    assert found.nearest.lo <= 2 <= found.nearest.hi <= 2 + 1e-8


def test_a_profile_holds_the_curves_own_distance():
    profile = taut2d.distance_profile(scene_of(taut2d.Path(DISC)), 6)
    for t, lo, hi in profile.curves[0].instants:
        exact = max(0, math.hypot(10 - t, 1) - 2)
        assert lo <= exact + 1e-14 and exact - 1e-14 <= hi and hi - lo <= 2e-9 * hi + 1e-11
    assert json.loads(profile.json)["geometry"]["tolerance"] < 1e-8


def test_a_bracket_that_is_wide_says_so():
    ring = taut2d.Path("M6 0 A6 6 0 0 1 -6 0 A6 6 0 0 1 6 0 Z M5 0 A5 5 0 0 0 -5 0 A5 5 0 0 0 5 0 Z")
    pin = taut2d.Path("M4.9 0 A4.9 4.9 0 0 1 -4.9 0 A4.9 4.9 0 0 1 4.9 0 Z")
    text = {"format": "taut-scene/1", "time": [0, 1],
            "bodies": [{"name": "hub", "polygon": ring._json()}, {"name": "pin", "polygon": pin._json()}]}
    found = taut2d.clearance(taut2d.Scene.from_json(json.dumps(text)))
    assert found.nearest.lo <= 0.1 + 1e-12 and found.nearest.hi >= 0.1 - 1e-12
    assert "run along each other" in found.wide
    assert taut2d.clearance(scene_of(taut2d.Path(DISC))).wide is None

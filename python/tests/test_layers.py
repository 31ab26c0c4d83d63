"""Layers of bodies and parts."""

import pytest

import taut2d
from taut2d import Body, Part, Path, Scene, Velocity

SQUARE = [(0, 0), (1, 0), (1, 1), (0, 1)]


def scene(*bodies):
    return Scene(bodies, (0, 10))


def test_bodies_meet_on_common_layers_only():
    low = Body("low", SQUARE, z=(0, 3))
    high = Body("high", [(x + 4, y) for x, y in SQUARE], Velocity((-1, 0)), z=(3, 6))
    answer = taut2d.check(scene(low, high))
    assert answer.outcome == "untested" and answer.coverage.layers == 1 and answer.coverage.untested == 1
    assert "1 on different layers" in str(answer)
    through = Body("through", [(x + 4, y) for x, y in SQUARE], Velocity((-1, 0)), z=(2, 6))
    assert taut2d.check(scene(low, through)).contact.t[0] == pytest.approx(3)


def test_parts_have_layers_of_their_own():
    stair = Body("stair", [Part(SQUARE, z=(3, 6)), Part([(x + 1, y) for x, y in SQUARE], z=(0, 3))], Velocity((-1, 0)))
    post = Body("post", [(x - 4, y) for x, y in SQUARE], z=(0, 1))
    given = scene(post, stair)
    assert Scene.from_json(given.to_json()) == given
    assert taut2d.check(given).contact.t[0] == pytest.approx(4)
    flat = scene(post, Body("stair", stair.shape[0:1] + stair.shape[1:], stair.motion))
    assert taut2d.check(flat).contact.t[0] == pytest.approx(4)
    disc = Path("M 1 0 A 1 1 0 0 1 -1 0 A 1 1 0 0 1 1 0 Z", z=(0, 1))
    polygons = taut2d.flatten(Body("disc", [disc, Path(disc.path, z=(5, 6))]), 0.01)
    assert [part.z for part in polygons.shape] == [(0, 1), (5, 6)]


def test_layers_are_two_heights():
    for z in ((3, 3), (3, 1), (1,), "ab"):
        with pytest.raises(taut2d.InputError, match="z"):
            Body("a", SQUARE, z=z)


def test_maps_take_layers():
    from taut2d import StaticMap
    ground = StaticMap([Body("low", SQUARE, z=(0, 3)), Body("high", [(x + 2, y) for x, y in SQUARE], z=(3, 6))])
    robot = ground.prepare(Body("robot", [(x - 0.5, y) for x, y in SQUARE], z=(4, 5)))
    answer = ground.check(robot, Velocity((1, 0)), 0, 5)
    assert answer.pair[0] == "high" and answer.coverage.layers == 1

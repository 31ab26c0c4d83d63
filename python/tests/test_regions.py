"""Regions that moving bodies pass over, against unions of sampled poses by shapely."""

import math

import pytest

import taut2d

shapely = pytest.importorskip("shapely")
from shapely import affinity  # noqa: E402
from shapely.geometry import Polygon, shape  # noqa: E402
from shapely.ops import unary_union  # noqa: E402

CAR = [(-1, -0.9), (3, -0.9), (3, 0.9), (-1, 0.9)]


def test_a_way_against_a_union_of_poses():
    keys = [taut2d.Keyframe(t, x=3 * t, y=math.sin(t), angle_deg=20 * t) for t in range(9)]
    scene = taut2d.Scene(time=(0, 8), bodies=[taut2d.Body("car", CAR, taut2d.Keyframes(keys))])
    region = taut2d.swept(scene, "car", tolerance=0.01)
    whole = shape(region)
    assert whole.is_valid and region.area == pytest.approx(whole.area)
    poses = []
    for k in range(2001):
        t = 8 * k / 2000
        i = min(int(t), 7)
        a, b, share = keys[i], keys[i + 1], t - i
        x, y, deg = (p + share * (q - p) for p, q in ((a.x, b.x), (a.y, b.y), (a.angle_deg, b.angle_deg)))
        poses.append(affinity.translate(affinity.rotate(Polygon(CAR), deg, origin=(0, 0)), x, y))
    sampled = unary_union(poses)
    assert whole.contains(sampled)
    assert whole.difference(sampled.buffer(0.01 + 0.02)).is_empty


def test_a_ring_is_a_polygon_with_a_hole():
    bar = taut2d.Body("bar", [(2, -0.1), (3, -0.1), (3, 0.1), (2, 0.1)], taut2d.Sweep(0, 360))
    region = taut2d.swept(taut2d.Scene(time=(0, 1), bodies=[bar]), "bar")
    assert len(region.parts) == 1 and len(region.parts[0][1]) == 1
    reach = math.hypot(3, 0.1)
    assert math.pi * (reach**2 - 4) <= region.area <= math.pi * ((reach + 0.002)**2 - (2 - 0.002)**2)


def test_faults():
    scene = taut2d.Scene(time=(0, 1), bodies=[taut2d.Body("car", CAR)])
    with pytest.raises(taut2d.InputError, match="there is no body"):
        taut2d.swept(scene, "cart")
    with pytest.raises(taut2d.InputError, match="too small"):
        taut2d.swept(scene, "car", tolerance=1e-10)
    with pytest.raises(taut2d.UndecidedError):
        taut2d.swept(scene, "car", max_seconds=0)

import concurrent.futures
import dataclasses
import json
import math
import pathlib
import random

import pytest
import taut2d
from taut2d import Body, InputError, KeyframeRows, Keyframes, Outcome, Part, StaticMap, Sweep, Velocity, VelocityRows

numpy = pytest.importorskip("numpy")
CART = [(-0.25, -0.25), (0.25, -0.25), (0.25, 0.25), (-0.25, 0.25)]


def star(rng, x, y, size):
    """A polygon with vertices all around (x, y)."""
    count = rng.randrange(3, 8)
    return [(x + size * rng.uniform(0.3, 1) * math.cos(2 * math.pi * (k + rng.uniform(0, 0.5)) / count),
             y + size * rng.uniform(0.3, 1) * math.sin(2 * math.pi * (k + rng.uniform(0, 0.5)) / count))
            for k in range(count)]


def valid_star(rng, x, y, size):
    while True:
        try:
            return taut2d.Shape(star(rng, x, y, size)).parts[0].outline
        except InputError:
            pass


def random_town(rng):
    """Houses on a grid: of one polygon, of two, with a court."""
    houses = []
    for i in range(40):
        x, y = 4 + 4 * (i % 8), 4 + 4 * (i // 8)
        shape = rng.choice([
            valid_star(rng, x, y, 2), [valid_star(rng, x, y, 1), valid_star(rng, x + 1, y, 1)],
            Part([(x - 1, y - 1), (x + 1, y - 1), (x + 1, y + 1), (x - 1, y + 1)],
                 [[(x - 0.5, y - 0.5), (x + 0.5, y - 0.5), (x, y + 0.5)]])])
        houses.append(Body(f"house {i}", shape, id=i if i % 3 else None))
    return houses


def random_motion(rng):
    start, end = ((rng.uniform(0, 30), rng.uniform(0, 16)) for _ in range(2))
    return rng.choice([Keyframes([(0, *start, 0), (1, *end, rng.uniform(-300, 300))]),
                       Keyframes([(0, *start), (0.5, *end), (1, *start)]), Velocity((end[0], end[1]), 90),
                       Sweep(0, 360, pivot=start)])


def plain(answer):
    """What answers of a map and of a scene have in common: all but the counts of pairs."""
    return dataclasses.replace(answer, coverage=None, json="", scene=None)


@pytest.mark.parametrize("touch", ["open", "closed"])
def test_a_map_answers_as_check_does_about_its_scene(touch):
    rng = random.Random(4)
    outcomes = set()
    for _ in range(5):
        town = StaticMap(random_town(rng))
        mover = town.prepare(Body("cart", valid_star(rng, 0, 0, 1), id={"no": 7}))
        for _ in range(20):
            motion = random_motion(rng)
            found = town.check(mover, motion, 0, 1, touch=touch)
            expected = taut2d.check(town.scene(mover, motion, 0, 1), touch=touch, engine="spacetime")
            assert plain(found) == plain(expected)
            object, wanted = json.loads(found.json), json.loads(expected.json)
            assert object.pop("coverage")["pairs"] == 40 and wanted.pop("coverage")
            assert object == wanted
            outcomes.add((found.outcome, found.contact is not None and found.contact.angle_deg is not None))
    assert {("contact", True), ("contact", False), ("free", False), ("overlap_at_start", False)} <= outcomes


def test_rows_are_the_answers_one_by_one():
    rng = random.Random(5)
    town = StaticMap(random_town(rng))
    mover = town.prepare(CART, "cart")
    starts, ends = ([(rng.uniform(0, 30), rng.uniform(0, 16), rng.uniform(0, 90)) for _ in range(300)] for _ in range(2))
    ends_of_time = numpy.array([rng.uniform(0.5, 1) for _ in range(300)])
    for rows in (KeyframeRows.between(starts, ends, pivot=(0.1, 0.2)),
                 VelocityRows([p[:2] for p in ends], 10)):
        found = [town.check_many(mover, rows, 0, ends_of_time, touch="closed", threads=n) for n in (1, 3)]
        assert found[0].tobytes() == found[1].tobytes()
        for k, row in enumerate(found[0]):
            answer = town.check(mover, rows[k], 0, ends_of_time[k], touch="closed")
            assert Outcome(row["outcome"]).name.lower() == answer.outcome
            assert [mover._names[i] for i in row["pair"] if i >= 0] == list(answer.pair or ())
            if answer.contact:
                assert ((row["t_lo"], row["t_hi"]), tuple(row["point"])) == (answer.contact.t, answer.contact.point)
                assert mover._names[row["vertex"]["body"]] == answer.contact.vertex.body
                assert row["edge"]["index"] == answer.contact.edge.index
        assert len(set(found[0]["outcome"])) >= 2
    assert len(town.check_many(mover, numpy.zeros((0, 2, 3)), 0, 1)) == 0


def test_placements_against_shapely():
    shapely = pytest.importorskip("shapely.geometry")
    affinity = pytest.importorskip("shapely.affinity")
    rng = random.Random(6)
    town = StaticMap(random_town(rng))
    shape = valid_star(rng, 0, 0, 1.5)
    mover = town.prepare(shape)
    houses = [shapely.shape(taut2d.Shape(list(body.shape) if isinstance(body.shape, tuple) else body.shape)) for body in town.bodies]
    placements = [(rng.uniform(0, 30), rng.uniform(0, 16), rng.uniform(0, 360)) for _ in range(400)]
    found = town.overlapped_many(mover, placements)
    judged = 0
    for k, (x, y, angle) in enumerate(placements):
        placed = affinity.translate(affinity.rotate(shapely.Polygon(shape), angle, origin=(0, 0)), x, y)
        areas = [house.buffer(0).intersection(placed).area for house in houses]
        if any(0 < area < 1e-9 for area in areas):
            continue
        judged += 1
        assert [i for i, area in enumerate(areas) if area][:1] == ([] if found[k] < 0 else [found[k]])
        name = town.overlapped(mover, Keyframes([(0, x, y, angle)]), 0)
        assert name == (None if found[k] < 0 else f"house {found[k]}")
    assert judged > 390 and len(set(found)) > 10


def test_touching_placements():
    town = StaticMap([Body("a", [(0, 0), (2, 0), (2, 2), (0, 2)])])
    mover = town.prepare([(0, 0), (1, 0), (1, 1), (0, 1)])
    assert town.overlapped(mover, None, 0) == "a"
    at = Keyframes([(0, 2, 0)])
    assert town.overlapped(mover, at, 0) is None and town.overlapped(mover, at, 0, touch="closed") == "a"
    assert town.overlapped_many(mover, [(2, 0), (1, 0)]).tolist() == [-1, 0]
    assert town.overlapped_many(mover, [(2, 0, 0)], touch="closed").tolist() == [0]
    assert repr(town) == "<taut2d.StaticMap of 1 bodies>" and repr(mover) == "<taut2d.Mover 'mover'>" and len(town) == 1


TOWN = StaticMap([Body("house", [(0, 0), (2, 0), (2, 2), (0, 2)])], reach=3)
MOVER = TOWN.prepare(CART)


@pytest.mark.parametrize("question, message", [
    (lambda: TOWN.check(MOVER, Keyframes([(0, 0, 0), (0, 1, 1)]), 0, 1), r"^motion.keyframes\[1\].t: not later"),
    (lambda: TOWN.check(MOVER, 5, 0, 1), "^motion: expected a motion, found int"),
    (lambda: TOWN.check(MOVER, None, 1, 0), "^time: the time interval ends before it starts"),
    (lambda: TOWN.check(MOVER, None, 0, "1"), "^end: expected a number, found str"),
    (lambda: TOWN.check(CART, None, 0, 1), r"^mover: expected a Mover, found list\nhint: map.prepare"),
    (lambda: StaticMap(TOWN.bodies).check(MOVER, None, 0, 1), "^mover: the mover was prepared for another map"),
    (lambda: TOWN.prepare([(0, 0), (1, 1), (1, 0), (0, 1)], "bow"), "^bow: the boundary is not simple"),
    (lambda: TOWN.prepare([(0, 0), (4, 0), (0, 1)]), "^mover: the shape has coordinates beyond the map's reach"),
    (lambda: TOWN.prepare(CART, "house"), "^house: a body of the map has the same name"),
    (lambda: StaticMap([Body("a", CART, Velocity((1, 0)))]), "^a: the body moves, or is relative"),
    (lambda: StaticMap([]), "^bodies: the scene has no bodies"),
    (lambda: StaticMap(TOWN.bodies, reach="far"), "^reach: expected a number"),
    (lambda: TOWN.check_many(MOVER, [[(0, 0, 0)], [(math.nan, 0, 0)]], 0, 1), "^row 1: keyframe 0: a number is not finite"),
    (lambda: TOWN.check_many(MOVER, [[(0, 0, 0)]] * 3, 0, [1, 2]), r"^end: expected an array of the shape \(\) or \(3,\)"),
    (lambda: TOWN.check_many(MOVER, [[(0, 0, 0)]] * 9, 0, [1] * 8 + [-1]), "^row 8: time: the time interval ends"),
    (lambda: TOWN.overlapped_many(MOVER, [(0, 0, 0, 0)]), "^placements: expected an array of the shape"),
    (lambda: TOWN.overlapped_many(MOVER, [(0, 0), (math.inf, 0)]), "^row 1: keyframe 0: a number is not finite"),
    (lambda: TOWN.overlapped(MOVER, None, 0, touch="soft"), "^touch: unknown value")])
def test_errors_say_where(question, message):
    with pytest.raises(InputError, match=message):
        question()


def test_a_mover_that_rests_is_asked_about():
    mover = TOWN.prepare([(1, 1), (3, 1), (3, 3)])
    assert TOWN.check(mover, None, 0, 1).outcome == "overlap_at_start"
    # Bodies of a scene that rest are one group, about which nothing is asked where there are others.
    assert TOWN.scene(mover, None, 0, 1).bodies[1].motion is None


def test_threads_share_a_map():
    rows = [Keyframes([(0, x / 10, -5), (1, x / 10, 5)]) for x in range(-40, 60)]
    expected = [TOWN.check(MOVER, motion, 0, 1) for motion in rows]
    with concurrent.futures.ThreadPoolExecutor(4) as pool:
        assert list(pool.map(lambda motion: TOWN.check(MOVER, motion, 0, 1), rows)) == expected


def test_a_limit_ends_a_question():
    answer = TOWN.check(MOVER, Velocity((1, 1), 0, (9, 9)), -5, 5, max_seconds=0)
    assert answer.outcome == "undecided" and answer.reason


@pytest.mark.parametrize("question", ["town.check(mover, taut2d.Keyframes([(k, 0, 0, 90 * k) for k in range(300000)]), 0, 299999)",
                                      "town.check_many(mover, taut2d.VelocityRows(numpy.zeros((10**6, 2)), 360), 0, 10)"])
def test_control_c_ends_questions(question, interrupt):
    program = f"""
import math, numpy, taut2d
hole = [(1.46 * math.cos(k * math.pi / 12), 1.46 * math.sin(k * math.pi / 12)) for k in range(24)]
town = taut2d.StaticMap([taut2d.Body("a", taut2d.Part([(-9, -9), (9, -9), (9, 9), (-9, 9)], [hole]))])
mover = town.prepare([(-1, -1), (1, -1), (1, 1), (-1, 1)])
print("begun", flush=True)
{question}
"""
    _, errors = interrupt(program)
    assert errors.rstrip().endswith("KeyboardInterrupt")

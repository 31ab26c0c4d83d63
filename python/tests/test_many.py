import pathlib
import random

import pytest
import taut2d
from taut2d import Body, InputError, KeyframeRows, Outcome, Scene, Shape, VelocityRows

numpy = pytest.importorskip("numpy")
root = pathlib.Path(__file__).resolve().parents[2]
ANVIL = Body("anvil", [(0, 0), (4, 0), (4, 1), (0, 1)])
HAMMER = Body("hammer", [(1, 5), (3, 5), (2, 6)])
DROP = Scene([ANVIL, HAMMER], (0, 10))


def star(rng, x, y, size):
    """A random polygon, star-shaped about (x, y)."""
    turns = sorted(rng.random() for _ in range(rng.randrange(3, 9)))
    while max(b - a for a, b in zip(turns, turns[1:] + [turns[0] + 1])) > 0.45:
        turns = sorted(turns + [rng.random()])
    radii = [size * rng.uniform(0.3, 1) for _ in turns]
    return [(x + r * numpy.cos(6.283 * t), y + r * numpy.sin(6.283 * t)) for t, r in zip(turns, radii)]


def pose(rng):
    return (rng.uniform(-4, 4), rng.uniform(-4, 4), rng.choice([0, 90, rng.uniform(-200, 200)]))


def assert_same(row, answer, names):
    """The row says what the answer says."""
    assert Outcome(row["outcome"]).name.lower() == answer.outcome
    contact = answer.contact or answer.touching
    assert bool(row["touching"]) == (answer.touching is not None)
    if contact:
        assert (row["t_lo"], row["t_hi"], bool(row["grazing"])) == (*contact.t, contact.grazing)
        assert (tuple(row["point"]), tuple(row["normal"])) == (contact.point, contact.normal)
        for field, ref in (("vertex", contact.vertex), ("edge", contact.edge)):
            assert tuple(row[field]) == (names.index(ref.body), ref.part, ref.ring, ref.index)
    else:
        assert numpy.isnan(row["t_lo"]) and row["vertex"]["index"] == -1 and row["edge"]["body"] == -1
        assert answer.overlap_point == (None if numpy.isnan(row["point"][0]) else tuple(row["point"]))
    assert [names[k] for k in row["pair"] if k >= 0] == list(answer.pair or ())
    if answer.outcome == "undecided":
        assert row["free_until"] == answer.free_until
    assert row["events"] == answer.events


@pytest.mark.parametrize("options", [{}, {"engine": "spacetime", "touch": "closed"}, {"max_events": 3}], ids=str)
def test_rows_are_the_answers_of_check(options):
    rng = random.Random(1)
    seen = set()
    for _ in range(20):
        scene = Scene([Body("a", star(rng, 0, 0, 3)), Body("b", star(rng, 1, 2, 2))], (0, 1))
        rows = KeyframeRows([[(t, *pose(rng)) for t in (0, 0.5, 1)] for _ in range(20)], pivot=(1, 2))
        found = taut2d.check_many(scene, {"b": rows}, **options)
        for k, row in enumerate(found):
            assert_same(row, taut2d.check(scene.with_motion("b", rows[k]), **options), ["a", "b"])
        seen.update(found["outcome"])
    assert len(seen) >= 3


def rack(teeth, up):
    """A comb with many corners, whose tiling takes longer than the rest of a short question."""
    outline = [(k + x, y) for k in range(teeth) for x, y in ((0, 0), (0.2, 2), (0.3, 2), (0.5, 0))] + [(teeth, -1), (0, -1)]
    return outline[::-1] if up else [(x + 0.5, 3 - y) for x, y in outline]


def test_rows_near_each_other_are_asked_by_the_kinetic_engine_as_if_alone():
    rng = random.Random(4)
    scene = Scene([Body("rack", rack(9, True)), Body("comb", rack(9, False))], (0, 1))
    starts = numpy.cumsum([(rng.gauss(0, 0.002), rng.gauss(0, 0.002), rng.gauss(0, 0.2)) for _ in range(150)], axis=0)
    ends = [(rng.uniform(-0.3, 0.3), rng.choice((0, 0, 1, -1)), 0) for _ in starts]
    rows = KeyframeRows.between(starts, starts + ends, pivot=(4, 2))
    for touch in ("open", "closed"):
        found = [taut2d.check_many(scene, {"comb": rows}, engine="kinetic", touch=touch, threads=n) for n in (1, 2, 3)]
        assert len({f.tobytes() for f in found}) == 1
        for k, row in enumerate(found[0]):
            assert_same(row, taut2d.check(scene.with_motion("comb", rows[k]), engine="kinetic", touch=touch), ["rack", "comb"])
        assert set(found[0]["outcome"]) >= {Outcome.FREE, Outcome.CONTACT}


def test_rows_of_worlds():
    rng = random.Random(2)
    plate = Body("plate", taut2d.Part([(-9, -9), (9, -9), (9, 9), (-9, 9)], [[(-6, -6), (-6, 6), (6, 6), (6, -6)]]))
    scene = Scene([plate, Body("a", [star(rng, 0, 0, 2), star(rng, 1, 0, 2)]),
                   Body("b", star(rng, 3, 3, 1), relative_to="a"), Body("c", star(rng, -4, -4, 1))], (0, 1), [("a", "b")])
    a = KeyframeRows.between([(0, 0, 0)], [pose(rng) for _ in range(60)])
    b = VelocityRows([(rng.uniform(-1, 1), rng.uniform(-1, 1)) for _ in range(60)], 30, pivot=(3, 3))
    found = taut2d.check_many(scene, {"a": a, "b": b})
    for k, row in enumerate(found):
        assert_same(row, taut2d.check(scene.with_motion("a", a[k]).with_motion("b", b[k])), ["plate", "a", "b", "c"])
    assert len(set(found["outcome"])) > 1 and len(set(map(tuple, found["pair"]))) > 2


def test_shapes_and_times_of_rows():
    rng = random.Random(3)
    given = [star(rng, 2, 5, 2), taut2d.Part([(0, 5), (4, 5), (4, 9), (0, 9)], [[(1, 6), (2, 6), (2, 7)]]),
             [star(rng, 0, 5, 1), star(rng, 4, 5, 1)], [(1, -3), (2, -3), (2, -2)]]
    shapes = [given[rng.randrange(4)] for _ in range(40)]
    times = [(0, rng.uniform(1, 10)) for _ in shapes]
    fall = DROP.with_motion("hammer", taut2d.Velocity((0, -0.7), 20, (2, 5)))
    found = taut2d.check_many(fall, shapes={"hammer": shapes}, times=times)
    for row, shape, when in zip(found, shapes, times):
        assert_same(row, taut2d.check(Scene([ANVIL, Body("hammer", shape, fall.bodies[1].motion)], when)),
                    ["anvil", "hammer"])
    assert set(found["outcome"]) == {Outcome.FREE, Outcome.CONTACT}


def test_many_scenes(taut):
    paths = [p for p in sorted((root / "examples").glob("*.json")) if not p.name.endswith(".answer.json")]
    scenes = [Scene.load(p) for p in paths]
    for row, scene in zip(taut2d.check_many(iter(scenes)), scenes):
        assert_same(row, taut2d.check(scene), [body.name for body in scene.bodies])


def test_any_number_of_threads_gives_the_same():
    x = numpy.linspace(-5, 5, 3000)
    rows = KeyframeRows.between(numpy.c_[x, 0 * x], numpy.c_[0.5 * x, -7 + 0 * x], (0, 10))
    found = [taut2d.check_many(DROP, {"hammer": rows}, threads=n).tobytes() for n in (1, 2, 5)]
    assert len(set(found)) == 1
    assert len(taut2d.check_many(DROP, {"hammer": rows.values[:0]})) == 0 and len(taut2d.check_many([])) == 0


def test_arrays_of_every_kind():
    expected = taut2d.check_many(DROP, {"hammer": KeyframeRows([[(0, 0, 0), (10, 0, -6)]])})
    for values in (numpy.array([[[0, 0, 0, 0], [10, 0, -6, 0]]], numpy.float32), [[(0, 0, 0), (10, 0, -6)]],
                   numpy.array([[[0, 0, 0, 0], [10, 0, -6, 0]]], ">i2"), numpy.zeros((1, 4, 4))[:, ::2] +
                   [[[0, 0, 0, 0], [10, 0, -6, 0]]]):
        assert taut2d.check_many(DROP, {"hammer": values}).tobytes() == expected.tobytes()
    assert taut2d.check_many(DROP, {"hammer": VelocityRows([(0, -0.6)])})["t_lo"] == pytest.approx(20 / 3)


@pytest.mark.parametrize("arguments, message", [
    (((), {"hammer": [[(0, 0, 0)]]}), "motions: there are many scenes already"),
    ((DROP,), "motions: nothing differs"),
    ((DROP, {"hamster": [[(0, 0, 0)]]}), "motions: there is no body 'hamster'\nhint: bodies are called 'anvil', 'hammer'"),
    ((DROP, {"hammer": [(0, 0, 0)]}), r"motions\['hammer'\]: expected an array of the shape \(rows, keyframes, 3 or 4\), "
                                      r"found \(1, 3\)"),
    ((DROP, {"hammer": "x"}), r"motions\['hammer'\]: expected an array of numbers"),
    ((DROP, {"hammer": [[(0, 0, 0)]], "anvil": [[(0, 0, 0)]] * 2}), "the numbers of rows differ: "),
    ((DROP, {"hammer": [[(0, 0, 0)]] * 700 + [[(0, 0, float("nan"))]]}), "row 700: hammer: keyframe 0: a number is not"),
    ((DROP, [[(0, 0, 0)]]), "motions: expected a dictionary"),
    ((5,), "scene: expected a Scene, or a list of them, found int"), (([DROP, 5],), r"scene\[1\]: expected a Scene, found int"),
    (([DROP, Scene([ANVIL, ANVIL, ANVIL], (0, 1))],), "row 1: bodies: two bodies are called"),
    ((Scene([ANVIL, Body("b", [(0, 0), (1, 1), (1, 0), (0, 1)])], (0, 1)), {"b": [[(0, 0, 0)]]}), "^b: the boundary is not")])
def test_errors_name_the_row(arguments, message):
    with pytest.raises(InputError, match=message):
        taut2d.check_many(*arguments)


def test_the_first_row_at_fault_is_named_by_any_number_of_threads():
    values = numpy.zeros((5000, 2, 3))
    values[:, 1] = (10, 0, -6)
    values[[1234, 1236, 4000], 1, 0] = -1
    for threads in (1, 2, 3, 4):
        with pytest.raises(InputError, match="row 1234: hammer: keyframe 1"):
            taut2d.check_many(DROP, {"hammer": values}, threads=threads)
    shapes = [HAMMER.shape] * 5 + [[(0, 0), (1, 1)]]
    with pytest.raises(InputError, match="row 5: hammer: "):
        taut2d.check_many(DROP, shapes={"hammer": shapes})
    with pytest.raises(InputError, match="threads: 0 is no number"):
        taut2d.check_many(DROP, {"hammer": values}, threads=0)


def test_control_c_ends_many_checks(interrupt):
    program = """
import numpy, taut2d
square = [(-1, -1), (1, -1), (1, 1), (-1, 1)]
scene = taut2d.Scene([taut2d.Body("a", square), taut2d.Body("b", [(x + 4, y) for x, y in square])], (0, 1e5))
rows = taut2d.VelocityRows(numpy.zeros((10**6, 2)), 360)
print("begun", flush=True)
taut2d.check_many(scene, {"a": rows, "b": rows})
"""
    _, errors = interrupt(program)
    assert errors.rstrip().endswith("KeyboardInterrupt")


def test_a_shape_is_what_it_was_made_of():
    shapely = pytest.importorskip("shapely.geometry")
    outline, hole = [(0.0, 0.0), (4.0, 0.0), (4.0, 4.0), (0.0, 4.0)], [(1.0, 1.0), (2.0, 1.0), (2.0, 2.0)]
    part = taut2d.Part(outline, [hole])
    plain = {Body("a", Shape(form)) for form in (outline, numpy.array(outline), numpy.array(outline, "f4"),
                                                 numpy.array(outline * 2)[:4], numpy.array(outline)[:, ::-1][:, ::-1],
                                                 shapely.Polygon(outline), Shape(outline))}
    assert plain == {Body("a", outline)}
    holed = {Body("a", Shape(form)) for form in (part, shapely.Polygon(outline, [hole]), {"outline": outline, "holes": [hole]},
                                                 "POLYGON ((0 0, 4 0, 4 4, 0 4, 0 0), (1 1, 2 1, 2 2, 1 1))")}
    assert holed == {Body("a", part)}
    assert shapely.shape(Shape([part, [(9, 9), (10, 9), (9, 10)]])).area == 16
    assert repr(Shape(part, "lid")) == "<taut2d.Shape 'lid': 7 vertices, 1 parts, 1 holes>"


@pytest.mark.parametrize("shape, message", [
    ([(0, 0), (1, 1), (1, 0), (0, 1)], "lid: the boundary is not simple"), ([(0, 0), (1, 1)], "lid: "),
    (taut2d.Part([(0, 0), (1, 0), (0, 1)], [[(5, 5), (6, 5), (5, 6)]]), "lid: "),
    (taut2d.WktFile("x.wkt"), "shape: a file is read with the scene"), (numpy.zeros((3, 3)), "columns"),
    (numpy.array([["a", "b"]] * 3), "expected an array of numbers"), (5, "expected a shape, found int")], ids=str)
def test_what_is_no_shape(shape, message):
    with pytest.raises(InputError, match=message):
        Shape(shape, "lid")

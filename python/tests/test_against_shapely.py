"""Answers against shapely, which knows nothing of taut: shapes at sampled instants, placed by formulas of this file.

Shapely rounds. What overlaps by less than 1e-9, where coordinates are about 10, is no overlap here, and what is closer than
1e-9 touches. Samples can only contradict an answer, never confirm it.
"""

import math
from bisect import bisect_right

import pytest
import taut2d
from taut2d import Body, KeyframeRows, Outcome, Part, Scene

hypothesis = pytest.importorskip("hypothesis")
pytest.importorskip("shapely")
from hypothesis import assume, given, settings, strategies as st  # noqa: E402
from shapely.affinity import affine_transform  # noqa: E402
from shapely.geometry import MultiPolygon, Polygon  # noqa: E402
from shapely.ops import unary_union  # noqa: E402

SMALL = 1e-9
# The same examples every time: a change is at fault, never the day.
SETTINGS = settings(max_examples=60, deadline=None, derandomize=True,
                    suppress_health_check=list(hypothesis.HealthCheck))


def reals(low, high):
    """Numbers without the ones that nobody writes, of magnitude 1e-300, say, which taut refuses as coordinates."""
    return st.integers(0, 10**6).map(lambda k: low + (high - low) * k / 10**6)


@st.composite
def rings(draw, sizes=(1, 4)):
    """Star-shaped about (0, 0), and not convex as a rule; on a grid at times, where edges are parallel and vertices meet
    edges exactly."""
    count = draw(st.integers(3, 9))
    size = draw(reals(*sizes))
    radii = draw(st.lists(reals(0.25, 1), min_size=count, max_size=count))
    first = draw(reals(0, 1))
    points = [(size * r * math.cos(2 * math.pi * (k + first) / count), size * r * math.sin(2 * math.pi * (k + first) / count))
              for k, r in enumerate(radii)]
    if draw(st.booleans()):
        points = [(round(x * 2) / 2, round(y * 2) / 2) for x, y in points]
    assume(len(set(points)) == count and Polygon(points).is_valid and Polygon(points).area > 0.1)
    return points


@st.composite
def parts(draw):
    """With a hole, at times: the outline, smaller."""
    ring = draw(rings())
    x, y = draw(st.integers(-2, 2)), draw(st.integers(-2, 2))
    moved = [(u + x, v + y) for u, v in ring]
    hole = [(0.5 * u + x, 0.5 * v + y) for u, v in ring]
    if not draw(st.booleans()):
        return Part(moved)
    shape = Polygon(moved, [hole])
    assume(shape.is_valid and Polygon(moved).exterior.distance(Polygon(hole).exterior) > 1e-3)
    return Part(moved, [hole])


numbers = st.one_of(st.integers(-9, 9).map(float), reals(-9, 9))
angles = st.one_of(st.sampled_from([0.0, 90.0, -180.0, 360.0]), reals(-400, 400))


@st.composite
def keyframes(draw):
    """Within [0, 1]."""
    times = sorted(draw(st.sets(st.sampled_from([0.25, 0.5, 0.75]), max_size=2)) | {0.0, 1.0})
    held = draw(st.booleans())
    angle = draw(angles)
    return [(t, draw(numbers), draw(numbers), angle if held else draw(angles)) for t in times]


@st.composite
def scenes(draw):
    """Two to four bodies, one of which may be seen from another one; the first rests."""
    bodies = [Body("b0", draw(st.lists(parts(), min_size=1, max_size=2)))]
    for i in range(1, draw(st.integers(2, 4))):
        parent = draw(st.sampled_from([None, "b1"])) if i > 1 else None
        bodies.append(Body(f"b{i}", draw(parts()), taut2d.Keyframes(draw(keyframes())), parent))
    return Scene(bodies, (0, 1))


def frame(motion, t):
    """(x, y) and the turn, from keyframes."""
    if motion is None:
        return 0, 1
    frames = motion.keyframes
    k = min(max(bisect_right([f.t for f in frames], t), 1), len(frames) - 1)
    a, b = frames[k - 1], frames[k]
    s = (t - a.t) / (b.t - a.t)
    x, y, angle = (p + s * (q - p) for p, q in zip((a.x, a.y, a.angle_deg), (b.x, b.y, b.angle_deg)))
    return complex(x, y), complex(math.cos(math.radians(angle)), math.sin(math.radians(angle)))


def placed(scene, t):
    """What each body is for shapely, at an instant."""
    by_name = {body.name: body for body in scene.bodies}
    found = {}
    for body in scene.bodies:
        origin, turn = frame(body.motion, t)
        if body.relative_to:
            outer_origin, outer_turn = frame(by_name[body.relative_to].motion, t)
            origin, turn = outer_origin + outer_turn * origin, outer_turn * turn
        shape = body.shape if isinstance(body.shape, tuple) else (body.shape,)
        whole = unary_union([Polygon(p.outline, p.holes) for p in shape])
        origin, turn = complex(origin), complex(turn)
        found[body.name] = affine_transform(whole, [turn.real, -turn.imag, turn.imag, turn.real, origin.real, origin.imag])
    return found


def chain(scene, body):
    """How it moves, parents first; who rests adds nothing."""
    outer = chain(scene, next(b for b in scene.bodies if b.name == body.relative_to)) if body.relative_to else []
    rests = body.motion is None or all((f.x, f.y, f.angle_deg % 360) == (0, 0, 0) for f in body.motion.keyframes)
    turns = body.motion is not None and len({f.angle_deg for f in body.motion.keyframes}) > 1
    return outer if rests and not turns else outer + [body.motion]


def pairs_of(scene):
    """Those that are asked about: who moves alike is not, unless there is nobody else."""
    bodies = scene.bodies
    return [(a.name, b.name) for i, a in enumerate(bodies) for b in bodies[i + 1:]
            if len(bodies) == 2 or chain(scene, a) != chain(scene, b)]


def overlap(scene, pair, t):
    shapes = placed(scene, t)
    return shapes[pair[0]].intersection(shapes[pair[1]]).area


def assert_apart(scene, pairs, times):
    for t in times:
        shapes = placed(scene, t)
        for a, b in pairs:
            assert shapes[a].intersection(shapes[b]).area < SMALL, (a, b, t)


def assert_contact(scene, pair, contact, end=1):
    """They touch then, and overlap soon after, unless it is a graze, or too late to see."""
    shapes = placed(scene, contact.t[0])
    assert shapes[pair[0]].distance(shapes[pair[1]]) < SMALL
    later = [contact.t[1] + d for d in (1e-5, 1e-4, 1e-3, 1e-2) if contact.t[1] + d <= end]
    if later and not contact.grazing:
        assert any(overlap(scene, pair, t) > 1e-14 for t in later)


def sampled(start, end, count=12):
    return [start + (end - start) * k / count for k in range(count)]


@SETTINGS
@given(scenes(), st.sampled_from(["kinetic", "spacetime"]))
def test_first_contacts(scene, engine):
    answer = taut2d.check(scene, engine=engine)
    assert answer.outcome != "undecided"
    if answer.outcome == "overlap_at_start":
        shapes = placed(scene, 0)
        assert shapes[answer.pair[0]].distance(shapes[answer.pair[1]]) < SMALL
    elif answer.outcome == "contact":
        assert_apart(scene, pairs_of(scene), sampled(0, answer.contact.t[0]))
        assert_contact(scene, answer.pair, answer.contact)
    else:
        assert_apart(scene, pairs_of(scene), [*sampled(0, 1, 40), 1])


@SETTINGS
@given(scenes())
def test_each_pair(scene):
    answer = taut2d.check(scene, pairs="all")
    for pair in answer.pairs:
        if pair.outcome == "contact":
            assert_apart(scene, [pair.bodies], sampled(0, pair.contact.t[0]))
            assert_contact(scene, pair.bodies, pair.contact)
        elif pair.outcome == "free":
            assert_apart(scene, [pair.bodies], [*sampled(0, 1, 25), 1])


@SETTINGS
@given(scenes())
def test_clearance(scene):
    found = taut2d.clearance(scene, pairs="all")
    assert found.reason is None
    for nearest in found.pairs:
        a, b = nearest.pair
        for t in [*sampled(0, 1, 25), 1]:
            shapes = placed(scene, t)
            assert nearest.lo <= shapes[a].distance(shapes[b]) + SMALL
        shapes = placed(scene, nearest.t[0])
        assert shapes[a].distance(shapes[b]) <= nearest.hi + SMALL
    assert found.nearest.lo == min(nearest.lo for nearest in found.pairs)


@SETTINGS
@given(scenes())
def test_intervals(scene):
    found = taut2d.intervals(scene)
    assert not found.undecided
    for pair in pairs_of(scene):
        spans = [i for i in found.intervals if set(i.pair) == set(pair)]
        for t in [*sampled(0, 1, 40), 1]:
            area = overlap(scene, pair, t)
            if any(i.start[1] < t < i.end[0] for i in spans):
                # Shapely may miss what is thin; that they touch it cannot.
                shapes = placed(scene, t)
                assert area > 0 or shapes[pair[0]].distance(shapes[pair[1]]) < SMALL
            elif not any(i.start[0] <= t <= i.end[1] for i in spans):
                assert area < SMALL, (pair, t)


@SETTINGS
@given(scenes())
def test_closed_touching(scene):
    answer = taut2d.check(scene, touch="closed")
    opened = taut2d.check(scene)
    first = {"overlap_at_start": 0, "contact": answer.contact and answer.contact.t[0], "free": 2}
    later = {"overlap_at_start": 0, "contact": opened.contact and opened.contact.t[1], "free": 2}
    assert first[answer.outcome] <= later[opened.outcome]
    if answer.outcome == "contact":
        shapes = placed(scene, answer.contact.t[0])
        assert shapes[answer.pair[0]].distance(shapes[answer.pair[1]]) < SMALL
    if answer.outcome != "overlap_at_start":
        for t in sampled(0, min(first[answer.outcome], 1)):
            shapes = placed(scene, t)
            # Not even closed shapes have a point in common, by more than shapely's rounding.
            assert all(shapes[a].intersection(shapes[b]).area < SMALL for a, b in pairs_of(scene))


@SETTINGS
@given(scenes(), reals(0, 1))
def test_range(scene, around):
    try:
        found = taut2d.range(scene, around)
    except taut2d.InputError:
        shapes = placed(scene, around)
        assert min(shapes[a].distance(shapes[b]) for a, b in pairs_of(scene)) < SMALL
        return
    start = 0 if found.start is None else found.start[1]
    end = 1 if found.end is None else found.end[0]
    assert start <= around <= end
    assert_apart(scene, pairs_of(scene), [*sampled(start, end), end])
    for span, t in ((found.before, found.start and found.start[0]), (found.after, found.end and found.end[1])):
        if span is not None:
            shapes = placed(scene, t)
            assert shapes[span.pair[0]].distance(shapes[span.pair[1]]) < SMALL


@SETTINGS
@given(parts(), parts(), st.lists(keyframes().filter(lambda k: len(k) == 3), min_size=1, max_size=6))
def test_many_rows(a, b, given_rows):
    scene = Scene([Body("a", a), Body("b", b)], (0, 1))
    rows = KeyframeRows(given_rows)
    for k, row in enumerate(taut2d.check_many(scene, {"b": rows}, threads=2)):
        alone = scene.with_motion("b", rows[k])
        if row["outcome"] == Outcome.FREE:
            assert_apart(alone, [("a", "b")], sampled(0, 1))
        elif row["outcome"] == Outcome.CONTACT:
            assert_apart(alone, [("a", "b")], sampled(0, row["t_lo"]))
            shapes = placed(alone, row["t_lo"])
            assert shapes["a"].distance(shapes["b"]) < SMALL


@SETTINGS
@given(parts(), parts(), st.integers(-5, 5), st.integers(-5, 5))
def test_shapes_go_to_shapely_and_back(a, b, x, y):
    """The area is that of the rings; so is what shapely makes of two of them."""
    both = unary_union([Polygon(a.outline, a.holes), Polygon([(u + x, v + y) for u, v in b.outline])])
    polygons = both.geoms if isinstance(both, MultiPolygon) else [both]
    assume(all(p.buffer(-1e-6).area > 0 for p in polygons))
    try:
        shape = taut2d.Shape(both)
    except taut2d.InputError:
        # Shapely allows rings that touch in a point; taut refuses them with the place.
        touching = [r.distance(s) == 0 for p in polygons for i, r in enumerate([p.exterior, *p.interiors])
                    for s in [p.exterior, *p.interiors][i + 1:]]
        assert any(touching)
        return
    area = sum(Polygon(p.outline, p.holes).area for p in shape.parts)
    assert area == pytest.approx(both.area, rel=1e-12)

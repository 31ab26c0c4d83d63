"""Tests the contact sequences of followers against an exact envelope.

Usage: follow_test.py TAUT

Of translations, the oracle computes in rational numbers, by definition: at an instant, the lift is the greatest height of
the cam's upper sides above the follower's lower sides, over all verticals. What touches may change only where a polynomial
in the time is zero: where two vertices are above each other, or where a vertex on the line of an edge is as high as another
one is. All of these zeros are isolated by Sturm's theorem; between two of them, one instant says what touches.

Of rotations, instants are sampled, in doubles. Laws without an oracle: the time reversed, the scene mirrored, the follower
and the cam cut into parts, the scene moved and turned as a whole.
"""

import json
import math
import os
import random
import subprocess
import sys
import tempfile
from fractions import Fraction as Q

TAUT = os.path.abspath(sys.argv[1])
EFFORT = {"tenth": 0.1}.get(os.environ.get("TAUT_EFFORT", ""), 1.0)
NARROW = Q(1, 2 ** 46)


def ask(scene, body="follower", reach=100, tolerance=1e-9, extra=()):
    with tempfile.TemporaryDirectory() as folder:
        name = os.path.join(folder, "scene.json")
        with open(name, "w", encoding="utf-8") as file:
            json.dump({"format": "taut-scene/1", **scene}, file)
        run = subprocess.run([TAUT, "follow", name, "--body", body, "--reach", str(reach), "--contacts", "--instants", "1",
                              "--tolerance", repr(tolerance), "--json", *extra], capture_output=True, text=True, check=False)
    if run.returncode not in (0, 3):
        raise AssertionError(f"exit code {run.returncode}: {run.stderr}\n{json.dumps(scene)}")
    return json.loads(run.stdout)


def contact_of(value):
    def feature(f):
        return (f["body"], f.get("part", 0), f.get("ring", 0), f["index"])
    return feature(value["vertex"]), feature(value["edge"])


def touching(stretch):
    return frozenset(contact_of(c) for c in stretch["touching"])


def covered(sequence, start, end):
    assert sequence[0]["t"][0] == start and sequence[-1]["t"][1] == end
    for one, two in zip(sequence, sequence[1:]):
        assert one["t"][1] == two["t"][0], (one, two)
    for one in sequence:
        assert one["t"][0] <= one["t"][1] and one["lift"][0] <= one["lift"][1], one


# Polynomials, ascending, of rational numbers.

def add(a, b, sign=1):
    n = max(len(a), len(b))
    c = [(a[i] if i < len(a) else Q(0)) + sign * (b[i] if i < len(b) else Q(0)) for i in range(n)]
    while c and c[-1] == 0:
        c.pop()
    return c


def times(a, k):
    return [x * k for x in a] if k else []


def value(a, t):
    v = Q(0)
    for x in reversed(a):
        v = v * t + x
    return v


def remainder(a, b):
    a = list(a)
    while len(a) >= len(b):
        k = a[-1] / b[-1]
        for i, x in enumerate(b):
            a[len(a) - len(b) + i] -= k * x
        a.pop()
        while a and a[-1] == 0:
            a.pop()
    return a


def sturm(a):
    chain = [a, [x * i for i, x in enumerate(a)][1:]]
    while len(chain[-1]) > 1:
        r = remainder(chain[-2], chain[-1])
        if not r:
            break
        chain.append([-x for x in r])
    return [p for p in chain if p]


def changes_at(chain, t):
    signs = [s for s in ((v > 0) - (v < 0) for v in (value(p, t) for p in chain)) if s]
    return sum(1 for a, b in zip(signs, signs[1:]) if a != b)


def zeros(a, start, end):
    """Intervals that contain one zero each, no wider than NARROW, of all zeros in [start, end]."""
    if len(a) < 2:
        return []
    if len(a) == 2:
        t = -a[0] / a[1]
        return [(t, t)] if start <= t <= end else []
    found = [(t, t) for t in (start, end) if value(a, t) == 0]
    chain = sturm(a)
    todo = [(start, end, changes_at(chain, start), changes_at(chain, end))]
    while todo:
        lo, hi, at_lo, at_hi = todo.pop()
        if at_lo == at_hi:
            continue
        if hi - lo <= NARROW:
            found.append((lo, hi))
            continue
        middle = (lo + hi) / 2
        at = changes_at(chain, middle)
        todo += [(lo, middle, at_lo, at), (middle, hi, at, at_hi)]
    return found


class Scene:
    """A cam that moves by polynomials, under a follower at rest: the x axis is across the direction."""

    def __init__(self, cam, follower, x, y):
        self.x, self.y = x, y
        self.cam, self.follower = ([(Q(p[0]), Q(p[1])) for p in points] for points in (cam, follower))

    def json(self):
        def numbers(polynomial):
            return [float(v) for v in polynomial]

        def outline(points):
            return [numbers(p) for p in points]
        return {"time": [0, 1], "bodies": [
            {"name": "cam", "polygon": outline(self.cam), "motion": {"x": numbers(self.x), "y": numbers(self.y)}},
            {"name": "follower", "polygon": outline(self.follower)}]}

    def lines(self):
        """Of each vertex and each edge of the other body that may face it: the lift, as a polynomial."""
        all_lines = []
        for below, points, edges in ((True, self.follower, self.cam), (False, self.cam, self.follower)):
            for p in points:
                for k, a in enumerate(edges):
                    b = edges[(k + 1) % len(edges)]
                    if a[0] == b[0]:
                        continue
                    slope = Q(b[1] - a[1]) / Q(b[0] - a[0])
                    # The height of the edge's line at the vertex: y_a + slope (x_p - x_a).
                    if below:
                        lift = add(self.y, add(times(self.x, -slope), [Q(a[1]) + slope * (p[0] - a[0]) - p[1]]))
                    else:
                        lift = add(self.y, add(times(self.x, -slope), [p[1] - Q(a[1]) - slope * (p[0] - a[0])]))
                    all_lines.append(lift)
        return [list(p) for p in {tuple(p) for p in all_lines}]

    def critical(self):
        polynomials = set()
        for p in self.follower:
            for q in self.cam:
                polynomials.add(tuple(add(self.x, [Q(q[0] - p[0])])))
        lines = self.lines()
        for i, one in enumerate(lines):
            polynomials.add(tuple(one))
            for two in lines[:i]:
                polynomials.add(tuple(add(one, two, -1)))
        found = {(Q(0), Q(0)), (Q(1), Q(1))}
        for p in polynomials:
            found.update(zeros(list(p), Q(0), Q(1)))
        joined = []
        for lo, hi in sorted(found):
            if joined and lo <= joined[-1][1]:
                joined[-1] = (joined[-1][0], max(hi, joined[-1][1]))
            else:
                joined.append((lo, hi))
        return joined

    def at(self, t):
        """The lift, and what touches. Nothing where no vertical meets both bodies."""
        dx, dy = value(self.x, t), value(self.y, t)
        cam = [(p[0] + dx, p[1] + dy) for p in self.cam]
        follower = [(Q(p[0]), Q(p[1])) for p in self.follower]
        levels = sorted({p[0] for p in cam + follower})
        best, contacts = None, set()

        def spanning(points, lo, hi):
            for k, a in enumerate(points):
                b = points[(k + 1) % len(points)]
                if min(a[0], b[0]) <= lo and hi <= max(a[0], b[0]):
                    yield k, a, b

        def height(a, b, x):
            return a[1] + (b[1] - a[1]) * (x - a[0]) / (b[0] - a[0])

        for lo, hi in zip(levels, levels[1:]):
            for i, a, b in spanning(cam, lo, hi):
                for k, c, d in spanning(follower, lo, hi):
                    for x in (lo, hi):
                        lift = height(a, b, x) - height(c, d, x)
                        if best is not None and lift < best:
                            continue
                        if best is None or lift > best:
                            best, contacts = lift, set()
                        for index, point in ((i, a), ((i + 1) % len(cam), b)):
                            if point[0] == x:
                                contacts.add((("cam", 0, 0, index), ("follower", 0, 0, k)))
                        for index, point in ((k, c), ((k + 1) % len(follower), d)):
                            if point[0] == x:
                                contacts.add((("follower", 0, 0, index), ("cam", 0, 0, i)))
        if best is None or best < 0:
            return None, frozenset()
        return best, frozenset(contacts)

    def sequence(self):
        """(from, to, contacts, lift at the first and at the last instant) with both instants in brackets."""
        critical = self.critical()
        stretches = []
        for (_, lo), (hi, _) in zip(critical, critical[1:]):
            if not lo < hi:
                continue
            contacts = self.at((lo + hi) / 2)[1]
            if stretches and stretches[-1][2] == contacts:
                stretches[-1] = (stretches[-1][0], hi, contacts)
            else:
                stretches.append((lo, hi, contacts))
        return stretches


def judge(scene, tolerance=1e-9):
    answer = ask(scene.json(), tolerance=tolerance)
    sequence, true = answer["contacts"], scene.sequence()
    where = json.dumps(scene.json())
    covered(sequence, 0, 1)
    eps = Q(1, 2 ** 40)
    for k, one in enumerate(sequence):
        lo, hi = Q(one["t"][0]), Q(one["t"][1])
        if one["state"] == "open":
            raise AssertionError(f"open on {one['t']}: {answer.get('contacts_reason')}\n{where}")
        inside = [s for s in true if s[1] > lo + eps and s[0] < hi - eps]
        if one["state"] in ("carried", "low"):
            assert len(inside) == 1 or hi - lo < eps, f"{one}\n{inside}\n{where}"
            for s in inside:
                assert s[2] == touching(one), f"{one}\n{s}\n{where}"
                for share in (Q(1, 7), Q(1, 2), Q(6, 7)):
                    lift = scene.at(lo + (hi - lo) * share)[0]
                    if lift is not None:
                        assert Q(one["lift"][0]) <= lift <= Q(one["lift"][1]), f"{one}\n{float(lift)}\n{where}"
        else:
            assert hi - lo <= tolerance, f"{one}\n{where}"
            around = [s for s in true if s[1] >= lo - eps and s[0] <= hi + eps]
            for s in around:
                if s[1] > lo and s[0] < hi and s[2]:
                    assert s[2] <= touching(one), f"{one}\n{s}\n{where}"
            if one.get("once"):
                assert len(around) == 2, f"{one}\n{around}\n{where}"
                assert [around[0][2], around[1][2]] == [touching(sequence[k - 1]), touching(sequence[k + 1])], where
            if one.get("jumps"):
                a, b = scene.at(around[0][1] - eps)[0], scene.at(around[-1][0] + eps)[0]
                assert abs((a or 0) - (b or 0)) > Q(1, 2 ** 30), f"{one}\n{where}"
            elif one.get("once"):
                a, b = scene.at(around[0][1] - eps)[0], scene.at(around[-1][0] + eps)[0]
                assert abs((a or 0) - (b or 0)) < Q(1, 2 ** 10), f"{one} does not jump: {a} {b}\n{where}"
    # Nothing is missed.
    for lo, hi, contacts in true:
        if hi - lo < 4 * tolerance:
            continue
        middle = (lo + hi) / 2
        one = next(s for s in sequence if Q(s["t"][0]) <= middle <= Q(s["t"][1]))
        assert touching(one) == contacts, f"{one}\n{contacts}\n{where}"
    return sequence


def shape(rng, n, radius, grid):
    """A star-shaped polygon, or one whose corners are on a grid."""
    if grid:
        kind = rng.randrange(4)
        a, b = rng.randint(1, 3), rng.randint(1, 3)
        if kind == 0:
            return [[-a, -b], [a, -b], [a, b], [-a, b]]
        if kind == 1:  # a step
            return [[-a, 0], [a + 1, 0], [a + 1, 1], [0, 1], [0, b + 1], [-a, b + 1]]
        if kind == 2:  # a fork, upwards
            return [[-2, -1], [2, -1], [2, b], [1, b], [1, 0], [-1, 0], [-1, b], [-2, b]]
        return [[-2, b + 1], [-2, -1], [-1, -1], [-1, b], [1, b], [1, -1], [2, -1], [2, b + 1]]  # downwards
    angles = sorted(rng.uniform(0, 2 * math.pi) for _ in range(n))
    while max((b - a) % (2 * math.pi) for a, b in zip(angles, angles[1:] + angles[:1])) > 2.9:
        angles = sorted(rng.uniform(0, 2 * math.pi) for _ in range(n))
    points = []
    for angle in angles:
        r = radius * rng.uniform(0.4, 1)
        points.append([round(r * math.cos(angle) * 16) / 16, round(r * math.sin(angle) * 16) / 16])
    return points


def simple(points):
    def cross(a, b, c):
        return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])
    n = len(points)
    if any(cross([0, 0], points[k], points[(k + 1) % n]) <= 0 for k in range(n)):
        return False
    return all(cross(points[k], points[(k + 1) % n], points[(k + 2) % n]) != 0 for k in range(n))


def exact_scenes(count):
    rng = random.Random(7)
    stretches = 0
    for number in range(count):
        grid = number % 3 == 0
        cam, follower = shape(rng, 7, 4, grid), shape(rng, 5, 2, grid)
        if not grid and not (simple(cam) and simple(follower)):
            continue
        degree = rng.randrange(0 if grid else 1, 4)

        def polynomial(size, terms):
            return [Q(rng.randint(-size * 4, size * 4), 4 if not grid else 1) for _ in range(terms + 1)]
        x = polynomial(3, degree) if not (grid and rng.random() < 0.3) else [Q(rng.randint(-2, 2))]
        y = polynomial(2, rng.randrange(3))
        scene = Scene(cam, [[p[0], p[1] + 2] for p in follower], add(x, []), add(y, []))
        stretches += len(judge(scene))
    print(f"exact envelopes: {stretches} stretches")
    assert stretches > 2 * count


def star(rng, n, radius):
    while True:
        points = shape(rng, n, radius, False)
        if simple(points):
            return points


def placed(points, pose):
    x, y, c, s = pose
    return [(x + c * p[0] - s * p[1], y + s * p[0] + c * p[1]) for p in points]


def sampled(cam, follower):
    """The lift of one polygon above another one, by definition, in doubles, and what has it up to rounding."""
    best, lifts = -math.inf, []
    for below, points, edges in ((True, follower, cam), (False, cam, follower)):
        for i, p in enumerate(points):
            for k, a in enumerate(edges):
                b = edges[(k + 1) % len(edges)]
                lo, hi = min(a[0], b[0]), max(a[0], b[0])
                if not lo <= p[0] <= hi or lo == hi:
                    continue
                height = a[1] + (b[1] - a[1]) * (p[0] - a[0]) / (b[0] - a[0])
                lift = height - p[1] if below else p[1] - height
                names = ("follower", "cam") if below else ("cam", "follower")
                lifts.append((lift, ((names[0], 0, 0, i), (names[1], 0, 0, k))))
                best = max(best, lift)
    return best, {name for lift, name in lifts if lift > best - 1e-9}, lifts


def turning(rng):
    """A cam that turns and moves, and a follower, as a scene and as functions of the time."""
    cam, follower = star(rng, rng.randint(4, 12), 4), [[x, y + 4] for x, y in star(rng, rng.randint(3, 7), 2)]
    rates = [rng.uniform(-1, 1), rng.uniform(-6, 6), rng.uniform(-2, 2)]
    x, y = [rng.uniform(-1, 1), rng.uniform(-2, 2)], [rng.uniform(-1, 1), rng.uniform(-1, 1)]
    scene = {"time": [0, 1], "bodies": [
        {"name": "cam", "polygon": cam, "motion": {"x": x, "y": y, "rotation": {"angle": rates}}},
        {"name": "follower", "polygon": follower}]}

    def pose(t):
        angle = rates[0] + rates[1] * t + rates[2] * t * t
        return x[0] + x[1] * t, y[0] + y[1] * t, math.cos(angle), math.sin(angle)
    return scene, cam, follower, pose


def rotations(count):
    rng = random.Random(11)
    stretches = changes = once = jumps = 0
    for _ in range(count):
        scene, cam, follower, pose = turning(rng)
        sequence = ask(scene)["contacts"]
        covered(sequence, 0, 1)
        where = json.dumps(scene)
        stretches += len(sequence)
        for one in sequence:
            assert one["state"] != "open", f"{one}\n{where}"
            changes += one["state"] == "change"
            once += "once" in one
            jumps += "jumps" in one
        for k in range(2000):
            t = rng.random()
            lift, names, _ = sampled(placed(cam, pose(t)), follower)
            one = next(s for s in sequence if s["t"][0] <= t <= s["t"][1])
            if lift < -1e-9:
                assert one["state"] in ("low", "change"), f"{t} {lift} {one}\n{where}"
            elif lift > 1e-9:
                assert one["lift"][0] - 1e-9 <= lift <= one["lift"][1] + 1e-9, f"{t} {lift} {one}\n{where}"
                assert touching(one) & names, f"{t} {names} {one}\n{where}"
                assert one["state"] == "change" or len(touching(one)) == 1, f"{one}\n{where}"
    print(f"rotations: {stretches} stretches, {changes} changes, {once} of them once, {jumps} jumps")
    assert once > 0.9 * changes and (jumps > 0 or count < 100)


def alike(one, two, rename=lambda c: c, of_time=lambda t: t, backwards=False):
    """Do two sequences say the same, up to the tolerance of the changes?"""
    two = list(reversed(two)) if backwards else two
    short = 4e-9

    def stretches(sequence, name, time):
        found = []
        for s in sequence:
            if s["state"] in ("carried", "low"):
                lo, hi = sorted(time(t) for t in s["t"])
                found.append((lo, hi, frozenset(name(c) for c in touching(s))))
        return found
    a, b = stretches(one, lambda c: c, lambda t: t), stretches(two, rename, of_time)
    assert len(a) == len(b), (a, b)
    for s, r in zip(a, b):
        assert abs(s[0] - r[0]) < short and abs(s[1] - r[1]) < short and s[2] == r[2], (s, r)


def laws(count):
    rng = random.Random(13)
    for _ in range(count):
        scene, cam, follower, _ = turning(rng)
        motion = scene["bodies"][0]["motion"]
        first = ask(scene)["contacts"]

        # The time reversed: polynomials in 1 - t.
        def reversed_polynomial(c):
            c = list(c) + [0] * (3 - len(c))
            return [c[0] + c[1] + c[2], -c[1] - 2 * c[2], c[2]]
        back = json.loads(json.dumps(scene))
        back["bodies"][0]["motion"] = {"x": reversed_polynomial(motion["x"]), "y": reversed_polynomial(motion["y"]),
                                       "rotation": {"angle": reversed_polynomial(motion["rotation"]["angle"])}}
        alike(first, ask(back)["contacts"], of_time=lambda t: 1 - t, backwards=True)

        # Mirrored at the y axis: vertex k becomes n - 1 - k, and edge k becomes n - 2 - k.
        n = {"cam": len(cam), "follower": len(follower)}
        mirrored = json.loads(json.dumps(scene))
        for body in mirrored["bodies"]:
            body["polygon"] = [[-x, y] for x, y in reversed(body["polygon"])]
        mirrored["bodies"][0]["motion"] = {"x": [-v for v in motion["x"]], "y": motion["y"],
                                           "rotation": {"angle": [-v for v in motion["rotation"]["angle"]]}}

        def of_mirror(contact):
            (b, _, _, i), (e, _, _, k) = contact
            return (b, 0, 0, n[b] - 1 - i), (e, 0, 0, (2 * n[e] - 2 - k) % n[e])
        alike(first, ask(mirrored)["contacts"], rename=of_mirror)

        # Both on a table that turns and moves: the follower is seen from it.
        table = {"name": "table", "polygon": [[0, 0], [1, 0], [0, 1]],
                 "motion": {"x": [3, 1], "y": [-2, 5], "rotation": {"angle": [1, 2]}}}
        carried = {"time": [0, 1], "bodies": [table] + [{**b, "relative_to": "table"} for b in scene["bodies"]],
                   "ignore": [["table", "*"]]}
        alike(first, ask(carried)["contacts"])

        # The follower as its triangles about the centre, and the cam, too: the same edges, with other numbers.
        for name, centre in (("follower", [0, 4]), ("cam", [0, 0])):
            parts = json.loads(json.dumps(scene))
            body = next(b for b in parts["bodies"] if b["name"] == name)
            points = body.pop("polygon")
            body["parts"] = [{"outline": [points[k], points[(k + 1) % len(points)], centre]} for k in range(len(points))]
            m = len(points)

            def whole(feature, is_vertex, name=name, m=m):
                body, part, _, index = feature
                if body != name:
                    return feature
                return (body, 0, 0, (part + index) % m) if is_vertex else (body, 0, 0, part)
            alike(first, ask(parts)["contacts"], rename=lambda c, w=whole: (w(c[0], True), w(c[1], False)))
    print(f"laws: {count} scenes")


def known():
    """Scenes whose answers are known by hand."""
    square = {"name": "cam", "polygon": [[-1, -1], [1, -1], [1, 1], [-1, 1]]}
    plate = {"name": "follower", "polygon": [[-3, 1], [3, 1], [3, 2], [-3, 2]]}
    # A block goes straight up under a plate: an edge on an edge, all the time.
    up = ask({"time": [0, 1], "bodies": [{**square, "motion": {"y": [0.5, 1]}}, plate]})["contacts"]
    assert [s["state"] for s in up] == ["carried"], up
    assert touching(up[0]) == {(("cam", 0, 0, 2), ("follower", 0, 0, 0)), (("cam", 0, 0, 3), ("follower", 0, 0, 0))}
    # It comes from below: nothing is lifted until then. From 0 on, the lift is as it was at the start.
    late = ask({"time": [0, 1], "bodies": [{**square, "motion": {"y": [-0.5, 1]}}, plate]})["contacts"]
    assert [s["state"] for s in late] == ["low", "change", "carried"] and late[1]["once"] and "jumps" not in late[1]
    # It slides away beside an edge as wide as itself: the sides along the direction are no contacts.
    wall = {"name": "wall", "polygon": [[1, -1], [2, -1], [2, 5], [1, 5]]}
    block = {"name": "follower", "polygon": [[-1, 1], [1, 1], [1, 2], [-1, 2]]}
    beside = ask({"time": [0, 1], "bodies": [{**square, "motion": {"y": [0.5, 0.5]}}, wall, block]})["contacts"]
    assert [s["state"] for s in beside] == ["carried"] and len(beside[0]["touching"]) == 4, beside
    # A table leaves: the follower falls from its edge.
    falls = ask({"time": [0, 4], "bodies": [{**square, "motion": {"y": [1], "x": [0, -1]}}, block]})["contacts"]
    assert [s["state"] for s in falls] == ["change", "carried", "change", "low"], falls
    assert falls[2]["once"] and falls[2]["jumps"] and falls[2]["t"][0] <= 2 <= falls[2]["t"][1]
    # A rod on two towers of the same height, which move to and fro: both, all the time.
    towers = [{"name": f"tower {k}", "polygon": [[x, 0], [x + 1, 0], [x + 0.5, 1]], "motion": {"y": [1, 1, -1]}}
              for k, x in enumerate((-2, 1))]
    both = ask({"time": [0, 1], "bodies": [*towers, plate]})["contacts"]
    assert [s["state"] for s in both] == ["carried"] and len(both[0]["touching"]) == 2, both
    # A square that turns: a corner each, and all changes at quarter turns.
    turns = ask({"time": [-0.125, 0.875], "bodies": [
        {**square, "motion": {"sweep": {"pivot": [0, 0], "from_deg": -45, "to_deg": 315}}}, plate]})["contacts"]
    corners = [touching(s) for s in turns if s["state"] == "carried"]
    assert [next(iter(c))[0] for c in corners] == [("cam", 0, 0, k) for k in (3, 2, 1, 0, 3)], corners
    assert [s["once"] for s in turns if s["state"] == "change"] == [True] * 4
    print("known answers")


def main():
    known()
    rotations(max(10, int(100 * EFFORT)))
    laws(max(5, int(40 * EFFORT)))
    exact_scenes(max(20, int(300 * EFFORT)))


main()

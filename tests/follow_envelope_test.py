"""Tests the contact sequences of followers of translated cams against an exact envelope.

Usage: follow_envelope_test.py TAUT

The oracle computes in rational numbers, by definition: at an instant, the lift is the greatest height of the cam's upper sides
above the follower's lower sides, over all verticals. What touches may change only where a polynomial in the time is zero: where
two vertices are above each other, or where a vertex on the line of an edge is as high as another one is. All of these zeros are
isolated by Sturm's theorem; between two of them, one instant says what touches.
"""

import json
import random
from fractions import Fraction as Q

from follow_sequences import EFFORT, ask, covered, shape, simple, touching

NARROW = Q(1, 2 ** 46)

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


exact_scenes(max(20, int(300 * EFFORT)))

"""Two bodies of a scene, displaced: functions of three vertices, ranges of edges, and whether they overlap."""

import math

from balls import BITS, ONE, Sampled, Undecided, add, exact, jadd, jconst, jmul, jsub, keeps_sign, mul, root, sign, sub
from bodies import less, orientation
from legs import legs_of, repeats_from


def product(a, b):
    """Of two integers times 2^-BITS: a ball."""
    return (a * b) >> BITS, 1


class Range:
    """Some edges: a run along a ring, or several rings."""

    def __init__(self, vertices, along, first, halves):
        self.vertices, self.along, self.first, self.halves = vertices, along, first, halves
        self.known = {}


def run_range(body, offset, n, first, count):
    """`count` edges of the ring of n vertices at `offset`."""
    vertices = [offset + (first + k) % n for k in range(count + 1)]
    a, b = body.points[vertices[0]], body.points[vertices[-1]]
    x, y = b[0] - a[0], b[1] - a[1]
    r = math.sqrt(x * x + y * y)
    halves = None
    if count > 1:
        halves = (run_range(body, offset, n, first, count // 2),
                  run_range(body, offset, n, first + count // 2, count - count // 2))
    return Range(sorted(set(vertices)), (x / r, y / r) if r > 0 else (1.0, 0.0), vertices[0], halves)


def rings_range(body, rings):
    """Rings are (offset, number of vertices)."""
    if len(rings) == 1:
        return run_range(body, *rings[0], 0, rings[0][1])
    vertices = [offset + k for offset, n in rings for k in range(n)]

    def extent(axis, of):
        c = [body.points[v][axis] for v in of]
        return min(c), max(c)

    (left, right), (low, high) = extent(0, vertices), extent(1, vertices)
    axis = 0 if right - left >= high - low else 1
    order = sorted(rings, key=lambda r: (sum(extent(axis, range(r[0], r[0] + r[1]))), r[0]))
    half = len(order) // 2
    return Range(vertices, (1.0, 0.0), None, (rings_range(body, order[:half]), rings_range(body, order[half:])))


def ranges_of(body):
    rings, offset = [], 0
    for ring in body.rings:
        rings.append((offset, len(ring.names)))
        offset += len(ring.names)
    return rings_range(body, rings)


def hull(points):
    """The indices of those that may be farthest in some direction."""
    order = sorted(range(len(points)), key=lambda k: points[k])
    out = []
    for run in (order, order[::-1]):
        half = []
        for k in run:
            while len(half) > 1 and orientation(points[half[-2]], points[half[-1]], points[k]) <= 0:
                half.pop()
            half.append(k)
        out += half[:-1]
    return out or order[:1]


class Pair:
    """P and Q; vertices of P, then of Q. All of it is independent of logs, and so is what was found out about it."""

    def __init__(self, scene, a, b, inwards):
        if scene.bodies[b].diameter > scene.bodies[a].diameter:
            a, b = b, a
        self.bodies = scene.bodies[a], scene.bodies[b]
        self.np, self.size = (len(self.bodies[0].points), sum(len(body.points) for body in self.bodies))
        self.points = self.bodies[0].displaced(inwards) + self.bodies[1].displaced(inwards)
        self.ranges = [ranges_of(body) for body in self.bodies]
        self.legs, self.repeats = legs_of(scene, a, b), repeats_from(scene, a, b)
        self.start = scene.start
        self.shown = {}
        self._overlap = None

    def in_p(self, v):
        return v < self.np

    def body(self, v):
        return (self.bodies[0], 0) if v < self.np else (self.bodies[1], self.np)

    def next(self, v):
        body, offset = self.body(v)
        return body.next[v - offset] + offset

    def previous(self, v):
        body, offset = self.body(v)
        return body.previous[v - offset] + offset

    def rigid(self, a, b, c):
        return orientation(*(self.points[v] for v in (a, b, c)))

    def local(self, leg, v):
        """Relative to the point about which its body turns last."""
        c = (leg.p if v < self.np else leg.q).c
        x, y = self.points[v]
        return x - c[0], y - c[1]

    def linear(self, leg, of_p, parts, a, b):
        """The sum of the frame's functions, times these balls, as a function over [a, b]."""
        at, over = leg.sampled_frame(a, b)
        side = 0 if of_p else 1
        return Sampled(combined(parts, at[side]), combined(parts, over[side]), a, b)

    def seen(self, leg, n, v, fixed):
        """n times the way from a vertex of one body to v of the other one, in the frame of the first: parts."""
        (nx, ny), (x, y) = n, self.local(leg, v)
        ax, ay = self.local(leg, fixed)
        return ((nx, 0), (ny, 0), add(product(nx, x), product(ny, y)), sub(product(ny, x), product(nx, y)),
                sub((0, 0), add(product(nx, ax), product(ny, ay))))

    def orientation(self, leg, a, b, c):
        """(of P's frame, parts) of (b - a) x (c - a)."""
        while self.in_p(a) != self.in_p(b):
            a, b, c = b, c, a
        e = less(self.points[a], self.points[b])
        return self.in_p(a), self.seen(leg, (-e[1], e[0]), c, a)

    def projection(self, leg, a, b, c):
        """(b - a) . (c - a), a and b of one body, c of the other."""
        return self.in_p(a), self.seen(leg, less(self.points[a], self.points[b]), c, a)

    def stays(self, leg, form, wanted, a, b, more=0):
        """Has a form, with `more` added, that sign at all times of [a, b]?"""
        of_p, parts = form

        def sample(x, y):
            f = self.linear(leg, of_p, parts, x, y)
            if more:
                f.shift(more)
            return f

        return keeps_sign(sample, wanted, a, b)

    def far_apart(self, leg, v, w, square, a, b):
        """Is the square of the two vertices' distance greater, at all times of [a, b]?"""
        side = 0 if self.in_p(v) else 1
        parts = [self.seen(leg, n, w, v) for n in ((ONE, 0), (0, ONE))]

        def sample(x, y):
            jets = []
            for frames in leg.sampled_frame(x, y):
                f, g = (combined(p, frames[side]) for p in parts)
                jets.append(jsub(jadd(jmul(f, f), jmul(g, g)), jconst(square)))
            return Sampled(*jets, x, y)

        return keeps_sign(sample, 1, a, b)

    def separated(self, leg, of_p, n, near, far, a, b, margin):
        """All of the range `far` beyond all of `near`, a range of P if of_p, by more than the margin, along n, in that
        body's frame."""
        offset = (0, self.np) if of_p else (self.np, 0)
        points = self.points
        least = max((v + offset[0] for v in near.vertices), key=lambda v: n[0] * points[v][0] + n[1] * points[v][1])
        if "hull" not in far.known:
            far.known["hull"] = [far.vertices[k] for k in hull([points[v + offset[1]] for v in far.vertices])]
        more = 0
        if margin:
            length = root(add(product(n[0], n[0]), product(n[1], n[1])))
            more = mul((margin, 0), length)
            more = -(more[0] + more[1] + 2)
        return all(self.stays(leg, (of_p, self.seen(leg, n, v + offset[1], least)), 1, a, b, more)
                   for v in far.known["hull"])

    def placed(self, leg, t):
        """All vertices in P's frame at an instant; Q's are balls."""
        frame = leg.sampled_frame(t, t)[0][0]
        sx, sy, c, s, _ = [f[0] for f in frame]
        out = [((x, 0), (y, 0)) for x, y in (self.local(leg, v) for v in range(self.np))]
        for v in range(self.np, self.size):
            x, y = ((k, 0) for k in self.local(leg, v))
            out.append((add(sx, sub(mul(c, x), mul(s, y))), add(sy, add(mul(s, x), mul(c, y)))))
        return out

    def known_contact(self, *asked):
        """What the function, the last argument, finds: once."""
        *what, find = asked
        key = (id(what[0]), *what[1:])
        if key not in self.shown:
            try:
                self.shown[key] = find(self, *what)
            except Undecided as reason:
                self.shown[key] = reason
        if isinstance(self.shown[key], Undecided):
            raise self.shown[key]
        return self.shown[key]

    def overlap_at_start(self):
        if self._overlap is None:
            leg = self.legs[0]
            self._overlap = overlap(self, self.placed(leg, exact(leg.start)))
        return self._overlap


def combined(parts, frame):
    v, d, dd = (0, 0), (0, 0), (0, 0)
    for part, f in zip(parts, frame):
        if part == (0, 0):
            continue
        v, d, dd = add(v, mul(part, f[0])), add(d, mul(part, f[1])), add(dd, mul(part, f[2]))
    return v, d, dd


def orientation_at(a, b, c):
    u, v = (sub(b[0], a[0]), sub(b[1], a[1])), (sub(c[0], a[0]), sub(c[1], a[1]))
    told = sign(sub(mul(u[0], v[1]), mul(u[1], v[0])))
    if not told:
        raise Undecided("an orientation at the start")
    return told


def apart(p, q):
    """Edges in boxes that do not meet."""
    for k in (0, 1):
        if max(x[k][0] + x[k][1] for x in p) < min(x[k][0] - x[k][1] for x in q):
            return True
        if max(x[k][0] + x[k][1] for x in q) < min(x[k][0] - x[k][1] for x in p):
            return True
    return False


def crossing(places, a, b, c, d):
    a, b, c, d = (places[v] for v in (a, b, c, d))
    if apart((a, b), (c, d)) or orientation_at(a, b, c) == orientation_at(a, b, d):
        return False
    return orientation_at(c, d, a) != orientation_at(c, d, b)


def inside_the_other(pair, places, v):
    """How often the other body winds around the vertex: crossings of a ray to the right."""
    others = range(pair.np, pair.size) if pair.in_p(v) else range(pair.np)
    winds, here = 0, places[v]

    def above(w):
        told = sign(sub(places[w][1], here[1]))
        if not told:
            raise Undecided("which of two vertices is higher")
        return told > 0

    for a in others:
        b = pair.next(a)
        if above(a) == above(b):
            continue
        side = orientation_at(places[a], places[b], here)
        if above(b) and side > 0:
            winds += 1
        elif above(a) and side < 0:
            winds -= 1
    return winds > 0


def overlap(pair, places):
    for a in range(pair.np):
        for c in range(pair.np, pair.size):
            if crossing(places, a, pair.next(a), c, pair.next(c)):
                return True
    for side, offset in ((0, 0), (1, pair.np)):
        at = offset
        for ring in pair.bodies[side].rings:
            if not ring.hole and inside_the_other(pair, places, at):
                return True
            at += len(ring.names)
    return False

"""A scene in the terms of a proof: fingerprint, roles, displaced bodies, legs. See docs/proof-format.md.

The scene must be valid. Of the laws of the displacement only one is checked: that displaced rings are simple."""

import hashlib
import math
import struct
from fractions import Fraction
from itertools import zip_longest

from covered import NotCovered
from keyframes import compiled
from roots import Function, sign

DELTA = 2.0**-200
INFINITE = math.inf


def number(x):
    return struct.pack("<d", 0.0 if x == 0 else x)


def trimmed(coefficients):
    c = [float(x) for x in coefficients]
    while c and c[-1] == 0:
        c.pop()
    return c


def origin_of(json, *polynomials):
    """From when on a piece's polynomials count time; constants do not."""
    return float(json.get("origin", 0)) if any(len(c) > 1 for c in polynomials) else 0.0


def origin_bytes(origin):
    return b"\xff\xff\xff\xff" + number(origin) if origin else b""


class Piece:
    def __init__(self, json):
        if json.get("rotation"):
            raise NotCovered("a body turns")
        self.x, self.y = trimmed(json.get("x", [])), trimmed(json.get("y", []))
        self.until = float(json.get("until", INFINITE))
        self.origin = origin_of(json, self.x, self.y)

    def bytes(self):
        parts = [number(self.until), origin_bytes(self.origin)]
        for c in (self.x, self.y):
            parts += [struct.pack("<I", len(c))] + [number(x) for x in c]
        return b"".join(parts) + b"\0"


def given_pieces(motion):
    return motion if isinstance(motion, list) else motion.get("pieces", [motion]) if motion else []


def made_between(make, given, start, end):
    """Those that matter on [start, end], at least one; the last one lasts for ever."""
    out = []
    for k, json in enumerate(given):
        if float(json.get("until", INFINITE)) <= start and k + 1 < len(given):
            continue
        out.append(make(json))
        if out[-1].until >= end:
            break
    out = out or [make({})]
    out[-1].until = INFINITE
    return out


def pieces_between(motion, start, end):
    given = given_pieces(compiled(motion, start, end))
    if any(set(piece) - {"x", "y", "until", "rotation", "pivot", "origin"} for piece in given):
        raise NotCovered("a motion that is not given by polynomials")
    return made_between(Piece, given, start, end)


def cross(a, b):
    return a[0] * b[1] - a[1] * b[0]


def less(a, b):
    return b[0] - a[0], b[1] - a[1]


def orientation(a, b, c):
    return sign(cross(less(a, b), less(a, c)))


def is_clockwise(ring):
    exact = [(Fraction(x), Fraction(y)) for x, y in ring]
    return sum(cross(exact[k - 1], exact[k]) for k in range(len(exact))) < 0


def diameter(ring):
    """The square, rounded as the specification says."""
    return max((b[0] - a[0]) * (b[0] - a[0]) + (b[1] - a[1]) * (b[1] - a[1]) for a in ring for b in ring)


def random_between(key, lo, hi):
    mask = (1 << 64) - 1
    z = (key + 0x9E3779B97F4A7C15) & mask
    z = ((z ^ (z >> 30)) * 0xBF58476D1CE4E5B9) & mask
    z = ((z ^ (z >> 27)) * 0x94D049BB133111EB) & mask
    z ^= z >> 31
    return lo + (hi - lo) * (float(z >> 11) * 2.0**-53)


def unit_of(a, b):
    """The direction from a to b, in doubles."""
    x, y = b[0] - a[0], b[1] - a[1]
    m = max(abs(x), abs(y))
    x /= m
    y /= m
    scaled = math.sqrt(x * x + y * y)
    return x / scaled, y / scaled


def corner_displacement(u, w, side, seed, i):
    sine, cosine = u[0] * w[1] - u[1] * w[0], u[0] * w[0] + u[1] * w[1]
    if abs(sine) <= 0.05 and cosine > 0:
        slide = random_between(~seed + i, -0.3, 0.3)
        r = side * random_between(seed + 2 * i, 1.3, 1.7)
        return -r * w[1] + slide * w[0], r * w[0] + slide * w[1]
    r1 = side * random_between(seed + 2 * i, 1.05, 1.95)
    r2 = side * random_between(seed + 2 * i + 1, 1.05, 1.95)
    alpha, beta = -r2 / sine, r1 / sine
    return alpha * u[0] + beta * w[0], alpha * u[1] + beta * w[1]


def displaced(ring, inwards, seed):
    """Pairs (point, displacement), each two doubles."""
    out, n, side = [], len(ring), 1.0 if inwards else -1.0
    for i, v in enumerate(ring):
        u = unit_of(ring[i - 1], v)
        w = unit_of(v, ring[(i + 1) % n])
        d = corner_displacement(u, w, side, seed, i)
        out.append((v, (DELTA * d[0], DELTA * d[1])))
    return out


def exponent_of(x):
    """The least e for which x is an integer times 2^-e."""
    return Fraction(x).denominator.bit_length() - 1


def is_simple(ring):
    """Of integer points in general position."""
    n = len(ring)
    edges = [(ring[k], ring[(k + 1) % n]) for k in range(n)]
    boxes = [(min(a[0], b[0]), max(a[0], b[0]), min(a[1], b[1]), max(a[1], b[1])) for a, b in edges]
    for i in range(n):
        for j in range(i + 2, n if i else n - 1):
            p, q = boxes[i], boxes[j]
            if p[0] > q[1] or q[0] > p[1] or p[2] > q[3] or q[2] > p[3]:
                continue
            (a, b), (c, d) = edges[i], edges[j]
            if orientation(a, b, c) * orientation(a, b, d) <= 0 and orientation(c, d, a) * orientation(c, d, b) <= 0:
                return False
    return all(orientation(ring[k - 2], ring[k - 1], ring[k]) != 0 for k in range(n))


class Leg:
    """The relative motion of Q over a stretch of the parameter [start, end], as polynomials on [0, 1]."""

    def __init__(self, start, end, x, y, bodies, joint=None):
        self.start, self.end, self.joint = start, end, joint
        scale = max([bodies.scale] + [exponent_of(c) for c in x + y])
        more = scale - bodies.scale
        self.points = [(a << more, b << more) for a, b in bodies.points]
        size = max(len(x), len(y), 1)
        self.moves = [[int(c * (1 << scale)) for c in p] + [0] * (size - len(p)) for p in (x, y)]
        self.np = bodies.np
        self.known = {}

    def places_at_start(self):
        dx, dy = self.moves[0][0], self.moves[1][0]
        return self.points[:self.np] + [(x + dx, y + dy) for x, y in self.points[self.np:]]

    def difference(self, a, b):
        """From one vertex to another: a polynomial for each coordinate."""
        moves = (b >= self.np) - (a >= self.np)
        d = less(self.points[a], self.points[b])
        return [[moves * c + (d[k] if i == 0 else 0) for i, c in enumerate(p)] for k, p in enumerate(self.moves)]

    def of_three(self, u, v, w, dot):
        """(v - u) x (w - u), or the product with a dot."""
        if not dot:  # first two of one body, whose difference is constant
            while (u < self.np) != (v < self.np):
                u, v, w = v, w, u
        (ax, ay), (bx, by) = self.difference(u, v), self.difference(u, w)
        out = [0] * (2 * len(ax) - 1)
        for i, (x, y) in enumerate(zip(ax, ay)):
            if x or y:
                for k in range(len(ax)):
                    out[i + k] += x * bx[k] + y * by[k] if dot else x * by[k] - y * bx[k]
        return out

    def function(self, u, v, w, dot=False):
        if not dot:  # the same from each vertex on
            u, v, w = min((u, v, w), (v, w, u), (w, u, v))
        key = (u, v, w, dot)
        if key not in self.known:
            self.known[key] = Function(self.of_three(u, v, w, dot))
        return self.known[key]


def polynomial_on(c, exponent, start, width):
    """c(start + width x) * 2^exponent in powers of x."""
    out = [Fraction(0)]
    for a in reversed(c):
        low = [start * x for x in out] + [Fraction(0)]
        high = [Fraction(0)] + [width * x for x in out]
        out = [x + y for x, y in zip(low, high)]
        out[0] += Fraction(a)
    return [x * Fraction(2) ** exponent for x in out]


def minus(a, b):
    return [x - y for x, y in zip_longest(a, b, fillvalue=Fraction(0))]


class Bodies:
    """The displaced bodies of a scene for one choice of shapes: points P, then Q, as integers times 2^-scale."""

    def __init__(self, plan, inwards):
        moved = []
        for k in (0, 1):
            moved += displaced(plan.rings[k], inwards, seed_of(plan.order[k], 0))
        self.np, self.size = len(plan.rings[0]), len(moved)
        self.scale = max(exponent_of(x) for v, d in moved for x in v + d)
        whole = 1 << self.scale
        self.points = [tuple(int((Fraction(v[k]) + Fraction(d[k])) * whole) for k in (0, 1)) for v, d in moved]
        if not (is_simple(self.points[:self.np]) and is_simple(self.points[self.np:])):
            raise NotCovered("a displaced body is not simple")
        self.legs = plan.legs(self)


MASK = (1 << 64) - 1


def seed_of(body, ring):
    """Different for any two rings of a scene."""
    return (0x9E3779B97F4A7C15 * (body + 1) + 0xBF58476D1CE4E5B9 * (ring + 1)) & MASK


class Plan:
    def __init__(self, scene):
        self.start, self.end = (float(t) for t in scene["time"])
        polygons = [[(float(x), float(y)) for x, y in body["polygon"]] for body in scene["bodies"]]
        motions = [pieces_between(body.get("motion"), self.start, self.end) for body in scene["bodies"]]
        # One part of one ring each, no parent, nothing ignored.
        self.hashed = b"".join([number(self.start), number(self.end), struct.pack("<I", 2)] + [
            struct.pack("<III", 1, 1, len(ring)) + b"".join(number(c) for v in ring for c in v) +
            struct.pack("<II", 0xFFFFFFFF, len(pieces)) + b"".join(piece.bytes() for piece in pieces) + bytes([0])
            for ring, pieces in zip(polygons, motions)] + [struct.pack("<I", 0)])
        self.hashed += bytes([1]) if scene.get("at_rest") == "test" else b""
        self.exponent = -math.frexp(max(abs(c) for ring in polygons for v in ring for c in v))[1]
        p = 1 if diameter(polygons[1]) > diameter(polygons[0]) else 0
        self.order = (p, 1 - p)
        self.rings, self.names, self.pieces = [], [], []
        for body in self.order:
            ring = polygons[body]
            n, step = len(ring), -1 if is_clockwise(ring) else 1
            first = ring.index(min(ring))
            self.names.append([(first + step * k) % n for k in range(n)])
            self.rings.append([tuple(math.ldexp(c, self.exponent) for c in ring[k]) for k in self.names[-1]])
            self.pieces.append(motions[body])
        self.known = {}

    def bodies(self, inwards):
        if inwards not in self.known:
            self.known[inwards] = Bodies(self, inwards)
        return self.known[inwards]

    def fingerprint(self, closed):
        return hashlib.sha256(b"taut scene 3" + bytes([closed]) + self.hashed).digest()

    def vertex_name(self, v):
        side = 0 if v < len(self.rings[0]) else 1
        return [self.order[side], self.names[side][v - side * len(self.rings[0])]]

    def edge_name(self, v):
        """An edge of the input is named by the vertex it begins with there."""
        body, index = self.vertex_name(v)
        names = self.names[self.order.index(body)]
        backwards = (names[0] - names[1]) % len(names) == 1 and len(names) > 2
        return [body, (index - 1) % len(names)] if backwards else [body, index]

    def legs(self, bodies):
        def on(piece, start, width):
            since = start - Fraction(piece.origin)
            return [polynomial_on(c, self.exponent, since, width) for c in (piece.x, piece.y)]

        def relative(i, k, start, width):
            p, q = on(self.pieces[0][i], start, width), on(self.pieces[1][k], start, width)
            return [minus(q[0], p[0]), minus(q[1], p[1])]

        legs, place, t = [], [0, 0], self.start
        while True:
            pieces = [self.pieces[side][place[side]] for side in (0, 1)]
            until = min(pieces[0].until, pieces[1].until, self.end)
            x, y = relative(*place, Fraction(t), Fraction(until) - Fraction(t))
            legs.append(Leg(t, until, x, y, bodies))
            if until >= self.end:
                return legs
            t, before = until, pieces
            old = relative(*place, Fraction(t), Fraction(0))
            for side in (0, 1):
                while self.pieces[side][place[side]].until <= t:
                    place[side] += 1
            after = [self.pieces[side][place[side]] for side in (0, 1)]
            if any((a.x, a.y, a.origin) != (b.x, b.y, b.origin) for a, b in zip(before, after)):
                new = relative(*place, Fraction(t), Fraction(0))
                x, y = ([a[0], b[0] - a[0]] for a, b in zip(old, new))
                legs.append(Leg(0.0, 1.0, x, y, bodies, joint=t))

"""An independent checker of logs about paths that are closed polygons. Written from docs/path-logs.md alone, with rational numbers.
That the log is about this problem, its fingerprint, is not checked here.

usage: barriers.py SCENE LOG      exit codes: 0 a proof, 1 not a proof, 3 not covered"""

import itertools
import json
import struct
import sys
from fractions import Fraction

from checker import checksum
from covered import NotCovered


class Refused(Exception):
    pass


def require(condition, why):
    if not condition:
        raise Refused(why)


def minus(a, b):
    return a[0] - b[0], a[1] - b[1]


def cross(a, b):
    return a[0] * b[1] - a[1] * b[0]


def dot(a, b):
    return a[0] * b[0] + a[1] * b[1]


def turn(a, b, p):
    return cross(minus(b, a), minus(p, a))


def on(p, a, b):
    return turn(a, b, p) == 0 and dot(minus(a, p), minus(b, p)) <= 0


def inside(rings, p):
    """1 inside of the rings by the parity of edges to the right, 0 on one of them, -1 outside."""
    odd = False
    for ring in rings:
        for a, b in zip(ring, ring[1:] + ring[:1]):
            if on(p, a, b):
                return 0
            if (a[1] > p[1]) != (b[1] > p[1]):
                odd ^= a[0] + (p[1] - a[1]) * (b[0] - a[0]) / (b[1] - a[1]) > p[0]
    return 1 if odd else -1


def shares(p, q, a, b):
    """Where along the segment from p to q the closed segment from a to b meets it: none, one or two numbers of [0, 1]."""
    d, e = minus(q, p), minus(b, a)
    if d == (0, 0):
        return [Fraction(0)] if on(p, a, b) else []
    across = cross(d, e)
    if across:
        s, t = cross(minus(a, p), e) / across, cross(minus(a, p), d) / across
        return [s] if 0 <= s <= 1 and 0 <= t <= 1 else []
    if cross(minus(a, p), d):
        return []
    lo, hi = sorted(dot(minus(end, p), d) / dot(d, d) for end in (a, b))
    lo, hi = max(lo, Fraction(0)), min(hi, Fraction(1))
    return [lo, hi] if lo <= hi else []


def holds(rings, p, q, strictly):
    """Is the segment in the part? Between two places where it meets a boundary it stays on one side."""
    places = {Fraction(0), Fraction(1)}
    for ring in rings:
        for a, b in zip(ring, ring[1:] + ring[:1]):
            found = shares(p, q, a, b)
            if found and strictly:
                return False
            places.update(found)
    at = lambda s: (p[0] + s * (q[0] - p[0]), p[1] + s * (q[1] - p[1]))
    ordered = sorted(places)
    samples = ordered + [(a + b) / 2 for a, b in zip(ordered, ordered[1:])]
    return all(inside(rings, at(s)) >= (1 if strictly else 0) for s in samples)


class Problem:
    """Of a scene with joints: bodies with their parts, and how joints displace them."""

    def __init__(self, scene):
        number = lambda x: Fraction(float(x))
        if "mechanism" in scene or scene.get("periodic"):
            raise NotCovered("mechanisms and periods")
        self.joints = {name: tuple(number(v) for v in r) for name, r in scene["joints"].items()}
        self.start = {name: number(v) for name, v in scene["start"].items()}
        self.goal = scene["goal"]
        if self.goal != "outside":
            self.goal = {name: tuple(number(v) for v in (g if isinstance(g, list) else [g, g])) for name, g in self.goal.items()}
        self.bodies = scene["bodies"]
        self.names = [b["name"] for b in self.bodies]
        self.ignored = [set(pair) for pair in scene.get("ignore", [])]
        self.parts = [self.parts_of(b, number) for b in self.bodies]
        self.number = number

    @staticmethod
    def parts_of(body, number):
        ring = lambda r: [(number(x), number(y)) for x, y in r]
        layers = lambda o: tuple(number(z) if z is not None else None for z in o["z"]) if "z" in o else None
        own = layers(body)
        parts = []
        for part in body.get("parts") or [body["polygon"]]:
            if isinstance(part, dict):
                parts.append(([ring(part["outline"])] + [ring(h) for h in part.get("holes", [])], layers(part) or own))
            else:
                parts.append(([ring(part)], own))
        return parts

    def chain(self, body):
        chain = [body]
        while "relative_to" in self.bodies[chain[-1]]:
            chain.append(self.names.index(self.bodies[chain[-1]]["relative_to"]))
        return chain

    def is_moved(self, body):
        return any(self.bodies[b].get("motion") for b in self.chain(body))

    def slide(self, body):
        """Its offset, and of each joint the vector."""
        offset, vectors = (Fraction(0), Fraction(0)), {}

        def add(joint, times, plus, direction):
            nonlocal offset
            d = tuple(self.number(x) for x in direction)
            was = vectors.get(joint, (Fraction(0), Fraction(0)))
            vectors[joint] = was[0] + times * d[0], was[1] + times * d[1]
            offset = offset[0] + plus * d[0], offset[1] + plus * d[1]

        for one in self.chain(body):
            motion = self.bodies[one].get("motion") or {}
            if "slide" in motion:
                s = motion["slide"]
                add(s["by"], self.number(s.get("times", 1)), self.number(s.get("plus", 0)), s["direction"])
            elif "free" in motion and "deg" not in motion["free"]:
                for key, direction in (("x", (1, 0)), ("y", (0, 1))):
                    if key in motion["free"]:
                        add(motion["free"][key], Fraction(1), Fraction(0), direction)
            else:
                require(not motion, "a body turns")
        return offset, vectors

    def relative(self, body, other):
        (a, u), (b, v) = self.slide(body), self.slide(other)
        zero = (Fraction(0), Fraction(0))
        vectors = {j: minus(v.get(j, zero), u.get(j, zero)) for j in self.joints}
        return minus(b, a), {j: w for j, w in vectors.items() if w != zero}

    def is_tested(self, a, b):
        if a == b or any({self.names[a], self.names[b]} == pair or ("*" in pair and pair & {self.names[a], self.names[b]})
                         for pair in self.ignored):
            return False
        first, second = self.chain(a), self.chain(b)
        return any(self.bodies[one].get("motion") for own, other in ((first, second), (second, first))
                   for one in own if one not in other)


def meet(a, b):
    """Have two intervals of heights an inside in common?"""
    if a is None or b is None:
        return True
    lows, highs = [z for z in (a[0], b[0]) if z is not None], [z for z in (a[1], b[1]) if z is not None]
    return not lows or not highs or max(lows) < min(highs)


class Reader:
    def __init__(self, data):
        self.data, self.at = data, 0

    def take(self, form):
        try:
            value, = struct.unpack_from("<" + form, self.data, self.at)
        except struct.error:
            raise Refused("the log is cut off") from None
        self.at += struct.calcsize("<" + form)
        return value

    def number(self):
        n = self.take("B")
        require(n <= 32, "too many digits")
        summands = [self.take("d") for _ in range(n)]
        require(all(abs(x) < float("inf") for x in summands), "not a number")
        return sum((Fraction(x) for x in summands), Fraction(0))

    def place(self):
        return self.number(), self.number()


class Checker:
    def __init__(self, problem, data):
        self.problem = problem
        require(data[:7] == b"tautprf", "this is no log")
        if data[7:8] != b"7":
            raise NotCovered("another kind of log")
        require(len(data) > 56 and struct.unpack("<Q", data[-8:])[0] == checksum(data[:-8]), "the checksum is wrong")
        log = Reader(data[:-8])
        log.at = 40
        touching = log.take("B")
        require(touching <= 1, "the header makes no sense")
        self.touching = touching == 1
        self.boxes = (log.take("I"), log.take("I")) if problem.goal == "outside" else None
        self.edges = [self.edge(log) for _ in range(log.take("I"))]
        require(log.at == len(log.data), "there is something after the end")
        self.corners = [edge[0] for edge in self.edges]

    def edge(self, log):
        begin, kind = log.place(), log.take("B")
        require(kind <= 1, "unknown edge")
        if kind == 1:
            return begin, None, log.take("B")
        bodies = log.take("I"), log.take("I")
        require(max(bodies) < len(self.problem.bodies), "there is no such body")
        return begin, bodies, (log.place(), log.place())

    def run(self):
        first = next((bodies for _, bodies, _ in self.edges if bodies), None)
        require(first is not None, "nothing collides")
        self.vectors = self.problem.relative(*first)[1]
        # In the order of the scene's joints.
        self.moving = [j for j in self.problem.joints if j in self.vectors]
        require(len(self.moving) == 1 or (len(self.moving) == 2 and cross(*(self.vectors[j] for j in self.moving))),
                "not one joint, or two across each other")
        for i in range(len(self.edges)):
            self.collides(i) if self.edges[i][1] else self.is_outside(i)
        start = self.displaced(self.problem.start)
        around = inside([self.corners], start)
        require(around != 0, "the start is on the polygon")
        if self.boxes:
            self.boxes_overlap()
            require(around > 0, "the start is not inside")
            return
        ranges = []
        for j in self.moving:
            (lo, hi), goal = self.problem.joints[j], self.problem.goal.get(j)
            ranges.append((max(lo, goal[0]), min(hi, goal[1])) if goal else (lo, hi))
        require(not all(lo <= self.problem.start[j] <= hi for j, (lo, hi) in zip(self.moving, ranges)),
                "the start is in the goal")
        region = [self.displaced(dict(zip(self.moving, v))) for v in itertools.product(*ranges)]
        if len(region) == 4:
            region[2:] = region[:1:-1]
        for a, b in zip(region, region[1:] + region[:1]):
            require(self.parts(around, a, b), "some of the goal is on the start's side")

    def parts(self, around, p, q):
        """Is each point from p to q on the polygon, or on the other side of it than what is `around` there?"""
        places = {Fraction(0), Fraction(1)}
        for a, b in zip(self.corners, self.corners[1:] + self.corners[:1]):
            places.update(shares(p, q, a, b))
        ordered = sorted(places)
        samples = ordered + [(a + b) / 2 for a, b in zip(ordered, ordered[1:])]
        return all(inside([self.corners], (p[0] + s * (q[0] - p[0]), p[1] + s * (q[1] - p[1]))) != around for s in samples)

    def displaced(self, values):
        return tuple(sum(values[j] * self.vectors[j][k] for j in self.moving) for k in (0, 1))

    def collides(self, i):
        begin, (body, other), (p, q) = self.edges[i]
        end = self.corners[(i + 1) % len(self.corners)]
        offset, vectors = self.problem.relative(body, other)
        require(vectors == self.vectors, "moved in another way")
        require(self.problem.is_tested(body, other), "not tested")
        there = minus(minus(p, offset), begin), minus(minus(q, offset), end)
        for (own, own_z), (far, far_z) in itertools.product(self.problem.parts[body], self.problem.parts[other]):
            if not meet(own_z, far_z):
                continue
            kinds = [(False, False)] if self.touching else [(True, False), (False, True)]
            if any(holds(own, p, q, a) and holds(far, *there, b) for a, b in kinds):
                return
        raise Refused(f"edge {i} is not shown to collide")

    def is_outside(self, i):
        n, side = len(self.edges), self.edges[i][2]
        require(side <= 3, "no such side")
        on_bound = 0
        for k in (i, (i + 1) % n):
            beyond = self.beyond(side, self.corners[k])
            require(beyond >= 0, "not outside of the range")
            if beyond == 0:
                on_bound += 1
                meeting = self.edges[(i - 1) % n if k == i else k]
                require(meeting[1] is not None, "its end is in the range")
        require(on_bound < 2, "along the end of the range")

    def beyond(self, side, at):
        """How far the value of a joint is beyond its bound."""
        u = self.vectors[self.moving[0]]
        v = self.vectors[self.moving[1]] if len(self.moving) == 2 else (-u[1], u[0])
        det = cross(u, v)
        value = cross(at, v) / det if side < 2 else cross(u, at) / det
        lo, hi = self.problem.joints[self.moving[side // 2]] if side // 2 < len(self.moving) else (0, 0)
        return value - hi if side % 2 else lo - value

    def boxes_overlap(self):
        moving, resting = self.boxes
        require(max(self.boxes) < len(self.problem.bodies), "there is no such body")
        offset, vectors = self.problem.relative(resting, moving)
        require(vectors == self.vectors, "moved in another way")
        require(self.problem.is_moved(moving) and not self.problem.is_moved(resting), "not the one that moves")
        extent = lambda body, k: [f(p[k] for rings, _ in self.problem.parts[body] for p in rings[0]) for f in (min, max)]
        for corner in self.corners:
            for k in (0, 1):
                (lo, hi), (low, high) = extent(moving, k), extent(resting, k)
                by = offset[k] + corner[k]
                require(lo + by <= high and low <= hi + by, "where the boxes are apart")


def check(scene, data):
    """Raises Refused unless the log proves that there is no way."""
    Checker(Problem(scene), data).run()


if __name__ == "__main__":
    try:
        check(json.load(open(sys.argv[1])), open(sys.argv[2], "rb").read())
        print("a proof")
    except Refused as why:
        print("not a proof:", why)
        sys.exit(1)
    except NotCovered as why:
        print("not covered:", why)
        sys.exit(3)

"""An independent checker of exact logs. Written from docs/exact-logs.md alone.

It bounds motions to second order and halves time until each side of a line is certain, so windows need not be short.

usage: exact_logs.py SCENE LOG      exit codes: 0 a proof, 1 not a proof, 3 not decided, or not covered"""

import json
import math
import sys
from fractions import Fraction
from math import isqrt

from balls import (J1, ONE, UNBOUNDED, Sampled, Undecided, add, between, exact, jmul, jpolynomial,
                   jpolynomial_about_middle, jsub, keeps_sign, mul, sign, sub, times)
from bodies import made_between
from covered import NotCovered
from legs import Pose, piece_at
from pairs import combined, hull, orientation_at, product
from tiling import Refused, require
from world import Piece, Scene

COVERED = {"$schema", "format", "id", "time", "bodies", "ignore", "at_rest"}
RAYS = ((1, 0), (1000003, 7919), (-104729, 1299709), (15485863, -32452843))


class ExactPiece(Piece):
    def other_turn(self, t):
        """A body whose cosine is beyond 1 rests, so that where it may be, the cosine has no known slope either."""
        if self.kind != 4:
            return super().other_turn(t)
        cosine = jpolynomial_about_middle(self.turn[0], t)
        square, radius = jsub(J1, jmul(cosine, cosine))[0]
        if square > radius:
            return super().other_turn(t)
        (a, r), most = cosine[0], max(square + radius, 0)
        within = between(*(max(-ONE, min(ONE, end)) for end in (a - r, a + r)))
        return (within, UNBOUNDED, UNBOUNDED), (between(0, isqrt(most * ONE) + 1), UNBOUNDED, UNBOUNDED)


class ExactScene(Scene):
    def __init__(self, given):
        parts = [part for body in given["bodies"] for part in body.get("parts", [body.get("polygon")])]
        if set(given) - COVERED or "time" not in given:
            raise NotCovered("a scene with joints or a mechanism")
        if any(not isinstance(part, (list, dict)) or isinstance(part, dict) and "outline" not in part for part in parts):
            raise NotCovered("an outline that is a curve, or in a file of its own")
        super().__init__(given)
        scale = Fraction(2) ** self.exponent
        for body in self.bodies:
            used = {ring.part for ring in body.rings}
            body.written = [(part, [tuple(exact(Fraction(c) * scale) for c in v) for v in ring])
                            for ring, _, part, _ in self._rings(given["bodies"][body.in_scene]) if part in used]

    def pieces(self, given):
        """With the one that begins when the scene ends, if there is one: it says where the body is at that instant."""
        return made_between(ExactPiece, given, self.start, math.nextafter(self.end, math.inf))

    def motions(self):
        """As they are written: with nothing cut."""
        return self.own


class Outline:
    """A body's edges, each with the vertices at its ends, and its rings."""

    def __init__(self, body):
        self.points, self.edges, self.rings, self.known = [], [], [], {}
        for part, ring in body.written:
            first, n = len(self.points), len(ring)
            self.points += ring
            self.edges += [(first + k, first + (k + 1) % n) for k in range(n)]
            self.rings.append((part, range(first, first + n)))

    def farthest(self, lo, hi):
        """The ends of these edges that may be farthest in some direction."""
        if (lo, hi) not in self.known:
            ends = sorted({v for edge in self.edges[lo:hi] for v in edge})
            self.known[lo, hi] = [ends[k] for k in hull([self.points[v] for v in ends])]
        return self.known[lo, hi]


class Line:
    def __init__(self, given, scene, middle):
        require(len(given) >= 2, "a line without a direction")
        x, y, *c = map(double, given)
        self.x, self.y = exact(x), exact(y)
        self.c = [exact(Fraction(a) * Fraction(2) ** scene.exponent) for a in c]
        self.middle, self.known = middle, {}

    def level(self, a, b):
        if (a, b) not in self.known:
            self.known[a, b] = [jpolynomial(self.c, sub(t, (self.middle, 0))) for t in instants(a, b)]
        return self.known[a, b]

    def along(self, point):
        """What x and y of a body's place, its cosine and its sine count for, at a point of it."""
        u, v = point
        return ((self.x, 0), (self.y, 0), add(product(self.x, u), product(self.y, v)),
                sub(product(self.y, u), product(self.x, v)))


class Window:
    """Two bodies in the frame of what they do alike, while each of their motions has one piece."""

    def __init__(self, scene, outlines, chains, a, b):
        self.scene, self.outlines = scene, outlines
        self.a, self.b, self.middle = exact(a), exact(b), exact((Fraction(a) + Fraction(b)) / 2)
        self.poses = [Pose([piece_at(motion, a) for motion in chain]) for chain in chains]
        self.frames = {}

    def local(self, side, v):
        return tuple(x - c for x, c in zip(self.outlines[side].points[v], self.poses[side].c))

    def frame(self, side, a, b):
        if (side, a, b) not in self.frames:
            pose, (middle, over) = self.poses[side], instants(a, b)
            at = (*pose.place(middle), *pose.turn(middle))
            try:
                self.frames[side, a, b] = at, (*pose.place(over), *pose.turn(over))
            except Undecided:  # a direction that may vanish, as far as can be seen over so long a time
                self.frames[side, a, b] = at, 4 * [3 * [UNBOUNDED]]
        return self.frames[side, a, b]

    def stays(self, side, v, line):
        parts = line.along(self.local(side, v))

        def sample(a, b):
            return Sampled(*(jsub(combined(parts, frame), level)
                             for frame, level in zip(self.frame(side, a, b), line.level(a, b))), a, b)

        return keeps_sign(sample, 1 if side else -1, self.a, self.b)

    def separate(self, steps, *ranges):
        step = next(steps, None)
        require(step is not None, "a step is missing")
        if isinstance(step, list):
            line = Line(step, self.scene, self.middle)
            require(all(self.stays(side, v, line) for side in (0, 1)
                        for v in self.outlines[side].farthest(*ranges[side])), "a line does not separate")
            return
        require(type(step) in (int, float) and step in (1, 2), "an unknown step")
        halved, (lo, hi) = step == 2, ranges[step == 2]
        m = lo + (hi - lo) // 2
        for part in ((lo, m), (m, hi)):
            self.separate(steps, *((ranges[0], part) if halved else (part, ranges[1])))

    def places(self, side):
        x, y, c, s = (f[0] for f in self.frame(side, self.middle, self.middle)[0])
        out = []
        for v in range(len(self.outlines[side].points)):
            u, w = ((k, 0) for k in self.local(side, v))
            out.append((add(x, sub(mul(c, u), mul(s, w))), add(y, add(mul(s, u), mul(c, w)))))
        return out

    def rings_are_outside(self):
        places = [self.places(side) for side in (0, 1)]
        for side in (0, 1):
            for _, ring in self.outlines[side].rings:
                inside = is_inside(places[side][ring[0]], self.outlines[1 - side].rings, places[1 - side])
                require(not inside, "a ring is within the other body")


def instants(a, b):
    return ((a + b) >> 1, 0), between(a, b)


def is_inside(point, rings, places):
    for ray in RAYS:
        try:
            crossed = [(part, sum(crosses(ray, point, ring, places))) for part, ring in rings]
            return any(sum(n for of, n in crossed if of == part) % 2 for part, _ in crossed)
        except Undecided:
            pass  # another ray may pass no vertex
    raise Undecided("whether a ring is within the other body")


def crosses(ray, point, ring, places):
    """For each edge of a ring, whether a ray from the point crosses it."""
    heights = []
    for v in ring:
        x, y = (sub(k, at) for k, at in zip(places[v], point))
        heights.append(sign(sub(times(y, ray[0]), times(x, ray[1]))))
        if not heights[-1]:
            raise Undecided("which of two vertices is higher")
    for k, v in enumerate(ring):
        if heights[k - 1] != heights[k]:
            yield orientation_at(places[ring[k - 1]], places[v], point) == heights[k]


def double(x):
    require(type(x) in (int, float), "not a number")
    try:
        x = float(x)
    except OverflowError:
        x = math.inf
    require(math.isfinite(x), "not a number")
    return x


def seen_alike(scene, pair):
    """How many first motions both bodies follow, and from which they can be seen."""
    p, q = pair
    shared = 0
    for motion, one, other in zip(scene.chains[p], scene.keys[p], scene.keys[q]):
        vanishes = any(piece.kind == 2 and max(map(len, piece.rotation)) > 1 for piece in motion)
        if one != other or vanishes:
            break
        shared += 1
    return shared


class Checker:
    def __init__(self, scene, known):
        self.scene, self.known = scene, known

    def outline(self, k):
        if ("outline", k) not in self.known:
            self.known["outline", k] = Outline(self.scene.bodies[k])
        return self.known["outline", k]

    def run(self, log):
        scene = self.scene
        require(isinstance(log, dict) and log.get("format") == "taut-exact/1", "the format")
        until, listed = double(log.get("until")), log.get("pairs")
        require(scene.start <= until <= scene.end, "the end of the proof")
        n = len(scene.bodies)
        asked = [[i, j] for i in range(n) for j in range(i + 1, n) if scene.asked(i, j)]
        require(asked, "nothing is proved")
        require(isinstance(listed, list) and all(isinstance(x, dict) for x in listed), "the pairs")
        require([x.get("pair") for x in listed] == asked, "the pairs are not those that are tested")
        for entry in listed:
            self.windows(entry["pair"], entry.get("windows"), until)
        return until

    def windows(self, pair, windows, until):
        require(isinstance(windows, list) and windows, "no windows")
        shared = seen_alike(self.scene, pair)
        chains = [self.scene.chains[k][shared:] for k in pair]
        end, motions = self.scene.start, [motion for chain in chains for motion in chain]
        for window in windows:
            require(isinstance(window, list) and len(window) >= 3, "a window")
            a, b = map(double, window[:2])
            require(a <= b and a <= end, "a gap between windows")
            pieces = [piece_at(motion, a) for motion in motions]
            require(a == b or all(b <= piece.until for piece in pieces), "a motion passes to another piece")
            self.once((*pair, repr(window)), lambda w=window, a=a, b=b: self.window(pair, chains, a, b, w[2:]))
            end = b
        require(end >= until, "the windows end too early")
        require(end > until or all(until < piece.until for piece in pieces), "nothing is said of the last piece")

    def once(self, what, show):
        """Logs that are damaged have most of their windows in common."""
        if what not in self.known:
            try:
                self.known[what] = show()
            except (Refused, Undecided) as reason:
                self.known[what] = reason
        if self.known[what]:
            raise self.known[what]

    def window(self, pair, chains, a, b, given):
        window = Window(self.scene, [self.outline(k) for k in pair], chains, a, b)
        steps = iter(given)
        window.separate(steps, *((0, len(outline.edges)) for outline in window.outlines))
        require(next(steps, None) is None, "too many steps")
        if not isinstance(given[0], list):
            window.rings_are_outside()


def check(scene, log, known):
    """(until when the log proves the scene free, or None; why not; was that decided?). `log` is what was read as JSON,
    `known` what was found out about the scene."""
    try:
        return Checker(scene, known).run(log), "", True
    except Refused as error:
        return None, str(error), True
    except (Undecided, RecursionError) as error:
        return None, str(error), False


def main():
    if len(sys.argv) != 3:
        print(__doc__, file=sys.stderr)
        return 2
    sys.setrecursionlimit(10000)
    try:
        with open(sys.argv[1], encoding="utf-8") as scene:
            scene = ExactScene(json.load(scene))
    except NotCovered as reason:
        print(f"not covered: {reason}")
        return 3
    try:
        with open(sys.argv[2], encoding="utf-8") as log:
            log = json.load(log)
    except (ValueError, RecursionError) as error:
        print(f"not a proof: {error}")
        return 1
    until, reason, decided = check(scene, log, {})
    if until is not None:
        print(json.dumps({"free_until": until}))
        return 0
    print(f"not a proof: {reason}" if decided else f"not decided: {reason}")
    return 1 if decided else 3


if __name__ == "__main__":
    sys.exit(main())

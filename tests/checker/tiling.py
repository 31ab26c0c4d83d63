"""The tiling of a log: half-edges with the sign of the corner that each enters. See docs/proof-format.md."""

from bodies import less, orientation

NONE = 0xFFFFFFFF


class Refused(Exception):
    """The log is no proof."""


def require(holds, what):
    if not holds:
        raise Refused(what)


def angle_class(d):
    """0 for directions in [0, pi), 1 for the others."""
    return 0 if d[1] > 0 or (d[1] == 0 and d[0] > 0) else 1


class Tiling:
    def __init__(self, log, bodies, leg):
        self.n, self.np = bodies.size, bodies.np
        self.origin, self.next, self.prev, self.sign = [], [], [], []
        for i in range(self.n):
            self.origin += [i, self.following(i)]
        self.read(log)
        for h in self.alive_ones():
            require(self.next[h] != NONE and self.prev[h] != NONE, "no cycles")
            require(self.origin[self.next[h]] == self.target(h), "a gap in a cycle")
            require(self.target(self.next[h]) != self.origin[h], "a face turns back on an edge")
        require(all(self.next[2 * i] == 2 * self.following(i) for i in range(self.n)), "a body is missing")
        self.measure(leg)

    def following(self, i):
        return 0 if i + 1 == self.np else self.np if i + 1 == self.n else i + 1

    def alive(self, h):
        return h < len(self.origin) and self.origin[h] != NONE

    def alive_ones(self):
        return [h for h in range(len(self.origin)) if self.origin[h] != NONE]

    def target(self, h):
        return self.origin[h ^ 1]

    def of_body(self, h):
        return h < 2 * self.n

    def inside(self, h):
        return self.of_body(h) and h % 2 == 0

    def corner(self, h):
        return self.origin[h], self.target(h), self.target(self.next[h])

    def link(self, a, b):
        self.next[a], self.prev[b] = b, a

    def read(self, log):
        count, n = log.u32(), self.n
        require(count % 2 == 0 and 2 * n <= count and count // 2 <= 3 * n + 16, "too many half-edges")
        for _ in range(2 * n, count, 2):
            pair = [log.u32(), log.u32()]
            require((pair[0] == NONE) == (pair[1] == NONE), "a half-edge without twin")
            require(pair[0] == NONE or (max(pair) < n and pair[0] != pair[1]), "no such vertices")
            self.origin += pair
        self.next, self.prev, self.sign = [NONE] * count, [NONE] * count, [0] * count
        for h in range(count):
            following = log.u32()
            if self.alive(h):
                require(self.alive(following) and self.prev[following] == NONE, "no cycles")
                self.link(h, following)
        reserve = log.u32()
        require(reserve <= count // 2, "too many unused half-edges")
        self.unused = []
        for _ in range(reserve):
            h = log.u32()
            require(h < count and h % 2 == 0 and not self.alive(h) and h not in self.unused, "not unused")
            self.unused.append(h)

    def measure(self, leg):
        """The signs of corners; angles around vertices; how often faces turn, and how many convex corners they have."""
        place = leg.places_at_start()
        around = {}
        for h in self.alive_ones():
            self.sign[h] = orientation(*(place[v] for v in self.corner(h)))
            require(self.sign[h] != 0, "three vertices on a line")
            around.setdefault(self.origin[h], []).append(h)
        for out in around.values():
            self.check_angles(out, place)
        seen, faces, infinite = set(), 0, 0
        for h in self.alive_ones():
            if h in seen:
                continue
            faces += 1
            half_turns, convex = self.turns(h, place, seen)
            if self.inside(h):
                continue
            if (half_turns, convex) == (-2, 1):
                infinite += 1
            else:
                require((half_turns, convex) == (2, 3), "a face is not a pseudo-triangle")
        require(infinite == 1, "not one infinite face")
        require(self.n - len(self.alive_ones()) // 2 + faces == 2, "Euler's formula")

    def check_angles(self, out, place):
        """Counterclockwise around a vertex, directions come back to where they began after one turn."""
        v, h, met, turns = place[self.origin[out[0]]], out[0], 0, 0
        while True:
            d = less(v, place[self.target(h)])
            h = self.prev[h] ^ 1
            e = less(v, place[self.target(h)])
            met += 1
            # The direction to the right is passed where the angle becomes smaller.
            c, f = angle_class(d), angle_class(e)
            turns += f < c or (f == c and d[0] * e[1] - d[1] * e[0] <= 0)
            if h == out[0]:
                break
            require(met <= len(out), "edges around a vertex")
        require(met == len(out) and turns == 1, "the angles do not add up")

    def turns(self, start, place, seen):
        half_turns, convex, h = 0, 0, start
        while True:
            seen.add(h)
            after = self.next[h]
            forwards = [place[self.origin[k]] < place[self.target(k)] for k in (h, after)]
            convex += self.sign[h] > 0
            half_turns += self.sign[h] if forwards[0] != forwards[1] else 0
            h = after
            if h == start:
                return half_turns, convex

    def ending(self, h, kind):
        """The corners, by the half-edges that enter them, that an event of this kind ends."""
        corners = [self.prev[h], h, self.next[h]]
        if kind:
            across = (h if kind == 1 else self.next[h]) ^ 1
            corners += [self.prev[across], across]
        return corners

    def apply(self, uv, kind):
        """Returns the corners that begin."""
        return (self.open_triangle, self.replace_first, self.replace_second)[kind](uv, self.next[uv])

    def open_triangle(self, uv, vw):
        require(self.sign[uv] < 0, "a convex corner closes without an edge that goes")
        before, after = self.prev[uv], self.next[vw]
        if self.unused:
            uw = self.unused.pop()
        else:
            uw = len(self.origin)
            for table in (self.origin, self.next, self.prev, self.sign):
                table += [NONE, NONE]
        wu = uw ^ 1
        self.origin[uw], self.origin[wu] = self.origin[uv], self.target(vw)
        self.sign[uw] = self.sign[vw]
        for a, b in ((before, uw), (uw, after), (uv, vw), (vw, wu), (wu, uv)):
            self.link(a, b)
        for h in (uv, vw, wu):
            self.sign[h] = 1
        return [before, uw, uv, vw, wu]

    def drop(self, h):
        self.origin[h] = self.origin[h ^ 1] = NONE
        self.unused.append(h & ~1)

    def replace_first(self, uv, vw):
        require(not self.of_body(uv), "an edge of a body goes")
        vu, before, after = uv ^ 1, self.prev[uv], self.next[vw]
        across_before, across_after = self.prev[vu], self.next[vu]
        reflex, triangle = self.sign[uv] < 0, self.next[after] == uv
        require(self.sign[across_before] > 0 if reflex else triangle or self.sign[vw] < 0, "no pseudo-triangles")
        at_u, begin, wu = self.sign[vu], [], after
        if triangle:
            self.drop(uv)
        else:
            wu = vu
            self.origin[vu] = self.target(vw)
            self.sign[uv] = self.sign[vw] if reflex else 1
            self.link(uv, after)
            begin = [before, uv]
        self.link(across_before, vw)
        self.link(vw, wu)
        self.link(wu, across_after)
        if reflex:
            self.sign[across_before] = -1
        self.sign[vw] = 1 if reflex else -1
        self.sign[wu] = at_u
        return begin + [across_before, vw, wu]

    def replace_second(self, uv, vw):
        require(not self.of_body(vw), "an edge of a body goes")
        wv, before, after = vw ^ 1, self.prev[uv], self.next[vw]
        across_before, across_after = self.prev[wv], self.next[wv]
        reflex, triangle = self.sign[uv] < 0, self.next[after] == uv
        at_v, at_w, begin, wu = self.sign[wv], self.sign[vw], [], after
        require(at_v > 0 if reflex else triangle or self.sign[before] < 0, "no pseudo-triangles")
        if triangle:
            self.drop(vw)
        else:
            uw, wu = vw, wv
            self.origin[uw] = self.origin[uv]
            self.sign[uw] = at_w
            if not reflex:
                self.sign[before] = 1
            self.link(before, uw)
            self.link(uw, after)
            begin = [before, uw]
        self.link(across_before, wu)
        self.link(wu, uv)
        self.link(uv, across_after)
        self.sign[wu] = 1 if reflex else -1
        self.sign[uv] = -1 if reflex else at_v
        return begin + [across_before, wu, uv]

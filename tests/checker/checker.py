"""An independent checker of proof logs, for scenes in which nothing turns. Written from docs/proof-format.md alone.

usage: checker.py SCENE LOG      exit codes: 0 a proof, 1 not a proof, 3 not covered"""

import json
import struct
import sys
from fractions import Fraction

from bodies import Plan, orientation
from covered import NotCovered
from roots import Undecided
from tiling import Refused, Tiling, require

EVENTS, CONTACTS, NEXT_LEG, FREE, FREE_UNTIL, TOUCHING = (0, 1, 2), (3, 4), 5, 6, 7, 8


class Bytes:
    def __init__(self, data):
        self.data, self.at = data, 0

    def take(self, size):
        require(self.at + size <= len(self.data), "cut off")
        self.at += size
        return self.data[self.at - size:self.at]

    def u8(self):
        return self.take(1)[0]

    def u32(self):
        return struct.unpack("<I", self.take(4))[0]

    def f64(self):
        return struct.unpack("<d", self.take(8))[0]


def checksum(data):
    total = 0xCBF29CE484222325
    for byte in data:
        total = ((total ^ byte) * 0x100000001B3) & 0xFFFFFFFFFFFFFFFF
    return total


class Instant:
    """A time within a leg: a Fraction of it, or a root of a corner's function, which one is told by its number."""

    def __init__(self, at, corner=(), number=0):
        self.at, self.corner, self.number = at, frozenset(corner), number

    def is_own(self, corner):
        return self.corner == frozenset(corner)


class Checker:
    def __init__(self, plan, data):
        self.log = log = Bytes(data)
        require(log.take(8) == b"tautprf2", "not a log of version 2")
        fingerprint, touch, shapes = log.take(32), log.u8(), log.u8()
        require(touch <= 1 and shapes <= 1, "the header")
        require(fingerprint == plan.fingerprint(touch), "another scene")
        self.plan, self.closed, self.inwards = plan, touch == 1, shapes == 0
        self.bodies = plan.bodies(self.inwards)
        self.legs = self.bodies.legs
        self.tiling = Tiling(log, self.bodies, self.legs[0])
        self.births, self.events = {}, 0
        for h in self.tiling.alive_ones():
            self.begin(h, None)
        self.enter(0)

    def begin(self, h, birth):
        """Rigid corners, of vertices of one body, and those inside a body need no watch."""
        t = self.tiling
        if t.inside(h):
            return
        u, v, w = t.corner(h)
        require(u != w, "a face turns back on an edge")
        if not (u < t.np) == (v < t.np) == (w < t.np):
            self.births[h] = birth

    def enter(self, k):
        self.current, self.leg = k, self.legs[k]
        self.last = Instant(Fraction(0))
        self.births = dict.fromkeys(self.births, self.last)

    def holds(self, h, until):
        """The corner keeps its sign from its birth to this instant; where its own three vertices are in line then, up
        to it."""
        corner, birth = self.tiling.corner(h), self.births[h]
        f = self.leg.function(*corner)
        if birth.is_own(corner):
            count = birth.number + 1
        else:
            count = f.roots_before(birth.at)
            require(birth.at != 0 or f.at_start != 0, "on a line at the start")
        require(f.sign_after(count) == self.tiling.sign[h], "a corner with another sign")
        following = f.roots[count] if count < len(f.roots) else None
        if until.is_own(corner):
            require(until.number == count, "a corner fails at another time")
        elif until.at == 1:
            require(following is None and f.at_end != 0, "a corner does not last")
        elif following is not None:
            require(following.compare(until.at) > 0, "a corner does not last")

    def failure(self, h, about):
        """The first instant after the corner's birth at which its vertices are in line: near the time in the log."""
        leg, corner = self.leg, self.tiling.corner(h)
        require(leg.start <= about <= leg.end, "not within the leg")
        f, birth = leg.function(*corner), self.births[h]
        count = f.roots_before(birth.at) if not birth.is_own(corner) else birth.number + 1
        require(count < len(f.roots), "a corner does not fail")
        now = Instant(f.roots[count], corner, count)
        width = Fraction(leg.end) - Fraction(leg.start)
        near = Fraction(1.618) / 2**40 * (abs(Fraction(leg.start)) + abs(Fraction(leg.end)))
        for bound, side in ((-near, 1), (near, -1)):
            place = (Fraction(about) + bound - Fraction(leg.start)) / width
            if 0 < place < 1:
                require(now.at.compare(place) == side, "a corner fails at another time")
        return now

    def check_middle(self, h, now, kind):
        """Which of the three is between the others."""
        u, v, w = self.tiling.corner(h)
        middle = v if self.tiling.sign[h] < 0 else w if kind in (1, 3) else u
        others = [x for x in (u, v, w) if x != middle]
        g = self.leg.function(middle, *others, dot=True)
        require(g.sign_after(g.roots_before(now.at)) < 0, "another vertex is between")

    def event(self, kind):
        about, h, t = self.log.f64(), self.log.u32(), self.tiling
        require(self.closed != self.inwards, "the wrong polygons")
        self.events += 1
        require(t.alive(h) and h in self.births, "no such corner")
        now = self.failure(h, about)
        corner = t.corner(h)
        if self.last.is_own(corner):
            require(now.number >= self.last.number, "out of order")
        else:
            require(self.last.at == 0 or now.at.compare(self.last.at) > 0, "out of order")
        self.check_middle(h, now, kind)
        self.last = now
        if kind in CONTACTS:
            hit = h if kind == 3 else t.next[h]
            require(t.sign[h] > 0 and t.of_body(hit), "no edge of a body is hit")
            self.all_hold(now)
            return self.contact(corner[2] if kind == 3 else corner[0], t.origin[hit & ~1], now)
        for k in t.ending(h, kind):
            if k in self.births:
                self.holds(k, now)
                del self.births[k]
        for k in t.apply(h, kind):
            self.begin(k, now)
        return None

    def contact(self, vertex, edge, now):
        now.at.refine(200)
        leg = self.leg
        x = Fraction(now.at.lo, 1 << now.at.bits)
        time = leg.joint if leg.joint is not None else float(leg.start + x * (Fraction(leg.end) - Fraction(leg.start)))
        return {"outcome": "contact", "t": time, "joint": leg.joint is not None,
                "vertex": self.plan.vertex_name(vertex), "edge": self.plan.edge_name(edge)}

    def all_hold(self, until):
        for h in self.births:
            self.holds(h, until)

    def end_leg(self):
        require(self.current + 1 < len(self.legs), "no further leg")
        self.all_hold(Instant(Fraction(1)))
        self.enter(self.current + 1)

    def free(self):
        require(self.closed != self.inwards, "the wrong polygons")
        while self.current + 1 < len(self.legs):
            self.end_leg()
        self.all_hold(Instant(Fraction(1)))
        return {"outcome": "free"}

    def free_until(self, t):
        require(self.closed != self.inwards, "the wrong polygons")
        leg = self.leg
        require(leg.start <= t <= leg.end, "not within the leg")
        width = Fraction(leg.end) - Fraction(leg.start)
        place = (Fraction(t) - Fraction(leg.start)) / width if width else Fraction(0)
        later = place > 0 if self.last.at == 0 else place == 1 or (place > 0 and self.last.at.compare(place) < 0)
        if later:
            self.all_hold(Instant(place))
        else:
            for h, birth in self.births.items():
                if birth is not self.last:
                    self.holds(h, self.last)
        return {"outcome": "undecided"}

    def touching(self, e, f):
        require(self.closed and self.inwards and self.events == 0 and self.current == 0, "no place for this")
        require(e < self.bodies.np <= f < self.bodies.size, "no such edges")
        place, following = self.plan.bodies(False).legs[0].places_at_start(), self.tiling.following
        a, b, c, d = (place[v] for v in (e, following(e), f, following(f)))
        sides = orientation(a, b, c), orientation(a, b, d), orientation(c, d, a), orientation(c, d, b)
        require(sides[0] * sides[1] < 0 and sides[2] * sides[3] < 0, "the edges do not cross")
        return {"outcome": "contact", "at_start": True}

    def run(self):
        result = None
        while result is None:
            kind = self.log.u8()
            if kind in EVENTS or kind in CONTACTS:
                result = self.event(kind)
            elif kind == NEXT_LEG:
                self.end_leg()
            elif kind == FREE:
                result = self.free()
            elif kind == FREE_UNTIL:
                result = self.free_until(self.log.f64())
            else:
                require(kind == TOUCHING, "unknown record")
                result = self.touching(self.log.u32(), self.log.u32())
        total = checksum(self.log.data[:self.log.at])
        require(self.log.take(8) == struct.pack("<Q", total), "the checksum")
        require(self.log.at == len(self.log.data), "something after the end")
        return dict(result, events=self.events, closed=self.closed)


def check(plan, data):
    """What the log proves, or None with the reason why it is no proof."""
    try:
        return Checker(plan, data).run(), ""
    except (Refused, Undecided) as error:
        return None, str(error)


def main():
    if len(sys.argv) != 3:
        print(__doc__, file=sys.stderr)
        return 2
    try:
        with open(sys.argv[1], encoding="utf-8") as scene, open(sys.argv[2], "rb") as log:
            proved, reason = check(Plan(json.load(scene)), log.read())
    except NotCovered as reason:
        print(f"not covered: {reason}")
        return 3
    print(json.dumps(proved) if proved else f"not a proof: {reason}")
    return 0 if proved else 1


if __name__ == "__main__":
    sys.exit(main())

"""An independent checker of logs of separations. Written from docs/separation-logs.md alone.

usage: separations.py SCENE LOG      exit codes: 0 a proof, 1 not a proof, 3 not decided, or not covered"""

import json
import math
import struct
import sys
from fractions import Fraction

from balls import ONE, Undecided, add, exact, first_change, keeps_sign, mul, root, sign
from checker import Bytes, checksum
from covered import NotCovered
from pairs import Pair, crossing, inside_the_other, product
from tiling import Refused, require
from windows import Windows
from world import Scene

FREE, CONTACT, TOUCHING, FREE_UNTIL, FINE_CONTACT, CLEARANCE = 0, 1, 2, 3, 4, 16
HALVE_TIME, HALVE_P, HALVE_Q, ENDS_APART, LATER = range(5)
MOST_HALVINGS = 61


class Contact:
    """The instant at which a vertex comes to an edge: between lo and hi, integers, of a leg's parameter."""

    def __init__(self, lo, hi, three):
        self.lo, self.hi, self.three = lo, hi, frozenset(three)


def direction_of(step, p, q):
    """(of P's frame, integers times 2^-BITS) or None."""
    if step in range(8, 16):
        (x, y), k = (p if step < 12 else q).along, step & 3
        if k & 1:
            x, y = -y, x
        if k & 2:
            x, y = -x, -y
        return step < 12, (exact(x), exact(y))
    if step in range(64, 128):
        quarters, t = divmod(step - 64, 16)
        x, y = 256 - t * t, 32 * t
        for _ in range(quarters):
            x, y = -y, x
        return True, (x * ONE >> 8, y * ONE >> 8)
    return None


class Separations:
    """One pair on one stretch of one leg."""

    def __init__(self, pair, leg, log, margin, until):
        self.pair, self.leg, self.log, self.margin, self.until = pair, leg, log, margin, until
        self.count = 0

    def visit(self, p, q, a, b, depth=0):
        step = self.log.u8()
        if step == HALVE_TIME:
            m = a + (b - a) / 2
            require(depth < MOST_HALVINGS and a < m < b, "time is halved too often")
            self.visit(p, q, a, m, depth + 1)
            self.visit(p, q, m, b, depth + 1)
        elif step in (HALVE_P, HALVE_Q):
            halves = (p if step == HALVE_P else q).halves
            require(halves, "a single edge is halved")
            for half in halves:
                self.visit(*((half, q) if step == HALVE_P else (p, half)), a, b, depth)
        elif step == LATER:
            require(self.until and exact(a) >= self.until.hi, "a stretch before the contact")
        else:
            why = self.log.u8() if step == ENDS_APART else 0
            self.once((id(p), id(q), a, b, step, why), lambda: self.is_apart(p, q, a, b, step, why))
            self.count += 1

    def once(self, what, ask):
        """The same question about the same scene is asked for many logs."""
        until = self.until and (self.until.lo, self.until.hi)
        key = (id(self.leg), self.margin, until, *what)
        if key not in self.pair.shown:
            try:
                self.pair.shown[key] = ask()
            except Undecided as reason:
                self.pair.shown[key] = reason
        known = self.pair.shown[key]
        if isinstance(known, Undecided):
            raise known
        require(known, "what the log says of two ranges is not so")

    def is_apart(self, p, q, a, b, step, why):
        a, b = exact(a), exact(b)
        if step != ENDS_APART:
            named = direction_of(step, p, q)
            require(named, "an unknown step")
            of_p, n = named
            near, far = (p, q) if of_p else (q, p)
            return self.pair.separated(self.leg, of_p, n, near, far, a, b, self.margin)
        require(not p.halves and not q.halves, "single edges where there are several")
        v, w = p.first, q.first + self.pair.np
        if not all(self.is_aside(*x, a, b) for x in ((w, v, why & 15), (v, w, why >> 4))):
            return False
        if not self.margin:
            return True
        square = product(self.margin, self.margin)
        return self.pair.far_apart(self.leg, v, w, square, a, b)

    def is_aside(self, vertex, edge, why, a, b):
        """Does the vertex stay off the edge that begins at `edge`?"""
        pair, leg = self.pair, self.leg
        end, more = pair.next(edge), 0
        require(why < 11 and (not self.margin or why < 4), "an unknown reason")
        if self.margin and why == 1:
            e = [y - x for x, y in zip(pair.points[edge], pair.points[end])]
            room = mul((self.margin, 0), root(add(product(e[0], e[0]), product(e[1], e[1]))))
            more = room[0] + room[1] + 2
        if why in (0, 1):
            return self.keeps((edge, end, vertex), 1 - 2 * why, a, b, more)
        if why in (2, 3):
            ends = (edge, end) if why == 2 else (end, edge)
            return pair.stays(leg, pair.projection(leg, *ends, vertex), -1, a, self.last(b))
        if why in (4, 5):
            line = pair.previous(edge) if why == 4 else end
            side = pair.rigid(line, pair.next(line), end if why == 4 else edge)
            return side != 0 and self.keeps((line, pair.next(line), vertex), -side, a, b)
        if why == 10:
            own = self.until and self.until.three == frozenset((edge, end, vertex))
            return self.behind_when_on_line(vertex, edge, end, a, min(b, self.until.lo) if own else self.last(b))
        line = pair.previous(vertex) if why in (6, 8) else vertex
        return all(self.keeps((line, pair.next(line), x), -1 if why < 8 else 1, a, b) for x in (edge, end))

    def behind_when_on_line(self, vertex, edge, end, a, b, depth=300):
        """On one side of the line, or behind one end, in each part of the stretch, however short these have to be."""
        pair, leg = self.pair, self.leg
        line = pair.orientation(leg, edge, end, vertex)
        ends = [pair.projection(leg, x, y, vertex) for x, y in ((edge, end), (end, edge))]
        for form, wanted in ((line, 1), (line, -1), (ends[0], -1), (ends[1], -1)):
            try:
                if pair.stays(leg, form, wanted, a, b):
                    return True
            except Undecided:
                pass
        m = (a + b) >> 1
        if depth == 0 or not a < m < b:
            raise Undecided("whether a vertex is behind an edge's end when it is on its line")
        return (self.behind_when_on_line(vertex, edge, end, a, m, depth - 1)
                and self.behind_when_on_line(vertex, edge, end, m, b, depth - 1))

    def last(self, b):
        return min(b, self.until.hi) if self.until else b

    def keeps(self, three, wanted, a, b, more=0):
        pair, leg, until = self.pair, self.leg, self.until
        form = pair.orientation(leg, *three)
        if until and until.lo <= b and until.three == frozenset(three):
            # It goes one way only from until.lo on, where it has its sign still.
            return a <= until.lo and pair.stays(leg, form, wanted, a, until.lo)
        return pair.stays(leg, form, wanted, a, self.last(b), more)


class Checker(Windows):
    def __init__(self, scene, data, known):
        self.scene, self.log, self.known = scene, Bytes(data), known
        log = self.log
        require(log.take(8) == b"tautprf4", "not a log of version 4")
        fingerprint, touch, claim = log.take(32), log.u8(), log.u8()
        require(touch <= 1 and claim & ~CLEARANCE <= FINE_CONTACT, "the header")
        require(fingerprint == scene.fingerprint(touch), "another scene")
        self.locked = False
        if scene.mechanism:
            scene.mechanism.read(log, scene.start)
            self.locked = scene.mechanism.until < scene.given_end
            scene.end = scene.mechanism.until
        self.closed, self.claim, self.margin = touch == 1, claim & ~CLEARANCE, 0
        require(any(scene.asked(a, b) for b in range(len(scene.bodies)) for a in range(b)), "nothing is proved")
        room = 2.0**-60
        self.inwards = not self.closed or self.claim == TOUCHING
        self.contact_pair, self.count = None, 0
        if claim & CLEARANCE:
            clearance = log.f64()
            require(self.claim != FINE_CONTACT and 0 < clearance < math.inf, "the clearance")
            self.margin = exact(Fraction(clearance) * Fraction(2) ** scene.exponent)
            require(self.margin > 0, "the clearance")
            room += math.ldexp(clearance, scene.exponent)
        self.room_at_rest = room * (1 + 2.0**-40)

    def pair(self, a, b, inwards=None):
        inwards = self.inwards if inwards is None else inwards
        key = (a, b, inwards)
        if key not in self.known:
            self.known[key] = Pair(self.scene, a, b, inwards)
        return self.known[key]

    def read_pair(self):
        a, b = self.log.u32(), self.log.u32()
        require(a < b < len(self.scene.bodies) and self.scene.asked(a, b), "a pair that is not asked about")
        return a, b

    def read_vertex(self, pair):
        v = self.log.u32()
        require(v < pair.size, "no such vertex")
        return v

    def section(self, pair, stretches, from_start, until=None):
        """A stretch is (number of a leg, from, to)."""
        for k, a, b in stretches:
            leg = pair.legs[k]
            last = until if (k, a, b) == stretches[-1] else None
            tree = Separations(pair, leg, self.log, 0 if leg.joint is not None else self.margin, last)
            tree.visit(*pair.ranges, a, b)
            self.count += tree.count
        if from_start:
            require(not pair.overlap_at_start(), "the bodies overlap at the start")

    def run(self):
        scene, log = self.scene, self.log
        self.until, found = scene.end, {"outcome": "locked" if self.locked else "free"}
        if self.claim == FREE_UNTIL:
            self.until, found = log.f64(), {"outcome": "undecided"}
        elif self.claim in (CONTACT, FINE_CONTACT):
            found = self.closer() if self.margin else self.contact()
        elif self.claim == TOUCHING:
            found = self.close_at_start() if self.margin else self.touching()
        require(scene.start <= self.until <= scene.end, "the end of the proof")
        self.windows(scene.start, self.until)
        total = checksum(log.data[:log.at])
        require(log.take(8) == struct.pack("<Q", total), "the checksum")
        require(log.at == len(log.data), "something after the end")
        return dict(found, closed=self.closed, separations=self.count, free_until=self.until)

    def contact(self):
        log = self.log
        self.contact_pair = self.read_pair()
        pair = self.pair(*self.contact_pair)
        k, vertex, edge = log.u32(), self.read_vertex(pair), self.read_vertex(pair)
        since = tuple(log.f64() for _ in range(3 if self.claim == FINE_CONTACT else 1))
        about, end, self.until = log.f64(), log.f64(), log.f64()
        require(k < len(pair.legs) and pair.in_p(vertex) != pair.in_p(edge), "a contact that cannot be")
        leg = pair.legs[k]
        require(all(map(math.isfinite, (*since, about, end))), "not a number")
        exactly = sum(map(Fraction, since))
        require(leg.start <= exactly <= leg.end and about <= leg.end, "a contact outside of its leg")
        at = pair.known_contact(leg, vertex, edge, since, about, self.find_contact)
        require(at, "no contact there")
        at = Contact(*at, (edge, pair.next(edge), vertex))
        for ends in ((edge, pair.next(edge)), (pair.next(edge), edge)):
            beside = pair.linear(leg, *pair.projection(leg, *ends, vertex), at.lo, at.hi).sign()
            if not beside:
                raise Undecided("whether the vertex meets the edge, or its line")
            require(beside > 0, "the vertex meets the edge's line only")
        require(end <= leg.end and exact(end) >= at.lo, "the stretch of the contact")
        way = [(i, pair.legs[i].start, pair.legs[i].end) for i in range(k)] + [(k, leg.start, end)]
        self.section(pair, way, True, at)
        time = leg.joint if leg.joint is not None else float(Fraction(at.hi, ONE))
        require(self.until <= math.nextafter(time, math.inf), "free beyond the contact")
        return {"outcome": "contact", "t": time, "joint": leg.joint is not None,
                "vertex": self.name(pair, vertex, "vertex"), "edge": self.name(pair, edge, "edge")}

    @staticmethod
    def find_contact(pair, leg, vertex, edge, since, about):
        near = Fraction(1.618) / 2**40 * (abs(Fraction(leg.start)) + abs(Fraction(leg.end)))
        of_p, parts = pair.orientation(leg, edge, pair.next(edge), vertex)

        def sample(a, b):
            return pair.linear(leg, of_p, parts, a, b)

        latest = min(exact(leg.end), math.floor((Fraction(about) + near) * ONE))
        outside = math.ceil(sum(map(Fraction, since)) * ONE)
        if not keeps_sign(sample, -1, outside, outside):
            return None
        found = first_change(sample, -1, outside, latest)
        return found if found and Fraction(found[1], ONE) >= Fraction(about) - near else None

    @staticmethod
    def name(pair, v, kind):
        body, offset = pair.body(v)
        return getattr(body, kind)(v - offset)

    def closer(self):
        log, a_b = self.log, self.read_pair()
        pair = self.pair(*a_b)
        k, vertex, peer, is_edge = log.u32(), self.read_vertex(pair), self.read_vertex(pair), log.u8()
        parts, self.until = [log.f64() for _ in range(3)], log.f64()
        require(k < len(pair.legs) and pair.legs[k].joint is None and pair.in_p(vertex) != pair.in_p(peer) and
                is_edge <= 1 and all(map(math.isfinite, parts)), "a closeness that cannot be")
        leg, (first, *rest) = pair.legs[k], map(Fraction, parts)
        require(sum(map(abs, rest)) <= (1 + abs(first)) / 2**40 and leg.start <= first + sum(rest) <= leg.end and
                self.until <= parts[0], "the instant of closeness")
        t = sum(map(exact, parts))
        require(self.is_closer(pair, leg, vertex, peer, is_edge, t), "the two are not closer")
        return {"outcome": "contact", "closer": True, "vertex": self.name(pair, vertex, "vertex"),
                ("edge" if is_edge else "other"): self.name(pair, peer, "edge" if is_edge else "vertex")}

    def is_closer(self, pair, leg, vertex, peer, is_edge, t):
        if not is_edge:
            square = product(self.margin, self.margin)
            try:
                return not pair.far_apart(leg, vertex, peer, square, t, t)
            except Undecided:
                raise Undecided("whether two vertices are closer than the clearance") from None
        end = pair.next(peer)
        e = [y - x for x, y in zip(pair.points[peer], pair.points[end])]
        room = mul((self.margin, 0), root(add(product(e[0], e[0]), product(e[1], e[1]))))
        forms = [pair.projection(leg, peer, end, vertex), pair.projection(leg, end, peer, vertex),
                 pair.orientation(leg, peer, end, vertex)]
        *values, side = [pair.linear(leg, *form, t, t).value for form in forms]
        signs = [sign(x) for x in (*values, add(room, side), add(room, (-side[0], side[1])))]
        if -1 in signs:
            return False
        if 0 in signs:
            raise Undecided("whether a vertex is closer to an edge than the clearance")
        return True

    def close_at_start(self):
        """Inner shapes keep the clearance at the start, as the windows show; two features of the outer ones do not."""
        a_b, log = self.read_pair(), self.log
        pair = self.pair(*a_b, False)
        vertex, peer, is_edge = self.read_vertex(pair), self.read_vertex(pair), log.u8()
        require(self.closed and is_edge <= 1 and pair.in_p(vertex) != pair.in_p(peer), "a closeness that cannot be")
        self.until = self.scene.start
        at = exact(self.scene.start)
        require(self.is_closer(pair, pair.legs[0], vertex, peer, is_edge, at), "the two are not as close at the start")
        return {"outcome": "contact", "closer": True, "vertex": self.name(pair, vertex, "vertex"),
                ("edge" if is_edge else "other"): self.name(pair, peer, "edge" if is_edge else "vertex")}

    def touching(self):
        a_b, log = self.read_pair(), self.log
        how = log.u8()
        pair = self.pair(*a_b, False)
        e, f = self.read_vertex(pair), self.read_vertex(pair)
        require(self.closed, "bodies may touch here")
        places = pair.placed(pair.legs[0], exact(self.scene.start))
        self.until = self.scene.start
        if how == 0:
            require(pair.in_p(e) != pair.in_p(f) and crossing(places, e, pair.next(e), f, pair.next(f)),
                    "the edges do not cross")
        else:
            require(how == 1 and e == f and inside_the_other(pair, places, e), "the vertex is not inside")
        return {"outcome": "contact", "at_start": True}


def check(scene, data, known):
    """(what the log proves, or None; why not; was that decided?). `known`: what was found out about the scene."""
    try:
        return Checker(scene, data, known).run(), "", True
    except Refused as error:
        return None, str(error), True
    except Undecided as error:
        return None, str(error), False


def main():
    if len(sys.argv) != 3:
        print(__doc__, file=sys.stderr)
        return 2
    sys.setrecursionlimit(10000)
    try:
        with open(sys.argv[1], encoding="utf-8") as scene, open(sys.argv[2], "rb") as log:
            proved, reason, decided = check(Scene(json.load(scene)), log.read(), {})
    except NotCovered as reason:
        print(f"not covered: {reason}")
        return 3
    if proved:
        print(json.dumps(proved))
        return 0
    print(f"not a proof: {reason}" if decided else f"not decided: {reason}")
    return 1 if decided else 3


if __name__ == "__main__":
    sys.exit(main())

"""A scene in the terms of a log of separations: fingerprint, rings, chains, pairs. See docs/separation-logs.md.

The scene must be valid."""

import copy
import functools
import hashlib
import math
import struct
from fractions import Fraction

import cosines
from balls import (J1, cadd, cmul, csub, exact, jadd, jconst, jinverse, jmul, jpolynomial, jpolynomial_about_middle,
                   jroot, jsub, jturn)
from bodies import (INFINITE, diameter, displaced, given_pieces, is_clockwise, made_between, number, origin_bytes,
                    origin_of, polynomial_on, seed_of, trimmed)
from covered import NotCovered
from keyframes import compiled
from mechanism import JointPiece, read_mechanism


def packed(polynomial):
    return struct.pack("<I", len(polynomial)) + b"".join(number(x) for x in polynomial)


def point(json):
    return tuple(float(c) for c in json) if json else (0.0, 0.0)


class Piece:
    """As given, and in internal units (`scaled`)."""

    KINDS = {"angle": 1, "direction": 2, "half_angle_tangent": 3, "cosine": 4}

    def __init__(self, json):
        if set(json) - {"x", "y", "until", "rotation", "pivot", "origin", "orbit"}:
            raise NotCovered("a motion of an unknown form")
        self.x, self.y = trimmed(json.get("x", [])), trimmed(json.get("y", []))
        self.until = float(json.get("until", INFINITE))
        self.kind, self.rotation = 0, ()
        for name, given in (json.get("rotation") or {}).items():
            self.kind = self.KINDS[name]
            given = [given["a"], given["b"]] if name == "direction" else [given]
            self.rotation = tuple(tuple(trimmed(c)) for c in given)
        orbit = json.get("orbit") or {}
        self.orbit = trimmed(orbit.get("angle", []))
        self.centre = point(orbit.get("center")) if self.orbit else (0.0, 0.0)
        self.pivot = point(json.get("pivot")) if self.kind or self.orbit else (0.0, 0.0)
        self.origin = origin_of(json, self.x, self.y, self.orbit, *self.rotation)

    def bytes(self):
        out = number(self.until) + origin_bytes(self.origin) + packed(self.x) + packed(self.y)
        if self.orbit:
            out += b"\5" + number(self.centre[0]) + number(self.centre[1]) + packed(self.orbit)
        out += bytes([self.kind]) + b"".join(packed(c) for c in self.rotation)
        if self.kind or self.orbit:
            out += number(self.pivot[0]) + number(self.pivot[1])
        return out

    def key(self):
        return tuple(self.x), tuple(self.y), self.kind, self.rotation, tuple(self.orbit), self.centre, self.pivot, self.origin

    def rests(self):
        return not (self.x or self.y or self.kind or self.orbit)

    def scale(self, exponent):
        """The coefficients in powers of the time itself, as integers times 2^-BITS, lengths multiplied by 2^exponent."""
        def length(x):
            return exact(Fraction(x) * Fraction(2) ** exponent)

        def in_time(c):
            return polynomial_on(c, 0, Fraction(-self.origin), Fraction(1))[:len(c)] if self.origin else c

        self.place = [[length(x) for x in in_time(c)] for c in (self.x, self.y)]
        self.c, self.m = [[(length(x), 0) for x in p] for p in (self.pivot, self.centre)]
        self.turn = [[exact(x) for x in in_time(c)] for c in self.rotation]
        self.orbit_turn = [exact(x) for x in in_time(self.orbit)]

    def pivot_place(self, t):
        """Where the pivot is."""
        k = [jadd(jpolynomial(c, t), jconst(at)) for c, at in zip(self.place, self.c)]
        if not self.orbit:
            return k
        m = [jconst(x) for x in self.m]
        return cadd(cmul(jturn(jpolynomial(self.orbit_turn, t)), csub(k, m)), m)

    def other_turn(self, t):
        """The rotation, unless it is given by an angle."""
        if self.kind == 4:
            cosine = jpolynomial_about_middle(self.turn[0], t)
            return cosine, jroot(jsub(J1, jmul(cosine, cosine)))
        c = [jpolynomial(p, t) for p in self.turn]
        if self.kind == 2:
            far = jinverse(jroot(jadd(jmul(c[0], c[0]), jmul(c[1], c[1]))))
            return jmul(c[0], far), jmul(c[1], far)
        square = jmul(c[0], c[0])
        below = jinverse(jadd(J1, square))
        return jmul(jsub(J1, square), below), jmul(jadd(c[0], c[0]), below)

    def until_then(self, until, turned):
        """The same up to another time, or for ever if None; where its cosine is 1 or -1 it rests."""
        part = copy.copy(self)
        if until is not None:
            part.until = until
        if turned != "cosine":
            part.kind, part.rotation = 2, ((1.0 if turned == "not turned" else -1.0,), ())
        return part


def cut_at_extremes(pieces, start, end):
    """Those whose rotations are given by cosines: between two cuts these stay below 1, or the body rests."""
    out, t = [], start
    for piece in pieces:
        until = min(piece.until, end)
        if piece.kind == 4:
            out += [piece.until_then(*part) for part in cosines.pieces(list(piece.rotation[0]) or [0.0], piece.origin,
                                                                   t, until)]
        else:
            out.append(piece)
        t = until
    return out


class Ring:
    """One ring of a body: scaled points with the material to the left, and their names in the scene."""

    def __init__(self, given, exponent, hole, part, ring):
        n, clockwise = len(given), is_clockwise(given)
        first, step = given.index(min(given)), -1 if clockwise else 1
        self.names = [(first + step * k) % n for k in range(n)]
        self.around = [tuple(math.ldexp(c, exponent) for c in given[k]) for k in self.names]  # counterclockwise
        self.hole, self.part, self.ring = hole, part, ring
        if hole:
            self.names = self.names[:1] + self.names[:0:-1]

    def points(self):
        return self.around[:1] + self.around[:0:-1] if self.hole else self.around

    def displaced(self, inwards, seed):
        moved = displaced(self.around, inwards != self.hole, seed)
        return moved[:1] + moved[:0:-1] if self.hole else moved


class Body:
    def __init__(self, rings, index):
        self.rings, self.index = rings, index
        self.points = [p for ring in rings for p in ring.points()]
        self.next, self.previous, self.ring_of = [], [], []
        for ring in rings:
            at, n = len(self.next), len(ring.names)
            self.next += [at + (k + 1) % n for k in range(n)]
            self.previous += [at + (k - 1) % n for k in range(n)]
            self.ring_of += [(ring, k) for k in range(n)]
        outer = [p for ring in rings if not ring.hole for p in ring.points()]
        self.box = (min(p[0] for p in outer), min(p[1] for p in outer),
                    max(p[0] for p in outer), max(p[1] for p in outer))
        self.outer = outer
        self.known = {}

    @functools.cached_property
    def diameter(self):
        return diameter(self.outer)

    def displaced(self, inwards):
        """Integers times 2^-BITS."""
        if inwards not in self.known:
            out = []
            for k, ring in enumerate(self.rings):
                out += [(exact(v[0]) + exact(d[0]), exact(v[1]) + exact(d[1]))
                        for v, d in ring.displaced(inwards, seed_of(self.index, k))]
            self.known[inwards] = out
        return self.known[inwards]

    def vertex(self, v):
        ring, k = self.ring_of[v]
        return [self.index, ring.part, ring.ring, ring.names[k]]

    def edge(self, v):
        """Named by the vertex with which it begins in the scene."""
        ring, k = self.ring_of[v]
        n = len(ring.names)
        a, b = ring.names[k], ring.names[(k + 1) % n]
        return [self.index, ring.part, ring.ring, a if (a + 1) % n == b else b]


everywhere = (-math.inf, math.inf)


def layers_of(body):
    """The layers of each of its parts."""
    def ends(z):
        return tuple(float(end if end is not None else other) for end, other in zip(z, everywhere))

    own = ends(body["z"]) if "z" in body else everywhere
    parts = body["parts"] if "parts" in body else [body["polygon"]]
    given = [part.get("z") if isinstance(part, dict) else None for part in parts]
    return [own if z is None else ends(z) for z in given]


def sections_of(layers):
    """From the lowest height up, (interval, parts): what a body is there."""
    heights = sorted({end for z in layers for end in z})
    sections = []
    for lo, hi in zip(heights, heights[1:]):
        parts = {k for k, z in enumerate(layers) if z[0] <= lo and hi <= z[1]}
        if sections and sections[-1][1] == parts and sections[-1][0][1] == lo:
            sections[-1] = ((sections[-1][0][0], hi), parts)
        elif parts:
            sections.append(((lo, hi), parts))
    return sections


class Scene:
    def __init__(self, json):
        self.start, self.end = (float(t) for t in json["time"])
        self.given_end = self.end
        self.bodies, self.own, self.chains = [], [], []
        given = [self._rings(body) for body in json["bodies"]]
        self.layers = [layers_of(body) for body in json["bodies"]]
        largest = max(abs(c) for rings in given for ring, hole, _, _ in rings if not hole for v in ring for c in v)
        self.exponent = -math.frexp(largest)[1]
        above = []
        for k, rings in enumerate(given):
            sections = sections_of(self.layers[k])
            for z, parts in sections:
                body = Body([Ring(r[0], self.exponent, *r[1:]) for r in rings if r[2] in parts], k)
                body.in_scene, body.z = k, z
                (self.bodies if z is sections[0][0] else above).append(body)
            motion = compiled(json["bodies"][k].get("motion"), self.start, self.end)
            self.own.append(self.pieces(given_pieces(motion)))
        self.in_scene = len(self.bodies)
        self.bodies += above
        self.at_rest_tested = json.get("at_rest") == "test"
        self._find_ignored(json)
        self.mechanism, self.mechanism_bytes, self.links = None, b"", {}
        if "mechanism" in json:
            self._join(json["mechanism"])
        self.hashed = self._hashed(json, given)
        self._find_chains()

    @staticmethod
    def _rings(body):
        parts = body["parts"] if "parts" in body else [body["polygon"]]
        out = []
        for k, part in enumerate(parts):
            if isinstance(part, dict) and "path" in part:
                raise NotCovered("a curve")
            rings = [part["outline"], *part.get("holes", [])] if isinstance(part, dict) else [part]
            out += [([(float(x), float(y)) for x, y in ring], i > 0, k, i) for i, ring in enumerate(rings)]
        return out

    def _find_ignored(self, json):
        self.names = {}
        for k, body in enumerate(json["bodies"]):
            self.names.setdefault(body["name"], k)
        self.ignored_by_all = [False] * self.in_scene
        self.ignored = set()
        for a, b in json.get("ignore", []):
            if a == b == "*":
                self.ignored_by_all = [True] * self.in_scene
            elif "*" in (a, b):
                self.ignored_by_all[self.names[b if a == "*" else a]] = True
            elif self.names[a] != self.names[b]:
                self.ignored.add(tuple(sorted((self.names[a], self.names[b]))))
        self.parents = [self.names[body["relative_to"]] if body.get("relative_to") else -1
                        for body in json["bodies"]]

    def _join(self, json):
        """Links move as their joints do, each seen from the one that carries it."""
        functions, self.mechanism_bytes = read_mechanism(json, self.names, self.exponent, self.start, self.end)
        linkage = functions.linkage
        self.mechanism = functions if linkage.unknowns else None
        ends = linkage.ends[:-1] + [INFINITE]
        for k, link in enumerate(linkage.tree.links):
            self.links[link.body] = k
            self.own[link.body] = [JointPiece(functions, k, piece, end) for piece, end in enumerate(ends)]
            self.parents[link.body] = linkage.tree.links[link.parent].body if link.parent >= 0 else -1

    def _hashed(self, json, given):
        """Without what comes before and in between: the name and the touch mode."""
        out = number(self.start) + number(self.end)

        def ring_bytes(ring):
            return struct.pack("<I", len(ring)) + b"".join(number(c) for v in ring for c in v)

        out += struct.pack("<I", len(given))
        for k, rings in enumerate(given):
            pieces = (struct.pack("<I", 0xFFFFFFFE) if k in self.links else
                      struct.pack("<I", len(self.own[k])) + b"".join(p.bytes() for p in self.own[k]))
            parts = [[r[0] for r in rings if r[2] == part] for part in range(rings[-1][2] + 1)]
            out += struct.pack("<I", len(parts))
            for part in parts:
                out += struct.pack("<I", len(part)) + b"".join(ring_bytes(ring) for ring in part)
            out += struct.pack("<I", self.parents[k] & 0xFFFFFFFF) + pieces + bytes([self.ignored_by_all[k]])
        out += struct.pack("<I", len(self.ignored))
        out += b"".join(struct.pack("<II", a, b) for a, b in sorted(self.ignored))
        out += bytes([1]) if self.at_rest_tested else b""
        if any(z != everywhere for body in self.layers for z in body):
            out += bytes([2])
            for body in self.layers:
                out += struct.pack("<I", len(body)) + b"".join(number(end) for z in body for end in z)
        return out + self.mechanism_bytes

    def fingerprint(self, closed):
        return hashlib.sha256(b"taut scene 3" + bytes([closed]) + self.hashed).digest()

    def pieces(self, given):
        return made_between(Piece, given, self.start, self.end)

    def motions(self):
        return [cut_at_extremes(pieces, self.start, self.end) for pieces in self.own]

    def _find_chains(self):
        moved = self.motions()
        for pieces in moved:
            for piece in pieces:
                piece.scale(self.exponent)
        for body in self.bodies:
            k = body.in_scene
            chain = []
            while k >= 0:
                if not all(piece.rests() for piece in moved[k]):
                    chain.insert(0, moved[k])
                k = self.parents[k]
            self.chains.append(chain)
        self.keys = [tuple(tuple((p.until, p.key()) for p in motion) for motion in chain) for chain in self.chains]
        listening = {key for key, ignored in zip(self.keys, self.ignored_by_all) if not ignored}
        self.tests_alike = self.at_rest_tested or len(listening) <= 1

    def asked(self, a, b):
        (first, a_lo, a_hi), (second, b_lo, b_hi) = ((self.bodies[k].in_scene, *self.bodies[k].z) for k in (a, b))
        if first == second or not max(a_lo, b_lo) < min(a_hi, b_hi):
            return False
        same = self.keys[a] == self.keys[b]
        a, b = first, second
        if self.ignored_by_all[a] or self.ignored_by_all[b] or (min(a, b), max(a, b)) in self.ignored:
            return False
        return self.tests_alike or not same

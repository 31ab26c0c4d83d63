"""How two bodies of a scene move relative to each other: poses of chains, legs, bridges.

See docs/separation-logs.md."""

import math
from fractions import Fraction

from balls import (J0, J1, add, between, cadd, cmul, conj, csub, exact, jadd, jconst, jmul, jpolynomial, jsub, jturn,
                   mul, sub)


class Pose:
    """Where a chain of pieces puts a body, which is taken relative to the point c: an angle, another turn, and where c
    is. The angle is kept as a polynomial, so that what two bodies turn alike is taken off before it is rounded."""

    def __init__(self, pieces):
        self.pieces = pieces
        self.c = [x[0] for x in pieces[-1].c] if pieces else [0, 0]
        self.angle = []
        for piece in pieces:
            if piece.kind == 1:
                self.angle = sum_of(self.angle, piece.turn[0])

    def other(self, t):
        out = None
        for piece in self.pieces:
            if piece.kind > 1:
                turn = piece.other_turn(t)
                out = cmul(out, turn) if out else turn
        return out

    def place(self, t):
        """The turn of each piece but the last is applied to what comes after it."""
        if not self.pieces:
            return J0, J0
        k = self.pieces[-1].pivot_place(t)
        for piece in reversed(self.pieces[:-1]):
            k = csub(k, [jconst(x) for x in piece.c])
            if piece.kind:
                k = cmul(jturn(jpolynomial(piece.turn[0], t)) if piece.kind == 1 else piece.other_turn(t), k)
            k = cadd(piece.pivot_place(t), k)
        return k

    def turn(self, t):
        return turned(self.angle, self.other(t), t)


def sum_of(a, b):
    n = max(len(a), len(b))
    return [x + y for x, y in zip(list(a) + [0] * (n - len(a)), list(b) + [0] * (n - len(b)))]


def turned(angle, other, t):
    while angle and angle[-1] == 0:
        angle = angle[:-1]
    out = jturn(jpolynomial(angle, t)) if angle else (J1, J0)
    return cmul(out, other) if other else out


class Bridge:
    """From one pose to another, straight, over [0, 1]."""

    def __init__(self, before, after, t):
        self.c = [0, 0]
        self.ends = []
        for pose in (before, after):
            at = (exact(t), 0)
            turn, place = pose.turn(at), pose.place(at)
            origin = csub(place, cmul(turn, [jconst((x, 0)) for x in pose.c]))
            self.ends.append([x[0] for x in (*origin, *turn)])

    def _at(self, k, s):
        a, b = self.ends[0][k], self.ends[1][k]
        change = sub(b, a)
        return add(a, mul(change, s)), change, (0, 0)

    def place(self, s):
        return self._at(0, s), self._at(1, s)

    def turn(self, s):
        return self._at(2, s), self._at(3, s)


class Leg:
    """Two bodies over a stretch of the parameter."""

    def __init__(self, start, end, p, q, joint=None):
        self.start, self.end, self.p, self.q, self.joint = start, end, p, q, joint
        self.frames = {}

    def frame(self, t):
        """As P sees Q, and Q sees P: the place of the other one, its turn, and the square of the own scale."""
        p, q = self.p, self.q
        between_them = csub(q.place(t), p.place(t))
        if self.joint is None:
            angle = sum_of(q.angle, [-a for a in p.angle])
            other_p, other_q = p.other(t), q.other(t)
            other = cmul(conj(other_p), other_q) if other_p and other_q else conj(other_p) if other_p else other_q
            turn, scales = turned(angle, other, t), (J1, J1)
            p_turn, q_turn = turned(p.angle, other_p, t), turned(q.angle, other_q, t)
        else:
            p_turn, q_turn = p.turn(t), q.turn(t)
            turn = cmul(conj(p_turn), q_turn)
            scales = [jadd(jmul(x[0], x[0]), jmul(x[1], x[1])) for x in (p_turn, q_turn)]
        from_p = cmul(conj(p_turn), between_them)
        from_q = cmul(conj(q_turn), between_them)
        return ((*from_p, *turn, scales[0]), (jsub(J0, from_q[0]), jsub(J0, from_q[1]), *conj(turn), scales[1]))

    def sampled_frame(self, a, b):
        key = (a, b)
        if key not in self.frames:
            if len(self.frames) > 4000:
                self.frames.clear()
            middle = (a + b) >> 1
            at = self.frame((middle, 0))
            self.frames[key] = at, at if a == b else self.frame(between(a, b))
        return self.frames[key]


def piece_at(motion, t):
    return next(piece for piece in motion if t < piece.until)


def chains_of(scene, p, q):
    """Without the first motions, as far as both have the same."""
    chains, common = [scene.chains[p], scene.chains[q]], 0
    while common < min(map(len, chains)) and scene.keys[p][common] == scene.keys[q][common]:
        common += 1
    return [chain[common:] for chain in chains]


def repeats_from(scene, p, q):
    """From when on nothing has to be shown of the pair: see "Repetition" in docs/proof-format.md."""
    begin, rates = scene.start, []
    for motion in (motion for chain in chains_of(scene, p, q) for motion in chain):
        last = next(k for k, piece in enumerate(motion) if piece.until >= scene.end)
        piece = motion[last]
        if piece.key()[0] == "joint":
            return math.inf
        if last:
            begin = max(begin, motion[last - 1].until)
        turning = piece.rotation[0] if piece.kind == 1 else ()
        resting = [piece.x, piece.y, *(piece.rotation if piece.kind != 1 else ())]
        if max(map(len, (turning, piece.orbit))) > 2 or max(map(len, resting)) > 1:
            return math.inf
        rates += [Fraction(c[1]) for c in (turning, piece.orbit) if len(c) == 2]
    if not rates:
        return math.inf
    below = math.lcm(*(rate.denominator for rate in rates))
    divisor = float(Fraction(math.gcd(*(int(rate * below) for rate in rates)), below))
    period = float.fromhex("0x1.921fb54442d19p+2") / divisor * (1 + 2.0**-50)
    instant = (begin + period) + 2.0**-51 * (abs(begin) + period)
    return instant if instant < scene.end else math.inf


def legs_of(scene, p, q):
    chains = chains_of(scene, p, q)
    legs, t = [], scene.start
    while True:
        now = [[piece_at(m, t) for m in chain] for chain in chains]
        until = min([scene.end] + [piece.until for pieces in now for piece in pieces])
        legs.append(Leg(t, until, Pose(now[0]), Pose(now[1])))
        if until >= scene.end:
            return legs
        t = until
        after = [[piece_at(m, t) for m in chain] for chain in chains]
        if any(a.key() != b.key() for side in (0, 1) for a, b in zip(now[side], after[side])):
            ends = [Bridge(Pose(now[side]), Pose(after[side]), t) for side in (0, 1)]
            legs.append(Leg(0.0, 1.0, *ends, joint=t))

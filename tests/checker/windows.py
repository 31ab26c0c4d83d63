"""The windows of a log of separations: the boxes that they state, and the pairs that they have to speak of."""

import math
import struct

from balls import Sampled, Undecided, add, between, exact, mul, sub
from legs import Pose, piece_at
from pairs import hull
from tiling import require

DEEPEST = 60
EVERYWHERE = (-math.inf, -math.inf, math.inf, math.inf)
ROOM = exact(2.0**-60)
HALVINGS = 14


class BodyPath:
    """A body's outlines while every motion of its chain follows one piece."""

    def __init__(self, body, pieces):
        self.pose = Pose(pieces)
        if "hull" not in body.known:
            points = [(exact(x), exact(y)) for ring in body.rings if not ring.hole for x, y in ring.points()]
            body.known["hull"] = [points[k] for k in hull(points)]
        self.points = [(x - self.pose.c[0], y - self.pose.c[1]) for x, y in body.known["hull"]]
        self.known = {}

    def extents(self, a, b):
        """For x and for y, the least and the greatest, as bounds."""
        if (a, b) not in self.known:
            frames = []
            for t in (((a + b) >> 1, 0), between(a, b)):
                frames.append((*self.pose.place(t), *self.pose.turn(t)))
            out = []
            for k in (0, 1):
                samples = [self.sampled(frames, k, p, a, b) for p in self.points]
                out.append((min(lo for lo, _ in samples), max(hi for _, hi in samples)))
            self.known[a, b] = out
        return self.known[a, b]

    @staticmethod
    def sampled(frames, k, p, a, b):
        jets = []
        for frame in frames:
            place, c, s = frame[k], frame[2], frame[3]
            u, v = ((p[0], 0), (p[1], 0))
            if k == 0:
                jets.append([add(x, sub(mul(y, u), mul(z, v))) for x, y, z in zip(place, c, s)])
            else:
                jets.append([add(x, add(mul(z, u), mul(y, v))) for x, y, z in zip(place, c, s)])
        f = Sampled(*jets, a, b)
        stray = f.value[1] + f.stray()
        # However it turns, it is no farther from the place of c.
        far = math.isqrt(p[0] * p[0] + p[1] * p[1]) + 1
        (middle, radius) = frames[1][k][0]
        return (max(f.value[0] - stray, middle - radius - far), min(f.value[0] + stray, middle + radius + far))

    def stays_within(self, box, room, a, b, halvings=HALVINGS):
        """`box` is of integers, or None for a side without bound."""
        inside = True
        for k, (lo, hi) in enumerate(self.extents(a, b)):
            inside = inside and (box[k] is None or box[k] <= lo - room)
            inside = inside and (box[k + 2] is None or hi + room <= box[k + 2])
        if inside:
            return True
        if a == b:
            return False
        m = (a + b) >> 1
        if halvings == 0:
            raise Undecided("whether a body stays within its box")
        return self.stays_within(box, room, a, m, halvings - 1) and self.stays_within(box, room, m, b, halvings - 1)


class Windows:
    """Part of the checker: what comes after the claim."""

    def windows(self, start, until):
        self.boxes = []
        for k, body in enumerate(self.scene.bodies):
            self.boxes.append(EVERYWHERE if self.scene.chains[k] else body.box)
        n = len(self.scene.bodies)
        everything = [(a, b) for a in range(n) for b in range(a + 1, n)
                      if self.scene.asked(a, b) and (a, b) != self.contact_pair]
        movers = [k for k in range(n) if self.scene.chains[k]]
        self.window(start, until, True, everything, movers, 0)

    def meet(self, a, b):
        p, q = self.boxes[a], self.boxes[b]
        if not self.scene.chains[a] and not self.scene.chains[b]:
            room = self.room_at_rest
            return not (p[0] - q[2] > room or q[0] - p[2] > room or p[1] - q[3] > room or q[1] - p[3] > room)
        return p[0] <= q[2] and q[0] <= p[2] and p[1] <= q[3] and q[1] <= p[3]

    def window(self, a, b, first, pairs, movers, depth):
        kind = self.log.u8()
        require(kind <= 1, "a window of an unknown kind")
        if kind == 0:
            return self.halves(a, b, first, pairs, movers, depth)
        before = list(self.boxes)
        for k in movers:
            flag = self.log.u8()
            require(flag <= 1, "neither a box nor none")
            if flag:
                self.boxes[k] = self.read_box(k, a, b)
        left = []
        for p, q in pairs:
            if not self.meet(p, q):
                continue
            now = self.log.u8()
            require(now <= 1, "neither separations nor shorter windows")
            if now:
                pair = self.pair(p, q)
                self.section(pair, stretches(pair.legs, a, min(b, pair.repeats), first), first)
            else:
                left.append((p, q))
        if left:
            moving = sorted({k for pair in left for k in pair if self.scene.chains[k]})
            self.halves(a, b, first, left, moving, depth)
        self.boxes = before
        return None

    def halves(self, a, b, first, pairs, movers, depth):
        m = a + (b - a) / 2
        require(depth < DEEPEST and a < m < b, "a window is halved too often")
        self.window(a, m, first, pairs, movers, depth + 1)
        self.window(m, b, False, pairs, movers, depth + 1)

    def read_box(self, k, a, b):
        box = struct.unpack("<4f", self.log.take(16))
        require(box[0] <= box[2] and box[1] <= box[3] and math.inf not in box[:2] and -math.inf not in box[2:],
                "a box that is none")
        key = ("box", k, a, b, box, self.margin)
        if key not in self.known:
            try:
                self.known[key] = self.stays_within(k, a, b, box)
            except Undecided as reason:
                self.known[key] = reason
        if isinstance(self.known[key], Undecided):
            raise self.known[key]
        require(self.known[key], "a body does not stay within its box")
        return box

    def path(self, k, pieces):
        key = ("path", k, tuple(map(id, pieces)))
        if key not in self.known:
            self.known[key] = BodyPath(self.scene.bodies[k], pieces)
        return self.known[key]

    def stays_within(self, k, a, b, box):
        chain, room = self.scene.chains[k], ROOM + self.margin
        box = [exact(x) if math.isfinite(x) else None for x in box]
        t = a
        while True:
            now = [piece_at(motion, t) for motion in chain]
            until = min(piece.until for piece in now)
            if not self.path(k, now).stays_within(box, room, exact(t), exact(min(until, b))):
                return False
            if until > b:
                return True
            t, mixed = until, [piece_at(motion, until) for motion in chain]
            for outer, old in enumerate(now):
                if not self.path(k, list(mixed)).stays_within(box, room, exact(t), exact(t)):
                    return False
                mixed[outer] = old
            if t >= b:
                return True


def stretches(legs, a, b, first):
    out = []
    for k, leg in enumerate(legs):
        if leg.joint is not None:
            if a < leg.joint <= b:
                out.append((k, leg.start, leg.end))
            continue
        lo, hi = max(a, leg.start), min(b, leg.end)
        if lo < hi or (lo == hi and first and k == 0):
            out.append((k, lo, hi))
    return out

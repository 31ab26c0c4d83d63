"""The equations of a mechanism's loops, and their derivatives, for numbers of two kinds: docs/separation-logs.md,
"Mechanisms"."""

import math
import struct
from fractions import Fraction

from balls import (BITS, EXTRA, J0, J1, ONE, PI, ZERO, add, exact, inverse, jadd, jconst, jmul, jsub, jturn, mul, root,
                   sin_cos, sub, times)
from bodies import number
from models import Model

DEGREE = (PI // 180 >> EXTRA, 2)


def fraction_ball(x):
    """Of any rational number."""
    return (x.numerator << BITS) // x.denominator, 1


class Balls:
    """The numbers of equations: values alone."""

    zero, one, add, sub, mul = ZERO, (ONE, 0), staticmethod(add), staticmethod(sub), staticmethod(mul)
    scaled = staticmethod(mul)

    @staticmethod
    def constant(x):
        return x

    @staticmethod
    def unit(degrees):
        s, c = sin_cos(mul(degrees, DEGREE))
        return c, s


class Jets:
    """The same as functions of time: jets, as balls.py has them."""

    zero, one, add, sub, mul, constant = J0, J1, staticmethod(jadd), staticmethod(jsub), staticmethod(jmul), \
        staticmethod(jconst)

    @staticmethod
    def unit(degrees):
        return jturn(tuple(mul(x, DEGREE) for x in degrees))

    @staticmethod
    def scaled(f, ball):
        return mul(f[0], ball), mul(f[1], ball), mul(f[2], ball)


class Models:
    """And over a cell: polynomials of its relative time, with an error."""

    zero, one, constant = Model.constant(ZERO), Model.constant((ONE, 0)), staticmethod(Model.constant)
    add, sub, mul = staticmethod(Model.plus), staticmethod(Model.minus), staticmethod(Model.by)

    @staticmethod
    def unit(degrees):
        return degrees.scaled(DEGREE).turn()

    @staticmethod
    def scaled(f, ball):
        return f.scaled(ball)


class Drive:
    """The pieces of a driven joint's value, each a polynomial in the time, with exact coefficients."""

    def __init__(self, json, kind, start, end):
        self.given, self.kind = [], kind
        degrees = kind == "revolute"
        if isinstance(json, list):
            frames = [(float(f["t"]), float(f["deg" if degrees else "value"])) for f in json]
            for k in range(len(frames) - 1):
                until = frames[k + 1][0] if k + 2 < len(frames) else math.inf
                self.given.append((until, (*frames[k], *frames[k + 1]), None))
            if len(frames) == 1:
                self.given.append((math.inf, None, [frames[0][1]]))
        elif "deg" in json or "value" in json:
            self.given.append((math.inf, None, [float(x) for x in json["deg" if degrees else "value"]]))
        else:
            ends = [float(json[name + ("_deg" if degrees else "")]) for name in ("from", "to")]
            self.given.append((math.inf, (start, ends[0], end, ends[1]), None))

    def bytes(self):
        out = struct.pack("<I", len(self.given))
        for until, line, polynomial in self.given:
            out += number(until)
            if line:
                out += b"\1" + b"".join(number(x) for x in line)
            else:
                c = polynomial
                out += b"\0" + struct.pack("<I", len(c)) + b"".join(number(x) for x in c)
        return out

    def at_piece(self, end):
        """The polynomial, as Fractions, of the piece that holds up to `end`."""
        _, line, polynomial = next((piece for piece in self.given if end <= piece[0]), self.given[-1])
        if not line:
            return [Fraction(x) for x in polynomial]
        t0, v0, t1, v1 = map(Fraction, line)
        if t0 == t1 or v0 == v1:
            return [v0]
        slope = (v1 - v0) / (t1 - t0)
        return [v0 - slope * t0, slope]


def value_at(polynomial, t):
    total = Fraction(0)
    for c in reversed(polynomial):
        total = total * t + c
    return total


def drive_jet(polynomial, t):
    """Of a ball of times."""
    v, d, dd = ZERO, ZERO, ZERO
    for x in reversed(polynomial):
        dd = add(mul(dd, t), d)
        d = add(mul(d, t), v)
        v = add(mul(v, t), fraction_ball(x))
    return v, d, times(dd, 2)


class Form:
    """A sum of multiples of unknowns and drives."""

    def __init__(self, of, index, factor=Fraction(1)):
        self.of, self.index, self.factor = of, index, factor

    def value(self, algebra, unknowns, drives):
        x = (unknowns if self.of == "unknown" else drives)[self.index]
        return x if self.factor == 1 else algebra.scaled(x, fraction_ball(self.factor))

    def rate(self, unknown):
        return self.factor if self.of == "unknown" and self.index == unknown else 0


class Joint:
    """Of the tree: how a link moves against the one that carries it. Of a closure: two links."""

    def __init__(self, given, origin, unit):
        self.slide = given.slide
        if self.slide:
            x, y = (exact(Fraction(c)) for c in given.at)
            length = root(add(mul((x, 0), (x, 0)), mul((y, 0), (y, 0))))
            self.direction = [mul((c, 0), inverse(length)) for c in (x, y)]
            self.place = [ZERO, ZERO]
        else:
            self.place = [((exact((Fraction(c) - Fraction(o)) * unit)), 0) for c, o in zip(given.at, origin)]


class Linkage:
    """The equations of a mechanism: F(unknowns, drives) = 0. Lengths are scaled by 2^exponent."""

    def __init__(self, json, tree, exponent, start, end):
        self.tree, self.unit = tree, Fraction(2) ** exponent
        joints = tree.joints
        self.drives = [Drive(given, joints[tree.named(name)].kind, start, end)
                       for name, given in json.get("drive", {}).items()]
        self.driven = {tree.named(name): k for k, name in enumerate(json.get("drive", {}))}
        self.couplings = {tree.named(c["joint"]): (tree.named(c["to"]), float(c.get("times", 1)))
                          for c in json.get("couple", [])}
        sources = {to for to, _ in self.couplings.values()}
        self.unknown_of = {}
        origin = next((j.at for j in joints if not j.slide), (0.0, 0.0))
        self.moved = [Joint(joints[link.joint], origin, self.unit) for link in tree.links]
        self.forms = [self.form(link.joint) for link in tree.links]
        self.closures = []
        for k in tree.closures:
            known = k in self.driven or k in self.couplings or k in sources
            ends = [tree.link_of.get(body, -1) for body in joints[k].bodies]
            self.closures.append((*ends, Joint(joints[k], origin, self.unit), self.form(k) if known else None))
        self.unknowns = len(self.unknown_of)
        # Sizes of the unknowns that matter equally: a degree, and for a slide about what a degree moves.
        extent = max([abs(c[0]) for joint in self.moved + [x[2] for x in self.closures] for c in joint.place] + [0])
        slides = {index for joint, index in self.unknown_of.items() if joints[joint].slide}
        self.weights = [(extent / ONE / 64 or 1.0) if k in slides else 1.0 for k in range(self.unknowns)]
        ends = {until for drive in self.drives for until, *_ in drive.given if start < until < end}
        self.ends = sorted(ends | {end})
        self.paths = [[drive.at_piece(end) for drive in self.drives] for end in self.ends]
        self.begins = [value_at(path, Fraction(start)) for path in self.paths[0]]

    def unit_of(self, joint):
        return self.unit if self.tree.joints[joint].slide else Fraction(1)

    def form(self, joint):
        factor, first = Fraction(1), joint
        while joint in self.couplings and joint not in self.driven:
            joint, by = self.couplings[joint]
            factor *= Fraction(by)
        factor = factor * self.unit_of(first)
        if joint in self.driven:  # as given, in the scene's units
            return Form("drive", self.driven[joint], factor)
        index = self.unknown_of.setdefault(joint, len(self.unknown_of))
        return Form("unknown", index, factor / self.unit_of(joint))

    def poses(self, algebra, unknowns, drives):
        """Of all links: where the origin is, two numbers, and a turn, two numbers."""
        out = []
        for link, joint, form in zip(self.tree.links, self.moved, self.forms):
            value = form.value(algebra, unknowns, drives)
            if link.reversed:
                value = algebra.sub(algebra.zero, value)
            own = self.joint_pose(algebra, joint, value)
            out.append(own if link.parent < 0 else self.composed(algebra, out[link.parent], own))
        return out

    @staticmethod
    def joint_pose(algebra, joint, value):
        if joint.slide:
            return [algebra.scaled(value, c) for c in joint.direction] + [algebra.one, algebra.zero]
        c, s = algebra.unit(value)
        x, y = joint.place
        versine = algebra.sub(algebra.one, c)
        return [algebra.add(algebra.scaled(versine, x), algebra.scaled(s, y)),
                algebra.sub(algebra.scaled(versine, y), algebra.scaled(s, x)), c, s]

    def composed(self, algebra, outer, inner):
        x, y = self.turned(algebra, outer, inner[:2])
        return [algebra.add(outer[0], x), algebra.add(outer[1], y), *self.turned(algebra, outer, inner[2:])]

    @staticmethod
    def turned(algebra, pose, v):
        c, s = pose[2:]
        return (algebra.sub(algebra.mul(c, v[0]), algebra.mul(s, v[1])),
                algebra.add(algebra.mul(s, v[0]), algebra.mul(c, v[1])))

    @staticmethod
    def turned_vector(algebra, pose, v):
        """Of a vector of two balls."""
        c, s = pose[2:]
        return (algebra.sub(algebra.scaled(c, v[0]), algebra.scaled(s, v[1])),
                algebra.add(algebra.scaled(s, v[0]), algebra.scaled(c, v[1])))

    def placed(self, algebra, pose, at):
        x, y = self.turned_vector(algebra, pose, at)
        return algebra.add(pose[0], x), algebra.add(pose[1], y)

    def on_path(self, link):
        while link >= 0:
            yield link
            link = self.tree.links[link].parent

    def angle(self, algebra, unknowns, drives, link):
        total = algebra.zero
        for k in self.on_path(link):
            if not self.moved[k].slide:
                value = self.forms[k].value(algebra, unknowns, drives)
                total = (algebra.sub if self.tree.links[k].reversed else algebra.add)(total, value)
        return total

    @staticmethod
    def pose(algebra, poses, link):
        return poses[link] if link >= 0 else [algebra.zero, algebra.zero, algebra.one, algebra.zero]

    def apart(self, algebra, poses, first, second, joint):
        """Of a closure: its first body's pose, where each body puts the joint, and the way between the two."""
        a, b = self.pose(algebra, poses, first), self.pose(algebra, poses, second)
        p, q = self.placed(algebra, a, joint.place), self.placed(algebra, b, joint.place)
        return a, p, q, (algebra.sub(q[0], p[0]), algebra.sub(q[1], p[1]))

    @staticmethod
    def seen_from(algebra, pose, v):
        """A vector's coordinates in a frame that turns with a link."""
        c, s = pose[2:]
        return (algebra.add(algebra.mul(c, v[0]), algebra.mul(s, v[1])),
                algebra.sub(algebra.mul(c, v[1]), algebra.mul(s, v[0])))

    def equations(self, algebra, unknowns, drives, turning=False):
        """`turning`: the gap of a pin that closes a loop is seen from the later one of its links, not from the ground.
        Both vanish at once; where a loop turns as a whole, the former equations do not turn with it."""
        poses, out = self.poses(algebra, unknowns, drives), []
        for first, second, joint, form in self.closures:
            a, _, _, (x, y) = self.apart(algebra, poses, first, second, joint)
            if turning and not joint.slide:
                x, y = self.seen_from(algebra, poses[max(first, second)], (x, y))
            turn = algebra.sub(self.angle(algebra, unknowns, drives, second),
                               self.angle(algebra, unknowns, drives, first))
            value = form and form.value(algebra, unknowns, drives)
            if not joint.slide:
                out += [x, y] + ([algebra.sub(turn, value)] if form else [])
                continue
            ex, ey = self.turned_vector(algebra, a, joint.direction)
            out += [algebra.sub(algebra.mul(ex, y), algebra.mul(ey, x)), turn]
            if form:
                along = algebra.add(algebra.mul(ex, x), algebra.mul(ey, y))
                out.append(algebra.sub(along, value))
        return out

    def jacobian(self, algebra, unknowns, drives, turning=False):
        """Rows of the derivatives of the equations by the unknowns."""
        poses, rows = self.poses(algebra, unknowns, drives), []
        for first, second, joint, form in self.closures:
            a, p, q, apart = self.apart(algebra, poses, first, second, joint)
            e = self.turned_vector(algebra, a, joint.direction) if joint.slide else None
            frame = max(first, second) if turning and not joint.slide else None
            size = 2 + (form is not None)
            block = [[algebra.zero] * self.unknowns for _ in range(size)]
            for side, link, point in ((-1, first, p), (1, second, q)):
                for k in self.on_path(link):
                    if self.forms[k].of != "unknown":
                        continue
                    moves = self.change(algebra, poses, k, side, point, joint, e, apart)
                    if frame is not None:
                        moves = self.change_seen(algebra, poses[frame], k, link == frame, moves, apart)
                    j, factor = self.forms[k].index, fraction_ball(self.forms[k].factor)
                    for i in range(size):
                        block[i][j] = algebra.add(block[i][j], algebra.scaled(moves[i], factor))
            if form and form.of == "unknown":
                by = (-form.factor.numerator << BITS) // form.factor.denominator, 1
                block[2][form.index] = algebra.add(block[2][form.index], algebra.constant(by))
            rows += block
        return rows

    def change(self, algebra, poses, k, side, point, joint, e, apart):
        """How a closure's equations change with the value of a joint between one of its links and the ground."""
        own, link = self.moved[k], self.tree.links[k]
        parent = self.pose(algebra, poses, link.parent)
        sign = side * (-1 if link.reversed else 1)
        radian = times(DEGREE, sign)
        if own.slide:
            turn = algebra.zero
            u, v = self.turned_vector(algebra, parent, own.direction)
            way = algebra.scaled(u, (sign * ONE, 0)), algebra.scaled(v, (sign * ONE, 0))
        else:
            turn = algebra.constant((sign * ONE, 0))
            pivot = self.placed(algebra, parent, own.place)
            way = (algebra.scaled(algebra.sub(pivot[1], point[1]), radian),
                   algebra.scaled(algebra.sub(point[0], pivot[0]), radian))
        if not joint.slide:
            return (*way, turn)
        across = algebra.sub(algebra.mul(e[0], way[1]), algebra.mul(e[1], way[0]))
        along = algebra.add(algebra.mul(e[0], way[0]), algebra.mul(e[1], way[1]))
        if side < 0 and not own.slide:
            # The direction turns with the first body; `radian` has the sign of a difference.
            x, y = apart
            dot = algebra.add(algebra.mul(e[0], x), algebra.mul(e[1], y))
            det = algebra.sub(algebra.mul(e[1], x), algebra.mul(e[0], y))
            across = algebra.add(across, algebra.scaled(dot, radian))
            along = algebra.add(along, algebra.scaled(det, radian))
        return across, turn, along

    def change_seen(self, algebra, frame, k, turns, moves, apart):
        """The same of a pin whose gap is seen from a link, which may turn with the joint's value as well."""
        x, y = self.seen_from(algebra, frame, moves[:2])
        if turns and not self.moved[k].slide:
            by = times(DEGREE, -1 if self.tree.links[k].reversed else 1)
            along, across = self.seen_from(algebra, frame, apart)
            x = algebra.add(x, algebra.scaled(across, by))
            y = algebra.sub(y, algebra.scaled(along, by))
        return x, y, moves[2]

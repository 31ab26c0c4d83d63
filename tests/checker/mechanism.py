"""Mechanisms with closed loops: their joints' values as functions of time, from the cells that a log states.

Written from docs/separation-logs.md, "Mechanisms", alone. The equations, their derivatives and the proof that each cell
holds one solution are here; the arithmetic is in balls.py and models.py."""

import math
import struct
from fractions import Fraction

from balls import (BITS, EXTRA, J0, J1, ONE, PI, UNBOUNDED, ZERO, Undecided, add, between, exact, inverse, jadd,
                   jconst, jmul, jsub, jturn, mul, root, sub, times)
from bodies import number
from joint_tree import Tree
from models import Model
from tiling import require

DEGREE = (PI // 180 >> EXTRA, 2)
ORDER = 17
ROUNDING = 1 << 64
LEAST_TUBE = Fraction(1, 2**40)
MOST_WIDENINGS = 8


def fraction_ball(x):
    """Of any rational number."""
    return (x.numerator << BITS) // x.denominator, 1


class Jets:
    """The numbers of equations: jets of time, as balls.py has them."""

    zero, one, add, sub, mul, constant = J0, J1, staticmethod(jadd), staticmethod(jsub), staticmethod(jmul), \
        staticmethod(jconst)

    @staticmethod
    def unit(degrees):
        return jturn(tuple(mul(x, DEGREE) for x in degrees))

    @staticmethod
    def scaled(f, ball):
        return mul(f[0], ball), mul(f[1], ball), mul(f[2], ball)


class Models:
    """The same over a cell: polynomials of its relative time, with an error."""

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

    def equations(self, algebra, unknowns, drives):
        rest = [algebra.zero, algebra.zero, algebra.one, algebra.zero]
        poses, out = self.poses(algebra, unknowns, drives), []
        for first, second, joint, form in self.closures:
            a, b = (poses[k] if k >= 0 else rest for k in (first, second))
            p, q = self.placed(algebra, a, joint.place), self.placed(algebra, b, joint.place)
            x, y = algebra.sub(q[0], p[0]), algebra.sub(q[1], p[1])
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

    def jacobian(self, algebra, unknowns, drives):
        """Rows of the derivatives of the equations by the unknowns."""
        rest = [algebra.zero, algebra.zero, algebra.one, algebra.zero]
        poses, rows = self.poses(algebra, unknowns, drives), []
        for first, second, joint, form in self.closures:
            a, b = (poses[k] if k >= 0 else rest for k in (first, second))
            p, q = self.placed(algebra, a, joint.place), self.placed(algebra, b, joint.place)
            e = self.turned_vector(algebra, a, joint.direction) if joint.slide else None
            apart = algebra.sub(q[0], p[0]), algebra.sub(q[1], p[1])
            size = 2 + (form is not None)
            block = [[algebra.zero] * self.unknowns for _ in range(size)]
            for side, link, point in ((-1, first, p), (1, second, q)):
                for k in self.on_path(link):
                    if self.forms[k].of != "unknown":
                        continue
                    moves = self.change(algebra, poses, k, side, point, joint, e, apart)
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
        parent = poses[link.parent] if link.parent >= 0 else [algebra.zero, algebra.zero, algebra.one, algebra.zero]
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


def float_inverse(rows):
    n = len(rows)
    left, right = [list(r) for r in rows], [[float(i == j) for j in range(n)] for i in range(n)]
    for k in range(n):
        pivot = max(range(k, n), key=lambda i: abs(left[i][k]))
        if left[pivot][k] == 0 or not math.isfinite(left[pivot][k]):
            raise Undecided("a mechanism near a dead point")
        for m in (left, right):
            m[k], m[pivot] = m[pivot], m[k]
        by = 1 / left[k][k]
        for m in (left, right):
            m[k] = [x * by for x in m[k]]
        for i in range(n):
            share = left[i][k]
            if i != k and share:
                for m in (left, right):
                    m[i] = [x - share * y for x, y in zip(m[i], m[k])]
    return right


def approximate_inverse(rows):
    """In doubles, as integers times 2^-BITS; any matrix would do."""
    return [[floor_of(Fraction(x)) for x in row] for row in float_inverse([[x[0] / ONE for x in row] for row in rows])]


def floor_of(x):
    """Of a rational number, times 2^BITS."""
    return (x.numerator << BITS) // x.denominator


def ceiling(x, bits):
    return -(-x >> bits)


def magnitude(x):
    return abs(x[0]) + x[1]


class Preconditioned:
    """A matrix A of balls, an approximate inverse Y in doubles, and a bound of |1 - Y A|."""

    def __init__(self, rows, weights, y=None):
        self.rows, self.weights = rows, weights
        self.y = y or approximate_inverse(rows)
        n = len(rows)
        bounds = []
        for i in range(n):
            total = Fraction(0)
            for j in range(n):
                entry = (ONE if i == j else 0, 0)
                for k in range(n):
                    entry = sub(entry, mul((self.y[i][k], 0), rows[k][j]))
                total += Fraction(magnitude(entry), ONE) * Fraction(weights[j]) / Fraction(weights[i])
            bounds.append(total)
        self.norm = max(bounds, default=Fraction(0))
        if self.norm >= Fraction(9, 10):
            raise Undecided("a mechanism near a dead point")

    def product(self, v):
        out = []
        for row in self.y:
            total = ZERO
            for y, x in zip(row, v):
                total = add(total, mul((y, 0), x))
            out.append(total)
        return out

    def size(self, v):
        """In the norm with the weights."""
        return max((Fraction(magnitude(x), ONE) / Fraction(w) for x, w in zip(v, self.weights)), default=Fraction(0))

    def spread(self, size):
        """A number of that size for each unknown, as integers."""
        return [math.ceil(size * Fraction(w) * ONE) + 1 for w in self.weights]

    def solve(self, b):
        x, steps = [0] * len(b), 12
        for k in range(steps + 1):
            rest = []
            for row, right in zip(self.rows, b):
                for a, c in zip(row, x):
                    right = sub(right, mul(a, (c, 0)))
                rest.append(right)
            change = self.product(rest)
            if k == steps:
                break
            x = [c + d[0] for c, d in zip(x, change)]
        far = self.spread(self.size(change) / (1 - self.norm))
        return [(c, r) for c, r in zip(x, far)]


class Cell:
    """A part of the time, from `lo` to `hi` (doubles), with a polynomial for each unknown about the middle."""

    def __init__(self, linkage, drives, lo, hi, given):
        self.lo, self.hi, self.drives = lo, hi, drives
        self.first, self.last = exact(lo), exact(hi)
        middle = lo + (hi - lo) / 2
        radius = max(hi - middle, middle - lo, 2.0**-900) / 0.6875
        unit = [linkage.unit_of(joint) for joint in linkage.unknown_of]
        self.half = max(Fraction(hi) - Fraction(middle), Fraction(middle) - Fraction(lo))
        self.middle = Fraction(middle)
        share = self.half / Fraction(radius)
        self.models = [Model([fraction_ball(Fraction(x) * u * share**k)[0] for k, x in enumerate(c)], len(c))
                       for c, u in zip(given, unit)]
        # In powers of the time since the middle, as Fractions: for values.
        self.given = [[Fraction(x) * u for x in c] for c, u in zip(given, unit)]
        self.radius = Fraction(radius)

    def value(self, t):
        """The polynomials at a Fraction, rounded."""
        s = (t - self.middle) / self.radius
        s = Fraction((s.numerator << BITS) // s.denominator, ONE)
        out = []
        for c in self.given:
            total = 0
            for x in reversed(c):
                total = (total * s.numerator // s.denominator) + fraction_ball(x)[0]
            out.append((total, 1 << 12))
        return out

    def drive_models(self):
        out = []
        time = Model([fraction_ball(self.middle)[0], fraction_ball(self.half)[0]], 2)
        for c in self.drives:
            total = Models.zero
            for x in reversed(c):
                total = Model.plus(Model.by(total, time), Model.constant(fraction_ball(x)))
            out.append(total)
        return out

    def prove(self, linkage, last):
        """One solution is within the tube of the polynomials, at each time of the cell; and it is the one in `last`."""
        n = linkage.unknowns
        drives = self.drive_models()
        y = approximate_inverse([[(m.c[0], 0) for m in row] for row in
                                 linkage.jacobian(Models, self.models, drives)])
        wrong = [m.norm() for m in self.times(y, linkage.equations(Models, self.models, drives))]
        # As narrow as the beginning allows: near a dead point, another solution is near.
        self.tube = [4 * max(w, x[1]) + floor_of(Fraction(weight) * LEAST_TUBE)
                     for w, x, weight in zip(wrong, last, linkage.weights)]
        for _ in range(MOST_WIDENINGS):
            bound = self.contraction(linkage, y, drives)
            inner = [w + ceiling(sum(x * r for x, r in zip(row, self.tube)), BITS) for w, row in zip(wrong, bound)]
            if all(x < r for x, r in zip(inner, self.tube)):
                break
            self.tube = [max(r, x + (x >> 2) + 1) for x, r in zip(inner, self.tube)]
        else:
            raise Undecided("the joints of a mechanism, over a part of the time")
        self.error = self.closure(linkage, bound, wrong)
        for value, before, r in zip(self.value(Fraction(self.lo)), last, self.tube):
            if not magnitude(sub(value, before)) < r:
                raise Undecided("which way a mechanism goes on")

    def contraction(self, linkage, y, drives):
        """A bound of |1 - Y F'| for all values within the tube."""
        n = linkage.unknowns
        slopes = linkage.jacobian(Models, [m.widened(r) for m, r in zip(self.models, self.tube)], drives)
        bound = [[0] * n for _ in range(n)]
        for j in range(n):
            for i, entry in enumerate(self.times(y, [slopes[k][j] for k in range(n)])):
                bound[i][j] = Model.minus(Model.constant((ONE if i == j else 0, 0)), entry).norm()
        return bound

    @staticmethod
    def times(y, v):
        out = []
        for row in y:
            total = Models.zero
            for a, x in zip(row, v):
                total = Model.plus(total, x.scaled((a, 0)))
            out.append(total)
        return out

    def closure(self, linkage, bound, wrong):
        """Of the solution's distance d from the polynomials, d <= wrong + bound d, and it is within the tube."""
        weights = [Fraction(w) for w in linkage.weights]
        norm = max(sum(Fraction(x, ONE) * w for x, w in zip(row, weights)) / own for row, own in zip(bound, weights))
        if norm >= 1:
            return self.tube
        most = max(Fraction(w, ONE) / own for w, own in zip(wrong, weights)) / (1 - norm)
        return [min(r, floor_of(most * w) + 1) for r, w in zip(self.tube, weights)]

    def ends(self):
        """The unknowns at the end."""
        return [add(x, (0, r)) for x, r in zip(self.value(Fraction(self.hi)), self.error)]

    def over(self, lo, hi):
        """Values over a part of it, integers."""
        out = []
        middle, half = Fraction(lo + hi, 2 * ONE), Fraction(hi - lo, 2 * ONE)
        reach = max(abs(Fraction(lo, ONE) - self.middle), abs(Fraction(hi, ONE) - self.middle)) / self.radius
        for at, c, r in zip(self.value(middle), self.given, self.error):
            slope = sum(k * abs(x) * reach**(k - 1) for k, x in enumerate(c) if k)
            out.append((at[0], at[1] + r + math.ceil(slope * half / self.radius * ONE) + 1))
        return out


class Functions:
    """The values of the tree's joints as functions of time."""

    def __init__(self, linkage):
        self.linkage, self.cells, self.known = linkage, None, {}

    def read(self, log, start):
        """What a log states, all of which is proved."""
        linkage = self.linkage
        last = [ZERO] * linkage.unknowns
        if any(linkage.begins):
            straight = [[Fraction(0), begin] for begin in linkage.begins]
            _, last, _ = self.read_path(log, straight, 0.0, 1.0, last)
        cells, t = [], start
        for drives, end in zip(linkage.paths, linkage.ends):
            path, last, t = self.read_path(log, drives, t, end, last)
            cells.append(path)
            if t < end or not last:
                break
        if self.cells is None:
            self.cells, self.until = cells, t
        elif self.until != t:
            raise Undecided("up to when a mechanism is followed")

    def read_path(self, log, drives, t, end, last):
        linkage, cells = self.linkage, []
        for _ in range(log.u32()):
            kind, to = log.u8(), log.f64()
            require(kind <= 1, "a cell of an unknown kind")
            require(t < to <= end or t == to == end and not cells, "a part of the time that makes no sense")
            if kind == 1:  # Nothing is stated of it, and nothing is found out here.
                require(cells, "no cells")
                return cells, None, to
            given = []
            for _ in range(linkage.unknowns):
                terms = log.u8()
                require(terms <= ORDER + 1, "a polynomial of too high a degree")
                c = [log.f64() for _ in range(terms)]
                require(all(map(math.isfinite, c)), "a coefficient that is no number")
                given.append(c)
            cell = self.proved(t, to, drives, given, last)
            last, t = cell.ends(), to
            cells.append(cell)
        require(cells, "no cells")
        return cells, last, t

    def proved(self, t, to, drives, given, last):
        key = ("cell", t, to, tuple(map(tuple, drives)), tuple(map(tuple, given)), tuple(last))
        if key not in self.known:
            cell = Cell(self.linkage, drives, t, to, given)
            cell.prove(self.linkage, last)
            self.known[key] = cell
        return self.known[key]

    def cells_of(self, piece, lo, hi):
        """Those that a part of the time, integers, is in; it may be longer by a rounding."""
        cells = self.cells[piece] if piece < len(self.cells) else []
        if not cells or lo < cells[0].first - ROUNDING or hi > cells[-1].last + ROUNDING:
            raise Undecided("the joints of a mechanism beyond the cells")
        return cells

    def cell_at(self, piece, t):
        """Of an integer."""
        cells = self.cells_of(piece, t, t)
        return next((cell for cell in cells if t <= cell.last), cells[-1])

    def values(self, piece, t):
        """Jets of the values of the tree's joints: degrees, and scaled lengths."""
        key = (piece, t)
        if key not in self.known:
            if len(self.known) > 20000:
                self.known.clear()
            linkage = self.linkage
            drives = [self.drive_jet(c, t) for c in linkage.paths[piece]]
            unknowns = self.unknown_jets(piece, t, drives) if linkage.unknowns else []
            self.known[key] = [form.value(Jets, unknowns, drives) for form in linkage.forms]
        return self.known[key]

    @staticmethod
    def drive_jet(c, t):
        v, d, dd = ZERO, ZERO, ZERO
        for x in reversed(c):
            dd = add(mul(dd, t), d)
            d = add(mul(d, t), v)
            v = add(mul(v, t), fraction_ball(x))
        return v, d, times(dd, 2)

    def unknown_jets(self, piece, t, drives):
        linkage = self.linkage
        if t[1] == 0:
            values = self.solved(piece, t[0], drives)
        else:
            values = self.enclosed(piece, t[0] - t[1], t[0] + t[1])
        try:
            rows = linkage.jacobian(Jets, [jconst(x) for x in values], [jconst(x[0]) for x in drives])
            system = Preconditioned([[x[0] for x in row] for row in rows], linkage.weights)
        except Undecided:
            return [(x, UNBOUNDED, UNBOUNDED) for x in values]
        jets = [(x, ZERO, ZERO) for x in values]
        first = system.solve([(-x[1][0], x[1][1]) for x in linkage.equations(Jets, jets, drives)])
        jets = [(x, d, ZERO) for x, d in zip(values, first)]
        second = system.solve([(-x[2][0], x[2][1]) for x in linkage.equations(Jets, jets, drives)])
        return [(x, d, dd) for x, d, dd in zip(values, first, second)]

    def enclosed(self, piece, lo, hi):
        out, cells = None, self.cells_of(piece, lo, hi)
        lo, hi = min(lo, cells[-1].last), max(hi, cells[0].first)
        for cell in cells:
            a, b = max(lo, cell.first), min(hi, cell.last)
            if a > b:
                continue
            here = cell.over(a, b)
            out = here if out is None else [between(min(x[0] - x[1], y[0] - y[1]), max(x[0] + x[1], y[0] + y[1]))
                                            for x, y in zip(out, here)]
        return out

    def solved(self, piece, t, drives):
        """At an instant, to all digits."""
        linkage, cell = self.linkage, self.cell_at(piece, t)
        constant = [jconst(x[0]) for x in drives]
        near = cell.value(Fraction(t, ONE))
        x, system = [v[0] for v in near], None
        for _ in range(14):
            at = [jconst((v, 0)) for v in x]
            if system is None:
                rows = linkage.jacobian(Jets, at, constant)
                system = Preconditioned([[r[0] for r in row] for row in rows], linkage.weights)
            step = system.product([f[0] for f in linkage.equations(Jets, at, constant)])
            x = [v - s[0] for v, s in zip(x, step)]
        step = system.product([f[0] for f in linkage.equations(Jets, [jconst((v, 0)) for v in x], constant)])
        size = 4 * system.size(step) + Fraction(1, 1 << (BITS - 40))
        box = [(v, r) for v, r in zip(x, system.spread(size))]
        rows = linkage.jacobian(Jets, [jconst(v) for v in box], constant)
        over = Preconditioned([[r[0] for r in row] for row in rows], linkage.weights, system.y)
        if over.norm > Fraction(1, 2):
            raise Undecided("Newton's steps do not contract")
        for v, about, r in zip(box, near, cell.tube):
            if not magnitude(sub(v, about)) < r:
                raise Undecided("which way a mechanism goes on")
        return box


class JointPiece:
    """A piece of a link's motion, seen from the link that carries it."""

    rotation, orbit = (), []

    def __init__(self, functions, link, piece, until):
        self.functions, self.link, self.piece, self.until = functions, link, piece, until
        linkage = functions.linkage
        self.joint, self.reversed = linkage.moved[link], linkage.tree.links[link].reversed
        self.kind = 0 if self.joint.slide else 5

    def place_pivot(self, at, exponent):
        self.c = [(exact(Fraction(x) * Fraction(2) ** exponent), 0) for x in at] if self.kind else [ZERO, ZERO]

    def scale(self, exponent):
        joint = self.functions.linkage.tree.joints[self.functions.linkage.tree.links[self.link].joint]
        self.place_pivot(joint.at, exponent)

    def key(self):
        """The same for all pieces: a joint goes on without a jump."""
        return "joint", self.link

    @staticmethod
    def rests():
        return False

    def value(self, t):
        value = self.functions.values(self.piece, t)[self.link]
        return tuple((-x[0], x[1]) for x in value) if self.reversed else value

    def pivot_place(self, t):
        if self.kind:
            return [jconst(x) for x in self.c]
        value = self.value(t)
        return [Jets.scaled(value, c) for c in self.joint.direction]

    def other_turn(self, t):
        return Jets.unit(self.value(t))


def hashed(json, tree, linkage, names):
    """What the fingerprint has of it."""
    out = b"\3" + struct.pack("<II", names[json["ground"]], len(tree.joints))
    for joint in tree.joints:
        out += struct.pack("<BII", joint.slide, *joint.bodies) + b"".join(number(c) for c in joint.at)
    out += struct.pack("<I", len(linkage.drives))
    for joint, drive in zip(linkage.driven, linkage.drives):
        out += struct.pack("<I", joint) + drive.bytes()
    couple = json.get("couple", [])
    out += struct.pack("<I", len(couple))
    for c in couple:
        out += struct.pack("<II", tree.named(c["joint"]), tree.named(c["to"])) + number(float(c.get("times", 1)))
    return out


def read_mechanism(json, names, exponent, start, end):
    """The functions, and the bytes that are hashed."""
    tree = Tree(json, names)
    linkage = Linkage(json, tree, exponent, start, end)
    return Functions(linkage), hashed(json, tree, linkage, names)

"""Mechanisms with closed loops: their joints' values as functions of time, from the cells that a log states.

Written from docs/separation-logs.md, "Mechanisms", alone. The equations are in linkage.py, the proof of a cell in
loop_cells.py, the arithmetic in balls.py and models.py."""

import math
import struct
from fractions import Fraction

from balls import BITS, MINUTE, ONE, UNBOUNDED, ZERO, Undecided, add, between, exact, jconst, mul, sub, times
from bodies import number
from box_cells import BoxCell
from loop_cells import Cell, Preconditioned, magnitude
from joint_tree import Tree
from linkage import Balls, Jets, Linkage, drive_jet
from models import ORDER
from tiling import require

ROUNDING = 1 << 64


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
            _, last, _ = self.read_path(log, straight, 0.0, 1.0, last, False)
        cells, t = [], start
        for drives, end in zip(linkage.paths, linkage.ends):
            path, last, t = self.read_path(log, drives, t, end, last, True)
            cells.append(path)
            if t < end or last is None:  # The rest is left out: before a dead point only a box is known.
                break
        if self.cells is None:
            self.cells, self.until = cells, t
        elif self.until != t:
            raise Undecided("up to when a mechanism is followed")

    def read_path(self, log, drives, t, end, last, may_lock):
        linkage, cells, count = self.linkage, [], log.u32()
        for k in range(count):
            kind, to = log.u8(), log.f64()
            require(kind <= 1, "a cell of an unknown kind")
            require(t < to <= end or t == to == end and not cells, "a part of the time that makes no sense")
            if kind == 1:
                require(cells and may_lock and k + 1 == count, "a cell before a dead point that is not the last one")
                cells.append(self.proved_box(t, to, drives, log, last))
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

    def proved_box(self, t, to, drives, log, last):
        parameter = log.u32()
        ranges = tuple((log.f64(), log.f64()) for _ in range(self.linkage.unknowns + 1))
        require(parameter < self.linkage.unknowns, "a parameter that is no unknown")
        require(all(-math.inf < lo < hi < math.inf for lo, hi in ranges), "a range of a box that is none")
        key = ("box", t, to, tuple(map(tuple, drives)), parameter, ranges, tuple(last))
        if key not in self.known:
            cell = BoxCell(self.linkage, drives, t, to, parameter, ranges)
            cell.prove(last)
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
            drives = [drive_jet(c, t) for c in linkage.paths[piece]]
            unknowns = self.unknown_jets(piece, t, drives) if linkage.unknowns else []
            self.known[key] = [form.value(Jets, unknowns, drives) for form in linkage.forms]
        return self.known[key]

    def unknown_jets(self, piece, t, drives):
        linkage = self.linkage
        if t[1] == 0:
            values = self.solved(piece, t[0], drives)
        else:
            values = self.enclosed(piece, t[0] - t[1], t[0] + t[1])
        try:
            system = Preconditioned(linkage.jacobian(Balls, values, [x[0] for x in drives]), linkage.weights)
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
        if isinstance(cell, BoxCell):
            return cell.over(t, t)
        constant = [x[0] for x in drives]
        near = cell.value(Fraction(t, ONE))
        x = [v[0] for v in near]
        system = Preconditioned(linkage.jacobian(Balls, [(v, 0) for v in x], constant), linkage.weights)
        for _ in range(14):
            step = system.product(linkage.equations(Balls, [(v, 0) for v in x], constant))
            x = [v - s[0] for v, s in zip(x, step)]
            # The next step would be some 40 bits shorter.
            if all(abs(s[0]) < MINUTE << 30 for s in step):
                break
        step = system.product(linkage.equations(Balls, [(v, 0) for v in x], constant))
        size = 4 * system.size(step) + Fraction(1, 1 << (BITS - 40))
        box = [(v, r) for v, r in zip(x, system.spread(size))]
        over = Preconditioned(linkage.jacobian(Balls, box, constant), linkage.weights, system.y)
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

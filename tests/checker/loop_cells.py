"""Cells of a mechanism: that one solution of its equations is near given polynomials, over a part of the time."""

import math
from fractions import Fraction

from balls import BITS, ONE, Undecided, add, exact, sub
from linkage import Models, fraction_ball
from models import Model

LEAST_TUBE = Fraction(1, 2**40)
MOST_WIDENINGS = 8


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
    """A matrix A of balls, an approximate inverse Y in doubles, and bounds of |1 - Y A| times the weights: `shares`."""

    def __init__(self, rows, weights, y=None):
        self.rows, self.weights = rows, weights
        self.y = y or approximate_inverse(rows)
        n = len(rows)
        sizes = [Fraction(w) for w in weights]
        self.shares = []
        for i in range(n):
            total = Fraction(0)
            for j in range(n):
                middle = sum(self.y[i][k] * rows[k][j][0] for k in range(n)) >> BITS
                radius = (sum(abs(self.y[i][k]) * rows[k][j][1] for k in range(n)) >> BITS) + 2
                total += (abs((ONE if i == j else 0) - middle) + radius) * sizes[j]
            self.shares.append(total / ONE)
        self.norm = max((share / size for share, size in zip(self.shares, sizes)), default=Fraction(0))
        if self.norm >= Fraction(9, 10):
            raise Undecided("a mechanism near a dead point")

    def product(self, v):
        """Y times a vector."""
        return [(sum(y * x[0] for y, x in zip(row, v)) >> BITS, (sum(abs(y) * x[1] for y, x in zip(row, v)) >> BITS) + 2)
                for row in self.y]

    def size(self, v):
        """In the norm with the weights."""
        return max((Fraction(magnitude(x), ONE) / Fraction(w) for x, w in zip(v, self.weights)), default=Fraction(0))

    def spread(self, size):
        """A number of that size for each unknown, as integers."""
        return [math.ceil(size * Fraction(w) * ONE) + 1 for w in self.weights]

    def solve(self, b):
        x, steps = [0] * len(b), 12
        for k in range(steps + 1):
            rest = [(right[0] - (sum(a[0] * c for a, c in zip(row, x)) >> BITS),
                     right[1] + (sum(a[1] * abs(c) for a, c in zip(row, x)) >> BITS) + 2)
                    for row, right in zip(self.rows, b)]
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
        self.models = [Model.of([Fraction(x) * u * share**k for k, x in enumerate(c)]) for c, u in zip(given, unit)]
        # In powers of the time since the middle, as Fractions: for values.
        self.given = [[Fraction(x) * u for x in c] for c, u in zip(given, unit)]
        self.radius = Fraction(radius)

    def value(self, t):
        """The polynomials at a Fraction within the cell, give or take a rounding."""
        s = (t - self.middle) / self.radius
        s = Fraction((s.numerator << BITS) // s.denominator, ONE)
        out = []
        for c in self.given:
            total = 0
            for x in reversed(c):
                total = (total * s.numerator // s.denominator) + fraction_ball(x)[0]
            # Each step rounds twice, and s is off by a unit, where it is at most 1.
            out.append((total, (len(c) + 1) * (math.ceil(sum(map(abs, c))) + 3)))
        return out

    def drive_models(self):
        out = []
        time = Model.of([self.middle, self.half])
        for c in self.drives:
            total = Models.zero
            for x in reversed(c):
                total = Model.plus(Model.by(total, time), Model.constant(fraction_ball(x)))
            out.append(total)
        return out

    def prove(self, linkage, last, turning=False):
        """One solution is within the tube of the polynomials, at each time of the cell; and it is the one in `last`.
        First by the equations as seen from the ground, or by those seen from a link (`turning`)."""
        for self.turning in (turning, not turning):
            try:
                self.contract(linkage, last)
                break
            except Undecided:
                if self.turning != turning:
                    raise
        for value, before, r in zip(self.value(Fraction(self.lo)), last, self.tube):
            if not magnitude(sub(value, before)) < r:
                raise Undecided("which way a mechanism goes on")

    def contract(self, linkage, last):
        """Krawczyk's test."""
        drives = self.drive_models()
        y = approximate_inverse([[m.middle() for m in row] for row in
                                 linkage.jacobian(Models, self.models, drives, self.turning)])
        wrong = [m.norm() for m in self.times(y, linkage.equations(Models, self.models, drives, self.turning))]
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

    def contraction(self, linkage, y, drives):
        """A bound of |1 - Y F'| for all values within the tube."""
        n = linkage.unknowns
        slopes = linkage.jacobian(Models, [m.widened(r) for m, r in zip(self.models, self.tube)], drives, self.turning)
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

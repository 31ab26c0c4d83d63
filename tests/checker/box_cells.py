"""The last cell before a dead point: that a mechanism's motion is in a box until the cell's end, or as long as it goes
on before. As functions of one of the unknowns, the parameter, the others and the time are regular there."""

from fractions import Fraction

from balls import BITS, MINUTE, ONE, Undecided, add, between, exact, jconst, mul, sub
from linkage import Balls, Jets, drive_jet
from loop_cells import Preconditioned, magnitude


class BoxCell:
    """`ranges`: of the unknowns, and last of the time, in doubles."""

    def __init__(self, linkage, drives, lo, hi, parameter, ranges):
        self.linkage, self.drives, self.p = linkage, drives, parameter
        self.first, self.last = exact(lo), exact(hi)
        units = [linkage.unit_of(joint) for joint in linkage.unknown_of]
        *unknowns, self.time = [[exact(Fraction(x) * unit) for x in ends] for ends, unit in zip(ranges, [*units, 1])]
        self.ranges = [between(*ends) for ends in unknowns]
        self.ends = unknowns[parameter]
        # What the curve leads through: the time in place of the parameter.
        self.box = list(self.ranges)
        self.box[parameter] = between(*self.time)

    def over(self, _lo, _hi):
        return self.ranges

    def split(self, y, s):
        """The unknowns, and the jets of the drives."""
        unknowns = list(y)
        unknowns[self.p] = s
        return unknowns, [drive_jet(c, y[self.p]) for c in self.drives]

    def equations(self, y, s):
        unknowns, drives = self.split(y, s)
        return self.linkage.equations(Balls, unknowns, [x[0] for x in drives], self.turning)

    def slopes(self, y, s):
        """The derivatives by y, in rows, and by the parameter."""
        unknowns, drives = self.split(y, s)
        rows = self.linkage.jacobian(Balls, unknowns, [x[0] for x in drives], self.turning)
        by_time = [f[1] for f in self.linkage.equations(Jets, [jconst(x) for x in unknowns], drives, self.turning)]
        by_parameter = [row[self.p] for row in rows]
        return [[t if j == self.p else x for j, x in enumerate(row)] for row, t in zip(rows, by_time)], by_parameter

    def prove(self, last):
        """With gaps seen from the ground, or from a link, as in other cells."""
        for self.turning in (False, True):
            try:
                return self.contract(last)
            except Undecided:
                if self.turning:
                    raise

    def contract(self, last):
        middle, radii = [(m, 0) for m, _ in self.box], [r - 2 for _, r in self.box]
        if min(radii) <= 0:
            raise Undecided("a box before a dead point that is too small")
        s, weights = between(*self.ends), [Fraction(r, ONE) for r in radii]
        y = Preconditioned(self.slopes(middle, (s[0], 0))[0], weights).y
        over = Preconditioned(self.slopes(self.box, s)[0], weights, y)
        # Krawczyk's test for all values of the parameter at once: by the mean value theorem, from the middle one.
        here = over.product(self.equations(middle, (s[0], 0)))
        along = over.product(self.slopes(middle, s)[1])
        wrong = [magnitude(x) + (magnitude(d) * s[1] >> BITS) + 1 for x, d in zip(here, along)]
        if not all(w + share * ONE < r for w, share, r in zip(wrong, over.shares, radii)):
            raise Undecided("the joints of a mechanism before a dead point")
        begin = list(last)
        begin[self.p] = self.first, 0
        before = last[self.p]
        if not (self.ends[0] <= before[0] - before[1] and before[0] + before[1] <= self.ends[1] and
                self.within(begin, radii)):
            raise Undecided("which way a mechanism goes on")
        for end in self.ends:
            at = self.solved(end, middle, weights)
            time = at[self.p]
            if not self.within(at, radii) or not (time[0] + time[1] < self.first or time[0] - time[1] > self.last):
                raise Undecided("whether a mechanism stays in a box before a dead point")

    def within(self, y, radii):
        return all(magnitude(sub(x, (m, 0))) < r for x, (m, _), r in zip(y, self.box, radii))

    def solved(self, s, y, weights):
        """For an exact value of the parameter."""
        system = Preconditioned(self.slopes(y, (s, 0))[0], weights)
        for _ in range(30):
            step = system.product(self.equations(y, (s, 0)))
            y = [(x[0] - d[0], 0) for x, d in zip(y, step)]
            if all(abs(d[0]) < MINUTE << 30 for d in step):
                break
        size = 4 * system.size(system.product(self.equations(y, (s, 0)))) + Fraction(1, 1 << 40)
        box = [add(x, (0, r)) for x, r in zip(y, system.spread(size))]
        if Preconditioned(self.slopes(box, (s, 0))[0], weights, system.y).norm > Fraction(1, 2):
            raise Undecided("Newton's steps do not contract")
        return box

"""Where rotations given by their cosines are cut into pieces. See docs/proof-format.md, "Cosines that reach 1"."""

import math
from fractions import Fraction


class Exact:
    """A polynomial with coefficients c / 2^scale, in integers: a fraction's common divisors take longer than all else."""

    def __init__(self, c, scale, origin):
        self.c, self.scale, self.origin = c, scale, Fraction(origin)

    @classmethod
    def of(cls, doubles, origin):
        ratios = [float(x).as_integer_ratio() for x in doubles]
        scale = max(d.bit_length() for _, d in ratios) - 1
        return cls([n << (scale - d.bit_length() + 1) for n, d in ratios], scale, origin)

    def at(self, t):
        """The value at a double, as an integer over two to the power of the second number."""
        since = Fraction(t) - self.origin
        m, d = since.numerator, since.denominator
        e, v, power = d.bit_length() - 1, 0, 0
        for x in reversed(self.c):
            v = v * m + (x << power)
            power += e
        return v, self.scale + power - e

    def is_negative(self, t):
        return self.at(t)[0] < 0

    def derivative(self):
        return Exact([k * x for k, x in enumerate(self.c)][1:], self.scale, self.origin)

    def minus(self, n):
        return Exact([self.c[0] - (n << self.scale), *self.c[1:]], self.scale, self.origin)


def value(c, t):
    v = 0.0
    for x in reversed(c):
        v = v * t + x
    return v


def excess(a, t):
    """|a| - 1."""
    v, scale = a.at(t)
    return Fraction(abs(v) - (1 << scale), 1 << scale)


def before(t):
    return math.nextafter(t, -math.inf)


def after(t):
    return math.nextafter(t, math.inf)


def touches(a, t):
    x = excess(a, t)
    bend = excess(a, before(t)) + excess(a, after(t)) - 2 * x
    return x > -Fraction(1, 2**90) or (bend < 0 and x >= 4 * bend)


def roots(c, places, start, end):
    found, ends = [], [start, *places, end]
    for lo, hi in zip(ends, ends[1:]):
        rises = c.is_negative(lo)
        if rises == c.is_negative(hi):
            continue
        while True:
            middle = lo + (hi - lo) / 2
            if not lo < middle < hi:
                break
            if c.is_negative(middle) == rises:
                lo = middle
            else:
                hi = middle
        found.append(hi)
    return found


def candidates(a, start, end):
    derivatives = [a]
    while len(derivatives[-1].c) > 2:
        derivatives.append(derivatives[-1].derivative())
    found, places = [], []
    for c in derivatives[:0:-1]:
        places = roots(c, places, start, end)
        found += places
    for extreme in (1, -1):
        found += roots(a.minus(extreme), places, start, end)
    return found


def cuts(a, start, end):
    noted, tried = [start, end], candidates(a, start, end)

    def note(t):
        if start < t < end and t not in noted:
            noted.append(t)

    for g in tried:
        three = [before(g), g, after(g)]
        over = [excess(a, t) for t in three]
        for t, x in zip(three, over):
            if x == 0:
                note(t)
        for k in (0, 1):
            if over[k] * over[k + 1] < 0:
                note(three[k] if over[k] < 0 else three[k + 1])
    for g in tried:
        if all(abs(t - g) >= 2.0**-10 * (end - start) for t in noted) and touches(a, g):
            note(before(g))
            note(after(g))
    return sorted(noted)[1:-1]


def pieces(doubles, origin, start, end):
    """Of a polynomial in powers of t - origin: until when, None for the last, and "cosine", or which way the body rests."""
    a, out, begin = Exact.of(doubles, origin), [], start
    for until in [*cuts(a, start, end), None]:
        last = end if until is None else until
        middle = begin + (last - begin) / 2
        rests = excess(a, middle) > 0 or all(touches(a, t) for t in (begin, middle, last))
        turned = "not turned" if value(doubles, middle - origin) > 0 else "half a turn"
        out.append([until, turned if rests else "cosine"])
        begin = until
    return out

"""Functions of s in [-1, 1]: a polynomial with integers times 2^-SHORT, and a bound of the rest.

Compare Taylor models (Makino and Berz). They need far fewer digits than instants do; numbers come and go with BITS."""

from fractions import Fraction
from math import factorial

from balls import BITS, ONE, Undecided, sin_cos

ORDER = 17
SHORT = 192
LEFT_OUT = BITS - SHORT


class Model:
    def __init__(self, c, error=0):
        """`error`: an integer times 2^-SHORT; coefficients may be off by a unit each, which it must include."""
        self.c, self.error = list(c) or [0], error

    @staticmethod
    def constant(ball):
        return Model([ball[0] >> LEFT_OUT], (ball[1] >> LEFT_OUT) + (2 if ball[1] else 1))

    @staticmethod
    def of(fractions):
        """A polynomial with these coefficients."""
        return Model([(x.numerator << SHORT) // x.denominator for x in map(Fraction, fractions)], len(fractions))

    def middle(self):
        """The value at 0, about."""
        return self.c[0] << LEFT_OUT, 0

    def norm(self):
        """A bound of the magnitude, times 2^BITS."""
        return self._norm() << LEFT_OUT

    def _norm(self):
        return sum(map(abs, self.c)) + self.error

    def widened(self, more):
        """By an integer times 2^-BITS."""
        return Model(self.c, self.error + (more >> LEFT_OUT) + 1)

    def plus(self, other):
        return self._sum(other, 1)

    def minus(self, other):
        return self._sum(other, -1)

    def _sum(self, other, sign):
        n = max(len(self.c), len(other.c))
        a, b = (f.c + [0] * (n - len(f.c)) for f in (self, other))
        return Model([x + sign * y for x, y in zip(a, b)], self.error + other.error)

    def by(self, other):
        a, b = self.c, other.c
        whole = [0] * (len(a) + len(b) - 1)
        for i, x in enumerate(a):
            if x:
                for j, y in enumerate(b):
                    whole[i + j] += x * y
        c = [x >> SHORT for x in whole]
        rest = sum(abs(x) for x in c[ORDER + 1:]) + len(c) + 1
        na, nb = sum(map(abs, a)), sum(map(abs, b))
        rest += (na * other.error + nb * self.error + self.error * other.error >> SHORT) + 1
        return Model(c[:ORDER + 1], rest)

    def scaled(self, ball):
        m, r = ball
        return Model([x * m >> BITS for x in self.c],
                     (sum(map(abs, self.c)) * r + self.error * (abs(m) + r) >> BITS) + len(self.c) + 2)

    def turn(self):
        """The cosine and the sine."""
        s, c = sin_cos((self.c[0] << LEFT_OUT, 0))
        varying = Model([0] + self.c[1:], self.error)
        most = varying._norm()
        if most > 4 << SHORT:
            raise Undecided("an angle over a part of the time")
        square = varying.by(varying)
        sums = []
        for first in (0, 1):  # the cosine's series, the sine's divided by the angle
            total = Model([0])
            for k in reversed(range(16)):
                power = ((1 << SHORT) // factorial(2 * k + first)) * (-1) ** k
                total = total.by(square).plus(Model([power], 1))
            # Terms fall from there on: the first one left out bounds the rest.
            rest = (most**32 // factorial(32) >> 31 * SHORT) + 1
            sums.append(Model(total.c, total.error + rest))
        cosine, sine = sums[0], sums[1].by(varying)
        return (cosine.scaled(c).minus(sine.scaled(s)), cosine.scaled(s).plus(sine.scaled(c)))

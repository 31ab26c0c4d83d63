"""Polynomials with integer coefficients on [0, 1]: their signs, their roots, and the order of these. All exact."""

from fractions import Fraction


class Undecided(Exception):
    """Two numbers are equal, or so near to each other that no proof should rest on their order."""


STEPS_OF_PRECISION = (96, 384, 1536, 6144)


def sign(x):
    return (x > 0) - (x < 0)


def value_at(p, x, bits):
    """p(x / 2^bits), times 2^(bits * degree)."""
    total = 0
    for k, c in enumerate(reversed(p)):
        total = total * x + (c << (bits * k))
    return total


def shifted(p):
    """p(x + 1)."""
    p = list(p)
    for i in range(len(p) - 1):
        for k in range(len(p) - 2, i - 1, -1):
            p[k] += p[k + 1]
    return p


def variations(p):
    """Descartes' rule for the roots in (0, 1): right if it says 0 or 1, else not less than their number."""
    count, last = 0, 0
    for c in shifted(p[::-1]):
        s = sign(c)
        count += s * last < 0
        last = s or last
    return count


def isolated(p, lo=0, bits=0):
    """Intervals (lo, bits), from lo / 2^bits to (lo + 1) / 2^bits, in order, that hold one root of p in (0, 1) each.
    p is given as a function on the interval asked about."""
    count = variations(p)
    if count == 0:
        return []
    if count == 1:
        return [(lo, bits)]
    if bits > STEPS_OF_PRECISION[-1]:
        raise Undecided("a multiple root")
    n = len(p) - 1
    left = [c << (n - k) for k, c in enumerate(p)]
    right = shifted(left)
    if right[0] == 0:
        raise Undecided("a root in the middle")
    return isolated(left, 2 * lo, bits + 1) + isolated(right, 2 * lo + 1, bits + 1)


class Root:
    """A root of p, known to lie between lo / 2^bits and (lo + 1) / 2^bits, and alone there."""

    def __init__(self, p, lo, bits):
        self.p, self.lo, self.bits = p, lo, bits
        self.before = self._sign_after(lo, bits)
        self.refine(60)
        self.least = self.lo / (1 << self.bits) - 2.0**-50
        self.most = self.lo / (1 << self.bits) + 2.0**-50

    def _sign_after(self, x, bits):
        """The sign just after the left end of the interval, where p may have another root."""
        s = sign(value_at(self.p, x, bits))
        return s or -sign(value_at(self.p, x + 1, bits)) or self._sign_after(2 * x, bits + 1)

    def _side(self, x, bits):
        return sign(value_at(self.p, x, bits)) * self.before

    def refine(self, bits):
        while self.bits < bits:
            if self.bits < 24 or not self._newton():
                self._halve()

    def _halve(self):
        self.bits += 1
        self.lo *= 2
        side = self._side(self.lo + 1, self.bits)
        if side == 0:
            raise Undecided("a root with few digits")
        self.lo += side > 0

    def _newton(self):
        """Nearly doubles the digits, if the slope is steady; the signs tell whether it did."""
        bits = 2 * self.bits - 8
        x = (2 * self.lo + 1) << (bits - self.bits - 1)
        slope = [k * c for k, c in enumerate(self.p)][1:]
        steep = value_at(slope, x, bits)
        if steep == 0:
            return False
        x -= value_at(self.p, x, bits) // steep
        lo, hi = x - 8, x + 8
        first = self.lo << (bits - self.bits)
        if lo < first or hi > first + (1 << (bits - self.bits)):
            return False
        if self._side(lo, bits) <= 0 or self._side(hi, bits) >= 0:
            return False
        self.lo, self.bits = lo >> 4, bits - 4
        # 16 units of 2^-bits need not begin at a multiple of 16.
        if self._side(self.lo + 1, self.bits) > 0:
            self.lo += 1
        return True

    def compare(self, other):
        """-1 if this root comes first, 1 if the other one does. Two different roots, or a root and a Fraction."""
        if isinstance(other, Root):
            if self.most < other.least:
                return -1
            if other.most < self.least:
                return 1
        for bits in STEPS_OF_PRECISION:
            self.refine(bits)
            lo, hi = Fraction(self.lo, 1 << self.bits), Fraction(self.lo + 1, 1 << self.bits)
            if isinstance(other, Root):
                other.refine(bits)
                a, b = Fraction(other.lo, 1 << other.bits), Fraction(other.lo + 1, 1 << other.bits)
            else:
                a = b = other
            if hi <= a and lo < a:
                return -1
            if b <= lo and b < hi:
                return 1
        raise Undecided("two instants that cannot be told apart")


class Function:
    """A polynomial on [0, 1], by its signs: at 0, at 1, and the roots between, at each of which it changes."""

    def __init__(self, p):
        p = list(p)
        while len(p) > 1 and p[-1] == 0:
            p.pop()
        self.at_start, self.at_end = sign(p[0]), sign(sum(p))
        self.roots = [Root(p, lo, bits) for lo, bits in isolated(p)]
        self.first = self.at_start or next((sign(c) for c in p if c), 0)

    def roots_before(self, instant):
        """How many roots come before a root of another function, or before a Fraction."""
        if instant == 0:
            return 0
        count = 0
        while count < len(self.roots) and self.roots[count].compare(instant) < 0:
            count += 1
        return count

    def sign_after(self, count):
        """Its sign after that many roots."""
        return -self.first if count % 2 else self.first

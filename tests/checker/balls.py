"""Numbers with error bounds, as pairs of integers (middle, radius) times 2^-BITS, and functions of time with them.

A jet is (value, first, second derivative), three balls. What is exact here is exact: radii only grow where something is
rounded away."""

from fractions import Fraction
from math import isqrt

BITS = 448
ONE = 1 << BITS
MINUTE = 1 << 20  # of a radius: more than any rounding of a few operations


class Undecided(Exception):
    """Bounds that do not tell."""


def exact(x):
    """A double, or a Fraction with few enough digits."""
    x = Fraction(x)
    scaled = x.numerator << BITS
    if x.denominator & (x.denominator - 1) or scaled % x.denominator:
        raise Undecided("a number with too many digits")
    return scaled // x.denominator


def ball(x):
    return exact(x), 0


def between(lo, hi):
    """The numbers from lo to hi, two integers."""
    middle = (lo + hi) >> 1
    return middle, hi - middle


def add(x, y):
    return x[0] + y[0], x[1] + y[1]


def sub(x, y):
    return x[0] - y[0], x[1] + y[1]


def neg(x):
    return -x[0], x[1]


def mul(x, y):
    (a, r), (b, s) = x, y
    if not a and not r or not b and not s:
        return 0, 0
    if not r and not s:
        return (a * b) >> BITS, 1
    if r > UNKNOWN or s > UNKNOWN:
        return UNBOUNDED
    return (a * b) >> BITS, ((abs(a) * s + abs(b) * r + r * s) >> BITS) + 2


def times(x, k):
    """A small integer times a ball."""
    return x[0] * k, x[1] * abs(k)


def sign(x):
    """1 or -1 if it certainly is, else 0."""
    a, r = x
    return 1 if a > r else -1 if -a > r else 0


def inverse(x):
    a, r = x
    low = abs(a) - r
    if low <= 0:
        raise Undecided("a division by nearly nothing")
    return (ONE * ONE) // a, (r * ONE // low * ONE) // abs(a) + 2


def root(x):
    a, r = x
    if a - r <= 0:
        raise Undecided("a square root of nearly nothing")
    return between(isqrt((a - r) << BITS), isqrt((a + r) << BITS) + 1)


def _arctan_of_inverse(n, one):
    total, power, k = 0, one // n, 1
    while power:
        total += power // k if k % 4 == 1 else -(power // k)
        power //= n * n
        k += 2
    return total


EXTRA = 64
PI = 4 * (4 * _arctan_of_inverse(5, 1 << (BITS + EXTRA)) - _arctan_of_inverse(239, 1 << (BITS + EXTRA)))
_known = {}


def _sin_cos_of(a):
    """Of an integer times 2^-BITS, with errors below MINUTE."""
    bits = BITS + EXTRA
    x = a << EXTRA
    quarters = (2 * x + PI // 2) // PI  # the nearest multiple of pi / 2
    if abs(quarters) > 1 << 40:
        raise Undecided("too many turns")
    x -= quarters * PI >> 1
    x >>= 6  # six doublings later
    square = x * x >> bits
    s = term = x
    k = 1
    while term:
        term = -(term * square >> bits) // ((k + 1) * (k + 2))
        s += term
        k += 2
    c = isqrt((1 << 2 * bits) - s * s)
    for _ in range(6):
        s, c = 2 * s * c >> bits, (1 << bits) - (2 * s * s >> bits)
    for _ in range(quarters % 4):
        s, c = c, -s
    return s >> EXTRA, c >> EXTRA


def sin_cos(x):
    a, r = x
    if a not in _known:
        if len(_known) > 20000:
            _known.clear()
        _known[a] = _sin_cos_of(a)
    s, c = _known[a]
    if r >= ONE:
        return (0, ONE), (0, ONE)
    # To second order: |sin(a + h) - sin a| <= |cos a| h + h^2 / 2.
    bend = (r * r >> (BITS + 1)) + MINUTE
    return (s, (abs(c) * r >> BITS) + bend), (c, (abs(s) * r >> BITS) + bend)


ZERO = (0, 0)
# Of a derivative that has no bound: no sum or product of a few bounds, and no value, gets anywhere near, so that whatever
# has it for a summand tells nothing.
UNBOUNDED = (0, 1 << 64 * BITS)
UNKNOWN = 1 << 48 * BITS  # a radius from which on a product is not computed: it would only be longer
J0 = (ZERO, ZERO, ZERO)
J1 = ((ONE, 0), ZERO, ZERO)


def jconst(x):
    return x, ZERO, ZERO


def jadd(f, g):
    return add(f[0], g[0]), add(f[1], g[1]), add(f[2], g[2])


def jsub(f, g):
    return sub(f[0], g[0]), sub(f[1], g[1]), sub(f[2], g[2])


def jneg(f):
    return neg(f[0]), neg(f[1]), neg(f[2])


def jmul(f, g):
    if f is J1:
        return g
    if g is J1:
        return f
    if f is J0 or g is J0:
        return J0
    return (mul(f[0], g[0]), add(mul(f[0], g[1]), mul(f[1], g[0])),
            add(add(mul(f[0], g[2]), mul(f[2], g[0])), times(mul(f[1], g[1]), 2)))


def jinverse(f):
    i = inverse(f[0])
    square = mul(i, i)
    first = neg(mul(f[1], square))
    second = sub(times(mul(mul(f[1], f[1]), mul(square, i)), 2), mul(f[2], square))
    return i, first, second


def jroot(f):
    """(r^2)' = 2 r r', (r^2)'' = 2 r'^2 + 2 r r''. Of what may be 0 the value alone is known, where f >= 0."""
    most = f[0][0] + f[0][1]
    if most < 0:
        raise Undecided("a cosine beyond 1")
    if f[0][0] <= f[0][1]:
        return between(0, isqrt(most << BITS) + 1), UNBOUNDED, UNBOUNDED
    r = root(f[0])
    half = inverse(times(r, 2))
    first = mul(f[1], half)
    return r, first, mul(sub(f[2], times(mul(first, first), 2)), half)


def jpolynomial(c, t):
    """c: integers times 2^-BITS, ascending."""
    if not c:
        return J0
    v, d, dd = (c[-1], 0), ZERO, ZERO
    for a in reversed(c[:-1]):
        dd = add(mul(dd, t), d)
        d = add(mul(d, t), v)
        v = add(mul(v, t), (a, 0))
    return v, d, times(dd, 2)


def jpolynomial_about_middle(c, t):
    """The same; over a stretch, the value is also what it is in the middle, give or take its greatest slope times the
    way: near an extreme that is far narrower."""
    f = jpolynomial(c, t)
    if not c or not t[1]:
        return f
    a, r = jpolynomial(c, (t[0], 0))[0]
    r += ((abs(f[1][0]) + f[1][1]) * t[1] >> BITS) + 1
    return ((a, r), f[1], f[2]) if r < f[0][1] else f


def jturn(angle):
    """The unit vector of an angle, as two jets."""
    s, c = sin_cos(angle[0])
    square = mul(angle[1], angle[1])
    return ((c, neg(mul(s, angle[1])), neg(add(mul(c, square), mul(s, angle[2])))),
            (s, mul(c, angle[1]), sub(mul(c, angle[2]), mul(s, square))))


def cmul(f, g):
    """Of complex numbers, two jets each."""
    return jsub(jmul(f[0], g[0]), jmul(f[1], g[1])), jadd(jmul(f[0], g[1]), jmul(f[1], g[0]))


def cadd(f, g):
    return jadd(f[0], g[0]), jadd(f[1], g[1])


def csub(f, g):
    return jsub(f[0], g[0]), jsub(f[1], g[1])


def conj(f):
    return f if f[1] is J0 else (f[0], jneg(f[1]))


class Sampled:
    """A function of time over [a, b], integers times 2^-BITS, by its jets at the middle and over all of it."""

    def __init__(self, at, over, a, b):
        self.value, self.slope, self.all = at[0], at[1], over[0]
        middle = (a + b) >> 1
        self.half = max(b - middle, middle - a)
        self.bend = abs(over[2][0]) + over[2][1]
        self.convex = sign(over[2])
        self.reach = (self.bend * self.half >> BITS) + 1

    def stray(self):
        """How far from its value in the middle it can be: by the slope there and the bend, or, where these have no
        bounds, by its values over all of the stretch."""
        h = self.half
        by_slope = (((abs(self.slope[0]) + self.slope[1]) * h + (self.reach * h >> 1)) >> BITS) + 2
        return min(by_slope, abs(self.all[0] - self.value[0]) + self.all[1])

    def shift(self, more):
        """Adds a bound."""
        self.value, self.all = add(self.value, (more, 2)), add(self.all, (more, 2))

    def sign(self):
        return sign((self.value[0], self.value[1] + self.stray()))

    def direction(self):
        """Of its slope: does it certainly rise, or fall?"""
        return sign((self.slope[0], self.slope[1] + self.reach))


def keeps_sign(sample, wanted, a, b, depth=260):
    """Has the function that sign at all times of [a, b]? sample(a, b) is one of it. False: certainly not. Raises
    Undecided where neither is found."""
    here = sample(a, b)
    told = here.sign()
    if told:
        return told == wanted
    middle = sign(here.value)
    if middle == -wanted:
        return False
    if a == b:
        raise Undecided("a sign")
    rising = here.direction()
    if rising:
        worst = a if rising == wanted else b
        return _sign_at(sample, worst) == wanted
    if here.convex == -wanted:  # least at the ends
        return _sign_at(sample, a) == wanted and _sign_at(sample, b) == wanted
    m = (a + b) >> 1
    if depth == 0 or not a < m < b:
        raise Undecided("a sign over a stretch of time")
    return keeps_sign(sample, wanted, a, m, depth - 1) and keeps_sign(sample, wanted, m, b, depth - 1)


def _sign_at(sample, t):
    told = sample(t, t).sign()
    if not told:
        raise Undecided("a sign at an end")
    return told


def first_change(sample, before, a, b, depth=400):
    """The first time in [a, b] at which the function, of that sign at a, changes it: (lo, hi), in which it changes once
    and goes one way only. None if there is none."""
    here = sample(a, b)
    if here.sign() == before:
        return None
    if here.direction() == -before:
        if _sign_at(sample, b) == before:
            return None
        return _bracket(sample, before, a, b)
    if here.direction() == before:
        return None
    m = (a + b) >> 1
    if depth == 0 or not a < m < b:
        raise Undecided("when a vertex comes to an edge")
    found = first_change(sample, before, a, m, depth - 1)
    if found:
        return found
    if _sign_at(sample, m) != before:
        raise Undecided("a change of sign that is not seen")
    return first_change(sample, before, m, b, depth - 1)


def _bracket(sample, before, a, b):
    """Of a function that goes one way only: nearer and nearer bounds of its zero, the next ones where a straight line
    through the ends meets 0 (J. Abbott, Quadratic interval refinement for real roots, 2014). They are guesses: a sign
    decides what is kept."""
    finer = 2  # the logarithm of into how many parts the bounds are divided
    while b - a > 1 << 40:
        ends = [abs(sample(x, x).value[0]) for x in (a, b)]
        part = max(b - a >> finer, 1 << 39)
        guess = a + (b - a) * ends[0] // max(sum(ends), 1)
        before_that = a, b
        for m in (guess - part // 2, guess + part // 2, a + b >> 1):
            told = sample(m, m).sign() if a < m < b else 0
            if told:
                a, b = (m, b) if told == before else (a, m)
            if b - a <= part:
                break
        finer = 2 * finer if b - a <= part else max(finer // 2, 1)
        if (a, b) == before_that:
            break
    return a, b

"""Where rotations given by their cosines are cut into pieces. See docs/proof-format.md, "Cosines that reach 1"."""

import math
from fractions import Fraction


def exact(c, t):
    v = Fraction(0)
    for x in reversed(c):
        v = v * Fraction(t) + Fraction(x)
    return v


def value(c, t):
    v = 0.0
    for x in reversed(c):
        v = v * t + x
    return v


def excess(a, t):
    """|a| - 1."""
    return abs(exact(a, t)) - 1


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
        rises = exact(c, lo) < 0
        if rises == (exact(c, hi) < 0):
            continue
        while True:
            middle = lo + (hi - lo) / 2
            if not lo < middle < hi:
                break
            if (exact(c, middle) < 0) == rises:
                lo = middle
            else:
                hi = middle
        found.append(hi)
    return found


def candidates(a, start, end):
    derivatives = [[Fraction(x) for x in a]]
    while len(derivatives[-1]) > 2:
        derivatives.append([k * x for k, x in enumerate(derivatives[-1])][1:])
    found, places = [], []
    for c in derivatives[:0:-1]:
        places = roots(c, places, start, end)
        found += places
    for extreme in (1, -1):
        found += roots([Fraction(a[0]) - extreme, *a[1:]], places, start, end)
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


def pieces(a, start, end):
    """Of the polynomial a: until when, None for the last, and "cosine", or which way the body rests."""
    out, begin = [], start
    for until in [*cuts(a, start, end), None]:
        last = end if until is None else until
        middle = begin + (last - begin) / 2
        rests = excess(a, middle) > 0 or all(touches(a, t) for t in (begin, middle, last))
        out.append([until, ("not turned" if value(a, middle) > 0 else "half a turn") if rests else "cosine"])
        begin = until
    return out

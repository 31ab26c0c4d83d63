"""Where rotations given by their cosines are cut into pieces. See docs/proof-format.md, "Cosines that reach 1"."""

import math
from fractions import Fraction


def value(c, t):
    v = 0.0
    for x in reversed(c):
        v = v * t + x
    return v


def excess(a, t):
    """|a| - 1, exactly."""
    v = Fraction(0)
    for x in reversed(a):
        v = v * Fraction(t) + Fraction(x)
    return abs(v) - 1


def roots(c, places, start, end):
    found, ends = [], [start, *places, end]
    for lo, hi in zip(ends, ends[1:]):
        rises = value(c, lo) < 0
        if rises == (value(c, hi) < 0):
            continue
        while True:
            middle = lo + (hi - lo) / 2
            if not lo < middle < hi:
                break
            if (value(c, middle) < 0) == rises:
                lo = middle
            else:
                hi = middle
        found.append(hi)
    return found


def guesses(a, start, end):
    derivatives = [a]
    while len(derivatives[-1]) > 2:
        derivatives.append([k * x for k, x in enumerate(derivatives[-1])][1:])
    found, places = [], []
    for c in derivatives[:0:-1]:
        places = roots(c, places, start, end)
        found += places
    for extreme in (1.0, -1.0):
        found += roots([a[0] - extreme, *a[1:]], places, start, end)
    return found


def cuts(a, start, end):
    noted, tried = [start, end], guesses(a, start, end)

    def note(t):
        if start < t < end and t not in noted:
            noted.append(t)

    for g in tried:
        three = [math.nextafter(g, -math.inf), g, math.nextafter(g, math.inf)]
        over = [excess(a, t) for t in three]
        for t, x in zip(three, over):
            if x == 0:
                note(t)
        for k in (0, 1):
            if over[k] * over[k + 1] < 0:
                note(three[k] if over[k] < 0 else three[k + 1])
    for g in tried:
        if all(abs(t - g) >= 2.0**-10 * (end - start) for t in noted) and excess(a, g) > -Fraction(1, 2**90):
            note(math.nextafter(g, -math.inf))
            note(math.nextafter(g, math.inf))
    return sorted(noted)[1:-1]


def pieces(a, start, end):
    """Of the polynomial a: until when, None for the last, and "cosine", or which way the body rests."""
    out, begin = [], start
    for until in [*cuts(a, start, end), None]:
        last = end if until is None else until
        middle = begin + (last - begin) / 2
        rests = all(excess(a, t) > -Fraction(1, 2**90) for t in (begin, middle, last))
        out.append([until, ("not turned" if value(a, middle) > 0 else "half a turn") if rests else "cosine"])
        begin = until
    return out

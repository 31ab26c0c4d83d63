"""Motions that are written in degrees, as the pieces that they stand for. See docs/scenes.md and docs/proof-format.md:
each coefficient is the exact number, rounded once to a double."""

import math
from fractions import Fraction

from covered import NotCovered

FORMS = ("keyframes", "csv", "velocity", "spin_deg", "sweep")
QUARTERS = ((1.0, 0.0), (0.0, 1.0), (-1.0, 0.0), (0.0, -1.0))
DIGITS = 1 << 1100  # what is not rational is known to so many parts of one


def _arctan_of_inverse(n):
    total, power, k = 0, DIGITS // n, 1
    while power:
        total += power // k if k % 4 == 1 else -(power // k)
        power //= n * n
        k += 2
    return total


RADIANS_PER_DEGREE = Fraction(4 * (4 * _arctan_of_inverse(5) - _arctan_of_inverse(239)), 180 * DIGITS)


def line(t0, a, t1, b, factor=Fraction(1)):
    """The polynomial through (t0, a) and (t1, b) in powers of the time since t0, times a factor."""
    if a == b:
        return [float(Fraction(a) * factor)] if a else []
    t0, a, t1, b = map(Fraction, (t0, a, t1, b))
    return [float(a * factor), float((b - a) / (t1 - t0) * factor)]


def turning(t0, a, t1, b):
    return line(t0, a, t1, b, RADIANS_PER_DEGREE)


def quarters(degrees):
    """How many quarter turns an angle is, modulo four; None if it is none."""
    turns = Fraction(degrees) / 90
    return None if turns.denominator > 1 else turns.numerator % 4


def held(degrees):
    turns = quarters(degrees)
    if turns is None:
        return {"angle": [float(Fraction(degrees) * RADIANS_PER_DEGREE)]}
    cosine, sine = QUARTERS[turns]
    return {"direction": {"a": [cosine], "b": [sine]}} if turns else None


def sine_and_cosine(degrees):
    turns = quarters(degrees)
    if turns is not None:
        return map(Fraction, reversed(QUARTERS[turns]))
    x = int(Fraction(math.fmod(degrees, 360)) * RADIANS_PER_DEGREE * DIGITS) // 16  # four doublings later
    term, totals, k = DIGITS, [0, 0], 0
    while term not in (0, -1):
        totals[k % 2] += -term if k % 4 in (2, 3) else term
        k += 1
        term = term * x // DIGITS // k
    cosine, sine = (Fraction(total, DIGITS) for total in totals)
    for _ in range(4):
        sine, cosine = 2 * sine * cosine, cosine * cosine - sine * sine
    return sine, cosine


def arrival(before, key, pivot):
    """Where the way around a centre leads to, from the place and the angle before."""
    way = "turn" if "turn" in key else "arc"
    by, centre = float(key[way]["deg"]), [Fraction(float(c)) for c in key[way]["center"]]
    sine, cosine = sine_and_cosine(by)
    x, y = (Fraction(p) + Fraction(b) - c for p, b, c in zip(pivot, before, centre))
    sums = cosine * x - sine * y + centre[0] - Fraction(pivot[0]), sine * x + cosine * y + centre[1] - Fraction(pivot[1])
    # Sixths of a turn have exact cosines, and a sum may be zero: this much is not known of it.
    unknown = Fraction(sum(map(abs, (x, y, *centre, *map(Fraction, pivot)))), 1 << 900)
    place = [float(total) if abs(total) >= unknown else 0.0 for total in sums]
    return (*place, before[2] + by if way == "turn" else before[2])


def rest_at(place, pivot):
    x, y, angle = place
    return {"x": [x], "y": [y], "rotation": held(angle), "pivot": pivot}


def leg(t0, a, t1, b, key, pivot):
    """From one place to the next."""
    way = next((key[name] for name in ("turn", "arc") if name in key), None)
    if way and float(way["deg"]) != 0:
        piece = rest_at(a, pivot)
        piece["orbit"] = {"center": way["center"], "angle": turning(t0, 0.0, t1, float(way["deg"]))}
        if "turn" in key and a[2] != b[2]:
            piece["rotation"] = {"angle": turning(t0, a[2], t1, b[2])}
    else:
        rotation = held(a[2]) if a[2] == b[2] else {"angle": turning(t0, a[2], t1, b[2])}
        piece = {"x": line(t0, a[0], t1, b[0]), "y": line(t0, a[1], t1, b[1]), "rotation": rotation, "pivot": pivot}
    return {**piece, "origin": t0, "until": t1}


def from_keyframes(keys, pivot):
    times, places = [float(key["t"]) for key in keys], []
    for key in keys:
        if "turn" in key or "arc" in key:
            places.append(arrival(places[-1], key, pivot))
        else:
            places.append(tuple(float(key.get(name, 0)) for name in ("x", "y", "angle_deg")))
    if len(keys) == 1:
        return [rest_at(places[0], pivot)]
    pieces = [{**rest_at(places[0], pivot), "until": times[0]}]
    for k in range(1, len(keys)):
        pieces.append(leg(times[k - 1], places[k - 1], times[k], places[k], keys[k], pivot))
    return [*pieces, rest_at(places[-1], pivot)]


def compiled(motion, start, end):
    """The motion, given by pieces."""
    if not isinstance(motion, dict) or not any(form in motion for form in FORMS):
        return motion
    pivot = [float(c) for c in motion.get("pivot", (0, 0))]
    if "keyframes" in motion:
        return from_keyframes(motion["keyframes"], pivot)
    if "csv" in motion:
        raise NotCovered("a motion in a file of its own")
    if "sweep" in motion:
        sweep = motion["sweep"]
        angle = turning(start, float(sweep["from_deg"]), end, float(sweep["to_deg"]))
        return [{"rotation": {"angle": angle}, "origin": start, "pivot": sweep.get("pivot", (0, 0))}]
    x, y = motion.get("velocity", (0, 0))
    spin = float(motion.get("spin_deg", 0))
    rotation = {"angle": [0, float(Fraction(spin) * RADIANS_PER_DEGREE)]} if spin else None
    return [{"x": [0, x], "y": [0, y], "rotation": rotation, "pivot": pivot}]

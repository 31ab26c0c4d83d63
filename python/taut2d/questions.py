"""How close bodies come, and when they overlap: the questions and their answers."""

from __future__ import annotations

import json
from dataclasses import dataclass, field
from typing import Any, Optional

from ._numbers import number
from ._verdict import Verdict, bodies_text, bracket, counted, instant, names, nothing
from .answers import Coverage, EdgeRef, Interval, PairAnswer, Point, VertexRef, _floats, _pair, _pair_answer
from .errors import InputError
from .options import ask, asked_scene
from .scene import Scene, _plain_places
from .words import Pairs, QuestionOutcome, RangeOutcome, Touch

# Without range(): `from taut2d import *` must leave Python's own alone.
__all__ = ["Clearance", "DistanceCurve", "DistanceProfile", "Intervals", "Meeting", "NearestPoints", "OverlapInterval", "Range",
           "clearance", "distance_profile", "intervals"]


@dataclass(frozen=True)
class Meeting:
    """What meets when an overlap begins, or parts when it ends; ``point`` is rounded, in the world's coordinates."""

    vertex: VertexRef
    edge: EdgeRef
    point: Point


@dataclass(frozen=True)
class OverlapInterval:
    """A maximal interval of time in which two bodies overlap.

    ``start``, ``end``: (lo, hi), which certainly contain its ends; exact where they are those of the scene's time.
    ``start_deg``, ``end_deg``: the same as angles in degrees, if one of the two sweeps.
    ``enter``, ``exit``: what meets and parts there; None at the start and the end of the scene.
    """

    pair: tuple[str, str]
    start: Interval
    end: Interval
    start_deg: Optional[Interval] = None
    end_deg: Optional[Interval] = None
    enter: Optional[Meeting] = None
    exit: Optional[Meeting] = None


@dataclass(frozen=True)
class Intervals(Verdict):
    """All intervals of overlap, pair by pair, each pair's in order of time. Nothing is claimed about pairs in
    ``undecided``. ``outcome``: "undecided" if there are such pairs, else "contact" if two bodies overlap at some time,
    else "free"; "untested" if no pair was tested. ``reason``: why it is undecided or untested; else None. ``json`` is what
    ``taut intervals --json`` prints."""

    outcome: QuestionOutcome
    reason: Optional[str]
    intervals: tuple[OverlapInterval, ...]
    undecided: tuple[PairAnswer, ...]
    coverage: Coverage
    json: str = field(repr=False, compare=False)

    def plot(self, ax: Any = None) -> Any:
        """Draws the intervals over time by matplotlib, a row for each pair that overlaps, and returns
        the axes. Pairs that are undecided are hatched.

        ``ax``: axes to draw into; None makes a new figure. Raises ImportError if matplotlib is missing, InputError if
        there is nothing to draw."""
        from .charts import plot_intervals
        return plot_intervals(self, ax)

    def _words(self) -> tuple[str, str]:
        if not self.intervals:
            return f"{bodies_text(self.coverage)} overlap at any time", ""
        first = min(self.intervals, key=lambda interval: interval.start)
        word = "first" if len(self.intervals) > 1 else "that is"
        return (f"{counted(len(self.intervals), 'interval')} of overlap",
                f"{word} {names(first.pair)}, from t = {bracket(first.start)} to {bracket(first.end)}")

    def _undecided_words(self) -> tuple[str, str]:
        if not self.undecided:
            return "", self.reason or ""
        count, first = len(self.undecided), names(self.undecided[0].bodies)
        known = first if count == 1 else f"{count} pairs, {first} among them"
        return f"{known}; of the others {counted(len(self.intervals), 'interval')} of overlap", self.reason or ""


@dataclass(frozen=True)
class Range(Verdict):
    """The maximal interval of time around an instant in which nothing overlaps.

    ``outcome``: "free", "undecided" or "untested". ``reason``: why it is one of the last two; else None.
    ``start``, ``end``: (lo, hi), which certainly contain its ends; None where these are the scene's own.
    ``before``, ``after``: the overlaps there. ``coverage``: which pairs that is about.
    ``json`` is what ``taut range --json`` prints.
    """

    outcome: RangeOutcome
    start: Optional[Interval]
    end: Optional[Interval]
    start_deg: Optional[Interval]
    end_deg: Optional[Interval]
    before: Optional[OverlapInterval]
    after: Optional[OverlapInterval]
    reason: Optional[str]
    coverage: Coverage
    json: str = field(repr=False, compare=False)

    def _words(self) -> tuple[str, str]:
        start = "the start" if self.start is None else f"t = {bracket(self.start)}"
        end = "the end" if self.end is None else f"t = {bracket(self.end)}"
        around = [f"{names(overlap.pair)} overlap {word}"
                  for overlap, word in ((self.before, "before"), (self.after, "after")) if overlap is not None]
        return f"{bodies_text(self.coverage)} overlap from {start} to {end}", ", ".join(around)


@dataclass(frozen=True)
class NearestPoints:
    """How close a pair of bodies comes.

    ``lo``, ``hi``: the least distance over the scene's time certainly lies between them; both 0 if the bodies touch.
    ``t``: (lo, hi), a time at which the distance is at most ``hi``; ``angle_deg``: the same of a sweep.
    ``points``, ``edges``: the nearest points, rounded, one on each body, and on which edges; None where they touch.
    """

    lo: float
    hi: float
    t: Interval
    pair: tuple[str, str]
    angle_deg: Optional[Interval] = None
    points: Optional[tuple[Point, Point]] = None
    edges: Optional[tuple[EdgeRef, EdgeRef]] = None


@dataclass(frozen=True)
class Clearance(Verdict):
    """How close bodies come. ``outcome``: "free": no two bodies touch; "contact": two do; "undecided"; "untested".
    ``nearest``: of the closest pair; None if it is undecided or untested: ``reason`` then says why. ``pairs``: of every pair, if they were asked for. ``wide``: why the bracket is wider than
    was asked for, as where a limit of time was reached or curves run along each other for long; else None. ``json`` is what ``taut clearance --json``
    prints."""

    outcome: QuestionOutcome
    nearest: Optional[NearestPoints]
    pairs: tuple[NearestPoints, ...]
    reason: Optional[str]
    coverage: Coverage
    json: str = field(repr=False, compare=False)
    wide: Optional[str] = field(default_factory=nothing)

    @property
    def distance(self) -> Optional[Interval]:
        """(lo, hi), which certainly contain the least distance over the scene's time: those of ``nearest``; None if that
        is undecided or untested."""
        return None if self.nearest is None else (self.nearest.lo, self.nearest.hi)

    def plot(self, ax: Any = None) -> Any:
        """Draws the least distance of the closest pair, or of each pair if they were asked for, by matplotlib, and
        returns the axes. Brackets are hatched from their lower to their upper end.

        ``ax``: axes to draw into; None makes a new figure. Raises ImportError if matplotlib is missing, InputError if
        there is nothing to draw."""
        from .charts import plot_clearance
        return plot_clearance(self, ax)

    def _words(self) -> tuple[str, str]:
        if self.nearest is None:
            return "", self.reason or ""
        nearest, among = self.nearest, "" if self.coverage.untested == 0 else " of the tested pairs"
        if nearest.hi == 0:
            return f"{names(nearest.pair)} touch or overlap at {instant(nearest.t)}", self.wide or ""
        return (f"the least distance{among} is {bracket((nearest.lo, nearest.hi))}",
                f"between {names(nearest.pair)}, at {instant(nearest.t)}")


@dataclass(frozen=True)
class DistanceCurve:
    """The distance of two bodies over time; 0 where they touch or overlap.

    ``pair``: whose; None if at each time it is the least one of all pairs. ``instants``: (t, lo, hi), evenly spaced:
    the distance at t certainly lies between lo and hi. ``stretches``: (start, end, lo, hi), the same for every instant
    from start to end. ``largest``: (lo, hi), which certainly contain the greatest distance, and ``largest_at`` is a time
    at which it is at least lo. ``settled``: whether that bracket is as narrow as was asked for, or of curves, as can be;
    ``wide``: why it is wider than was asked for.
    """

    pair: Optional[tuple[str, str]]
    instants: tuple[tuple[float, float, float], ...]
    stretches: tuple[tuple[float, float, float, float], ...]
    largest: Interval
    largest_at: float
    settled: bool
    wide: Optional[str] = None


@dataclass(frozen=True)
class DistanceProfile(Verdict):
    """The distance of bodies over time. ``outcome``: as of Clearance. ``curves``: first the least of all pairs, then each
    pair's own, if they were asked for; none if it is undecided or untested: ``reason`` then says why. Of bodies with curves
    brackets hold the curves' own distance; between instants to 1e-4 of it at best. ``json`` is what
    ``taut clearance --profile N --json`` prints."""

    outcome: QuestionOutcome
    curves: tuple[DistanceCurve, ...]
    reason: Optional[str]
    coverage: Coverage
    json: str = field(repr=False, compare=False)

    @property
    def greatest(self) -> Optional[Interval]:
        """(lo, hi), which certainly contain the greatest distance over the scene's time: ``largest`` of the first curve,
        at each time the least distance of all pairs; None if there are no curves."""
        return self.curves[0].largest if self.curves else None

    def plot(self, ax: Any = None) -> Any:
        """Draws the distance over time by matplotlib, a line for each curve, with its brackets between instants as
        bands, and returns the axes.

        ``ax``: axes to draw into; None makes a new figure. Raises ImportError if matplotlib is missing, InputError if
        there is nothing to draw."""
        from .charts import plot_profile
        return plot_profile(self, ax)

    def _words(self) -> tuple[str, str]:
        if not self.curves:
            return "", self.reason or ""
        curve, among = self.curves[0], "" if self.coverage.untested == 0 else " of the tested pairs"
        lo = min(part[-2] for part in (*curve.instants, *curve.stretches))
        who = "two bodies touch or overlap" if self.outcome == "contact" else f"the distance{among} is never below {lo!r}"
        return who, f"it is greatest, {bracket(curve.largest)}, at t = {curve.largest_at!r}"


def _interval(value: Any) -> Optional[Interval]:
    return None if value is None else _floats(value)


def _meeting(value: Any) -> Optional[Meeting]:
    if value is None:
        return None
    return Meeting(VertexRef(**value["vertex"]), EdgeRef(**value["edge"]), _floats(value["point"]))


def _overlap(value: Any) -> Optional[OverlapInterval]:
    if value is None:
        return None
    return OverlapInterval(_pair(value["pair"]), _floats(value["from"]), _floats(value["to"]),
                           _interval(value.get("from_deg")), _interval(value.get("to_deg")),
                           _meeting(value.get("enter")), _meeting(value.get("exit")))


def _nearest(value: Any) -> Optional[NearestPoints]:
    if value is None:
        return None
    points, edges = value.get("points"), value.get("edges")
    return NearestPoints(float(value["lo"]), float(value["hi"]), _floats(value["t"]), _pair(value["pair"]),
                         _interval(value.get("angle_deg")),
                         None if points is None else (_floats(points[0]), _floats(points[1])),
                         None if edges is None else (EdgeRef(**edges[0]), EdgeRef(**edges[1])))


def _intervals_members(text: str) -> dict[str, Any]:
    value = json.loads(text)
    found = tuple(o for o in map(_overlap, value["intervals"]) if o is not None)
    return {"outcome": value["outcome"], "reason": value.get("reason"), "intervals": found,
            "undecided": tuple(map(_pair_answer, value["undecided"])), "coverage": Coverage(**value["coverage"])}


def range_from_json(text: str) -> Range:
    """What ``taut range --json`` has printed."""
    value = json.loads(text)
    ends = value["range"] or {}
    return Range(value["outcome"], _interval(ends.get("from")), _interval(ends.get("to")), _interval(ends.get("from_deg")),
                 _interval(ends.get("to_deg")), _overlap(value.get("before")), _overlap(value.get("after")),
                 value.get("reason"), Coverage(**value["coverage"]), text)


def _clearance_members(text: str) -> dict[str, Any]:
    value = json.loads(text)
    pairs = tuple(n for n in map(_nearest, value.get("pairs", ())) if n is not None)
    return {"outcome": value["outcome"], "nearest": _nearest(value["clearance"]), "pairs": pairs,
            "reason": value.get("reason"), "coverage": Coverage(**value["coverage"]), "wide": value.get("wide")}


def _curve(value: Any) -> DistanceCurve:
    largest = value["largest"]
    return DistanceCurve(None if value["pair"] is None else _pair(value["pair"]),
                         tuple((float(t), float(lo), float(hi)) for t, lo, hi in value["instants"]),
                         tuple((float(a), float(b), float(lo), float(hi)) for a, b, lo, hi in value["stretches"]),
                         (float(largest["lo"]), float(largest["hi"])), float(largest["t"]), bool(largest["settled"]),
                         largest.get("wide"))


def profile_from_json(text: str) -> DistanceProfile:
    """What ``taut clearance --profile N --json`` has printed."""
    value = json.loads(text)
    return DistanceProfile(value["outcome"], tuple(map(_curve, value["profile"])), value.get("reason"), Coverage(**value["coverage"]), text)


def intervals(scene: Scene, *, touch: Touch = "open", max_seconds: Optional[float] = None) -> Intervals:
    """All maximal intervals of time in which bodies of the scene overlap, for each pair that is asked about.

    ``touch``: with "open", an instant at which bodies only touch is no interval; with "closed" it is one.
    ``max_seconds``: pairs that are not done by then are listed as undecided. Errors are those of check().
    """
    with _plain_places():
        answer, _, _ = ask("intervals", asked_scene(scene), touch=touch, max_seconds=max_seconds)
        return Intervals._of(answer, _intervals_members)


def range(scene: Scene, around: float, *, touch: Touch = "open", max_seconds: Optional[float] = None) -> Range:
    """The maximal interval of time around an instant in which no two bodies that are asked about overlap.

    Raises InputError if the instant is outside of the scene's time, or bodies overlap then; else as check().
    """
    with _plain_places():
        at: dict[str, Any] = {"from": number(around, "around")}
        answer, _, _ = ask("range", asked_scene(scene), touch=touch, max_seconds=max_seconds, **at)
        return range_from_json(answer)


def clearance(scene: Scene, *, tolerance: float = 1e-9, pairs: Pairs = "first", within: Optional[float] = None,
              max_seconds: Optional[float] = None) -> Clearance:
    """How close bodies come over the scene's time: a bracket that certainly holds the least distance of their closures.

    ``tolerance``: how wide the bracket may be, as a share of it, and 1e-12 of the largest coordinate besides.
    ``pairs``: "first": of the pair that comes closest; "all": of each pair, in Clearance.pairs. ``within``: with "all",
    only of pairs that may come as close as this; others are counted as ``apart``. Errors are those of check().
    """
    with _plain_places():
        answer, _, _ = ask("clearance", asked_scene(scene), tolerance=tolerance, pairs=pairs, within=within,
                           max_seconds=max_seconds)
        return Clearance._of(answer, _clearance_members)


def distance_profile(scene: Scene, instants: int = 101, *, tolerance: float = 1e-9, pairs: Pairs = "first",
                     max_seconds: Optional[float] = None) -> DistanceProfile:
    """The distance of bodies over the scene's time, in brackets that are certain: at so many ``instants`` (2 to
    1,000,000), evenly spaced, on the stretches between them, and of the greatest distance.

    ``tolerance``: as of clearance(), for each bracket but the upper ends of the stretches', which are as good as these
    are short. ``pairs``: "first": at each time the least distance of all pairs; "all": then each pair's, too. Errors are
    those of check().
    """
    if not 2 <= instants <= 1000000:
        raise InputError("instants", f"{instants} instants were asked for", "2 to 1000000 can be")
    with _plain_places():
        answer, _, _ = ask("distance_profile", asked_scene(scene), instants=instants, tolerance=tolerance, pairs=pairs,
                           max_seconds=max_seconds)
        return profile_from_json(answer)

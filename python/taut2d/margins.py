"""Whether bodies keep a clearance: the question, its answer, and its proof."""

from __future__ import annotations

import json
from dataclasses import dataclass, field
from typing import Any, Optional, Union

from ._numbers import number
from ._verdict import Verdict, instant, names
from .answers import Coverage, EdgeRef, Interval, Logged, Point, VertexRef, _floats, _pair
from .options import ask, asked_scene
from .scene import PairClearance, Scene, _plain_places
from .words import MarginOutcome, Pairs, Touch

__all__ = ["MarginAnswer", "MarginProof", "PairMargin", "check_clearance", "prove_clearance"]


@dataclass(frozen=True)
class PairMargin:
    """One pair and the clearance. ``outcome``: "free": always kept. "contact": they first come closer (with
    ``touch="closed"``: as close) within ``t``. "closer_at_start", "overlap_at_start": they are, or even overlap, at the start. "undecided": the highest
    precision does not tell, or a limit was reached: see ``reason``.

    Of a contact, ``vertex`` and either ``edge`` or ``other_vertex`` are the features that come so close; ``grazing``:
    they do so slowly that ``t`` is wider than the clock is fine. ``points``, ``edges``: nearest points then, on each
    body, no more than ``distance`` apart. ``free_until``: certainly not closer before.

    ``margin``, ``origin``: of a scene with clearances, what the pair is to keep, as in PairClearance. ``margin_at``: what that
    is at the end of ``t``, or at ``free_until``, if it changes with time; rounded up.
    """

    bodies: tuple[str, str]
    outcome: MarginOutcome
    t: Optional[Interval] = None
    grazing: bool = False
    vertex: Optional[VertexRef] = None
    edge: Optional[EdgeRef] = None
    other_vertex: Optional[VertexRef] = None
    distance: Optional[float] = None
    points: Optional[tuple[Point, Point]] = None
    edges: Optional[tuple[EdgeRef, EdgeRef]] = None
    free_until: Optional[float] = None
    reason: Optional[str] = None
    margin: Union[None, float, tuple[float, ...]] = None
    origin: float = 0.0
    margin_at: Optional[float] = None


def _nearest_text(pair: PairMargin) -> str:
    if pair.points is None or pair.distance is None:
        return ""
    (a, b), (c, d) = pair.points
    return f"nearest points then: ({a:.9g}, {b:.9g}) and ({c:.9g}, {d:.9g}), at most {pair.distance!r} apart"


@dataclass(frozen=True)
class MarginAnswer(Verdict):
    """Do all bodies keep a clearance? ``first``: the pair that comes closer first; None if ``outcome`` is "free".
    ``also``: others that do at the same time, as far as is known. ``pairs``: every pair, if they were asked for.
    ``clearances``: those of the scene, for which ``clearance`` does not count. ``json`` is what ``taut check --clearance C --json``
    prints."""

    outcome: MarginOutcome
    clearance: float
    first: Optional[PairMargin]
    also: tuple[PairMargin, ...]
    pairs: tuple[PairMargin, ...]
    reason: Optional[str]
    coverage: Coverage
    json: str = field(repr=False, compare=False)
    clearances: tuple[PairClearance, ...] = ()

    @property
    def t(self) -> Optional[Interval]:
        """When that is."""
        return None if self.first is None else self.first.t

    def _words(self) -> tuple[str, str]:
        first = self.first
        if first is None:
            who = "all bodies keep" if self.coverage.untested == 0 else "bodies of the tested pairs keep"
            return f"{who} {'their clearances' if self.clearances else f'a distance of {self.clearance!r}'}", ""
        if self.outcome == "overlap_at_start":
            return f"{names(first.bodies)} overlap at the start", ""
        known = f"{names(first.bodies)} do not keep a distance of {_asked(first, self.clearance)!r}"
        return f"{known} at {'the start' if first.t is None else instant(first.t)}", _nearest_text(first)

    def _undecided_words(self) -> tuple[str, str]:
        first = self.first
        if first is None:
            return "", self.reason or ""
        until = "" if first.free_until is None else f", free until t = {first.free_until!r}"
        return names(first.bodies) + until, first.reason or self.reason or ""


@dataclass(frozen=True)
class MarginProof(Logged):
    """An answer about a clearance with a log that proves it, which verify() and the program taut-verify check. ``log`` is
    empty if there is nothing to prove: bodies are closer at the start, or nothing was decided. ``scene_sha256``: names the
    scene that it is about."""

    answer: MarginAnswer
    log: bytes = field(repr=False)
    scene_sha256: str

    _instead = 'proof.answer.outcome == "free", or verify(scene, proof)'


def _asked(pair: PairMargin, clearance: float) -> float:
    """What the pair was to keep, then."""
    if pair.margin is None:
        return clearance
    return pair.margin if isinstance(pair.margin, float) else pair.margin_at or 0.0


def _own_margin(value: Any) -> Union[None, float, tuple[float, ...]]:
    return tuple(map(float, value)) if isinstance(value, list) else None if value is None else float(value)


def _margin(value: Any) -> PairMargin:
    points, edges, t = value.get("points"), value.get("edges"), value.get("t")
    vertex, edge, other = (value.get(key) for key in ("vertex", "edge", "other_vertex"))
    return PairMargin(_pair(value["bodies"]), value["outcome"], None if t is None else _floats(t),
                      value.get("grazing", False), None if vertex is None else VertexRef(**vertex),
                      None if edge is None else EdgeRef(**edge), None if other is None else VertexRef(**other),
                      value.get("distance"), None if points is None else (_floats(points[0]), _floats(points[1])),
                      None if edges is None else (EdgeRef(**edges[0]), EdgeRef(**edges[1])),
                      None if value.get("free_until") is None else float(value["free_until"]), value.get("reason"),
                      _own_margin(value.get("margin")), float(value.get("origin", 0)),
                      None if value.get("margin_at") is None else float(value["margin_at"]))


def margin_from_json(text: str) -> MarginAnswer:
    """What ``taut check --clearance C --json`` has printed."""
    value = json.loads(text)
    first = value.get("first")
    return MarginAnswer(value["outcome"], float(value["clearance"]), None if first is None else _margin(first),
                        tuple(map(_margin, value.get("also", ()))), tuple(map(_margin, value.get("pairs", ()))),
                        value.get("reason"), Coverage(**value["coverage"]), text,
                        tuple(PairClearance(**own) for own in value.get("clearances", ())))


def check_clearance(scene: Scene, clearance: float, *, touch: Touch = "open", pairs: Pairs = "first",
                    max_seconds: Optional[float] = None) -> MarginAnswer:
    """Do all bodies keep this distance, in the scene's units, and if not, when and where do they first come closer?

    ``clearance`` must be positive. ``touch``: bodies that come to the clearance and no closer, or stay at it, are free
    if it is "open", and in contact if it is "closed". ``pairs``: "first": up to the first pair that comes closer; "all":
    each pair on its own, in MarginAnswer.pairs. "free" is proved, and so is the time of a contact. Pairs that
    Scene.clearances name keep the margin given there instead, which may change with time. Errors are those of check().
    """
    with _plain_places():
        answer, _, _ = ask("check_clearance", asked_scene(scene), clearance=number(clearance, "clearance"), touch=touch,
                           pairs=pairs, max_seconds=max_seconds)
        return margin_from_json(answer)


def prove_clearance(scene: Scene, clearance: float, *, touch: Touch = "open",
                    max_seconds: Optional[float] = None) -> MarginProof:
    """As check_clearance(), with a log that proves the answer, in memory. Options and errors are those of
    check_clearance(); a scene with clearances is one."""
    with _plain_places():
        answer, log, name = ask("prove_clearance", asked_scene(scene), clearance=number(clearance, "clearance"),
                                touch=touch, max_seconds=max_seconds)
    return MarginProof(margin_from_json(answer), log, name)

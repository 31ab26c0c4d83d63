"""How bodies come apart: the question and its answer."""

from __future__ import annotations

import json
from dataclasses import dataclass, field
from typing import Any, Optional, Union

from ._verdict import Verdict, counted, names
from .answers import Coverage, EdgeRef, Interval, VertexRef, _floats
from .options import ask, asked_scene
from .scene import Scene, _plain_places
from .words import SeparationOutcome

__all__ = ["BodyDirections", "DirectionArc", "RemovalStep", "RemovalWay", "Separation", "VertexAtEdge", "WayPoint", "separate"]


@dataclass(frozen=True)
class VertexAtEdge:
    """A vertex of one body that comes to an edge of the other just where the travel ends."""

    vertex: VertexRef
    edge: EdgeRef


@dataclass(frozen=True)
class DirectionArc:
    """A maximal closed arc of directions, counterclockwise.

    ``start_deg``, ``end_deg``: (lo, hi), degrees from the x axis that certainly contain its ends. ``point``: a single
    direction, as far as doubles can tell, a slot that fits exactly. ``start_vertices``, ``end_vertices``: the vertex of
    the moving body that comes to a vertex of another one in that direction; or ``start_reach``, ``end_reach``: there the
    travel ends. None of these if the arc is all directions.
    """

    start_deg: Interval
    end_deg: Interval
    point: bool
    start_vertices: Optional[tuple[VertexRef, VertexRef]] = None
    end_vertices: Optional[tuple[VertexRef, VertexRef]] = None
    start_reach: Optional[VertexAtEdge] = None
    end_reach: Optional[VertexAtEdge] = None


@dataclass(frozen=True)
class BodyDirections:
    """Where one body can go by itself. ``free``: the arcs; empty if it is locked. ``all``: every direction is free."""

    body: str
    all: bool
    free: tuple[DirectionArc, ...]


def _freedom(body: BodyDirections) -> str:
    if body.all:
        return f"{body.body} leaves in every direction"
    return f"{body.body} leaves in {counted(len(body.free), 'arc')} of directions" if body.free else \
        f"{body.body} leaves in no direction"


@dataclass(frozen=True)
class RemovalStep:
    """One body taken away, straight, in ``direction_deg``, about the middle of the arc ``within``."""

    body: str
    direction_deg: float
    within: DirectionArc


@dataclass(frozen=True)
class WayPoint:
    """A place on a way: a point p of the body, where it stands at the start, is at R (p - pivot) + pivot + (x, y), where R
    turns by ``deg`` degrees counterclockwise."""

    x: float
    y: float
    deg: float


@dataclass(frozen=True)
class RemovalWay:
    """One body taken away along a way on which it may turn about ``pivot``: from the start to where its box and the common
    box of all that block it have no inner point in common. Between two ``points``, x, y and deg change evenly."""

    body: str
    pivot: tuple[float, float]
    points: tuple[WayPoint, ...]


@dataclass(frozen=True)
class Separation(Verdict):
    """How bodies come apart. ``outcome``: "free", "locked", "overlap_at_start" (of ``pair``), "undecided" or
    "untested" (for ``reason``). ``bodies``: of two bodies, the second one's directions against the first; of more, each one's against
    all others. ``order``: of more than two, bodies in an order in which they leave one by one; ``stuck``: those that are
    left then.

    If turns were asked for: ``ways``: an order in which bodies leave one by one along ways that are proved free; ``stuck``:
    those that are left and have no way of any shape by themselves; ``unsure``: those of which that is not known. ``scene``:
    the bodies as they leave, one after the other: what check() and prove() take. All that is about bodies whose boundaries
    lie within ``rounded`` of those meant, since where they stand is rounded; 0 if they are drawn there.

    ``wide``: why ends are enclosed less narrowly than to 1e-7 degrees, as curves may demand. ``json`` is what
    ``taut separate --json`` prints."""

    outcome: SeparationOutcome
    bodies: tuple[BodyDirections, ...]
    order: tuple[RemovalStep, ...]
    stuck: tuple[str, ...]
    pair: Optional[tuple[str, ...]]
    reason: Optional[str]
    coverage: Coverage
    json: str = field(repr=False, compare=False)
    wide: Optional[str] = None
    ways: tuple[RemovalWay, ...] = ()
    unsure: tuple[str, ...] = ()
    rounded: float = 0.0
    scene: Optional[Scene] = field(default=None, repr=False, compare=False)

    def _words(self) -> tuple[str, str]:
        if self.outcome == "overlap_at_start":
            return names(self.pair), ""
        steps: tuple[Union[RemovalStep, RemovalWay], ...] = self.ways or self.order
        if steps or self.stuck:
            leave = "bodies leave in the order " + ", ".join(step.body for step in steps) if steps else "no body leaves"
            return leave, "these cannot leave: " + ", ".join(self.stuck) if self.stuck else ""
        return "; ".join(map(_freedom, self.bodies)), ""


def _arc(value: Any) -> DirectionArc:
    def vertices(key: str) -> Optional[tuple[VertexRef, VertexRef]]:
        pair = value.get(key)
        return None if pair is None else (VertexRef(**pair[0]), VertexRef(**pair[1]))

    def reach(key: str) -> Optional[VertexAtEdge]:
        at = value.get(key)
        return None if at is None else VertexAtEdge(VertexRef(**at["vertex"]), EdgeRef(**at["edge"]))

    return DirectionArc(_floats(value["from_deg"]), _floats(value["to_deg"]), value["point"],
                        vertices("from_vertices"), vertices("to_vertices"), reach("from_reach"), reach("to_reach"))


def _directions(value: Any) -> BodyDirections:
    return BodyDirections(value["body"], value["all"], tuple(map(_arc, value["directions"])))


def _step(value: Any) -> RemovalStep:
    return RemovalStep(value["body"], float(value["direction_deg"]), _arc(value["within"]))


def _way(value: Any) -> RemovalWay:
    points = tuple(WayPoint(float(at["x"]), float(at["y"]), float(at["deg"])) for at in value["points"])
    return RemovalWay(value["body"], _floats(value["pivot"]), points)


def separation_from_json(text: str) -> Separation:
    """What ``taut separate --json`` has printed."""
    value = json.loads(text)
    bodies = value.get("bodies") if "bodies" in value else [value]
    pair = value.get("pair")
    return Separation(value["outcome"], tuple(map(_directions, bodies)), tuple(map(_step, value.get("order", ()))),
                      tuple(value.get("stuck", ())), None if pair is None else tuple(pair), value.get("reason"),
                      Coverage(**value["coverage"]), text, value.get("wide"), tuple(map(_way, value.get("ways", ()))),
                      tuple(value.get("unsure", ())), float(value.get("rounded", 0)),
                      Scene.from_json(json.dumps(value["scene"])) if "scene" in value else None)


def separate(scene: Scene, *, travel: Optional[float] = None, turns: bool = False, tolerance: float = 1e-4,
             max_cells: int = 4_000_000, max_seconds: Optional[float] = None) -> Separation:
    """In which directions bodies come apart, and in which order an assembly does.

    Bodies stand as at the start of the scene's time; each is moved straight, without turning, as far as ``travel``
    (in the scene's units, > 0; None: any distance), and must overlap nothing on the way, where touching is allowed, at
    the travel's end, too. Of two bodies, the second one moves. Errors are those of check().

    ``turns``: bodies that cannot leave straight are also moved along ways on which they turn as they like, one at a time,
    as path() finds them; or it is proved that there is none. ``tolerance``: places and angles are divided down to this
    share of their ranges, from 1e-9 to 1; ``max_cells``: a body is left undecided at so many cells. Not for curves.
    """
    with _plain_places():
        answer, _, _ = ask("separate", asked_scene(scene), travel=travel, turns=turns, tolerance=tolerance,
                           max_cells=max_cells, scene=turns, max_seconds=max_seconds)
        return separation_from_json(answer)

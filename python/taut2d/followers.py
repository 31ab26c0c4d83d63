"""How high a cam lifts its follower."""

from __future__ import annotations

import json
from dataclasses import dataclass, field
from typing import Any, Optional

from ._numbers import number
from .answers import Coverage, EdgeRef, VertexRef
from .options import ask, scene_text
from .scene import Scene, _plain_places
from .words import FollowState, Touch

__all__ = ["FollowAnswer", "FollowContact", "FollowStretch", "Lift", "follow"]


@dataclass(frozen=True)
class Lift:
    """Where a follower lies on what is below it. ``t``: contains the instant. ``lift``: contains that at the instant, along
    the direction, from where the scene has the follower. ``vertex`` and ``edge`` touch."""

    t: tuple[float, float]
    lift: tuple[float, float]
    vertex: VertexRef
    edge: EdgeRef


@dataclass(frozen=True)
class FollowContact:
    """A vertex of the follower on an edge of another body, or a vertex of another body on an edge of the follower."""

    vertex: VertexRef
    edge: EdgeRef


@dataclass(frozen=True)
class FollowStretch:
    """A stretch of the time of a contact sequence. ``state``: "carried" where ``touching`` holds the follower, all of it,
    and nothing else does, at all instants of ``t``; "low" where the lift is below 0 at all of them; "change" where contacts
    change, in no longer than the tolerance; "open" where more than that is not decided. Of the last two, ``touching`` is all
    that may touch. ``lift`` encloses the lifts; 0 stands for lower ones. ``once``: it is proved to be one change, of the
    contacts before to those after. ``jumps``: the lift is proved to jump there."""

    t: tuple[float, float]
    state: FollowState
    lift: tuple[float, float]
    touching: tuple[FollowContact, ...]
    once: bool = False
    jumps: bool = False


def _stretch(value: dict[str, Any]) -> FollowStretch:
    touching = tuple(FollowContact(VertexRef(**c["vertex"]), EdgeRef(**c["edge"])) for c in value["touching"])
    return FollowStretch((value["t"][0], value["t"][1]), value["state"], (value["lift"][0], value["lift"][1]), touching,
                         value.get("once", False), value.get("jumps", False))


@dataclass(frozen=True)
class FollowAnswer:
    """The lifts of ``body`` in order of time. Of ``instants``, those are left out at which nothing reaches up to where the
    scene has the follower: there the lift is 0 or less. ``undecided``: stretches of time whose instants are not decided,
    and ``reason`` why the first of them is not. ``coverage``: of pairs with the follower. ``contacts``, if asked for: stretches
    of time in order, from the scene's start to its end, and ``contacts_reason`` why the first open one is. ``json`` is what
    ``taut follow --json`` prints."""

    body: str
    instants: int
    lifts: tuple[Lift, ...]
    coverage: Coverage
    undecided: tuple[tuple[float, float], ...]
    reason: Optional[str]
    contacts: Optional[tuple[FollowStretch, ...]]
    contacts_reason: Optional[str]
    json: str = field(repr=False, compare=False)


def follow(scene: Scene, body: str, reach: float, *, direction_deg: float = 90, instants: int = 360,
           contacts: bool = False, tolerance: float = 1e-9, touch: Touch = "open", max_seconds: Optional[float] = None) -> FollowAnswer:
    """The lift of a follower, which has no motion of its own, at about so many ``instants``.

    In each of as many equal stretches of the scene's time it comes down evenly, from the lift ``reach`` to 0, and where it
    meets another body is an instant and a lift: both enclosed, for the motions as they are given. Nothing stands in its
    way from ``reach`` down to there at that instant, up to rounding of the places. ``direction_deg``: along
    which it is lifted, counterclockwise from the x axis. Assumes that a spring presses the follower onto the cam at all
    times. What touches only between two instants is not among the lifts.

    With ``contacts``, all of the scene's time is divided into stretches: in each of them it is proved which features hold
    the follower, at all instants, or it is shorter than ``tolerance``, a share of the scene's time. Nothing is missed.
    Bodies must be polygons, and the follower clear the others at ``reach`` at all times. InputError if the scene is not valid, there is no such body,
    it does not clear the others at ``reach``, or no pair with it is tested. What is open after ``max_seconds`` is in ``undecided``.
    """
    with _plain_places():
        text, _, _ = ask("follow", scene_text(scene), body=body, reach=number(reach, "reach"),
                         direction_deg=number(direction_deg, "direction_deg"), instants=instants,
                         contacts=contacts, tolerance=number(tolerance, "tolerance"), touch=touch,
                         max_seconds=max_seconds)
    value = json.loads(text)
    lifts = tuple(Lift((at["t"][0], at["t"][1]), (at["lift"][0], at["lift"][1]), VertexRef(**at["vertex"]),
                       EdgeRef(**at["edge"])) for at in value["lifts"])
    return FollowAnswer(value["body"], value["instants"], lifts, Coverage(**value["coverage"]),
                        tuple((lo, hi) for lo, hi in value.get("undecided", ())), value.get("reason"),
                        tuple(map(_stretch, value["contacts"])) if contacts else None, value.get("contacts_reason"), text)

"""Simulations: the kinetic data structure, advanced in time, with plans that may change."""

from __future__ import annotations

import json
from dataclasses import dataclass
from typing import Optional

from . import _taut2d
from ._numbers import number
from .answers import Contact, Coverage, PairAnswer, VertexRef, _contact, _pair_answer
from .errors import InputError
from .maps import motion_text, plain_motions
from .motions import Motion
from .options import run_options, scene_text
from .scene import Scene, _names, _plain_places
from .words import FaceKind, SimulationState, Touch

__all__ = ["Simulation", "Tiling", "TilingEdge", "TilingFace"]


@dataclass(frozen=True)
class TilingEdge:
    """An edge of the tiling, between two of Tiling.vertices. ``polygon``: it is an edge of a body. ``joins``: it joins the
    two bodies."""

    start: int
    end: int
    polygon: bool
    joins: bool


@dataclass(frozen=True)
class TilingFace:
    """A face of the tiling.

    ``kind``: "node" (the pseudo-triangle of a node of a body's chain tree), "root" (the root pseudo-triangle),
    "infinite" (what is outside of everything), or "polygon_interior". ``body``: of a node, or of an interior, whose it is;
    else None. ``depth``: of a node, in its tree, 0 at the root. ``boundary``: the face on the left, as places in
    Tiling.vertices; empty for interiors.
    """

    kind: FaceKind
    body: Optional[str]
    depth: int
    boundary: tuple[int, ...]


@dataclass(frozen=True)
class Tiling:
    """The planar map at one instant: a copy. ``points``: where ``vertices`` are, in the world, rounded."""

    time: float
    vertices: tuple[VertexRef, ...]
    points: tuple[tuple[float, float], ...]
    edges: tuple[TilingEdge, ...]
    faces: tuple[TilingFace, ...]


class Simulation:
    """check() online: it has a current time up to which the motion is proved free, and proceeds from there, event by
    event; the motion of a body after that time may be changed.

    ``scene``: any number of bodies, with parts, holes and parents, and without curves (flatten() makes polygons of these).
    Events are those of all pairs of rings that are near; distant pairs cost nothing. ``touch``, ``max_events``, ``max_seconds``: as in check(); the last
    one is for each call. Where one of them, Ctrl-C, or the highest precision ends it, ``state`` is "undecided" from then
    on.

    The time only grows. Threads may share a simulation: they take turns. Raises InputError if the scene is not valid.
    """

    def __init__(self, scene: Scene, *, touch: Touch = "open", max_events: Optional[int] = None,
                 max_seconds: Optional[float] = None) -> None:
        options = run_options(touch, "kinetic", "first", max_seconds, max_events)
        with _plain_places():
            self._core = _taut2d.Simulation(scene_text(scene), options)
        self._scene = scene

    @property
    def scene(self) -> Scene:
        """The scene with the motions that hold from ``time`` on: scene.poses(simulation.time) is where bodies are."""
        return self._scene

    @property
    def state(self) -> SimulationState:
        """"running": the tested pairs are free up to ``time``, and there may be more events; "finished": they are proved
        free to the end of the scene; "contact"; "overlap_at_start"; "undecided": nothing is claimed beyond ``time``, for
        the ``reason`` given; "untested": the end was reached, and no pair was tested at any time: see ``coverage``."""
        return self._core.standing().state

    @property
    def reason(self) -> str:
        """Why the state is "undecided", in words; empty otherwise."""
        return self._core.standing().reason

    @property
    def coverage(self) -> Coverage:
        """Which pairs are tested at present; set_motion() may change that."""
        return Coverage(*self._core.standing().coverage)

    @property
    def time(self) -> float:
        """Up to when the motion is proved free. After an event, the upper end of that event's enclosure; where events
        nearly coincide, the next one's may end a little before it."""
        return self._core.standing().time

    @property
    def contact(self) -> Optional[Contact]:
        """The first contact, once the state is "contact"."""
        members = self._core.standing().contact
        return _contact(json.loads(members)) if members else None

    @property
    def pair(self) -> Optional[tuple[str, str]]:
        """The two bodies of the contact, or of the overlap; or of what is not decided, if that is one pair of a world."""
        found = self._core.standing().pair
        return (self._scene.bodies[found[0]].name, self._scene.bodies[found[1]].name) if found else None

    @property
    def also(self) -> tuple[PairAnswer, ...]:
        """As Answer.also."""
        return tuple(_pair_answer(json.loads(text)) for text in self._core.standing().also)

    @property
    def overlap_point(self) -> Optional[tuple[float, float]]:
        """As Answer.overlap_point, if the state is "overlap_at_start"."""
        return self._core.standing().overlap

    @property
    def events(self) -> int:
        """How many events there have been."""
        return self._core.standing().events

    @property
    def certificates(self) -> int:
        """The size of the active set: how many certificates can fail."""
        return self._core.standing().certificates

    @property
    def certificates_max(self) -> int:
        """The largest that the active set has been."""
        return self._core.standing().certificates_max

    def next_event(self) -> Optional[tuple[float, float]]:
        """(lo, hi), which certainly contains the time of the next event, and never begins before ``time``: of events that
        nearly coincide, those after the first count as no earlier than the end of its enclosure. None if none is left before the end, or it is
        undecided. Looks as far as it must: if a motion's next piece begins before the event, ``time`` moves on to that
        joint, or to the end of a window in which nothing happens."""
        return self._core.next_event()

    def step(self) -> bool:
        """Processes one event; if several pairs are near, also those whose enclosures are not later. False if there is none
        before the end, after a contact, or if it is undecided."""
        return self._core.step()

    def advance_to(self, t: float) -> SimulationState:
        """Processes all events before ``t``, at most to the end of the scene, and stands at ``t``, unless a contact comes
        first. A time before ``time`` changes nothing. Returns the state. KeyboardInterrupt on Ctrl-C, which leaves it
        "undecided"; InputError for what is no finite number."""
        return self._core.advance_to(number(t, "t"))

    def set_motion(self, name: str, motion: Optional[Motion]) -> None:
        """Replaces a body's motion from ``time`` on; None: it rests at its own coordinates.

        The new motion is in the scene's time, like the old one, and must have the body, at ``time``, where it is: a gap that
        rounding leaves is bridged, a larger jump is an InputError and changes nothing. Events that nearly coincide with
        the last one are processed first; if one of them is the contact, it stays the answer. The motion is relative
        to the body's parent, and bodies attached to it move with it. Raises UndecidedError if the
        state is "undecided".
        """
        places = [k for k, body in enumerate(self._scene.bodies) if body.name == name]
        if not places:
            raise InputError("name", f"there is no body {name!r}", "bodies are called " + _names(self._scene))
        changed = self._scene.with_motion(name, motion)
        with plain_motions():
            self._core.set_motion(places[0], motion_text(motion, *self._scene.time))
        self._scene = changed

    def tiling(self) -> Tiling:
        """The external relative geodesic triangulation at ``time``: pseudo-triangles that fill the space between the
        bodies. Of bodies that overlap or touch at the start it has no edges and faces. Raises UndecidedError if the state
        is "undecided", and InputError unless the scene has two bodies of one ring each: each two rings of others have a
        tiling of their own."""
        names = [body.name for body in self._scene.bodies]
        time, vertices, edges, faces = self._core.tiling()
        return Tiling(
            time, tuple(VertexRef(names[body], index) for body, index, _, _ in vertices),
            tuple((x, y) for _, _, x, y in vertices), tuple(TilingEdge(*edge) for edge in edges),
            tuple(TilingFace(kind, names[body] if kind in ("node", "polygon_interior") else None, depth, tuple(boundary))
                  for kind, body, depth, boundary in faces))

    def __repr__(self) -> str:
        standing = self._core.standing()
        return f"<taut2d.Simulation: {standing.state} at {standing.time!r}, {standing.events} events>"

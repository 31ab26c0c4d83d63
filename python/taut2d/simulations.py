"""Simulations: the kinetic data structure, advanced in time, with plans that may change."""

from __future__ import annotations

import json
from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from typing import Any, Optional

from . import _taut2d
from ._numbers import number, point
from .answers import Contact, Coverage, PairAnswer, VertexRef, _contact, _pair_answer
from .errors import InputError
from .maps import motion_text, plain_motions
from .motions import Angle, Motion, Polynomial
from .options import run_options, scene_text
from .scene import Body, Scene, _names, _plain_places
from .words import FaceKind, SimulationState, Touch

__all__ = ["ContactMotion", "Simulation", "SimulatedContact", "Tiling", "TilingEdge", "TilingFace"]


def _only_motion(text: str) -> Optional[Motion]:
    """Of a scene of one body."""
    return Scene.from_json(text).bodies[0].motion


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


@dataclass(frozen=True)
class ContactMotion:
    """How two bodies move at a contact, in the world's coordinates: each number as (lo, hi), which certainly contains it
    all over Contact.t.

    ``normal``: x and y of the unit normal of the edge, out of its body. ``velocity``: x and y of the velocity of the vertex as
    the edge's body sees it, less what that body's material has there. ``along_normal``: the component of the velocity along the
    normal, negative while the bodies approach.
    """

    normal: tuple[tuple[float, float], tuple[float, float]]
    velocity: tuple[tuple[float, float], tuple[float, float]]
    along_normal: tuple[float, float]


class SimulatedContact:
    """A contact as numbers, which is quicker than Contact, for callbacks of advance_many().

    ``bodies``: the names of the vertex's body and of the edge's. ``indices``: of that vertex, and of the edge, as in
    Contact. ``point``, ``normal``, ``t``: as in Contact.
    """

    __slots__ = ("_core", "_bodies")

    def __init__(self, core: _taut2d.LiveContact, names: list[str]) -> None:
        self._core = core
        self._bodies = names

    @property
    def bodies(self) -> tuple[str, str]:
        """The names of the body of the vertex, and of the body of the edge."""
        vertex, edge = self._core.bodies
        return self._bodies[vertex], self._bodies[edge]

    @property
    def indices(self) -> tuple[int, int]:
        """Of the vertex, and of the edge, in their bodies."""
        return self._core.indices

    @property
    def point(self) -> tuple[float, float]:
        """Where they meet, in the world, rounded."""
        return self._core.point

    @property
    def normal(self) -> tuple[float, float]:
        """The unit normal of the edge, out of its body."""
        return self._core.normal

    @property
    def t(self) -> tuple[float, float]:
        """(lo, hi), which certainly contains the time."""
        return self._core.t


class Simulation:
    """check() online: it has a current time up to which the motion is proved free, and proceeds from there, event by
    event; the motion of a body after that time may be changed.

    A contact stops it: ``state`` is "contact", and ``time`` is the last number up to which the motion is proved free. There
    set_motion() gives bodies other motions from ``time`` on, and resume() goes on. If they still approach, or the rounding of
    their new motions makes them overlap, the next answer is a contact at the same time, and ``contact_again`` says so. Bodies
    that slide along each other go on where touching is no collision. To be free of rounding, move a body off the contact
    by a few units in the last place of its coordinates, along the normal.

    ``scene``: any number of bodies, with parts, holes and parents, and without curves (flatten() makes polygons of these).
    Events are those of all pairs of rings that are near; distant pairs cost nothing. ``touch``, ``max_events``, ``max_seconds``: as in check(); the last
    one is for each call. ``max_contacts_per_time``: the state becomes "undecided" where one pair comes into contact more often than
    this within ``contact_time`` (None: about a millionth of the scene's time), as a ball that bounces lower and lower does. ``record``: keep all
    motions, for record(). Where one of them, Ctrl-C, or the highest precision ends it, ``state`` is "undecided" from then
    on.

    The time only grows. Threads may share a simulation: they take turns. Raises InputError if the scene is not valid.
    """

    def __init__(self, scene: Scene, *, touch: Touch = "open", max_events: Optional[int] = None,
                 max_seconds: Optional[float] = None, max_contacts_per_time: int = 1000,
                 contact_time: Optional[float] = None, record: bool = False) -> None:
        options = run_options(touch, "kinetic", "first", max_seconds, max_events)
        most = int(max_contacts_per_time)
        if most < 0:
            raise InputError("max_contacts_per_time", "the limit is negative", "give a number of contacts, 0 or more")
        within = 0.0 if contact_time is None else number(contact_time, "contact_time")
        with _plain_places():
            self._core = _taut2d.Simulation(scene_text(scene), options, most, within, bool(record))
        # The scene, and what has changed since it was made: bodies in their order, motions, ignored pairs and margins.
        self._scene = scene
        self._is_current = True
        self._now = dict(enumerate(scene.bodies))
        self._changed: dict[str, Optional[Motion]] = {}
        self._ignore = list(scene.ignore)
        self._clearances = list(scene.clearances)
        # Of bodies by their numbers; those that were removed keep theirs.
        self._bodies = [body.name for body in scene.bodies]
        self._places = {name: k for k, name in enumerate(self._bodies)}

    @property
    def scene(self) -> Scene:
        """The scene with the motions that hold from ``time`` on: scene.poses(simulation.time) is where bodies are."""
        for name, motion in self._changed.items():
            place = self._places[name]
            self._now[place] = replace(self._now[place], motion=motion)
        if self._changed or not self._is_current:
            self._changed = {}
            self._is_current = True
            self._scene = replace(self._scene, bodies=list(self._now.values()), ignore=list(self._ignore),
                                  clearances=list(self._clearances))
        return self._scene

    def _place(self, name: str) -> int:
        place = self._places.get(name)
        if place is None:
            raise InputError("name", f"there is no body {name!r}", "bodies are called " + _names(self.scene))
        return place

    @property
    def state(self) -> SimulationState:
        """"running": the tested pairs are free up to ``time``, and there may be more events; "finished": they are proved
        free to the end of the scene; "locked": the same, and the scene ends there because its mechanism locks; "contact": resume()
        goes on; "overlap_at_start"; "undecided": nothing is claimed beyond ``time``, for
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
        """Up to when the motion is proved free. After an event, the upper end of that event's enclosure; where the next one
        nearly coincides with it, a little less. It never decreases."""
        return self._core.standing().time

    @property
    def contact(self) -> Optional[Contact]:
        """The contact, once the state is "contact"."""
        members = self._core.standing().contact
        return _contact(json.loads(members)) if members else None

    @property
    def contact_again(self) -> bool:
        """Whether the contact is one from which the simulation was resumed: the same features, at the same time."""
        return self._core.standing().again

    @property
    def contacts(self) -> int:
        """How many contacts there have been, without those that came again."""
        return self._core.standing().contacts

    @property
    def pair(self) -> Optional[tuple[str, str]]:
        """The two bodies of the contact, or of the overlap; or of what is not decided, if that is one pair of a world."""
        found = self._core.standing().pair
        return (self._bodies[found[0]], self._bodies[found[1]]) if found else None

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
        to the body's parent, and bodies attached to it move with it. After a contact the state stays "contact", and the motion counts
        once resume() is called. Quickest is a Polynomial without a rotation, or with an Angle. Raises UndecidedError if the
        state is "undecided".
        """
        place = self._place(name)
        with plain_motions():
            if (isinstance(motion, Polynomial) and motion.until is None and motion.orbit is None
                    and (motion.rotation is None or isinstance(motion.rotation, Angle))):
                angle = None if motion.rotation is None else motion.rotation.angle
                pivot = (0.0, 0.0) if motion.pivot is None else (motion.pivot[0], motion.pivot[1])
                self._core.set_polynomial(place, motion.x, motion.y, angle, pivot, motion.origin)
            else:
                self._core.set_motion(place, motion_text(motion, *self._scene.time))
        self._changed[name] = motion

    def resume(self) -> SimulationState:
        """Goes on after a contact, usually with other motions: see set_motion(). Time stays; pairs that are still in
        contact, with the motions that they had, are in contact again at once. Returns the state. InputError unless the
        state is "contact"."""
        return self._core.resume()

    def stop(self, name: str, *, gap: float = 0.0) -> None:
        """At a contact, one of its bodies rests from now on, where it is; call resume() then. It is first moved off the
        contact, along its normal, by ``gap``, which covers the rounding of its new motion; 0: 2^-44 of the largest
        coordinate. InputError unless the simulation stands at a contact of that body."""
        self._changed[name] = _only_motion(self._core.stop(self._place(name), number(gap, "gap")))

    def push(self, name: str, *, step: float, hinge: Optional[Sequence[float]] = None,
             direction: Optional[Sequence[float]] = None, gap: float = 0.0) -> None:
        """At a contact, the other body pushes this one, which turns about ``hinge`` or slides along ``direction``, both as
        seen from its parent: it moves evenly for the time ``step``, a sixteenth faster than it is pushed, and then rests
        until it is caught up with, which is the next contact. Assumes friction enough to stop what is not pushed. A body
        that is not pushed, since the two part, goes on. Call resume() then. InputError as of stop(), and where the body does
        not leave the contact that way."""
        if (hinge is None) == (direction is None):
            raise InputError("hinge", "neither a hinge nor a direction is given, or both are", "give one of them")
        about = None if hinge is None else point(hinge, "hinge", "write (x, y)")
        along = (0.0, 0.0) if direction is None else point(direction, "direction", "write (x, y)")
        self._changed[name] = _only_motion(
            self._core.push(self._place(name), about, along, number(step, "step"), number(gap, "gap")))

    def advance_many(self, t: float, on_contact: Callable[[SimulatedContact], Any]) -> SimulationState:
        """Like advance_to(), but calls ``on_contact(contact)`` for every contact, and goes on after it. The function may
        call set_motion() and all else of this simulation but advance_to(), advance_many(), step() and resume(); if it returns False,
        the simulation stays at the contact. Of several pairs in contact at one time it is called for each, and then goes
        on. Returns the state. What the function raises ends the call, at the contact."""
        names = self._bodies
        return self._core.advance_many(number(t, "t"), lambda contact: on_contact(SimulatedContact(contact, names)))

    def add_body(self, body: Body) -> None:
        """Adds a body from ``time`` on, which other bodies must not overlap. This and the next three calls cost what they are
        about: the pairs of the body that are near. In a scene whose bodies have cross-sections on different layers, and for
        a body that is larger than all others, beyond the next power of 2, a call costs what a new simulation does; so does
        set_motion() at the very instant at which a body was added or attached."""
        if not isinstance(body, Body):
            raise InputError("body", f"expected a Body, found {type(body).__name__}", "write Body(name, shape, motion)")
        alone = Scene([replace(body, relative_to=None)], self._scene.time, folder=self._scene.folder)
        with _plain_places():
            place = self._core.add_body(scene_text(alone), body.relative_to or "")
        self._bodies.append(body.name)
        self._places[body.name] = place
        self._now[place] = body
        self._is_current = False

    def remove_body(self, name: str) -> None:
        """Takes a body away from ``time`` on. InputError if another one is attached to it."""
        self._core.remove_body(self._place(name))
        del self._now[self._places.pop(name)]
        self._changed.pop(name, None)
        self._ignore = [pair for pair in self._ignore if name not in pair]
        self._clearances = [own for own in self._clearances if name not in own.pair]
        self._is_current = False

    def ignore(self, a: str, b: str) -> None:
        """The pair is not tested from ``time`` on."""
        self._core.ignore(self._place(a), self._place(b))
        self._ignore.append((a, b))
        self._is_current = False

    def set_parent(self, name: str, parent: Optional[str], motion: Optional[Motion]) -> None:
        """From ``time`` on, the body is attached to ``parent``, or to none, and moves as seen from there. Its place in the
        world at ``time`` must stay, up to a jump like that of set_motion()."""
        place, other = self._place(name), None if parent is None else self._place(parent)
        with plain_motions():
            self._core.set_parent(place, other, motion_text(motion, *self._scene.time))
        self._now[place] = replace(self._now[place], motion=motion, relative_to=parent)
        self._changed.pop(name, None)
        self._is_current = False

    def relative_velocity(self, contact: Optional[Contact] = None) -> ContactMotion:
        """How the bodies of a contact move at that time: of ``contact``, or of one of ``also``. Of the motions that hold
        from ``time`` on, so after set_motion() the new ones. InputError if there is no such contact."""
        which = 0
        if contact is not None and contact != self.contact:
            others = [other.contact for other in self.also]
            if contact not in others:
                raise InputError("contact", "the simulation does not stand at this contact",
                                 "give its contact, or that of one of its also")
            which = 1 + others.index(contact)
        nx, ny, vx, vy, along = self._core.relative_velocity(which)
        return ContactMotion((nx, ny), (vx, vy), along)

    def record(self) -> tuple[Scene, ...]:
        """All that was done until ``time``, as ordinary scenes: one for each stretch of time between two calls of
        add_body(), remove_body(), ignore() or set_parent(), mostly a single one. They are free of contacts: every motion gives
        way to the next one right before it. InputError without ``record=True``."""
        return tuple(Scene.from_json(text) for text in self._core.record())

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

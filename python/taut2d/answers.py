"""Answers: what is known about the first contact, and proofs of it."""

from __future__ import annotations

import json
import os
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Any, Optional, Union

from ._verdict import Undivided, Verdict, bodies_text, instant, names, nothing
from .words import ContactAt, EngineName, OutcomeWord, Touch, VerifiedOutcome

if TYPE_CHECKING:
    from .scene import Scene

__all__ = ["Answer", "Contact", "Coverage", "EdgeRef", "PairAnswer", "Proof", "ProvedCloseness", "VertexRef",
           "Verified"]

Interval = tuple[float, float]
Point = tuple[float, float]


@dataclass(frozen=True)
class VertexRef:
    """Vertex ``index`` of a body, as its shape lists them, from 0: of ring ``ring`` (0 is the outline, k the k-th hole)
    of part ``part``. Of a body bounded by curves it is segment ``index`` of that ring, and ``at``, between 0 and 1, says where
    on it: else None."""

    body: str
    index: int
    part: int = 0
    ring: int = 0
    id: Any = None
    at: Optional[float] = field(default=None, repr=False)


@dataclass(frozen=True)
class EdgeRef:
    """The edge of a body from vertex ``index`` to the next one of the same ring; of curves, as VertexRef has it."""

    body: str
    index: int
    part: int = 0
    ring: int = 0
    id: Any = None
    at: Optional[float] = field(default=None, repr=False)


@dataclass(frozen=True)
class Geometry:
    """How well curves were known: polygons of ``segments`` edges in all were, where it mattered, nowhere farther from them than
    ``tolerance``."""

    tolerance: float
    segments: int


@dataclass(frozen=True)
class Contact:
    """What meets what, when and where.

    ``t``: (lo, hi), which certainly contains the time; a few units in the last place wide, unless ``grazing``.
    ``vertex``, ``edge``: what meets, as the scene names them.
    ``point``: where, in the world's coordinates; ``normal``: the unit normal of the edge, out of its body. Both are
    rounded, good to a few units in the last place.
    ``grazing``: overlapping and touching cannot be told apart all over ``t``.
    ``angle_deg``: of a sweep, (lo, hi), which certainly contains the angle in degrees; else None.
    """

    t: Interval
    vertex: VertexRef
    edge: EdgeRef
    point: Point
    normal: Point
    grazing: bool = False
    angle_deg: Optional[Interval] = None


def meeting_text(contact: Contact) -> str:
    """What meets what, and where."""
    vertex, edge, (x, y) = contact.vertex, contact.edge, contact.point
    kind = "vertex" if vertex.at is None else "segment"
    other = "edge" if edge.at is None else "segment"
    return f"{kind} {vertex.index} of {vertex.body} meets {other} {edge.index} of {edge.body} at ({x:.9g}, {y:.9g})"


@dataclass(frozen=True)
class PairAnswer:
    """What is known of one pair of bodies. ``outcome`` as in Answer; ``free_until`` and ``reason`` are there if it is
    "undecided"."""

    bodies: tuple[str, str]
    outcome: OutcomeWord
    contact: Optional[Contact] = None
    free_until: Optional[float] = None
    reason: Optional[str] = None


@dataclass(frozen=True)
class Coverage:
    """Counts of pairs of bodies: ``pairs`` counts all pairs of the scene and is the sum of the others.

    ``tested``: examined by an engine. ``apart``: kept apart by bounding boxes, as far as the answer goes. Nothing is said
    of the others: ``ignored``: Scene.ignore excludes them; ``moving_alike``: both bodies have the same motion;
    ``at_rest``: neither moves (see Scene.at_rest for these two); ``layers``: they have no layer in common (see Body.z), and
    never meet; ``not_reached``: a limit or an interruption came first.
    """

    pairs: int
    tested: int
    apart: int
    ignored: int
    moving_alike: int
    at_rest: int
    layers: int
    not_reached: int = 0

    @property
    def untested(self) -> int:
        """The number of pairs about which the answer says nothing."""
        return self.ignored + self.moving_alike + self.at_rest + self.layers + self.not_reached


@dataclass(frozen=True)
class Answer(Verdict):
    """What check() found out. str() says it in words; there is no truth value: see ``free`` and ``outcome``.

    ``outcome``: "free", "contact", "overlap_at_start", "undecided", "locked" (free up to right before a mechanism locks), or
    "untested": no pair of bodies was tested, so there is no verdict. "free" and "contact" are proved, of the pairs that ``coverage`` counts as tested or apart.
    ``contact``: the first contact, if the outcome is "contact".
    ``touching``: of a "free" answer with open touching, where the bodies touch for the first time without overlapping.
    ``touching_undecided``: why that is not known, if it is not.
    ``overlap_point``: of "overlap_at_start", a point that certainly lies inside both bodies, where one was found.
    ``free_until``, ``reason``: of "undecided", and of "locked" (see ``lock``), up to when the motion is proved free, and which limit was hit; ``reason``
    also says why nothing was tested.
    ``pair``: the names of the bodies that the outcome is about, unless it is "free" or "untested".
    ``also``: pairs whose first contacts come so close to this one that their order is not told.
    ``coverage``: which pairs the answer is about.
    ``pairs``: with ``pairs="all"``, each pair that was tested.
    ``engine``: who answered; ``events``, ``certificates_initial``, ``certificates_max``: of the kinetic engine.
    ``touch``, ``bodies``, ``time``: what the answer is about.
    ``id``: the id of the scene.
    ``scene``: the Scene that was asked about.
    ``fit``: what bodies were shrunk by, at least, before they were asked about; 0 if they were not.
    ``json``: the answer as ``taut check --json`` prints it, byte for byte, without the line break.
    ``geometry``: of a scene with curves, how well they were known; else None.
    """

    outcome: OutcomeWord
    contact: Optional[Contact]
    touching: Optional[Contact]
    touching_undecided: Optional[str]
    overlap_point: Optional[Point]
    free_until: Optional[float]
    reason: Optional[str]
    pair: Optional[tuple[str, str]]
    also: tuple[PairAnswer, ...]
    coverage: Coverage
    pairs: Optional[tuple[PairAnswer, ...]]
    engine: EngineName
    events: int
    certificates_initial: int
    certificates_max: int
    touch: Touch
    bodies: tuple[str, ...]
    time: Interval
    fit: float
    id: Any
    json: str = field(repr=False)
    scene: Optional[Scene] = field(default=None, repr=False, compare=False)
    geometry: Optional[Geometry] = field(default_factory=nothing)

    _instead = 'answer.free, or answer.outcome == "contact"'

    @property
    def free(self) -> bool:
        """Proved free of collisions over the whole time. "undecided" and "untested" are never free."""
        return self.outcome == "free"

    def _words(self) -> tuple[str, str]:
        if self.outcome == "free":
            do = "overlap" if self.touch == "open" else "touch"
            known = f"{bodies_text(self.coverage)} {do} from t = {self.time[0]!r} to {self.time[1]!r}"
            if self.touching is not None:
                return known, f"bodies first touch at {instant(self.touching.t)}: {meeting_text(self.touching)}"
            undecided = self.touching_undecided
            return known, "" if undecided is None else f"whether bodies touch is undecided: {undecided}"
        if self.contact is None:
            return names(self.pair), ""
        return f"{names(self.pair)} at {instant(self.contact.t)}", meeting_text(self.contact)

    def _undecided_words(self) -> tuple[str, str]:
        about = "" if self.pair is None else names(self.pair)
        if self.free_until is not None and self.free_until > self.time[0]:
            about += f"{', ' if about else ''}free until t = {self.free_until!r}"
        return about, self.reason or ""

    def _repr_html_(self) -> str:
        """What Jupyter shows: the answer in words, and the motion up to there."""
        from .notebook import html_of_answer
        return html_of_answer(self)


class Logged(Undivided):
    """An answer with a log that proves it."""

    answer: Any
    log: bytes

    def save(self, path: Union[str, os.PathLike[str]]) -> None:
        """Writes the log into a file, for ``taut verify``. Raises ValueError if there is none."""
        if not self.log:
            raise ValueError(f"there is no proof: the answer is {self.answer.outcome}")
        with open(path, "wb") as file:
            file.write(self.log)


@dataclass(frozen=True)
class Proof(Logged):
    """An answer with a log that proves it, which verify() and the program taut-verify check.

    ``answer``: as check() gives it. ``log``: the proof; empty if there is nothing to prove, since the bodies overlap at
    the start or nothing was decided. ``scene_sha256``: names what was proved about, the scene's exact numbers and the
    reading of touching.
    """

    answer: Answer
    log: bytes = field(repr=False)
    scene_sha256: str

    _instead = 'proof.answer.outcome == "free", or verify(scene, proof)'


@dataclass(frozen=True)
class ProvedCloseness:
    """Two features that come closer than a clearance: not before the beginning of ``t``, and certainly at its end. The
    second one is ``edge`` or ``other_vertex``."""

    t: Interval
    vertex: VertexRef
    edge: Optional[EdgeRef] = None
    other_vertex: Optional[VertexRef] = None


@dataclass(frozen=True)
class Verified:
    """What a log proves about a scene. It is true, as bool() has it, if the log is valid: that alone says nothing of the
    outcome.

    ``valid``: True: it proves the rest of this. False: it proves nothing, for the ``reason`` given. None: the time was
    up.
    ``outcome``: "free": on the whole interval. "contact": ``contact`` is the first one. "undecided": free before
    ``free_until``, no more.
    ``events``, ``separations``: how long the proof is.
    ``coverage``: which pairs the log proves something about: those counted as tested.
    ``segments``: of a scene with curves, how many edges the polygons around and within the bodies have; else None.
    ``clearance``: None, or the distance that the proof is about: "free" means then that it is kept, and "contact" that
    it is not, as ``closer`` says.
    ``contact_at``: "start", "motion", or "joint": in the jump between two pieces of a motion that rounding leaves.
    """

    valid: Optional[bool]
    reason: Optional[str] = None
    outcome: Optional[VerifiedOutcome] = None
    free_until: Optional[float] = None
    contact: Optional[Contact] = None
    contact_at: Optional[ContactAt] = None
    touch: Optional[Touch] = None
    events: Optional[int] = None
    separations: Optional[int] = None
    scene_sha256: Optional[str] = None
    clearance: Optional[float] = None
    closer: Optional[ProvedCloseness] = None
    segments: Optional[int] = None
    coverage: Optional[Coverage] = None

    def __bool__(self) -> bool:
        return self.valid is True


def _pair(values: list[str]) -> tuple[str, str]:
    return values[0], values[1]


def _floats(values: list[Any]) -> tuple[float, float]:
    """JSON writes a double that is a whole number as such."""
    return float(values[0]), float(values[1])


def _float(value: Any) -> Optional[float]:
    return None if value is None else float(value)


def _contact(object: dict[str, Any]) -> Optional[Contact]:
    """From the members "t", "grazing" and "contact" of an object."""
    if "contact" not in object:
        return None
    c = object["contact"]
    angle = c.get("angle_deg")
    return Contact(_floats(object["t"]), VertexRef(**c["vertex"]), EdgeRef(**c["edge"]), _floats(c["point"]),
                   _floats(c["normal"]), object.get("grazing", False), None if angle is None else _floats(angle))


def _pair_answer(object: dict[str, Any]) -> PairAnswer:
    return PairAnswer(_pair(object["bodies"]), object["outcome"], _contact(object), _float(object.get("free_until")),
                      object.get("reason"))


def answer_from_json(text: str, scene: Optional[Scene] = None) -> Answer:
    """The answer that ``taut check --json`` has printed."""
    return Answer._of(text, _answer_members, scene=scene)


def _answer_members(text: str) -> dict[str, Any]:
    object = json.loads(text)
    scope, certificates = object["scope"], object["certificates"]
    touching = object.get("touching")
    if touching is not None:
        touching = _contact({**touching, "grazing": object.get("grazing", False)})
    pairs = object.get("pairs")
    return {
        "outcome": object["outcome"],
        "contact": _contact(object),
        "touching": touching,
        "touching_undecided": object.get("touching_undecided"),
        "overlap_point": _floats(object["overlap"]["point"]) if "overlap" in object else None,
        "free_until": _float(object.get("free_until")),
        "reason": object.get("reason"),
        "pair": _pair(object["pair"]) if "pair" in object else None,
        "also": tuple(map(_pair_answer, object.get("also", ()))),
        "coverage": Coverage(**object["coverage"]),
        "pairs": None if pairs is None else tuple(map(_pair_answer, pairs)),
        "engine": object["engine"],
        "events": object["events"],
        "certificates_initial": certificates["initial"],
        "certificates_max": certificates["max"],
        "touch": scope["touch"],
        "bodies": tuple(scope["bodies"]),
        "time": _floats(scope["time"]),
        "fit": float(scope.get("fit", 0)),
        "id": object.get("id"),
        "geometry": Geometry(**object["geometry"]) if "geometry" in object else None,
    }


def _log_of(proof: Any, kinds: Any) -> bytes:
    """Of a proof of one of these kinds, the bytes of a log, or the path of a file."""
    if isinstance(proof, kinds):
        return bytes(proof.log)
    if isinstance(proof, (bytes, bytearray, memoryview)):
        return bytes(proof)
    with open(proof, "rb") as file:
        return file.read()


def verified_from_json(text: str) -> Verified:
    """What the library says of a log."""
    object = json.loads(text)
    return Verified(object["valid"], object.get("reason"), object.get("outcome"), _float(object.get("free_until")),
                    _contact(object), object.get("contact_at"), object.get("touch"), object.get("events"),
                    object.get("separations"), object.get("scene_sha256"), _float(object.get("clearance")),
                    _closeness(object.get("closer")), object.get("segments"),
                    Coverage(**object["coverage"]) if "coverage" in object else None)


def _closeness(value: Any) -> Optional[ProvedCloseness]:
    if value is None:
        return None
    edge, other = value.get("edge"), value.get("other_vertex")
    return ProvedCloseness(_floats(value["t"]), VertexRef(**value["vertex"]),
                           None if edge is None else EdgeRef(**edge), None if other is None else VertexRef(**other))

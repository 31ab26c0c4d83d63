"""Ways from a start to a goal, and proofs that there are none."""

from __future__ import annotations

import json
import os
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any, Optional, Union

from . import _taut2d
from ._numbers import number, point
from ._text_form import TextForm
from ._verdict import Verdict, bodies_text, names
from .answers import Coverage, EdgeRef, Logged, VertexRef, _log_of, _pair
from .errors import InputError
from .linkages import EnvelopeCell, Linkage, _cells_from, _plot_cells
from .options import ask
from .scene import Scene, _plain_places, _scene_text
from .words import PathOutcome, Touch

__all__ = ["PathAnswer", "PathLength", "PathProblem", "PathProof", "TightFeatures", "TightPlace", "VerifiedPath", "path", "prove_path", "verify_path"]


@dataclass(frozen=True)
class PathProblem(TextForm):
    """A start, a goal, and what may move in between.

    ``linkage``: bodies and up to four joints; a body that may move in all three ways follows Free.
    ``start``: {"x": 1, "y": 1, "turn": 0}: each joint's value.
    ``goal``: {"x": (8, 9), "y": 7}: values or ranges; joints that are not named are free. Or "outside": the box of each body
    that moves and the box of each that does not have no common interior.
    ``periodic``: names of joints whose period is the length of their range, such as a turn from 0 to 360.
    """

    linkage: Linkage
    start: Mapping[str, float]
    goal: Union[Mapping[str, Union[float, Sequence[float]]], str]
    periodic: Sequence[str] = ()

    def __post_init__(self) -> None:
        if not isinstance(self.linkage, Linkage):
            raise InputError("linkage", f"expected a Linkage, found {type(self.linkage).__name__}")
        if not isinstance(self.start, Mapping):
            raise InputError("start", f"expected a dict, found {type(self.start).__name__}", 'write {"x": 1}')
        object.__setattr__(self, "start", {name: number(v, f"start.{name}") for name, v in self.start.items()})
        if isinstance(self.goal, Mapping):
            object.__setattr__(self, "goal", {
                name: point(v, f"goal.{name}", "write (lowest, highest)") if isinstance(v, Sequence) else number(v, f"goal.{name}")
                for name, v in self.goal.items()})
        elif self.goal != "outside":
            raise InputError("goal", f"expected a dict or \"outside\", found {self.goal!r}", 'write {"x": (8, 9)}')
        object.__setattr__(self, "periodic", tuple(self.periodic))

    def to_json(self) -> str:
        """The problem in the format taut-scene/1, on one line: what ``taut path`` reads."""
        object = json.loads(self.linkage.to_json())
        if self.periodic:
            object["periodic"] = list(self.periodic)
        object["start"] = dict(self.start)
        object["goal"] = self.goal if isinstance(self.goal, str) else {
            name: list(v) if isinstance(v, tuple) else v for name, v in self.goal.items()}
        return json.dumps(object, separators=(",", ":"), ensure_ascii=False, allow_nan=False)

    @classmethod
    def _read(cls, text: str, name: str, folder: Union[str, os.PathLike[str]]) -> PathProblem:
        _taut2d.read_problem(_scene_text(text, name, folder))
        object = json.loads(text)
        return cls(Linkage._read(text, name, folder), object["start"], object["goal"], object.get("periodic", ()))

    def scene(self, waypoints: Sequence[Mapping[str, float]]) -> Scene:
        """An ordinary scene in which the bodies go along waypoints, one unit of time from each to the next: what check()
        and prove() take."""
        rows = [[float(at[joint]) for joint in self.linkage._joint_names()] for at in waypoints]
        with _plain_places():
            text = _taut2d.path_scene(_scene_text(self.to_json(), "scene", self.linkage.folder), rows)
        return Scene.from_json(text, folder=self.linkage.folder)


@dataclass(frozen=True)
class TightFeatures:
    """A vertex and an edge that come together where it is tight, and the distance between the two, rounded; an overlap has
    a distance, too."""

    vertex: VertexRef
    edge: EdgeRef
    distance: float


@dataclass(frozen=True)
class TightPlace:
    """Where it was too tight to decide. ``values``: in a box of joint values that would connect the start and the goal, where
    the bodies are likely to have most room; ``size``: the sides of the box. ``pair``: two bodies that are neither apart nor
    overlapping in it. ``features``: of these at ``values``, the vertex and the edge that are nearest to each other; and then,
    if there are some, the nearest ones that push the bodies the other way: the two sides of a slot."""

    values: Mapping[str, float]
    size: Mapping[str, float]
    pair: tuple[str, str]
    features: tuple[TightFeatures, ...] = ()


@dataclass(frozen=True)
class PathLength:
    """How long a way is. ``way``: its length, rounded up. ``shortest_at_least``: proved: every way from the start to the goal is
    at least as long; rounded down. ``weights``: of each joint: the length of a segment is the square root of the sum of
    (weight times change)^2; a weight is the speed of the fastest vertex of any body at the start, while that joint alone moves at
    speed 1. None if the answer is exact: the length is then that of the way of each point of what moves."""

    way: float
    shortest_at_least: float
    weights: Optional[Mapping[str, float]] = None


@dataclass(frozen=True)
class PathAnswer(Verdict):
    """Is there a way? ``outcome``: "path": along ``waypoints``, between which all joints move evenly; each instant is proved
    free. "none": proved, for ways of any shape within the joints' ranges. "undecided": neither was shown, because it is
    tight at ``tight``, or for another ``reason``. "untested": no pair was tested. ``exact``: only translations were left,
    and exact signs decided. ``length``: of a path, if it was to be short; a ``reason`` says then why it may be longer than
    ``within`` asks for. ``cells``: the partition of all joint values, if it was asked for. ``coverage``: which pairs
    that is about. ``json`` is what ``taut path --json`` prints."""

    outcome: PathOutcome
    waypoints: tuple[Mapping[str, float], ...]
    length: Optional[PathLength]
    tight: Optional[TightPlace]
    exact: bool
    tolerance: float
    cell_count: int
    cells: tuple[EnvelopeCell, ...]
    reason: Optional[str]
    coverage: Coverage
    json: str = field(repr=False, compare=False)
    joints: tuple[str, ...] = field(default=(), repr=False, compare=False)

    _instead = 'answer.outcome == "path"'

    def plot(self, ax: Any = None) -> Any:
        """Draws the cells of two joints by matplotlib, as the search left them, and the way; returns the axes. ``ax``: axes to
        draw into; None makes a new figure. Raises InputError without cells, or for another number of joints."""
        if not self.cells or len(self.cells[0].lo) != 2:
            raise InputError("cells", "there is no partition of two joints to draw", "ask path(..., cells=True)")
        first, second = self.joints
        axes = _plot_cells(self.cells, first, second, "#e4e4e4", ax)
        if self.waypoints:
            axes.plot([at[first] for at in self.waypoints], [at[second] for at in self.waypoints], color="#1f4e9c", label="way")
        return axes

    def _words(self) -> tuple[str, str]:
        if self.outcome == "path":
            n = len(self.waypoints) - 1
            return f"{n} straight segment{'' if n == 1 else 's'} from the start to the goal", f"{bodies_text(self.coverage)} collide on it"
        return "no way leads from the start to the goal", ""

    def _undecided_words(self) -> tuple[str, str]:
        if self.tight is None:
            return "", self.reason or ""
        at = ", ".join(f"{joint} = {value:.9g}" for joint, value in self.tight.values.items())
        return self.reason or "", f"{names(self.tight.pair)} about {at}"


@dataclass(frozen=True)
class PathProof(Logged):
    """An answer with a log that proves it, which verify_path() and the program taut-verify check.

    ``answer``: as path() gives it. ``log``: the proof that there is no way; empty otherwise: a way is proved by
    prove(problem.scene(answer.waypoints)). ``scene_sha256``: names the problem that it is about."""

    answer: PathAnswer
    log: bytes = field(repr=False)
    scene_sha256: str

    _instead = 'proof.answer.outcome == "none", or verify_path(problem, proof)'


@dataclass(frozen=True)
class VerifiedPath:
    """What a log proves about ways. It is true, as bool() has it, if the log is valid.

    ``valid``: True: no way leads from the start to the goal. False: it proves nothing, for the ``reason`` given. None: the
    time was up. ``touch``: "open": no way without overlap; "closed": none without touching. ``clearance``: None, or the
    distance that no way keeps. ``barrier``: of translations, the number of edges of a closed polygon that no way crosses; else
    None. ``cells``, ``colliding``, ``reached``: of the partition of all joint values, 0 if there is none: how many there are,
    how many were shown to collide, and how many of the others a chain leads to from the start. ``scene_sha256``: names the
    problem."""

    valid: Optional[bool]
    reason: Optional[str] = None
    touch: Optional[str] = None
    clearance: Optional[float] = None
    barrier: Optional[int] = None
    cells: Optional[int] = None
    colliding: Optional[int] = None
    reached: Optional[int] = None
    scene_sha256: Optional[str] = None

    def __bool__(self) -> bool:
        return self.valid is True


def _tight_from(value: Any) -> Optional[TightPlace]:
    if value is None:
        return None
    return TightPlace({k: float(v) for k, v in value["values"].items()}, {k: float(v) for k, v in value["size"].items()},
                      _pair(value["pair"]),
                      tuple(TightFeatures(VertexRef(**f["vertex"]), EdgeRef(**f["edge"]), float(f["distance"]))
                            for f in value["features"]))


def _length_from(value: Any) -> Optional[PathLength]:
    if value is None:
        return None
    weights = value.get("weights")
    return PathLength(float(value["way"]), float(value["shortest_at_least"]),
                      None if weights is None else {k: float(v) for k, v in weights.items()})


def _path_from_json(text: str, problem: PathProblem) -> PathAnswer:
    value = json.loads(text)
    waypoints = tuple({k: float(v) for k, v in at.items()} for at in value.get("waypoints", ()))
    return PathAnswer(value["outcome"], waypoints, _length_from(value.get("length")), _tight_from(value.get("tight")), value["exact"], float(value["tolerance"]),
                      value["cell_count"], _cells_from(value), value.get("reason"), Coverage(**value["coverage"]), text, problem.linkage._joint_names())


def path(problem: PathProblem, *, touch: Touch = "open", clearance: float = 0.0, tolerance: float = 1e-4,
         shortest: bool = False, within: float = 0.05, max_cells: int = 4_000_000, cells: bool = False,
         max_seconds: Optional[float] = None) -> PathAnswer:
    """Is there a way from the start to the goal on which nothing collides?

    The answer is a way, each instant of which is proved free, or the proof that there is none. Boxes of joint values are
    divided where they would connect the start and the goal, until they are free or collide for all values in them. Where
    one body only translates, by one slide or two, exact signs decide.

    ``touch``: "open": bodies may touch all of the way; "closed": never. ``clearance``: keep at least this distance all of
    the way, whatever ``touch`` says. ``tolerance``: boxes are divided down to this share of each joint's range, from 1e-9 to
    1. ``shortest``: make the way short, and bound from below how long any way is; ``within``: a way that is at most this share
    longer than that bound is short enough. ``max_cells``, ``max_seconds``: undecided when there are so many boxes, or after so much wall time. ``cells``: hand out
    the boxes. Raises InputError for a problem that makes no sense, and where the start, or a goal that is one combination,
    collides.
    """
    with _plain_places():
        answer, _, _ = ask("path", _problem_text(problem), touch=touch, clearance=clearance, tolerance=tolerance,
                           shortest=shortest, within=within, max_cells=max_cells, cells=cells, max_seconds=max_seconds)
        return _path_from_json(answer, problem)


def _problem_text(problem: PathProblem) -> _taut2d.SceneText:
    if not isinstance(problem, PathProblem):
        raise InputError("problem", f"expected a PathProblem, found {type(problem).__name__}",
                         "PathProblem.load(path) reads a file, and PathProblem(linkage, start, goal) makes one")
    return _scene_text(problem.to_json(), "scene", problem.linkage.folder)


def prove_path(problem: PathProblem, *, touch: Touch = "open", clearance: float = 0.0, tolerance: float = 1e-4,
               max_cells: int = 4_000_000, max_seconds: Optional[float] = None) -> PathProof:
    """As path(), with a log that proves it where there is no way, in memory. Where no log is found that verify_path() accepts,
    the answer is "undecided". Options and errors are those of path()."""
    with _plain_places():
        answer, log, name = ask("prove_path", _problem_text(problem), touch=touch, clearance=clearance, tolerance=tolerance,
                                max_cells=max_cells, max_seconds=max_seconds)
        return PathProof(_path_from_json(answer, problem), log, name)


def verify_path(problem: PathProblem, proof: Union[PathProof, bytes, str, os.PathLike[str]], *,
                max_seconds: Optional[float] = None) -> VerifiedPath:
    """Whether a log proves that there is no way, by a verifier that contains nothing of the search.

    ``proof``: what prove_path() gave, or the bytes of a log, or the path of a file. Raises InputError if the problem is not
    valid, OSError if the file cannot be read; a log that proves nothing is no exception."""
    with _plain_places():
        found, _, _ = ask("verify_path", _problem_text(problem), log=_log_of(proof, PathProof), max_seconds=max_seconds)
    value = json.loads(found)
    value.pop("outcome", None)
    return VerifiedPath(**value)

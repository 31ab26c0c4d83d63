"""Linkages: bodies whose place is given by joint values instead of time, and for which of these they keep apart."""

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
from .answers import Coverage, _pair
from .errors import InputError
from .options import ask
from .pictures import _new_axes
from .scene import Body, Scene, _body_from_json, _plain_places, _scene_text
from .words import AtRest, CellState, QuestionOutcome

__all__ = ["Envelope", "EnvelopeCell", "EnvelopeWitness", "Linkage", "envelope"]


@dataclass(frozen=True)
class Linkage(TextForm):
    """Bodies that follow joints.

    ``bodies``: Body with a motion that is Revolute, Slide, Free, or None; an arm's links are chained by ``relative_to``.
    ``joints``: {"lift": (0, 60), "reach": (0, 2.5)}: one to four names, each with the range of its value, in degrees or
    lengths.
    ``ignore``, ``id``, ``folder``, ``at_rest``: as of a Scene; bodies are at rest relative to each other that no joint moves
    against each other.
    ``mechanism``: as of a Scene, but its "drive" gives ranges, {"A": (0, 90)}: driven joints come after ``joints``, which may
    be empty then. Where several of them move one loop, combinations at which it may lock are undecided.
    """

    bodies: Sequence[Body]
    joints: Mapping[str, Sequence[float]] = field(default_factory=dict)
    ignore: Sequence[Sequence[str]] = ()
    id: Any = None
    folder: Union[str, os.PathLike[str]] = field(default=".", compare=False)
    at_rest: AtRest = "skip"
    mechanism: Optional[Mapping[str, Any]] = None

    def __post_init__(self) -> None:
        # What a scene looks at, with a time that means nothing.
        scene = Scene(self.bodies, (0, 0), self.ignore, self.id, self.folder, self.at_rest)
        if not isinstance(self.joints, Mapping):
            raise InputError("joints", f"expected a dict, found {type(self.joints).__name__}",
                             'write {"lift": (0, 60)}')
        for name in ("bodies", "ignore", "folder"):
            object.__setattr__(self, name, getattr(scene, name))
        object.__setattr__(self, "joints", {name: point(range, f"joints.{name}", "write (lowest, highest)") for name, range in self.joints.items()})

    def to_json(self) -> str:
        """The linkage in the format taut-scene/1, on one line: what ``taut envelope`` reads."""
        object = json.loads(Scene(self.bodies, (0, 0), self.ignore, self.id, at_rest=self.at_rest).to_json())
        del object["time"]
        if self.joints or self.mechanism is None:
            object["joints"] = {name: list(range) for name, range in self.joints.items()}
        if self.mechanism is not None:
            object["mechanism"] = self.mechanism
        return json.dumps(object, separators=(",", ":"), ensure_ascii=False, allow_nan=False)

    @classmethod
    def _read(cls, text: str, name: str, folder: Union[str, os.PathLike[str]]) -> Linkage:
        _taut2d.read_linkage(_scene_text(text, name, folder))
        object = json.loads(text)
        return cls([_body_from_json(body) for body in object["bodies"]], object.get("joints", {}), object.get("ignore", ()),
                   object.get("id"), folder, object.get("at_rest", "skip"), object.get("mechanism"))

    def _joint_names(self) -> tuple[str, ...]:
        """In the order in which answers have them."""
        return (*self.joints, *(self.mechanism["drive"] if self.mechanism is not None else ()))


@dataclass(frozen=True)
class EnvelopeCell:
    """A box of joint values, from ``lo[k]`` to ``hi[k]`` of joint k. ``state``: "free": for all values in it no pair
    touches; "colliding": for all, the interiors of ``pair`` overlap; "undecided": neither was shown before the box became
    as small as the tolerance. ``may_lock``: of an undecided one, that is not because of a pair but of a mechanism that may
    lock in it, or does not get there. ``reached``: where there is no way, cells that were not shown to collide lead here from
    the start."""

    state: CellState
    lo: tuple[float, ...]
    hi: tuple[float, ...]
    pair: Optional[tuple[str, str]] = None
    may_lock: bool = False
    reached: bool = False


@dataclass(frozen=True)
class EnvelopeWitness:
    """A combination, by the joints' names, at which the two bodies of ``pair`` overlap."""

    values: Mapping[str, float]
    pair: tuple[str, str]


@dataclass(frozen=True)
class Envelope(Verdict):
    """For which combinations bodies keep apart. ``outcome``: "free": for every one, proved. "contact": not for the one in
    ``witness``. "undecided": none was found that collides, and not all were shown to be free. "untested": no pair was
    tested. ``coverage``: which pairs that is about. ``free``, ``colliding``,
    ``undecided``: shares of all combinations; ``may_lock``: that of ``undecided`` at which a mechanism may lock, or to
    which it does not get. ``other_poses``: cells are decided for one pose of the mechanism, and other ways without a lock,
    through undecided cells, may lead to another pose at the same values. ``cells``: a partition of them, if it was asked for. ``reason``: why it
    ended early. ``json`` is what ``taut envelope --json`` prints."""

    outcome: QuestionOutcome
    witness: Optional[EnvelopeWitness]
    free: float
    colliding: float
    undecided: float
    may_lock: float
    other_poses: bool
    tolerance: float
    cells: tuple[EnvelopeCell, ...]
    reason: Optional[str]
    coverage: Coverage
    json: str = field(repr=False, compare=False)

    def _words(self) -> tuple[str, str]:
        shares = f"free {self.free:.4%}, colliding {self.colliding:.4%}, undecided {self.undecided:.4%} of all combinations"
        if self.witness is None:
            return f"{bodies_text(self.coverage)} touch for any combination", shares
        at = ", ".join(f"{joint} = {value:.9g}" for joint, value in self.witness.values.items())
        return f"{names(self.witness.pair)} overlap at {at}", shares

    def _undecided_words(self) -> tuple[str, str]:
        return "" if self.outcome == "untested" else self._words()[1], self.reason or ""

    def plot(self, ax: Any = None) -> Any:
        """Draws the cells of two joints by matplotlib, and returns the axes. ``ax``: axes to draw into; None makes a new
        figure. Raises InputError without cells, or for another number of joints."""
        if not self.cells or len(self.cells[0].lo) != 2:
            raise InputError("cells", "there is no partition of two joints to draw", "ask envelope(..., cells=True)")
        first, second = (joint["name"] for joint in json.loads(self.json)["joints"])
        axes = _plot_cells(self.cells, first, second, "#4a4a4a", ax)
        if self.witness is not None:
            axes.plot([self.witness.values[first]], [self.witness.values[second]], "o", color="#7d130a",
                      markerfacecolor="white", label="witness")
        return axes


def _plot_cells(cells: Sequence[EnvelopeCell], first: str, second: str, undecided: str, ax: Any) -> Any:
    """Into axes, which are returned."""
    axes = _new_axes(ax)
    from matplotlib.collections import PolyCollection

    for state, colour in (("free", "#bfe3c6"), ("colliding", "#d98a80"), ("undecided", undecided)):
        boxes = [[(c.lo[0], c.lo[1]), (c.hi[0], c.lo[1]), (c.hi[0], c.hi[1]), (c.lo[0], c.hi[1])]
                 for c in cells if c.state == state]
        axes.add_collection(PolyCollection(boxes, facecolors=colour, edgecolors=colour, linewidths=0.3, label=state))
    axes.autoscale_view()
    axes.set_xlabel(first)
    axes.set_ylabel(second)
    return axes


def _cells_from(value: Any) -> tuple[EnvelopeCell, ...]:
    return tuple(EnvelopeCell(c["state"], tuple(map(float, c["lo"])), tuple(map(float, c["hi"])),
                              _pair(c["pair"]) if "pair" in c else None, "may_lock" in c, "reached" in c) for c in value.get("cells", ()))


def _envelope_from_json(text: str) -> Envelope:
    value = json.loads(text)
    witness = value["witness"]
    cells = _cells_from(value)
    return Envelope(value["outcome"],
                    None if witness is None else EnvelopeWitness({name: float(x) for name, x in witness["values"].items()},
                                                                 _pair(witness["pair"])),
                    float(value["free"]), float(value["colliding"]), float(value["undecided"]),
                    float(value.get("may_lock", 0)), "other_poses" in value, float(value["tolerance"]), cells, value.get("reason"), Coverage(**value["coverage"]), text)


def envelope(linkage: Linkage, *, tolerance: float = 1e-3, cells: bool = False,
             max_seconds: Optional[float] = None) -> Envelope:
    """For which combinations of joint values do bodies keep apart?

    Divides all combinations into boxes that are free, that collide, and small ones of which that is not shown: the border
    between the two, and bodies that touch without overlap. What is said of a box is proved for every combination in it.
    Every two bodies are asked about that are not ignored and not fixed to each other.

    ``tolerance``: boxes are divided down to this share of each joint's range, from 1e-6 to 1. ``cells``: hand out the
    boxes, in Envelope.cells. ``max_seconds``: stop dividing after so much wall time; large boxes are looked at first.
    Raises InputError for joints, motions and shapes that make no sense.
    """
    if not isinstance(linkage, Linkage):
        raise InputError("linkage", f"expected a Linkage, found {type(linkage).__name__}",
                         "Linkage.load(path) reads a file, and Linkage(bodies, joints) makes one")
    with _plain_places():
        text = _scene_text(linkage.to_json(), "scene", linkage.folder)
        answer, _, _ = ask("envelope", text, tolerance=tolerance, cells=cells, max_seconds=max_seconds)
        return _envelope_from_json(answer)

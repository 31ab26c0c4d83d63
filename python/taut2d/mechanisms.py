"""How a mechanism moves: ranges of its joints, transmission angles, and locks."""

from __future__ import annotations

import json
from dataclasses import dataclass, field
from typing import Any, Optional

from ._verdict import Lock, Undivided, lock_from
from .options import ask, asked_scene
from .scene import Scene, _plain_places
from .words import MechanismOutcome

__all__ = ["Extreme", "JointRange", "Lock", "MechanismMotion", "TransmissionAngle", "mechanism"]


@dataclass(frozen=True)
class Extreme:
    """An extreme of a function of time: it is in [lo, hi], and a value in there is taken at ``t``."""

    lo: float
    hi: float
    t: float


@dataclass(frozen=True)
class JointRange:
    """What a joint does. ``bodies``: values are those of the second one as the first one sees it, and 0 in the drawn pose.
    ``unit``: "degrees" or "length"."""

    joint: str
    bodies: tuple[str, str]
    unit: str
    least: Extreme
    greatest: Extreme


@dataclass(frozen=True)
class TransmissionAngle:
    """The angle at which two links meet at the pin that closes a loop, in degrees, at most 90. At 0 they are in line."""

    joint: str
    links: tuple[str, str]
    least: Extreme
    greatest: Extreme


@dataclass(frozen=True)
class MechanismMotion(Undivided):
    """What mechanism() found out. ``outcome``: "moves" to the end of the time; "locked" before, see ``lock``; "undecided",
    see ``reason``. ``mobility``: independent ways to move; ``loops``: closed loops. ``instants``, ``values``: of each instant
    that was asked for, the values of all joints in order, as (lo, hi). ``json`` is what ``taut mechanism --json`` prints."""

    outcome: MechanismOutcome
    reason: Optional[str]
    mobility: int
    loops: int
    joints: tuple[JointRange, ...]
    transmission: tuple[TransmissionAngle, ...]
    lock: Optional[Lock]
    instants: tuple[float, ...]
    values: tuple[tuple[tuple[float, float], ...], ...]
    json: str = field(repr=False, compare=False)

    _instead = 'motion.outcome == "moves"'

    def __str__(self) -> str:
        known = f"{self.outcome}: mobility {self.mobility}, {self.loops} loop{'' if self.loops == 1 else 's'}"
        if self.lock is not None:
            known += f"\n{self.lock.kind} at t in {list(self.lock.t)}: {', '.join(self.lock.links)} in line"
        return known if self.reason is None else f"{known}\n{self.reason}"


def _extreme(value: Any) -> Extreme:
    return Extreme(float(value["lo"]), float(value["hi"]), float(value["t"]))


def mechanism(scene: Scene, *, instants: int = 0, max_seconds: Optional[float] = None) -> MechanismMotion:
    """How the scene's mechanism moves, up to the end of the time or a lock. Every number is an enclosure.

    ``instants``: at how many instants, evenly over the time, all joint values are listed; 0, or 2 at least.
    Errors are those of check(); InputError for a scene without a mechanism.
    """
    with _plain_places():
        text, _, _ = ask("mechanism", asked_scene(scene), instants=instants, max_seconds=max_seconds)
    value = json.loads(text)
    joints = tuple(JointRange(j["joint"], (j["bodies"][0], j["bodies"][1]), j["unit"], _extreme(j["least"]), _extreme(j["greatest"]))
                   for j in value["joints"])
    angles = tuple(TransmissionAngle(a["joint"], (a["links"][0], a["links"][1]), _extreme(a["least"]), _extreme(a["greatest"]))
                   for a in value["transmission"])
    rows = value.get("instants", ())
    return MechanismMotion(value["outcome"], value.get("reason"), value["mobility"], value["loops"], joints, angles,
                           lock_from(value.get("lock")), tuple(float(row["t"]) for row in rows),
                           tuple(tuple((float(v[0]), float(v[1])) for v in row["values"]) for row in rows), text)

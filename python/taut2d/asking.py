"""What can be asked about a scene."""

from __future__ import annotations

import os
from typing import Any, Optional, Union

from ._numbers import number
from .answers import Answer, Proof, Verified, answer_from_json, verified_from_json
from .directions import Separation, separation_from_json
from .errors import InputError
from .margins import MarginAnswer, MarginProof, margin_from_json
from .options import ask, scene_text
from .questions import (Clearance, DistanceProfile, Intervals, Range, clearance_from_json, intervals_from_json,
                        profile_from_json, range_from_json)
from .scene import Scene, _plain_places
from .words import Engine, Pairs, Touch

__all__ = ["check", "check_clearance", "clearance", "distance_profile", "intervals", "prove", "prove_clearance", "range",
           "separate", "verify"]


def check(scene: Scene, *, touch: Touch = "open", engine: Engine = "usual", pairs: Pairs = "first",
          max_seconds: Optional[float] = None, max_events: Optional[int] = None, fit: Optional[float] = None,
          time_tolerance: float = 1e-9) -> Answer:
    """Decides whether and when bodies of the scene first collide.

    ``touch``: "open": bodies collide when their interiors overlap, and may touch; "closed": touching counts.
    ``engine``: "kinetic", "spacetime", "both" (compared), "either" (in turn; the first answer), or "usual": either,
    of a world for each pair, and the kinetic one where ``max_events`` limits two polygons.
    ``pairs``: "first": up to the first contact of any pair; "all": each pair's own first contact, in Answer.pairs.
    ``max_seconds``, ``max_events``: stop with "undecided" after so much wall time, or so many events of the kinetic
    engine; None is no limit.
    ``fit``: if given, bodies are shrunk on each side by between ``fit`` and twice as much first, in the scene's units, so
    that what overlaps by rounding does not; the answer is about the shrunk bodies, and says so.
    ``time_tolerance``: of a scene with curves, how wide the time of a contact may be, as a share of the scene's time.

    "free" and "contact" are proofs for every instant of the scene's time. The same scene gives the same answer
    everywhere, unless ``max_seconds`` ends it. Raises InputError if the scene or an option is not valid, InternalError
    for a defect of taut, KeyboardInterrupt on Ctrl-C.
    """
    with _plain_places():
        answer, _, _ = ask("check", scene_text(scene), touch=touch, engine=engine, pairs=pairs, max_seconds=max_seconds,
                           max_events=max_events, fit=fit, time_tolerance=time_tolerance)
        return answer_from_json(answer, scene)


def intervals(scene: Scene, *, touch: Touch = "open", max_seconds: Optional[float] = None) -> Intervals:
    """All maximal intervals of time in which bodies of the scene overlap, for each pair that is asked about.

    ``touch``: with "open", an instant at which bodies only touch is no interval; with "closed" it is one.
    ``max_seconds``: pairs that are not done by then are listed as undecided. Errors are those of check().
    """
    with _plain_places():
        answer, _, _ = ask("intervals", scene_text(scene), touch=touch, max_seconds=max_seconds)
        return intervals_from_json(answer)


def range(scene: Scene, around: float, *, touch: Touch = "open", max_seconds: Optional[float] = None) -> Range:
    """The maximal interval of time around an instant in which no two bodies that are asked about overlap.

    Raises InputError if the instant is outside of the scene's time, or bodies overlap then; else as check().
    """
    with _plain_places():
        at: dict[str, Any] = {"from": number(around, "around")}
        answer, _, _ = ask("range", scene_text(scene), touch=touch, max_seconds=max_seconds, **at)
        return range_from_json(answer)


def clearance(scene: Scene, *, tolerance: float = 1e-9, pairs: Pairs = "first",
              max_seconds: Optional[float] = None) -> Clearance:
    """How close bodies come over the scene's time: a bracket that certainly holds the least distance of their closures.

    ``tolerance``: how wide the bracket may be, as a share of it, and 1e-12 of the largest coordinate besides.
    ``pairs``: "first": of the pair that comes closest; "all": of each pair, in Clearance.pairs. Errors are those of
    check().
    """
    with _plain_places():
        answer, _, _ = ask("clearance", scene_text(scene), tolerance=tolerance, pairs=pairs, max_seconds=max_seconds)
        return clearance_from_json(answer)


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
        answer, _, _ = ask("distance_profile", scene_text(scene), instants=instants, tolerance=tolerance, pairs=pairs,
                           max_seconds=max_seconds)
        return profile_from_json(answer)


def check_clearance(scene: Scene, clearance: float, *, touch: Touch = "open", pairs: Pairs = "first",
                    max_seconds: Optional[float] = None) -> MarginAnswer:
    """Do all bodies keep this distance, in the scene's units, and if not, when and where do they first come closer?

    ``clearance`` must be positive. ``touch``: bodies that come to the clearance and no closer, or stay at it, are free
    if it is "open", and in contact if it is "closed". ``pairs``: "first": up to the first pair that comes closer; "all":
    each pair on its own, in MarginAnswer.pairs. "free" is proved, and so is the time of a contact. Errors are those of
    check().
    """
    with _plain_places():
        answer, _, _ = ask("check_clearance", scene_text(scene), clearance=number(clearance, "clearance"), touch=touch,
                           pairs=pairs, max_seconds=max_seconds)
        return margin_from_json(answer)


def separate(scene: Scene, *, travel: Optional[float] = None, max_seconds: Optional[float] = None) -> Separation:
    """In which directions bodies come apart, and in which order an assembly does.

    Bodies stand as at the start of the scene's time; each is moved straight, without turning, as far as ``travel``
    (in the scene's units, > 0; None: any distance), and must overlap nothing on the way, where touching is allowed, at
    the travel's end, too. Of two bodies, the second one moves. Errors are those of check().
    """
    with _plain_places():
        answer, _, _ = ask("separate", scene_text(scene), travel=travel, max_seconds=max_seconds)
        return separation_from_json(answer)


def prove(scene: Scene, *, touch: Touch = "open", engine: Engine = "usual", max_seconds: Optional[float] = None,
          max_events: Optional[int] = None) -> Proof:
    """As check(), with a log that proves the answer, in memory.

    ``engine``: of two plain bodies, "kinetic" gives the way of a tiling, about 13 bytes an event, "spacetime" what
    separates the bodies, "either", which is "usual", the proof of the engine that answers first, "both" that of the
    kinetic one, compared with the other. Of worlds it is what separates the bodies. Of bodies with curves it is polygons around and within them,
    and proofs about these. Other options and errors are those of check(). An
    undecided run proves what it has done.
    """
    with _plain_places():
        answer, log, name = ask("prove", scene_text(scene), touch=touch, engine=engine, max_seconds=max_seconds,
                                max_events=max_events)
    return Proof(answer_from_json(answer, scene), log, name)


def prove_clearance(scene: Scene, clearance: float, *, touch: Touch = "open",
                    max_seconds: Optional[float] = None) -> MarginProof:
    """As check_clearance(), with a log that proves the answer, in memory. Options and errors are those of
    check_clearance()."""
    with _plain_places():
        answer, log, name = ask("prove_clearance", scene_text(scene), clearance=number(clearance, "clearance"),
                                touch=touch, max_seconds=max_seconds)
    return MarginProof(margin_from_json(answer), log, name)


def verify(scene: Scene, proof: Union[Proof, MarginProof, bytes, str, os.PathLike[str]], *,
           max_seconds: Optional[float] = None) -> Verified:
    """What a log proves about a scene, by a verifier that contains neither engine.

    ``proof``: what prove() or prove_clearance() gave, or the bytes of a log, or the path of a file. The result is true where the log is valid;
    its outcome says what is proved. Raises InputError if the scene is not valid, OSError if the file cannot be read,
    KeyboardInterrupt on Ctrl-C; a log that proves nothing is no exception.
    """
    if isinstance(proof, (Proof, MarginProof)):
        log = proof.log
    elif isinstance(proof, (bytes, bytearray, memoryview)):
        log = bytes(proof)
    else:
        with open(proof, "rb") as file:
            log = file.read()
    with _plain_places():
        found, _, _ = ask("verify", scene_text(scene), log=log, max_seconds=max_seconds)
        return verified_from_json(found)

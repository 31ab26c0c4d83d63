"""When bodies of a scene first collide, the proof of it, and its check."""

from __future__ import annotations

import os
from typing import Optional, Union

from .answers import Answer, Proof, Verified, _log_of, answer_from_json, verified_from_json
from .margins import MarginProof
from .options import ask, asked_scene, scene_text
from .scene import Scene, _plain_places
from .words import Engine, Pairs, Touch

__all__ = ["check", "prove", "verify"]


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
        answer, _, _ = ask("check", asked_scene(scene), touch=touch, engine=engine, pairs=pairs, max_seconds=max_seconds,
                           max_events=max_events, fit=fit, time_tolerance=time_tolerance)
        return answer_from_json(answer, scene)


def prove(scene: Scene, *, touch: Touch = "open", engine: Engine = "usual", max_seconds: Optional[float] = None,
          max_events: Optional[int] = None, exact: bool = False) -> Proof:
    """As check(), with a log that proves the answer, in memory.

    ``engine``: of two plain bodies, "kinetic" gives the way of a tiling, about 13 bytes an event, "spacetime" what
    separates the bodies, "either", which is "usual", the proof of the engine that answers first, "both" that of the
    kinetic one, compared with the other. Of worlds it is what separates the bodies. Of bodies with curves it is polygons around and within them,
    and proofs about these. Other options and errors are those of check(). An
    undecided run proves what it has done.
    ``exact``: the log is an exact one, for taut-verified, a checker that is proved itself. Touching counts, whatever
    ``touch`` says; the log, JSON, ends before a contact: its "until". Where bodies have no room between them, or the
    scene has curves or a mechanism, there is none.
    """
    with _plain_places():
        answer, log, name = ask("prove", scene_text(scene) if exact else asked_scene(scene), touch=touch, engine=engine, max_seconds=max_seconds,
                                max_events=max_events, exact=exact)
    return Proof(answer_from_json(answer, scene), log, name)


def verify(scene: Scene, proof: Union[Proof, MarginProof, bytes, str, os.PathLike[str]], *,
           max_seconds: Optional[float] = None) -> Verified:
    """What a log proves about a scene, by a verifier that contains neither engine.

    ``proof``: what prove() or prove_clearance() gave, or the bytes of a log, or the path of a file. The result is true where the log is valid;
    its outcome says what is proved. Raises InputError if the scene is not valid, OSError if the file cannot be read,
    KeyboardInterrupt on Ctrl-C; a log that proves nothing is no exception.
    """
    log = _log_of(proof, (Proof, MarginProof))
    with _plain_places():
        found, _, _ = ask("verify", asked_scene(scene), log=log, max_seconds=max_seconds)
        return verified_from_json(found)

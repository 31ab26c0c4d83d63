"""Maps: one body among many that rest, prepared once and asked often."""

from __future__ import annotations

import json
from collections.abc import Iterable
from dataclasses import replace
from typing import TYPE_CHECKING, Any, Optional

from . import _taut2d
from ._numbers import number, numpy_for
from .answers import Answer, answer_from_json
from .errors import InputError
from .many import answer_dtype, thread_count
from .motions import Motion
from .options import run_options
from .scene import Body, Scene, _motions, _plain_places, _scene_text, _unnamed
from .variants import KeyframeRows, VelocityRows, _array
from .words import Touch

if TYPE_CHECKING:
    import numpy

    from .many import Answers

    Places = numpy.ndarray[Any, numpy.dtype[numpy.signedinteger[Any]]]

__all__ = ["Mover", "StaticMap"]

# What stands for the mover's shape where its motion alone is looked at.
_TRIANGLE = [[0, 0], [1, 0], [0, 1]]


def motion_text(motion: Optional[Motion], start: float, end: float) -> _taut2d.SceneText:
    """A scene that has nothing but this motion, on that time."""
    if motion is not None and not isinstance(motion, _motions):
        raise InputError("motion", f"expected a motion, found {type(motion).__name__}",
                         "write Keyframes, Sweep, Velocity, Polynomial, Pieces or CsvKeyframes, or None")
    body: dict[str, Any] = {"name": "it", "polygon": _TRIANGLE}
    if motion is not None:
        body["motion"] = motion._json()
    scene = {"format": "taut-scene/1", "time": [start, end], "bodies": [body]}
    return _scene_text(json.dumps(scene), _unnamed, ".")


class plain_motions(_plain_places):
    """As _plain_places, where the body whose motion it is goes without saying."""

    def __exit__(self, kind: Any, error: Any, trace: Any) -> None:
        try:
            super().__exit__(kind, error, trace)
        except InputError as plain:
            error = plain
        if isinstance(error, InputError):
            place = error.place.replace("bodies[0].", "")
            raise InputError("" if place == "it" else place, error.problem, error.hint) from None


class Mover:
    """A shape that moves among the bodies of a map: what StaticMap.prepare() returns. Immutable; threads may share it."""

    def __init__(self, core: _taut2d.MapMover, body: Body, names: tuple[str, ...]) -> None:
        self._core = core
        self._names = names
        # The names as a scope in JSON has them.
        self._json = json.dumps(names, separators=(",", ":"), ensure_ascii=False)[1:-1]
        self.body = body

    @property
    def name(self) -> str:
        """What answers call it."""
        return self.body.name

    def __repr__(self) -> str:
        return f"<taut2d.Mover {self.name!r}>"


class StaticMap:
    """Bodies at rest, prepared for questions about bodies that move among them: a floor plan, a city, the obstacles of a
    planner.

    ``bodies``: each a Body without a motion, a parent and curves (flatten() makes polygons of these); their names differ.
    Each is validated as in a scene, and prepared when something first comes near it.
    ``reach``: shapes of movers may have coordinates of their own up to this magnitude, in the map's units; those of the
    map they may always have.

    A question answers as check() does about the scene of the map's bodies, in their order, and the moving body after
    them (see scene()): first contact, witness, enclosures, "free" as a proof, all of it the same, without looking at what
    is far away. Immutable; threads may share it, and the interpreter is free while the library works. Raises InputError.
    """

    def __init__(self, bodies: Iterable[Body], reach: float = 0.0) -> None:
        given = (bodies,) if isinstance(bodies, Body) else tuple(bodies)
        with _plain_places():
            self._core = _taut2d.StaticMap(Scene(given, (0, 0))._text(), number(reach, "reach"))
        self.bodies: tuple[Body, ...] = given

    def __len__(self) -> int:
        return len(self.bodies)

    def __repr__(self) -> str:
        return f"<taut2d.StaticMap of {len(self)} bodies>"

    def prepare(self, shape: Any, name: str = "mover") -> Mover:
        """Prepares a shape to move in this map: O(n log n) in its vertices, once.

        ``shape``: what Body takes; or a Body, whose name is taken, and whose motion and parent are not looked at.
        ``name``: what answers call it; no body of the map has it. Raises InputError, also where the shape's own
        coordinates are beyond the map's ``reach``.
        """
        body = Body(shape.name, shape.shape, id=shape.id, z=shape.z) if isinstance(shape, Body) else Body(name, shape)
        if any(body.name == other.name for other in self.bodies):
            raise InputError(body.name, "a body of the map has the same name", "give the mover another one")
        with _plain_places():
            core = _taut2d.StaticMap.prepare(self._core, Scene([body], (0, 0))._text())
        return Mover(core, body, (*(other.name for other in self.bodies), body.name))

    def scene(self, mover: Mover, motion: Optional[Motion], start: float, end: float) -> Scene:
        """The scene that check() with these arguments is about: to draw it, to prove it, to ask anything else."""
        moving = replace(mover.body, motion=motion)
        return Scene((*self.bodies, moving), (start, end))

    def check(self, mover: Mover, motion: Optional[Motion], start: float, end: float, *, touch: Touch = "open",
              max_seconds: Optional[float] = None) -> Answer:
        """Does the mover, on this motion, first meet anything on [``start``, ``end``], what, and when?

        ``motion``: as of a Body, in the map's units; None: it rests at its own coordinates. ``touch``, ``max_seconds``:
        as in taut2d.check().

        The answer is that of taut2d.check() with the engine "spacetime" about scene(mover, motion, start, end), in which
        the mover is asked about even if it rests. Answer.coverage counts the pairs of the mover and a body of the map;
        Answer.scene is None. Raises InputError if
        the motion is not valid on that time, or the mover was prepared for another map; KeyboardInterrupt on Ctrl-C.
        """
        options = run_options(touch, "spacetime", "first", max_seconds, None)
        text = motion_text(motion, number(start, "start"), number(end, "end"))
        with plain_motions():
            before, after = self._core.check(_mover(mover)._core, text, options)
        answer = answer_from_json(before + after)
        return replace(answer, bodies=mover._names, json=before + mover._json + after)

    def overlapped(self, mover: Mover, motion: Optional[Motion], t: float, *, touch: Touch = "open") -> Optional[str]:
        """The name of a body of the map that the mover overlaps, or with ``touch="closed"`` touches, where its motion has
        it at time ``t``; of several, the first in the map; None if the placement is free.

        Decided exactly. Raises InputError if the motion is not valid there, UndecidedError where the highest precision
        does not tell.
        """
        options = run_options(touch, "spacetime", "first", None, None)
        when = number(t, "t")
        with plain_motions():
            found = self._core.overlapped(_mover(mover)._core, motion_text(motion, when, when), options)
        return None if found is None else self.bodies[found].name

    def check_many(self, mover: Mover, motions: Any, start: Any, end: Any, *, touch: Touch = "open",
                   threads: Optional[int] = None, max_seconds: Optional[float] = None) -> Answers:
        """check() of many motions, on all processors: an array of answer_dtype(), as taut2d.check_many() gives it.

        ``motions``: KeyframeRows, VelocityRows, or an array that KeyframeRows takes. ``start``, ``end``: numbers, or an
        array (rows,) each. In the answers, bodies are those of the map by their place in it, and len(map) is the mover.
        ``threads``: how many; None is one for each processor; answers are the same for any number. ``max_seconds``: for
        each row. Raises InputError as check() does, and names the first row at fault.
        """
        numpy = numpy_for("check_many()")
        options = run_options(touch, "spacetime", "first", max_seconds, None)
        count = thread_count(threads)
        rows = motions if isinstance(motions, (KeyframeRows, VelocityRows)) else KeyframeRows(motions)
        times = _array(numpy.stack([_column(start, "start", len(rows)), _column(end, "end", len(rows))], axis=1), "start",
                       "(rows,)", lambda shape: True)
        table = _taut2d.MapRows(len(rows))
        rows._add(table, 0)
        table.times(times)
        answers: Answers = numpy.zeros(len(rows), answer_dtype())
        with plain_motions():
            self._core.check_rows(_mover(mover)._core, table, options, count, answers)
        return answers

    def overlapped_many(self, mover: Mover, placements: Any, *, touch: Touch = "open",
                        threads: Optional[int] = None) -> Places:
        """overlapped() of many placements: for each the place in the map of the first body that the mover overlaps, or
        -1.

        ``placements``: an array (rows, 3) of x, y and the angle in degrees, about the mover's own origin, or (rows, 2),
        without the angle. Errors are those of overlapped(), and name the first row at fault.
        """
        numpy = numpy_for("overlapped_many()")
        options = run_options(touch, "spacetime", "first", None, None)
        count = thread_count(threads)
        given = _array(placements, "placements", "(rows, 2 or 3)",
                       lambda shape: len(shape) == 2 and shape[1] in (2, 3))
        poses = numpy.zeros((len(given), 3))
        poses[:, :given.shape[1]] = given
        found = numpy.zeros(len(given))
        with plain_motions():
            self._core.overlapped_rows(_mover(mover)._core, poses, len(given), options, count, found)
        places: Places = found.astype(int)
        return places


def _mover(given: Any) -> Mover:
    if not isinstance(given, Mover):
        raise InputError("mover", f"expected a Mover, found {type(given).__name__}", "map.prepare(shape) makes one")
    return given


def _column(value: Any, place: str, rows: int) -> Any:
    """One number for each row, of one for all, or of an array."""
    numpy = numpy_for("check_many()")
    found = _array(value, place, f"() or ({rows},)", lambda shape: shape in ((), (1,), (rows,)))
    return numpy.broadcast_to(found, rows)

"""Many checks at once: arrays in, an array of answers out, on several threads."""

from __future__ import annotations

import enum
import os
from collections.abc import Iterable, Mapping, Sequence
from typing import TYPE_CHECKING, Any, Optional, Union

from . import _taut2d
from ._numbers import doubles, numpy_for, point
from .errors import InputError
from .motions import Keyframes, Velocity
from .options import run_options, scene_text
from .scene import Scene, _names, _plain_places
from .shape import Shape

if TYPE_CHECKING:
    import numpy

    Answers = numpy.ndarray[Any, numpy.dtype[numpy.void]]

__all__ = ["KeyframeRows", "Outcome", "VelocityRows", "answer_dtype", "check_many"]


class Outcome(enum.IntEnum):
    """The field "outcome" of check_many()'s answers; ``Outcome(3).name.lower()`` is what Answer.outcome says."""

    FREE = 0
    CONTACT = 1
    OVERLAP_AT_START = 2
    UNDECIDED = 3


def _array(values: Any, place: str, shapes: str, fits: Any) -> Any:
    """Doubles in an array without gaps, of one of the forms that fit."""
    numpy = numpy_for("check_many()")
    try:
        found = numpy.ascontiguousarray(doubles(numpy.asarray(values)))
    except (InputError, ValueError) as error:
        raise InputError(place, f"expected an array of numbers: {error}") from error
    if not fits(found.shape):
        raise InputError(place, f"expected an array of the shape {shapes}, found {found.shape}")
    return found


def _pivots(pivot: Any, rows: int) -> Any:
    if pivot is None:
        return None
    return _array(pivot, "pivot", f"(2,) or ({rows}, 2)", lambda shape: shape in ((2,), (rows, 2)))


class KeyframeRows:
    """A motion by keyframes for each row: ``values[i]`` is what Keyframes takes.

    ``values``: an array of the shape (rows, keyframes, 4), of t, x, y and the angle in degrees, or (rows, keyframes, 3),
    without the angle. ``pivot``: (x, y), for all rows, or an array (rows, 2); None is (0, 0). Angles, times and pivots
    mean what they mean in Keyframes, and ``rows[i]`` is the Keyframes of one row.
    """

    def __init__(self, values: Any, pivot: Any = None) -> None:
        self.values = _array(values, "keyframes", "(rows, keyframes, 3 or 4)",
                             lambda shape: len(shape) == 3 and shape[1] > 0 and shape[2] in (3, 4))
        self.pivot = _pivots(pivot, len(self.values))

    @classmethod
    def between(cls, starts: Any, ends: Any, time: Sequence[float] = (0, 1), pivot: Any = None) -> KeyframeRows:
        """From a pose to a pose, evenly: ``starts`` and ``ends`` have x, y and the angle in degrees (or x, y) in each
        row; one of the two may be a single pose. ``time``: when the way begins and ends."""
        numpy = numpy_for("check_many()")
        begin, end = point(time, "time")
        poses = [_array(p, name, "(rows, 2 or 3)", lambda shape: len(shape) in (1, 2) and shape[-1] in (2, 3))
                 for name, p in (("starts", starts), ("ends", ends))]
        try:
            poses = numpy.broadcast_arrays(*map(numpy.atleast_2d, poses))
        except ValueError as error:
            raise InputError("ends", f"starts are {poses[0].shape}, and ends {poses[1].shape}",
                             "give as many, each x, y, or each x, y and an angle") from error
        times = [numpy.full((len(poses[0]), 1), t) for t in (begin, end)]
        return cls(numpy.stack([numpy.hstack([t, p]) for t, p in zip(times, poses)], axis=1), pivot)

    def __len__(self) -> int:
        return len(self.values)

    def __getitem__(self, row: int) -> Keyframes:
        return Keyframes(self.values[row].tolist(), _row_of(self.pivot, row))

    def _add(self, table: _taut2d.Template, body: int) -> None:
        table.keyframes(body, self.values, self.values.shape[1], self.values.shape[2], self.pivot)


class VelocityRows:
    """A steady motion for each row, as Velocity has it: ``velocity`` is an array (rows, 2), ``spin_deg`` a number or an
    array (rows,), ``pivot`` (x, y), an array (rows, 2), or None. ``rows[i]`` is the Velocity of one row."""

    def __init__(self, velocity: Any, spin_deg: Any = 0.0, pivot: Any = None) -> None:
        numpy = numpy_for("check_many()")
        lines = _array(velocity, "velocity", "(rows, 2)", lambda shape: len(shape) == 2 and shape[1] == 2)
        spins = _array(spin_deg, "spin_deg", f"() or ({len(lines)},)", lambda shape: shape in ((), (len(lines),), (1,)))
        self.values = numpy.column_stack([lines, numpy.broadcast_to(spins.reshape(-1), len(lines))])
        self.pivot = _pivots(pivot, len(lines))

    def __len__(self) -> int:
        return len(self.values)

    def __getitem__(self, row: int) -> Velocity:
        x, y, spin = self.values[row].tolist()
        return Velocity((x, y), spin, _row_of(self.pivot, row))

    def _add(self, table: _taut2d.Template, body: int) -> None:
        table.velocities(body, self.values, self.pivot)


Rows = Union[KeyframeRows, VelocityRows]


def _row_of(pivot: Any, row: int) -> Optional[tuple[float, float]]:
    if pivot is None:
        return None
    x, y = (pivot[row] if pivot.ndim == 2 else pivot).tolist()
    return x, y


def answer_dtype() -> numpy.dtype[numpy.void]:
    """What a row of check_many()'s answers is made of."""
    library = numpy_for("check_many()")
    feature = [("body", "i4"), ("part", "i4"), ("ring", "i4"), ("index", "i4")]
    found: numpy.dtype[numpy.void] = library.dtype(
        [("t_lo", "f8"), ("t_hi", "f8"), ("free_until", "f8"), ("point", "f8", 2), ("normal", "f8", 2),
         ("events", "u8"), ("pair", "i4", 2), ("vertex", feature), ("edge", feature),
         ("outcome", "u1"), ("touching", "?"), ("grazing", "?")], align=True)
    return found


def _threads(threads: Optional[int]) -> int:
    if threads is None:
        # Those that this process may use, where the system says so.
        return len(os.sched_getaffinity(0)) if hasattr(os, "sched_getaffinity") else os.cpu_count() or 1
    if not isinstance(threads, int) or threads < 1:
        raise InputError("threads", f"{threads!r} is no number of threads", "give 1 or more, or None for all processors")
    return threads


def _prepared(shapes: Any, place: str) -> list[Any]:
    """Shapes that come again are made once."""
    made: dict[int, Any] = {}
    found = []
    for i, shape in enumerate(list(shapes)):
        if id(shape) not in made:
            try:
                made[id(shape)] = Shape(shape), shape
            except InputError as error:
                raise InputError(f"row {i}: {place}", error.problem, error.hint) from error
        found.append(made[id(shape)][0]._core)
    return found


def _columns(motions: Any, shapes: Any, times: Any) -> tuple[int, dict[str, Rows], dict[str, list[Any]], Any]:
    """How many rows there are, and what they are made of."""
    for name, given in (("motions", motions), ("shapes", shapes)):
        if not isinstance(given, Mapping):
            raise InputError(name, f"expected a dictionary, found {type(given).__name__}",
                             'name the body: {"hammer": ...}')
    moved = {}
    for name, rows in motions.items():
        try:
            moved[name] = rows if isinstance(rows, (KeyframeRows, VelocityRows)) else KeyframeRows(rows)
        except InputError as error:
            raise InputError(f"motions[{name!r}]", error.problem, error.hint) from error
    shaped = {name: _prepared(rows, name) for name, rows in shapes.items()}
    if times is not None:
        times = _array(times, "times", "(rows, 2)", lambda shape: len(shape) == 2 and shape[1] == 2)
    sizes = {**{f"motions[{k!r}]": len(v) for k, v in moved.items()},
             **{f"shapes[{k!r}]": len(v) for k, v in shaped.items()}, **({} if times is None else {"times": len(times)})}
    if not sizes:
        raise InputError("motions", "nothing differs from row to row",
                         "give an array of motions for a body, or a list of scenes in place of the scene")
    if len(set(sizes.values())) > 1:
        raise InputError("motions", "the numbers of rows differ: " + ", ".join(f"{k} has {n}" for k, n in sizes.items()))
    return next(iter(sizes.values())), moved, shaped, times


def _table(scene: Scene, motions: Any, shapes: Any, times: Any) -> tuple[int, _taut2d.Template]:
    rows, moved, shaped, when = _columns(motions, shapes, times)
    indices = {body.name: i for i, body in enumerate(scene.bodies)}
    for name in (*moved, *shaped):
        if name not in indices:
            raise InputError("motions" if name in moved else "shapes", f"there is no body {name!r}",
                             "bodies are called " + _names(scene))
    table = _taut2d.Template(scene._text(), rows)
    for name, column in moved.items():
        column._add(table, indices[name])
    for name, cores in shaped.items():
        table.shapes(indices[name], cores)
    if when is not None:
        table.times(when)
    return rows, table


def check_many(scene: Union[Scene, Iterable[Scene]], motions: Mapping[str, Any] = {}, *,
               shapes: Mapping[str, Sequence[Any]] = {}, times: Any = None, touch: str = "open",
               engine: str = "kinetic", threads: Optional[int] = None, max_seconds: Optional[float] = None,
               max_events: Optional[int] = None) -> Answers:
    """Checks many scenes, on all processors, and gives an array of as many answers: what check() says of each.

    ``scene``: one Scene, from which rows differ by the arguments that follow; or any number of them, and none of these
    arguments.
    ``motions``: {name of a body: its motion in each row}, as KeyframeRows, VelocityRows, or an array that KeyframeRows
    takes, of the shape (rows, keyframes, 3 or 4).
    ``shapes``: {name of a body: a list of its shape in each row}. Shapes that come again are prepared once.
    ``times``: an array (rows, 2) of when each row begins and ends; None: as the scene.
    ``threads``: how many; None is one for each processor. The answers are the same for any number.
    ``max_seconds``, ``max_events``: for each row, as in check(); ``touch``, ``engine`` as there.

    The result is a structured array of answer_dtype(): "outcome" (see Outcome), "t_lo" and "t_hi" (which certainly
    contain the time of the contact), "free_until", "point", "normal", "pair" (the two bodies, by their place in the
    scene), "vertex" and "edge" (each "body", "part", "ring", "index"), "grazing", "events". "touching" is true for rows
    that are free and touch: time, vertex and edge are then those of the touch. "point" of an overlap at the start lies
    inside both bodies. What there is not is NaN, or -1.

    Raises InputError as check() does, and names the first row at fault; KeyboardInterrupt on Ctrl-C.
    """
    library = numpy_for("check_many()")
    options = run_options(touch, engine, "first", max_seconds, max_events)
    count = _threads(threads)
    with _plain_places():
        if isinstance(scene, Scene):
            rows, table = _table(scene, motions, shapes, times)
            answers = library.empty(rows, answer_dtype())
            _taut2d.check_rows(table, options, count, answers)
        else:
            if motions or shapes or times is not None:
                raise InputError("motions", "there are many scenes already, each with motions of its own",
                                 "give one scene, and what differs from it")
            texts = [scene_text(one, f"scene[{i}]") for i, one in enumerate(scene)]
            answers = library.empty(len(texts), answer_dtype())
            _taut2d.check_texts(texts, options, count, answers)
    found: Answers = answers
    return found

"""Many checks at once: arrays in, an array of answers out, on several threads."""

from __future__ import annotations

import enum
import os
import re
import time
from collections.abc import Callable, Iterable, Mapping, Sequence
from typing import TYPE_CHECKING, Any, Optional, Union

from . import _taut2d
from ._numbers import numpy_for
from .errors import InputError
from .options import run_options
from .scene import Scene, _plain_places
from .variants import Scenes, Variants, asked
from .words import Engine, Touch

if TYPE_CHECKING:
    import numpy

    Answers = numpy.ndarray[Any, numpy.dtype[numpy.void]]

__all__ = ["Outcome", "answer_dtype", "check_many"]


class Outcome(enum.IntEnum):
    """The field "outcome" of check_many()'s answers; ``Outcome(3).name.lower()`` is what Answer.outcome says."""

    FREE = 0
    CONTACT = 1
    OVERLAP_AT_START = 2
    UNDECIDED = 3
    UNTESTED = 4
    LOCKED = 5


def answer_dtype() -> numpy.dtype[numpy.void]:
    """What a row of check_many()'s answers is made of."""
    library = numpy_for("check_many()")
    feature = [("body", "i4"), ("part", "i4"), ("ring", "i4"), ("index", "i4")]
    found: numpy.dtype[numpy.void] = library.dtype(
        [("t_lo", "f8"), ("t_hi", "f8"), ("free_until", "f8"), ("point", "f8", 2), ("normal", "f8", 2),
         ("events", "u8"), ("untested", "u8"), ("pair", "i4", 2), ("vertex", feature), ("edge", feature),
         ("outcome", "u1"), ("touching", "?"), ("grazing", "?")], align=True)
    return found


def thread_count(threads: Optional[int]) -> int:
    if threads is None:
        # Those that this process may use, where the system says so.
        return len(os.sched_getaffinity(0)) if hasattr(os, "sched_getaffinity") else os.cpu_count() or 1
    if not isinstance(threads, int) or threads < 1:
        raise InputError("threads", f"{threads!r} is no number of threads", "give 1 or more, or None for all processors")
    return threads


# How many rows of all are done.
Progress = Callable[[int, int], object]


def in_row_from(error: InputError, begin: int) -> InputError:
    """Rows of a part are counted from its beginning; the user counts all of them."""
    row = re.match(r"row (\d+)(.*)", error.place, re.DOTALL)
    return InputError(f"row {begin + int(row[1])}{row[2]}", error.problem, error.hint) if row else error


def _in_parts(given: Union[Variants, Scenes], options: _taut2d.RunOptions, threads: int, answers: Answers,
              progress: Progress) -> None:
    """Parts that take about a quarter of a second, so that who waits sees how far it is."""
    begin, size, rows = 0, 8 * threads, len(given)
    while begin < rows:
        end, started = min(begin + size, rows), time.monotonic()
        try:
            given.part(begin, end).check(options, threads, answers[begin:end])
        except InputError as error:
            raise in_row_from(error, begin) from error
        taken = time.monotonic() - started
        size = max(8 * threads, int(size * min(4.0, 0.25 / max(taken, 1e-3))))
        begin = end
        progress(end, rows)


def answers_to(given: Union[Variants, Scenes], options: _taut2d.RunOptions, threads: int,
               progress: Optional[Progress] = None) -> Answers:
    """Of all rows, in order."""
    answers: Answers = numpy_for("check_many()").zeros(len(given), answer_dtype())
    with _plain_places():
        if progress is None:
            given.check(options, threads, answers)
        else:
            _in_parts(given, options, threads, answers, progress)
    return answers


def check_many(scene: Union[Scene, Iterable[Scene]], motions: Mapping[str, Any] = {}, *,
               shapes: Mapping[str, Sequence[Any]] = {}, times: Any = None, touch: Touch = "open",
               engine: Engine = "usual", threads: Optional[int] = None, max_seconds: Optional[float] = None,
               max_events: Optional[int] = None, progress: Optional[Progress] = None) -> Answers:
    """Checks many scenes, on all processors, and gives an array of as many answers: what check() says of each.

    ``scene``: one Scene, from which rows differ by the arguments that follow; or any number of them, and none of these
    arguments.
    ``motions``: {name of a body: its motion in each row}, as KeyframeRows, VelocityRows, or an array that KeyframeRows
    takes, of the shape (rows, keyframes, 3 or 4).
    ``shapes``: {name of a body: a list of its shape in each row}. Shapes that come again are prepared once.
    ``times``: an array (rows, 2) of when each row begins and ends; None: as the scene.
    ``threads``: how many; None is one for each processor. The answers are the same for any number.
    ``max_seconds``, ``max_events``: for each row, as in check(); ``touch``, ``engine`` as there. With the engine
    "kinetic", rows that begin near others go on from the tiling of one of these, with the same answers.
    ``progress``: called as progress(done, rows) on this thread, some four times a second and at the end; what it raises
    ends the call.

    The result is a structured array of answer_dtype(): "outcome" (see Outcome), "t_lo" and "t_hi" (which certainly
    contain the time of the contact), "free_until", "point", "normal", "pair" (the two bodies, by their place in the
    scene), "vertex" and "edge" (each "body", "part", "ring", "index"), "grazing", "events", "untested" (the number of pairs about which the row says
    nothing: Coverage.untested). "touching" is true for rows
    that are free and touch: time, vertex and edge are then those of the touch. "point" of an overlap at the start lies
    inside both bodies. What there is not is NaN, or -1.

    Raises InputError as check() does, and names the first row at fault; KeyboardInterrupt on Ctrl-C.
    """
    options = run_options(touch, engine, "first", max_seconds, max_events)
    return answers_to(asked(scene, motions, shapes, times), options, thread_count(threads), progress)

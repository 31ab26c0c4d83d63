"""Sweeps: many checks, whose answers go to files, shard by shard, and which can be taken up again."""

from __future__ import annotations

import concurrent.futures
import json
import os
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, Optional, Union

from ._numbers import numpy_for
from .errors import InputError
from .many import Outcome, Progress, answer_dtype, answers_to, in_row_from, thread_count
from .options import run_options
from .scene import Scene
from .variants import Scenes, Variants, asked
from .words import Engine, Touch

if TYPE_CHECKING:
    import numpy

__all__ = ["SweepAnswers", "sweep"]

_FORMAT = "taut-sweep/1"
_FEATURE = ("body", "part", "ring", "index")
_NO_POINT = (float("nan"), float("nan"))
_OUTCOMES = [outcome.name.lower() for outcome in Outcome]


@dataclass(frozen=True)
class SweepAnswers:
    """The answers of a sweep, in files.

    ``folder``: where they are. ``rows``: how many. ``shards``: the files in order, each of JSON Lines: an object for each
    row, with "row", "outcome", and what else is known of it. ``bodies``: their names, if all rows have the same.
    """

    folder: str
    rows: int
    shards: tuple[str, ...]
    bodies: Optional[tuple[str, ...]] = None

    def __iter__(self) -> Iterator[dict[str, Any]]:
        """The rows in order, as dictionaries; one file is open at a time."""
        for shard in self.shards:
            with open(shard, encoding="utf-8") as file:
                for line in file:
                    yield json.loads(line)

    def array(self) -> numpy.ndarray[Any, numpy.dtype[numpy.void]]:
        """All of them as check_many() gives them, in memory: of a sweep over the variants of one scene. Raises ValueError
        for one over a list of scenes, whose bodies have no places in common."""
        if self.bodies is None:
            raise ValueError("each scene has bodies of its own: go through the rows")
        answers: numpy.ndarray[Any, numpy.dtype[numpy.void]] = numpy_for("a sweep").zeros(self.rows, answer_dtype())
        for row, line in zip(answers, self):
            _read(row, line, self.bodies)
        return answers


def _line(number: int, row: tuple[Any, ...], names: Sequence[str]) -> str:
    """A row of answer_dtype() as JSON; doubles read back as the same doubles. ``names``: those of the bodies, as JSON."""
    (t_lo, t_hi, free_until, point, normal, events, untested, pair, vertex, edge, outcome, touching, grazing) = row
    line = f'{{"row":{number},"outcome":"{_OUTCOMES[outcome]}","free_until":{free_until!r},"events":{events}'
    line += f',"untested":{untested}' if untested else ""
    if pair[0] >= 0:
        line += f',"pair":[{names[pair[0]]},{names[pair[1]]}]'
    if vertex[3] >= 0:
        line += f',"t":[{t_lo!r},{t_hi!r}]'
        for name, (body, part, ring, index) in (("vertex", vertex), ("edge", edge)):
            line += f',"{name}":{{"body":{names[body]},"part":{part},"ring":{ring},"index":{index}}}'
        line += f',"normal":[{normal[0]!r},{normal[1]!r}]'
        line += (',"touching":true' if touching else "") + (',"grazing":true' if grazing else "")
    if point[0] == point[0]:
        line += f',"point":[{point[0]!r},{point[1]!r}]'
    return line + "}\n"


def _lines(given: Union[Variants, Scenes], begin: int, answers: Any) -> str:
    """All rows, the first of which has this number."""
    def names(row: int) -> list[str]:
        return [json.dumps(name, ensure_ascii=False) for name in given.names(row)]

    alike = names(0) if isinstance(given, Variants) and len(given) else None
    # tolist() makes floats and tuples of all at once; fields of a row, one by one, take five times as long.
    return "".join(_line(begin + k, _plain(row), alike or names(k)) for k, row in enumerate(answers.tolist()))


def _plain(row: tuple[Any, ...]) -> tuple[Any, ...]:
    """Arrays within a row as lists."""
    return tuple(value.tolist() if hasattr(value, "tolist") else value for value in row)


def _read(row: Any, line: dict[str, Any], names: Sequence[str]) -> None:
    """The inverse of _line()."""
    row["outcome"] = Outcome[line["outcome"].upper()]
    row["free_until"], row["events"] = line["free_until"], line["events"]
    row["untested"] = line.get("untested", 0)
    row["t_lo"], row["t_hi"] = line.get("t", _NO_POINT)
    row["point"], row["normal"] = line.get("point", _NO_POINT), line.get("normal", _NO_POINT)
    row["pair"] = [names.index(name) for name in line["pair"]] if "pair" in line else -1
    for name in ("vertex", "edge"):
        found = line.get(name)
        row[name] = (-1,) * 4 if found is None else (names.index(found["body"]), *(found[f] for f in _FEATURE[1:]))
    for flag in ("touching", "grazing"):
        row[flag] = line.get(flag, False)


@dataclass(frozen=True)
class _Options:
    """What check_many() is told besides the rows; it goes to other processes as it is."""

    touch: Touch
    engine: Engine
    max_seconds: Optional[float]
    max_events: Optional[int]

    def answers_of(self, part: Union[Variants, Scenes], begin: int, threads: int) -> Any:
        """Those of a shard whose first row is the one that is said."""
        options = run_options(self.touch, self.engine, "first", self.max_seconds, self.max_events)
        try:
            return answers_to(part, options, threads)
        except InputError as error:
            raise in_row_from(error, begin) from error

    def text_of(self, part: Union[Variants, Scenes], begin: int) -> str:
        """The lines of such a shard, made by one thread."""
        return _lines(part, begin, self.answers_of(part, begin, 1))


def _write(path: str, text: str) -> None:
    """The whole text or nothing: what is there under that name is complete."""
    beside = f"{path}.{os.getpid()}.tmp"
    with open(beside, "w", encoding="utf-8") as file:
        file.write(text)
        file.flush()
        os.fsync(file.fileno())
    os.replace(beside, path)


def _claim(folder: str, about: dict[str, Any]) -> None:
    """Says in the folder what its shards are about; refuses one that is about something else."""
    os.makedirs(folder, exist_ok=True)
    path = os.path.join(folder, "sweep.json")
    if not os.path.exists(path):
        _write(path, json.dumps(about, indent=1) + "\n")
        return
    with open(path, encoding="utf-8") as file:
        try:
            there = json.load(file)
        except ValueError as error:
            raise InputError(path, "this is no account of a sweep", "remove the folder, or name another one") from error
    different = sorted(key for key in {*about, *there} if there.get(key) != about.get(key))
    if different:
        raise InputError(folder, f"it holds another sweep, which differs in {', '.join(different)}",
                         "name another folder, or remove this one")


def _on_cluster(client: Any, options: _Options, given: Union[Variants, Scenes],
                missing: Sequence[tuple[int, int, str]], written: Callable[[int], None]) -> None:
    """Shards on the workers of Dask; what a lost worker had begun goes to another one. A few more than there are
    processors are on their way at a time."""
    import distributed
    completed: Any = distributed.as_completed
    left = iter(missing)

    def send(shard: tuple[int, int, str]) -> Any:
        begin, end, _ = shard
        future = client.submit(options.text_of, given.part(begin, end), begin, pure=False)
        shards[future.key] = shard
        return future

    shards: dict[str, tuple[int, int, str]] = {}
    at_once = 2 * sum(client.ncores().values()) or 2
    waiting = completed([send(shard) for _, shard in zip(range(at_once), left)])
    try:
        for future in waiting:
            begin, end, path = shards.pop(future.key)
            _write(path, future.result())
            written(end - begin)
            for shard in left:
                waiting.add(send(shard))
                break
    finally:
        client.cancel(list(waiting.futures))


def _on_threads(count: int, options: _Options, given: Union[Variants, Scenes],
                missing: Sequence[tuple[int, int, str]], written: Callable[[int], None]) -> None:
    """Shards one after the other, each on all threads; a file is written while the library is at the next one."""
    def write(path: str, part: Union[Variants, Scenes], begin: int, answers: Any) -> None:
        _write(path, _lines(part, begin, answers))

    with concurrent.futures.ThreadPoolExecutor(1) as writer:
        last: Optional[tuple[concurrent.futures.Future[None], int]] = None

        def finish() -> None:
            if last is not None:
                last[0].result()
                written(last[1])

        for begin, end, path in missing:
            part = given.part(begin, end)
            answers = options.answers_of(part, begin, count)
            finish()
            last = (writer.submit(write, path, part, begin, answers), end - begin)
        finish()


def sweep(scene: Union[Scene, Iterable[Scene]], motions: Mapping[str, Any] = {}, *, to: Union[str, os.PathLike[str]],
          shapes: Mapping[str, Sequence[Any]] = {}, times: Any = None, touch: Touch = "open", engine: Engine = "usual",
          max_seconds: Optional[float] = None, max_events: Optional[int] = None, shard: int = 1000,
          threads: Optional[int] = None, client: Any = None, progress: Optional[Progress] = None) -> SweepAnswers:
    """check_many() for more rows than one sitting: answers go to files, and a sweep that was stopped goes on where it was.

    ``to``: a folder, made if need be. It gets sweep.json, which says what the sweep is about, and files of ``shard`` rows
    each, in JSON Lines. A file is there as a whole or not at all. The same call again makes only the files that are
    missing; another one is refused.
    ``client``: a distributed.Client, on whose workers shards are answered, while the files are written here; a worker that
    is lost loses nothing else. None: ``threads`` of this process.
    ``progress``: called as progress(done, rows) at once and after each file, of all rows, those of files that were there
    among them; what it raises ends the call.
    All else is as in check_many(). Files have the same bytes however often a sweep was stopped, and wherever it ran,
    unless ``max_seconds`` ends rows. Errors are those of check_many(), and OSError where files cannot be written.
    """
    if not isinstance(shard, int) or shard < 1:
        raise InputError("shard", f"{shard!r} is no number of rows", "give 1 or more")
    options = _Options(touch, engine, max_seconds, max_events)
    run_options(touch, engine, "first", max_seconds, max_events)
    given = asked(scene, motions, shapes, times)
    folder, rows, count = os.fspath(to), len(given), thread_count(threads)
    names = given.names(0) if isinstance(given, Variants) else None
    _claim(folder, {"format": _FORMAT, "rows": rows, "shard": shard, "touch": touch, "engine": engine,
                    "max_seconds": max_seconds, "max_events": max_events, "bodies": names, "sha256": given.digest()})
    shards = [(begin, min(begin + shard, rows), os.path.join(folder, f"rows-{begin:012d}.jsonl"))
              for begin in range(0, rows, shard)]
    missing = [(begin, end, path) for begin, end, path in shards if not os.path.exists(path)]
    done = rows - sum(end - begin for begin, end, _ in missing)

    def written(more: int) -> None:
        nonlocal done
        done += more
        if progress is not None:
            progress(done, rows)

    written(0)
    if client is not None:
        _on_cluster(client, options, given, missing, written)
    else:
        _on_threads(count, options, given, missing, written)
    return SweepAnswers(folder, rows, tuple(path for _, _, path in shards),
                        None if names is None else tuple(names))

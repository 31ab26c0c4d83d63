"""What differs from row to row, where many scenes have most in common."""

from __future__ import annotations

import hashlib
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, field, replace
from typing import Any, Optional, Union

from . import _taut2d
from ._numbers import doubles, numpy_for, time_span
from .errors import InputError
from .motions import Keyframes, Velocity
from .options import scene_text
from .scene import Scene, _names
from .shape import Shape

__all__ = ["KeyframeRows", "Scenes", "Variants", "VelocityRows"]


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
        begin, end = time_span(time, "time")
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

    def _part(self, rows: slice) -> KeyframeRows:
        return KeyframeRows(self.values[rows], _pivots_of(self.pivot, rows))

    def _add(self, table: Union[_taut2d.Template, _taut2d.MapRows], body: int) -> None:
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

    def _part(self, rows: slice) -> VelocityRows:
        return VelocityRows(self.values[rows, :2], self.values[rows, 2], _pivots_of(self.pivot, rows))

    def _add(self, table: Union[_taut2d.Template, _taut2d.MapRows], body: int) -> None:
        table.velocities(body, self.values, self.pivot)


Rows = Union[KeyframeRows, VelocityRows]


def _row_of(pivot: Any, row: int) -> Optional[tuple[float, float]]:
    if pivot is None:
        return None
    x, y = (pivot[row] if pivot.ndim == 2 else pivot).tolist()
    return x, y


def _pivots_of(pivot: Any, rows: slice) -> Any:
    return pivot[rows] if pivot is not None and pivot.ndim == 2 else pivot


def _prepared(shapes: Any, place: str) -> list[Shape]:
    """Shapes that come again are made once."""
    made: dict[int, tuple[Shape, Any]] = {}
    found = []
    for i, shape in enumerate(list(shapes)):
        if id(shape) not in made:
            try:
                made[id(shape)] = Shape(shape), shape
            except InputError as error:
                raise InputError(f"row {i}: {place}", error.problem, error.hint) from error
        found.append(made[id(shape)][0])
    return found


def _require_names(scene: Scene, given: Any, place: str) -> None:
    if not isinstance(given, Mapping):
        raise InputError(place, f"expected a dictionary, found {type(given).__name__}", 'name the body: {"hammer": ...}')
    for name in given:
        if all(body.name != name for body in scene.bodies):
            raise InputError(place, f"there is no body {name!r}", "bodies are called " + _names(scene))


@dataclass(frozen=True)
class Variants:
    """One scene, and what its rows have in place of what it has."""

    scene: Scene
    motions: dict[str, Rows]
    shapes: dict[str, list[Shape]]
    times: Any

    @classmethod
    def of(cls, scene: Scene, motions: Any, shapes: Any, times: Any) -> Variants:
        """From the arguments of check_many()."""
        _require_names(scene, motions, "motions")
        _require_names(scene, shapes, "shapes")
        moved: dict[str, Rows] = {}
        for name, rows in motions.items():
            try:
                moved[name] = rows if isinstance(rows, (KeyframeRows, VelocityRows)) else KeyframeRows(rows)
            except InputError as error:
                raise InputError(f"motions[{name!r}]", error.problem, error.hint) from error
        if times is not None:
            times = _array(times, "times", "(rows, 2)", lambda shape: len(shape) == 2 and shape[1] == 2)
        made = cls(scene, moved, {name: _prepared(rows, name) for name, rows in shapes.items()}, times)
        made._require_rows()
        return made

    def _sizes(self) -> dict[str, int]:
        sizes = {f"motions[{name!r}]": len(rows) for name, rows in self.motions.items()}
        sizes.update({f"shapes[{name!r}]": len(rows) for name, rows in self.shapes.items()})
        return sizes if self.times is None else {**sizes, "times": len(self.times)}

    def _require_rows(self) -> None:
        sizes = self._sizes()
        if not sizes:
            raise InputError("motions", "nothing differs from row to row",
                             "give an array of motions for a body, or a list of scenes in place of the scene")
        if len(set(sizes.values())) > 1:
            raise InputError("motions", "the numbers of rows differ: " +
                             ", ".join(f"{name} has {size}" for name, size in sizes.items()))

    def __len__(self) -> int:
        return next(iter(self._sizes().values()))

    def part(self, begin: int, end: int) -> Variants:
        """Some of the rows."""
        rows = slice(begin, end)
        return replace(self, motions={name: column._part(rows) for name, column in self.motions.items()},
                       shapes={name: column[rows] for name, column in self.shapes.items()},
                       times=None if self.times is None else self.times[rows])

    def names(self, row: int) -> list[str]:
        """The bodies of a row."""
        return [body.name for body in self.scene.bodies]

    def check(self, options: _taut2d.RunOptions, threads: int, into: Any) -> None:
        """Answers all rows."""
        indices = {body.name: i for i, body in enumerate(self.scene.bodies)}
        table = _taut2d.Template(self.scene._text(), len(self))
        for name, column in self.motions.items():
            column._add(table, indices[name])
        for name, shapes in self.shapes.items():
            table.shapes(indices[name], [shape._core for shape in shapes])
        if self.times is not None:
            table.times(self.times)
        _taut2d.check_rows(table, options, threads, into)

    def digest(self) -> str:
        """Names what is asked about; other numbers, another name."""
        found = hashlib.sha256(self.scene.to_json().encode("utf-8", "surrogatepass"))
        for name, column in self.motions.items():
            pivot = b"" if column.pivot is None else column.pivot.tobytes()
            for part in (name.encode(), type(column).__name__.encode(), repr(column.values.shape).encode(),
                         column.values.tobytes(), pivot):
                found.update(b"%d:" % len(part) + part)
        for name, shapes in self.shapes.items():
            found.update(name.encode())
            for shape in shapes:
                found.update(repr(shape._core.rings()).encode())
        if self.times is not None:
            found.update(self.times.tobytes())
        return found.hexdigest()


@dataclass(frozen=True)
class Scenes:
    """Scenes that have nothing in common."""

    scenes: Sequence[Scene] = field(default_factory=tuple)

    def __len__(self) -> int:
        return len(self.scenes)

    def part(self, begin: int, end: int) -> Scenes:
        """Some of the rows."""
        return Scenes(self.scenes[begin:end])

    def names(self, row: int) -> list[str]:
        """The bodies of a row."""
        return [body.name for body in self.scenes[row].bodies]

    def check(self, options: _taut2d.RunOptions, threads: int, into: Any) -> None:
        """Answers all rows."""
        texts = [scene_text(one, f"scene[{i}]") for i, one in enumerate(self.scenes)]
        _taut2d.check_texts(texts, options, threads, into)

    def digest(self) -> str:
        """Names what is asked about."""
        found = hashlib.sha256()
        for scene in self.scenes:
            found.update(scene.to_json().encode("utf-8", "surrogatepass") + b"\n")
        return found.hexdigest()


def asked(scene: Any, motions: Any, shapes: Any, times: Any) -> Union[Variants, Scenes]:
    """From the arguments of check_many()."""
    if isinstance(scene, Scene):
        return Variants.of(scene, motions, shapes, times)
    if motions or shapes or times is not None:
        raise InputError("motions", "there are many scenes already, each with motions of its own",
                         "give one scene, and what differs from it")
    if isinstance(scene, (str, bytes, Mapping)) or not isinstance(scene, Iterable):
        raise InputError("scene", f"expected a Scene, or a list of them, found {type(scene).__name__}")
    scenes = list(scene)
    for i, one in enumerate(scenes):
        if not isinstance(one, Scene):
            raise InputError(f"scene[{i}]", f"expected a Scene, found {type(one).__name__}")
    return Scenes(scenes)

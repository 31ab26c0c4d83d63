"""Shapes that are read and prepared once, for many scenes."""

from __future__ import annotations

import struct
from typing import Any

from . import _taut2d
from ._numbers import doubles
from .errors import InputError
from .parts import GeojsonFile, Part, Path, WktFile, flatten_hint, opened, parts_of_value

__all__ = ["Shape"]


def _ring(value: Any) -> Any:
    """An array as the library reads it, without a list of its numbers."""
    return opened(doubles(value))


def _rings(value: Any) -> list[tuple[Any, list[Any]]]:
    """Outlines, each with its holes, as the library takes them."""
    if getattr(value, "ndim", 0) == 2:
        return [(_ring(value), [])]
    if hasattr(value, "exterior") and hasattr(value, "interiors") and not getattr(value, "is_empty", True):
        # A polygon of shapely, whose coordinates are arrays: the first one is repeated, and heights may follow.
        import numpy
        rings = [opened(numpy.asarray(ring.coords, float)[:, :2]) for ring in (value.exterior, *value.interiors)]
        return [(rings[0], rings[1:])]
    parts = parts_of_value(value, "shape")
    for part in parts:
        if isinstance(part, (WktFile, GeojsonFile)):
            raise InputError("shape", "a file is read with the scene that names it, and makes no shape by itself",
                             "read the file, and give what it says")
        if isinstance(part, Path):
            raise InputError("shape", "it is bounded by curves, which Shape does not take", flatten_hint)
    return [(part.outline, list(part.holes)) for part in parts if isinstance(part, Part)]


class Shape:
    """A shape that comes again: validated, and prepared, once.

    ``shape``: what Body takes, except for files: a list of (x, y); a numpy array with two columns, whose numbers never
    become objects of Python; a Part, or a list of shapes; anything with ``__geo_interface__``; WKT. ``name``: what
    messages call it.

    It can be given to Body, and to check_many() for each row; answers are those of the bare shape. Immutable. Raises
    InputError, at once, for what no body can have: a boundary that crosses itself, a hole that is not inside.
    """

    def __init__(self, shape: Any, name: str = "shape") -> None:
        self._core: _taut2d.Shape = shape._core if isinstance(shape, Shape) else _taut2d.Shape(_rings(shape), name)
        self.name = name

    def __reduce__(self) -> tuple[Any, ...]:
        return Shape, (list(self.parts), self.name)

    @property
    def parts(self) -> tuple[Part, ...]:
        """Its parts, as tuples of floats."""
        rings = [[tuple(struct.iter_unpack("dd", ring)) for ring in part] for part in self._core.rings()]
        return tuple(Part(part[0], part[1:]) for part in rings)

    def _body_parts(self) -> tuple[Part, ...]:
        """The parts as a body has them. One polygon keeps what it is prepared to."""
        parts: tuple[Part, ...] = self.__dict__.setdefault("_parts", self.parts)
        if len(parts) == 1 and not parts[0].holes:
            parts[0].__dict__.setdefault("_core", self._core)
        return parts

    @property
    def __geo_interface__(self) -> dict[str, Any]:
        closed = [tuple(ring + ring[:1] for ring in (part.outline, *part.holes)) for part in self.parts]
        if len(closed) == 1:
            return {"type": "Polygon", "coordinates": closed[0]}
        return {"type": "MultiPolygon", "coordinates": tuple(closed)}

    def __repr__(self) -> str:
        rings = self._core.rings()
        vertices = sum(len(ring) for part in rings for ring in part) // 16
        holes = sum(len(part) - 1 for part in rings)
        return f"<taut2d.Shape {self.name!r}: {vertices} vertices, {len(rings)} parts, {holes} holes>"

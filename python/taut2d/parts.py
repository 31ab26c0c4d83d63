"""Parts: polygons with holes, from everything that people have them in."""

from __future__ import annotations

import os
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, fields
from typing import Any, Optional, Union

from ._numbers import number, path_text, point
from .errors import InputError
from .words import FillRule

__all__ = ["GeojsonFile", "OnePart", "Part", "Parts", "Path", "WktFile", "parts_of_value", "shape_of_value"]

Point = tuple[float, float]
Layers = tuple[Optional[float], Optional[float]]
Ring = tuple[Point, ...]


def opened(ring: Any) -> Any:
    """A ring, a sequence of points or an array, without a first vertex that is repeated at the end, once or more often:
    what has been opened stays as it is."""
    while len(ring) > 1 and all(a == b for a, b in zip(ring[0], ring[-1])):
        ring = ring[:-1]
    return ring


def layers(value: Any, place: str = "z") -> Optional[Layers]:
    """(lo, hi) with lo < hi, where None is no end; or None for all layers."""
    if value is None:
        return None
    ends = tuple(value) if isinstance(value, Sequence) and not isinstance(value, str) else (value,)
    if len(ends) != 2:
        raise InputError(place, "expected two heights", "give (lo, hi), the lower one first, or None for no end")
    lo, hi = (None if end is None else number(end, place) for end in ends)
    if lo is not None and hi is not None and not lo < hi:
        raise InputError(place, f"the layers run from {lo!r} to {hi!r}", "give the lower height first")
    return lo, hi


def _on_layers(json: Any, z: Optional[Sequence[Optional[float]]]) -> Any:
    return json if z is None else {**json, "z": list(z)}


def _ring(values: Any, place: str) -> Ring:
    """Points from a sequence of pairs, or from a numpy array with two columns; the first one may be repeated at the
    end."""
    if hasattr(values, "tolist"):
        # Python's own floats, many times faster than one by one.
        values = values.tolist()
    if isinstance(values, (str, bytes)) or not isinstance(values, Iterable):
        raise InputError(place, f"expected points, found {type(values).__name__}",
                         "give a list of (x, y), or a numpy array with two columns")
    ring: Ring = opened(tuple(point(value, f"{place}[{i}]") for i, value in enumerate(values)))
    return ring


def plain_state(instance: Any) -> dict[str, Any]:
    """What copies and pickles of it have: its fields, without what the library has made of them."""
    return {f.name: getattr(instance, f.name) for f in fields(instance)}


@dataclass(frozen=True)
class Part:
    """A polygon without its holes. ``outline`` and each of ``holes`` are lists of (x, y), or numpy arrays with two
    columns: the vertices in order, in either orientation. A first vertex that is repeated at the end is left out there.
    Holes lie inside the outline, and none touches it or another one. ``z``: its own layers, (lo, hi), in place of those of
    its body; see Body.z."""

    outline: Any
    holes: Any = ()
    z: Optional[Sequence[Optional[float]]] = None

    def __post_init__(self) -> None:
        object.__setattr__(self, "outline", _ring(self.outline, "outline"))
        holes = tuple(_ring(hole, f"holes[{i}]") for i, hole in enumerate(self.holes))
        object.__setattr__(self, "holes", holes)
        object.__setattr__(self, "z", layers(self.z))

    def __getstate__(self) -> dict[str, Any]:
        return plain_state(self)

    def _json(self) -> Any:
        outline = [list(p) for p in self.outline]
        if not self.holes and self.z is None:
            return outline
        holes = {"holes": [[list(p) for p in hole] for hole in self.holes]} if self.holes else {}
        return _on_layers({"outline": outline, **holes}, self.z)


def _segment_text(segment: Any, place: str) -> str:
    """One segment of an SVG path, without where it begins."""
    points = [complex(p) if not hasattr(p, "__len__") else complex(*p) for p in segment[1:]] if len(segment) != 6 else []
    if len(points) in (1, 2, 3):
        return "LQC"[len(points) - 1] + " ".join(f" {p.real!r} {p.imag!r}" for p in points)
    if len(segment) == 6:
        radius, end = (complex(p) if not hasattr(p, "__len__") else complex(*p) for p in (segment[1], segment[5]))
        turned, large, sweep = number(segment[2], place), bool(segment[3]), bool(segment[4])
        return f"A {radius.real!r} {radius.imag!r} {turned!r} {large:d} {sweep:d} {end.real!r} {end.imag!r}"
    raise InputError(place, f"a segment of {len(segment)} members",
                     "give (start, end), (start, control, end), (start, control, control, end), or an arc as (start, radius, "
                     "rotation, large, sweep, end)")


@dataclass(frozen=True)
class Path:
    """What an SVG path encloses, y upwards, about its curves themselves.

    ``path``: its data, M L H V C S Q T A Z; or an object with a method ``d()``, such as a Path of svgpathtools; or a list of
    segments in order, each a tuple of points, (x, y) or complex: (start, end) is a line, (start, control, end) and (start,
    control, control, end) are Bezier curves, (start, radius, rotation, large, sweep, end) is an arc. Every subpath is
    closed, and must meet neither itself nor another one.
    ``fill_rule``: "nonzero" or "evenodd", where subpaths lie in each other.
    ``z``: its own layers, as of a Part.
    """

    path: Any
    fill_rule: FillRule = "nonzero"
    z: Optional[Sequence[Optional[float]]] = None

    def __post_init__(self) -> None:
        object.__setattr__(self, "z", layers(self.z))
        if self.fill_rule not in ("nonzero", "evenodd"):
            raise InputError("fill_rule", f"unknown rule {self.fill_rule!r}", 'write "nonzero" or "evenodd"')
        if hasattr(self.path, "d"):
            object.__setattr__(self, "path", str(self.path.d()))
        if isinstance(self.path, str):
            return
        segments = list(self.path)
        if not segments:
            raise InputError("path", "there are no segments", "give at least two")
        first = segments[0][0]
        start = complex(first) if not hasattr(first, "__len__") else complex(*first)
        text = " ".join(_segment_text(s, f"path[{i}]") for i, s in enumerate(segments))
        object.__setattr__(self, "path", f"M {start.real!r} {start.imag!r} {text} Z")

    def _json(self) -> Any:
        return _on_layers({"path": self.path, "fill-rule": self.fill_rule}, self.z)


@dataclass(frozen=True)
class WktFile:
    """An outline from a file with a WKT POLYGON. ``path`` is relative to the scene's folder, and must lie below it.
    ``z``: its own layers, as of a Part."""

    path: Union[str, os.PathLike[str]]
    z: Optional[Sequence[Optional[float]]] = None

    def __post_init__(self) -> None:
        object.__setattr__(self, "path", path_text(self.path, "path"))
        object.__setattr__(self, "z", layers(self.z))

    def _json(self) -> Any:
        return _on_layers({"wkt": self.path}, self.z)


@dataclass(frozen=True)
class GeojsonFile:
    """An outline from a file with a GeoJSON Polygon. ``path`` is relative to the scene's folder, and must lie below
    it. ``z``: its own layers, as of a Part."""

    path: Union[str, os.PathLike[str]]
    z: Optional[Sequence[Optional[float]]] = None

    def __post_init__(self) -> None:
        object.__setattr__(self, "path", path_text(self.path, "path"))
        object.__setattr__(self, "z", layers(self.z))

    def _json(self) -> Any:
        return _on_layers({"geojson": self.path}, self.z)


OnePart = Union[Part, Path, WktFile, GeojsonFile]
Parts = Union[OnePart, tuple[OnePart, ...]]

# What to do where polygons only are taken.
flatten_hint = ("taut2d.flatten(scene, tolerance), or flatten(body, tolerance), makes polygons around such bodies, no farther "
                'from the curves than the tolerance, and with side="inner" within them: for example, '
                "taut2d.Simulation(taut2d.flatten(scene, 0.001))")

_shape_hint = ("give a list of (x, y), a numpy array with two columns, a Part, a list of these, an object with "
               "__geo_interface__, or WKT")


def _geo_ring(values: Any) -> Ring:
    """As GeoJSON has it: the first vertex is repeated at the end, and heights may follow x and y."""
    ring: Ring = opened(tuple((number(p[0], "x"), number(p[1], "y")) for p in values))
    return ring


def _geo_parts(geometry: Mapping[str, Any], place: str) -> tuple[Part, ...]:
    kind = geometry.get("type")
    if kind == "Feature":
        return _geo_parts(geometry.get("geometry") or {}, place)
    if kind == "FeatureCollection":
        return tuple(part for f in geometry["features"] for part in _geo_parts(f, place))
    if kind == "Polygon":
        polygons = [geometry["coordinates"]]
    elif kind == "MultiPolygon":
        polygons = geometry["coordinates"]
    else:
        raise InputError(place, f"expected a Polygon or a MultiPolygon, found {kind}",
                         "bodies are areas: buffer a line, say, or take the polygons out of a collection")
    parts = tuple(Part(_geo_ring(rings[0]), tuple(_geo_ring(ring) for ring in rings[1:]))
                  for rings in polygons if len(rings) > 0 and len(rings[0]) > 0)
    if not parts:
        raise InputError(place, "the geometry is empty")
    return parts


def _wkt_parts(text: str, place: str) -> tuple[Part, ...]:
    try:
        from shapely import wkt
        from shapely.errors import ShapelyError
    except ImportError as error:
        raise InputError(place, "WKT is read by shapely, which is not installed",
                         "install shapely, or give points, or WktFile(path)") from error
    try:
        geometry = wkt.loads(text)
    except ShapelyError as error:
        raise InputError(place, "this is not WKT", 'write "POLYGON ((0 0, 1 0, 0 1, 0 0))"') from error
    return _geo_parts(geometry.__geo_interface__, place)


def _is_number(value: Any) -> bool:
    # An array of numpy, which offers __float__ as well, is none.
    return getattr(value, "ndim", 0) == 0 and not isinstance(value, (str, bytes)) and hasattr(value, "__float__")


def _is_ring(value: Any) -> bool:
    """Does it begin as a list of points does? What is wrong further on is then wrong with a point."""
    if hasattr(value, "ndim"):
        return bool(value.ndim == 2)
    if not value:
        return True
    first = value[0]
    if isinstance(first, (str, bytes, Mapping, Part, Path, WktFile, GeojsonFile)) or hasattr(first, "__geo_interface__"):
        return False
    return _is_number(first) or (isinstance(first, Iterable) and all(map(_is_number, first)))


def _parts(value: Any, place: str) -> tuple[tuple[OnePart, ...], bool]:
    """The parts that a value stands for, and whether they were written as a list of parts."""
    if isinstance(value, (Part, Path, WktFile, GeojsonFile)):
        return (value,), False
    if isinstance(value, str):
        return _wkt_parts(value, place), False
    if hasattr(value, "_body_parts"):
        # A Shape, which is prepared already.
        return value._body_parts(), False
    if hasattr(value, "__geo_interface__"):
        return _geo_parts(value.__geo_interface__, place), False
    if isinstance(value, Mapping):
        if "path" in value:
            return (Path(value["path"], value.get("fill-rule", "nonzero")),), False
        if "outline" in value:
            return (Part(value["outline"], tuple(value.get("holes", ()))),), False
        return _geo_parts(value, place), False
    if isinstance(value, bytes) or not isinstance(value, Iterable):
        raise InputError(place, f"expected a shape, found {type(value).__name__}", _shape_hint)
    if not hasattr(value, "ndim"):
        value = list(value)
    if _is_ring(value):
        return (Part(_ring(value, place)),), False
    return tuple(part for i, v in enumerate(value) for part in _parts(v, f"{place}[{i}]")[0]), True


def parts_of_value(value: Any, place: str) -> tuple[OnePart, ...]:
    """The parts of a shape in any form that Body takes."""
    return _parts(value, place)[0]


def shape_of_value(value: Any, place: str) -> Parts:
    parts, listed = _parts(value, place)
    # A list of one part stays one: its vertices are then named with their part.
    return parts if listed or len(parts) != 1 else parts[0]

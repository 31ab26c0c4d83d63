"""Drawings and maps as scenes, with a report of what was read and what was not."""

from __future__ import annotations

import json
import os
from dataclasses import dataclass, field
from typing import Any, Mapping, Optional, Sequence, Tuple, Union

from . import _taut2d
from ._numbers import number
from .errors import InputError
from .parts import Layers, layers as heights_of
from .scene import Scene
from .words import CrossingContours, Faults, Grouping, LengthUnit, OpenLines, RepairKind

__all__ = ["Drawing", "DrawingBody", "DrawingFile", "Gap", "OpenLine", "Repair", "Skipped", "read_drawing"]

_Point = Tuple[float, float]


@dataclass(frozen=True)
class Gap:
    """An end of a line that was moved by ``width``, from ``start`` to ``end``, to meet another line. ``place``: file and
    line."""

    start: _Point
    end: _Point
    width: float
    place: str
    layer: str


@dataclass(frozen=True)
class OpenLine:
    """A line that encloses nothing and is no part of a body. ``gap``: how far away the nearest other open end is, and
    ``nearest``, where; None if there is none."""

    points: Tuple[_Point, ...]
    gap: Optional[float]
    nearest: Optional[_Point]
    place: str
    layer: str


@dataclass(frozen=True)
class Repair:
    """A "loop", "crossing" or "spike" of this size that was cut off, or a "sliver" of this width that was filled."""

    what: RepairKind
    at: _Point
    size: float
    place: str
    layer: str


@dataclass(frozen=True)
class Crossing:
    """A contour that crosses or touches itself, more widely than what is cut off."""

    at: _Point
    place: str
    layer: str


@dataclass(frozen=True)
class Skipped:
    """What did not become part of a body, and why. ``unread``: it was drawn, and may have been meant to. ``times``: how
    many there are of the kind; the place and the handle are the first one's."""

    what: str
    reason: str
    place: str
    layer: str
    handle: str
    unread: bool
    times: int


@dataclass(frozen=True)
class DrawingFile:
    """What became of one file. ``tolerance``, ``join``, ``repair``: the lengths that were used. ``deviation``: how far
    chords are from their curves, at most. ``repeated``: segments that were drawn more than once. ``notes``: decisions
    that a person should know of."""

    file: str
    format: str
    units: str
    tolerance: float
    join: float
    repair: float
    deviation: float
    repeated: int
    gaps: Tuple[Gap, ...]
    open: Tuple[OpenLine, ...]
    repairs: Tuple[Repair, ...]
    crossings: Tuple[Crossing, ...]
    notes: Tuple[str, ...]
    skipped: Tuple[Skipped, ...]


@dataclass(frozen=True)
class DrawingBody:
    """A body in numbers. ``area``: of the union of its parts; ``box``: the lower left and the upper right corner;
    ``overlap``: by how much the areas of the parts exceed that of their union; ``z``: the heights between which its
    parts lie, each pair once, where None is no end; empty if nothing says them. Parts with different heights count
    apart in areas."""

    name: str
    file: str
    parts: int
    holes: int
    vertices: int
    area: float
    box: Tuple[_Point, _Point]
    overlap: float = 0.0
    z: Tuple[Layers, ...] = ()


@dataclass(frozen=True)
class Drawing:
    """What read_drawing() gives. ``scene``: bodies that rest, over the time (0, 1); None if there are ``faults``.
    ``json``: the report as ``taut import --json`` prints it; ``svg``: a picture in which open lines are red."""

    scene: Optional[Scene]
    files: Tuple[DrawingFile, ...]
    bodies: Tuple[DrawingBody, ...]
    faults: Tuple[InputError, ...]
    json: str = field(repr=False, compare=False)
    svg: str = field(repr=False, compare=False)

    @property
    def area(self) -> float:
        """The area of all bodies."""
        return sum(body.area for body in self.bodies)

    def _repr_svg_(self) -> str:
        return self.svg


def _place(value: Any) -> _Point:
    return (float(value[0]), float(value[1]))


def _open_line(value: dict[str, Any]) -> OpenLine:
    ends = [end for end in (value["nearest_from"], value["nearest_to"]) if end is not None]
    nearest = min(ends, key=lambda end: float(end["distance"])) if ends else None
    return OpenLine(tuple(_place(p) for p in value["points"]), float(nearest["distance"]) if nearest else None,
                    _place(nearest["at"]) if nearest else None, value["place"], value["layer"])


def _file(value: dict[str, Any]) -> DrawingFile:
    return DrawingFile(
        value["file"], value["format"], value["units"], float(value["tolerance"]), float(value["join"]),
        float(value["repair"]), float(value["deviation"]), value["repeated"],
        tuple(Gap(_place(g["from"]), _place(g["to"]), float(g["width"]), g["place"], g["layer"]) for g in value["gaps"]),
        tuple(_open_line(line) for line in value["open"]),
        tuple(Repair(r["what"], _place(r["at"]), float(r["size"]), r["place"], r["layer"]) for r in value["repairs"]),
        tuple(Crossing(_place(c["at"]), c["place"], c["layer"]) for c in value["crossings"]),
        tuple(value["notes"]),
        tuple(Skipped(s["what"], s["reason"], s["place"], s["layer"], s["handle"], s["unread"], s["times"])
              for s in value["skipped"]))


def _drawing(scene: str, report: str, svg: str) -> Drawing:
    value = json.loads(report)
    bodies = tuple(DrawingBody(b["name"], b["file"], b["parts"], b["holes"], b["vertices"], float(b["area"]),
                               (_place(b["box"][0]), _place(b["box"][1])), float(b["overlap"]),
                               tuple((z[0], z[1]) for z in b.get("z", ()))) for b in value["bodies"])
    faults = tuple(InputError(f["place"], f["problem"], f["hint"]) for f in value["faults"])
    return Drawing(Scene.from_json(scene) if scene else None, tuple(_file(f) for f in value["files"]), bodies, faults,
                   report, svg)


def _length(value: Optional[float], name: str, zero: bool) -> Optional[float]:
    if value is None:
        return None
    length = number(value, name)
    if length < 0 or (length == 0 and not zero):
        raise InputError(name, f"{length} is not a length", "give a positive number in the units of the scene")
    return length


def _word(value: str, name: str, words: Sequence[str]) -> str:
    if value not in words:
        raise InputError(name, f"expected one of {', '.join(words)}, found {value!r}", "choose one of these")
    return value


def read_drawing(path: Union[str, os.PathLike[str], Sequence[Union[str, os.PathLike[str]]]], *,
                 tolerance: Optional[float] = None, join: Optional[float] = None, repair: Optional[float] = None,
                 open: OpenLines = "error", by: Grouping = "auto",
                 layers: Union[Sequence[str], Mapping[str, Optional[Layers]]] = (),
                 merge_layers: Union[bool, Sequence[str]] = (), scale: float = 1.0, curves: bool = False,
                 split: bool = False, drills: Optional[float] = None, unknown_free: bool = False, strict: bool = False,
                 faults: Faults = "raise", unit: Optional[LengthUnit] = None,
                 crossing: CrossingContours = "error") -> Drawing:
    """A scene of SVG and DXF drawings, of boards of KiCad, WKT and GeoJSON files, and maps of map_server; bodies rest.

    ``path``: one file, or several ones; their endings say what they are.
    ``tolerance``: chords are nowhere farther from their curves. ``join``: ends of lines that are at most so far from
    another end or line meet it. ``repair``: loops up to this size are cut off; if it is given, polygons of WKT and
    GeoJSON are mended, too. In units of the scene; None: 0.01, 0.02 and 0.1 mm, in proportion for small and large
    drawings.
    ``open``: outlines that stay open are an "error", or "close" them by straight lines, or "skip" them. Shapes that are
    not read and may bound a body are an error, unless it is "skip".
    ``by``: what becomes a body: "auto": layers, but contours in material of another layer are its holes; "layer",
    "color", "group" or "nesting". ``layers``: only these; a mapping gives the bodies on each of them
    heights, ``{"base": (0, 3), "lever": (3, 6), "pin": None}``, in units of the scene; None is no end, or all heights.
    ``merge_layers``: these, or all if True, are one.
    ``scale``: all lengths are multiplied by it. ``curves``: arcs and Bezier curves stay what they are. ``split``: a body
    for each part. ``drills``: those of a board that are at least so wide are holes in it. ``unknown_free``: what a
    robot's map does not know is no obstacle. ``strict``: what is not read is an error.
    ``unit``: what a drawing is in that does not say so: "mm", "cm", "m", "um", "in", "ft", "mil", "pt" or "px". Several
    files are converted to the unit of the first one.
    ``crossing``: closed contours around material that cross each other are an "error", or all are one part ("union"),
    or the smaller is taken out of the larger ("subtract"), or they divide each other into "parts".
    ``faults``: "raise": the first fault is raised; "report": the result has them, and no scene.

    Raises InputError with file, line and remedy where a file cannot be read, and for faults: outlines that stay open,
    nothing that encloses an area, layers that can be read in two ways, rings that cross.
    """
    settings = _taut2d.ImportSettings()
    settings.tolerance = _length(tolerance, "tolerance", False)
    settings.join = _length(join, "join", True)
    settings.repair = _length(repair, "repair", True)
    factor = _length(scale, "scale", False)
    settings.scale = 1.0 if factor is None else factor
    settings.unit = "" if unit is None else _word(unit, "unit", ("mm", "cm", "m", "um", "in", "ft", "mil", "pt", "px"))
    settings.curves, settings.split, settings.strict = bool(curves), bool(split), bool(strict)
    settings.drills = _length(drills, "drills", True)
    settings.unknown_free = bool(unknown_free)
    settings.layers = list(layers)
    if isinstance(layers, Mapping):
        for name, ends in layers.items():
            z = heights_of(ends, f"layers[{name!r}]")
            if z is not None:
                settings.give_heights(name, *z)
    settings.merge_all = merge_layers is True
    settings.merged = [] if isinstance(merge_layers, bool) else list(merge_layers)
    settings.group_by(_word(by, "by", ("auto", "layer", "color", "group", "nesting")))
    settings.leave_open(_word(open, "open", ("error", "close", "skip")))
    settings.cross(_word(crossing, "crossing", ("error", "subtract", "union", "parts")))
    _word(faults, "faults", ("raise", "report"))
    paths = [path] if isinstance(path, (str, os.PathLike)) else list(path)
    drawing = _drawing(*_taut2d.read_drawings([os.fspath(p) for p in paths], settings))
    if drawing.faults and faults == "raise":
        raise drawing.faults[0]
    return drawing

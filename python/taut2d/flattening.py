"""Polygons for curves."""

from __future__ import annotations

import struct
from dataclasses import replace
from typing import Any, TypeVar

from . import _taut2d
from ._numbers import number
from .errors import InputError
from .linkages import Linkage
from .parts import Part, Path
from .scene import Body, Scene, _plain_places
from .words import Side

__all__ = ["flatten"]

Curved = TypeVar("Curved", Scene, Linkage, Body)


def _has_path(body: Body) -> bool:
    return any(isinstance(part, Path) for part in (body.shape if isinstance(body.shape, tuple) else (body.shape,)))


def _flat_bodies(bodies: tuple[Body, ...], folder: str, tolerance: float, outer: bool) -> dict[str, Body]:
    """The bodies that have paths, by their names, with polygons instead."""
    curved = [body for body in bodies if _has_path(body)]
    if not curved:
        return {}
    with _plain_places():
        alone = Scene([Body(body.name, body.shape) for body in curved], (0, 0), folder=folder)
        flat = _taut2d.flatten(alone._text(), tolerance, outer)
    found = {}
    for body, (parts, layers) in zip(curved, flat):
        rings = [[tuple(struct.iter_unpack("dd", ring)) for ring in part] for part in parts]
        shape = [Part(part[0], part[1:], z) for part, z in zip(rings, layers)]
        found[body.name] = replace(body, shape=shape[0] if len(shape) == 1 else shape)
    return found


def flatten(curved: Curved, tolerance: float, side: Side = "outer") -> Curved:
    """A Scene, a Linkage or a Body like this one, with polygons instead of curves, for what takes polygons only: Simulation,
    StaticMap, cells(), envelope() and Shape.

    ``tolerance``: polygons are nowhere farther from the curves, in the scene's units, > 0. ``side``: "outer": polygons
    contain the bodies; "inner": bodies contain the polygons. Both are proved: where outer polygons never overlap, the
    bodies do not either, and where inner ones overlap, the bodies do.

    Bodies that have no Path stay as they are. Raises InputError where curves are not valid, or ``tolerance`` is less than
    2^-40 of the largest coordinate.
    """
    if not isinstance(curved, (Scene, Linkage, Body)):
        raise InputError("curved", f"expected a Scene, a Linkage or a Body, found {type(curved).__name__}",
                         "write Body(name, path)")
    if side not in ("outer", "inner"):
        raise InputError("side", f"unknown value {side!r}", 'write "outer" or "inner"')
    most = number(tolerance, "tolerance")
    if not most > 0:
        raise InputError("tolerance", f"{most} is not a positive number",
                         "give the most that polygons may be from the curves, in the scene's units")
    result: Any = curved
    if isinstance(curved, Body):
        result = _flat_bodies((curved,), ".", most, side == "outer").get(curved.name, curved)
    else:
        bodies = tuple(curved.bodies)
        flat = _flat_bodies(bodies, str(curved.folder), most, side == "outer")
        result = replace(curved, bodies=[flat.get(body.name, body) for body in bodies])
    found: Curved = result
    return found

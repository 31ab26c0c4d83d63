"""Scenes that are asked about again: read by the library once, with shapes that are prepared once."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, Optional, Union

from . import _taut2d
from .errors import InputError
from .motions import CsvKeyframes
from .parts import GeojsonFile, Part, WktFile

if TYPE_CHECKING:
    from .scene import Body, Scene

# Stands in a text for a shape that is handed over beside it.
_placeholder = [[0, 0], [1, 0], [0, 1]]


def read_scene(scene: Scene) -> Union[_taut2d.ReadScene, _taut2d.SceneText]:
    """The scene as the library has read it, or its text where that may say something else the next time, or is at
    fault: errors then speak of all of the text."""
    known: Optional[_taut2d.ReadScene] = scene.__dict__.get("_read")
    if known is not None:
        return known
    if not _is_lasting(scene):
        return scene._text()
    try:
        shapes = [_shape(body) for body in scene.bodies]
        bodies = [body._json() if shape is None else body._json(_placeholder) for body, shape in zip(scene.bodies, shapes)]
        read = _taut2d.ReadScene(scene._text(bodies), shapes)
    except InputError:
        return scene._text()
    scene.__dict__["_read"] = read
    return read


def _is_lasting(scene: Scene) -> bool:
    """Does it say the same whenever it is asked? Files may change, and so may dictionaries and lists."""
    ids = (scene.id, *(body.id for body in scene.bodies))
    return scene.mechanism is None and all(map(_names_no_file, scene.bodies)) and all(
        isinstance(id, (type(None), str, int, float)) for id in ids)


def _names_no_file(body: Body) -> bool:
    parts = body.shape if isinstance(body.shape, tuple) else (body.shape,)
    return not isinstance(body.motion, CsvKeyframes) and not any(isinstance(p, (WktFile, GeojsonFile)) for p in parts)


def _shape(body: Body) -> Optional[_taut2d.Shape]:
    """Of one polygon without holes, which is kept with the polygon: bodies that share it, as one that moves in another
    way, are not prepared again."""
    part: Any = body.shape
    if not isinstance(part, Part) or part.holes or part.z is not None:
        return None
    if "_core" not in part.__dict__:
        part.__dict__["_core"] = _taut2d.Shape([(part.outline, [])], "shape")
    core: _taut2d.Shape = part.__dict__["_core"]
    return core

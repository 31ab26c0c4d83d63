"""Options that several functions take, looked at before the library sees them."""

from __future__ import annotations

from typing import Any, Optional

from . import _taut2d
from ._numbers import number
from .errors import InputError
from .scene import Scene
from .words import Engine, Pairs, Touch


def seconds(limit: Optional[float]) -> Optional[float]:
    if limit is None or limit == float("inf"):
        return None
    found = number(limit, "max_seconds")
    if found < 0:
        raise InputError("max_seconds", "the limit is negative", "give seconds, 0 or more")
    return found


def run_options(touch: Touch, engine: Engine, pairs: Pairs, max_seconds: Optional[float],
                max_events: Optional[int], fit: Optional[float] = None, time_tolerance: float = 1e-9) -> _taut2d.RunOptions:
    for name, value in (("touch", touch), ("engine", engine), ("pairs", pairs)):
        if not isinstance(value, str):
            raise InputError(name, f"expected a word, found {type(value).__name__}")
    if max_events is not None:
        try:
            max_events = min(max_events.__index__(), 2**64 - 1)
        except AttributeError as error:
            raise InputError("max_events", f"expected a whole number, found {type(max_events).__name__}") from error
        if max_events < 0:
            raise InputError("max_events", "the limit is negative", "give a number of events, 0 or more")
    shrink = 0.0 if fit is None else number(fit, "fit")
    if fit is not None and not shrink > 0:
        raise InputError("fit", "it is not a positive number", "None leaves bodies as they are")
    return _taut2d.RunOptions(touch, engine, pairs, seconds(max_seconds), max_events, shrink,
                              number(time_tolerance, "time_tolerance"))


def scene_text(scene: Any, place: str = "scene") -> _taut2d.SceneText:
    if not isinstance(scene, Scene):
        raise InputError(place, f"expected a Scene, found {type(scene).__name__}",
                         "Scene.load(path) reads a file, and Scene.from_json(text) the text of one")
    return scene._text()

"""Options that several functions take, looked at before the library sees them."""

from __future__ import annotations

import functools
import json
from collections.abc import Callable
from typing import Any, Optional, TypeVar, Union

from . import _taut2d
from ._numbers import number
from .errors import InputError
from .prepared import read_scene
from .scene import Scene
from .words import Engine, Pairs, Touch


def seconds(limit: Optional[float]) -> Optional[float]:
    if limit is None or limit == float("inf"):
        return None
    found = number(limit, "max_seconds")
    if found < 0:
        raise InputError("max_seconds", "the limit is negative", "give seconds, 0 or more")
    return found


_Word = TypeVar("_Word", bound=str)


def _word(value: _Word, name: str) -> _Word:
    if not isinstance(value, str):
        raise InputError(name, f"expected a word, found {type(value).__name__}")
    return value


def _events(limit: Any) -> Optional[int]:
    if limit is None:
        return None
    try:
        events = min(int(limit.__index__()), 2**64 - 1)
    except AttributeError as error:
        raise InputError("max_events", f"expected a whole number, found {type(limit).__name__}") from error
    if events < 0:
        raise InputError("max_events", "the limit is negative", "give a number of events, 0 or more")
    return events


def _fit(distance: Any) -> Optional[float]:
    if distance is None:
        return None
    shrink = number(distance, "fit")
    if not shrink > 0:
        raise InputError("fit", "it is not a positive number", "None leaves bodies as they are")
    return shrink


def run_options(touch: Touch, engine: Engine, pairs: Pairs, max_seconds: Optional[float],
                max_events: Optional[int]) -> _taut2d.RunOptions:
    """Options of check() for functions that ask it many times."""
    return _taut2d.RunOptions(_word(touch, "touch"), _word(engine, "engine"), _word(pairs, "pairs"), seconds(max_seconds),
                              _events(max_events))


# The questions as the library describes them: each one's options by their names.
_questions: dict[str, dict[str, dict[str, Any]]] = {
    entry["name"]: {option["name"]: option for option in entry["options"]} for entry in json.loads(_taut2d.questions())
}
_by_type: dict[str, Callable[[Any, str], Any]] = {
    "number": number, "whole number": lambda value, _: int(value), "flag": lambda value, _: bool(value), "word": _word,
    "text": _word,
}
# Options that Python takes in more forms, or fewer.
_by_name: dict[str, Callable[[Any], Any]] = {"max_seconds": seconds, "max_events": _events, "fit": _fit}


def _checked(option: dict[str, Any], value: Any) -> Any:
    name = option["name"]
    if name in _by_name:
        return _by_name[name](value)
    # None stands for no limit.
    is_limit = option["type"] == "number" and not option["required"] and "default" not in option
    return None if value is None and is_limit else _by_type[option["type"]](value, name)


def _default(option: dict[str, Any]) -> Any:
    return option["words"][0] if option["type"] == "word" else option.get("default")


def _written(name: str, /, **options: Any) -> str:
    """Options as JSON; those that are None, or what they are by default, are left out."""
    known = _questions[name]
    checked = {key: _checked(known[key], value) for key, value in options.items()}
    return json.dumps({key: value for key, value in checked.items() if value not in (None, _default(known[key]))})


# Of options that come again: writing them takes as long as a small question. 1, 1.0 and True are not the same.
_known_options = functools.lru_cache(maxsize=256, typed=True)(_written)


def ask(name: str, about: Union[_taut2d.ReadScene, _taut2d.SceneText], *, log: bytes = b"",
        **options: Any) -> tuple[str, bytes, str]:
    """One question to the library: the answer as JSON, and of a proof its log and the name of its scene. Options that are
    None are left out."""
    try:
        written = _known_options(name, **options)
    except TypeError:  # of what cannot be a key
        written = _written(name, **options)
    return _taut2d.ask(about, name, written, log)


def asked_scene(scene: Any) -> Union[_taut2d.ReadScene, _taut2d.SceneText]:
    """What ask() is given about a scene."""
    return read_scene(scene) if isinstance(scene, Scene) else scene_text(scene)


def scene_text(scene: Any, place: str = "scene") -> _taut2d.SceneText:
    if not isinstance(scene, Scene):
        raise InputError(place, f"expected a Scene, found {type(scene).__name__}",
                         "Scene.load(path) reads a file, and Scene.from_json(text) the text of one")
    return scene._text()

"""The page of `taut view`, with a scene in it: in Jupyter, or as a file."""

from __future__ import annotations

import html
import json
import os
import sys
from typing import Any, Optional, Union

from ._numbers import number
from .errors import InputError
from .parts import GeojsonFile, WktFile
from .motions import CsvKeyframes
from .scene import Scene
from .words import Touch

__all__ = ["Viewer", "viewer_of"]

_MARKER = "@TAUT-DATA@"
_PLACES = (os.path.join(os.path.dirname(__file__), "viewer.html"),
           *(os.path.join(p, "share", "taut", "viewer.html") for p in (sys.prefix, "/usr/local", "/usr")))


class Viewer:
    """A page that shows a motion in a browser and computes it anew there, by the library itself: it can be stopped, gone
    through, and looked at closely. ``page``: its HTML, about three megabytes, which need no network. Jupyter shows it in
    place, and keeps all of it in the notebook."""

    def __init__(self, page: str) -> None:
        self.page = page

    def save(self, path: Union[str, os.PathLike[str]]) -> None:
        """Writes the page into a file, which any browser opens."""
        with open(path, "w", encoding="utf-8") as file:
            file.write(self.page)

    def _repr_html_(self) -> str:
        # A document of its own, which reaches nothing of the page around it.
        return (f'<iframe sandbox="allow-scripts allow-downloads" srcdoc="{html.escape(self.page)}" '
                'style="width: 100%; height: 600px; border: 1px solid #ccc"></iframe>')


def _template(path: Optional[Union[str, os.PathLike[str]]]) -> str:
    places = _PLACES if path is None else (os.fspath(path),)
    found = next((place for place in places if os.path.isfile(place)), None)
    hint = "build it by `./dev web` and `./dev python`, or name it: view(template=...)"
    if found is None:
        raise InputError("template", "the viewer's page is missing; looked for " + ", ".join(map(str, places)), hint)
    with open(found, encoding="utf-8") as file:
        text = file.read()
    if text.count(_MARKER) != 1:
        raise InputError(str(found), f"this is no template of the viewer: {_MARKER} must occur once", hint)
    return text


def _require_no_files(scene: Scene) -> None:
    """The page has the scene alone."""
    for body in scene.bodies:
        shapes = body.shape if isinstance(body.shape, tuple) else (body.shape,)
        if isinstance(body.motion, CsvKeyframes) or any(isinstance(s, (WktFile, GeojsonFile)) for s in shapes):
            raise InputError(body.name, "it is read from a file, which the page cannot do",
                             "`taut view` puts what files say into the page")


def questions_of(intervals: bool, clearance: bool, profile: Optional[int], separate: bool) -> dict[str, Any]:
    """What the page asks, as ``taut view`` writes it."""
    ask: dict[str, Any] = {name: {} for name, wanted in (("intervals", intervals), ("clearance", clearance)) if wanted}
    if profile is not None:
        if not isinstance(profile, int) or not 2 <= profile <= 1000000:
            raise InputError("profile", f"{profile!r} is no number of instants", "give 2 to 1000000, or None")
        ask["distance_profile"] = {"instants": profile}
    if separate:
        ask["separate"] = {}
    return ask


def viewer_of(scene: Scene, touch: Touch, at: Optional[float], ask: dict[str, Any],
              template: Optional[Union[str, os.PathLike[str]]]) -> Viewer:
    """See Scene.view()."""
    _require_no_files(scene)
    scene.validate()
    if touch not in ("open", "closed"):
        raise InputError("touch", f"unknown value {touch!r}", 'one of "open", "closed"')
    about: dict[str, Any] = {"touch": touch, "scene": json.loads(scene.to_json())}
    if ask:
        about["ask"] = ask
    if at is not None:
        about["at"] = number(at, "at")
        if not scene.time[0] <= about["at"] <= scene.time[1]:
            raise InputError("at", f"{at} is outside of the scene's time, {list(scene.time)}", "choose an instant within")
    # It stands inside a script element: no "</script>" and no "<!--" may occur in it.
    data = json.dumps(about, ensure_ascii=False).replace("<", "\\u003c")
    return Viewer(_template(template).replace(_MARKER, data))

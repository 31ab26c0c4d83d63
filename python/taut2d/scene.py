"""Scenes: bodies, how they move, and the time interval in question."""

from __future__ import annotations

import json
import os
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field, replace
from typing import TYPE_CHECKING, Any, Optional, Union

from . import _taut2d, pictures
from ._numbers import is_sequence, number, numbers, time_span
from ._text_form import TextForm
from .answers import Answer, Contact
from .errors import InputError
from .motions import (CsvKeyframes, Free, Keyframes, Motion, Pieces, Polynomial, Revolute, Slide, Sweep, Velocity,
                      motion_from_json)
from .parts import (GeojsonFile, OnePart, Part, Path, WktFile, flatten_hint, layers, plain_state,
                    shape_of_value)
from .pictures import Pose
from .words import AtRest, Touch

if TYPE_CHECKING:
    from .viewer import Viewer

__all__ = ["Body", "PairClearance", "Scene"]

_motions = (Keyframes, CsvKeyframes, Velocity, Sweep, Polynomial, Pieces, Revolute, Slide, Free)


def _name(value: Any, place: str) -> str:
    if not isinstance(value, str):
        raise InputError(place, f"expected a name, found {type(value).__name__}", 'name the body, "lid", say')
    return value


def _two_names(given: Any, place: str) -> tuple[str, str]:
    pair = (given,) if isinstance(given, str) else tuple(given)
    if len(pair) != 2:
        raise InputError(place, "expected two names", 'write ("door", "pin"), or ("door", "*")')
    return _name(pair[0], f"{place}[0]"), _name(pair[1], f"{place}[1]")


@dataclass(frozen=True)
class Body:
    """A rigid body.

    ``name``: what answers call it; all bodies of a scene have different names.
    ``shape``: a list of (x, y) or a numpy array with two columns, vertices in order, where the first one may be
    repeated at the end; a Part, which may have holes; a list of shapes, which move together and may overlap; any object with ``__geo_interface__``
    (a Polygon or MultiPolygon of shapely, a feature of geopandas, a Shape), or the GeoJSON dictionary itself; a string of WKT,
    POLYGON or MULTIPOLYGON, if shapely is installed; WktFile or GeojsonFile. Afterwards it is a Part, a file, or a
    tuple of these.
    ``motion``: one of taut2d.motions, or None: it rests.
    ``relative_to``: the name of another body, in whose frame the motion is seen: an arm's second link, from the first.
    Chains have at most 16 bodies.
    ``id``: any JSON value, which answers hand through; None is no id.
    ``z``: the layers that the body reaches through, (lo, hi) across the plane, where None is no end; None: all. Bodies can meet only where the
    insides of these intervals do: plates that lie flush on each other do not. Parts may have layers of their own.

    Raises InputError for what is not a shape or a number; that a boundary does not cross itself, and the like, is looked
    at by check() and Scene.validate().
    """

    name: str
    shape: Any
    motion: Optional[Motion] = None
    relative_to: Optional[str] = None
    id: Any = None
    z: Optional[Sequence[Optional[float]]] = None

    def __post_init__(self) -> None:
        _name(self.name, "name")
        object.__setattr__(self, "z", layers(self.z, f"{self.name}: z"))
        try:
            object.__setattr__(self, "shape", shape_of_value(self.shape, "shape"))
        except InputError as error:
            raise InputError(f"{self.name}: {error.place}", error.problem, error.hint) from error
        if self.motion is not None and not isinstance(self.motion, _motions):
            raise InputError(f"{self.name}: motion", f"expected a motion, found {type(self.motion).__name__}",
                             "write Keyframes, Sweep, Velocity, Polynomial, Pieces or CsvKeyframes, in a Linkage Revolute, "
                             "Slide or Free, or None")

    def _json(self, polygon: Any = None) -> dict[str, Any]:
        """With another polygon than its own, if one is given."""
        object: dict[str, Any] = {"name": self.name}
        if self.id is not None:
            object["id"] = self.id
        if isinstance(self.shape, tuple):
            object["parts"] = [part._json() for part in self.shape]
        else:
            object["polygon"] = self.shape._json() if polygon is None else polygon
        if self.z is not None:
            object["z"] = list(self.z)
        if self.relative_to is not None:
            object["relative_to"] = _name(self.relative_to, f"{self.name}: relative_to")
        if self.motion is not None:
            object["motion"] = self.motion._json()
        return object


def _body_from_json(value: dict[str, Any]) -> Body:
    def part(given: Any) -> OnePart:
        if isinstance(given, dict):
            if "wkt" in given:
                return WktFile(given["wkt"], given.get("z"))
            if "path" in given:
                return Path(given["path"], given.get("fill-rule", "nonzero"), given.get("z"))
            if "geojson" in given:
                return GeojsonFile(given["geojson"], given.get("z"))
            return Part(given["outline"], tuple(given.get("holes", ())), given.get("z"))
        return Part(given)

    shape: Any = [part(p) for p in value["parts"]] if "parts" in value else part(value["polygon"])
    return Body(value["name"], shape, motion_from_json(value.get("motion")), value.get("relative_to"), value.get("id"),
                value.get("z"))


@dataclass(frozen=True)
class PairClearance:
    """What a pair of bodies is to keep, for check_clearance(), instead of the clearance that is asked about.

    ``pair``: two names; "*" is every other body. What names both bodies counts before what names one of them, and that
    before "*" twice.
    ``margin``: a distance; or the coefficients of a polynomial in the time since ``origin``, in ascending powers: (0.2, 0.05)
    is 0.2 + 0.05 (t - origin). It is not negative at any time of the scene, nor 0 at all of them.
    """

    pair: Sequence[str]
    margin: Union[float, Sequence[float]]
    origin: float = 0.0

    def __post_init__(self) -> None:
        object.__setattr__(self, "pair", _two_names(self.pair, "pair"))
        margin = self.margin
        object.__setattr__(self, "margin", numbers(margin, "margin") if is_sequence(margin) else number(margin, "margin"))
        object.__setattr__(self, "origin", number(self.origin, "origin"))

    def _json(self) -> dict[str, Any]:
        margin = list(self.margin) if isinstance(self.margin, tuple) else self.margin
        written: dict[str, Any] = {"pair": list(self.pair), "margin": margin}
        if self.origin != 0:
            written["origin"] = self.origin
        return written


@dataclass(frozen=True)
class Scene(TextForm):
    """Bodies and a closed time interval: when do two of the bodies first touch?

    ``bodies``: one or more Body.
    ``time``: (start, end), in the unit of the motions.
    ``ignore``: pairs of names that are not tested, [("door", "pin"), ("chassis", "*")]; "*" is every other body.
    ``id``: any JSON value, which the answer hands through; None is no id.
    ``folder``: where the files that bodies name are looked up; they must lie below it.
    ``at_rest``: what to do about pairs that do not move relative to each other, since both rest or both have the same
    motion: "test" them at the start; or "skip" them, unless nothing in the scene moves relative to anything else. Every
    answer counts what was skipped: see Coverage.
    ``mechanism``: how bodies are joined, as the scene format has it: a dict with "ground", "joints", "drive" and "couple"
    (docs/mechanisms.md). Joined bodies have no motion of their own.
    ``clearances``: of PairClearance, what certain pairs are to keep: see check_clearance().
    """

    bodies: Sequence[Body]
    time: Sequence[float]
    ignore: Sequence[Sequence[str]] = ()
    id: Any = None
    folder: Union[str, os.PathLike[str]] = field(default=".", compare=False)
    at_rest: AtRest = "skip"
    mechanism: Optional[Mapping[str, Any]] = None
    clearances: Sequence[PairClearance] = ()

    def __post_init__(self) -> None:
        if self.at_rest not in ("skip", "test"):
            raise InputError("at_rest", f"unknown value {self.at_rest!r}", 'write "skip" or "test"')
        bodies = (self.bodies,) if isinstance(self.bodies, Body) else tuple(self.bodies)
        for i, body in enumerate(bodies):
            if not isinstance(body, Body):
                raise InputError(f"bodies[{i}]", f"expected a Body, found {type(body).__name__}",
                                 "write Body(name, shape, motion)")
        object.__setattr__(self, "bodies", bodies)
        object.__setattr__(self, "time", time_span(self.time, "time"))
        object.__setattr__(self, "ignore", tuple(_two_names(pair, f"ignore[{i}]") for i, pair in enumerate(self.ignore)))
        for i, clearance in enumerate(self.clearances):
            if not isinstance(clearance, PairClearance):
                raise InputError(f"clearances[{i}]", f"expected a PairClearance, found {type(clearance).__name__}",
                                 'write PairClearance(("arm", "wall"), 0.5)')
        object.__setattr__(self, "clearances", tuple(self.clearances))
        object.__setattr__(self, "folder", os.fspath(self.folder))

    def to_json(self) -> str:
        """The scene in the format taut-scene/1, on one line: what ``taut check`` reads. Every number reads back as the
        same double. Raises InputError if an id is no JSON value."""
        return self._json([body._json() for body in self.bodies])

    def _json(self, bodies: list[dict[str, Any]]) -> str:
        object: dict[str, Any] = {"format": "taut-scene/1", "time": list(self.time)}
        if self.id is not None:
            object["id"] = self.id
        object["bodies"] = bodies
        if self.ignore:
            object["ignore"] = [list(pair) for pair in self.ignore]
        if self.clearances:
            object["clearances"] = [clearance._json() for clearance in self.clearances]
        if self.at_rest != "skip":
            object["at_rest"] = self.at_rest
        if self.mechanism is not None:
            object["mechanism"] = self.mechanism
        try:
            return json.dumps(object, separators=(",", ":"), ensure_ascii=False, allow_nan=False)
        except (TypeError, ValueError) as error:
            raise InputError("id", str(error), "an id is a JSON value: a string, a number, a list, a dict") from error

    @classmethod
    def _read(cls, text: str, name: str, folder: Union[str, os.PathLike[str]]) -> Scene:
        # The library knows the format, and says what is wrong; after that, there is nothing left to doubt here.
        _taut2d.read(_scene_text(text, name, folder))
        object = json.loads(text)
        return cls([_body_from_json(body) for body in object["bodies"]], object["time"], object.get("ignore", ()),
                   object.get("id"), folder, object.get("at_rest", "skip"), object.get("mechanism"),
                   [PairClearance(**clearance) for clearance in object.get("clearances", ())])

    def with_motion(self, name: str, motion: Optional[Motion]) -> Scene:
        """The same scene, in which one body moves in another way. Raises InputError if there is no such body."""
        if all(body.name != name for body in self.bodies):
            raise InputError("bodies", f"there is no body {name!r}", "bodies are called " + _names(self))
        return replace(self, bodies=[replace(b, motion=motion) if b.name == name else b for b in self.bodies])

    def validate(self) -> None:
        """Raises InputError for everything that check() would refuse: boundaries that cross themselves, motions that
        jump, names that are not there."""
        with _plain_places():
            _taut2d.validate(self._text())

    def poses(self, t: float) -> dict[str, Pose]:
        """Where every body is at an instant, seen from the world: parents are composed. Rounded, good for pictures and
        no part of a proof. Raises InputError if the scene is not valid, or the instant outside of its time."""
        with _plain_places():
            found = pictures.poses(self, [number(t, "t")])[0]
        return {body.name: pose for body, pose in zip(self.bodies, found)}

    def plot(self, ax: Any = None, at: Union[None, float, Answer, Contact] = None) -> Any:
        """Draws the bodies at an instant by matplotlib, and returns the axes.

        ``ax``: axes to draw into; None makes a new figure. ``at``: a time; or an Answer or a Contact, which is marked,
        with the normal of its edge; None is the start. Raises ImportError if matplotlib is missing, InputError if the
        scene is not valid or the instant outside of its time.
        """
        with _plain_places():
            return pictures.plot(self, ax, at)

    def animate(self, ax: Any = None, until: Union[None, float, Answer, Contact] = None, *, frames: int = 120,
                seconds: float = 6.0) -> Any:
        """Draws the motion by matplotlib, as a FuncAnimation, which must be kept until it is shown or saved:
        ``scene.animate().save("motion.gif")``, or ``.to_jshtml()`` in a notebook.

        ``until``: a time; or an Answer or a Contact, which is marked in the last frame; None is the end. ``frames``:
        how many, 2 or more, which ``seconds`` pass evenly. ``ax`` and errors as in plot().
        """
        with _plain_places():
            return pictures.animate(self, ax, until, frames, seconds)

    def view(self, *, touch: Touch = "open", at: Optional[float] = None, intervals: bool = False,
             clearance: bool = False, profile: Optional[int] = None, separate: bool = False,
             template: Union[None, str, os.PathLike[str]] = None) -> Viewer:
        """The viewer, as ``taut view`` writes it: Jupyter shows it in place, and ``.save(path)`` makes a page of it.

        ``touch``: as in check(). ``at``: the instant to show first; None is the start. ``intervals``, ``clearance``,
        ``profile`` (a number of instants, 2 to 1,000,000), ``separate``: what the page asks besides, from the beginning:
        intervals(), clearance(), distance_profile() and separate(); the reader can ask all of it, too. ``template``: the page that
        ``./dev web`` builds; None looks in the package, and where taut is installed. Raises InputError if there is none,
        if the scene is not valid, or if it names files.
        """
        from .viewer import questions_of, viewer_of
        return viewer_of(self, touch, at, questions_of(intervals, clearance, profile, separate), template)

    def _repr_html_(self) -> str:
        """What Jupyter shows: the motion, or what is wrong with the scene."""
        from .notebook import html_of_scene
        return html_of_scene(self)

    def _text(self, bodies: Optional[list[dict[str, Any]]] = None) -> _taut2d.SceneText:
        return _scene_text(self.to_json() if bodies is None else self._json(bodies), _unnamed, self.folder)

    def __getstate__(self) -> dict[str, Any]:
        return plain_state(self)


def _names(scene: Scene) -> str:
    return ", ".join(repr(body.name) for body in scene.bodies)


def _scene_text(text: str, name: str, folder: Union[str, os.PathLike[str]]) -> _taut2d.SceneText:
    if not isinstance(text, str):
        raise InputError("", f"expected text, found {type(text).__name__}", "give the JSON of a scene as a str")
    try:
        data = text.encode("utf-8")
    except UnicodeEncodeError as error:
        raise InputError("", f"half of a surrogate pair is no character: {text[error.start]!r}") from error
    return _taut2d.SceneText(data, os.fsencode(name), os.fsencode(folder))


# What stands for the text of a scene that was not read from a file; where it is in that text helps nobody.
_unnamed = "\x01"


class _plain_places:
    """Errors about a scene that was made here name no line and no column of a text that nobody has seen, and remedies in
    Python."""

    def __enter__(self) -> None:
        pass

    def __exit__(self, kind: Any, error: Any, trace: Any) -> None:
        if not isinstance(error, InputError):
            return
        row, unnamed, rest = error.place.partition(_unnamed)
        place = row + rest.partition(": ")[2] if unnamed else error.place
        # The library names its program, which is of no use here.
        hint = flatten_hint if error.hint.startswith("`taut flatten") else error.hint
        if (place, hint) != (error.place, error.hint):
            raise InputError(place, error.problem, hint) from None

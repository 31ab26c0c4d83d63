"""Motions: how a body moves in time. A body without a motion rests.

Angles are in degrees, counterclockwise, except in Polynomial; time and lengths are in units of your own. Numbers are
IEEE doubles and are taken exactly; what is written in degrees or by keyframes is rounded once, as docs/scenes.md says.
"""

from __future__ import annotations

import os
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any, ClassVar, Optional, Union, get_args

from .errors import InputError
from ._numbers import number, numbers, path_text, point

__all__ = [
    "Angle", "Arc", "Cosine", "CsvKeyframes", "Direction", "Free", "HalfAngleTangent", "Keyframe", "Keyframes", "Orbit",
    "Pieces", "Polynomial", "Revolute", "Slide", "Sweep", "Turn", "Velocity",
]

# What is accepted; once made, fields hold tuples of floats.
Point = Sequence[float]
Coefficients = Sequence[float]


def _set(instance: Any, **values: Any) -> None:
    """Sets fields of a frozen instance: only its own __post_init__ may."""
    for name, value in values.items():
        object.__setattr__(instance, name, value)


def _pivot(pivot: Any) -> Optional[Point]:
    return None if pivot is None else point(pivot, "pivot")


def _pivot_json(pivot: Optional[Point]) -> dict[str, Any]:
    return {} if pivot is None else {"pivot": list(pivot)}


@dataclass(frozen=True)
class Keyframe:
    """At time ``t`` the body is moved by (``x``, ``y``) and turned by ``angle_deg`` degrees. The way from the keyframe
    before is straight, and the angle changes evenly: from 350 to 370 is 20 degrees, from 350 to 10 is -340."""

    t: float
    x: float = 0.0
    y: float = 0.0
    angle_deg: float = 0.0

    def __post_init__(self) -> None:
        _set(self, t=number(self.t, "t"), x=number(self.x, "x"), y=number(self.y, "y"),
             angle_deg=number(self.angle_deg, "angle_deg"))

    def _json(self) -> dict[str, Any]:
        return {"t": self.t, "x": self.x, "y": self.y, "angle_deg": self.angle_deg}


@dataclass(frozen=True)
class Turn:
    """Until time ``t`` the body goes around ``center`` by ``deg`` degrees and turns with it, like a car. The circle is
    exact. It begins where the keyframe before has ended, and is never the first of the keyframes."""

    t: float
    center: Point
    deg: float

    def __post_init__(self) -> None:
        _set(self, t=number(self.t, "t"), center=point(self.center, "center"), deg=number(self.deg, "deg"))

    def _json(self) -> dict[str, Any]:
        return {"t": self.t, "turn": {"center": list(self.center), "deg": self.deg}}


@dataclass(frozen=True)
class Arc:
    """As Turn, but the body does not turn, like a tool on a circular path."""

    t: float
    center: Point
    deg: float

    def __post_init__(self) -> None:
        _set(self, t=number(self.t, "t"), center=point(self.center, "center"), deg=number(self.deg, "deg"))

    def _json(self) -> dict[str, Any]:
        return {"t": self.t, "arc": {"center": list(self.center), "deg": self.deg}}


def _keyframe(given: Any, place: str) -> Union[Keyframe, Turn, Arc]:
    if isinstance(given, (Keyframe, Turn, Arc)):
        return given
    hint = "write Keyframe(t, x, y, angle_deg), or (t, x, y) or (t, x, y, angle_deg), or Turn(...) or Arc(...)"
    try:
        if isinstance(given, Mapping):
            if "turn" in given:
                return Turn(given["t"], **given["turn"])
            if "arc" in given:
                return Arc(given["t"], **given["arc"])
            return Keyframe(**given)
        values = tuple(given)
        if len(values) not in (3, 4):
            raise InputError(place, f"expected 3 or 4 numbers, found {len(values)}", hint)
        return Keyframe(*values)
    except (TypeError, KeyError) as error:
        raise InputError(place, "this is no keyframe", hint) from error


@dataclass(frozen=True)
class Keyframes:
    """Poses at times that ascend, linear in between; the body rests before the first and after the last.

    ``keyframes`` are Keyframe, Turn or Arc, tuples (t, x, y) or (t, x, y, angle_deg), dictionaries with these keys, or a
    numpy array with 3 or 4 columns; once made, a tuple of the three. ``pivot`` is what the body turns about, in its own coordinates; None is (0, 0).
    """

    keyframes: Any
    pivot: Optional[Point] = None

    def __post_init__(self) -> None:
        try:
            given = list(self.keyframes)
        except TypeError as error:
            raise InputError("keyframes", "this is no sequence", "give a list of keyframes") from error
        _set(self, keyframes=tuple(_keyframe(k, f"keyframes[{i}]") for i, k in enumerate(given)),
             pivot=_pivot(self.pivot))

    def _json(self) -> dict[str, Any]:
        return {"keyframes": [k._json() for k in self.keyframes], **_pivot_json(self.pivot)}


@dataclass(frozen=True)
class CsvKeyframes:
    """Keyframes from a CSV file, whose first line names the columns t, x, y, angle_deg in any order; ``t`` must be
    there. ``path`` is relative to the scene's folder, and must lie below it."""

    path: Union[str, os.PathLike[str]]
    pivot: Optional[Point] = None

    def __post_init__(self) -> None:
        _set(self, path=path_text(self.path, "path"), pivot=_pivot(self.pivot))

    def _json(self) -> dict[str, Any]:
        return {"csv": self.path, **_pivot_json(self.pivot)}


@dataclass(frozen=True)
class Velocity:
    """At time t the body is moved by t times ``velocity``, and turned by t times ``spin_deg`` degrees about ``pivot``,
    which moves along. At t = 0 it is where its shape says."""

    velocity: Point = (0.0, 0.0)
    spin_deg: float = 0.0
    pivot: Optional[Point] = None

    def __post_init__(self) -> None:
        _set(self, velocity=point(self.velocity, "velocity"), spin_deg=number(self.spin_deg, "spin_deg"),
             pivot=_pivot(self.pivot))

    def _json(self) -> dict[str, Any]:
        return {"velocity": list(self.velocity), "spin_deg": self.spin_deg, **_pivot_json(self.pivot)}


@dataclass(frozen=True)
class Sweep:
    """The body turns about ``pivot``, which rests, evenly from ``from_deg`` at the start of the scene's time to
    ``to_deg`` at its end. Answers state the angle. With the time (from_deg, to_deg), t is the angle itself."""

    from_deg: float
    to_deg: float
    pivot: Optional[Point] = None

    def __post_init__(self) -> None:
        _set(self, from_deg=number(self.from_deg, "from_deg"), to_deg=number(self.to_deg, "to_deg"),
             pivot=_pivot(self.pivot))

    def _json(self) -> dict[str, Any]:
        return {"sweep": {"from_deg": self.from_deg, "to_deg": self.to_deg, **_pivot_json(self.pivot)}}


class _RotationForm:
    """What forms of rotation have in common: dataclasses whose fields are polynomials. In scene files, a form of one
    polynomial is ``{key: [...]}``, one of several ``{key: {field: [...], ...}}``."""

    _key: ClassVar[str]

    def __post_init__(self) -> None:
        _set(self, **{name: numbers(value, name) for name, value in vars(self).items()})

    def _json(self) -> dict[str, Any]:
        polynomials = {name: list(value) for name, value in vars(self).items()}
        if len(polynomials) > 1:
            return {self._key: polynomials}
        (only,) = polynomials.values()
        return {self._key: only}


@dataclass(frozen=True)
class Angle(_RotationForm):
    """A rotation by an angle in radians, a polynomial in time: coefficients in ascending powers."""

    _key = "angle"
    angle: Coefficients


@dataclass(frozen=True)
class Direction(_RotationForm):
    """A rotation that takes the x axis to the direction (a, b), polynomials in time that never vanish together."""

    _key = "direction"
    a: Coefficients
    b: Coefficients


@dataclass(frozen=True)
class HalfAngleTangent(_RotationForm):
    """A rotation by the angle whose half has the tangent ``s``, a polynomial in time."""

    _key = "half_angle_tangent"
    s: Coefficients


@dataclass(frozen=True)
class Cosine(_RotationForm):
    """A rotation by the angle between 0 and 180 degrees with the cosine ``a``, a polynomial in time within [-1, 1]."""

    _key = "cosine"
    a: Coefficients


Rotation = Union[Angle, Direction, HalfAngleTangent, Cosine]


@dataclass(frozen=True)
class Orbit:
    """A turn of the place at which a body is: what it would be without is turned about ``center`` by an angle in radians,
    a polynomial in time. The body's own rotation stays what it is."""

    center: Point
    angle: Coefficients

    def __post_init__(self) -> None:
        _set(self, center=point(self.center, "center"), angle=numbers(self.angle, "angle"))

    def _json(self) -> dict[str, Any]:
        return {"center": list(self.center), "angle": list(self.angle)}


@dataclass(frozen=True)
class Polynomial:
    """The body is moved by (x(t), y(t)) and turned by ``rotation`` about ``pivot``, a point of its own.

    ``x`` and ``y`` are coefficients in ascending powers of t - ``origin``, of degree at most 16; empty is zero. So are
    those of ``rotation``. With an origin nearby, coefficients are as small as the motion, however late it takes place.
    ``until`` is the time at which the next piece of Pieces takes over; None for the last one, or for a single one.
    """

    x: Coefficients = ()
    y: Coefficients = ()
    rotation: Optional[Rotation] = None
    pivot: Optional[Point] = None
    until: Optional[float] = None
    origin: float = 0.0
    orbit: Optional[Orbit] = None

    def __post_init__(self) -> None:
        if self.orbit is not None and not isinstance(self.orbit, Orbit):
            raise InputError("orbit", f"expected an Orbit, found {type(self.orbit).__name__}", "write Orbit(center, angle)")
        if self.rotation is not None and not isinstance(self.rotation, _RotationForm):
            raise InputError("rotation", f"expected a rotation, found {type(self.rotation).__name__}",
                             "write one of " + ", ".join(f"{form.__name__}(...)" for form in get_args(Rotation)))
        _set(self, x=numbers(self.x, "x"), y=numbers(self.y, "y"), pivot=_pivot(self.pivot),
             until=None if self.until is None else number(self.until, "until"), origin=number(self.origin, "origin"))

    def _json(self) -> dict[str, Any]:
        object: dict[str, Any] = {"x": list(self.x), "y": list(self.y)}
        if self.rotation is not None:
            object["rotation"] = self.rotation._json()
        object.update(_pivot_json(self.pivot))
        if self.until is not None:
            object["until"] = self.until
        if self.origin != 0:
            object["origin"] = self.origin
        if self.orbit is not None:
            object["orbit"] = self.orbit._json()
        return object


@dataclass(frozen=True)
class Pieces:
    """Polynomials one after the other, each until its ``until``, an instant of the scene's time."""

    pieces: Sequence[Polynomial]

    def __post_init__(self) -> None:
        _set(self, pieces=tuple(self.pieces))
        for i, piece in enumerate(self.pieces):
            if not isinstance(piece, Polynomial):
                raise InputError(f"pieces[{i}]", f"expected a Polynomial, found {type(piece).__name__}")

    def _json(self) -> list[Any]:
        return [piece._json() for piece in self.pieces]


def _joint_json(vector: str, value: Point, by: str, times: float, plus: float) -> dict[str, Any]:
    return {vector: list(value), "by": by, **({} if times == 1 else {"times": times}),
            **({} if plus == 0 else {"plus": plus})}


def _joint(instance: Any, vector: str) -> None:
    if not isinstance(instance.by, str):
        raise InputError("by", f"expected the name of a joint, found {type(instance.by).__name__}")
    _set(instance, **{vector: point(getattr(instance, vector), vector)}, times=number(instance.times, "times"),
         plus=number(instance.plus, "plus"))


@dataclass(frozen=True)
class Revolute:
    """Of a Linkage: the body turns about ``pivot``, a point of its own coordinates, counterclockwise, by
    times * value + plus degrees, where value is that of the joint called ``by``."""

    pivot: Point
    by: str
    times: float = 1.0
    plus: float = 0.0

    def __post_init__(self) -> None:
        _joint(self, "pivot")

    def _json(self) -> dict[str, Any]:
        return {"revolute": _joint_json("pivot", self.pivot, self.by, self.times, self.plus)}


@dataclass(frozen=True)
class Slide:
    """Of a Linkage: the body is moved by times * value + plus times ``direction``, where value is that of the joint called
    ``by``: give a direction of length 1 if the value is a length."""

    direction: Point
    by: str
    times: float = 1.0
    plus: float = 0.0

    def __post_init__(self) -> None:
        _joint(self, "direction")

    def _json(self) -> dict[str, Any]:
        return {"slide": _joint_json("direction", self.direction, self.by, self.times, self.plus)}


@dataclass(frozen=True)
class Free:
    """Of a Linkage: the body moves freely. It turns about ``pivot``, a point of its own coordinates, by the value of the
    joint called ``deg``, in degrees, and is then moved by the values of the joints called ``x`` and ``y``. Joints that are
    None move nothing; at least one is named."""

    x: Optional[str] = None
    y: Optional[str] = None
    deg: Optional[str] = None
    pivot: Point = (0.0, 0.0)

    def __post_init__(self) -> None:
        for name in ("x", "y", "deg"):
            if not isinstance(getattr(self, name), (str, type(None))):
                raise InputError(name, f"expected the name of a joint, found {type(getattr(self, name)).__name__}")
        if self.x is None and self.y is None and self.deg is None:
            raise InputError("free", "it names no joint", 'write Free("x", "y", "turn")')
        _set(self, pivot=point(self.pivot, "pivot"))

    def _json(self) -> dict[str, Any]:
        named = {name: getattr(self, name) for name in ("x", "y", "deg") if getattr(self, name) is not None}
        return {"free": {**named, **({} if self.pivot == (0, 0) else {"pivot": list(self.pivot)})}}


Motion = Union[Keyframes, CsvKeyframes, Velocity, Sweep, Polynomial, Pieces, Revolute, Slide, Free]


def _rotation_from_json(value: Any) -> Optional[Rotation]:
    if value is None:
        return None
    form: Any = next(form for form in get_args(Rotation) if form._key in value)
    given = value[form._key]
    rotation: Rotation = form(**given) if isinstance(given, dict) else form(given)
    return rotation


def _orbit_from_json(value: Any) -> Optional[Orbit]:
    return None if value is None else Orbit(value["center"], value["angle"])


def _piece_from_json(value: dict[str, Any]) -> Polynomial:
    return Polynomial(value.get("x", ()), value.get("y", ()), _rotation_from_json(value.get("rotation")),
                      value.get("pivot"), value.get("until"), value.get("origin", 0.0), _orbit_from_json(value.get("orbit")))


def motion_from_json(value: Any) -> Optional[Motion]:
    """The motion that a scene's JSON describes, which must have been found right."""
    if value is None:
        return None
    if isinstance(value, list):
        return Pieces(tuple(_piece_from_json(piece) for piece in value))
    if "keyframes" in value:
        return Keyframes(value["keyframes"], value.get("pivot"))
    if "csv" in value:
        return CsvKeyframes(value["csv"], value.get("pivot"))
    if "sweep" in value:
        return Sweep(**value["sweep"])
    if "velocity" in value or "spin_deg" in value:
        return Velocity(**value)
    if "revolute" in value:
        return Revolute(**value["revolute"])
    if "slide" in value:
        return Slide(**value["slide"])
    if "free" in value:
        return Free(**value["free"])
    return _piece_from_json(value)

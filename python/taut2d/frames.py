"""Tables of pandas and GeoPandas: moving features in, answers out."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from typing import TYPE_CHECKING, Any, Optional, Union

from ._numbers import doubles, numpy_for
from .answers import Answer
from .errors import InputError
from .many import Outcome
from .motions import Keyframes
from .scene import Body, Scene

if TYPE_CHECKING:
    from pandas import DataFrame

__all__ = ["answers_frame", "scene_from_frame"]


def _pandas() -> Any:
    try:
        import pandas
    except ImportError as error:
        raise ImportError("tables need pandas, which is not installed: on Debian, python3-pandas") from error
    return pandas


def _column(frame: Any, name: str) -> Any:
    if name not in frame.columns:
        raise InputError(name, "there is no such column", "the table has " + ", ".join(map(str, frame.columns)))
    return frame[name]


def _require_lengths(frame: Any) -> None:
    """Degrees of longitude are no lengths."""
    crs = getattr(frame, "crs", None)
    if crs is not None and crs.is_geographic:
        raise InputError("crs", f"coordinates in {crs.name} are angles, not lengths",
                         "choose a projection in metres: frame.to_crs(...)")


def _positions(frame: Any) -> Any:
    """Two columns of numbers: of points, or of the columns x and y."""
    if "geometry" not in frame.columns:
        return doubles(frame[["x", "y"]].to_numpy() if {"x", "y"} <= set(frame.columns) else _column(frame, "x"))
    _require_lengths(frame)
    kinds = set(frame.geometry.geom_type)
    if kinds - {"Point"}:
        raise InputError("geometry", f"expected a Point in each row, found {', '.join(sorted(map(str, kinds)))}",
                         "shapes are another argument; rows say where they are")
    return numpy_for("tables").column_stack([frame.geometry.x, frame.geometry.y])


def _seconds(times: Any, origin: Any) -> Any:
    """Times as numbers: those of a calendar in seconds from the origin on."""
    pandas = _pandas()
    if not pandas.api.types.is_datetime64_any_dtype(times):
        return doubles(times.to_numpy())
    begin = times.min() if origin is None else pandas.Timestamp(origin)
    # In two steps: nanoseconds of years are more than doubles count.
    since = (times - begin).dt
    return since.days.to_numpy() * 86400.0 + since.seconds.to_numpy() + since.nanoseconds.to_numpy() * 1e-9 + (
        since.microseconds.to_numpy() * 1e-6)


def _rows(frame: Any, time: str, angle: Optional[str], origin: Any) -> Any:
    """t, x, y and the angle in degrees of each row."""
    numpy = numpy_for("tables")
    turned = numpy.zeros(len(frame)) if angle is None else doubles(_column(frame, angle).to_numpy())
    rows = numpy.column_stack([_seconds(_column(frame, time), origin), _positions(frame), turned])
    if not numpy.isfinite(rows).all():
        raise InputError(f"row {int(numpy.argmin(numpy.isfinite(rows).all(axis=1)))}", "a number is missing",
                         "leave out rows without a time or a place: frame.dropna()")
    return rows


def _motion(rows: Any, feature: str) -> tuple[Keyframes, float, float]:
    """From row to row, turning the shorter way; and when it begins and ends."""
    numpy = numpy_for("tables")
    rows = rows[numpy.argsort(rows[:, 0], kind="stable")]
    if (numpy.diff(rows[:, 0]) <= 0).any():
        raise InputError(feature, "it is in two rows at one time", "leave out one of them: frame.drop_duplicates(...)")
    rows[:, 3] = numpy.unwrap(rows[:, 3], period=360)
    return Keyframes(rows), float(rows[0, 0]), float(rows[-1, 0])


def _resting(frame: Any, name: str) -> list[Body]:
    _require_lengths(frame)
    names = [str(value) for value in (frame[name] if name in frame.columns else frame.index)]
    return [Body(label, shape) for label, shape in zip(names, frame.geometry)]


def scene_from_frame(moving: Any, shape: Any, *, static: Any = None, name: str = "name", time: str = "time",
                     angle: Optional[str] = None, origin: Any = None) -> Scene:
    """A scene of moving features: a table that says where each is, at some times, as GeoPandas and MovingPandas have it.

    ``moving``: a GeoDataFrame with a Point in each row, or a DataFrame with columns x and y; rows of the same ``name`` are
    one feature, in any order. From row to row it moves straight and evenly.
    ``shape``: what Body takes, around (0, 0), for all features; or a dictionary of them by name.
    ``static``: a GeoDataFrame of polygons that rest, named by the same column, or by the index; or None.
    ``time``: a column of numbers, or of dates, which become seconds from ``origin`` on; None: from the earliest.
    ``angle``: a column of degrees, counterclockwise, or None: nothing turns. A feature turns the shorter way to its next
    row's angle.

    The scene's time is that for which all features have rows. Coordinates are lengths: InputError for those in degrees,
    as for missing numbers, for times that come twice, and where there is no common time.
    """
    rows = _rows(moving, time, angle, origin)
    bodies, begins, ends = [], [], []
    for label, places in moving.reset_index(drop=True).groupby(name, sort=False).groups.items():
        motion, begin, end = _motion(rows[places], str(label))
        found = shape[label] if isinstance(shape, Mapping) and "type" not in shape else shape
        bodies.append(Body(str(label), found, motion))
        begins.append(begin)
        ends.append(end)
    if not bodies:
        raise InputError("moving", "the table has no rows", "give at least one feature")
    if not max(begins) <= min(ends):
        raise InputError(time, "there is no time for which all features have rows",
                         "leave out those that come later, or ask about each time by itself")
    return Scene([*([] if static is None else _resting(static, name)), *bodies], (max(begins), min(ends)))


def _row_of(answer: Answer) -> dict[str, Any]:
    contact = answer.contact or answer.touching
    row: dict[str, Any] = {"outcome": answer.outcome, "free_until": answer.free_until, "touching": answer.touching is not None,
                           "untested": answer.coverage.untested}
    if answer.pair is not None:
        row["body_1"], row["body_2"] = answer.pair
    if contact is not None:
        row.update(t_lo=contact.t[0], t_hi=contact.t[1], x=contact.point[0], y=contact.point[1],
                   normal_x=contact.normal[0], normal_y=contact.normal[1], vertex_body=contact.vertex.body,
                   vertex=contact.vertex.index, edge_body=contact.edge.body, edge=contact.edge.index)
    elif answer.overlap_point is not None:
        row["x"], row["y"] = answer.overlap_point
    return row


_COLUMNS = ("outcome", "t_lo", "t_hi", "free_until", "body_1", "body_2", "x", "y", "normal_x", "normal_y", "vertex_body",
            "vertex", "edge_body", "edge", "touching", "untested")


def _from_array(answers: Any, names: Optional[list[str]]) -> dict[str, Any]:
    """Columns of an array of answer_dtype(); bodies by their names, if they are known."""
    pandas = _pandas()

    def bodies(places: Any) -> Any:
        found = pandas.array(places, dtype="Int64")
        found[places < 0] = pandas.NA
        return found if names is None else pandas.array([None if k < 0 else names[k] for k in places], dtype="object")

    def indices(places: Any) -> Any:
        found = pandas.array(places, dtype="Int64")
        found[places < 0] = pandas.NA
        return found

    return {"outcome": [Outcome(k).name.lower() for k in answers["outcome"]], "t_lo": answers["t_lo"], "t_hi": answers["t_hi"],
            "free_until": pandas.Series(answers["free_until"]).where(answers["outcome"] == Outcome.UNDECIDED), "body_1": bodies(answers["pair"][:, 0]), "body_2": bodies(answers["pair"][:, 1]),
            "x": answers["point"][:, 0], "y": answers["point"][:, 1], "normal_x": answers["normal"][:, 0],
            "normal_y": answers["normal"][:, 1], "vertex_body": bodies(answers["vertex"]["body"]),
            "vertex": indices(answers["vertex"]["index"]), "edge_body": bodies(answers["edge"]["body"]),
            "edge": indices(answers["edge"]["index"]), "touching": answers["touching"], "untested": answers["untested"]}


def answers_frame(answers: Union[Any, Iterable[Answer]], scene: Optional[Scene] = None) -> DataFrame:
    """Answers as a table of pandas, a row each.

    ``answers``: what check_many() gives, or SweepAnswers.array(), or any number of what check() gives. ``scene``: the one
    that was asked about, which names the bodies of an array; without it they are numbers.

    Columns: outcome, t_lo, t_hi, free_until, body_1 and body_2 (the pair), x, y, normal_x, normal_y, vertex_body, vertex,
    edge_body, edge, touching, untested, as in Answer; what there is not is missing.
    """
    pandas = _pandas()
    names = None if scene is None else [body.name for body in scene.bodies]
    if getattr(getattr(answers, "dtype", None), "names", None):
        frame = pandas.DataFrame(_from_array(answers, names))
    else:
        frame = pandas.DataFrame([_row_of(answer) for answer in answers]).reindex(columns=list(_COLUMNS))
        for column in ("vertex", "edge"):
            frame[column] = frame[column].astype("Int64")
    frame["outcome"] = pandas.Categorical(frame["outcome"], [outcome.name.lower() for outcome in Outcome])
    found: DataFrame = frame[list(_COLUMNS)]
    return found

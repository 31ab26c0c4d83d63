"""Pictures of scenes by matplotlib: at one instant, and moving."""

from __future__ import annotations

import struct
from typing import TYPE_CHECKING, Any, NamedTuple, Optional, Union

from . import _taut2d
from ._numbers import number
from .answers import Answer, Contact
from .errors import InputError

if TYPE_CHECKING:
    from .scene import Scene

# Fills and lines of bodies in turn, those of the library's own pictures.
_FILLS = ("#2a6f9e", "#e59345", "#159185", "#f0d762", "#683b6a", "#7abee4", "#966042", "#f5accc", "#1e4070", "#6ca45a",
          "#838a8f", "#daeaa8")
_LINES = ("#032e4b", "#683e15", "#00423c", "#675b1e", "#341c35", "#2e5366", "#472b1b", "#6d4758", "#0f203a", "#2c4923",
          "#3a3d40", "#5b6342")
_MARK = "#d7191c"

Instant = Union[None, float, Answer, Contact]


class Pose(NamedTuple):
    """Where a body is: its point (u, v) is at (x + u cos - v sin, y + u sin + v cos). Rounded; for pictures."""

    x: float
    y: float
    cos: float
    sin: float


def _matplotlib() -> Any:
    try:
        import matplotlib
    except ImportError as error:
        raise ImportError("pictures are drawn by matplotlib, which is not installed: on Debian, python3-matplotlib") \
            from error
    return matplotlib


def poses(scene: Scene, times: list[float]) -> list[list[Pose]]:
    """Of all bodies at each of the times."""
    for t in times:
        if not scene.time[0] <= t <= scene.time[1]:
            raise InputError("at", f"{t} is outside of the scene's time, {list(scene.time)}", "choose an instant within")
    found = [Pose(*four) for four in struct.iter_unpack("dddd", _taut2d.poses(scene._text(), times))]
    bodies = len(scene.bodies)
    return [found[i * bodies:(i + 1) * bodies] for i in range(len(times))]


def instant(scene: Scene, at: Instant) -> tuple[float, Optional[Contact], Optional[tuple[float, float]]]:
    """When that is, with the contact and the point in the overlap that are to be marked."""
    if isinstance(at, Contact):
        return at.t[0], at, None
    if isinstance(at, Answer):
        contact = at.contact or at.touching
        if contact is not None:
            return contact.t[0], contact, None
        if at.outcome == "overlap_at_start":
            return scene.time[0], None, at.overlap_point
        return scene.time[1] if at.free_until is None else at.free_until, None, None
    return scene.time[0] if at is None else number(at, "at"), None, None


class _Drawn:
    """The bodies of a scene as patches on axes, which poses are put into."""

    def __init__(self, scene: Scene, axes: Any) -> None:
        import numpy
        from matplotlib.patches import PathPatch
        self._axes = axes
        self._points = []
        self._patches = []
        for i, parts in enumerate(_taut2d.rings(scene._text())):
            rings = [numpy.frombuffer(ring).reshape(-1, 2) for part in parts for ring in part]
            self._points.append(numpy.vstack(rings))
            for part in parts:
                patch = PathPatch(_compound(part), facecolor=_FILLS[i % len(_FILLS)],
                                  edgecolor=_LINES[i % len(_LINES)], alpha=0.9,
                                  linewidth=1, label=scene.bodies[i].name if part is parts[0] else None)
                patch.taut2d_body = i
                self._patches.append(axes.add_patch(patch))

    def put(self, placed: list[Pose]) -> list[Any]:
        from matplotlib.transforms import Affine2D
        for patch in self._patches:
            x, y, cos, sin = placed[patch.taut2d_body]
            patch.set_transform(Affine2D([[cos, -sin, x], [sin, cos, y], [0, 0, 1]]) + self._axes.transData)
        return self._patches

    def bounds(self, placed: list[Pose]) -> Any:
        """The least and the greatest coordinates."""
        import numpy
        spread = []
        for points, (x, y, cos, sin) in zip(self._points, placed):
            there = points @ numpy.array([[cos, sin], [-sin, cos]]) + (x, y)
            spread += [there.min(axis=0), there.max(axis=0)]
        return numpy.array([numpy.min(spread, axis=0), numpy.max(spread, axis=0)])


def _compound(part: list[bytes]) -> Any:
    """One path of all rings, holes turning the other way than the outline: that is what leaves them out."""
    import numpy
    from matplotlib.path import Path
    paths = []
    for k, ring in enumerate(part):
        points = numpy.frombuffer(ring).reshape(-1, 2)
        x, y = points[:, 0], points[:, 1]
        turns_left = numpy.sum(x * numpy.roll(y, -1) - y * numpy.roll(x, -1)) > 0
        if turns_left != (k == 0):
            points = points[::-1]
        paths.append(Path(numpy.vstack([points, points[:1]]), closed=True))
    return Path.make_compound_path(*paths)


def _mark(axes: Any, contact: Optional[Contact], overlap: Optional[tuple[float, float]]) -> list[Any]:
    """The contact, with the edge's normal, or a point that lies in both bodies."""
    if contact is not None:
        # As long at any scale: 28 points, a point being 1/72 of an inch.
        arrow = axes.quiver(*contact.point, *contact.normal, color=_MARK, units="inches", scale_units="inches",
                            scale=72 / 28, width=0.03, zorder=5)
        return [arrow, *axes.plot(*contact.point, "o", color=_MARK, markersize=6, markeredgecolor="white", zorder=5)]
    if overlap is not None:
        return list(axes.plot(*overlap, "x", color=_MARK, markersize=9, markeredgewidth=2.5, zorder=5))
    return []


def _new_axes(axes: Any) -> Any:
    _matplotlib()
    if axes is not None:
        return axes
    from matplotlib import pyplot
    return pyplot.subplots()[1]


def _frame(axes: Any, scene: Scene, bounds: Any) -> None:
    axes.set_aspect("equal")
    axes.update_datalim(bounds)
    axes.autoscale_view()
    if len(scene.bodies) <= len(_FILLS):
        axes.legend(loc="best", fontsize="small")


def plot(scene: Scene, axes: Any = None, at: Instant = None) -> Any:
    """See Scene.plot()."""
    t, contact, overlap = instant(scene, at)
    placed = poses(scene, [t])[0]
    axes = _new_axes(axes)
    drawn = _Drawn(scene, axes)
    drawn.put(placed)
    _mark(axes, contact, overlap)
    _frame(axes, scene, drawn.bounds(placed))
    axes.set_title(f"t = {t:.6g}")
    return axes


def animate(scene: Scene, axes: Any = None, until: Instant = None, frames: int = 120, seconds: float = 6.0) -> Any:
    """See Scene.animate()."""
    if frames < 2:
        raise InputError("frames", f"{frames} are too few to show a motion", "give 2 or more")
    end, contact, overlap = instant(scene, scene.time[1] if until is None else until)
    begin = scene.time[0]
    times = [begin + (end - begin) * k / (frames - 1) for k in range(frames - 1)] + [end]
    placed = poses(scene, times)
    axes = _new_axes(axes)
    import numpy
    from matplotlib.animation import FuncAnimation
    drawn = _Drawn(scene, axes)
    _frame(axes, scene, numpy.vstack([drawn.bounds(p) for p in placed]))
    marks = _mark(axes, contact, overlap)

    def show(k: int) -> list[Any]:
        axes.set_title(f"t = {times[k]:.6g}")
        for mark in marks:
            mark.set_visible(k == frames - 1)
        return [*drawn.put(placed[k]), *marks]

    show(0)
    return FuncAnimation(axes.figure, show, frames, interval=1000 * number(seconds, "seconds") / frames)

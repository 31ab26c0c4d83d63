"""Charts of answers by matplotlib: when bodies overlap, and how far they are apart. Rounded; no part of a proof."""

from __future__ import annotations

import json
from typing import TYPE_CHECKING, Any, Optional

from ._verdict import untested_text
from .errors import InputError
from .pictures import _FILLS, _MARK, _new_axes

if TYPE_CHECKING:
    from .answers import Coverage
    from .questions import Clearance, DistanceProfile, Intervals

_UNDECIDED = "#4a4a4a"


def _label(pair: Optional[tuple[str, str]]) -> str:
    return "least of all pairs" if pair is None else " x ".join(pair)


def _require(is_there: bool, outcome: str, reason: Optional[str], what: str) -> None:
    if not is_there:
        raise InputError(what, f"there is nothing to draw: the answer is {outcome}", reason or "")


def _rows(axes: Any, labels: list[str]) -> None:
    """One row for each label, the first one at the top."""
    axes.set_yticks(list(range(len(labels))), labels)
    axes.set_ylim(max(len(labels), 1) - 0.5, -0.5)


def _title(axes: Any, coverage: Coverage, text: str = "") -> None:
    """Nobody shall take a chart to be about pairs that were not tested."""
    axes.set_title("\n".join(line for line in (text, untested_text(coverage)) if line), fontsize="medium")


def plot_intervals(answer: Intervals, axes: Any) -> Any:
    """See Intervals.plot()."""
    _require(answer.outcome != "untested", answer.outcome, answer.reason, "intervals")
    axes = _new_axes(axes)
    begin, end = map(float, json.loads(answer.json)["scope"]["time"])
    rows: dict[tuple[str, str], int] = {}
    for interval in answer.intervals:
        row = rows.setdefault(interval.pair, len(rows))
        start, stop = interval.start[0], interval.end[1]
        axes.broken_barh([(start, stop - start)], (row - 0.35, 0.7), facecolors=_MARK, edgecolors=_MARK,
                         label="overlap" if interval is answer.intervals[0] else None)
    for i, pair in enumerate(answer.undecided):
        row = rows.setdefault(pair.bodies, len(rows))
        axes.broken_barh([(begin, end - begin)], (row - 0.35, 0.7), facecolors="none", edgecolors=_UNDECIDED, hatch="///",
                         label="undecided" if i == 0 else None)
    _rows(axes, [_label(pair) for pair in rows])
    axes.set_xlim(begin, end if end > begin else begin + 1)
    axes.set_xlabel("t")
    if rows:
        axes.legend(loc="best", fontsize="small")
    nothing = "no overlap" if answer.coverage.untested == 0 else "no overlap of the tested pairs"
    _title(axes, answer.coverage, "" if rows else nothing)
    return axes


def plot_profile(answer: DistanceProfile, axes: Any) -> Any:
    """See DistanceProfile.plot()."""
    _require(bool(answer.curves), answer.outcome, answer.reason, "curves")
    axes = _new_axes(axes)
    for k, curve in enumerate(answer.curves):
        colour = _FILLS[k % len(_FILLS)]
        times = [t for start, stop, _, _ in curve.stretches for t in (start, stop)]
        lows = [lo for _, _, lo, _ in curve.stretches for _ in range(2)]
        highs = [hi for _, _, _, hi in curve.stretches for _ in range(2)]
        axes.fill_between(times, lows, highs, color=colour, alpha=0.3, linewidth=0)
        axes.plot([t for t, _, _ in curve.instants], [hi for _, _, hi in curve.instants], color=colour, linewidth=1,
                  label=_label(curve.pair))
    axes.set_xlabel("t")
    axes.set_ylabel("distance")
    axes.set_ylim(bottom=0)
    axes.legend(loc="best", fontsize="small")
    _title(axes, answer.coverage)
    return axes


def plot_clearance(answer: Clearance, axes: Any) -> Any:
    """See Clearance.plot()."""
    found = answer.pairs or (() if answer.nearest is None else (answer.nearest,))
    _require(bool(found), answer.outcome, answer.reason, "nearest")
    axes = _new_axes(axes)
    for row, pair in enumerate(found):
        is_least = answer.nearest is not None and pair.pair == answer.nearest.pair
        axes.barh(row, pair.lo, 0.7, color=_MARK if is_least else _FILLS[0], label="closest pair" if is_least else None)
        # What is not known of it: as wide as the bracket.
        axes.broken_barh([(pair.lo, pair.hi - pair.lo)], (row - 0.35, 0.7), facecolors="none", edgecolors=_UNDECIDED,
                         hatch="///")
    _rows(axes, [_label(pair.pair) for pair in found])
    axes.set_xlim(left=0)
    axes.set_xlabel("least distance")
    axes.legend(loc="best", fontsize="small")
    _title(axes, answer.coverage)
    return axes

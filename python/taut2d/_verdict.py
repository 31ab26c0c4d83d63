"""What all answers have in common: an outcome for which no truth value stands, and words for a person to read."""

from __future__ import annotations

import json
from collections.abc import Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, Callable, NoReturn, Optional, TypeVar

from .words import LockKind

if TYPE_CHECKING:
    from .answers import Coverage


_Read = TypeVar("_Read", bound="ReadLater")


_beginning = '{"outcome":"'


class ReadLater:
    """Has its members from its ``json``, which is read when the first one is asked for: who only wants to know whether
    bodies collide does not wait for the rest. Members with a default of None have it from a factory, since one of the
    class would hide that they are missing."""

    @classmethod
    def _of(cls: type[_Read], text: str, read: Callable[[str], dict[str, Any]], **known: Any) -> _Read:
        """From a text that the library has written."""
        answer = object.__new__(cls)
        answer.__dict__.update(known, json=text, _read=read)
        return answer

    if not TYPE_CHECKING:  # a checker is to know which members there are

        def __getattr__(self, name: str) -> Any:
            members = self.__dict__
            read = members.get("_read")
            if read is not None and not name.startswith("__"):
                text = members["json"]
                # Mostly the first member and the only one that is looked at.
                if name == "outcome" and text.startswith(_beginning):
                    return text[len(_beginning):text.index('"', len(_beginning))]
                members.update(read(text))
                # Last: another thread may read the same.
                members.pop("_read", None)
            if name in members:
                return members[name]
            raise AttributeError(f"{type(self).__name__!r} object has no attribute {name!r}")


def nothing() -> None:
    """The factory of members that are None by default."""


class Undivided:
    """Has no truth value. An object of Python is true, and so would be the answer that two bodies collide."""

    _instead = 'answer.outcome == "free"'

    def __bool__(self) -> NoReturn:
        raise TypeError(f"{type(self).__name__} is neither true nor false: write {self._instead}")


@dataclass(frozen=True)
class Lock:
    """Where a mechanism cannot go on as it is driven. ``t``: an interval of time that contains the lock. ``kind``: "dead
    point"; "change point", where it could go on in more than one way; or "undecided", where links come so near to a line
    that it is not known. ``joints``: those that could move there while the driven ones are held; ``links``: the bodies
    that move with them."""

    t: tuple[float, float]
    kind: LockKind
    joints: tuple[str, ...]
    links: tuple[str, ...]


def lock_from(value: Any) -> Optional[Lock]:
    if value is None:
        return None
    lo, hi = value["t"]
    return Lock((float(lo), float(hi)), value["kind"], tuple(value["joints"]), tuple(value["links"]))


class Verdict(ReadLater, Undivided):
    """An answer: str() gives it in at most three lines."""

    outcome: str
    reason: Optional[str]
    coverage: Coverage

    @property
    def lock(self) -> Optional[Lock]:
        """Where the scene's mechanism locks, up to which the answer holds; None if it does not."""
        text: Optional[str] = getattr(self, "json", None)
        return lock_from(json.loads(text).get("lock")) if text and '"lock"' in text else None

    def _words(self) -> tuple[str, str]:
        """What is known, and about whom or when, in a line each, of an answer that was decided. The second may be
        empty."""
        raise NotImplementedError

    def _undecided_words(self) -> tuple[str, str]:
        return "", self.reason or ""

    def __str__(self) -> str:
        is_decided = self.outcome not in ("undecided", "untested")
        known, detail = self._words() if is_decided else self._undecided_words()
        outcome = self.outcome.replace("_", " ")
        lines = [f"{outcome}: {known}" if known else outcome, detail, untested_text(self.coverage)]
        # Three lines at most, whatever characters a name or a reason has.
        return "\n".join(" ".join(line.splitlines()) for line in lines if line)


def untested_text(coverage: Coverage) -> str:
    """Which pairs the answer says nothing about; empty if there are none."""
    if coverage.untested == 0:
        return ""
    counts = ((coverage.ignored, "ignored"), (coverage.moving_alike, "moving alike"), (coverage.at_rest, "at rest"),
              (coverage.layers, "on different layers"), (coverage.not_reached, "not reached"))
    why = ", ".join(f"{count} {word}" for count, word in counts if count > 0)
    return f"not tested: {coverage.untested} of {coverage.pairs} pair{'' if coverage.pairs == 1 else 's'} ({why})"


def bodies_text(coverage: Coverage) -> str:
    """Of whom something is said that holds for every pair: the subject of a sentence without "not"."""
    return "no two bodies" if coverage.untested == 0 else "no two bodies of the tested pairs"


def bracket(values: Sequence[float]) -> str:
    """An enclosure, or the number that it is."""
    lo, hi = values
    return repr(lo) if lo == hi else f"[{lo!r}, {hi!r}]"


def instant(values: Sequence[float]) -> str:
    return f"t = {bracket(values)}" if values[0] == values[1] else f"t in {bracket(values)}"


def names(pair: Optional[Sequence[str]]) -> str:
    return "two bodies" if pair is None else " and ".join(pair)


def counted(count: int, word: str) -> str:
    return f"{count} {word}{'' if count == 1 else 's'}"

"""What taut2d raises on purpose. Catch TautError to catch all of it; an undecided check is an answer, no exception."""

from __future__ import annotations

__all__ = ["InputError", "InternalError", "TautError", "UndecidedError"]


class TautError(Exception):
    """The base of all errors of taut2d."""


class InputError(TautError, ValueError):
    """The input is not a scene that can be decided, or an option has no meaning.

    ``place`` says where: a file with line and column, a path such as ``bodies[1].motion``, the name of a body; it may be
    empty. ``problem`` says what is wrong there, and ``hint`` what to do about it; the hint may be empty.
    """

    def __init__(self, place: str, problem: str, hint: str = "") -> None:
        super().__init__(place, problem, hint)
        self.place = place
        self.problem = problem
        self.hint = hint

    def __str__(self) -> str:
        text = f"{self.place}: {self.problem}" if self.place else self.problem
        return f"{text}\nhint: {self.hint}" if self.hint else text


class UndecidedError(TautError):
    """Precision, or a limit, does not suffice, where there is no answer to say so in."""


class InternalError(TautError):
    """A defect of taut, noticed before it became an answer: an invariant was broken, or the two engines contradict each
    other. Please report it, together with the scene."""

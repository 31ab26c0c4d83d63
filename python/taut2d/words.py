"""The words that functions take and answers give, as types: a checker such as mypy then knows them."""

from __future__ import annotations

from typing import Literal

__all__ = ["AtRest", "CellState", "ContactAt", "CrossingContours", "Engine", "EngineName", "FaceKind", "Faults", "FillRule", "FollowState",
           "Grouping", "LengthUnit", "MarginOutcome", "OpenLines", "OutcomeWord", "Pairs", "PathOutcome", "QuestionOutcome", "RangeOutcome",
           "RepairKind", "SeparationOutcome", "Side", "SimulationState", "Touch", "VerifiedOutcome"]

# What functions take.
Touch = Literal["open", "closed"]
Engine = Literal["usual", "kinetic", "spacetime", "both", "either"]
Pairs = Literal["first", "all"]
AtRest = Literal["skip", "test"]
FillRule = Literal["nonzero", "evenodd"]
Side = Literal["outer", "inner"]
CrossingContours = Literal["error", "subtract", "union", "parts"]
OpenLines = Literal["error", "close", "skip"]
Grouping = Literal["auto", "layer", "color", "group", "nesting"]
Faults = Literal["raise", "report"]
LengthUnit = Literal["mm", "cm", "m", "um", "in", "ft", "mil", "pt", "px"]

# What answers give.
OutcomeWord = Literal["free", "contact", "overlap_at_start", "undecided", "untested", "locked"]
MarginOutcome = Literal["free", "contact", "overlap_at_start", "closer_at_start", "undecided", "untested", "locked"]
LockKind = Literal["dead point", "change point", "undecided"]
MechanismOutcome = Literal["moves", "locked", "undecided"]
QuestionOutcome = Literal["free", "contact", "undecided", "untested"]
PathOutcome = Literal["path", "none", "undecided", "untested"]
RangeOutcome = Literal["free", "undecided", "untested"]
SeparationOutcome = Literal["free", "locked", "overlap_at_start", "undecided", "untested"]
VerifiedOutcome = Literal["free", "contact", "undecided"]
EngineName = Literal["kinetic", "spacetime", "both"]
ContactAt = Literal["start", "motion", "joint"]
CellState = Literal["free", "colliding", "undecided"]
FollowState = Literal["carried", "low", "change", "open"]
FaceKind = Literal["node", "root", "infinite", "polygon_interior"]
SimulationState = Literal["running", "finished", "contact", "overlap_at_start", "undecided", "untested", "locked"]
RepairKind = Literal["loop", "crossing", "spike", "sliver"]

"""Numbers and points as people hand them over, made plain: floats, and tuples of floats."""

from __future__ import annotations

import math
import os
from collections.abc import Iterable
from typing import Any

from .errors import InputError


def number(value: Any, place: str) -> float:
    """A finite double: what float() makes of it, which for numpy's numbers and for whole numbers up to 2**53 is the
    same number."""
    try:
        if isinstance(value, (str, bytes)):
            raise TypeError
        result = float(value)
    except OverflowError:
        result = math.inf
    except (TypeError, ValueError) as error:
        raise InputError(place, f"expected a number, found {type(value).__name__}") from error
    if not math.isfinite(result):
        raise InputError(place, f"{result} is not a finite number")
    return result


def is_sequence(values: Any) -> bool:
    # An array of numpy without dimensions has __iter__, too, and cannot be iterated over.
    return isinstance(values, Iterable) and not isinstance(values, (str, bytes)) and getattr(values, "ndim", 1) > 0


def numbers(values: Any, place: str) -> tuple[float, ...]:
    """A sequence of finite doubles."""
    if not is_sequence(values):
        raise InputError(place, f"expected numbers, found {type(values).__name__}", "give a list of numbers")
    return tuple(number(value, f"{place}[{i}]") for i, value in enumerate(values))


def point(value: Any, place: str, hint: str = "write (x, y)") -> tuple[float, float]:
    """Two finite doubles; ``hint``: how they are written."""
    if not is_sequence(value):
        raise InputError(place, f"expected two numbers, found {type(value).__name__}", hint)
    found = numbers(value, place)
    if len(found) != 2:
        raise InputError(place, f"expected two numbers, found {len(found)}", hint)
    return found[0], found[1]


def time_span(value: Any, place: str) -> tuple[float, float]:
    """When something begins and ends."""
    return point(value, place, "write (start, end): when the motion begins, and when it ends")


def path_text(value: Any, place: str) -> str:
    """The name of a file, as a str."""
    try:
        return os.fsdecode(value)
    except TypeError as error:
        raise InputError(place, f"expected the path of a file, found {type(value).__name__}") from error


def numpy_for(purpose: str) -> Any:
    """The module numpy, which not everything needs."""
    try:
        import numpy
    except ImportError as error:
        raise ImportError(f"{purpose} needs numpy, which is not installed: on Debian, python3-numpy") from error
    return numpy


def doubles(value: Any) -> Any:
    """An array's numbers as doubles. Other numbers become the nearest ones; what is none is an InputError."""
    if getattr(value, "dtype", None) == float:
        return value
    try:
        return value.astype(float)
    except (TypeError, ValueError, AttributeError) as error:
        raise InputError("", f"expected an array of numbers, found {value!r:.40}") from error

"""Which region a moving body passes over: keep-out zones, swept areas of vehicles."""

from __future__ import annotations

import json
from dataclasses import dataclass, field
from typing import Any, Optional, Tuple

from ._numbers import number
from .options import ask, scene_text
from .scene import Scene, _plain_places

Ring = Tuple[Tuple[float, float], ...]


@dataclass(frozen=True)
class SweptRegion:
    """The region that ``body`` passes over, in world coordinates. ``parts``: of each polygon its outline, counterclockwise,
    and its holes, clockwise. ``tolerance``: no point of it is farther from what the body covers at some instant. ``area``:
    of the region. ``json`` is what ``taut swept --json`` prints."""

    body: str
    tolerance: float
    area: float
    parts: Tuple[Tuple[Ring, Tuple[Ring, ...]], ...]
    json: str = field(repr=False, compare=False)

    @property
    def __geo_interface__(self) -> dict[str, Any]:
        """As GeoJSON, which shapely and geopandas take: ``shapely.geometry.shape(region)``."""
        closed = tuple(tuple(ring + ring[:1] for ring in (outline, *holes)) for outline, holes in self.parts)
        return {"type": "MultiPolygon", "coordinates": closed}


def swept(scene: Scene, body: str, *, tolerance: Optional[float] = None, max_seconds: Optional[float] = None) -> SweptRegion:
    """The region that a body passes over in the scene's time. It certainly contains every point that the body, its boundary
    included, covers at any instant, whatever happens between poses, and reaches at most ``tolerance`` beyond that.

    ``body``: its name. ``tolerance``: in the scene's units; None: a thousandth of the body's diagonal. Other bodies do
    not matter. InputError if the scene is not valid, if there is no such body, or if the tolerance is too small for
    doubles; UndecidedError after ``max_seconds``.
    """
    with _plain_places():
        text, _, _ = ask("swept", scene_text(scene), body=body, max_seconds=max_seconds,
                         tolerance=0.0 if tolerance is None else number(tolerance, "tolerance"))
    value = json.loads(text)

    def ring(points: Any) -> Ring:
        return tuple((float(x), float(y)) for x, y in points)

    parts = tuple((ring(part["outline"]), tuple(map(ring, part.get("holes", ())))) for part in value["parts"])
    return SweptRegion(value["body"], float(value["tolerance"]), float(value["area"]), parts, text)

"""Which cells of a grid a moving body touches: motion primitives of grid planners."""

from __future__ import annotations

import json
from dataclasses import dataclass, field
from typing import Any, Optional, Sequence, Tuple

from ._numbers import point
from .options import ask, scene_text
from .scene import Scene, _plain_places


@dataclass(frozen=True)
class Cells:
    """The cells of a grid that a body touches. ``cells``: (column, row) of each, by rows and then columns; cell (i, j) is
    the square from ``origin`` + ``resolution`` (i, j) to ``origin`` + ``resolution`` (i + 1, j + 1). ``json`` is what
    ``taut cells --json`` prints."""

    body: str
    resolution: float
    origin: Tuple[float, float]
    cells: Tuple[Tuple[int, int], ...]
    json: str = field(repr=False, compare=False)

    def __len__(self) -> int:
        return len(self.cells)

    def mask(self) -> Any:
        """A numpy array of bool over the rectangle around all cells, the lowest row first, and the column and the row
        of its first element."""
        import numpy

        if not self.cells:
            return numpy.zeros((0, 0), dtype=bool), (0, 0)
        index = numpy.array(self.cells)
        low = index.min(axis=0)
        width, height = index.max(axis=0) - low + 1
        out = numpy.zeros((height, width), dtype=bool)
        out[index[:, 1] - low[1], index[:, 0] - low[0]] = True
        return out, (int(low[0]), int(low[1]))


def cells(scene: Scene, body: str, resolution: float, *, origin: Sequence[float] = (0.0, 0.0),
          max_seconds: Optional[float] = None) -> Cells:
    """All cells that a body, its boundary included, touches at any instant of the scene's time: none is missing,
    whatever happens between poses, and none is always more than a sixteenth of a cell away from the body.

    ``body``: its name. ``resolution``: the side of a cell. ``origin``: the lower left corner of cell (0, 0). Other
    bodies do not matter. Of a body with curves, flatten() makes polygons first. ``max_seconds``: UndecidedError after so much
    wall time. InputError if the scene is not valid, if there is no such body, or if cells are so small that doubles do not tell sixteenths of them.
    """
    x, y = point(origin, "origin")
    with _plain_places():
        text, _, _ = ask("cells", scene_text(scene), body=body, resolution=resolution, origin_x=x, origin_y=y,
                         max_seconds=max_seconds)
    value = json.loads(text)
    found = tuple((cell[0], cell[1]) for cell in value["cells"])
    return Cells(value["body"], float(value["resolution"]), (float(value["origin"][0]), float(value["origin"][1])),
                 found, text)

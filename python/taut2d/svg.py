"""Pictures of the library's own, as SVG."""

from __future__ import annotations

import json
from typing import Optional

from .options import ask, scene_text
from .scene import Scene, _plain_places
from .words import Touch

__all__ = ["draw"]


def draw(scene: Scene, *, at: Optional[float] = None, animate: bool = False, plain: bool = False, touch: Touch = "open",
         width: int = 800, max_seconds: Optional[float] = None) -> str:
    """The picture of ``taut draw``, as the text of an SVG image: the bodies, and the tilings between them.

    ``at``: the instant; None: the first contact, or the end. It is not after the first contact. ``animate``: a picture that
    moves, without script, from the start to the contact, or to the end. ``plain``: without tilings; those of two polygons
    without colours. ``width``: in pixels, from 200 to 20000. ``touch``, ``max_seconds``: as in check().
    Raises InputError if the scene or an option is not valid.
    """
    with _plain_places():
        answer, _, _ = ask("draw", scene_text(scene), at=at, animate=animate, plain=plain, touch=touch, width=width,
                           max_seconds=max_seconds)
    text: str = json.loads(answer)["svg"]
    return text

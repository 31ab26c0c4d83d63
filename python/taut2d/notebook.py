"""What Jupyter shows of scenes and answers: pictures that move, drawn by the library.

They are images of some kilobytes, without script. The viewer has three megabytes, which every output would hold anew, and
needs a compiler for WebAssembly to be built: Scene.view() is for those who ask for it.
"""

from __future__ import annotations

import base64
import html
from typing import Any, Optional

from . import _taut2d
from .answers import Answer, Contact
from .errors import TautError
from .pictures import instant
from .scene import Scene, _plain_places


def _picture(scene: Scene, end: float, ending: _taut2d.Ending) -> str:
    with _plain_places():
        svg = _taut2d.animation(scene._text(), end, ending)
    # An image of its own: names in it do not meet those in other pictures of the page.
    data = base64.b64encode(svg.encode("utf-8")).decode("ascii")
    return f'<img alt="the motion" style="max-width: min(640px, 100%); max-height: 480px" src="data:image/svg+xml;base64,{data}"/>'


def _refused(error: TautError) -> str:
    return f"<pre>{html.escape(type(error).__name__)}: {html.escape(str(error))}</pre>"


def html_of_scene(scene: Scene) -> str:
    try:
        return _picture(scene, scene.time[1], _taut2d.Ending())
    except TautError as error:
        return _refused(error)


def _names(scene: Scene) -> dict[str, int]:
    return {body.name: i for i, body in enumerate(scene.bodies)}


def _contact_for(scene: Scene, contact: Contact) -> Any:
    """As the library takes it."""
    names = _names(scene)
    v, e = contact.vertex, contact.edge
    return ((names[v.body], v.part, v.ring, v.index), (names[e.body], e.part, e.ring, e.index), contact.point,
            contact.normal)


def _words(answer: Answer) -> str:
    contact: Optional[Contact] = answer.contact or answer.touching
    words = {"free": "free" if contact is None else "free, and touching",
             "overlap_at_start": "overlap at the start"}.get(answer.outcome, answer.outcome)
    if contact is not None:
        return f"{words} at t = {contact.t[0]:.6g}"
    return words if answer.free_until is None else f"{words} from t = {answer.free_until:.6g}"


def _sentence(answer: Answer) -> str:
    text = f"<b>{html.escape(_words(answer))}</b>"
    if answer.pair is not None:
        text += f": {html.escape(answer.pair[0])} &times; {html.escape(answer.pair[1])}"
    contact = answer.contact or answer.touching
    if contact is not None:
        vertex, edge = contact.vertex, contact.edge
        text += (f"<br/>vertex {vertex.index} of {html.escape(vertex.body)} meets edge {edge.index} of "
                 f"{html.escape(edge.body)}, t in [{contact.t[0]!r}, {contact.t[1]!r}]")
    if answer.reason is not None:
        text += f"<br/>{html.escape(answer.reason)}"
    return f"<div>{text}</div>"


def html_of_answer(answer: Answer) -> str:
    if answer.scene is None:
        return _sentence(answer)
    scene = answer.scene
    end, contact, _ = instant(scene, answer)
    ending = _taut2d.Ending()
    ending.words = _words(answer)
    ending.free = answer.outcome == "free"
    if contact is not None:
        ending.contact = _contact_for(scene, contact)
    elif answer.outcome == "overlap_at_start" and answer.pair is not None:
        names = _names(scene)
        ending.overlap = [names[name] for name in answer.pair]
    try:
        return _sentence(answer) + _picture(scene, end, ending)
    except TautError as error:
        return _sentence(answer) + _refused(error)

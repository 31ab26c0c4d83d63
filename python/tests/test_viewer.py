import html
import json
import pathlib
import re
import subprocess

import pytest
import taut2d
from taut2d import Body, InputError, Scene

root = pathlib.Path(__file__).resolve().parents[2]
SCENE = Scene([Body("a</script><!--", [(0, 0), (4, 0), (4, 1)]),
               Body("b", [(1, 5), (3, 5), (2, 6)], taut2d.Velocity((0.1, -0.5), 7))], (0, 10))
PAGE = '<html><script type="application/json" id="taut-data">@TAUT-DATA@</script></html>'


@pytest.fixture
def template(tmp_path):
    path = tmp_path / "viewer.html"
    path.write_text(PAGE, encoding="utf-8")
    return path


def data_in(page):
    return json.loads(re.search(r'id="taut-data">([^<]*)</script>', page)[1])


def test_a_page_holds_the_scene(template, tmp_path):
    viewer = SCENE.view(template=template, touch="closed", at=3)
    data = data_in(viewer.page)
    assert Scene.from_json(json.dumps(data["scene"])) == SCENE and (data["touch"], data["at"]) == ("closed", 3)
    viewer.save(tmp_path / "page.html")
    assert (tmp_path / "page.html").read_text(encoding="utf-8") == viewer.page
    inline = viewer._repr_html_()
    assert html.unescape(re.search(r'srcdoc="([^"]*)"', inline)[1]) == viewer.page


def test_a_page_asks_what_the_command_has_it_ask(taut, template, tmp_path):
    SCENE.save(tmp_path / "scene.json")
    for ask, flags in (({"intervals": True, "profile": 50}, ["--intervals", "--profile", "50"]),
                       ({"clearance": True, "separate": True}, ["--clearance", "--separate"]), ({}, [])):
        run = subprocess.run([taut, "view", str(tmp_path / "scene.json"), "--template", str(template), *flags],
                             stdout=subprocess.PIPE, text=True, check=True)
        assert data_in(SCENE.view(template=template, **ask).page).get("ask") == data_in(run.stdout).get("ask")
    for wrong in (1, 2.5, "50", 10**7):
        with pytest.raises(InputError, match="^profile: .* is no number of instants"):
            SCENE.view(template=template, profile=wrong)


def test_the_command_puts_the_same_into_the_page(taut, template, tmp_path):
    gears = root / "examples" / "gears.json"
    run = subprocess.run([taut, "view", str(gears), "--template", str(template)], stdout=subprocess.PIPE, text=True, check=True)
    printed, made = data_in(run.stdout), data_in(Scene.load(gears).view(template=template).page)
    assert taut2d.check(Scene.from_json(json.dumps(printed["scene"]))) == taut2d.check(Scene.from_json(json.dumps(made["scene"])))
    assert printed["touch"] == made["touch"]


@pytest.mark.parametrize("call, message", [
    (lambda t: SCENE.view(template="nowhere.html"), "template: the viewer's page is missing; looked for nowhere.html\nhint: "),
    (lambda t: SCENE.view(template=root / "README.md"), "this is no template of the viewer"),
    (lambda t: SCENE.view(template=t, touch="ajar"), "touch: unknown value 'ajar'"),
    (lambda t: SCENE.view(template=t, at=11), r"at: 11 is outside of the scene's time, \[0.0, 10.0\]"),
    (lambda t: Scene([Body("bow", [(0, 0), (1, 1), (1, 0), (0, 1)])], (0, 1)).view(template=t), "bow: the boundary"),
    (lambda t: Scene.load(root / "examples/parking.json").view(template=t), "car: it is read from a file")])
def test_what_has_no_page(template, call, message):
    with pytest.raises(InputError, match=message):
        call(template)

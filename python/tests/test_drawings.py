import json
import pathlib

import pytest
import taut2d
from taut2d import InputError

ROOT = pathlib.Path(__file__).resolve().parents[2]
OPEN = """<svg xmlns="http://www.w3.org/2000/svg" width="40mm" viewBox="0 0 40 40"><g id="plate" fill="none" stroke="black">
<path d="M 0 0 H 40 V 40 H 0 V 0.5"/><rect x="10" y="10" width="10" height="10"/><path d="M 5 5 H 8"/></g></svg>"""


def test_reads_the_examples():
    drawing = taut2d.read_drawing(ROOT / "examples/import/cam.dxf")
    assert [body.name for body in drawing.scene.bodies] == ["cam", "follower"]
    assert [body.name for body in drawing.bodies] == ["cam", "follower"]
    assert drawing.bodies[0].holes == 2 and drawing.bodies[0].area == pytest.approx(1610, abs=1)
    assert drawing.area == pytest.approx(sum(body.area for body in drawing.bodies))
    assert drawing.files[0].units == "mm" and drawing.files[0].tolerance == 0.01
    assert drawing.files[0].skipped[0].what == "TEXT" and drawing.files[0].skipped[0].unread
    assert json.loads(drawing.json)["bodies"][0]["name"] == "cam"
    assert drawing.svg.startswith("<svg")
    both = taut2d.read_drawing([ROOT / "examples/import/cam.dxf", str(ROOT / "examples/import/latch.svg")], curves=True)
    assert len(both.files) == 2 and len(both.scene.bodies) == 4
    taut2d.check(both.scene)


def test_an_outline_that_stays_open_is_a_fault(tmp_path):
    file = tmp_path / "open.svg"
    file.write_text(OPEN)
    with pytest.raises(InputError, match="stays open") as error:
        taut2d.read_drawing(file)
    assert "--join 0.505" in error.value.hint
    drawing = taut2d.read_drawing(file, faults="report")
    assert drawing.scene is None and len(drawing.faults) == 1
    assert sorted(line.gap is None for line in drawing.files[0].open) == [False, False]
    assert min(line.gap for line in drawing.files[0].open) == pytest.approx(0.5)
    assert taut2d.read_drawing(file, open="close").area == pytest.approx(1500)
    assert taut2d.read_drawing(file, open="skip").area == pytest.approx(100)
    joined = taut2d.read_drawing(file, join=0.6)
    assert joined.files[0].gaps[0].width == pytest.approx(0.5)


def test_layers_have_heights(tmp_path):
    file = tmp_path / "layers.svg"
    file.write_text('<svg fill="none" stroke="black"><g id="a"><rect width="9" height="9"/></g><g id="b">'
                    '<rect x="2" y="2" width="2" height="2"/></g></svg>')
    drawing = taut2d.read_drawing(file, layers={"a": (0, 3), "b": (3, None)})
    assert drawing.area == pytest.approx(85)
    assert [tuple(body.z) for body in drawing.scene.bodies] == [(0, 3), (3, None)]
    assert [body.z for body in drawing.bodies] == [((0, 3),), ((3, None),)]
    drawing = taut2d.read_drawing(file, layers={"a": (0, 3), "b": None})
    assert drawing.scene.bodies[1].z is None and drawing.bodies[1].z == ()
    assert "no heights are given for layer b" in drawing.files[0].notes[0]
    with pytest.raises(InputError, match="run from") as error:
        taut2d.read_drawing(file, layers={"a": (3, 3)})
    assert error.value.place == "layers['a']"


def test_layers_and_words(tmp_path):
    file = tmp_path / "layers.svg"
    file.write_text('<svg fill="none" stroke="black"><g id="a"><rect width="9" height="9"/></g><g id="b">'
                    '<rect x="2" y="2" width="2" height="2"/></g></svg>')
    assert taut2d.read_drawing(file).area == pytest.approx(77)
    assert "1 contour is a hole" in taut2d.read_drawing(file).files[0].notes[0]
    assert taut2d.read_drawing(file, by="layer").area == pytest.approx(85)
    assert taut2d.read_drawing(file, layers=["b"]).area == pytest.approx(4)
    assert len(taut2d.read_drawing(file, merge_layers=True).bodies) == 1
    assert len(taut2d.read_drawing(file, merge_layers=["a", "b"], split=True).bodies) == 1
    for wrong in ({"by": "size"}, {"open": "maybe"}, {"join": -1}, {"tolerance": 0}, {"layers": ["c"]}, {"faults": "x"},
                  {"crossing": "cut"}):
        with pytest.raises(InputError):
            taut2d.read_drawing(file, **wrong)
    file.write_text('<svg fill="none" stroke="black"><g><rect width="9" height="9"/><rect x="7" y="2" width="4" height="2"/></g>'
                    '</svg>')
    with pytest.raises(InputError, match="is it a cut, or a part"):
        taut2d.read_drawing(file)
    for crossing, area in (("subtract", 77), ("union", 85), ("parts", 85)):
        assert taut2d.read_drawing(file, crossing=crossing).area == pytest.approx(area)
    with pytest.raises(InputError, match="missing.svg"):
        taut2d.read_drawing(tmp_path / "missing.svg")


def test_drills_and_overlaps(tmp_path):
    board = tmp_path / "b.kicad_pcb"
    board.write_text("(kicad_pcb (gr_rect (start 0 0) (end 9 9) (layer Edge.Cuts)) (via (at 3 3) (drill 1)))")
    assert taut2d.read_drawing(board).bodies[0].holes == 0
    assert taut2d.read_drawing(board, drills=1).bodies[0].holes == 1
    with pytest.raises(taut2d.InputError):
        taut2d.read_drawing(board, drills=-1)
    squares = tmp_path / "s.wkt"
    squares.write_text("POLYGON((0 0,4 0,4 4,0 4)) POLYGON((2 2,5 2,5 5,2 5))")
    body = taut2d.read_drawing(squares).bodies[0]
    assert (body.area, body.overlap) == (21, 4)


def test_files_of_several_units_are_converted(tmp_path):
    page = '<svg width="{}" viewBox="0 0 10 10"><rect width="2" height="1"/></svg>'
    (tmp_path / "mm.svg").write_text(page.format("10mm"))
    (tmp_path / "none.svg").write_text(page.format("10"))
    both = [tmp_path / "mm.svg", tmp_path / "none.svg"]
    with pytest.raises(taut2d.InputError, match="states no unit"):
        taut2d.read_drawing(both)
    drawing = taut2d.read_drawing(both, unit="cm")
    assert [round(body.area, 9) for body in drawing.bodies] == [2.0, 200.0]
    with pytest.raises(taut2d.InputError):
        taut2d.read_drawing(both, unit="inch")

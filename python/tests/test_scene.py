import json
import math
import os
import pathlib

import pytest
import taut2d
from taut2d import Body, InputError, Part, Scene

SQUARE = ((0.0, 0.0), (4.0, 0.0), (4.0, 4.0), (0.0, 4.0))
HOLE = ((1.0, 1.0), (2.0, 1.0), (2.0, 2.0))
OTHER = ((10.0, 0.0), (11.0, 0.0), (10.0, 1.0))


def geo_ring(ring):
    return [list(p) for p in ring] + [list(ring[0])]


class Feature:
    def __init__(self, geometry):
        self.__geo_interface__ = geometry


def test_one_outline_in_every_form():
    numpy = pytest.importorskip("numpy")
    shapely = pytest.importorskip("shapely.geometry")
    forms = [
        SQUARE, [list(p) for p in SQUARE], [(0, 0), (4, 0), (4, 4), (0, 4)], numpy.array(SQUARE),
        numpy.array(SQUARE, dtype=numpy.float32), numpy.array(SQUARE, dtype=int), [numpy.array(p) for p in SQUARE],
        ((numpy.float64(x), numpy.int32(y)) for x, y in SQUARE), Part(SQUARE), {"outline": SQUARE},
        shapely.Polygon(SQUARE), shapely.MultiPolygon([shapely.Polygon(SQUARE)]),
        Feature({"type": "Polygon", "coordinates": [geo_ring(SQUARE)]}),
        {"type": "Feature", "geometry": {"type": "Polygon", "coordinates": [geo_ring(SQUARE)]}},
        "POLYGON ((0 0, 4 0, 4 4, 0 4, 0 0))",
    ]
    assert {Body("a", form) for form in forms} == {Body("a", SQUARE)}


def test_holes_and_parts_in_every_form():
    numpy = pytest.importorskip("numpy")
    shapely = pytest.importorskip("shapely.geometry")
    holed = [Part(SQUARE, [HOLE]), {"outline": SQUARE, "holes": [HOLE]}, shapely.Polygon(SQUARE, [HOLE]),
             Part(numpy.array(SQUARE), [numpy.array(HOLE)]),
             "POLYGON ((0 0, 4 0, 4 4, 0 4, 0 0), (1 1, 2 1, 2 2, 1 1))"]
    assert {Body("a", form).shape for form in holed} == {Part(SQUARE, (HOLE,))}
    parts = [[Part(SQUARE, [HOLE]), Part(OTHER)], [Part(SQUARE, [HOLE]), OTHER],
             shapely.MultiPolygon([shapely.Polygon(SQUARE, [HOLE]), shapely.Polygon(OTHER)]),
             [shapely.Polygon(SQUARE, [HOLE]), numpy.array(OTHER)],
             "MULTIPOLYGON (((0 0, 4 0, 4 4, 0 4, 0 0), (1 1, 2 1, 2 2, 1 1)), ((10 0, 11 0, 10 1, 10 0)))"]
    assert {Body("a", form).shape for form in parts} == {(Part(SQUARE, (HOLE,)), Part(OTHER))}
    rings = [[SQUARE, OTHER], [numpy.array(SQUARE), numpy.array(OTHER)]]
    assert {Body("a", form).shape for form in rings} == {(Part(SQUARE), Part(OTHER))}


def test_rings_may_be_closed_in_every_form():
    numpy = pytest.importorskip("numpy")
    shapely = pytest.importorskip("shapely.geometry")
    closed, hole = geo_ring(SQUARE), geo_ring(HOLE)
    forms = [closed, tuple(map(tuple, closed)), numpy.array(closed), numpy.array(closed, dtype=numpy.float32),
             (p for p in closed), {"outline": closed}, Part(closed), [numpy.array(p) for p in closed]]
    assert {Body("a", form) for form in forms} == {Body("a", SQUARE)}
    assert Part(closed, [hole]) == Part(numpy.array(closed), [numpy.array(hole)]) == Part(SQUARE, [HOLE])
    assert Body("a", [closed, numpy.array(geo_ring(OTHER))]).shape == (Part(SQUARE), Part(OTHER))
    scene = {"format": "taut-scene/1", "time": [0, 1], "bodies": [{"name": "a", "polygon": closed}]}
    assert Scene.from_json(json.dumps(scene)).bodies[0].shape == Part(SQUARE)
    for form in (closed, numpy.array(closed), numpy.array(closed)[:, ::1], shapely.Polygon(SQUARE), Part(closed)):
        assert taut2d.Shape(form).parts == (Part(SQUARE),)
    assert taut2d.Shape(shapely.Polygon([(*p, 7) for p in SQUARE], [HOLE])).parts == (Part(SQUARE, [HOLE]),)
    answer = taut2d.check(Scene([Body("a", closed, taut2d.Velocity((1, 0))), Body("b", numpy.array(geo_ring(OTHER)))], (0, 9)))
    assert answer.outcome == "contact" and answer.contact.t[0] <= 6 <= answer.contact.t[1]
    # A vertex that is repeated elsewhere stays an error.
    with pytest.raises(InputError, match="vertices 0 and 1 are the same point"):
        Scene([Body("a", [SQUARE[0], *SQUARE]), Body("b", OTHER)], (0, 1)).validate()


def test_numbers_go_through_without_loss():
    numbers = [0.1, 1 / 3, math.pi, 5e-324 * 2**600, 2.0**-400, 2.0**53 + 2, -0.0, 1e22, math.nextafter(1, 2)]
    scene = Scene([Body("a", [(x, -x) for x in numbers])], (0, 0.1 + 0.2))
    assert Scene.from_json(scene.to_json()) == scene
    assert [x for x, _ in Scene.from_json(scene.to_json()).bodies[0].shape.outline] == numbers


def test_a_scene_comes_back_from_its_text(tmp_path):
    scene = Scene(
        [
            Body("a", SQUARE, taut2d.Sweep(0, 90, (1, 2)), id={"row": 1}),
            Body("b", Part(SQUARE, [HOLE]), taut2d.Keyframes([(0, 0, 0), (1, 2, 3), taut2d.Turn(2, (1, 1), 90),
                                                              taut2d.Arc(3, (0, 0), -45)], (1, 1)), relative_to="a"),
            Body("c", [SQUARE, OTHER], taut2d.Velocity((1, 2), 3, (4, 5))),
            Body("d", OTHER, taut2d.Polynomial([1, 2], (), taut2d.Cosine([1, -1]), (0, 1))),
            Body("e", OTHER, taut2d.Pieces([taut2d.Polynomial((), [0, 1], taut2d.Direction([1], [0, 1]), until=2),
                                            taut2d.Polynomial(rotation=taut2d.HalfAngleTangent([0, 1]))])),
            Body("f", OTHER, taut2d.Polynomial(rotation=taut2d.Angle([0, 1]), origin=0.5,
                                             orbit=taut2d.Orbit((1, 2), [0, 0.25]))),
        ],
        (0, 1), [("a", "b"), ("c", "*")], id="an id")
    assert Scene.from_json(scene.to_json()) == scene
    scene.save(tmp_path / "scene.json")
    assert Scene.load(tmp_path / "scene.json") == scene
    assert "$schema" not in json.loads(scene.to_json())


def test_motions_in_seconds_since_1970_are_those_at_time_zero():
    def distance(start, motion):
        scene = Scene([Body("a", SQUARE), Body("b", OTHER, motion(start))], (start, start + 2.5))
        return taut2d.clearance(scene).distance

    def keyframes(start):
        return taut2d.Keyframes([(start, 0, 0.1), (start + 0.7, 1.3, 2.2), (start + 1.7, 3.1, 0.3)])

    def polynomial(start):
        return taut2d.Polynomial([0.1, 0.3, 0.1], [0.7, 1.1], taut2d.Angle([0.1, 0.7]), origin=start)

    for motion in (keyframes, polynomial):
        early, late = distance(0, motion), distance(1.79e9, motion)
        # The times of the keyframes are rounded there, by 2^-23.
        assert early[0] == pytest.approx(late[0], abs=2e-6)
    with pytest.raises(InputError, match="origin"):
        taut2d.Polynomial([1], origin=math.nan)


def test_keyframes_in_every_form():
    numpy = pytest.importorskip("numpy")
    forms = [[(0, 1, 2, 3), (1, 4, 5, 6)], numpy.array([(0, 1, 2, 3), (1, 4, 5, 6)]),
             [taut2d.Keyframe(0, 1, 2, 3), taut2d.Keyframe(1, 4, 5, 6)],
             [{"t": 0, "x": 1, "y": 2, "angle_deg": 3}, {"t": 1, "x": 4, "y": 5, "angle_deg": 6}]]
    assert len({taut2d.Keyframes(form) for form in forms}) == 1


def test_files_are_found_in_the_folder_of_the_scene(tmp_path):
    (tmp_path / "a.wkt").write_text("POLYGON ((0 0, 4 0, 4 4, 0 4, 0 0))")
    (tmp_path / "drive.csv").write_text("t,x,y\n0,10,0\n10,0,0\n")
    scene = Scene([Body("a", taut2d.WktFile(pathlib.Path("a.wkt"))), Body("b", SQUARE, taut2d.CsvKeyframes("drive.csv"))], (0, 10),
                  folder=tmp_path)
    assert taut2d.check(scene).contact.t[0] == 6


@pytest.mark.parametrize("make, place, problem", [
    (lambda: Body("lid", 7), "lid: shape", "expected a shape, found int"),
    (lambda: Body("lid", [(0, 0), (1, 0), (0, "x")]), "lid: shape[2][1]", "found str"),
    (lambda: Body("lid", [(0, 0), (1, 0), (0, 1, 2)]), "lid: shape[2]", "expected two numbers, found 3"),
    (lambda: Body("lid", [(0, 0), (1, 0), (0, math.nan)]), "lid: shape[2][1]", "nan is not a finite number"),
    (lambda: Body("lid", {"type": "Point", "coordinates": [0, 0]}), "lid: shape", "found Point"),
    (lambda: Body("lid", SQUARE, "fast"), "lid: motion", "expected a motion, found str"),
    (lambda: taut2d.Keyframes([(0, 0, 0), (1, 2)]), "keyframes[1]", "found 2"),
    (lambda: Scene([Body("a", SQUARE)], (0,)), "time", "expected two numbers, found 1"),
    (lambda: Scene([Body("a", SQUARE)], 10), "time", "expected two numbers, found int"),
    (lambda: taut2d.Velocity(3), "velocity", "expected two numbers, found int"),
    (lambda: Scene([Body("a", SQUARE)], (0, 1), ["ab"]), "ignore[0]", "expected two names"),
    (lambda: Scene.from_json('{"format": "taut-scene/1"}'), "scene:1:1", '"time"'),
    (lambda: Scene([Body("a", SQUARE), Body("b", SQUARE[:2])], (0, 1)).validate(), "b", "vertices"),
    (lambda: taut2d.CsvKeyframes(7), "path", "found int"),
    (lambda: taut2d.check("lid.json"), "scene", "expected a Scene, found str"),
    (lambda: Scene.from_json(b"{}"), "", "expected text, found bytes"),
    (lambda: taut2d.check(Scene([Body("\ud800", SQUARE), Body("b", OTHER)], (0, 1))), "", "surrogate"),
    (lambda: taut2d.check(Scene([Body("a", SQUARE), Body("b", OTHER, id={1, 2})], (0, 1))), "id", "set"),
    (lambda: taut2d.check(Scene([Body("a", SQUARE), Body("a", OTHER)], (0, 1))), "bodies", "two bodies"),
])
def test_errors_say_where_and_what(make, place, problem):
    with pytest.raises(InputError) as caught:
        make()
    assert caught.value.place == place
    assert problem in caught.value.problem
    assert str(caught.value).startswith(f"{place}: {caught.value.problem}" if place else caught.value.problem)


def test_an_error_has_a_hint():
    bow = [(0, 0), (1, 1), (1, 0), (0, 1)]
    with pytest.raises(taut2d.TautError) as caught:
        taut2d.check(Scene([Body("bow", bow), Body("b", OTHER)], (0, 1)))
    error = caught.value
    assert isinstance(error, ValueError)
    assert (error.place, error.hint[:17]) == ("bow", "list the vertices")
    assert error.problem == "the boundary is not simple: edges 0-1 and 2-3 cross at (0.5, 0.5)"
    assert str(error) == f"bow: {error.problem}\nhint: {error.hint}"


@pytest.mark.parametrize("make, hint", [
    (lambda: Scene([Body("a", SQUARE)], 10), "write (start, end)"),
    (lambda: Scene([Body("a", SQUARE)], (0, 1, 2)), "write (start, end)"),
    (lambda: taut2d.KeyframeRows.between([(0, 0)], [(1, 1)], time=1), "write (start, end)"),
    (lambda: taut2d.Linkage([Body("a", SQUARE)], {"lift": 60}), "write (lowest, highest)"),
    (lambda: taut2d.Velocity((1, 2, 3)), "write (x, y)"),
    (lambda: Body("a", [0, 1, 2]), "write (x, y)"),
])
def test_hints_are_about_what_was_meant(make, hint):
    with pytest.raises(InputError) as caught:
        make()
    assert caught.value.hint.startswith(hint)


def test_wkt_that_is_none_is_an_error_with_a_hint():
    pytest.importorskip("shapely")
    for text, problem in [("POLYGON ((0 0, 1", "this is not WKT"), ("POINT (0 0)", "found Point"),
                          ("POLYGON EMPTY", "empty")]:
        with pytest.raises(InputError) as caught:
            Body("a", text)
        assert problem in caught.value.problem


def test_names_of_files_may_be_any_bytes(tmp_path):
    path = os.fsdecode(os.path.join(os.fsencode(tmp_path), b"\xff.json"))
    with open(path, "w") as file:
        file.write("{}")
    with pytest.raises(InputError) as caught:
        Scene.load(path)
    assert caught.value.place == path + ":1:1"

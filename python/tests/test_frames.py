"""Tables in and out, and progress of many checks."""

import math

import pytest
import taut2d

numpy = pytest.importorskip("numpy")
pandas = pytest.importorskip("pandas", reason="pandas is not installed: on Debian, python3-pandas")

square = [(-1, -1), (1, -1), (1, 1), (-1, 1)]


def ships():
    """Two ships whose ways cross at (10, 0), one of them at 10 and the other one at 12; rows are shuffled."""
    return pandas.DataFrame({"name": ["a", "b", "a", "b"], "time": [20.0, 0.0, 0.0, 20.0], "x": [20.0, 10.0, 0.0, 10.0],
                             "y": [0.0, -12.0, 0.0, 8.0]})


def test_moving_features_meet_where_they_do():
    scene = taut2d.scene_from_frame(ships(), square)
    assert [body.name for body in scene.bodies] == ["a", "b"] and scene.time == (0, 20)
    answer = taut2d.check(scene)
    # Their squares overlap once both distances are below 2: |t - 10| < 2 and |t - 12| < 2.
    assert answer.contact.t[0] <= 10 <= answer.contact.t[1]
    frame = taut2d.answers_frame([answer, taut2d.check(taut2d.scene_from_frame(ships(), {"a": square, "b": [(0, 0), (.1, 0), (0, .1)]}))], scene)
    assert list(frame["outcome"]) == ["contact", "contact"]
    assert (frame["t_lo"][0], frame["t_hi"][0]) == answer.contact.t
    assert tuple(frame.loc[0, ["body_1", "body_2"]]) == ("a", "b")


def test_dates_angles_and_the_common_time():
    begin = pandas.Timestamp("2024-03-01 12:00", tz="UTC")
    frame = pandas.DataFrame({"ship": ["a"] * 3 + ["b"] * 2, "when": [begin + pandas.Timedelta(seconds=s) for s in (0, 10.5, 60, 5, 30)],
                              "x": [0.0, 1, 2, 50, 60], "y": 0.0, "heading": [350.0, 10, 20, 0, 0]})
    scene = taut2d.scene_from_frame(frame, square, name="ship", time="when", angle="heading")
    assert scene.time == (5, 30)
    keyframes = scene.bodies[0].motion.keyframes
    assert [k.t for k in keyframes] == [0, 10.5, 60] and [k.angle_deg for k in keyframes] == [350, 370, 380]
    later = taut2d.scene_from_frame(frame, square, name="ship", time="when", origin=begin - pandas.Timedelta(days=400))
    assert later.time == (400 * 86400 + 5, 400 * 86400 + 30)


def test_tables_of_geopandas():
    geopandas = pytest.importorskip("geopandas", reason="GeoPandas is not installed: on Debian, python3-geopandas")
    from shapely.geometry import Point, box
    table = ships()
    moving = geopandas.GeoDataFrame(table[["name", "time"]], geometry=[Point(p) for p in zip(table.x, table.y)], crs="EPSG:32632")
    islands = geopandas.GeoDataFrame({"name": ["rock"]}, geometry=[box(14, -0.5, 16, 0.5)], crs="EPSG:32632")
    assert taut2d.scene_from_frame(moving, square) == taut2d.scene_from_frame(table, square)
    scene = taut2d.scene_from_frame(moving[moving.name == "a"], square, static=islands)
    answer = taut2d.check(scene)
    assert answer.pair == ("rock", "a") and answer.contact.t[0] <= 13 <= answer.contact.t[1]
    for broken, said in [(moving.set_crs("EPSG:4326", allow_override=True), "angles, not lengths"),
                         (islands.assign(time=0), "expected a Point")]:
        with pytest.raises(taut2d.InputError, match=said):
            taut2d.scene_from_frame(broken, square)


@pytest.mark.parametrize("change, said", [
    (lambda f: f.assign(x=math.nan), "a number is missing"), (lambda f: f.drop(columns="time"), "no such column"),
    (lambda f: f.assign(time=[9, 0, 8, 1]), "no time for which all"), (lambda f: f.assign(time=1.0), "in two rows at one time"),
    (lambda f: f.iloc[:0], "no rows"), (lambda f: f.drop(columns="x"), "no such column")])
def test_faults(change, said):
    with pytest.raises(taut2d.InputError, match=said):
        taut2d.scene_from_frame(change(ships()), square)


def test_an_array_of_answers_as_a_table(tmp_path):
    anvil = taut2d.Body("anvil", [(0, 0), (4, 0), (4, 1), (0, 1)])
    hammer = taut2d.Body("hammer", [(1, 5), (3, 5), (2, 6)])
    scene = taut2d.Scene([anvil, hammer], (0, 10))
    rows = {"hammer": taut2d.VelocityRows([(0, -1), (9, 0), (0, -0.5)])}
    answers = taut2d.check_many(scene, rows)
    frame = taut2d.answers_frame(answers, scene)
    assert list(frame["outcome"]) == ["contact", "free", "contact"]
    assert list(frame["t_lo"].isna()) == [False, True, False] and frame["vertex"].isna()[1]
    assert list(frame["vertex_body"].fillna("")) == ["hammer", "", "hammer"]
    one_by_one = taut2d.answers_frame([taut2d.check(scene.with_motion("hammer", rows["hammer"][k])) for k in range(3)])
    for column in frame.columns:
        assert frame[column].astype(object).where(frame[column].notna(), None).tolist() == \
            one_by_one[column].astype(object).where(one_by_one[column].notna(), None).tolist(), column
    assert taut2d.answers_frame(answers)["body_1"].tolist()[0] == 0
    found = taut2d.sweep(scene, rows, to=tmp_path, shard=2)
    pandas.testing.assert_frame_equal(taut2d.answers_frame(found.array(), scene), frame)


def test_progress_of_many_checks_and_sweeps(tmp_path):
    anvil = taut2d.Body("anvil", [(0, 0), (4, 0), (4, 1), (0, 1)])
    hammer = taut2d.Body("hammer", [(1, 5), (3, 5), (2, 6)])
    scene = taut2d.Scene([anvil, hammer], (0, 10))
    rows = {"hammer": taut2d.VelocityRows(numpy.column_stack([numpy.linspace(-1, 1, 1000), numpy.full(1000, -0.5)]))}
    seen = []
    answers = taut2d.check_many(scene, rows, threads=2, progress=lambda done, of: seen.append((done, of)))
    assert answers.tobytes() == taut2d.check_many(scene, rows).tobytes()
    assert seen[-1] == (1000, 1000) and [d for d, _ in seen] == sorted({d for d, _ in seen}) and len(seen) > 1

    class Enough(Exception):
        pass

    def stop(done, of):
        raise Enough

    with pytest.raises(Enough):
        taut2d.check_many(scene, rows, progress=stop)
    values = numpy.full((1000, 3), 1.0)
    values[777] = numpy.nan
    with pytest.raises(taut2d.InputError, match="row 777"):
        taut2d.check_many(scene, {"hammer": taut2d.VelocityRows(values[:, :2])}, progress=lambda *_: None)
    # A sweep counts what was there before.
    calls = []
    with pytest.raises(Enough):
        taut2d.sweep(scene, rows, to=tmp_path, shard=400, progress=lambda done, of: stop(0, 0) if done else None)
    taut2d.sweep(scene, rows, to=tmp_path, shard=400, progress=lambda done, of: calls.append(done))
    assert calls[-1] == 1000 and calls[0] >= 400
    assert taut2d.sweep(scene, rows, to=tmp_path, shard=400).array().tobytes() == answers.tobytes()

import json
import os
import pathlib
import signal
import subprocess
import sys
import threading
import time

import pytest
import taut2d
from taut2d import Body, InputError, KeyframeRows, Scene

numpy = pytest.importorskip("numpy")

# What the child processes of the tests below do, too.
PROGRAM = """
import numpy, sys, taut2d
anvil = taut2d.Body("anvil", [(0, 0), (4, 0), (4, 1), (0, 1)])
hammer = taut2d.Body("hammer", [(1, 5), (3, 5), (2, 6)])
scene = taut2d.Scene([anvil, hammer], (0, 10))
rows = 6000
x = numpy.linspace(-5, 5, rows)
y = 0 * x
motions = {"hammer": taut2d.KeyframeRows.between(numpy.column_stack([x, y, y]), numpy.column_stack([x, y - 6, y + 90]),
                                                 (0, 10), pivot=(2, 5))}
"""
names = {}
exec(PROGRAM, names)
SCENE, MOTIONS, ROWS = names["scene"], names["motions"], names["rows"]


def contents(folder):
    return {path.name: path.read_bytes() for path in pathlib.Path(folder).iterdir()}


@pytest.fixture(scope="module")
def whole(tmp_path_factory):
    """The files of a sweep that nothing has disturbed."""
    folder = tmp_path_factory.mktemp("sweep") / "whole"
    taut2d.sweep(SCENE, MOTIONS, to=folder, shard=500, threads=1)
    return contents(folder)


def test_files_have_the_answers_in_order(tmp_path):
    found = taut2d.sweep(SCENE, MOTIONS, to=tmp_path / "a", shard=2500, touch="closed")
    assert [os.path.basename(s) for s in found.shards] == [f"rows-{k:012d}.jsonl" for k in (0, 2500, 5000)]
    expected = taut2d.check_many(SCENE, MOTIONS, touch="closed")
    assert found.array().tobytes() == expected.tobytes()
    rows = list(found)
    assert [row["row"] for row in rows] == list(range(ROWS))
    contact = next(row for row in rows if row["outcome"] == "contact")
    alone = taut2d.check(SCENE.with_motion("hammer", MOTIONS["hammer"][contact["row"]]), touch="closed")
    assert tuple(contact["t"]) == alone.contact.t and contact["vertex"]["body"] == alone.contact.vertex.body
    assert contact["edge"]["index"] == alone.contact.edge.index and tuple(contact["point"]) == alone.contact.point


def test_what_is_there_is_not_made_again(tmp_path, whole):
    found = taut2d.sweep(SCENE, MOTIONS, to=tmp_path, shard=500)
    assert contents(tmp_path) == whole
    times = {path: os.stat(path).st_mtime_ns for path in found.shards}
    os.remove(found.shards[3])
    taut2d.sweep(SCENE, MOTIONS, to=tmp_path, shard=500)
    assert contents(tmp_path) == whole
    assert [k for k, path in enumerate(found.shards) if os.stat(path).st_mtime_ns != times[path]] == [3]


def test_a_killed_sweep_goes_on(tmp_path, whole):
    program = PROGRAM + "taut2d.sweep(scene, motions, to=sys.argv[1], shard=500, threads=1)\n"
    child = subprocess.Popen([sys.executable, "-c", program, tmp_path])
    while len(list(tmp_path.glob("*.jsonl"))) < 3 and child.poll() is None:
        time.sleep(0.001)
    child.send_signal(signal.SIGKILL)
    child.wait()
    assert len(list(tmp_path.glob("*.jsonl"))) < 12, "it was too fast to be killed"
    taut2d.sweep(SCENE, MOTIONS, to=tmp_path, shard=500)
    assert {name: text for name, text in contents(tmp_path).items() if not name.endswith(".tmp")} == whole


def test_another_sweep_is_refused(tmp_path):
    few = {"hammer": MOTIONS["hammer"].values[:20]}
    taut2d.sweep(SCENE, few, to=tmp_path)
    other = {"hammer": MOTIONS["hammer"].values[:20] + 1e-9}
    for arguments, keys in (((SCENE, other), "sha256"), ((SCENE.with_motion("anvil", taut2d.Velocity((0, 0))), few), "sha256"),
                            (([SCENE] * 20,), "bodies, sha256")):
        with pytest.raises(InputError, match=f"it holds another sweep, which differs in {keys}"):
            taut2d.sweep(*arguments, to=tmp_path)
    with pytest.raises(InputError, match="differs in max_events, shard, touch"):
        taut2d.sweep(SCENE, few, to=tmp_path, touch="closed", shard=10, max_events=3)
    (tmp_path / "sweep.json").write_text("{")
    with pytest.raises(InputError, match="this is no account of a sweep"):
        taut2d.sweep(SCENE, few, to=tmp_path)


def test_errors_name_the_row_of_the_whole(tmp_path):
    values = numpy.array(MOTIONS["hammer"].values)
    values[2345, 1, 0] = -1
    with pytest.raises(InputError, match="row 2345: hammer: keyframe 1"):
        taut2d.sweep(SCENE, {"hammer": values}, to=tmp_path)
    assert len(list(tmp_path.glob("*.jsonl"))) == 2
    for options, message in (({"shard": 0}, "shard: 0 is no"), ({"touch": 1}, "touch: expected a word")):
        with pytest.raises(InputError, match=message):
            taut2d.sweep(SCENE, MOTIONS, to=tmp_path / "b", **options)
        assert not (tmp_path / "b").exists()


def test_scenes_and_shapes_and_pivots(tmp_path):
    shapes = [[(1, 5), (3, 5), (2, 6)], taut2d.Shape([(0, 5), (4, 5), (4, 9)]), [(1, 5), (3, 5), (2, 6)]] * 5
    motion = KeyframeRows(MOTIONS["hammer"].values[2000:2015], numpy.arange(30.0).reshape(15, 2) / 10)
    times = [(0, 1 + k) for k in range(15)]
    arguments = {"shapes": {"hammer": shapes}, "times": times}
    found = taut2d.sweep(SCENE, {"hammer": motion}, to=tmp_path / "a", shard=4, **arguments)
    assert found.array().tobytes() == taut2d.check_many(SCENE, {"hammer": motion}, **arguments).tobytes()
    scenes = [Scene([SCENE.bodies[0], Body("hammer", shape, motion[k])], times[k]) for k, shape in enumerate(shapes)]
    listed = taut2d.sweep(iter(scenes), to=tmp_path / "b", shard=4)
    assert list(listed) == list(found)
    with pytest.raises(ValueError, match="each scene has bodies of its own"):
        listed.array()


def test_workers_may_be_lost(tmp_path, whole, monkeypatch):
    distributed = pytest.importorskip("distributed", reason="Dask's distributed is not installed: python3-distributed")
    monkeypatch.setenv("PYTHONPATH", os.path.dirname(os.path.dirname(os.path.abspath(taut2d.__file__))))
    options = {"n_workers": 2, "threads_per_worker": 1, "dashboard_address": None, "processes": True}
    with distributed.LocalCluster(local_directory=str(tmp_path / "dask"), **options) as cluster:
        with distributed.Client(cluster) as client:
            before = client.run(os.getpid)
            folder = tmp_path / "sweep"
            killed = []

            def kill():
                while len(list(folder.glob("*.jsonl"))) < 2:
                    time.sleep(0.001)
                victim = next(iter(before.values()))
                killed.append(len(list(folder.glob("*.jsonl"))))
                os.kill(victim, signal.SIGKILL)

            killer = threading.Thread(target=kill)
            killer.start()
            taut2d.sweep(SCENE, MOTIONS, to=folder, shard=500, client=client)
            killer.join()
            assert killed[0] < 12, "the sweep was over before a worker was killed"
            assert contents(folder) == whole
            values = numpy.array(MOTIONS["hammer"].values)
            values[2345, 1, 0] = -1
            with pytest.raises(InputError, match="row 2345: hammer: keyframe 1"):
                taut2d.sweep(SCENE, {"hammer": values}, to=tmp_path / "bad", shard=500, client=client)


def test_the_account_of_a_sweep(tmp_path):
    taut2d.sweep(SCENE, {"hammer": MOTIONS["hammer"].values[:3]}, to=tmp_path, max_events=9)
    account = json.loads((tmp_path / "sweep.json").read_text())
    assert len(account.pop("sha256")) == 64
    assert account == {"format": "taut-sweep/1", "rows": 3, "shard": 1000, "touch": "open", "engine": "usual",
                       "max_seconds": None, "max_events": 9, "bodies": ["anvil", "hammer"]}

"""Scenes that are asked about again, answers that are read later, and questions within questions."""
import copy
import dataclasses
import json
import pathlib
import pickle
import threading

import pytest
import taut2d
from taut2d import Body, InputError, Scene

from test_answers import ANVIL, HAMMER, LONG

root = pathlib.Path(__file__).resolve().parents[2]
DROP = Scene([ANVIL, HAMMER], (0, 10))
QUESTIONS = [taut2d.check, taut2d.clearance, taut2d.intervals, lambda scene: taut2d.range(scene, 0),
             lambda scene: taut2d.distance_profile(scene, 5), lambda scene: taut2d.check_clearance(scene, 0.5),
             taut2d.separate]


def json_of(question, scene):
    try:
        return question(scene).json
    except InputError as error:
        return error.place, error.problem, error.hint


@pytest.mark.parametrize("path", sorted((root / "examples").glob("*.json")), ids=lambda path: path.stem)
def test_each_answer_is_that_of_the_text(path, monkeypatch):
    from taut2d import options
    try:
        scene = Scene.load(path)
    except InputError:
        pytest.skip("no scene over time")
    questions = QUESTIONS if len(scene.bodies) == 2 else QUESTIONS[:3]
    again = [[json_of(question, scene) for question in questions] for _ in range(2)]
    monkeypatch.setattr(options, "read_scene", lambda scene: scene._text())
    assert again == 2 * [[json_of(question, scene) for question in questions]]


def test_a_new_motion_leaves_shapes_prepared():
    scene = Scene([Body("anvil", ANVIL.shape), Body("hammer", HAMMER.shape)], (0, 10))
    found = [taut2d.check(scene.with_motion("hammer", taut2d.Velocity((0, -k)))) for k in (1, 2, 4)]
    assert [answer.contact.t[0] for answer in found] == [4, 2, 1]
    assert scene.with_motion("hammer", None).bodies[0].shape is scene.bodies[0].shape


def test_a_shape_is_prepared_once():
    shape = taut2d.Shape(HAMMER.shape)
    first, second = Body("a", shape), Body("b", shape)
    assert first.shape is second.shape and first == Body("a", HAMMER.shape)


def test_what_may_change_is_read_again(tmp_path):
    known = {"part": 1}
    scene = Scene([ANVIL, dataclasses.replace(HAMMER, id=known)], (0, 10))
    ids = []
    for known["part"] in (1, 2):
        ids.append(taut2d.check(scene).contact.vertex.id)
    assert ids == [{"part": 1}, {"part": 2}]
    filed = Scene([ANVIL, Body("hammer", taut2d.WktFile("hammer.wkt"), HAMMER.motion)], (0, 10), folder=tmp_path)
    times = []
    for height in (5, 3):
        (tmp_path / "hammer.wkt").write_text(f"POLYGON ((1 {height}, 3 {height}, 2 6, 1 {height}))")
        times.append(taut2d.check(filed).contact.t[0])
    assert times == [8, 4]


def test_errors_are_those_of_the_text():
    crossed = Scene([ANVIL, Body("hammer", [(0, 5), (2, 7), (2, 5), (0, 7)])], (0, 10))
    for _ in range(2):
        with pytest.raises(InputError) as error:
            taut2d.check(crossed)
        with pytest.raises(InputError) as said:
            crossed.validate()
        assert (error.value.place, error.value.problem) == (said.value.place, said.value.problem)


@pytest.mark.parametrize("make", [copy.copy, copy.deepcopy, lambda it: pickle.loads(pickle.dumps(it))])
def test_scenes_and_answers_can_be_copied(make):
    answer = taut2d.check(DROP)
    assert make(DROP) == DROP and taut2d.check(make(DROP)).json == answer.json
    assert make(answer) == answer == make(make(answer))
    assert make(taut2d.clearance(DROP)) == taut2d.clearance(DROP)


def test_members_are_read_when_they_are_asked_for():
    answer = taut2d.check(DROP)
    assert "outcome" not in vars(answer)
    assert answer.outcome == "contact" and "contact" not in vars(answer)
    assert answer.geometry is None and vars(answer)["outcome"] == answer.outcome == "contact"
    assert taut2d.check(dataclasses.replace(DROP, id='{"outcome":"free"')).outcome == "contact"
    assert answer == taut2d.check(DROP) and repr(answer) == repr(taut2d.check(DROP))
    for fresh in (answer, taut2d.check(DROP), taut2d.clearance(DROP), taut2d.intervals(DROP)):
        assert not hasattr(fresh, "outcom")
    assert taut2d.clearance(DROP).wide is None and taut2d.clearance(DROP).outcome == "contact"


def test_several_threads_may_read_one_answer():
    for _ in range(50):
        answer, found = taut2d.check(DROP), []
        threads = [threading.Thread(target=lambda: found.append((answer.contact.t, answer.scene))) for _ in range(4)]
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join()
        assert found == 4 * [(taut2d.check(DROP).contact.t, DROP)]


def test_options_are_told_apart_by_their_types():
    taut2d.check(DROP, max_events=1)
    with pytest.raises(InputError):
        taut2d.check(DROP, max_events=1.0)
    with pytest.raises(InputError):
        taut2d.check(DROP, touch=["open"])
    assert json.loads(taut2d.check(DROP, touch="closed").json)["scope"]["touch"] == "closed"


def test_a_question_starts_no_thread():
    # By their numbers: one that another test has started may end meanwhile.
    def tasks():
        return {task.name for task in pathlib.Path("/proc/self/task").glob("*")}

    before = threading.active_count(), tasks()
    taut2d.check(DROP)
    assert threading.active_count() <= before[0] and tasks() <= before[1]


def test_a_handler_of_signals_may_ask(interrupt):
    program = LONG + """
import signal
def ask(*_):
    print(taut2d.check(taut2d.Scene(scene.bodies, (0, 1))).outcome, flush=True)
    signal.setitimer(signal.ITIMER_REAL, 0)
signal.signal(signal.SIGALRM, ask)
signal.setitimer(signal.ITIMER_REAL, 0.2)
print("begun", flush=True)
taut2d.check(scene)
"""
    printed, errors = interrupt(program)
    assert printed == "free\n" and errors.rstrip().endswith("KeyboardInterrupt")


def test_control_c_ends_what_a_handler_of_signals_asks(interrupt):
    program = LONG + """
import signal
def handler(*_):
    signal.setitimer(signal.ITIMER_REAL, 0)
    taut2d.check(scene)
signal.signal(signal.SIGALRM, handler)
signal.setitimer(signal.ITIMER_REAL, 0.2)
print("begun", flush=True)
taut2d.check(scene)
"""
    _, errors = interrupt(program)
    assert ", in handler\n" in errors and errors.rstrip().endswith("KeyboardInterrupt")


def test_a_handler_of_signals_leaves_a_simulation_in_work_alone(interrupt):
    program = LONG + """
import signal
simulation = taut2d.Simulation(scene)
def ask(*_):
    try:
        simulation.step()
    except taut2d.InputError as error:
        print(error.problem, flush=True)
signal.signal(signal.SIGALRM, ask)
signal.setitimer(signal.ITIMER_REAL, 0.2)
print("begun", flush=True)
simulation.advance_to(1e7)
"""
    printed, errors = interrupt(program)
    assert printed == "a handler of signals asks a simulation in the middle of its work\n"
    assert errors.rstrip().endswith("KeyboardInterrupt")

import pathlib
import threading

import pytest
import taut2d
from taut2d import Body, InputError, Keyframes, Part, Scene, Simulation, UndecidedError, Velocity

root = pathlib.Path(__file__).resolve().parents[2]
WALL = Body("wall", [(8, -5), (9, -5), (9, 5), (8, 5)])
ARM = Body("arm", [(0, 0), (1, 0), (1, 1), (0, 1)], Velocity((1, 0)))
SCENE = Scene([WALL, ARM], (0, 10))


def test_an_arm_that_turns_back():
    simulation = Simulation(SCENE)
    assert simulation.state == "running" and simulation.time == 0 and simulation.contact is None
    assert simulation.advance_to(5) == "running" and simulation.time == 5
    assert simulation.scene is SCENE and SCENE.poses(5)["arm"].x == 5
    back = Keyframes([(5, 5, 0), (10, 0, 0)])
    simulation.set_motion("arm", back)
    assert simulation.scene == SCENE.with_motion("arm", back)
    assert simulation.advance_to(10) == "finished" and simulation.time == 10
    assert simulation.next_event() is None and not simulation.step() and simulation.contact is None


@pytest.mark.parametrize("name", ["gears", "gears_thick_tooth", "hello", "lid", "jigsaw_caught"])
@pytest.mark.parametrize("touch", ["open", "closed"])
def test_events_lead_to_the_answer_of_check(name, touch):
    scene = Scene.load(root / "examples" / f"{name}.json")
    answer = taut2d.check(scene, touch=touch, engine="kinetic")
    simulation = Simulation(scene, touch=touch)
    seen = 0
    while (interval := simulation.next_event()) is not None:
        assert interval[0] <= interval[1]
        if not simulation.step():
            break
        seen += 1
    simulation.advance_to(scene.time[1])
    assert simulation.state == {"free": "finished"}.get(answer.outcome, answer.outcome)
    assert simulation.contact == answer.contact and simulation.events == answer.events and seen <= answer.events
    assert simulation.certificates_max == answer.certificates_max >= simulation.certificates >= 0


def test_the_tiling_fills_the_space_between_the_bodies():
    scene = Scene.load(root / "examples" / "combs.json")
    simulation = Simulation(scene)
    for t in (scene.time[0], 0.5, 1.5):
        simulation.advance_to(t)
        tiling = simulation.tiling()
        assert tiling.time == simulation.time
        names = [body.name for body in scene.bodies]
        sizes = {body.name: len(body.shape.outline) for body in scene.bodies}
        assert {name: sum(v.body == name for v in tiling.vertices) for name in names} == sizes
        assert sum(edge.polygon for edge in tiling.edges) == len(tiling.vertices)
        assert any(edge.joins for edge in tiling.edges)
        for edge in tiling.edges:
            assert edge.joins == (tiling.vertices[edge.start].body != tiling.vertices[edge.end].body)
        # Euler: the map is connected, and every face is told once.
        assert len(tiling.vertices) - len(tiling.edges) + len(tiling.faces) == 2
        assert sorted(face.body for face in tiling.faces if face.kind == "polygon_interior") == sorted(names)
        assert {"node", "root", "infinite"} <= {face.kind for face in tiling.faces}
        # The free faces within the relative hull and the bodies fill what the infinite face leaves.
        shoelace = lambda ring: sum(tiling.points[a][0] * tiling.points[b][1] - tiling.points[b][0] * tiling.points[a][1]
                                    for a, b in zip(ring, ring[1:] + ring[:1])) / 2
        areas = {kind: sum(shoelace(face.boundary) for face in tiling.faces if face.kind == kind)
                 for kind in ("node", "root", "infinite")}
        bodies = sum(abs(ring_area(body.shape.outline)) for body in scene.bodies)
        assert areas["node"] + areas["root"] + bodies == pytest.approx(-areas["infinite"], rel=1e-9)
        poses = scene.poses(t)
        for vertex, (x, y) in zip(tiling.vertices, tiling.points):
            u, v = scene.bodies[names.index(vertex.body)].shape.outline[vertex.index]
            pose = poses[vertex.body]
            assert (pose.x + u * pose.cos - v * pose.sin, pose.y + u * pose.sin + v * pose.cos) == pytest.approx((x, y))


def ring_area(ring):
    return sum(a[0] * b[1] - b[0] * a[1] for a, b in zip(ring, ring[1:] + ring[:1])) / 2


def test_overlap_at_the_start():
    simulation = Simulation(Scene([WALL, Body("b", WALL.shape)], (0, 1)))
    assert simulation.state == "overlap_at_start" and simulation.overlap_point is not None
    x, y = simulation.overlap_point
    assert 8 < x < 9 and -5 < y < 5 and simulation.advance_to(1) == "overlap_at_start"
    assert repr(simulation) == "<taut2d.Simulation: overlap_at_start at 0.0, 0 events>"
    assert (len(simulation.tiling().vertices), simulation.tiling().edges, simulation.tiling().faces) == (8, (), ())


def test_a_contact_of_a_sweep_has_its_angle():
    scene = Scene.load(root / "examples" / "lid.json")
    simulation = Simulation(scene)
    simulation.advance_to(scene.time[1])
    assert simulation.contact == taut2d.check(scene, engine="kinetic").contact and simulation.contact.angle_deg is not None


def test_what_is_refused_changes_nothing():
    simulation = Simulation(SCENE)
    simulation.advance_to(5)
    for motion, message in ((Velocity((2, 0)), "^arm"), (Keyframes([(5, 5, 0), (5, 0, 0)]), r"^motion.keyframes\[1\].t: not"),
                            (7, "motion: expected a motion")):
        with pytest.raises(InputError, match=message):
            simulation.set_motion("arm", motion)
    with pytest.raises(InputError, match="name: there is no body 'leg'\nhint: bodies are called 'wall', 'arm'"):
        simulation.set_motion("leg", None)
    with pytest.raises(InputError, match="t: nan is not a finite number"):
        simulation.advance_to(float("nan"))
    assert simulation.scene is SCENE and simulation.advance_to(3) == "running" and simulation.time == 5
    assert simulation.advance_to(10) == "contact" and simulation.contact == taut2d.check(SCENE, engine="kinetic").contact


def test_no_simulation():
    with pytest.raises(InputError, match="expected a Scene, found int"):
        Simulation(5)
    with pytest.raises(InputError, match="^b: the boundary is not simple"):
        Simulation(Scene([WALL, Body("b", [(0, 0), (1, 1), (1, 0), (0, 1)])], (0, 1)))
    with pytest.raises(InputError, match="two bodies are called"):
        Simulation(Scene([WALL, ARM, Body("arm", [(30, 0), (31, 0), (30, 1)])], (0, 1)))


ROOM = Body("room", Part([(-5, -5), (5, -5), (5, 5), (-5, 5)], [[(-4, -4), (4, -4), (4, 4), (-4, 4)]]))
CART = Body("cart", [(-1, -1), (0, -1), (0, 0), (-1, 0)])
LOAD = Body("load", [(-1, 0), (0, 0), (0, 1), (-1, 1)], relative_to="cart")


def test_a_world_whose_plans_change():
    scene = Scene([ROOM, CART, LOAD], (0, 10))
    simulation = Simulation(scene)
    assert simulation.advance_to(2) == "running" and simulation.pair is None and simulation.also == ()
    up = Keyframes([(2, 0, 0), (10, 0, 8)])
    simulation.set_motion("cart", up)
    assert simulation.advance_to(4) == "running" and simulation.certificates > 0
    aside = Keyframes([(4, 0, 2), (10, 12, 2)])
    simulation.set_motion("cart", aside)
    assert simulation.scene == scene.with_motion("cart", aside)
    assert simulation.advance_to(10) == "contact"
    answer = taut2d.check(Scene([ROOM, Body("cart", CART.shape, aside), LOAD], (4, 10)), engine="kinetic")
    assert answer.engine == "kinetic" and answer.contact.t[0] <= 6 <= answer.contact.t[1]
    assert simulation.pair == answer.pair == ("room", "cart")
    assert [other.bodies for other in simulation.also] == [other.bodies for other in answer.also] == [("room", "load")]
    with pytest.raises(InputError, match="only two bodies of one ring"):
        simulation.tiling()


@pytest.mark.parametrize("name", ["planetary", "room", "arm"])
def test_events_of_worlds_lead_to_the_answer_of_check(name):
    scene = Scene.load(root / "examples" / "worlds" / f"{name}.json")
    answer = taut2d.check(scene, engine="kinetic")
    simulation = Simulation(scene)
    while simulation.next_event() is not None and simulation.step():
        pass
    simulation.advance_to(scene.time[1])
    assert simulation.state == {"free": "finished"}.get(answer.outcome, answer.outcome)
    assert simulation.pair == answer.pair and simulation.contact == answer.contact


def test_limits_leave_it_undecided():
    scene = Scene.load(root / "examples" / "gears.json")
    simulation = Simulation(scene, max_events=20)
    assert simulation.advance_to(1) == "undecided" and "20 events" in simulation.reason and 0 < simulation.time < 1
    assert not simulation.step() and simulation.next_event() is None
    with pytest.raises(UndecidedError, match="20 events"):
        simulation.set_motion("pinion", None)
    with pytest.raises(UndecidedError, match="20 events"):
        simulation.tiling()
    assert Simulation(scene, max_seconds=0).state == "undecided"


def test_threads_take_turns():
    scene = Scene.load(root / "examples" / "gears.json")
    simulation = Simulation(scene)
    threads = [threading.Thread(target=lambda: [simulation.step() for _ in range(50)]) for _ in range(4)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert simulation.events == 200
    assert simulation.advance_to(1) == "finished" and simulation.events == taut2d.check(scene, engine="kinetic").events


def test_control_c_leaves_it_undecided(interrupt):
    program = """
import taut2d
ring = [(-1, -1), (1, -1), (1, 1), (-1, 1)]
simulation = taut2d.Simulation(taut2d.Scene([taut2d.Body("a", ring, taut2d.Velocity((0, 0), 360)),
                                             taut2d.Body("b", [(x + 4, y) for x, y in ring])], (0, 1e5)))
print("begun", flush=True)
try:
    simulation.advance_to(1e5)
except KeyboardInterrupt:
    print(simulation.state, simulation.time > 0, simulation.reason)
"""
    printed, errors = interrupt(program)
    assert printed.startswith("undecided True ") and errors == ""

"""Simulations that go on after contacts, and the programs of taut2d.examples."""

import math

import pytest
import taut2d
from taut2d import Body, InputError, Polynomial, Scene, Simulation, UndecidedError
from taut2d.examples import Elastic, billiards, fleet, gripper, rigid_body

BALL = [(-0.5, 0), (0, -0.5), (0.5, 0), (0, 0.5)]
LEFT = Body("left", [(-1, -5), (0, -5), (0, 5), (-1, 5)])
RIGHT = Body("right", [(10, -5), (11, -5), (11, 5), (10, 5)])


def corridor(*others, **options):
    return Simulation(Scene([Body("ball", BALL, Polynomial((2, 3))), LEFT, RIGHT, *others], (0, 20)), **options)


def test_a_ball_goes_to_and_fro():
    simulation = corridor(record=True)
    seen = []

    def bounce(contact):
        seen.append((contact.bodies, contact.point[0], contact.normal, simulation.time))
        right = "right" in contact.bodies
        simulation.set_motion("ball", Polynomial((9.5 if right else 0.5, -3 if right else 3), origin=simulation.time))

    assert simulation.advance_many(20, bounce) == "finished"
    assert [t for *_, t in seen] == pytest.approx([2.5, 5.5, 8.5, 11.5, 14.5, 17.5])
    assert [x for _, x, _, _ in seen] == pytest.approx([10, 0] * 3) and {"ball", "right"} == set(seen[0][0])
    assert simulation.contacts == 6 and not simulation.contact_again
    (record,) = simulation.record()
    assert record.time == (0, 20) and taut2d.check(record).outcome == "free"
    assert simulation.scene.bodies[0].motion == Polynomial((0.5, 3), origin=simulation.scene.bodies[0].motion.origin)


def test_a_contact_comes_again():
    simulation = corridor()
    with pytest.raises(InputError, match="there is no contact to go on from"):
        simulation.resume()
    assert simulation.advance_to(20) == "contact" and simulation.resume() == "contact" and simulation.contact_again
    motion = simulation.relative_velocity()
    assert motion == simulation.relative_velocity(simulation.contact)
    assert all(lo <= hi < lo + 1e-12 for lo, hi in (*motion.normal, *motion.velocity, motion.along_normal))
    assert motion.along_normal[0] == pytest.approx(-3) and abs(motion.velocity[0][0]) == pytest.approx(3)
    simulation.set_motion("ball", Polynomial((9.5,), (0, 0.25), origin=simulation.time))
    assert simulation.state == "contact" and simulation.resume() == "running"
    assert simulation.advance_to(20) == "finished" and simulation.contact is None
    with pytest.raises(InputError, match="there is no contact"):
        simulation.relative_velocity()


def test_a_callback_stops_or_raises():
    simulation = corridor()
    assert simulation.advance_many(20, lambda contact: False) == "contact" and simulation.time == pytest.approx(2.5)
    with pytest.raises(ZeroDivisionError):
        simulation.advance_many(20, lambda contact: 1 / 0)
    assert simulation.state == "contact"
    with pytest.raises(InputError, match="there is no body 'wall'"):
        simulation.advance_many(20, lambda contact: simulation.set_motion("wall", None))
    # It stays in contact, which comes again without an end.
    limited = corridor(max_contacts_per_time=50)
    assert limited.advance_many(20, lambda contact: None) == "undecided"
    assert '"ball" and "right" came into contact more than 50 times' in limited.reason
    with pytest.raises(UndecidedError):
        limited.resume()


def test_bodies_come_and_go():
    simulation = corridor(record=True)
    simulation.advance_to(1)
    simulation.add_body(Body("post", [(7, -0.25), (7.5, -0.25), (7.5, 0.25), (7, 0.25)]))
    with pytest.raises(InputError, match="would overlap"):
        simulation.add_body(Body("in the way", [(4, 0), (6, 0), (6, 1)]))
    assert simulation.advance_to(20) == "contact" and set(simulation.pair) == {"ball", "post"}
    simulation.remove_body("post")
    assert simulation.state == "contact" and [body.name for body in simulation.scene.bodies] == ["ball", "left", "right"]
    with pytest.raises(InputError):
        simulation.set_motion("post", None)
    simulation.resume()
    assert simulation.advance_to(20) == "contact" and simulation.time == pytest.approx(2.5)
    simulation.ignore("ball", "right")
    simulation.resume()
    assert simulation.advance_to(4) == "running"
    assert [len(scene.bodies) for scene in simulation.record()] == [3, 4, 3, 3]
    assert all(taut2d.check(scene).outcome == "free" for scene in simulation.record())
    with pytest.raises(InputError, match="were not recorded"):
        corridor().record()


def test_rigid_bodies():
    square = rigid_body([(1, 1), (3, 1), (3, 3), (1, 3)], density=2)
    assert (square.mass, square.inertia) == pytest.approx((8, 8 * (4 + 4) / 12)) and square.centre == pytest.approx((2, 2))
    clockwise = rigid_body([(1, 3), (3, 3), (3, 1), (1, 1)], density=2)
    assert (clockwise.mass, clockwise.inertia) == pytest.approx((square.mass, square.inertia))


def test_billiards_keep_energy_and_momentum():
    simulation, elastic = billiards(9, record=True)
    energy, momentum = elastic.energy(), elastic.momentum()
    assert simulation.advance_many(60, elastic.respond) == "running" and simulation.contacts > 100
    assert elastic.energy() == pytest.approx(energy, rel=1e-13)
    assert elastic.momentum() == pytest.approx(momentum, abs=1e-12)
    (record,) = simulation.record()
    assert taut2d.check(record).outcome == "free"


def test_two_bodies_of_one_mass_exchange_velocities():
    half = math.sqrt(0.125)
    square = [(-half, -half), (half, -half), (half, half), (-half, half)]
    a, b = rigid_body(BALL), rigid_body(square)
    a.velocity, b.at = (2.0, 0.0), (5.0, 0.0)
    simulation = Simulation(Scene([Body("a", BALL, a.motion()), Body("b", square, b.motion())], (0, 10)))
    elastic = Elastic({"a": a, "b": b}, 2.0 ** -44)
    elastic.simulation = simulation
    assert simulation.advance_many(10, elastic.respond) == "finished"
    assert a.velocity == pytest.approx((0, 0)) and b.velocity == pytest.approx((2, 0))
    assert b.since == pytest.approx((5 - 0.5 - half) / 2)


def test_a_gripper_takes_a_part_along():
    simulation, happened = gripper(record=True)
    assert happened == ["down: contact of gripper and part at 4", "onto the shelf: contact of part and shelf at 18",
                        "away: finished of  at 60"]
    assert [taut2d.check(scene).outcome for scene in simulation.record()] == ["free"] * 3
    assert simulation.scene.bodies[1].relative_to is None


def test_a_fleet_plans_anew():
    simulation, changes = fleet(record=True)
    assert simulation.state == "finished" and changes == simulation.contacts > 0
    (record,) = simulation.record()
    assert taut2d.check(record).outcome == "free"

"""The lift of a follower on a cam, and what bodies do at a contact."""

import math

import pytest

import taut2d

SQUARE = [(-1, -1), (1, -1), (1, 1), (-1, 1)]
PLATE = [(-3, 1), (3, 1), (3, 1.5), (-3, 1.5)]


def test_a_plate_on_a_square():
    """The highest corner of a square that turns about its centre."""
    cam = taut2d.Body("cam", SQUARE, taut2d.Velocity((0, 0), spin_deg=90))
    scene = taut2d.Scene([cam, taut2d.Body("plate", PLATE)], (0, 1))
    found = taut2d.follow(scene, "plate", 2, instants=50)
    assert (found.body, found.instants, len(found.lifts)) == ("plate", 50, 50)
    assert (found.coverage.pairs, found.coverage.tested) == (1, 1)
    for at in found.lifts:
        top = math.sqrt(2) * math.cos(math.pi / 2 * at.t[0] - math.pi / 4) - 1
        assert at.lift[0] - 1e-12 <= top <= at.lift[1] + 1e-12
        assert (at.vertex.body, at.vertex.index, at.edge.body) == ("cam", 2, "plate")
    above = taut2d.Scene([cam, taut2d.Body("plate", [(x, y + 1) for x, y in PLATE])], (0, 1))
    assert taut2d.follow(above, "plate", 2).lifts == ()
    with pytest.raises(taut2d.InputError, match="free at all times"):
        taut2d.follow(scene, "plate", 0.1)
    assert (found.undecided, found.reason) == ((), None)
    stopped = taut2d.follow(scene, "plate", 2, max_seconds=0)
    assert (stopped.lifts, stopped.undecided) == ((), ((0, 1),))
    assert "limit" in stopped.reason


def test_what_holds_a_plate():
    """The corners of a square that turns about its centre hold a plate in turn."""
    cam = taut2d.Body("cam", SQUARE, taut2d.Velocity((0, 0), spin_deg=90))
    scene = taut2d.Scene([cam, taut2d.Body("plate", PLATE)], (0.25, 2.25))
    found = taut2d.follow(scene, "plate", 2, instants=1, contacts=True, tolerance=1e-6)
    assert [s.state for s in found.contacts] == ["carried", "change"] * 2 + ["carried"]
    held = [s for s in found.contacts if s.state == "carried"]
    assert [s.touching[0].vertex.index for s in held] == [2, 1, 0]
    assert all(len(s.touching) == 1 and s.touching[0].edge.body == "plate" for s in held)
    for change, t in zip(found.contacts[1::2], (1, 2)):
        assert change.t[0] <= t <= change.t[1] < change.t[0] + 2e-6
        assert change.once and not change.jumps
    assert (found.contacts[0].t[0], found.contacts[-1].t[1], found.contacts_reason) == (0.25, 2.25, None)
    assert taut2d.follow(scene, "plate", 2, instants=1).contacts is None
    with pytest.raises(taut2d.InputError, match="tolerance"):
        taut2d.follow(scene, "plate", 2, contacts=True, tolerance=0)
    stopped = taut2d.follow(scene, "plate", 2, contacts=True, max_seconds=0)
    assert [s.state for s in stopped.contacts] == ["open"] and "limit" in stopped.contacts_reason


def simulation(motion):
    bodies = [taut2d.Body("block", SQUARE), taut2d.Body("ram", [(-6, -0.5), (-4, -0.5), (-4, 0.5), (-6, 0.5)], motion)]
    return taut2d.Simulation(taut2d.Scene(bodies, (0, 10)), record=True)


def test_a_ram_stops_at_a_block():
    running = simulation(taut2d.Velocity((1, 0)))
    with pytest.raises(taut2d.InputError, match="does not stand at a contact"):
        running.stop("ram")
    assert running.advance_to(10) == "contact" and running.time == pytest.approx(3)
    running.stop("ram")
    assert running.resume() == "running"
    assert running.advance_to(10) == "finished" and running.contacts == 1
    assert running.scene.bodies[1].motion is not None
    assert taut2d.check(running.record()[0]).outcome == "free"
    # As the simulation has it from the contact on.
    rest = taut2d.check(taut2d.Scene(running.scene.bodies, (3, 10)))
    assert rest.outcome == "free"


def test_a_ram_pushes_a_block():
    running = simulation(taut2d.Velocity((1, 0)))
    while running.advance_to(10) == "contact":
        running.push("block", direction=(1, 0), step=0.5)
        running.resume()
    assert running.state == "finished" and running.contacts > 5
    assert taut2d.check(running.record()[0]).outcome == "free"
    with pytest.raises(taut2d.InputError, match="neither a hinge nor a direction"):
        running.push("block", step=1)
    door = simulation(taut2d.Velocity((1, 0)))
    assert door.advance_to(10) == "contact"
    door.push("block", hinge=(-1, 3), step=0.5)
    assert door.resume() == "running" and door.advance_to(3.6) in ("running", "contact")

"""Programs that go on after contacts: what bodies do then is up to the program, and these are some.

    from taut2d.examples import Elastic, billiards

    simulation, elastic = billiards(16)
    simulation.advance_many(20, elastic.respond)
    print(simulation.contacts, elastic.energy())

Elastic is the response of rigid bodies without friction. billiards() lets stars collide in a box, gripper() takes a part
along, and fleet() has robots that plan anew where they would meet.
"""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Optional

from .motions import Angle, Keyframes, Polynomial
from .scene import Body, Scene
from .simulations import SimulatedContact, Simulation

__all__ = ["Elastic", "RigidBody", "billiards", "fleet", "gripper", "rigid_body"]


@dataclass
class RigidBody:
    """A polygon with a mass that moves evenly since ``since``.

    ``mass``; ``inertia`` about its centre of mass, which is drawn at ``centre`` and has come to ``centre`` + ``at``;
    ``velocity``; ``angle`` and ``spin``, in radians.
    """

    mass: float
    inertia: float
    centre: tuple[float, float]
    at: tuple[float, float] = (0.0, 0.0)
    velocity: tuple[float, float] = (0.0, 0.0)
    angle: float = 0.0
    spin: float = 0.0
    since: float = 0.0

    def energy(self) -> float:
        """Of motion and of rotation."""
        return (self.mass * (self.velocity[0] ** 2 + self.velocity[1] ** 2) + self.inertia * self.spin ** 2) / 2

    def motion(self) -> Polynomial:
        """As Simulation.set_motion() takes it."""
        return Polynomial((self.at[0], self.velocity[0]), (self.at[1], self.velocity[1]), Angle((self.angle, self.spin)),
                          pivot=self.centre, origin=self.since)

    def advance_to(self, t: float) -> None:
        """Where it is at time t."""
        passed = t - self.since
        self.at = (self.at[0] + self.velocity[0] * passed, self.at[1] + self.velocity[1] * passed)
        self.angle = math.remainder(self.angle + self.spin * passed, 2 * math.pi)
        self.since = t


def rigid_body(outline: Sequence[Sequence[float]], density: float = 1.0) -> RigidBody:
    """Mass, centre of mass and moment of inertia of a polygon, by Green's theorem. It rests."""
    ox, oy = outline[0][0], outline[0][1]
    area = x = y = second = 0.0
    for k, p in enumerate(outline):
        q = outline[(k + 1) % len(outline)]
        ax, ay, bx, by = p[0] - ox, p[1] - oy, q[0] - ox, q[1] - oy
        w = ax * by - ay * bx
        area += w / 2
        x += w * (ax + bx) / 6
        y += w * (ay + by) / 6
        second += w * (ax * ax + ax * bx + bx * bx + ay * ay + ay * by + by * by) / 12
    cx, cy = x / area, y / area
    mass = abs(area) * density
    return RigidBody(mass, abs(second) * density - mass * (cx * cx + cy * cy), (ox + cx, oy + cy))


class Elastic:
    """Elastic collisions, without friction, of the bodies that have a mass; all others stay where they are.

    ``bodies``: by their names. ``gap``: how far a body is moved off a contact, so that the rounding of its new motion
    does not make it overlap; a few units in the last place of the scene's coordinates. ``respond`` is what
    Simulation.advance_many() calls.
    """

    def __init__(self, bodies: Mapping[str, RigidBody], gap: float) -> None:
        self.bodies = dict(bodies)
        self.gap = gap
        #: Set by the program that has the simulation.
        self.simulation: Optional[Simulation] = None
        #: What bodies without a mass were given.
        self.given_away = (0.0, 0.0)

    def energy(self) -> float:
        """Of all bodies."""
        return math.fsum(body.energy() for body in self.bodies.values())

    def momentum(self) -> tuple[float, float]:
        """Of all bodies, and what those without a mass were given."""
        return tuple(math.fsum([*(body.mass * body.velocity[i] for body in self.bodies.values()), self.given_away[i]])
                     for i in (0, 1))  # type: ignore[return-value]

    def respond(self, contact: SimulatedContact) -> None:
        """Reverses the velocity with which the two bodies approach each other, by an impulse along the normal."""
        assert self.simulation is not None
        t = self.simulation.time
        names = contact.bodies
        (px, py), (nx, ny) = contact.point, contact.normal
        approach = yields = 0.0
        sides = []
        for name, sign in zip(names, (1.0, -1.0)):
            body = self.bodies.get(name)
            if body is None:
                continue
            body.advance_to(t)
            turn = (px - body.centre[0] - body.at[0]) * ny - (py - body.centre[1] - body.at[1]) * nx
            approach += sign * (body.velocity[0] * nx + body.velocity[1] * ny + body.spin * turn)
            yields += 1 / body.mass + turn * turn / body.inertia
            sides.append((name, body, sign, turn))
        impulse = -2 * approach / yields if approach < 0 else 0.0
        for name, body, sign, turn in sides:
            push, way = sign * impulse, sign * self.gap
            body.velocity = (body.velocity[0] + push / body.mass * nx, body.velocity[1] + push / body.mass * ny)
            body.spin += push * turn / body.inertia
            body.at = (body.at[0] + way * nx, body.at[1] + way * ny)
            self.simulation.set_motion(name, body.motion())
        if len(sides) == 1:
            push = -sides[0][2] * impulse
            self.given_away = (self.given_away[0] + push * nx, self.given_away[1] + push * ny)


def _box(x: float, y: float, width: float, height: float) -> list[tuple[float, float]]:
    return [(x, y), (x + width, y), (x + width, y + height), (x, y + height)]


def _star(x: float, y: float, points: int) -> list[tuple[float, float]]:
    return [(x + r * math.cos(math.pi * k / points), y + r * math.sin(math.pi * k / points))
            for k, r in enumerate([1.0, 0.4] * points)]


def billiards(stars: int = 16, end: float = 1000.0, record: bool = False) -> tuple[Simulation, Elastic]:
    """Stars of five points in a box, which collide elastically, and their response."""
    columns = math.ceil(math.sqrt(stars))
    side = 3.0 * columns
    rigid: dict[str, RigidBody] = {}
    bodies: list[Body] = []
    for k in range(stars):
        outline = _star(3.0 * (k % columns) + 1.5, 3.0 * (k // columns) + 1.5, 5)
        body = rigid_body(outline)
        body.velocity = (0.1 * (7 * k % 11 - 5), 0.1 * (5 * k % 13 - 6))
        body.spin = 0.1 * (3 * k % 7 - 3)
        rigid[f"star {k}"] = body
        bodies.append(Body(f"star {k}", outline, body.motion()))
    walls = {"bottom": _box(-1, -1, side + 2, 1), "top": _box(-1, side, side + 2, 1), "left": _box(-1, 0, 1, side),
             "right": _box(side, 0, 1, side)}
    bodies += [Body(name, outline) for name, outline in walls.items()]
    simulation = Simulation(Scene(bodies, (0, end)), record=record)
    elastic = Elastic(rigid, 2.0 ** -42 * side)
    elastic.simulation = simulation
    return simulation, elastic


def gripper(record: bool = False) -> tuple[Simulation, list[str]]:
    """A gripper goes down to a part until it touches, takes it along, and puts it on a shelf: the simulation at its end, and
    what happened."""
    tool = Body("gripper", [(-1, 3), (1, 3), (1, 4), (-1, 4)], Polynomial((0,), (0, -0.5)))
    scene = Scene([tool, Body("part", [(-0.5, 0), (0.5, 0), (0.5, 1), (-0.5, 1)]),
                   Body("table", [(-3, -1), (3, -1), (3, 0), (-3, 0)]), Body("shelf", [(5, -1), (9, -1), (9, 0.5), (5, 0.5)])],
                  (0, 60), ignore=[("table", "shelf")])
    simulation = Simulation(scene, record=record)
    happened: list[str] = []

    def reach(what: str) -> float:
        simulation.advance_to(60)
        pair = simulation.pair or ()
        happened.append(f"{what}: {simulation.state} of {' and '.join(pair)} at {simulation.time:g}")
        return simulation.time

    gap = 2.0 ** -40
    t = reach("down")
    # The part is attached from now on, off the table by less than anything can be seen, and both rise.
    down = -0.5 * t
    simulation.set_motion("gripper", Polynomial((0,), (down, 0.5), origin=t))
    simulation.ignore("gripper", "part")
    simulation.set_parent("part", "gripper", Polynomial((0,), (-down + gap,)))
    simulation.resume()
    simulation.advance_to(t + 4)
    up = down + 2
    simulation.set_motion("gripper", Keyframes([(t + 4, 0, up), (t + 11, 7, up), (t + 61, 7, up - 25)]))
    t = reach("onto the shelf")
    y = up - 0.5 * (t - 15)
    simulation.set_parent("part", None, Polynomial((7,), (y - down + 2 * gap,)))
    simulation.set_motion("gripper", Polynomial((7,), (y, 0.5), origin=t))
    simulation.resume()
    reach("away")
    return simulation, happened


def fleet(robots: int = 6, record: bool = False) -> tuple[Simulation, int]:
    """Robots that cross a yard on straight lines. Where two would meet, the second one turns back home, and sets out again
    when it is there: the simulation at its end, and how often plans have changed."""
    shape = [(-1, -0.5), (0.5, -0.5), (1, 0), (0.5, 0.5), (-1, 0.5)]
    home = {f"robot {k}": (12 * math.cos(2 * math.pi * k / robots), 12 * math.sin(2 * math.pi * k / robots))
            for k in range(robots)}

    def leg(name: str, t: float, at: tuple[float, float], to: tuple[float, float], speed: float) -> Keyframes:
        x, y = home[name]
        angle = math.degrees(math.atan2(-y, -x))
        arrives = t + max(1e-6, math.dist(at, to) / speed)
        return Keyframes([(t, *at, angle), (arrives, *to, angle)])

    def place(name: str) -> tuple[float, float]:
        pose = simulation.scene.poses(simulation.time)[name]
        return pose.x, pose.y

    far = {name: (-0.9 * x, -0.9 * y) for name, (x, y) in home.items()}
    bodies = [Body(name, shape, leg(name, 0, home[name], far[name], 1 + 0.17 * k)) for k, name in enumerate(home)]
    simulation = Simulation(Scene(bodies, (0, 100)), record=record)
    changes = 0

    def plan_anew(contact: SimulatedContact) -> None:
        nonlocal changes
        changes += 1
        t, (nx, ny) = simulation.time, contact.normal
        for name, sign in zip(contact.bodies, (1, -1)):
            # Off the other one by what rounding needs, and home.
            x, y = place(name)
            at = (x + sign * 1e-9 * nx, y + sign * 1e-9 * ny)
            simulation.set_motion(name, leg(name, t, at, home[name], 1.0))

    simulation.advance_many(100, plan_anew)
    return simulation, changes

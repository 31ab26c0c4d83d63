"""Tests the contact sequences of followers of cams that turn, without computing them another way.

Usage: follow_test.py TAUT

Some answers are known by hand. Random instants are judged by the lift at that instant, in doubles. Sequences keep what does not
matter: the time reversed, the scene mirrored, the follower and the cam cut into parts, the scene moved and turned as a whole.
"""

import json
import math
import random

from follow_sequences import EFFORT, ask, covered, star, touching


def placed(points, pose):
    x, y, c, s = pose
    return [(x + c * p[0] - s * p[1], y + s * p[0] + c * p[1]) for p in points]


def sampled(cam, follower):
    """The lift of one polygon above another one, by definition, in doubles, and what has it up to rounding."""
    best, lifts = -math.inf, []
    for below, points, edges in ((True, follower, cam), (False, cam, follower)):
        for i, p in enumerate(points):
            for k, a in enumerate(edges):
                b = edges[(k + 1) % len(edges)]
                lo, hi = min(a[0], b[0]), max(a[0], b[0])
                if not lo <= p[0] <= hi or lo == hi:
                    continue
                height = a[1] + (b[1] - a[1]) * (p[0] - a[0]) / (b[0] - a[0])
                lift = height - p[1] if below else p[1] - height
                names = ("follower", "cam") if below else ("cam", "follower")
                lifts.append((lift, ((names[0], 0, 0, i), (names[1], 0, 0, k))))
                best = max(best, lift)
    return best, {name for lift, name in lifts if lift > best - 1e-9}, lifts


def turning(rng):
    """A cam that turns and moves, and a follower, as a scene and as functions of the time."""
    cam, follower = star(rng, rng.randint(4, 12), 4), [[x, y + 4] for x, y in star(rng, rng.randint(3, 7), 2)]
    rates = [rng.uniform(-1, 1), rng.uniform(-6, 6), rng.uniform(-2, 2)]
    x, y = [rng.uniform(-1, 1), rng.uniform(-2, 2)], [rng.uniform(-1, 1), rng.uniform(-1, 1)]
    scene = {"time": [0, 1], "bodies": [
        {"name": "cam", "polygon": cam, "motion": {"x": x, "y": y, "rotation": {"angle": rates}}},
        {"name": "follower", "polygon": follower}]}

    def pose(t):
        angle = rates[0] + rates[1] * t + rates[2] * t * t
        return x[0] + x[1] * t, y[0] + y[1] * t, math.cos(angle), math.sin(angle)
    return scene, cam, follower, pose


def rotations(count):
    rng = random.Random(11)
    stretches = changes = once = jumps = 0
    for _ in range(count):
        scene, cam, follower, pose = turning(rng)
        sequence = ask(scene)["contacts"]
        covered(sequence, 0, 1)
        where = json.dumps(scene)
        stretches += len(sequence)
        for one in sequence:
            assert one["state"] != "open", f"{one}\n{where}"
            changes += one["state"] == "change"
            once += "once" in one
            jumps += "jumps" in one
        for k in range(2000):
            t = rng.random()
            lift, names, _ = sampled(placed(cam, pose(t)), follower)
            one = next(s for s in sequence if s["t"][0] <= t <= s["t"][1])
            if lift < -1e-9:
                assert one["state"] in ("low", "change"), f"{t} {lift} {one}\n{where}"
            elif lift > 1e-9:
                assert one["lift"][0] - 1e-9 <= lift <= one["lift"][1] + 1e-9, f"{t} {lift} {one}\n{where}"
                assert touching(one) & names, f"{t} {names} {one}\n{where}"
                assert one["state"] == "change" or len(touching(one)) == 1, f"{one}\n{where}"
    print(f"rotations: {stretches} stretches, {changes} changes, {once} of them once, {jumps} jumps")
    assert once > 0.9 * changes and (jumps > 0 or count < 100)


def alike(one, two, rename=lambda c: c, of_time=lambda t: t, backwards=False):
    """Do two sequences say the same, up to the tolerance of the changes?"""
    two = list(reversed(two)) if backwards else two
    short = 4e-9

    def stretches(sequence, name, time):
        found = []
        for s in sequence:
            if s["state"] in ("carried", "low"):
                lo, hi = sorted(time(t) for t in s["t"])
                found.append((lo, hi, frozenset(name(c) for c in touching(s))))
        return found
    a, b = stretches(one, lambda c: c, lambda t: t), stretches(two, rename, of_time)
    assert len(a) == len(b), (a, b)
    for s, r in zip(a, b):
        assert abs(s[0] - r[0]) < short and abs(s[1] - r[1]) < short and s[2] == r[2], (s, r)


def laws(count):
    rng = random.Random(13)
    for _ in range(count):
        scene, cam, follower, _ = turning(rng)
        motion = scene["bodies"][0]["motion"]
        first = ask(scene)["contacts"]

        # The time reversed: polynomials in 1 - t.
        def reversed_polynomial(c):
            c = list(c) + [0] * (3 - len(c))
            return [c[0] + c[1] + c[2], -c[1] - 2 * c[2], c[2]]
        back = json.loads(json.dumps(scene))
        back["bodies"][0]["motion"] = {"x": reversed_polynomial(motion["x"]), "y": reversed_polynomial(motion["y"]),
                                       "rotation": {"angle": reversed_polynomial(motion["rotation"]["angle"])}}
        alike(first, ask(back)["contacts"], of_time=lambda t: 1 - t, backwards=True)

        # Mirrored at the y axis: vertex k becomes n - 1 - k, and edge k becomes n - 2 - k.
        n = {"cam": len(cam), "follower": len(follower)}
        mirrored = json.loads(json.dumps(scene))
        for body in mirrored["bodies"]:
            body["polygon"] = [[-x, y] for x, y in reversed(body["polygon"])]
        mirrored["bodies"][0]["motion"] = {"x": [-v for v in motion["x"]], "y": motion["y"],
                                           "rotation": {"angle": [-v for v in motion["rotation"]["angle"]]}}

        def of_mirror(contact):
            (b, _, _, i), (e, _, _, k) = contact
            return (b, 0, 0, n[b] - 1 - i), (e, 0, 0, (2 * n[e] - 2 - k) % n[e])
        alike(first, ask(mirrored)["contacts"], rename=of_mirror)

        # Both on a table that turns and moves: the follower is seen from it.
        table = {"name": "table", "polygon": [[0, 0], [1, 0], [0, 1]],
                 "motion": {"x": [3, 1], "y": [-2, 5], "rotation": {"angle": [1, 2]}}}
        carried = {"time": [0, 1], "bodies": [table] + [{**b, "relative_to": "table"} for b in scene["bodies"]],
                   "ignore": [["table", "*"]]}
        alike(first, ask(carried)["contacts"])

        # The follower as its triangles about the centre, and the cam, too: the same edges, with other numbers.
        for name, centre in (("follower", [0, 4]), ("cam", [0, 0])):
            parts = json.loads(json.dumps(scene))
            body = next(b for b in parts["bodies"] if b["name"] == name)
            points = body.pop("polygon")
            body["parts"] = [{"outline": [points[k], points[(k + 1) % len(points)], centre]} for k in range(len(points))]
            m = len(points)

            def whole(feature, is_vertex, name=name, m=m):
                body, part, _, index = feature
                if body != name:
                    return feature
                return (body, 0, 0, (part + index) % m) if is_vertex else (body, 0, 0, part)
            alike(first, ask(parts)["contacts"], rename=lambda c, w=whole: (w(c[0], True), w(c[1], False)))
    print(f"laws: {count} scenes")


def known():
    """Scenes whose answers are known by hand."""
    square = {"name": "cam", "polygon": [[-1, -1], [1, -1], [1, 1], [-1, 1]]}
    plate = {"name": "follower", "polygon": [[-3, 1], [3, 1], [3, 2], [-3, 2]]}
    # A block goes straight up under a plate: an edge on an edge, all the time.
    up = ask({"time": [0, 1], "bodies": [{**square, "motion": {"y": [0.5, 1]}}, plate]})["contacts"]
    assert [s["state"] for s in up] == ["carried"], up
    assert touching(up[0]) == {(("cam", 0, 0, 2), ("follower", 0, 0, 0)), (("cam", 0, 0, 3), ("follower", 0, 0, 0))}
    # It comes from below: nothing is lifted until then. From 0 on, the lift is as it was at the start.
    late = ask({"time": [0, 1], "bodies": [{**square, "motion": {"y": [-0.5, 1]}}, plate]})["contacts"]
    assert [s["state"] for s in late] == ["low", "change", "carried"] and late[1]["once"] and "jumps" not in late[1]
    # It slides away beside an edge as wide as itself: the sides along the direction are no contacts.
    wall = {"name": "wall", "polygon": [[1, -1], [2, -1], [2, 5], [1, 5]]}
    block = {"name": "follower", "polygon": [[-1, 1], [1, 1], [1, 2], [-1, 2]]}
    beside = ask({"time": [0, 1], "bodies": [{**square, "motion": {"y": [0.5, 0.5]}}, wall, block]})["contacts"]
    assert [s["state"] for s in beside] == ["carried"] and len(beside[0]["touching"]) == 4, beside
    # A table leaves: the follower falls from its edge.
    falls = ask({"time": [0, 4], "bodies": [{**square, "motion": {"y": [1], "x": [0, -1]}}, block]})["contacts"]
    assert [s["state"] for s in falls] == ["change", "carried", "change", "low"], falls
    assert falls[2]["once"] and falls[2]["jumps"] and falls[2]["t"][0] <= 2 <= falls[2]["t"][1]
    # A rod on two towers of the same height, which move to and fro: both, all the time.
    towers = [{"name": f"tower {k}", "polygon": [[x, 0], [x + 1, 0], [x + 0.5, 1]], "motion": {"y": [1, 1, -1]}}
              for k, x in enumerate((-2, 1))]
    both = ask({"time": [0, 1], "bodies": [*towers, plate]})["contacts"]
    assert [s["state"] for s in both] == ["carried"] and len(both[0]["touching"]) == 2, both
    # A square that turns: a corner each, and all changes at quarter turns.
    turns = ask({"time": [-0.125, 0.875], "bodies": [
        {**square, "motion": {"sweep": {"pivot": [0, 0], "from_deg": -45, "to_deg": 315}}}, plate]})["contacts"]
    corners = [touching(s) for s in turns if s["state"] == "carried"]
    assert [next(iter(c))[0] for c in corners] == [("cam", 0, 0, k) for k in (3, 2, 1, 0, 3)], corners
    assert [s["once"] for s in turns if s["state"] == "change"] == [True] * 4
    # A table that a slide of a mechanism carries, beside one that moves alike: the motion of the first is known by loops.
    ram = {"name": "ram", "polygon": [[-1, -1], [1, -1], [1, 1], [-1, 1]]}
    frame = {"name": "frame", "polygon": [[9, -9], [10, -9], [10, -8]]}
    press = ask({"time": [0, 1], "bodies": [frame, ram, plate], "mechanism": {
        "ground": "frame", "joints": {"S": {"slide": ["frame", "ram"], "direction": [0, 1]}},
        "drive": {"S": {"from": 0.5, "to": 2}}}})
    assert [s["state"] for s in press["contacts"]] == ["carried"] and len(press["contacts"][0]["touching"]) == 2, press
    # A crank moves a block to and fro, whose flat face carries the plate at one height.
    crank = {"name": "crank", "polygon": [[0, -9], [2, -9], [0, -8]], "z": [5, 6]}
    rod = {"name": "rod", "polygon": [[2, -9], [6, 0], [5, 0]], "z": [6, 7]}
    slider = {"name": "slider", "polygon": [[2, -1], [8, -1], [8, 2], [2, 2]], "z": [0, 1]}
    top = {"name": "follower", "polygon": [[4, 1.5], [5, 1.5], [5, 3], [4, 3]], "z": [0, 1]}
    yoke = ask({"time": [0, 360], "bodies": [frame, crank, rod, slider, top], "mechanism": {
        "ground": "frame", "joints": {
            "A": {"revolute": ["frame", "crank"], "at": [0, 0]}, "B": {"revolute": ["crank", "rod"], "at": [1, 0]},
            "C": {"revolute": ["rod", "slider"], "at": [5, 0]}, "S": {"slide": ["frame", "slider"], "direction": [1, 0]}},
        "drive": {"A": {"from_deg": 0, "to_deg": 360}}}})
    assert [s["state"] for s in yoke["contacts"]].count("open") == 0, yoke
    carried = [s for s in yoke["contacts"] if s["state"] == "carried"]
    assert len(carried) >= 1 and all(s["lift"][0] <= 0.5 <= s["lift"][1] for s in carried), yoke
    # Teeth under a tip, many in as much time as is called a change.
    teeth = [[0.5 - 0.025 * k, 0.2 * (k % 2)] for k in range(21)]
    saw = {"name": "cam", "polygon": [[-5, -2], [5, -2], [5, 0], *teeth, [-5, 0]], "motion": {"x": [-2, 4]}}
    tip = {"name": "follower", "polygon": [[0, -0.5], [0.5, 1], [-0.5, 1]]}
    many = ask({"time": [0, 1], "bodies": [saw, tip]}, tolerance=0.1)
    assert "smaller one" in many["contacts_reason"] and [s["state"] for s in many["contacts"]].count("open") == 1, many
    few = ask({"time": [0, 1], "bodies": [saw, tip]})
    assert "contacts_reason" not in few and [s["state"] for s in few["contacts"]].count("carried") >= 20, few
    print("known answers")


def main():
    known()
    rotations(max(10, int(100 * EFFORT)))
    laws(max(5, int(40 * EFFORT)))


main()

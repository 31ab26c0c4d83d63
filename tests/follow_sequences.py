"""What tests of followers share: how they ask for a sequence of contacts, what holds of every sequence, and random shapes."""

import json
import math
import os
import subprocess
import sys
import tempfile

TAUT = os.path.abspath(sys.argv[1])
EFFORT = {"tenth": 0.1}.get(os.environ.get("TAUT_EFFORT", ""), 1.0)


def ask(scene, body="follower", reach=100, tolerance=1e-9, extra=()):
    with tempfile.TemporaryDirectory() as folder:
        name = os.path.join(folder, "scene.json")
        with open(name, "w", encoding="utf-8") as file:
            json.dump({"format": "taut-scene/1", **scene}, file)
        run = subprocess.run([TAUT, "follow", name, "--body", body, "--reach", str(reach), "--contacts", "--instants", "1",
                              "--tolerance", repr(tolerance), "--json", *extra], capture_output=True, text=True, check=False)
    if run.returncode not in (0, 3):
        raise AssertionError(f"exit code {run.returncode}: {run.stderr}\n{json.dumps(scene)}")
    return json.loads(run.stdout)


def contact_of(value):
    def feature(f):
        return (f["body"], f.get("part", 0), f.get("ring", 0), f["index"])
    return feature(value["vertex"]), feature(value["edge"])


def touching(stretch):
    return frozenset(contact_of(c) for c in stretch["touching"])


def covered(sequence, start, end):
    assert sequence[0]["t"][0] == start and sequence[-1]["t"][1] == end
    for one, two in zip(sequence, sequence[1:]):
        assert one["t"][1] == two["t"][0], (one, two)
    for one in sequence:
        assert one["t"][0] <= one["t"][1] and one["lift"][0] <= one["lift"][1], one


def shape(rng, n, radius, grid):
    """A star-shaped polygon, or one whose corners are on a grid."""
    if grid:
        kind = rng.randrange(4)
        a, b = rng.randint(1, 3), rng.randint(1, 3)
        if kind == 0:
            return [[-a, -b], [a, -b], [a, b], [-a, b]]
        if kind == 1:  # a step
            return [[-a, 0], [a + 1, 0], [a + 1, 1], [0, 1], [0, b + 1], [-a, b + 1]]
        if kind == 2:  # a fork, upwards
            return [[-2, -1], [2, -1], [2, b], [1, b], [1, 0], [-1, 0], [-1, b], [-2, b]]
        return [[-2, b + 1], [-2, -1], [-1, -1], [-1, b], [1, b], [1, -1], [2, -1], [2, b + 1]]  # downwards
    angles = sorted(rng.uniform(0, 2 * math.pi) for _ in range(n))
    while max((b - a) % (2 * math.pi) for a, b in zip(angles, angles[1:] + angles[:1])) > 2.9:
        angles = sorted(rng.uniform(0, 2 * math.pi) for _ in range(n))
    points = []
    for angle in angles:
        r = radius * rng.uniform(0.4, 1)
        points.append([round(r * math.cos(angle) * 16) / 16, round(r * math.sin(angle) * 16) / 16])
    return points


def simple(points):
    def cross(a, b, c):
        return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])
    n = len(points)
    if any(cross([0, 0], points[k], points[(k + 1) % n]) <= 0 for k in range(n)):
        return False
    return all(cross(points[k], points[(k + 1) % n], points[(k + 2) % n]) != 0 for k in range(n))


def star(rng, n, radius):
    while True:
        points = shape(rng, n, radius, False)
        if simple(points):
            return points

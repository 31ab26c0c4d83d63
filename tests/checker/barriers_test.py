#!/usr/bin/env python3
"""Of random problems about translations, and of those in examples/paths and ../shared/paths, the independent checker must accept what
`taut prove` writes; and of damaged logs, and of logs given to other problems, what `taut verify` accepts and nothing else.

usage: barriers_test.py TAUT REPOSITORY"""

import collections
import json
import pathlib
import random
import struct
import subprocess
import sys
import tempfile

from barriers import Refused, check
from checker import checksum
from covered import NotCovered
from effort import effort

RANDOM = effort(400, 60)
DAMAGED = 4


def random_scene(rng, touch):
    """Blocks of a grid around a mover of a few blocks; moved along the axes, or by one slide. Where bodies may not touch, the mover
    is half of a block, and goals are often where it touches one."""
    size, outside = rng.randint(3, 6), rng.random() < 0.3
    block = lambda at: [[at[0], at[1]], [at[0] + 1, at[1]], [at[0] + 1, at[1] + 1], [at[0], at[1] + 1]]
    scale = rng.choice([1, 0.75, 0.1])
    drawn = lambda ring: [[x * scale, y * scale] for x, y in ring]
    at_border = lambda x, y: x in (-1, size) or y in (-1, size)
    gap = rng.randrange(4 * size)
    rest = [(x, y) for x in range(-1, size + 1) for y in range(-1, size + 1)
            if (at_border(x, y) and (x + 3 * y) % (4 * size) != gap) or (not at_border(x, y) and rng.random() < 0.35)]
    free = [(x, y) for x in range(size) for y in range(size) if (x, y) not in rest] or [(0, 0)]
    start, goal = rng.choice(free), rng.choice(free)
    mover = [(0, 0)] + ([(1, 0)] if (start[0] + 1, start[1]) in free and rng.random() < 0.5 else [])
    slides = rng.random() < 0.2
    parts, room = [drawn(block(at)) for at in mover], 0
    if touch == "closed":
        parts, room = [drawn([[0, 0], [0.5, 0], [0.5, 0.5], [0, 0.5]])], 0.25
    motion = {"slide": {"direction": [2, 1], "by": "x", "plus": 0.5 * scale}} if slides else {"free": {"x": "x", "y": "y"}}
    scene = {"format": "taut-scene/1", "joints": {"x": [-2, 2 * size], "y": [-2, 2 * size]},
             "bodies": [{"name": "mover", "parts": parts, "motion": motion},
                        {"name": "rest", "parts": [drawn(block(at)) for at in rest]}],
             "start": {"x": (start[0] + room) * scale, "y": (start[1] + room) * scale},
             "goal": "outside" if outside else {"x": (goal[0] + rng.choice([0, room])) * scale}}
    if not outside and rng.random() < 0.5:
        low = (goal[1] + rng.choice([0, room])) * scale
        scene["goal"]["y"] = [low, low + rng.choice([0, 2 * room * scale])]
    return scene


def sealed(data):
    return data + struct.pack("<Q", checksum(data))


def damaged(rng, data):
    body = bytearray(data[:-8])
    at = rng.randrange(40, len(body))
    kind = rng.randrange(4)
    if kind == 0:
        body[at] = rng.randrange(256)
    elif kind == 1:
        body[at] = rng.randrange(4)
    elif kind == 2:
        del body[at:at + rng.randint(1, 40)]
    else:
        # A coordinate as of another place.
        places = [i for i in range(40, len(body) - 8) if body[i + 7:i + 8] in (b"\x3f", b"\x40", b"\xbf", b"\xc0")]
        if len(places) > 1:
            a, b = rng.sample(places, 2)
            body[a:a + 8] = body[b:b + 8]
    return sealed(bytes(body))


class Run:
    def __init__(self, taut, folder):
        self.taut, self.scene, self.log = taut, folder / "scene.json", folder / "log"
        self.seen, self.rng = collections.Counter(), random.Random(7)

    def prove(self, scene, touch):
        self.scene.write_text(json.dumps(scene))
        self.log.unlink(missing_ok=True)
        subprocess.run([self.taut, "prove", "--touch", touch, self.scene, "-o", self.log], capture_output=True)
        return self.log.read_bytes() if self.log.exists() else None

    def is_valid(self, data):
        self.log.write_bytes(data)
        run = subprocess.run([self.taut, "verify", self.scene, self.log], capture_output=True, text=True)
        assert run.returncode in (0, 1), run.stderr
        return run.returncode == 0

    def ask(self, name, scene, touch):
        data = self.prove(scene, touch)
        if data is None or data[7:8] != b"7":
            return
        try:
            check(scene, data)
        except NotCovered:
            return
        except Refused as why:
            raise AssertionError(f"{name}, {touch}: the log is refused: {why}") from None
        self.seen["logs"] += 1
        for _ in range(DAMAGED):
            other = damaged(self.rng, data)
            try:
                check(scene, other)
                accepted = True
            except Refused:
                accepted = False
            if self.is_valid(other) != accepted:
                raise AssertionError(f"{name}, {touch}: the checker {'accepts' if accepted else 'refuses'} a damaged log, and "
                                     f"`taut verify` does not: {other.hex()} of {json.dumps(scene)}")
            self.seen["damaged, accepted" if accepted else "damaged, refused"] += 1


def main():
    taut, repository = pathlib.Path(sys.argv[1]), pathlib.Path(sys.argv[2])
    with tempfile.TemporaryDirectory() as folder:
        run = Run(taut, pathlib.Path(folder))
        files = sorted((repository / "examples/paths").glob("*.json")) + sorted(
            (repository.resolve().parent / "shared/paths").glob("*.json"))
        for file in files:
            text = file.read_text()
            if any(word in text for word in ('"deg"', "revolute", "outcome")):
                continue
            for touch in ("open", "closed"):
                run.ask(file.name, json.loads(text), touch)
        rng = random.Random(5)
        for i in range(RANDOM):
            touch = rng.choice(["open", "closed"])
            run.ask(f"random scene {i}", random_scene(rng, touch), touch)
        print(dict(run.seen))
        assert run.seen["logs"] >= RANDOM / 8 and min(run.seen.values()) > 0, run.seen


if __name__ == "__main__":
    main()

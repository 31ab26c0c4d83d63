#!/usr/bin/env python3
"""The independent checker of exact logs must accept what `taut prove --exact` writes about the examples and the corpus,
and of damaged logs, and of logs of scenes that changed after them, nothing that `taut check` contradicts.

usage: exact_logs_test.py TAUT REPOSITORY"""

import collections
import copy
import json
import pathlib
import random
import subprocess
import sys
import tempfile
import time

from covered import NotCovered
from effort import effort
from exact_logs import ExactScene, check

# Sizes of logs, in bytes: of those that are checked, and of those that are damaged, which takes as long as reading them.
LARGEST = effort(10**6, 2 * 10**5)
LARGEST_DAMAGED = 10**5


class Damage:
    """Ways to damage a log. Each returns whether what comes out of it can be a proof still, and None if there is
    nothing to damage."""

    def __init__(self, rng, contact, end):
        self.rng, self.contact, self.end = rng, contact, end

    def a_window(self, log):
        return self.rng.choice(self.rng.choice(log["pairs"])["windows"])

    def a_line(self, log):
        window = self.a_window(log)
        return self.rng.choice([step for step in window if isinstance(step, list)])

    def pair_left_out(self, log):
        log["pairs"].pop(self.rng.randrange(len(log["pairs"])))
        return False

    def window_left_out(self, log):
        windows = self.rng.choice(log["pairs"])["windows"]
        windows.pop(self.rng.randrange(len(windows)))
        return False

    def window_stretched_over_the_next(self, log):
        windows = self.rng.choice(log["pairs"])["windows"]
        if len(windows) < 2:
            return None
        k = self.rng.randrange(len(windows) - 1)
        windows[k][1] = windows[k + 1][1]
        windows.pop(k + 1)
        return True

    def step_left_out(self, log):
        window = self.a_window(log)
        window.pop(self.rng.randrange(2, len(window)))
        return False

    def other_body_halved(self, log):
        window = self.a_window(log)
        halved = [k for k in range(2, len(window)) if not isinstance(window[k], list)]
        if not halved:
            return None
        k = self.rng.choice(halved)
        window[k] = 3 - window[k]
        return True

    def line_turned_round(self, log):
        line = self.a_line(log)
        line[:] = [-x for x in line]
        return False

    def line_moved(self, log):
        line = self.a_line(log)
        line += [0] * (3 - len(line))
        size = max(map(abs, line[:3]))
        line[2] += self.rng.choice((-1, 1)) * size * 2.0 ** self.rng.randrange(-40, 4)
        return True

    def line_tilted(self, log):
        line = self.a_line(log)
        line[self.rng.randrange(len(line))] *= 1 + self.rng.choice((-1, 1)) * 2.0 ** self.rng.randrange(-40, 2)
        return True

    def ends_later(self, log):
        """At the contact, or when the scene ends."""
        if not self.contact:
            log["until"] = self.end + 1
            return False
        log["until"] = self.rng.choice((self.contact, self.end))
        if self.rng.random() < 0.8:
            for pair in log["pairs"]:
                pair["windows"][-1][1] = log["until"]
        return False


KINDS = [name for name, member in vars(Damage).items() if not name.startswith(("_", "a_")) and callable(member)]


def pushed(scene, rng):
    """The scene with a body that somebody has pushed."""
    scene = copy.deepcopy(scene)
    body = rng.choice(scene["bodies"])
    parts = body["parts"] if "parts" in body else [body["polygon"]]
    rings = [ring for part in parts for ring in
             ([part["outline"], *part.get("holes", [])] if isinstance(part, dict) else [part])]
    size = max(abs(c) for ring in rings for v in ring for c in v)
    by = [size * rng.uniform(-1, 1) * 2.0 ** rng.randrange(-12, 1) for _ in (0, 1)]
    for ring in rings:
        ring[:] = [[x + dx for x, dx in zip(v, by)] for v in ring]
    return scene


class Test:
    def __init__(self, taut, folder):
        self.taut, self.counts, self.findings = taut, collections.Counter(), 0
        self.scene_file, self.log_file = pathlib.Path(folder, "scene.json"), pathlib.Path(folder, "log.json")
        self.rng = random.Random(1)

    def contact(self, file):
        """When the bodies have come into contact, None if they do not; raises ValueError where that is not known."""
        out = subprocess.run([self.taut, "check", "--touch", "closed", "--json", file], stdout=subprocess.PIPE,
                             stderr=subprocess.DEVNULL, check=False).stdout
        answer = json.loads(out)  # nothing where the scene is not valid
        if answer["outcome"] not in ("free", "contact"):
            raise ValueError("an answer that is not known")
        t = answer.get("t", answer["scope"]["time"][0])
        return None if answer["outcome"] == "free" else max(t) if isinstance(t, list) else t

    def judge(self, kind, verdict, accepted):
        """`accepted`: whether it has to be, None if it may be."""
        until, reason, decided = verdict
        self.counts[kind, "accepted" if until is not None else "refused" if decided else "undecided"] += 1
        if accepted is not None and (until is not None) != accepted:
            self.finding(f"{kind}: {reason or 'accepted'}")

    def finding(self, text):
        self.findings += 1
        print(f"{self.file}: {text}")

    def file_with_log(self, file):
        self.file = file
        self.log_file.unlink(missing_ok=True)
        subprocess.run([self.taut, "prove", "--exact", "--max-seconds", "1", file, "-o", self.log_file], stdout=subprocess.DEVNULL,
                       stderr=subprocess.DEVNULL, check=False)
        if not self.log_file.exists() or self.log_file.stat().st_size > LARGEST:
            return
        given, text, known = json.loads(file.read_text()), self.log_file.read_text(), {}
        try:
            scene = ExactScene(given)
        except NotCovered:
            self.counts["a scene", "not covered"] += 1
            return
        self.judge("as written", check(scene, json.loads(text), known), True)
        if len(text) > LARGEST_DAMAGED:
            return
        contact = self.contact(file)
        for _ in range(effort(2, 1)):
            for kind in KINDS:
                log = json.loads(text)
                may_be = getattr(Damage(self.rng, contact, scene.end), kind)(log)
                if may_be is not None:
                    self.judge(kind, check(scene, log, known), None if may_be else False)
        for _ in range(effort(4)):
            self.push(given, text)

    def push(self, given, text):
        other = pushed(given, self.rng)
        verdict = check(ExactScene(other), json.loads(text), {})
        self.judge("a body pushed", verdict, None)
        if verdict[0] is None:
            return
        self.scene_file.write_text(json.dumps(other))
        try:
            contact = self.contact(self.scene_file)
        except ValueError:
            self.counts["a body pushed", "nothing to compare with"] += 1
            return
        if contact is not None and contact <= verdict[0]:
            self.finding(f"accepted until {verdict[0]}, with a contact at {contact}, once a body is pushed: "
                         f"{json.dumps(other)}")


def square(r):
    return [[-r, -r], [r, -r], [r, r], [-r, r]]


def rings_test():
    """A square within another one has edges apart from its edges. Only where that has a hole the bodies are, too."""
    lines = [[0, 1, -2], [-1, 0, -2], [0, -1, -2], [1, 0, -2]]  # below, right, above, left of the inner square
    refuted = []
    for holes, expected in (([], False), ([square(3)], True)):
        steps = 2 * [1, 1, *lines[:2], 1, *lines[2:]]
        steps = [1, *steps] if holes else steps[:7]
        for inner_first in (False, True):
            bodies = [{"name": "outer", "polygon": {"outline": square(4), "holes": holes}},
                      {"name": "inner", "polygon": square(1), "motion": {"velocity": [0.25, 0]}}]
            written = steps
            if inner_first:
                bodies.reverse()
                written = [[-x for x in s] if isinstance(s, list) else 2 for s in steps]
            log = {"format": "taut-exact/1", "until": 1,
                   "pairs": [{"pair": [0, 1], "windows": [[0, 1, *written]]}]}
            verdict = check(ExactScene({"time": [0, 1], "bodies": bodies}), log, {})
            wanted = (1.0, "") if expected else (None, "a ring is within the other body")
            if verdict[:2] != wanted:
                refuted.append(f"a square in {'a hole' if holes else 'another square'}: {verdict}")
    return refuted


def main():
    taut, root = sys.argv[1], pathlib.Path(sys.argv[2])
    sys.setrecursionlimit(10000)
    began = time.process_time()
    files = sorted(file for folder in ("examples", "examples/worlds", "tests/corpus", "tests/corpus/worlds")
                   for file in (root / folder).glob("*.json") if not file.name.endswith(".answer.json"))
    with tempfile.TemporaryDirectory() as folder:
        test = Test(taut, folder)
        for file in files:
            test.file_with_log(file)
    for key, count in sorted(test.counts.items()):
        print(*key, count)
    refuted = rings_test()
    print(*refuted, sep="\n", end="\n" if refuted else "")
    valid = test.counts["as written", "accepted"]
    damaged = sum(count for (_, what), count in test.counts.items() if what == "refused")
    print(f"{valid} logs, {damaged} damaged ones refused, {test.findings + len(refuted)} findings, "
          f"{time.process_time() - began:.1f} s")
    return 1 if test.findings or refuted or valid < 50 or damaged < 100 else 0


if __name__ == "__main__":
    sys.exit(main())

#!/usr/bin/env python3
"""No answer says more than was tested: the law of coverage, over all questions of the command.

Draws scenes of bodies at rest, bodies that move alike, attached bodies and ignore lists, in which bodies overlap. How many
pairs are excluded, and why, is counted here from what the scene was made of. Then for every question:

* JSON: coverage is just that, its parts add up, and the outcome is "untested" if and only if nothing is left to test.
* Text: if pairs were not tested, one of the first two lines says so; "free" and what is like it are said of nothing else.
* Limits that are reached at once: nothing is counted as tested, and no pair disappears from what is counted.
* Exit codes: 2 where nothing was tested, 0 with --allow-untested; 3 where a limit ended the run, with UNDECIDED first.

usage: coverage_test.py TAUT [SCENES]
"""

import json
import os
import random
import re
import subprocess
import sys
import tempfile
from itertools import combinations

QUESTIONS = [["check"], ["check", "--pairs", "all"], ["check", "--engine", "both"], ["check", "--touch", "closed"],
             ["check", "--clearance", "0.25"], ["clearance"], ["clearance", "--profile", "3"], ["intervals"],
             ["range", "--from", "0.5"], ["separate"], ["prove", "-o", "log"]]
CLAIMS = re.compile(r"^(FREE|NO OVERLAP|CLEARANCE|PROFILE|VALID|.*keep)")
MOTIONS = [None, {"velocity": [0.25, 0]}, {"velocity": [0, 1]}, {"sweep": {"from_deg": 0, "to_deg": 90}}]


def square(x, y):
    return [[x, y], [x + 1, y], [x + 1, y + 1], [x, y + 1]]


def draw(rng):
    """A scene, and for each body its parent and the number of its motion (0: it rests in its parent's frame)."""
    n = rng.choice([1, 2, 2, 3, 3, 4, 5])
    bodies, parents, motions = [], [], []
    for k in range(n):
        parent = rng.randrange(k) if k and rng.random() < 0.3 else None
        motion = rng.choice([0, 0, 0, 1, 1, 2, 3])
        body = {"name": f"b{k}", "polygon": square(rng.choice([0, 0.5, 4]), rng.choice([0, 0.5, 4]))}
        if MOTIONS[motion]:
            body["motion"] = MOTIONS[motion]
        if parent is not None:
            body["relative_to"] = f"b{parent}"
        bodies.append(body)
        parents.append(parent)
        motions.append(motion)
    scene = {"format": "taut-scene/1", "time": [0, 1], "bodies": bodies}
    names = [b["name"] for b in bodies] + ["*"]
    ignore = [rng.sample(names, 2) for _ in range(rng.choice([0, 0, 0, 1, 1, 2, 4])) if n > 1]
    if ignore:
        scene["ignore"] = ignore
    if rng.random() < 0.25:
        scene["at_rest"] = "test"
    return scene, parents, motions


def counted(scene, parents, motions):
    """What is left out and why, by definition."""
    def chain(k):
        return ([] if k is None else chain(parents[k]) + ([motions[k]] if motions[k] else []))

    names = [b["name"] for b in scene["bodies"]]
    ignored = {frozenset(pair) for a, b in scene.get("ignore", []) for pair in combinations(names, 2)
               if (a in pair and b in (*pair, "*")) or (b in pair and a == "*")}
    chains = [chain(k) for k in range(len(names))]
    alone = {name for a, b in scene.get("ignore", []) if "*" in (a, b) for name in (a, b)} - {"*"}
    heard = [c for name, c in zip(names, chains) if name not in alone]
    skips = any(c != heard[0] for c in heard) and scene.get("at_rest") != "test"
    count = {"pairs": 0, "ignored": 0, "moving_alike": 0, "at_rest": 0}
    for a, b in combinations(range(len(names)), 2):
        count["pairs"] += 1
        if frozenset((names[a], names[b])) in ignored:
            count["ignored"] += 1
        elif skips and chains[a] == chains[b]:
            count["moving_alike" if chains[a] else "at_rest"] += 1
    return count


class Judge:
    def __init__(self, taut, folder):
        self.taut, self.folder, self.failures, self.judged = taut, folder, 0, 0

    def run(self, *args):
        done = subprocess.run([self.taut, *args], capture_output=True, text=True, cwd=self.folder)
        return done.returncode, done.stdout, done.stderr

    def fail(self, args, what):
        self.failures += 1
        with open(os.path.join(self.folder, "scene.json")) as file:
            print(f"FAILED: taut {' '.join(args)}: {what}\n{file.read()}")

    def expect(self, args, condition, what):
        self.judged += 1
        if not condition:
            self.fail(args, what)

    def judge(self, question, count, no_time):
        args = [question[0], "scene.json", *question[1:]]
        if question[0] == "separate":
            # Bodies stand as at the start, whatever they do later.
            count = {**count, "moving_alike": 0, "at_rest": 0}
        untested = count["ignored"] + count["moving_alike"] + count["at_rest"]
        nothing = untested == count["pairs"]
        code, text, errors = self.run(*args)
        if code == 2 and question[0] == "range" and "overlap at that instant" in errors:
            return
        head = "\n".join(text.splitlines()[:2])
        self.expect(args, (code == 2) == nothing and errors == "", f"exit code {code}, {errors}")
        self.expect(args, text.startswith("UNTESTED") == nothing, head)
        self.expect(args, ("NOT TESTED" in head) == (untested > 0 and not nothing), head)
        self.expect(args, not (nothing and any(map(CLAIMS.match, text.splitlines()))), text)
        if nothing:
            self.expect(args, self.run(*args, "--allow-untested")[0] == 0, "--allow-untested")
        self.judge_json(args, count, nothing)
        if no_time:
            self.judge_stopped(args, count, nothing)
        if question[0] == "prove":
            self.judge_proof(args, code, nothing, untested)

    def judge_json(self, args, count, nothing):
        answer = json.loads(self.run(*args, "--json")[1])
        coverage = answer["coverage"]
        self.expect(args, all(coverage[key] == count[key] for key in count), f"{coverage}, not {count}")
        self.expect(args, sum(coverage.values()) == 2 * coverage["pairs"], f"{coverage} does not add up")
        self.expect(args, (answer["outcome"] == "untested") == nothing, answer["outcome"])
        self.expect(args, not nothing or "nothing was tested" in answer.get("reason", ""), str(answer))

    def judge_stopped(self, args, count, nothing):
        """A limit that is reached at once: pairs are counted nevertheless, and none as tested."""
        if nothing:
            return
        stopped = [*args, "--max-seconds", "0"]
        code, text, _ = self.run(*stopped)
        # What boxes decide before the clock is looked at may be said.
        by_boxes = args[0] in ("intervals", "range") and code == 0
        self.expect(stopped, by_boxes or (code == 3 and text.startswith("UNDECIDED")), text)
        self.expect(stopped, by_boxes or "NOT TESTED" in "\n".join(text.splitlines()[:2]), text)
        coverage = json.loads(self.run(*stopped, "--json")[1])["coverage"]
        self.expect(stopped, all(coverage[key] == count[key] for key in ("pairs", "ignored")), f"{coverage}, not {count}")
        self.expect(stopped, sum(coverage.values()) == 2 * coverage["pairs"], f"{coverage} does not add up")
        self.expect(stopped, coverage["tested"] == 0 and by_boxes == (coverage["not_reached"] == 0), str(coverage))

    def judge_proof(self, args, code, nothing, untested):
        if nothing or code != 0:
            return
        code, text, _ = self.run("verify", "scene.json", "log", "--expect", "free")
        self.expect(args, code == 0, f"verify: {text}")
        self.expect(args, ("NOT TESTED" in "\n".join(text.splitlines()[:2])) == (untested > 0), f"verify: {text}")


def main():
    taut = os.path.abspath(sys.argv[1])
    scenes = int(sys.argv[2]) if len(sys.argv) > 2 else 40
    seen = {"nothing": 0, "some": 0, "all": 0}
    with tempfile.TemporaryDirectory() as folder:
        judge = Judge(taut, folder)
        for seed in range(scenes):
            scene, parents, motions = draw(random.Random(seed))
            with open(os.path.join(folder, "scene.json"), "w") as file:
                json.dump(scene, file)
            count = counted(scene, parents, motions)
            untested = sum(count.values()) - count["pairs"]
            seen["nothing" if untested == count["pairs"] else "some" if untested else "all"] += 1
            for question in QUESTIONS:
                judge.judge(question, count, seed % 4 == 0)
        if judge.failures == 0 and min(seen.values()) < scenes // 10:
            judge.fail([], f"too few of a kind: {seen}")
        print(f"{scenes} scenes, {judge.judged} laws, {judge.failures} failures; {seen}")
        return 1 if judge.failures else 0


sys.exit(main())

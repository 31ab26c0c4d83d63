#!/usr/bin/env python3
"""Logs about mechanisms, as the command writes them: the independent checker must find that they prove what it says.

usage: mechanism_logs_test.py TAUT REPOSITORY      with less effort: every twelfth scene, the examples and the corpus"""

import glob
import json
import os
import random
import subprocess
import sys
import tempfile

from balls import ONE, exact
from effort import effort
from linkage import Balls
from separations import check
from world import Scene


def wrong_derivatives(linkage):
    """Are the equations' derivatives, on which each proof of a cell rests, what differences say?"""
    rng, h = random.Random(1), ONE >> 60
    unknowns, drives = ([(exact(rng.uniform(-20, 20)), 0) for _ in range(n)]
                        for n in (linkage.unknowns, len(linkage.drives)))
    for turning in (False, True):
        rows = linkage.jacobian(Balls, unknowns, drives, turning)
        for j, (x, _) in enumerate(unknowns):
            low, high = (linkage.equations(Balls, [*unknowns[:j], (x + d, 0), *unknowns[j + 1:]], drives, turning)
                         for d in (-h, h))
            for row, a, b in zip(rows, low, high):
                if abs((b[0] - a[0]) / (2 * h) - row[j][0] / ONE) > 1e-12 * (1 + abs(row[j][0] / ONE)):
                    return True
    return False


def judged(taut, file, touch, folder):
    """Empty if all is well; None if there is no log."""
    log = os.path.join(folder, "log")
    done = subprocess.run([taut, "prove", file, "--touch", touch, "-o", log, "--json"], stdout=subprocess.PIPE,
                          stderr=subprocess.PIPE, text=True, check=False)
    if not os.path.exists(log):
        return None
    with open(log, "rb") as f:
        data = f.read()
    os.remove(log)
    said = json.loads(done.stdout)
    with open(file, encoding="utf-8") as f:
        scene = Scene(json.load(f))
    if scene.mechanism and wrong_derivatives(scene.mechanism.linkage):
        return "derivatives are not those of the equations"
    proved, reason, _ = check(scene, data, {})
    if not proved:
        return f"taut: {said['outcome']}; the checker: {reason}"
    if proved["outcome"] != said["outcome"]:
        return f"taut: {said['outcome']}; the checker: {proved['outcome']}"
    until = said.get("free_until", said["t"][0] if "t" in said else scene.end)
    if abs(proved["free_until"] - until) > 1e-12 * max(1, abs(until)):
        return f"free until {until} and {proved['free_until']}"
    return ""


def main():
    taut, root = sys.argv[1:3]
    sys.setrecursionlimit(10000)
    files, corpus, shared = ([f for f in sorted(glob.glob(f"{root}/{where}/*.json")) if not f.endswith(".answer.json")]
                             for where in ("examples/mechanisms", "tests/corpus/mechanisms", "../shared/mechanisms"))
    files += corpus
    if not shared:
        print("../shared/mechanisms is absent: only the examples are checked")
    files += shared[::1 if effort(4) == 4 else 12]
    findings = logs = 0
    with tempfile.TemporaryDirectory() as folder:
        for k, file in enumerate(files):
            name = os.path.basename(file)[:-5]
            finding = judged(taut, file, ("open", "closed")[k % 2], folder)
            logs += finding is not None
            findings += bool(finding)
            print(f"{name}: {'no log' if finding is None else finding or 'proved'}", flush=True)
    print(f"{logs} logs, {findings} findings")
    return 1 if findings or logs < 4 else 0


if __name__ == "__main__":
    sys.exit(main())

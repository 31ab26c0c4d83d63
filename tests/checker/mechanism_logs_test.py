#!/usr/bin/env python3
"""Logs about mechanisms, as the command writes them: the independent checker must find that they prove what it says.

usage: mechanism_logs_test.py TAUT REPOSITORY      with less effort: every twelfth scene, and the examples"""

import glob
import json
import os
import subprocess
import sys
import tempfile

from effort import effort
from separations import check
from world import Scene

# Scenes that the checker decides too slowly, and one whose cells end before a dead point at the scene's end.
LEFT_OUT = ("scissor_lift", "toggle_exact_0")


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
    files = sorted(glob.glob(f"{root}/examples/mechanisms/*.json"))
    shared = sorted(f for f in glob.glob(f"{root}/../shared/mechanisms/*.json") if not f.endswith(".answer.json"))
    if not shared:
        print("../shared/mechanisms is absent: only the examples are checked")
    files += shared[::1 if effort(4) == 4 else 12]
    findings = logs = 0
    with tempfile.TemporaryDirectory() as folder:
        for k, file in enumerate(files):
            name = os.path.basename(file)[:-5]
            if name in LEFT_OUT:
                continue
            finding = judged(taut, file, ("open", "closed")[k % 2], folder)
            logs += finding is not None
            findings += bool(finding)
            print(f"{name}: {'no log' if finding is None else finding or 'proved'}", flush=True)
    print(f"{logs} logs, {findings} findings")
    return 1 if findings or logs < 4 else 0


if __name__ == "__main__":
    sys.exit(main())

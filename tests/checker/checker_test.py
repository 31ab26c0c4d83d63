#!/usr/bin/env python3
"""taut's verifier and the independent checker must say the same of hundreds of logs and of thousands of damaged ones.

usage: checker_test.py PROGRAM REPOSITORY [LOGS]      PROGRAM is taut_checker_logs"""

import collections
import json
import os
import re
import struct
import subprocess
import sys
import time

from bodies import Plan, displaced, pieces_between, random_between, seed_of
from checker import check
from covered import NotCovered
from effort import effort


def difference(said, proved, reason):
    """Empty if the two agree."""
    if said["valid"] != (proved is not None):
        return f"taut: {said.get('reason', 'valid')}; the checker: {reason or 'valid'}"
    if not proved:
        return ""
    for key in ("outcome", "closed", "events"):
        if said[key] != proved[key]:
            return f"{key}: {said[key]} and {proved[key]}"
    if proved["outcome"] != "contact" or proved.get("at_start"):
        return ""
    lo, hi = said["t"]
    slack = 1e-15 * max(abs(lo), abs(hi))
    if not lo - slack <= proved["t"] <= hi + slack:
        return f"time: {said['t']} and {proved['t']}"
    for key in ("vertex", "edge", "joint"):
        if said[key] != proved[key]:
            return f"{key}: {said[key]} and {proved[key]}"
    return ""


def check_vectors(root):
    """The test vectors of the specification that no command prints: displaced vertices, and what is hashed."""
    with open(f"{root}/docs/proof-format.md", encoding="utf-8") as page:
        text = page.read()
    plan = Plan(json.loads(re.search(r"file: pair.json -->\n```text\n(.*?)```", text, re.S).group(1)))
    assert "".join(re.findall(r"^`([0-9a-f]{40,})`", text, re.M)) == (b"taut scene 3\0" + plan.hashed).hex()
    assert plan.fingerprint(0).hex() in text
    rows = re.findall(r"^\| ([PQ]) \| (\d) \| .* \| (\w+)wards \| `(\w+)` \| `(\w+)` \|$", text, re.M)
    assert len(rows) == 8
    for body, vertex, side, *bits in rows:
        side_of = "PQ".index(body)
        ring, seed = plan.rings[side_of], seed_of(plan.order[side_of], 0)
        _, d = displaced(ring, side == "in", seed)[int(vertex)]
        assert [struct.pack(">d", x).hex() for x in d] == bits, (body, vertex, side)
    ring = [(0.0, 0.0), (0.25, 0.0), (0.5, 0.0), (0.0, 0.375)]
    numbers = [random_between(0, 0.0, 1.0), random_between(1, 0.0, 1.0), *displaced(ring, True, seed_of(0, 0))[1][1]]
    assert [struct.pack(">d", x).hex() for x in numbers] == re.findall(r"(?:bits|has|dx|dy) `([0-9a-f]{16})`", text)


def check_what_is_not_covered(root):
    checker = os.path.join(os.path.dirname(os.path.abspath(__file__)), "checker.py")
    asked = [sys.executable, checker, f"{root}/examples/rotor.json", os.devnull]
    assert subprocess.run(asked, stdout=subprocess.DEVNULL).returncode == 3


def check_keyframes():
    """What turns is not covered, also where it is written in degrees."""
    keys = [{"t": 0, "x": 0, "y": 0}, {"t": 1, "x": 0.1, "y": 2}, {"t": 2, "x": 1, "y": 2}]
    pieces = [(p.x, p.y, p.origin, p.until) for p in pieces_between({"keyframes": keys}, 0, 2.5)]
    assert pieces == [([0, 0.1], [0, 2], 0, 1), ([0.1, 0.9], [2], 1, 2), ([1], [2], 0, float("inf"))], pieces
    for angle in (90, 10):
        try:
            pieces_between({"keyframes": [{"t": 0, "angle_deg": angle}]}, 0, 1)
        except NotCovered:
            continue
        raise AssertionError("a body that is turned is taken for one that is not")


def main():
    program, root, logs = sys.argv[1], sys.argv[2], sys.argv[3] if len(sys.argv) > 3 else str(effort(400))
    check_vectors(root)
    check_what_is_not_covered(root)
    check_keyframes()
    lines = subprocess.run([program, root, logs], stdout=subprocess.PIPE, check=True, text=True).stdout.splitlines()
    began, counts, bad, plan, text = time.process_time(), collections.Counter(), 0, None, ""
    for line in lines:
        said = json.loads(line)
        if "scene" in said:
            plan, text = Plan(said["scene"]), line
            continue
        proved, reason = check(plan, bytes.fromhex(said["log"]))
        kind = said["damage"] or "valid logs"
        counts[kind, "accepted" if proved else "refused"] += 1
        outcome = difference(said, proved, reason)
        if outcome:
            bad += 1
            print(f"{kind}: {outcome}\n  {text[:2000]}\n  {said['log'][-400:]}")
    for key, count in sorted(counts.items()):
        print(*key, count)
    valid = counts["valid logs", "accepted"]
    print(f"{sum(counts.values())} logs, {valid} of them valid as written, {bad} differences, "
          f"{time.process_time() - began:.1f} s")
    return 1 if bad or valid < int(logs) else 0


if __name__ == "__main__":
    sys.exit(main())

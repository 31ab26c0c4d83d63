#!/usr/bin/env python3
"""taut's verifier and the independent checker of separations must say the same of hundreds of logs and of thousands of
damaged ones. Where one of them cannot decide, the other may.

usage: separations_test.py PROGRAM REPOSITORY [LOGS]      PROGRAM is taut_checker_separations"""

import collections
import json
import subprocess
import sys
import time

from covered import NotCovered
from effort import effort
from separations import check
from world import Scene

# What a verifier says that knows no better, but does not know the contrary: its bounds are coarser.
MAY_BE = ("is not known", "cannot be decided", "not separated", "does not stay within its box", "does not stay off",
          "not within its stretch of time", "does not keep the clearance", "do not keep the clearance",
          "are not shown to", "do not cover the time")


def difference(said, proved):
    """Empty if two verdicts on a log that both accept agree."""
    for key in ("outcome", "closed", "separations"):
        if said[key] != proved[key]:
            return f"{key}: {said[key]} and {proved[key]}"
    if abs(said["free_until"] - proved["free_until"]) > 1e-12 * max(1, abs(said["free_until"])):
        return f"free until: {said['free_until']} and {proved['free_until']}"
    if "edge" in said:
        lo, hi = said["t"]
        slack = 1e-15 * max(abs(lo), abs(hi))
        if not lo - slack <= proved["t"] <= hi + slack:
            return f"time: {said['t']} and {proved['t']}"
    for key in ("vertex", "edge"):
        if key in said and said[key] != proved.get(key):
            return f"{key}: {said[key]} and {proved.get(key)}"
    return ""


class Tally:
    def __init__(self):
        self.counts, self.findings, self.open, self.not_covered = collections.Counter(), 0, [], 0

    def judge(self, said, verdict, text):
        proved, reason, decided = verdict
        kind = said["damage"] or "valid logs"
        self.counts[kind, "accepted" if proved else "refused" if decided else "undecided"] += 1
        finding = ""
        if said["valid"] and proved:
            finding = difference(said, proved)
        elif said["valid"] and decided:
            finding = f"taut accepts it; the checker: {reason}"
        elif proved:
            if any(words in said["reason"] for words in MAY_BE):
                self.counts["only the checker accepts", said["reason"].split(": ")[-1]] += 1
            else:
                finding = f"the checker accepts it; taut: {said['reason']}"
        elif said["valid"]:
            self.open.append(f"{kind}: {reason}")
        if finding:
            self.findings += 1
            print(f"{kind}: {finding}\n  {text[:3000]}\n  {said['log']}")


def main():
    program, root, logs = sys.argv[1], sys.argv[2], sys.argv[3] if len(sys.argv) > 3 else str(effort(250))
    sys.setrecursionlimit(10000)
    lines = subprocess.run([program, root, logs], stdout=subprocess.PIPE, check=True, text=True).stdout.splitlines()
    began, tally, scene, known, text = time.process_time(), Tally(), None, {}, ""
    for line in lines:
        said = json.loads(line)
        if "scene" in said:
            text, known = line, {}
            try:
                scene = Scene(said["scene"])
            except NotCovered:
                scene, tally.not_covered = None, tally.not_covered + 1
        elif scene:
            tally.judge(said, check(scene, bytes.fromhex(said["log"]), known), text)
    for key, count in sorted(tally.counts.items()):
        print(*key, count)
    for reason, count in collections.Counter(tally.open).most_common(12):
        print(f"accepted by taut, and not decided here, {count} times: {reason}")
    valid = tally.counts["valid logs", "accepted"]
    print(f"{sum(tally.counts.values())} logs, {valid} of them valid as written, {tally.findings} differences, "
          f"{len(tally.open)} not decided, {tally.not_covered} scenes not covered, {time.process_time() - began:.1f} s")
    return 1 if tally.findings or 10 * valid < 8 * int(logs) else 0


if __name__ == "__main__":
    sys.exit(main())

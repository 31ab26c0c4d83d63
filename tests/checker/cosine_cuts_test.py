#!/usr/bin/env python3
"""Where rotations given by their cosines are cut: what docs/proof-format.md says, written anew, against taut.

usage: cosine_cuts_test.py PROGRAM [COUNT]      PROGRAM is taut_cosine_cuts"""

import collections
import json
import subprocess
import sys

from cosines import pieces
from effort import effort


def main():
    count = sys.argv[2] if len(sys.argv) > 2 else str(effort(2000))
    lines = subprocess.run([sys.argv[1], count], stdout=subprocess.PIPE, check=True, text=True).stdout.splitlines()
    kinds, bad = collections.Counter(), 0
    for line in lines:
        said = json.loads(line)
        expected = pieces([float(x) for x in said["cosine"]], float(said["origin"]), float(said["from"]), float(said["to"]))
        kinds[min(len(expected), 5), any(name != "cosine" for _, name in expected)] += 1
        if expected != said["pieces"]:
            bad += 1
            print(f"differs: {line}\n  expected {expected}")
    print(f"{len(lines)} cosines, {bad} differences; pieces (5: or more), at rest: {sorted(kinds.items())}")
    # Cosines without cuts, with some, and with stretches at rest were all among them.
    return 1 if bad or len(lines) != int(count) or len(kinds) < 6 else 0


if __name__ == "__main__":
    sys.exit(main())

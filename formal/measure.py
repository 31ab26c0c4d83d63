#!/usr/bin/env python3
"""How long taut-verified takes for exact logs, and taut-verify for logs of separations about the same scenes: processor time
of whole processes, medians, as a table.

usage: measure.py REPOSITORY SCENE...     besides the scenes, of a world of 100 and of 300 bodies that turn and move apart"""

import json
import math
import resource
import statistics
import subprocess
import sys
import tempfile
from pathlib import Path

repository = Path(sys.argv[1]).resolve()
folder = Path(tempfile.mkdtemp(prefix="taut-formal-"))
build = repository / "build/release"


def world(count):
    bodies, columns = [], math.isqrt(count) + 1
    for i in range(count):
        x, y = i % columns * 3 - 1.5 * columns, i // columns * 3 - 1.5 * columns
        motion = {"x": [x, x / 2], "y": [y, y / 2], "rotation": {"angle": [0.1 * i, 0.7 + 0.01 * i]}}
        bodies.append({"name": f"b{i}", "polygon": [[-1, -1], [1, -1], [1.1, 0.2], [1, 1], [-1, 1]], "motion": motion})
    file = folder / f"world_of_{count}.json"
    file.write_text(json.dumps({"format": "taut-scene/1", "time": [0, 1], "bodies": bodies}))
    return file


def seconds(*command):
    times = []
    for _ in range(9):
        before = resource.getrusage(resource.RUSAGE_CHILDREN)
        subprocess.run(command, check=True, capture_output=True)
        after = resource.getrusage(resource.RUSAGE_CHILDREN)
        times.append(after.ru_utime - before.ru_utime + after.ru_stime - before.ru_stime)
    return statistics.median(times)


print("| scene | log | lines | `taut-verified` | `taut-verify`, of a log of separations | ratio |\n|---|---|---|---|---|---|")
for scene in [*map(Path, sys.argv[2:]), world(100), world(300)]:
    exact, separations = folder / "exact.log", folder / "separations.log"
    subprocess.run([build / "taut", "prove", "--exact", scene, "-o", exact], capture_output=True)
    subprocess.run([build / "taut", "prove", "--touch", "closed", "--engine", "spacetime", scene, "-o", separations], capture_output=True)
    lines = sum(isinstance(step, list) for pair in json.loads(exact.read_text())["pairs"] for w in pair["windows"] for step in w)
    proved = seconds(repository / "formal/build/taut-verified", scene, exact)
    other = seconds(build / "taut-verify", scene, separations)
    print(f"| `{scene.name}` | {exact.stat().st_size / 1000:.0f} kB | {lines:,} | {1000 * proved:.1f} ms | {1000 * other:.1f} ms | "
          f"{proved / other:.1f} |", flush=True)

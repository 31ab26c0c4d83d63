#!/usr/bin/env python3
"""Long questions say on a terminal how far they are, and nowhere else. usage: progress_test.py TAUT"""
import os
import pty
import re
import select
import subprocess
import sys
import tempfile
import time
from pathlib import Path

taut = os.path.abspath(sys.argv[1])
root = Path(__file__).resolve().parent.parent


def on_terminal(words, seconds, folder, wanted=None):
    """What standard error, a terminal, gets within so much time; or, if something is wanted, until it is there, and a
    line says how much time has passed. The process is stopped then."""
    ours, theirs = pty.openpty()
    with subprocess.Popen([taut, *words], stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL, stderr=theirs, cwd=folder) as process:
        os.close(theirs)
        text, end = b"", time.monotonic() + seconds
        while time.monotonic() < end:
            ready, _, _ = select.select([ours], [], [], 0.1)
            if ready:
                try:
                    more = os.read(ours, 65536)
                except OSError:  # the other side is closed
                    break
                text += more
            if wanted and re.search(wanted, text.decode(errors="replace")) and re.search(rb"[1-9] s(, about [^\x1b]* left)?\x1b\[K", text):
                break
        process.kill()
    os.close(ours)
    return text.decode()


def piped(words, folder):
    with subprocess.Popen([taut, *words], stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, cwd=folder) as process:
        time.sleep(1.7)
        process.kill()
        return process.stderr.read().decode()


def run(words, folder):
    subprocess.run([taut, *words], check=True, cwd=folder, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)


def world(folder, bodies, name):
    """Discs of many vertices that fly through each other's boxes for long, and never meet."""
    import json
    import math
    ring = [[math.cos(2 * math.pi * k / 240) * (1 + 0.3 * (k % 2)), math.sin(2 * math.pi * k / 240) * (1 + 0.3 * (k % 2))]
            for k in range(240)]
    side = math.ceil(math.sqrt(bodies))
    all_bodies = []
    for i in range(bodies):
        x, y = 2.63 * (i % side), 2.63 * (i // side)
        all_bodies.append({"name": f"b{i}", "polygon": [[x + p, y + q] for p, q in ring],
                           "motion": {"velocity": [0, 0], "spin_deg": 30 + i, "pivot": [x, y]}})
    (folder / name).write_text(json.dumps({"format": "taut-scene/1", "time": [0, 300], "bodies": all_bodies}))


def drawing(folder):
    """400,000 lines."""
    with open(folder / "big.dxf", "w") as out:
        out.write("0\nSECTION\n2\nENTITIES\n")
        for i in range(100000):
            x, y = 3 * (i % 300), 3 * (i // 300)
            corners = [(x, y), (x + 2, y), (x + 2, y + 2), (x, y + 2)]
            for (ax, ay), (bx, by) in zip(corners, corners[1:] + corners[:1]):
                out.write(f"0\nLINE\n8\n0\n10\n{ax}\n20\n{ay}\n11\n{bx}\n21\n{by}\n")
        out.write("0\nENDSEC\n0\nEOF\n")


with tempfile.TemporaryDirectory() as name:
    folder = Path(name)
    world(folder, 144, "world.json")
    drawing(folder)
    (folder / "lines.jsonl").write_text((root / "examples/lid.json").read_text().replace("\n", " ") + "\n")
    with open(folder / "lines.jsonl") as line, open(folder / "many.jsonl", "w") as out:
        out.write(line.read() * 200000)
    # What is asked, and what the line says of it.
    questions = [
        (["check", "world.json"], r"% +\[=* *\] .* pairs"),
        (["check", "--json", "--lines", "many.jsonl"], r"% +\[=* *\]  [\d,]+ scenes, \d+ s, about \d+ (s|min) left"),
        (["check", "--json", "--lines", "many.jsonl", "--resume", "answers.jsonl"], r"[\d,]+ scenes, \d+ s, about"),
        (["clearance", "world.json", "--pairs", "all"], r"[\d,]+ pairs"),
        (["intervals", "world.json"], r"[\d,]+ of [\d,]+ pairs"),
        (["check", "--clearance", "0.01", "world.json"], r"[\d,]+ of [\d,]+ pairs"),
        (["separate", "world.json"], r"[\d,]+ of 144 bodies"),
        (["envelope", str(root / "examples/linkages/loader.json"), "--tolerance", "1e-6"], r"% +\[=* *\] .* cells"),
        (["prove", "world.json", "-o", "world.proof"], r"% +\[=* *\] .* pairs"),
        (["import", "big.dxf", "-o", "out.json"], r"points of lines|entities"),
    ]
    for words, wanted in questions:
        said = on_terminal(words, 30, folder, wanted)
        assert re.search(wanted, said), f"{words}: {said[-400:]!r}"
        assert re.search(r"\r[^\r\n]*\d+ s(, about [^\x1b]* left)?\x1b\[K", said), f"{words}: {said[-400:]!r}"
        said = piped(words, folder)
        assert "\r" not in said and "\x1b" not in said, f"{words}: {said[-400:]!r}"
    # Short ones say nothing, and a line that was shown is wiped.
    said = on_terminal(["check", str(root / "examples/lid.json")], 5, folder)
    assert said == "", repr(said)
    said = on_terminal(["intervals", "world.json", "--max-seconds", "1.5"], 10, folder)
    assert said.endswith("\r\x1b[K"), repr(said[-100:])
print(f"all well: {len(questions)} long questions, on a terminal and not")

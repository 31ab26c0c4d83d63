#!/usr/bin/env python3
"""taut-verified on real and random scenes: it reads them as taut does, accepts the logs that taut writes, and of damaged
logs only those that still claim what is true.

usage: test.py REPOSITORY [COUNT]     with COUNT random scenes (400), and ten damaged logs for each, up to 10,000"""

import collections
import copy
import json
import random
import subprocess
import sys
import tempfile
import time
from pathlib import Path

import sampling
from damaged import damage

repository = Path(sys.argv[1]).resolve()
count = int(sys.argv[2]) if len(sys.argv) > 2 else 400
taut = repository / "build/release/taut"
exact_logs = repository / "build/release/tests/taut_exact_logs"
taut_verify = repository / "build/release/taut-verify"
verified = repository / "formal/build/taut-verified"
folder = Path(tempfile.mkdtemp(prefix="taut-formal-"))
accepted, rejected, malformed, not_covered = 0, 1, 2, 3
failures = []
most_damaged = 10_000


def fail(what):
    failures.append(what)
    print("FAILED:", what)


def verify(scene, log):
    """The exit code: scene is a path or JSON, log is JSON or text."""
    if not isinstance(scene, Path):
        (folder / "scene.json").write_text(json.dumps(scene))
        scene = folder / "scene.json"
    (folder / "log").write_text(log if isinstance(log, str) else json.dumps(log))
    done = subprocess.run([verified, scene, folder / "log"], capture_output=True, text=True)
    if done.returncode not in (accepted, rejected, malformed, not_covered):
        fail(f"exit code {done.returncode}: {done.stderr}")
    return done.returncode


def listed_scenes():
    files = []
    for where in ("../shared/scenes", "../shared/worlds", "examples", "examples/worlds", "tests/corpus", "tests/corpus/worlds"):
        files += sorted((repository / where).glob("*.json"))
    for file in files:
        if file.name.endswith("answer.json"):
            continue
        try:
            value = json.loads(file.read_text())
        except ValueError:
            continue
        if isinstance(value, dict) and "bodies" in value:
            yield file


# What taut read, as print_scene.ml has it.

def plain_piece(piece, last):
    rotation = piece.get("rotation")
    turns = bool(rotation) or "orbit" in piece
    plain = {"x": piece.get("x", []), "y": piece.get("y", []), "rotation": rotation, "origin": piece.get("origin", 0),
             "pivot": piece.get("pivot", [0, 0]) if turns else [0, 0]}
    if "orbit" in piece:
        plain["orbit"] = piece["orbit"]
    if not last:
        plain["until"] = piece["until"]
    return plain


def plain_motion(motion):
    if motion is None:
        return []
    pieces = motion if isinstance(motion, list) else [motion]
    return [plain_piece(p, p is pieces[-1]) for p in pieces]


def rests(motion):
    return all(not p["x"] and not p["y"] and not p["rotation"] and "orbit" not in p for p in motion)


def parts_of(body):
    everywhere = body.get("z", [None, None])
    parts = []
    for part in body["parts"] if "parts" in body else [body["polygon"]]:
        if isinstance(part, list):
            part = {"outline": part}
        lo, hi = part.get("z", everywhere)
        parts.append(([part["outline"], *part.get("holes", [])],
                      (float("-inf") if lo is None else lo, float("inf") if hi is None else hi)))
    return parts


def sections_of(body):
    """Distinct sets of parts, from the lowest height up: at each height between two ends of layers."""
    parts = parts_of(body)
    ends = sorted({end for _, z in parts for end in z})
    found = []
    for a, b in zip(ends, ends[1:]):
        inside = [k for k, (_, (lo, hi)) in enumerate(parts) if lo <= a and b <= hi]
        if not found or found[-1] != inside:
            found.append(inside)
    return [[parts[k][0] for k in inside] for inside in found if inside]


def as_read_by_taut(scene):
    bodies = {b["name"]: b for b in scene["bodies"]}
    lowest, others = [], []
    for body in scene["bodies"]:
        chain, at = [], body
        while True:
            motion = plain_motion(at.get("motion"))
            if not rests(motion):
                chain.insert(0, motion)
            if "relative_to" not in at:
                break
            at = bodies[at["relative_to"]]
        for k, section in enumerate(sections_of(body)):
            (others if k else lowest).append({"name": body["name"], "chain": chain, "parts": section})
    return {"time": scene["time"], "bodies": lowest + others}


def test_reading():
    files = list(listed_scenes())
    lines = subprocess.run([exact_logs, "read", *files], capture_output=True, text=True, check=True).stdout.splitlines()
    same = refused = 0
    for line in map(json.loads, lines):
        done = subprocess.run([verified, "--print", line["file"]], capture_output=True, text=True)
        if done.returncode == not_covered:
            refused += 1
            continue
        if done.returncode:
            fail(f"{line['file']}: {done.stderr}")
            continue
        read = json.loads(done.stdout)
        for key, value in as_read_by_taut(line["scene"]).items():
            if read[key] != value:
                fail(f"{line['file']}: {key} read as {str(read[key])[:300]}, by taut as {str(value)[:300]}")
                break
        else:
            same += 1
    print(f"reading: {same} scenes as taut reads them, {refused} not covered")


def places_in(value, found):
    """All members and elements, as their owner and key."""
    for key, inner in list(value.items()) if isinstance(value, dict) else list(enumerate(value)) if isinstance(value, list) else []:
        found.append((value, key))
        places_in(inner, found)
    return found


def changed_scene(rng, scene):
    scene = copy.deepcopy(scene)
    for _ in range(rng.choice([1, 1, 2])):
        owner, key = rng.choice(places_in(scene, []))
        value, kind = owner[key], rng.randrange(6)
        if kind == 0:
            del owner[key]
        elif kind == 1 and isinstance(owner, list):
            owner.insert(key, copy.deepcopy(value))
        elif isinstance(value, (int, float)) and not isinstance(value, bool):
            owner[key] = rng.choice([-value, value + 1, value / 3, value * 2.0 ** rng.randrange(-60, 60), 0, -0.0, 90, 360])
        elif isinstance(value, str):
            owner[key] = rng.choice(["*", "test", "skip", "b0", "b1", "P", "Q", ""])
        else:
            other_owner, other = rng.choice(places_in(scene, []))
            owner[key] = copy.deepcopy(other_owner[other])
    return scene


def test_reading_of_changed_scenes():
    rng, files = random.Random(2), []
    for number, file in enumerate(listed_scenes()):
        for k in range(max(1, min(20, count // 100))):
            changed = folder / f"changed_{number}_{k}.json"
            changed.write_text(json.dumps(changed_scene(rng, json.loads(file.read_text()))))
            files.append(changed)
    by_taut = {}
    for first in range(0, len(files), 1000):
        read = subprocess.run([exact_logs, "read", *files[first:first + 1000]], capture_output=True, text=True, check=True)
        by_taut.update((line["file"], line["scene"]) for line in map(json.loads, read.stdout.splitlines()))
    tally = collections.Counter()
    for file in files:
        done = subprocess.run([verified, "--print", file], capture_output=True, text=True)
        scene = by_taut.get(str(file))
        tally[done.returncode == accepted, scene is not None] += 1
        if done.returncode not in (accepted, malformed, not_covered):
            fail(f"exit code {done.returncode} for {file.read_text()[:1000]}: {done.stderr}")
        if done.returncode or scene is None:
            continue
        read = json.loads(done.stdout)
        for key, value in as_read_by_taut(scene).items():
            if read[key] != value:
                fail(f"{file.read_text()[:1000]}: {key} read as {str(read[key])[:300]}, by taut as {str(value)[:300]}")
                break
        file.unlink()
    print(f"reading of changed scenes: {tally[True, True]} alike, {tally[False, False]} refused by both, "
          f"{tally[True, False]} by taut alone, {tally[False, True]} by the checker alone")


def test_listed():
    tally, seconds = collections.Counter(), [0, 0]
    for file in listed_scenes():
        log = folder / "exact.log"
        log.unlink(missing_ok=True)
        begin = time.time()
        done = subprocess.run([taut, "prove", "--exact", file, "-o", log, "--json", "--max-seconds", "20"],
                              capture_output=True, text=True)
        seconds[0] += time.time() - begin
        if not log.exists():
            outcome = json.loads(done.stdout)["outcome"] if done.stdout else done.stderr.splitlines()[0].split("do not ")[-1]
            tally["no log: " + outcome] += 1
            continue
        begin = time.time()
        code = subprocess.run([verified, file, log], capture_output=True, text=True).returncode
        seconds[1] += time.time() - begin
        tally[f"log, {json.loads(done.stdout)['outcome']}: {['accepted', 'REJECTED', 'MALFORMED', 'not covered'][code]}"] += 1
        if code not in (accepted, not_covered):
            fail(f"{file}: its log is not accepted")
    for what, number in sorted(tally.items()):
        print(f"listed scenes: {number} {what}")
    print(f"listed scenes: {seconds[0]:.1f} s for writing logs, {seconds[1]:.1f} s for checking them")


def agreed(scene, until):
    """What taut-verify says of a log of separations: whether the scene is free up to a time, touching included."""
    file, log = folder / "agreed.json", folder / "agreed.log"
    file.write_text(json.dumps(scene))
    log.unlink(missing_ok=True)
    subprocess.run([taut, "prove", file, "-o", log, "--touch", "closed", "--engine", "spacetime", "--max-seconds", "20"],
                   capture_output=True)
    if not log.exists():
        return False
    done = subprocess.run([taut_verify, file, log, "--expect", "free", "--touch", "closed", "--until", repr(until)],
                          capture_output=True)
    return done.returncode == 0


def judge_accepted(rng, what, bad, given, agreements):
    """A damaged log that was accepted claims that the scene is free up to its end: so must say the engines, taut-verify of
    a log of another kind, and the scene itself at some instants."""
    scene, until = given["scene"], bad["until"]
    told = f"accepted: {what}: {json.dumps(bad)[:1000]} about {json.dumps(scene)[:1000]}"
    if what == "pair left out" or (given["known"] != "free" and until > given["until"]):
        fail(told)
    if until not in agreements:
        agreements[until] = agreed(scene, until)
        if not agreements[until]:
            fail("taut-verify does not agree: " + told)
    begin = scene["time"][0]
    for t in [begin, until, *(rng.uniform(begin, until) for _ in range(8))]:
        overlapping = sampling.overlapping_pair(scene, t)
        if overlapping:
            fail(f"{overlapping} overlap at {t}, {told}")


def test_damaged(rng, given, damaged):
    """Ten damaged logs of a scene."""
    agreements = {}
    for _ in range(10):
        what, bad = damage(rng, given["log"])
        code = verify(given["scene"], bad)
        damaged[what, code == accepted] += 1
        if code == accepted:
            judge_accepted(rng, what, bad, given, agreements)


def test_random():
    rng = random.Random(1)
    tally, damaged, before = collections.Counter(), collections.Counter(), None
    made = subprocess.Popen([exact_logs, "random", str(count)], stdout=subprocess.PIPE, text=True)
    for line in made.stdout:
        given = json.loads(line)
        scene, log = given["scene"], given["log"]
        if log is None:
            tally["no log: " + given["outcome"]] += 1
            continue
        code = verify(scene, log)
        tally[["accepted", "REJECTED", "MALFORMED", "not covered"][code] + ", " + given["known"]] += 1
        if code != accepted:
            fail(f"the log of a random scene has exit code {code}: {json.dumps(scene)[:2000]}")
            continue
        if not any("z" in str(b.keys()) for b in scene["bodies"]) and '"z"' not in line and len(log["pairs"]) < given["pairs"]:
            fail(f"{len(log['pairs'])} pairs are proved, and taut tests {given['pairs']}")
        if sum(damaged.values()) < most_damaged:
            test_damaged(rng, given, damaged)
        if before and verify(scene, before) == accepted:
            tally["accepted: the log of the scene before"] += 1
        text = json.dumps(log)
        if verify(scene, text[: rng.randrange(len(text))]) != malformed:
            fail("a log that ends too early is not refused")
        before = log
    made.wait()
    if made.returncode:
        fail(f"{exact_logs.name}: exit code {made.returncode}")
    for what, number in sorted(tally.items()):
        print(f"random scenes: {number} {what}")
    for what in sorted({w for w, _ in damaged}):
        print(f"damaged logs: {what}: {damaged[what, False]} rejected, {damaged[what, True]} still proofs of what is true")
    true = sum(number for (_, proof), number in damaged.items() if proof)
    print(f"damaged logs: {sum(damaged.values()) - true} rejected, {true} accepted, of all of which taut-verify and samples say the same")


def test_touching():
    """Bodies that meet are never accepted, whatever the log says: here, what would do if they were apart."""
    square = [[0, 0], [1, 0], [1, 1], [0, 1]]
    moved = {"name": "b", "polygon": square, "motion": {"x": [1]}}
    scene = {"format": "taut-scene/1", "time": [0, 1], "at_rest": "test", "bodies": [{"name": "a", "polygon": square}, moved]}
    log = {"format": "taut-exact/1", "until": 1, "pairs": [{"pair": [0, 1], "windows": [[0, 1, [1, 0, 1]]]}]}
    if verify(scene, log) != rejected:
        fail("bodies that touch are accepted")
    for changed in ({"pairs": []}, {"until": -1}):
        if verify(scene, {**log, **changed}) != rejected:
            fail(f"accepted: a log with {changed}")
    moved["motion"]["x"] = [1 + 2.0 ** -40]
    log["pairs"][0]["windows"][0][2] = [1, 0, 1 + 2.0 ** -41]
    if verify(scene, log) != accepted:
        fail("bodies with room are not accepted")
    # One inside of the other: no edges meet.
    moved["polygon"], moved["motion"]["x"] = [[0.25, 0.25], [0.75, 0.25], [0.75, 0.75], [0.25, 0.75]], [0]
    def all_pairs():
        """Each edge of the outer square against the inner one as a whole."""
        normals = {0: [0, 1, 0.1], 1: [-1, 0, -0.9], 2: [0, -1, -0.9], 3: [1, 0, 0.1]}
        return [1, 1, normals[0], normals[1], 1, normals[2], normals[3]]
    log["pairs"][0]["windows"][0] = [0, 1, *all_pairs()]
    if verify(scene, log) != rejected:
        fail("a body inside of another one is accepted")
    # The same with a hole around it.
    scene["bodies"][0]["polygon"] = {"outline": [[-1, -1], [2, -1], [2, 2], [-1, 2]], "holes": [square]}
    outer = {0: [0, 1, -0.5], 1: [-1, 0, -1.5], 2: [0, -1, -1.5], 3: [1, 0, -0.5]}
    log["pairs"][0]["windows"][0] = [0, 1, 1, 1, 1, outer[0], outer[1], 1, outer[2], outer[3], *all_pairs()]
    if verify(scene, log) != accepted:
        fail("a body in a hole is not accepted")


test_touching()
test_reading()
test_reading_of_changed_scenes()
test_listed()
test_random()
if failures:
    sys.exit(f"{len(failures)} failures")
print("all as it should be")

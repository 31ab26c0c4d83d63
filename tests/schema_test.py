#!/usr/bin/python3
"""The JSON Schema of the scene format: every scene of the repository fits it, and what is broken does not.

usage: schema_test.py TAUT ROOT
"""

import copy
import glob
import json
import os
import subprocess
import sys

import jsonschema

taut, root = sys.argv[1], sys.argv[2]
failures = []


def fail(what):
    failures.append(what)
    print("FAILED:", what)


text = subprocess.run([taut, "schema"], check=True, capture_output=True, text=True).stdout
with open(os.path.join(root, "docs/taut-scene-1.schema.json")) as file:
    if file.read() != text:
        fail("`taut schema` does not print docs/taut-scene-1.schema.json")
schema = json.loads(text)
jsonschema.Draft7Validator.check_schema(schema)
validator = jsonschema.Draft7Validator(schema)


def fits(scene):
    return validator.is_valid(scene)


def reads(scene):
    """Does the program read the scene? (What is wrong with its geometry has another message.)"""
    question = "check" if "time" in scene else "path" if "start" in scene else "envelope"
    run = subprocess.run([taut, question, "--allow-untested", "-"], input=json.dumps(scene), capture_output=True, text=True)
    return run.returncode in (0, 1, 3)


# Everything that is there.
paths = glob.glob(os.path.join(root, "examples", "**", "*.json"), recursive=True)
paths += [p for p in glob.glob(os.path.join(root, "tests", "**", "*.json"), recursive=True)
          if not p.endswith(".answer.json")]
scenes = [(os.path.relpath(path, root), json.load(open(path))) for path in sorted(paths)]
with open(os.path.join(root, "tests/determinism/scenes.txt")) as file:
    scenes += [("scenes.txt:%d" % (i + 1), json.loads(line)) for i, line in enumerate(file) if line[0] != "#"]
if len(scenes) < 50:
    fail("only %d scenes were found" % len(scenes))
for name, scene in scenes:
    for error in validator.iter_errors(scene):
        fail("%s: %s" % (name, error.message))

base = {"format": "taut-scene/1", "time": [0, 1], "bodies": [
    {"name": "P", "polygon": [[0, 0], [1, 0], [0, 1]]},
    {"name": "Q", "polygon": [[5, 0], [6, 0], [5, 1]], "motion": {"velocity": [1, 0]}}]}

good_motions = [
    None, {}, {"x": [1, 2]}, {"x": [], "rotation": None}, {"rotation": {"angle": [0, 1]}, "pivot": [1, 2]},
    {"rotation": {"direction": {"a": [1], "b": [0, 1]}}}, {"rotation": {"half_angle_tangent": [0, 1]}},
    {"rotation": {"cosine": [0.5]}}, [{"x": [1], "until": 0.5}, {"x": [1]}],
    {"keyframes": [{"t": 0}]}, {"keyframes": [{"t": 0, "x": 1, "y": 2, "angle_deg": 3}], "pivot": [0, 0]},
    {"velocity": [1, 2]}, {"spin_deg": 3}, {"velocity": [0, 0], "spin_deg": 3, "pivot": [1, 1]},
    {"sweep": {"from_deg": 0, "to_deg": 9}}, {"sweep": {"pivot": [1, 1], "from_deg": 0, "to_deg": 9}},
]
bad_motions = [
    0, "rest", [], True, {"z": [1]}, {"x": 1}, {"x": ["1"]}, {"x": [0] * 18}, {"rotation": {}}, {"rotation": 90},
    {"rotation": {"angle": [1], "cosine": [0]}}, {"rotation": {"angel": [1]}}, {"rotation": {"direction": {"a": [1]}}},
    {"until": "1"}, {"pivot": [1]}, {"pivot": 3}, {"keyframes": []}, {"keyframes": [{}]}, {"keyframes": [[0, 1]]},
    {"keyframes": [{"t": "0"}]}, {"keyframes": [{"t": 0, "angle": 1}]}, {"keyframes": [{"t": 0}], "x": [1]},
    {"velocity": [1]}, {"velocity": [1, 2, 3]}, {"velocity": [1, 2], "until": 1}, {"spin_deg": "9"},
    {"sweep": {"from_deg": 0}}, {"sweep": {"from": 0, "to_deg": 1}}, {"sweep": {"from_deg": 0, "to_deg": 9}, "pivot": [0, 0]},
    {"csv": 1}, {"csv": "a.csv", "velocity": [1, 1]}, [{"velocity": [1, 2]}],
]


def with_motion(motion):
    scene = copy.deepcopy(base)
    scene["bodies"][1]["motion"] = motion
    return scene


def changed(change):
    scene = copy.deepcopy(base)
    change(scene)
    return scene


good_joint_motions = [
    None, {"revolute": {"pivot": [0, 0], "by": "lift"}}, {"slide": {"direction": [1, 0], "by": "lift"}},
    {"revolute": {"pivot": [1, 0], "by": "lift", "times": -2, "plus": 10}},
]
bad_joint_motions = [
    {}, {"revolute": {"pivot": [0, 0]}}, {"revolute": {"by": "lift"}}, {"slide": {"pivot": [1, 0], "by": "lift"}},
    {"slide": {"direction": [1], "by": "lift"}}, {"slide": {"direction": [1, 0], "by": 1}}, {"velocity": [1, 0]},
    {"revolute": {"pivot": [0, 0], "by": "lift"}, "slide": {"direction": [1, 0], "by": "lift"}},
]


def with_joints(motion, joints={"lift": [0, 60]}):
    scene = with_motion(motion)
    del scene["time"]
    scene["joints"] = joints
    return scene


good = [(json.dumps(m), with_motion(m)) for m in good_motions]
good += [("joints: " + json.dumps(m), with_joints(m)) for m in good_joint_motions]
good += [
    ("$schema", changed(lambda s: s.update({"$schema": "x"}))),
    ("one body", changed(lambda s: s["bodies"].pop())),
    ("ignored", changed(lambda s: s.update({"ignore": [[s["bodies"][0]["name"], "*"]]}))),
    ("at rest", changed(lambda s: s.update({"at_rest": "test"}))),
    ("parts", changed(lambda s: s["bodies"][0].update({"parts": [s["bodies"][0].pop("polygon")]}))),
    ("holes", changed(lambda s: s["bodies"][0].update({"polygon": {"outline": s["bodies"][0]["polygon"], "holes": []}}))),
    ("parent", changed(lambda s: s["bodies"][0].update({"relative_to": s["bodies"][1]["name"]}))),
    ("around a centre", with_motion({"keyframes": [{"t": 0, "x": 1, "y": 2}, {"t": 1, "turn": {"center": [0, 0], "deg": 90}},
                                                   {"t": 2, "arc": {"center": [0, 0], "deg": -90}}]})),
]
bad = [(json.dumps(m), with_motion(m)) for m in bad_motions]
bad += [("joints: " + json.dumps(m), with_joints(m)) for m in bad_joint_motions]
bad += [("joints: " + json.dumps(j), with_joints(None, j)) for j in ({}, {"a": [1]}, {"a": 1}, [], None)]
bad += [("a joint's motion in time", with_motion(good_joint_motions[1]))]
bad += [("no " + key, changed(lambda s, key=key: s.pop(key))) for key in ("format", "time", "bodies")]
bad += [
    ("misspelt key", changed(lambda s: s.update({"tiem": [0, 1]}))),
    ("format 2", changed(lambda s: s.update({"format": "taut-scene/2"}))),
    ("time of one", changed(lambda s: s.update({"time": [0]}))),
    ("time of three", changed(lambda s: s.update({"time": [0, 1, 2]}))),
    ("no polygon", changed(lambda s: s["bodies"][0].pop("polygon"))),
    ("polygon and parts", changed(lambda s: s["bodies"][0].update({"parts": [s["bodies"][0]["polygon"]]}))),
    ("no parts", changed(lambda s: s["bodies"][0].update({"parts": s["bodies"][0].pop("polygon") and []}))),
    ("at rest, otherwise", changed(lambda s: s.update({"at_rest": "ask"}))),
    ("ignored one", changed(lambda s: s.update({"ignore": [["P"]]}))),
    ("parent without a name", changed(lambda s: s["bodies"][0].update({"relative_to": 1}))),
    ("no name", changed(lambda s: s["bodies"][0].pop("name"))),
    ("empty name", changed(lambda s: s["bodies"][0].update({"name": ""}))),
    ("line break in a name", changed(lambda s: s["bodies"][0].update({"name": "a\nb"}))),
    ("no polygon", changed(lambda s: s["bodies"][0].pop("polygon"))),
    ("two vertices", changed(lambda s: s["bodies"][0]["polygon"].pop())),
    ("vertex of three", changed(lambda s: s["bodies"][0]["polygon"][0].append(1))),
    ("flat polygon", changed(lambda s: s["bodies"][0].update({"polygon": [0, 0, 1, 0, 0, 1]}))),
    ("wkt and geojson", changed(lambda s: s["bodies"][0].update({"polygon": {"wkt": "a", "geojson": "b"}}))),
    ("unknown key of a body", changed(lambda s: s["bodies"][0].update({"colour": "red"}))),
]
# The schema and the reader agree.
for what, scene in good:
    if not fits(scene):
        fail("the schema refuses a good scene: " + what)
    if not reads(scene):
        fail("taut does not read a good scene: " + what)
for what, scene in bad:
    if fits(scene):
        fail("the schema accepts a bad scene: " + what)
    if reads(scene):
        fail("taut reads a bad scene: " + what)

print("%d scenes, %d good and %d bad ones made up" % (len(scenes), len(good), len(bad)))
sys.exit(1 if failures else 0)

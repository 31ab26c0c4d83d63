#!/usr/bin/env python3
"""Makes the pictures of the documentation again, and compares them byte by byte: pictures_test.py TAUT ROOT [--update]

Every SVG in docs/images is made by a command below, or is named with who makes it. --update writes them anew.
"""
import glob
import os
import subprocess
import sys
import tempfile

# Each picture and its command, whose last argument but the file is `-o` or `--svg`.
COMMANDS = {
    "arm_moving.svg": "draw examples/worlds/arm.json --animate --plain --width 600 -o",
    "arm_overlaps.svg": "intervals examples/worlds/arm.json --svg",
    "combs.svg": "draw examples/combs.json --at -0.9 -o",
    "crank_rocker_moving.svg": "draw examples/mechanisms/crank_rocker.json --animate --plain --width 500 -o",
    "excavator_moving.svg": "draw examples/mechanisms/excavator.json --animate --plain --width 600 -o",
    "jansen_moving.svg": "draw examples/mechanisms/jansen.json --animate --plain --width 400 -o",
    "scissor_lift_moving.svg": "draw examples/mechanisms/scissor_lift.json --animate --plain --width 300 -o",
    "billiards_moving.svg": "draw examples/worlds/billiards.json --animate --plain --width 480 -o",
    "conveyor_moving.svg": "draw examples/worlds/conveyor.json --animate --plain --width 700 -o",
    "drawer_moving.svg": "draw examples/worlds/drawer.json --animate --plain --width 400 -o",
    "gears_moving.svg": "draw examples/gears_thick_tooth.json --animate -o",
    "geneva_moving.svg": "draw examples/worlds/geneva.json --animate --plain --width 600 -o",
    "lid_moving.svg": "draw examples/lid.json --animate --width 400 -o",
    "loader_envelope.svg": "envelope examples/linkages/loader.json --svg",
    "paths/reach.svg": "path examples/paths/reach.json --map",
    "parking_distance.svg": "clearance examples/parking.json --profile 181 --svg",
    "parking_moving.svg": "draw examples/parking_clips.json --animate --width 600 -o",
    "paths/bracket_moving.svg": "path examples/paths/bracket.json --svg",
    "paths/excavator_moving.svg": "path examples/paths/excavator.json --svg",
    "planetary_moving.svg": "draw examples/worlds/planetary.json --animate --plain --width 500 -o",
    "puzzle_moving.svg": "draw examples/worlds/puzzle.json --animate --plain --width 400 -o",
    "room_moving.svg": "draw examples/worlds/room.json --animate --plain --width 500 -o",
    "questions/check.svg": "draw examples/gears_thick_tooth.json -o",
    "questions/clearance.svg": "clearance examples/gears.json --svg",
    "questions/margin.svg": "check --clearance 0.03 examples/gears.json --svg",
    "questions/range.svg": "range examples/lid.json --from 50 --svg",
    "questions/separate.svg": "separate examples/worlds/puzzle.json --svg",
    "questions/separate_turns.svg": "separate --turns examples/worlds/bent_bar.json --svg",
    "questions/swept.svg": "swept examples/mechanisms/crank_rocker.json --body coupler -o",
}
# Made by ./dev planners, which needs OMPL.
MADE_ELSEWHERE = {"planners_car.svg", "planners_rooms.svg"}


def made(taut, root, command):
    """The picture that the command writes. Outcomes are exit codes: only bad input and defects are failures."""
    with tempfile.TemporaryDirectory() as folder:
        path = os.path.join(folder, "picture.svg")
        run = subprocess.run([taut, *command.split(), path], cwd=root, stdout=subprocess.DEVNULL,
                             stderr=subprocess.PIPE, text=True)
        content = open(path, "rb").read() if os.path.exists(path) else b""
    if run.returncode not in (0, 1):
        raise SystemExit("taut %s: exit code %d\n%s" % (command, run.returncode, run.stderr))
    return content


def difference(old, new):
    """Where two pictures differ first."""
    before, after = old.decode().split("\n"), new.decode().split("\n")
    for number, (a, b) in enumerate(zip(before, after), 1):
        if a != b:
            return "line %d is\n  %s\nand is made as\n  %s" % (number, a[:160], b[:160])
    return "%d lines are made as %d" % (len(before), len(after))


def main(taut, root, update):
    folder = os.path.join(root, "docs/images")
    there = {os.path.relpath(path, folder) for path in glob.glob(folder + "/**/*.svg", recursive=True)}
    unknown = sorted(there - MADE_ELSEWHERE - set(COMMANDS))
    failures = ["docs/images/%s: name its command in tests/pictures_test.py" % name for name in unknown]
    for name, command in sorted(COMMANDS.items()):
        path, new = os.path.join(folder, name), made(taut, root, command)
        old = open(path, "rb").read() if os.path.exists(path) else b""
        if old == new:
            continue
        if update:
            with open(path, "wb") as file:
                file.write(new)
            print("written:", name)
        else:
            where = difference(old, new)
            failures.append("docs/images/%s is not what `taut %s FILE` makes: %s" % (name, command, where))
    for failure in failures:
        print(failure, file=sys.stderr)
    if failures:
        raise SystemExit("run tests/pictures_test.py TAUT . --update, and look at the pictures")
    print("%d pictures are as they are made" % len(COMMANDS))


if __name__ == "__main__":
    main(os.path.abspath(sys.argv[1]), os.path.abspath(sys.argv[2]), "--update" in sys.argv[3:])

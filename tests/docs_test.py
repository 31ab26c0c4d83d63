#!/usr/bin/python3
"""Runs the code blocks of README.md, examples/README.md and docs/, and compares what comes out with what they show.

usage: docs_test.py TAUT ROOT [--update] [FILE ...]

--update writes what the commands print into the files, in place of what they show. A block is one of these; blocks of
other kinds, and indented ones, are errors:

console  each line after "$ " is run by bash (taut, taut-verify and "./dev run" are there), in a folder that looks like the
         repository; its output must be the lines below, where measured times are masked and a line "..." stands for any
         lines
json     a scene, or a motion: must fit the schema and be decided
cpp      must be part of a program in examples/, which a test runs
cmake    configures a project with taut as a subdirectory
csv, text, python  written to a file if the line before is <!-- file: NAME -->; Python and what runs it are skipped where
         `./dev python` has not built the package

<!-- skip: REASON --> in the line before leaves a block out.
"""

import difflib
import glob
import json
import os
import re
import shutil
import subprocess
import sys
import tempfile

import jsonschema

FENCE = re.compile(r"^( *)```(\w*)$")
COMMENT = re.compile(r"^<!-- (file|skip): (.*) -->$")
# Measured times differ from run to run.
TIME = re.compile(r"\b\d+(\.\d+)?(e[+-]?\d+)? (us|ms|s)\b")


class Block:
    def __init__(self, kind, first_line, lines, notes):
        self.kind, self.first_line, self.lines, self.notes = kind, first_line, lines, notes

    def text(self):
        return "".join(line + "\n" for line in self.lines)


def blocks_of(lines):
    """The fenced blocks, with the comments directly before them; what is indented by four is code without a fence."""
    blocks, notes, i = [], {}, 0
    while i < len(lines):
        comment, fence = COMMENT.match(lines[i]), FENCE.match(lines[i])
        if comment:
            notes[comment.group(1)] = comment.group(2)
        elif fence:
            end = lines.index(fence.group(1) + "```", i + 1)
            body = [line[len(fence.group(1)):] for line in lines[i + 1:end]]
            blocks.append(Block(fence.group(2), i + 1, body, notes))
            notes, i = {}, end
        elif lines[i].startswith("    ") and i > 0 and lines[i - 1] == "" and not in_list(lines, i):
            blocks.append(Block("indented", i, [lines[i]], {}))
        elif lines[i]:
            notes = {}
        i += 1
    return blocks


def in_list(lines, i):
    while i > 0 and (lines[i] == "" or lines[i].startswith(" ")):
        i -= 1
    return bool(re.match(r"^([*-]|\d+\.) ", lines[i]))


def masked(text):
    return TIME.sub("TIME", text.rstrip())


def agrees(shown, printed):
    """Line by line; a line `...` stands for any lines."""
    pattern = "".join(".*" if line == "..." else re.escape(masked(line)) + "\n" for line in shown)
    return re.fullmatch(pattern, "".join(masked(line) + "\n" for line in printed), re.DOTALL) is not None


def console_parts(lines):
    """[command, [lines of its output]]; a command goes on in the next line after a backslash."""
    parts = []
    for line in lines:
        if line.startswith("$ "):
            parts.append([line[2:], []])
        elif parts and not parts[-1][1] and parts[-1][0].endswith("\\"):
            parts[-1][0] += "\n" + line
        elif parts:
            parts[-1][1].append(line)
        else:
            raise ValueError("a console block begins with a line `$ command`")
    return parts


class Runner:
    def __init__(self, taut, root, update):
        self.taut, self.root, self.update = taut, root, update
        self.package = os.path.join(root, "build/python/package")
        self.failures = 0
        self.counts = {}
        with open(os.path.join(root, "docs/taut-scene-1.schema.json")) as file:
            self.schema = jsonschema.Draft7Validator(json.load(file))
        paths = [p for folder in ("*.cpp", "*/*.cpp") for p in glob.glob(os.path.join(root, "examples", folder))]
        self.programs = {path: open(path).read() for path in paths}

    def file(self, path):
        """A document, in a folder of its own that looks like the repository's."""
        with tempfile.TemporaryDirectory() as self.folder, open(os.path.join(self.root, path)) as file:
            self.path, self.replaced = path, {}
            self.lines = file.read().split("\n")
            blocks = blocks_of(self.lines)
            if not self.python_works():
                blocks = self.without_python(blocks)
            self.set_up()
            for block in blocks:
                self.block(block)
        if self.update and self.replaced:
            for first in sorted(self.replaced, reverse=True):
                old, new = self.replaced[first]
                self.lines[first:first + old] = new
            with open(os.path.join(self.root, path), "w") as file:
                file.write("\n".join(self.lines))

    def python_works(self):
        """Has the package been built, and is there what the programs import?"""
        needed = subprocess.run(["/usr/bin/python3", "-c", "import matplotlib, numpy"], stderr=subprocess.DEVNULL)
        return needed.returncode == 0 and bool(glob.glob(self.package + "/taut2d/_taut2d*.so"))

    def without_python(self, blocks):
        """What can be run where the package is missing."""
        left = [block for block in blocks if block.kind != "python" and
                not (block.kind == "console" and any(line.startswith(("$ python3 ", "$ build/python/")) for line in block.lines))]
        if len(left) < len(blocks):
            print("skipped: %s: %d blocks, since the Python package, numpy or matplotlib is missing (./dev python test)" %
                  (self.path, len(blocks) - len(left)))
        return left

    def set_up(self):
        for name in ("examples", "docs", "include", "tests/checker"):
            shutil.copytree(os.path.join(self.root, name), os.path.join(self.folder, name))
        os.mkdir(os.path.join(self.folder, "bin"))
        os.makedirs(os.path.join(self.folder, "build/python/venv/bin"))
        os.symlink("/usr/bin/python3", os.path.join(self.folder, "build/python/venv/bin/python"))
        for name in ("taut", "taut-verify"):
            # A copy: the viewer's page that may have been built is not found from here.
            shutil.copy(os.path.join(os.path.dirname(self.taut), name), os.path.join(self.folder, "bin", name))
        # The one that the package is built for; another one may come first in the path.
        os.symlink("/usr/bin/python3", os.path.join(self.folder, "bin", "python3"))
        os.symlink(os.path.join(self.folder, "bin"), os.path.join(self.folder, "build/release"))
        # `./dev run` builds, then runs; the build has been done.
        dev = os.path.join(self.folder, "dev")
        with open(dev, "w") as file:
            file.write('#!/bin/sh\n[ "$1" = run ] || { echo "docs_test: skip this block" >&2; exit 99; }\n'
                       'shift\nexec build/release/taut "$@"\n')
        os.chmod(dev, 0o755)

    def fail(self, block, what):
        self.failures += 1
        print("FAILED: %s:%d: %s" % (self.path, block.first_line, what))

    def block(self, block):
        kind = "skip" if "skip" in block.notes else block.kind
        self.counts[kind] = self.counts.get(kind, 0) + 1
        check = {"skip": lambda b: None, "console": self.console, "json": self.json, "csv": self.store, "python": self.store,
                 "cpp": self.cpp,
                 "cmake": self.cmake, "text": self.text}.get(kind)
        if check is None:
            self.fail(block, "a block of the kind \"%s\" has no test: see CONTRIBUTING.md" % kind)
        else:
            check(block)

    def run(self, command):
        env = dict(os.environ, PATH=os.path.join(self.folder, "bin") + ":" + os.environ["PATH"], LC_ALL="C.UTF-8",
                   PYTHONPATH=self.package)
        return subprocess.run(["bash", "-c", command], cwd=self.folder, env=env, stdout=subprocess.PIPE,
                              stderr=subprocess.STDOUT, text=True, timeout=120, stdin=subprocess.DEVNULL)

    def console(self, block):
        shown_anew = []
        for command, shown in console_parts(block.lines):
            run = self.run(command)
            printed = run.stdout.rstrip("\n").split("\n") if run.stdout else []
            shown_anew += ["$ " + command] + (shown if agrees(shown, printed) else printed)
            if run.returncode in (4, 99, 126, 127) or run.returncode < 0:
                self.fail(block, "`%s` ends with exit code %d\n%s" % (command, run.returncode, run.stdout))
            elif not self.update and not agrees(shown, printed):
                difference = difflib.unified_diff(shown, printed, "shown", "printed", lineterm="")
                self.fail(block, "`%s` prints something else\n%s" % (command, "\n".join(difference)))
        if shown_anew != block.lines:
            self.replaced[block.first_line] = (len(block.lines), "\n".join(shown_anew).split("\n"))

    def store(self, block):
        name = block.notes.get("file")
        if name is None:
            self.fail(block, "say what the file is called: <!-- file: NAME --> before the block")
            return
        with open(os.path.join(self.folder, name), "w") as file:
            file.write(block.text())

    def text(self, block):
        if "file" in block.notes:
            self.store(block)

    def json(self, block):
        """A scene, or what stands behind "motion": ..., or behind "polygon": ... ."""
        try:
            value = json.loads(block.text())
        except ValueError as error:
            self.fail(block, "not JSON: %s" % error)
            return
        if "file" in block.notes:
            self.store(block)
        if isinstance(value, dict) and "outcome" in value:
            return  # an answer, shown by a console block
        scene = value
        if not (isinstance(value, dict) and "format" in value):
            scene = {"format": "taut-scene/1", "time": [0, 1], "bodies": [
                {"name": "P", "polygon": [[100, 0], [101, 0], [100, 1]]},
                {"name": "Q", "polygon": [[0, 0], [1, 0], [0, 1]], "motion": value}]}
        for error in self.schema.iter_errors(scene):
            self.fail(block, "not as the schema says: " + error.message)
        with open(os.path.join(self.folder, "block.json"), "w") as file:
            json.dump(scene, file)
        run = self.run("taut %s --allow-untested block.json" % ("path" if "start" in scene else "envelope" if "joints" in scene else "check"))
        if run.returncode not in (0, 1):
            self.fail(block, "taut does not decide it: " + run.stdout)

    def cpp(self, block):
        """Part of a program in examples/, which the build compiles and a test runs."""
        if not any(block.text() in text for text in self.programs.values()):
            self.fail(block, "these lines are not part of a program in examples/")

    def cmake(self, block):
        folder = os.path.join(self.folder, "consumer")
        os.mkdir(folder)
        os.symlink(self.root, os.path.join(folder, "taut"))
        shutil.copy(os.path.join(self.root, "examples/hello.cpp"), os.path.join(folder, "app.cpp"))
        with open(os.path.join(folder, "CMakeLists.txt"), "w") as file:
            file.write(block.text())
        run = self.run("cmake -S consumer -B consumer/build -DCMAKE_CXX_COMPILER=g++")
        if run.returncode != 0:
            self.fail(block, "cmake fails:\n" + run.stdout)
        shutil.rmtree(folder)


def main():
    arguments = sys.argv[1:]
    update = "--update" in arguments
    arguments = [a for a in arguments if a != "--update"]
    taut, root, files = os.path.realpath(arguments[0]), os.path.realpath(arguments[1]), arguments[2:]
    if not files:
        files = ["README.md", "examples/README.md"]
        files += sorted(os.path.relpath(p, root) for p in glob.glob(os.path.join(root, "docs", "*.md")))
    runner = Runner(taut, root, update)
    for path in files:
        runner.file(path)
    print(", ".join("%d %s" % (runner.counts[k], k) for k in sorted(runner.counts)))
    if not arguments[2:] and runner.counts.get("console", 0) < 10:
        print("FAILED: hardly any block was found")
        runner.failures += 1
    return 1 if runner.failures else 0


if __name__ == "__main__":
    sys.exit(main())

#!/usr/bin/env python3
"""A compiler launcher: what another build has compiled from the same text by the same command is copied, all else is
compiled. So a consumer of the sources is built whole, and what it builds is compiled once.

same_object.py BUILD COMPILER ARGUMENTS..."""
import json
import os
import pathlib
import shlex
import shutil
import sys

# What says where things are, each with one argument.
PLACES = ("-o", "-c", "-MF", "-MT")


def taken_apart(command):
    """The flags of a command, and the places it names."""
    flags, places = [], {}
    words = iter(command)
    for word in words:
        if word in PLACES:
            places[word] = next(words)
        elif word != "-MD":
            flags.append(word)
    return flags, places


def same_object(build, flags, source):
    text = pathlib.Path(source).read_bytes()
    for entry in json.loads((build / "compile_commands.json").read_text()):
        path = pathlib.Path(entry["file"])
        if path.name != pathlib.Path(source).name:
            continue
        theirs, places = taken_apart(shlex.split(entry["command"])[1:])
        made = pathlib.Path(entry["directory"]) / places["-o"]
        if theirs == flags and path.read_bytes() == text and made.is_file():
            return made
    return None


def main():
    build, command = pathlib.Path(sys.argv[1]), sys.argv[2:]
    flags, places = taken_apart(command[1:])
    made = same_object(build, flags, places["-c"]) if "-c" in places else None
    if made is None:
        os.execvp(command[0], command)
    shutil.copyfile(made, places["-o"])
    if "-MF" in places:
        pathlib.Path(places["-MF"]).write_text(f"{places['-o']}: {places['-c']}\n")


main()

"""The library's layers depend on those that CMakeLists.txt names, and on no others; nor does the verifier use an engine. No
headers include each other.

usage: layers_test.py PROJECT

Where each layer is a library of its own, the linker sees to that. Builds that compile the whole library as a few files
(cmake/layers.cmake) link whatever is called: here the headers that are included decide, but for the public ones, which have
types for all."""

import re
import sys
from pathlib import Path


# What the verifier derives by rules of its own: which pairs are tested, boxes around moving bodies, pieces of curves, how
# bodies follow joints.
own_rules = """
    scene/instance.hpp scene/free_cells.hpp scene/meeting_boxes.hpp scene/linkage.hpp
    geometry/band.hpp geometry/cell.hpp geometry/part_rings.hpp geometry/piece.hpp
""".split()


def layers_of(cmake):
    """The layers that each one names, and the order in which they are listed."""
    uses = {}
    for name, arguments in re.findall(r"^taut_layer\((\w+)([^)]*)\)", cmake, re.M):
        words = arguments.split()
        uses[name] = words[words.index("USES") + 1 :] if "USES" in words else []
    return uses


def reach(uses, layer):
    """The layer, what it names, and what these name."""
    found, left = set(), [layer]
    while left:
        one = left.pop()
        if one not in found:
            found.add(one)
            left += uses[one]
    return found


def includes(file):
    return re.findall(r'^#include "([^"]+)"', file.read_text(), re.M)


def sources(folder):
    return sorted([*folder.glob("*.cpp"), *folder.glob("*.hpp")])


def cycles(project):
    """Headers that include each other: which of them comes first decides whether a file compiles by itself."""
    roots = [project / "src", project / "include", project / "apps"]
    headers = {h.relative_to(root).as_posix(): h for root in roots for h in root.rglob("*.hpp")}
    left = {name: set(includes(file)) & headers.keys() for name, file in headers.items()}
    while free := [name for name, needs in left.items() if not needs]:
        for name in free:
            del left[name]
        for needs in left.values():
            needs.difference_update(free)
    return sorted(left)


def faults(project):
    for name in cycles(project):
        yield f"{name} includes itself, through others, or includes headers that do"
    uses = layers_of((project / "CMakeLists.txt").read_text())
    if len(uses) < 10:
        yield "CMakeLists.txt: no layers found"
    folders = {f.name for f in (project / "src").iterdir() if f.is_dir()}
    for folder in sorted(folders ^ uses.keys()):
        yield f"src/{folder}: a folder without a layer, or a layer without a folder"

    def of(file, may_use):
        for header in includes(file):
            layer = header.split("/")[0]
            if layer in uses and layer not in may_use:
                yield f"{file.relative_to(project)} includes {header}, of a layer that it does not depend on"

    for layer in uses:
        for file in sources(project / "src" / layer):
            yield from of(file, reach(uses, layer))
    verifier = reach(uses, "proof") | reach(uses, "io")
    for engine in ("tiling", "kinetic", "spacetime", "solver", "query"):
        if engine in verifier:
            yield f"CMakeLists.txt: the verifier's layers use {engine}"
    for file in sources(project / "apps" / "verify"):
        yield from of(file, verifier)
    own = set(own_rules)
    for name in sorted(own):
        if not (project / "src" / name).exists():
            yield f"tests/layers_test.py names {name}, which does not exist"
    for folder in ("src/proof", "apps/verify"):
        for file in sources(project / folder):
            for header in sorted(own.intersection(includes(file))):
                yield f"{file.relative_to(project)} includes {header}, which the verifier must not share"


def main():
    found = list(faults(Path(sys.argv[1]).resolve()))
    print("\n".join(found) or "every layer keeps to those that it names")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())

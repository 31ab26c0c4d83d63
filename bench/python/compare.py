#!/usr/bin/env python3
"""How much check_many() takes besides the library: a loop in C++ does the same, on one thread.

usage: compare.py CHECK_LOOP

Run by `./dev python bench`. Both run in turn, several times; the least processor time of each counts.
"""

import pathlib
import subprocess
import sys
import tempfile
import time

import numpy
import taut2d

root = pathlib.Path(__file__).resolve().parents[2]


def hammers(rows):
    x = numpy.linspace(-5, 5, rows)
    return numpy.stack([numpy.c_[0 * x, x, 0 * x, 0 * x], numpy.c_[0 * x + 10, x, 0 * x - 6, 0 * x]], axis=1)


def turning_hammers(rows):
    keyframes = hammers(rows)
    keyframes[:, 1, 3] = 90
    return keyframes


def gears(rows):
    """The pinion turns with the wheel, and is not quite where it should be."""
    x, y = numpy.random.default_rng(1).uniform(-2e-2, 2e-2, (2, rows)) + [[16], [0]]
    return numpy.stack([numpy.c_[0 * x, x, y, 0 * x], numpy.c_[0 * x + 1, x, y, 0 * x - 360 * 152 / 104]], axis=1)


def cases():
    anvil = taut2d.Body("anvil", [(0, 0), (4, 0), (4, 1), (0, 1)])
    hammer = taut2d.Body("hammer", [(1, 5), (3, 5), (2, 6)])
    drop = taut2d.Scene([anvil, hammer], (0, 10))
    yield "a triangle falls", drop, hammers(30000)
    yield "a triangle falls and turns", drop, turning_hammers(10000)
    yield "two gears", taut2d.Scene.load(root / "examples/gears.json"), gears(300)


def here(scene, keyframes):
    begin = time.process_time()
    found = taut2d.check_many(scene, {scene.bodies[-1].name: keyframes}, threads=1)
    taken = time.process_time() - begin
    return taken, sum(found["t_lo"][found["outcome"] == taut2d.Outcome.CONTACT].tolist())


def there(program, scene, keyframes, folder):
    scene.save(folder / "scene.json")
    keyframes.tofile(folder / "keyframes")
    printed = subprocess.run([program, folder / "scene.json", folder / "keyframes", str(keyframes.shape[1])],
                             stdout=subprocess.PIPE, text=True, check=True).stdout
    return tuple(map(float, printed.split()))


def main(program):
    print("%-28s %9s %14s %14s %12s" % ("", "rows", "C++, us a row", "Python", "besides"))
    for name, scene, keyframes in cases():
        with tempfile.TemporaryDirectory() as folder:
            pairs = [(there(program, scene, keyframes, pathlib.Path(folder)), here(scene, keyframes)) for _ in range(7)]
        assert len({total for pair in pairs for _, total in pair}) == 1, "the answers differ"
        cpp, python = (min(pair[k][0] for pair in pairs) / len(keyframes) * 1e6 for k in (0, 1))
        print("%-28s %9d %14.2f %14.2f %9.2f us, %+.1f %%" %
              (name, len(keyframes), cpp, python, python - cpp, 100 * (python / cpp - 1)))


if __name__ == "__main__":
    main(sys.argv[1])

#!/usr/bin/env python3
"""Scenes by the million for `taut check --lines`: the lid of examples/lid.json, with a hinge that is not quite in its place.

usage: tolerances.py COUNT >scenes.jsonl

One scene on each line. In scene K the hinge lies up to 8 away from where it should be in x and in y, and the lid is
opened from closed to 60 or more degrees, at most 110: numbers that a fixed generator draws for K, so that the scenes of
every run are the same.
"""

import json
import pathlib
import sys

root = pathlib.Path(__file__).resolve().parents[2]


def drawn(number):
    """A number from 0 to 1, one of 2^32: the finalizer of SplitMix64 (Steele, Lea and Flood)."""
    z = number * 0x9E3779B97F4A7C15 & (2**64 - 1)
    z = (z ^ z >> 30) * 0xBF58476D1CE4E5B9 & (2**64 - 1)
    z = (z ^ z >> 27) * 0x94D049BB133111EB & (2**64 - 1)
    return (z >> 32) / 2**32


def main(count):
    container, lid = json.loads((root / "examples/lid.json").read_text())["bodies"]
    motion = lid.pop("motion")["sweep"]
    assert motion["pivot"] == [0, 0] and motion["to_deg"] == 110
    bodies = json.dumps([container, lid], separators=(",", ":"))[:-2]
    for k in range(count):
        x, y, share = 16 * drawn(3 * k) - 8, 16 * drawn(3 * k + 1) - 8, drawn(3 * k + 2)
        print(f'{{"format":"taut-scene/1","time":[0,1],"bodies":{bodies},"motion":{{"sweep":{{"pivot":[{x:.4f},{y:.4f}],'
              f'"from_deg":0,"to_deg":{60 + 50 * share:.3f}}}}}}}]}}')


if __name__ == "__main__":
    main(int(sys.argv[1]))

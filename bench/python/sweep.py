#!/usr/bin/env python3
"""What sweep() takes besides the questions: a million of them, say, of about a millisecond each.

usage: sweep.py [ROWS] [WORKERS]

With WORKERS, on so many workers of a Dask cluster on this machine; else on as many threads as there are processors.
The folder of the sweep is made anew, and removed. Printed are the time of it all, the time while the library answered
(of a cluster: that of all workers, shared among them), and the difference as a share of that.
"""

import os
import pathlib
import sys
import tempfile
import time

import numpy
import taut2d
from taut2d import _taut2d

root = pathlib.Path(__file__).resolve().parents[2]


def pinions(rows):
    """A part of a turn of two gears, with a pinion that is not quite where it should be."""
    x, y = numpy.random.default_rng(1).uniform(-4e-2, 4e-2, (2, rows)) + [[16], [0]]
    return numpy.stack([numpy.c_[0 * x, x, y, 0 * x], numpy.c_[0 * x + 1, x, y, 0 * x - 360 * 152 / 104]], axis=1)


def timed(answer, spent):
    """The same function, which notes how long it took."""
    def call(*arguments):
        begin = time.perf_counter()
        try:
            return answer(*arguments)
        finally:
            spent.append(time.perf_counter() - begin)
    return call


def note_in_workers(dask_worker):
    dask_worker.taut_spent = []
    _taut2d.check_rows = timed(_taut2d.check_rows, dask_worker.taut_spent)


def report(rows, taken, asked, where, found):
    outcomes = {name: 0 for name in ("free", "contact", "overlap_at_start", "undecided")}
    for row in found:
        outcomes[row["outcome"]] += 1
    size = sum(os.path.getsize(path) for path in found.shards)
    print(f"{rows} rows on {where}: {taken:.1f} s, of which the library {asked:.1f} s: {100 * (taken / asked - 1):.1f} % besides, "
          f"{1e6 * (taken - asked) / rows:.1f} us a row")
    print(f"{len(found.shards)} files, {size / 1e6:.0f} MB; {outcomes}")


def main(rows, workers):
    scene = taut2d.Scene.load(root / "examples/gears.json")
    motions = {"pinion": pinions(rows)}
    times = numpy.broadcast_to([0, 0.6], (rows, 2))
    spent = []
    with tempfile.TemporaryDirectory() as folder:
        begin = time.perf_counter()
        if workers:
            import distributed
            options = {"n_workers": workers, "threads_per_worker": 1, "dashboard_address": None, "processes": True}
            with distributed.LocalCluster(local_directory=folder, **options) as cluster, distributed.Client(cluster) as client:
                client.run(note_in_workers)
                begin = time.perf_counter()
                found = taut2d.sweep(scene, motions, times=times, to=folder + "/sweep", client=client)
                taken = time.perf_counter() - begin
                asked = sum(sum(client.run(lambda dask_worker: dask_worker.taut_spent).values(), [])) / workers
            where = f"{workers} workers of Dask"
        else:
            _taut2d.check_rows = timed(_taut2d.check_rows, spent)
            found = taut2d.sweep(scene, motions, times=times, to=folder + "/sweep")
            taken, asked, where = time.perf_counter() - begin, sum(spent), f"{len(os.sched_getaffinity(0))} threads"
        report(rows, taken, asked, where, found)


if __name__ == "__main__":
    main(int(sys.argv[1]) if len(sys.argv) > 1 else 10**6, int(sys.argv[2]) if len(sys.argv) > 2 else 0)

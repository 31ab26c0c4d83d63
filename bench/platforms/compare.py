"""Worlds on this machine and in WebAssembly: a table for docs/benchmarks.md.

usage: compare.py ROUNDS NATIVE_PROGRAM NODE SCRIPT

The two programs take turns, and of each question the median of their times counts. Answers must be the same."""

import statistics
import subprocess
import sys


def times(command):
    """Of each question, in order: (milliseconds, what identifies the answers)."""
    text = subprocess.run(command, check=True, capture_output=True, text=True).stdout
    lines = (line.split("\t") for line in text.splitlines())
    return {name: (float(ms), answers) for name, ms, answers in lines}


def main():
    rounds, native, node, script = int(sys.argv[1]), *sys.argv[2:5]
    runs = [(times([native]), times([node, script])) for _ in range(rounds)]
    print("| | this machine, ms | WebAssembly, ms | times |")
    print("|---|---:|---:|---:|")
    for name in runs[0][0]:
        if len({side[name][1] for run in runs for side in run}) != 1:
            sys.exit(f"{name}: the answers are not the same")
        here, there = (statistics.median(run[k][name][0] for run in runs) for k in (0, 1))
        print(f"| {name} | {here:.2f} | {there:.2f} | {there / here:.2f} |")


if __name__ == "__main__":
    main()

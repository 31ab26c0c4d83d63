"""What a proof takes beside the answer alone, as a user sees it: whole commands, CPU time.

usage: compare.py TAUT ROUNDS SCENE...

`taut check` and `taut prove` take turns on each scene, in both readings of touching; of each the median counts. Printed are
the scenes whose proofs take longest beside their answers, and a summary."""

import os
import statistics
import sys
import tempfile


def cpu_seconds(command):
    child = os.fork()
    if child == 0:
        nowhere = os.open(os.devnull, os.O_WRONLY)
        os.dup2(nowhere, 1)
        os.dup2(nowhere, 2)
        os.execv(command[0], command)
    _, status, usage = os.wait4(child, 0)
    if os.waitstatus_to_exitcode(status) > 1:
        sys.exit(f"{' '.join(command)}: exit code {os.waitstatus_to_exitcode(status)}")
    return usage.ru_utime + usage.ru_stime


def beside(taut, rounds, scene, touch, log):
    checks, proofs = [], []
    for _ in range(rounds):
        checks.append(cpu_seconds([taut, "check", "--touch", touch, scene]))
        proofs.append(cpu_seconds([taut, "prove", "--touch", touch, scene, "-o", log]))
    return statistics.median(checks), statistics.median(proofs)


def main():
    taut, rounds, scenes = sys.argv[1], int(sys.argv[2]), sys.argv[3:]
    rows = []
    with tempfile.TemporaryDirectory() as folder:
        log = os.path.join(folder, "log")
        for scene in scenes:
            for touch in ("open", "closed"):
                rows.append((*beside(taut, rounds, scene, touch, log), os.path.basename(scene), touch))
    rows.sort(key=lambda row: row[1] / row[0], reverse=True)
    for check, proof, scene, touch in rows[:10]:
        print(f"{proof / check:.2f}: check {check * 1e3:.1f} ms, prove {proof * 1e3:.1f} ms, {scene}, {touch}")
    ratios = [proof / check for check, proof, *_ in rows]
    print(f"{len(rows)} questions, {sum(r > 2 for r in ratios)} above 2, at most {max(ratios):.2f}, "
          f"median {statistics.median(ratios):.2f}")


if __name__ == "__main__":
    main()

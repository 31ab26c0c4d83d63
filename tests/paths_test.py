#!/usr/bin/env python3
"""paths_test.py TAUT: all scenes with known answers in ../shared/paths, in each mode, by the checker that comes with them. It
verifies the ways by bounds of its own."""
import pathlib
import re
import subprocess
import sys

CHECKER = pathlib.Path(__file__).resolve().parents[2] / "shared" / "paths" / "check.py"


def main() -> int:
    if not CHECKER.exists():
        print(f"skipped: the paths with known answers are not here ({CHECKER})")
        return 77
    run = subprocess.run([sys.executable, CHECKER, sys.argv[1]], capture_output=True, text=True)
    lines = [line for line in run.stdout.splitlines() if line.strip()]
    count = re.fullmatch(r"(\d+) of (\d+) wrong", lines[-1] if lines else "")
    if run.returncode != 0 or not count or int(count[1]) > 0 or int(count[2]) < 172:
        print("\n".join(lines), run.stderr)
        return 1
    print(f"{count[2]} questions, none answered wrongly")
    return 0


if __name__ == "__main__":
    sys.exit(main())

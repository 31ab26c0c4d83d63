#!/usr/bin/env python3
"""mechanisms_test.py TAUT: all questions about the mechanisms with certified answers, in ../shared/mechanisms, by the checker that
comes with them."""
import pathlib
import re
import subprocess
import sys

CHECKER = pathlib.Path(__file__).resolve().parents[2] / "shared" / "mechanisms" / "check.py"
# Four pairs of this scissor lift are equally close, and the answer names one of them.
TIES = {"scissor_1 clearance pair"}


def main() -> int:
    if not CHECKER.exists():
        print(f"skipped: the mechanisms with certified answers are not here ({CHECKER})")
        return 77
    run = subprocess.run([sys.executable, CHECKER, sys.argv[1], "--timeout", "60"], capture_output=True, text=True)
    lines = [line for line in run.stdout.splitlines() if line.strip()]
    count = re.fullmatch(r"check +\d+ of (\d+) scenes wrong", next((s for s in lines if s.startswith("check ")), ""))
    wrong = [s for s in lines if not re.match(r"(check|clearance|intervals|range) +\d+ of |\d+ of ", s)]
    wrong = [s for s in wrong if not any(s.startswith(tie) for tie in TIES)]
    if run.stderr or not count or int(count[1]) < 77 or wrong:
        print("\n".join(wrong or lines), run.stderr)
        return 1
    print(f"{count[1]} scenes, none wrong")
    return 0


if __name__ == "__main__":
    sys.exit(main())

#!/usr/bin/env python3
"""paths_test.py TAUT: all scenes with known answers in ../shared/paths, in each mode, by the checker that comes with them. It
verifies the ways by bounds of its own. Where there is no way, `taut prove` must find a log that `taut verify` accepts."""
import json
import pathlib
import re
import subprocess
import sys
import tempfile

CHECKER = pathlib.Path(__file__).resolve().parents[2] / "shared" / "paths" / "check.py"


def without_log(taut: str):
    """Scenes without a way for which no log is found, or none that is accepted."""
    with tempfile.TemporaryDirectory() as folder:
        log = pathlib.Path(folder) / "none.proof"
        for file in sorted(CHECKER.parent.glob("*.answer.json")):
            scene = file.with_name(file.name.replace(".answer", ""))
            for touch, answer in json.loads(file.read_text()).items():
                if touch not in ("open", "closed") or answer.get("outcome") != "none":
                    continue
                subprocess.run([taut, "prove", scene, "--touch", touch, "-o", log], capture_output=True)
                if not log.exists() or subprocess.run([taut, "verify", scene, log], capture_output=True).returncode != 0:
                    yield f"{scene.name}, {touch}"
                log.unlink(missing_ok=True)


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
    missing = list(without_log(sys.argv[1]))
    if missing:
        print("no log of no way:", *missing, sep="\n")
        return 1
    print(f"{count[2]} questions, none answered wrongly; a log wherever there is no way")
    return 0


if __name__ == "__main__":
    sys.exit(main())

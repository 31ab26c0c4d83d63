#!/usr/bin/python3
"""taut in version control: the hook of pre-commit and the examples for CI servers. hook_test.py TAUT ROOT

A bar of length 10 and half width 1 turns a whole turn beside a wall; its corners come as far as the root of 101.
"""
import json
import math
import os
import shutil
import subprocess
import sys
import tempfile
import unittest
import xml.etree.ElementTree as ET

TAUT, ROOT = os.path.abspath(sys.argv[1]), os.path.abspath(sys.argv[2])
PRE_COMMIT = "/usr/bin/pre-commit"
if not os.path.exists(PRE_COMMIT) or not shutil.which("git"):
    print("skipped: no git, or no pre-commit: `./dev integrations` installs them")
    sys.exit(77)
import yaml  # noqa: E402  pre-commit brings it

REACH = math.hypot(10, 1)


def mechanism(wall):
    """A scene with a wall so far to the right."""
    return json.dumps({
        "format": "taut-scene/1", "time": [0, 360],
        "bodies": [{"name": "frame", "polygon": [[wall, -20], [wall + 1, -20], [wall + 1, 20], [wall, 20]]},
                   {"name": "bar", "polygon": [[0, -1], [10, -1], [10, 1], [0, 1]]}],
        "mechanism": {"ground": "frame", "joints": {"A": {"revolute": ["frame", "bar"], "at": [0, 0]}},
                      "drive": {"A": {"from_deg": 0, "to_deg": 360}}}})


class Repository(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.home = folder.name
        bin_folder = os.path.join(self.home, "bin")
        os.mkdir(bin_folder)
        os.symlink(TAUT, os.path.join(bin_folder, "taut"))
        self.environment = {"HOME": self.home, "PATH": bin_folder + ":/usr/bin:/bin", "LANG": "C.UTF-8",
                            "GIT_AUTHOR_NAME": "a", "GIT_AUTHOR_EMAIL": "a@b", "GIT_COMMITTER_NAME": "a",
                            "GIT_COMMITTER_EMAIL": "a@b", "GIT_CONFIG_NOSYSTEM": "1"}
        self.folder = self.repository("work")

    def repository(self, name):
        folder = os.path.join(self.home, name)
        os.mkdir(folder)
        self.run_in(folder, "git", "init", "-q")
        return folder

    def run_in(self, folder, *words, code=0):
        done = subprocess.run(words, cwd=folder, env=self.environment, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE,
                              stderr=subprocess.STDOUT)
        text = done.stdout.decode("utf-8", "replace")
        self.assertEqual(done.returncode, code, text)
        return text

    def write(self, name, text, folder=None):
        path = os.path.join(folder or self.folder, name)
        os.makedirs(os.path.dirname(path), exist_ok=True)
        with open(path, "w", encoding="utf-8") as file:
            file.write(text)

    def commit(self, code=0):
        self.run_in(self.folder, "git", "add", "-A")
        return self.run_in(self.folder, "git", "commit", "-qm", "a change", code=code)

    def commits(self):
        return int(self.run_in(self.folder, "git", "rev-list", "--count", "--all"))


class Hooks(Repository):
    def change_the_mechanism(self):
        """Commits are made while the mechanism keeps 0.3, and refused when it does not."""
        self.run_in(self.folder, PRE_COMMIT, "install")
        self.write("scenes/press.json", mechanism(REACH + 0.3001))
        self.write("package.json", "{}")
        self.commit()
        self.assertEqual(self.commits(), 1)
        self.write("scenes/press.json", mechanism(REACH + 0.2999))
        self.write("scenes/other.json", mechanism(12))
        said = self.commit(code=1)
        self.assertIn("Failed", said)
        self.assertIn("CONTACT  frame x bar   closer than 0.3 at t = ", said)
        self.assertEqual(self.commits(), 1)
        self.write("scenes/press.json", '{"format": "taut-scene/1"')
        self.assertIn("scenes/press.json:1:", self.commit(code=1))
        self.write("scenes/press.json", mechanism(12))
        self.commit()
        self.assertEqual(self.commits(), 2)

    def test_the_local_hook(self):
        with open(os.path.join(ROOT, "examples/ci/pre-commit-config.yaml"), encoding="utf-8") as file:
            self.write(".pre-commit-config.yaml", file.read())
        self.change_the_mechanism()

    def test_the_hook_of_the_repository(self):
        hooks = self.repository("taut")
        shutil.copy(os.path.join(ROOT, ".pre-commit-hooks.yaml"), hooks)
        self.run_in(hooks, "git", "add", "-A")
        self.run_in(hooks, "git", "commit", "-qm", "hooks")
        revision = self.run_in(hooks, "git", "rev-parse", "HEAD").strip()
        self.write(".pre-commit-config.yaml", yaml.safe_dump({"repos": [{"repo": hooks, "rev": revision, "hooks": [
            {"id": "taut-check", "args": ["--clearance", "0.3"]}]}]}))
        self.change_the_mechanism()

    def test_without_the_command(self):
        with open(os.path.join(ROOT, "examples/ci/pre-commit-config.yaml"), encoding="utf-8") as file:
            self.write(".pre-commit-config.yaml", file.read())
        self.run_in(self.folder, PRE_COMMIT, "install")
        os.remove(os.path.join(self.home, "bin/taut"))
        self.write("scenes/press.json", mechanism(12))
        self.assertIn("`taut` not found", self.commit(code=1))


class Servers(Repository):
    def check_by(self, command):
        """A command of an example, while the mechanism keeps its distance, and when it does not."""
        self.write("scenes/press.json", mechanism(REACH + 0.3001))
        self.write("scenes/other.json", mechanism(12))
        for wall, code, failures in ((REACH + 0.3001, 0, "0"), (REACH + 0.2999, 1, "1")):
            self.write("scenes/press.json", mechanism(wall))
            self.run_in(self.folder, "bash", "-euo", "pipefail", "-c", command, code=code)
            suite = ET.parse(os.path.join(self.folder, "clearances.xml")).getroot()[0]
            self.assertEqual((suite.get("tests"), suite.get("failures"), suite.get("errors")), ("2", failures, "0"))
        failure, = suite.iter("failure")
        # Where the upper corner comes to 0.3 from the wall: REACH cos(t + atan(1/10)) = wall - 0.3.
        ahead = math.degrees(math.acos((REACH + 0.2999 - 0.3) / REACH))
        expected = 360 - math.degrees(math.atan2(1, 10)) - ahead
        first = min(angle for angle in (math.degrees(math.atan2(1, 10)) - ahead, expected) if angle > 0)
        self.assertAlmostEqual(float(failure.get("message").split("t = ")[1].strip("[…").split(",")[0]), first, places=6)

    def steps(self, name):
        with open(os.path.join(ROOT, "examples/ci", name), encoding="utf-8") as file:
            return yaml.safe_load(file)

    def test_github_actions(self):
        workflow = self.steps("github-actions.yml")
        steps = workflow["jobs"]["check"]["steps"]
        check, = [step["run"] for step in steps if "taut check" in step.get("run", "")]
        upload = next(step for step in steps if step.get("uses", "").startswith("actions/upload-artifact"))
        self.assertEqual((upload["if"], upload["with"]["path"]), ("always()", "clearances.xml"))
        for step in steps:
            self.run_in(self.folder, "bash", "-n", "-c", step.get("run", ":"))
        self.check_by(check)

    def test_gitlab(self):
        job = self.steps("gitlab-ci.yml")["clearances"]
        self.assertEqual(job["artifacts"]["reports"]["junit"], "clearances.xml")
        self.check_by("\n".join(job["script"]))


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])

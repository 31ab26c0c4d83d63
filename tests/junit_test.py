#!/usr/bin/python3
"""The JUnit reports of `taut check --junit`: junit_test.py TAUT ROOT

They must be what readers of JUnit agree on: elements, attributes, their types and order as in the schema of Jenkins
(junit-10.xsd), and counts that are those of the cases.
"""
import json
import os
import re
import signal
import subprocess
import sys
import tempfile
import time
import unittest
import xml.etree.ElementTree as ET

TAUT, ROOT = os.path.abspath(sys.argv[1]), os.path.abspath(sys.argv[2])
SQUARE = [[0, 0], [1, 0], [1, 1], [0, 1]]
# Of each element: attributes that it must have, that it may have, and its children in their order.
SCHEMA = {
    "testsuites": ({"tests", "failures", "errors"}, {"name", "time", "disabled"}, ["testsuite"]),
    "testsuite": ({"name", "tests"}, {"failures", "errors", "skipped", "time", "timestamp", "hostname", "id", "package"},
                  ["testcase"]),
    "testcase": ({"name", "classname"}, {"time", "assertions", "status"},
                 ["skipped", "error", "failure", "system-out", "system-err"]),
    "skipped": (set(), {"message"}, []), "error": ({"type"}, {"message"}, []), "failure": ({"type"}, {"message"}, []),
    "system-out": (set(), set(), []), "system-err": (set(), set(), []),
}


def scene(x, motion, name="moving", **more):
    """A square that rests at the origin, and one at x that moves."""
    return dict({"format": "taut-scene/1", "time": [0, 10], "bodies": [
        {"name": "resting", "polygon": SQUARE},
        {"name": name, "polygon": [[x + u, v] for u, v in SQUARE], "motion": motion}]}, **more)


FREE, HIT = scene(3, {"velocity": [1, 0]}), scene(3, {"velocity": [-1, 0]})


class Folder(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = folder.name

    def path(self, name):
        return os.path.join(self.folder, name)

    def write(self, name, content):
        with open(self.path(name), "w", encoding="utf-8", errors="surrogateescape") as file:
            file.write(content if isinstance(content, str) else json.dumps(content))
        return name

    def run_taut(self, *words):
        return subprocess.run([TAUT, *words], cwd=self.folder, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE,
                              stderr=subprocess.PIPE)

    def report(self, code, *words):
        """The cases of a valid report, as (name, tag of the result or "", type, message, text)."""
        done = self.run_taut("check", "--junit", "report.xml", *words)
        self.assertEqual(done.returncode, code, done.stderr)
        root = ET.parse(self.path("report.xml")).getroot()
        self.assertEqual(root.tag, "testsuites")
        self.validate(root)
        return [self.case(case) for case in root.iter("testcase")]

    def case(self, case):
        results = [child for child in case if child.tag != "system-out"]
        self.assertLessEqual(len(results), 1)
        if not results:
            return case.get("name"), "", None, None, case.findtext("system-out")
        return case.get("name"), results[0].tag, results[0].get("type"), results[0].get("message"), results[0].text

    def validate(self, element):
        must, may, children = SCHEMA[element.tag]
        have = set(element.attrib)
        self.assertTrue(must <= have <= must | may, "%s has %s" % (element.tag, have))
        order = [children.index(child.tag) for child in element]
        self.assertEqual(order, sorted(order), element.tag)
        for key in ("tests", "failures", "errors", "skipped"):
            if key in have:
                self.assertRegex(element.get(key), r"^\d+$")
                tag = {"tests": "testcase", "failures": "failure", "errors": "error", "skipped": "skipped"}[key]
                self.assertEqual(int(element.get(key)), len(list(element.iter(tag))), key)
        if "time" in have:
            self.assertRegex(element.get("time"), r"^\d+\.\d+$")
            times = [float(case.get("time")) for case in element.iter("testcase")]
            self.assertAlmostEqual(float(element.get("time")), sum(times), delta=1e-5 * (1 + len(times)))
        for child in element:
            self.validate(child)


class Reports(Folder):
    def test_every_outcome(self):
        names = [self.write("free.json", FREE), self.write("hit.json", HIT),
                 self.write("overlap.json", scene(0.5, {"velocity": [1, 0]})),
                 self.write("untested.json", scene(3, {"velocity": [1, 0]}, ignore=[["resting", "*"]])),
                 self.write("broken.json", '{"format": "taut-scene/1", '),
                 os.path.join(ROOT, "examples/mechanisms/toggle_press.json"), "missing.json"]
        cases = self.report(2, *names)
        self.assertEqual([case[0] for case in cases], names)
        self.assertEqual([case[1:3] for case in cases],
                         [("", None), ("failure", "contact"), ("failure", "overlap_at_start"), ("error", "untested"),
                          ("error", "bad_input"), ("error", "locked"), ("error", "bad_input")])
        self.assertIn("FREE  resting x moving\n  proved free on [0, 10]", cases[0][4])
        self.assertEqual(cases[1][3], "CONTACT  resting x moving   t = [2, 2.0000000000000004]")
        self.assertIn("proved free on [0, 2)", cases[1][4])
        self.assertIn("broken.json:1:", cases[4][3])
        skipped = self.report(0, "--allow-untested", "free.json", "untested.json")
        self.assertEqual([case[1] for case in skipped], ["", "skipped"])

    def test_undecided_is_an_error(self):
        cases = self.report(3, "--engine", "kinetic", "--max-events", "5", os.path.join(ROOT, "examples/gears.json"))
        self.assertEqual(cases[0][1:3], ("error", "undecided"))
        self.assertIn("the limit of 5 events was reached", cases[0][4])

    def test_clearances_of_several_scenes(self):
        """Squares 2 apart, at rest and on their way: they come closer than 0.5 after 1.5, and are closer than 3 at once."""
        self.write("free.json", FREE)
        self.write("hit.json", HIT)
        cases = self.report(1, "--clearance", "0.5", "free.json", "hit.json")
        self.assertEqual([case[1:3] for case in cases], [("", None), ("failure", "contact")])
        self.assertIn("all keep 0.5 on [0, 10]", cases[0][4])
        self.assertRegex(cases[1][3], r"closer than 0\.5 at t = \[?1\.(5|49999)")
        cases = self.report(1, "--clearance", "3", "free.json", "hit.json")
        self.assertEqual([case[1:3] for case in cases], [("failure", "closer_at_start")] * 2)
        with open(self.path("report.xml"), encoding="utf-8") as file:
            self.assertIn('<testsuite name="taut check --clearance 3"', file.read())
        done = self.run_taut("check", "--json", "--clearance", "0.5", "free.json", "hit.json")
        answers = [json.loads(line) for line in done.stdout.splitlines()]
        self.assertEqual([(answer["scene"], answer["outcome"], answer["clearance"]) for answer in answers],
                         [("free.json", "free", 0.5), ("hit.json", "contact", 0.5)])

    def test_lines_and_shards_and_json(self):
        self.write("scenes.jsonl", "\n".join(json.dumps(one) for one in (FREE, HIT, FREE)))
        for extra in ([], ["--json"], ["--threads", "3"]):
            cases = self.report(1, "--lines", "scenes.jsonl", *extra)
            self.assertEqual([case[:2] for case in cases],
                             [("scenes.jsonl:1", ""), ("scenes.jsonl:2", "failure"), ("scenes.jsonl:3", "")])
        cases = self.report(0, "--lines", "scenes.jsonl", "--shard", "1/2")
        self.assertEqual([case[0] for case in cases], ["scenes.jsonl:1", "scenes.jsonl:3"])
        self.write("empty.jsonl", "")
        self.assertEqual(self.report(0, "--lines", "empty.jsonl"), [])

    def test_hostile_names(self):
        for name in ("<&>\"'", "]]>", "\ufffe\uffff", "\u202eback", "\U0001f600 ärger", "&#0;"):
            self.write("name.json", scene(3, {"velocity": [-1, 0]}, name))
            case, = self.report(1, "name.json")
            shown = re.sub("[\u202e\ufffe\uffff]", lambda match: "\\u%04x" % ord(match.group()), name)
            self.assertIn("resting x %s " % shown, case[3])
        for name in ("\x01\x1b[2Jred", "a\nb\tc"):
            self.write("name.json", scene(3, {"velocity": [-1, 0]}, name))
            case, = self.report(2, "name.json")
            self.assertEqual(case[1:3], ("error", "bad_input"))
        for name in ("a b'c.json", "<x>&\".json", "line\nbreak.json", b"bytes\xff.json".decode("utf-8", "surrogateescape")):
            self.write(name, FREE)
            self.assertEqual(len(self.report(0, name)), 1)


class Files(Folder):
    def test_whole_or_not_at_all(self):
        self.write("free.json", FREE)
        self.write("report.xml", "old")
        done = self.run_taut("check", "--junit", "no/such/folder.xml", "free.json")
        self.assertEqual(done.returncode, 2)
        self.assertIn(b"no/such/folder.xml: cannot write the file", done.stderr)
        # A run that is stopped lacks scenes: the old report stays, and nothing else is left.
        self.write("many.jsonl", (json.dumps(FREE) + "\n") * 400000)
        with open(os.devnull, "wb") as devnull:
            run = subprocess.Popen([TAUT, "check", "--json", "--lines", "--junit", "report.xml", "many.jsonl"],
                                   cwd=self.folder, stdout=devnull, stderr=subprocess.PIPE)
            time.sleep(0.5)
            run.send_signal(signal.SIGINT)
            said = run.communicate(timeout=60)[1]
        self.assertEqual(run.returncode, 3, said)
        self.assertIn(b"no JUnit report was written", said)
        with open(self.path("report.xml"), encoding="utf-8") as file:
            self.assertEqual(file.read(), "old")
        self.assertEqual(sorted(os.listdir(self.folder)), ["free.json", "many.jsonl", "report.xml"])

    def test_what_does_not_go_together(self):
        self.write("free.json", FREE)
        for words, message in ((["--junit", "-"], b"standard output has the answers"),
                               (["--junit", "x.xml", "--clearance", "1", "--svg", "x.svg"], b"--svg: it draws one scene")):
            done = self.run_taut("check", *words, "free.json")
            self.assertEqual(done.returncode, 2)
            self.assertIn(message, done.stderr)
        self.assertEqual(os.listdir(self.folder), ["free.json"])


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])

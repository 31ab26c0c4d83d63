"""What the extensions for drawing programs share: they run the command `taut`, and say its answers in words.

Copy this file next to the extension. It needs Python 3.7 and nothing else.
"""

import json
import math
import os
import shutil
import subprocess
import tempfile


class TautError(Exception):
    """Why there is no answer, in words for the user."""


def find_command(given=""):
    """The path of the command: `given`, or where the system looks for programs, or one of the usual folders."""
    if given:
        found = shutil.which(os.path.expanduser(given))
        if not found:
            raise TautError("%s is not the command taut: it is not there, or cannot be started." % given)
        return found
    usual = [os.path.expanduser("~/.local/bin"), "/usr/local/bin", "/opt/homebrew/bin"]
    found = shutil.which("taut") or shutil.which("taut", path=os.pathsep.join(usual))
    if not found:
        raise TautError("The command taut was not found. Install it, or give its path in the dialog.\n"
                        "(Looked for in PATH and in %s.)" % ", ".join(usual))
    return found


class Taut:
    """The command, and a folder for the files that it reads and writes; use it in a `with` statement."""

    def __init__(self, command="", seconds=60):
        self.command, self.seconds = find_command(command), seconds

    def __enter__(self):
        self._folder = tempfile.TemporaryDirectory(prefix="taut-")
        self.folder = self._folder.name
        return self

    def __exit__(self, *_):
        self._folder.cleanup()

    def path(self, name):
        return os.path.join(self.folder, name)

    def write(self, name, text):
        with open(self.path(name), "w", encoding="utf-8") as file:
            file.write(text)
        return self.path(name)

    def read(self, name):
        """The object in a file of JSON that the command wrote."""
        with open(self.path(name), encoding="utf-8") as file:
            return json.load(file)

    def run(self, *arguments, codes=(0, 1, 3), prints=True):
        """What a subcommand prints to standard output. Other exit codes than `codes`, and silence, are errors."""
        options = {"creationflags": 0x08000000} if os.name == "nt" else {}  # no window of a console
        try:
            done = subprocess.run([self.command, *arguments], cwd=self.folder, stdin=subprocess.DEVNULL,
                                  stdout=subprocess.PIPE, stderr=subprocess.PIPE, **options)
        except OSError as error:
            raise TautError("%s cannot be started: %s" % (self.command, error)) from error
        printed = done.stdout.decode("utf-8", "replace")
        if done.returncode not in codes or (prints and not printed):
            said = done.stderr.decode("utf-8", "replace").strip()
            raise TautError(said or "%s ended with exit code %d" % (self.command, done.returncode))
        return printed

    def json_of(self, *arguments, codes=(0, 1, 3)):
        """The object that a subcommand prints."""
        return json.loads(self.run(*arguments, codes=codes))

    def check(self, scene, clearance=0, deviation=0, fit=0):
        """The answer about a scene, both as the objects of their JSON. If no pair was tested, it is `untested`.

        `fit`: bodies are shrunk by so much to twice as much first, for parts that fit exactly; not with a clearance.

        `deviation`: how far the scene's outlines are from the shapes that they stand for, at most. If it is not 0 the
        answer has a member `shapes`: is `free` proved of these shapes, too? It is if the outlines keep twice that
        distance more.
        """
        if fit > 0 and clearance > 0:
            raise TautError("Ask for a distance to keep, or shrink the bodies: one of the two.")
        answer = self._ask(scene, clearance, fit)
        if deviation > 0:
            # Of shrunk bodies nothing follows for the curves.
            free = fit == 0 and answer["outcome"] == "free"
            free = free and self._ask(scene, clearance + 2 * deviation)["outcome"] == "free"
            answer["shapes"] = {"deviation": deviation, "free": free}
        return answer

    def draw(self, t, picture):
        """A picture (SVG) of the scene that was asked about last, at the time t."""
        self.run("draw", self.path("scene.json"), "--at", repr(t), "-o", picture, prints=False)

    def _ask(self, scene, clearance, fit=0):
        words = ["check", "--json", "--allow-untested", "--max-seconds", repr(self.seconds)]
        if clearance > 0:
            words += ["--clearance", repr(clearance)]
        if fit > 0:
            words += ["--fit", repr(fit)]
        return self.json_of(*words, self.write("scene.json", json.dumps(scene)))


class Rotation:
    """A turn about a point by so many degrees, counterclockwise if positive. The scene's time is the angle's size."""

    def __init__(self, pivot, degrees):
        if not degrees or not math.isfinite(degrees):
            raise TautError("The angle must be a number of degrees other than 0.")
        self.pivot, self.degrees = pivot, degrees

    end = property(lambda self: abs(self.degrees))

    def in_scene(self):
        return {"sweep": {"pivot": list(self.pivot), "from_deg": 0, "to_deg": self.degrees}}

    def in_words(self, t):
        return "%.9g degrees %s" % (t, "counterclockwise" if self.degrees > 0 else "clockwise")

    def matrix(self, t):
        """(a, b, c, d, e, f): a point (x, y) is then at (a x + c y + e, b x + d y + f)."""
        angle = math.radians(math.copysign(t, self.degrees))
        (x, y), cos, sin = self.pivot, math.cos(angle), math.sin(angle)
        return cos, sin, -sin, cos, x - cos * x + sin * y, y - sin * x - cos * y


class Translation:
    """A way along a straight line by (dx, dy). The scene's time is the share of it, from 0 to 1."""

    def __init__(self, dx, dy, unit=""):
        if not (dx or dy) or not math.isfinite(dx + dy):
            raise TautError("The distance must be other than 0.")
        self.dx, self.dy, self.unit = dx, dy, unit

    end = 1

    def in_scene(self):
        return {"velocity": [self.dx, self.dy]}

    def in_words(self, t):
        return "%.9g %s" % (t * math.hypot(self.dx, self.dy), self.unit)

    def matrix(self, t):
        return 1, 0, 0, 1, self.dx * t, self.dy * t


def contact_of(answer):
    """Where an answer has bodies meet, or come too close: a list of one or two points. Empty if it names none."""
    if "contact" in answer:
        return [answer["contact"]["point"]]
    if "overlap" in answer:
        return [answer["overlap"]["point"]]
    return answer.get("first", {}).get("points", [])


def instant_of(answer, end):
    """The time at which a picture of the answer is drawn: of the contact, of the end of what is proved, or `end`."""
    outcome = answer["outcome"]
    if outcome == "contact":
        return answer["t"][0]
    if outcome in ("overlap_at_start", "closer_at_start", "untested"):
        return 0
    if outcome in ("undecided", "locked"):
        return answer.get("free_until", answer.get("first", {}).get("free_until", 0))
    return end


def answer_in_words(answer, motion, unit, clearance=0):
    """Lines that say what is proved, and up to which tolerance. `motion` says times in words."""
    outcome, pair = answer["outcome"], " and ".join(answer.get("pair", []))
    all_pairs = "tested pairs" if untested_of(answer) else "bodies"
    kept = "all %s keep %.9g %s" % (all_pairs, clearance, unit) if clearance > 0 else "no %s collide" % all_pairs
    end, lines = motion.in_words(motion.end), []
    if outcome == "free":
        lines.append("FREE: %s up to %s, the end of the motion. This is proved." % (kept, end))
    elif outcome == "contact":
        lo, hi = answer["t"]
        what = "come closer than %.9g %s" % (clearance, unit) if clearance > 0 else "meet"
        lines.append("CONTACT: %s %s after %s." % (pair, what, motion.in_words(lo)))
        if hi - lo > 1e-6 * motion.end:
            lines.append("It is between %s and %s." % (motion.in_words(lo), motion.in_words(hi)))
        lines.append("It is proved that before this %s." % kept)
    elif outcome == "overlap_at_start":
        lines.append("OVERLAP AT THE START: %s overlap as they are drawn." % pair)
    elif outcome == "closer_at_start":
        lines.append("CLOSER AT THE START: as they are drawn, %s are %.9g %s apart." %
                     (pair, answer["first"]["distance"], unit))
    elif outcome == "untested":
        lines.append("UNTESTED: %s." % answer["reason"])
    else:
        lines.append("%s: %s." % (outcome.upper(), answer.get("reason") or answer.get("first", {}).get("reason", "")))
        lines.append("It is proved that %s up to %s." % (kept, motion.in_words(instant_of(answer, motion.end))))
    if answer.get("grazing"):
        lines.append("It is a graze: overlap and touching cannot be distinguished.")
    if "touching" in answer:
        lines.append("They touch without overlap, first after %s." % motion.in_words(answer["touching"]["t"][0]))
    if "touching_undecided" in answer:
        lines.append("Whether they touch was not decided: %s." % answer["touching_undecided"])
    if "geometry" in answer and "shapes" not in answer:
        lines.append("This is about the curves themselves, not about chords.")
    fit = answer["scope"].get("fit", 0)
    if fit > 0:
        lines.append("All this is about bodies shrunk by %.6g to %.6g %s." % (fit, 2 * fit, unit))
    if "shapes" in answer:
        lines.append(shapes_in_words(answer, unit))
    return lines + untested_of(answer)


def shapes_in_words(answer, unit):
    """What follows for shapes that the outlines approximate."""
    away = "%.3g %s" % (answer["shapes"]["deviation"], unit)
    if answer["shapes"]["free"]:
        return "Curves were chords, at most %s away; chords keep twice that, so free holds for the curves." % away
    if answer["outcome"] == "free":
        return ("Curves were chords, at most %s away. The chords come closer than twice that: the curves may collide." %
                away)
    return "Curves were chords, at most %s away: this is about the chords." % away


def untested_of(answer):
    """A line that counts the pairs about which nothing is said; no line if there are none."""
    words = {"ignored": "ignored", "moving_alike": "moving alike", "at_rest": "at rest",
             "layers": "on different layers", "not_reached": "not reached"}
    counts = ["%d %s" % (answer["coverage"][key], words[key]) for key in words if answer["coverage"].get(key)]
    return ["Pairs that were not tested: %s." % ", ".join(counts)] if counts else []

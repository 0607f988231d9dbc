"""What the tests of the program share: TEST.py PROGRAM SOURCE_FOLDER [unittest options]."""

import json
import pathlib
import re
import shlex
import shutil
import subprocess
import sys
import tempfile
import unittest

PROGRAM, SOURCE = sys.argv[1], pathlib.Path(sys.argv[2])
TRACES = SOURCE / "tests/traces"
ONE_LINE = r"^asterism: [^\n]+\n$"


def run(*arguments, stdin=None):
    return subprocess.run(
        [PROGRAM, *map(str, arguments)], capture_output=True, text=True, input=stdin, timeout=600
    )


def as_json(*arguments):
    """The exit code, and what is written as JSON."""
    done = run(*arguments, "--json", "-")
    return done.returncode, json.loads(done.stdout)


def trace_text(*visits, name="t"):
    """A trace file with these visits."""
    return json.dumps(
        {"format": "asterism/trace", "version": 1, "name": name, "visits": list(visits)}
    )


def no_map_text():
    """A trace file that no map explains: a dead end, where it seems to be left by, has a crossing."""
    dead_end = {"star": "a+1 a-0", "left_by": "a+"}
    crossing = {"star": "a+1 b+1 a-1 b-1", "entered_by": "a+", "left_by": "a+"}
    return trace_text(dead_end, crossing, crossing, name="no")


def shown_in_readme(*subcommands):
    """The commands of these kinds that the README shows, each with what it prints."""
    return shown_in("README.md", *subcommands)


def shown_in(page, *subcommands):
    text = (SOURCE / page).read_text()
    shown = re.findall(r"(?m)^    \$ asterism (.*)\n((?:    (?!\$).*\n|\n(?=    (?!\$)))*)", text)
    return [
        (shlex.split(command), re.sub(r"(?m)^    ", "", output).rstrip())
        for command, output in shown
        if command.split()[0] in subcommands
    ]


def view(star, first):
    """The star read clockwise from an arm, without labels: [(α, steps to the opposite arm)]."""
    arms = star.split()
    place = {}
    for number, arm in enumerate(arms):
        place.setdefault(arm[:-2], []).append(number)
    opposite = {a: b for a, b in place.values()} | {b: a for a, b in place.values()}
    order = [(first + step) % len(arms) for step in range(len(arms))]
    return [(arms[i][-1], (opposite[i] - i) % len(arms)) for i in order]


def arm_number(star, name):
    return None if name is None else [arm[:-1] for arm in star.split()].index(name)


class ProgramTest(unittest.TestCase):
    def refused(self, code, *arguments, said=ONE_LINE):
        """Checks that this is refused with nothing but a message, and returns the message."""
        done = run(*arguments)
        self.assertEqual((done.returncode, done.stdout), (code, ""), done.stderr)
        self.assertRegex(done.stderr, said)
        return done.stderr

    def check_lost_result(self, *arguments):
        """Checks that it is an error when what is printed gets lost, and returns the message."""
        with open("/dev/full", "w") as full:
            done = subprocess.run([PROGRAM, *map(str, arguments)], stdout=full,
                                  stderr=subprocess.PIPE, text=True, timeout=300)
        self.assertEqual(done.returncode, 70)
        return done.stderr

    def check_shown(self, shown, at_least=1, folder=SOURCE):
        """Checks that commands print what a page says they do."""
        self.assertGreaterEqual(len(shown), at_least)
        for command, output in shown:
            done = subprocess.run([PROGRAM, *command], capture_output=True, text=True, cwd=folder,
                                  timeout=600)
            self.assertEqual((done.stdout + done.stderr).rstrip(), output, command)

    def check_help(self, command):
        done = run(command, "--help")
        self.assertEqual(done.returncode, 0)
        self.assertRegex(done.stdout, rf"Examples:\s+asterism {command}")


class Folder(ProgramTest):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def file(self, name, text):
        path = self.folder / name
        path.write_text(text)
        return path

    def own_axioms(self, name="axioms"):
        """A folder of one's own with the axioms as shipped."""
        folder = self.folder / name
        shutil.copytree(SOURCE / "axioms", folder, ignore=shutil.ignore_patterns("*.?pp", "*.txt"))
        return folder


class BigTrace(Folder):
    """With a walk that has far too many maps to list."""

    def setUp(self):
        super().setUp()
        self.big = self.folder / "big.trace.json"
        made = run("simulate", "--seed", "8", "--travels", "60", "--missing", "0", "-o", self.big)
        self.assertEqual(made.returncode, 0)

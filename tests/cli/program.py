"""What the tests of the program share: TEST.py PROGRAM SOURCE_FOLDER [unittest options]."""

import pathlib
import re
import shlex
import subprocess
import sys
import tempfile
import unittest

PROGRAM, SOURCE = sys.argv[1], pathlib.Path(sys.argv[2])


def run(*arguments, stdin=None):
    return subprocess.run(
        [PROGRAM, *map(str, arguments)], capture_output=True, text=True, input=stdin, timeout=600
    )


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


class Folder(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def file(self, name, text):
        path = self.folder / name
        path.write_text(text)
        return path

"""A run whose files cannot all be written: the results of before are left, or those of now.

faults_test.py PROGRAM SOURCE_FOLDER FAULTS_LIBRARY [--full]
"""

import hashlib
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile
import unittest

from program import PROGRAM, run

LIBRARY = sys.argv[3]
STEP = 1 if "--full" in sys.argv else 40
EVERY = 1_000_000
BEFORE, NOW = ("--resolution", "0.4"), ("--resolution", "0.3")


def content(folder, kept=False):
    """Every file of a folder; if asked for, with what a run that failed says it has kept."""
    return {
        str(file.relative_to(folder)): hashlib.sha256(file.read_bytes()).hexdigest()
        for file in sorted(folder.rglob("*"))
        if file.is_file() and (kept or ".unfinished" not in file.parts)
    }


class Faults(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(folder.cleanup)
        cls.folder = pathlib.Path(folder.name).resolve()
        cls.log = cls.folder / "log"
        done = run("simulate", "--building", "office", "--seed", 3, "--travels", 2, "-o", cls.log)
        assert done.returncode == 0, done.stderr

    def mapped(self, folder, *options, inside=False, first=0, count=0):
        """The exit code, and how many calls could have failed."""
        told = self.folder / "told"
        faults = {"LD_PRELOAD": LIBRARY, "FAULT_FOLDER": str(folder), "FAULT_FIRST": str(first),
                  "FAULT_COUNT": str(count), "FAULT_TOLD": str(told)}  # fmt: skip
        done = subprocess.run(
            [PROGRAM, "run", self.log, "-o", "." if inside else folder, "--certify", "0", *options],
            capture_output=True, text=True, cwd=folder if inside else None,
            env={**os.environ, **faults})  # fmt: skip
        return done.returncode, int(told.read_text()), done.stderr

    def test_results_are_those_of_before_or_those_of_now(self):
        for inside in (False, True):
            out = self.folder / f"out-{inside}"
            other = self.folder / f"other-{inside}"
            for folder in (out, other):
                folder.mkdir()
                (folder / "notes").write_text("mine")
            self.assertEqual(self.mapped(out, *BEFORE, inside=inside)[0], 0)
            before = content(out)
            _, calls, _ = self.mapped(other, *NOW, inside=inside)
            now = content(other)
            self.assertNotEqual(before, now)
            self.assertGreater(calls, 30)
            failed = 0
            for count in (1, EVERY):
                for first in range(1 + STEP % 4, calls + 1, STEP):
                    with self.subTest(inside=inside, first=first, count=count):
                        code, _, message = self.mapped(
                            out, *NOW, inside=inside, first=first, count=count)
                        found = content(out)
                        if code == 0:
                            self.assertEqual(found, now)
                        else:
                            self.assertEqual(code, 70, message)
                            self.assertRegex(message.splitlines()[-1], "^asterism: ")
                            failed += 1
                        if found not in (before, now) and inside and count == EVERY:
                            # Nothing can be moved back any more. Nothing is lost, either.
                            kept = content(out, kept=True).values()
                            self.assertLessEqual(set(before.values()), set(kept))
                            self.assertIn("expected to move there what is in", message)
                            code, _, message = self.mapped(out, *BEFORE, inside=inside)
                            self.assertIn("kept by an earlier run", message)
                            shutil.rmtree(out / ".unfinished")
                            self.assertEqual(self.mapped(out, *BEFORE, inside=inside)[0], 0)
                            continue
                        self.assertTrue(found in (before, now), message)
                    self.assertEqual(self.mapped(out, *BEFORE, inside=inside)[0], 0)
                    self.assertEqual(content(out), before)
            self.assertGreater(failed, 0)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])

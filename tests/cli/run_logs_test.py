"""Real logs, mapped in one command; skipped where the data are absent.

run_logs_test.py PROGRAM SOURCE_FOLDER [unittest options]
"""

import json
import os
import pathlib
import subprocess
import sys
import unittest

from program import PROGRAM, SOURCE, Folder, run, shown_in
from routes import bad_routes

DATA = pathlib.Path(os.environ.get("ASTERISM_DATA", SOURCE / "../shared/data"))
TRUE_ACES = [0, 1, 2, 3, 4, 5, 6, 7, 0, 8, 4, 8, 6, 8, 2]  # data/aces/places.md


class Logs(Folder):
    def mapped(self, name, *options):
        """Exit code and summary of a run."""
        out = self.folder / name
        done = run("run", DATA / name / f"{name}.log.xz", "-o", out, "--json", *options)
        self.assertIn(done.returncode, (0, 1), done.stderr)
        self.assertEqual(run("validate", out / "maps.json", out / "trajectory.tum",
                             out / "layout.g2o", out / "map.yaml").returncode, 0)
        self.assertEqual(bad_routes(out), [])
        return done.returncode, json.loads(done.stdout)

    def errors(self, name, kind, file):
        done = run("evaluate", self.folder / name / "trajectory.tum", kind, DATA / name / file,
                   "--json")
        self.assertEqual(done.returncode, 0, done.stderr)
        return json.loads(done.stdout)

    def test_aces(self):
        for options in ([], ["--planar"]):
            with self.subTest(options=options):
                code, found = self.mapped("aces", *options)
                self.assertEqual(code, 0)
                self.assertEqual(found["models"][0]["visits"], TRUE_ACES)
                self.assertTrue(found["models"][0]["plausible"])
                errors = self.errors("aces", "--reference", "aces.gmapping.txt.xz")
                self.assertEqual(errors["matched"], errors["poses"])
                self.assertLessEqual(errors["position_rmse_m"], 0.30)

    @unittest.skipUnless((DATA / "intel").exists(), "the data are not here")
    def test_intel(self):
        # As good as a particle filter, though part of the trace be unexplained.        [KSD09]
        self.mapped("intel")
        errors = self.errors("intel", "--relations", "intel.relations.xz")
        self.assertEqual(errors["matched"], errors["relations"])
        self.assertLessEqual(errors["translation_m"]["mean"], 0.070)

    @unittest.skipUnless((DATA / "duke_loop5").exists(), "the data are not here")
    def test_duke_loop5(self):
        code, found = self.mapped("duke_loop5")
        self.assertEqual((code, found["scans"]), (0, 551))

    @unittest.skipUnless((DATA / "seattle").exists(), "the data are not here")
    def test_seattle(self):
        self.mapped("seattle")

    @unittest.skipUnless((DATA / "intel").exists(), "the data are not here")
    def test_the_page_shows_what_comes_out(self):
        shown = shown_in("docs/reproduce.md", "run", "evaluate")
        self.assertEqual(len(shown), 4)
        for command, output in shown:
            there = [DATA / word.split(".")[0] / word if word.endswith(".xz") else word
                     for word in command]
            done = subprocess.run([PROGRAM, *there], capture_output=True, text=True,
                                  cwd=self.folder, timeout=1000)
            self.assertEqual(done.stdout.rstrip(), output, command)


if __name__ == "__main__":
    if not (DATA / "aces").exists():
        sys.exit(77)
    unittest.main(argv=[sys.argv[0], *sys.argv[3:]])

"""Small drives on which programs have failed; skipped where they are absent.

cases_test.py PROGRAM SOURCE_FOLDER [unittest options]
"""

import json
import os
import pathlib
import sys
import unittest

from program import SOURCE, Folder, run

DATA = pathlib.Path(os.environ.get("ASTERISM_DATA", SOURCE / "../shared/data"))
CASES = DATA.parent / "cases"


class Cases(Folder):
    def mapped(self, name):
        """The summary of a run."""
        done = run("run", CASES / f"{name}.log.xz", "-o", self.folder / name, "--json")
        self.assertEqual((done.returncode, done.stdout[:1]), (0, "{"), done.stderr)
        return json.loads(done.stdout)

    def position_error(self, name):
        done = run("evaluate", self.folder / name / "trajectory.tum", "--reference",
                   CASES / f"{name}.true.tum", "--json")  # fmt: skip
        return json.loads(done.stdout)["position_rmse_m"]

    def test_nothing_is_plausible_that_has_two_places_on_one_spot(self):
        for name, pairs in (
            ("ring_with_side_door", [[1, 5], [2, 6]]),
            ("door_closed_second_lap", [[1, 5], [2, 6], [3, 7]]),
            ("uturn_mid_corridor", [[0, 1]]),
        ):
            with self.subTest(name=name):
                models = self.mapped(name)["models"]
                self.assertFalse(any(model["plausible"] for model in models))
                found = [spot["places"] for spot in models[0]["shared_spots"]]
                self.assertEqual(found, pairs)
                page = (self.folder / name / "report.html").read_text()
                self.assertIn(f"places {pairs[0][0]} and {pairs[0][1]} lie on one spot", page)

    def test_places_that_lie_apart_are_plausible(self):
        for name in ("door_open_control", "slow_uturn_dead_end_control", "zero_control",
                     "no_reset_control"):  # fmt: skip
            with self.subTest(name=name):
                summary = self.mapped(name)
                self.assertTrue(summary["models"][0]["plausible"])
                self.assertNotIn("shared_spots", summary["models"][0])
                self.assertNotIn("remarks", summary)
                self.assertLess(self.position_error(name), 0.25)

    def test_odometry_that_starts_again_is_told_and_bridged(self):
        (remark,) = self.mapped("odometry_reset")["remarks"]
        self.assertTrue(remark.startswith("odometry jumps 15.0 m and 0 degrees at scan 196"))
        self.assertLess(self.position_error("odometry_reset"), 0.3)

    def test_coordinates_that_are_huge_at_once_are_a_jump(self):
        remarks = self.mapped("far_jump")["remarks"]
        self.assertTrue(remarks[0].startswith("odometry jumps 999999.9 m"), remarks)
        self.assertTrue(remarks[1].startswith("the map by raw odometry is drawn in cells of "))

    def test_the_order_of_scans_counts_where_stamps_run_backwards(self):
        (remark,) = self.mapped("backwards_stamps")["remarks"]
        self.assertTrue(remark.startswith("stamps run backwards at 399 of 400 scans"))


if __name__ == "__main__":
    if not CASES.exists():
        print(f"skipped: no {CASES}")
        sys.exit(77)
    unittest.main(argv=[sys.argv[0], *sys.argv[3:]])

"""Drives through simulated buildings, and what is perceived of them.

drives_test.py PROGRAM SOURCE_FOLDER [unittest options]
"""

import cmath
import json
import math
import sys
import unittest

from program import Folder, run


class Drives(Folder):
    def drive(self, *options):
        self.log = self.folder / "drive.log"
        self.trace = self.folder / "drive.trace.json"
        return run("simulate", "--building", *options, "-o", self.log, "--true-trace", self.trace)

    def test_the_log_has_the_scans_of_the_true_trace(self):
        for building in ("aces-like", "office"):
            with self.subTest(building=building):
                svg, true = self.folder / "drive.svg", self.folder / "true.maps.json"
                done = self.drive(building, "--seed", "3", "--svg", svg, "--true-map", true)
                self.assertEqual((done.returncode, done.stdout), (0, ""), done.stderr)
                self.assertEqual(run("validate", self.trace, true).returncode, 0)
                lines = self.log.read_text().splitlines()
                self.assertIn("PARAM robot_front_laser_max 80 0 nohost 0", lines)
                scans = [line.split() for line in lines if line.startswith("FLASER 180 ")]
                self.assertEqual({len(scan) for scan in scans}, {2 + 180 + 9})
                ranges = [float(word) for scan in scans for word in scan[2:182]]
                self.assertTrue(0 < min(ranges) < max(ranges) == 80)
                visits = json.loads(self.trace.read_text())["visits"]
                self.assertEqual(visits[0]["scans"][0], 0)
                self.assertEqual(visits[-1]["scans"][1], len(scans) - 1)
                self.assertTrue(svg.read_text().startswith("<?xml"))

    def test_the_true_trajectory_has_a_pose_a_scan_and_agrees_with_the_true_trace(self):
        tum = self.folder / "true.tum"
        done = self.drive("office", "--seed", "5", "--travels", "4", "--true-trajectory", tum)
        self.assertEqual((done.returncode, done.stdout), (0, ""), done.stderr)
        scans = [line.split() for line in self.log.read_text().splitlines()
                 if line.startswith("FLASER ")]
        lines = [[float(word) for word in line.split()] for line in tum.read_text().splitlines()
                 if not line.startswith("#")]
        self.assertEqual([line[0] for line in lines], [float(scan[-1]) for scan in scans])
        poses = [(complex(x, y), cmath.rect(1, 2 * math.atan2(qz, qw)))
                 for _, x, y, _, _, _, qz, qw in lines]
        # Odometry is right at the first scan.
        x, y, heading = map(float, scans[0][-6:-3])
        self.assertAlmostEqual(poses[0][0], complex(x, y))
        self.assertAlmostEqual(poses[0][1], cmath.rect(1, heading))
        visits = json.loads(self.trace.read_text())["visits"]
        self.assertEqual(len(visits), 5)
        for left, reached in zip(visits, visits[1:]):
            (left_at, left_to), (reached_at, reached_to) = (
                poses[visit["scans"][0]] for visit in (left, reached))
            told = reached["displacement"]
            self.assertAlmostEqual((reached_at - left_at) / left_to, complex(told["x_m"], told["y_m"]))
            self.assertAlmostEqual(reached_to / left_to, cmath.rect(1, told["heading_rad"]))

    def test_a_drive_through_the_ring_is_perceived_visit_by_visit(self):
        self.drive("aces-like", "--seed", "1", "--travels", "2")
        trace, plots = self.folder / "seen.trace.json", self.folder / "plots"
        done = run("perceive", self.log, "-o", trace, "--plots", plots)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertEqual(run("validate", trace).returncode, 0)
        seen = json.loads(trace.read_text())["visits"]
        true = json.loads(self.trace.read_text())["visits"]
        self.assertEqual(len(seen), len(true))
        for one, other in zip(seen, true):
            self.assertLessEqual(one["scans"][0], other["scans"][1])
            self.assertLessEqual(other["scans"][0], one["scans"][1])
            self.assertTrue((self.folder / one["lpm"]).is_file())
        for name in ("visit-0.svg", f"visit-{len(seen) - 1}.svg", "visits.svg", "way.svg"):
            self.assertTrue((plots / name).read_text().startswith("<?xml"), name)

    def test_a_log_without_a_place_and_a_broken_detector_are_told_apart(self):
        self.drive("aces-like", "--seed", "1", "--travels", "1")
        lines = self.log.read_text().splitlines(keepends=True)
        short = self.folder / "short.log"
        short.write_text("".join(lines[:12]))
        done = run("perceive", short)
        self.assertEqual((done.returncode, done.stdout), (65, ""))
        self.assertIn("expected a drive that visits one", done.stderr)
        done = run("perceive", short, "--detector", self.folder / "none.so")
        self.assertEqual((done.returncode, done.stdout), (69, ""))
        done = run("perceive", short, "--detector-command", "echo garbage")
        self.assertEqual((done.returncode, done.stdout), (69, ""))
        self.assertEqual(run("perceive", self.folder / "none.log").returncode, 65)
        self.assertEqual(run("perceive", short, "--max-range", "-1").returncode, 64)

    def test_same_seed_same_bytes(self):
        logs = []
        for options in (["--seed", "1"], ["--seed", "1"], ["--seed", "2"],
                        ["--seed", "1", "--turned", "30"], ["--seed", "1", "--mirrored"],
                        ["--seed", "1", "--people", "0"]):
            self.drive("office", "--travels", "2", *options)
            logs.append(self.log.read_bytes())
        self.assertEqual(logs[0], logs[1])
        self.assertEqual(len(set(logs)), 5)

    def test_a_building_that_cannot_be(self):
        done = self.drive("office", "--width", "1", "--height", "1")
        self.assertEqual(done.returncode, 65)
        self.assertRegex(done.stderr, r"^asterism: simulate: found no grid [^\n]+\n$")
        self.assertFalse(self.log.exists())

    def test_on_stdout(self):
        done = run("simulate", "--building", "office", "--travels", "1")
        self.drive("office", "--travels", "1")
        self.assertEqual(done.stdout, self.log.read_text())


if __name__ == "__main__":
    unittest.main(argv=[sys.argv[0], *sys.argv[3:]])

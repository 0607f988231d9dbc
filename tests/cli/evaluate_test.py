"""Errors of trajectories: evaluate_test.py PROGRAM SOURCE_FOLDER [unittest options]."""

import json
import lzma
import math
import os
import pathlib
import sys
import unittest

from program import SOURCE, Folder, ProgramTest, run

DATA = pathlib.Path(os.environ.get("ASTERISM_DATA", SOURCE / "../shared/data"))


def tum(poses):
    """Lines of a trajectory, of poses (stamp, x, y, heading)."""
    return "".join(
        f"{t!r} {x!r} {y!r} 0 0 0 {math.sin(h / 2)!r} {math.cos(h / 2)!r}\n" for t, x, y, h in poses
    )


def moved(poses, by):
    c, s = math.cos(by[2]), math.sin(by[2])
    return [
        (t, by[0] + c * x - s * y, by[1] + s * x + c * y, h + by[2]) for t, x, y, h in poses
    ]


# Along two sides of a square, four metres in all.
DRIVE = [(10 + 0.5 * i, min(i, 2), max(i - 2, 0), 0 if i < 2 else math.pi / 2) for i in range(5)]


class Reference(Folder):
    def errors(self, trajectory, reference):
        done = run("evaluate", self.file("t.tum", tum(trajectory)), "--json", "--reference",
                   self.file("r.txt", reference))
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        return json.loads(done.stdout)

    def test_a_trajectory_moved_rigidly_has_no_error(self):
        errors = self.errors(moved(DRIVE, (3, -7, 2.5)), tum(DRIVE))
        self.assertEqual((errors["poses"], errors["matched"]), (5, 5))
        self.assertLess(errors["position_rmse_m"], 1e-12)
        self.assertLess(errors["heading_rmse_rad"], 1e-12)
        x, y, heading = errors["reference_from_layout"]
        self.assertAlmostEqual(heading, -2.5)
        self.assertAlmostEqual(3 * math.cos(2.5) - 7 * math.sin(2.5), -x)
        self.assertAlmostEqual(-3 * math.sin(2.5) - 7 * math.cos(2.5), -y)

    def test_a_known_error(self):
        # Two poses 2 m apart, estimated 2.6 m apart: each is 0.3 m off, whatever the motion.
        line = [(1, 0, 0, 0), (2, 2, 0, 0)]
        longer = [(1, 0, 0, 0.1), (2, 2.6, 0, -0.1)]
        errors = self.errors(moved(longer, (5, 5, 1)), tum(line))
        self.assertAlmostEqual(errors["position_rmse_m"], 0.3)
        self.assertAlmostEqual(errors["heading_rmse_rad"], 0.1)

    def test_only_estimates_of_a_scan_count(self):
        lines = "".join(
            f"{i} {t} {x + (9 if kind == 'O' else 0)} {y} {h} {kind}\n"
            for i, ((t, x, y, h), kind) in enumerate(zip(DRIVE, "POKKO"))
        )
        errors = self.errors(DRIVE, "# scan_index timestamp x y theta kind\n" + lines)
        self.assertEqual((errors["poses"], errors["matched"]), (2, 2))
        self.assertLess(errors["position_rmse_m"], 1e-12)

    def test_the_first_pose_of_a_stamp_counts(self):
        repeated = DRIVE + [(t, 50, 50, 1) for t, *_ in DRIVE]
        errors = self.errors(repeated, tum(DRIVE))
        self.assertEqual(errors["matched"], 5)
        self.assertLess(errors["position_rmse_m"], 1e-12)

    def test_the_text_says_how_much_matched(self):
        done = run("evaluate", self.file("t.tum", tum(DRIVE[1:])), "--reference",
                   self.file("r.tum", tum(DRIVE)))
        self.assertEqual(done.stdout, "4 of 5 poses of the reference matched\n"
                         "position error: 0.000 m RMSE, after the rigid fit\n"
                         "heading error:  0.00 degrees RMSE\n")


class Relations(Folder):
    def test_known_errors(self):
        relations = ("10 11 2 0 0 0 0 1.5707963267948966\n"    # exact
                     "11 12 2.3 0.4 0 0 0 0.2\n"               # 0.5 m and 0.2 rad off
                     "12 99 0 0 0 0 0 0\n")                    # no such stamp
        arguments = ("evaluate", self.file("t.tum", tum(moved(DRIVE, (1, 2, 3)))), "--relations",
                     self.file("r.relations", relations))
        errors = json.loads(run(*arguments, "--json").stdout)
        self.assertEqual((errors["relations"], errors["matched"]), (3, 2))
        for name, mean in (("translation_m", 0.25), ("rotation_rad", 0.1)):
            self.assertAlmostEqual(errors[name]["mean"], mean)
            self.assertAlmostEqual(errors[name]["standard_deviation"], mean)
        self.assertEqual(run(*arguments).stdout, "2 of 3 relations matched\n"
                         "translation error: 0.250 ± 0.250 m\n"
                         "rotation error:    5.73 ± 5.73 degrees\n")

    @unittest.skipUnless((DATA / "intel").exists(), "the data are not here")
    def test_the_reference_of_intel_has_the_errors_it_is_known_for(self):
        lines = lzma.open(DATA / "intel/intel.gmapping.txt.xz", "rt").read().splitlines()[1:]
        poses = [tuple(map(float, line.split()[1:5])) for line in lines]
        file = self.file("gmapping.tum", tum(poses))
        done = run("evaluate", file, "--relations", DATA / "intel/intel.relations.xz")
        self.assertEqual(done.stdout, "2984 of 2984 relations matched\n"
                         "translation error: 0.063 ± 0.064 m\n"
                         "rotation error:    2.28 ± 2.76 degrees\n")
        errors = json.loads(run("evaluate", file, "--json", "--reference",
                                DATA / "intel/intel.gmapping.txt.xz").stdout)
        self.assertEqual((errors["poses"], errors["matched"]), (910, 910))
        # Not 0: some stamps repeat, and the first scan of such a stamp is not the one of kind K.
        self.assertLess(errors["position_rmse_m"], 0.05)


class BadInput(Folder):
    def test_usage(self):
        t = self.file("t.tum", tum(DRIVE))
        for arguments in ([], [t], ["--relations", t], [t, "--relations", t, "--reference", t],
                          [t, "--reference"], [t, "--unknown"]):
            with self.subTest(arguments=arguments):
                self.refused(64, "evaluate", *arguments)

    def test_files(self):
        t = self.file("t.tum", tum(DRIVE))
        bad = self.file("bad.txt", "1 2 3\n")
        missing = self.folder / "missing"
        for known in ("--relations", "--reference"):
            self.assertIn("bad.txt:1: found the end of the line", self.refused(65, "evaluate", t, known, bad))
            self.assertIn("bad.txt:1: found", self.refused(65, "evaluate", bad, known, t))
            self.assertIn("missing: found no such file", self.refused(65, "evaluate", t, known, missing))
            self.assertIn("found a directory", self.refused(65, "evaluate", t, known, self.folder))

    def test_no_stamp_in_common(self):
        t = self.file("t.tum", tum(DRIVE))
        later = self.file("later.tum", tum([(t + 100, x, y, h) for t, x, y, h in DRIVE]))
        self.assertIn("later.tum: found no stamp of the trajectory's; expected stamps within "
                      "10.000000 to 12.000000 s", self.refused(65, "evaluate", t, "--reference", later))
        relations = self.file("r.relations", "110 111 0 0 0 0 0 0\n")
        self.assertIn("r.relations: found no relation between two of the trajectory's stamps",
                      self.refused(65, "evaluate", t, "--relations", relations))


class Validate(Folder):
    def test_each_kind_by_its_ending(self):
        corpus = SOURCE / "tests/corpus"
        for name, text in (("tum/good/two.tum", "trajectory: 2 poses, 2.7 m"),
                           ("tum/good/packed.tum.xz", "trajectory: 2 poses, 2.7 m"),
                           ("relations/good/packed.relations.xz", "relations: 1"),
                           ("g2o/good/two.g2o", "pose graph: 2 places, 1 displacements, 1 fixed"),
                           ("pgm/good/packed.pgm.gz", "picture: 3 x 2 pixels"),
                           ("maps/good/ranked.maps.json", "maps of square: 1 listed, 2 ranked")):
            done = run("validate", corpus / name)
            self.assertEqual((done.returncode, done.stdout), (0, f"{corpus / name}: valid, {text}\n"))

    def test_an_occupancy_map_is_its_yaml_and_its_picture(self):
        corpus = SOURCE / "tests/corpus"
        yaml = self.file("map.yaml", (corpus / "yaml/good/map_server.yaml").read_text())
        done = run("validate", yaml)
        self.assertEqual(done.returncode, 65)
        self.assertIn("map.pgm: found no such file or directory", done.stderr)
        (self.folder / "map.pgm").write_bytes((corpus / "pgm/good/bytes.pgm").read_bytes())
        self.assertIn("valid, occupancy map: 3 x 2 cells of 0.05 m", run("validate", yaml).stdout)

    def test_the_bad_files_of_the_corpus(self):
        for kind in ("tum", "relations", "g2o", "pgm", "yaml"):
            folder = SOURCE / "tests/corpus" / kind
            rows = (folder / "bad.tsv").read_text().splitlines()[1:]
            expected = [f"{folder / 'bad' / name}{message}" for name, message in
                        (row.split("\t") for row in rows)]
            done = run("validate", *(folder / "bad" / row.split("\t")[0] for row in rows))
            self.assertEqual((done.returncode, done.stdout), (65, ""))
            self.assertEqual(done.stderr.splitlines(), expected)

    @unittest.skipUnless((DATA / "aces").exists(), "the data are not here")
    def test_files_of_others(self):
        done = run("validate", DATA / "aces/aces.gmapping.txt.xz", DATA / "intel/intel.relations.xz",
                   DATA / "grids/aces.pgm.xz")
        self.assertEqual(done.returncode, 0, done.stderr)
        for text in ("valid, reference: 440 poses", "valid, relations: 2984",
                     "valid, picture: 1174 x 1154 pixels"):
            self.assertIn(text, done.stdout)


class Help(ProgramTest):
    def test_it_has_examples(self):
        self.check_help("evaluate")


if __name__ == "__main__":
    unittest.main(argv=[sys.argv[0], *sys.argv[3:]])

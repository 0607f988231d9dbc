"""From a log to a report, in simulated buildings: run_test.py PROGRAM SOURCE_FOLDER [options]."""

import json
import pathlib
import re
import struct
import subprocess
import sys
import tempfile
import unittest
import xml.etree.ElementTree as xml

from program import PROGRAM, SOURCE, Folder, run, shown_in_readme
from routes import bad_routes

OF_A_MODEL = {"trajectory.tum", "map.pgm", "map.yaml", "map.png", "layout.g2o", "map.graphml",
              "map.dot", "routes.geojson", "routes.osm"}  # fmt: skip
OF_A_RUN = {"log.trace.json", "maps.json", "report.html"}


def drive(folder, seed):
    """Four visits in an office of at most six places."""
    log = folder / f"office-{seed}.log"
    done = run("simulate", "--building", "office", "--width", "3", "--height", "2", "--travels",
               "3", "--seed", seed, "-o", log)
    assert done.returncode == 0, done.stderr
    return log


def scans(log):
    return [line for line in log.read_text().splitlines() if line.startswith("FLASER ")]


def contents(folder):
    return {str(file.relative_to(folder)): file.read_bytes()
            for file in folder.rglob("*") if file.is_file()}


def results(folder):
    """Names of what lies in the folder itself, and of each model."""
    return {name: {file.name for file in (folder / name).iterdir() if file.is_file()}
            for name in [".", *(entry.name for entry in folder.glob("model-*"))]}


def numbers(file, word):
    return [[float(number) for number in line.split()[1:]]
            for line in file.read_text().splitlines() if line.startswith(word + " ")]


class Office(unittest.TestCase):
    """Of this drive two maps are left: one goes round where the robot did not, and is simpler."""

    @classmethod
    def setUpClass(cls):
        cls.temporary = tempfile.TemporaryDirectory()
        cls.addClassCleanup(cls.temporary.cleanup)
        cls.home = pathlib.Path(cls.temporary.name)
        cls.log = drive(cls.home, 6)
        cls.folder = cls.home / "out"
        cls.done = run("run", cls.log, "-o", cls.folder)
        assert cls.done.returncode == 0, cls.done.stderr
        cls.maps = json.loads((cls.folder / "maps.json").read_text())

    def again(self, *options, folder="other", log=None):
        done = run("run", log or self.log, "-o", self.home / folder, *options)
        return done, self.home / folder

    def test_minimal_models_searched_for_are_drawn_as_those_listed(self):
        minimal = ["--rank", "minimal"]
        done, searched = self.again(*minimal, folder="searched")
        other, listed = self.again(*minimal, "--max-hypotheses", "1000000", folder="listed")
        self.assertEqual((done.returncode, other.returncode), (0, 0), done.stderr)
        one, two = contents(searched), contents(listed)
        maps, of_list = json.loads(one.pop("maps.json")), json.loads(two.pop("maps.json"))
        self.assertEqual((maps["consistent"], maps["per_visit"]), (None, None))
        for key in ("complete", "minimal", "maps", "ranked"):
            self.assertEqual(maps[key], of_list[key], key)
        self.assertIn("simplest were searched for", one.pop("report.html").decode())
        two.pop("report.html")
        self.assertEqual(one, two)
        self.assertEqual(run("validate", searched / "maps.json").returncode, 0)

    def test_a_search_that_is_stopped_says_so(self):
        done, folder = self.again("--rank", "minimal", "--time-limit", "0", folder="stopped")
        self.assertEqual(done.returncode, 2)
        self.assertIn("stopped by time limit", done.stdout)
        maps = json.loads((folder / "maps.json").read_text())
        self.assertEqual((maps["complete"], maps["stopped_by"], maps["maps"]),
                         (False, "time limit", []))

    def test_all_files_are_there(self):
        self.assertEqual(results(self.folder),
                         {".": OF_A_RUN | OF_A_MODEL, "model-2": OF_A_MODEL})
        visits = {"perception", *(f"visit-{k}" for k in range(4))}
        self.assertEqual({file.stem for file in (self.folder / "log.lpm").iterdir()}, visits)

    def test_another_question_takes_up_what_was_perceived(self):
        _, folder = self.again(folder="twice")
        whole = contents(folder)
        done, folder = self.again(folder="twice")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn("places as perceived before", done.stdout)
        self.assertEqual(contents(folder), whole)
        done, folder = self.again("--afresh", folder="twice")
        self.assertNotIn("places as perceived before", done.stdout)
        self.assertEqual(contents(folder), whole)
        assumed = ["--assume", "differ(0, 1)", "--models", "1"]
        done, folder = self.again(*assumed, folder="twice")
        self.assertIn("places as perceived before", done.stdout)
        _, other = self.again(*assumed, folder="assumed")
        self.assertEqual(contents(folder), contents(other))

    def test_a_trace_that_is_told_gives_its_own_map(self):
        trace = self.folder / "log.trace.json"
        done, folder = self.again("--trace", trace, folder="told")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn("places as told by", done.stdout)
        told, whole = contents(folder), contents(self.folder)
        for file in (told, whole):
            file.pop("log.lpm/perception.json")
        page = told.pop("report.html").decode()
        self.assertIn("the visits are as told by ", page)
        self.assertNotIn("the visits are as told by ", whole.pop("report.html").decode())
        self.assertEqual(told, whole)
        done, folder = self.again(folder="told")
        self.assertEqual(done.returncode, 65)
        self.assertIn("log.trace.json: found a trace that was told; expected --trace", done.stderr)
        self.assertEqual(contents(folder)["log.trace.json"], told["log.trace.json"])
        edited = self.home / "edited.trace.json"
        visits = json.loads(trace.read_text())
        visits["visits"].pop()
        visits["visits"][-1].pop("left_by")
        edited.write_text(json.dumps(visits))
        lpm = ["--trace", edited, "--lpm", self.folder / "log.lpm"]
        done, folder = self.again(*lpm, folder="edited")
        self.assertEqual(done.returncode, 0, done.stderr)
        maps = json.loads((folder / "maps.json").read_text())
        self.assertEqual(len(maps["ranked"][0]["visits"]), 3)
        visits["visits"][1].pop("displacement")
        edited.write_text(json.dumps(visits))
        done, folder = self.again(*lpm, folder="refused")
        self.assertEqual((done.returncode, folder.exists()), (65, False))
        self.assertIn(":/visits/1/displacement: found nothing; expected ", done.stderr)
        done, _ = self.again("--lpm", self.folder / "log.lpm", folder="refused")
        self.assertEqual(done.returncode, 64)

    def test_they_are_valid(self):
        files = [self.folder / name
                 for name in ("log.trace.json", "maps.json", "log.lpm/perception.json")]
        for folder in (self.folder, self.folder / "model-2"):
            files += [folder / name for name in
                      ("trajectory.tum", "map.yaml", "map.pgm", "layout.g2o")]
            xml.parse(folder / "map.graphml")
            self.assertIn("graph", (folder / "map.dot").read_text())
            xml.parse(folder / "routes.osm")
            self.assertEqual(bad_routes(folder), [])
            self.assertIn("features", json.loads((folder / "routes.geojson").read_text()))
        done = run("validate", *files)
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        for visit in json.loads((self.folder / "log.trace.json").read_text())["visits"]:
            self.assertTrue((self.folder / visit["lpm"]).is_file())

    def test_a_pose_a_scan_with_the_stamps_of_the_log(self):
        stamps = [float(line.split()[-1]) for line in scans(self.log)]
        for model in (".", "model-2"):
            text = (self.folder / model / "trajectory.tum").read_text()
            lines = [line for line in text.splitlines() if not line.startswith("#")]
            self.assertEqual([float(line.split()[0]) for line in lines], stamps)

    def test_the_picture_is_as_large_as_the_map(self):
        size = (self.folder / "map.pgm").read_bytes().split(None, 3)[1:3]
        png = (self.folder / "map.png").read_bytes()
        self.assertEqual(struct.unpack(">II", png[16:24]), tuple(map(int, size)))

    def test_the_plausible_map_ranks_before_the_simpler_one(self):
        best, next_one = self.maps["ranked"]
        self.assertEqual(self.maps["consistent"], 2)
        self.assertEqual((best["plausible"], next_one["plausible"]), (True, False))
        self.assertLess(len(next_one["paths"]), len(best["paths"]))
        self.assertEqual([one["visits"] for one in self.maps["maps"]], [next_one["visits"]])
        self.assertIn("   2 implausible", self.done.stdout)
        self.assertIn("rank 1 has its visits at places 0 1 2 3\n", self.done.stdout)

    def test_layouts_agree_with_the_maps_file(self):
        for ranked, model in zip(self.maps["ranked"], (".", "model-2")):
            file = self.folder / model / "layout.g2o"
            places = [[place[key] for key in ("x_m", "y_m", "heading_rad")]
                      for place in ranked["layout"]]
            self.assertEqual([line[1:] for line in numbers(file, "VERTEX_SE2")], places)
            travels = [[one["from"], one["to"]] for one in ranked["displacements"]]
            self.assertEqual([line[:2] for line in numbers(file, "EDGE_SE2")], travels)
            self.assertEqual(numbers(file, "FIX"), [[0]])

    def test_the_report_needs_nothing_else(self):
        text = (self.folder / "report.html").read_text()
        for element in xml.fromstring(text.replace("<!DOCTYPE html>", "")).iter():
            self.assertNotRegex(element.tag, r"(script|link|iframe|object|embed)$")
            for name, value in element.attrib.items():
                self.assertFalse(name.startswith("on"), name)
                if name.endswith(("src", "href")):
                    self.assertRegex(value, r"^(#|data:)")
        self.assertNotRegex(text, r"@import|url\(")
        for decided in ("axioms", "planarity", "preference", "likelihood"):
            self.assertIn(f"<b>{decided}</b>", text)

    def test_same_log_same_bytes(self):
        done, folder = self.again("--afresh")
        self.assertEqual(done.stdout.replace("other", "out"), self.done.stdout)
        self.assertEqual(contents(folder), contents(self.folder))

    def test_progress_by_stage(self):
        stages = re.findall(r"^(\w+): \d+\.\d s$", self.done.stderr, re.MULTILINE)
        self.assertEqual(stages, ["perceive", "grow", "rank", "draw"])

    def test_fewer_models_replace_an_earlier_run_and_leave_what_is_not_its(self):
        folder = self.home / "used"
        (folder / "model-2").mkdir(parents=True)
        (folder / "model-3").mkdir()
        for name in ("notes.txt", "model-2/map.png", "model-3/mine.txt", "model-3/map.png"):
            (folder / name).write_text("kept, if it is not a name of ours")
        done, _ = self.again("--models", "1", "--rank", "minimal", "--json", folder="used")
        # The one minimal model, though it is implausible.
        model, = json.loads(done.stdout)["models"]
        self.assertEqual((model["visits"], model["plausible"]), ([0, 1, 2, 0], False))
        self.assertEqual(results(folder), {".": OF_A_RUN | OF_A_MODEL | {"notes.txt"},
                                           "model-3": {"mine.txt"}})

    def test_planar_maps_and_the_cells_asked_for(self):
        done, folder = self.again("--planar", "--resolution", "0.2", "--certify", "0", "--json")
        found = json.loads(done.stdout)
        self.assertEqual(found["explained_visits"], 4)
        self.assertEqual(found["consistent"], 2)
        self.assertEqual((found["scans"], found["complete"]), (len(scans(self.log)), True))
        self.assertEqual([one["visits"] for one in found["models"]],
                         [one["visits"] for one in self.maps["ranked"]])
        options = json.loads((folder / "maps.json").read_text())["options"]
        self.assertEqual((options["planar"], options["certify_s"]), (True, 0))
        self.assertIn("resolution: 0.2\n", (folder / "map.yaml").read_text())
        fine, coarse = ((f / "map.pgm").stat().st_size for f in (self.folder, folder))
        self.assertLess(coarse, fine / 10)

    def test_a_limit_ends_the_run_with_what_is_known(self):
        done, folder = self.again("--max-hypotheses", "1")
        self.assertEqual(done.returncode, 2)
        self.assertIn("stopped by limit of 1 hypotheses before visit 3", done.stdout)
        maps = json.loads((folder / "maps.json").read_text())
        self.assertEqual((maps["complete"], maps["explained"]), (False, 3))
        self.assertEqual(maps["ranked"][0]["visits"], [0, 1, 2])
        self.assertEqual(run("validate", folder / "maps.json").returncode, 0)
        self.assertEqual(len(numbers(folder / "layout.g2o", "VERTEX_SE2")), 3)
        self.assertIn("The maps of the first 3 of 4 visits are known",
                      (folder / "report.html").read_text())

    def test_a_bad_log_changes_nothing(self):
        lines = self.log.read_text().splitlines()
        bad = self.home / "bad.log"
        bad.write_text("\n".join(lines[:500] + ["FLASER 180 much"] + lines[500:]))
        short = self.home / "short.log"
        short.write_text("\n".join(lines[:12]))
        before = contents(self.folder)
        for folder in ("out", "none"):
            for log, why in ((bad, "bad.log:501: found"), (short, "expected a drive that visits"),
                             (self.home / "missing.log", "missing.log: found no such file")):
                done, _ = self.again(folder=folder, log=log)
                self.assertEqual((done.returncode, done.stdout), (65, ""))
                self.assertRegex(done.stderr, r"^asterism: [^\n]+\n$")
                self.assertIn(why, done.stderr)
        self.assertEqual(contents(self.folder), before)
        self.assertFalse((self.home / "none").exists())

    def test_a_folder_that_cannot_be(self):
        for folder in (self.log.name, self.log.name + "/below"):
            done, _ = self.again(folder=folder)
            self.assertEqual((done.returncode, done.stdout), (70, ""))
            self.assertRegex(done.stderr, r"^asterism: [^\n]+; expected a folder to write to\n$")


class NoMap(Folder):
    def test_the_parts_that_maps_explain_are_drawn(self):
        # Two drives through two buildings as if they were one: the first robot ends on its way
        # back to a dead end, where the second sees a junction.
        first, second = drive(self.folder, 4), drive(self.folder, 1)
        end_s = float(scans(first)[-1].split()[-1])
        lines = first.read_text().splitlines()
        for words in map(str.split, scans(second)):
            lines.append(" ".join([*words[:-3], str(end_s + 1 + float(words[-3])), words[-2],
                                   str(end_s + 1 + float(words[-1]))]))
        log, out = self.file("two.log", "\n".join(lines) + "\n"), self.folder / "out"
        done = run("run", log, "-o", out)
        self.assertEqual(done.returncode, 1, done.stderr)
        maps = json.loads((out / "maps.json").read_text())
        explained = maps["explained"]
        self.assertEqual((maps["complete"], maps["consistent"], maps["minimal"]), (True, 0, None))
        self.assertEqual(maps["per_visit"].index(0), explained)
        self.assertIn(f"none is left after visit {explained}\nvisit {explained} came by", done.stdout)
        # It is cut where the one drive ends: no segment leads on, and no place is in both parts.
        visits = len(maps["per_visit"])
        self.assertIn(f"ranked: maps in 2 pieces, of visits 0 to {explained - 1} and of visits "
                      f"{explained} to {visits - 1}\n", done.stdout)
        for ranked in maps["ranked"]:
            self.assertEqual(len(ranked["visits"]), visits)
            self.assertEqual(ranked["visits"][explained], max(ranked["visits"][:explained]) + 1)
            self.assertEqual((ranked["left"][explained - 1], ranked["entered"][explained]),
                             (None, None))
        self.assertIn("The models are in 2 pieces", (out / "report.html").read_text())
        self.assertEqual(run("validate", out / "maps.json").returncode, 0)
        # The trajectory goes on to the end of the log all the same.
        poses = [line for line in (out / "trajectory.tum").read_text().splitlines()
                 if not line.startswith("#")]
        self.assertEqual(len(poses), len(scans(log)))
        done = run("run", log, "-o", out, "--json")
        self.assertEqual(json.loads(done.stdout)["explained_visits"], explained)
        self.assertIn(f"visit {explained} came by", json.loads(done.stdout)["why"])
        self.assertEqual(json.loads(done.stdout)["parts"],
                         [[0, explained - 1], [explained, visits - 1]])
        done = run("run", log, "-o", self.folder / "searched", "--rank", "minimal")
        self.assertEqual(done.returncode, 1, done.stderr)
        self.assertIn(f"none is left after visit {explained}\nvisit {explained} came by", done.stdout)
        searched = json.loads((self.folder / "searched/maps.json").read_text())
        self.assertEqual((searched["consistent"], searched["explained"]), (0, explained))
        self.assertEqual({len(ranked["visits"]) for ranked in searched["ranked"]}, {visits})


class Readme(Folder):
    def test_what_it_shows_is_what_comes_out(self):
        shown = shown_in_readme("simulate", "run", "evaluate")
        self.assertGreaterEqual(len(shown), 3)
        for command, output in shown:
            done = subprocess.run([PROGRAM, *command], capture_output=True, text=True,
                                  cwd=self.folder, timeout=600)
            self.assertEqual((done.returncode, done.stdout.rstrip()), (0, output), command)

    def test_it_names_the_files_of_a_run(self):
        text = (SOURCE / "README.md").read_text()
        for name in OF_A_RUN | OF_A_MODEL:
            self.assertIn(f"`{name}`", text)


class Usage(Folder):
    def test_it_is_refused(self):
        log = self.file("a.log", "")
        for options in ([], [log], ["-o", self.folder], [log, "-o"], [log, "-o", "x", "--models", 0],
                        [log, "-o", "x", "--rank", "best"], [log, "-o", "x", "--resolution", "0"],
                        [log, "-o", "x", "--min-gateway-width-m", "-1"], [log, "-o", "x", "--all"],
                        [log, "-o", "x", "--time-limit", "nan"]):
            with self.subTest(options=options):
                self.refused(64, "run", *options)

    def test_help_has_examples(self):
        self.check_help("run")


if __name__ == "__main__":
    unittest.main(argv=[sys.argv[0], *sys.argv[3:]])

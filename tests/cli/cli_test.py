"""Runs the program as a user would: cli_test.py PROGRAM SOURCE_FOLDER [unittest options]."""

import json
import pathlib
import re
import shutil
import subprocess
import sys
import time
import unittest
import xml.etree.ElementTree as xml

from program import (PROGRAM, SOURCE, TRACES, BigTrace, Folder, ProgramTest, run, shown_in,
                     shown_in_readme, trace_text)

EXPECTED = json.loads((TRACES / "expected.json").read_text())
ACES = str(TRACES / "aces-stubs.trace.json")


class Maps(Folder):
    def test_every_known_number(self):
        for name, known in EXPECTED.items():
            for planar in ("all", "planar"):
                with self.subTest(trace=name, maps=planar):
                    options = ["--planar"] if planar == "planar" else []
                    done = run("map", TRACES / f"{name}.trace.json", "--json", "-", *options)
                    self.assertEqual((done.returncode, done.stderr), (0, ""))
                    maps = json.loads(done.stdout)
                    want = known[planar]
                    self.assertEqual(maps["consistent"], want["consistent"])
                    self.assertEqual(maps["per_visit"], want["per_visit"])
                    minimal = dict(want["minimal"])
                    visits = minimal.pop("visits")
                    self.assertEqual(maps["minimal"], {**minimal, "certified": True})
                    self.assertEqual([m["visits"] for m in maps["maps"]], visits)

    def test_the_solver_alone_gives_the_same_file(self):
        native, solver, both = (
            run("map", ACES, "--planar", "--json", "-", "--check", check).stdout
            for check in ("native", "solver", "both")
        )
        self.assertEqual(native.replace('"native"', '"solver"'), solver)
        self.assertEqual(native.replace('"native"', '"both"'), both)

    def test_all_maps_are_listed_sorted_and_valid(self):
        file = self.folder / "all.maps.json"
        self.assertEqual(run("map", ACES, "--all", "--json", file).returncode, 0)
        maps = json.loads(file.read_text())["maps"]
        self.assertEqual(len(maps), 107)
        keys = [(m["visits"], [-1 if e is None else e for e in m["entered"]]) for m in maps]
        self.assertEqual(keys, sorted(keys))
        self.assertEqual(run("validate", file).returncode, 0)

    def test_the_text_spells_out_some_of_all_maps_and_counts_the_others(self):
        text = run("map", ACES, "--all", "--certify", "0").stdout
        self.assertIn("\nmap 19\n", text)
        self.assertTrue(text.endswith("\n(87 more: see --json)\n"))

    def test_same_bytes_twice(self):
        first, second = (run("map", ACES, "--all", "--json", "-").stdout for _ in range(2))
        self.assertEqual(first, second)

    def test_the_text_says_what_matters(self):
        text = run("map", ACES, "--planar").stdout
        self.assertIn("55 planar maps explain the trace", text)
        self.assertIn("1 minimal model: 6 paths, 9 places; certified by the solver", text)
        self.assertIn("place 8: visits 9, 11, 13,", text)
        self.assertIn("path 0: | 0 - 8 - 4 |", text)

    def test_not_certified_is_said(self):
        done = run("map", ACES, "--certify", "0", "--json", "-")
        self.assertFalse(json.loads(done.stdout)["minimal"]["certified"])
        self.assertIn("not certified", run("map", ACES, "--certify", "0").stdout)

    def test_no_map(self):
        # Back along the only segment there is a dead end; it cannot have become a crossing.
        contradiction = trace_text(
            {"star": "a+1 a-0", "left_by": "a+"},
            {"star": "a+1 b+1 a-1 b-1", "entered_by": "a+", "left_by": "a+"},
            {"star": "a+1 b+1 a-1 b-1", "entered_by": "a+"},
        )
        file = self.file("no.trace.json", contradiction)
        done = run("map", file)
        self.assertEqual(done.returncode, 1)
        self.assertIn("no map explains the trace: none is left after visit 2", done.stdout)
        maps = json.loads(run("map", file, "--json", "-").stdout)
        self.assertEqual((maps["consistent"], maps["minimal"], maps["maps"]), (0, None, []))
        self.assertEqual(maps["per_visit"], [1, 1, 0])

    def test_a_trace_from_stdin(self):
        done = run("map", "-", stdin=pathlib.Path(ACES).read_text())
        self.assertIn("107 maps explain the trace", done.stdout)

    def test_one_visit(self):
        file = self.file("one.trace.json", trace_text({"star": "a+1 a-0"}))
        self.assertIn("1 map explains the trace", run("map", file).stdout)


class Limits(BigTrace):
    def stopped(self, *limit):
        done = run("map", self.big, "--json", "-", *limit)
        maps = json.loads(done.stdout)
        self.assertEqual((done.returncode, maps["complete"]), (2, False))
        self.assertEqual((maps["consistent"], maps["minimal"]), (None, None))
        return maps

    def test_hypotheses(self):
        maps = self.stopped("--max-hypotheses", "1000")
        self.assertEqual(maps["stopped_by"], "limit of 1000 hypotheses")
        self.assertLessEqual(max(maps["per_visit"]), 1000)
        file = self.file("stopped.maps.json", json.dumps(maps))
        self.assertEqual(run("validate", file).returncode, 0)

    def test_time(self):
        self.assertEqual(self.stopped("--time-limit", "0.3")["stopped_by"], "time limit")

    def test_time_is_asked_for_at_every_visit_however_few_the_maps(self):
        for check in ("native", "solver"):
            self.assertEqual(run("map", ACES, "--check", check, "--time-limit", "0").returncode, 2)

    def test_certification_ends_in_time_though_grounding_is_long(self):
        # Straight on through 200 crossings: a million instances of transitive.
        star = "a+1 b+1 a-1 b-1"
        straight = [{"star": star, "left_by": "a+"}]
        straight += [{"star": star, "entered_by": "a-", "left_by": "a+"}] * 199
        file = self.file("straight.trace.json", trace_text(*straight))
        begin = time.monotonic()
        self.assertIn("not certified within 0.1 s", run("map", file, "--certify", "0.1").stdout)
        self.assertLess(time.monotonic() - begin, 20)

    def test_the_text_says_how_far_it_got(self):
        done = run("map", self.big, "--max-hypotheses", "1000")
        self.assertRegex(done.stdout, r"stopped by limit of 1000 hypotheses before visit \d+ was")

    def test_a_limit_that_is_not_reached_changes_nothing(self):
        limited = run("map", ACES, "--max-hypotheses", "107", "--json", "-")
        self.assertEqual(limited.returncode, 0)
        self.assertEqual(json.loads(limited.stdout)["consistent"], 107)
        self.assertEqual(run("map", ACES, "--max-hypotheses", "106").returncode, 2)


class Axioms(Folder):
    def count(self, *options):
        done = run("map", TRACES / "eight-crossings.trace.json", "--json", "-", *options)
        self.assertEqual(done.returncode, 0, done.stderr)
        return json.loads(done.stdout)["consistent"]

    def test_optional_axioms(self):
        self.assertEqual(self.count("--axiom", "one_segment"), 77)
        self.assertEqual(self.count("--axiom", "one_crossing", "--planar"), 45)

    def test_a_folder_of_ones_own(self):
        folder = self.own_axioms()
        self.assertEqual(self.count("--axioms", folder), 83)
        topological = folder / "topological.smt2"
        text = topological.read_text()
        begin = text.index("(assert (! (forall ((q DState) (r DState) (s DState))")
        topological.write_text(text[:begin])
        self.assertEqual(self.count("--axioms", folder, "--check", "solver"), 92)
        refused = run("map", ACES, "--axioms", folder)
        self.assertEqual(refused.returncode, 65)
        self.assertIn("expected --check solver", refused.stderr)

    def test_terms_without_end_are_refused(self):
        folder = self.own_axioms()
        (folder / "own.smt2").write_text(
            "(assert (! (forall ((d DirectedPath) (p Place)) (=> (on d p) (on (opp d) p)))\n"
            " :named both_ways))")
        done = run("map", ACES, "--axioms", folder, "--check", "solver")
        self.assertEqual((done.returncode, done.stdout), (65, ""))
        self.assertIn("own.smt2:1: found terms of opp without end", done.stderr)

    def test_another_preference(self):
        folder = self.own_axioms()
        preference = folder / "preference.smt2"
        preference.write_text("(set-info :minimise (place path))\n")
        done = run("map", TRACES / "grid-3x3.trace.json", "--axioms", folder, "--json", "-")
        maps = json.loads(done.stdout)
        self.assertEqual(maps["options"]["preference"], ["place", "path"])
        self.assertTrue(maps["minimal"]["certified"])

    def test_the_table(self):
        table = run("axioms").stdout
        for name in ("deterministic", "at", "along", "irreflexive", "star_binding"):
            self.assertRegex(table, rf"(?m)^{name} ")
        self.assertIn("[BMK10, (8)]", table)
        self.assertIn("path, place", table)
        self.assertIn("one_crossing", run("axioms", "--axiom", "one_crossing").stdout)

    def test_why_not(self):
        done = run("map", ACES, "--why-not", "0,1,2,3,4,5,6,7,1")
        self.assertEqual(done.returncode, 1)
        self.assertIn("reversible", done.stdout)
        self.assertEqual(run("map", ACES, "--why-not", "0,1,2,3,0").returncode, 0)
        planar = run("map", ACES, "--planar", "--why-not", "0,1,2,3,4,5,6,7,0,8,2,8,4,8,6")
        self.assertIn("planarity", planar.stdout)
        for places in ("0", "0,2", "0,1,2,3,9", "1,0"):
            self.assertEqual(run("map", ACES, "--why-not", places).returncode, 65, places)


class Problems(Folder):
    def verdicts(self, solver, folder):
        if not shutil.which(solver):
            self.skipTest(f"{solver} is not installed")
        files = sorted(folder.glob("*.smt2"))
        self.assertTrue(files)
        return {
            f.name: subprocess.run([solver, f], capture_output=True, text=True).stdout.strip()
            for f in files
        }

    def test_maps_are_satisfiable_to_other_solvers(self):
        run("map", ACES, "--export-smt2", self.folder / "p")
        for solver in ("z3", "cvc5"):
            self.assertEqual(set(self.verdicts(solver, self.folder / "p").values()), {"sat"})

    def test_what_is_dropped_is_not(self):
        run("map", ACES, "--why-not", "0,1,2,3,4,5,6,7,1", "--export-smt2", self.folder / "p")
        for solver in ("z3", "cvc5"):
            self.assertEqual(set(self.verdicts(solver, self.folder / "p").values()), {"unsat"})


class Drawings(Folder):
    def test_one_a_model_and_a_chart(self):
        self.assertEqual(run("map", ACES, "--svg", self.folder / "svg").returncode, 0)
        files = sorted(f.name for f in (self.folder / "svg").iterdir())
        self.assertEqual(files, ["hypotheses.svg"] + [f"model-{i}.svg" for i in range(6)])
        for name in files:
            root = xml.parse(self.folder / "svg" / name).getroot()
            self.assertEqual(root.tag, "{http://www.w3.org/2000/svg}svg")
        chart = (self.folder / "svg/hypotheses.svg").read_text()
        self.assertIn("all: 107", chart)
        self.assertIn("planar: 55", chart)


    def test_nothing_stale_is_left(self):
        for options in ([], ["--planar"]):
            run("map", ACES, "--svg", self.folder, "--export-smt2", self.folder, *options)
        self.assertEqual(sorted(f.name for f in self.folder.iterdir()),
                         ["hypotheses.svg", "map-0.smt2", "model-0.svg"])


class Simulations(Folder):
    def test_the_true_map_is_never_dropped(self):
        for world in ("grid", "corridors"):
            for seed in range(3):
                with self.subTest(world=world, seed=seed):
                    file = self.folder / "walk.trace.json"
                    true = self.folder / "true.maps.json"
                    made = run("simulate", "--world", world, "--seed", seed, "--travels", "12",
                               "-o", file, "--true-map", true)
                    self.assertEqual(made.returncode, 0, made.stderr)
                    self.assertEqual(run("validate", file, true).returncode, 0)
                    listed = json.loads(
                        run("map", file, "--planar", "--all", "--json", "-").stdout)["maps"]
                    self.assertIn(json.loads(true.read_text())["maps"][0], listed)

    def test_same_seed_same_bytes(self):
        self.assertEqual(run("simulate", "--seed", "5").stdout, run("simulate", "--seed", "5").stdout)
        self.assertNotEqual(run("simulate", "--seed", "5").stdout,
                            run("simulate", "--seed", "6").stdout)


class BadInput(Folder):
    def test_traces(self):
        bad = self.file("bad.trace.json", trace_text({"star": "a+1 a-0", "left_by": "a-"}))
        message = self.refused(65, "map", bad, "--json", self.folder / "out.json")
        self.assertRegex(message, r"bad\.trace\.json:/visits/0/left_by: found .*; expected ")
        self.assertFalse((self.folder / "out.json").exists())
        self.refused(65, "map", self.folder / "missing.trace.json")
        self.refused(65, "map", self.folder)
        self.refused(65, "map", self.file("empty.trace.json", ""))

    def test_axioms(self):
        self.refused(65, "map", ACES, "--axiom", "no_such")
        self.refused(65, "map", ACES, "--axiom", "../causal")
        self.refused(65, "map", ACES, "--axioms", self.folder / "missing")
        self.refused(65, "axioms", "--axioms", self.folder)
        self.file("bad.smt2", "(assert true)")
        self.assertIn("bad.smt2:1: found", self.refused(65, "axioms", "--axioms", self.folder))

    def test_usage(self):
        for arguments in ([], ["map"], ["fly"], ["map", ACES, "--check", "oracle"],
                          ["map", ACES, "--certify", "-1"], ["map", ACES, "--time-limit", "x"],
                          ["map", ACES, "--time-limit", "nan"], ["map", ACES, "--certify", "inf"],
                          ["map", ACES, "--max-hypotheses", "-1"],
                          ["map", ACES, "--why-not", "0,-1"],
                          ["map", ACES, "--why-not", "0,1", "--max-hypotheses", "1"],
                          ["map", ACES, "--why-not", "0,1", "--json", "-"],
                          ["simulate", "--travels", "-1"], ["simulate", "--missing", "nan"],
                          ["simulate", "--world", "moon"], ["simulate", "--building", "moon"],
                          ["simulate", "--mirrored"], ["simulate", "--turned", "nan"],
                          ["simulate", "--building", "office", "--world", "grid"], ["map", ACES, "--unknown"]):
            with self.subTest(arguments=arguments):
                self.refused(64, *arguments)

    def test_what_cannot_be_written(self):
        done = run("map", ACES, "--json", self.folder / "no/such/folder.json")
        self.assertNotEqual(done.returncode, 0)
        self.assertRegex(done.stderr, r"^asterism: [^\n]+\n$")
        done = run("map", ACES, "--svg", "/dev/null/folder")
        self.assertEqual(done.returncode, 70)
        self.assertRegex(done.stderr, r"^asterism: /dev/null/folder: found [^\n]+\n$")

    def test_a_result_that_got_lost(self):
        for arguments in (["map", ACES, "--json", "-"], ["map", ACES], ["simulate"], ["axioms"]):
            with self.subTest(arguments=arguments):
                self.assertRegex(self.check_lost_result(*arguments),
                                 r"^asterism: stdout: found [^\n]+\n$")

    def test_validate_goes_on_after_a_bad_file(self):
        bad = self.file("bad.trace.json", "{")
        done = run("validate", bad, ACES)
        self.assertEqual(done.returncode, 65)
        self.assertIn("bad.trace.json:", done.stderr)
        self.assertIn("valid, trace aces-stubs: 15 visits", done.stdout)

    def test_validate_reads_logs(self):
        corpus = SOURCE / "tests/corpus/carmen"
        for name in ("flaser.log", "flaser.log.gz", "flaser.log.xz"):
            done = run("validate", corpus / "good" / name)
            self.assertEqual(done.returncode, 0)
            self.assertIn("valid, log: 40 scans of 3 beams, 7.8 s, 3.9 m", done.stdout)
        done = run("validate", corpus / "bad/range_nan.log")
        self.assertEqual(done.returncode, 65)
        self.assertIn('range_nan.log:2: found "nan"; expected range 2 of 3', done.stderr)


class Readme(Folder):
    def test_what_it_shows_is_what_comes_out(self):
        shown = shown_in_readme("map", "axioms", "validate")
        self.assertTrue(shown)
        refusals = [one for one in shown_in("docs/queries.md", "map") if "--why-not" in one[0]]
        self.assertTrue(refusals)
        for command, output in shown + refusals:
            done = subprocess.run([PROGRAM, *command], capture_output=True, text=True, cwd=SOURCE,
                                  timeout=300)
            self.assertEqual(done.stdout.rstrip(), output, command)

    def test_the_figures_to_reproduce_are_what_comes_out(self):
        shown = shown_in("docs/reproduce.md", "map", "test")
        self.assertEqual(len(shown), 2)
        for command, output in shown:
            done = subprocess.run([PROGRAM, *command], capture_output=True, text=True, cwd=SOURCE,
                                  timeout=300)
            self.assertTrue(done.stdout.startswith(output + "\n"), command)

    def test_its_pictures_are_what_comes_out(self):
        run("map", SOURCE / "examples/aces-stubs.trace.json", "--planar", "--svg", self.folder)
        for shown, drawn in (("aces-planar", "model-0"), ("aces-hypotheses", "hypotheses")):
            self.assertEqual((SOURCE / f"docs/{shown}.svg").read_text(),
                             (self.folder / f"{drawn}.svg").read_text())


class Help(ProgramTest):
    def test_each_command_has_examples(self):
        for command in ("map", "simulate", "axioms", "validate"):
            self.check_help(command)

    def test_version_names_the_libraries(self):
        done = run("--version")
        self.assertRegex(done.stdout, r"(?m)^asterism \d+\.\d+\.\d+$")
        for library in ("z3", "boost", "nlohmann-json", "fmt", "cli11", "zlib", "liblzma", "libpng"):
            self.assertRegex(done.stdout, rf"(?m)^{re.escape(library)} \d")


if __name__ == "__main__":
    unittest.main(argv=[sys.argv[0], *sys.argv[3:]])

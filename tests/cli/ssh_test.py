"""Maps traces of the basic SSH: ssh_test.py PROGRAM SOURCE_FOLDER [unittest options]."""

import json
import re
import shutil
import subprocess
import sys
import unittest
import xml.etree.ElementTree as xml

from program import SOURCE, Folder, ProgramTest, as_json, run, shown_in

SQUARE = SOURCE / "examples/05_square.trace.json"


def experience(text, name="t"):
    return json.dumps({"format": "asterism/trace", "version": 1, "kind": "ssh", "name": name,
                       "experience": text.split()})


def maps_of(*arguments):
    return as_json("map", *arguments)


class Maps(Folder):
    def test_the_square_is_closed(self):
        code, found = maps_of(SQUARE)
        self.assertEqual((code, found["kind"], found["trace"]), (0, "ssh", "square"))
        self.assertEqual(found["experience"], json.loads(SQUARE.read_text())["experience"])
        self.assertEqual((found["consistent"], found["per_view"]), (2, [1, 1, 1, 1, 1, 2, 3, 5, 2]))
        self.assertEqual(found["minimal"], {"paths": 4, "places": 4, "count": 1, "certified": True})
        (only,) = found["maps"]
        self.assertEqual(only["dstates"], [0, 1, 2, 3, 4, 5, 6, 7, 0])
        self.assertEqual(only["places"], [0, 1, 1, 2, 2, 3, 3, 0])

    def test_who_decides_changes_nothing(self):
        for options in ([], ["--planar"], ["--axiom", "one_segment", "--axiom", "one_crossing"]):
            native, solver, both = (
                run("map", SQUARE, "--all", "--json", "-", "--check", check, *options).stdout
                for check in ("native", "solver", "both"))
            self.assertEqual(native.replace('"native"', '"solver"'), solver)
            self.assertEqual(native.replace('"native"', '"both"'), both)

    def test_all_maps_are_listed_sorted_and_valid(self):
        trace = self.file("walk.trace.json", experience(
            "a travel a turn:left a travel a turn_around a travel a turn:left a turn:right a", "walk"))
        file = self.folder / "all.maps.json"
        self.assertEqual(run("map", trace, "--all", "--json", file).returncode, 0)
        found = json.loads(file.read_text())
        namings = [m["dstates"] for m in found["maps"]]
        self.assertEqual(namings, sorted(namings))
        self.assertEqual(len(namings), found["consistent"])
        self.assertGreater(len(namings), 20)
        done = run("validate", file, trace)
        self.assertEqual(done.returncode, 0)
        self.assertEqual(done.stdout,
                         f"{file}: valid, maps of walk, basic SSH: {len(namings)} listed\n"
                         f"{trace}: valid, trace walk, basic SSH: 8 views\n")
        text = run("map", trace, "--all", "--certify", "0").stdout
        self.assertIn("\nmap 19\n", text)
        self.assertTrue(text.endswith(f"\n({len(namings) - 20} more: see --json)\n"))
        self.assertIn("; not certified\n", text)

    def test_a_trace_from_stdin_and_the_same_bytes(self):
        first, second = (run("map", "-", stdin=SQUARE.read_text()).stdout for _ in range(2))
        self.assertEqual(first, second)
        self.assertEqual(first, run("map", SQUARE).stdout)

    def test_axioms_of_ones_own_need_the_solver(self):
        folder = self.folder / "axioms"
        shutil.copytree(SOURCE / "axioms", folder, ignore=shutil.ignore_patterns("*.?pp"))
        topological = folder / "topological.smt2"
        text = topological.read_text()
        begin = text.index("; irreflexive")
        topological.write_text(text[:begin] + text[text.index("; opposite", begin):])
        trace = self.file("loop.trace.json", experience("a travel a"))
        refused = run("map", trace, "--axioms", folder)
        self.assertEqual((refused.returncode, refused.stdout), (65, ""))
        self.assertIn("--check solver", refused.stderr)
        _, found = maps_of(trace, "--axioms", folder, "--check", "solver", "--all")
        self.assertEqual([m["dstates"] for m in found["maps"]], [[0, 0], [0, 1]])
        self.assertEqual(found["minimal"], {"paths": 1, "places": 1, "count": 1, "certified": True})
        # A travel that leads to where it began is drawn as a loop.
        drawn = self.folder / "drawn"
        run("map", trace, "--axioms", folder, "--check", "solver", "--svg", drawn)
        curves = [path.get("d") for path in xml.parse(drawn / "model-0.svg").iter()
                  if path.tag.endswith("path")]
        self.assertRegex(curves[0], r"^M36\.0 [0-9.]+C.* 36\.0 [0-9.]+$")

    def test_views_that_cannot_be_told_from_a_terminal_s_orders_are_shown_safely(self):
        trace = self.file("t.trace.json", json.dumps(
            {"format": "asterism/trace", "version": 1, "kind": "ssh", "name": "a\nb",
             "experience": ["\x1b[2J"]}))
        self.assertEqual(run("map", trace, "--certify", "0").stdout.splitlines()[0],
                         "a?b: 1 view, 0 actions")
        self.assertIn('"?[2J"', run("map", trace).stdout)

    def test_drawings(self):
        folder = self.folder / "drawings"
        folder.mkdir()
        (folder / "model-1.svg").write_text("of an earlier run")
        self.assertEqual(run("map", SQUARE, "--svg", folder).returncode, 0)
        self.assertEqual([file.name for file in folder.iterdir()], ["model-0.svg"])
        picture = xml.parse(folder / "model-0.svg").getroot()
        svg = "{http://www.w3.org/2000/svg}"
        self.assertEqual(len(picture.findall(f".//{svg}circle")), 4)
        texts = {text.text for text in picture.iter(f"{svg}text")}
        self.assertLessEqual({"square, minimal model 0 (of 1)", "0", "3", "place 0: views 0, 7, 8"},
                             texts)

    def test_problems_for_other_solvers(self):
        folder = self.folder / "smt2"
        self.assertEqual(run("map", SQUARE, "--all", "--export-smt2", folder).returncode, 0)
        self.assertEqual({file.name for file in folder.iterdir()}, {"map-0.smt2", "map-1.smt2"})
        self.assertIn("(leads d7_0 a2 d0_0)", (folder / "map-0.smt2").read_text())
        if shutil.which("z3"):
            done = subprocess.run(["z3", folder / "map-0.smt2"], capture_output=True, text=True)
            self.assertEqual(done.stdout, "sat\n")


class Limits(Folder):
    def test_a_limit_ends_the_run_in_good_order(self):
        code, found = maps_of(SQUARE, "--max-hypotheses", "3")
        self.assertEqual((code, found["complete"], found["consistent"]), (2, False, None))
        self.assertEqual(found["stopped_by"], "limit of 3 hypotheses")
        self.assertEqual(found["per_view"], [1, 1, 1, 1, 1, 2, 3])
        self.assertEqual((found["minimal"], found["maps"]), (None, []))
        text = run("map", SQUARE, "--max-hypotheses", "3").stdout
        self.assertIn("stopped by limit of 3 hypotheses before view 7 was explained\n", text)
        turns = " ".join(f"a turn:{k}" for k in range(30)) + " a"
        trace = self.file("many.trace.json", experience(turns))
        code, found = maps_of(trace, "--time-limit", "0.2")
        self.assertEqual((code, found["stopped_by"]), (2, "time limit"))
        self.assertEqual(maps_of(SQUARE, "--max-hypotheses", "5", "--time-limit", "100")[0], 0)


class BadInput(Folder):
    def test_what_needs_stars_refuses_it_in_one_line(self):
        self.assertEqual(self.refused(65, "query", SQUARE, "same(0, 1)"),
                         f'asterism: {SQUARE}:/kind: found "ssh"; expected "hssh", a trace with '
                         "stars\n")
        self.assertEqual(self.refused(65, "map", SQUARE, "--why-not", "0,1"),
                         "asterism: --why-not: found a trace of the basic SSH; expected a trace "
                         "with stars\n")

    def test_a_bad_experience(self):
        trace = self.file("bad.trace.json", experience("a travel"))
        self.assertIn("expected an odd number", self.refused(65, "map", trace))
        trace = self.file("bad.trace.json", experience("a fly b"))
        self.assertIn(":/experience/1: found \"fly\"; expected an action", self.refused(65, "map", trace))


class Docs(ProgramTest):
    def test_what_they_show_is_what_comes_out(self):
        self.check_shown(shown_in("docs/ssh.md", "map"))

    def test_the_trace_they_show_is_the_example(self):
        page = (SOURCE / "docs/ssh.md").read_text()
        (shown,) = re.findall(r"(?s)```json\n(.*?)```", page)
        self.assertEqual(shown, SQUARE.read_text())

    def test_the_keys_they_tell_are_there(self):
        page = (SOURCE / "docs/ssh.md").read_text()
        _, found = maps_of(SQUARE)
        keys = set(found) | set(found["maps"][0])
        told = set(re.findall(r"`(\w+)`", page[page.index("## Maps file"):page.index("## From visits")]))
        self.assertEqual(keys - told, {"format", "version", "kind"})


if __name__ == "__main__":
    unittest.main(argv=[sys.argv[0], *sys.argv[3:]])

"""Suites of traces, on the command line: suite_test.py PROGRAM SOURCE_FOLDER [unittest options]."""

import json
import re
import shutil
import sys
import unittest
import xml.etree.ElementTree as xml

from program import SOURCE, TRACES, Folder, ProgramTest, run, shown_in

NAMES = sorted(file.name[: -len(".trace.json")] for file in TRACES.glob("*.trace.json"))


def answered(verdict, holds, of):
    return {"verdict": verdict, "holds": holds, "of": of}


class Suite(Folder):
    def setUp(self):
        super().setUp()
        self.suite = self.folder / "suite"
        self.suite.mkdir()
        self.junit = self.folder / "junit.xml"

    def copy(self, *names):
        for name in names:
            for ending in ("trace", "expect"):
                shutil.copy(TRACES / f"{name}.{ending}.json", self.suite)

    def write(self, name, *cases):
        text = json.dumps({"format": "asterism/expect", "version": 1, "cases": cases})
        (self.suite / f"{name}.expect.json").write_text(text)

    def read(self, name):
        return json.loads((self.suite / f"{name}.expect.json").read_text())["cases"]

    def change(self, name, old, new, times=1):
        file = self.suite / f"{name}.expect.json"
        text = file.read_text()
        self.assertIn(old, text)
        file.write_text(text.replace(old, new, times))

    def ask(self, *options):
        done = run("test", self.suite, "--junit", self.junit, *options)
        self.root = xml.parse(self.junit).getroot()
        return done.returncode, done.stdout, done.stderr

    def elements(self):
        """Of each test case its name and what became of it."""
        return {case.get("name"): [child.tag for child in case] for case in self.root[0]}


class OwnTraces(unittest.TestCase):
    def test_expect_files_say_what_two_programs_agree_on(self):
        expected = json.loads((TRACES / "expected.json").read_text())
        self.assertEqual(sorted(expected), NAMES)
        for name, known in expected.items():
            with self.subTest(name=name):
                cases = json.loads((TRACES / f"{name}.expect.json").read_text())["cases"]
                for case, kind in zip(cases, ("all", "planar")):
                    self.assertEqual(case["options"], {"planar": kind == "planar"})
                    self.assertEqual({key: case[key] for key in known[kind]}, known[kind])
        eight = json.loads((TRACES / "eight-crossings.expect.json").read_text())["cases"]
        self.assertEqual([case["consistent"] for case in eight], [83, 46, 77, 45, 74, 45])

    def test_answers_are_those_of_other_commands(self):
        for file in (*TRACES.glob("*.expect.json"), *(SOURCE / "examples").glob("*.expect.json")):
            trace = str(file).replace(".expect.", ".trace.")
            for case in json.loads(file.read_text())["cases"]:
                with self.subTest(file=file.name, options=case["options"]):
                    options = case["options"]
                    words = ["--planar"] if options["planar"] else []
                    for name in options.get("optional_axioms", []):
                        words += ["--axiom", name]
                    for fact in options.get("assumptions", []):
                        words += ["--assume", fact]
                    maps = json.loads(run("map", trace, "--json", "-", "--certify", "0",
                                          *words).stdout)
                    for key in ("consistent", "per_visit"):
                        self.assertEqual(case[key], maps[key])
                    if maps["minimal"]:
                        maps["minimal"].pop("certified")
                        maps["minimal"]["visits"] = [m["visits"] for m in maps["maps"]]
                    self.assertEqual(case["minimal"], maps["minimal"])
                    for query in case.get("queries", []):
                        over = query.pop("over", "all")
                        answer, = json.loads(run("query", trace, query["query"], "--over", over,
                                                 "--json", "-", *words).stdout)["queries"]
                        self.assertEqual(query, {key: answer[key] for key in query})
                        self.assertEqual(len(query), 4)


class Tested(Suite):
    def test_as_expected(self):
        self.copy(*NAMES)
        code, out, _ = self.ask()
        self.assertEqual(code, 0)
        lines = out.splitlines()
        self.assertEqual(lines[2], "aces-stubs: as expected, 5 cases and 15 queries")
        self.assertEqual([line.split(":")[0] for line in lines[:-1]], NAMES)
        self.assertEqual(lines[-1], "7 traces: 7 as expected")
        self.assertEqual(self.elements(), {name: [] for name in NAMES})
        self.assertEqual(self.root.get("tests"), "7")
        self.assertEqual(self.root.get("failures"), "0")

    def test_by_any_engine(self):
        self.copy("square-three-laps")
        for check in ("solver", "both"):
            self.assertEqual(self.ask("--check", check)[0], 0)

    def test_differences_by_pointer(self):
        self.copy("aces-stubs", "grid-3x3")
        self.change("aces-stubs", '"per_visit": [1, 1, 1, 1, 2, 1, 2, 4, 3, 2, 9, 9, 34, 34, 107]',
                    '"per_visit": [1, 1, 1, 1, 2, 1, 2, 4, 3, 2, 9, 9, 33, 34, 107]')
        self.change("aces-stubs", '"paths": 6', '"paths": 7', 2)
        self.change("aces-stubs", '"verdict": "possible", "holds": 20', '"verdict": "possible", "holds": 21')
        self.change("aces-stubs", "0, 8, 2, 8, 4, 8, 6]", "0, 8, 2, 8, 4, 8, 5]")
        code, out, _ = self.ask()
        self.assertEqual(code, 1)
        row = "1, 1, 1, 1, 2, 1, 2, 4, 3, 2, 9, 9, "
        model = "0, 1, 2, 3, 4, 5, 6, 7, 0, 8, 2, 8, 4, 8, "
        self.assertEqual(out.splitlines(), [
            "aces-stubs: not as expected, 5 cases and 15 queries",
            f"  /cases/0/per_visit: found [{row}34, 34, 107]; expected [{row}33, 34, 107]",
            "  /cases/0/minimal/paths: found 6; expected 7",
            f"  /cases/0/minimal/visits/0: found [{model}6]; expected [{model}5]",
            "  /cases/1/minimal/paths: found 6; expected 7",
            "  /cases/1/queries/0/holds: found 20; expected 21",
            "grid-3x3: as expected, 2 cases",
            "2 traces: 1 as expected, 1 not as expected"])
        self.assertEqual(self.elements(), {"aces-stubs": ["failure"], "grid-3x3": []})
        failure = self.root[0][0][0]
        self.assertIn("/cases/0/minimal/paths: found 6; expected 7\n/cases/0/minimal/visits/0: found", failure.text)
        self.assertEqual(failure.get("message"), "not as expected: 5 cases and 15 queries")

    def test_what_was_never_recorded_differs(self):
        shutil.copy(TRACES / "grid-3x3.trace.json", self.suite)
        self.write("grid-3x3", {"options": {"planar": True}})
        code, out, _ = self.ask()
        self.assertEqual(code, 1)
        self.assertIn("  /cases/0/consistent: found 71; expected nothing\n", out)

    def test_says_which_have_nothing_to_expect(self):
        shutil.copy(TRACES / "grid-3x3.trace.json", self.suite)
        code, out, _ = self.ask()
        self.assertEqual((code, out), (0, "grid-3x3: without an expect file\n"
                                       "1 trace: 1 without an expect file\n"))
        self.assertEqual(self.elements(), {"grid-3x3": ["skipped"]})

    def test_many_differences_are_cut(self):
        shutil.copy(TRACES / "grid-3x3.trace.json", self.suite)
        self.write("grid-3x3", {"options": {"planar": False}, "queries": [
            {"query": f"same(0, {j})"} for j in range(14)]})
        out = self.ask()[1]
        self.assertIn("\n  (25 more)\n", out)
        self.assertEqual(len(out.splitlines()), 23)

    def test_junit_and_text_are_the_same_each_time(self):
        self.copy(*NAMES)
        first = self.ask(), self.junit.read_bytes()
        self.assertEqual((self.ask(), self.junit.read_bytes()), first)


class Limits(Suite):
    def test_leave_undecided_and_record_nothing(self):
        self.copy("square-three-laps")
        made = run("simulate", "--seed", "8", "--travels", "60", "--missing", "0", "-o",
                   self.suite / "big.trace.json")
        self.assertEqual(made.returncode, 0)
        self.write("big", {"options": {"planar": False}})
        before = (self.suite / "big.expect.json").read_bytes()
        for update in ([], ["--update"]):
            code, out, _ = self.ask("--max-hypotheses", "1000", *update)
            self.assertEqual(code, 2)
            self.assertIn("big: undecided, stopped by limit of 1000 hypotheses\n", out)
            self.assertEqual(self.elements()["big"], ["error"])
            self.assertEqual((self.suite / "big.expect.json").read_bytes(), before)
        code, out, _ = self.ask("--time-limit", "0")
        self.assertEqual((code, out.splitlines()[-1]), (2, "2 traces: 2 undecided"))
        # A difference is one all the same.
        self.change("square-three-laps", '"paths": 2', '"paths": 3')
        self.assertEqual(self.ask("--max-hypotheses", "1000")[0], 1)


class Updated(Suite):
    def test_records_what_was_asked(self):
        shutil.copy(TRACES / "aces-stubs.trace.json", self.suite)
        self.write("aces-stubs",
                   {"queries": [{"query": "same(0,  8)"}, {"query": "same(2, 14)", "over": "minimal"}],
                    "options": {"planar": True, "assumptions": ["differ(0, 8)"]}},
                   {"options": {"planar": False, "optional_axioms": ["one_segment"]}})
        code, out, _ = self.ask("--update")
        self.assertEqual(code, 0)
        self.assertTrue(out.startswith("aces-stubs: recorded, 2 cases and 2 queries\n  /cases/0/cons"))
        first, second = self.read("aces-stubs")
        self.assertEqual(first["options"], {"planar": True, "assumptions": ["differ(0, 8)"]})
        self.assertEqual(first["consistent"], 35)
        self.assertEqual(first["queries"][0],
                         {"query": "same(0,  8)", **answered("impossible", 0, 35)})
        self.assertEqual((first["queries"][1]["over"], first["queries"][1]["of"]),
                         ("minimal", first["minimal"]["count"]))
        self.assertEqual(second["options"], {"planar": False, "optional_axioms": ["one_segment"]})
        self.assertEqual(self.ask()[0], 0)

    def test_makes_what_is_missing(self):
        for name in NAMES:
            shutil.copy(TRACES / f"{name}.trace.json", self.suite)
        code, out, _ = self.ask("--update")
        self.assertEqual((code, out.splitlines()[-1]), (0, "7 traces: 7 recorded"))
        for name in NAMES:
            wanted = json.loads((TRACES / f"{name}.expect.json").read_text())["cases"][:2]
            for case in wanted:
                case.pop("queries", None)
            self.assertEqual(self.read(name), wanted)
        before = {file: file.read_bytes() for file in self.suite.iterdir()}
        self.ask("--update")
        self.assertEqual({file: file.read_bytes() for file in self.suite.iterdir()}, before)
        files = self.suite.glob("*.expect.json")
        self.assertEqual(run("validate", *files).returncode, 0)

    def test_own_files_are_as_it_writes_them(self):
        self.copy(*NAMES)
        self.assertEqual(self.ask("--update")[0], 0)
        for name in NAMES:
            self.assertEqual((self.suite / f"{name}.expect.json").read_bytes(),
                             (TRACES / f"{name}.expect.json").read_bytes())


class Schema(Suite):
    def test_holds_for_what_is_written(self):
        try:
            import jsonschema
        except ImportError:
            self.skipTest("jsonschema is missing")

        def check(kind, text):
            schema = json.loads((SOURCE / "docs" / f"{kind}.schema.json").read_text())
            jsonschema.Draft202012Validator(schema).validate(json.loads(text))

        aces = TRACES / "aces-stubs.trace.json"
        for options in ([], ["--planar"], ["--over", "minimal"], ["--max-hypotheses", "3"],
                        ["--assume", "same(0,1)"], ["--assume", "differ(0,8)", "--check", "both"],
                        ["--axiom", "one_segment", "--axiom", "one_crossing"]):
            done = run("query", aces, "same(0, 8)", "places < 9", "order(1, 2, 3)", "--json", "-",
                       *options)
            check("answers", done.stdout)
        for options in (["same(8, 10)", "--by", "solver"], ["route(5, 13)"],
                        ["same(0, 8)", "--by", "solver", "--time-limit", "0"],
                        ["route(5, 13)", "same(0, 8)", "--max-hypotheses", "3"],
                        ["route(5, 13)", "--assume", "differ(0, 0)"]):
            check("answers", run("query", aces, *options, "--json", "-").stdout)
        check("maps", run("map", aces, "--json", "-", "--assume", "differ(0, 8)").stdout)
        for name in NAMES:
            shutil.copy(TRACES / f"{name}.trace.json", self.suite)
        self.ask("--update")
        for file in self.suite.glob("*.expect.json"):
            check("expect", file.read_text())


class BadInput(Suite):
    def refused(self, name, message):
        code, out, err = self.ask()
        self.assertEqual(code, 65)
        self.assertEqual(err, f"{self.suite}/{message}\n")
        self.assertIn(f"{name}: not to be tested\n", out)
        self.assertIn("square-three-laps: as expected", out)
        self.assertEqual(self.elements()[name], ["error"])

    def test_does_not_keep_others_from_being_tested(self):
        self.copy("square-three-laps", "aces-stubs")
        good = self.read("aces-stubs")[0]
        expect = "aces-stubs.expect.json:/cases/0/"
        for change, message in (
            ({"options": {"planar": 1}}, "options/planar: found 1; expected true or false"),
            ({"options": {"planar": True, "assumptions": ["same(0, 99)"]}, "per_visit": None},
             "options/assumptions/0: assumption, character 9: found visit 99; expected 0 to 14"),
            ({"queries": [{"query": "smae(0, 1)"}]},
             "queries/0/query: query, character 1: found 'smae'; expected same, differ, "),
            ({"queries": [{"query": "same(0, 1)"}, {"query": "same(0, 15)"}]},
             "queries/1/query: query, character 9: found visit 15; expected 0 to 14"),
            ({"options": {"planar": True, "optional_axioms": ["no_such"]}},
             "options/optional_axioms: "),
        ):
            with self.subTest(message=message):
                case = {**good, **change}
                if case["per_visit"] is None:
                    for key in ("consistent", "per_visit", "minimal", "queries"):
                        case.pop(key)
                self.write("aces-stubs", case)
                before = (self.suite / "aces-stubs.expect.json").read_bytes()
                code, out, err = self.ask()
                self.assertEqual(code, 65)
                self.assertTrue(err.startswith(f"{self.suite}/{expect}{message}"), err)
                self.assertRegex(err, r"^[^\n]+\n$")
                self.assertIn("aces-stubs: not to be tested\nsquare-three-laps: as expected", out)
                self.assertEqual(self.elements(), {"aces-stubs": ["error"], "square-three-laps": []})
                self.assertEqual(self.ask("--update")[0], 65)
                self.assertEqual((self.suite / "aces-stubs.expect.json").read_bytes(), before)

    def test_files_that_are_not_there_or_broken(self):
        self.copy("square-three-laps")
        self.write("lonely", {"options": {"planar": True}})
        self.refused("lonely", "lonely.trace.json: found no such file or directory; "
                     "expected a file that can be read")
        (self.suite / "lonely.trace.json").write_text("[]")
        self.refused("lonely", "lonely.trace.json: found array; expected an object")

    def test_folders(self):
        for folder, found in ((self.suite, "no traces"), (self.folder / "none", "no such file")):
            done = run("test", folder)
            self.assertEqual((done.returncode, done.stdout), (65, ""))
            self.assertRegex(done.stderr, f"^asterism: {folder}: found {found}[^\n]*; expected ")
        (self.suite / "a.trace.json").mkdir()
        self.assertEqual(run("test", self.suite).returncode, 65)

    def test_usage(self):
        self.copy("square-three-laps")
        for words in ([], [self.suite, "--jobs", "2"], [self.suite, "--time-limit", "x"],
                      [self.suite, "--check", "none"]):
            done = run("test", *words)
            self.assertEqual((done.returncode, done.stdout), (64, ""))
        self.assertEqual(run("test", self.suite, "--junit", self.folder / "no/x.xml").returncode, 70)

    def test_a_result_that_got_lost(self):
        self.copy("square-three-laps")
        self.check_lost_result("test", self.suite)

    def test_names_are_quoted_in_xml(self):
        name = 'a<b>&"c'
        shutil.copy(TRACES / "grid-3x3.trace.json", self.suite / f"{name}.trace.json")
        self.ask()
        self.assertEqual(self.elements(), {name: ["skipped"]})

    def test_validate_points_into_the_query(self):
        file = self.file("a.expect.json", json.dumps(
            {"format": "asterism/expect", "version": 1,
             "cases": [{"options": {"planar": True}, "queries": [{"query": "same(0"}]}]}))
        done = run("validate", file)
        self.assertEqual(done.returncode, 65)
        self.assertEqual(done.stderr, f"{file}:/cases/0/queries/0/query: query, character 7: found "
                         "the end; expected ','\n")


class Docs(ProgramTest):
    def test_help_has_examples(self):
        self.check_help("test")

    def test_what_they_show_is_what_comes_out(self):
        self.check_shown(shown_in("docs/formats.md", "test"))

    def test_the_file_shown_is_one(self):
        page = (SOURCE / "docs/formats.md").read_text()
        shown, = re.findall(r"(?m)^    (\{ \"format\": \"asterism/expect\".*\n(?:    .*\n)*)", page)
        text = re.sub(r"(?m)^    ", "", shown)
        self.assertEqual(text, (SOURCE / "examples/01_corner.expect.json").read_text())


if __name__ == "__main__":
    unittest.main(argv=[sys.argv[0], *sys.argv[3:]])

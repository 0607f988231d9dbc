"""What a person knows, on the command line: assume_test.py PROGRAM SOURCE_FOLDER [options]."""

import itertools
import json
import sys
import unittest

from program import TRACES, Folder, ProgramTest, run, shown_in

ACES = TRACES / "aces-stubs.trace.json"


def assuming(*facts):
    return [word for fact in facts for word in ("--assume", fact)]


def held(maps, *facts):
    """Of maps, those where (is_same, i, j) is so for each fact."""
    return [m for m in maps if all((m["visits"][i] == m["visits"][j]) == s for s, i, j in facts)]


class Maps(Folder):
    def test_are_those_that_hold_the_assumptions(self):
        for planar in ([], ["--planar"]):
            listed = json.loads(run("map", ACES, "--all", "--json", "-", *planar).stdout)["maps"]
            for (i, j), (k, m) in itertools.product([(0, 8), (4, 10), (3, 3)], [(2, 14), (6, 8)]):
                for same, other in itertools.product((True, False), repeat=2):
                    facts = [f"{'same' if same else 'differ'}({i}, {j})",
                             f"{'same' if other else 'differ'}({k}, {m})"]
                    with self.subTest(planar=planar, facts=facts):
                        done = run("map", ACES, "--all", "--json", "-", "--certify", "0", *planar,
                                   *assuming(*facts))
                        found = json.loads(done.stdout)
                        wanted = held(listed, (same, i, j), (other, k, m))
                        self.assertEqual(found["maps"], wanted)
                        self.assertEqual(done.returncode, 0 if wanted else 1)
                        self.assertEqual(found["options"]["assumptions"], facts)

    def test_are_certified_written_and_read(self):
        file = self.folder / "aces.maps.json"
        done = run("map", ACES, "--planar", "--json", file, *assuming("differ(0,8)"))
        self.assertEqual(done.returncode, 0)
        self.assertIn("14 travels\nassuming differ(0, 8)\nplanar maps after", done.stdout)
        self.assertIn("35 planar maps explain the trace\n", done.stdout)
        self.assertIn("; certified by the solver\n", done.stdout)
        self.assertEqual(run("validate", file).returncode, 0)
        broken = file.read_text().replace("differ(0, 8)", "same(0, 8)")
        self.assertEqual(run("validate", self.file("b.maps.json", broken)).returncode, 65)

    def test_of_the_solver_are_the_same(self):
        for check in ("solver", "both"):
            self.assertEqual(
                run("map", ACES, "--planar", "--check", check, *assuming("same(0, 8)")).stdout,
                run("map", ACES, "--planar", *assuming("same(0, 8)")).stdout)

    def test_without_assumptions_tell_of_none(self):
        self.assertNotIn("assum", run("map", ACES, "--json", "-").stdout)

    def test_contradictions_leave_none(self):
        done = run("map", ACES, *assuming("same(0, 1)", "differ(0, 1)"))
        self.assertEqual(done.returncode, 1)
        self.assertTrue(done.stdout.endswith(
            "no map explains the trace under these assumptions: none is left after visit 1\n"))
        done = run("map", ACES, "--planar", *assuming("differ(4, 4)"))
        self.assertEqual(done.returncode, 1)
        self.assertTrue(done.stdout.endswith("none is left after visit 4\n"))


class Queries(Folder):
    def test_are_asked_of_the_maps_left(self):
        done = run("query", ACES, *assuming("differ(0, 8)"), "same(2, 14)", "differ(0, 8)")
        self.assertEqual(done.returncode, 0)
        lines = done.stdout.splitlines()
        self.assertEqual(lines[0], "assuming differ(0, 8)")
        self.assertEqual(lines[1], "same(2, 14): possible, in 13 of 73 maps")
        self.assertEqual(lines[-1], "differ(0, 8): certain, in 73 of 73 maps")
        both = run("query", ACES, "same(2, 14) and differ(0, 8)").stdout
        self.assertIn("possible, in 13 of 107 maps", both)
        found = json.loads(run("query", ACES, "same(2, 14)", "--json", "-",
                               *assuming("differ(0,8)")).stdout)
        self.assertEqual(found["options"]["assumptions"], ["differ(0, 8)"])
        self.assertEqual(found["consistent"], 73)

    def test_of_none(self):
        done = run("query", ACES, "same(2, 14)", *assuming("differ(1, 1)"))
        self.assertEqual((done.returncode, done.stdout),
                         (1, "assuming differ(1, 1)\nsame(2, 14): impossible, in 0 of 0 maps\n"
                          "no map explains the trace under these assumptions: none is left after "
                          "visit 1\n"))


class Runs(Folder):
    def setUp(self):
        super().setUp()
        # Of this drive two maps are left; the simpler goes back to place 0.
        self.log = self.folder / "office.log"
        made = run("simulate", "--building", "office", "--width", "3", "--height", "2",
                   "--travels", "3", "--seed", "6", "-o", self.log)
        self.assertEqual(made.returncode, 0)

    def ranked(self, *facts):
        out = self.folder / "out"
        done = run("run", self.log, "-o", out, "--json", *assuming(*facts))
        self.assertEqual(run("validate", out / "maps.json").returncode, 0)
        return done.returncode, json.loads(done.stdout), (out / "report.html").read_text()

    def test_rank_the_maps_left(self):
        code, found, report = self.ranked("same(0,3)")
        self.assertEqual((code, found["consistent"]), (0, 1))
        self.assertEqual([m["visits"] for m in found["models"]], [[0, 1, 2, 0]])
        self.assertEqual(found["assumptions"], ["same(0, 3)"])
        self.assertIn("same(0, 3)", report)
        self.assertIn("<b>assumptions</b>", report)

    def test_of_what_none_explains_draw_the_rest(self):
        code, found, report = self.ranked("same(0,2)")
        self.assertEqual((code, found["consistent"], found["explained_visits"]), (1, 0, 2))
        self.assertIn("assuming same(0, 2)", found["why"])
        self.assertIn("assuming same(0, 2)", report)
        code, found, _ = self.ranked("differ(0,0)")
        self.assertEqual((code, found["explained_visits"], found["models"]), (1, 0, []))

    def test_are_refused_before_anything_is_written(self):
        out = self.folder / "out"
        done = run("run", self.folder / "missing.log", "-o", out, *assuming("same(0)"))
        self.assertEqual((done.returncode, done.stdout), (64, ""))
        done = run("run", self.log, "-o", out, *assuming("same(0, 4)"))
        self.assertEqual(done.returncode, 65)
        self.assertIn("asterism: assumption, character 9: found visit 4; expected 0 to 3\n",
                      done.stderr)
        self.assertFalse(out.exists())


class BadInput(Folder):
    def refused(self, code, *arguments, said=r"^asterism: "):
        return super().refused(code, *arguments, said=said)

    def test_points_at_the_character(self):
        for command in (["map"], ["query", "same(0,1)"]):
            missing = [command[0], self.folder / "missing.trace.json", *command[1:]]
            self.assertEqual(self.refused(64, *missing, *assuming("same(0,8)", "same(3,9")),
                             "asterism: assumption, character 9: found the end; expected ')'\n"
                             "same(3,9\n        ^\n")
            self.assertEqual(self.refused(65, command[0], ACES, *command[1:],
                                          *assuming("differ(15, 0)")),
                             "asterism: assumption, character 8: found visit 15; expected 0 to 14\n")
        for fact in (" ", "not same(0, 1)", "adjacent(0, 1)", "same(0, 1) and same(1, 2)", "same"):
            with self.subTest(fact=fact):
                message = self.refused(64, "map", ACES, "--assume=" + fact)
                self.assertRegex(message, r"^asterism: assumption, character \d+: found .*; expected")

    def test_excludes_why_not(self):
        message = self.refused(64, "map", ACES, "--why-not", "0,1,0", *assuming("same(0, 1)"))
        self.assertRegex(message, r"^asterism: .*exclude[^\n]*\n$")


class Docs(ProgramTest):
    def test_what_they_show_is_what_comes_out(self):
        shown = [one for one in shown_in("docs/queries.md", "map", "query") if "--assume" in one[0]]
        self.check_shown(shown)


if __name__ == "__main__":
    unittest.main(argv=[sys.argv[0], *sys.argv[3:]])

"""Axioms of one's own, as docs/axiom-language.md tells how to write them: own_axioms_test.py PROGRAM
SOURCE_FOLDER."""

import re
import sys
import unittest

from program import SOURCE, TRACES, Folder, as_json, run, shown_in

PAGE = "docs/axiom-language.md"


class WorkedExample(Folder):
    def setUp(self):
        super().setUp()
        self.axioms = self.own_axioms("my-axioms")
        (block,) = re.findall(r"(?s)```\n(; What is known.*?)```", (SOURCE / PAGE).read_text())
        (self.axioms / "building.smt2").write_text(block)

    def asked(self, command):
        return run(*[SOURCE / word if word.startswith("tests/") else
                     self.axioms if word == "my-axioms" else word for word in command])

    def test_it_is_valid(self):
        self.assertEqual(run("validate", self.axioms).returncode, 0)
        names = re.findall(r":named axiom\.(\w+)", (self.axioms / "building.smt2").read_text())
        self.assertEqual(names, ["second_after", "short"])
        listed = run("axioms", "--axioms", self.axioms).stdout
        for name in names:
            self.assertRegex(listed, rf"(?m)^{name} +\[own\]$")

    def test_the_maps_shown_are_what_comes_out(self):
        (command, output), _ = shown_in(PAGE, "map")
        done = self.asked(command)
        self.assertEqual(done.returncode, 0)
        self.assertTrue(done.stdout.startswith(output + "\n"), done.stdout)

    def test_the_explanation_shown_is_what_comes_out(self):
        ((command, output),) = shown_in(PAGE, "explain")
        self.assertEqual(self.asked(command).stdout.rstrip(), output)
        shipped = [word for word in command if word not in ("--axioms", "my-axioms")]
        self.assertIn("same(3, 13): possible", self.asked(shipped).stdout)


class OwnExtents(Folder):
    """Few dead ends are preferred: the directions in which paths end."""

    TRACE = TRACES / "aces-stubs.trace.json"

    def setUp(self):
        super().setUp()
        self.axioms = self.own_axioms("my-axioms")
        self.prefer("(set-info :extent (dead_end ((q DState)) :where (ends q) (along q)))\n"
                    "(set-info :minimise (dead_end path place))\n")

    def prefer(self, text):
        preference = self.axioms / "preference.smt2"
        kept = preference.read_text()
        preference.write_text(kept[:kept.index("(set-info :minimise")] + text)

    def solved(self, *options):
        return ("--axioms", self.axioms, "--check", "solver", *options)

    @staticmethod
    def dead_ends(report_map):
        return sum(arm.endswith("0") for place in report_map["places"]
                   for arm in place["star"].split())

    def test_the_page_shows_what_comes_out(self):
        (block,) = re.findall(r"(?s)```\n(; long.*?)```", (SOURCE / PAGE).read_text())
        self.prefer(block)
        _, (command, output) = shown_in(PAGE, "map")
        shown = [SOURCE / word if word.startswith("tests/") else
                 self.axioms if word == "few-corridors" else word for word in command]
        done = run(*shown)
        self.assertEqual(done.returncode, 0)
        self.assertTrue(done.stdout.startswith(output + "\n"), done.stdout)
        shipped = run(*shown[:3]).stdout
        self.assertIn("\n3 minimal models: 6 paths, 9 places; certified by the solver\n", shipped)

    def test_the_solver_alone_counts_them(self):
        for command in ("map", "query"):
            asked = ["same(0, 1)"] if command == "query" else []
            for check in ("native", "both"):
                said = self.refused(65, command, self.TRACE, *asked, "--axioms", self.axioms,
                                    "--check", check)
                self.assertIn("found other extents to minimise than the shipped ones; expected "
                              "--check solver", said)
        self.assertIn("other extents to minimise", self.refused(
            65, "next", self.TRACE, *self.solved()))
        self.assertIn("path, place and segment alone", self.refused(
            65, "map", SOURCE / "examples/05_square.trace.json", *self.solved()))

    def test_the_maps_with_the_fewest_are_minimal(self):
        code, listed = as_json("map", self.TRACE, *self.solved("--all", "--planar"))
        self.assertEqual(code, 0)
        self.assertEqual(listed["options"]["preference"], ["dead_end", "path", "place"])
        sizes = [(self.dead_ends(m), len(m["paths"]), len(m["places"])) for m in listed["maps"]]
        again, found = as_json("map", self.TRACE, *self.solved("--planar"))
        self.assertEqual((again, found["minimal"]["certified"]), (0, True))
        self.assertEqual(found["maps"],
                         [m for m, size in zip(listed["maps"], sizes) if size == min(sizes)])
        text = run("map", self.TRACE, *self.solved("--planar")).stdout
        self.assertIn(f"certified by the solver\n  dead_end: {min(sizes)[0]}\n", text)

    def test_questions_about_minimal_models_are_answered(self):
        options = ("--axioms", self.axioms, "--planar", "--over", "minimal")
        for query in ("same(0, 8)", "places <= 9", "adjacent(3, 5)"):
            listed = as_json("query", self.TRACE, query, *options, "--check", "solver")
            asked = as_json("query", self.TRACE, query, *options, "--by", "solver")
            explained = as_json("explain", self.TRACE, query, *options)
            self.assertEqual(listed[0], asked[0])
            verdict = listed[1]["queries"][0]["verdict"]
            self.assertEqual(verdict, asked[1]["queries"][0]["verdict"])
            self.assertEqual(verdict, explained[1]["verdict"])

    def test_a_shipped_name_declared_otherwise_says_so(self):
        preference = self.axioms / "preference.smt2"
        preference.write_text("(set-info :extent (path ((q DState)) (along q)))\n"
                              "(set-info :minimise (path place))\n")
        code, found = as_json("map", self.TRACE, *self.solved("--planar"))
        self.assertEqual((code, found["options"]["preference"]), (0, ["path (own)", "place"]))
        self.assertEqual(found["minimal"]["paths"], 6)
        self.assertIn("  path: 12\n", run("map", self.TRACE, *self.solved("--planar")).stdout)

    def test_they_are_listed(self):
        listed = run("axioms", "--axioms", self.axioms).stdout
        self.assertIn(f"preference.smt2:", listed)
        self.assertRegex(listed, r"(?m)^extent segment +\[BMK10\]$")
        self.assertRegex(listed, r"(?m)^extent dead_end *$")
        self.assertIn("minimised, the first before the next: dead_end, path, place\n", listed)

    def test_the_old_form_is_read(self):
        (self.axioms / "preference.smt2").write_text("(set-info :minimise (path place))\n")
        shipped = run("map", self.TRACE, "--json", "-").stdout
        own = run("map", self.TRACE, "--axioms", self.axioms, "--json", "-").stdout
        self.assertEqual(own.replace(str(self.axioms), "shipped"), shipped)


if __name__ == "__main__":
    unittest.main(argv=[sys.argv[0], *sys.argv[3:]])

"""Asks maps on the command line: query_test.py PROGRAM SOURCE_FOLDER [unittest options]."""

import json
import re
import shutil
import sys
import unittest

from program import (ONE_LINE, SOURCE, TRACES, BigTrace, Folder, ProgramTest, as_json, run, shown_in,
                     shown_in_readme)

ACES = TRACES / "aces-stubs.trace.json"


def answers(*arguments):
    return as_json("query", *arguments)


class Answers(Folder):
    def test_agree_with_all_maps_listed(self):
        for planar in ([], ["--planar"]):
            for trace in ("aces-stubs", "grid-3x3", "eight-crossings"):
                file = TRACES / f"{trace}.trace.json"
                listed = json.loads(run("map", file, "--all", "--json", "-", *planar).stdout)["maps"]
                pairs = [(i, j) for i in range(8) for j in range(i, 12)]
                code, found = answers(file, *planar, *(f"same({i}, {j})" for i, j in pairs))
                self.assertEqual(len(found["queries"]), len(pairs))
                for (i, j), answer in zip(pairs, found["queries"]):
                    with self.subTest(trace=trace, planar=planar, i=i, j=j):
                        holds = [m for m in listed if m["visits"][i] == m["visits"][j]]
                        fails = [m for m in listed if m["visits"][i] != m["visits"][j]]
                        verdict = ("impossible" if not holds else "possible" if fails else "certain")
                        self.assertEqual(
                            (answer["verdict"], answer["holds"], answer["of"]),
                            (verdict, len(holds), len(listed)))
                        for key, maps in (("witness", holds), ("counterexample", fails)):
                            first = maps and {k: maps[0][k] for k in ("visits", "entered")}
                            self.assertEqual(answer[key], first or None)
                verdicts = {answer["verdict"] for answer in found["queries"]}
                self.assertEqual(code, 1 if "impossible" in verdicts else 0)

    def test_over_minimal_models(self):
        code, found = answers(ACES, "--over", "minimal", "paths = 6 and places = 9", "same(2, 14)")
        self.assertEqual((code, found["options"]["over"], found["consistent"]), (0, "minimal", None))
        certain, possible = found["queries"]
        self.assertEqual((certain["verdict"], certain["of"]), ("certain", 6))
        self.assertIsNone(certain["counterexample"])
        self.assertEqual((possible["verdict"], possible["of"]), ("possible", 6))

    def test_minimal_models_searched_for_answer_as_those_listed(self):
        asked = ("same(0, 8)", "on_path(1, 8)", "places = 9 or steps(0, 7) = 1", "route(8, 1)")
        listing = ["--max-hypotheses", "1000000"]
        for trace in ("aces-stubs", "grid-3x3", "eight-crossings"):
            file = TRACES / f"{trace}.trace.json"
            for options in ([], ["--planar"], ["--assume", "differ(0, 8)"]):
                with self.subTest(trace=trace, options=options):
                    arguments = [file, "--over", "minimal", *options]
                    code, found = answers(*arguments, *asked)
                    code_listed, listed = answers(*arguments, *listing, *asked)
                    self.assertEqual((found["options"].pop("by"), listed["options"].pop("by")),
                                     ("search", "enumeration"))
                    self.assertIsNone(found.pop("consistent"))
                    self.assertGreater(listed.pop("consistent"), 0)
                    self.assertEqual((code, found), (code_listed, listed))
                    text = run("query", *arguments, *asked).stdout
                    self.assertEqual(text, run("query", *arguments, *listing, *asked).stdout)

    def test_minimal_models_of_more_maps_than_can_be_listed(self):
        walk = ["--width", 5, "--height", 5, "--travels", 60, "--seed", 1]
        file = self.file("walk.trace.json", run("simulate", *walk).stdout)
        arguments = [file, "same(3, 9)", "--over", "minimal"]
        code, found = answers(*arguments, "--time-limit", "60")
        self.assertEqual((code, found["complete"], found["queries"][0]["verdict"]),
                         (1, True, "impossible"))
        self.assertEqual(found["queries"][0]["of"], 15)
        for command, asked in (("query", ["same(3, 9)"]), ("explain", ["same(3, 9)"]), ("next", [])):
            on_jobs = [run(command, file, *asked, "--over", "minimal", "--jobs", jobs).stdout
                       for jobs in (1, 2)]
            self.assertTrue(on_jobs[0])
            self.assertEqual(on_jobs[0], on_jobs[1])
        code, found = answers(*arguments, "--max-hypotheses", "1000")
        self.assertEqual((code, found["complete"]), (2, False))
        code, found = answers(*arguments, "--time-limit", "0")
        self.assertEqual((code, found["stopped_by"], found["options"]["by"]),
                         (2, "time limit", "search"))
        self.assertEqual(found["queries"][0]["verdict"], "undecided")
        done = run("query", *arguments, "--time-limit", "0")
        self.assertEqual((done.returncode, done.stdout),
                         (2, "same(3, 9): undecided, stopped by time limit\n"))

    def test_checks_and_axioms_of_maps_count(self):
        for check in ("native", "solver", "both"):
            _, found = answers(ACES, "--planar", "same(0, 8)", "--check", check)
            self.assertEqual(found["options"].pop("check"), check)
            self.assertEqual(found["queries"], answers(ACES, "--planar", "same(0, 8)")[1]["queries"])
        eight = TRACES / "eight-crossings.trace.json"
        _, found = answers(eight, "same(0, 0)", "--axiom", "one_segment")
        self.assertEqual(found["queries"][0]["of"], 77)
        folder = self.folder / "axioms"
        shutil.copytree(SOURCE / "axioms", folder, ignore=shutil.ignore_patterns("*.?pp"))
        topological = folder / "topological.smt2"
        text = topological.read_text()
        topological.write_text(text[:text.index("(assert (! (forall ((q DState) (r DState) (s DState))")])
        refused = run("query", eight, "same(0, 0)", "--axioms", folder)
        self.assertEqual((refused.returncode, refused.stdout), (65, ""))
        _, found = answers(eight, "same(0, 0)", "--axioms", folder, "--check", "solver")
        self.assertEqual(found["queries"][0]["of"], 92)

    def test_exit_codes(self):
        self.assertEqual(run("query", ACES, "same(0, 8)", "same(0, 0)").returncode, 0)
        self.assertEqual(run("query", ACES, "same(0, 8)", "same(0, 1)").returncode, 1)

    def test_no_map(self):
        dead_end = {"star": "a+1 a-0", "left_by": "a+"}
        crossing = {"star": "a+1 b+1 a-1 b-1", "entered_by": "a+", "left_by": "a+"}
        file = self.file("no.trace.json", json.dumps(
            {"format": "asterism/trace", "version": 1, "name": "no",
             "visits": [dead_end, crossing, crossing]}))
        done = run("query", file, "same(0, 0)")
        self.assertEqual(done.returncode, 1)
        self.assertEqual(done.stdout, "same(0, 0): impossible, in 0 of 0 maps\n"
                         "no map explains the trace: none is left after visit 2\n")
        code, found = answers(file, "same(0, 0)")
        self.assertEqual((code, found["consistent"], found["complete"]), (1, 0, True))
        minimal = run("query", file, "same(0, 0)", "--over", "minimal")
        self.assertEqual((minimal.returncode, minimal.stdout),
                         (1, done.stdout.replace("maps", "minimal models")))
        code, found = answers(file, "same(0, 0)", "--over", "minimal")
        self.assertEqual((code, found["consistent"], found["complete"]), (1, 0, True))

    def test_same_bytes_and_both_outputs(self):
        file = self.folder / "answers.json"
        first = run("query", ACES, "places = 9", "--json", "-").stdout
        text = run("query", ACES, "places = 9", "--json", file).stdout
        self.assertEqual(file.read_text(), first)
        self.assertEqual(text, run("query", ACES, "places = 9").stdout)
        self.assertRegex(text, r"^places = 9: possible, in 6 of 107 maps\n  it holds [^\n]*\n  it fails ")

    def test_a_query_of_two_lines_is_shown_in_one(self):
        done = run("query", ACES, "same(0, 0)\n\tand same(1, 1)")
        self.assertEqual(done.stdout, "same(0, 0)  and same(1, 1): certain, in 107 of 107 maps\n")

    def test_a_trace_from_stdin(self):
        done = run("query", "-", "same(0, 0)", stdin=ACES.read_text())
        self.assertEqual(done.stdout, "same(0, 0): certain, in 107 of 107 maps\n")


def step(mapped, at, turn):
    """Where a turn and a travel lead from [place, arm come in by]; None if that is not known."""
    place, arm = at
    size = len(mapped["places"][place]["star"].split())
    for segment in mapped["segments"]:
        for one, other in (segment, segment[::-1]):
            if turn < size and one == [place, (arm + turn) % size]:
                return other
    return None


def walk(mapped, visit, turns):
    at = [mapped["visits"][visit], mapped["entered"][visit] or 0]
    for turn in turns:
        at = at and step(mapped, at, turn)
    return at and at[0]


def travels(mapped, start, end):
    """The least number of them from one place to another."""
    reached, count = {start}, 0
    while end not in reached:
        count += 1
        joined = [{p, q} for (p, _), (q, _) in mapped["segments"]]
        reached = reached.union(*(places for places in joined if places & reached))
    return count


class Routes(Folder):
    def test_lead_there_in_all_maps_listed(self):
        pairs = [(0, 9), (9, 0), (5, 13), (12, 9), (14, 8), (3, 3), (2, 10)]
        for planar in ([], ["--planar"]):
            listed = json.loads(run("map", ACES, "--all", "--json", "-", *planar).stdout)["maps"]
            code, found = answers(ACES, *planar, *(f"route({i}, {j})" for i, j in pairs))
            self.assertEqual((code, found["queries"], len(found["routes"])), (0, [], len(pairs)))
            for (i, j), answer in zip(pairs, found["routes"]):
                with self.subTest(planar=planar, i=i, j=j):
                    self.assertEqual((answer["verdict"], answer["is_shortest"], answer["of"]),
                                     ("certain", True, len(listed)))
                    turns = answer["turns"]
                    self.assertLessEqual(len(turns), abs(i - j))
                    self.assertTrue(all(walk(m, i, turns) == m["visits"][j] for m in listed))
                    least = [travels(m, m["visits"][i], m["visits"][j]) for m in listed]
                    self.assertEqual(sum(some["maps"] for some in answer["shorter"]),
                                     sum(one < len(turns) for one in least))
                    self.assertEqual(answer["unlisted"], 0)
                    for some in answer["shorter"]:
                        witness, = (m for m in listed if m["visits"] == some["witness"]["visits"]
                                    and m["entered"] == some["witness"]["entered"])
                        self.assertEqual(walk(witness, i, some["turns"]), witness["visits"][j])
                        self.assertEqual(len(some["turns"]), least[listed.index(witness)])

    def test_are_told_apart_from_queries(self):
        code, found = answers(ACES, "same(0, 1)", "route(0, 9)", "--over", "minimal", "--planar")
        self.assertEqual((code, found["queries"][0]["verdict"]), (1, "impossible"))
        self.assertEqual((found["routes"][0]["turns"], found["routes"][0]["of"]), ([2], 1))
        self.assertNotIn("routes", answers(ACES, "same(0, 1)")[1])
        done = run("query", ACES, "same(0, 0)", "route(0,\t9)", "--over", "minimal", "--planar")
        self.assertEqual(done.stdout, "route(0, 9): certain, by 1 travel, in 1 of 1 planar minimal model\n"
                         "  as if come in by v+, leave by the 2nd arm clockwise, v-, travel\n"
                         "same(0, 0): certain, in 1 of 1 planar minimal model\n")

    def test_undecided_and_none(self):
        code, found = answers(ACES, "route(0, 9)", "same(0, 0)", "--max-hypotheses", "20")
        self.assertEqual((code, found["complete"]), (2, False))
        answer, = found["routes"]
        self.assertEqual((answer.pop("query"), answer.pop("verdict")), ("route(0, 9)", "undecided"))
        self.assertEqual(set(answer.values()), {None})
        done = run("query", ACES, "route(0, 9)", "--max-hypotheses", "20")
        self.assertEqual(done.stdout, "route(0, 9): undecided, stopped by limit of 20 hypotheses\n")

        end, tee = "a+1 a-0", "a+1 b+1 a-1 b-1"
        file = self.file("no.trace.json", json.dumps(
            {"format": "asterism/trace", "version": 1, "name": "no",
             "visits": [{"star": end, "left_by": "a+"},
                        {"star": tee, "entered_by": "a+", "left_by": "a+"},
                        {"star": tee, "entered_by": "a+"}]}))
        done = run("query", file, "route(0, 2)")
        self.assertEqual((done.returncode, done.stdout.splitlines()[0]),
                         (1, "route(0, 2): impossible, since there is no map"))


class Limits(BigTrace):
    def test_undecided(self):
        for limit in (["--max-hypotheses", "1000"], ["--time-limit", "0"]):
            with self.subTest(limit=limit):
                code, found = answers(self.big, "same(0, 1)", "places > 1", *limit)
                self.assertEqual((code, found["complete"], found["consistent"]), (2, False, None))
                self.assertTrue(found["stopped_by"])
                for answer in found["queries"]:
                    self.assertEqual(answer.pop("verdict"), "undecided")
                    self.assertTrue(answer.pop("query"))
                    self.assertEqual(set(answer.values()), {None})
        done = run("query", self.big, "same(0, 1)", "--max-hypotheses", "1000")
        self.assertEqual(done.stdout,
                         "same(0, 1): undecided, stopped by limit of 1000 hypotheses\n")

    def test_a_limit_that_is_not_reached_changes_nothing(self):
        limits = ["--max-hypotheses", "107", "--time-limit", "1000"]
        self.assertEqual(run("query", ACES, "places < 10", *limits).stdout,
                         run("query", ACES, "places < 10").stdout)


class BadInput(Folder):
    def refused(self, code, *arguments, said=r"^asterism: "):
        return super().refused(code, "query", *arguments, said=said)

    def test_a_text_that_is_no_query(self):
        # Told before the trace is read, and nothing is written.
        out = self.folder / "out.json"
        message = self.refused(64, self.folder / "missing.trace.json", "same(3)", "--json", out)
        self.assertEqual(message, "asterism: query, character 7: found ')'; expected ','\n"
                         "same(3)\n      ^\n")
        self.assertFalse(out.exists())
        corpus = SOURCE / "tests/corpus/query"
        for row in (corpus / "bad.tsv").read_text().splitlines()[1:]:
            name, wanted = row.split("\t")
            text = (corpus / "bad" / name).read_bytes().decode()
            if "\0" in text:
                continue
            with self.subTest(name=name):
                first, _, excerpt = self.refused(64, ACES, text).partition("\n")
                self.assertEqual(first, f"asterism: query, character {wanted}")
                self.assertRegex(excerpt, r"^[^\n]*\n *\^\n$")

    def test_a_visit_that_is_not_there(self):
        message = self.refused(65, ACES, "same(0, 15)")
        self.assertEqual(message, "asterism: query, character 9: found visit 15; expected 0 to 14\n")
        message = self.refused(65, ACES, "route(0, 15)")
        self.assertEqual(message, "asterism: query, character 10: found visit 15; expected 0 to 14\n")
        self.assertIn("how it was left", self.refused(65, ACES, "on(0, path_of(14))"))

    def test_files_and_usage(self):
        self.refused(65, self.folder / "missing.trace.json", "same(0, 1)")
        self.refused(65, ACES, "same(0, 1)", "--axiom", "no_such")
        for arguments in ([], [ACES], [ACES, "same(0, 1)", "--over", "some"],
                          [ACES, "same(0, 1)", "--jobs", 2],
                          [ACES, "same(0, 1)", "--over", "all", "--jobs", 2],
                          [ACES, "same(0, 1)", "--max-hypotheses", "-1"],
                          [ACES, "same(0, 1)", "--time-limit", "x"], [ACES, "same(0, 1)", "--all"]):
            with self.subTest(arguments=arguments):
                self.refused(64, *arguments, said=ONE_LINE)

    def test_a_result_that_got_lost(self):
        self.check_lost_result("query", ACES, "same(0, 1)")


class Docs(ProgramTest):
    def test_what_they_show_is_what_comes_out(self):
        self.check_shown(shown_in("docs/queries.md", "query"), 5)
        self.check_shown(shown_in_readme("query"))

    def test_every_word_of_the_grammar_is_read(self):
        page = (SOURCE / "docs/queries.md").read_text()
        rows = re.findall(r"(?m)^\| `(.*?)` \|", page)
        queries = [query for row in rows for query in row.split("`, `")]
        self.assertGreaterEqual(len(queries), 10)
        for query in queries:
            text = re.sub(r"\b([ijk])\b", lambda m: str("ijk".index(m[1])), query)
            self.assertIn(run("query", ACES, text).returncode, (0, 1), text)

    def test_help_has_examples(self):
        self.check_help("query")


if __name__ == "__main__":
    unittest.main(argv=[sys.argv[0], *sys.argv[3:]])

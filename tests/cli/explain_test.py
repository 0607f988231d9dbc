"""Explains on the command line: explain_test.py PROGRAM SOURCE_FOLDER [unittest options]."""

import json
import sys
import unittest

from program import SOURCE, TRACES, Folder, as_json, no_map_text, run, shown_in, shown_in_readme

ACES = TRACES / "aces-stubs.trace.json"


def explained(*arguments):
    return as_json("explain", *arguments)


def kinds(clash):
    return [next(key for key in member if key != "without") for member in clash]


class Clashes(Folder):
    def test_impossible_and_certain(self):
        code, found = explained(ACES, "same(8, 10)")
        self.assertEqual((code, found["verdict"]), (1, "impossible"))
        self.assertEqual([m["visit"] for m in found["clash"] if "visit" in m], [8, 9, 10])
        self.assertEqual(found["clash"][-1]["claim"], "same(8, 10)")
        code, contrary = explained(ACES, "not same(8, 10)")
        self.assertEqual((code, contrary["verdict"]), (0, "certain"))
        self.assertEqual(contrary["clash"], found["clash"])
        self.assertEqual(len(contrary["witness"]["visits"]), 15)

    def test_each_map_without_a_member_tells_of_the_other_visits(self):
        _, found = explained(ACES, "same(7, 14)")
        visits = [m["visit"] for m in found["clash"] if "visit" in m]
        for member in found["clash"]:
            told = [k for k, place in enumerate(member["without"]["visits"]) if place is not None]
            self.assertEqual(told, [k for k in visits if k != member.get("visit")])
            if "claim" not in member and member.get("visit") not in (7, 14):
                places = member["without"]["visits"]
                self.assertEqual(places[7], places[14])

    def test_possible(self):
        code, found = explained(ACES, "same(0, 8)")
        self.assertEqual((code, found["verdict"], found["clash"]), (0, "possible", None))
        for key, equal in (("witness", True), ("counterexample", False)):
            visits = found[key]["visits"]
            self.assertEqual(visits[0] == visits[8], equal)
            self.assertEqual(run("map", ACES, "--why-not", ",".join(map(str, visits))).returncode, 0)

    def test_preference(self):
        code, found = explained(ACES, "--over", "minimal", "places = 10")
        self.assertEqual((code, found["verdict"]), (1, "impossible"))
        preference = found["preference"]
        self.assertEqual((preference["minimal"], preference["best"], preference["decides"]),
                         ([6, 9], [8, 10], "path"))
        listed = json.loads(run("map", ACES, "--all", "--json", "-").stdout)["maps"]
        best = min((len(m["paths"]), len(m["places"])) for m in listed if len(m["places"]) == 10)
        self.assertEqual(best, (8, 10))
        code, found = explained(ACES, "--over", "minimal", "places < 10")
        self.assertEqual((code, found["verdict"]), (0, "certain"))
        code, found = explained(ACES, "--over", "minimal", "same(0, 1)")
        self.assertEqual((code, found["preference"]), (1, None))
        self.assertTrue(found["clash"])

    def test_the_best_map_otherwise_is_that_of_listing_all(self):
        listed = json.loads(run("map", ACES, "--all", "--json", "-").stdout)["maps"]
        decided = 0
        for i, j in ((0, 8), (2, 10), (4, 12), (1, 9), (2, 14), (0, 10)):
            with self.subTest(i=i, j=j):
                found = explained(ACES, "--over", "minimal", f"same({i}, {j})")[1]
                best = {is_so: min((len(m["paths"]), len(m["places"])) for m in listed
                                   if (m["visits"][i] == m["visits"][j]) == is_so)
                        for is_so in {m["visits"][i] == m["visits"][j] for m in listed}}
                if len(best) < 2 or best[True] == best[False]:
                    self.assertIsNone(found["preference"])
                    continue
                decided += 1
                self.assertEqual(found["verdict"],
                                 "certain" if best[True] < best[False] else "impossible")
                self.assertEqual((found["preference"]["minimal"], found["preference"]["best"]),
                                 (list(min(best.values())), list(max(best.values()))))
        self.assertGreater(decided, 1)

    def test_a_trace_that_no_map_explains(self):
        file = self.file("no.trace.json", no_map_text())
        done = run("explain", file, "same(0, 0)")
        self.assertEqual(done.returncode, 1)
        self.assertTrue(done.stdout.startswith(
            "same(0, 0): impossible, since no map explains the trace. These clash:\n"), done.stdout)
        _, found = explained(file, "same(0, 0)")
        self.assertNotIn("claim", kinds(found["clash"]))

    def test_other_axioms(self):
        eight = TRACES / "eight-crossings.trace.json"
        listed = [json.loads(run("map", eight, "--all", "--json", "-", *axiom).stdout)["maps"]
                  for axiom in ([], ["--axiom", "one_segment"])]
        pairs = [(i, j) for i in range(15) for j in range(i) if any(
            m["visits"][i] == m["visits"][j] for m in listed[0])]
        for i, j in pairs:
            if any(m["visits"][i] == m["visits"][j] for m in listed[1]):
                continue
            _, found = explained(eight, "--axiom", "one_segment", f"same({j}, {i})")
            self.assertIn("one_segment", [m.get("axiom") for m in found["clash"]])

    def test_same_bytes_and_both_outputs(self):
        file = self.folder / "clash.json"
        text = run("explain", ACES, "same(8, 10)", "--json", file).stdout
        self.assertEqual(text, run("explain", ACES, "same(8, 10)").stdout)
        self.assertEqual(file.read_text(), run("explain", ACES, "same(8, 10)", "--json", "-").stdout)


class BySolver(Folder):
    def test_agrees_with_listing(self):
        queries = ["same(0, 8)", "same(8, 10)", "not same(8, 10)", "places > 8", "on_path(1, 3)"]
        for options, way in (([], "enumeration"), (["--planar"], "enumeration"),
                             (["--over", "minimal"], "search")):
            asked = [json.loads(run("query", ACES, *queries, *options, "--json", "-", *by).stdout)
                     for by in ([], ["--by", "solver"])]
            self.assertEqual(*([q["verdict"] for q in found["queries"]] for found in asked))
            self.assertEqual([found["options"]["by"] for found in asked], [way, "solver"])

    def test_undecided(self):
        done = run("query", ACES, "same(0, 8)", "--by", "solver", "--time-limit", "0")
        self.assertEqual((done.returncode, done.stdout), (2, "same(0, 8): undecided, stopped by time limit of 0 s\n"))
        done = run("explain", ACES, "same(0, 8)", "--time-limit", "0")
        self.assertEqual((done.returncode, done.stdout), (2, "same(0, 8): undecided in 0 s\n"))

    def test_refuses_what_is_about_listing(self):
        for option in (["--check", "native"], ["--max-hypotheses", "5"]):
            done = run("query", ACES, "same(0, 8)", "--by", "solver", *option)
            self.assertEqual((done.returncode, done.stdout), (64, ""))
            self.assertIn(option[0], done.stderr)


class Schema(Folder):
    def setUp(self):
        super().setUp()
        try:
            import jsonschema
        except ImportError:
            self.skipTest("jsonschema is missing")
        schema = json.loads((SOURCE / "docs/explanation.schema.json").read_text())
        jsonschema.Draft202012Validator.check_schema(schema)
        self.validator = jsonschema.Draft202012Validator(schema)

    def written(self, *arguments, trace=ACES):
        _, found = explained(trace, *arguments)
        self.validator.validate(found)
        return found

    def assert_refused(self, document, *changes):
        """Each change, a value and the keys that lead to where it is put, spoils the document."""
        self.assertTrue(self.validator.is_valid(document))
        for value, *keys, last in changes:
            spoilt = json.loads(json.dumps(document))
            part = spoilt
            for key in keys:
                part = part[key]
            part[last] = value
            self.assertFalse(self.validator.is_valid(spoilt), (value, *keys, last))

    def test_clash(self):
        certain = self.written("not same(8, 10)", "--axiom", "one_segment")
        self.assertEqual(certain["verdict"], "certain")
        found = self.written("same(8, 10)")
        self.assertEqual(kinds(found["clash"])[::3], ["visit", "axiom", "axiom"])
        without = found["clash"][0]["without"]
        self.assert_refused(
            found,
            ("asterism/answers", "format"), (2, "version"), ("likely", "verdict"), (None, "query"),
            (1, "x"), (1, "options", "x"), ("some", "options", "over"), ([], "options", "assumptions"),
            ("possible", "verdict"), ("certain", "verdict"), ("undecided", "verdict"),
            (None, "clash"), ([], "clash"), (certain["witness"], "witness"),
            (found["clash"] + found["clash"][-1:], "clash"),
            ({"visit": 8}, "clash", 0), ({"without": without}, "clash", 0),
            ({"visit": None, "without": without}, "clash", 0),
            ({"axiom": "view", "without": without}, "clash", 0),
            ({"planarity": None, "without": without}, "clash", 0),
            ({"assumption": "same(0, 1)", "without": without}, "clash", 0),
            ("same(8, 10)", "clash", 0, "claim"), ("a word", "clash", 0, "words"),
            (-1, "clash", 0, "without", "visits", 0), (0.5, "clash", 0, "without", "entered", 0),
            (1, "clash", 0, "without", "x"))
        self.assert_refused(certain, (None, "witness"), (certain["witness"], "counterexample"),
                            (None, "witness", "visits", 3), (None, "witness", "entered", 3))
        for key in found:
            rest = {other: value for other, value in found.items() if other != key}
            self.assertFalse(self.validator.is_valid(rest), key)

    def test_planarity(self):
        star = "a+1 b+1 c+1 a-0 b-0 c-0"  # three segments, in the same order at both their ends
        visits = [{"star": star, "left_by": "a+"},
                  {"star": star, "entered_by": "a+", "left_by": "b+"},
                  {"star": star, "entered_by": "b+", "left_by": "c+"},
                  {"star": star, "entered_by": "c+"}]
        trace = self.file("three.trace.json", json.dumps(
            {"format": "asterism/trace", "version": 1, "name": "three", "visits": visits}))
        found = self.written("same(0, 2) and same(1, 3)", "--planar", trace=trace)
        at = kinds(found["clash"]).index("planarity")
        self.assertTrue(found["clash"][at]["planarity"]["loops"])
        self.assert_refused(
            found,
            (False, "options", "planar"), (True, "clash", at, "planarity"),
            ({}, "clash", at, "planarity"), ([0], "clash", at, "planarity", "left"),
            ([0, 1, 2], "clash", at, "planarity", "face", 0), ([], "clash", at, "planarity", "face"),
            ([-1], "clash", at, "planarity", "loops", 0), (1, "clash", at, "planarity", "x"),
            (found["clash"] + found["clash"][at:at + 1], "clash"))

    def test_assumption(self):
        found = self.written("same(0, 1)", "--assume", "differ(0, 0)")
        at = kinds(found["clash"]).index("assumption")
        self.assert_refused(found, ("differ(0,0)", "clash", at, "assumption"),
                            ("differ(0,0)", "options", "assumptions", 0))
        self.written("same(0, 8)", "--assume", "differ(2, 14)")

    def test_possible(self):
        found = self.written("same(0, 8)")
        self.assert_refused(found, (None, "witness"), (None, "counterexample"), ([], "clash"),
                            ("impossible", "verdict"), ("certain", "verdict"), ("undecided", "verdict"))

    def test_preference(self):
        self.assertEqual(self.written("places < 10", "--over", "minimal")["verdict"], "certain")
        found = self.written("places = 10", "--over", "minimal")
        self.assert_refused(
            found,
            ("all", "options", "over"), ("possible", "verdict"), (None, "preference"),
            (None, "witness"), (None, "counterexample"),
            ("gateway", "preference", "decides"), (["path", "path"], "preference", "extents"),
            ([], "preference", "minimal"), ([-1, 9], "preference", "best"),
            (None, "preference", "map"), (1, "preference", "x"))

    def test_undecided(self):
        found = self.written("same(0, 8)", "--time-limit", "0")
        self.assertEqual(found["verdict"], "undecided")
        self.assert_refused(found, ("possible", "verdict"), ("certain", "verdict"), ([], "clash"))
        # time over after the maps were found, and before the minimal models were
        found = self.written("same(2, 14)", "--over", "minimal")
        self.validator.validate({**found, "verdict": "undecided"})
        self.assert_refused({**found, "verdict": "undecided"}, (None, "witness"))


class BadInput(Folder):
    def test_refused(self):
        out = self.folder / "out.json"
        for code, query, message in (
                (64, "same(3", "query, character 7: found the end"),
                (65, "same(3, 15)", "query, character 9: found visit 15; expected 0 to 14")):
            done = run("explain", ACES, query, "--json", out)
            self.assertEqual((done.returncode, done.stdout), (code, ""), done.stderr)
            self.assertIn(message, done.stderr)
            self.assertFalse(out.exists())
        done = run("explain", self.file("bad.trace.json", "{}"), "same(0, 0)")
        self.assertEqual((done.returncode, done.stdout), (65, ""))


class Pages(Folder):
    def test_what_is_shown_is_printed(self):
        in_readme = shown_in_readme("explain")
        shown = shown_in("docs/queries.md", "explain")
        self.assertTrue(in_readme and shown)
        for command, output in in_readme + shown:
            command = [SOURCE / word if word.startswith("examples/") else word for word in command]
            self.assertEqual(run(*command).stdout.rstrip(), output)

    def test_their_picture_is_drawn_so(self):
        file = self.folder / "clash.svg"
        run("explain", SOURCE / "examples/aces-stubs.trace.json", "same(8, 10)", "--svg", file)
        self.assertEqual((SOURCE / "docs/aces-clash.svg").read_text(), file.read_text())


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1] + sys.argv[3:])

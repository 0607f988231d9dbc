"""Checks axioms on the command line: verify_test.py PROGRAM SOURCE_FOLDER [unittest options]."""

import itertools
import json
import re
import sys
import unittest

from program import SOURCE, Folder, as_json, run

ACES = SOURCE / "examples/aces-stubs.trace.json"
NO_LOOP = """; no_loop   [mine]
; Nothing comes before what comes before it.
(assert (! (forall ((q DState) (r DState)) (=> (and (order q r) (order r q)) false))
  :named axiom.no_loop))
"""
STAY = """(assert (! (forall ((q DState) (r DState)) (=> (order q r) (= (place q) (place r))))
  :named stay))
"""


def verify(*arguments):
    return as_json("verify", *arguments)


def read(text):
    """The S-expressions of a text, as lists."""
    stack = [[]]
    for token in re.findall(r"[()]|[^\s()]+", re.sub(r";.*", "", text)):
        if token == "(":
            stack.append([])
        elif token == ")":
            done = stack.pop()
            stack[-1].append(done)
        else:
            stack[-1].append(token)
    return stack[0]


def assertions(texts):
    """name: (variables, formula)"""
    found = {}
    for form in itertools.chain(*map(read, texts)):
        if form[0] == "assert":
            _, (_, variables, formula), _, name = form[1]
            found[name.removeprefix("axiom.")] = (variables, formula)
    return found


class Model:
    """A model as told in JSON. A function read as a relation gives several values."""

    def __init__(self, told):
        self.told = told

    def terms(self, term, bound):
        """Each value of a term, with those of the terms in it."""
        text = json.dumps(term)
        if text in bound:
            yield bound[text], bound
        elif isinstance(term, str):
            yield term, bound  # a constant, which names itself
        else:
            for argument, with_argument in self.terms(term[1], bound):
                for value in self.told["functions"][term[0]][argument]:
                    yield value, {**with_argument, text: value}

    def values(self, terms, bound):
        if not terms:
            yield [], bound
            return
        for first, with_first in self.terms(terms[0], bound):
            for rest, with_rest in self.values(terms[1:], with_first):
                yield [first, *rest], with_rest

    def terms_of(self, formula):
        """Every term that is no variable or constant."""
        if isinstance(formula, str):
            return []
        inner = [t for part in formula[1:] for t in self.terms_of(part)]
        return inner + [formula] if formula[0] in self.told["functions"] else inner

    def is_true(self, formula, bound):
        if isinstance(formula, str):
            return formula == "true"
        head, *parts = formula
        if head == "and":
            return all(self.is_true(part, bound) for part in parts)
        if head == "or":
            return any(self.is_true(part, bound) for part in parts)
        if head == "not":
            return not self.is_true(parts[0], bound)
        if head == "=>":
            return not self.is_true(parts[0], bound) or self.is_true(parts[1], bound)
        values = [next(self.terms(part, bound))[0] for part in parts]
        if head == "=":
            return values[0] == values[1]
        return values in self.told["relations"].get(head, [])

    def holds(self, variables, formula):
        sorts = [self.told["elements"][sort] for _, sort in variables]
        for elements in itertools.product(*sorts):
            bound = {json.dumps(name): e for (name, _), e in zip(variables, elements)}
            for _, full in self.values(self.terms_of(formula), bound):
                if not self.is_true(formula, full):
                    return False
        return True

    def is_function(self, name):
        return all(len(values) == 1 for values in self.told["functions"][name].values())


class Shipped(Folder):
    def test_every_axiom_has_its_model(self):
        code, found = verify("--worlds", "2")
        self.assertEqual((code, found["faults"], found["undecided"]), (0, [], []))
        files = [*SOURCE.glob("axioms/*.smt2"), *SOURCE.glob("axioms/optional/*.smt2")]
        said = assertions(file.read_text() for file in files)
        listed = set(re.findall(r"(?m)^(\w+) +\[", run("axioms").stdout))
        names = [axiom["name"] for axiom in found["axioms"]]
        optional = {axiom["name"] for axiom in found["axioms"] if not axiom["in_force"]}
        self.assertEqual(len(names), len(set(names)))
        self.assertEqual(set(names), listed | optional)
        self.assertEqual(optional, {"one_crossing", "one_segment"})
        self.assertEqual(set(names), set(said) | {"at", "along"})
        signature = {"at": "place", "along": "along"}
        for axiom in found["axioms"]:
            with self.subTest(axiom=axiom["name"]):
                self.assertEqual(axiom["verdict"], "independent")
                self.assertEqual(axiom["by_signature"], axiom["name"] in signature)
                model = Model(axiom["model"])
                for name, (variables, formula) in said.items():
                    if name == axiom["name"] or name not in optional:
                        self.assertEqual(model.holds(variables, formula), name != axiom["name"], name)
                for name, function in signature.items():
                    self.assertEqual(model.is_function(function), name != axiom["name"])
        self.assertEqual(found["together"]["verdict"], "satisfiable")
        model = Model(found["together"]["model"])
        for name in set(said) - optional:
            self.assertTrue(model.holds(*said[name]), name)
        q, r = found["together"]["fails_at"]
        self.assertIn([q, "travel", r], model.told["relations"]["leads"])
        self.assertNotEqual(*(model.told["functions"]["place"][d] for d in (q, r)))

    def test_engines_are_compared_on_worlds_and_traces(self):
        code, found = verify("--worlds", "6", "--seed", "3", ACES)
        self.assertEqual(code, 0)
        engines = found["engines"]
        # 107 maps and 55 planar ones are known of the trace.
        self.assertEqual((engines["traces"], engines["certified"]), (7, 14))
        self.assertGreaterEqual(engines["maps"], 162 + 12)
        self.assertGreaterEqual(engines["maps_counted"], 107 + 6)
        self.assertGreater(engines["candidates"], 7000)
        self.assertTrue(engines["native_compared"])
        self.assertIsNone(engines["difference"])
        self.assertIsNone(found["change"])

    def test_an_optional_axiom_that_others_imply_is_a_remark(self):
        code, found = verify("--worlds", "0", "--axiom", "one_segment", "--axiom", "one_crossing")
        self.assertEqual(code, 0)
        verdicts = {axiom["name"]: axiom["verdict"] for axiom in found["axioms"]}
        self.assertEqual([n for n, v in verdicts.items() if v != "independent"], ["one_segment"])
        proof = next(a["proof"] for a in found["axioms"] if a["name"] == "one_segment")
        self.assertEqual([step["axiom"] for step in proof].count("order"), 2)
        self.assertEqual({step["axiom"] for step in proof}, {"order", "one_crossing"})

    def test_same_bytes_and_both_outputs(self):
        file = self.folder / "found.json"
        first = run("verify", "--worlds", "2", "--json", "-").stdout
        text = run("verify", "--worlds", "2", "--json", file)
        self.assertEqual(file.read_text(), first)
        self.assertEqual(text.stdout, run("verify", "--worlds", "2").stdout)
        self.assertTrue(text.stdout.endswith("\n\nall is well\n"))
        for axiom in json.loads(first)["axioms"]:
            self.assertRegex(text.stdout, rf"(?m)^{axiom['name']}  \[")

    def test_without_time_it_is_undecided(self):
        done = run("verify", "--time-limit", "0", "--worlds", "2")
        self.assertEqual(done.returncode, 2)
        self.assertIn("\nundecided: whether the others imply transitive\n", done.stdout)
        self.assertIn("stopped by time limit\n", done.stdout)
        self.assertNotIn("all is well", done.stdout)

    def test_a_trace_of_too_many_maps_is_left_out_and_said_so(self):
        big = self.folder / "big.trace.json"
        run("simulate", "--seed", "8", "--travels", "40", "--missing", "0", "-o", big)
        code, found = verify("--worlds", "0", big)
        self.assertEqual((code, found["engines"]["cut_short"]), (2, 2))
        self.assertEqual(found["undecided"], ["traces left out for too many maps: 2 times"])


class WithAxioms(Folder):
    def setUp(self):
        super().setUp()
        self.axioms = self.own_axioms()

    def replace(self, name, replacement=""):
        for file in self.axioms.glob("*.smt2"):
            text = file.read_text()
            mark = text.find(f":named axiom.{name}))")
            if mark >= 0:
                begin = text.rfind("(assert", 0, mark)
                file.write_text(text[:begin] + replacement + text[text.index("\n", mark):])


class Own(WithAxioms):
    def test_the_same_axioms_change_nothing(self):
        code, found = verify("--axioms", self.axioms, "--worlds", "2")
        change = found["change"]
        self.assertEqual((code, change["more"], change["fewer"], change["smallest"]), (0, 0, 0, None))
        self.assertEqual(change["added"] + change["removed"] + change["changed"], [])
        self.assertTrue(found["engines"]["native_compared"])
        # Of the fifteen visits alone there are 107.
        self.assertEqual(change["traces"], 3)
        self.assertGreaterEqual(change["maps"], 107 + 2)

    def test_an_axiom_left_out(self):
        self.replace("transitive")
        code, found = verify("--axioms", self.axioms, "--worlds", "1", "--seed", "38")
        change = found["change"]
        self.assertEqual((code, change["removed"], change["added"]), (0, ["transitive"], []))
        self.assertGreater(change["traces_that_differ"], 0)
        self.assertGreater(change["more"], 0)
        self.assertEqual(change["maps"], change["shipped_maps"] + change["more"] - change["fewer"])
        self.assertFalse(found["engines"]["native_compared"])
        self.check_smallest(change)

    def check_smallest(self, change):
        """Both sets, asked again by another command, differ on the trace and on none shorter."""
        trace = change["smallest"]

        def counts(visits):
            file = self.file("smallest.trace.json", json.dumps({**trace, "visits": visits}))
            return [
                json.loads(run("map", file, "--certify", "0", "--json", "-", *more).stdout)["consistent"]
                for more in ([], ["--axioms", self.axioms, "--check", "solver"])
            ]

        self.assertEqual(
            counts(trace["visits"]), [change["smallest_shipped_maps"], change["smallest_maps"]])
        self.assertEqual(len(set(counts(trace["visits"][:-1]))), 1)

    def test_an_axiom_more_and_one_that_says_less(self):
        self.file("axioms/more.smt2", NO_LOOP)
        self.replace("transitive", "(assert (! (forall ((q DState) (r DState) (s DState)) (=> (and "
                     "(order q r) (leads r travel s)) (order q s))) :named axiom.transitive))")
        code, found = verify("--axioms", self.axioms, "--worlds", "1")
        change = found["change"]
        self.assertEqual((code, change["added"], change["changed"]), (0, ["no_loop"], ["transitive"]))
        # With the shipped axioms it is implied; from what is left of transitive it does not follow.
        verdicts = {axiom["name"]: axiom["verdict"] for axiom in found["axioms"]}
        self.assertEqual(verdicts["no_loop"], "independent")
        self.assertNotIn("one_segment", verdicts)

    def test_an_axiom_that_others_imply(self):
        self.file("axioms/more.smt2", NO_LOOP)
        done = run("verify", "--axioms", self.axioms, "--worlds", "1")
        self.assertEqual(done.returncode, 0)
        self.assertRegex(done.stdout, r"(?m)^no_loop  \[mine\]\n  Nothing comes .*\n"
                         r"  implied: .*\n    .*transitive\(")
        self.assertIn("\nremark: no_loop is implied\n", done.stdout)
        self.assertIn("\n  added: no_loop\n", done.stdout)

    def test_axioms_that_allow_no_travel(self):
        self.file("axioms/more.smt2", STAY)
        done = run("verify", "--axioms", self.axioms, "--worlds", "1")
        self.assertEqual(done.returncode, 1)
        self.assertRegex(done.stdout, r"unsatisfiable: [^\n]*\n    [^\n]*stay\(q, r\)")
        self.assertIn("\nfault: the axioms allow no travel from one place to another\n", done.stdout)
        self.assertNotIn("all is well", done.stdout)

    def test_maps_that_count_other_paths_than_the_axioms_force(self):
        self.replace("travel")
        code, found = verify("--axioms", self.axioms, "--worlds", "1")
        self.assertEqual(code, 1)
        self.assertIn("the axioms force", found["engines"]["difference"])
        self.assertEqual(found["faults"], [found["engines"]["difference"]])
        self.assertGreaterEqual(len(found["engines"]["shortest"]["visits"]), 2)

    def test_a_choice_has_no_least_closure(self):
        self.file("axioms/more.smt2", "(assert (! (forall ((q DState) (r DState)) "
                  "(=> (order q r) (or (order q r) (ends q)))) :named choice))")
        code, found = verify("--axioms", self.axioms, "--worlds", "1")
        self.assertEqual((code, found["engines"]["maps_counted"]), (0, 0))
        self.assertIn("leave a choice", found["engines"]["remark"])


class BadInput(Folder):
    def test_files_and_usage(self):
        self.refused(65, "verify", "--axioms", self.folder / "missing")
        self.refused(65, "verify", "--axioms", self.folder)
        self.refused(65, "verify", "--axiom", "no_such")
        self.refused(65, "verify", self.folder / "missing.trace.json")
        bad = self.file("bad.smt2", "(assert true)")
        self.assertIn(f"{bad}:1: found", self.refused(65, "verify", "--axioms", self.folder))
        for arguments in (["--worlds", "-1"], ["--seed", "x"], ["--time-limit", "-1"], ["--all"]):
            with self.subTest(arguments=arguments):
                self.refused(64, "verify", *arguments)

    def test_a_result_that_got_lost(self):
        self.check_lost_result("verify", "--worlds", "0")


class Docs(WithAxioms):
    def test_what_they_show_is_what_comes_out(self):
        page = (SOURCE / "docs/verify.md").read_text()
        shown = [re.sub(r"(?m)^    ", "", block) for block in
                 re.findall(r"(?m)^((?:    (?!asterism).*\n)+)", page)]
        self.assertEqual(len(shown), 3)
        independent, implied, change = shown
        self.assertIn(independent, run("verify", "--worlds", "0").stdout)
        optional = ["--axiom", "one_segment", "--axiom", "one_crossing"]
        self.assertIn(implied, run("verify", "--worlds", "0", *optional).stdout)
        self.replace("transitive")
        self.assertIn(change, run("verify", "--axioms", self.axioms, "--worlds", "2",
                                    "--seed", "38").stdout)

    def test_help_has_examples(self):
        self.check_help("verify")


if __name__ == "__main__":
    unittest.main(argv=[sys.argv[0], *sys.argv[3:]])

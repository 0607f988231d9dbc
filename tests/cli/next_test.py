"""Asks on the command line where to go next: next_test.py PROGRAM SOURCE_FOLDER [unittest options]."""

import copy
import json
import pathlib
import sys
import tempfile
import unittest
import xml.etree.ElementTree as xml

from program import (SOURCE, TRACES, BigTrace, Folder, ProgramTest, as_json, no_map_text, run,
                     shown_in, view)

ACES = TRACES / "aces-stubs.trace.json"
STRANGE = "a+1 b+1 c+1 d+1 e+1 f+1 a-1 b-1 c-1 d-1 e-1 f-1"


def found(*arguments):
    return as_json("next", *arguments)


def consistent(file, *arguments):
    done = run("map", file, "--certify", "0", "--json", "-", *arguments)
    return json.loads(done.stdout)["consistent"]


class Exits(Folder):
    def left(self, trace, star, *arguments):
        """The maps left if this trace went on to a place seen so, from its first arm."""
        longer = copy.deepcopy(trace)
        longer["visits"].append({"star": star, "entered_by": "a+"})
        return consistent(self.file("longer.trace.json", json.dumps(longer)), *arguments)

    def check_outlooks(self, trace, exit, *arguments):
        outlooks = exit["outlooks"]
        self.assertAlmostEqual(sum(each["chance"] for each in outlooks), 1)
        expected = sum(each["chance"] * each["left"] for each in outlooks)
        self.assertAlmostEqual(exit["expected_left"], expected, places=5)
        for outlook in outlooks:
            star = outlook["seen"] or STRANGE
            self.assertEqual(outlook["left"], self.left(trace, star, *arguments), star)
        chances = [each["chance"] for each in outlooks if each["seen"]]
        self.assertEqual(chances, sorted(chances, reverse=True))

    def test_count_what_longer_traces_leave(self):
        deeper = 0
        for name in ("aces-stubs", "grid-3x3", "square-three-laps"):
            file = TRACES / f"{name}.trace.json"
            for planar in ([], ["--planar"]):
                with self.subTest(trace=name, planar=planar):
                    code, answer = found(file, *planar)
                    maps = consistent(file, *planar)
                    self.assertEqual((code, answer["consistent"]), (0, maps))
                    sure = {}
                    for exit in answer["exits"]:
                        self.assertEqual(exit["known"] + exit["open"], maps)
                        trace = json.loads(file.read_text())
                        trace["visits"][-1]["left_by"] = exit["leave_by"]
                        if not exit["then"]:
                            self.check_outlooks(trace, exit, *planar)
                            if not exit["tells"]:
                                sure[exit["leave_by"]] = exit["outlooks"][0]["seen"]
                    for exit in answer["exits"]:
                        if len(exit["then"]) != 1:
                            continue
                        star = sure[exit["leave_by"]]
                        arm = star.split()[exit["then"][0]][:-1]
                        trace = json.loads(file.read_text())
                        trace["visits"][-1]["left_by"] = exit["leave_by"]
                        trace["visits"].append({"star": star, "entered_by": "a+", "left_by": arm})
                        self.check_outlooks(trace, exit, *planar)
                        deeper += 1
        self.assertGreater(deeper, 3)

    def test_over_minimal_models(self):
        for name in ("aces-stubs", "grid-3x3", "square-three-laps"):
            file = TRACES / f"{name}.trace.json"
            for planar in ([], ["--planar"]):
                with self.subTest(trace=name, planar=planar):
                    of_all = found(file, *planar)[1]
                    code, searched = found(file, *planar, "--over", "minimal")
                    self.assertEqual((code, searched["consistent"]), (0, None))
                    self.assertEqual(searched["options"].pop("over"), "minimal")
                    for key in ("minimal", "tell_apart"):
                        self.assertEqual(searched[key], of_all[key])
                    for exit in searched["exits"]:
                        self.assertEqual(exit["known"] + exit["open"], searched["minimal"])
                    listed = found(file, *planar, "--over", "minimal", "--max-hypotheses", "1000000")[1]
                    self.assertEqual(listed["consistent"], of_all["consistent"])
                    self.assertEqual(listed["exits"], searched["exits"])
                    text = run("next", file, *planar, "--over", "minimal").stdout
                    self.assertRegex(text, r"minimal models? explains? the trace")
                    self.assertIn("\n(counted below are the minimal models alone)\n", text)

    def test_minimal_models_of_more_maps_than_can_be_listed(self):
        walk = ["--width", 5, "--height", 5, "--travels", 60, "--seed", 1]
        file = self.file("walk.trace.json", run("simulate", *walk).stdout)
        code, answer = found(file, "--over", "minimal", "--time-limit", "60")
        self.assertEqual((code, answer["complete"], answer["minimal"]), (0, True, 15))
        self.assertEqual(answer["tell_apart"]["answer"], "found")
        for options in (["--over", "minimal", "--time-limit", "0"], ["--max-hypotheses", "1000"]):
            code, answer = found(file, *options)
            self.assertEqual((code, answer["complete"], answer["exits"]), (2, False, None))
        self.assertIn("--over minimal", run("next", file, "--max-hypotheses", "1000").stdout)

    def test_those_that_leave_fewest_come_first(self):
        exits = found(ACES, "--planar")[1]["exits"]
        order = [(not exit["tells"], exit["expected_left"]) for exit in exits]
        self.assertEqual(order, sorted(order))
        self.assertEqual([exit["tells"] for exit in exits[-2:]], [True, False])

    def test_the_text_has_the_same(self):
        _, answer = found(ACES, "--planar")
        text = run("next", ACES, "--planar").stdout
        self.assertTrue(text.startswith("55 planar maps explain the trace; the robot is where visit 14 "
                                        "was, v+1 h+0 v-1 h-1\n"), text)
        for exit in answer["exits"]:
            name = " ".join([exit["leave_by"], *map(str, exit["then"])])
            row = f"\n{name:<12} {exit['expected_left']:>12.1f}  {exit['known']:>8}  {exit['open']:>8}"
            self.assertIn(row, text)
        self.assertEqual(text.count("tells nothing"), 1)

    def test_farther_exits_are_those_nearer_and_more(self):
        def names(travels):
            exits = found(ACES, "--max-travels", travels)[1]["exits"]
            return {(exit["leave_by"], *exit["then"]) for exit in exits}

        self.assertLessEqual(names(1), names(2))
        self.assertLess(names(2), names(4))
        self.assertIs(found(ACES, "--max-travels", 1)[1]["more_exits"], True)
        self.assertIs(found(ACES, "--max-travels", 40)[1]["more_exits"], False)

    def test_one_visit(self):
        trace = {"format": "asterism/trace", "version": 1, "name": "one",
                 "visits": [{"star": "a+1 b+0 a-1 b-1"}]}
        code, answer = found(self.file("one.trace.json", json.dumps(trace)))
        self.assertEqual((code, [exit["leave_by"] for exit in answer["exits"]]), (0, ["a+", "a-", "b-"]))
        for exit in answer["exits"]:
            self.assertEqual(exit["outlooks"], [{"seen": None, "left": 1, "chance": 1.0}])

    def test_how_the_last_visit_was_left_is_no_matter(self):
        trace = json.loads(ACES.read_text())
        trace["visits"][-1]["left_by"] = "v-"
        left = self.file("left.trace.json", json.dumps(trace))
        self.assertEqual(run("next", left).stdout, run("next", ACES).stdout)

    def test_checks_and_axioms_of_maps_count(self):
        exits = found(ACES, "--planar")[1]["exits"]
        for check in ("solver", "both"):
            _, answer = found(ACES, "--planar", "--check", check)
            self.assertEqual((answer["options"]["check"], answer["exits"]), (check, exits))
        eight = TRACES / "eight-crossings.trace.json"
        _, answer = found(eight, "--axiom", "one_segment")
        self.assertEqual(answer["consistent"], 77)
        trace = json.loads(eight.read_text())
        exit = answer["exits"][0]
        self.assertEqual(exit["then"], [])
        trace["visits"][-1]["left_by"] = exit["leave_by"]
        self.check_outlooks(trace, exit, "--axiom", "one_segment")


class TellingApart(Folder):
    def walk(self, model, turns):
        """What a robot sees that goes this way through a model: a view a travel."""
        across = {tuple(a): tuple(b) for a, b in model["segments"]}
        across |= {b: a for a, b in across.items()}
        at = (model["visits"][-1], model["entered"][-1])
        seen = []
        for turn in turns:
            star = model["places"][at[0]]["star"]
            at = across.get((at[0], (at[1] + turn) % len(star.split())))
            if at is None:
                break
            seen.append(view(model["places"][at[0]]["star"], at[1]))
        return seen

    def test_models_expect_what_they_say(self):
        told = 0
        for file in sorted(TRACES.glob("*.trace.json")):
            code, answer = found(file)
            apart = answer["tell_apart"]
            models = json.loads(run("map", file, "--json", "-").stdout)["maps"]
            self.assertEqual((code, answer["minimal"]), (0, len(models)))
            if apart["answer"] != "found" or len(models) == 1:
                continue
            told += 1
            last = json.loads(file.read_text())["visits"][-1]
            arms = [arm[:-1] for arm in last["star"].split()]
            turn = (arms.index(apart["leave_by"]) - arms.index(last["entered_by"])) % len(arms)
            walks = [self.walk(model, [turn, *apart["then"]]) for model in models]
            for walk, expected in zip(walks, apart["expected"], strict=True):
                self.assertEqual([view(star, 0) for star in expected], walk[:len(expected)])
            for i, walk in enumerate(walks):
                for other in walks[:i]:
                    self.assertTrue(any(a != b for a, b in zip(walk, other)), file)
        self.assertGreaterEqual(told, 2)

    def test_one_model(self):
        _, answer = found(ACES, "--planar")
        self.assertEqual(answer["tell_apart"],
                         {"answer": "found", "leave_by": None, "then": None, "expected": [[]]})
        self.assertIn("\n1 minimal model: nothing to tell apart\n",
                      run("next", ACES, "--planar").stdout)

    def test_models_that_nothing_tells_apart(self):
        corridors = TRACES / "aces-corridors.trace.json"
        self.assertEqual(found(corridors)[1]["tell_apart"]["answer"], "none")
        self.assertIn("no row of travels is sure to tell them all apart", run("next", corridors).stdout)


class Limits(BigTrace):
    def test_undecided(self):
        for limit in (["--max-hypotheses", "1000"], ["--time-limit", "0"]):
            with self.subTest(limit=limit):
                code, answer = found(self.big, *limit)
                self.assertEqual((code, answer["complete"], answer["exits"]), (2, False, None))
                self.assertTrue(answer["stopped_by"])
                self.assertIsNone(answer["consistent"])
        done = run("next", self.big, "--max-hypotheses", "1000")
        self.assertTrue(done.stdout.startswith("undecided, stopped by limit of 1000 hypotheses\n"))

    def test_a_limit_that_is_not_reached_changes_nothing(self):
        limits = ["--max-hypotheses", "107", "--time-limit", "1000"]
        self.assertEqual(run("next", ACES, *limits).stdout, run("next", ACES).stdout)

    def test_no_map(self):
        file = self.file("no.trace.json", no_map_text())
        done = run("next", file)
        self.assertEqual((done.returncode, done.stdout),
                         (1, "no map explains the trace: none is left after visit 2\n"))
        code, answer = found(file)
        self.assertEqual((code, answer["consistent"], answer["exits"]), (1, 0, None))
        self.assertEqual((answer["complete"], answer["tell_apart"]), (True, None))


class Files(Folder):
    def test_same_bytes_and_both_outputs(self):
        file = self.folder / "exits.json"
        first = run("next", ACES, "--json", "-").stdout
        text = run("next", ACES, "--json", file).stdout
        self.assertEqual(file.read_text(), first)
        self.assertEqual(text, run("next", ACES).stdout)
        self.assertEqual(run("next", "-", stdin=ACES.read_text()).stdout, text)

    def test_a_picture(self):
        file = self.folder / "exits.svg"
        run("next", ACES, "--max-travels", "4", "--svg", file)
        exits = found(ACES, "--max-travels", "4")[1]["exits"]
        space = "{http://www.w3.org/2000/svg}"
        root = xml.parse(file).getroot()
        self.assertEqual(len(root.findall(f".//{space}circle")),
                         sum(len(exit["outlooks"]) for exit in exits))
        texts = [text.text for text in root.findall(f".//{space}text")]
        for exit in exits:
            self.assertIn(" ".join([exit["leave_by"], *map(str, exit["then"])]), texts)
        self.assertIn("now 107", texts)
        self.assertEqual(run("next", ACES, "--svg", "/dev/null/exits.svg").returncode, 70)

    def test_bad_input(self):
        self.refused(65, "next", self.folder / "missing.trace.json")
        self.refused(65, "next", ACES, "--axiom", "no_such")
        folder = self.own_axioms()
        same = run("next", ACES, "--axioms", folder)
        self.assertEqual((same.returncode, same.stdout), (0, run("next", ACES).stdout))
        topological = folder / "topological.smt2"
        text = topological.read_text()
        topological.write_text(text[:text.index("(assert (! (forall ((q DState) (r DState) (s DState))")])
        for check in ([], ["--check", "solver"]):
            self.assertIn("--axioms: found other axioms",
                          self.refused(65, "next", ACES, "--axioms", folder, *check))

    def test_usage(self):
        for arguments in ([], [ACES, ACES], [ACES, "--max-travels", "0"], [ACES, "--max-travels", "x"],
                          [ACES, "--max-hypotheses", "-1"], [ACES, "--time-limit", "x"]):
            with self.subTest(arguments=arguments):
                self.refused(64, "next", *arguments)

    def test_a_result_that_got_lost(self):
        self.check_lost_result("next", ACES)


class Docs(ProgramTest):
    def test_what_they_show_is_what_comes_out(self):
        self.check_shown(shown_in("docs/next.md", "next"), 2)

    def test_their_picture_is_drawn_so(self):
        with tempfile.TemporaryDirectory() as folder:
            file = pathlib.Path(folder) / "exits.svg"
            run("next", SOURCE / "examples/aces-stubs.trace.json", "--planar", "--svg", file)
            self.assertEqual((SOURCE / "docs/aces-exits.svg").read_text(), file.read_text())

    def test_help_has_examples(self):
        self.check_help("next")


if __name__ == "__main__":
    unittest.main(argv=[sys.argv[0], *sys.argv[3:]])

"""Tests of `asterism map --minimal`: what is found, limits, checkpoints, bad input.

usage: minimal_test.py PROGRAM SOURCE_FOLDER [--full] [unittest options]
"""

import json
import random
import signal
import subprocess
import sys
import time
import unittest

from program import PROGRAM, SOURCE, Folder, as_json, run, trace_text

FULL = "--full" in sys.argv
KILLS = 50 if FULL else 4
ACES = SOURCE / "examples" / "aces-stubs.trace.json"
SQUARE = SOURCE / "examples" / "05_square.trace.json"


def report(*arguments):
    return as_json("map", *arguments)


def hub(arms):
    """Out and back along each arm of a hub, to crossings that may be the same in many ways.

              |   |   |
           ---C---C---C---   those that are one: seen from other sides
               \\  |  /
                \\ | /
                 hub
    """
    half = arms // 2
    star = " ".join([f"p{i}+1" for i in range(half)] + [f"p{i}-1" for i in range(half)])
    names = [f"p{i}+" for i in range(half)] + [f"p{i}-" for i in range(half)]
    visits = []
    for i, name in enumerate(names):
        visits.append({"star": star, "left_by": name} | ({"entered_by": names[i - 1]} if i else {}))
        visits.append({"star": "c+1 d+1 c-1 d-1", "entered_by": "c+", "left_by": "c+"})
    del visits[-1]["left_by"]
    return trace_text(*visits, name=f"hub-{arms}")


class Search(Folder):
    def grid(self, side, travels, missing, seed):
        trace = self.folder / f"grid-{side}-{seed}.trace.json"
        size = ["--width", side, "--height", side, "--travels", travels, "--missing", missing]
        self.assertEqual(run("simulate", *size, "--seed", seed, "-o", trace).returncode, 0)
        return trace


class Minimal(Search):
    def test_the_search_finds_what_the_list_has(self):
        hub_8 = self.file("hub.trace.json", hub(8))
        no_path_twice = ["--axiom", "one_crossing"]
        for options in [[], ["--planar"], ["--assume", "same(0, 8)"], no_path_twice]:
            for trace in (ACES, hub_8):
                code, listed = report(trace, "--certify", 0, *options)
                again, found = report(trace, "--minimal", *options)
                self.assertEqual(again, code)
                self.assertEqual(found["minimal"], listed["minimal"])
                self.assertEqual(found["maps"], listed["maps"])
                self.assertEqual((found["consistent"], found["per_visit"]), (None, None))
                self.assertTrue(found["complete"])
                self.assertEqual(found["options"]["method"], "search")
                self.assertNotIn("method", listed["options"])

    def test_the_preference_of_a_folder_of_axioms_counts(self):
        folder = self.own_axioms()
        preference = (folder / "preference.smt2").read_text()
        self.assertIn("(path place)", preference)
        (folder / "preference.smt2").write_text(preference.replace("path place", "place path"))
        code, listed = report(ACES, "--certify", 0, "--axioms", folder)
        self.assertEqual(listed["options"]["preference"], ["place", "path"])
        again, found = report(ACES, "--minimal", "--axioms", folder)
        self.assertEqual((again, found["maps"]), (code, listed["maps"]))
        self.assertEqual(found["options"]["method"], "search")

    def test_what_the_search_does_not_know_is_listed_and_said(self):
        folder = self.own_axioms()
        topological = (folder / "topological.smt2").read_text()
        end = topological.index(":named axiom.irreflexive))") + len(":named axiom.irreflexive))")
        begin = topological.rindex("(assert", 0, end)
        (folder / "topological.smt2").write_text(topological[:begin] + topological[end:])
        small = self.file("hub.trace.json", hub(4))
        for options in (["--axioms", folder], ["--check", "both"], ["--check", "solver"]):
            code, found = report(small, "--minimal", *options)
            self.assertEqual(code, 0, options)
            self.assertEqual(found["options"]["method"], "listing")
            self.assertIsNotNone(found["consistent"])
            text = run("map", small, "--minimal", *options).stdout
            self.assertIn("\nminimal models chosen from all maps, listed\n", text)
        done = run("map", small, "--minimal", "--check", "both", "--checkpoint", "c.json")
        self.assertEqual(done.returncode, 65)
        self.assertIn("--checkpoint: found a search that lists all maps; expected", done.stderr)

    def test_a_trace_of_the_basic_ssh_is_listed_and_said(self):
        code, found = report(SQUARE, "--minimal")
        self.assertEqual((code, found["options"]["method"]), (0, "listing"))
        text = run("map", SQUARE, "--minimal").stdout
        self.assertIn("\nminimal models chosen from all maps, listed\n", text)
        done = run("map", SQUARE, "--minimal", "--checkpoint", self.folder / "c.json")
        self.assertEqual(done.returncode, 65)

    def test_the_text_says_how_it_is_known(self):
        text = run("map", ACES, "--minimal", "--planar").stdout
        self.assertIn("\nminimal models searched for, maps not listed\n", text)
        self.assertIn(
            "\n1 minimal model: 6 paths, 9 places; proved minimal by exhausted search\n", text
        )
        self.assertIn("\nmodel 0\n", text)
        certified = run("map", ACES, "--minimal", "--planar", "--certify", 10).stdout
        self.assertIn("proved minimal by exhausted search, certified by the solver\n", certified)
        many = run("map", self.file("hub.trace.json", hub(8)), "--minimal").stdout
        self.assertIn("\n960 minimal models: 4 paths, 5 places; proved", many)
        self.assertTrue(many.endswith("\n(940 more: see --json)\n"))

    def test_no_map(self):
        code, found = report(ACES, "--minimal", "--assume", "differ(0, 8)", "--assume", "same(0, 8)")
        self.assertEqual((code, found["minimal"], found["maps"]), (1, None, []))
        self.assertTrue(found["complete"])
        both = ["--assume", "differ(0, 8)", "--assume", "same(0, 8)"]
        none_left = "\nno map explains the trace under these assumptions: none is left after visit 8\n"
        for how in ([], ["--minimal"]):
            self.assertIn(none_left, run("map", ACES, *how, *both).stdout)
        self.assertEqual((found["consistent"], found["explained"]), (0, 8))

    def test_drawings(self):
        pictures = self.folder / "svg"
        pictures.mkdir()
        (pictures / "hypotheses.svg").write_text("of an earlier run")
        done = run("map", ACES, "--minimal", "--svg", pictures)
        self.assertEqual(done.returncode, 0)
        self.assertEqual(len(list(pictures.glob("model-*.svg"))), 6)
        self.assertFalse((pictures / "hypotheses.svg").exists())

    def test_any_number_of_threads_gives_the_same_bytes(self):
        trace = self.grid(7, 100, 0.3, 1)
        first, *others = (
            run("map", trace, "--minimal", "--jobs", jobs, "--json", "-").stdout for jobs in (1, 2, 4)
        )
        self.assertIn('"complete": true', first)
        for other in others:
            self.assertEqual(other, first)

    def test_usage(self):
        for options in (
            ["--minimal", "--all"],
            ["--minimal", "--max-hypotheses", 9],
            ["--minimal", "--why-not", "0,1"],
            ["--minimal", "--jobs", 0],
            ["--minimal", "--jobs", "two"],
            ["--minimal", "--resume"],
            ["--minimal", "--checkpoint-every", 1],
            ["--minimal", "--checkpoint", "c.json", "--checkpoint-every", -1],
            ["--jobs", 2],
            ["--checkpoint", "c.json"],
            ["--memory-limit", 0],
            ["--memory-limit", "2T"],
            ["--memory-limit", "18446744073709551615G"],
            ["--time-limit", "1m"],
            ["--time-limit", "s"],
        ):
            done = run("map", ACES, *options)
            self.assertEqual(done.returncode, 64, options)
            self.assertEqual(len(done.stderr.splitlines()), 1, options)


class Limits(Search):
    def stopped(self, trace, *options, by):
        file = self.folder / "stopped.maps.json"
        done = run("map", trace, "--json", file, *options)
        self.assertEqual(done.returncode, 2, done.stderr)
        self.assertIn(f"\nstopped by {by}", done.stdout)
        self.assertEqual(run("validate", file).returncode, 0)
        found = json.loads(file.read_text())
        self.assertEqual((found["complete"], found["stopped_by"]), (False, by))
        self.assertIsNone(found["minimal"])
        return done.stdout, found

    def test_stopped_by_time(self):
        trace = self.file("hub.trace.json", hub(14))
        text, found = self.stopped(trace, "--minimal", "--time-limit", "0.5s", by="time limit")
        best = found["bounds"]["best"]
        proved = found["bounds"]["paths_at_least"]
        self.assertLessEqual(proved, 7)  # the truth
        self.assertGreaterEqual(best["paths"], 7)
        self.assertEqual(len(found["maps"]), min(best["count"], 100))
        known = f"{best['paths']} paths, {best['places']} places, {best['count']} map"
        self.assertIn(f"\npaths ≥ {proved} proved; best so far {known}", text)
        self.assertEqual(found["options"]["time_limit_s"], 0.5)

    def test_stopped_before_it_began(self):
        text, found = self.stopped(ACES, "--minimal", "--time-limit", "0", by="time limit")
        self.assertEqual(found["bounds"], {"paths_at_least": 0, "best": None})
        self.assertIn("\npaths ≥ 0 proved; no map found so far\n", text)

    def test_stopped_by_memory(self):
        trace = self.file("hub.trace.json", hub(14))
        for options in (["--minimal"], ["--minimal", "--jobs", 2], []):
            _, found = self.stopped(trace, "--memory-limit", "40M", *options, by="memory limit")
            self.assertEqual(found["options"]["memory_limit_bytes"], 40 << 20)
            self.assertEqual("bounds" in found, "--minimal" in options)

    def test_all_maps_that_do_not_fit_are_not_listed(self):
        trace = self.file("hub.trace.json", hub(10))
        _, found = self.stopped(trace, "--memory-limit", "20M", "--all", by="memory limit")
        self.assertEqual(found["maps"], [])

    def test_stopped_by_signal(self):
        trace = self.file("hub.trace.json", hub(14))
        checkpoint = self.folder / "hub.checkpoint.json"
        options = ["--minimal", "--json", "-", "--checkpoint", checkpoint, "--checkpoint-every", "0"]
        for number, by in ((signal.SIGINT, "interrupt"), (signal.SIGTERM, "termination")):
            checkpoint.unlink(missing_ok=True)
            running = subprocess.Popen(
                [PROGRAM, "map", trace, *options], stdout=subprocess.PIPE, stderr=subprocess.PIPE
            )
            while not checkpoint.exists() and running.poll() is None:
                time.sleep(0.01)
            running.send_signal(number)
            found = json.loads(running.communicate(timeout=60)[0])
            self.assertEqual((running.returncode, found["stopped_by"]), (2, by))
            self.assertEqual(run("validate", checkpoint).returncode, 0)


class Checkpoints(Search):
    def test_a_run_that_is_killed_goes_on_to_the_same_bytes(self):
        """Each round is killed until its own time is enough, from another moment each time."""
        trace = self.grid(6, 100, 0, 5) if FULL else self.grid(6, 100, 0.1, 3)
        checkpoint = self.folder / "grid.checkpoint.json"
        result = self.folder / "grid.maps.json"
        begin = time.monotonic()
        self.assertEqual(run("map", trace, "--minimal", "--json", result).returncode, 0)
        whole_s = time.monotonic() - begin
        expected = result.read_bytes()
        result.unlink()
        moments = random.Random(7)
        kills = rounds = resumed = 0
        while kills < KILLS:
            options = ["--minimal", "--jobs", 1 + rounds % 2, "--json", result, "--resume"]
            options += ["--checkpoint", checkpoint, "--checkpoint-every", 0.02]
            command = [PROGRAM, "map", trace, *map(str, options)]
            after_s = moments.uniform(0.02, 0.6 * whole_s) if kills < KILLS else 600
            running = subprocess.Popen(
                command, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL
            )
            while kills == 0 and not checkpoint.exists() and running.poll() is None:
                time.sleep(0.001)  # or no run might come to one before it is killed
            try:
                running.wait(after_s)
            except subprocess.TimeoutExpired:
                running.kill()
                running.wait()
                kills += 1
                resumed += checkpoint.exists()
                continue
            self.assertEqual(running.returncode, 0)
            self.assertEqual(result.read_bytes(), expected)
            self.assertFalse(checkpoint.exists())
            result.unlink()
            rounds += 1
        self.assertGreater(resumed, 0)
        done = run("map", trace, *options)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertEqual(result.read_bytes(), expected)

    def test_stopped_and_resumed_is_as_never_stopped(self):
        trace = self.file("hub.trace.json", hub(12))
        checkpoint = self.folder / "hub.checkpoint.json"
        expected = run("map", trace, "--minimal").stdout
        options = ["--minimal", "--checkpoint", checkpoint]
        self.assertEqual(run("map", trace, *options, "--time-limit", "0.1").returncode, 2)
        self.assertEqual(run("validate", checkpoint).returncode, 0)
        done = run("map", trace, *options, "--resume", "--jobs", 2)
        self.assertEqual((done.returncode, done.stdout), (0, expected))
        self.assertFalse(checkpoint.exists())

    def test_without_a_checkpoint_it_begins_and_says_so(self):
        checkpoint = self.folder / "none.checkpoint.json"
        done = run("map", ACES, "--minimal", "--checkpoint", checkpoint, "--resume")
        self.assertEqual(done.returncode, 0)
        self.assertIn("no checkpoint to resume from; the search begins afresh", done.stderr)

    def test_a_file_that_is_there_is_kept(self):
        note = self.file("note.txt", "mine")
        written = note.read_bytes()
        done = run("map", ACES, "--minimal", "--checkpoint", note)
        self.assertEqual(done.returncode, 65)
        self.assertIn("found a file that is there already; expected none, or --resume", done.stderr)
        self.assertEqual(run("map", ACES, "--minimal", "--checkpoint", note, "--resume").returncode, 65)
        self.assertEqual(note.read_bytes(), written)
        folder = self.folder / "folder"
        folder.mkdir()
        done = run("map", ACES, "--minimal", "--checkpoint", folder, "--resume")
        self.assertEqual(done.returncode, 65)
        same = self.folder / "same.json"
        done = run("map", ACES, "--minimal", "--checkpoint", same, "--json", same)
        self.assertEqual(done.returncode, 65)
        self.assertFalse(same.exists())

    def test_another_search_is_refused(self):
        checkpoint = self.folder / "aces.checkpoint.json"
        options = ["--minimal", "--checkpoint", checkpoint]
        self.assertEqual(run("map", ACES, *options, "--time-limit", 0).returncode, 2)
        before = checkpoint.read_bytes()
        for trace, more, place in (
            (self.file("hub.trace.json", hub(4)), [], "/digest"),
            (ACES, ["--planar"], "/options/planar"),
            (ACES, ["--assume", "same(0, 8)"], "/options/assumptions"),
            (ACES, ["--axiom", "one_crossing"], "/options/optional_axioms"),
        ):
            done = run("map", trace, *options, "--resume", *more)
            self.assertEqual(done.returncode, 65)
            self.assertRegex(done.stderr, rf"^asterism: {checkpoint}:{place}: found .*; expected ")
            self.assertEqual(len(done.stderr.splitlines()), 1)
        self.assertEqual(checkpoint.read_bytes(), before)

    def test_what_cannot_be_a_state_is_refused(self):
        trace = self.file("hub.trace.json", hub(14))
        checkpoint = self.folder / "hub.checkpoint.json"
        options = ["--minimal", "--checkpoint", checkpoint]
        self.assertEqual(run("map", trace, *options, "--time-limit", 0.1).returncode, 2)
        good = json.loads(checkpoint.read_text())
        for key, value in (
            ("models", ["0 1 2"]),
            ("incumbent", " ".join(["0"] * 28)),
            ("branches", [{"decided": "0", "next": "99999999"}]),
            ("limit", 2**64 - 1),
        ):
            changed = {"models": []} if key == "incumbent" else {}
            checkpoint.write_text(json.dumps(good | changed | {key: value}))
            done = run("map", trace, *options, "--resume")
            self.assertEqual(done.returncode, 65, (key, value))
            self.assertTrue(done.stderr.startswith(f"asterism: {checkpoint}:"), done.stderr)
            self.assertEqual(len(done.stderr.splitlines()), 1)
        checkpoint.write_text("{")
        self.assertEqual(run("map", trace, *options, "--resume").returncode, 65)


if __name__ == "__main__":
    names = [word for word in sys.argv[3:] if word != "--full"]
    if FULL:
        names.append("Checkpoints.test_a_run_that_is_killed_goes_on_to_the_same_bytes")
    unittest.main(argv=[sys.argv[0], *names])

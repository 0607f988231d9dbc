"""Fifty simulated buildings, perceived and compared with the truth.

buildings_test.py PROGRAM SOURCE_FOLDER [unittest options]
"""

import json
import sys
import unittest

from program import Folder, arm_number, run, view


def same(seen, true):
    """Whether a star is the true one, and was entered and left by the true arms."""
    count = len(true["star"].split())
    if len(seen["star"].split()) != count:
        return False
    for turn in range(count):
        if view(seen["star"], turn) != view(true["star"], 0):
            continue
        ways = [
            (arm_number(seen["star"], seen.get(way)), arm_number(true["star"], true.get(way)))
            for way in ("entered_by", "left_by")
        ]
        if all(None in (s, t) or s == (t + turn) % count for s, t in ways):
            return True
    return False


class Buildings(Folder):
    def visits(self, seed):
        log, true, seen = (self.folder / name for name in ("log", "true.json", "seen.json"))
        options = ["--building", "office", "--seed", seed, "--travels", 10]
        done = run("simulate", *options, "-o", log, "--true-trace", true)
        self.assertEqual(done.returncode, 0, done.stderr)
        done = run("perceive", log, "-o", seen)
        self.assertEqual(done.returncode, 0, done.stderr)
        return [json.loads(file.read_text())["visits"] for file in (seen, true)]

    def test_stars_and_arms(self):
        count, right, strays = 0, 0, []
        for seed in range(1001, 1051):
            seen, true = self.visits(seed)
            count += len(true)
            matched = set()
            for number, visit in enumerate(true):
                first, last = visit["scans"]
                here = [i for i, one in enumerate(seen)
                        if one["scans"][0] <= last and one["scans"][1] >= first]  # fmt: skip
                matched.update(here)
                right += len(here) == 1 and same(seen[here[0]], visit)
                if len(here) != 1:
                    strays.append((seed, number, len(here)))
            strays += [(seed, seen[i]["scans"]) for i in range(len(seen)) if i not in matched]
        print(f"{count} visits: {right} right, missed or false: {strays}")
        self.assertGreaterEqual(right, 0.99 * count)
        self.assertLessEqual(len(strays), count / 200, strays)


if __name__ == "__main__":
    unittest.main(argv=[sys.argv[0], *sys.argv[3:]])

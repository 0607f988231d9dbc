"""Fifty simulated buildings, mapped and compared with the truth.

buildings_test.py PROGRAM SOURCE_FOLDER [unittest options]
"""

import concurrent.futures
import json
import math
import os
import pathlib
import sys
import tempfile
import unittest

from poses import between, logarithm, mean_band, normalised_squared, read_trajectory
from program import arm_number, run, view
from routes import bad_routes

SEEDS = range(1001, 1051)


def turned(seen, true):
    """Where the true star's first arm is in the star seen.

    None unless the star is the true one, and was entered and left by the true arms.
    """
    count = len(true["star"].split())
    if len(seen["star"].split()) != count:
        return None
    for turn in range(count):
        if view(seen["star"], turn) != view(true["star"], 0):
            continue
        ways = [
            (arm_number(seen["star"], seen.get(way)), arm_number(true["star"], true.get(way)))
            for way in ("entered_by", "left_by")
        ]
        if all(None in (s, t) or s == (t + turn) % count for s, t in ways):
            return turn
    return None


class Mapped:
    """What was made of one building, and the truth."""

    def __init__(self, seed, folder):
        self.seed = seed
        log = folder / "log"
        truth = [folder / name for name in ("trace.json", "map.json", "trajectory.tum")]
        options = ["--building", "office", "--seed", seed, "--travels", 10, "-o", log]
        for option, file in zip(("--true-trace", "--true-map", "--true-trajectory"), truth):
            options += [option, file]
        self.done = [run("simulate", *options)]
        options = ["--models", 1, "--certify", 0, "--resolution", 0.2, "--json"]
        self.done.append(run("run", log, "-o", folder / "found", *options))
        if any(done.returncode not in (0, 1) for done in self.done):
            return
        self.true = json.loads(truth[0].read_text())["visits"]
        self.true_map = json.loads(truth[1].read_text())["maps"][0]
        self.poses = read_trajectory(truth[2])
        self.seen = json.loads((folder / "found/log.trace.json").read_text())["visits"]
        self.bad_routes = bad_routes(folder / "found")
        self.ranked = json.loads((folder / "found/maps.json").read_text())["ranked"][0]
        self.compare_traces()

    def compare_traces(self):
        """Which visits were right, and which missed or made up."""
        self.turns, self.strays = [], []
        matched = set()
        for number, visit in enumerate(self.true):
            first, last = visit["scans"]
            here = [i for i, one in enumerate(self.seen)
                    if one["scans"][0] <= last and one["scans"][1] >= first]  # fmt: skip
            matched.update(here)
            self.turns.append(turned(self.seen[here[0]], visit) if len(here) == 1 else None)
            if len(here) != 1:
                self.strays.append((self.seed, number, len(here)))
        self.strays += [(self.seed, one["scans"]) for i, one in enumerate(self.seen)
                        if i not in matched]  # fmt: skip

    def trace_is_right(self):
        return None not in self.turns and not self.strays

    def map_is_true(self):
        """Whether the map ranked first has each visit at its place, entered by its arm."""
        if self.ranked["visits"] != self.true_map["visits"]:
            return False
        places = self.true_map["places"]
        for visit, place in enumerate(self.true_map["visits"]):
            if visit == 0:
                continue
            turn = self.turns[places[place]["first_visit"]]
            arms = len(places[place]["star"].split())
            if self.ranked["entered"][visit] != (self.true_map["entered"][visit] + turn) % arms:
                return False
        return True

    def place_errors(self):
        """From where each place but the first is by the layout to where it is, by its frame."""
        firsts = [place["first_visit"] for place in self.ranked["places"]]
        truth = [self.poses[self.seen[visit]["scans"][0]] for visit in firsts]
        found = [(pose["x_m"], pose["y_m"], pose["heading_rad"]) for pose in self.ranked["layout"]]
        return [logarithm(between(pose, between(truth[0], true)))
                for pose, true in list(zip(found, truth))[1:]]  # fmt: skip

    def last_place_misfit(self):
        """Squared error of the place first seen last, by its covariance."""
        return normalised_squared(self.place_errors()[-1], self.ranked["layout"][-1]["covariance"])


class Buildings(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        def mapped(seed):
            with tempfile.TemporaryDirectory() as folder:
                return Mapped(seed, pathlib.Path(folder))

        with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
            cls.all = list(pool.map(mapped, SEEDS))
        for building in cls.all:
            for done in building.done:
                assert done.returncode in (0, 1), (building.seed, done.stderr)
        cls.right = [one for one in cls.all if one.trace_is_right()]
        cls.true = [one for one in cls.right if one.map_is_true()]

    def test_stars_and_arms(self):
        count = sum(len(one.true) for one in self.all)
        right = sum(turn is not None for one in self.all for turn in one.turns)
        strays = [stray for one in self.all for stray in one.strays]
        print(f"{count} visits: {right} right, missed or false: {strays}")
        self.assertGreaterEqual(right, 0.99 * count)
        self.assertLessEqual(len(strays), count / 200, strays)

    def test_the_map_ranked_first_is_the_true_one(self):
        wrong = [one.seed for one in self.right if one not in self.true]
        print(f"{len(self.all)} buildings: {len(self.right)} traces right, of these "
              f"{len(self.true)} maps; the wrong ones: {wrong}")  # fmt: skip
        self.assertGreaterEqual(len(self.true), 0.95 * len(self.right))

    def test_places_are_where_the_layout_says(self):
        errors = [error for one in self.true for error in one.place_errors()]
        position_m = math.sqrt(sum(x * x + y * y for x, y, _ in errors) / len(errors))
        heading_rad = math.sqrt(sum(turn * turn for _, _, turn in errors) / len(errors))
        print(f"{len(errors)} places: {position_m:.3f} m and {math.degrees(heading_rad):.2f}° RMSE")
        self.assertLessEqual(position_m, 0.3)
        self.assertLessEqual(heading_rad, math.radians(2))

    def test_routes_lead_through_no_wall(self):
        bad = [(one.seed, one.bad_routes) for one in self.all if one.bad_routes]
        print(f"routes of {len(self.all)} buildings; through walls or unknown ground: {bad}")
        self.assertEqual(bad, [])

    def test_no_two_places_of_a_true_map_share_a_spot(self):
        shared = [(one.seed, one.ranked["shared_spots"]) for one in self.true
                  if "shared_spots" in one.ranked]  # fmt: skip
        print(f"{len(self.true)} true maps; of these with two places on one spot: {shared}")
        self.assertEqual(shared, [])

    def test_covariances_are_honest(self):
        misfits = [one.last_place_misfit() for one in self.true]
        mean = sum(misfits) / len(misfits)
        least, most = mean_band(len(misfits))
        print(f"squared error of the last place, by its covariance: {mean:.2f} in the mean; "
              f"expected {least:.2f} to {most:.2f}")  # fmt: skip
        self.assertGreaterEqual(mean, least)
        self.assertLessEqual(mean, most)


if __name__ == "__main__":
    unittest.main(argv=[sys.argv[0], *sys.argv[3:]])

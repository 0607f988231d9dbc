"""The ACES log, perceived and mapped; skipped where the data are absent.

aces_test.py PROGRAM SOURCE_FOLDER [unittest options]
"""

import json
import math
import os
import pathlib
import sys
import unittest

from program import SOURCE, Folder, run, view

DATA = pathlib.Path(os.environ.get("ASTERISM_DATA", SOURCE / "../shared/data"))
LOG = DATA / "aces/aces.log.xz"

# Place, the scans within it, and the turn to the right there, of each visit: data/aces/places.md.
VISITS = [
    ("N", 0, 347, None), ("NE", 641, 961, 90), ("E", 1204, 1547, 0), ("SE", 1843, 2064, 90),
    ("S", 2259, 2493, 0), ("SW", 2746, 2994, 90), ("W", 3198, 3451, 0), ("NW", 3641, 3889, 90),
    ("N", 4053, 4422, 90), ("C", 4535, 4792, 0), ("S", 4883, 5132, 180), ("C", 5296, 5532, -90),
    ("W", 5742, 5975, 180), ("C", 6123, 6468, 0), ("E", 6713, 6987, 180),
]  # fmt: skip


def turn_deg(visit):
    """To the right, between the headings of the gateways entered and left by; within 180°."""
    heading = {gateway["arm"]: gateway["heading_rad"] for gateway in visit["gateways"]}
    turn = heading[visit["entered_by"]] + math.pi - heading[visit["left_by"]]
    return math.degrees(math.remainder(turn, 2 * math.pi))


def faults(visits):
    """What is not as it is in the building: places, their order, their stars, the turns."""
    if len(visits) != len(VISITS):
        return [f"{len(visits)} visits"]
    found, stars = [], {}
    for visit, (place, first, last, turn) in zip(visits, VISITS):
        if visit["scans"][0] > last or visit["scans"][1] < first:
            found.append(f"scans {visit['scans']} are not at {place}")
        star = visit["star"]
        views = {str(view(star, arm)) for arm in range(len(star.split()))}
        if not views & stars.setdefault(place, views):
            found.append(f"{place} has another star: {star}")
        if turn is not None and abs(math.remainder(turn_deg(visit) - turn, 360)) > 60:
            found.append(f"turn of {turn_deg(visit):.0f} at {place}")
    return found


class Aces(Folder):
    def perceive(self, *options):
        trace = self.folder / "aces.trace.json"
        done = run("perceive", LOG, "-o", trace, *options)
        self.assertEqual(done.returncode, 0, done.stderr)
        return trace, json.loads(trace.read_text())["visits"]

    def test_its_visits_and_the_true_map_among_the_planar_ones(self):
        trace, visits = self.perceive()
        maps = self.folder / "aces.maps.json"
        self.assertEqual(faults(visits), [])
        for visit in visits[1:]:
            self.assertGreater(visit["displacement"]["covariance"][0], 0)

        done = run("map", trace, "--planar", "--certify", "0", "--all", "--json", maps)
        self.assertEqual(done.returncode, 0, done.stderr)
        numbers = {}
        true_map = [numbers.setdefault(place, len(numbers)) for place, *_ in VISITS]
        listed = [one["visits"] for one in json.loads(maps.read_text())["maps"]]
        self.assertIn(true_map, listed)

    def test_whichever_way_the_map_lies(self):
        wrong = {}
        for heading in range(0, 91, 5):
            found = faults(self.perceive("--heading", heading)[1])
            if found:
                wrong[heading] = found
        self.assertLessEqual(len(wrong), 2, wrong)


if __name__ == "__main__":
    if not LOG.is_file():
        sys.exit(77)
    unittest.main(argv=[sys.argv[0], *sys.argv[3:]])

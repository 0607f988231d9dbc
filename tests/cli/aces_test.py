"""The ACES log, perceived and mapped; skipped where the data are absent.

aces_test.py PROGRAM SOURCE_FOLDER [unittest options]
"""

import json
import os
import pathlib
import sys
import unittest

from program import SOURCE, Folder, run

DATA = pathlib.Path(os.environ.get("ASTERISM_DATA", SOURCE / "../shared/data"))
LOG = DATA / "aces/aces.log.xz"

# Place, and the scans within it, of each visit: data/aces/places.md.
VISITS = [
    ("N", 0, 347), ("NE", 641, 961), ("E", 1204, 1547), ("SE", 1843, 2064), ("S", 2259, 2493),
    ("SW", 2746, 2994), ("W", 3198, 3451), ("NW", 3641, 3889), ("N", 4053, 4422),
    ("C", 4535, 4792), ("S", 4883, 5132), ("C", 5296, 5532), ("W", 5742, 5975),
    ("C", 6123, 6468), ("E", 6713, 6987),
]  # fmt: skip


class Aces(Folder):
    def test_its_visits_and_the_true_map_among_the_planar_ones(self):
        trace, maps = self.folder / "aces.trace.json", self.folder / "aces.maps.json"
        done = run("perceive", LOG, "-o", trace)
        self.assertEqual(done.returncode, 0, done.stderr)
        visits = json.loads(trace.read_text())["visits"]
        self.assertEqual(len(visits), len(VISITS), done.stdout)
        for visit, (place, first, last) in zip(visits, VISITS):
            self.assertLessEqual(visit["scans"][0], last, place)
            self.assertGreaterEqual(visit["scans"][1], first, place)

        done = run("map", trace, "--planar", "--certify", "0", "--all", "--json", maps)
        self.assertEqual(done.returncode, 0, done.stderr)
        numbers = {}
        true_map = [numbers.setdefault(place, len(numbers)) for place, _, _ in VISITS]
        listed = [one["visits"] for one in json.loads(maps.read_text())["maps"]]
        self.assertIn(true_map, listed)


if __name__ == "__main__":
    if not LOG.is_file():
        sys.exit(77)
    unittest.main(argv=[sys.argv[0], *sys.argv[3:]])

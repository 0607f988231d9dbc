"""Where the routes of a run lead, on its global map."""

import json
import math
import re


class Floor:
    """The global map of a run: map.yaml and map.pgm."""

    def __init__(self, folder):
        described = (folder / "map.yaml").read_text()
        self.resolution = float(re.search(r"resolution: (\S+)", described)[1])
        origin = re.search(r"origin: \[(.*)\]", described)[1]
        self.left, self.bottom, turn = map(float, origin.split(","))
        assert turn == 0
        data = (folder / "map.pgm").read_bytes()
        head = re.match(rb"P5\s+(\d+)\s+(\d+)\s+255\s", data)
        self.width, self.height = int(head[1]), int(head[2])
        self.greys = data[head.end():]  # fmt: skip

    def grey(self, x, y):
        """0 is a wall, 254 free, all else unknown."""
        column = math.floor((x - self.left) / self.resolution)
        row = math.floor((y - self.bottom) / self.resolution)
        if not (0 <= column < self.width and 0 <= row < self.height):
            return 205
        return self.greys[(self.height - 1 - row) * self.width + column]


def bad_routes(folder):
    """Of all routes of a run's best map those over a wall, or over 0.3 m of unknown ground or more:
    the places they join, metres over walls, metres unknown."""
    floor = Floor(folder)
    bad = []
    for route in json.loads((folder / "routes.geojson").read_text())["features"]:
        if route["geometry"]["type"] != "MultiLineString":
            continue
        wall, unknown = 0, 0
        line = route["geometry"]["coordinates"][0]
        for (x0, y0), (x1, y1) in zip(line, line[1:]):
            length = math.hypot(x1 - x0, y1 - y0)
            parts = max(1, math.ceil(length / 0.01))
            for part in range(parts):
                share = (part + 0.5) / parts
                grey = floor.grey(x0 + share * (x1 - x0), y0 + share * (y1 - y0))
                wall += length / parts * (grey == 0)
                unknown += length / parts * (grey not in (0, 254))
        if wall > 0 or unknown > 0.3:
            ends = [route["properties"][end] for end in ("startid", "endid")]
            bad.append((*ends, round(wall, 2), round(unknown, 2)))
    return bad

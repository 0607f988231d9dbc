"""A detector of one's own, as a program: asterism perceive LOG --detector-command 'python3 ...'.

Reads scans from standard input and writes visits to standard output, one JSON object a line; see
docs/detectors.md. Whatever speaks these lines will do, in any language.

The robot halts for two seconds at least wherever corridors meet, looks round, and drives on.
Corridors are at right angles, and it halts facing along one. So a star has four arms at most:
ahead, right, behind, left.
"""

import json
import math
import sys

STILL_M = 0.05  # a robot that halts moves less
AWAY_M = 0.5  # one that has left a place has moved more
HALT_S = 2.0
FAR_M = 3.0  # a wall so near is no way out
NARROW_RAD = math.radians(10)  # how far from straight ahead, right, ... one looks

ARMS = ["a+", "b+", "a-", "b-"]  # clockwise: ahead, right, behind, left


def quarter(x, y):
    """Which of the four directions a point lies in, and how far from straight, in radians."""
    angle = -math.atan2(y, x)
    nearest = round(angle / (math.pi / 2))
    return nearest % 4, abs(angle - nearest * math.pi / 2)


def relative(pose, x, y):
    """A point of the odometry's frame in the frame of a pose."""
    dx, dy, heading = x - pose[0], y - pose[1], pose[2]
    cos, sin = math.cos(heading), math.sin(heading)
    return cos * dx + sin * dy, cos * dy - sin * dx


def absolute(pose, x, y):
    """A point of a pose's frame in the frame that the pose is in."""
    cos, sin = math.cos(pose[2]), math.sin(pose[2])
    return pose[0] + cos * x - sin * y, pose[1] + sin * x + cos * y


class Halt:
    def __init__(self, scan, came_from):
        self.pose, self.came_from = scan["odometry"], came_from
        self.first = scan
        self.seen_m = [0.0] * 4
        self.look(scan)

    def look(self, scan):
        self.last = scan
        for beam, distance in enumerate(scan["ranges_m"]):
            angle = scan["first_beam_rad"] + beam * scan["beam_step_rad"]
            hit = distance * math.cos(angle), distance * math.sin(angle)
            hit = absolute(scan["odometry"], *absolute(scan["robot_from_laser"], *hit))
            x, y = relative(self.pose, *hit)
            towards, off = quarter(x, y)
            if off <= NARROW_RAD:
                self.seen_m[towards] = max(self.seen_m[towards], math.hypot(x, y))

    def arm_towards(self, point, is_open):
        towards, _ = quarter(*relative(self.pose, *point))
        if not is_open[towards]:
            sys.exit(f"scan {self.last['scan']}: found a wall; expected a way out by {ARMS[towards]}")
        return ARMS[towards]

    def visit(self, left_for):
        """The visit that this halt was, or None if it was none."""
        is_open = [distance >= FAR_M for distance in self.seen_m]
        if self.last["stamp_s"] - self.first["stamp_s"] < HALT_S or not any(is_open):
            return None
        arms = [
            f"{arm}{int(is_open[i])}"
            for i, arm in enumerate(ARMS)
            if is_open[i] or is_open[(i + 2) % 4]
        ]
        visit = {"star": " ".join(arms)}
        if self.came_from:
            visit["entered_by"] = self.arm_towards(self.came_from, is_open)
        if left_for:
            visit["left_by"] = self.arm_towards(left_for, is_open)
        visit["scans"] = [self.first["scan"], self.last["scan"]]
        visit["stamps_s"] = [self.first["stamp_s"], self.last["stamp_s"]]
        return visit


def tell(visit):
    # At once: a detector that keeps its lines to itself only answers when the drive is over.
    if visit:
        print(json.dumps(visit), flush=True)


def main():
    halt = None
    before = None  # the scan before this one
    travel = []  # where the robot was since its last visit
    for line in sys.stdin:
        scan = json.loads(line)
        here = scan["odometry"][:2]
        if halt:
            moved_m = math.dist(halt.pose[:2], here)
            if moved_m < STILL_M:
                halt.look(scan)
            elif moved_m >= AWAY_M:
                visit = halt.visit(left_for=here)
                tell(visit)
                travel = [here] if visit else travel + [here]
                halt = None
        elif before and math.dist(before["odometry"][:2], here) < STILL_M:
            away = [point for point in travel if math.dist(point, here) >= AWAY_M]
            halt = Halt(before, away[-1] if away else None)
            halt.look(scan)
        else:
            travel.append(here)
        before = scan
    if halt:
        tell(halt.visit(left_for=None))


main()

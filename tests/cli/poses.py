"""Poses (x, y, heading) of the plane, and how far off they are: m, rad."""

import math


def wrapped(angle):
    return math.remainder(angle, 2 * math.pi)


def compose(a, b):
    c, s = math.cos(a[2]), math.sin(a[2])
    return a[0] + c * b[0] - s * b[1], a[1] + s * b[0] + c * b[1], wrapped(a[2] + b[2])


def between(a, b):
    """Pose b as seen from pose a."""
    c, s = math.cos(a[2]), math.sin(a[2])
    x, y = b[0] - a[0], b[1] - a[1]
    return c * x + s * y, c * y - s * x, wrapped(b[2] - a[2])


def logarithm(pose):
    """The even motion that leads to a pose within one unit of time."""
    x, y, turn = pose
    half = turn / 2
    scale = 1 if half == 0 else half / math.tan(half)
    return scale * x + half * y, scale * y - half * x, turn


def normalised_squared(error, covariance):
    """eᵀ Σ⁻¹ e by Gauss' elimination; Σ row by row."""
    size = len(error)
    rows = [list(covariance[size * i : size * (i + 1)]) + [error[i]] for i in range(size)]
    for i in range(size):
        for below in rows[i + 1 :]:
            share = below[i] / rows[i][i]
            below[i:] = [b - share * a for a, b in zip(rows[i][i:], below[i:])]
    # Of a symmetric matrix the elimination is its L D Lᵀ: the last column is L⁻¹ e.
    return sum(row[-1] ** 2 / row[i] for i, row in enumerate(rows))


def mean_band(count):
    """Where the mean of so many χ² of three degrees of freedom is, 95 times of 100.

    By the cube root of Wilson and Hilferty, right to three digits from ten degrees of freedom on.
    """
    variance = 2 / (9 * 3 * count)
    return tuple(3 * (1 - variance + z * math.sqrt(variance)) ** 3 for z in (-1.96, 1.96))


def read_trajectory(file):
    lines = [line for line in file.read_text().splitlines() if not line.startswith("#")]
    numbers = [list(map(float, line.split())) for line in lines]
    return [(x, y, 2 * math.atan2(qz, qw)) for _, x, y, _, _, _, qz, qw in numbers]

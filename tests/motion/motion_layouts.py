"""A table and blocks on it, from which the tests build their layouts."""

import numpy as np

from motion import Box

TOP = 0.711
TABLE = Box("table", (0.65, 0.0, TOP - 0.02), size=(0.7, 1.8, 0.04), color=(0.9, 0.9, 0.9, 1.0), fixed=True)


def block(name, x, y, *, level=0, edge=0.05, yaw=0.0, **more):
    return Box(
        name,
        (x, y, TOP + edge / 2 + level * edge),
        (np.cos(yaw / 2), 0, 0, np.sin(yaw / 2)),
        (edge, edge, edge),
        **more,
    )

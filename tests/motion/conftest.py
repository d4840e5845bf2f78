"""A table and layouts of blocks on it."""

import numpy as np
import pytest

from motion import Box, Scene

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


@pytest.fixture(scope="session")
def one_block():
    return Scene((TABLE, block("b", 0.6, -0.3)))


@pytest.fixture(scope="session")
def twenty_blocks():
    spots = [(0.47 + 0.085 * (i % 4), -0.6 + 0.28 * (i // 4)) for i in range(20)]
    return Scene((TABLE, *(block(f"b{i}", x, y, yaw=0.1 * i) for i, (x, y) in enumerate(spots))))


@pytest.fixture(scope="session")
def tower():
    """Three blocks on one another, and two beside."""
    stack = [block(f"t{level}", 0.58, 0.25, level=level) for level in range(3)]
    return Scene((TABLE, *stack, block("a", 0.55, 0.45), block("b", 0.65, 0.1)))

"""Layouts of blocks on the table."""

import pytest
from motion_layouts import TABLE, block

from motion import Scene


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

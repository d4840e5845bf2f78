"""Instructions for random worlds whose meaning is known: descriptions that by construction fit one block only."""

from __future__ import annotations

import numpy as np

from grounding.world import World, WorldObject
from integration.benchmark.random_worlds import Episode, draw_episode

SPOKEN_KINDS = ("pick", "on")
CLEAR_BY = 0.03
"""By how much the first in an order is ahead of the second, in [m]."""
_ORDERS = {
    "leftmost": lambda item: float(item.position[1]),
    "rightmost": lambda item: -float(item.position[1]),
    "nearest": lambda item: -float(np.linalg.norm(item.position[:2])),
    "farthest": lambda item: float(np.linalg.norm(item.position[:2])),
}


def draw_spoken(seed: int, number: int) -> tuple[Episode, str]:
    """An episode whose goal can be said, and the instruction that says it."""
    for attempt in range(1000):
        episode = draw_episode(seed + 1_000_003 * attempt, number, kinds=SPOKEN_KINDS)
        rng = np.random.default_rng([seed, number, 3, attempt])
        target = _described(rng, episode.world, episode.target)
        if target is None:
            continue
        to = episode.actions[0].destination
        if to is None:
            return episode, f"pick up {target}"
        below = _described(rng, episode.world, to.reference[0])
        if below is not None:
            return episode, f"put {target} on {below}"
    raise AssertionError(f"no episode {number} of seed {seed} can be said")


def _described(rng: np.random.Generator, world: World, name: str) -> str | None:
    """Words that fit one block only, or None: its colour where no other has it, or its place in an order."""
    blocks = [item for item in world.objects if item.type == "block"]
    meant = world[name]
    if any(_stacked(meant, other) for other in blocks):
        return None
    alike = [item for item in blocks if item.color == meant.color]
    found = [f"the {meant.color} block"] if len(alike) == 1 else []
    for word, key in _ORDERS.items():
        if _first(meant, alike, key) and len(alike) > 1:
            found.append(f"the {word} {meant.color} block")
        if _first(meant, blocks, key):
            found.append(f"the {word} block")
    return str(rng.choice(found)) if found else None


def _first(meant: WorldObject, among: list[WorldObject], key: object) -> bool:
    values = [key(item) for item in among if item.id != meant.id]  # type: ignore[operator]
    return bool(key(meant) > max(values, default=-np.inf) + CLEAR_BY)  # type: ignore[operator]


def _stacked(one: WorldObject, other: WorldObject) -> bool:
    """Tells whether two blocks stand on one another: their places in an order are the same."""
    return one.id != other.id and bool(np.linalg.norm(one.position[:2] - other.position[:2]) < 0.03)

"""Kinds of scenes, and a scene of each: arrangements, strays among them, and who looks from where."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace

import numpy as np

from grounding.corpus.by_hand.hand import Hand, Opening
from grounding.corpus.by_hand.room import apart
from grounding.errors import CorpusError
from grounding.pictures.boxes import visible
from grounding.pictures.seen import SIZE, scene_camera
from grounding.world import Viewpoint, World, WorldObject

SPEAKER = Viewpoint(np.array((1.6, 0.0, 0.0)), 3.14159)  # across the table, facing the robot
LIMITS = (6, 18)  # blocks of a scene
SEEN = 0.3  # share of every block that its writer sees at least
_COLORS = ("red", "blue", "green", "yellow", "purple", "orange")
_MISTAKEN = ({"orange", "yellow"}, {"orange", "red"}, {"purple", "blue"})  # not in one scene
_ATTEMPTS = 400


@dataclass(frozen=True, eq=False)
class Scene:
    """A scene before anybody has written about it.

    Attributes:
        name: of its world.
        kind: one of `KINDS`.
        world: blocks, table and, if somebody sits there, the speaker.
        openings: places that the arrangements leave for one more block.
        arranged: ids of the blocks that belong to an arrangement.
    """

    name: str
    kind: str
    world: World
    openings: tuple[Opening, ...]
    arranged: frozenset[str]


def lay_scene(rng: np.random.Generator, name: str, kind: str, across: bool) -> Scene:
    """Lay a scene of a kind.

    Args:
        rng: the only source of chance.
        name: of its world.
        kind: one of `KINDS`.
        across: whether the writer sits across the table, and is the world's speaker.

    Raises:
        CorpusError: an unknown kind, or no such scene was found.
    """
    if kind not in KINDS:
        raise CorpusError(f"no scenes of kind {kind!r}; kinds are {', '.join(KINDS)}")
    for _ in range(_ATTEMPTS):
        hand = Hand(rng, _palette(rng), bool(rng.random() < 0.65))
        if not KINDS[kind](hand) or not LIMITS[0] <= len(hand.table.blocks) <= LIMITS[1]:
            continue
        scene = _numbered(hand, name, kind, SPEAKER if across else None)
        things = scene.world.things
        if not apart(things):
            continue
        shown = visible(things, scene_camera(scene.world), SIZE)
        if min(found.share for found in shown.values()) >= SEEN:
            return scene
    raise CorpusError(f"no scene of kind {kind!r} was found in {_ATTEMPTS} attempts")


def _palette(rng: np.random.Generator) -> tuple[str, ...]:
    count = int(rng.choice((1, 2, 3, 4), p=(0.12, 0.36, 0.36, 0.16)))
    while True:
        colors = tuple(_COLORS[i] for i in rng.permutation(len(_COLORS))[:count])
        if not any(pair <= set(colors) for pair in _MISTAKEN):
            return colors


def _numbered(hand: Hand, name: str, kind: str, speaker: Viewpoint | None) -> Scene:
    """The scene with its blocks numbered at random, so that numbers say nothing of the order of laying."""
    laid = hand.table.blocks
    order = hand.rng.permutation(len(laid))
    names = {laid[old].id: f"b{new + 1}" for new, old in enumerate(order)}
    blocks = [_renamed(laid[old], names[laid[old].id]) for old in order]
    world = World((*blocks, hand.table.world().objects[-1]), speaker)
    openings = tuple(replace(o, near=tuple(names[i] for i in o.near)) for o in hand.openings)
    return Scene(name, kind, world, openings, frozenset(names[i] for i in hand.arranged))


def _renamed(block: WorldObject, name: str) -> WorldObject:
    return WorldObject(name, block.type, block.color, block.position, block.orientation, block.size)


def _rows(hand: Hand) -> bool:
    count = int(hand.rng.integers(2, 4))
    sizes = hand.rng.integers(3, 7 if count == 2 else 6, size=count)
    gapped = int(hand.rng.integers(count + 1))
    return all(hand.row(int(size), i == gapped) for i, size in enumerate(sizes)) and hand.loose(_few(hand, 1, 3))


def _grid(hand: Hand) -> bool:
    rows, columns = ((2, 3), (2, 4), (2, 5), (3, 3), (3, 4), (3, 5), (4, 4))[int(hand.rng.integers(7))]
    return hand.grid(rows, columns, bool(hand.rng.random() < 0.35)) and hand.loose(_few(hand, 2, 4))


def _clusters(hand: Hand) -> bool:
    sizes = hand.rng.integers(3, 7, size=2)
    return all(hand.heap(int(size)) for size in sizes) and hand.loose(_few(hand, 1, 4))


def _towers(hand: Hand) -> bool:
    sizes = hand.rng.integers(2, 4, size=_few(hand, 2, 4))
    return all(hand.tower(int(size)) for size in sizes) and hand.loose(_few(hand, 2, 4))


def _ring(hand: Hand) -> bool:
    filled = bool(hand.rng.random() < 0.3)
    return hand.ring(_few(hand, 5, 8), filled) and hand.loose(_few(hand, 2, 5))


def _clutter(hand: Hand) -> bool:
    return hand.loose(2) and hand.loose(_few(hand, 7, 13), near=True)


def _alike(hand: Hand) -> bool:
    picks = hand.rng.permutation(np.arange(_few(hand, 3, 5)) % len(hand.palette))
    laid = (hand.alike(3 if hand.rng.random() < 0.3 else 2, hand.palette[int(i)]) for i in picks)
    return all(laid) and hand.loose(_few(hand, 1, 3))


def _mixed(hand: Hand) -> bool:
    rng = hand.rng
    lay: tuple[Callable[[], bool], ...] = (
        lambda: hand.row(_few(hand, 3, 5), bool(rng.random() < 0.4)),
        lambda: hand.grid(2, _few(hand, 2, 3)),
        lambda: hand.ring(_few(hand, 5, 6)),
        lambda: hand.tower(_few(hand, 2, 3)),
        lambda: hand.heap(_few(hand, 3, 4)),
        lambda: hand.alike(2, hand.palette[0]),
    )
    chosen = rng.permutation(len(lay))[: _few(hand, 3, 4)]
    return all(lay[i]() for i in chosen) and hand.loose(_few(hand, 1, 3))


def _few(hand: Hand, low: int, high: int) -> int:
    return int(hand.rng.integers(low, high + 1))


KINDS: dict[str, Callable[[Hand], bool]] = {
    "rows": _rows, "grid": _grid, "cluster": _clusters, "towers": _towers,
    "ring": _ring, "clutter": _clutter, "alike": _alike, "mixed": _mixed,
}  # fmt: skip
"""How a scene of each kind is laid."""

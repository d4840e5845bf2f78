"""Random worlds, composed without physics.

They hold what people would have something to say about: rows, columns, diagonals, circles, groups, towers, pairs and
clutter, at rest on the table, with a gap between any two blocks that do not stand on each other.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace

import numpy as np

from grounding.corpus.tabletop import WHOLE_X, WHOLE_Y, Looks, Tabletop, heap, line, ring
from grounding.errors import CorpusError
from grounding.symbols import Container
from grounding.world import Array, World, WorldObject

COLORS = ("red", "blue", "green", "yellow", "purple", "orange")
EDGES = (0.03, 0.04, 0.045, 0.05, 0.06)  # [m]
LIMITS = (3, 30)  # blocks of a world
_ATTEMPTS = 40  # tables laid anew before giving up
_USUAL_EDGE = 0.05


@dataclass(frozen=True, eq=False)
class Composition:
    """A world and how it was laid.

    Attributes:
        world: blocks, in random order of their ids, and the table.
        containers: the arrangements laid; chance may have made others. Pairs are groups of two. Diagonals and clutter
            are not among them.
    """

    world: World
    containers: tuple[Container, ...]


@dataclass(frozen=True)
class Area:
    """Where blocks may lie.

    Attributes:
        x: interval of their centres away from the robot in [m].
        y: interval of their centres to its left in [m].
        gap: least distance between any two blocks that do not rest on each other in [m].
    """

    x: tuple[float, float] = WHOLE_X
    y: tuple[float, float] = WHOLE_Y
    gap: float = 0.02


def compose(rng: np.random.Generator, blocks: int | None = None, area: Area | None = None) -> Composition:
    """Lay a random world.

    Args:
        rng: the only source of chance: the same state gives the same world.
        blocks: how many; drawn from `LIMITS`, small numbers more often, if None.
        area: where they may lie; by default the whole table.

    Raises:
        CorpusError: `blocks` is outside `LIMITS`, or the area has no room for them.
    """
    count = _draw_count(rng) if blocks is None else blocks
    if not LIMITS[0] <= count <= LIMITS[1]:
        raise CorpusError(f"a world of {count} blocks; composed are {LIMITS[0]} to {LIMITS[1]}")
    area = Area() if area is None else area
    for _ in range(_ATTEMPTS):
        table = Tabletop(rng, area.x, area.y, area.gap)
        if _fill(table, count, _Style.draw(rng)):
            return _shuffled(table)
    raise CorpusError(f"no room for {count} blocks in x {area.x} and y {area.y} with gaps of {area.gap:g} m")


def _draw_count(rng: np.random.Generator) -> int:
    low, high = LIMITS
    return int(low + np.floor((high - low + 1) * rng.random() ** 1.5))


@dataclass(frozen=True)
class _Style:
    """What the blocks of one world have in common.

    Attributes:
        palette: its colours.
        by_block: whether colours are drawn a block, not an arrangement.
        edges: of its cubes in [m].
        neatness: standard deviation of places within an arrangement in [m].
        clutter: share of the blocks that belong to no arrangement.
    """

    palette: tuple[str, ...]
    by_block: bool
    edges: tuple[float, ...]
    neatness: float
    clutter: float

    @classmethod
    def draw(cls, rng: np.random.Generator) -> _Style:
        palette = tuple(COLORS[i] for i in rng.permutation(len(COLORS))[: rng.integers(1, len(COLORS) + 1)])
        size = rng.random()
        if size < 0.75:
            edges: tuple[float, ...] = (_USUAL_EDGE,)
        elif size < 0.88:
            edges = (EDGES[rng.integers(len(EDGES))],)
        else:
            edges = EDGES
        return cls(palette, bool(rng.random() < 0.4), edges, float(rng.uniform(0.0, 0.003)), float(rng.beta(1.2, 2.0)))

    def looks(self, rng: np.random.Generator, count: int) -> Looks:
        """Looks of one arrangement."""
        picks = rng.integers(len(self.palette), size=count if self.by_block else 1)
        edge = self.edges[rng.integers(len(self.edges))]
        return Looks(tuple(self.palette[i] for i in picks.tolist()), edge, self.neatness, float(rng.uniform(0.0, 0.12)))


def _fill(table: Tabletop, count: int, style: _Style) -> bool:
    """Lay `count` blocks; False where there was no room."""
    rng = table.rng
    left = count - round(style.clutter * count)
    misses = 0
    while left >= 2 and misses < 6:
        kind = _KINDS[rng.choice(len(_KINDS), p=_SHARES)]
        low, high, lay = _ARRANGEMENTS[kind]
        if low > left:
            misses += 1
            continue
        size = int(rng.integers(low, min(high, left) + 1))
        if lay(table, size, style.looks(rng, size)):
            left -= size
        else:
            misses += 1
    loose = [style.looks(rng, 1) for _ in range(count - len(table.blocks))]
    return table.scatter([replace(looks, yaw=float(np.pi / 4), jitter=0.0) for looks in loose])


def _pitch(table: Tabletop, looks: Looks, turned: bool) -> float:
    """Distance of neighbours in [m] that leaves the gap; `turned`: whichever way they face each other."""
    across = np.sqrt(2) if turned else np.cos(looks.yaw) + np.sin(looks.yaw)
    least = looks.edge * across + table.gap + 4 * np.sqrt(2) * looks.jitter
    return float(least + min(table.rng.exponential(0.35), 1.2) * looks.edge)


def _lay_line(table: Tabletop, count: int, looks: Looks, kind: str | None, direction: float) -> bool:
    lean = table.rng.normal(0.0, 0.03) if kind else 0.0
    looks = replace(looks, turn=float(lean) if kind else direction)
    return _lay_at_rest(table, kind, line(count, _pitch(table, looks, False), direction + lean), looks)


def _lay_row(table: Tabletop, count: int, looks: Looks) -> bool:
    return _lay_line(table, count, looks, "row", np.pi / 2)


def _lay_column(table: Tabletop, count: int, looks: Looks) -> bool:
    return _lay_line(table, count, looks, "column", 0.0)


def _lay_diagonal(table: Tabletop, count: int, looks: Looks) -> bool:
    direction = table.rng.uniform(0.5, np.pi / 2 - 0.5) * table.rng.choice((-1, 1))
    return _lay_line(table, count, looks, None, float(direction))


def _lay_ring(table: Tabletop, count: int, looks: Looks) -> bool:
    offsets = ring(count, _pitch(table, looks, True), table.rng.uniform(0, 2 * np.pi))
    return _lay_at_rest(table, "circle", offsets, replace(looks, yaw=0.4))


def _lay_group(table: Tabletop, count: int, looks: Looks) -> bool:
    offsets = heap(count, _pitch(table, looks, True), table.rng)
    return _lay_at_rest(table, "group", offsets, replace(looks, yaw=0.4))


def _lay_at_rest(table: Tabletop, kind: str | None, offsets: Array, looks: Looks) -> bool:
    margin = 2 * looks.jitter
    slack = offsets + np.sign(offsets) * margin  # jitter does not carry a block out of the area
    place = table.room(slack, looks.edge)
    if place is None:
        return False
    table.lay(kind, place + offsets, looks)
    return True


def _lay_tower(table: Tabletop, count: int, looks: Looks) -> bool:
    place = table.room(np.zeros((1, 2)), looks.edge)
    if place is None:
        return False
    table.stack(place, count, replace(looks, jitter=min(looks.jitter, 0.002)))
    return True


_ARRANGEMENTS: dict[str, tuple[int, int, Callable[[Tabletop, int, Looks], bool]]] = {
    "row": (3, 7, _lay_row),
    "column": (3, 5, _lay_column),
    "diagonal": (3, 5, _lay_diagonal),
    "circle": (5, 8, _lay_ring),
    "group": (3, 7, _lay_group),
    "pair": (2, 2, _lay_group),
    "tower": (2, 4, _lay_tower),
}
_KINDS = tuple(_ARRANGEMENTS)
_SHARES = (0.24, 0.2, 0.06, 0.1, 0.16, 0.08, 0.16)


def _shuffled(table: Tabletop) -> Composition:
    """Number the blocks at random: the order of laying says nothing."""
    order = table.rng.permutation(len(table.blocks))
    names = {table.blocks[old].id: f"b{new + 1}" for new, old in enumerate(order)}
    blocks = [_renamed(table.blocks[old], f"b{new + 1}") for new, old in enumerate(order)]
    containers = tuple(Container(c.kind, tuple(names[name] for name in c.objects)) for c in table.containers)
    return Composition(table.world().with_objects((*blocks, table.world().objects[-1])), containers)


def _renamed(block: WorldObject, name: str) -> WorldObject:
    return WorldObject(name, block.type, block.color, block.position, block.orientation, block.size)

"""Which arrangements catch the eye, of those that share members, and which people would name without being asked."""

from __future__ import annotations

from collections.abc import Iterable, Sequence

from grounding.geometry.arrangement import Arrangement

_MOST = 0.7  # of the members


def prominent(arrangements: Iterable[Arrangement]) -> tuple[Arrangement, ...]:
    """Of arrangements of a kind that share members, those that catch the eye; the most prominent first."""
    kept: list[Arrangement] = []
    taken: dict[str, int] = {}
    seen = [a for a in arrangements if a.prominence > 0]
    for a in sorted(seen, key=lambda a: (-a.prominence, a.kind, a.mask)):
        if not a.mask & taken.get(a.kind, 0):
            taken[a.kind] = taken.get(a.kind, 0) | a.mask
            kept.append(a)
    return tuple(kept)


def evident(arrangements: Sequence[Arrangement]) -> frozenset[tuple[str, int]]:
    """What people would name unasked, by kind and members.

    A row is not called a group as well, and three of a group that happen to be in line are not called a row.
    """
    shapes = prominent(a for a in arrangements if a.kind != "group" and a.evident)
    groups = prominent(a for a in arrangements if a.kind == "group" and a.evident)
    apart = [g for g in groups if not any(_mostly(g.mask, shape.mask) for shape in shapes)]
    chance = {s.mask for s in shapes for g in apart if s.count == 3 and not s.mask & ~g.mask}
    return frozenset((a.kind, a.mask) for a in (*shapes, *apart) if a.kind == "tower" or a.mask not in chance)


def _mostly(mask: int, shape: int) -> bool:
    """Whether most members of a set are members of a shape."""
    return (mask & shape).bit_count() > _MOST * mask.bit_count()

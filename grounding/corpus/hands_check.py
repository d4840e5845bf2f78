"""Whether a corpus of texts agrees with its worlds and with itself."""

from __future__ import annotations

from collections.abc import Callable, Iterator

import numpy as np

from grounding.corpus.by_hand.room import EDGE, gap, supports, uncovered
from grounding.corpus.check import Finding
from grounding.corpus.hands import Hands, HandText
from grounding.world import World, WorldObject

_LEAST = 0.01  # free space beside a block that was put down, in [m]
_REST = 0.005  # largest gap between a block and what it stands on, in [m]


def check_hands(corpus: Hands) -> tuple[Finding, ...]:
    """Run all `CHECKS`, in their order."""
    return tuple(finding for check in CHECKS.values() for finding in check(corpus))


def check_objects(corpus: Hands) -> Iterator[Finding]:
    """The block that is meant can be taken: nothing stands on it."""
    for text in corpus:
        world = corpus.worlds[text.world]
        if not uncovered(world[text.object], world.things):
            yield Finding("objects", text.id, None, f"something stands on {text.object!r}, which is meant")


def check_destinations(corpus: Hands) -> Iterator[Finding]:
    """Where a block goes is free and supported."""
    for text in corpus:
        if text.destination is not None:
            problem = _misplaced(corpus.worlds[text.world], corpus.worlds[text.world][text.object], text.destination)
            if problem:
                yield Finding("destinations", text.id, None, f"destination {list(text.destination)}: {problem}")


def check_splits(corpus: Hands) -> Iterator[Finding]:
    """All texts of a world are in one split, so that no split has seen another's scenes."""
    first: dict[str, HandText] = {}
    for text in corpus:
        other = first.setdefault(text.world, text)
        if other.split != text.split:
            message = f"is in {text.split!r}, {other.id!r} of the same world in {other.split!r}"
            yield Finding("splits", text.id, None, message)


def check_agreement(corpus: Hands) -> Iterator[Finding]:
    """The same words in the same world after the same history mean the same."""
    first: dict[tuple[str, tuple[str, ...], str], HandText] = {}
    for text in corpus:
        words = " ".join(text.instruction.lower().split())
        other = first.setdefault((text.world, text.history, words), text)
        if (other.object, other.destination) != (text.object, text.destination):
            yield Finding("agreement", text.id, None, f"has the words of {other.id!r} and means something else")


def check_kinds(corpus: Hands) -> Iterator[Finding]:
    """A world is of one kind."""
    first: dict[str, HandText] = {}
    for text in corpus:
        other = first.setdefault(text.world, text)
        if other.kind != text.kind:
            message = f"is of kind {text.kind!r}, {other.id!r} of the same world of kind {other.kind!r}"
            yield Finding("kinds", text.id, None, message)


def _misplaced(world: World, moved: WorldObject, place: tuple[float, float, float]) -> str | None:
    """What is wrong with a block's being put somewhere, or None."""
    there = moved.moved(place, (1.0, 0.0, 0.0, 0.0))
    others = [item for item in world.things if item.id != moved.id]
    x, y, z = place
    for item in others:
        if abs(float(item.position[2]) - z) < EDGE - _REST and gap(np.array((x, y)), 0.0, item) < _LEAST:
            return f"{item.id!r} stands less than {_LEAST:g} m from there"
    if any(supports(item, there) for item in others):
        return None
    for table in (item for item in world.objects if item.type == "table"):
        top = float(table.position[2] + table.half_extents[2])
        inside = (np.abs(there.position[:2] - table.position[:2]) <= table.half_extents[:2]).all()
        if inside and abs(z - float(moved.size[2]) / 2 - top) <= _REST:
            return None
    return "neither the table nor a block is under it"


CHECKS: dict[str, Callable[[Hands], Iterator[Finding]]] = {
    "objects": check_objects, "destinations": check_destinations, "splits": check_splits,
    "agreement": check_agreement, "kinds": check_kinds,
}  # fmt: skip

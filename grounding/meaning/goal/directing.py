"""Directions in a destination: with their lengths, as faces of what is moved, or as sides of the table."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

from grounding.lexicon import whereto as g
from grounding.lexicon import words as w
from grounding.meaning.goal.ahead import ends_in_place, face_follows, reference_follows
from grounding.meaning.goal.clues import Clue, Offset
from grounding.meaning.goal.items import Item
from grounding.meaning.goal.memory import Memory
from grounding.meaning.goal.referring import locate, refer
from grounding.meaning.goal.steering import OWN, SIDEWAYS
from grounding.meaning.nouns import Noun


def direct(memory: Memory, items: Sequence[Item], place: int, names: tuple[str, ...]) -> int:
    """Take in a word that names directions.

    Args:
        memory: of what was said before.
        items: the pieces of the destination.
        place: of the word among them.
        names: of the directions.

    Returns:
        how many of the pieces that follow were taken in with it.
    """
    text, last = items[place].text, set(memory.since[-2:])
    if OWN & last and (face_follows(items, place) or memory.face):
        memory.face = (*memory.face, *names)
        return 0
    if OWN & last and memory.named_last() is not None:
        memory.offsets.append(Offset(names, memory.number, memory.extent))
        memory.since = ["of"]
        refer(memory, memory.named_last())
        return 0
    if memory.number is not None and "from" in last and last <= {"from", "the"}:
        locate(memory, Noun(head="place", directions=names, text=text))
        return 0
    if _leads_to_place(memory, items, place):
        return _to_place(memory, items, place, names)
    begins_anew = memory.since[:1] == ["to"] and reference_follows(items, place)
    if memory.offsets and not memory.offsets[-1].binding and begins_anew:
        memory.flush()
    _go_on(memory, names, binding=g.leads(text) is not None)
    return 0


def _go_on(memory: Memory, names: tuple[str, ...], *, binding: bool) -> None:
    """Add a direction to those before it."""
    previous = memory.offsets[-1] if memory.offsets else None
    if previous is not None and _belongs_to(memory, previous, names):
        memory.offsets[-1] = replace(previous, names=(*previous.names, *names), binding=binding)
    else:
        steps = memory.number
        shared = memory.counted_first and set(memory.since) <= {"and", "to", "the", "then"}
        if steps is None and shared and previous is not None and not set(previous.names) & set(names):
            steps = previous.steps
        memory.counted_first = memory.number is not None
        memory.offsets.append(Offset(names, steps, memory.extent, memory.owner, binding))
    if memory.relation in ("on", "in"):
        memory.relation = ""
    memory.number, memory.extent, memory.owner, memory.since = None, "", None, []


def _belongs_to(memory: Memory, previous: Offset, names: tuple[str, ...]) -> bool:
    """Tells whether a direction is one with that right before it: "upper" "left", "west" "northwest"."""
    joined = previous.steps is None and not memory.since and memory.number is None
    return joined and (not set(previous.names) & set(names) or len(names) + len(previous.names) == 3)


def _to_place(memory: Memory, items: Sequence[Item], place: int, names: tuple[str, ...]) -> int:
    memory.flush()
    taken = 0
    for item in items[place + 1 : place + 3]:
        if item.kind != "word" or not w.directions(item.text):
            break
        names = (*names, *w.directions(item.text))
        taken += 1
    noun = Noun(head="place", directions=names, agent=memory.owner)
    memory.clues.append(Clue("place", (noun,), axis=memory.extent))
    memory.forget()
    return taken


def _leads_to_place(memory: Memory, items: Sequence[Item], place: int) -> bool:
    """Tells whether a side of the table is meant, not one of something: "to the top", "on the far right"."""
    text = items[place].text
    led = memory.since[-1:] in (["the"], ["far"], ["very"], ["way"])
    if g.leads(text) or memory.number is not None or not led or not ends_in_place(items, place):
        return False
    if memory.clues and memory.clues[-1].relation in ("near", "touch") and not memory.offsets:
        return False
    before = [text for text in memory.since if text != "the"]
    if set(before) & {"far", "way", "very"}:
        return True
    leading = ("on", "at", "in") if text in SIDEWAYS else ("on", "at", "in", "to", "near")
    return bool(before) and before[-1] in leading

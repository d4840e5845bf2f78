"""Things, places and arrangements that are named in a destination: what was said before relates to them."""

from __future__ import annotations

from grounding.lexicon import whereto as g
from grounding.lexicon.words import OPPOSITE
from grounding.meaning.goal.clues import Clue, Offset
from grounding.meaning.goal.items import Item
from grounding.meaning.goal.lengths import stories
from grounding.meaning.goal.memory import Memory
from grounding.meaning.nouns import Noun


def refer(memory: Memory, noun: Noun | None) -> None:
    """Take in that something is named."""
    if noun is None:
        return
    squared = noun.head == "block" and not noun.definite and "square" in noun.text
    if squared and not memory.relation and not memory.offsets:
        form(memory, noun)
        return
    relation = memory.relation
    if memory.waiting:
        memory.clues.append(Clue("between", (*memory.waiting, noun)))
        memory.waiting = ()
    elif memory.binds() and relation in ("", "on", "in", "near", "touch"):
        memory.lead_from(noun, memory.strict or relation == "touch" or bool(memory.face))
    elif memory.binds() and relation == "align":
        sideways = {"left", "right"} & {name for offset in memory.offsets for name in offset.names}
        memory.offsets = []
        memory.clues.append(Clue("align", (noun,), axis="column" if sideways else "row"))
    elif memory.face:
        memory.flush()
        opposite = tuple(OPPOSITE.get(name, name) for name in memory.face)
        memory.clues.append(Clue("offset", (noun,), (Offset(opposite),), strict=True))
    elif relation == "between" and not noun.plural and not noun.conjoined and noun.head != "container":
        memory.flush()
        memory.waiting = (noun,)
    else:
        memory.flush()
        relation = relation or _unsaid(memory, noun)
        if relation:
            far = () if memory.number is None or relation not in ("toward", "apart") else (Offset((), memory.number),)
            memory.clues.append(Clue(relation, (noun,), far, axis=memory.axis, strict=memory.strict))
    if relation == "on":
        memory.tower = False
    memory.forget()


def _unsaid(memory: Memory, noun: Noun) -> str:
    """The relation that is meant where none is named."""
    if memory.tower:
        return "on"
    if "from" in memory.since[-2:]:
        return ""
    if memory.since[-1:] == ["of"] and not memory.clues:
        return ""
    if "with" in memory.since[-2:]:
        return "near"
    if noun.head == "container" and "tower" in noun.kinds:
        return "on"
    return "in" if noun.head == "container" and {"row", "column"} & set(noun.kinds) else "near"


def point_back(memory: Memory, item: Item) -> None:
    """Take "it" as what was named last, or as what is moved where it stands for itself."""
    related = bool(memory.relation) or memory.binds()
    if not related or memory.since[-1:] in (["so"], ["that"], ["until"]):
        memory.since.append(item.text)
        return
    refer(memory, memory.named_last() or Noun(head="pronoun", text=item.text))


def locate(memory: Memory, noun: Noun | None) -> None:
    """Take in that a part of the table is named."""
    if noun is None:
        return
    bound = tuple(memory.offsets) if memory.binds() else ()
    if bound:
        memory.offsets = []
    elif memory.number is not None and "from" in memory.since and noun.directions:
        bound = (Offset(tuple(OPPOSITE[name] for name in noun.directions), memory.number),)
    memory.flush()
    last = memory.clues[-1] if memory.clues else None
    if last is not None and last.relation == "place" and bound and last.nouns[0].text == noun.text:
        memory.clues[-1] = last.going(*bound)
    else:
        memory.clues.append(Clue("place", (noun,), bound, axis=memory.extent))
    memory.forget()


def reach_table(memory: Memory, noun: Noun | None) -> None:
    """Take in that the table as a whole is named: directions before it are its sides."""
    if noun is not None and (noun.colors or noun.directions or noun.other):
        memory.table, memory.surface = noun, True
    memory.surface |= memory.relation == "on"
    edge = any(g.is_face(text) for text in memory.since) and "to" in memory.since
    if memory.offsets and memory.offsets[-1].steps is None and (memory.binds() or edge):
        names = tuple(name for offset in memory.offsets for name in offset.names if offset.steps is None)
        memory.offsets = [offset for offset in memory.offsets if offset.steps is not None]
        memory.flush()
        memory.clues.append(Clue("place", (Noun(head="place", directions=names),), axis=memory.extent))
    memory.flush()
    memory.forget()


def form(memory: Memory, noun: Noun) -> None:
    """Take in that an arrangement is to come about."""
    if "tower" in noun.kinds:
        memory.tower, memory.relation = True, "on"
        memory.height = stories(noun) or memory.height
    else:
        memory.flush()
        memory.clues.append(Clue("make", (noun,)))
        memory.forget()

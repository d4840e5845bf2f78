"""What lies in a relation to what a noun phrase means, read literally."""

from __future__ import annotations

from itertools import product

from grounding.geometry.masks import indices_of, mask_of
from grounding.language.tree import Phrase
from grounding.literal.choosing import touching
from grounding.literal.reading import ReadsLiterally
from grounding.literal.values import Meant, Narrow, Unread
from grounding.symbols import Region

MOST_REFERENCES = 8  # so many things a reference may leave open: "behind a green block"


def region_of(reader: ReadsLiterally, meant: Meant, relation: str, phrase: Phrase | None) -> Narrow:
    """What lies in a relation to what a noun phrase means."""
    layout = reader.layout
    text = phrase.text if phrase is not None else relation
    if meant.sort != "things":
        raise Unread(text)
    if relation in ("above", "below"):
        upright = "top" if relation == "above" else "bottom"
        stands = meant.chosen and layout.within(Region(upright, meant.kind, layout.names(meant.chosen)))
        if not meant.chosen and reader.scene.towers and meant.pool.bit_count() <= MOST_REFERENCES:
            found = _of_some(reader, meant.pool, upright, 1, text)
            if found:
                return Narrow(found)
        relation = upright if stands else "back" if relation == "above" else "front"
    if relation == "touching":
        return Narrow(_in_contact(reader, meant, text), vague=True)
    if relation == "between":
        return Narrow(_between(reader, meant, text), vague=True)
    if meant.parts and not meant.chosen:
        masks = [_of_some(reader, part.chosen or part.pool, relation, 1, text) for part in meant.parts]
        return Narrow(masks[0] & masks[1], vague=True)
    if meant.chosen:
        region = Region(relation, meant.kind, layout.names(meant.chosen))
        return Narrow(layout.within(region), region, vague=True)
    if meant.plural and meant.definite:
        raise Unread(text)
    number = (meant.number or 2) if meant.plural else 1
    region = Region(relation, "object", layout.names(meant.pool))
    if meant.pool.bit_count() > MOST_REFERENCES:
        raise Unread(text)
    if number == 1:
        return Narrow(layout.within(region), region, vague=True)
    return Narrow(_of_some(reader, meant.pool, relation, number, text), vague=True)


def _of_some(reader: ReadsLiterally, pool: int, relation: str, number: int, text: str) -> int:
    """What is in a relation to so many members of a set."""
    if pool.bit_count() > MOST_REFERENCES:
        raise Unread(text)
    counts = [0] * reader.layout.size
    for i in indices_of(pool):
        if relation == "touching":
            found = touching(reader.scene, i)
        else:
            found = reader.layout.within(Region(relation, "object", (reader.layout.ids[i],)))
        for j in indices_of(found):
            counts[j] += 1
    return mask_of(j for j, count in enumerate(counts) if count >= number)


def _in_contact(reader: ReadsLiterally, meant: Meant, text: str) -> int:
    if meant.chosen and meant.kind not in ("object", "group"):
        found = 0
        for i in indices_of(meant.chosen):
            found |= touching(reader.scene, i)
        return found & ~meant.chosen
    if meant.chosen:
        found = reader.layout.everything & ~meant.chosen
        for i in indices_of(meant.chosen):
            found &= touching(reader.scene, i)
        return found
    if meant.parts:
        masks = [_of_some(reader, part.chosen or part.pool, "touching", 1, text) for part in meant.parts]
        return masks[0] & masks[1]
    if meant.plural and meant.definite:
        raise Unread(text)
    return _of_some(reader, meant.pool, "touching", (meant.number or 2) if meant.plural else 1, text)


def _between(reader: ReadsLiterally, meant: Meant, text: str) -> int:
    layout = reader.layout
    counted = any(part.plural and part.kind == "group" for part in meant.parts)  # "two red ones and a blue one"
    if not meant.plural or counted or (not meant.parts and meant.number not in (2, None)):
        raise Unread(text)
    if meant.parts and not meant.chosen:
        pools = [list(indices_of(part.chosen or part.pool)) for part in meant.parts]
        pairs = [(i, j) for i, j in product(*pools) if i != j]
    else:
        members = list(indices_of(meant.chosen or meant.pool))
        if meant.chosen and len(members) != 2:
            raise Unread(text)
        pairs = [(i, j) for i in members for j in members if i < j]
    if not pairs or len(pairs) > MOST_REFERENCES**2:
        raise Unread(text)
    found = 0
    for i, j in pairs:
        found |= layout.within(Region("between", "object", layout.names(1 << i | 1 << j)))
    return found

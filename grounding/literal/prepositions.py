"""What a preposition says of what is meant: of things, of a place, of the table, of somebody; literally."""

from __future__ import annotations

from grounding.geometry.masks import mask_of, single
from grounding.language.tree import Phrase
from grounding.lexicon import words as w
from grounding.literal.choosing import along, from_person, from_reference, to_center, toward
from grounding.literal.places import NAMES, OPPOSITE, PARTS
from grounding.literal.reading import ReadsLiterally
from grounding.literal.relations import region_of
from grounding.literal.values import Effect, Meant, Member, Narrow, Order, Sided, Unread, Viewed
from grounding.meaning.nouns import Noun
from grounding.symbols import Region
from grounding.world.scene import SPEAKER

RELATIONS = {
    "behind": "back", "beyond": "back", "past": "back", "above": "above", "over": "above", "below": "below",
    "under": "below", "beneath": "below", "underneath": "below", "near": "near", "beside": "near", "by": "near",
    "next to": "near", "close to": "near", "adjacent to": "near", "alongside": "near", "against": "touching",
    "touching": "touching", "between": "between", "in between": "between", "atop": "top", "upon": "top",
    "in front of": "front",
}  # fmt: skip
_OF = frozenset(("in", "of", "from", "on", "at", "to", "off", "off of", "within", "inside", "among", "out of",
                 "toward", "towards", "along", "for", "onto", "over to"))  # fmt: skip
STRICT = frozenset("directly immediately right just exactly".split())
ADVERBS = STRICT | frozenset(
    "away very slightly almost diagonally straight located situated placed positioned sitting standing lying also all "
    "the way far more most so that nearly still now completely both is are".split()
)


def related(
    reader: ReadsLiterally, phrase: Phrase, texts: list[str], meant: Meant, noun: Noun, pool: int, *, strict: bool
) -> list[Effect]:  # fmt: skip
    """What a preposition says by what it relates to.

    Args:
        reader: of noun phrases.
        phrase: the modifier.
        texts: its own words.
        meant: what it relates to.
        noun: what it modifies.
        pool: what the noun may be by its own words.
        strict: whether "directly" is said.

    Raises:
        Unread: it is beyond what is read literally.
    """
    if len(texts) >= 2 and texts[-1] == "of" and w.directions(texts[-2]) and meant.sort in ("things", "agent"):
        names = [NAMES.get(name, name) for name in w.directions(texts[-2])]
        return _beside(reader, meant, names, strict, phrase)
    preposition = _preposition(texts, meant)
    match meant.sort:
        case "table":
            return _to_table(reader, preposition, pool, phrase)
        case "agent":
            return _to_somebody(meant, preposition, phrase)
        case "place":
            if preposition not in _OF and RELATIONS.get(preposition) not in ("near", "touching", "above"):
                raise Unread(phrase.text)
            return at_place(reader, meant, preposition, noun, strict)
    return _to_things(reader, meant, preposition, noun, pool, phrase, strict=strict)


def _preposition(texts: list[str], meant: Meant) -> str:
    """The words that set things in relation to what is meant."""
    if meant.sort == "place" and texts[-1] == "from" and set(texts) <= {"up", "down", "in", "over", "from"}:
        return "from"
    return " ".join(text for text in texts if text not in ADVERBS or text == "that") or texts[-1]


def _to_table(reader: ReadsLiterally, preposition: str, pool: int, phrase: Phrase) -> list[Effect]:
    if preposition == "on" and reader.scene.towers:
        lying = mask_of(i for i in range(reader.scene.n) if not reader.scene.raised[i])
        return [Narrow(lying)] if single(pool & lying) else []  # else all that is there: "the bricks on the table"
    if preposition in _OF or preposition in ("on", "onto"):
        return []
    raise Unread(phrase.text)


def _to_somebody(meant: Meant, preposition: str, phrase: Phrase) -> list[Effect]:
    if preposition in ("to", "from"):
        return [Viewed(str(meant.agent), preposition)]
    if preposition in ("near", "close to", "next to", "by"):
        return [Sided("far" if meant.agent == SPEAKER else "near")]
    raise Unread(phrase.text)


def _to_things(
    reader: ReadsLiterally, meant: Meant, preposition: str, noun: Noun, pool: int, phrase: Phrase, *, strict: bool
) -> list[Effect]:  # fmt: skip
    relation = RELATIONS.get(preposition)
    if relation is None and preposition in ("on", "onto"):
        relation = "top"
    if preposition == "on" and meant.kind not in ("object", "tower"):
        relation = None
    if relation is not None:
        narrow = region_of(reader, meant, relation, phrase)
        return [Narrow(narrow.mask, narrow.region, strict, True)]
    if preposition in _OF:
        return [_member(reader, meant, preposition, pool, noun, phrase)]
    raise Unread(phrase.text)


def by_distance(
    reader: ReadsLiterally, meant: Meant, far: bool, index: int | None, texts: list[str], phrase: Phrase
) -> Effect:
    """Ranks by distance: "second farthest from it", "furthest to the left", "furthest from the left"."""
    layout = reader.layout
    if meant.sort == "agent":
        if meant.agent == SPEAKER:
            return Order(from_person(reader.scene, SPEAKER, far), index)
        name = "far" if far else "near"
        return Order(along(layout, name), index, name)
    if meant.sort == "place" and meant.parts and meant.parts[0].sort == "table":
        meant = Meant("place", names=meant.names)
    if meant.sort == "place" and not meant.parts:
        away = far and "from" in texts
        if len(meant.names) == 2:
            if away:
                raise Unread(phrase.text)
            return Order(toward(reader.scene, meant.names), index, "", 0.03)
        if meant.names == ("center",):
            if far:
                raise Unread(phrase.text)
            return Order(to_center(layout), index, "center")
        return Sided(OPPOSITE.get(meant.names[0], meant.names[0]) if away else meant.names[0], False, index, False)
    if meant.sort == "things" and meant.chosen:
        mask = meant.chosen
        return Order(from_reference(layout, layout.names(mask), far), index, reference=mask)
    raise Unread(phrase.text)


def counted(reader: ReadsLiterally, meant: Meant, index: int) -> list[Effect]:
    """Ranks by counting from a place: "third from the left"."""
    if len(meant.names) == 2:
        return [Order(toward(reader.scene, meant.names), index, "", 0.03)]
    return [Sided(meant.names[0], False, index)]


def at_place(reader: ReadsLiterally, meant: Meant, preposition: str, noun: Noun, strict: bool | None) -> list[Effect]:
    """In a place of the table or of a thing."""
    if not meant.parts:
        if len(meant.names) == 2:
            if meant.place in PARTS:
                return [Sided(name, True) for name in meant.names]
            return [Order(toward(reader.scene, meant.names), None, "", 0.03)]
        if meant.agent is not None and meant.names in (("front",), ("back",)):
            raise Unread("in front of somebody")
        narrows = not (noun.distance and preposition == "to")
        return [Sided(meant.names[0], meant.place in PARTS, None, narrows, preposition in ("on", "at", "in", "to"))]
    whole = meant.parts[0]
    if whole.sort == "table":
        name = {"top": "back", "bottom": "front"}.get(meant.names[0], meant.names[0])
        if noun.distance and preposition == "to":
            return [Sided(name, narrows=False)]
        return [Narrow(reader.layout.within(Region(name, "object", _table_of(reader))))]
    if whole.sort == "agent":
        if meant.names[0] in ("left", "right") and len(meant.names) == 1:
            return [] if _ranks(noun) else [Sided(meant.names[0])]
        if len(meant.names) == 1 and not strict:
            return []
        raise Unread("in front of somebody")
    name = meant.names[0]
    lying = {"top": "back", "bottom": "front"}.get(name, name)
    kind = whole.kind
    arranged = kind not in ("object", "robot")
    if arranged and len(meant.names) == 1 and whole.chosen and not _ranks(noun) and not noun.ordinals:
        member = name == "center" or (preposition == "at" and name in ("left", "right", "front", "back"))
        lying_end = preposition in ("at", "in") and kind in ("row", "column")
        member |= name in ("top", "bottom") and (kind == "tower" or lying_end)
        member |= bool(meant.place) and preposition in ("at", "on", "in")
        if member:
            said = name if kind == "tower" else lying
            upright = kind == "tower"
            return [Member(whole.chosen, kind), Order(along(reader.layout, said, upright), None, said)]
    if len(meant.names) == 1 and name == "center" and whole.plural and whole.number == 2:
        return [region_of(reader, whole, "between", None)]
    return _beside(reader, whole, list(meant.names), bool(strict), None)


def _table_of(reader: ReadsLiterally) -> tuple[str, ...]:
    found = tuple(item.id for item in reader.layout.world.objects if item.type == "table")
    if len(found) > 1:
        raise Unread("which of the tables?")
    return found


def _beside(
    reader: ReadsLiterally, whole: Meant, names: list[str], strict: bool, phrase: Phrase | None
) -> list[Effect]:
    if whole.sort == "agent":
        turned = [OPPOSITE.get(name, name) for name in names] if whole.agent == SPEAKER else names
        return [Sided(turned[0])]
    if whole.sort != "things":
        raise Unread("beside what?")
    found: list[Effect] = []
    for name in names:
        narrow = region_of(reader, whole, name, phrase)
        found.append(Narrow(narrow.mask, narrow.region if len(names) == 1 else None, strict, True))
    return found


def _ranks(noun: Noun) -> bool:
    return bool(noun.directions or noun.distance or noun.middle or noun.far)


def _member(reader: ReadsLiterally, meant: Meant, preposition: str, pool: int, noun: Noun, phrase: Phrase) -> Effect:
    if meant.sort != "things":
        raise Unread(phrase.text)
    if not meant.chosen and meant.plural and meant.sets:
        inside = [a for a in meant.sets if not a[1] & ~pool]
        if len(inside) == 1:
            return Member(inside[0][1], inside[0][0])
    if not meant.chosen and meant.plural and meant.number:
        sets = [(a.kind, a.mask) for a in reader.layout.evident_of((), meant.pool) if a.count == meant.number]
        if len(sets) == 1:
            return Member(sets[0][1], sets[0][0])
    if not meant.chosen:
        raise Unread(phrase.text)
    taken = meant.kind == "tower" and preposition in ("from", "off", "off of")
    if taken and not (_ranks(noun) or noun.ordinals or noun.plural):
        raise Unread(phrase.text)  # what is taken off a stack is its top
    return Member(meant.chosen, meant.kind, preposition in ("to", "from") and bool(noun.distance))

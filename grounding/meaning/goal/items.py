"""The words of a destination in their order, with noun phrases that name something as one item."""

from __future__ import annotations

import re
from collections.abc import Iterable
from dataclasses import dataclass, replace

from grounding.lexicon import words as w
from grounding.meaning.goal.vocabulary import STORIES
from grounding.meaning.nouns import Noun, read_noun
from grounding.language.lexicon import meanings
from grounding.language.tree import Phrase, Word
from grounding.symbols import Cardinal, Ordinal

_DECIMAL = re.compile(r"\d+\.\d+|\.\d+")
_AMOUNTS = {"half": 0.5, "quarter": 0.25, "couple": 2.0, "few": 2.5, "several": 3.0, "twice": 2.0, "once": 1.0}
_LENGTHS = frozenset("row rows column columns line lines level levels".split())
_DEFINITE = frozenset("the this that these those both all".split())
_MOVING = frozenset("place put move set stack position lay slide shift".split())
_RESULTS = frozenset("so until making creating forming where such".split())
_RELATING = frozenset("between on onto of touching touches touch next with by beside near against atop among".split())
_OWN = frozenset("its it's their".split())


@dataclass(frozen=True)
class Item:
    """One piece of a destination.

    Attributes:
        kind: "word"; "number"; "length", a unit of distance; "thing", what objects are meant by a noun; "counted", a
            noun that is either a length or things ("two blocks"); "place", a part of the table; "shape", an
            arrangement that is to come about; "pronoun"; "stop", between two clauses.
        text: its words.
        value: of a number, or of what is counted.
        noun: of a thing, a place, a shape.
    """

    kind: str
    text: str
    value: float = 0.0
    noun: Noun | None = None


STOP = Item("stop", "")


def line_up(phrases: Iterable[Phrase]) -> list[Item]:
    """The pieces of a destination, from the phrases that speak of it."""
    items: list[Item] = []
    for phrase in phrases:
        _enter(phrase, items)
    return _joined(items)


def _enter(phrase: Phrase, items: list[Item]) -> None:
    if phrase.tag == "NP":
        _name(phrase, items)
        return
    if phrase.tag in ("S", "SBAR", "VP") and items:
        items.append(STOP)
    _expand(phrase, items)


def _commands(phrase: Phrase) -> bool:
    return phrase.tag == "VP" and bool(phrase.words) and phrase.words[0].text in _MOVING


def number(text: str) -> float | None:
    """The number that a word says, parts included."""
    if text in _AMOUNTS:
        return _AMOUNTS[text]
    if _DECIMAL.fullmatch(text):
        return float(text)
    return next((float(s.value) for s in meanings(text) if isinstance(s, Cardinal)), None)


def ordinal(text: str) -> int:
    """The rank that a word says, from 1; 0 where it says none."""
    return next((s.value for s in meanings(text) if isinstance(s, Ordinal) and s.value > 0), 0)


def stories(noun: Noun) -> int:
    """How high the tower is that a noun asks for, in blocks; 0 where it does not say."""
    if noun.number:
        return noun.number
    counts = (number(m.leaves[1].text) for m in noun.modifiers if m.leaves[0].text == "of" and len(m.leaves) > 1)
    return int(next((value for value in counts if value), 0))


def _word(word: Word) -> Item:
    text = word.text
    value = number(text)
    if value is not None:
        return Item("number", text, value)
    if w.is_measure(text):
        return Item("length", text)
    if text in ("it", "them", "itself"):
        return Item("pronoun", text)
    return Item("word", text)


def _name(phrase: Phrase, items: list[Item]) -> None:
    """A noun phrase: a distance, a thing, a place, or words that say something else."""
    noun, apart = peeled(read_noun(phrase))
    texts = [leaf.text for leaf in phrase.leaves]
    if _opens_distance(phrase, noun, items):
        _spread(phrase, items)
        return
    _take(phrase, noun, texts, items)
    for modifier in apart:
        _enter(modifier, items)


def peeled(noun: Noun) -> tuple[Noun, list[Phrase]]:
    """A noun without what says how far to go from it or what shall come about: "the tower" "up two spaces"."""
    if noun.conjoined and all(_is_length(read_noun(p), p.text.split()) or number(p.text) for p in noun.conjoined[1:]):
        first, ways = peeled(read_noun(noun.conjoined[0]))
        if ways:
            return first, [*ways, *noun.conjoined[1:], *noun.modifiers]
    apart = [m for m in noun.modifiers if is_course(m)]
    kept = tuple(m for m in noun.modifiers if m not in apart)
    return (replace(noun, modifiers=kept) if apart else noun), apart


def is_course(phrase: Phrase) -> bool:
    """Whether a phrase tells a way to go: directions and lengths, and no thing."""
    first = phrase.leaves[0].text
    if first in _RESULTS or (first in ("in", "at") and len(phrase.leaves) > 2 and w.is_measure(phrase.leaves[2].text)):
        return True
    nouns = [p for p in phrase.preorder() if p.tag == "NP"]
    measured = any(_is_length(read_noun(p), [leaf.text for leaf in p.leaves]) for p in nouns)
    things = any(not p.phrases and read_noun(p).head in ("block", "container", "pronoun", "table") and not _is_length(
        read_noun(p), [leaf.text for leaf in p.leaves]) for p in nouns)  # fmt: skip
    return measured and not things and any(w.directions(leaf.text) for leaf in phrase.leaves)


def _opens_distance(phrase: Phrase, noun: Noun, items: list[Item]) -> bool:
    """Whether a noun phrase says how far from something: "two blocks" "above the tower", "one" "left of X"."""
    if noun.head not in ("block", "measure", "other") or not noun.modifiers or noun.colors or noun.conjoined:
        return False
    base = phrase
    while base.phrases and base.phrases[0].tag == "NP" and base.children[0] is base.phrases[0]:
        base = base.phrases[0]
    texts = [word.text for word in base.words]
    if not texts or number(texts[0]) is None and texts[0] not in ("a", "an", "about"):
        return False
    plain = all(
        number(t) is not None or t in ("a", "an", "about", "and", "more") or w.is_measure(t) or w.is_block(t)
        for t in texts
    )
    counted = any(number(t) is not None for t in texts) or any(w.is_measure(t) for t in texts)
    led = any(w.directions(leaf.text) or leaf.text in ("behind", "from") for leaf in noun.modifiers[0].leaves[:5])
    before = [item.text for item in items[-2:]]
    related = (
        before[-1:] == ["to"]
        and before[:1] != before[-1:]
        and w.is_beside(before[0])
        or bool(before and before[-1] in _RELATING)
    )
    return plain and counted and (led or all(number(t) is not None for t in texts)) and not related


def _spread(phrase: Phrase, items: list[Item]) -> None:
    """The words of a noun phrase's head, and what follows it."""
    for place, child in enumerate(phrase.children):
        if isinstance(child, Word):
            item = _word(child)
            items.append(Item("length", item.text) if w.is_block(item.text) and item.kind == "word" else item)
        elif child.tag == "NP" and place == 0:
            _spread(child, items)
        else:
            _enter(child, items)


def _take(phrase: Phrase, noun: Noun, texts: list[str], items: list[Item]) -> None:
    if noun.head == "table":
        items.append(Item("table", phrase.text))
    elif noun.head == "pronoun" and len(texts) == 1:
        items.append(Item("pronoun", phrase.text))
    elif noun.conjoined:
        _join(phrase, noun, items)
    elif _is_length(noun, texts):
        _measure(phrase, noun, items)
    elif noun.head == "container":
        _arrangement(phrase, noun, items)
    elif noun.head == "block":
        items.append(Item("thing", noun.text, noun=noun))
    elif noun.head == "place" and (noun.place or noun.middle) and not _OWN & set(texts):
        _part(phrase, noun, items)
    else:
        _expand(phrase, items)


def _expand(phrase: Phrase, items: list[Item]) -> None:
    """What a phrase says; of several commands in one, the last tells where to."""
    commands = [place for place, child in enumerate(phrase.children) if isinstance(child, Phrase) and _commands(child)]
    start = commands[-1] if len(commands) > 0 and any(
        isinstance(c, Phrase) and c.tag == "VP" for c in phrase.children[: commands[-1]]) else 0  # fmt: skip
    for child in phrase.children[start:]:
        if isinstance(child, Word):
            items.append(_word(child))
        else:
            _enter(child, items)


def _join(phrase: Phrase, noun: Noun, items: list[Item]) -> None:
    parts = [read_noun(part) for part in noun.conjoined]
    if all(part.head in ("block", "container") and not _is_length(part, part.text.split()) for part in parts):
        items.append(Item("thing", phrase.text, noun=noun))
    else:
        _expand(phrase, items)


def _is_length(noun: Noun, texts: list[str]) -> bool:
    """Whether a noun phrase may be a distance: "two spaces", "half a block", "one row"."""
    bare = not (noun.colors or noun.modifiers or noun.ordinals or noun.distance or noun.lone or noun.other)
    counted = any(number(text) is not None for text in texts) or texts[:1] in (["a"], ["an"])
    if not (bare and counted) or _DEFINITE & set(texts):
        return False
    if noun.head == "measure" or noun.head == "other":
        return noun.head == "measure" or all(number(text) is not None for text in texts)
    if noun.head == "container":
        return texts[-1] in _LENGTHS and not noun.directions and not noun.middle and texts[0] not in ("a", "an")
    numbered = any(number(text) is not None for text in texts)
    return noun.head == "block" and numbered and not noun.directions and not noun.middle


def _measure(phrase: Phrase, noun: Noun, items: list[Item]) -> None:
    texts = [leaf.text for leaf in phrase.leaves]
    if noun.head == "block" and any(w.is_block(text) for text in texts) and "one" != texts[-1]:
        value = next((v for text in texts if (v := number(text)) is not None), 1.0)
        if value != int(value) or "half" in texts:
            items.extend(_word(leaf) for leaf in phrase.leaves if not w.is_block(leaf.text))
            items.append(Item("length", texts[-1]))
            return
        items.append(Item("counted", phrase.text, value, noun))
        return
    for leaf in phrase.leaves:
        item = _word(leaf)
        if item.kind == "word" and (leaf.text in _LENGTHS or w.is_block(leaf.text)):
            item = Item("length", leaf.text)
        elif leaf.text in ("a", "an") and not any(number(text) for text in texts):
            item = Item("number", leaf.text, 1.0)
        items.append(item)


def _arrangement(phrase: Phrase, noun: Noun, items: list[Item]) -> None:
    """Rows and columns are places by themselves: what else is said stands beside them."""
    texts = [leaf.text for leaf in phrase.leaves]
    if texts in (["line"], ["row"], ["column"]) or "same" in texts[:2] or _counts_stories(phrase):
        _spread(phrase, items)
        return
    made = not noun.definite and (not noun.modifiers or texts[0] in ("a", "an"))
    lines = bool({"row", "column"} & set(noun.kinds))
    if made and not noun.directions and not noun.middle:
        inner = tuple(m for m in noun.modifiers if m.leaves[0].text in ("of", "in"))
        items.append(Item("shape", phrase.text, noun=replace(noun, modifiers=inner)))
        for modifier in noun.modifiers:
            if modifier not in inner:
                _enter(modifier, items)
        return
    apart = [m for m in noun.modifiers if lines and m.tag in ("PP", "SBAR") and m.leaves[0].text not in ("of", "with")]
    kept = tuple(m for m in noun.modifiers if m not in apart)
    items.append(Item("thing", phrase.text, noun=replace(noun, modifiers=kept) if apart else noun))
    for modifier in apart:
        _enter(modifier, items)


def _counts_stories(phrase: Phrase) -> bool:
    """Whether a noun phrase is a story itself, not a building of so many: "the third story", "three stories"."""
    while phrase.phrases and phrase.children[0] is phrase.phrases[0]:
        phrase = phrase.phrases[0]
    words = [word.text for word in phrase.words]
    return bool(words) and words[-1] in STORIES


def _part(phrase: Phrase, noun: Noun, items: list[Item]) -> None:
    """A place of the table is one item; one of a thing says a direction from it."""
    owner = next((p for m in noun.modifiers for p in m.phrases if m.tag == "PP" and p.tag == "NP"), None)
    if owner is not None and read_noun(owner).head not in ("table", "other"):
        _spread(phrase, items)
    elif noun.agent is not None and noun.place == "side" and not (noun.directions or noun.middle):
        items.append(Item("place", phrase.text, noun=replace(noun, directions=("front",))))
    elif noun.directions or noun.middle or noun.place == "corner":
        items.append(Item("place", phrase.text, noun=noun))
    else:
        _spread(phrase, items)


def _joined(items: list[Item]) -> list[Item]:
    """Numbers that belong together: "two and a half", "1 2" for what was written as a fraction."""
    found: list[Item] = []
    for item in items:
        texts = [i.text for i in found[-2:]]
        if item.kind == "number" and found:
            last = found[-1]
            if item.value < 1 and texts[-1:] in (["a"], ["and"]):
                back = next((i for i in range(len(found) - 1, -1, -1) if found[i].text not in ("a", "and")), None)
                if back is not None and found[back].kind == "number" and "and" in [i.text for i in found[back:]]:
                    found[back:] = [replace(found[back], value=found[back].value + item.value)]
                    continue
            if last.kind == "number" and last.text.isdigit() and item.text.isdigit() and last.value < item.value <= 8:
                found[-1] = replace(last, value=last.value / item.value)
                continue
            if last.kind == "number" and item.value < 1:
                found[-1] = replace(last, value=last.value * item.value if last.value <= 1 else last.value + item.value)
                continue
        found.append(item)
    return found

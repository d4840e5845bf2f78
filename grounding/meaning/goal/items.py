"""The words of a destination in their order, with noun phrases that name something as one item."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass, replace

from grounding.language.tree import Phrase, Word
from grounding.lexicon import words as w
from grounding.lexicon.whereto import is_story, metres
from grounding.meaning.goal.lengths import LINES, Metres, is_length, number, opens_distance, peeled
from grounding.meaning.nouns import Noun, read_noun

_MOVING = frozenset("place put move set stack position lay slide shift".split())
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
    return _metric(_joined(items))


def _enter(phrase: Phrase, items: list[Item]) -> None:
    if phrase.tag == "NP":
        _name(phrase, items)
        return
    if phrase.tag in ("S", "SBAR", "VP") and items:
        items.append(STOP)
    _expand(phrase, items)


def _commands(phrase: Phrase) -> bool:
    return phrase.tag == "VP" and bool(phrase.words) and phrase.words[0].text in _MOVING


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
    if opens_distance(phrase, noun, [item.text for item in items[-2:]]):
        _spread(phrase, items)
        return
    _take(phrase, noun, texts, items)
    for modifier in apart:
        _enter(modifier, items)


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
        items.append(Item("table", phrase.text, noun=noun))
        for modifier in noun.modifiers:
            if modifier.tag == "PP" and modifier.leaves[0].text != "of":
                _enter(modifier, items)  # "on the table" "10 cm behind X"
    elif noun.head == "pronoun" and len(texts) == 1:
        items.append(Item("pronoun", phrase.text))
    elif noun.conjoined:
        _join(phrase, noun, items)
    elif is_length(noun, texts):
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
    """Take in what a phrase says; of several commands in one, the last tells where to."""
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
    if all(part.head in ("block", "container") and not is_length(part, part.text.split()) for part in parts):
        items.append(Item("thing", phrase.text, noun=noun))
    else:
        _expand(phrase, items)


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
        if item.kind == "word" and (leaf.text in LINES or w.is_block(leaf.text)):
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
    """Tells whether a noun phrase is a story itself, not a building of so many: "the third story", "three stories"."""
    while phrase.phrases and phrase.children[0] is phrase.phrases[0]:
        phrase = phrase.phrases[0]
    words = [word.text for word in phrase.words]
    return bool(words) and is_story(words[-1])


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


def _metric(items: list[Item]) -> list[Item]:
    """Numbers with a unit of length as one item: "10 cm", "half a metre"."""
    found: list[Item] = []
    for item in items:
        unit = metres(item.text) if item.kind == "length" else None
        back = 2 if len(found) > 1 and found[-1].text in ("a", "an", "of") else 1
        if unit is not None and len(found) >= back and found[-back].kind == "number":
            number_of = found[-back]
            found[-back:] = [replace(number_of, text=f"{number_of.text} {item.text}",
                                     value=Metres(number_of.value * unit))]  # fmt: skip
        elif unit is not None and found and found[-1].text in ("a", "an"):
            found[-1] = Item("number", f"{found[-1].text} {item.text}", Metres(unit))
        else:
            found.append(item)
    return found


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

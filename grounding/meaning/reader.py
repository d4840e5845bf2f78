"""Noun phrases to referents."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import replace

from grounding.language.lexicon import meanings, size_order
from grounding.language.tree import Phrase
from grounding.lexicon import words as w
from grounding.meaning import recall
from grounding.meaning.modifiers.forms import read_conditions
from grounding.meaning.nouns import Noun, read_noun
from grounding.meaning.reading import Context
from grounding.meaning.referents import (
    NOTHING,
    OBJECTS,
    PERSON,
    PLACE,
    SETS,
    TABLE,
    Condition,
    Referent,
    Region,
    again,
)
from grounding.meaning.things import own_conditions, selectors
from grounding.meaning.wholes import region_of, whole_of
from grounding.symbols import Cardinal

_CONTENT = (["of"], ["with"], ["containing"])


class Reader:
    """Reads noun phrases and modifiers; see `grounding.meaning.reading`.

    Attributes:
        context: what was spoken of before.
    """

    def __init__(self, context: Context | None = None) -> None:
        self.context = context or Context()

    @contextmanager
    def within(self, mentioned: Referent | None, *, several: bool = False) -> Iterator[None]:
        """Something else that "it" points to, for as long as the context lasts."""
        before = self.context
        self.context = replace(before, mentioned=mentioned, several=several)
        try:
            yield
        finally:
            self.context = before

    def conditions(self, phrase: Phrase, head: Noun) -> list[Condition]:
        """What a modifier says of what a noun speaks of."""
        return read_conditions(self, phrase, head)

    def phrase(self, phrase: Phrase) -> Referent:
        """What a noun phrase speaks of."""
        return self.refer(read_noun(phrase))

    def refer(self, noun: Noun) -> Referent:
        """What a noun speaks of."""
        if noun.sized and self.context.sizes:
            noun = _by_size(noun)
        if recall.is_recalled(noun) and (self.context.handled or recall.is_surely_recalled(noun)):
            return Referent(OBJECTS, (Condition("recalled", words=noun.colors),), text=noun.text)
        if noun.conjoined:
            return self._conjoined(noun)
        match noun.head:
            case "agent":
                return Referent(PERSON, person=noun.agent, text=noun.text)
            case "table":
                return self._table(noun)
            case "pronoun":
                return self._pronoun(noun)
            case "place":
                return self._place(noun)
            case "container":
                return self._arrangement(noun)
            case "block" | "other":
                return self._things(noun)
        return Referent(NOTHING, text=noun.text)

    def _things(self, noun: Noun) -> Referent:
        context = self.context
        if noun.head == "other" and not (noun.modifiers or noun.colors or context.knows(noun)):
            return Referent(NOTHING, text=noun.text)
        if context.several and context.mentioned is not None and _points_back(noun):
            those = Condition("those", (context.mentioned,))
            return Referent(SETS, (those,), number=noun.number, plural=True, text=noun.text)
        return Referent(
            SETS if noun.plural else OBJECTS, tuple(own_conditions(self, noun)), number=noun.number,
            plural=noun.plural, definite=noun.definite, universal=noun.universal, only=noun.only, text=noun.text,
        )  # fmt: skip

    def _table(self, noun: Noun) -> Referent:
        """A table, one of several where more is said of it."""
        found = [Condition("colour", words=noun.colors)] if noun.colors else []
        if noun.directions:
            found.append(Condition("extreme", region=Region(noun.directions, bare=True, owner=noun.agent)))
        if noun.other:
            found.append(Condition("other"))
        return Referent(TABLE, tuple(found), text=noun.text)

    def _pronoun(self, noun: Noun) -> Referent:
        if self.context.mentioned is not None:
            return replace(again(self.context.mentioned), text=noun.text)
        if self.context.handled:
            return Referent(OBJECTS, (Condition("recalled"),), text=noun.text)
        return Referent(NOTHING, text=noun.text)

    def _place(self, noun: Noun) -> Referent:
        """A place, or the objects at the end of something."""
        whole = whole_of(self, noun)
        some_part = "part" in noun.text.split() and not (noun.directions or noun.middle)
        if whole is not None and whole.sort == SETS and some_part:
            return whole
        region = region_of(noun, whole.region if whole is not None and whole.sort == PLACE else None)
        if whole is not None and whole.sort in (OBJECTS, SETS):
            part = Condition("part", (whole,), region=region)
            return Referent(OBJECTS, (part,), region=region, text=noun.text)
        modifying = [c for m in noun.modifiers for c in self.conditions(m, noun) if c.restricts]
        return Referent(PLACE, tuple(modifying), region=region, text=noun.text)

    def _arrangement(self, noun: Noun) -> Referent:
        """A row, a column, a group, a tower, with what it is made of and what is said of the whole."""
        context = self.context
        pointing = noun.text.split()[0] in ("that", "this") and not (noun.plural or noun.modifiers)
        if pointing and context.several and context.mentioned is not None:
            return Referent(SETS, (Condition("those", (context.mentioned,)),), kinds=noun.kinds, text=noun.text)
        colors, types, number = noun.colors, noun.types, noun.number
        found: list[Condition] = []
        for modifier in noun.modifiers:
            content = _content(modifier)
            if content is None:
                found += self.conditions(modifier, noun)
            else:
                colors, number = colors or content.colors, number or content.number
                types = types or content.types
        if "-" in noun.text:
            number = number or _hyphenated(noun.text)
        made = [Condition("colour", words=colors)] if colors else []
        made += [Condition("kind", words=types)] if types else []
        return Referent(
            SETS, (*made, *found, *selectors(noun)), kinds=noun.kinds, number=number, plural=noun.plural,
            definite=noun.definite, universal=noun.universal, only=noun.only, text=noun.text,
        )  # fmt: skip

    def _conjoined(self, noun: Noun) -> Referent:
        """Noun phrases joined with "and": more of the same thing, or two things."""
        first = read_noun(noun.conjoined[0])
        if first.head == "block" and all(not _has_noun(part) for part in noun.conjoined[1:]):
            return self.refer(replace(first, modifiers=(*first.modifiers, *noun.conjoined[1:], *noun.modifiers)))
        whole = _coloured(noun)
        if whole is not None:
            return self.refer(whole)
        parts = tuple(self.phrase(part) for part in noun.conjoined)
        kinds = {kind for part in parts for kind in part.kinds}
        things = tuple(part for part in parts if part.sort in (OBJECTS, SETS))
        if not things:
            return Referent(NOTHING, text=noun.text)
        crossing = len(parts) == 2 and kinds == {"row", "column"}
        return Referent(SETS, parts=things, number=len(parts), plural=not crossing, crossing=crossing,
                        definite=noun.definite, text=noun.text)  # fmt: skip


def _by_size(noun: Noun) -> Noun:
    """A noun whose word for a size tells things apart, where these are of different sizes: "the small block"."""
    small = size_order(noun.sized) < 0
    lone = noun.lone and not noun.unstacked
    return replace(noun, head="block", kinds=(), size=-1 if small else 1, lone=lone, unstacked=False,
                   plural=noun.plural and noun.head == "block")  # fmt: skip


def _coloured(noun: Noun) -> Noun | None:
    """One arrangement of which several colours are said: "the blue and" "green tower"; None for several things."""
    parts = [read_noun(part) for part in noun.conjoined]
    last, before = parts[-1], parts[:-1]
    bare = all(p.colors and not (p.types or p.kinds or p.modifiers) and not _named(p) for p in before)
    if not (bare and last.head == "container" and last.colors) or last.plural or last.text.startswith(("a ", "the ")):
        return None
    colors = tuple(dict.fromkeys(color for part in parts for color in part.colors))
    return replace(last, colors=colors, definite=before[0].definite, modifiers=(*last.modifiers, *noun.modifiers),
                   text=noun.text)  # fmt: skip


def _named(noun: Noun) -> bool:
    return any(w.is_block(text) or w.containers(text) for text in noun.text.split())


def _content(modifier: Phrase) -> Noun | None:
    """The members that an arrangement is said to have: "of five", "of red blocks"."""
    if modifier.tag == "PP" and [word.text for word in modifier.words] in _CONTENT and modifier.phrases:
        inner = read_noun(modifier.phrases[0])
        if inner.head == "block" and not inner.ordinals and not inner.distance and not inner.modifiers:
            return inner
    return None


def _hyphenated(text: str) -> int | None:
    """The number of "a five-block row"."""
    numbers = (s.value for word in text.split() if "-" in word for s in meanings(word.split("-")[0])
               if isinstance(s, Cardinal))  # fmt: skip
    return next(numbers, None)


def _points_back(noun: Noun) -> bool:
    """Whether a plural tells nothing but how many: "the two", "these four blocks"."""
    told = (noun.colors, noun.modifiers, noun.directions, noun.ordinals, noun.distance, noun.middle, noun.lone)
    return noun.plural and noun.definite and not any(told) and not noun.conjoined


def _has_noun(phrase: Phrase) -> bool:
    """Whether a noun phrase names a kind of thing itself."""
    return any(w.is_block(leaf.text) or w.containers(leaf.text) for leaf in phrase.leaves)

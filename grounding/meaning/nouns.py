"""Noun phrases, read for what they ask: a head, what restricts it, what selects within, and its modifiers."""

from __future__ import annotations

from dataclasses import dataclass, replace

from grounding.language.lexicon import is_plural, is_universal, meanings, size_order
from grounding.language.tree import Phrase, Word
from grounding.lexicon import words as w
from grounding.symbols import LAST, Cardinal, ObjectColor, Ordinal

_KEPT = "graded noun"
_INDEFINITE = frozenset("a an some any".split())
_SKIPPED = frozenset("the that this these those of 's very really all and or is please your my its his her".split())


_IN_TOWER = Phrase("PP", (Word("in", "IN", 0), Phrase("NP", (Word("a", "DT", 0), Word("tower", "NN", 0)))))


@dataclass(frozen=True)
class Noun:
    """What a noun phrase says.

    Attributes:
        head: block, container, place, table, agent, pronoun, measure, or other.
        kinds: of container.
        place: "side" or "corner".
        colors: asked for; one of them is enough.
        number: how many, or None.
        counted: how many of each colour, where several colours are named: "three green and one blue block".
        plural: whether several are meant.
        ordinals: ranks, -1 for the last.
        distance: "near" or "far", a rank by distance.
        far: whether "far" is said, of a place or a thing.
        directions: that words before the head name.
        middle: whether the middle is asked for.
        lone: whether it stands apart.
        unstacked: whether that means only that it is not part of a stack: "the single block".
        other: whether what was spoken of is excluded.
        only: whether it is the only one.
        size: 1 for the largest arrangement, -1 for the smallest.
        agent: who is meant by a pronoun, or whose side it is.
        definite: False after "a", "some".
        universal: "all", "both".
        unknown: words that say nothing here.
        strange: whether the thing itself is named by a word that nobody knows.
        modifiers: phrases after the head.
        conjoined: further noun phrases joined with "and".
        text: its words.
    """

    head: str = "other"
    kinds: tuple[str, ...] = ()
    place: str | None = None
    colors: tuple[str, ...] = ()
    number: int | None = None
    counted: tuple[tuple[int | None, str], ...] = ()
    plural: bool = False
    ordinals: tuple[int, ...] = ()
    distance: str | None = None
    far: bool = False
    directions: tuple[str, ...] = ()
    middle: bool = False
    lone: bool = False
    unstacked: bool = False
    other: bool = False
    only: bool = False
    size: int = 0
    agent: str | None = None
    definite: bool = True
    universal: bool = False
    unknown: tuple[str, ...] = ()
    strange: bool = False
    modifiers: tuple[Phrase, ...] = ()
    conjoined: tuple[Phrase, ...] = ()
    text: str = ""


def read_noun(phrase: Phrase) -> Noun:
    """Read a noun phrase; nested heads are read as one. What was read is kept with the phrase, which is immutable."""
    kept: dict[str, object] = phrase.__dict__
    noun = kept.get(_KEPT)
    if not isinstance(noun, Noun):
        noun = kept[_KEPT] = _read(phrase)
    return noun


def is_measuring(noun: Noun) -> bool:
    """Whether a noun may only tell how far: "two blocks", "half a block"."""
    told = noun.colors or noun.modifiers or noun.ordinals or noun.directions or noun.distance or noun.lone
    return noun.head == "measure" or (noun.head == "block" and noun.number is not None and not noun.definite) or (
        noun.head == "block" and noun.number is not None and not told and not noun.text.startswith("the ")
    )


def _read(phrase: Phrase) -> Noun:
    inner = [child for child in phrase.phrases if child.tag == "NP"]
    conjunction = any(word.tag == "CC" or word.text in ("and", "or") for word in phrase.words)
    if inner and conjunction and len(inner) > 1:
        joined = _extended(inner[0], inner[1:])
        if joined is not None:
            return read_noun(joined)
        parts = tuple(inner)
        first = read_noun(parts[0])
        rest = tuple(child for child in phrase.phrases if child.tag != "NP")
        nouns = [read_noun(part) for part in parts]
        if all(noun.head == "place" and noun.directions and not noun.modifiers for noun in nouns):
            names = tuple(dict.fromkeys(name for noun in nouns for name in noun.directions))
            return replace(first, directions=names, modifiers=rest, text=phrase.text)  # "the back and the right"
        return replace(first, conjoined=parts, modifiers=rest, text=phrase.text)
    own = read_words(phrase.words)
    if not inner:
        return replace(own, modifiers=_following(own.modifiers, phrase.phrases), text=phrase.text)
    head = read_noun(inner[0])
    others = tuple(child for child in phrase.phrases if child is not inner[0])
    return replace(_merged(head, own), modifiers=_following(head.modifiers, others), text=phrase.text)


def _following(before: tuple[Phrase, ...], after: tuple[Phrase, ...]) -> tuple[Phrase, ...]:
    """Modifiers in order; a bare direction takes what "of" names: "the box southwest" "of the tower"."""
    bare = bool(before and after) and not before[-1].phrases and [word.text for word in after[0].words] == ["of"]
    if bare and any(w.directions(word.text) for word in before[-1].words):
        return (*before[:-1], Phrase("PP", (*before[-1].children, *after[0].children)), *after[1:])
    return (*before, *after)


def _extended(phrase: Phrase, further: list[Phrase]) -> Phrase | None:
    """A noun phrase whose last modifier asks for several, with what was joined to the whole: "between X" "and Y"."""
    children = phrase.children
    if not children or not isinstance(children[-1], Phrase):
        return None
    last = children[-1]
    if last.tag == "PP" and any(w.is_between(v.text) or w.is_surrounded(v.text) for v in last.words):
        inner = last.children[-1]
        if not isinstance(inner, Phrase) or inner.tag != "NP" or any(v.tag == "CC" for v in inner.words):
            return None
        joiner = Word("and", "CC", inner.leaves[-1].index + 1)
        together = Phrase("NP", (inner, joiner, *further))
        return Phrase(phrase.tag, (*children[:-1], Phrase("PP", (*last.children[:-1], together))))
    deeper = _extended(last, further)
    return None if deeper is None else Phrase(phrase.tag, (*children[:-1], deeper))


def read_words(leaves: tuple[Word, ...]) -> Noun:
    """Read the words of a base noun phrase."""
    found = _Reading()
    for place, word in enumerate(leaves):
        found.take(word, last=place == len(leaves) - 1)
    return found.noun(" ".join(word.text for word in leaves))


def _merged(head: Noun, own: Noun) -> Noun:
    """A head with what is said before it."""
    return replace(
        head,
        colors=head.colors or own.colors,
        number=head.number or own.number,
        ordinals=head.ordinals or own.ordinals,
        distance=head.distance or own.distance,
        far=head.far or own.far,
        directions=(*own.directions, *head.directions),
        middle=head.middle or own.middle,
        lone=head.lone or own.lone,
        unstacked=head.unstacked or own.unstacked,
        other=head.other or own.other,
        unknown=(*own.unknown, *head.unknown),
        universal=head.universal or own.universal,
        head=own.head if head.head == "other" else head.head,
        kinds=head.kinds or own.kinds,
        strange=head.strange and own.head == "other",
    )


class _Reading:
    """Collects what the words of a base noun phrase say."""

    def __init__(self) -> None:
        self.said: dict[str, object] = {}
        self.colors: list[str] = []
        self.ordinals: list[int] = []
        self.directions: list[str] = []
        self.unknown: list[str] = []
        self.kinds: tuple[str, ...] = ()
        self.heads: list[str] = []
        self.stacked = False
        self.small = False
        self.storied = False
        self.away = False
        self.far = False
        self.counts: list[int] = []
        self.count: int | None = None
        self.counted: list[tuple[int | None, str]] = []
        self.named_strangely = False
        self.behind: list[Word] = []

    def take(self, word: Word, last: bool) -> None:
        text = word.text
        if "-" in text and not meanings(text) and not w.directions(text) and not w.place(text):
            parts = [part for part in text.split("-") if part]
            for place, part in enumerate(parts):
                tag = "NNS" if part.endswith("s") else "NN" if place == len(parts) - 1 else word.tag
                self.take(Word(part, tag, word.index), last and place == len(parts) - 1)
            return
        if text in _INDEFINITE:
            self.said["definite"] = False
            return
        symbols = meanings(text)
        for symbol in symbols:
            if isinstance(symbol, ObjectColor):
                self.colors.append(symbol.name)
                self.counted.append((self.count, symbol.name))
                self.count = None
                return
            if isinstance(symbol, Ordinal):
                self.ordinals.append(symbol.value)
                return
        if text in ("last", "final"):
            self.ordinals.append(LAST)
            return
        for symbol in symbols:
            if isinstance(symbol, Cardinal) and not (text == "one" and (last and self.said_more)):
                self.counts.append(symbol.value)
                self.count = symbol.value
                self.said["number"] = sum(self.counts) if len(self.colors) + 1 >= len(self.counts) > 1 else symbol.value
        if is_universal(text):
            self.said["universal"] = True
            return
        if text == "only":
            self.said["only"] = True
            return
        if size_order(text):
            self.said["size"] = size_order(text)
            self.small = text == "small"
            return
        self._take_noun(word, last)

    @property
    def said_more(self) -> bool:
        return bool(self.said or self.colors or self.ordinals or self.directions or self.unknown) or True

    def _take_noun(self, word: Word, last: bool = False) -> None:
        text = word.text
        if w.is_lone(text):
            self.said["lone"] = True
            self.said["unstacked"] = w.is_unstacked(text)
            return
        if w.is_other(text):
            self.said["other"] = True
            if text == "others":
                self.said["plural"] = True
            return
        if text in ("stacked", "piled"):
            self.stacked = True
            return
        if w.is_middle(text):
            self.said["middle"] = True
            return
        kinds = w.containers(text)
        if kinds:
            self.heads.append("container")
            self.storied |= text in ("story", "stories")
            self.kinds = tuple(k for k in kinds if k in self.kinds) or kinds
            self.said["plural"] = is_plural(word.tag) or text.endswith("s")
            if text in ("pair", "duo", "couple"):
                self.said["number"] = 2
            if text == "trio":
                self.said["number"] = 3
            return
        if w.is_block(text):
            self.heads.append("block")
            self.said["plural"] = text.endswith(("s", "es")) and text != "ones'"
            return
        if w.is_table(text):
            self.heads.append("table")
            return
        if w.is_measure(text):
            self.heads.append("measure")
            return
        if w.place(text) and not w.directions(text):
            self.heads.append("place")
            self.said["place"] = "corner" if self.said.get("place") == "corner" else w.place(text)
            return
        if w.agent(text):
            self.said["agent"] = w.agent(text)
            return
        self.away |= text in ("far", "very", "extreme")
        self.far |= text == "far"
        distance = w.distance(text)
        if distance and (w.is_ranking(text) or not self.said.get("distance")):
            if w.is_ranking(text) or distance == "near":
                self.said["distance"] = distance
            return
        named = w.directions(text)
        if named and self.heads and self.heads[-1] in ("block", "container"):
            self.behind.append(word)
            return
        if named:
            self.directions += [name for name in named if name not in self.directions]
            if w.is_extreme(text):
                self.said["extreme"] = True
            return
        if text in ("it", "them", "itself", "they"):
            self.heads.append("pronoun")
            return
        if text not in _SKIPPED and word.tag not in ("DT", "PDT", "IN", "TO", "CC", "RB", "PRP$", "POS", "UH"):
            self.unknown.append(text)
            self.named_strangely = word.tag in ("NN", "NNS", "NNP") and last

    def noun(self, text: str) -> Noun:
        said = dict(self.said)
        said.pop("extreme", None)
        head = self._head()
        number = said.get("number")
        if number == 1:
            said.pop("number")
            if head == "other":
                head = "block"
        if head == "other" and self.directions and said.get("distance") == "far" and not (self.colors or self.ordinals):
            head = "place"  # "the furthest left"
        if head == "other" and (self.colors or self.ordinals or said.get("number") or said.get("lone")
                                or said.get("distance") or said.get("universal") or said.get("other")):  # fmt: skip
            head = "block"
        if head == "other" and (self.directions or said.get("middle") or said.get("place")):
            head = "place"
        if head == "place" and said.get("place") and (self.away or said.get("distance") == "near"):
            deep = "back" if self.away else "front"
            if not {"back", "front", "up", "down"} & set(self.directions) and (
                said["place"] == "corner" or not self.directions
            ):
                self.directions.append(deep)  # "the far right corner", "the near edge"
        if head == "block" and self.far and not (self.directions or said.get("distance")):
            said["distance"] = "far"  # "the far one"
        if head == "table" and said.get("middle"):
            head = "place"  # "the table center"
        if head == "place" and self.away and self.directions and said.get("place") != "corner":
            said["distance"] = "far"  # "the far left of the table" is as far left as anything is
        if head == "other" and said.get("agent"):
            head = "agent"
        if head == "block" and isinstance(number, int) and number > 1:
            said["plural"] = True
        if LAST in self.ordinals and len(self.ordinals) > 1:  # "second to last"
            self.ordinals = [LAST * next(o for o in self.ordinals if o != LAST)]
        if head == "block" and said.get("universal"):
            said["plural"] = True
        kinds = self.kinds
        if head == "block" and said.get("size") == -1 and self.small:
            said["size"], said["lone"], said["unstacked"] = 0, True, True  # "the small block"
        if head == "block" and (said.get("plural") and self.stacked or (said.get("size") and not self.stacked)):
            head, kinds = "container", ("tower",)
            said["plural"] = False
        modifiers = (Phrase("PP", tuple(self.behind)),) if self.behind else ()
        if head == "block" and self.stacked:
            modifiers = (*modifiers, _IN_TOWER)  # "the stacked block"
        strange = self.named_strangely and not self.heads
        return Noun(head=head, kinds=kinds, modifiers=modifiers, strange=strange, far=self.away,
                    colors=tuple(self.colors), counted=tuple(self.counted),
                    ordinals=tuple(self.ordinals), directions=tuple(self.directions), unknown=tuple(self.unknown),
                    text=text, **said)  # type: ignore[arg-type]  # fmt: skip

    def _head(self) -> str:
        heads = self.heads
        if not heads:
            return "other"
        if heads[-1] in ("measure", "block") and self.storied:
            return "container"  # "a two-story unit"
        if "measure" in heads:
            return "measure"
        if heads[-1] == "block" and "container" in heads[:-1] and len(heads) > 1:
            return "block"  # "the tower block"
        return heads[-1]

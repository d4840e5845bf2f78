"""The words of a base noun phrase: what each says of its head, and what they say together."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from grounding.language.lexicon import is_plural, is_universal, meanings, size_order
from grounding.language.tree import Phrase, Word
from grounding.lexicon import words as w
from grounding.lexicon.shades import tint_of
from grounding.symbols import LAST, Cardinal, ObjectColor, Ordinal

_INDEFINITE = frozenset("a an some any either".split())
_POINTING = frozenset("the this that these those my your his her its".split())
_SKIPPED = frozenset("the that this these those of 's very really all and or is please your my its his her".split())
_SMALL_WORDS = ("DT", "PDT", "IN", "TO", "CC", "RB", "PRP$", "POS", "UH")
_IN_TOWER = Phrase("PP", (Word("in", "IN", 0), Phrase("NP", (Word("a", "DT", 0), Word("tower", "NN", 0)))))
_DEEP = frozenset("back front up down".split())


class NounWords:
    """Collects what the words of a base noun phrase say, one after the other."""

    def __init__(self) -> None:
        self.said: dict[str, Any] = {}
        self.colors: list[str] = []
        self.ordinals: list[int] = []
        self.directions: list[str] = []
        self.unknown: list[str] = []
        self.kinds: tuple[str, ...] = ()
        self.types: list[str] = []
        self.heads: list[str] = []
        self.stacked = False
        self.small = False
        self.sized = ""
        self.storied = False
        self.away = False
        self.far = False
        self.counts: list[int] = []
        self.count: int | None = None
        self.counted: list[tuple[int | None, str]] = []
        self.named_strangely = False
        self.behind: list[Word] = []
        self.last = False
        self.joined = False
        self.mixed = False
        self.pointed = False
        self.tint: str | None = None

    def take(self, word: Word, last: bool) -> None:
        """Take in a word.

        Args:
            word: the next one.
            last: whether none follows.
        """
        text = word.text
        if "-" in text and not meanings(text) and not w.directions(text) and not w.place(text):
            parts = [part for part in text.split("-") if part]
            for place, part in enumerate(parts):
                self.joined = place > 0
                tag = "NNS" if part.endswith("s") else "NN" if place == len(parts) - 1 else word.tag
                self.take(Word(part, tag, word.index), last and place == len(parts) - 1)
            self.joined = False
            return
        self.last = last
        if not any(hears(self, word) for hears in _HEARING):
            self._unknown(word)

    # -- what single words say: each tells whether it was heard ------------------------------------------------------

    def _article(self, word: Word) -> bool:
        self.pointed |= word.text in _POINTING
        if word.text in _INDEFINITE:
            self.said["definite"] = False
        return word.text in _INDEFINITE

    def _symbol(self, word: Word) -> bool:
        """A colour, a rank or a number; a number leaves open what else the word says."""
        symbols = meanings(word.text)
        for symbol in symbols:
            if isinstance(symbol, ObjectColor):
                self._colour(symbol.name)
                return True
            if isinstance(symbol, Ordinal):
                self.ordinals.append(symbol.value)
                return True
        if word.text in ("last", "final"):
            self.ordinals.append(LAST)
            return True
        for symbol in symbols:
            if isinstance(symbol, Cardinal) and not (word.text == "one" and self.last):
                self._number(symbol.value)
        return False

    def _colour(self, name: str) -> None:
        """A colour, with the tint that was said before it: "light blue"."""
        told = name if self.tint is None else f"{self.tint}-{name}"
        self.mixed |= self.joined and self.tint is None
        self.tint = None
        self.colors.append(told)
        self.counted.append((self.count, told))
        self.count = None

    def _tint(self, word: Word) -> bool:
        """What shade of a colour is meant, said before it or, as in "blue-sky", behind it."""
        tint = tint_of(word.text)
        if tint is not None and self.joined and self.colors:
            self.colors[-1] = f"{tint}-{self.colors[-1]}"
        elif tint is not None:
            self.tint = tint
        return tint is not None

    def _coloured_ones(self, word: Word) -> bool:
        """A colour in the plural: "the greens"."""
        text = word.text
        named = [symbol for symbol in meanings(text[:-1]) if isinstance(symbol, ObjectColor)]
        if text[-1:] != "s" or not named or meanings(text):
            return False
        self._colour(named[0].name)
        self.heads.append("block")
        self.said["plural"] = True
        return True

    def _number(self, value: int) -> None:
        self.counts.append(value)
        self.count = value
        together = len(self.colors) + 1 >= len(self.counts) > 1  # "two red and three blue blocks"
        self.said["number"] = sum(self.counts) if together else value

    def _amount(self, word: Word) -> bool:
        """Words such as "all", "only", "largest"."""
        if is_universal(word.text):
            self.said["universal"] = True
        elif word.text == "only":
            self.said["only"] = True
        elif size_order(word.text):
            self.said["size"] = size_order(word.text)
            self.small = word.text in ("small", "little", "tiny")
            self.sized = word.text
        else:
            return False
        return True

    def _standing(self, word: Word) -> bool:
        """Words such as "lone", "other", "stacked", "middle"."""
        text = word.text
        if w.is_lone(text):
            self.said["lone"] = True
            self.said["unstacked"] = w.is_unstacked(text)
        elif w.is_other(text):
            self.said["other"] = True
            if text == "others":
                self.said["plural"] = True
        elif text in ("stacked", "piled"):
            self.stacked = True
        elif w.is_middle(text):
            self.said["middle"] = True
        else:
            return False
        return True

    def _arrangement(self, word: Word) -> bool:
        text, kinds = word.text, w.containers(word.text)
        if not kinds:
            return False
        self.heads.append("container")
        self.storied |= text in ("story", "stories")
        self.kinds = tuple(k for k in kinds if k in self.kinds) or kinds
        self.said["plural"] = is_plural(word.tag) or text.endswith("s")
        if w.members(text):
            self.said["number"] = w.members(text)
        return True

    def _thing(self, word: Word) -> bool:
        """A block, the table, a measure, a part of the table, somebody."""
        text = word.text
        if w.is_block(text):
            self.heads.append("block")
            if text == "one" and not (self.pointed or self.colors or self.directions or self.ordinals):
                self.said["definite"] = False  # "one of the blue blocks"
            kind = w.kind(text)
            self.types += [] if kind is None or kind in self.types else [kind]
            self.said["plural"] = text.endswith(("s", "es")) and text != "ones'"
        elif w.is_table(text):
            self.heads.append("table")
        elif w.is_measure(text):
            self.heads.append("measure")
        elif w.place(text) and not w.directions(text):
            self.heads.append("place")
            self.said["place"] = "corner" if self.said.get("place") == "corner" else w.place(text)
        elif w.agent(text):
            self.said["agent"] = w.agent(text)
        else:
            return False
        return True

    def _distance(self, word: Word) -> bool:
        text = word.text
        self.away |= text in ("far", "very", "extreme")
        self.far |= text == "far"
        distance = w.distance(text)
        if not distance or not (w.is_ranking(text) or not self.said.get("distance")):
            return False
        if w.is_ranking(text) or distance == "near":
            self.said["distance"] = distance
        return True

    def _direction(self, word: Word) -> bool:
        named = w.directions(word.text)
        if named and self.heads and self.heads[-1] in ("block", "container"):
            self.behind.append(word)
        elif named:
            self.directions += [name for name in named if name not in self.directions]
        return bool(named)

    def _pronoun(self, word: Word) -> bool:
        if word.text not in ("it", "them", "itself", "they"):
            return False
        self.heads.append("pronoun")
        return True

    def _unknown(self, word: Word) -> None:
        if word.text not in _SKIPPED and word.tag not in _SMALL_WORDS:
            self.unknown.append(word.text)
            self.named_strangely = word.tag in ("NN", "NNS", "NNP") and self.last

    # -- what they say together --------------------------------------------------------------------------------------

    def told(self) -> dict[str, Any]:
        """The fields of a noun."""
        said = dict(self.said)
        head = self._head_of(said)
        self._deepen(head, said)
        head = self._placed(head, said)
        self._count(head, said)
        kinds = self.kinds
        said["sized"] = self.sized if head in ("block", "other") else ""
        if head == "block" and said.get("size") == -1 and self.small:
            said["size"], said["lone"], said["unstacked"] = 0, True, True  # "the small block"
        if head == "block" and (said.get("plural") and self.stacked or (said.get("size") and not self.stacked)):
            head, kinds = "container", ("tower",)
            said["plural"] = False
        if head == "block" and self.mixed:  # "the red-yellow block" is two of them, one on the other
            head, kinds, self.types = "container", ("tower",), []
            said["plural"] = False
        modifiers = (Phrase("PP", tuple(self.behind)),) if self.behind else ()
        if head == "block" and self.stacked:
            modifiers = (*modifiers, _IN_TOWER)  # "the stacked block"
        return {
            **said, "head": head, "kinds": kinds, "modifiers": modifiers, "far": self.away,
            "strange": self.named_strangely and not self.heads, "colors": tuple(self.colors),
            "types": tuple(self.types), "counted": tuple(self.counted), "ordinals": tuple(self.ordinals),
            "directions": tuple(self.directions), "unknown": tuple(self.unknown),
        }  # fmt: skip

    def _head_of(self, said: dict[str, Any]) -> str:
        """The head, also where none is named: what is counted, coloured or ranked is a thing."""
        head = self._named()
        if said.get("number") == 1:
            said.pop("number")
            if not self.pointed:
                said["definite"] = False  # "one blue block"
            head = "block" if head == "other" else head
        if head != "other":
            return head
        ranked = self.colors or self.ordinals
        if self.directions and said.get("distance") == "far" and not ranked:
            return "place"  # "the furthest left"
        if ranked or any(said.get(name) for name in ("number", "lone", "distance", "universal", "other")):
            return "block"
        return "place" if self.directions or said.get("middle") or said.get("place") else head

    def _deepen(self, head: str, said: dict[str, Any]) -> None:
        """Take "far" and "near" as directions of a place: "the far right corner", "the near edge"."""
        if head != "place" or not said.get("place") or not (self.away or said.get("distance") == "near"):
            return
        if not _DEEP & set(self.directions) and (said["place"] == "corner" or not self.directions):
            self.directions.append("back" if self.away else "front")

    def _placed(self, head: str, said: dict[str, Any]) -> str:
        """The head where distances, the middle or somebody change it."""
        if head in ("block", "container") and self.far and not (self.directions or said.get("distance")):
            said["distance"] = "far"  # "the far one"
        if head == "table" and said.get("middle"):
            head = "place"  # "the table center"
        if head == "place" and self.away and self.directions and said.get("place") != "corner":
            said["distance"] = "far"  # "the far left of the table" is as far left as anything is
        return "agent" if head == "other" and said.get("agent") else head

    def _count(self, head: str, said: dict[str, Any]) -> None:
        """Numbers and "all" make several; "second to last" is one rank."""
        number = said.get("number")
        if head == "block" and ((isinstance(number, int) and number > 1) or said.get("universal")):
            said["plural"] = True
        if LAST in self.ordinals and len(self.ordinals) > 1:
            self.ordinals = [LAST * next((o for o in self.ordinals if o != LAST), 1)]

    def _named(self) -> str:
        heads = self.heads
        if not heads:
            return "other"
        if heads[-1] in ("measure", "block") and self.storied:
            return "container"  # "a two-story unit"
        if "measure" in heads:
            return "measure"
        if heads[-1] == "block" and "container" in heads[:-1]:
            return "block"  # "the tower block"
        return heads[-1]


_HEARING: tuple[Callable[[NounWords, Word], bool], ...] = (
    NounWords._article, NounWords._tint, NounWords._coloured_ones, NounWords._symbol, NounWords._amount,
    NounWords._standing, NounWords._arrangement, NounWords._thing, NounWords._distance, NounWords._direction,
    NounWords._pronoun,
)  # fmt: skip
"""What a word may say, in the order in which it is tried."""

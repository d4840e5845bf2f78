"""From the pieces of a destination to clues, in one pass from left to right."""

from __future__ import annotations

from dataclasses import replace

from grounding.lexicon import words as w
from grounding.meaning.goal.ahead import (
    direction_follows,
    ends_in_place,
    face_follows,
    reference_follows,
    side_follows,
    thing_follows,
    top_of_thing,
)
from grounding.meaning.goal.clues import Clue, Offset
from grounding.meaning.goal.items import Item, ordinal, stories
from grounding.meaning.goal.memory import Memory
from grounding.meaning.goal.vocabulary import (
    ALIGNING,
    AXES,
    BINDING,
    BREAKS,
    EMPHASIZED,
    FACES,
    IN,
    LARGE,
    LINKING,
    LINKS,
    ON,
    OPPOSITE,
    OWN,
    SIDEWAYS,
    SMALL,
    STACKING,
    STORIES,
    TALL,
    TOWARD,
)
from grounding.meaning.nouns import Noun
from grounding.world.scene import ROBOT, SPEAKER

_PEOPLE = {ROBOT: "front", SPEAKER: "back"}  # "toward you" is to the robot's front; who speaks sits across the table


def listen(items: list[Item]) -> list[Clue]:
    """The clues that a destination gives, in the order of the words.

    Args:
        items: its pieces, see `line_up`.
    """
    listener = _Listener(items)
    for place, item in enumerate(items):
        listener.hear(place, item)
    return listener.finish()


class _Listener(Memory):
    """Takes one piece after the other in."""

    def __init__(self, items: list[Item]) -> None:
        super().__init__()
        self.items = items
        self.passed = 0

    # -- pieces ----------------------------------------------------------------------------------------------------

    def hear(self, place: int, item: Item) -> None:
        """Take one piece in."""
        if self.passed:
            self.passed -= 1
            return
        if item.kind == "stop":
            self.flush()
            self.since = []
        elif item.kind == "number":
            self._count(item.value, place)
        elif item.kind == "length":
            if self.number is None and self.since[-1:] in (["a"], ["an"]) and not self.measured():
                self._count(1.0, place)
        elif item.kind == "counted" and [i.text for i in self.items[place + 1 : place + 2] if i.text in TALL]:
            self.height = int(item.value)
        elif item.kind == "counted":
            if (
                self.relation
                or self.since[-1:] in (["of"], ["with"], ["to"])
                or (self.offsets and self.offsets[-1].binding and not self.since)
            ):
                self._refer(item.noun)
            else:
                self._count(item.value, place)
        elif item.kind == "thing":
            self._refer(item.noun)
        elif item.kind == "pronoun":
            self._point_back(item)
        elif item.kind == "place":
            self._locate(item.noun)
        elif item.kind == "table":
            self._on_table()
        elif item.kind == "shape":
            self._shape(item)
        else:
            self._word(place, item.text)

    def _count(self, value: float, place: int) -> None:
        """A number belongs to the direction after it, or else to the one before it."""
        open_before = bool(self.offsets) and self.offsets[-1].steps is None
        if open_before and (not self.since or not direction_follows(self.items, place)):
            everywhere = bool({"by", "each", "both"} & set(self.since))
            self.offsets = [
                replace(offset, steps=value)
                if offset.steps is None and (everywhere or offset is self.offsets[-1])
                else offset
                for offset in self.offsets
            ]
            self.since = []
        elif (
            not self.offsets
            and not direction_follows(self.items, place)
            and self.clues
            and not self.relation
            and (self.clues[-1].offsets and self.clues[-1].offsets[-1].steps is None)
            and "and" not in self.since
        ):
            last = self.clues[-1]
            self.clues[-1] = replace(last, offsets=(*last.offsets[:-1], replace(last.offsets[-1], steps=value)))
        else:
            self.number = value

    def _word(self, place: int, text: str) -> None:
        following = [
            i.text if i.kind in ("word", "number", "length") else "" for i in self.items[place + 1 : place + 4]
        ]
        names = (BINDING[text],) if text in BINDING else w.directions(text)
        if text == "right" and following[:1] and following[0] in EMPHASIZED:
            self.strict = True
        elif text in ("top", "tops") and top_of_thing(self.items, place):
            self.relation = "on"
        elif names:
            self._direct(place, text, names, following)
            return
        elif text in BREAKS:
            self.flush()
            self.since = []
            return
        elif w.is_middle(text) and not self.offsets and not self.since and self._in_arrangement():
            self.clues[-1] = replace(self.clues[-1], relation="between")  # "the circle's center"
        elif w.is_between(text) or w.is_middle(text):
            self.relation = "between"
        elif text in ALIGNING:
            self.relation = "align"
        elif (w.is_touching(text) or text in LINKING) and text != "against":
            self.relation = self.relation if self.tower else "touch"
        elif self.relation == "toward" and w.agent(text) in _PEOPLE:
            self.relation = ""
            self._direct(place, text, (_PEOPLE[w.agent(text) or ROBOT],), following)
            return
        elif text in TOWARD:
            self.relation = "toward"
        elif text in STACKING:
            if text in STORIES and (self.number or self.rank):
                self.height, self.number = int(self.number or self.rank), None
            self.relation, self.tower = "on", self.tower or text not in ("level",)
        elif w.is_beside(text) or text == "against":
            self.relation = self.relation or "near"
        elif text in ON and not side_follows(self.items, place):
            self.relation = "on"
        elif text in IN and not self.relation:
            self.relation = "in" if thing_follows(self.items, place) else ""
        self.rank = ordinal(text) or (self.rank if text in LINKS else 0)
        if text in AXES:
            self.axis = AXES[text]
        elif text in SMALL:
            self.extent = "slightly"
            if self.offsets and self.offsets[-1].steps is None and not direction_follows(self.items, place):
                self.offsets[-1] = replace(self.offsets[-1], extent="slightly")
                self.extent = ""
        elif text in LARGE:
            self.extent = "far"
        elif text in ("my", "your"):
            self.owner = w.agent(text)
        elif w.is_strict(text):
            self.strict = True
        self.since.append(text)

    def _in_arrangement(self) -> bool:
        """Whether what was named last is an arrangement near or in which something goes."""
        last = self.clues[-1] if self.clues else None
        return last is not None and last.relation in ("near", "in") and last.nouns[-1].head == "container"

    # -- directions ------------------------------------------------------------------------------------------------

    def _direct(self, place: int, text: str, names: tuple[str, ...], following: list[str]) -> None:
        faced = face_follows(self.items, place)
        if OWN & set(self.since[-2:]) and (faced or self.face):
            self.face = (*self.face, *names)
            return
        if OWN & set(self.since[-2:]) and self.named_last() is not None:
            self.offsets.append(Offset(names, self.number, self.extent))
            self.since = ["of"]
            self._refer(self.named_last())
            return
        if self.number is not None and {"from"} & set(self.since[-2:]) and set(self.since[-2:]) <= {"from", "the"}:
            self._locate(Noun(head="place", directions=names, text=text))
            return
        if self._leads_to_place(place, text):
            self.flush()
            for item in self.items[place + 1 : place + 3]:
                if item.kind != "word" or not w.directions(item.text):
                    break
                names = (*names, *w.directions(item.text))
                self.passed += 1
            self.clues.append(Clue("place", (Noun(head="place", directions=names, agent=self.owner),),
                                   axis=self.extent))  # fmt: skip
            self.forget()
            return
        if (
            self.offsets
            and not self.offsets[-1].binding
            and self.since[:1] == ["to"]
            and reference_follows(self.items, place)
        ):
            self.flush()
        previous = self.offsets[-1] if self.offsets else None
        joined = previous is not None and previous.steps is None and not self.since and self.number is None
        if (
            joined
            and previous is not None
            and (not set(previous.names) & set(names) or len(names) + len(previous.names) == 3)
        ):
            self.offsets[-1] = replace(previous, names=(*previous.names, *names), binding=text in BINDING)
        else:
            steps = self.number
            shared = previous is not None and self.counted_first and set(self.since) <= {"and", "to", "the", "then"}
            if steps is None and shared and previous is not None and not set(previous.names) & set(names):
                steps = previous.steps
            self.counted_first = self.number is not None
            self.offsets.append(Offset(names, steps, self.extent, self.owner, text in BINDING))
        if self.relation in ("on", "in"):
            self.relation = ""
        self.number, self.extent, self.owner, self.since = None, "", None, []

    def _leads_to_place(self, place: int, text: str) -> bool:
        """Whether a side of the table is meant, not one of something: "to the top", "on the far right"."""
        if text in BINDING or self.number is not None or self.since[-1:] not in (["the"], ["far"], ["very"], ["way"]):
            return False
        if not ends_in_place(self.items, place):
            return False
        if self.clues and self.clues[-1].relation in ("near", "touch") and not self.offsets:
            return False
        before = [t for t in self.since if t != "the"]
        if set(before) & {"far", "way", "very"}:
            return True
        if text in SIDEWAYS:
            return before[-1:] in (["on"], ["at"], ["in"])
        return before[-1:] in (["on"], ["at"], ["in"], ["to"], ["near"])

    # -- references ------------------------------------------------------------------------------------------------

    def _refer(self, noun: Noun | None) -> None:
        """Something is named: what was said before relates to it."""
        if noun is None:
            return
        if (
            not noun.definite
            and noun.head == "block"
            and "square" in noun.text
            and not self.relation
            and not self.offsets
        ):
            self._shape(Item("shape", noun.text, noun=noun))
            return
        relation, binds = self.relation, self.binds()
        if self.waiting:
            self.clues.append(Clue("between", (*self.waiting, noun)))
            self.waiting = ()
        elif self.offsets and binds and relation in ("", "on", "in", "near", "touch"):
            strict = self.strict or relation == "touch" or bool(self.face)
            self.lead_from(noun, strict)
        elif self.offsets and binds and relation == "align":
            sideways = {"left", "right"} & {name for offset in self.offsets for name in offset.names}
            self.offsets = []
            self.clues.append(Clue("align", (noun,), axis="column" if sideways else "row"))
        elif self.face:
            self.flush()
            opposite = tuple(OPPOSITE.get(name, name) for name in self.face)
            self.clues.append(Clue("offset", (noun,), (Offset(opposite),), strict=True))
        elif relation == "between" and not noun.plural and not noun.conjoined and noun.head != "container":
            self.flush()
            self.waiting = (noun,)
        else:
            self.flush()
            relation = relation or self._bare(noun)
            if relation:
                self.clues.append(Clue(relation, (noun,), axis=self.axis, strict=self.strict))
        if relation == "on":
            self.tower = False
        self.forget()

    def _bare(self, noun: Noun) -> str:
        """What is meant where no relation is named."""
        if self.tower:
            return "on"
        if "from" in self.since[-2:]:
            return ""
        if self.since[-1:] == ["of"] and not self.clues:
            return ""
        if "with" in self.since[-2:]:
            return "near"
        if noun.head == "container" and "tower" in noun.kinds:
            return "on"
        return "in" if noun.head == "container" and {"row", "column"} & set(noun.kinds) else "near"

    def _point_back(self, item: Item) -> None:
        """Take "it" as what was named last, or as what is moved where it stands for itself."""
        related = bool(self.relation) or self.binds()
        if not related or self.since[-1:] in (["so"], ["that"], ["until"]):
            self.since.append(item.text)
            return
        self._refer(self.named_last() or Noun(head="pronoun", text=item.text))

    def _locate(self, noun: Noun | None) -> None:
        if noun is None:
            return
        bound = tuple(self.offsets) if self.binds() else ()
        if bound:
            self.offsets = []
        elif self.number is not None and "from" in self.since and noun.directions:
            bound = (Offset(tuple(OPPOSITE[name] for name in noun.directions), self.number),)
        self.flush()
        last = self.clues[-1] if self.clues else None
        if last is not None and last.relation == "place" and bound and last.nouns[0].text == noun.text:
            self.clues[-1] = replace(last, offsets=(*last.offsets, *bound))
        else:
            self.clues.append(Clue("place", (noun,), bound, axis=self.extent))
        self.forget()

    def _on_table(self) -> None:
        self.surface |= self.relation == "on"
        edge = bool(FACES & set(self.since)) and "to" in self.since
        if self.offsets and self.offsets[-1].steps is None and (self.binds() or edge):
            names = tuple(name for offset in self.offsets for name in offset.names if offset.steps is None)
            self.offsets = [offset for offset in self.offsets if offset.steps is not None]
            self.flush()
            self.clues.append(Clue("place", (Noun(head="place", directions=names),), axis=self.extent))
        self.flush()
        self.forget()

    def _shape(self, item: Item) -> None:
        noun = item.noun
        assert noun is not None
        if "tower" in noun.kinds:
            self.tower, self.relation = True, "on"
            self.height = stories(noun) or self.height
        else:
            self.flush()
            self.clues.append(Clue("make", (noun,)))
            self.forget()

"""From the pieces of a destination to clues, in one pass from left to right."""

from __future__ import annotations

from dataclasses import replace

from grounding.lexicon import whereto as g
from grounding.lexicon import words as w
from grounding.meaning.goal.ahead import direction_follows, side_follows, thing_follows, top_of_thing
from grounding.meaning.goal.clues import RELATION, Clue
from grounding.meaning.goal.directing import direct
from grounding.meaning.goal.items import Item
from grounding.meaning.goal.lengths import ordinal
from grounding.meaning.goal.memory import Memory
from grounding.meaning.goal.referring import form, locate, point_back, reach_table, refer
from grounding.meaning.goal.steering import BREAKS, EMPHASIZED, LINKS
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

    def hear(self, place: int, item: Item) -> None:
        """Take one piece in."""
        if self.passed:
            self.passed -= 1
            return
        match item.kind:
            case "stop":
                self.flush()
                self.since = []
            case "number":
                self._count(item.value, place)
            case "length":
                if self.number is None and self.since[-1:] in (["a"], ["an"]) and not self.measured():
                    self._count(1.0, place)
            case "counted":
                self._counted(item, place)
            case "thing":
                refer(self, item.noun)
            case "pronoun":
                point_back(self, item)
            case "place":
                locate(self, item.noun)
            case "table":
                reach_table(self, item.noun)
            case "shape" if item.noun is not None:
                form(self, item.noun)
            case _:
                self._word(place, item.text)

    def _counted(self, item: Item, place: int) -> None:
        """Take "two blocks" as a height, as things, or as a length."""
        binding = bool(self.offsets) and self.offsets[-1].binding and not self.since
        if any(g.is_tall(following.text) for following in self.items[place + 1 : place + 2]):
            self.height = int(item.value)
        elif self.relation or self.since[-1:] in (["of"], ["with"], ["to"]) or binding:
            refer(self, item.noun)
        else:
            self._count(item.value, place)

    def _count(self, value: float, place: int) -> None:
        """Give a number to the direction after it, or else to the one before it."""
        follows = direction_follows(self.items, place)
        open_before = bool(self.offsets) and self.offsets[-1].steps is None
        if open_before and (not self.since or not follows):
            everywhere = bool({"by", "each", "both"} & set(self.since))
            self.offsets = [
                replace(offset, steps=value)
                if offset.steps is None and (everywhere or offset is self.offsets[-1])
                else offset
                for offset in self.offsets
            ]
            self.since = []
        elif not self.offsets and not follows and not self.relation and "and" not in self.since and self._goes_open():
            last = self.clues[-1]
            self.clues[-1] = replace(last, offsets=(*last.offsets[:-1], replace(last.offsets[-1], steps=value)))
        else:
            self.number = value

    def _goes_open(self) -> bool:
        """Tells whether the last clue ends in a direction without a length."""
        return bool(self.clues and self.clues[-1].offsets) and self.clues[-1].offsets[-1].steps is None

    def _word(self, place: int, text: str) -> None:
        following = self.items[place + 1].text if self._plain(place + 1) else ""
        led = g.leads(text)
        names = w.directions(text) or (() if led is None else (led,))
        person = w.agent(text)
        if text == "right" and following in EMPHASIZED:
            self.strict = True
        elif text in ("top", "tops") and top_of_thing(self.items, place):
            self.relation = "on"
        elif names:
            self.passed = direct(self, self.items, place, names)
            return
        elif text in BREAKS:
            self.flush()
            self.since = []
            return
        elif self.relation in ("toward", "apart") and person in _PEOPLE:
            name = _PEOPLE[person or ROBOT]
            name, self.relation = name if self.relation == "toward" else w.OPPOSITE[name], ""
            self.passed = direct(self, self.items, place, (name,))
            return
        else:
            self._relate(place, text)
        self._mark(place, text)
        self.since.append(text)

    def _plain(self, place: int) -> bool:
        return place < len(self.items) and self.items[place].kind in ("word", "number", "length")

    def _relate(self, place: int, text: str) -> None:
        """Take in a word that sets what is named next in a relation."""
        following_from = self._plain(place + 1) and self.items[place + 1].text == "from"
        if w.is_middle(text) and not self.offsets and not self.since and self._in_arrangement():
            self.clues[-1] = replace(self.clues[-1], relation="between")  # "the circle's center"
        elif w.is_between(text) or w.is_middle(text):
            self.relation = "between"
        elif (related := w.related(text)) is not None:
            self.relation = RELATION + related
        elif w.is_apart([text]) and following_from and not self.offsets:
            self.relation = "apart"
        elif g.is_aligning(text):
            self.relation = "align"
        elif (w.is_touching(text) or g.is_linking(text)) and text != "against":
            self.relation = self.relation if self.tower else "touch"
        elif g.is_toward(text):
            self.relation = "toward"
        elif g.is_stacking(text):
            self._stack(text)
        elif (w.is_beside(text) and not self._counts(place)) or text == "against":
            self.relation = self.relation or "near"
        elif (w.is_on(text) and not side_follows(self.items, place)) or self._covers(text, place):
            self.relation = "on"
        elif g.is_inside(text) and not self.relation:
            self.relation = "in" if thing_follows(self.items, place) else ""

    def _counts(self, place: int) -> bool:
        """Tells whether a number follows: "by 5 cm" tells how far."""
        return place + 1 < len(self.items) and self.items[place + 1].kind == "number"

    def _covers(self, text: str, place: int) -> bool:
        """Tells whether a word puts something over a thing, not over to a side."""
        return w.is_over(text) and not self.offsets and thing_follows(self.items, place)

    def _stack(self, text: str) -> None:
        if g.is_story(text) and (self.number or self.rank):
            self.height, self.number = int(self.number or self.rank), None
        self.relation, self.tower = "on", True

    def _mark(self, place: int, text: str) -> None:
        """Note ranks, axes, how far and how exactly."""
        self.rank = ordinal(text) or (self.rank if text in LINKS else 0)
        axis, extent = g.axis(text), g.extent(text)
        if axis is not None:
            self.axis = axis
        elif extent is not None:
            self.extent = extent
            open_before = bool(self.offsets) and self.offsets[-1].steps is None
            if extent == "slightly" and open_before and not direction_follows(self.items, place):
                self.offsets[-1] = replace(self.offsets[-1], extent="slightly")
                self.extent = ""
        elif text in ("my", "your"):
            self.owner = w.agent(text)
        elif w.is_strict(text):
            self.strict = True

    def _in_arrangement(self) -> bool:
        """Tells whether what was named last is an arrangement near or in which something goes."""
        last = self.clues[-1] if self.clues else None
        return last is not None and last.relation in ("near", "in") and last.nouns[-1].head == "container"

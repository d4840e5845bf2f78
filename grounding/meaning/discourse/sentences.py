"""What a clause with a verb tells: commands, statements, what is looked at, and what is said of "it" afterwards.

A sentence is heard by readings in their order. Each says whether it is of its kind, and if so, what it tells.
"""

from __future__ import annotations

from collections.abc import Callable

from grounding.language.tree import Phrase, Word
from grounding.meaning.discourse.giving import gained, given
from grounding.meaning.discourse.hearing import Sentence, hear
from grounding.meaning.discourse.sharing import shared_out
from grounding.meaning.discourse.told import Told, add, deny, is_informative, mention, state, take, with_further
from grounding.meaning.discourse.verbs import (
    BEING,
    FORMING,
    GAINING,
    HANDLING,
    JOINING,
    LOSING,
    MOVED,
    ORDERING,
    is_verbal,
)
from grounding.meaning.goal.lengths import peeled
from grounding.meaning.nouns import Noun, read_noun
from grounding.meaning.reader import Reader

_BODY = frozenset("hand hands arm arms gripper fingers claw".split())
_NAMING = frozenset("the that this these those its both".split())
_HAVING = frozenset("has have contains holds".split())
_ARRIVING = frozenset("joins touches meets hugs forms creates makes fills completes".split())
_NOW = frozenset(("now",))
_MOVING = frozenset(HANDLING["place"])
_NOT = frozenset(("not", "n't"))


def read_sentence(clause: Phrase, reader: Reader, told: Told) -> None:
    """Hear what a clause tells."""
    sentence = hear(clause, reader, told)
    parts = sentence.parts
    if not any(is_verbal(text) for text in sentence.verbs) and told.target is not None and not parts.subjects:
        add(clause, reader, told)
        return
    for reading in _READINGS:
        if reading(sentence, reader, told):
            return
    _only_names(sentence, reader, told)


def _moves_the_hand(sentence: Sentence, reader: Reader, told: Told) -> bool:
    """For example "move your arm": nothing is told of objects."""
    nouns = sentence.nouns
    return bool(nouns) and nouns[0].head in ("other", "place", "agent") and bool(_BODY & set(nouns[0].text.split()))


def _tells_result(sentence: Sentence, reader: Reader, told: Told) -> bool:
    """For example "three blocks will then be stacked", after it was said what goes where."""
    if told.target is None or told.kind != "place" or not (told.destination and sentence.named):
        return False
    if _is_same_thing(sentence.named[0]) or (sentence.subjects and sentence.subjects[0].head == "block"
                                             and not sentence.subjects[0].plural):  # fmt: skip
        return False
    return sentence.has(ORDERING) or (sentence.has(_NOW) and not sentence.has(_MOVING))


def _gives_or_gets(sentence: Sentence, reader: Reader, told: Told) -> bool:
    """For example "the tower loses its top block"."""
    giver = given(sentence.verbs, sentence.parts, sentence.named, sentence.nouns)
    if giver is None:
        return False
    owner = sentence.parts.named[:1]
    its_own = any(phrase in owner for modifier in giver.modifiers for phrase in modifier.phrases)
    take(giver, reader, told, None if its_own or not owner else reader.refer(sentence.named[0]))
    where = gained(sentence.verbs, sentence.parts)
    told.kind = "place" if where or not sentence.has(LOSING) else "pick"
    told.destination += where
    return True


def _receives(sentence: Sentence, reader: Reader, told: Told) -> bool:
    """For example "the tower takes a block just above it": where something new is to be, whatever it is."""
    if not (sentence.subjects and sentence.nouns and sentence.has(GAINING)):
        return False
    subject, new = sentence.subjects[0], sentence.nouns[0]
    if subject.head == "pronoun" or new.head != "block" or new.definite:
        return False
    told.kind = "place"
    told.mentioned, told.plural = reader.refer(subject), False
    told.destination += gained(sentence.verbs, sentence.parts)
    return True


def _looks_at_subject(sentence: Sentence, reader: Reader, told: Told) -> bool:
    """For example "a red block is there"."""
    named = [noun for noun in sentence.subjects if noun.head != "pronoun" and is_informative(noun)]
    if not (sentence.looking and named and all(noun.head == "pronoun" for noun in sentence.nouns)):
        return False
    mention(with_further(named[0], *sentence.parts.before), reader, told)
    return True


def _looks_for(sentence: Sentence, reader: Reader, told: Told) -> bool:
    """For example "look for the tower"."""
    if not sentence.looking or sentence.nouns:
        return False
    rest = sentence.parts.rest
    sought = [child for part in rest for child in part.phrases if child.tag == "NP"]
    if not (sought and rest[0].words and rest[0].words[-1].text in ("for", "at", "to")):
        return False
    mention(read_noun(sought[0]), reader, told)
    return True


def _looks_at_object(sentence: Sentence, reader: Reader, told: Told) -> bool:
    """For example "there is a tower on the left"."""
    nouns, parts = sentence.nouns, sentence.parts
    if not (sentence.looking and nouns) or (sentence.kind and not sentence.subjects and len(nouns) > 1):
        return False
    mention(with_further(nouns[0], *parts.before, *parts.rest), reader, told)
    return True


def _lists(sentence: Sentence, reader: Reader, told: Told) -> bool:
    """For example "that corner holds two cubes", "the row has a red block at its left end": they are spoken of."""
    if not (sentence.has(_HAVING) and sentence.named and sentence.nouns) or told.target is not None:
        return False
    whole, new = sentence.named[0], sentence.nouns[0]
    if whole.head not in ("container", "place") or new.head != "block":
        return False
    if not new.plural and (new.definite or whole.head != "container"):
        return False
    if whole.head == "container":
        mention(whole, reader, told)  # what is "its" within the clause
        new = with_further(new, *sentence.parts.rest)
    where = Phrase("PP", (Word("in" if whole.head == "container" else "at", "IN", 0), sentence.parts.named[0]))
    mention(with_further(new, where), reader, told)
    return True


def _touches_with(sentence: Sentence, reader: Reader, told: Told) -> bool:
    """For example "the red block has its left side touch the tower"."""
    if not (sentence.has(_HAVING) and sentence.fresh and sentence.nouns) or told.target is not None:
        return False
    part = sentence.nouns[0]
    if part.head != "place" or part.text.split(" ", 1)[0] != "its":
        return False
    _move_subject(sentence, reader, told)
    return True


def _arrives(sentence: Sentence, reader: Reader, told: Told) -> bool:
    """For example "and joins the tower", of what was said to move."""
    if told.target is None or told.kind != "place" or not told.destination or sentence.subjects:
        return False
    if not sentence.nouns or sentence.nouns[0].head == "pronoun" or not sentence.has(_ARRIVING):
        return False
    told.destination += [sentence.parts.said, *sentence.parts.objects, *sentence.parts.rest]
    return True


def _says_where_it_goes(sentence: Sentence, reader: Reader, told: Told) -> bool:
    """For example "it should be left of X", "its left side touches X"."""
    if told.kind != "place" or told.target is None or not told.destination:
        return False
    if not (sentence.named and _is_same_thing(sentence.named[0])):
        return False
    parts = sentence.parts
    told.destination += [*parts.owned, parts.said, *parts.objects, *parts.rest]
    return True


def _orders(sentence: Sentence, reader: Reader, told: Told) -> bool:
    """For example "the red block should be on the tower", "the red block is moved to the left"."""
    if told.target is not None or not (sentence.fresh or (sentence.subjects and reader.context.handled)):
        return False
    if not (sentence.has(ORDERING) or (sentence.has(BEING) and sentence.has(MOVED))):
        return False
    _move_subject(sentence, reader, told)
    return True


def _denies(sentence: Sentence, reader: Reader, told: Told) -> bool:
    """For example "it is not the red one"."""
    if not (sentence.subjects and sentence.has(BEING) and sentence.has(_NOT)):
        return False
    deny(sentence.subjects[0], sentence.nouns, sentence.parts.rest, reader, told)
    return True


def _states(sentence: Sentence, reader: Reader, told: Told) -> bool:
    """For example "it is the red one"."""
    if not (sentence.subjects and sentence.has(BEING)):
        return False
    state(sentence.subjects[0], sentence.nouns, sentence.parts.rest, reader, told)
    return True


def _moves_by_itself(sentence: Sentence, reader: Reader, told: Told) -> bool:
    """For example "the red block moves to the left"; what it moves, if anything, is no certain block."""
    nouns = sentence.nouns
    if sentence.kind != "place" or not sentence.subjects:
        return False
    verb = next((text for text in sentence.verbs if text in HANDLING["place"]), "")
    joins = sentence.subjects[0].head == "block" and verb in JOINING
    if nouns and nouns[0].head == "block" and nouns[0].text.split(" ", 1)[0] in _NAMING and not joins:
        return False
    _move_subject(sentence, reader, told)
    return True


def _move_subject(sentence: Sentence, reader: Reader, told: Told) -> None:
    parts = sentence.parts
    take(with_further(sentence.subjects[0], *parts.before), reader, told)
    told.kind = "place"
    told.destination += [parts.said, *parts.objects, *parts.rest]


def _take_topic(sentence: Sentence, reader: Reader, told: Told) -> None:
    """A command may say first of which set it chooses: "the row nearest you, take its middle block"."""
    first = next((word for word in sentence.parts.words if is_verbal(word.text)), None)
    sets = bool(sentence.subjects) and (sentence.subjects[0].head == "container" or sentence.subjects[0].plural)
    if sets and first is not None and first.tag == "VB" and told.target is None:
        mention(sentence.subjects[0], reader, told)


def _picks(sentence: Sentence, reader: Reader, told: Told) -> bool:
    """For example "pick up the red block on the left", "remove the tower"."""
    if sentence.kind not in ("pick", "clear") or not sentence.nouns:
        return False
    parts = sentence.parts
    _take_topic(sentence, reader, told)
    told.kind = sentence.kind
    take(with_further(sentence.nouns[0], *parts.before, *parts.rest), reader, told)
    for further in parts.objects[1:]:
        add(further, reader, told)
    return True


def _places(sentence: Sentence, reader: Reader, told: Told) -> bool:
    """For example "put the block on the left onto the tower"."""
    if sentence.kind != "place" or not sentence.nouns:
        return False
    parts = sentence.parts
    _take_topic(sentence, reader, told)
    told.kind = sentence.kind
    noun, rest = shared_out(with_further(sentence.nouns[0], *parts.before), list(parts.rest), told)
    noun, courses = peeled(noun)
    take(noun, reader, told)
    told.destination += [parts.said, *courses, *parts.objects[1:], *rest]
    return True


def _goes_on(sentence: Sentence, reader: Reader, told: Told) -> bool:
    """For example "and move to the left": of what was named before."""
    if sentence.kind != "place" or sentence.subjects or told.target is None:
        return False
    told.kind = sentence.kind
    told.destination += [sentence.parts.said, *sentence.parts.rest]
    return True


def _joins_further(sentence: Sentence, reader: Reader, told: Told) -> bool:
    """For example "and becomes the top of the tower": what was named before comes to be its object, or beside it."""
    if sentence.kind != "place" or sentence.subjects or told.target is None or not sentence.has(JOINING | FORMING):
        return False
    told.kind = sentence.kind
    told.destination += [sentence.parts.said, *sentence.parts.objects, *sentence.parts.rest]
    return True


def _only_names(sentence: Sentence, reader: Reader, told: Told) -> None:
    """What no other reading is of: it names something, or says more of what was named."""
    parts = sentence.parts
    for nouns in (sentence.nouns, sentence.subjects):
        if nouns:
            following = told.destination or sentence.has(BEING)
            if told.target is not None and following and nouns[0].head == "container":
                told.doubt += 1  # "... what used to be a tower", "... and is now a tower"
                return
            take(with_further(nouns[0], *parts.before, *parts.rest), reader, told)
            return
    for part in parts.rest:
        add(part, reader, told)


_READINGS: tuple[Callable[[Sentence, Reader, Told], bool], ...] = (
    _moves_the_hand,
    _tells_result,
    _gives_or_gets,
    _receives,
    _looks_at_subject,
    _looks_for,
    _looks_at_object,
    _lists,
    _touches_with,
    _arrives,
    _says_where_it_goes,
    _orders,
    _denies,
    _states,
    _moves_by_itself,
    _joins_further,
    _picks,
    _places,
    _goes_on,
)


def _is_same_thing(noun: Noun) -> bool:
    """Whether a subject is what was just spoken of, or a side of it: "it", "its left side"."""
    texts = noun.text.split()
    return (noun.head == "pronoun" and not noun.modifiers) or (noun.head == "place" and texts[:1] == ["its"])

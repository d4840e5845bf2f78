"""Meanings as text: one line for every condition, to be read by people and read back.

    goal pick x1
    x1 is objects said "the red block left of the row of five"
    x1 colour red
    x1 toward left of x2 said "left"
    x2 is sets row number 5 said "the row of five"

Every referent has a name, the target `x1`, the others in the order in which they are spoken of; one that is spoken of
twice has one name. A referent has a line that tells its sort, followed by a line for each of its conditions. The lines:

    text        = [ goal ] { "mentioned" NAME } { "destination" QUOTED } { referent }
    goal        = "goal" KIND [ NAME ]                                     what is to be done, and with what
    referent    = sort { condition }
    sort        = NAME "is" SORT terms                                     the WORDs are kinds of arrangement
                  [ "person" ] [ PERSON ] [ "number" INT ] { FLAG } [ "indefinite" ] [ "parts" names ]
                  [ "said" QUOTED ]
    condition   = NAME [ "not" ] CONCEPT terms
                  [ [ PREPOSITION ] names ] [ "amount" NUMBER ] [ "ways" way { "and" way } ] [ "rank" INT ] { ADVERB }
                  [ "seen" "by" PERSON ] [ "said" QUOTED ]
    terms       = { WORD } [ "place" place ]
                | [ place ] [ "words" { WORD } ]                           of the sort place, and at, extreme and part
    place       = "anywhere" | { WORD } [ "middle" ] [ SHAPE ] [ "of" "the" "table" ] [ "of" PERSON ]
    way         = { WORD } NUMBER
    names       = NAME { "and" NAME }

A PREPOSITION is "of" or what suits the concept: nearest to, farthest from, same as, other than, apart from,
surrounded by; between, beside, touching, on and outside have none. A PERSON is robot or speaker; "person" stands
before it where the sort is another one. A FLAG is plural, all, only, alike or crossing, an ADVERB strictly, nearly or
counted. The SHAPE of a place is its noun (side, edge, quadrant, corner), or where only directions were named nothing,
"together" (a point between them), "outermost" or "cornermost". A WORD that the notation itself uses is put in quotes.
`write` and `parse_meaning` are inverse to each other.
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import NamedTuple

from grounding.meaning.discourse.told import Told
from grounding.meaning.notation_parser import Meaning, parse_meaning
from grounding.meaning.notation_terms import (
    FLAGS,
    PLACED,
    PREPOSITIONS,
    REFERENT_FLAGS,
    amount,
    place_of,
    quoted,
    somebody,
    word,
)
from grounding.meaning.referents import PERSON, PLACE, Condition, Referent, Region

__all__ = ["Line", "Meaning", "lines", "named", "parse_meaning", "write", "write_referent"]


class Line(NamedTuple):
    """A line that tells of a referent.

    Attributes:
        name: of the referent.
        referent: of which it tells.
        condition: that it says of it; None for its sort.
        text: of the line.
    """

    name: str
    referent: Referent
    condition: Condition | None
    text: str


def write(told: Told | Meaning) -> str:
    """What a text has told, as lines."""
    meaning = told if isinstance(told, Meaning) else meaning_of(told)
    target, mentioned = meaning.target, meaning.mentioned
    names = named(*(referent for referent in (target, mentioned) if referent is not None))
    found = [f"goal {meaning.kind}" + ("" if target is None else f" {names[target]}")]
    found += [] if mentioned is None else [f"mentioned {names[mentioned]}"]
    found += [f"destination {quoted(text)}" for text in meaning.destination]
    return "\n".join([*found, *(line.text for line in _lines(names))])


def meaning_of(told: Told) -> Meaning:
    """The meaning of what was told: what is only mentioned is left out where it is the target."""
    mentioned = None if told.mentioned is told.target else told.mentioned
    return Meaning(told.kind, told.target, mentioned, tuple(phrase.text for phrase in told.destination))


def write_referent(referent: Referent) -> str:
    """A referent and all to which it relates, as lines."""
    return "\n".join(line.text for line in lines(referent))


def lines(*referents: Referent) -> tuple[Line, ...]:
    """The lines that tell of referents and of all to which they relate."""
    return tuple(_lines(named(*referents)))


def named(*referents: Referent) -> dict[Referent, str]:
    """Names for referents and all to which they relate, in the order in which they are spoken of."""
    names: dict[Referent, str] = {}
    for referent in referents:
        _name(referent, names)
    return names


def _name(referent: Referent, names: dict[Referent, str]) -> None:
    if referent in names:
        return
    names[referent] = f"x{len(names) + 1}"
    for inner in (*referent.parts, *(r for condition in referent.conditions for r in condition.of)):
        _name(inner, names)


def _lines(names: dict[Referent, str]) -> Iterator[Line]:
    for referent, name in names.items():
        yield Line(name, referent, None, f"{name} {_sort(referent, names)}")
        for condition in referent.conditions:
            yield Line(name, referent, condition, f"{name} {_condition(condition, names)}")


def _sort(referent: Referent, names: dict[Referent, str]) -> str:
    parts = ["is", referent.sort, *_kinds(referent)]
    if referent.person is not None:
        parts += [*(["person"] if referent.sort != PERSON else []), somebody(referent.person)]
    parts += [] if referent.number is None else [f"number {referent.number}"]
    parts += [said for field, said in REFERENT_FLAGS.items() if getattr(referent, field)]
    parts += [] if referent.definite else ["indefinite"]
    parts += [f"parts {_names(referent.parts, names)}"] if referent.parts else []
    parts += [f"said {quoted(referent.text)}"] if referent.text else []
    return " ".join(parts)


def _condition(condition: Condition, names: dict[Referent, str]) -> str:
    parts = ["not"] if condition.negated else []
    parts.append(condition.concept)
    parts += _terms(condition.words, condition.region, placed=condition.concept in PLACED)
    if condition.of:
        parts.append(f"{PREPOSITIONS.get(condition.concept, 'of')} {_names(condition.of, names)}".lstrip())
    if condition.number is not None:
        parts.append(f"amount {amount(condition.number)}")
    if condition.ways:
        ways = (f"{' '.join(map(word, directions))} {amount(steps)}" for directions, steps in condition.ways)
        parts.append(f"ways {' and '.join(ways)}")
    parts += [] if condition.rank is None else [f"rank {condition.rank}"]
    parts += [said for field, said in FLAGS.items() if getattr(condition, field)]
    parts += [] if condition.owner is None else [f"seen by {somebody(condition.owner)}"]
    parts += [f"said {quoted(condition.said)}"] if condition.said else []
    return " ".join(parts)


def _kinds(referent: Referent) -> list[str]:
    """The kinds and the place of a referent; those of a person, which has none, each with a keyword."""
    found = _terms(referent.kinds, referent.region, placed=referent.sort == PLACE)
    return ["words", *found] if referent.sort == PERSON and referent.kinds else found


def _terms(words: tuple[str, ...], region: Region | None, *, placed: bool) -> list[str]:
    """Words and a place, with a keyword before the one that is not expected there."""
    said = list(map(word, words))
    if region is None:
        return ["words", *said] if placed and said else said
    if placed:
        return [place_of(region), *(["words", *said] if said else [])]
    return [*said, f"place {place_of(region)}"]


def _names(referents: tuple[Referent, ...], names: dict[Referent, str]) -> str:
    return " and ".join(names[referent] for referent in referents)

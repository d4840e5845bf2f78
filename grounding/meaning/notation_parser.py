"""Meanings read back from text; the grammar stands in `grounding.meaning.notation`."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import Any, NamedTuple

from grounding.meaning.notation_terms import (
    CONCEPTS,
    FLAGS,
    NAME,
    PLACED,
    PREPOSITIONS,
    REFERENT_FLAGS,
    SORTS,
)
from grounding.meaning.notation_words import Words
from grounding.meaning.referents import PERSON, PLACE, Condition, Referent

KINDS = ("pick", "place", "clear")


class Meaning(NamedTuple):
    """What a text asks for.

    Attributes:
        kind: of action.
        target: what shall be handled, or None.
        mentioned: what is spoken of besides, or None.
        destination: the words of the phrases that tell where to.
    """

    kind: str = "pick"
    target: Referent | None = None
    mentioned: Referent | None = None
    destination: tuple[str, ...] = ()


def parse_meaning(text: str) -> Meaning:
    """Read a meaning back from its lines; without a line for the goal its first referent is to be picked.

    Raises:
        MeaningError: a line is none of the notation, or a name is missing, told twice, or in a circle.
    """
    parser = _Parser()
    for number, line in enumerate(text.split("\n"), start=1):
        if line.strip():
            parser.line(Words(number, line))
    return parser.meaning()


@dataclass
class _Spec:
    """What the lines tell of a referent, with the names of those to which it relates."""

    words: Words
    fields: dict[str, Any]
    parts: list[str] = field(default_factory=list)
    conditions: list[tuple[dict[str, Any], list[str]]] = field(default_factory=list)


class _Parser:
    def __init__(self) -> None:
        self.specs: dict[str, _Spec] = {}
        self.kind = KINDS[0]
        self.target: str | None = None
        self.mentioned: str | None = None
        self.destination: list[str] = []
        self.heads: dict[str, Words] = {}
        self.built: dict[str, Referent | None] = {}

    def line(self, words: Words) -> None:
        first = words.next
        if first in ("goal", "mentioned"):
            words.take("")
            if first in self.heads:
                words.fail("tells it twice", f"one line that begins with {first!r}")
            self.heads[first] = words
            self._head(first, words)
        elif words.ask("destination"):
            self.destination.append(words.quoted())
        elif NAME.fullmatch(first):
            self._tell(words)
        else:
            words.fail(f"begins with {first!r}", "goal, mentioned, destination or a name like x1")
        if words.left:
            words.fail(f"goes on with {words.next!r}", "the end of the line, or the fields in their order")

    def _head(self, first: str, words: Words) -> None:
        if first == "mentioned":
            self.mentioned = words.name()
            return
        self.kind = words.take(f"a kind of action: {', '.join(KINDS)}")
        if self.kind not in KINDS:
            words.fail(f"asks for {self.kind!r}", f"a kind of action: {', '.join(KINDS)}")
        self.target = words.name() if words.left else None

    def _tell(self, words: Words) -> None:
        name = words.name()
        if words.ask("is"):
            if name in self.specs:
                words.fail(f"tells again what {name} is", "one such line for every name")
            spec = self.specs[name] = _Spec(words, {})
            _sort(words, spec)
            return
        if name not in self.specs:
            words.fail(f"says something of {name} before it is told what that is", f"{name} is objects, before it")
        self.specs[name].conditions.append(_condition(words))

    def meaning(self) -> Meaning:
        if not self.heads and self.specs:
            self.target = next(iter(self.specs))
        target = None if self.target is None else self._built(self.target, self.heads.get("goal"))
        mentioned = None if self.mentioned is None else self._built(self.mentioned, self.heads["mentioned"])
        for name, spec in self.specs.items():
            if name not in self.built:
                spec.words.fail(f"tells of {name}, which nothing relates to", "a line that names it, or no such line")
        return Meaning(self.kind, target, mentioned, tuple(self.destination))

    def _built(self, name: str, words: Words | None) -> Referent:
        spec = self.specs.get(name)
        if spec is None:
            assert words is not None
            words.fail(f"names {name}, of which nothing is told", f"a line {name} is ...")
        if name in self.built:
            known = self.built[name]
            if known is None:
                spec.words.fail(f"tells of {name}, which relates to itself", "referents without a circle")
            return known
        self.built[name] = None
        parts = tuple(self._built(part, spec.words) for part in spec.parts)
        conditions = tuple(
            Condition(of=tuple(self._built(other, spec.words) for other in names), **fields)
            for fields, names in spec.conditions
        )
        found = Referent(conditions=conditions, parts=parts, **spec.fields)
        self.built[name] = found
        return found


def _sort(words: Words, spec: _Spec) -> None:
    """Read what a referent is."""
    fields = spec.fields
    fields["sort"] = words.take(f"a sort: {', '.join(SORTS)}")
    if fields["sort"] not in SORTS:
        words.fail(f"has the sort {fields['sort']!r}", f"one of {', '.join(SORTS)}")
    if fields["sort"] == PLACE and words.is_place():
        fields["region"] = words.place()
    elif fields["sort"] not in (PLACE, PERSON):
        fields["kinds"] = words.words()
    if words.ask("words"):
        fields["kinds"] = words.words()
    if words.ask("place"):
        fields["region"] = words.place()
    if words.ask("person") or (fields["sort"] == PERSON and words.is_person()):
        fields["person"] = words.word()
    if words.ask("number"):
        fields["number"] = int(words.number_of(whole=True))
    for name, said in REFERENT_FLAGS.items():
        fields[name] = words.ask(said)
    fields["definite"] = not words.ask("indefinite")
    if words.ask("parts"):
        spec.parts = words.names()
    if words.ask("said"):
        fields["text"] = words.quoted()


def _condition(words: Words) -> tuple[dict[str, Any], list[str]]:
    """Read a condition: its fields, and the names of those to which it relates."""
    fields: dict[str, Any] = {"negated": words.ask("not")}
    concept = fields["concept"] = words.take("a concept")
    if concept not in CONCEPTS:
        words.fail(f"has the concept {concept!r}", f"one of {', '.join(sorted(CONCEPTS))}")
    if concept not in PLACED:
        fields["words"] = words.words()
    elif words.is_place():
        fields["region"] = words.place()
    if words.ask("words"):
        fields["words"] = words.words()
    if words.ask("place"):
        fields["region"] = words.place()
    names = words.names() if words.leads(PREPOSITIONS.get(concept, "of")) else []
    if words.ask("amount"):
        fields["number"] = words.number_of(whole=False)
    if words.ask("ways"):
        fields["ways"] = _ways(words)
    if words.ask("rank"):
        fields["rank"] = int(words.number_of(whole=True))
    for name, said in FLAGS.items():
        fields[name] = words.ask(said)
    if words.ask("seen", "by"):
        fields["owner"] = words.word()
    if words.ask("said"):
        fields["said"] = words.quoted()
    return fields, names


def _ways(words: Words) -> tuple[tuple[tuple[str, ...], float], ...]:
    found = [(words.words(), words.number_of(whole=False))]
    while words.ask("and"):
        found.append((words.words(), words.number_of(whole=False)))
    return tuple(found)

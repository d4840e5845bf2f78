"""Forms: names of facts and roles with blanks in them, and what they mean in words.

`nth[<ref>|<who>|<rank>]` is the form of `nth[mod.in|head|first]`. A blank stands for the values that its `Blank`
accepts; the meaning of a form may mention its blanks, and is then filled with what the values mean.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass, field
from functools import cached_property
from typing import NamedTuple

_BLANK = re.compile(r"<([a-z]+)(\d?)>")


class Blank(NamedTuple):
    """What may stand in a place.

    Attributes:
        pattern: regular expression of its values, without groups.
        say: a value in words; None if it is none of the values after all.
    """

    pattern: str
    say: Callable[[str], str | None]


@dataclass(frozen=True)
class Form:
    """A form of facts or roles.

    Attributes:
        template: the name with blanks, e.g. "word=<word>"; the same blank again is written <word2>.
        meaning: in words, with blanks that are filled with what the values mean.
        example: a name of this form.
        families: the factors in which it means this; empty for all.
    """

    template: str
    meaning: str
    example: str
    families: tuple[str, ...] = ()
    blanks: Mapping[str, Blank] = field(default_factory=dict, repr=False, compare=False)

    @cached_property
    def _pattern(self) -> re.Pattern[str]:
        parts, end = [], 0
        for match in _BLANK.finditer(self.template):
            parts.append(re.escape(self.template[end : match.start()]))
            parts.append(f"(?P<{match[1]}{match[2]}>{self.blanks[match[1]].pattern})")
            end = match.end()
        return re.compile("".join(parts) + re.escape(self.template[end:]))

    def explain(self, name: str) -> str | None:
        """What a name means; None if it is not of this form."""
        match = self._pattern.fullmatch(name)
        if match is None:
            return None
        said: dict[str, str] = {}
        for blank, value in match.groupdict().items():
            words = self.blanks[blank.rstrip("0123456789")].say(value)
            if words is None:
                return None
            said[blank] = words
        return _BLANK.sub(lambda place: said[place[1] + place[2]], self.meaning)


class Explained(NamedTuple):
    """A name that is explained.

    Attributes:
        form: whose form it has.
        meaning: what it means, in words.
    """

    form: Form
    meaning: str


def first_of(forms: Iterable[Form], name: str, family: str | None = None) -> Explained | None:
    """The first form that a name has.

    Args:
        forms: in the order in which they are tried.
        name: of a fact or a role.
        family: of the factor that it belongs to; None for any.
    """
    for form in forms:
        if family is None or not form.families or family in form.families:
            meaning = form.explain(name)
            if meaning is not None:
                return Explained(form, meaning)
    return None


def one_of(words: Mapping[str, str]) -> Blank:
    """A blank for listed values, each with its words."""
    longest_first = sorted(words, key=len, reverse=True)
    return Blank("|".join(map(re.escape, longest_first)), words.get)


def as_is(pattern: str) -> Blank:
    """A blank for values that are quoted as they are."""
    return Blank(pattern, lambda value: f'"{value}"')


def plain(values: Iterable[str]) -> Blank:
    """A blank for listed values that speak for themselves."""
    return one_of({value: value for value in values})


def nested(*registers: Sequence[Form]) -> Blank:
    """A blank for names that have a form of their own."""

    def say(value: str) -> str | None:
        found = first_of((form for register in registers for form in register), value)
        return found and found.meaning

    return Blank(".+", say)

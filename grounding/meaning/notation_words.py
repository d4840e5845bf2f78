"""The words of one line of a written meaning, taken one by one."""

from __future__ import annotations

import json
from typing import NoReturn

from grounding.errors import MeaningError
from grounding.meaning.notation_terms import KEYWORDS, NAME, PEOPLE, region_of, shapes, split
from grounding.meaning.referents import Region


class Words:
    """The words of a line, taken one by one."""

    def __init__(self, number: int, line: str) -> None:
        self.number, self.text = number, line.strip()
        try:
            self.left = split(line)
        except ValueError as error:
            raise MeaningError(number, self.text, f"has an open quote at {error}", 'a text between two "') from None

    def fail(self, problem: str, right: str) -> NoReturn:
        """Refuse the line."""
        raise MeaningError(self.number, self.text, problem, right)

    @property
    def next(self) -> str:
        """The word that comes next; "" at the end."""
        return self.left[0] if self.left else ""

    def take(self, right: str) -> str:
        """The next word, taken; `right` is what should stand there."""
        if not self.left:
            self.fail("ends too early", right)
        return self.left.pop(0)

    def ask(self, *wanted: str) -> bool:
        """Take words where they come next."""
        if tuple(self.left[: len(wanted)]) != wanted:
            return False
        del self.left[: len(wanted)]
        return True

    def leads(self, preposition: str) -> bool:
        """Take a preposition where it comes next; without one, whether a name does."""
        return self.ask(preposition) if preposition else bool(NAME.fullmatch(self.next))

    def name(self) -> str:
        """The name of a referent."""
        found = self.take("the name of a referent, x1")
        if not NAME.fullmatch(found):
            self.fail(f"has {found!r} where a referent is named", "a name, x1 or x2 and so on")
        return found

    def names(self) -> list[str]:
        """Names with "and" between them."""
        found = [self.name()]
        while self.ask("and"):
            found.append(self.name())
        return found

    def is_word(self) -> bool:
        """Whether a word of the meaning comes next, and none of the notation."""
        text = self.next
        return bool(text) and not (text in KEYWORDS or NAME.fullmatch(text) or is_number(text))

    def is_person(self) -> bool:
        """Whether a person comes next."""
        return self.next in PEOPLE or self.next.startswith('"')

    def words(self) -> tuple[str, ...]:
        """Words up to the next one of the notation."""
        found = []
        while self.is_word():
            found.append(self.word())
        return tuple(found)

    def word(self) -> str:
        """A word, in quotes or not."""
        text = self.take("a word")
        return self.unquoted(text) if text.startswith('"') else text

    def unquoted(self, text: str) -> str:
        """A text without its quotes."""
        try:
            return str(json.loads(text))
        except ValueError:
            self.fail(f"has {text} where a text is", 'a text between two "')

    def quoted(self) -> str:
        """A text in quotes."""
        text = self.take('a text between two "')
        if not text.startswith('"'):
            self.fail(f"has {text!r} where a text is", 'a text between two "')
        return self.unquoted(text)

    def number_of(self, *, whole: bool) -> float:
        """A number."""
        text = self.take("a number")
        if not is_number(text) or (whole and float(text) != int(float(text))):
            self.fail(f"has {text!r} where a number is", "a whole number" if whole else "a number")
        return float(text)

    def place(self) -> Region:
        """A place: directions, "middle", its shape, whose it is."""
        self.ask("anywhere")
        names = self.words()
        middle = self.ask("middle")
        shape = self.take("a shape") if self.next in shapes() else None
        table = self.ask("of", "the", "table")
        owner = self.left[1] if self.next == "of" and self.left[1:2] and self.left[1] in PEOPLE else None
        if owner is not None:
            del self.left[:2]
        return region_of(names, shape, middle=middle, table=table, owner=owner)

    def is_place(self) -> bool:
        """Whether a place follows."""
        return self.next in {"anywhere", "middle", *shapes()} or self.is_word()


def is_number(text: str) -> bool:
    """Whether a word is a number."""
    try:
        return text[:1] in "-0123456789" and abs(float(text)) < float("inf")
    except ValueError:
        return False

"""The exceptions of this package. Every message names what was wrong, where, and what would be right."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from grounding.corpus.format import Corpus


class GroundingError(Exception):
    """Root of everything that `grounding` raises on purpose."""


class WorldError(GroundingError):
    """A world or a world file that cannot be used; names the object and the key."""


class SymbolError(GroundingError):
    """A symbol that cannot be built or read."""


class TreeError(GroundingError):
    """A bracketed parse tree that cannot be read."""


class LanguageError(GroundingError):
    """A text that cannot be split into words at all, or a grammar that cannot be used."""


class LexiconError(GroundingError):
    """A table of words or of parameters that is refused; names the file and the entry."""


class CorpusError(GroundingError):
    """A corpus file that is refused; names the file and the element."""


class HandsError(CorpusError):
    """A line of a corpus of texts that is refused.

    Attributes:
        file: its name.
        line: number of the line, from 1.
        key: that is wrong, with a dot before a key within `gold`; None where the line is no JSON.
        right: what would be right.
    """

    def __init__(self, file: str, line: int, key: str | None, problem: str, right: str) -> None:
        self.file, self.line, self.key, self.right = file, line, key, right
        what = problem if key is None else f"{key!r} {problem}"
        super().__init__(f"{file}: line {line}: {what}; right would be: {right}")


class MeaningError(GroundingError):
    """A meaning that was written down and cannot be read back.

    Attributes:
        line: its number, from 1; 0 where the text as a whole is wrong.
        text: of the line.
        right: what would be right.
    """

    def __init__(self, line: int, text: str, problem: str, right: str) -> None:
        self.line, self.text, self.right = line, text, right
        where = f"line {line} ({text!r})" if line else "the text"
        super().__init__(f"meaning: {where} {problem}; right would be: {right}")


class ModelError(GroundingError):
    """Weights or a grammar on disk that are missing, damaged or of another version."""


class PictureError(GroundingError):
    """A picture that cannot be written where it was asked for; names the file."""


class CorpusErrors(CorpusError):
    """Everything that was refused in a corpus, where reading went on after the first.

    Attributes:
        problems: one error each, in the order of the files and lines.
        rest: the corpus of the examples that were not refused; None where there is none, or what was read is none.
    """

    def __init__(self, problems: Sequence[CorpusError], rest: Corpus | None = None) -> None:
        self.problems = tuple(problems)
        self.rest = rest
        super().__init__("\n".join(str(problem) for problem in self.problems))


class SearchError(GroundingError):
    """A space of symbols or of assignments that is too large to be searched; says how large it is."""

"""What a reader does with a refusal: stop at the first, or note it and go on."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager
from typing import TYPE_CHECKING

from grounding.errors import CorpusError, CorpusErrors, GroundingError

if TYPE_CHECKING:
    from grounding.corpus.format import Corpus


class Problems:
    """Refusals met while reading.

    Attributes:
        keep_going: note them and go on, instead of raising the first.
        found: so far.
    """

    def __init__(self, keep_going: bool) -> None:
        self.keep_going = keep_going
        self.found: list[CorpusError] = []
        self._raised: CorpusError | None = None

    @contextmanager
    def at(self, place: str) -> Iterator[None]:
        """Read one element; a refusal inside is named after `place`, the innermost one where several are entered."""
        try:
            yield
        except (GroundingError, RecursionError) as error:
            if error is self._raised:
                raise
            problem = CorpusError(f"{place}: {error if isinstance(error, GroundingError) else 'nested too deeply'}")
            if not self.keep_going:
                self._raised = problem
                raise problem from error
            self.found.append(problem)

    def finish(self, rest: Corpus | None = None) -> None:
        """Raise what was noted, if anything, with the corpus of what was not refused."""
        if self.found:
            raise CorpusErrors(self.found, rest)

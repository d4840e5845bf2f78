"""Whether a corpus agrees with its worlds and with itself: a list of findings, each with its example and phrase."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import asdict, dataclass
from itertools import zip_longest

from grounding.corpus.format import Corpus, Example, objects_of
from grounding.corpus.shapes import misfit
from grounding.errors import LanguageError
from grounding.language.tokens import tokenize
from grounding.language.tree import Phrase, to_brackets
from grounding.symbols import Container, Symbol, format_symbols
from grounding.world import World


@dataclass(frozen=True)
class Finding:
    """Something that does not agree.

    Attributes:
        check: name of the check that found it, one of `CHECKS`.
        example: id of the example.
        phrase: text of the phrase, or None where the whole example is meant.
        message: what is wrong.
    """

    check: str
    example: str
    phrase: str | None
    message: str

    def __str__(self) -> str:
        where = f", {self.phrase!r}" if self.phrase is not None else ""
        return f"{self.example}{where}: {self.message} [{self.check}]"

    def to_json(self) -> dict[str, str | None]:
        """The finding as plain values."""
        return asdict(self)


def check_corpus(corpus: Corpus) -> tuple[Finding, ...]:
    """Run all `CHECKS`, in their order."""
    return tuple(finding for check in CHECKS.values() for finding in check(corpus))


def check_objects(corpus: Corpus) -> Iterator[Finding]:
    """Worlds are there and hold every object that symbols name."""
    for example in corpus.examples:
        if example.world not in corpus.worlds:
            yield Finding("objects", example.id, None, f"no world {example.world!r} in this corpus")
            continue
        known = corpus.worlds[example.world].by_id
        for phrase, symbols in example.phrases:
            for name in sorted({name for symbol in symbols for name in objects_of(symbol)} - set(known)):
                yield Finding("objects", example.id, phrase.text, f"no object {name!r} in world {example.world!r}")


def check_words(corpus: Corpus) -> Iterator[Finding]:
    """The words of the tree are those of the instruction; marks may be left out of the tree."""
    for example in corpus.examples:
        leaves = [leaf.text for leaf in example.tree.leaves]
        try:
            tokens = tokenize(example.instruction)
        except LanguageError as error:
            yield Finding("words", example.id, None, str(error))
            continue
        texts = [token.text for token in tokens]
        if leaves != texts and leaves != [token.text for token in tokens if token.is_word]:
            pairs = enumerate(zip_longest(leaves, texts, fillvalue="nothing"), start=1)
            place, (leaf, text) = next((n, pair) for n, pair in pairs if pair[0] != pair[1])
            message = f"word {place} is {leaf!r} in the tree and {text!r} in the instruction"
            yield Finding("words", example.id, None, message)


def check_agreement(corpus: Corpus) -> Iterator[Finding]:
    """Phrases with the same words and the same tree, in the same world after the same history, have the same symbols.

    Of those that differ, the ones against the majority are reported; against the first, where there is none.
    """
    seen: dict[tuple[str, tuple[str, ...], str], dict[frozenset[Symbol], list[tuple[Example, Phrase]]]] = {}
    for example in corpus.examples:
        for phrase, symbols in example.phrases:
            key = example.world, example.history, to_brackets(phrase)
            seen.setdefault(key, {}).setdefault(symbols, []).append((example, phrase))
    for answers in seen.values():
        usual = max(answers, key=lambda symbols: len(answers[symbols]))
        for symbols, places in answers.items():
            if symbols == usual:
                continue
            witness = answers[usual][0][0].id
            extra, missing = format_symbols(symbols - usual) or "nothing", format_symbols(usual - symbols) or "nothing"
            for example, phrase in places:
                yield Finding("agreement", example.id, phrase.text,
                              f"differs from the same phrase in {witness}: has {extra}, lacks {missing}")  # fmt: skip


def check_containers(corpus: Corpus) -> Iterator[Finding]:
    """Containers are what they say: rows straight along y, columns along x, circles round, towers stacked."""
    known: dict[tuple[str, Container], str | None] = {}
    for example in corpus.examples:
        world = corpus.worlds.get(example.world)
        if world is None:
            continue
        for phrase, symbols in example.phrases:
            for symbol in sorted((s for s in symbols if isinstance(s, Container) and s.objects), key=str):
                key = example.world, symbol
                if key not in known:
                    known[key] = _misfit(symbol, world)
                message = known[key]
                if message is not None:
                    yield Finding("containers", example.id, phrase.text, f"{symbol}: {message}")


def _misfit(container: Container, world: World) -> str | None:
    if any(name not in world.by_id for name in container.objects):
        return None  # `check_objects` says so
    return misfit(container.kind, [world[name] for name in container.objects])


CHECKS: dict[str, Callable[[Corpus], Iterator[Finding]]] = {
    "objects": check_objects,
    "words": check_words,
    "agreement": check_agreement,
    "containers": check_containers,
}

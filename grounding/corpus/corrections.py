"""Corrections of an annotated corpus: a file of what is wrong in it, phrase by phrase, and what would be right.

A corpus that others published stays as it is; what is wrong in it stands in a file of its own, so that both can be
measured. The file quotes nothing: a phrase is named by its number in preorder, its tag and the positions of its first
and last word, and all three have to agree with the corpus. `docs/corrections.md` gives the form.
"""

from __future__ import annotations

import json
from collections import Counter
from collections.abc import Mapping
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any, TypeGuard

from grounding.corpus.format import Corpus, Example, objects_of
from grounding.corpus.problems import Problems
from grounding.errors import CorpusError, SymbolError
from grounding.language.tokens import tokenize
from grounding.language.tree import Phrase, Word
from grounding.symbols import Symbol, format_symbols, parse_symbol
from grounding.world import World

KINDS: Mapping[str, str] = {
    "referent": "the objects are not those that the words mean in this world",
    "missing": "a symbol that the same kind of phrase has everywhere else is not there",
    "unsaid": "a symbol that no word of the phrase says, and that the same kind of phrase has nowhere else",
    "slip": "a value is off: a name, a count, a place in a symbol",
    "word": "a word of the tree is not the one that the instruction has in its place",
}
_KEYS = ("phrase", "tag", "words", "kind", "wrong", "annotated", "right")
_OPTIONAL = ("from_instruction",)


@dataclass(frozen=True)
class PhraseCorrection:
    """What is wrong with one phrase.

    Attributes:
        number: of the phrase in the preorder of its tree, from 0.
        tag: its phrase type.
        first: position of its first word in the tree, from 0.
        last: position of its last word.
        kind: one of `KINDS`.
        wrong: what is wrong and why.
        annotated: symbols that should not be there.
        right: symbols that should be there in their stead.
        from_instruction: positions of the words that are taken from the instruction's text instead of the tree.
    """

    number: int
    tag: str
    first: int
    last: int
    kind: str
    wrong: str
    annotated: frozenset[Symbol]
    right: frozenset[Symbol]
    from_instruction: tuple[int, ...] = ()

    def __str__(self) -> str:
        return f"phrase {self.number} ({self.tag}, words {self.first} to {self.last})"


@dataclass(frozen=True)
class Correction:
    """All that is wrong with one example.

    Attributes:
        id: of the example.
        phrases: by their numbers.
    """

    id: str
    phrases: tuple[PhraseCorrection, ...]


@dataclass(frozen=True)
class Corrections:
    """A file of corrections.

    Attributes:
        source: the file, as errors name it.
        examples: one entry for each example that is corrected.
    """

    source: str
    examples: tuple[Correction, ...]

    @property
    def kinds(self) -> Mapping[str, int]:
        """How many phrases are corrected, by kind."""
        return dict(Counter(phrase.kind for entry in self.examples for phrase in entry.phrases))


def read_corrections(path: Path | str, keep_going: bool = False) -> Corrections:
    """Read a file of corrections.

    Args:
        path: a JSON file; `docs/corrections.md` gives its form.
        keep_going: read all entries and raise all refusals together.

    Raises:
        CorpusError: naming the file, the id, the phrase and the key; `CorpusErrors` with `keep_going`.
    """
    try:
        data = json.loads(Path(path).read_text(encoding="utf-8"))
    except FileNotFoundError:
        raise CorpusError(f"{path}: no such file of corrections") from None
    except (OSError, ValueError, RecursionError) as error:
        raise CorpusError(f"{path}: cannot be read as a file of corrections: {error}") from error
    if not isinstance(data, dict) or set(data) != {"corrections"} or not isinstance(data["corrections"], list):
        raise CorpusError(f"{path}: a file of corrections is an object with the key 'corrections', a list")
    problems = Problems(keep_going)
    entries: dict[str, Correction] = {}
    for number, item in enumerate(data["corrections"], start=1):
        with problems.at(str(path)):
            if not isinstance(item, dict) or set(item) != {"id", "phrases"}:
                raise CorpusError(f"correction {number}: expected an object with the keys 'id' and 'phrases'")
            name, phrases = item["id"], item["phrases"]
            if not isinstance(name, str) or not name:
                raise CorpusError(f"correction {number}: 'id' is a text that is not empty, not {name!r}")
            if name in entries:
                raise CorpusError(f"{name}: corrected twice; every id occurs once")
            if not isinstance(phrases, list) or not phrases:
                raise CorpusError(f"{name}: 'phrases' is a list that is not empty")
            found: dict[int, PhraseCorrection] = {}
            for phrase in phrases:
                with problems.at(f"{path}: {name}"):
                    read = _read_phrase(phrase)
                    if read.number in found:
                        raise CorpusError(f"{read}: corrected twice; every phrase occurs once")
                    found[read.number] = read
            entries[name] = Correction(name, tuple(found[key] for key in sorted(found)))
    problems.finish()
    return Corrections(str(path), tuple(entries.values()))


def apply_corrections(corpus: Corpus, corrections: Corrections, keep_going: bool = False) -> Corpus:
    """The corpus as it would be if it were right; the one that is given stays as it is.

    Args:
        corpus: as it was published.
        corrections: all of its examples have to be in the corpus.
        keep_going: apply everything and raise all refusals together.

    Raises:
        CorpusError: naming the file, the id and the phrase: an unknown id, a phrase that is not there or has another
            tag or other words, a symbol that is not annotated or is there already, an object that is not in the world.
            `CorpusErrors` with `keep_going`.
    """
    problems = Problems(keep_going)
    known = {example.id: place for place, example in enumerate(corpus.examples)}
    examples = list(corpus.examples)
    for entry in corrections.examples:
        with problems.at(corrections.source):
            if entry.id not in known:
                raise CorpusError(f"{entry.id}: no such example among the {len(corpus)} of the corpus")
            place = known[entry.id]
            examples[place] = corrected(examples[place], entry, corpus.worlds[examples[place].world])
    problems.finish()
    return Corpus(tuple(examples), corpus.worlds)


def corrected(example: Example, correction: Correction, world: World) -> Example:
    """An example with its corrections applied; see `apply_corrections`.

    Args:
        example: as it was published.
        correction: of this example.
        world: of this example.
    """
    groundings = list(example.groundings)
    phrases = list(example.tree.preorder())
    words: dict[int, str] = {}
    for entry in correction.phrases:
        where = f"{example.id}: {entry}"
        if entry.number >= len(phrases):
            raise CorpusError(f"{where}: the tree has the phrases 0 to {len(phrases) - 1}")
        phrase = phrases[entry.number]
        leaves = phrase.leaves
        if (phrase.tag, leaves[0].index, leaves[-1].index) != (entry.tag, entry.first, entry.last):
            raise CorpusError(f"{where}: phrase {entry.number} of the tree is {phrase.tag}, words {leaves[0].index} to "
                              f"{leaves[-1].index}")  # fmt: skip
        groundings[entry.number] = _exchanged(groundings[entry.number], entry, world, where)
        for position in entry.from_instruction:
            words[position] = _word(example, position, where)
    tree = _reworded(example.tree, words) if words else example.tree
    return replace(example, tree=tree, groundings=tuple(groundings))


def _exchanged(symbols: frozenset[Symbol], entry: PhraseCorrection, world: World, where: str) -> frozenset[Symbol]:
    if absent := entry.annotated - symbols:
        raise CorpusError(f"{where}: not annotated: {format_symbols(absent)}; annotated are "
                          f"{format_symbols(symbols) or 'no symbols'}")  # fmt: skip
    if there := entry.right & symbols:
        raise CorpusError(f"{where}: annotated already: {format_symbols(there)}")
    unknown = sorted({name for symbol in entry.right for name in objects_of(symbol)} - set(world.by_id))
    if unknown:
        raise CorpusError(f"{where}: no object {unknown[0]!r} in its world")
    return (symbols - entry.annotated) | entry.right


def _word(example: Example, position: int, where: str) -> str:
    """The word that the instruction's text has where the tree has a leaf."""
    said = [token.text for token in tokenize(example.instruction) if token.is_word]
    leaves = example.tree.leaves
    if len(said) != len(leaves):
        raise CorpusError(f"{where}: 'from_instruction' needs a tree with as many words as the instruction, not "
                          f"{len(leaves)} for {len(said)}")  # fmt: skip
    if said[position] == leaves[position].text:
        raise CorpusError(f"{where}: 'from_instruction': word {position} is the instruction's already")
    return said[position]


def _reworded(phrase: Phrase, words: Mapping[int, str]) -> Phrase:
    children: list[Word | Phrase] = []
    for child in phrase.children:
        if isinstance(child, Phrase):
            children.append(_reworded(child, words))
        else:
            children.append(replace(child, text=words.get(child.index, child.text)))
    return Phrase(phrase.tag, tuple(children))


def _read_phrase(data: Any) -> PhraseCorrection:
    if not isinstance(data, dict):
        raise CorpusError(f"a phrase is an object with the keys {', '.join(_KEYS)}, not {type(data).__name__}")
    number = data.get("phrase")
    where = f"phrase {number!r}: "
    for key in _KEYS:
        if key not in data:
            raise CorpusError(f"{where}key {key!r} is missing")
    for key in data:
        if key not in _KEYS + _OPTIONAL:
            raise CorpusError(f"{where}unknown key {key!r}; known are {', '.join(_KEYS + _OPTIONAL)}")
    if not _is_position(number):
        raise CorpusError(f"{where}'phrase' is a number in preorder, from 0")
    for key in ("tag", "kind", "wrong"):
        if not isinstance(data[key], str) or not data[key].strip():
            raise CorpusError(f"{where}{key!r} is a text that is not empty, not {data[key]!r}")
    if data["kind"] not in KINDS:
        raise CorpusError(f"{where}unknown kind {data['kind']!r}; known are {', '.join(KINDS)}")
    span = _positions(data["words"], f"{where}'words'")
    if len(span) != 2 or span[0] > span[1]:
        raise CorpusError(f"{where}'words' are the positions of the first and the last word, not {data['words']!r}")
    exchanged = _positions(data.get("from_instruction", []), f"{where}'from_instruction'")
    for position in exchanged:
        if not span[0] <= position <= span[1]:
            raise CorpusError(f"{where}'from_instruction': {position} is no word of the phrase")
    sides = {key: _symbols(data[key], f"{where}{key!r}") for key in ("annotated", "right")}
    if not (exchanged or sides["annotated"] or sides["right"]):
        raise CorpusError(f"{where}nothing is corrected; 'annotated' and 'right' hold no symbol")
    if both := sides["annotated"] & sides["right"]:
        raise CorpusError(f"{where}both wrong and right: {format_symbols(both)}")
    return PhraseCorrection(number, data["tag"], *span, data["kind"], data["wrong"], sides["annotated"],
                            sides["right"], exchanged)  # fmt: skip


def _is_position(value: Any) -> TypeGuard[int]:
    return isinstance(value, int) and not isinstance(value, bool) and value >= 0


def _positions(values: Any, where: str) -> tuple[int, ...]:
    if not isinstance(values, list) or not all(_is_position(value) for value in values):
        raise CorpusError(f"{where} is a list of positions, from 0, not {values!r}")
    return tuple(values)


def _symbols(texts: Any, where: str) -> frozenset[Symbol]:
    if not isinstance(texts, list) or not all(isinstance(text, str) for text in texts):
        raise CorpusError(f"{where} is a list of symbols, each a text, not {texts!r}")
    return frozenset(_symbol(text, where) for text in texts)


def _symbol(text: str, where: str) -> Symbol:
    try:
        return parse_symbol(text)
    except SymbolError as error:
        raise CorpusError(f"{where}: {error}") from error

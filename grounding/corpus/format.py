"""Annotated examples and the files they are kept in: `NAME.jsonl`, one example a line, beside `NAME.worlds.json`.

A line holds `id`, `world` (a name in the worlds file), `instruction`, `outcome` and `tree`: the phrase tree in brackets
with the symbols of every phrase in braces, in the notation of `grounding.symbols`. It may hold `history`: the ids of
what was moved before, the latest last.
"""

from __future__ import annotations

import json
from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass
from functools import cached_property, lru_cache
from pathlib import Path
from typing import Any

from grounding.corpus.problems import Problems
from grounding.errors import CorpusError, SymbolError, TreeError, WorldError
from grounding.language.tree import Phrase, from_brackets, to_brackets
from grounding.symbols import (
    Action,
    Container,
    ObjectSymbol,
    Region,
    Symbol,
    format_symbols,
    parse_symbols,
)
from grounding.world import World, load_worlds, world_to_json

OUTCOMES = ("grounded", "ambiguous", "no_referent")
_KEYS = ("id", "world", "instruction", "outcome", "tree")
_OPTIONAL = ("history",)


@dataclass(frozen=True)
class Example:
    """One instruction, understood.

    Attributes:
        id: its name, unique in a corpus.
        world: name of the world it was given in.
        instruction: as it was written.
        tree: its phrases.
        groundings: the symbols that are true of each phrase, in the order of `tree.preorder()`.
        outcome: one of `OUTCOMES`.
        history: ids of what was moved before, the latest last.
    """

    id: str
    world: str
    instruction: str
    tree: Phrase
    groundings: tuple[frozenset[Symbol], ...]
    outcome: str = "grounded"
    history: tuple[str, ...] = ()

    def __post_init__(self) -> None:
        if self.outcome not in OUTCOMES:
            raise CorpusError(f"unknown outcome {self.outcome!r}; known are {', '.join(OUTCOMES)}")
        count = sum(1 for _ in self.tree.preorder())
        if count != len(self.groundings):
            raise CorpusError(f"{len(self.groundings)} groundings for {count} phrases; every phrase has one")

    @cached_property
    def phrases(self) -> tuple[tuple[Phrase, frozenset[Symbol]], ...]:
        """Every phrase with its symbols, parents before children."""
        return tuple(zip(self.tree.preorder(), self.groundings, strict=True))


@dataclass(frozen=True, eq=False)
class Corpus:
    """Examples and the worlds they speak of.

    Attributes:
        examples: in the order of the file.
        worlds: by their names.
    """

    examples: tuple[Example, ...]
    worlds: Mapping[str, World]

    def __len__(self) -> int:
        return len(self.examples)

    def __iter__(self) -> Iterator[Example]:
        return iter(self.examples)

    def __getitem__(self, example_id: str) -> Example:
        for example in self.examples:
            if example.id == example_id:
                return example
        raise CorpusError(f"no example {example_id!r} among the {len(self.examples)} of this corpus")

    def select(self, examples: Iterable[Example]) -> Corpus:
        """A corpus of these examples, with the worlds that they need."""
        kept = tuple(examples)
        names = {example.world for example in kept}
        return Corpus(kept, {name: world for name, world in self.worlds.items() if name in names})


def worlds_path(path: Path | str) -> Path:
    """Where the worlds of a corpus file are kept: beside it, as `NAME.worlds.json`."""
    return Path(path).with_suffix(".worlds.json")


def objects_of(symbol: Symbol) -> tuple[str, ...]:
    """Ids of all objects that a symbol names."""
    match symbol:
        case ObjectSymbol(id):
            return (id,)
        case Container() | Region():
            return symbol.objects
        case Action(objects=objects, destination=destination):
            return objects + (destination.objects if destination else ())
    return ()


def example_from_json(data: Any, worlds: Mapping[str, World]) -> Example:
    """Build an example from the plain values of a line.

    Args:
        data: what JSON gave.
        worlds: by name; the example's must be among them and hold every object that it names.

    Raises:
        CorpusError: naming the key or the phrase.
    """
    if not isinstance(data, dict):
        raise CorpusError(f"an example is an object with the keys {', '.join(_KEYS)}, not {type(data).__name__}")
    who = f"example {data['id']!r}: " if isinstance(data.get("id"), str) else ""
    for key in _KEYS:
        if key not in data:
            raise CorpusError(f"{who}key {key!r} is missing")
        if not isinstance(data[key], str) or (not data[key].strip() and key != "world"):
            raise CorpusError(f"{who}{key!r} is a text that is not empty, not {data[key]!r}")
    for key in data:
        if key not in _KEYS + _OPTIONAL:
            raise CorpusError(f"{who}unknown key {key!r}; known are {', '.join(_KEYS + _OPTIONAL)}")
    if data["world"] not in worlds:
        raise CorpusError(f"{who}no world {data['world']!r} among the {len(worlds)} of the worlds file")
    try:
        tree, notes = from_brackets(data["tree"])
    except TreeError as error:
        raise CorpusError(f"{who}'tree': {error}") from error
    groundings = []
    known = worlds[data["world"]].by_id
    for phrase, note in zip(tree.preorder(), notes, strict=True):
        try:
            symbols = _symbols(note)
        except SymbolError as error:
            raise CorpusError(f"{who}phrase {phrase.tag} {phrase.text!r}: {error}") from error
        for unknown in (name for symbol in symbols for name in objects_of(symbol) if name not in known):
            raise CorpusError(f"{who}phrase {phrase.tag} {phrase.text!r}: no object {unknown!r} in its world")
        groundings.append(symbols)
    history = _history(data.get("history", []), known, who)
    try:
        return Example(
            data["id"], data["world"], data["instruction"], tree, tuple(groundings), data["outcome"], history
        )
    except CorpusError as error:
        raise CorpusError(f"{who}{error}") from None


def _history(value: Any, known: Mapping[str, Any], who: str) -> tuple[str, ...]:
    if not isinstance(value, list) or not all(isinstance(name, str) for name in value):
        raise CorpusError(f"{who}'history' is a list of ids, not {value!r}")
    for name in value:
        if name not in known:
            raise CorpusError(f"{who}'history': no object {name!r} in its world")
    return tuple(value)


def example_to_json(example: Example) -> dict[str, Any]:
    """An example as the plain values of a line; `example_from_json` reads them back."""
    notes = iter(example.groundings)
    tree = to_brackets(example.tree, lambda _: format_symbols(next(notes)))
    data: dict[str, Any] = {"id": example.id, "world": example.world, "instruction": example.instruction,
                            "outcome": example.outcome, "tree": tree}  # fmt: skip
    return {**data, "history": list(example.history)} if example.history else data


def read_corpus(path: Path | str, keep_going: bool = False) -> Corpus:
    """Read a corpus in the project's format.

    Args:
        path: of the `.jsonl` file; the worlds lie beside it.
        keep_going: read all lines and raise all refusals together.

    Raises:
        CorpusError: naming the file, the line and the element; `CorpusErrors` with `keep_going`.
    """
    problems = Problems(keep_going)
    try:
        lines = Path(path).read_text(encoding="utf-8").split("\n")
    except FileNotFoundError:
        raise CorpusError(f"{path}: no such corpus file") from None
    except (OSError, UnicodeDecodeError) as error:
        raise CorpusError(f"{path}: cannot be read as a corpus file: {error}") from error
    try:
        worlds = load_worlds(worlds_path(path))
    except WorldError as error:
        raise CorpusError(str(error)) from error
    examples: dict[str, Example] = {}
    for number, line in enumerate(lines, start=1):
        if not line.strip():
            continue
        with problems.at(f"{path}: line {number}"):
            try:
                data = json.loads(line)
            except (ValueError, RecursionError) as error:
                raise CorpusError(f"not a whole JSON object ({error}); is it truncated?") from error
            example = example_from_json(data, worlds)
            if example.id in examples:
                raise CorpusError(f"example {example.id!r}: duplicate id; every id occurs once")
            examples[example.id] = example
    if not examples and not problems.found:
        raise CorpusError(f"{path}: holds no example; a line looks like {json.dumps(dict.fromkeys(_KEYS, '...'))}")
    corpus = Corpus(tuple(examples.values()), worlds)
    problems.finish(corpus if examples else None)
    return corpus


def write_corpus(corpus: Corpus, path: Path | str) -> None:
    """Write a corpus as `path` and, beside it, its worlds; both one element a line."""
    lines = [json.dumps(example_to_json(example), ensure_ascii=False) for example in corpus.examples]
    Path(path).write_text("".join(line + "\n" for line in lines), encoding="utf-8")
    write_worlds(corpus.worlds, worlds_path(path))


def write_worlds(worlds: Mapping[str, World], path: Path | str) -> None:
    """Write a file of named worlds, one a line."""
    lines = [f"{json.dumps(name)}: {json.dumps(world_to_json(world))}" for name, world in worlds.items()]
    Path(path).write_text("{" + ",\n ".join(lines) + "}\n", encoding="utf-8")


@lru_cache(maxsize=1 << 16)
def _symbols(note: str) -> frozenset[Symbol]:
    return parse_symbols(note)

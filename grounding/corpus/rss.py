"""The XML corpus of Paul et al. (RSS 2016), as published with H2SL: a folder of `example_*.xml` becomes a `Corpus`.

Worlds are told apart by their layout, not by the image that an example names. What the recordings leave open is filled
in by `rss_world`; symbols are translated by `rss_symbols`.
"""

from __future__ import annotations

from collections import Counter
from dataclasses import dataclass
from pathlib import Path

from grounding.corpus.elements import Element, read_elements
from grounding.corpus.format import Corpus, Example
from grounding.corpus.problems import Problems
from grounding.corpus.rss_symbols import read_symbol
from grounding.corpus.rss_world import layout, read_world, short_names
from grounding.errors import CorpusError
from grounding.language.tree import Phrase, Word
from grounding.symbols import Symbol
from grounding.world import World

PHRASE_TAGS = ("NP", "PP", "VP", "PRT", "S", "ADJP", "ADVP", "SBAR", "QP", "WHNP", "X")
_REST = ("instruction", "image", "world")


@dataclass(frozen=True)
class _Reading:
    """One file, before its world has a name."""

    id: str
    image: str
    instruction: str
    world: World
    tree: Phrase
    groundings: tuple[frozenset[Symbol], ...]


def read_folder(folder: Path | str, keep_going: bool = False) -> Corpus:
    """Read all `example_*.xml` of a folder, in the order of their names.

    Args:
        folder: where they are.
        keep_going: read all files and raise all refusals together.

    Raises:
        CorpusError: a file that is not well-formed, has no tree, or names an unknown object or symbol; names the file,
            the line and the element. `CorpusErrors` with `keep_going`.
    """
    paths = sorted(Path(folder).glob("example_*.xml"))
    if not paths:
        raise CorpusError(f"{folder}: no example_*.xml in this folder")
    problems = Problems(keep_going)
    readings: list[_Reading] = []
    for path in paths:
        before = len(problems.found)
        with problems.at(str(path)):
            reading = _read_file(path, problems)
            if len(problems.found) == before:  # a file with a refused symbol is not used
                readings.append(reading)
    problems.finish(_join(readings) if readings else None)
    return _join(readings)


def read_file(path: Path | str) -> Corpus:
    """Read a single file: a corpus of one example."""
    problems = Problems(keep_going=False)
    with problems.at(str(path)):
        return _join([_read_file(Path(path), problems)])
    raise AssertionError("unreachable: a refusal was raised")


def _read_file(path: Path, problems: Problems) -> _Reading:
    root = read_elements(path)
    worlds, instructions = list(root.all("world")), list(root.all("instruction"))
    if len(worlds) != 1 or len(instructions) != 1:
        raise CorpusError(f"{root}: expected one <world> and one <instruction>, found {len(worlds)} and "
                          f"{len(instructions)}")  # fmt: skip
    trees = [child for child in root.children if child.tag not in _REST]
    if len(trees) != 1:
        raise CorpusError(f"{root}: expected one phrase as the tree, found {len(trees)}")
    names = short_names(worlds[0])
    groundings: list[frozenset[Symbol]] = []
    tree = _phrase(trees[0], names, groundings, [0], problems, path)
    image = next((Path(child.attributes.get("file", "")).stem for child in root.all("image")), "")
    return _Reading(
        path.stem, image, instructions[0].get("text"), read_world(worlds[0], names), tree, tuple(groundings)
    )


def _phrase(
    element: Element,
    names: dict[str, str],
    groundings: list[frozenset[Symbol]],
    count: list[int],
    problems: Problems,
    path: Path,
) -> Phrase:
    """Build a phrase; its symbols are appended in preorder, `count` counts the words so far."""
    if element.tag not in PHRASE_TAGS:
        raise CorpusError(f"{element}: no phrase; known are {', '.join(PHRASE_TAGS)}")
    slot = len(groundings)
    groundings.append(frozenset())
    symbols: list[Symbol] = []
    children: list[Word | Phrase] = []
    for child in element.children:
        if child.tag == "grounding":
            for entry in (symbol for group in child.all("grounding_set") for symbol in group.children):
                with problems.at(str(path)):
                    symbols.append(read_symbol(entry, names))
        elif "text" in child.attributes:
            children.append(Word(child.attributes["text"].lower(), child.tag, count[0]))
            count[0] += 1
        else:
            children.append(_phrase(child, names, groundings, count, problems, path))
    if not children:
        raise CorpusError(f"{element}: a phrase without words")
    groundings[slot] = frozenset(symbols)
    return Phrase(element.tag, tuple(children))


def _join(readings: list[_Reading]) -> Corpus:
    """Give every layout one name: that of the scene which most of its images show."""
    layouts: dict[tuple[object, ...], list[_Reading]] = {}
    for reading in readings:
        layouts.setdefault(layout(reading.world), []).append(reading)
    named: dict[tuple[object, ...], str] = {}
    for key, group in layouts.items():
        scenes = Counter(reading.image.rpartition("_")[0] or "world" for reading in group)
        name = base = min(scenes, key=lambda scene: (-scenes[scene], scene))
        number = 2
        while name in named.values():
            name, number = f"{base}-{number}", number + 1
        named[key] = name
    examples = tuple(Example(r.id, named[layout(r.world)], r.instruction, r.tree, r.groundings) for r in readings)
    return Corpus(examples, {named[key]: group[0].world for key, group in layouts.items()})

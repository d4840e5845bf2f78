"""The treebank: sentences that people of this project wrote as gold trees, annotated in worlds where they are clear."""

from __future__ import annotations

import zlib
from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from grounding.corpus.annotate import annotate
from grounding.corpus.composer import compose
from grounding.corpus.format import Corpus, Example
from grounding.corpus.meaning import NotAnnotatable
from grounding.errors import CorpusError, TreeError
from grounding.geometry.layout import Layout
from grounding.language.tree import Phrase, from_brackets
from grounding.symbols import Container
from grounding.world import World, load_world


@dataclass(frozen=True, eq=False)
class LaidWorld:
    """A world whose arrangements are known.

    Attributes:
        name: in the corpus.
        layout: the world, measured.
        arrangements: (kind, mask) of those that are there to be spoken of.
    """

    name: str
    layout: Layout
    arrangements: tuple[tuple[str, int], ...]


def read_trees(folder: Path) -> tuple[Phrase, ...]:
    """The gold trees of all `*.trees` files of a folder, in the order of files and lines.

    Raises:
        CorpusError: no file, or a line that is no tree; names file and line.
    """
    files = sorted(folder.glob("*.trees"))
    if not files:
        raise CorpusError(f"{folder}: no *.trees files; gold trees stand one a line in files of that name")
    trees = []
    for path in files:
        for number, line in enumerate(path.read_text(encoding="utf-8").splitlines(), start=1):
            if line.strip() and not line.lstrip().startswith("#"):
                try:
                    trees.append(from_brackets(line)[0])
                except TreeError as error:
                    raise CorpusError(f"{path.name}, line {number}: {error}") from error
    return tuple(trees)


def lay(name: str, world: World, containers: Iterable[Container] = ()) -> LaidWorld:
    """Digest a world; arrangements that chance made and that catch the eye count like those that were laid."""
    layout = Layout(world)
    known = [(c.kind, layout.mask(c.objects)) for c in containers]
    for found in layout.prominent(a for a in layout.arrangements if a.evident):
        if not any(found.mask & mask and (found.kind == kind or found.kind == "group") for kind, mask in known):
            known.append((found.kind, found.mask))
    return LaidWorld(name, layout, tuple(known))


def shipped_worlds(folder: Path) -> Iterator[LaidWorld]:
    """The scenes of a folder, digested."""
    for path in sorted(folder.glob("*.json")):
        yield lay(path.stem, load_world(path))


def composed_worlds(count: int, seed: int) -> Iterator[LaidWorld]:
    """Worlds composed at random, digested; the same seed gives the same ones."""
    rng = np.random.default_rng(seed)
    for number in range(count):
        composition = compose(rng)
        yield lay(f"c{number:03d}", composition.world, composition.containers)


def annotate_everywhere(
    trees: Sequence[Phrase], worlds: Sequence[LaidWorld], limits: Mapping[str, int], seed: int
) -> Iterator[Example]:
    """Annotate every tree in some of the worlds where it can be.

    Args:
        trees: gold trees.
        worlds: to choose from; each tree tries them in an order of its own.
        limits: how many examples of each outcome a tree gets at most.
        seed: of that order.
    """
    for number, tree in enumerate(trees):
        rng = np.random.default_rng((seed, zlib.crc32(tree.text.encode())))
        left = dict(limits)
        for place in rng.permutation(len(worlds)):
            world = worlds[int(place)]
            try:
                groundings, outcome = annotate(tree, world.layout, world.arrangements)
            except NotAnnotatable:
                continue
            if left.get(outcome, 0) > 0:
                left[outcome] -= 1
                yield Example(f"t{number:04d}-{world.name}", world.name, tree.text, tree, groundings, outcome)
            if not any(left.values()):
                break


def build_treebank(trees_folder: Path, scenes_folder: Path, composed: int = 200, seed: int = 1) -> Corpus:
    """Annotate the project's sentences in the shipped scenes and in composed worlds."""
    worlds = [*shipped_worlds(scenes_folder), *composed_worlds(composed, seed)]
    limits = {"grounded": 5, "ambiguous": 1, "no_referent": 1}
    examples = tuple(annotate_everywhere(read_trees(trees_folder), worlds, limits, seed))
    used = {example.world for example in examples}
    return Corpus(examples, {w.name: w.layout.world for w in worlds if w.name in used})

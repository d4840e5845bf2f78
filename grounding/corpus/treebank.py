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
from grounding.corpus.sight import SLANTED
from grounding.corpus.sparse import colourless, compose_loosely, with_hands
from grounding.corpus.variation import vary
from grounding.errors import CorpusError, TreeError
from grounding.geometry.arrangements import Arrangement
from grounding.geometry.layout import Layout
from grounding.language.tree import Phrase, from_brackets
from grounding.symbols import Container
from grounding.world import World, load_world

HANDS_SHARE = 0.3
COLOURLESS_SHARE = 0.1
MOST_TRIED = 120  # worlds in which a tree is tried


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
    """Digest a world; arrangements that chance made and that catch the eye count like those that were laid.

    A line that leans like neither a row nor a column counts too: a diagonal.
    """
    layout = Layout(world)
    known = [(c.kind, layout.mask(c.objects)) for c in containers]
    for found in layout.evident_of((), layout.everything):
        if not any(found.mask & mask and (found.kind == kind or found.kind == "group") for kind, mask in known):
            known.append((found.kind, found.mask))
    known += [(a.kind, a.mask) for a in layout.prominent(filter(_is_diagonal, layout.arrangements))
              if not any((a.mask & mask).bit_count() > 1 for _, mask in known)]  # fmt: skip
    return LaidWorld(name, layout, tuple(known))


def _is_diagonal(line: Arrangement) -> bool:
    """Whether a line is evident and slanted."""
    fits = line.deviation < 0.12 and line.regularity > 0.75 and line.separation > 0.9
    return line.kind in ("row", "column") and line.angle > SLANTED and line.count >= 3 and fits


def shipped_worlds(folder: Path) -> Iterator[LaidWorld]:
    """The scenes of a folder, digested."""
    for path in sorted(folder.glob("*.json")):
        yield lay(path.stem, load_world(path))


def composed_worlds(count: int, seed: int) -> Iterator[LaidWorld]:
    """Worlds composed at random, digested; the same seed gives the same ones.

    Half are laid neatly, half loosely; in some the robot's hands are recorded, in some nobody knows the colours.
    """
    rng = np.random.default_rng(seed)
    for number in range(count):
        composition = compose(rng) if number % 2 else compose_loosely(rng)
        world = composition.world
        if rng.random() < HANDS_SHARE:
            world = with_hands(world)
        if rng.random() < COLOURLESS_SHARE:
            world = colourless(world)
        yield lay(f"c{number:03d}", world, composition.containers)


def annotate_everywhere(
    trees: Sequence[Phrase], worlds: Sequence[LaidWorld], limits: Mapping[str, float], seed: int, prefix: str = "t"
) -> Iterator[Example]:
    """Annotate every tree in some of the worlds where it can be.

    Args:
        trees: gold trees.
        worlds: to choose from; each tree tries them in an order of its own.
        limits: how many examples of each outcome a tree gets at most; a fraction is the chance of one more.
        seed: of that order.
        prefix: of the examples' ids.
    """
    for number, tree in enumerate(trees):
        rng = np.random.default_rng((seed, zlib.crc32(tree.text.encode())))
        left = {outcome: int(limit + rng.random()) for outcome, limit in limits.items()}
        for place in rng.permutation(len(worlds))[:MOST_TRIED]:
            world = worlds[int(place)]
            try:
                groundings, outcome = annotate(tree, world.layout, world.arrangements)
            except NotAnnotatable:
                continue
            if left.get(outcome, 0) > 0:
                left[outcome] -= 1
                name = f"{prefix}{number:05d}-{world.name}"
                yield Example(name, world.name, tree.text, tree, groundings, outcome)
            if not left.get("grounded", 0):
                break


def build_treebank(trees_folder: Path, scenes_folder: Path, composed: int = 200, seed: int = 1) -> Corpus:
    """Annotate the project's sentences in the shipped scenes and in composed worlds."""
    worlds = [*shipped_worlds(scenes_folder), *composed_worlds(composed, seed)]
    limits = {"grounded": 3, "ambiguous": 0.5, "no_referent": 0.4}
    return _corpus(annotate_everywhere(read_trees(trees_folder), worlds, limits, seed), worlds)


def build_variants(
    trees: Sequence[Phrase], scenes_folder: Path, variants: int, composed: int = 400, seed: int = 2
) -> Corpus:
    """Annotate variants of gold trees, each in a world or two.

    Args:
        trees: gold trees.
        scenes_folder: of the shipped scenes.
        variants: how many of each tree.
        composed: how many worlds are composed beside the scenes.
        seed: of worlds and variants.
    """
    worlds = [*shipped_worlds(scenes_folder), *composed_worlds(composed, seed)]
    rng = np.random.default_rng(seed)
    varied = {str(tree): tree for original in trees for tree in (vary(original, rng) for _ in range(variants))}
    limits = {"grounded": 1.5, "ambiguous": 0.2, "no_referent": 0.2}
    return _corpus(annotate_everywhere(list(varied.values()), worlds, limits, seed, "v"), worlds)


def _corpus(examples: Iterable[Example], worlds: Sequence[LaidWorld]) -> Corpus:
    kept = tuple(examples)
    used = {example.world for example in kept}
    return Corpus(kept, {w.name: w.layout.world for w in worlds if w.name in used})

"""Generates annotated examples: composes worlds, samples gold trees, keeps what is true of the world.

Worlds may come from elsewhere, settled by physics for instance: `recognise` finds the arrangements in them. Which
wordings are held out is told by a hash of the wording alone, see `is_held_out`.
"""

from __future__ import annotations

import zlib
from collections import Counter
from collections.abc import Iterable
from functools import lru_cache

import numpy as np

import models
from grounding.corpus.annotate import annotate
from grounding.corpus.composer import compose
from grounding.corpus.format import Example
from grounding.corpus.meaning import NotAnnotatable
from grounding.corpus.sparse import colourless, compose_loosely, with_hands
from grounding.corpus.treebank import LaidWorld, lay, read_trees
from grounding.corpus.variation import vary
from grounding.language.lexicon import alike
from grounding.language.tree import Phrase
from grounding.symbols import Container
from grounding.world import Viewpoint, World, make_object

KINDS = ("composed", "loose")
MOST_COPIES = 4  # of one wording in a corpus
HELD_OUT_SHARE = 0.1
SPEAKER_SHARE = 0.4
_TRIES = 60  # trees a wanted example
_OUTCOME_SHARES = {"grounded": 0.8, "ambiguous": 0.1, "no_referent": 0.1}


def compose_world(rng: np.random.Generator, name: str, kind: str | None = None, blocks: int | None = None) -> LaidWorld:
    """Lay a random world without physics.

    Args:
        rng: the only source of chance.
        name: in the corpus.
        kind: one of `KINDS`; drawn if None.
        blocks: how many, 3 to 30; drawn if None; worlds of kind "loose" have few.
    """
    kind = KINDS[int(rng.random() < 0.2)] if kind is None else kind
    composition = compose_loosely(rng) if kind == "loose" and blocks is None else compose(rng, blocks)
    return recognise(name, dressed(composition.world, rng), composition.containers)


def dressed(world: World, rng: np.random.Generator) -> World:
    """The world with what does not lie on the table drawn: a speaker across it, the robot's hands, unknown colours."""
    if rng.random() < SPEAKER_SHARE:
        table = next((item for item in world.objects if item.type == "table"), make_object("table"))
        x = float(table.position[0] + table.size[0] / 2 + rng.uniform(0.2, 0.6))
        place = np.array([round(x, 3), round(float(rng.uniform(-0.1, 0.1)), 3), 0.0])
        world = World(world.objects, Viewpoint(place, 3.14159))
    if rng.random() < 0.15:
        world = with_hands(world)
    return colourless(world) if rng.random() < 0.05 else world


def recognise(name: str, world: World, containers: Iterable[Container] = ()) -> LaidWorld:
    """Digest a world: the arrangements that were laid, if known, and those that catch the eye."""
    return lay(name, world, containers)


def generate(world: LaidWorld, rng: np.random.Generator, count: int, taken: Counter[str]) -> tuple[Example, ...]:
    """Annotated examples in one world.

    Args:
        world: with its arrangements.
        rng: the only source of chance.
        count: at most so many; fewer where little is true of the world.
        taken: how often each wording is in the corpus already; counted on.

    Returns:
        examples with ids unique for the world's name.
    """
    trees = _trees()
    found: list[Example] = []
    texts: set[str] = set()
    for _ in range(_TRIES * count):
        if len(found) == count:
            break
        tree = vary(trees[int(rng.integers(len(trees)))], rng)
        wording = wording_of(tree)
        if tree.text in texts or taken[wording] >= MOST_COPIES:
            continue
        try:
            groundings, outcome = annotate(tree, world.layout, world.arrangements)
        except NotAnnotatable:
            continue
        if rng.random() > _OUTCOME_SHARES[outcome] * 1.25:
            continue
        texts.add(tree.text)
        taken[wording] += 1
        found.append(Example(f"{world.name}-{len(found)}", world.name, tree.text, tree, groundings, outcome))
    return tuple(found)


def wording_of(tree: Phrase) -> str:
    """The words of a tree without the number, rank, colour or side that they name."""
    return " ".join(alike(leaf.text) for leaf in tree.leaves)


def is_held_out(tree: Phrase) -> bool:
    """Whether the wording of a tree is kept for measuring: decided by a hash, for all corpora alike."""
    return zlib.crc32(wording_of(tree).encode()) % 1000 < 1000 * HELD_OUT_SHARE


@lru_cache(maxsize=1)
def _trees() -> tuple[Phrase, ...]:
    return read_trees(models.TREEBANK)

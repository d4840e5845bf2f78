"""Figures 6 and 7: instructions of a corpus, and some of our own, with what their phrases were grounded to.

Instructions of the corpus are grounded on their annotated trees, by factors learned from all examples of other
wordings; those of our own are parsed and grounded as they are in use, by what ships with the project.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

import models
from grounding.corpus.format import Corpus, Example
from grounding.experiments.engines import make_engine
from grounding.experiments.errors import ExperimentError
from grounding.experiments.panels import Figure, phrases_of, telling_panels, unsaid_kinds
from grounding.experiments.splits import layout_key
from grounding.geometry.layout import Layout
from grounding.grounder import Grounder
from grounding.inference import aligned
from grounding.learning import learn
from grounding.learning.examples import annotated
from grounding.symbols import Container
from grounding.world import load_world

PENALTY = 0.3
CANDIDATES = 3  # so many examples are grounded for each that is drawn


class OwnInstruction(NamedTuple):
    """An instruction in words of our own.

    Attributes:
        name: of the figure.
        scene: that ships with the project.
        text: of the instruction.
    """

    name: str
    scene: str
    text: str


OWN = (
    OwnInstruction("own_five", "default", "take the middle cube of the five cubes on the right"),
    OwnInstruction("own_six", "twelve", "lift the nearest block of the six blocks on the right"),
)


def choose(corpus: Corpus, count: int) -> tuple[str, ...]:
    """Ids of the examples that show most: phrases that ground to an arrangement which none of their words names.

    Among equals the longer instruction comes first; instructions of the same words or in the same world come later.
    """
    worth = {example.id: _worth(example, corpus) for example in corpus}
    order = sorted(corpus, key=lambda e: (-worth[e.id][0], -worth[e.id][1], -len(e.tree.leaves), e.id))
    chosen: list[Example] = []
    for fresh in (True, False):
        for example in order:
            if len(chosen) == count:
                break
            told = example.tree.text in {e.tree.text for e in chosen}
            known = example.world in {e.world for e in chosen}
            if example not in chosen and not (fresh and (told or known)):
                chosen.append(example)
    return tuple(example.id for example in chosen)


def corpus_figures(corpus: Corpus, ids: Sequence[str], count: int | None = None) -> tuple[Figure, ...]:
    """Figures of examples of a corpus.

    Args:
        corpus: that they are in; those of other words are learned from.
        ids: of the examples.
        count: so many are drawn, those whose root is grounded as annotated and that have most to show; None: all.

    Raises:
        CorpusError: there is no such example.
        ExperimentError: nothing is left to learn from.
    """
    chosen = [corpus[name] for name in ids]
    texts = {example.tree.text for example in chosen}
    layouts = {name: Layout(world) for name, world in corpus.worlds.items()}
    rest = [e for e in corpus if e.tree.text not in texts]
    if not rest:
        raise ExperimentError("no instruction is left to learn from but those that are to be drawn")
    engine = make_engine("adcg", learn([annotated(e.tree, e.groundings, layouts[e.world]) for e in rest], PENALTY))
    figures: list[tuple[tuple[bool, int], Figure]] = []
    for example in chosen:
        best = engine.infer(example.tree, layouts[example.world]).hypotheses[0]
        panels = telling_panels(phrases_of(example.tree, best), corpus.worlds[example.world])
        known = layout_key(corpus.worlds[example.world]) in {layout_key(corpus.worlds[e.world]) for e in rest}
        parts = [part.symbols for _, part in aligned(example.tree, best)]
        right = sum(part == gold for part, gold in zip(parts, example.groundings, strict=True))
        note = f"{example.id}, {example.world}: learned from {len(rest)} instructions of other words"
        note += f", {'some' if known else 'none'} of them in this world"
        note += f"; {right} of {len(example.groundings)} phrases as annotated"
        figure = Figure(example.id, example.instruction, corpus.worlds[example.world], panels, note)
        figures.append(((parts[0] != example.groundings[0], -len(panels)), figure))
    if count is not None:
        figures = sorted(figures, key=lambda pair: pair[0])[:count]
    return tuple(figure for _, figure in figures)


def own_figures() -> tuple[Figure, ...]:
    """Figures of instructions in words of our own, in scenes and with weights that ship with the project."""
    grounder = Grounder.load()
    figures = []
    for own in OWN:
        world = load_world(models.SCENES / f"{own.scene}.json")
        result = grounder.ground(own.text, world)
        note = f"in words of our own, in the scene {own.scene!r}, with the grammar and the weights that ship"
        figures.append(Figure(own.name, own.text, world, telling_panels(result.phrases, world), note))
    return tuple(figures)


def _worth(example: Example, corpus: Corpus) -> tuple[int, int]:
    """How many phrases ground to an arrangement that no word names: to one of some of the blocks, and at all."""
    count = len(corpus.worlds[example.world].things)
    some = every = 0
    for phrase, symbols in example.phrases:
        if phrase.tag == "NP" and set(unsaid_kinds(phrase.text, symbols)) - {"group"}:
            every += 1
            some += all(len(s.objects) < count for s in symbols if isinstance(s, Container))
    return some, every

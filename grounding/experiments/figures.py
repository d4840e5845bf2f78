"""Figures 6 and 7: instructions of a corpus, and some of our own, with what their phrases were grounded to.

Instructions of the corpus are grounded on their annotated trees, by factors learned from all examples of other
wordings; those of our own by the grammar and the factors that ship with the project.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

import models
from grounding.corpus.format import Corpus, Example
from grounding.experiments.engines import ADAPTIVE, Engine, make_engine
from grounding.experiments.errors import ExperimentError
from grounding.experiments.panels import Figure, phrases_of, telling_panels, unsaid_kinds
from grounding.experiments.splits import layout_key
from grounding.factors import load_model
from grounding.geometry.layout import Layout
from grounding.inference import Adcg, aligned
from grounding.language.parser import Parser
from grounding.learning import learn
from grounding.learning.examples import annotated
from grounding.symbols import Container
from grounding.world import load_world

PENALTY = 0.1
CANDIDATES = 6  # so many examples are grounded for each that is drawn
_PARTS = 4  # parts of the examples, each left out of what the factors for its figures learn from


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

    Among equals the longer instruction comes first; no two have the same words.
    """
    worth = {example.id: _worth(example, corpus) for example in corpus}
    order = sorted(corpus, key=lambda e: (-worth[e.id][0], -worth[e.id][1], -len(e.tree.leaves), e.id))
    chosen: list[Example] = []
    for example in order:
        if len(chosen) < count and example.tree.text not in {e.tree.text for e in chosen}:
            chosen.append(example)
    return tuple(example.id for example in chosen)


def corpus_figures(corpus: Corpus, ids: Sequence[str], count: int | None = None) -> tuple[Figure, ...]:
    """Figures of examples of a corpus, each grounded by factors that have not seen its words.

    Args:
        corpus: that they are in.
        ids: of the examples.
        count: so many are drawn, those first whose root is grounded as annotated and of which a phrase means an
            arrangement that no word names, from as many worlds as there are; None: all.

    Raises:
        CorpusError: there is no such example.
        ExperimentError: nothing is left to learn from.
    """
    chosen = [corpus[name] for name in dict.fromkeys(ids)]
    layouts = {name: Layout(world) for name, world in corpus.worlds.items()}
    parts = min(_PARTS, len(chosen))
    drawn: dict[str, tuple[bool, Figure]] = {}
    for part in range(parts):
        held = chosen[part::parts]
        texts = {example.tree.text for example in held}
        rest = [e for e in corpus if e.tree.text not in texts]
        if not rest:
            raise ExperimentError("no instruction is left to learn from but those that are to be drawn")
        learned = learn([annotated(e.tree, e.groundings, layouts[e.world]) for e in rest], PENALTY)
        engine = make_engine(ADAPTIVE, learned)
        for example in held:
            drawn[example.id] = _figure(example, corpus, rest, engine, layouts[example.world])
    ordered = [drawn[example.id] for example in chosen]
    return tuple(figure for _, figure in ordered) if count is None else _best(ordered, count)


def _figure(
    example: Example, corpus: Corpus, rest: Sequence[Example], engine: Engine, layout: Layout
) -> tuple[bool, Figure]:
    """The figure of an example, and whether it shows what the figures are for."""
    best = engine.infer(example.tree, layout).hypotheses[0]
    panels = telling_panels(phrases_of(example.tree, best), layout.world)
    found = [part.symbols for _, part in aligned(example.tree, best)]
    right = sum(symbols == gold for symbols, gold in zip(found, example.groundings, strict=True))
    here = layout_key(layout.world)
    known = any(layout_key(corpus.worlds[e.world]) == here for e in rest)
    note = f"{example.id}, {example.world}; {right} of {len(found)} phrases as annotated; learned from {len(rest)} "
    note += f"instructions of other words, {'some' if known else 'none'} in this world"
    shows = found[0] == example.groundings[0] and any(set(panel.unsaid) - {"group"} for panel in panels)
    return shows, Figure(example.id, example.instruction, layout.world, panels, note)


def _best(figures: Sequence[tuple[bool, Figure]], count: int) -> tuple[Figure, ...]:
    """Those that show what they are for come first, and of these one of each world."""
    kept: list[Figure] = []
    for wanted, fresh in ((True, True), (True, False), (False, True), (False, False)):
        for shows, figure in figures:
            known = figure in kept or (fresh and any(figure.world is other.world for other in kept))
            if shows == wanted and not known and len(kept) < count:
                kept.append(figure)
    return tuple(kept)


def own_figures() -> tuple[Figure, ...]:
    """Figures of instructions in words of our own, in scenes and with factors that ship with the project."""
    parser, engine = Parser.load(), Adcg(load_model(models.WEIGHTS), beam=1)
    figures = []
    for own in OWN:
        world = load_world(models.SCENES / f"{own.scene}.json")
        tree = parser.parse(own.text, 1)[0].tree
        best = engine.infer(tree, Layout(world)).hypotheses[0]
        note = f"in words of our own, in the scene {own.scene!r}, with the grammar and the factors that ship"
        figures.append(Figure(own.name, own.text, world, telling_panels(phrases_of(tree, best), world), note))
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

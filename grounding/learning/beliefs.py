"""Learns the weights that decide what is meant, from texts of which only what they mean is known.

Annotated examples tell by their root what may be meant, free texts by the object that their writer saw marked. How a
text is to be read is not told: every reading is weighed. What is spoken of on the way is judged by the weights of the
round before.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator
from dataclasses import dataclass

import numpy as np

from grounding.corpus.format import Corpus
from grounding.corpus.hands import Hands
from grounding.geometry.layout import Layout
from grounding.grounder import Grounder
from grounding.language.parser import Parse
from grounding.model.belief import Objects, rows_of
from grounding.model.cases import Learned, Weights
from grounding.model.evaluator import EVEN
from grounding.model.training import Example, collect, train
from grounding.readings import pick_of
from grounding.symbols import Action
from grounding.world.scene import Scene

EQUAL = Learned(Weights({**EVEN, "nothing": -3.0, "spread": 1.0, "literal": 1.0,
                                  "nothing.literal": 1.0}), EVEN)  # fmt: skip
"""Equal weights of all concepts, towards which the penalty pulls."""
ALONE = ("literal",)
"""Readers that are left out while weights for what is spoken of on the way are learned."""
PENALTY = 100.0
HANDS = 20.0
"""Free texts count so many times more than others: they are few, and more like what people write."""
ROUNDS = 1


@dataclass(frozen=True, eq=False)
class Text:
    """A text with what it means.

    Attributes:
        parses: the likeliest first.
        scene: the world.
        history: ids of the objects handled before.
        gold: what may be meant; the empty tuple where nothing here is.
        weight: how much it counts.
    """

    parses: tuple[Parse, ...]
    scene: Scene
    history: tuple[str, ...]
    gold: tuple[Objects, ...]
    weight: float = 1.0


def texts_of(corpus: Corpus, grounder: Grounder) -> Iterator[Text]:
    """The texts of annotated examples, parsed anew from their words."""
    scenes = {name: Scene(Layout(world)) for name, world in corpus.worlds.items()}
    for example in corpus.examples:
        scene = scenes[example.world]
        root = example.groundings[0]
        asked = {s.objects for s in root if isinstance(s, Action) and s.objects}
        asked = asked or {action.objects for action in pick_of(root, scene.layout)}
        meant = example.outcome in ("grounded", "ambiguous")
        gold = tuple(sorted({tuple(sorted(objects)) for objects in asked})) if meant else ()
        yield Text(grounder.parser.parse(example.instruction, grounder.parses), scene, example.history, gold or ((),))


def texts_by_hand(hands: Hands, grounder: Grounder, split: str = "train") -> Iterator[Text]:
    """Free texts, with the object that the writer saw marked."""
    scenes = {name: Scene(Layout(world)) for name, world in hands.worlds.items()}
    for text in hands.texts:
        if text.split == split:
            parses = grounder.parser.parse(text.instruction, grounder.parses)
            yield Text(parses, scenes[text.world], text.history, ((text.object,),), HANDS)


def learn_beliefs(
    texts: Iterable[Text], grounder: Grounder, *, shuffled: int | None = None,
    progress: Callable[[str], None] | None = None,
) -> Learned:  # fmt: skip
    """Learn the weights that decide, and those that judge what is spoken of on the way.

    The latter are learned from meanings alone: what other readers hold of a text says nothing of its parts.

    Args:
        texts: with what they mean.
        grounder: that reads them; its own weights are not used.
        shuffled: seed with which every text's meaning is drawn from what its readings propose, for telling how much the
            weights decide; None for learning from what is meant.
        progress: told what is done.
    """
    kept = tuple(texts)
    rng = None if shuffled is None else np.random.default_rng(shuffled)
    learned = EQUAL
    for number, without in enumerate((*[ALONE] * ROUNDS, grounder.without), start=1):
        reader = Grounder(grounder.parser, learned, without=without)
        problem = collect(_examples(kept, reader, rng))
        if progress is not None:
            found = f"{problem.texts} texts, {len(problem.names)} features, {problem.lost} texts left out"
            progress(f"round {number} of {ROUNDS + 1}: {found}")
        weights = train(problem, EQUAL.deciding, PENALTY)
        learned = Learned(weights, weights if number <= ROUNDS else learned.referring)
    return learned


def _examples(texts: Iterable[Text], reader: Grounder, rng: np.random.Generator | None) -> Iterator[Example]:
    for text in texts:
        readings = reader.hear(text.parses, text.scene, text.history).meanings
        example = Example(readings, text.gold, text.weight)
        if rng is not None:
            options = sorted({names for reading in readings for names, *_ in rows_of(reading)})
            example = replace_gold(example, options[int(rng.integers(len(options)))])
        yield example


def replace_gold(example: Example, option: Objects) -> Example:
    """The same readings with another meaning."""
    return example._replace(gold=(option,))

"""Readings of an instruction: what each hypothesis of each parse would have the robot do, with its share of belief."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass

from grounding.geometry.layout import Layout
from grounding.geometry.masks import indices_of
from grounding.inference import Hypothesis, Inference
from grounding.language.lexicon import is_universal, meanings
from grounding.language.tree import Phrase
from grounding.symbols import (
    Action,
    Cardinal,
    Container,
    ContainerAttribute,
    ObjectAttribute,
    ObjectSymbol,
    ObjectType,
    Region,
    Symbol,
    symbol_key,
)

REFERENT_ODDS = 20.0  # people who instruct mean something that is there: so many to one
_PARSE_WEIGHT = 0.7  # how much a parse's probability counts beside how well its phrases ground


@dataclass(frozen=True)
class Reading:
    """One way to take the instruction.

    Attributes:
        inference: of the parse.
        hypothesis: of its root.
        actions: what it asks for; several where it leaves open which, none where it asks for nothing that is there.
        weight: its share of belief among all readings; they sum to 1.
    """

    inference: Inference
    hypothesis: Hypothesis
    actions: tuple[Action, ...]
    weight: float


def readings(inferences: Sequence[tuple[Inference, float]], layout: Layout) -> tuple[Reading, ...]:
    """All readings, the likeliest first.

    Args:
        inferences: of every parse, with the parse's probability.
        layout: the world.
    """
    found: list[tuple[float, Inference, Hypothesis, tuple[Action, ...]]] = []
    for inference, probability in inferences:
        count = max(1, sum(1 for _ in inference.tree.preorder()))
        best = inference.hypotheses[0].log_probability
        for hypothesis in inference.hypotheses:
            actions = requested(inference.tree, hypothesis, layout)
            log = _PARSE_WEIGHT * math.log(max(probability, 1e-9)) + best / count
            log += hypothesis.log_probability - best + (math.log(REFERENT_ODDS) if actions else 0.0)
            found.append((log, inference, hypothesis, actions))
    top = max(log for log, *_ in found)
    total = sum(math.exp(log - top) for log, *_ in found)
    found.sort(key=lambda item: -item[0])
    return tuple(Reading(i, h, a, math.exp(log - top) / total) for log, i, h, a in found)


def preferred(inference: Inference, layout: Layout) -> Hypothesis:
    """The hypothesis that is believed: people mean something that is there, see `REFERENT_ODDS`."""
    return readings([(inference, 1.0)], layout)[0].hypothesis


def requested(tree: Phrase, hypothesis: Hypothesis, layout: Layout) -> tuple[Action, ...]:
    """What a hypothesis asks for. A noun phrase alone asks to pick up what it means."""
    actions = [s for s in hypothesis.symbols if isinstance(s, Action) and s.objects]
    if actions:
        return _agreeing(tree, sorted(actions, key=symbol_key))
    if tree.tag == "NP":
        return _agreeing(tree, pick_of(hypothesis.symbols, layout))
    if tree.tag in ("FRAG", "S", "SBAR"):
        for child, part in zip(tree.phrases, hypothesis.children, strict=True):
            found = requested(child, part, layout)
            if found:
                return found
    return ()


def _agreeing(tree: Phrase, actions: Sequence[Action]) -> tuple[Action, ...]:
    """Number agreement: where one block is spoken of and several were found, it is open which one is meant."""
    if not _speaks_of_one(tree):
        return tuple(actions)
    single = (Action(a.kind, (name,), a.destination) for a in actions for name in a.objects)
    return tuple(dict.fromkeys(single))


def _speaks_of_one(tree: Phrase) -> bool:
    """Whether what is handled is a single object by the words' number: "the block in the row", not "each block"."""
    phrase = tree
    while phrase.phrases:
        inner = [child for child in phrase.phrases if child.tag in ("NP", "VP", "S")]
        if not inner or any(word.tag == "CC" for word in phrase.words):
            return False
        phrase = inner[-1] if phrase.tag in ("S", "SBAR") else inner[0]
    nouns = [word for word in phrase.words if word.tag in ("NN", "NNS")]
    if phrase.tag != "NP" or not nouns or any(is_universal(word.text) for word in phrase.words):
        return False
    numbers = any(isinstance(s, Cardinal) and s.value > 1 for word in phrase.words for s in meanings(word.text))
    return nouns[-1].tag == "NN" and not numbers and any(isinstance(s, ObjectType) for s in meanings(nouns[-1].text))


def pick_of(symbols: frozenset[Symbol], layout: Layout) -> tuple[Action, ...]:
    """Picking up what a noun phrase means: its objects, or each that it leaves possible."""
    objects = tuple(sorted(s.id for s in symbols if isinstance(s, ObjectSymbol) and s.id in layout.index))
    if objects:
        return (Action("pick", objects),)
    pool = layout.everything
    attributes = [s for s in symbols if isinstance(s, ObjectAttribute)]
    if not attributes:
        return ()
    for symbol in symbols:
        match symbol:
            case ObjectAttribute(object_type, color) | ContainerAttribute(object_type, color):
                pool &= layout.matching(object_type, color)
            case Container(_, members) if members:
                pool &= layout.mask(members)
            case Region():
                pool &= layout.within(symbol)
    return tuple(Action("pick", (layout.ids[i],)) for i in indices_of(pool))

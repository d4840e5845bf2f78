"""Learns the first pass: which kinds of symbols the annotated groundings of a phrase contain.

The threshold is chosen on instructions whose wording was left out: the largest that still keeps the wanted share of the
kinds that these need.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass

import numpy as np

from grounding.factors.first_pass import FirstPass
from grounding.factors.training import TrainingSet, train
from grounding.features import FAMILIES, family_of
from grounding.features.needs import need_facts, need_key, world_facts
from grounding.geometry.layout import Layout
from grounding.inference.first_pass import Restriction
from grounding.language.tree import Phrase
from grounding.learning.examples import Annotated
from grounding.symbols import Symbol
from grounding.world import Array

PENALTY = 0.3
KEPT = 0.997  # share of the needed kinds to be kept of instructions left out; some above .99, for texts to come
PARTS = 4
_TOLERANCE = 1e-4  # of the fit
_SHYEST, _BOLDEST = 1e-4, 0.02  # thresholds below and above which none is chosen

KINDS = tuple(family.name for family in FAMILIES)


def needed(symbols: Iterable[Symbol]) -> tuple[str, ...]:
    """The kinds among some symbols, in the order of the families."""
    found = {family_of(symbol) for symbol in symbols}
    return tuple(kind for kind in KINDS if kind in found)


def learn_first_pass(examples: Iterable[Annotated], penalty: float = PENALTY, kept: float = KEPT) -> FirstPass:
    """Train the first pass and choose its threshold.

    Args:
        examples: annotated trees.
        penalty: strength of the L2 regularisation.
        kept: the share of the needed kinds that the threshold keeps in cross-validation.
    """
    known = list(examples)
    texts = {text: number for number, text in enumerate(sorted({tree.text for tree, _, _ in known}))}
    parts = min(PARTS, len(texts))
    odds: list[Array] = [np.array([np.inf])]
    for part in range(parts if parts > 1 else 0):
        out = [example for example in known if texts[example[0].text] % parts == part]
        rest = [example for example in known if texts[example[0].text] % parts != part]
        odds.append(_odds_of_needed(_train(rest, penalty), out))
    return FirstPass(_train(known, penalty).factor, _threshold(np.concatenate(odds), kept))


def share_kept(first_pass: FirstPass, examples: Iterable[Annotated]) -> float:
    """The share of the needed kinds that is kept; 1 where none is needed."""
    restriction = Restriction(first_pass)
    counts = [count_kept(restriction, example) for example in examples]
    wanted = sum(total for _, total in counts)
    return sum(found for found, _ in counts) / wanted if wanted else 1.0


def count_kept(restriction: Restriction, example: Annotated) -> tuple[int, int]:
    """How many of the kinds that the phrases of an example need are kept, and how many they need."""
    tree, groundings, layout = example
    needs = restriction.needs(tree, layout)
    found = total = 0
    for phrase in tree.preorder():
        wanted = needed(groundings[id(phrase)])
        total += len(wanted)
        found += len(needs[id(phrase)].kept.intersection(wanted))
    return found, total


def _train(examples: Sequence[Annotated], penalty: float) -> FirstPass:
    cases: dict[object, _Case] = {}
    for tree, groundings, layout in examples:
        world = world_facts(layout)
        of = {phrase: needed(symbols) for phrase, symbols in groundings.items()}
        for phrase in tree.preorder():
            children = [of[id(child)] for child in phrase.phrases]
            key = world, need_key(phrase, children), of[id(phrase)]
            cases.setdefault(key, _Case(phrase, children, of[id(phrase)], layout)).count += 1
    data = TrainingSet()
    for case in cases.values():
        rows = [((kind,), kind in case.wanted, case.count) for kind in KINDS]
        data.add_counted(need_facts(case.phrase, case.children, case.layout), rows)
    return FirstPass(train(data, penalty, tolerance=_TOLERANCE), 0.0)


@dataclass
class _Case:
    """A phrase with the kinds that its children and it need, and how often it occurs."""

    phrase: Phrase
    children: list[tuple[str, ...]]
    wanted: tuple[str, ...]
    layout: Layout
    count: int = 0


def _odds_of_needed(first_pass: FirstPass, examples: Sequence[Annotated]) -> Array:
    """The log odds that the first pass gives to what is needed."""
    found: list[float] = []
    restriction = Restriction(first_pass)
    for tree, groundings, layout in examples:
        needs = restriction.needs(tree, layout)
        for phrase in tree.preorder():
            wanted = needed(groundings[id(phrase)])
            values = dict(zip(first_pass.kinds, needs[id(phrase)].log_odds.tolist(), strict=True))
            found += [values[kind] for kind in wanted]
    return np.array(found)


def _threshold(odds: Array, kept: float) -> float:
    """The largest threshold that keeps a share, from the log odds of what is to be kept."""
    lowest = float(np.quantile(odds, 1 - kept, method="lower"))
    return float(np.clip(1 / (1 + np.exp(-lowest)), _SHYEST, _BOLDEST))

"""Turns annotated examples into the rows that factors are trained on.

Every phrase is looked at with its children's annotated groundings and, in the later stages, with its own annotated
concrete and abstract symbols. All symbols that are not annotated are negatives: those that are proposed or, in worlds
whose power set can be listed, all of Γ; those that are alike are merged with their number.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, field

import numpy as np

from grounding.factors import TrainingSet
from grounding.features import FAMILIES, STAGES, Scope, family_of
from grounding.features.context import context_facts
from grounding.features.exhaustive import every
from grounding.geometry.layout import Layout
from grounding.inference.engine import context_key
from grounding.language.tree import Phrase
from grounding.symbols import Symbol

Annotated = tuple[Phrase, Mapping[int, frozenset[Symbol]], Layout]

_STAGE_OF = {family.name: family.stage for family in FAMILIES}


@dataclass
class Coverage:
    """How many annotated symbols were among the proposed ones, by family."""

    annotated: Counter[str] = field(default_factory=Counter)
    proposed: Counter[str] = field(default_factory=Counter)
    missing: list[tuple[str, str]] = field(default_factory=list)


def annotated(tree: Phrase, groundings: Sequence[frozenset[Symbol]], layout: Layout) -> Annotated:
    """Pair every phrase of a tree, by identity, with its annotated symbols."""
    return tree, {id(phrase): g for phrase, g in zip(tree.preorder(), groundings, strict=True)}, layout


@dataclass(frozen=True)
class Negatives:
    """Which symbols are negatives, beside those that are proposed.

    Attributes:
        things: all of Γ in worlds of up to so many things, none in larger ones.
        sample: containers that geometry does not find differ in so many ways that they are not merged but drawn: so
            many of each kind and phrase, each standing for its share; none are left out where there are no more.
        seed: of what is drawn.
    """

    things: int = 0
    sample: int = 64
    seed: int = 0


PROPOSED = Negatives()


def collect(examples: Iterable[Annotated], negatives: Negatives = PROPOSED) -> tuple[dict[str, TrainingSet], Coverage]:
    """The training rows of all families."""
    sets = {family.name: TrainingSet() for family in FAMILIES}
    coverage = Coverage()
    rng = np.random.default_rng(negatives.seed)
    cases: dict[object, _Case] = {}
    for tree, groundings, layout in examples:
        for phrase in tree.preorder():
            children = tuple(groundings[id(child)] for child in phrase.phrases)
            case = _Case(phrase, children, groundings[id(phrase)], layout)
            cases.setdefault((context_key(phrase, children), case.gold, id(layout)), case).count += 1
    for case in cases.values():
        sample = negatives.sample if case.layout.size <= negatives.things else None
        _collect_case(case, sets, coverage, sample, rng)
    return sets, coverage


@dataclass
class _Case:
    """A phrase in a world with its annotation, and how often it occurs."""

    phrase: Phrase
    children: tuple[frozenset[Symbol], ...]
    gold: frozenset[Symbol]
    layout: Layout
    count: int = 0


def _collect_case(
    case: _Case,
    sets: Mapping[str, TrainingSet],
    coverage: Coverage,
    sample: int | None,
    rng: np.random.Generator,
) -> None:
    gold, times = case.gold, case.count
    by_stage = [frozenset(s for s in gold if _STAGE_OF[family_of(s)] == number) for number in range(len(STAGES))]
    scope = Scope(case.phrase, case.children, case.layout)
    for number, families in enumerate(STAGES):
        if number == 1:
            scope = scope.with_concrete(by_stage[0])
        elif number == 2:
            scope = scope.with_abstract(by_stage[1])
        facts = context_facts(scope)
        for family in families:
            wanted = {s for s in gold if family_of(s) == family.name}
            rows: list[tuple[Sequence[str], bool, float]] = []
            if sample is None:
                listed = proposals = family.propose(scope)
            else:
                space = every(scope, family.name).listing(sorted(wanted, key=str))
                listed, proposals = space.listed, space.listed[: space.proposed]
                rows = [(roles, False, times * count) for roles, count in space.unlisted(sample, rng)]
            sets[family.name].add_counted(facts, [*((roles, s in gold, times) for s, roles in listed), *rows])
            found = wanted & {symbol for symbol, _ in proposals}
            coverage.annotated[family.name] += times * len(wanted)
            coverage.proposed[family.name] += times * len(found)
            coverage.missing += times * [(case.phrase.text, str(s)) for s in sorted(wanted - found, key=str)]

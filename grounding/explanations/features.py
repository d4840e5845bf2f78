"""Which features made a phrase mean what it was taken to mean, and its runner-up lose.

A symbol's log odds are the sum of W[c, r] over the facts c of the phrase's context and the roles r of the symbol; each
addend is one binary feature. Two symbols of one family stand in the same context, so that what tells them apart are the
roles that only one of them has.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass

import numpy as np

from grounding.explanations.values import Contribution, Judged
from grounding.explanations.wording import fact_in_words, negated, role_in_words
from grounding.factors import Factor, FactorModel
from grounding.features import STAGES, Scope
from grounding.features.context import context_facts
from grounding.features.families import family_of
from grounding.geometry.layout import Layout
from grounding.inference import Hypothesis
from grounding.inference.engine import sigmoid
from grounding.language.tree import Phrase
from grounding.symbols import Symbol, symbol_key
from grounding.world import Array

SHOWN = 3  # features for, and so many against
_LEAST = 0.05  # weights nearer to zero tell nothing


@dataclass(frozen=True, eq=False)
class Candidates:
    """The symbols of one family that were judged for one phrase.

    Attributes:
        family: its name.
        factor: its weights.
        facts: of the context, those that the factor knows.
        roles: of every symbol.
    """

    family: str
    factor: Factor
    facts: tuple[str, ...]
    roles: Mapping[Symbol, tuple[str, ...]]

    def contributions(self, symbol: Symbol) -> tuple[tuple[str, ...], Array]:
        """The roles of a symbol that the factor knows, and the weight of every (fact, role)."""
        roles = tuple(role for role in self.roles[symbol] if role in self.factor.role_ids)
        rows = [self.factor.fact_ids[fact] for fact in self.facts]
        return roles, self.factor.weights[np.ix_(rows, [self.factor.role_ids[role] for role in roles])]

    def log_odds(self, symbol: Symbol) -> float:
        """Of φ = true, as inference has it."""
        return float(self.contributions(symbol)[1].sum())


@dataclass(frozen=True, eq=False)
class Context:
    """All that was judged for one phrase.

    Attributes:
        scope: of the phrase, with its own symbols settled.
        symbols: that it was taken to mean.
        families: what was judged, by family.
    """

    scope: Scope
    symbols: frozenset[Symbol]
    families: Mapping[str, Candidates]

    def judged(self, symbol: Symbol) -> Judged:
        """A symbol with its strongest features."""
        candidates = self.families.get(family_of(symbol))
        if candidates is None or symbol not in candidates.roles:
            return Judged(symbol, 1.0, 0.0)
        roles, weights = candidates.contributions(symbol)
        odds = float(weights.sum())
        flat = [
            (float(weights[i, j]), candidates.facts[i], roles[j])
            for i, j in np.argwhere(np.abs(weights) > _LEAST).tolist()
        ]
        flat.sort(key=lambda item: (-abs(item[0]), item[1], item[2]))
        pros = self._told([item for item in flat if item[0] > 0], candidates.family)
        cons = self._told([item for item in flat if item[0] < 0], candidates.family)
        return Judged(symbol, sigmoid(odds), odds, pros, cons)

    def _told(self, features: Sequence[tuple[float, str, str]], family: str) -> tuple[Contribution, ...]:
        """The strongest features in words, one of each role, as those of one role say nearly the same."""
        strongest: dict[str, tuple[float, str]] = {}
        for weight, fact, role in features:
            strongest.setdefault(role, (weight, fact))
        told = []
        for role, (weight, fact) in list(strongest.items())[:SHOWN]:
            text = role_in_words(role, family, self.scope)
            if fact != "bias":
                text += f", where {fact_in_words(fact, family, self.scope)}"
            told.append(Contribution(text, weight))
        return tuple(told)

    def runner_up(self, symbol: Symbol) -> Symbol | None:
        """The likeliest symbol of the same family that the phrase was not taken to mean."""
        candidates = self.families.get(family_of(symbol))
        if candidates is None:
            return None
        others = [other for other in candidates.roles if other not in self.symbols]
        return max(others, key=lambda other: (candidates.log_odds(other), symbol_key(other)), default=None)

    def lost(self, symbol: Symbol, rival: Symbol) -> tuple[Contribution, ...]:
        """What speaks for a symbol rather than for another of its family, role by role.

        What holds the rival back most comes first. Weights are negative where they hold the rival back; together, but
        for tiny ones, they are the difference of the log odds.
        """
        candidates = self.families.get(family_of(symbol))
        if candidates is None or symbol not in candidates.roles or rival not in candidates.roles:
            return ()
        found = []
        for bearer, other, sign in ((symbol, rival, -1.0), (rival, symbol, 1.0)):
            roles, weights = candidates.contributions(bearer)
            lacked = set(candidates.roles[other])
            own = {r: v for r, v in zip(roles, weights.sum(axis=0).tolist(), strict=True) if r not in lacked}
            for role, weight in _folded(own).items():
                if abs(weight) > _LEAST:
                    meaning = role_in_words(role, candidates.family, self.scope)
                    found.append(Contribution(meaning if sign > 0 else negated(meaning), sign * weight))
        return tuple(sorted(found, key=lambda item: (item.weight, item.text)))


def _folded(weights: Mapping[str, float]) -> dict[str, float]:
    """Weights of roles; what counts for a whole way of naming a set ("some nth") goes to the set that is named so."""
    folded = dict(weights)
    for role in weights:
        if role.startswith("some "):
            named = [other for other in weights if other.startswith(f"{role[5:]}[")]
            if named:
                strongest = max(named, key=lambda other: (abs(weights[other]), other))
                folded[strongest] += folded.pop(role)
    return folded


def contexts(
    model: FactorModel, phrase: Phrase, hypothesis: Hypothesis, layout: Layout, depth: int = 0
) -> Iterator[tuple[Phrase, int, Context]]:
    """Every phrase of a tree with its depth and what was judged for it, parents before children.

    Args:
        model: the factors.
        phrase: the root.
        hypothesis: of the root.
        layout: the world.
        depth: of the root.
    """
    yield phrase, depth, context_of(model, phrase, hypothesis, layout)
    for child, part in zip(phrase.phrases, hypothesis.children, strict=True):
        yield from contexts(model, child, part, layout, depth + 1)


def context_of(model: FactorModel, phrase: Phrase, hypothesis: Hypothesis, layout: Layout) -> Context:
    """What was judged for one phrase, stage by stage as inference does."""
    stage_of = {family.name: family.stage for family in (f for stage in STAGES for f in stage)}
    by_stage = [frozenset(s for s in hypothesis.symbols if stage_of[family_of(s)] == stage) for stage in range(3)]
    first = Scope(phrase, tuple(child.symbols for child in hypothesis.children), layout)
    second = first.with_concrete(by_stage[0])
    third = second.with_abstract(by_stage[1])
    found: dict[str, Candidates] = {}
    for scope, families in zip((first, second, third), STAGES, strict=True):
        facts = context_facts(scope)
        for family in families:
            factor = model.factors.get(family.name)
            if factor is not None:
                known = tuple(fact for fact in facts if fact in factor.fact_ids)
                roles = {symbol: tuple(roles) for symbol, roles in family.propose(scope)}
                found[family.name] = Candidates(family.name, factor, known, roles)
    return Context(third, hypothesis.symbols, found)

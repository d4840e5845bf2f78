"""Engines of all kinds on the same factors: the same answers, true maxima, and what they searched."""

import functools
import itertools
import math

import numpy as np
import pytest

from grounding.corpus.annotate import annotate
from grounding.errors import SearchError
from grounding.factors import Factor, FactorModel
from grounding.features import FAMILIES, STAGES, Scope, family_of
from grounding.features.context import context_facts
from grounding.features.exhaustive import every
from grounding.geometry.layout import Layout
from grounding.inference import ENGINES, G3, Adcg, Dcg, Exact, aligned
from grounding.inference.dcg import MOST_LIKELY, likely_symbols
from grounding.inference.engine import Tally
from grounding.language.tree import from_brackets
from grounding.learning import Negatives, learn
from grounding.learning.examples import annotated
from grounding.space import SymbolSpace
from grounding.world import World, make_object

TREES = (
    "(VP (VB take) (NP (DT the) (JJ rightmost) (NN block)))",
    "(VP (VB clear) (NP (DT the) (NNS blocks)))",
    "(VP (VB put) (NP (DT the) (JJ red) (NN block)) (PP (IN on) (NP (DT the) (JJ leftmost) (NN block))))",
)
engines = pytest.mark.parametrize("name", list(ENGINES))


@functools.cache
def layout():
    blocks = [make_object(f"b{i}", "block", color, (0.6, y, 0.7)) for i, color, y in ((1, "red", 0.2), (2, "blue", 0),
                                                                                     (3, "green", -0.2))]  # fmt: skip
    return Layout(World((*blocks, make_object("table", "table", "white", (0.65, 0, 0.655), size=(0.7, 1.8, 0.04)))))


@functools.cache
def examples():
    found = []
    for text in TREES:
        tree = from_brackets(text)[0]
        found.append(annotated(tree, annotate(tree, layout(), ())[0], layout()))
    return tuple(found)


@functools.cache
def factors():
    return learn(examples(), 0.1, negatives=Negatives(12))


@functools.cache
def inferred(name, number, **options):
    return ENGINES[name](factors(), **options).infer(examples()[number][0], layout())


@engines
@pytest.mark.parametrize("number", range(len(TREES)))
def test_what_was_learned_is_found_by_all(name, number):
    tree, groundings, _ = examples()[number]
    inference = inferred(name, number)
    for phrase, part in aligned(tree, inference.hypotheses[0]):
        assert part.symbols == groundings[id(phrase)]
        assert part.symbols <= set(part.probabilities)
        assert all(0 <= p <= 1 for p in part.probabilities.values())


@engines
def test_the_same_answer_every_time(name):
    first, second = (ENGINES[name](factors()).infer(examples()[0][0], Layout(layout().world)) for _ in range(2))
    assert first.hypotheses == second.hypotheses
    assert (first.evaluations, first.symbols, first.sizes) == (second.evaluations, second.symbols, second.sizes)


@engines
def test_memory_changes_nothing(name):
    memory = {}
    engine = ENGINES[name](factors())
    tree = examples()[0][0]
    alone, shared, again = (engine.infer(tree, layout(), m) for m in (None, memory, memory))
    assert alone.hypotheses == shared.hypotheses == again.hypotheses


def test_sizes_are_those_of_gamma():
    tree = from_brackets("(NP (DT the) (NN row))")[0]
    inference = Dcg(factors(), beam=1).infer(tree, layout())
    sizes = SymbolSpace.of_world(layout().world).counts
    subsets = 2**sizes.objects - sizes.objects - 1
    assert inference.sizes["container"] == 5 * subsets + (sizes.hands > 0)
    assert inference.sizes["region"] >= 6 * 10 * subsets
    assert set(inference.sizes) == {family.name for family in FAMILIES}
    assert inference.symbols == sum(inference.sizes.values()) >= inference.evaluations > 0
    adaptive = Adcg(factors(), beam=1).infer(tree, layout())
    assert set(adaptive.sizes) <= set(inference.sizes)
    assert all(size <= inference.sizes[family] for family, size in adaptive.sizes.items())
    assert sum(adaptive.sizes.values()) == adaptive.symbols


def test_all_of_a_stage_is_summed_up():
    """The log probability is that of judging every symbol one by one."""
    tree = from_brackets("(NP (DT the) (JJ leftmost) (JJ red) (NN block))")[0]
    scope = Scope(tree, (), layout())
    model = factors()
    for stage in range(3):
        if stage == 1:
            scope = scope.with_concrete(frozenset())
        elif stage == 2:
            scope = scope.with_abstract(frozenset())
        scorer = model.scorer(family.name for family in STAGES[stage])
        likely = likely_symbols(scorer, scope, -3.0, Tally())
        found = likely.rest - sum(math.log1p(math.exp(min(odds, 700))) for odds in likely.log_odds)
        facts, log, probable = context_facts(scope), 0.0, set()
        for family in STAGES[stage]:
            weight = model.factors[family.name].role_weights(facts)
            space = every(scope, family.name)
            rows = [(symbol, roles, 1) for symbol, roles in space.listed]
            for block, dropped in zip(space.blocks, space.dropped, strict=True):
                places = sorted(set(range(block.size)) - set(dropped))
                rows += [(block.symbol(place), block.roles(place), 1) for place in places]
            rows += [(None, roles, count) for roles, count in space.alike]
            for symbol, roles, count in rows:
                odds = sum(weight.get(role, 0.0) for role in roles)
                log -= count * float(np.logaddexp(0.0, odds))
                if odds > -3.0 and symbol is not None:
                    probable.add(symbol)
        assert found == pytest.approx(log, rel=1e-6)
        assert probable <= set(likely.symbols)


def test_the_exact_maximum_is_that_of_a_wide_beam():
    tree = from_brackets("(NP (DT the) (JJ red) (NN block))")[0]
    exact = Exact(factors()).infer(tree, layout()).hypotheses[0]
    wide = Dcg(factors(), beam=4, least=1e-3).infer(tree, layout()).hypotheses[0]
    assert exact.symbols == wide.symbols
    assert exact.log_probability == pytest.approx(wide.log_probability)


@pytest.mark.parametrize("number", range(2))
def test_nothing_is_likelier_than_the_exact_maximum(number):
    exact = inferred("exact", number).hypotheses[0]
    for other in (inferred("dcg", number), inferred("dcg", number, beam=1), inferred("g3", number)):
        assert other.hypotheses[0].log_probability <= exact.log_probability + 1e-9


def test_the_exact_search_says_when_it_is_too_much():
    with pytest.raises(SearchError, match="1 contexts"):
        Exact(factors(), most=1).infer(examples()[0][0], layout())


@pytest.mark.parametrize("candidates", [0, 1, 3])
def test_every_value_of_a_grounding_variable_is_written_out(candidates):
    tree = from_brackets("(NP (DT the) (JJ red) (NN block))")[0]
    values = list(G3(factors(), candidates).values(Scope(tree, (), layout()), Tally()))
    assert len(values) == len({value.symbols for value in values}) == 8**candidates
    assert all(value.log_probability <= 0 for value in values)
    assert sum(math.exp(value.log_probability) for value in values) <= 1 + 1e-9


def test_more_candidates_find_nothing_less_likely():
    found = [G3(factors(), n).infer(examples()[0][0], layout()).hypotheses[0].log_probability for n in range(3)]
    assert all(a <= b + 1e-9 for a, b in itertools.pairwise(found))


@pytest.mark.parametrize("name", ["dcg", "exact", "g3"])
def test_large_worlds_are_refused(name):
    many = World(tuple(make_object(f"b{i}", position=(i, 0, 0)) for i in range(40)))
    with pytest.raises(SearchError, match="40 things"):
        ENGINES[name](factors()).infer(examples()[0][0], Layout(many))


def test_factors_that_know_no_negatives_are_refused():
    world = World(tuple(make_object(f"b{i}", position=(i, 0, 0)) for i in range(12)))
    weight = Factor(("bias",), ("named by nothing",), np.array([[3.0]]))
    assert 5 * 2**12 > MOST_LIKELY
    with pytest.raises(SearchError, match="incorrect combinations"):
        Dcg(FactorModel({"container": weight}, {})).infer(from_brackets("(NP (DT the) (NN row))")[0], Layout(world))


@engines
def test_an_empty_world(name):
    tree = examples()[0][0]
    for hypothesis in ENGINES[name](factors()).infer(tree, Layout(World(()))).hypotheses:
        assert not any(getattr(symbol, "objects", ()) for symbol in hypothesis.symbols)


def test_every_symbol_found_has_a_family():
    for symbol in inferred("dcg", 2).hypotheses[0].symbols:
        assert family_of(symbol) in factors().factors

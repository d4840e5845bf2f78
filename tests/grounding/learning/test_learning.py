"""From annotated trees to factors: every annotated symbol can be proposed, and what was learned is found again."""

import functools

import numpy as np
import pytest

import models
from grounding.corpus.annotate import annotate
from grounding.corpus.loading import load_corpus
from grounding.corpus.meaning import NotAnnotatable
from grounding.factors import Factor
from grounding.features import FAMILIES, family_of
from grounding.geometry.layout import Layout
from grounding.inference import Adcg, Hypothesis
from grounding.language.tree import from_brackets
from grounding.learning import collect, evaluate, learn
from grounding.learning.evaluation import aligned
from grounding.learning.examples import annotated
from grounding.learning.learner import FIRST_PASS
from grounding.world import load_world

TREES = (
    "(VP (VB pick) (PRT (RP up)) (NP (DT the) (JJ rightmost) (NN block)))",
    "(VP (VB take) (NP (DT the) (JJ leftmost) (JJ red) (NN block)))",
    "(VP (VB clear) (NP (DT the) (JJ blue) (NNS blocks)))",
    "(VP (VB take) (NP (DT the) (JJ blue) (NN block)))",
    "(VP (VB put) (NP (DT the) (JJ rightmost) (NN block)) (PP (IN on) (NP (DT the) (JJ leftmost) (NN block))))",
)


@functools.cache
def small():
    """A few sentences in the scene of four."""
    layout = Layout(load_world(models.SCENES / "four.json"))
    found = []
    for text in TREES:
        tree = from_brackets(text)[0]
        found.append(annotated(tree, annotate(tree, layout, ())[0], layout))
    return tuple(found)


@functools.cache
def shipped():
    """Every twentieth example of the treebank."""
    corpus = load_corpus(None)
    chosen = corpus.examples[::40]
    layouts = {e.world: Layout(corpus.worlds[e.world]) for e in chosen}
    return tuple(annotated(e.tree, e.groundings, layouts[e.world]) for e in chosen)


def test_every_phrase_has_its_symbols():
    for tree, groundings, _ in small():
        assert set(groundings) == {id(phrase) for phrase in tree.preorder()}
    tree, groundings, layout = small()[0]
    with pytest.raises(ValueError, match=r"shorter|longer"):
        annotated(tree, tuple(groundings.values())[:-1], layout)


def test_annotated_symbols_are_proposed():
    _, coverage = collect(shipped())
    assert set(coverage.annotated) <= {family.name for family in FAMILIES}
    assert sum(coverage.proposed.values()) >= 0.95 * sum(coverage.annotated.values()), coverage.missing[:10]


def test_rows_are_the_same_every_time():
    first, second = (collect(small())[0] for _ in range(2))
    for name, data in first.items():
        assert data.facts == second[name].facts
        assert data.roles == second[name].roles
        assert data.rows == second[name].rows


@functools.cache
def learned():
    told = []
    return learn(small(), 0.1, told.append, {"why": "a test"}), told


def test_learning_tells_its_progress_and_keeps_notes():
    model, told = learned()
    assert told == [*(family.name for family in FAMILIES), FIRST_PASS]
    assert model.notes["why"] == "a test"
    assert model.notes["penalty"] == 0.1
    assert set(model.factors) == {family.name for family in FAMILIES}


def test_learning_is_deterministic():
    again = learn(small(), 0.1)
    for name, factor in learned()[0].factors.items():
        assert isinstance(factor, Factor)
        assert np.array_equal(factor.weights, again.factors[name].weights)


def test_what_was_learned_is_found_again():
    evaluation = evaluate(small(), Adcg(learned()[0]))
    assert evaluation.examples == len(TREES)
    assert evaluation.root == 1.0
    assert evaluation.complete == 1.0
    assert evaluation.phrases == 1.0
    assert evaluation.errors == ()


def test_shares_are_shares_and_errors_are_told():
    untrained = learn((), 0.1)
    evaluation = evaluate(small(), Adcg(untrained))
    assert evaluation.root < 1
    assert evaluation.complete <= evaluation.root
    assert 0 <= evaluation.phrases <= 1
    assert len(evaluation.errors) == round((1 - evaluation.complete) * evaluation.examples)
    assert evaluate((), Adcg(untrained)).examples == 0


def test_a_higher_bar_for_symbols_finds_fewer():
    shares = [evaluate(small(), Adcg(learned()[0]), bar).phrases for bar in (0.75, 1.0)]
    assert shares[0] > shares[1]


def test_hypotheses_are_aligned_with_phrases():
    tree = from_brackets(TREES[0])[0]
    inner = Hypothesis(frozenset(), 0.0)
    pairs = list(aligned(tree, Hypothesis(frozenset(), 0.0, (inner, inner))))
    assert [phrase for phrase, _ in pairs] == list(tree.preorder())
    with pytest.raises(ValueError, match=r"shorter|longer"):
        list(aligned(tree, inner))


def test_every_annotated_symbol_has_a_family():
    names = {family.name for family in FAMILIES}
    for _, groundings, _ in shipped():
        for symbols in groundings.values():
            assert {family_of(symbol) for symbol in symbols} <= names


def test_sentences_that_are_not_true_teach_nothing():
    layout = Layout(load_world(models.SCENES / "four.json"))
    tree = from_brackets("(VP (VB take) (NP (DT the) (JJ tallest) (NN elephant)))")[0]
    with pytest.raises(NotAnnotatable):
        annotate(tree, layout, ())

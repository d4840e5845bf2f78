"""A first pass that keeps everything changes nothing; one that does not never lets a kind through that was not kept."""

import functools
import itertools
from dataclasses import replace

import numpy as np
import pytest

from grounding.corpus.annotate import annotate
from grounding.errors import ModelError
from grounding.factors import Factor, FirstPass
from grounding.features import FAMILIES, family_of
from grounding.geometry.layout import Layout
from grounding.inference import Adcg, Dcg, Hadcg, Hdcg, aligned
from grounding.inference.first_pass import Restriction
from grounding.language.tree import from_brackets
from grounding.learning import Negatives, learn
from grounding.learning.examples import annotated
from grounding.world import World, make_object

TREES = (
    "(VP (VB take) (NP (DT the) (JJ rightmost) (NN block)))",
    "(VP (VB clear) (NP (DT the) (NNS blocks)))",
    "(VP (VB put) (NP (DT the) (JJ red) (NN block)) (PP (IN on) (NP (DT the) (JJ leftmost) (NN block))))",
)
UNHEARD = "(NP (NP (DT the) (JJ weird) (NN row)) (PP (IN beside) (NP (DT a) (NN block))))"
KINDS = tuple(family.name for family in FAMILIES)
pairs = pytest.mark.parametrize(("restricted", "plain"), [(Hadcg, Adcg), (Hdcg, Dcg)])
texts = pytest.mark.parametrize("text", [*TREES, UNHEARD])


@functools.cache
def layout():
    blocks = [make_object(f"b{i}", "block", color, (0.6, y, 0.7)) for i, color, y in ((1, "red", 0.2), (2, "blue", 0),
                                                                                     (3, "green", -0.2))]  # fmt: skip
    return Layout(World((*blocks, make_object("table", "table", "white", (0.65, 0, 0.655), size=(0.7, 1.8, 0.04)))))


@functools.cache
def factors():
    trees = [from_brackets(text)[0] for text in TREES]
    return learn([annotated(tree, annotate(tree, layout(), ())[0], layout()) for tree in trees], 0.1,
                 negatives=Negatives(12))  # fmt: skip


def first_pass(threshold=0.0, **biases):
    """One that judges kinds by nothing but what is given for them; nothing speaks for or against the others."""
    weights = np.array([[biases.get(kind, 0.0) for kind in KINDS]])
    return FirstPass(Factor(("bias",), KINDS, weights), threshold)


def plain_hypotheses(inference):
    return [(h.symbols, h.log_probability, dict(h.probabilities), h.children) for h in inference.hypotheses]


@pairs
@texts
def test_a_first_pass_that_keeps_everything_changes_nothing(restricted, plain, text):
    tree = from_brackets(text)[0]
    for keeping in (first_pass(), replace(factors().first_pass, threshold=0.0)):
        ours = restricted(factors(), first_pass=keeping).infer(tree, layout())
        theirs = plain(factors()).infer(tree, layout())
        assert plain_hypotheses(ours) == plain_hypotheses(theirs)
        assert ours.sizes == theirs.sizes
        phrases = sum(1 for _ in tree.preorder())
        assert 0 < ours.evaluations - theirs.evaluations <= phrases * len(KINDS)


@pairs
@texts
@pytest.mark.parametrize("banned", ["object", "container", "type", "attribute", "spatial"])
def test_no_symbol_of_a_kind_that_was_not_kept(restricted, plain, text, banned):
    tree = from_brackets(text)[0]
    inference = restricted(factors(), first_pass=first_pass(0.5, **{banned: -1.0})).infer(tree, layout())
    assert banned not in inference.sizes
    for hypothesis in inference.hypotheses:
        for _, part in aligned(tree, hypothesis):
            assert all(family_of(symbol) != banned for symbol in (*part.symbols, *part.probabilities))


@pairs
@texts
def test_every_phrase_has_symbols_of_its_kept_kinds_only(restricted, plain, text):
    tree = from_brackets(text)[0]
    learned = factors().first_pass
    needs = Restriction(learned).needs(tree, layout())
    for hypothesis in restricted(factors()).infer(tree, layout()).hypotheses:
        for phrase, part in aligned(tree, hypothesis):
            kept = needs[id(phrase)].kept | set(KINDS).difference(learned.kinds)
            assert {family_of(symbol) for symbol in (*part.symbols, *part.probabilities)} <= kept


@pairs
def test_nothing_kept_is_nothing_found(restricted, plain):
    never = first_pass(0.5, **dict.fromkeys(KINDS, -5.0))
    tree = from_brackets(TREES[2])[0]
    inference = restricted(factors(), first_pass=never).infer(tree, layout())
    assert inference.symbols == 0
    assert [part.symbols for _, part in aligned(tree, inference.hypotheses[0])] == [frozenset()] * 4


@pairs
def test_kinds_without_a_factor_are_kept(restricted, plain):
    knows_one = FirstPass(Factor(("bias",), ("container",), np.array([[1.0]])), 0.5)
    tree = from_brackets(TREES[0])[0]
    ours = restricted(factors(), first_pass=knows_one).infer(tree, layout())
    assert plain_hypotheses(ours) == plain_hypotheses(plain(factors()).infer(tree, layout()))


@pairs
def test_weights_without_a_first_pass_are_refused_in_words(restricted, plain):
    with pytest.raises(ModelError, match=r"no first pass.*--first-pass-only"):
        restricted(replace(factors(), first_pass=None))
    assert plain(replace(factors(), first_pass=None)).infer(from_brackets(TREES[0])[0], layout()).hypotheses


@pairs
def test_less_is_searched(restricted, plain):
    tree = from_brackets(TREES[1])[0]
    assert restricted(factors()).infer(tree, layout()).symbols < plain(factors()).infer(tree, layout()).symbols


def test_a_higher_threshold_keeps_no_more():
    tree = from_brackets(UNHEARD)[0]
    learned = [replace(factors().first_pass, threshold=t) for t in (0.0, 0.01, 0.1, 0.5, 0.9)]
    kept = [[needs.kept for needs in Restriction(one).needs(tree, layout()).values()] for one in learned]
    for more, fewer in itertools.pairwise(kept):
        assert all(b <= a for a, b in zip(more, fewer, strict=True))


@pytest.mark.parametrize("threshold", [-0.1, 1.0, 2.0, float("nan")])
def test_a_threshold_is_a_probability(threshold):
    with pytest.raises(ValueError, match="probability"):
        first_pass(threshold)


@pairs
def test_the_first_pass_is_remembered(restricted, plain):
    memory = {}
    engine = restricted(factors())
    tree = from_brackets(TREES[2])[0]
    first, again = (engine.infer(tree, layout(), memory) for _ in range(2))
    assert plain_hypotheses(first) == plain_hypotheses(again)
    assert first.evaluations > again.evaluations == 0

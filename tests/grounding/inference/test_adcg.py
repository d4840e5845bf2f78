"""Adaptive inference with the shipped factors: the same answer every time, and a wider beam keeps the best."""

import functools

import pytest

import models
from grounding.factors import load_model
from grounding.features import family_of
from grounding.geometry.layout import Layout
from grounding.inference import Adcg
from grounding.language.parser import Parser
from grounding.learning.evaluation import aligned
from grounding.world import World, load_world

TEXTS = (
    "pick up the middle block in the row of five blocks on the right",
    "take the farthest block in the column of three blocks on the left",
    "put the nearest block to the left of the farthest block",
    "clear the two blocks on the right",
    "the block behind it",
    "colorless green ideas sleep",
)


@functools.cache
def factors():
    return load_model(models.WEIGHTS)


@functools.cache
def layout_of(name):
    return Layout(load_world(models.SCENES / f"{name}.json"))


@functools.cache
def trees(text):
    return [parse.tree for parse in Parser.load().parse(text, 2)]


def plain(inference):
    return [(h.symbols, h.log_probability, dict(h.probabilities), h.children) for h in inference.hypotheses]


@pytest.mark.parametrize("text", TEXTS)
def test_the_same_answer_every_time(text):
    for tree in trees(text):
        first, second = (Adcg(factors()).infer(tree, Layout(layout_of("seven").world)) for _ in range(2))
        assert plain(first) == plain(second)
        assert (first.evaluations, first.symbols) == (second.evaluations, second.symbols)


@pytest.mark.parametrize("text", TEXTS)
def test_hypotheses_are_ordered_whole_and_different(text):
    for tree in trees(text):
        for beam in (1, 4):
            inference = Adcg(factors(), beam=beam).infer(tree, layout_of("default"))
            assert inference.tree is tree
            assert 1 <= len(inference.hypotheses) <= beam
            logs = [h.log_probability for h in inference.hypotheses]
            assert logs == sorted(logs, reverse=True)
            assert logs[0] <= 1e-9
            assert len({h.symbols for h in inference.hypotheses}) == len(inference.hypotheses)
            for hypothesis in inference.hypotheses:
                for phrase, part in aligned(tree, hypothesis):
                    assert len(part.children) == len(phrase.phrases)
                    assert all(0 <= p <= 1 for p in part.probabilities.values())
                    assert all(family_of(symbol) in factors().factors for symbol in part.symbols)


@pytest.mark.parametrize("text", TEXTS[:4])
def test_a_wider_beam_finds_nothing_less_likely(text):
    for tree in trees(text):
        best = [
            Adcg(factors(), beam=beam).infer(tree, layout_of("default")).hypotheses[0].log_probability
            for beam in (1, 4)
        ]
        assert best[0] <= best[1] + 1e-9


@pytest.mark.parametrize("text", TEXTS[:2])
def test_where_all_is_clear_the_beam_does_not_matter(text):
    tree = trees(text)[0]
    first, wide = (Adcg(factors(), beam=beam).infer(tree, layout_of("default")).hypotheses[0] for beam in (1, 4))
    assert first.symbols == wide.symbols


def test_memory_changes_nothing():
    text = TEXTS[0]
    memory = {}
    inference = Adcg(factors())
    for tree in trees(text):
        alone = inference.infer(tree, layout_of("default"))
        shared = inference.infer(tree, layout_of("default"), memory)
        again = inference.infer(tree, layout_of("default"), memory)
        assert plain(alone) == plain(shared) == plain(again)
        assert again.evaluations == 0


@pytest.mark.parametrize("text", TEXTS)
def test_an_empty_world(text):
    for tree in trees(text):
        for hypothesis in Adcg(factors()).infer(tree, Layout(World(()))).hypotheses:
            assert not any(getattr(symbol, "objects", ()) for symbol in hypothesis.symbols)

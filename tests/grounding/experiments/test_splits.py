"""Splits: the same from the same seed, paired over methods and holdouts, whole worlds kept together."""

import pytest
from hypothesis import given
from hypothesis import strategies as st
from tiny_corpus import tiny

from grounding.corpus.format import Corpus
from grounding.experiments import ExperimentError
from grounding.experiments.splits import layout_key, make_splits, parse_holdouts, world_numbers


@given(st.sampled_from(["random", "worlds"]), st.sampled_from([0.34, 0.5, 0.7]), st.integers(0, 9))
def test_every_example_is_on_one_side(by, holdout, seed):
    for split in make_splits(tiny(), by, [holdout], 3, seed):
        assert sorted(split.train + split.test) == list(range(len(tiny())))
        assert split.train
        assert split.test


def test_random_splits_hold_out_the_share_that_is_asked_for():
    (split,) = make_splits(tiny(), "random", [0.5], 1, 0)
    assert len(split.test) == round(0.5 * len(tiny()))


def test_the_same_seed_gives_the_same_splits_and_more_of_them_leave_the_first():
    few, many = (make_splits(tiny(), "random", [0.3, 0.6], count, 7) for count in (2, 5))
    assert few[:2] == many[:2]
    assert few[2:] == many[5:7]
    assert few != make_splits(tiny(), "random", [0.3, 0.6], 2, 8)
    assert len({split.name for split in many}) == len(many)


def test_what_is_held_out_at_a_small_share_is_at_a_larger_one():
    small, large = make_splits(tiny(), "random", [0.2, 0.6], 1, 0)
    assert set(small.test) < set(large.test)


def test_worlds_are_never_on_both_sides():
    numbers = world_numbers(tiny())
    for split in make_splits(tiny(), "worlds", [0.34, 0.67], 4, 0):
        assert not {numbers[i] for i in split.train} & {numbers[i] for i in split.test}


def test_worlds_are_told_apart_by_what_lies_where():
    corpus = tiny()
    twice = {**corpus.worlds, "copy": corpus.worlds["four"].with_objects(corpus.worlds["four"].objects[::-1])}
    assert layout_key(twice["copy"]) == layout_key(twice["four"])
    renamed = Corpus((*corpus.examples[:1], *corpus.examples), twice)
    assert len(set(world_numbers(renamed))) == 3


def test_nothing_left_on_one_side_is_refused():
    with pytest.raises(ExperimentError, match="3 worlds leaves nothing"):
        make_splits(tiny(), "worlds", [0.1], 1, 0)


def test_holdouts_are_read():
    paper = parse_holdouts("0.2:0.8:0.05")
    assert len(paper) == 13
    assert (paper[0], paper[6], paper[-1]) == (0.2, 0.5, 0.8)
    assert parse_holdouts("0.2,0.5") == (0.2, 0.5)
    assert parse_holdouts("0.4") == (0.4,)


@pytest.mark.parametrize("text", ["", "a", "0.2:0.8", "0.8:0.2:0.1", "0.2:0.8:0", "0,0.5", "1", "0.2:1.4:0.1"])
def test_holdouts_that_make_no_sense_are_refused(text):
    with pytest.raises(ValueError, match=r"share|range"):
        parse_holdouts(text)

"""The first pass as it is learned: it keeps what held-out wordings need, and it is the same every time."""

import functools
from dataclasses import replace

import numpy as np
import pytest

from grounding.corpus.loading import load_corpus
from grounding.features import FAMILIES, family_of
from grounding.geometry.layout import Layout
from grounding.inference.first_pass import Restriction
from grounding.learning import learn_first_pass
from grounding.learning.examples import annotated
from grounding.learning.first_pass import KINDS, count_kept, needed, share_kept


@functools.cache
def treebank():
    """Every fourth example of the treebank."""
    corpus = load_corpus(None)
    layouts = {name: Layout(world) for name, world in corpus.worlds.items()}
    return tuple(annotated(e.tree, e.groundings, layouts[e.world]) for e in corpus.examples[::4] if not e.history)


@functools.cache
def parted():
    """Learned from four fifths of the wordings, and the others."""
    texts = sorted({tree.text for tree, _, _ in treebank()})
    out = set(texts[::5])
    held = [example for example in treebank() if example[0].text in out]
    return learn_first_pass([example for example in treebank() if example[0].text not in out]), held


def test_what_held_out_wordings_need_is_kept():
    learned, held = parted()
    assert len(held) > 50
    assert share_kept(learned, held) >= 0.99


def test_most_kinds_are_not_kept():
    learned, held = parted()
    restriction = Restriction(learned)
    kept = [len(needs.kept) for tree, _, layout in held for needs in restriction.needs(tree, layout).values()]
    assert np.mean(kept) < 0.5 * len(FAMILIES)


def test_counts_add_up_to_the_share():
    learned, held = parted()
    counts = [count_kept(Restriction(learned), example) for example in held]
    assert all(0 <= found <= total for found, total in counts)
    assert sum(a for a, _ in counts) / sum(b for _, b in counts) == pytest.approx(share_kept(learned, held))
    assert share_kept(replace(learned, threshold=0.0), held) == 1
    assert share_kept(learned, []) == 1


def test_the_same_every_time():
    first, second = (learn_first_pass(treebank()[:60]) for _ in range(2))
    assert (first.threshold, first.factor.facts, first.kinds) == (second.threshold, second.factor.facts, second.kinds)
    assert np.array_equal(first.factor.weights, second.factor.weights)


def test_more_is_kept_where_more_is_asked_for():
    some, most = (learn_first_pass(treebank()[:100], kept=share) for share in (0.9, 0.999))
    assert 0 < most.threshold <= some.threshold < 1


def test_kinds_are_those_of_the_families():
    assert tuple(family.name for family in FAMILIES) == KINDS
    tree, groundings, _ = treebank()[0]
    for phrase in tree.preorder():
        assert set(needed(groundings[id(phrase)])) == {family_of(symbol) for symbol in groundings[id(phrase)]}


def test_one_wording_or_none_is_learned_from():
    for examples in (treebank()[:1], ()):
        learned = learn_first_pass(examples)
        assert share_kept(learned, treebank()[:1]) <= 1

"""Checks of corpora: composed worlds pass, and each kind of fault is found where it is."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from grounding.corpus import Corpus, Example
from grounding.corpus.check import CHECKS, check_corpus
from grounding.corpus.composer import compose
from grounding.corpus.shapes import circle_deviation, line_fit, misfit
from grounding.language.tree import from_brackets
from grounding.symbols import parse_symbols
from grounding.world import World, make_object


def blocks(*places):
    return [make_object(f"b{n}", position=place) for n, place in enumerate(places)]


WORLD = World(tuple(blocks((0.5, 0.0, 0.736), (0.5, 0.1, 0.736), (0.5, 0.2, 0.736), (0.5, 0.2, 0.786))))


def example(name, tree, instruction=None, world="w"):
    root, notes = from_brackets(tree)
    return Example(name, world, instruction or root.text, root, tuple(parse_symbols(note) for note in notes))


def findings(*examples):
    return [(f.check, f.example, f.phrase) for f in check_corpus(Corpus(examples, {"w": WORLD}))]


def test_a_sound_corpus_has_no_findings():
    assert findings(
        example("a", "(NP {container(row; b0 b1 b2)} (DT the) (NN line))", "The line!"),
        example("b", "(NP {container(tower; b2 b3)} (DT the) (NN pile))"),
    ) == []  # fmt: skip


def test_unknown_objects_and_worlds():
    assert (
        findings(example("a", "(NP {object(b9) region(left, object; b8)} (NN cube))")) == [("objects", "a", "cube")] * 2
    )
    assert findings(example("a", "(NP (NN cube))", world="v")) == [("objects", "a", None)]


@pytest.mark.parametrize("text", ["that cube", "the cube there", "the", "the the cube", "   "])
def test_words_that_differ(text):
    assert findings(example("a", "(NP (DT the) (NN cube))", text)) == [("words", "a", None)]


def test_the_minority_disagrees():
    phrase = "(PP (IN by) (NP {{object({})}} (DT the) (NN cube)))"
    examples = [example(name, phrase.format(name)) for name in ("b1",)]
    examples += [example(name, phrase.format("b2")) for name in ("c", "d")]
    assert findings(*examples) == [("agreement", "b1", "the cube")]
    assert findings(*examples[1:]) == []


@pytest.mark.parametrize(
    "container",
    ["row; b0", "column; b0 b1 b2", "tower; b0 b1", "tower; b0 b3", "circle; b0 b1 b2", "robot; b0", "group; b1"],
)
def test_containers_that_are_none(container):
    assert findings(example("a", f"(NP {{container({container})}} (NN lot))")) == [("containers", "a", "lot")]


def test_a_kind_alone_claims_nothing():
    assert findings(example("a", "(NP {container(circle)} (NN ring))")) == []


def test_every_check_says_what_it_checks():
    assert all(check.__doc__ for check in CHECKS.values())


@given(st.integers(0, 10_000), st.floats(-3, 3), st.floats(-1, 1), st.floats(-1, 1))
def test_fits_do_not_depend_on_where_things_lie(seed, turn, x, y):
    points = compose(np.random.default_rng(seed), 7).world.positions[:, :2]
    rotation = np.array([[np.cos(turn), -np.sin(turn)], [np.sin(turn), np.cos(turn)]])
    moved = points @ rotation.T + (x, y)
    assert line_fit(moved)[0] == pytest.approx(line_fit(points)[0], abs=1e-9)
    assert circle_deviation(moved) == pytest.approx(circle_deviation(points), abs=1e-6)


@given(st.integers(4, 12), st.floats(0.05, 0.5), st.floats(0, 6))
def test_rings_are_round_and_lines_are_not(count, radius, start):
    angles = start + 2 * np.pi * np.arange(count) / count
    ring = blocks(*[(radius * np.cos(a), radius * np.sin(a), 0.0) for a in angles])
    line = blocks(*[(0.0, 0.1 * n, 0.0) for n in range(count)])
    assert misfit("circle", ring) is None
    assert misfit("row", line) is None
    assert misfit("column", line) is not None

"""Phrase trees: brackets are written and read, walks meet every phrase once, other texts are refused."""

import re

import pytest
from hypothesis import given
from hypothesis import strategies as st

from grounding.errors import TreeError
from grounding.language.tree import Phrase, Word, from_brackets, to_brackets

texts = st.text(st.characters(codec="utf-8", categories=("L", "N")), min_size=1, max_size=6)
notes = st.text(st.characters(codec="utf-8", categories=("L", "N", "P"), exclude_characters="(){}"), max_size=8)


@st.composite
def trees(draw, depth=3):
    count = 0

    def phrase(left):
        nonlocal count
        children = []
        for _ in range(draw(st.integers(1, 3))):
            if left and draw(st.booleans()):
                children.append(phrase(left - 1))
            else:
                children.append(Word(draw(texts), draw(st.sampled_from(("NN", "DT", "VB"))), count))
                count += 1
        return Phrase(draw(st.sampled_from(("NP", "PP", "VP"))), tuple(children))

    return phrase(depth)


@given(trees())
def test_brackets_are_read_back(tree):
    again, notes_ = from_brackets(to_brackets(tree))
    assert again == tree
    assert set(notes_) == {""}


@given(trees(), st.lists(notes, min_size=1, max_size=5))
def test_annotations_belong_to_their_phrases(tree, texts_):
    given_ = {id(phrase): texts_[i % len(texts_)].strip() for i, phrase in enumerate(tree.preorder())}
    again, read = from_brackets(to_brackets(tree, lambda phrase: given_[id(phrase)]))
    assert again == tree
    assert list(read) == [given_[id(phrase)] for phrase in tree.preorder()]


@given(trees())
def test_walks_meet_every_phrase_once(tree):
    down, up = list(tree.preorder()), list(tree.postorder())
    assert sorted(map(id, down)) == sorted(map(id, up))
    assert down[0] is up[-1] is tree
    place = {id(phrase): i for i, phrase in enumerate(up)}
    assert all(place[id(child)] < place[id(phrase)] for phrase in down for child in phrase.phrases)


@given(trees())
def test_leaves_are_the_sentence(tree):
    assert [leaf.index for leaf in tree.leaves] == list(range(len(tree.leaves)))
    assert tree.text.split(" ") == [leaf.text for leaf in tree.leaves]


@pytest.mark.parametrize(
    ("text", "says"),
    [
        ("", "ends too early"), ("(NP (DT the)", "ends too early"), ("(NP)", "no children"),
        ("(NP {x})", "no children"),
        ("NP", "expected '('"), ("(NN block)", "not a single word"), ("(NP (NN block)) (NP (NN a))", "text after"),
        ("((NN a))", "expected a tag"), ("(NP (NN a b))", "expected ')'"), ("(NP (NN a)) }", "unreadable"),
        ("(NP {a (NN b))", "unreadable"),
    ],
)  # fmt: skip
def test_other_texts_are_refused(text, says):
    with pytest.raises(TreeError, match=re.escape(says)):
        from_brackets(text)

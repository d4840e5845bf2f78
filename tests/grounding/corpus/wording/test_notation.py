"""The notation of productions."""

import pytest

from grounding.corpus.wording.notation import Branch, Leaf, Slot, read_productions
from grounding.errors import CorpusError


def test_leaves_phrases_and_slots():
    table = read_productions("[a]\none 2.5 @deep @color : (NP the <b>?.25 left|right/NN)\n", "# b\n[b]\nx 1 : red\n")
    (production,) = table["a"]
    assert (production.name, production.weight, production.marks) == ("a.one", 2.5, {"deep", "color"})
    the, slot, side = production.parts[0].parts
    assert production.parts[0] == Branch("NP", (the, slot, side))
    assert the == Leaf((("the", "DT"),))
    assert slot == Slot("b", 0.25)
    assert side == Leaf((("left", "NN"), ("right", "NN")))
    assert list(production.slots()) == [slot]


def test_a_tag_is_for_its_word_and_those_before_it():
    table = read_productions("[a]\none 1 : near|close/JJ|behind\n")
    assert table["a"][0].parts == (Leaf((("near", "JJ"), ("close", "JJ"), ("behind", "IN"))),)


@pytest.mark.parametrize(
    ("text", "complaint"),
    [
        ("[a]\none 1 : (NP the", "open"),
        ("[a]\none 1 : the)", "not open"),
        ("[a]\none 1 : <b>", "no symbol 'b'"),
        ("[a]\none 1 : blorb", "usual tag"),
        ("[a]\none 1 : the\none 1 : a", "twice"),
        ("[a]\none 1 : the\n[a]\n", "two sections"),
        ("one 1 : the", "expected a production"),
        ("[a]\none : the", "expected a production"),
    ],
)
def test_mistakes_are_named(text, complaint):
    with pytest.raises(CorpusError, match=complaint):
        read_productions(text)

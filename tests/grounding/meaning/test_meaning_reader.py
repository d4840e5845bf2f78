"""The reader of noun phrases: sorts, numbers and contexts."""

import pytest

from grounding.language.tree import from_brackets
from grounding.meaning.notation import write_referent
from grounding.meaning.reader import Reader
from grounding.meaning.reading import Context
from grounding.meaning.referents import CHOOSING, RANKING, RESTRICTING, Condition, Referent, again

RED = "(NP (DT the) (JJ red) (NN block))"
ROW = "(NP (DT the) (NN row))"


def read(brackets, context=None):
    return Reader(context).phrase(from_brackets(brackets)[0])


@pytest.mark.parametrize(
    ("brackets", "lines"),
    [
        (RED, ["is objects", "colour red", "kind block"]),
        ("(NP (DT a) (JJ green) (NN block))", ["is objects indefinite", "colour green", "kind block"]),
        ("(NP (DT all) (JJ red) (NNS blocks))", ["is sets plural all", "colour red", "kind block"]),
        ("(NP (DT the) (JJ only) (JJ red) (NN block))", ["is objects only", "colour red", "kind block"]),
        ("(NP (DT the) (JJ third) (JJ red) (NN block))", ["is objects", "colour red", "kind block", "ordinal rank 3"]),
        ("(NP (DT the) (JJ green) (NN prism))", ["is objects", "colour green", "kind pyramid"]),
        ("(NP (DT the) (JJ middle) (NN block))", ["is objects", "kind block", "middle"]),
        ("(NP (DT the) (JJS tallest) (NN tower))", ["is sets tower", "size amount 1"]),
        ("(NP (DT the) (JJ second) (NN row))", ["is sets row", "ordinal rank 2"]),
        ("(NP (NP (DT the) (NN row)) (PP (IN of) (NP (CD five) (JJ red) (NNS blocks))))",
         ["is sets row number 5", "colour red", "kind block"]),
        (f"(NP {ROW} (CC and) (NP (DT the) (NN column)))", ["is sets number 2 crossing parts x2 and x3"]),
        (f"(NP {RED} (CC and) (NP (DT the) (JJ blue) (NN block)))", ["is sets number 2 plural parts x2 and x3"]),
        ("(NP (PRP you))", ["is person robot"]),
        ("(NP (DT the) (NN table))", ["is table"]),
        ("(NP (DT the) (JJ back) (JJ left) (NN corner))", ["is place back left corner"]),
        (f"(NP (NP (DT the) (NN end)) (PP (IN of) {ROW}))", ["is objects place edge", "part edge of x2"]),
        ("(NP (DT the) (NN wug))", ["is nothing"]),
        ("(NP (PRP it))", ["is nothing"]),
    ],
)  # fmt: skip
def test_a_noun_phrase_is_a_referent(brackets, lines):
    told = [line for line in write_referent(read(brackets)).splitlines() if line.startswith("x1 ")]
    assert [line.removeprefix("x1 ").partition(' said "')[0] for line in told] == lines


def test_it_is_what_was_mentioned():
    mentioned = read(RED)
    found = read("(NP (PRP it))", Context(mentioned))
    assert found.conditions[0].concept == "same"
    assert found.conditions[0].of == (mentioned,)


def test_it_is_what_was_handled_where_nothing_was_mentioned():
    assert read("(NP (PRP it))", Context(handled=True)).conditions[0].concept == "recalled"


@pytest.mark.parametrize("text", ["(NP (DT the) (CD two))", "(NP (DT those) (NNS blocks))"])
def test_bare_plurals_point_back_to_several(text):
    mentioned = read(ROW)
    (those,) = read(text, Context(mentioned, several=True)).conditions
    assert (those.concept, those.of) == ("those", (mentioned,))
    assert all(condition.concept != "those" for condition in read(text).conditions)


def test_others_are_not_what_was_mentioned():
    mentioned = read(RED)
    other = next(c for c in read("(NP (DT the) (JJ other) (NN one))", Context(mentioned)).conditions)
    assert other.concept == "other"
    assert other.of[0].conditions[0].of == (mentioned,)


def test_a_context_ends():
    reader = Reader()
    with reader.within(read(RED), several=True):
        assert reader.context.several
    assert reader.context == Context()


def test_every_concept_is_of_one_kind_and_what_is_denied_restricts():
    assert not RESTRICTING & CHOOSING | RESTRICTING & RANKING | CHOOSING & RANKING
    for concept in RESTRICTING | CHOOSING | RANKING:
        plain, denied = Condition(concept), Condition(concept, negated=True)
        assert plain.restricts + plain.chooses + plain.ranks == 1
        assert denied.restricts
        assert not denied.chooses
        assert not denied.ranks


def test_referents_are_told_apart_by_identity():
    one, other = Referent("objects"), Referent("objects")
    assert one != other
    assert len({one, other}) == 2
    assert next(iter(again(one).all())) is one

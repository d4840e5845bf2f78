import pytest

from grounding.language.parser import Parser
from grounding.language.possessives import unfold
from grounding.language.tree import from_brackets


def unfolded(text):
    return unfold(from_brackets(text)[0]).text


@pytest.mark.parametrize(
    ("tree", "text"),
    [
        ("(NP (POSP (NP (DT the) (NN ring)) (POS 's)) (NN middle))", "the middle of the ring"),
        ("(NP (NP (POSP (NP (DT the) (NN row)) (POS 's)) (JJ last) (NN cube)) (PP (IN on) (NP (DT the) (NN table))))",
         "the last cube of the row on the table"),
        ("(NP (NP (DT the) (JJ left) (NN neighbor)) (PP (IN of) (NP (PRP it))))", "the block left of it"),
        ("(NP (PRP$ its) (JJ right) (NN neighbor))", "the block right of it"),
        ("(NP (NP (DT the) (JJS nearest) (NN neighbor)) (PP (IN of) (NP (DT the) (NN tower))))",
         "the block nearest to the tower"),
        ("(NP (NP (POSP (NP (DT the) (NN tower)) (POS 's)) (NN neighbor)) (PP (IN on) (NP (DT the) (NN left))))",
         "the block on the left of the tower"),
        ("(NP (CONJP (RB not) (NP (DT the) (JJ red) (NN one)) (CC but) (NP (NP (DT the) (NN one)) "
         "(PP (IN behind) (NP (PRP it))))))", "the one behind the red one"),
        ("(NP (DT a) (JJ far) (JJ left) (NN corner) (NN brick))", "a brick in the far left corner"),
        ("(NP (NP (DT the) (NN end) (NN block)) (PP (IN of) (NP (DT the) (NN row))))",
         "the block at the end of the row"),
    ],
)  # fmt: skip
def test_readers_meet_the_plain_form(tree, text):
    assert unfolded(tree) == text


def test_other_trees_stay_as_they_are():
    tree = from_brackets("(VP (VB take) (NP (NP (DT the) (NN end)) (PP (IN of) (NP (DT the) (NN row)))))")[0]
    assert unfold(tree) is tree


def test_the_shipped_grammar_knows_who_owns_what():
    parse = Parser.load().parse("lift the green cube's left neighbour")[0]
    assert parse.tree.text == "lift the block left of the green cube"
    assert not parse.unknown_words
    assert parse.complete
    assert sorted({leaf.index for leaf in parse.tree.leaves}) == [0, 1, 2, 3, 4, 5, 6]
    assert parse.tree.span == (0, 6)

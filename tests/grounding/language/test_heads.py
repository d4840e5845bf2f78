import pytest

from grounding.language.heads import BASE_NP, head_index, plain_tag, refined_tag
from grounding.language.tree import from_brackets


@pytest.mark.parametrize(
    ("brackets", "head"),
    [
        ("(NP (DT the) (JJ red) (NN block))", "block"),
        ("(NP (NP (DT the) (NN row)) (PP (IN of) (NP (NNS blocks))))", "the row"),
        ("(NP (DT the) (JJS closest))", "closest"),
        ("(PP (RB just) (IN in) (NP (NN front)))", "in"),
        ("(PP (JJS closest) (IN to) (NP (DT the) (NN robot)))", "closest"),
        ("(VP (UH please) (VB put) (NP (PRP it)) (PRT (RP down)))", "put"),
        ("(S (MD could) (NP (PRP you)) (VP (VB take) (NP (PRP it))))", "take it"),
        ("(X (Y (A a)) (Z (B b)))", "a"),
    ],
)
def test_heads(brackets: str, head: str) -> None:
    phrase, _ = from_brackets(brackets)
    child = phrase.children[head_index(phrase.tag, phrase.children)]
    assert child.text == head


def test_noun_phrases_without_phrases_are_set_apart_and_come_back() -> None:
    base, _ = from_brackets("(NP (DT the) (NN row))")
    nested, _ = from_brackets("(NP (NP (DT the) (NN row)) (PP (IN of) (NP (CD five))))")
    assert refined_tag(base) == BASE_NP
    assert refined_tag(nested) == "NP"
    assert plain_tag(refined_tag(base)) == plain_tag(refined_tag(nested)) == "NP"

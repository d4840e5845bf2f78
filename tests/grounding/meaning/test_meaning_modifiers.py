"""Modifiers: each construction says the condition that is expected, as a line of the notation."""

import pytest

from grounding.language.tree import from_brackets
from grounding.meaning.notation import lines
from grounding.meaning.reader import Reader

TOWER = "(NP (DT the) (NN tower))"
RED = "(NP (DT the) (JJ red) (NN block))"
SAID = [
    # directions
    (f"(PP (JJ left) (IN of) {TOWER})", ["toward left of x2"]),
    (f"(PP (JJ right) (IN of) {TOWER})", ["toward right of x2"]),
    (f"(PP (RB directly) (IN behind) {TOWER})", ["toward back of x2 strictly"]),
    (f"(PP (RB right) (IN behind) {TOWER})", ["toward back of x2 strictly"]),
    (f"(PP (IN to) (NP (NP (DT the) (NN left)) (PP (IN of) {TOWER})))", ["toward left of x2"]),
    (f"(PP (PP (IN above)) (CC and) (PP (IN to) (NP (NP (DT the) (NN left)) (PP (IN of) {RED}))))",
     ["toward up left of x2"]),
    ("(PP (JJ left) (IN of) (NP (DT the) (NN center)))", ["off_middle left"]),
    (f"(PP (NP (CD two) (NNS spaces)) (JJ left) (IN of) {TOWER})", ["measured left of x2 amount 2"]),
    (f"(PP (NP (CD two) (NNS blocks)) (IN behind) {TOWER})", ["measured back of x2 amount 2 counted"]),
    (f"(PP (PP (NP (CD two) (NNS spaces)) (IN up)) (CC and) (PP (NP (NN one)) (JJ left) (IN of) {TOWER}))",
     ["stepped of x2 ways up 2 and left 1"]),
    ("(PP (IN in) (NP (NP (NN front)) (PP (IN of) (NP (PRP you)))))", ["before front of x2"]),
    (f"(SBAR (WHNP (WDT that)) (S (VP (VBZ has) {RED} (PP (IN to) (NP (PRP$ its) (NN left))))))",
     ["toward right of x2"]),
    ("(PP (IN with) (NP (NP (DT a) (JJ red) (NN block)) (PP (IN to) (NP (PRP$ its) (NN right)))))",
     ["toward left of x2"]),
    ("(PP (IN of) (NP (CD nine) (NNS blocks)))", ["member of x2"]),
    # nearness, contact, support, between
    (f"(PP (JJ next) (IN to) {TOWER})", ["beside x2"]),
    (f"(PP (VBG touching) {TOWER})", ["touching x2"]),
    (f"(PP (RB almost) (PP (VBG touching) {TOWER}))", ["touching x2 nearly"]),
    (f"(PP (IN on) {RED})", ["on x2"]),
    ("(PP (IN on) (NP (DT the) (NN table)))", ["on_table"]),
    ("(PP (IN between) (NP (DT the) (NNS towers)))", ["between x2"]),
    (f"(PP (IN between) (NP {TOWER} (CC and) {RED}))", ["between x2 and x3"]),
    ("(PP (VBN surrounded) (IN by) (NP (CD three) (JJ red) (NNS blocks)))", ["surrounded by x2"]),
    ("(PP (IN outside) (NP (DT the) (NN circle)))", ["outside x2"]),
    (f"(PP (VBN separated) (IN from) {TOWER})", ["apart from x2"]),
    ("(PP (VBN separated) (IN from) (NP (DT the) (NNS others)))", ["apart_others"]),
    ("(PP (IN with) (NP (DT the) (JJ other) (JJ red) (NNS ones)))", ["with_others red"]),
    ("(PP (IN by) (NP (PRP itself)))", ["alone"]),
    # ranks
    (f"(PP (JJS closest) (IN to) {TOWER})", ["nearest to x2"]),
    (f"(PP (JJS farthest) (IN from) {RED})", ["farthest from x2"]),
    ("(PP (JJS farthest) (IN to) (NP (DT the) (NN left)))", ["nearest to x2"]),
    (f"(PP (JJ second) (JJS closest) (IN to) {TOWER})", ["nearest to x2 rank 2"]),
    ("(PP (IN from) (NP (DT the) (NN left)))", ["extreme left"]),
    ("(PP (JJ third) (IN from) (NP (DT the) (NN left)))", ["extreme left rank 3"]),
    # places, members, parts
    ("(PP (IN on) (NP (DT the) (NN left)))", ["at left"]),
    ("(PP (IN on) (NP (PRP$ my) (NN left)))", ["at left of speaker"]),
    ("(PP (IN on) (NP (NP (DT the) (JJ left) (NN side)) (PP (IN of) (NP (DT the) (NN table)))))",
     ["at left side of the table"]),
    ("(PP (IN in) (NP (DT the) (JJ back) (JJ left) (NN corner)))", ["at back left corner"]),
    ("(PP (IN in) (NP (NP (DT the) (NN middle)) (PP (IN of) (NP (DT the) (NN table)))))", ["at middle of the table"]),
    (f"(PP (IN in) (NP (NP (DT the) (NN middle)) (PP (IN of) {TOWER})))", ["centre of x2 and x4"]),
    (f"(PP (IN at) (NP (NP (DT the) (NN top)) (PP (IN of) {TOWER})))", ["same as x2"]),
    (f"(PP (IN in) {TOWER})", ["member of x2"]),
    (f"(PP (IN of) {RED})", ["among of x2"]),
    # denials and predicates
    ("(SBAR (WHNP (WDT that)) (S (VP (VBZ is) (ADJP (JJ red)))))", ["colour red"]),
    ("(SBAR (WHNP (WDT that)) (S (VP (VBZ is) (ADJP (RB not) (JJ red)))))", ["not colour red"]),
    (f"(SBAR (WHNP (WDT that)) (S (VP (VBZ is) (RB not) (PP (IN in) {TOWER}))))", ["not member of x2"]),
    (f"(SBAR (WHNP (WDT that)) (S (VP (VBZ is) (NP (NP (DT the) (JJS closest) (NN one)) (PP (IN to) {TOWER})))))",
     ["nearest to x2"]),
    # what says nothing of the thing
    ("(PP (IN from) (NP (PRP$ your) (NN perspective)))", []),
]  # fmt: skip


def said(modifier):
    """What a modifier says of a block, without the words for it."""
    phrase = from_brackets(f"(NP (NP (DT the) (NN thing)) {modifier})")[0]
    told = (line for line in lines(Reader().phrase(phrase)) if line.name == "x1" and line.condition is not None)
    return [line.text.removeprefix("x1 ").partition(" said ")[0] for line in told]


def mirrored(text):
    return text.replace("left", "\0").replace("right", "left").replace("\0", "right")


@pytest.mark.parametrize(("modifier", "expected"), SAID)
def test_a_modifier_says_its_condition(modifier, expected):
    assert said(modifier) == expected


@pytest.mark.parametrize(("modifier", "expected"), [pair for pair in SAID if "(RB right)" not in pair[0]])
def test_a_mirrored_modifier_says_the_mirrored_condition(modifier, expected):
    assert said(mirrored(modifier)) == [mirrored(text) for text in expected]

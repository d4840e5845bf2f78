"""Annotation of what people say beyond plain commands: viewpoints, corners, contact, clauses, several sentences."""

import math

import numpy as np
import pytest

from grounding.corpus.annotate import annotate
from grounding.corpus.meaning import NotAnnotatable
from grounding.geometry.layout import Layout
from grounding.language.tree import from_brackets
from grounding.symbols import Action, format_symbols, parse_symbols
from grounding.world import Viewpoint, World, make_object

Z = 0.736
TABLE = make_object("table", "table", "white", (0.65, 0, 0.691), size=(0.7, 1.8, 0.04))
BLOCKS = {  # three in contact on the left, three greens on the right, one alone at the back, a tower in front
    "a": ("red", 0.60, 0.50), "b": ("blue", 0.651, 0.50), "c": ("white", 0.60, 0.449),
    "g1": ("green", 0.55, -0.40), "g2": ("green", 0.66, -0.45), "g3": ("green", 0.80, -0.50),
    "far": ("yellow", 0.93, 0.12), "t1": ("blue", 0.42, 0.0), "t2": ("orange", 0.42, 0.0, Z + 0.05),
}  # fmt: skip


def layout_of(speaker=None, blocks=BLOCKS):
    objects = [make_object(n, color=c, position=(x, y, *(z or (Z,)))) for n, (c, x, y, *z) in blocks.items()]
    return Layout(World((*objects, TABLE), speaker))


ALONE = layout_of()
ACROSS = layout_of(Viewpoint(np.array([1.6, 0.0, 0.0]), math.pi))
TOWER = (("tower", ALONE.mask(("t1", "t2"))),)


def root(tree, layout=ALONE, history=()):
    """(outcome, symbols of the root) of a tree; what has no bracket is a word, tagged by what it is here."""
    groundings, outcome = annotate(from_brackets(_tagged(tree))[0], layout, TOWER, history)
    return outcome, groundings[0]


_TAGS = {
    "the": "DT", "a": "DT", "another": "DT", "that": "DT", "pick": "VB", "put": "VB", "take": "VB", "move": "VB",
    "is": "VBZ", "are": "VBP", "moves": "VBZ", "loses": "VBZ", "want": "VBP", "blocks": "NNS", "it": "PRP", "me": "PRP",
    "you": "PRP", "i": "PRP", "my": "PRP$", "your": "PRP$", "its": "PRP$", "there": "EX", "two": "CD", "three": "CD",
    "and": "CC", "closest": "JJS", "farthest": "JJS", "closer": "JJR", "up": "RP", "which": "WDT", "moved": "VBD",
    **dict.fromkeys("red green blue yellow orange white rightmost left right top middle northeast lone".split(), "JJ"),
    **dict.fromkeys("of to on in from between touching surrounded by behind".split(), "IN"),
}  # fmt: skip


def _tagged(tree):
    """`(NP the block)` with a tag for every word."""
    parts, opened = [], False
    for part in tree.replace("(", " ( ").replace(")", " ) ").split():
        if part in "()" or opened:
            parts.append(part)
        else:
            parts.append(f"({_TAGS.get(part, 'NN')} {part})")
        opened = part == "("
    return " ".join(parts).replace("( ", "(")


def objects(symbols):
    """What actions are on, or the objects where there are none."""
    acts = sorted(name for s in symbols if isinstance(s, Action) for name in s.objects)
    return acts or sorted(str(s)[7:-1] for s in symbols if str(s).startswith("object("))


GREEN = "(NP the green block)"
TREES = {
    "contact with some block": ("(NP (NP the red block) (PP touching (NP a white block)))", ["a"]),
    "contact with each": ("(NP (NP the block) (PP touching (NP (NP the white block) and (NP a blue block))))", ["a"]),
    "contact is not nearness": ("(NP (NP the white block) (PP touching (NP the red block)))", ["c"]),
    "alone": ("(NP (NP the yellow block) (PP by (NP itself)))", ["far"]),
    "lone": ("(NP the lone yellow block)", ["far"]),
    "a corner": ("(NP (NP the block) (PP in (NP the top left corner)))", ["b"]),
    "a corner's green block": ("(NP (NP the green block) (PP in (NP the top right corner)))", ["g3"]),
    "a compass corner": ("(NP (NP the green block) (PP closest to (NP the northeast corner)))", ["g3"]),
    "closest to a thing": ("(NP (NP the green block) (PP closest to (NP the tower)))", ["g1"]),
    "farthest from a thing": ("(NP (NP the green block) (PP farthest from (NP the red block)))", ["g3"]),
    "discontinuous": ("(NP (NP the closest green block) (PP to (NP the tower)))", ["g1"]),
    "of a set": (
        "(NP (NP the middle one) (PP of (NP (NP the three green blocks) (PP on (NP the right)))))", ["g2"]),
    "framed": (
        "(VP (PP of (NP the three green blocks)) pick (PRT up) (NP the closest one))", ["g1"]),
    "between two": (
        "(NP (NP the green block) (PP between (NP (NP the farthest green block) and (NP the closest green block))))",
        ["g2"]),
    "a relative clause": (
        "(NP (NP the green block) (SBAR (WHNP which) (S (VP is (PP closest to (NP you))))))", ["g1"]),
    "a predicate": (
        "(NP (NP the green block) (SBAR (WHNP which) (S (VP is (NP (NP the closest one) (PP to (NP you)))))))", ["g1"]),
    "a wish": ("(S (NP i) (VP want (NP the yellow block)))", ["far"]),
    "of a tower": ("(S (NP the tower) (VP loses (NP its top block)))", ["t2"]),
    "what is there, then one of it": (
        "(FRAG (S (NP there) (VP are (NP (NP three green blocks) (PP on (NP the right))))) "
        "(VP pick (PRT up) (NP the closest one)))", ["g1"]),
    "it": ("(FRAG (S (NP there) (VP is (NP a yellow block))) (VP pick (PRT up) (NP it)))", ["far"]),
    "said of it": (
        "(FRAG (VP pick (PRT up) (NP the blue block)) (S (NP it) (VP is (PP touching (NP the red block)))))", ["b"]),
    "one of two": ("(NP (NP the blue block) (PP closer to (NP you)))", ["t1"]),
}  # fmt: skip


@pytest.mark.parametrize("name", list(TREES))
def test_what_single_constructions_mean(name):
    tree, wanted = TREES[name]
    outcome, symbols = root(tree)
    assert (outcome, objects(symbols)) == ("grounded", wanted), format_symbols(symbols)


def test_the_speaker_across_the_table_sees_it_the_other_way_round():
    mine, yours = (
        "(NP (NP the green block) (PP closest to (NP me)))",
        "(NP (NP the green block) (PP closest to (NP you)))",
    )
    assert objects(root(mine, ACROSS)[1]) == ["g3"]
    assert objects(root(yours, ACROSS)[1]) == ["g1"] == objects(root(mine)[1])
    my_left = "(NP (NP the green block) (PP on (NP my left)))"
    assert objects(root(my_left, ACROSS)[1]) == ["g3"]
    with pytest.raises(NotAnnotatable, match="other side"):
        root(my_left.replace("my", "your"), ACROSS)


def test_places_are_destinations():
    outcome, symbols = root("(VP put (NP the yellow block) (PP in (NP the top left corner)))")
    assert outcome == "grounded"
    assert symbols == parse_symbols("action(place) action(place; far; back, object; table) region(left, object; table)")
    _, symbols = root("(VP move (NP the yellow block) (PP (NP two spaces) to (NP the left)))")
    assert symbols == parse_symbols("action(place) action(place; far; left, object; far)")
    _, symbols = root("(S (NP the yellow block) (VP moves (PP northeast of (NP the red block))))")
    assert symbols == parse_symbols("action(place) action(place; far; back, object; a) region(right, object; a)")


def test_put_it_there_after_take_that():
    tree = "(VP (VP take (NP the yellow block)) and (VP put (NP it) (PP behind (NP the red block))))"
    assert root(tree) == ("grounded", parse_symbols("action(place) action(place; far; back, object; a)"))


def test_history_says_what_it_is():
    with pytest.raises(NotAnnotatable, match="nothing was spoken of"):
        root("(VP pick (PRT up) (NP it))")
    assert objects(root("(VP pick (PRT up) (NP it))", history=("g1", "far"))[1]) == ["far"]
    moved = "(NP (NP the block) (SBAR (S (NP you) (VP moved))))"
    assert objects(root(moved, history=("g2",))[1]) == ["g2"]
    with pytest.raises(NotAnnotatable, match="nothing was moved"):
        root(moved)


@pytest.mark.parametrize(
    ("tree", "why"),
    [
        ("(NP (NP the closer green block) (PP to (NP you)))", "a comparison is of two"),
        ("(FRAG (S (NP there) (VP are (NP two green blocks))) (VP pick (PRT up) (NP the closest block)))", "not true"),
        ("(FRAG (VP pick (PRT up) (NP the yellow block)) (VP take (NP the red block)))", "two commands"),
        ("(NP (NP the yellow block) (PP on (NP the right)))", "other side"),
        ("(NP (NP the rightmost green block) (PP closest to (NP you)))", "two directions"),
        ("(S (NP it) (VP is (PP behind (NP the red block))))", "no instruction"),
    ],
)  # fmt: skip
def test_what_is_not_so_is_refused(tree, why):
    with pytest.raises(NotAnnotatable, match=why):
        root(tree)


def test_contact_that_is_too_close_to_call_is_refused():
    doubtful = layout_of(blocks={"a": ("red", 0.6, 0.5), "b": ("blue", 0.666, 0.5), "c": ("green", 0.8, 0.0)})
    with pytest.raises(NotAnnotatable, match="too close to call"):
        root("(NP (NP the blue block) (PP touching (NP the red block)))", doubtful)

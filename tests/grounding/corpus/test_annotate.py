"""Annotation: what sentences mean in a world made by hand, and that what is not clear there is refused."""

import pytest

from grounding.corpus.annotate import annotate
from grounding.corpus.meaning import NotAnnotatable
from grounding.geometry.layout import Layout
from grounding.language.tree import from_brackets
from grounding.symbols import Action, parse_symbols
from grounding.world import World, make_object

Z = 0.736
TABLE = make_object("table", "table", "white", (0.65, 0, 0.691), size=(0.7, 1.8, 0.04))
BLOCKS = {  # a row on the right, a column on the left, a tower in between, a loose block at the back
    "r1": ("red", 0.60, 0.0), "r2": ("blue", 0.61, -0.1), "r3": ("red", 0.6, -0.2), "r4": ("red", 0.62, -0.3),
    "r5": ("green", 0.6, -0.4), "c1": ("red", 0.52, 0.4), "c2": ("yellow", 0.62, 0.42), "c3": ("red", 0.72, 0.44),
    "t1": ("blue", 0.45, 0.18), "t2": ("red", 0.45, 0.18, Z + 0.05), "loose": ("purple", 0.93, 0.15),
}  # fmt: skip


def world(blocks=BLOCKS):
    objects = [make_object(n, color=c, position=(x, y, *(z or (Z,)))) for n, (c, x, y, *z) in blocks.items()]
    return World((*objects, TABLE))


LAYOUT = Layout(world())
KNOWN = tuple(
    (kind, LAYOUT.mask(names))
    for kind, names in (
        ("row", ("r1", "r2", "r3", "r4", "r5")),
        ("column", ("c1", "c2", "c3")),
        ("tower", ("t1", "t2")),
    )
)

THE = "(NP (DT the) %s)"
ROW = "(NP (NP (DT the) (NN row)) (PP (IN of) (NP (CD five) (NNS blocks))))"
COLUMN = "(NP (NP (DT the) (NN column)) (PP (IN of) (NP (CD three))))"
NEAREST = "(NP (DT the) (JJS nearest) (JJ red) (NN block))"
PURPLE = "(NP (DT the) (JJ purple) (NN block))"
GREEN = "(NP (DT the) (JJ green) (NN block))"
YELLOW = "(NP (DT the) (JJ yellow) (NN block))"


def pick(noun_phrase):
    return f"(VP (VB pick) (PRT (RP up)) {noun_phrase})"


def put(what, preposition):
    return f"(VP (VB put) {what} {preposition})"


def of(head, preposition, inner):
    return f"(NP {head} (PP (IN {preposition}) {inner}))"


def meaning(tree, layout=LAYOUT, known=KNOWN):
    """(outcome, actions) of a tree, objects and all."""
    groundings, outcome = annotate(from_brackets(tree)[0], layout, known)
    assert len(groundings) == sum(1 for _ in from_brackets(tree)[0].preorder())
    return outcome, {symbol for symbol in groundings[0] if isinstance(symbol, Action) and symbol.objects}


GROUNDED = {
    "the middle one of a row": (pick(of(THE % "(JJ middle) (NN block)", "in", ROW)), "action(pick; r3)"),
    "an extreme of the world": (pick(THE % "(JJ rightmost) (NN block)"), "action(pick; r5)"),
    "an extreme of a colour": (pick(NEAREST), "action(pick; t2)"),
    "the only one of a colour": (pick(PURPLE), "action(pick; loose)"),
    "an ordinal from a side": (
        pick(of(THE % "(JJ second) (NN block)", "from", "(NP (DT the) (NN right))")), "action(pick; r4)"),
    "the farthest of a column": (pick(of(THE % "(JJS farthest) (NN block)", "of", COLUMN)), "action(pick; c3)"),
    "what stands on a thing": (
        pick(of(THE % "(NN block)", "on", THE % "(JJ leftmost) (JJ blue) (NN block)")), "action(pick; t2)"),
    "the top of a tower": (pick(of(THE % "(JJ top) (NN block)", "of", THE % "(NN tower)")), "action(pick; t2)"),
    "a whole arrangement": ("(VP (VB clear) (NP (DT the) (NN column)))", "action(clear; c1 c2 c3)"),
    "all of a colour": ("(VP (VB clear) (NP (DT the) (JJ blue) (NNS blocks)))", "action(clear; r2 t1)"),
    "so many at a side": ("(VP (VB clear) (NP (DT the) (CD two) (JJ leftmost) (NNS blocks)))", "action(clear; c2 c3)"),
    "on a thing": (put(PURPLE, f"(PP (IN on) {GREEN})"), "action(place; loose; top, object; r5)"),
    "to the left of a thing": (
        put(PURPLE, f"(PP (IN to) {of('(NP (DT the) (NN left))', 'of', GREEN)})"),
        "action(place; loose; left, object; r5)"),
    "between two things": (
        put(PURPLE, f"(PP (IN between) (NP {GREEN} (CC and) {YELLOW}))"),
        "action(place; loose; between, object; c2 r5)"),
    "the middle as a noun": (
        pick(of(THE % "(NN block)", "in", of("(NP (DT the) (NN middle))", "of", THE % "(NN row)"))),
        "action(pick; r3)"),
}  # fmt: skip


@pytest.mark.parametrize("construction", GROUNDED)
def test_constructions(construction):
    tree, known = GROUNDED[construction]
    assert meaning(tree) == ("grounded", parse_symbols(known))


def test_what_fits_several_is_ambiguous():
    reds = {name for name, (color, *_) in BLOCKS.items() if color == "red"}
    outcome, actions = meaning(pick(THE % "(JJ red) (NN block)"))
    assert outcome == "ambiguous"
    assert actions == {Action("pick", (name,)) for name in reds}


@pytest.mark.parametrize(
    "noun_phrase",
    [THE % "(JJ white) (NN block)", THE % "(NN ball)",
     "(NP (NP (DT the) (NN row)) (PP (IN of) (NP (CD seven) (NNS blocks))))"],
)  # fmt: skip
def test_what_is_not_there_has_no_referent(noun_phrase):
    assert meaning(pick(noun_phrase)) == ("no_referent", set())


def test_parts_mean_what_they_say():
    tree = from_brackets(GROUNDED["the middle one of a row"][0])[0]
    groundings = dict(zip((p.text for p in tree.preorder()), annotate(tree, LAYOUT, KNOWN)[0], strict=True))
    assert groundings["five blocks"] >= parse_symbols("cardinal(5) type(block) collection(block, -, -, 5)")
    assert groundings["the row"] >= parse_symbols("container(row)")
    assert groundings["the row of five blocks"] >= parse_symbols("container(row; r1 r2 r3 r4 r5)")
    assert groundings["the middle block"] >= parse_symbols("spatial(center) attribute(block, -, center, 1)")
    assert groundings["the middle block in the row of five blocks"] >= parse_symbols("object(r3)")
    assert groundings["up"] == frozenset()


def test_a_near_tie_is_refused():
    layout = Layout(world({**BLOCKS, "r5b": ("green", 0.8, -0.395)}))
    with pytest.raises(NotAnnotatable, match="too close to call"):
        meaning(pick(THE % "(JJ rightmost) (NN block)"), layout, ())


@pytest.mark.parametrize(
    "tree",
    [
        put(PURPLE, ""), put(THE % "(NN block)", f"(PP (IN between) {GREEN})"),
        "(VP (VB sing) (NP (DT a) (NN block)))", "(NP (DT the) (JJ left) (JJ right) (NN block))",
        "(SQ (VB is) (NP (DT the) (NN block)))", pick("(NP (DT the) (NN frobnicator))"),
    ],
)  # fmt: skip
def test_what_is_not_covered_is_refused_by_name(tree):
    with pytest.raises(NotAnnotatable, match="'"):
        meaning(tree)


def mirrored():
    objects = [item.moved(item.position * (1, -1, 1)) for item in LAYOUT.world.objects]
    return Layout(World(tuple(objects)))


SWAPPED = {"left": "right", "right": "left", "leftmost": "rightmost", "rightmost": "leftmost"}


@pytest.mark.parametrize("construction", GROUNDED)
def test_a_mirror_swaps_left_and_right(construction):
    tree, known = GROUNDED[construction]
    for word, other in SWAPPED.items():
        tree = tree.replace(f" {word})", f" >{other})")
    tree, known = tree.replace(">", ""), known.replace("; left,", "; right,")
    assert meaning(tree, mirrored()) == ("grounded", parse_symbols(known))

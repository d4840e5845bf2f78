"""What phrases are worth: sentences through the shipped grammar, read in small scenes whose answer is plain."""

import functools

import numpy as np
import pytest

from grounding import World, make_object
from grounding.geometry.layout import Layout
from grounding.graded.belief import believe
from grounding.graded.reader import Reader
from grounding.graded.values import Membership, Rank, Restriction
from grounding.language.parser import Parser
from grounding.meaning.nouns import read_noun
from grounding.world import Viewpoint
from grounding.world.scene import ROBOT, SPEAKER, Scene

TABLE = make_object("table", "table", "white", (0.65, 0, 0.691), size=(0.7, 1.8, 0.04))


def block(name, color, x, y, level=0):
    return make_object(name, "block", color, (x, y, 0.736 + 0.05 * level))


WORLD = World(
    (TABLE, block("a", "red", 0.5, 0.4), block("b", "green", 0.5, 0.2), block("c", "red", 0.5, 0.0),
     block("d", "blue", 0.5, -0.2), block("e", "red", 0.5, -0.4), block("f", "yellow", 0.8, 0.2),
     block("t1", "green", 0.8, -0.3), block("t2", "blue", 0.8, -0.3, 1)),
    Viewpoint(np.array([1.6, 0.0, 0.0]), np.pi),
)  # fmt: skip
SCENE = Scene(Layout(WORLD))
IDS = SCENE.layout.ids


@functools.cache
def parser():
    return Parser.load()


def noun_phrase(text):
    """The outermost noun phrase of a text."""
    return next(phrase for phrase in parser().parse(text, 1)[0].tree.preorder() if phrase.tag == "NP")


def value(text, view=ROBOT, history=()):
    return Reader(SCENE, view, history).value(noun_phrase(text))


def best(weights):
    return IDS[int(np.argmax(weights))]


@pytest.mark.parametrize(
    ("text", "name"),
    [
        ("the yellow block", "f"), ("the leftmost red block", "a"), ("the rightmost red cube", "e"),
        ("the second red block from the left", "c"), ("the block between the green block and the blue block", "c"),
        ("the block directly behind the green block", "f"), ("the red block closest to the yellow block", "a"),
        ("the red block farthest to the right", "e"), ("the third block from the left in the row of five", "c"),
        ("the last red block from the left", "e"),
    ],
)  # fmt: skip
def test_single_phrases_are_worth_most_for_what_they_mean(text, name):
    found = value(text)
    assert found.kind == "objects"
    assert found.weights.shape == (SCENE.n,)
    assert (found.weights >= 0).all()
    assert (found.weights <= 1 + 1e-9).all()
    assert best(found.weights) == name


@pytest.mark.parametrize(
    ("text", "name"),
    [
        ("the block on top of the green block", "t2"), ("the bottom block of the tower", "t1"),
    ],
)  # fmt: skip
def test_heights_are_heard_in_stacks(text, name):
    found = value(text).weights
    assert best(found) == name
    assert (found > 0.9 * found.max()).sum() == 1


def test_colours_are_kept_apart():
    red = value("the red block").weights
    assert {IDS[i] for i in np.flatnonzero(red > 0.5)} == {"a", "c", "e"}
    assert not red[[i for i, name in enumerate(IDS) if name not in "ace"]].any()


def test_what_carries_something_is_hardly_meant():
    green = value("the green block").weights
    assert green[IDS.index("t1")] < 0.2 < green[IDS.index("b")]


@pytest.mark.parametrize(
    ("text", "kind", "members"),
    [
        ("the row of five blocks", "sets", {"a", "b", "c", "d", "e"}), ("the tower", "sets", {"t1", "t2"}),
        ("the red blocks", "sets", {"a", "c", "e"}), ("the three red blocks", "sets", {"a", "c", "e"}),
    ],
)  # fmt: skip
def test_several_are_sets(text, kind, members):
    found = value(text)
    assert found.kind == kind
    mask, weight = found.sets[0]
    assert {IDS[i] for i in np.flatnonzero(mask)} == members
    assert 0 < weight <= 1


@pytest.mark.parametrize(
    ("text", "kind", "agent"),
    [("pick the block closest to you", "agent", "robot"), ("pick the block closest to me", "agent", "speaker")],
)
def test_people_are_agents(text, kind, agent):
    inner = [p for p in parser().parse(text, 1)[0].tree.preorder() if p.tag == "NP"][-1]
    found = Reader(SCENE).value(inner)
    assert (found.kind, found.agent) == (kind, agent)


@pytest.mark.parametrize(
    ("text", "effect"),
    [("the block in the row of five", Membership), ("the block behind the green block", Restriction),
     ("the block closest to the yellow block", Rank)],
)  # fmt: skip
def test_modifiers_restrict_choose_or_rank(text, effect):
    (modifier,) = read_noun(noun_phrase(text)).modifiers
    (found,) = Reader(SCENE).effects(modifier, np.ones(SCENE.n))
    assert isinstance(found, effect)


# Viewpoints


def test_unmarked_sides_are_those_of_the_view():
    assert best(value("the leftmost red block").weights) == "a"
    assert best(value("the leftmost red block", SPEAKER).weights) == "e"


@pytest.mark.parametrize("view", [ROBOT, SPEAKER])
@pytest.mark.parametrize(
    ("text", "name"), [("the red block on your left", "a"), ("the red block on my left", "e")]
)
def test_marked_sides_are_those_of_who_is_named(view, text, name):
    assert best(value(text, view).weights) == name


def test_near_and_far_are_from_who_is_named():
    assert best(value("the block farthest from me").weights) in "abcde"
    assert best(value("the block closest to me").weights) in ("f", "t2")


# Belief


TEXTS = ["pick up the leftmost red block", "take the block behind the green block", "the red block",
         "grab the red blocks", "put the yellow block on the tower", "take the three red blocks", "lift the tower",
         "pick up the block that is closest to me", "there is a tower. take its top block"]  # fmt: skip


@pytest.mark.parametrize("text", TEXTS)
def test_belief_sums_to_one(text):
    belief = believe(parser().parse(text, 4), SCENE)
    assert sum(reading.share for reading in belief.readings) == pytest.approx(1)
    assert sum(share for _, share in belief.options) == pytest.approx(1, abs=1e-4)
    shares = [share for _, share in belief.options]
    assert shares == sorted(shares, reverse=True)
    assert 0 <= belief.truth <= 1 + 1e-9
    assert set(belief.parses()) <= set(range(4))


@pytest.mark.parametrize("text", TEXTS)
def test_belief_does_not_depend_on_the_order_of_objects(text):
    shuffled = World(WORLD.objects[::-1], WORLD.speaker)
    one, other = (believe(parser().parse(text, 4), Scene(Layout(world))) for world in (WORLD, shuffled))
    assert dict(one.options) == pytest.approx(dict(other.options))


def test_both_views_are_kept_where_no_side_is_marked():
    belief = believe(parser().parse("pick up the leftmost red block", 2), SCENE)
    assert {reading.reader.view for reading in belief.readings} == {ROBOT, SPEAKER}
    shares = {names: share for (_, names), share in belief.options}
    assert shares[("a",)] > shares[("e",)] > 10 * shares.get(("c",), 0.0)
    silent = World(WORLD.objects)
    alone = believe(parser().parse("pick up the leftmost red block", 2), Scene(Layout(silent)))
    assert {reading.reader.view for reading in alone.readings} == {ROBOT}


def test_it_is_what_was_handled_last():
    belief = believe(parser().parse("pick it up", 2), SCENE, ("f", "c"))
    assert belief.options[0][0] == ("pick", ("c",))
    assert not believe(parser().parse("pick it up", 2), SCENE).options


def test_nonsense_is_believed_of_nothing():
    assert believe(parser().parse("sing a song", 2), SCENE).truth < 0.1

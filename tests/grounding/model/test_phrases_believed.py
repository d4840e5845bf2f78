"""What phrases mean: sentences through all that ships, in small scenes whose answer is plain."""

import numpy as np
import pytest
from believing import TABLE, believed, block, first

from grounding import World
from grounding.world import Viewpoint
from grounding.world.scene import ROBOT, SPEAKER

WORLD = World(
    (TABLE, block("a", "red", 0.5, 0.4), block("b", "green", 0.5, 0.2), block("c", "red", 0.5, 0.0),
     block("d", "blue", 0.5, -0.2), block("e", "red", 0.5, -0.4), block("f", "yellow", 0.8, 0.2),
     block("t1", "green", 0.8, -0.3), block("t2", "blue", 0.8, -0.3, 1)),
    Viewpoint(np.array([1.6, 0.0, 0.0]), np.pi),
)  # fmt: skip


@pytest.mark.parametrize(
    ("text", "name"),
    [
        ("the yellow block", "f"), ("the leftmost red block", "a"), ("the rightmost red cube", "e"),
        ("the second red block from the left", "c"), ("the block between the green block and the blue block", "c"),
        ("the block directly behind the green block", "f"), ("the red block farthest to the right", "e"),
        ("the third block from the left in the row of five", "c"),
        ("the last red block from the left", "e"), ("the block on top of the green block", "t2"),
        ("the bottom block of the tower", "t1"), ("the red block on your left", "a"), ("the red block on my left", "e"),
    ],
)  # fmt: skip
def test_single_phrases_mean_what_they_say(text, name):
    assert first(text, WORLD) == ("pick", (name,))


def test_what_carries_something_is_hardly_meant():
    belief = believed("the green block", WORLD)
    assert belief.probability(("t1",)) < 0.2 < belief.probability(("b",))


@pytest.mark.parametrize(
    ("text", "members"),
    [
        ("the row of five blocks", ("a", "b", "c", "d", "e")), ("the tower", ("t1", "t2")),
        ("the red blocks", ("a", "c", "e")), ("the three red blocks", ("a", "c", "e")),
    ],
)  # fmt: skip
def test_several_are_sets(text, members):
    assert first(text, WORLD)[1] == members


def test_near_and_far_are_from_who_is_named():
    assert first("the block farthest from me", WORLD)[1][0] in "abcde"
    assert first("the block closest to me", WORLD)[1][0] in ("f", "t2")


TEXTS = ["pick up the leftmost red block", "take the block behind the green block", "the red block",
         "grab the red blocks", "put the yellow block on the tower", "take the three red blocks", "lift the tower",
         "pick up the block that is closest to me", "there is a tower. take its top block"]  # fmt: skip


@pytest.mark.parametrize("text", TEXTS)
def test_belief_sums_to_one(text):
    belief = believed(text, WORLD)
    assert sum(belief.shares) == pytest.approx(1)
    assert sum(share for _, share in belief.options) == pytest.approx(1, abs=1e-4)
    shares = [share for _, share in belief.options]
    assert shares == sorted(shares, reverse=True)
    assert 0 <= belief.agreement <= 1 + 1e-9
    assert set(belief.parses()) <= set(range(4))


@pytest.mark.parametrize("text", TEXTS)
def test_belief_does_not_depend_on_the_order_of_objects(text):
    shuffled = World(WORLD.objects[::-1], WORLD.speaker)
    one, other = (believed(text, world) for world in (WORLD, shuffled))
    assert dict(one.options) == pytest.approx(dict(other.options))


def test_both_views_are_kept_where_no_side_is_marked():
    belief = believed("pick up the leftmost red block", WORLD)
    assert {reading.evaluator.view for reading in belief.readings if reading.cases} == {ROBOT, SPEAKER}
    shares = dict(belief.options)
    assert shares[("a",)] > shares[("e",)] > 2 * shares.get(("c",), 0.0)
    silent = World(WORLD.objects)
    alone = believed("pick up the leftmost red block", silent)
    assert {reading.evaluator.view for reading in alone.readings} == {ROBOT}


def test_it_is_what_was_handled_last():
    assert first("pick it up", WORLD, ("f", "c")) == ("pick", ("c",))
    assert first("pick it up", WORLD) is None


def test_nonsense_is_believed_of_nothing():
    assert believed("sing a song", WORLD).agreement < 0.1


def test_the_first_two_of_a_line_are_those_at_its_start():
    blue = block("blue", "blue", 0.8, -0.5)
    row = World((TABLE, blue, *(block(f"r{i}", "red", 0.6, 0.3 - 0.1 * i) for i in range(5))))
    assert first("take the first two blocks in the row", row)[1] == ("r0", "r1")
    assert first("take the last two blocks in the row", row)[1] == ("r3", "r4")
    column = World((TABLE, blue, *(block(f"c{i}", "red", 0.4 + 0.1 * i, 0.1) for i in range(5))))
    assert first("take the first two red blocks in the column of red blocks", column)[1] == ("c0", "c1")

"""Texts that list what is there, tell what comes about, or tell of parts; phrases that a parse tore apart."""

import pytest
from believing import first, grounder, laid

from grounding.language.tree import Phrase, Word
from grounding.meaning.discourse.mending import as_sentence, mended

# Two at the far left, a tower at the far right with one beside it, one alone at the near right, one amid the
# right side, one in the middle of all, two at the near left.
WORLD = laid(one=(0.95, 0.55), two=(0.84, 0.55), base=(0.9, -0.35), top=(0.9, -0.35, 1), by=(0.9, -0.295),
             near=(0.38, -0.7), right=(0.66, -0.7), mid=(0.63, 0.0), low=(0.38, 0.6), over=(0.48, 0.3))  # fmt: skip


def best(text, history=()):
    return first(text, WORLD, history)[1]


@pytest.mark.parametrize(
    ("text", "name"),
    [
        ("The upper left corner has two cubes. The lower one shall go onto the tower.", "two"),
        ("The cube in the middle slides to the left and touches the bottom right cube.", "mid"),
        ("Put the bottom right cube on the tower. Three cubes will then be stacked.", "near"),
        ("The bottom right moves three spaces to the left.", "near"),
        ("Put the bottom right cube directly behind the tower and then slide it to the left.", "near"),
    ],
)
def test_what_is_listed_or_comes_about_is_not_what_moves(text, name):
    assert best(text) == (name,)


@pytest.mark.parametrize(
    ("text", "name"),
    [
        ("The two-story unit has its top cube move to the left.", "top"),
        ("The tower on the right takes its nearest cube.", "by"),
        ("The tower grows by a story from the bottom right corner.", "near"),
    ],
)
def test_parts_and_neighbours_are_those_of_the_subject(text, name):
    assert best(text) == (name,)


@pytest.mark.parametrize(
    ("text", "name"),
    [
        ("take the cube on the right in the middle and put it on the tower", "right"),
        ("take the cube in the middle on the right and put it on the tower", "right"),
        ("take the second cube down on the left and put it on the tower", "two"),
        ("take the cube two spaces up and six right of the bottom left cube", "over"),
        ("take the single cube that is closest to the tower", "by"),
        ("take the cube closest to the center line", "mid"),
    ],
)
def test_phrases_that_say_one_thing_together(text, name):
    assert best(text) == (name,)


def test_a_box_that_continues_is_the_one_that_was_moved():
    assert best("This box continues, now left by two spaces.", ("low",)) == ("low",)


def noun(*words, tag="NP"):
    return Phrase(tag, tuple(Word(text, "NN", place) for place, text in enumerate(words)))


def test_the_middle_of_a_grid_is_put_together():
    torn = Phrase("NP", (Phrase("PP", (Word("of", "IN", 0), noun("grid"))), noun("center", tag="PP")))
    assert [phrase.text for phrase in mended(torn).preorder() if phrase.tag == "NP"][-1] == "grid center"


def test_a_rank_that_was_read_as_a_measure_is_a_rank():
    rank, start, you = noun("the", "furthest"), Word("from", "IN", 2), noun("you")
    assert mended(Phrase("PP", (rank, start, you))) == Phrase("PP", (rank.words[1], start, you))
    step = Phrase("PP", (noun("two", "spaces"), start, you))
    assert mended(step) is step


def test_what_is_whole_stays_the_same():
    whole = Phrase("VP", (Word("take", "VB", 0), noun("the", "cube")))
    assert mended(whole) is whole
    assert as_sentence(whole) is whole


def test_a_relation_that_begins_with_a_verb_is_a_sentence():
    torn = Phrase("NP", (noun("the", "tower"), Phrase("PP", (Word("claims", "IN", 2), noun("the", "cube")))))
    assert [child.tag for child in as_sentence(torn).phrases] == ["NP", "VP"]


@pytest.mark.parametrize(
    ("text", "kind"),
    [
        ("take the block in the middle away", "clear"),
        ("push the block in the middle aside", "clear"),
        ("move the block in the middle out of the way", "clear"),
        ("move the block in the middle away from the tower", "place"),
        ("put the block in the middle onto the tower", "place"),
        ("take the block in the middle", "pick"),
    ],
)
def test_what_is_moved_away_is_cleared_unless_it_is_said_from_what(text, kind):
    result = grounder().ground(text, WORLD)
    assert next((a.action, a.objects) for a in (*result.actions, *result.alternatives)) == (kind, ("mid",))

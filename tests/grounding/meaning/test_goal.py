"""Destinations in words: clues by directions, lengths and relations; the same words always give the same clues."""

import functools

import pytest

from grounding.language.parser import Parser
from grounding.lexicon import whereto
from grounding.lexicon.vocabulary import vocabulary
from grounding.meaning.goal.items import line_up
from grounding.meaning.goal.lengths import Metres, is_course, number, peeled
from grounding.meaning.goal.listening import listen
from grounding.meaning.nouns import read_noun


@functools.cache
def parser():
    return Parser.load()


@functools.cache
def tree(text):
    return parser().parse(text, 1)[0].tree


def clues(where):
    """The clues of a destination after "move the red block"; the block itself is none."""
    found = listen(line_up(tree(f"move the red block {where}").phrases[1:]))
    assert found, where
    return found


def relations(where):
    return [clue.relation for clue in clues(where)]


@pytest.mark.parametrize(
    ("where", "relation"),
    [
        ("onto the blue block", "on"),
        ("next to the blue block", "near"),
        ("between the blue block and the green block", "between"),
        ("to the left of the blue block", "offset"),
        ("above the blue block", "offset"),
        ("to the left", "own"),
        ("toward the blue block", "toward"),
        ("to the left side of the table", "place"),
    ],
)
def test_a_relation_is_heard(where, relation):
    assert relation in relations(where)


@pytest.mark.parametrize("count", ["one", "two", "three", "four"])
@pytest.mark.parametrize("way", ["left", "right", "up", "down"])
def test_a_length_belongs_to_its_direction_on_either_side(count, way):
    before, after = clues(f"{count} spaces {way}"), clues(f"{way} {count} spaces")
    for found in (before, after):
        assert [(offset.names, offset.steps) for clue in found for offset in clue.offsets] == [((way,), number(count))]


def test_lengths_stay_apart():
    offsets = [offset for clue in clues("up two spaces and left one space") for offset in clue.offsets]
    assert [(offset.names, offset.steps) for offset in offsets] == [(("up",), 2.0), (("left",), 1.0)]


@pytest.mark.parametrize(("said", "opposite"), [("left", "right"), ("right", "left")])
def test_its_side_at_something_is_beside_that_on_the_other_side(said, opposite):
    found = clues(f"so that its {said} side touches the blue block")
    assert [(c.relation, c.offsets[0].names, c.strict) for c in found if c.nouns] == [("offset", (opposite,), True)]


def test_compass_points_are_heard_as_sides():
    def heard(text):
        return [[(offset.names, offset.steps) for offset in clue.offsets] for clue in clues(text)]

    assert heard("two spaces west of the blue block") == heard("two spaces left of the blue block")


@pytest.mark.parametrize(("said", "metres"), [
    ("20 cm", 0.2), ("200 mm", 0.2), ("0.2 meters", 0.2), ("20cm", 0.2), ("twenty centimeters", 0.2),
    ("half a meter", 0.5), ("a foot", 0.3048), ("two inches", 0.0508),
])  # fmt: skip
@pytest.mark.parametrize("way", ["{} to the left", "{} left of the green block", "{} towards the green block"])
def test_lengths_with_a_unit_are_metres(said, metres, way):
    steps = [offset.steps for clue in clues(way.format(said)) for offset in clue.offsets]
    assert steps == [pytest.approx(metres)]
    assert isinstance(steps[0], Metres)


def test_a_way_is_no_part_of_what_it_leads_from():
    noun = read_noun(tree("the tower up two spaces"))
    bare, ways = peeled(noun)
    assert not bare.modifiers
    assert all(is_course(way) for way in ways)


def test_every_unit_has_a_length():
    for unit in vocabulary().words("unit"):
        assert whereto.metres(unit) > 0


def test_directions_that_lead_away_agree_with_directions():
    """A preposition that leads away from things on a flat table names no other direction than it does elsewhere."""
    from grounding.lexicon.words import directions, flat

    for word in vocabulary().words("leading"):
        named = flat(directions(word))
        assert not named or named == (whereto.leads(word),)

"""The meaning of phrases is told in agreement with the answer, by the readings that the answer was found with."""

import functools

import pytest

import models
from grounding import Grounder, World, load_world, make_object
from grounding.model.belief import believe, read
from grounding.model.evaluator import EVEN
from grounding.phrases import phrases_of
from grounding.result import Destination, GroundedAction
from grounding.symbols import Action, Cardinal, Container, ObjectColor, ObjectSymbol, Region, SpatialReference

WORLD = load_world(models.SCENES / "four.json")
BY_LEFT = [o.id for o in sorted(WORLD.things, key=lambda o: -o.position[1])]


@functools.cache
def grounder():
    return Grounder.load()


def phrases(text, *ids, action="pick"):
    """Noun phrases with their likely objects, where an answer handles `ids`."""
    understood = grounder().understand(text, WORLD)
    belief = believe(read(understood.parses, understood.scene), EVEN)
    told = phrases_of(understood.parse.tree, belief, [GroundedAction(action, ids, 0.9)])
    return {phrase.text: [(symbol.id, p) for symbol, p in phrase.groundings if isinstance(symbol, ObjectSymbol)]
            for phrase in told if phrase.tag == "NP"}  # fmt: skip


@pytest.mark.parametrize(("said", "name"), [("leftmost", BY_LEFT[0]), ("rightmost", BY_LEFT[-1])])
def test_what_is_handled_has_the_probability_of_the_answer(said, name):
    assert phrases(f"pick up the {said} block", name)[f"the {said} block"] == [(name, 0.9)]


def test_what_it_is_related_to_has_its_own_objects():
    text = "put the leftmost block on the rightmost block"
    found = phrases(text, BY_LEFT[0], action="place")
    assert found["the leftmost block"] == [(BY_LEFT[0], 0.9)]
    assert found["the rightmost block"][0][0] == BY_LEFT[-1]


def symbols(text, world=WORLD):
    """What phrases mean, by their texts."""
    return {phrase.text: dict(phrase.groundings) for phrase in grounder().ground(text, world).phrases}


def test_words_have_their_own_symbols_and_the_whole_has_the_action():
    found = symbols("pick up the red block")
    assert ObjectColor("red") in found["the red block"]
    actions = [s for s in found["pick up the red block"] if isinstance(s, Action) and s.objects]
    assert all(WORLD[name].color == "red" for action in actions for name in action.objects)
    assert actions


def test_arrangements_and_regions_are_told():
    world = load_world(models.SCENES / "default.json")
    found = symbols("pick up the middle block in the row of five blocks", world)
    row = next(s for s in found["the row of five blocks"] if isinstance(s, Container) and s.objects)
    assert row == Container("row", ("b1", "b2", "b3", "b4", "b5"))
    assert Cardinal(5) in found["five blocks"]
    beside = symbols("pick up the block behind the red block")
    assert any(isinstance(s, Region) and s.relation == "back" for of in beside.values() for s in of)


def test_where_something_goes_belongs_to_the_action():
    understood = grounder().understand("put the leftmost block on the rightmost block", WORLD)
    place = Destination((0.0, 0.0, 0.0), "top", (BY_LEFT[-1],))
    told = phrases_of(understood.parse.tree, understood.belief, [GroundedAction("place", (BY_LEFT[0],), 0.9, place)])
    wanted = Action("place", (BY_LEFT[0],), Region("top", "object", (BY_LEFT[-1],)))
    assert dict(told[0].groundings)[wanted] == 0.9


def test_a_diagonal_is_a_row_of_gamma():
    blocks = [make_object(f"d{i}", color="red", position=(0.45 + 0.08 * i, 0.3 - 0.08 * i, 0.736)) for i in range(4)]
    world = World((WORLD["table"], *blocks, make_object("x", color="blue", position=(0.5, -0.4, 0.736))))
    found = symbols("pick up the first block in the diagonal", world)["the diagonal"]
    assert any(isinstance(s, Container) and s.kind == "row" and s.objects for s in found)


@pytest.mark.parametrize(
    ("text", "phrase", "wanted"),
    [
        ("pick up the third block from the right", "from the right", {SpatialReference("right")}),
        ("pick up the block on the left side", "on the left side", {SpatialReference("left")}),
    ],
)
def test_sides_are_told_without_the_prepositions_own_meaning(text, phrase, wanted):
    assert {s for s in symbols(text)[phrase] if isinstance(s, SpatialReference)} == wanted


def test_a_set_from_which_is_chosen_is_told():
    world = load_world(models.SCENES / "default.json")
    found = symbols("pick up the middle block in the row of five blocks", world)["in the row of five blocks"]
    assert Container("row", ("b1", "b2", "b3", "b4", "b5")) in found

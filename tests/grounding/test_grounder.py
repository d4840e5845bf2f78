"""From text and world to an answer, with the shipped grammar and weights on the shipped scenes."""

import functools
import json
import re
from dataclasses import replace

import numpy as np
import pytest
from hypothesis import example, given, settings
from hypothesis import strategies as st

import models
from grounding import Grounder, LanguageError, ModelError, World, load_world, make_object
from grounding.language.lexicon import known_words
from grounding.result import OUTCOMES

FIGURE_1 = "pick up the middle block in the row of five blocks on the right"
FIGURE_8 = "pick up the farthest block in the column of three blocks on the left"


@functools.cache
def grounder():
    return Grounder.load()


@functools.cache
def scene(name):
    return load_world(models.SCENES / f"{name}.json")


def answer(text, world):
    """(outcome, actions without probabilities and places)."""
    result = grounder().ground(text, scene(world) if isinstance(world, str) else world)
    return result.outcome, [
        (a.action, set(a.objects), a.destination and (a.destination.relation, set(a.destination.reference)))
        for a in result.actions
    ]


def picks(text, world):
    outcome, actions = answer(text, world)
    assert outcome == "grounded", (text, outcome)
    (action,) = actions
    assert action[0] == "pick"
    assert action[2] is None
    return action[1]


def place_of(name, world="default"):
    return scene(world)[name].position


# The paper's demonstrations


@pytest.mark.parametrize("text", [FIGURE_1, FIGURE_1.replace(" in the row", " of the row")])
def test_the_middle_block_of_the_row(text):
    row = sorted(
        (o for o in scene("default").things if o.id in ("b1", "b2", "b3", "b4", "b5")), key=lambda o: o.position[1]
    )
    assert picks(text, "default") == {row[2].id} == {"b3"}


def test_the_farthest_block_of_the_column():
    column = ("b6", "b7", "b8")
    assert picks(FIGURE_8, "default") == {max(column, key=lambda name: place_of(name)[0])}


def test_what_the_phrases_mean_is_told():
    result = grounder().ground(FIGURE_1, scene("default"))
    told = {p.text: {(s["symbol"], s.get("kind"), tuple(s.get("objects", ()))) for s in p.to_json()["groundings"]}
            for p in result.phrases}  # fmt: skip
    assert ("container", "row", ("b1", "b2", "b3", "b4", "b5")) in set().union(*told.values())
    assert ("object", None, ("b3",)) in set().union(*told.values())
    assert result.phrases[0].text == FIGURE_1
    assert result.phrases[0].depth == 0


# Typed outcomes


@pytest.mark.parametrize("text", ["sing a song", "hello", "why?", "what is your name"])
def test_what_is_no_instruction_is_not_understood(text):
    result = grounder().ground(text, scene("default"))
    assert result.outcome == "not_understood"
    assert not result.actions
    assert result.explanation


@pytest.mark.parametrize("world", ["default", "seven", "tower"])
def test_an_unknown_thing_is_named(world):
    result = grounder().ground("pick up the purple elephant", scene(world))
    assert result.outcome in ("no_referent", "not_understood")
    assert "elephant" in result.unknown_words
    assert "elephant" in result.explanation


@pytest.mark.parametrize("text", ["pick up the blue block", "take the nearest green cube"])
def test_a_colour_that_is_not_there_is_named(text):
    result = grounder().ground(text, scene("default"))
    assert result.outcome == "no_referent"
    assert re.search("blue|green", result.explanation)
    assert "red" in result.explanation


@pytest.mark.parametrize("text", ["pick up the block", "take the block", "grab the red block"])
def test_one_of_twenty_is_asked_for(text):
    result = grounder().ground(text, scene("default"))
    assert result.outcome == "ambiguous"
    assert not result.actions
    assert len(result.alternatives) > 1
    assert result.question.endswith("?")
    assert {a.action for a in result.alternatives} == {"pick"}


def furnished(*objects):
    return World((*objects, scene("default")["table"]))


EMPTY = ["pick up the block", "pick up the nearest red block", "put the red block on the blue block",
         "clear the blocks", "take the leftmost block of the row", "the red block", FIGURE_1, FIGURE_8]  # fmt: skip


@pytest.mark.parametrize("text", EMPTY)
@pytest.mark.parametrize("world", [World(()), furnished()], ids=["empty", "table"])
def test_in_a_world_without_blocks_nothing_is_meant(text, world):
    result = grounder().ground(text, world)
    assert result.outcome == "no_referent"
    assert not result.actions
    assert not result.alternatives
    assert result.explanation


@pytest.mark.parametrize("text", ["pick up the block", "pick up the nearest block", "take the red cube"])
def test_in_a_world_of_one_block_it_is_meant(text):
    assert picks(text, furnished(make_object("only", color="red", position=(0.6, 0.1, 0.736)))) == {"only"}


@pytest.mark.parametrize("text", ["", " ", "\n\t", "...", "?!", "​"])
def test_a_text_without_words_is_refused(text):
    with pytest.raises(LanguageError, match="without words"):
        grounder().ground(text, scene("default"))


def test_missing_weights_are_named(tmp_path):
    with pytest.raises(ModelError, match=r"cannot read the weights .*nothing\.json"):
        Grounder.load(beliefs=tmp_path / "nothing.json")


@pytest.mark.parametrize("text", ["don't pick up the nearest block", "do not pick up the nearest block"])
def test_what_is_forbidden_is_not_done(text):
    assert answer(text, "default")[0] != "grounded"


@pytest.mark.parametrize("text", ["take a blue cube", "grab any of the blue blocks", "pick up one of the blue blocks"])
def test_any_of_two_will_do_where_any_is_asked_for(text):
    result = grounder().ground(text, scene("four"))
    assert result.outcome == "grounded"
    assert scene("four")[result.actions[0].objects[0]].color == "blue"
    assert len(result.actions[0].objects) == 1


@pytest.mark.parametrize("text", ["pick up the red block", "take the blue cube", "the red block"])
def test_which_of_two_blocks_is_asked(text):
    assert answer(text, "four")[0] == "ambiguous"


@pytest.mark.parametrize("text", ["slide adjacent box", "put the nearest block", "move the nearest block"])
def test_what_is_placed_has_a_place(text):
    for action in grounder().ground(text, scene("four")).actions:
        assert action.action != "place" or action.destination is not None


@pytest.mark.parametrize("number", ["seven", "eight", "nine", "eleven"])
@pytest.mark.parametrize("text", ["pick up the middle block in the row of {} blocks", "pick up the row of {} blocks"])
def test_a_row_that_is_not_there_is_not_replaced_by_another(text, number):
    assert answer(text.format(number), "default")[0] == "no_referent"


def test_which_of_two_rows_is_asked():
    assert answer("pick up the middle block in the row of five blocks", "two_rows")[0] == "ambiguous"


# Minimal pairs

CLEAR = [
    ("default", FIGURE_1), ("default", FIGURE_8), ("default", "pick up the nearest block"),
    ("default", "take the second block from the left"), ("default", "grab the leftmost block"),
    ("default", "put the nearest block to the left of the farthest block"),
    ("default", "pick up the second block from the right in the row of five blocks"),
    ("seven", "pick up the leftmost red block"), ("seven", "take the farthest blue cube"),
    ("seven", "put the nearest block on top of the farthest block"), ("four", "pick up the rightmost block"),
    ("four", "pick up the nearest blue block"), ("twelve", "clear the green blocks"),
    ("twelve", "pick up the nearest green block"), ("scattered", "pick up the three nearest blocks"),
    ("scattered", "take the leftmost yellow block"), ("tower", "pick up the farthest red block"),
    ("two_rows", "pick up the rightmost block in the far row"),
]  # fmt: skip
clear = pytest.mark.parametrize(("world", "text"), CLEAR)
SWAPPED = {"left": "right", "right": "left", "leftmost": "rightmost", "rightmost": "leftmost"}


def swapped(text):
    return " ".join(SWAPPED.get(word, word) for word in text.split())


@clear
def test_in_a_mirror_left_is_right(world, text):
    mirror = World(tuple(o.moved(o.position * (1, -1, 1), o.orientation * (1, 1, 1, -1)) for o in scene(world).objects))
    outcome, actions = answer(text, world)
    assert outcome == "grounded"
    assert answer(swapped(text), mirror) == (
        outcome,
        [(kind, ids, place and (SWAPPED.get(place[0], place[0]), place[1])) for kind, ids, place in actions],
    )


@clear
def test_order_and_names_of_objects_say_nothing(world, text):
    rng = np.random.default_rng(1)
    objects = scene(world).objects
    names = {o.id: f"thing-{i}" for o, i in zip(objects, rng.permutation(len(objects)), strict=True)}
    renamed = [
        make_object(names[o.id], o.type, o.color, o.position, o.orientation, o.size)
        for o in (objects[i] for i in rng.permutation(len(objects)))
    ]
    outcome, actions = answer(text, world)
    assert answer(text, World(tuple(renamed))) == (
        outcome,
        [
            (kind, {names[i] for i in ids}, place and (place[0], {names[i] for i in place[1]}))
            for kind, ids, place in actions
        ],
    )


@clear
@pytest.mark.parametrize(
    "change", ["{upper}", "{text}.", "{title}!", "  {spaced}  ", "please {text}", "{text}, please"]
)
def test_case_marks_and_politeness_say_nothing(world, text, change):
    changed = change.format(text=text, upper=text.upper(), title=text.title(), spaced=text.replace(" ", "   "))
    assert answer(changed, world) == answer(text, world)


@pytest.mark.parametrize("world", ["default", "seven", "scattered", "four"])
def test_ordinals_count(world):
    order = sorted(scene(world).things, key=lambda o: -o.position[1])
    for ordinal, item in zip(("first", "second", "third", "fourth"), order, strict=False):
        assert picks(f"pick up the {ordinal} block from the left", world) == {item.id}


@pytest.mark.parametrize(
    ("superlative", "score"),
    [("nearest", lambda p: -np.hypot(p[0], p[1])), ("farthest", lambda p: np.hypot(p[0], p[1])),
     ("leftmost", lambda p: p[1]), ("rightmost", lambda p: -p[1])],
)  # fmt: skip
@pytest.mark.parametrize(("world", "color"), [("seven", "red"), ("seven", "blue"), ("scattered", "green"),
                                              ("scattered", "purple"), ("tower", "yellow")])  # fmt: skip
def test_colours_narrow(superlative, score, world, color):
    of_color = [o for o in scene(world).things if o.color == color]
    assert picks(f"pick up the {superlative} {color} block", world) == {
        max(of_color, key=lambda o: score(o.position)).id
    }


@pytest.mark.parametrize("verb", ["pick up", "take", "grab", "lift", "get"])
def test_verbs_of_one_meaning(verb):
    assert picks(f"{verb} the nearest block", "seven") == picks("pick up the nearest block", "seven")


def test_the_verb_decides_the_action():
    for text, kind in (
        ("pick up the nearest block", "pick"),
        ("put the nearest block on the farthest block", "place"),
        ("clear the red blocks", "clear"),
    ):
        outcome, actions = answer(text, "seven")
        assert outcome == "grounded"
        assert [action[0] for action in actions] == [kind]


# The form of the answer


RESULT = {"instruction", "outcome", "actions", "alternatives", "question", "explanation", "unknown_words",
          "milliseconds", "phrases"}  # fmt: skip
ACTION = {"action", "objects", "probability", "destination"}
PLACE = {"position", "relation", "reference"}
PHRASE = {"text", "tag", "words", "groundings"}


def checked(result, text, world):
    """What holds of every answer."""
    data = json.loads(json.dumps(result.to_json()))
    assert set(data) - {"mended"} == RESULT
    assert data["instruction"] == text
    assert data["outcome"] in OUTCOMES
    assert data["milliseconds"] >= 0
    every = data["actions"] + data["alternatives"]
    total = 0.0
    for action in every:
        assert set(action) == ACTION
        assert action["action"] in ("pick", "place", "clear")
        assert action["objects"]
        assert all(name in world.by_id for name in action["objects"])
        assert 0 <= action["probability"] <= 1
        assert (action["destination"] is None) or set(action["destination"]) <= PLACE
        total += action["probability"]
    assert total <= max(1, len(data["actions"])) + 1e-3  # of each step
    assert bool(data["actions"]) == (data["outcome"] == "grounded")
    assert (data["question"] is not None) == (data["outcome"] == "ambiguous")
    assert data["explanation"] or data["outcome"] == "grounded"
    likely = [a["probability"] for a in data["alternatives"]]
    assert likely == sorted(likely, reverse=True)
    for phrase in data["phrases"]:
        assert set(phrase) == PHRASE
        first, last = phrase["words"]
        assert 0 <= first <= last
        assert len(phrase["text"].split(" ")) <= last - first + 1  # a verb may be shared with an earlier step
        assert all(0 <= symbol["probability"] <= 1 for symbol in phrase["groundings"])
        assert all(name in world.by_id for symbol in phrase["groundings"] for name in symbol.get("objects", ()))


@clear
def test_answers_have_their_form(world, text):
    checked(grounder().ground(text, scene(world)), text, scene(world))


@pytest.mark.parametrize("text", [*EMPTY, "sing a song", "pick up the purple elephant"])
def test_refusals_have_their_form(text):
    for world in (World(()), scene("four")):
        checked(grounder().ground(text, world), text, world)


@clear
def test_the_same_question_has_the_same_answer(world, text):
    first, second = (Grounder.ground(grounder(), text, load_world(models.SCENES / f"{world}.json")) for _ in range(2))
    assert first.timed(0.0) == second.timed(0.0)


words = st.lists(st.sampled_from(sorted(known_words() | {"the", "a", "in", "of", "it", "not"})), min_size=1, max_size=9)


@given(words.map(" ".join), st.sampled_from(("four", "tower")))
@example("the left of the left of the left", "four")
@example("put it on it", "four")
@example("pick up the zeroth block", "tower")
@settings(max_examples=60)
def test_any_words_have_an_answer(text, world):
    checked(grounder().ground(text, scene(world)), text, scene(world))


@given(st.text(max_size=25))
@settings(max_examples=60)
def test_any_text_has_an_answer_or_no_words(text):
    try:
        result = grounder().ground(text, scene("four"))
    except LanguageError:
        assert not any(character.isalnum() for character in text)
    else:
        checked(result, text, scene("four"))


def test_long_texts_have_an_answer():
    for text in ("pick up the block " * 8, "the " * 30 + "block", "block of " * 15 + "block"):
        checked(grounder().ground(text, scene("four")), text, scene("four"))


@pytest.mark.parametrize("count", [1, 2, 60])
def test_worlds_of_any_size(count):
    rng = np.random.default_rng(count)
    blocks = [make_object(f"b{i}", position=(*rng.uniform((0.4, -0.8), (0.9, 0.8)), 0.736)) for i in range(count)]
    nearest = min(blocks, key=lambda o: np.hypot(*o.position[:2])).id
    assert picks("pick up the nearest block", furnished(*blocks)) == {nearest}
    checked(grounder().ground(FIGURE_1, furnished(*blocks)), FIGURE_1, furnished(*blocks))


def test_a_colour_that_is_taken_for_another_is_told():
    world = load_world(models.SCENES / "four.json")
    seen = world.with_objects(replace(item, color="magenta" if item.color == "red" else item.color)
                              for item in world.objects)  # fmt: skip
    result = Grounder.load().ground("take the pink block on the left", seen)
    assert ("pink", "magenta") in result.mended
    assert Grounder.load().ground("take the purple block on the left", world).outcome == "no_referent"
    assert not Grounder.load().ground("take the blue block on the left", world).mended

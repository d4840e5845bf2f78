"""Conversations: questions are answered in many ways, answers are remembered, and nothing is asked for ever."""

import functools

import pytest
from hypothesis import example, given, settings
from hypothesis import strategies as st

import models
from grounding import Grounder, LanguageError, WorldError, load_world
from grounding.conversation import PATIENCE, Conversation
from grounding.language.lexicon import known_words

WHICH = "pick up the block"


@functools.cache
def grounder():
    return Grounder.load()


@functools.cache
def scene(name="four"):
    return load_world(models.SCENES / f"{name}.json")


def talked(*texts, world="four"):
    """A conversation after what was said, and the last answer."""
    conversation = Conversation(grounder(), scene(world))
    return conversation, [conversation.say(text) for text in texts][-1]


def picked(*texts, world="four"):
    conversation, result = talked(*texts, world=world)
    assert result.outcome == "grounded", (texts, result.outcome, result.explanation)
    assert not conversation.waits
    assert conversation.history[-1:] == result.actions[-1].objects[-1:]
    return result.actions[-1].objects


BY_LEFT = sorted((o for o in scene().things), key=lambda o: -o.position[1])
REDS = [o.id for o in BY_LEFT if o.color == "red"]


@pytest.mark.parametrize(
    ("answer", "place"),
    [("the one on the left", 0), ("the left one", 0), ("left", 0), ("the rightmost one", 1), ("on the right", 1),
     ("I mean the right one", 1), ("pick up the leftmost red block", 0), ("no, the right one", 1)],
)  # fmt: skip
def test_alternatives_are_told_apart_by_where_they_are(answer, place):
    assert picked("pick up the red block", answer) == (REDS[place],)


@pytest.mark.parametrize(
    ("answer", "place"),
    [("the first one", 0), ("the second one", 1), ("second", 1), ("2", 1), ("the latter", 1), ("the former", 0),
     ("the last one please", 1), ("number two", 1)],
)  # fmt: skip
def test_alternatives_are_counted_as_they_were_named(answer, place):
    named = talked("pick up the red block")[1].alternatives
    assert picked("pick up the red block", answer) == named[place].objects


def test_both_are_taken():
    assert set(picked("pick up the red block", "both")) == set(REDS)


def test_yes_to_a_question_of_several_asks_for_one():
    conversation, result = talked(WHICH, "yes")
    assert result.outcome == "ambiguous"
    assert " or " not in result.question
    assert conversation.say("yes").actions[0].objects == result.alternatives[0].objects


def test_no_leaves_those_that_were_not_named():
    named = talked(WHICH)[1].alternatives[:3]
    _, result = talked(WHICH, "neither")
    left = {a.objects for a in result.alternatives}
    assert left
    assert not left & {a.objects for a in named}


def test_no_to_all_ends_the_question():
    conversation, result = talked(WHICH, "no", "no")
    assert result.outcome == "no_referent"
    assert not conversation.waits


def test_no_to_a_choice_of_two_asks_again_which():
    conversation, result = talked("lift the red cube", "no")
    assert result.outcome == "ambiguous"
    assert conversation.waits
    assert picked("lift the red cube", "no", "the left one") == (REDS[0],)


@pytest.mark.parametrize("text", ["not that one", "no, not this one", "wrong block"])
def test_what_was_taken_wrongly_is_not_taken_again(text):
    conversation, result = talked("lift the leftmost red cube", text)
    assert result.outcome == "ambiguous"
    assert {a.objects for a in result.alternatives} == {(REDS[1],)}
    assert conversation.history == ()
    assert conversation.say("yes").actions[0].objects == (REDS[1],)


def test_whoever_goes_on_with_it_agrees():
    conversation, result = talked("lift the leftmost red cube", "not that one", "put it on the farthest blue cube")
    assert [(a.action, a.objects) for a in result.actions] == [("place", (REDS[1],))]
    assert not conversation.waits


def test_the_other_one_of_two_is_taken_at_once():
    assert picked("lift the leftmost red cube", "no, the other one") == (REDS[1],)
    assert picked("lift the red cube", "the left one", "no, the other one") == (REDS[1],)


def test_what_was_put_wrongly_is_where_it_was():
    conversation, first = talked("put the leftmost red cube on the farthest blue cube")
    assert first.outcome == "grounded"
    result = conversation.say("no, the other one")
    assert [a.objects for a in result.actions] == [(REDS[1],)]
    assert result.actions[0].action == "place"
    assert (conversation.world[REDS[0]].position == scene()[REDS[0]].position).all()


def test_after_the_world_was_seen_nothing_is_taken_back():
    conversation, _ = talked("lift the leftmost red cube")
    conversation.observe(scene())
    assert conversation.say("no, the other one").actions[0].objects == (REDS[1],)


def test_rows_that_are_called_alike_are_told_apart():
    _, result = talked("lift the row", world="two_rows")
    offers = result.question.removeprefix("Do you mean ").rstrip("?").split(" or ")
    assert len(set(offers)) == 2
    for offer, alternative in zip(offers, result.alternatives, strict=False):
        assert set(picked("lift the row", offer, world="two_rows")) == set(alternative.objects)
    word = offers[1].split()[1]
    assert set(picked("lift the row", f"the {word} one", world="two_rows")) == set(result.alternatives[1].objects)


def test_an_answer_that_narrows_is_asked_further():
    _, result = talked(WHICH, "the red one")
    assert result.outcome == "ambiguous"
    assert {a.objects for a in result.alternatives} == {(name,) for name in REDS}
    assert picked(WHICH, "the red one", "the left one") == (REDS[0],)


def test_a_question_can_be_answered_in_its_own_words():
    for world in ("four", "seven", "twelve"):
        asked = talked(WHICH, world=world)[1]
        texts = asked.question.removeprefix("Do you mean ").rstrip("?").split(", ")
        for text, alternative in zip(texts[:1], asked.alternatives, strict=False):
            assert picked(WHICH, text, world=world) == alternative.objects


def test_an_instruction_may_come_instead_of_an_answer():
    nearest_blue = min((o for o in scene().things if o.color == "blue"), key=lambda o: o.position[0]).id
    assert picked("pick up the red block", "pick up the nearest blue block") == (nearest_blue,)


def test_another_thing_may_be_meant():
    nearest_blue = min((o for o in scene().things if o.color == "blue"), key=lambda o: o.position[0]).id
    assert picked("pick up the red block", "no, the nearest blue block") == (nearest_blue,)


@pytest.mark.parametrize("said", ["never mind", "forget it", "cancel"])
def test_questions_are_forgotten(said):
    conversation, result = talked(WHICH, said)
    assert result.outcome == "not_understood"
    assert not conversation.waits
    assert conversation.history == ()


def test_where_to_is_answered_with_a_place():
    conversation, result = talked("put the leftmost block", "on the rightmost block")
    (action,) = result.actions
    assert action.action == "place"
    assert action.objects == (BY_LEFT[0].id,)
    assert action.destination.reference == (BY_LEFT[-1].id,)
    assert conversation.world[BY_LEFT[0].id].position == pytest.approx(action.destination.position)


def test_what_was_moved_is_put_back():
    conversation, _ = talked("put the leftmost block on the rightmost block")
    (action,) = conversation.say("put it back").actions
    assert action.objects == (BY_LEFT[0].id,)
    assert action.destination.position == pytest.approx(tuple(BY_LEFT[0].position))
    assert conversation.world[BY_LEFT[0].id].position == pytest.approx(BY_LEFT[0].position)


def test_where_it_was_is_asked_where_nobody_knows():
    result = grounder().ground("put it back", scene(), ["b1"])
    assert result.outcome == "ambiguous"
    assert "where" in result.question.lower()


@pytest.mark.parametrize(
    "said",
    ["pick it up", "pick up the same block", "pick up the block you just moved", "take the block you moved before"],
)
def test_what_was_handled_is_spoken_of(said):
    for name in ("b1", "b3"):
        conversation = Conversation(grounder(), scene())
        conversation.handled([name])
        assert conversation.say(said).actions[0].objects == (name,)


def test_the_other_one_is_not_the_same():
    assert picked("pick up the leftmost red block", "pick up the other red block") == (REDS[1],)
    assert picked("pick up the leftmost red block", "pick up the other one") == (REDS[1],)


def test_what_is_seen_replaces_what_was_expected():
    conversation, _ = talked("pick up the leftmost block")
    left, right = BY_LEFT[0], BY_LEFT[-1]
    swapped = {left.id: left.moved(right.position), right.id: right.moved(left.position)}
    conversation.observe(scene().with_objects(swapped.get(o.id, o) for o in scene().objects))
    assert conversation.say("pick up the leftmost block").actions[0].objects == (right.id,)


def test_nothing_is_handled_that_is_not_there():
    with pytest.raises(WorldError, match="b99"):
        Conversation(grounder(), scene()).handled(["b99"])


def test_an_empty_answer_is_refused_and_the_question_stays():
    conversation, _ = talked(WHICH)
    with pytest.raises(LanguageError):
        conversation.say("...")
    assert conversation.waits


words = st.lists(
    st.sampled_from(sorted(known_words() | {"yes", "no", "neither", "it", "wug"})), min_size=1, max_size=4
).map(" ".join)


@given(st.lists(words, min_size=1, max_size=4))
@example(["yes", "yes", "yes"])
@example(["wug"] * 4)
@settings(max_examples=40)
def test_no_question_is_asked_for_ever(answers):
    conversation = Conversation(grounder(), scene())
    question, repeated = conversation.say(WHICH).question, 0
    for answer in answers:
        result = conversation.say(answer)
        assert (result.question is not None) == (result.outcome == "ambiguous")
        assert result.instruction == answer
        assert conversation.waits <= (result.outcome == "ambiguous")
        repeated = repeated + 1 if result.question == question else 0
        question = result.question
        assert question is None or repeated <= PATIENCE


@pytest.mark.parametrize(
    ("answer", "reference"), [("the nearest one", "b3"), ("the farthest blue block", "b2"), ("the second one", "b3"),
                              ("the blue one on the right", "b3")],
)  # fmt: skip
def test_which_of_two_a_place_was_named_by_keeps_what_else_was_said_of_it(answer, reference):
    move = "put the red block on the left two blocks to the right of the blue block"
    conversation, asked = talked(move)
    assert asked.outcome == "ambiguous"
    assert conversation.waits
    assert asked.question is not None
    assert "nearest" in asked.question
    result = conversation.say(answer)
    assert result.outcome == "grounded"
    (action,) = result.actions
    there = scene()[reference].position
    assert action.objects == ("b1",)
    assert action.destination is not None
    assert action.destination.reference == (reference,)
    assert there[1] - action.destination.position[1] > 2 * 0.05  # to the right, two blocks off


def test_what_was_only_picked_up_goes_back_to_its_place():
    conversation, _ = talked("pick up the leftmost red block")
    result = conversation.say("put it back")
    assert result.outcome == "grounded"
    assert result.actions[0].destination.position == pytest.approx(scene()["b1"].position)


@pytest.mark.parametrize(("world", "text"), [("two_rows", "take the block"), ("twelve", "take the red block")])
def test_the_words_of_a_question_are_its_best_answer(world, text):
    conversation, asked = talked(text, world=world)
    assert asked.outcome == "ambiguous"
    named = asked.question.removeprefix("Do you mean ").removesuffix("?").split(", or ")[0].split(", ")
    for place, offer in enumerate(named[:2]):
        again, _ = talked(text, world=world)
        result = again.say(offer)
        assert result.outcome == "grounded", offer
        assert result.actions[0].objects == asked.alternatives[place].objects
    assert conversation.waits

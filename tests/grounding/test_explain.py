"""Explanations: their numbers are those that decided, their words name what told the answer apart."""

import functools
import json

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from PIL import Image

import models
from grounding import Grounder, World, load_world, make_object
from grounding.__main__ import main
from grounding.explanations import explain, told
from grounding.explanations.features import contexts
from grounding.explanations.picture import draw_explanation
from grounding.explanations.tracing import TracedReader
from grounding.explanations.wording import negated
from grounding.features.explained import ROLES
from grounding.graded.discourse import read_text
from grounding.inference.engine import sigmoid
from grounding.pictures.palette import MARKS
from grounding.pictures.shades import CloseView, Panel, draw_panels
from grounding.symbols import ObjectSymbol
from grounding.world import Viewpoint

ASKED = [
    ("seven", "pick up the leftmost red block"), ("seven", "take the blue block behind the red block"),
    ("default", "pick up the middle block in the row of five blocks on the right"), ("tower", "grab the top block"),
    ("groups", "take the second block from the left in the row"), ("four", "pick up the block"),
    ("tower", "put the leftmost block on the red block closest to you"), ("twelve", "clear the green blocks"),
    ("tower", "there is a tower. take its top block"), ("scattered", "pick up the three nearest blocks"),
    ("seven", "sing a song"), ("four", "pick up the green block"), ("tower", "grab the block on my left"),
    ("default", "the block that is farthest away from you"), ("seven", "it"), ("seven", "take the wug next to it"),
]  # fmt: skip
asked = pytest.mark.parametrize(("name", "text"), ASKED)


@functools.cache
def grounder():
    return Grounder.load()


@functools.cache
def scene(name):
    return load_world(models.SCENES / f"{name}.json")


def across(name):
    """A scene with a speaker on the other side of the table."""
    return World(scene(name).objects, Viewpoint(np.array([1.6, 0.0, 0.0]), np.pi))


@asked
def test_the_answer_is_the_same_with_and_without(name, text):
    result, explanation = explain(grounder(), text, scene(name))
    assert result == grounder().ground(text, scene(name)).timed(0.0)
    told_of = {explanation.answer.objects} if explanation.answer else set()
    assert {action.objects for action in result.actions} <= told_of
    assert [p.text for p in explanation.phrases] == [p.text for p in result.phrases]


@asked
def test_features_add_up_to_what_inference_decided_on(name, text):
    understanding = grounder().understand(text, scene(name))
    reading = understanding.readings[0]
    model = grounder().inference.model
    parts = {id(p): h for p, h in _aligned(reading.inference.tree, reading.hypothesis)}
    for phrase, _, context in contexts(model, reading.inference.tree, reading.hypothesis, understanding.scene.layout):
        for symbol in context.symbols:
            expected = parts[id(phrase)].probabilities.get(symbol)
            if expected is not None:
                assert context.judged(symbol).probability == pytest.approx(expected, abs=1e-6)
                rival = context.runner_up(symbol)
                if rival is not None:
                    gap = context.judged(rival).log_odds - context.judged(symbol).log_odds
                    assert sum(c.weight for c in context.lost(symbol, rival)) == pytest.approx(gap, abs=1.0)
        for candidates in context.families.values():
            for symbol in candidates.roles:
                assert 0 <= sigmoid(candidates.log_odds(symbol)) <= 1


def _aligned(phrase, hypothesis):
    yield phrase, hypothesis
    for child, part in zip(phrase.phrases, hypothesis.children, strict=True):
        yield from _aligned(child, part)


@asked
def test_a_traced_reader_reads_the_same(name, text):
    understanding = grounder().understand(text, scene(name))
    for reading in understanding.graded.readings:
        tree = understanding.parses[reading.place].tree
        traced = TracedReader(understanding.scene, reading.reader.view, ())
        told_again = read_text(tree, traced)
        np.testing.assert_array_equal(told_again.target, reading.told.target)


@asked
def test_an_explanation_is_plain_json_and_lines(name, text):
    result, explanation = explain(grounder(), text, scene(name))
    data = json.loads(json.dumps(explanation.to_json()))
    assert {"parse", "mended", "viewpoint", "answer", "rivals", "phrases"} <= set(data)
    for phrase in data["phrases"]:
        for name_, weight in ((phrase["graded"] or {}).get("weights") or {}).items():
            assert name_ in scene(name).by_id
            assert 0 <= weight <= 1
        for symbol in phrase["symbols"]:
            assert all(feature["weight"] > 0 for feature in symbol["for"])
            assert all(feature["weight"] < 0 for feature in symbol["against"])
    lines = told(explanation, bool(result.actions))
    assert all("\n" not in line and "<" not in line.replace("<side>", "").replace("<ordinal>", "") for line in lines)


@pytest.mark.parametrize(
    ("name", "text", "loser", "says"),
    [
        ("seven", "pick up the leftmost red block", "b4", 'agrees less with "leftmost"'),
        ("seven", "take the blue block behind the red block", "b5", 'agrees less with "behind the red block"'),
        ("seven", "pick up the block closest to you", "b3", 'agrees less with "closest to you"'),
        ("groups", "take the second block from the left in the row", "b2", 'agrees less with "in the row"'),
    ],
)
def test_why_the_runner_up_lost(name, text, loser, says):
    _, explanation = explain(grounder(), text, scene(name))
    rival = next(r for r in explanation.rivals if r.option.objects == (loser,))
    assert any(says in reason.text and reason.weight < 0 for reason in rival.reasons), rival.reasons
    assert any(says in line for line in told(explanation))


def test_the_factors_say_why_too():
    _, explanation = explain(grounder(), "pick up the leftmost red block", scene("seven"))
    (rival,) = explanation.rivals
    assert rival.features[0].text == 'it is not, of all red blocks, the first along "left"'
    assert rival.features[0].weight < -5


def test_a_colour_is_said_without_numbers():
    table = scene("four")["table"]
    world = World((table, make_object("a", color="red", position=(0.6, 0.1, 0.736)),
                   make_object("b", color="blue", position=(0.6, -0.1, 0.736))))  # fmt: skip
    _, explanation = explain(grounder(), "take the red block", world)
    assert [reason.text for reason in explanation.rivals[0].reasons] == ["b is not red"]


def test_mended_words_and_viewpoints_are_said():
    _, explanation = explain(grounder(), "pick up the leftmost red blok", scene("seven"))
    assert explanation.mended == (("blok", "block"),)
    assert explanation.viewpoint == "directions are as the robot sees them"
    assert explain(grounder(), "pick up the red block", scene("seven"))[1].viewpoint == ""
    _, theirs = explain(grounder(), "pick up the leftmost block on my right", across("tower"))
    right = next(p for p in theirs.phrases if p.text == "my right")
    assert right.weighed.note == "as the speaker sees it"
    assert right.weighed.likely[0][0] == ("b9",)  # the robot's leftmost


def test_equals_are_not_told_apart():
    result, explanation = explain(grounder(), "pick up the block", scene("four"))
    assert result.outcome == "ambiguous"
    assert all(not rival.reasons and not rival.features for rival in explanation.rivals)
    assert any("nothing that was said tells it apart" in line for line in told(explanation, False))


@given(st.permutations(range(7)))
@settings(max_examples=5)
def test_the_order_of_objects_changes_no_word(order):
    things = [scene("seven").objects[i] for i in range(len(scene("seven").objects))]
    base = explain(grounder(), "take the blue block behind the red block", scene("seven"))[1]
    shuffled = World(tuple(things[i] for i in order if i < len(things)) + tuple(things[len(order) :]))
    assert told(explain(grounder(), "take the blue block behind the red block", shuffled)[1]) == told(base)


def test_every_meaning_can_be_denied():
    for form in ROLES:
        assert negated(form.meaning) != form.meaning


# Pictures


def test_a_picture_rings_the_answer(tmp_path):
    result, explanation = explain(grounder(), "pick up the leftmost red block", scene("seven"))
    image = np.asarray(draw_explanation(scene("seven"), result, explanation), dtype=int)
    assert (np.abs(image - MARKS[0]).max(axis=2) <= 8).any()


def test_heavier_objects_are_stronger():
    blocks = [make_object(f"b{i}", color="blue", position=(0.6, 0.3 - 0.2 * i, 0.736)) for i in range(3)]
    world = World((scene("four")["table"], *blocks))
    image = np.asarray(draw_panels(world, [Panel("x", {"b0": 0.0, "b1": 0.5, "b2": 1.0})]), dtype=int)
    assert image.shape[1] == 1280
    left, middle, right = (image[:, part * 400 + 40 : part * 400 + 440] for part in range(3))
    blueness = [(strip[..., 2] - strip[..., 0]).max() for strip in (left, middle, right)]
    assert blueness[0] < blueness[1] < blueness[2]


@given(st.lists(st.tuples(st.floats(0.2, 1.2), st.floats(-1, 1)), max_size=6))
@settings(max_examples=20)
def test_every_object_is_inside_its_panel(places):
    world = World(tuple(make_object(f"b{i}", position=(*p, 0.736)) for i, p in enumerate(places)))
    view = CloseView(world, 400)
    for item in world.things:
        x, y = view(item.position)[0]
        assert 0 <= x <= 400
        assert 0 <= y <= view.height


@pytest.mark.parametrize("text", ["pick up the leftmost block", "sing a song", "pick up the green block"])
def test_any_outcome_has_a_picture(text, tmp_path, capsys):
    path = tmp_path / "why.png"
    main(["ground", text, "--world", str(models.SCENES / "four.json"), "--picture", str(path)])
    with Image.open(path) as image:
        assert image.width == 1280
    assert "phrases:" not in capsys.readouterr().out


# The command


def test_the_command_adds_an_object_to_json_only_when_asked(capsys):
    arguments = ["ground", "pick up the rightmost block", "--world", str(models.SCENES / "four.json"), "--json"]
    assert main(arguments) == 0
    plain = json.loads(capsys.readouterr().out)
    assert main([*arguments, "--explain"]) == 0
    data = json.loads(capsys.readouterr().out)
    assert plain["explanation"] == data["explanation"]["sentence"]
    assert data["explanation"]["answer"]["objects"] == ["b4"]
    assert set(plain) == set(data)


@pytest.mark.parametrize(("path", "says"), [("why.bmp", ".png"), ("missing/why.png", "does not exist")])
def test_a_picture_that_cannot_be_written_is_refused_in_a_line(path, says, tmp_path, capsys):
    assert main(["ground", "pick up the block", "--picture", str(tmp_path / path)]) == 2
    told_ = capsys.readouterr()
    assert told_.out == ""
    (line,) = told_.err.splitlines()
    assert line.startswith("error: ")
    assert says in line


def test_symbols_of_objects_come_with_features():
    _, explanation = explain(grounder(), "pick up the rightmost block", scene("four"))
    judged = [j for p in explanation.phrases for j in p.symbols if j.symbol == ObjectSymbol("b4")]
    assert judged
    assert all(j.pros and j.log_odds > 0 for j in judged)

"""Explanations: their numbers are those that decided, their words name what told the answer apart."""

import functools
import json
from dataclasses import dataclass

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from PIL import Image

import models
from grounding import World, load_world, make_object
from grounding.__main__ import main
from grounding.explanations import explain, told
from grounding.explanations.candidates import compared, of_readings
from grounding.explanations.picture import draw_explanation
from grounding.explanations.wording import feature_text
from grounding.geometry.layout import Layout
from grounding.grounder import Understanding
from grounding.language.parser import Parse, Parser
from grounding.meaning.notation import parse_meaning
from grounding.model.belief import Belief, believe, read
from grounding.model.cases import Weights
from grounding.model.evaluator import EVEN
from grounding.pictures.palette import MARKS
from grounding.pictures.shades import CloseView, Panel, draw_panels
from grounding.result import GroundedAction, Grounding
from grounding.world import Viewpoint
from grounding.world.scene import Scene

WEIGHTS = Weights({**EVEN, "nothing": -3.4, "parse": 0.7, "set.those": 1.0, "outside": 1.0, "spread": 0.5,
                   "within": 1.0, "nothing.within": -0.5, "view.robot.nobody": 1.5,
                   "view.speaker.nobody": -1.5})  # fmt: skip
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


@dataclass(frozen=True, eq=False)
class Read:
    """A text that was read, whose likeliest option is taken where it is much likelier than the next."""

    text: str
    parses: tuple[Parse, ...]
    scene: Scene
    belief: Belief

    def decided(self):
        found = [GroundedAction(self.belief.kinds[o][0][0], o, p) for o, p in self.belief.options if o]
        if not found or not self.belief.options[0][0]:
            return Grounding(self.text, "no_referent", explanation="nothing here is meant")
        if len(found) > 1 and found[0].probability < 1.6 * found[1].probability:
            return Grounding(self.text, "ambiguous", alternatives=tuple(found[:3]))
        return Grounding(self.text, "grounded", tuple(found[:1]))


class Reads:
    weights = WEIGHTS

    def __init__(self):
        self.parser = Parser.load()

    def understand(self, text, world, history=()):
        parses, measured = tuple(self.parser.parse(text, 4)), Scene(Layout(world))
        return Read(text, parses, measured, believe(read(parses, measured, history, WEIGHTS), WEIGHTS))


@functools.cache
def grounder():
    return Reads()


@functools.cache
def scene(name):
    return load_world(models.SCENES / f"{name}.json")


@functools.cache
def explained(name, text):
    return explain(grounder(), text, scene(name))


def across(name):
    """A scene with a speaker on the other side of the table."""
    return World(scene(name).objects, Viewpoint(np.array([1.6, 0.0, 0.0]), np.pi))


@asked
def test_the_answer_is_the_same_with_and_without(name, text):
    result, explanation = explained(name, text)
    assert result == grounder().understand(text, scene(name)).decided()
    told_of = {explanation.answer.objects} if explanation.answer else set()
    assert {action.objects for action in result.actions} <= told_of


@asked
def test_features_add_up_to_what_decided(name, text):
    belief = grounder().understand(text, scene(name)).belief
    candidates = [of_readings(belief.readings, objects, WEIGHTS) for objects, _ in belief.options[:4]]
    for answer in candidates:
        for rival in candidates:
            gap = sum(c.weight for c in compared(answer, rival, WEIGHTS))
            assert gap == pytest.approx(rival.score - answer.score, abs=1e-9)


@asked
def test_the_lines_of_the_meaning_read_back(name, text):
    _, explanation = explained(name, text)
    if explanation.meaning:
        meaning = parse_meaning("\n".join(line.text for line in explanation.meaning))
        assert explanation.answer is None or meaning.kind == explanation.answer.action


@asked
def test_an_explanation_is_plain_json_and_lines(name, text):
    result, explanation = explained(name, text)
    data = json.loads(json.dumps(explanation.to_json()))
    assert {"parse", "mended", "viewpoint", "answer", "rivals", "phrases", "meaning", "missing"} <= set(data)
    for phrase in data["phrases"]:
        for block, weight in ((phrase["meant"] or {}).get("weights") or {}).items():
            assert block in scene(name).by_id
            assert 0 <= weight <= 1
    for line in data["meaning"]:
        for degrees in line["degrees"]:
            assert all(0 <= degrees[key] <= 1 for key in ("truth", "preference", "rank") if key in degrees)
    for rival in data["rivals"]:
        assert all(reason["weight"] <= 0 or reason["text"].startswith(" ".join(rival["objects"]))
                   for reason in rival["lost"])  # fmt: skip
    lines = told(explanation, bool(result.actions))
    assert all("\n" not in line and "<" not in line for line in lines)


@pytest.mark.parametrize(
    ("name", "text", "loser", "says"),
    [
        ("seven", "pick up the leftmost red block", "b1", 'agrees less with "left most"'),
        ("seven", "take the blue block behind the red block", "b5", 'agrees less with "behind the red block"'),
        ("seven", "pick up the block closest to you", "b1", 'agrees less with "nearest to you"'),
        ("groups", "take the second block from the left in the row", "b2", 'agrees less with "in the row"'),
    ],
)
def test_why_the_runner_up_lost(name, text, loser, says):
    _, explanation = explained(name, text)
    rival = next(r for r in explanation.rivals if r.option.objects == (loser,))
    assert any(says in reason.text and reason.weight < 0 for reason in rival.reasons), rival.reasons
    assert any(says in line for line in told(explanation))
    assert rival.features[0].weight < 0


def test_a_condition_has_the_degrees_of_the_answer_and_of_the_runner_up():
    _, explanation = explained("seven", "take the blue block behind the red block")
    (line,) = (line for line in explanation.meaning if "toward back" in line.text)
    (answer, own), (rival, other) = line.degrees
    assert (answer, rival) == (("b7",), ("b5",))
    assert own.truth > 0.5 > other.truth
    (red,) = (line for line in explanation.meaning if line.name == "x2" and line.likely)
    assert {name for names, _ in red.likely for name in names} <= {
        item.id for item in scene("seven").things if item.color == "red"
    }


def test_a_colour_is_said_without_numbers():
    world = World((scene("four")["table"], make_object("a", color="red", position=(0.6, 0.1, 0.736)),
                   make_object("b", color="blue", position=(0.6, -0.1, 0.736))))  # fmt: skip
    _, explanation = explain(grounder(), "take the red block", world)
    assert [reason.text for reason in explanation.rivals[0].reasons] == ["b is not red"]


@pytest.mark.parametrize(
    ("name", "text", "says"),
    [
        ("four", "pick up the green block", "nothing here is green"),
        ("four", "pick up the block behind the green block", "nothing here is green"),
    ],
)
def test_what_is_missing_is_said(name, text, says):
    _, explanation = explained(name, text)
    assert says in explanation.missing
    assert any(says in line for line in told(explanation, False))
    assert explanation.nothing > 0.3


def test_mended_words_and_viewpoints_are_said():
    _, explanation = explained("seven", "pick up the leftmost red blok")
    assert explanation.mended == (("blok", "block"),)
    assert explanation.viewpoint == "directions are as the robot sees them"
    assert explained("seven", "pick up the red block")[1].viewpoint == ""
    _, theirs = explain(grounder(), "pick up the leftmost block on my right", across("tower"))
    right = next(p for p in theirs.phrases if p.text == "my right")
    assert right.weighed.note == "as the speaker sees it"
    assert right.weighed.likely[0][0] == ("b9",)  # the robot's leftmost


def test_equals_are_not_told_apart():
    result, explanation = explained("four", "pick up the block")
    assert result.outcome == "ambiguous"
    assert all(not rival.reasons and not rival.features for rival in explanation.rivals)
    assert any("nothing that was said tells it apart" in line for line in told(explanation, False))


@given(st.permutations(range(7)))
@settings(max_examples=5, deadline=None)
def test_the_order_of_objects_changes_no_word(order):
    things = scene("seven").objects
    base = explained("seven", "take the blue block behind the red block")[1]
    shuffled = World(tuple(things[i] for i in order if i < len(things)) + tuple(things[len(order) :]))
    assert told(explain(grounder(), "take the blue block behind the red block", shuffled)[1]) == told(base)


def test_every_feature_has_words_of_its_own():
    names = {"T.toward", "T.toward<0.15", "T.not.toward", "P.at.side.ranked", "R.side", "R.side.nth", "best.colour",
             "R.set.size", "view.robot.you", "form.line.evident", "nothing", "nothing.goal<0.5", "sole", "P.ranked",
             "sole.chosen", "T.beside", "T.beside:next", "set.member", "set.those", "buried.vertical"}  # fmt: skip
    for reading in grounder().understand("take the leftmost red block in the row", scene("seven")).belief.readings:
        for case in (*reading.cases, reading.nothing):
            names |= {*case.scalars, *case.columns}
    assert len({feature_text(name) for name in names}) == len(names)


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


# The command

needs_grounder = pytest.mark.skipif(
    "belief" not in Understanding.__dataclass_fields__ or not models.BELIEFS.is_file(),
    reason="the grounder has no weights of meanings yet",
)


@needs_grounder
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


@needs_grounder
@pytest.mark.parametrize("text", ["pick up the leftmost block", "sing a song", "pick up the green block"])
def test_any_outcome_has_a_picture(text, tmp_path, capsys):
    path = tmp_path / "why.png"
    main(["ground", text, "--world", str(models.SCENES / "four.json"), "--picture", str(path)])
    with Image.open(path) as image:
        assert image.width == 1280
    assert "phrases:" not in capsys.readouterr().out

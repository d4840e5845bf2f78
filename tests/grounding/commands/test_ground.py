"""`python -m grounding ground`: the answer on standard output, and an exit code that tells the outcome."""

import json

import pytest

import models
from grounding.__main__ import main
from grounding.commands.ground import describe
from grounding.result import Destination, GroundedAction, Grounding

FOUR = str(models.SCENES / "four.json")


def test_the_default_scene_is_the_papers(capsys):
    assert main(["ground", "pick up the middle block in the row of five blocks on the right"]) == 0
    told = capsys.readouterr()
    assert told.out.startswith("grounded\n  pick b3  (")
    assert told.err == ""


def test_json_is_all_there_is(capsys):
    assert main(["ground", "pick up the rightmost block", "--world", FOUR, "--json"]) == 0
    told = capsys.readouterr()
    data = json.loads(told.out)
    assert told.err == ""
    assert data["outcome"] == "grounded"
    assert data["actions"][0]["objects"] == ["b4"]
    assert data["actions"][0]["destination"] is None


@pytest.mark.parametrize(
    ("text", "outcome"),
    [("sing a song", "not_understood"), ("pick up the green block", "no_referent"), ("pick up the block", "ambiguous")],
)
def test_what_is_not_grounded_has_its_own_exit_code(capsys, text, outcome):
    assert main(["ground", text, "--world", FOUR, "--json"]) == 3
    assert json.loads(capsys.readouterr().out)["outcome"] == outcome
    assert main(["ground", text, "--world", FOUR]) == 3
    assert capsys.readouterr().out.startswith(f"{outcome}: ")


def test_phrases_are_explained(capsys):
    assert main(["ground", "pick up the rightmost block", "--world", FOUR, "--explain"]) == 0
    plain = capsys.readouterr().out
    assert "NP 'the rightmost block': " in plain
    assert "object(b4)" in plain


@pytest.mark.parametrize("text", ["", "  ", "..."])
def test_an_empty_instruction_is_refused_in_a_line(capsys, text):
    assert main(["ground", text]) == 2
    told = capsys.readouterr()
    assert told.out == ""
    assert len(told.err.splitlines()) == 1
    assert "expected an instruction" in told.err


@pytest.mark.parametrize(
    ("content", "says"),
    [
        (None, "no such world file"), ('{"objects": [', "truncated"),
        ('{"objects": [{"id": "b1"}]}', "'type' is missing"),
        ('{"objects": [{"id": "b1", "type": "block", "color": "red", "position": [NaN, 0, 0],'
         ' "orientation": [1, 0, 0, 0], "size": [1, 1, 1]}]}', "object 'b1': 'position' holds nan"),
    ],
)  # fmt: skip
def test_a_wrong_world_file_is_refused_in_a_line(capsys, tmp_path, content, says):
    path = tmp_path / "world.json"
    if content is not None:
        path.write_text(content, encoding="utf-8")
    assert main(["ground", "pick up the block", "--world", str(path), "--json"]) == 2
    told = capsys.readouterr()
    assert told.out == ""
    (line,) = told.err.splitlines()
    assert line.startswith(f"error: {path}")
    assert says in line


def test_a_world_without_blocks(capsys, tmp_path):
    path = tmp_path / "world.json"
    path.write_text('{"objects": []}', encoding="utf-8")
    assert main(["ground", "pick up the block", "--world", str(path)]) == 3
    assert capsys.readouterr().out == "no_referent: there is nothing on the table\n"


def test_people_are_told_everything():
    place = GroundedAction("place", ("b1",), 0.25, Destination((0.1, -0.2, 0.3), "left", ("b2",)))
    result = Grounding(
        "x", "ambiguous", (), (place, GroundedAction("pick", ("b1", "b2"), 0.5)), "Which?", "two", ("wug",)
    )
    assert describe(result) == [
        "ambiguous: two", "  Which?", "  readings:", "    place b1 to (0.100, -0.200, 0.300) m, left of b2  (0.25)",
        "    pick b1 b2  (0.50)", "  unknown words: wug",
    ]  # fmt: skip

"""`python -m grounding dialogue`: lines in, what was understood out, until the input ends."""

import io
import json
import subprocess
import sys

import pytest

import models
from grounding.__main__ import main

FOUR = str(models.SCENES / "four.json")


def talk(monkeypatch, capsys, *lines, options=()):
    monkeypatch.setattr(sys, "stdin", io.StringIO("".join(f"{line}\n" for line in lines)))
    code = main(["dialogue", "--world", FOUR, *options])
    told = capsys.readouterr()
    return code, told.out.splitlines(), told.err


def test_a_question_and_its_answer(monkeypatch, capsys):
    code, told, error = talk(
        monkeypatch, capsys, "pick up the red block", "the left one", "put it on the rightmost block"
    )
    assert code == 0
    assert told[0].startswith("ambiguous: ")
    assert "Do you mean" in told[1]
    assert any(line.startswith("  pick b1") for line in told)
    assert any(line.startswith("  place b1 to ") for line in told)
    assert error == ""


def test_each_line_has_a_line_of_json(monkeypatch, capsys):
    lines = ["pick up the red block", "the second one", "", "sing a song", "...", "pick up teh leftmost block"]
    code, told, _ = talk(monkeypatch, capsys, *lines, options=["--json"])
    assert code == 0
    data = [json.loads(line) for line in told]
    assert [entry["instruction"] for entry in data] == [line for line in lines if line]
    assert [entry["outcome"] for entry in data] == [
        "ambiguous", "grounded", "not_understood", "not_understood", "grounded",
    ]  # fmt: skip
    assert data[-1]["mended"] == [["teh", "the"]]


def test_what_was_handled_before_is_known(monkeypatch, capsys):
    _, told, _ = talk(monkeypatch, capsys, "pick it up", options=["--json", "--history", "b2"])
    assert json.loads(told[0])["actions"][0]["objects"] == ["b2"]


def test_no_lines_are_no_conversation(monkeypatch, capsys):
    assert talk(monkeypatch, capsys) == (0, [], "")


def test_an_interrupt_ends_it(monkeypatch, capsys):
    class Interrupted(io.StringIO):
        def readline(self, *_):
            raise KeyboardInterrupt

    monkeypatch.setattr(sys, "stdin", Interrupted())
    assert main(["dialogue", "--world", FOUR]) == 0
    assert capsys.readouterr().out == ""


@pytest.mark.parametrize(
    ("options", "says"), [(["--history", "b9"], "b9"), (["--world", "nothing.json"], "nothing.json")]
)
def test_what_is_not_there_is_named(monkeypatch, capsys, options, says):
    code, told, error = talk(monkeypatch, capsys, "pick it up", options=options)
    assert (code, told) == (2, [])
    assert error.startswith("error: ")
    assert says in error


def test_it_runs_as_a_command():
    done = subprocess.run(
        [sys.executable, "-m", "grounding", "dialogue", "--world", FOUR], input="pick up the rightmost block\n",
        capture_output=True, text=True, timeout=60, check=False,
    )  # fmt: skip
    assert (done.returncode, done.stderr) == (0, "")
    assert done.stdout.startswith("grounded\n  pick b4")

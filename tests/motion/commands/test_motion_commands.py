import json

import pytest
from PIL import Image

from motion.__main__ import main

SMALL = ["--table", "0.6", "0", "0.691", "0.2", "0.4", "0.04", "--spacing", "0.1"]


def test_the_picture_is_written_and_summed_up(tmp_path, capsys):
    picture = tmp_path / "new" / "reach.png"
    assert main(["reach", *SMALL, "--output", str(picture), "--json"]) == 0
    answer = json.loads(capsys.readouterr().out)
    assert answer["picture"] == str(picture)
    assert answer["within_reach"]["either"] == 1
    with Image.open(picture) as image:
        assert image.width > 800


def test_a_place_is_asked_for(capsys):
    assert main(["reach", *SMALL, "--at", "0.6", "-0.1", "--json"]) == 0
    answer = json.loads(capsys.readouterr().out)
    assert {way["arm"] for way in answer["ways"]} == {"left", "right"}
    assert main(["reach", *SMALL, "--at", "0.6", "-0.1"]) == 0
    assert "right hand, tilted by 0 degrees" in capsys.readouterr().out


def test_what_is_out_of_reach_is_told_with_the_reason(capsys):
    far = ["--table", "1.1", "0", "0.691", "0.2", "0.2", "0.04", "--spacing", "0.2"]
    assert main(["reach", *far, "--at", "1.15", "0"]) == 4
    assert "too far" in capsys.readouterr().err


def test_inverse_kinematics_are_printed(capsys):
    assert main(["ik", "left", "0.6", "0.2", "0.8", "--json"]) == 0
    answer = json.loads(capsys.readouterr().out)
    assert list(answer["joints"]) == [f"left_{joint}" for joint in ("s0", "s1", "e0", "e1", "w0", "w1", "w2")]
    assert answer["position_error"] < 1e-4
    assert main(["ik", "right", "0.6", "-0.2", "0.8"]) == 0
    assert "right_w2" in capsys.readouterr().out


@pytest.mark.parametrize(
    ("arguments", "code", "message"),
    [
        (["ik", "left", "1.3", "0", "0.8"], 4, "too far"),
        (["ik", "left", "0.2", "0.3", "0.75"], 4, "left_e1 would have to be"),
        (["ik", "middle", "0.6", "0.2", "0.8"], 2, "'middle'"),
        (["ik", "left", "0.6", "0.2", "0.8", "--orientation", "1", "1", "0", "0"], 2, "norm 1.414"),
        (["ik", "left", "0.6", "0.2", "0.8", "--solver", "simplex"], 2, "'simplex'"),
        (["reach", "--at", "3", "0", *SMALL], 2, "not on the table"),
        (["reach", "--block", "60", *SMALL], 2, "60, 60 mm"),
        (["reach", "--output", "reach.txt", *SMALL], 2, ".png"),
        (["reach", "--table", "0.6", "0", "0.7", "0", "0.4", "0.04"], 2, "positive"),
    ],
)
def test_errors_are_one_line_and_an_exit_code(capsys, arguments, code, message):
    assert main(arguments) == code
    error = capsys.readouterr().err
    assert error.startswith("error: ")
    assert message in error
    assert error.count("\n") == 1


@pytest.mark.parametrize("arguments", [["reach", "--at", "nan", "0"], ["reach", "--block", "-5"], ["dance"]])
def test_bad_usage_is_told_by_the_parser(capsys, arguments):
    with pytest.raises(SystemExit) as caught:
        main(arguments)
    assert caught.value.code == 2
    assert "error:" in capsys.readouterr().err


def test_without_a_command_help_is_printed(capsys):
    assert main([]) == 2
    assert "reach" in capsys.readouterr().err

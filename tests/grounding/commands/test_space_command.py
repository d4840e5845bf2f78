"""`python -m grounding space`: a table for people, JSON for programs, and words for bad input."""

import json

import pytest

import models
from grounding.__main__ import main
from grounding.space import KINDS


def test_small_spaces_are_counted_twice(capsys):
    assert main(["space", "--objects", "4", "--types", "block", "--colors", "red,blue", "--json"]) == 0
    told = capsys.readouterr()
    data = json.loads(told.out)
    assert told.err == ""
    assert data["objects"] == 4
    assert data["colors"] == 2
    assert [kind["kind"] for kind in data["kinds"]] == [kind.name for kind in KINDS]
    assert all(kind["enumerated"] == kind["size"] for kind in data["kinds"])
    assert data["total"]["size"] == sum(kind["size"] for kind in data["kinds"])
    assert data["total"]["size"] == data["concrete"]["size"] + data["abstract"]["size"]


def test_large_spaces_are_counted_by_formula(capsys):
    assert main(["space", "--objects", "20"]) == 0
    out = capsys.readouterr().out
    containers = next(line for line in out.splitlines() if line.startswith("containers "))
    assert containers.split() == ["containers", "5,242,775", "-", "A", "S"]
    assert "not enumerated" in out


def test_huge_spaces_have_a_magnitude(capsys):
    assert main(["space", "--objects", "20000", "--json"]) == 0
    data = json.loads(capsys.readouterr().out)
    assert data["total"]["size"] is None
    assert data["total"]["log10_size"] == pytest.approx(20000 * 0.4771212547 + 1.778, abs=0.01)
    assert main(["space", "--objects", "20000"]) == 0
    assert "e9544" in capsys.readouterr().out


def test_a_world_brings_its_furniture(capsys):
    assert main(["space", "--world", str(models.SCENES / "four.json"), "--types", "", "--colors", "", "--json"]) == 0
    data = json.loads(capsys.readouterr().out)
    assert data["objects"] == 4
    assert data["furniture"] == 1
    assert data["types"] == 2
    assert all(kind["enumerated"] == kind["size"] for kind in data["kinds"])


def test_no_objects_are_a_space_too(capsys):
    assert main(["space", "--objects", "0"]) == 0
    assert "all symbols" in capsys.readouterr().out


@pytest.mark.parametrize(
    ("arguments", "says"),
    [
        (["--objects", "-1"], "-1 is below 0"),
        (["--objects", "four"], "'four' is no whole number"),
        (["--objects", "3.5"], "'3.5' is no whole number"),
        (["--objects", "1000001"], "too many"),
        (["--objects", "9" * 5000], "no whole number"),
        (["--objects", "3", "--types", "a,,b"], "'' is no label"),
        (["--objects", "3", "--colors", "red,red"], "twice"),
        (["--objects", "3", "--colors", "dark red"], "'dark red' is no label"),
        ([], "--objects"),
    ],
)
def test_bad_usage_is_said(capsys, arguments, says):
    with pytest.raises(SystemExit) as left:
        main(["space", *arguments])
    assert left.value.code == 2
    assert says in capsys.readouterr().err


def test_a_missing_world_is_said(capsys, tmp_path):
    assert main(["space", "--world", str(tmp_path / "none.json")]) == 2
    assert "no such world file" in capsys.readouterr().err

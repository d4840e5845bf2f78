"""`python -m grounding features`: counts add up, every form is told, and the page of documentation has them all."""

import json
from pathlib import Path

import numpy as np
import pytest

import models
from grounding.__main__ import main
from grounding.commands.features import PAPER, markdown_tables
from grounding.factors import Factor, FactorModel, load_model, save_model

PAGE = Path(__file__).parents[3] / "docs" / "features.md"


def run(capsys, *arguments):
    assert main(["features", *arguments]) == 0
    return capsys.readouterr().out


@pytest.fixture
def small(tmp_path):
    """Weights of two families, one of which has names that nobody has explained."""
    weights = np.array([[1.5, 0.0], [-2.0, 0.25]])
    factors = {
        "kind": Factor(("word=row", "wug fact"), ("named", "wug role"), weights),
        "action": Factor(("bias",), ("kind pick",), np.array([[0.5]])),
    }
    save_model(FactorModel(factors, {}), tmp_path / "weights")
    return tmp_path / "weights.npz"


def test_counts_of_forms_add_up_to_those_of_the_weights(capsys):
    data = json.loads(run(capsys, "--json"))
    model = load_model(models.WEIGHTS)
    assert data["features"] == model.feature_count == sum(entry["features"] for entry in data["families"])
    assert data["features"] == sum(entry["features"] for entry in data["facts"])
    assert data["features"] == sum(entry["features"] for entry in data["roles"])
    assert data["paper"] == PAPER
    assert data["unexplained"] == {"facts": [], "roles": []}
    assert sum(entry["count"] for entry in data["facts"]) == len({f for x in model.factors.values() for f in x.facts})


def test_one_family_alone(capsys):
    data = json.loads(run(capsys, "--family", "object", "--json"))
    factor = load_model(models.WEIGHTS).factors["object"]
    assert [entry["family"] for entry in data["families"]] == ["object"]
    assert sum(entry["count"] for entry in data["roles"]) == len(factor.roles)
    assert all(entry["families"] == ["object"] for entry in data["roles"])


def test_people_read_it_too(capsys):
    out = run(capsys)
    assert "binary features with a weight" in out
    assert "50,820" in out
    assert "  word=<word>  x " in out
    assert "unexplained" not in out
    assert max(map(len, out.splitlines())) <= 120


def test_what_has_no_form_is_listed_as_such(capsys, small):
    out = run(capsys, "--weights", str(small))
    assert "5 binary features" not in out
    assert "4 binary features with a weight, of 5 pairs" in out
    assert "unexplained  x 1, in 2 features:\n      wug fact" in out
    assert "unexplained  x 1, in 1 features [kind]:\n      wug role" in out
    data = json.loads(run(capsys, "--weights", str(small), "--json"))
    assert data["unexplained"] == {"facts": ["wug fact"], "roles": ["wug role"]}


def test_features_are_found_the_strongest_first(capsys, small):
    data = json.loads(run(capsys, "--weights", str(small), "--find", "WUG", "--json"))
    assert data["matching"] == 2
    assert [(f["fact"], f["role"], f["weight"]) for f in data["features"]] == [
        ("wug fact", "named", -2.0), ("wug fact", "wug role", 0.25),
    ]  # fmt: skip
    assert data["features"][0]["fact_means"] is None
    assert data["features"][0]["role_means"] == "an own word may name it"
    main(["features", "--weights", str(small.parent), "--find", "wug", "--limit", "1"])
    told = capsys.readouterr()
    assert told.out.startswith("  -2.000  kind: wug fact  x  named\n")
    assert "wug role" not in told.out
    assert told.err == "2 features match 'wug'; 1 shown\n"


def test_nothing_found_is_no_error(capsys, small):
    assert json.loads(run(capsys, "--weights", str(small), "--find", "quux", "--json"))["features"] == []


def test_the_page_has_every_form():
    """Renew it with `python -m grounding features --markdown`."""
    page = PAGE.read_text(encoding="utf-8")
    missing = [line for line in markdown_tables() if line not in page]
    assert not missing, f"docs/features.md lacks {missing[:5]}; python -m grounding features --markdown prints them"


@pytest.mark.parametrize(
    ("arguments", "says"),
    [
        (["--weights", "nowhere/weights.npz"], "no such weights"),
        (["--family", "wug"], "no family 'wug' in these weights; they have action"),
    ],
)
def test_bad_input_is_said_in_a_line(capsys, arguments, says):
    assert main(["features", *arguments]) == 2
    told = capsys.readouterr()
    assert told.out == ""
    assert says in told.err
    assert len(told.err.splitlines()) == 1


@pytest.mark.parametrize("arguments", [["--find", " "], ["--find", "x", "--limit", "0"], ["--limit", "some"]])
def test_bad_usage_is_said(capsys, arguments):
    with pytest.raises(SystemExit) as left:
        main(["features", *arguments])
    assert left.value.code == 2
    assert "error: " in capsys.readouterr().err

"""`python -m grounding train`: the same corpus gives the same bytes; what cannot be used leaves nothing behind."""

import json
from dataclasses import replace

import pytest

import models
from grounding import Grounder, load_world
from grounding.__main__ import main
from grounding.corpus.format import read_corpus
from grounding.factors import load_model, save_model
from grounding.language.grammar import Grammar

FILES = ["grammar.json", "grammar.tables", "weights.json", "weights.npz"]
TREES = (
    "(VP (VB pick) (PRT (RP up)) (NP (DT the) (JJ rightmost) (NN block)))",
    "(VP (VB take) (NP (DT the) (JJ leftmost) (NN block)))",
)


@pytest.fixture
def small(tmp_path):
    """A corpus of a few shipped examples and a folder of gold trees."""
    lines = (models.TREEBANK / "treebank.jsonl").read_text(encoding="utf-8").splitlines()[::600]
    (tmp_path / "small.jsonl").write_text("\n".join(lines) + "\n", encoding="utf-8")
    worlds = json.loads((models.TREEBANK / "treebank.worlds.json").read_text(encoding="utf-8"))
    used = {json.loads(line)["world"] for line in lines}
    (tmp_path / "small.worlds.json").write_text(json.dumps({name: worlds[name] for name in used}), encoding="utf-8")
    (tmp_path / "trees").mkdir()
    (tmp_path / "trees" / "a.trees").write_text("# two sentences\n" + "\n".join(TREES) + "\n", encoding="utf-8")
    return tmp_path


def train(folder, output, *more):
    return main(["train", "--corpus", str(folder / "small.jsonl"), "--trees", str(folder / "trees"), "--output",
                 str(output), "--variants", "0", "--sampled", "20", *more])  # fmt: skip


def test_the_same_corpus_gives_the_same_bytes(small, capsys):
    for name in ("first", "second"):
        assert train(small, small / name) == 0
    assert sorted(path.name for path in (small / "first").iterdir()) == FILES
    for name in FILES:
        assert (small / "first" / name).read_bytes() == (small / "second" / name).read_bytes()
    told = capsys.readouterr()
    summary = [json.loads(line) for line in told.out.splitlines()]
    assert [line["examples"] for line in summary] == [len(read_corpus(small / "small.jsonl"))] * 2
    assert summary[0]["features"] > 0
    assert "factors" in told.err
    grounder = Grounder.load(small / "first" / "grammar.json")
    result = grounder.ground("take the leftmost block", load_world(models.SCENES / "four.json"))
    assert result.outcome in ("grounded", "ambiguous", "no_referent", "not_understood")


def test_a_first_pass_is_added_to_factors_that_stay(small, capsys):
    assert train(small, small / "out") == 0
    whole = load_model(small / "out" / "weights")
    save_model(replace(whole, first_pass=None), small / "out" / "weights")
    before = load_model(small / "out" / "weights")
    assert train(small, small / "out", "--first-pass-only") == 0
    again = load_model(small / "out" / "weights")
    assert before.first_pass is None
    assert again.first_pass.threshold == whole.first_pass.threshold
    assert again.first_pass.factor.facts == whole.first_pass.factor.facts
    for name, factor in before.factors.items():
        assert (again.factors[name].weights == factor.weights).all()
    assert json.loads(capsys.readouterr().out.splitlines()[-1])["features of the first pass"] > 0


def test_a_first_pass_needs_factors_beside_it(small, capsys):
    assert train(small, small / "out", "--first-pass-only") == 2
    assert "no such weights" in capsys.readouterr().err


def test_the_grammar_can_be_learned_alone(small, capsys):
    assert train(small, small / "out", "--grammar-only") == 0
    assert sorted(path.name for path in (small / "out").iterdir()) == FILES[:2]
    assert train(small, small / "more", "--grammar-only", "--sampled", "60") == 0
    fewer, more = (Grammar.read(small / name / FILES[0]).words.words_seen for name in ("out", "more"))
    assert more > fewer
    assert [json.loads(line)["sampled"] for line in capsys.readouterr().out.splitlines()] == [20, 60]


@pytest.mark.parametrize(
    "option",
    [("--penalty", "-1"), ("--penalty", "nan"), ("--penalty", "much"), ("--variants", "-2"), ("--sampled", "-1")],
)
def test_settings_that_make_no_sense_are_refused(small, option):
    with pytest.raises(SystemExit) as left:
        train(small, small / "out", *option)
    assert left.value.code == 2
    assert not (small / "out").exists()


def refused(capsys):
    told = capsys.readouterr()
    assert told.out == ""
    return told.err.splitlines()


def test_a_missing_corpus_is_named(small, capsys):
    (small / "small.jsonl").unlink()
    assert train(small, small / "out") == 2
    (line,) = refused(capsys)
    assert "small.jsonl" in line
    assert not (small / "out").exists()


def test_a_bad_line_of_a_corpus_is_named(small, capsys):
    path = small / "small.jsonl"
    path.write_text(path.read_text(encoding="utf-8") + "nonsense\n", encoding="utf-8")
    assert train(small, small / "out") == 2
    lines = refused(capsys)
    number = len(path.read_text(encoding="utf-8").splitlines())
    assert any("small.jsonl" in line and str(number) in line for line in lines)
    assert not (small / "out").exists()


def test_a_bad_tree_is_named_with_its_line(small, capsys):
    (small / "trees" / "b.trees").write_text(TREES[0] + "\n(NP (DT the)\n", encoding="utf-8")
    assert train(small, small / "out") == 2
    (line,) = refused(capsys)
    assert "b.trees, line 2" in line
    assert not (small / "out").exists()


def test_a_folder_without_trees_is_named(small, capsys):
    (small / "trees" / "a.trees").unlink()
    assert train(small, small / "out") == 2
    assert "no *.trees files" in refused(capsys)[0]


def test_several_corpora_and_generated_examples_are_learned_from_together(small, capsys):
    for ending in (".jsonl", ".worlds.json"):
        (small / f"other{ending}").write_bytes((small / f"small{ending}").read_bytes())
    shipped = len(read_corpus(small / "small.jsonl"))
    both = ["--corpus", str(small / "small.jsonl"), str(small / "other.jsonl")]
    assert train(small, small / "both", *both) == 0
    assert train(small, small / "more", "--generated", "6", "--seed", "1", "--hold-out") == 0
    counts = [json.loads(line)["examples"] for line in capsys.readouterr().out.splitlines()]
    assert counts[0] == 2 * shipped
    assert 0 < counts[1] <= shipped + 6

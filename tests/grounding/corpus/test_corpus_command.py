"""`python -m grounding corpus`: what it prints, its exit codes, one line for an error and never a traceback."""

import json
import subprocess
import sys

import numpy as np
import pytest

from grounding.__main__ import main
from grounding.commands import SUMMARIES
from grounding.corpus import Corpus, Example, read_corpus, write_corpus
from grounding.corpus.composer import compose
from grounding.corpus.pretty import Paint, pretty
from grounding.language.tree import from_brackets
from grounding.symbols import parse_symbols
from grounding.world import load_world


def make(name, tree, world="w"):
    root, notes = from_brackets(tree)
    return Example(name, world, root.text, root, tuple(parse_symbols(note) for note in notes))


@pytest.fixture
def path(tmp_path):
    rng = np.random.default_rng(5)
    worlds = {"w": compose(rng, 5).world, "v": compose(rng, 9).world}
    examples = (
        make("one", "(VP {action(pick; b1)} (VB lift) (NP {object(b1) type(block)} (DT this) (NN cube)))"),
        make("two", "(NP {object(b7)} (DT that) (NN cube))", "v"),
    )
    write_corpus(Corpus(examples, worlds), tmp_path / "small.jsonl")
    return tmp_path / "small.jsonl"


def run(*arguments):
    return main(["corpus", *map(str, arguments)])


def refused(capsys):
    """The error's line; nothing else was said."""
    output = capsys.readouterr()
    assert output.out == ""
    lines = output.err.splitlines()
    assert all(line.startswith("error: ") for line in lines)
    return "\n".join(lines)


def test_show_prints_every_phrase_and_symbol_without_colour(path, capsys):
    assert run("show", path) == 0
    text = capsys.readouterr().out
    for part in ("one", "two", "lift this cube", "NP this/DT cube/NN", "object(b1)", "action(pick; b1)", "type(block)"):
        assert part in text
    assert "\033" not in text


def test_show_can_be_limited(path, capsys):
    assert run("show", path, "--id", "two") == 0
    assert "lift" not in capsys.readouterr().out
    assert run("show", path, "--limit", "1") == 0
    assert "that cube" not in capsys.readouterr().out


def test_colour_changes_nothing_but_colour(path):
    for example in read_corpus(path):
        coloured = pretty(example, Paint(True))
        for code in ("0", "1", "2", "33", "35", "36"):
            coloured = coloured.replace(f"\033[{code}m", "")
        assert coloured == pretty(example)


def test_check_of_a_sound_corpus(path, capsys):
    assert run("check", path, "--json") == 0
    assert json.loads(capsys.readouterr().out) == {
        "examples": 2, "worlds": 2, "phrases": 3, "refused": [], "findings": []
    }  # fmt: skip


def test_check_says_what_it_finds(path, capsys):
    path.write_text(path.read_text().replace("lift this", "drop this", 1))
    assert run("check", path) == 1
    assert "one: word 1 is 'lift' in the tree and 'drop' in the instruction [words]" in capsys.readouterr().out
    assert run("check", path, "--json") == 1
    assert [finding["check"] for finding in json.loads(capsys.readouterr().out)["findings"]] == ["words"]


def test_check_keeps_going(path, capsys):
    path.write_text(path.read_text().replace("(VP", "VP").replace("b7", "b70"))
    assert run("check", path) == 2
    assert len(refused(capsys).splitlines()) == 1
    assert run("check", path, "--keep-going") == 2
    assert [f"line {n}" in line for n, line in enumerate(refused(capsys).splitlines(), 1)] == [True, True]
    assert run("check", path, "--keep-going", "--json") == 2
    assert len(json.loads(capsys.readouterr().out)["refused"]) == 2


def test_worlds_are_listed(path, capsys):
    assert run("worlds", path) == 0
    lines = capsys.readouterr().out.splitlines()
    assert [line.split("\t")[0] for line in lines] == ["w", "v"]
    assert "9 objects" in lines[1]


def test_convert_writes_a_corpus_or_a_world(path, tmp_path, capsys):
    assert run("convert", path, "--output", tmp_path / "copy.jsonl", "--shift", "-0.1") == 0
    assert (tmp_path / "copy.jsonl").read_text() == path.read_text()
    before, after = read_corpus(path).worlds["v"], read_corpus(tmp_path / "copy.jsonl").worlds["v"]
    np.testing.assert_allclose(after.positions - before.positions, [[-0.1, 0, 0]] * 9, atol=1e-12)
    for choice in (("--world", "v"), ("--id", "two")):
        assert run("convert", path, "--output", tmp_path / "v.json", *choice) == 0
        np.testing.assert_array_equal(load_world(tmp_path / "v.json").positions, before.positions)
    capsys.readouterr()
    assert run("convert", path, "--output", tmp_path / "v.json") == 2
    assert "name one with --world or --id; this corpus has w, v" in refused(capsys)
    assert run("convert", path, "--output", tmp_path / "v.json", "--world", "x") == 2
    assert "no world 'x'" in refused(capsys)
    assert run("convert", path, "--output", tmp_path / "v.txt", "--world", "v") == 2
    assert "written to a .jsonl file" in refused(capsys)
    assert run("convert", path, "--output", tmp_path / "none" / "v.json", "--world", "v") == 2
    assert "none" in refused(capsys)


@pytest.mark.parametrize("arguments", [["show", "nowhere.jsonl"], ["check", "nowhere"], ["worlds", "/"]])
def test_files_that_are_not_there(arguments, capsys):
    assert run(*arguments) == 2
    assert arguments[1] in refused(capsys)


def test_an_example_that_is_not_there(path, capsys):
    assert run("show", path, "--id", "three") == 2
    assert "no example 'three'" in refused(capsys)


@pytest.mark.parametrize(
    "arguments",
    [["corpus"], ["corpus", "show", "--limit", "0"], ["corpus", "convert", "x"], ["sing"],
     ["corpus", "convert", "x", "--output", "y.json", "--shift", "nan"]],
)  # fmt: skip
def test_bad_usage(arguments, capsys):
    with pytest.raises(SystemExit) as caught:
        main(arguments)
    assert caught.value.code == 2
    assert "Traceback" not in capsys.readouterr().err


def test_without_a_command_the_commands_are_listed(capsys):
    assert main([]) == 2
    assert "corpus" in capsys.readouterr().err
    assert "corpus" in SUMMARIES


def test_an_interrupt_and_a_closed_pipe_have_their_codes(path, monkeypatch):
    def interrupt(*_):
        raise KeyboardInterrupt

    monkeypatch.setattr("grounding.commands.corpus.load_corpus", interrupt)
    assert run("show", path) == 130
    line = path.read_text().splitlines()[0]
    path.write_text("".join(line.replace('"one"', f'"{n}"') + "\n" for n in range(3000)))
    process = subprocess.Popen([sys.executable, "-m", "grounding", "corpus", "show", str(path)],
                               stdout=subprocess.PIPE, stderr=subprocess.PIPE)  # fmt: skip
    process.stdout.readline()
    process.stdout.close()
    with process.stderr:
        said = process.stderr.read()
    assert process.wait() == 141
    assert said == b""

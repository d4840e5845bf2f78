"""`python -m grounding batch`: a result a line, in input order; what is wrong is told at once, by file and line."""

import json

import numpy as np
import pytest

import models
from grounding import Grounder, World, load_world, make_object
from grounding.__main__ import main
from grounding.result import OUTCOMES
from grounding.world import world_to_json

KEYS = {"id", "instruction", "outcome", "actions", "alternatives", "question", "explanation", "unknown_words",
        "milliseconds", "phrases"}  # fmt: skip


@pytest.fixture
def files(tmp_path):
    worlds = {name: world_to_json(load_world(models.SCENES / f"{name}.json")) for name in ("four", "seven")}
    (tmp_path / "worlds.json").write_text(json.dumps(worlds), encoding="utf-8")
    return tmp_path


def run(folder, *lines, output="out.jsonl"):
    """Exit code and results; lines are texts or plain values."""
    texts = [line if isinstance(line, str) else json.dumps(line) for line in lines]
    (folder / "in.jsonl").write_text("\n".join(texts) + "\n", encoding="utf-8")
    code = main(["batch", "--worlds", str(folder / "worlds.json"), "--input", str(folder / "in.jsonl"), "--output",
                 str(folder / output)])  # fmt: skip
    path = folder / output
    return code, [
        json.loads(line) for line in path.read_text(encoding="utf-8").splitlines()
    ] if path.is_file() else None


def left(folder):
    return {path.name for path in folder.iterdir()} - {"worlds.json", "in.jsonl"}


LINES = [
    {"id": "z", "world": "seven", "instruction": "pick up the leftmost red block"},
    {"id": 1, "world": "four", "instruction": "sing a song"},
    {"id": "a", "world": "four", "instruction": "pick up the rightmost block", "history": ["b1"]},
    {"id": "z", "world": "four", "instruction": "pick up the rightmost block", "history": None},
    {"id": None, "world": "four", "instruction": ""},
]


def test_results_come_in_input_order(files, capsys):
    code, results = run(files, *LINES)
    assert code == 0
    assert [result["id"] for result in results] == [line["id"] for line in LINES]
    assert [result["instruction"] for result in results] == [line["instruction"] for line in LINES]
    assert all(set(result) == KEYS for result in results)
    assert [result["outcome"] for result in results] == [
        "grounded", "not_understood", "grounded", "grounded", "not_understood",
    ]  # fmt: skip
    assert left(files) == {"out.jsonl"}
    told = capsys.readouterr()
    assert told.out == ""
    assert "5 of 5" in told.err


def test_results_are_those_of_grounding_one_by_one(files):
    _, results = run(files, *LINES[:3])
    grounder = Grounder.load()
    for line, result in zip(LINES, results, strict=False):
        alone = grounder.ground(line["instruction"], load_world(models.SCENES / f"{line['world']}.json")).to_json()
        assert {**result, "milliseconds": 0} == {"id": line["id"], **alone, "milliseconds": 0}


def test_no_lines_give_an_empty_file(files):
    assert run(files, "", "  ") == (0, [])


def test_folders_are_made(files):
    code, results = run(files, LINES[0], output="a/b/out.jsonl")
    assert (code, len(results)) == (0, 1)


def test_line_separators_within_a_text_are_part_of_it(files):
    text = "pick up the leftmost\u2028red block"
    code, results = run(files, json.dumps({"id": 1, "world": "seven", "instruction": text}, ensure_ascii=False))
    assert code == 0
    assert results[0]["instruction"] == text


WRONG = [
    ("nonsense", "no JSON"), ("[1]", "found list"), ('{"id": 1, "world": "four"}', "'instruction' is missing"),
    ('{"world": "four", "instruction": "x"}', "'id' is missing"),
    ('{"id": 1, "instruction": "x"}', "'world' is missing"),
    ('{"id": 1, "world": "five", "instruction": "x"}', "no world 'five'; the worlds file has four, seven"),
    ('{"id": 1, "world": ["four"], "instruction": "x"}', "no world ['four']"),
    ('{"id": 1, "world": {}, "instruction": "x"}', "no world {}"),
    ('{"id": 1, "world": "four", "instruction": 5}', "'instruction' is a text"),
    ('{"id": 1, "world": "four", "instruction": "x", "history": "b1"}', "'history' is a list"),
    ('{"id": 1, "world": "four"', "no JSON"), ("[" * 100_000, "no JSON"),
]  # fmt: skip


@pytest.mark.parametrize(("line", "says"), WRONG)
def test_a_wrong_line_is_named(files, capsys, line, says):
    code, results = run(files, LINES[0], "", line)
    assert (code, results) == (2, None)
    (told,) = capsys.readouterr().err.splitlines()
    assert told.startswith("error: ")
    assert "in.jsonl, line 3: " in told
    assert says in told
    assert left(files) == set()


def test_all_wrong_lines_are_told_at_once(files, capsys):
    code, _ = run(files, LINES[0], *(line for line, _ in WRONG))
    told = capsys.readouterr().err.splitlines()
    assert code == 2
    assert len(told) == len(WRONG)


def test_an_earlier_output_is_kept_where_the_input_is_wrong(files):
    (files / "out.jsonl").write_text('"kept"\n', encoding="utf-8")
    assert run(files, "nonsense") == (2, ["kept"])


@pytest.mark.parametrize(
    ("content", "says"),
    [(None, "worlds.json: no such worlds file"), ("{", "truncated"), ("[]", "maps names to worlds"),
     ('{"bad": {"objects": [{"id": "b1"}]}}', "world 'bad': object 'b1': key 'type' is missing")],
)  # fmt: skip
def test_a_wrong_worlds_file_is_named(files, capsys, content, says):
    if content is None:
        (files / "worlds.json").unlink()
    else:
        (files / "worlds.json").write_text(content, encoding="utf-8")
    assert run(files, LINES[0]) == (2, None)
    (told,) = capsys.readouterr().err.splitlines()
    assert says in told


def test_a_missing_or_unreadable_input_is_named(files, capsys):
    arguments = ["batch", "--worlds", str(files / "worlds.json"), "--output", str(files / "out.jsonl"), "--input"]
    assert main([*arguments, str(files / "nothing.jsonl")]) == 2
    (files / "in.jsonl").write_bytes(b"\xff\xfe")
    assert main([*arguments, str(files / "in.jsonl")]) == 2
    missing, unreadable = capsys.readouterr().err.splitlines()
    assert "nothing.jsonl" in missing
    assert "in.jsonl: not UTF-8" in unreadable
    assert left(files) == set()


def test_a_folder_is_no_output(files, capsys):
    (files / "out.jsonl").mkdir()
    assert run(files, LINES[0]) == (2, None)
    assert "is a folder" in capsys.readouterr().err
    assert left(files) == {"out.jsonl"}


ODD = [
    "", "   ", "...", "🤖🤖", "pick up the 🔴 block", "hebe den roten Block auf", "拿起红色的方块",
    "ramasse le bloc rouge",
    "block " * 60, "pick up the red block " * 40, "put the red block on the blue block. " * 60, "word " * 500,
    "the " * 30, "a" * 3000, "not " * 30, "1 2 3 4 5", "pick up block 7", "it", "put it on it", "yes", "\u0000 take",
    "take\tthe\tred one", "(take [the {red} block", "take the red block" + "!" * 300,
]  # fmt: skip


def test_odd_texts_in_worlds_of_any_size_have_sane_results(files):
    rng = np.random.default_rng(3)
    table = make_object("table", "table", position=(0.65, 0, 0.691), size=(0.7, 1.8, 0.04))
    colors = ("red", "blue", "green")
    worlds = {}
    for count in (0, 1, 200):
        places = rng.uniform((0.4, -0.8), (0.9, 0.8), (count, 2))
        blocks = [make_object(f"b{i}", color=colors[i % 3], position=(*place, 0.736)) for i, place in enumerate(places)]
        worlds[f"of {count}"] = world_to_json(World((*blocks, table)))
    (files / "worlds.json").write_text(json.dumps(worlds), encoding="utf-8")
    lines = [{"id": f"{name} {i}", "world": name, "instruction": text, "history": ["b0", "b99999", 7, None]}
             for name in worlds for i, text in enumerate(ODD)]  # fmt: skip
    code, results = run(files, *lines)
    assert code == 0
    assert [result["id"] for result in results] == [line["id"] for line in lines]
    for line, result in zip(lines, results, strict=True):
        assert result["outcome"] in OUTCOMES
        assert result["explanation"] or result["outcome"] == "grounded"
        assert (result["question"] is not None) == (result["outcome"] == "ambiguous")
        if line["world"] == "of 0":
            assert result["outcome"] in ("no_referent", "not_understood")
        if not any(character.isalnum() for character in line["instruction"]):
            assert result["outcome"] == "not_understood"


def test_what_is_far_too_long_is_refused(files):
    _, (result,) = run(files, {"id": 1, "world": "four", "instruction": "take the block " * 100})
    assert result["outcome"] == "not_understood"
    assert "at most 200 words" in result["explanation"]

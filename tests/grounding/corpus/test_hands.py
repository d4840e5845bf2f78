"""Corpora of free texts: what is read back, what is refused and how it is said, what a check finds."""

import json
import tomllib
from pathlib import Path

import pytest

import models
from grounding.__main__ import main
from grounding.corpus import CorpusError, CorpusErrors
from grounding.corpus.by_hand import KINDS as LAID
from grounding.corpus.hands import KINDS, Hands, HandText, read_hands, write_hands
from grounding.corpus.hands_check import check_hands
from grounding.errors import HandsError, WorldError
from grounding.world import World, load_worlds, make_object, world_to_json

TABLE = make_object("table", "table", "white", (0.65, 0.0, 0.691), size=(0.7, 1.8, 0.04))
PICK = HandText("t-pick", "t", "the red one, please", "b1", 1, "pick", "rows", "dev")
PLACE = HandText("t-place", "t", "put the red one on the blue one", "b1", 3, "place", "rows", "dev", (0.6, 0.2, 0.786))


@pytest.fixture
def world():
    red = make_object("b1", "block", "red", (0.6, 0.0, 0.736))
    blue = make_object("b2", "block", "blue", (0.6, 0.2, 0.736))
    return World((red, blue, TABLE))


@pytest.fixture
def folder(tmp_path, world):
    write_hands(Hands((PICK, PLACE), {"t": world}), tmp_path)
    return tmp_path


def change(folder, line=1, **values):
    """Write other values into a line; None takes a key away."""
    file = folder / "hands.jsonl"
    lines = file.read_text().splitlines()
    data = json.loads(lines[line - 1])
    for key, value in values.items():
        if value is None:
            del data[key]
        else:
            data[key] = value
    lines[line - 1] = json.dumps(data)
    file.write_text("\n".join(lines) + "\n")


def test_what_is_written_is_read(folder, world):
    corpus = read_hands(folder)
    assert corpus.texts == (PICK, PLACE)
    assert world_to_json(corpus.worlds["t"]) == world_to_json(world)
    assert corpus["t-place"] is corpus.texts[1]
    assert read_hands(folder / "hands.jsonl").texts == corpus.texts
    assert len(corpus.select([])) == 0
    assert not corpus.select([]).worlds


def test_the_same_corpus_is_the_same_bytes(folder, tmp_path):
    before = [(folder / name).read_bytes() for name in ("hands.jsonl", "hands.worlds.json")]
    write_hands(read_hands(folder), tmp_path / "again")
    assert [(tmp_path / "again" / name).read_bytes() for name in ("hands.jsonl", "hands.worlds.json")] == before


@pytest.mark.parametrize(
    ("line", "values", "key", "right"),
    [
        (1, {"world": "u"}, "world", "t"),
        (1, {"instruction": "  "}, "instruction", "not empty"),
        (1, {"instruction": ["pick"]}, "instruction", "not empty"),
        (1, {"split": None}, "split", "all of"),
        (1, {"outcome": "grounded"}, "outcome", "only"),
        (1, {"manner": 0}, "manner", "from 1"),
        (1, {"manner": True}, "manner", "from 1"),
        (1, {"manner": "brief"}, "manner", "from 1"),
        (1, {"task": "push"}, "task", "pick, place"),
        (1, {"kind": "heap"}, "kind", "cluster"),
        (1, {"split": "held out"}, "split", "train, dev, test"),
        (1, {"history": "b1"}, "history", "b1, b2"),
        (1, {"history": ["b9"]}, "history", "b1, b2"),
        (1, {"history": [["b1"]]}, "history", "b1, b2"),
        (1, {"gold": "b1"}, "gold", "object"),
        (1, {"gold": {"object": "b1", "destination": [0.6, 0.0, 0.736]}}, "gold", "['object'] where task is 'pick'"),
        (2, {"gold": {"object": "b1"}}, "gold", "['destination', 'object'] where task is 'place'"),
        (1, {"gold": {"object": "table"}}, "gold.object", "b1, b2"),
        (1, {"gold": {"object": {}}}, "gold.object", "b1, b2"),
        (2, {"gold": {"object": "b1", "destination": [0.6, 0.0]}}, "gold.destination", "metres"),
        (2, {"gold": {"object": "b1", "destination": [0.6, 0.0, "low"]}}, "gold.destination", "metres"),
        (2, {"gold": {"object": "b1", "destination": [0.6, 0.0, float("nan")]}}, "gold.destination", "metres"),
        (2, {"gold": {"object": "b1", "destination": [600, 0, 736]}}, "gold.destination", "within 10"),
        (2, {"gold": {"object": "b1", "destination": [10**400, 0, 1]}}, "gold.destination", "within 10"),
        (2, {"id": "t-pick"}, "id", "of its own"),
    ],
)
def test_bad_lines_are_refused_by_file_line_and_key(folder, line, values, key, right):
    change(folder, line, **values)
    with pytest.raises(HandsError) as caught:
        read_hands(folder)
    error = caught.value
    assert (error.file, error.line, error.key) == (str(folder / "hands.jsonl"), line, key)
    assert right in error.right
    for part in (error.file, f"line {line}", repr(key), error.right):
        assert part in str(error)


@pytest.mark.parametrize("text", ['{"id": "t-pi', "[1, 2]", "[" * 100_000, "nothing"])
def test_what_is_no_object_is_refused(folder, text):
    (folder / "hands.jsonl").write_text(text)
    with pytest.raises(HandsError, match="line 1"):
        read_hands(folder)


def test_missing_and_unreadable_files_are_refused(folder):
    (folder / "hands.worlds.json").unlink()
    with pytest.raises(CorpusError, match=r"hands\.worlds\.json: no such"):
        read_hands(folder)
    (folder / "hands.jsonl").write_bytes(b"\xff\xfe")
    with pytest.raises(CorpusError, match="unreadable"):
        read_hands(folder)
    with pytest.raises(CorpusError, match="no such file"):
        read_hands(folder / "other.jsonl")


@pytest.mark.parametrize("data", [{"schema": 2, "worlds": {}}, {"schema": 1}, {"schema": 1, "worlds": []}])
def test_worlds_of_another_schema_are_refused(folder, data):
    (folder / "hands.worlds.json").write_text(json.dumps(data))
    with pytest.raises(CorpusError, match="schema"):
        read_hands(folder)
    with pytest.raises(WorldError, match="right would be"):
        load_worlds(folder / "hands.worlds.json")


def test_keep_going_lists_all_refusals(folder):
    change(folder, 1, manner=0)
    change(folder, 2, split="all")
    with pytest.raises(CorpusErrors) as caught:
        read_hands(folder, keep_going=True)
    assert [problem.key for problem in caught.value.problems] == ["manner", "split"]


def test_a_sound_corpus_has_no_findings(folder):
    assert check_hands(read_hands(folder)) == ()


@pytest.mark.parametrize(
    ("other", "check"),
    [
        (HandText("x", "t", "the blue one", "b2", 1, "pick", "rows", "test"), "splits"),
        (HandText("x", "t", "the blue one", "b2", 1, "pick", "ring", "dev"), "kinds"),
        (HandText("x", "t", "The red one,  please", "b2", 1, "pick", "rows", "dev"), "agreement"),
        (HandText("x", "t", "into it", "b1", 1, "place", "rows", "dev", (0.6, 0.23, 0.736)), "destinations"),
        (HandText("x", "t", "over it", "b1", 1, "place", "rows", "dev", (0.6, 0.2, 0.9)), "destinations"),
        (HandText("x", "t", "off it", "b1", 1, "place", "rows", "dev", (1.2, 0.2, 0.736)), "destinations"),
    ],
)
def test_a_check_finds_what_does_not_agree(world, other, check):
    assert [(f.check, f.example) for f in check_hands(Hands((PICK, PLACE, other), {"t": world}))] == [(check, "x")]


def test_a_check_finds_a_covered_block(world):
    stacked = world.with_objects((*world.objects, make_object("b3", "block", "red", (0.6, 0.0, 0.786))))
    found = check_hands(Hands((PICK,), {"t": stacked}))
    assert [finding.check for finding in found] == ["objects"]
    assert "b1" in str(found[0])


def test_commands_take_the_folder_and_the_file(folder, capsys):
    for path in (folder, folder / "hands.jsonl"):
        assert main(["corpus", "check", str(path)]) == 0
        assert "2 texts, 1 worlds; no findings" in capsys.readouterr().err
        assert main(["corpus", "show", str(path)]) == 0
        text = capsys.readouterr().out
        for part in (PICK.instruction, "pick b1 (red)", "place b1 (red) at (0.600, 0.200, 0.786)", "manner 3"):
            assert part in text
    assert main(["corpus", "show", str(folder), "--id", "t-place"]) == 0
    assert PICK.instruction not in capsys.readouterr().out
    assert main(["corpus", "worlds", str(folder)]) == 0
    assert "2 texts" in capsys.readouterr().out


def test_commands_say_what_is_wrong_in_one_line(folder, capsys):
    change(folder, 1, manner=0)
    assert main(["corpus", "check", str(folder)]) == 2
    lines = capsys.readouterr().err.splitlines()
    assert len(lines) == 1
    assert "line 1: 'manner' is 0" in lines[0]
    assert main(["corpus", "check", str(folder), "--json", "--keep-going"]) == 2
    assert len(json.loads(capsys.readouterr().out)["refused"]) == 1


def test_the_corpus_that_ships_is_sound_and_shipped():
    assert check_hands(read_hands()) == ()
    assert json.loads((models.HANDS / "hands.worlds.json").read_text())["schema"] == 1
    project = Path(models.__file__).parents[1] / "pyproject.toml"
    globs = tomllib.loads(project.read_text())["tool"]["setuptools"]["package-data"]["models"]
    shipped = {path for pattern in globs for path in models.ROOT.glob(pattern)}
    assert {models.HANDS / name for name in ("hands.jsonl", "hands.worlds.json", "README.md")} <= shipped


def test_texts_and_scenes_are_of_the_same_kinds():
    assert tuple(LAID) == KINDS

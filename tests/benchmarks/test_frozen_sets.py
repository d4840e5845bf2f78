import json

import pytest
from freeze_paper_roots import single_roots
from held_out import FROZEN, drawn, measured
from instructions import Instruction, instruction_of, read_instructions, write_instructions

from grounding.corpus.loading import load_corpus
from grounding.result import GroundedAction, Grounding


@pytest.fixture(scope="module", params=[("held_out", 170), ("held_out_777", 578)], ids=lambda p: p[0])
def frozen(request):
    name, count = request.param
    path = FROZEN.with_name(f"{name}.jsonl")
    return path, count, *read_instructions(path, path.with_suffix(".worlds.json"))


def test_a_frozen_set_is_whole(frozen):
    _, count, instructions, worlds = frozen
    assert len(instructions) == count == len({i.id for i in instructions})
    for instruction in instructions:
        known = worlds[instruction.world].by_id
        named = [*instruction.history, *(name for names in instruction.objects for name in names)]
        assert set(named) <= set(known)
        assert (instruction.outcome == "grounded") == bool(instruction.objects) == bool(instruction.actions)


def test_a_set_that_is_read_and_written_again_has_the_same_bytes(frozen, tmp_path):
    path, _, instructions, worlds = frozen
    write_instructions(instructions, worlds, tmp_path / path.name)
    for ending in (".jsonl", ".worlds.json"):
        assert (tmp_path / path.name).with_suffix(ending).read_bytes() == path.with_suffix(ending).read_bytes()


def test_the_same_seed_draws_the_same_set():
    first, worlds = drawn(40, 3)
    second, _ = drawn(40, 3)
    assert first
    assert [vars(i) for i in first] == [vars(i) for i in second]
    assert {i.world for i in first} <= set(worlds)


def test_held_out_wordings_are_counted_by_root_and_outcome(grounder):
    instructions, worlds = read_instructions(FROZEN, FROZEN.with_suffix(".worlds.json"))
    kept = instructions[:6]
    report = measured(kept, worlds, grounder)
    right = sum(i.is_answered_by(grounder.ground(i.text, worlds[i.world], i.history)) for i in kept)
    assert report["examples"] == 6
    assert report["root"] * 6 >= right - 1e-3
    assert sum(report["outcomes"].values()) == 6


@pytest.mark.parametrize(("gold", "outcome", "objects", "right"), [
    ({"object": "a"}, "grounded", [("a",)], True),
    ({"object": "a"}, "grounded", [("b",)], False),
    ({"object": "a"}, "grounded", [("a",), ("b",)], False),
    ({"object": "a"}, "grounded", [("a", "b")], False),
    ({"object": "a"}, "ambiguous", [], False),
    ({"actions": [["pick", ["a", "b"]]]}, "grounded", [("a", "b")], True),
    ({"outcome": "no_referent"}, "no_referent", [], True),
    ({"outcome": "no_referent"}, "ambiguous", [], False),
    ({"outcome": "ambiguous"}, "grounded", [("a",)], False),
])  # fmt: skip
def test_what_is_right(gold, outcome, objects, right):
    instruction = Instruction("i", "w", "the block", (), gold)
    actions = tuple(GroundedAction("pick", names, 1.0) for names in objects)
    assert instruction.is_answered_by(Grounding("the block", outcome, actions)) is right


def test_single_roots_are_those_that_mean_one_block():
    corpus = load_corpus()
    some = corpus.select(corpus.examples[:80])
    found = single_roots(some)
    assert 0 < len(found) < 80
    assert all(set(i.gold) == {"object"} for i in found)
    rest = {e.id for e in some} - {i.id for i in found}
    for example in (e for e in some if e.id in rest):
        gold = instruction_of(example, some.worlds[example.world]).gold
        assert "object" not in gold
        assert json.dumps(gold)

import json
from contextlib import suppress

import pytest
from hypothesis import given
from hypothesis import strategies as st
from small_treebank import TREES

from grounding.errors import ModelError
from grounding.language.events import STOP
from grounding.language.grammar import Grammar

GRAMMAR = Grammar.learn(TREES)


def test_the_file_gives_the_same_grammar_and_the_same_bytes() -> None:
    text = GRAMMAR.to_json()
    again = Grammar.from_json(text)
    assert again == GRAMMAR
    assert again.to_json() == text


@given(st.permutations(TREES))
def test_the_order_of_the_trees_makes_no_difference(trees: list) -> None:
    assert Grammar.learn(trees).to_json() == GRAMMAR.to_json()


def test_every_phrase_has_a_head_and_ends_on_both_sides() -> None:
    phrases = sum(1 for tree in TREES for _ in tree.preorder())
    assert sum(GRAMMAR.heads.values()) == phrases
    assert sum(count for event, count in GRAMMAR.children.items() if event.child_tag == STOP) == 2 * phrases


def test_chains_of_only_children_have_no_circles() -> None:
    grammar = Grammar.learn([*TREES])
    above = dict.fromkeys(grammar.phrase_tags, 0)
    for _ in above:
        for upper, lower in grammar.chains:
            above[lower] = max(above[lower], above[upper] + 1)
    assert max(above.values()) < len(above)


@given(st.data())
def test_a_damaged_file_is_refused(data: st.DataObject) -> None:
    text = GRAMMAR.to_json()
    where = data.draw(st.integers(0, len(text) - 1))
    other = data.draw(st.sampled_from("0aZ}"))
    damaged = text[:where] + other + text[where + 1 :]
    with suppress(ModelError):
        assert Grammar.from_json(damaged) == GRAMMAR


@pytest.mark.parametrize("text", ["", "[]", "{}", "null", '{"format": "grounding grammar", "version": 99}'])
def test_other_files_are_refused(text: str) -> None:
    with pytest.raises(ModelError):
        Grammar.from_json(text)


def test_a_cut_file_and_a_missing_one_are_refused_by_name(tmp_path) -> None:
    path = tmp_path / "grammar.json"
    with pytest.raises(ModelError, match=r"grammar\.json"):
        Grammar.read(path)
    GRAMMAR.write(path)
    assert Grammar.read(path) == GRAMMAR
    path.write_text(path.read_text()[:-200])
    with pytest.raises(ModelError, match=r"grammar\.json"):
        Grammar.read(path)
    path.write_bytes(b"\xff\xfe\x00")
    with pytest.raises(ModelError, match=r"grammar\.json"):
        Grammar.read(path)


def test_counts_of_a_right_checksum_but_wrong_kind_are_refused() -> None:
    import hashlib

    document = json.loads(GRAMMAR.to_json())
    document["content"]["heads"][0][-1] = -1
    body = json.dumps(document["content"], separators=(",", ":"))
    document["sha256"] = hashlib.sha256(body.encode()).hexdigest()
    with pytest.raises(ModelError, match="content"):
        Grammar.from_json(json.dumps(document))

from pathlib import Path

import pytest
from hypothesis import given
from hypothesis import strategies as st
from small_treebank import TREES

import models
from grounding.errors import ModelError
from grounding.language.compiled import StoredRows, read_grammar, tables_beside, write_tables
from grounding.language.grammar import Grammar
from grounding.language.parser import Parser
from grounding.language.tables import NOVELTIES

GRAMMAR = Grammar.learn(TREES)


@pytest.fixture
def written(tmp_path: Path) -> Path:
    path = tmp_path / "grammar.json"
    GRAMMAR.write(path)
    write_tables(path)
    return path


def test_the_tables_of_the_file_are_those_that_the_counts_give(written: Path) -> None:
    stored = read_grammar(written)
    assert stored.counted is not None
    assert stored == GRAMMAR
    for name in NOVELTIES:
        assert dict(getattr(stored.tables, name).rows) == getattr(GRAMMAR.tables, name).rows
    assert stored.tables.sides == GRAMMAR.tables.sides
    assert stored.tables.label_words == GRAMMAR.tables.label_words
    assert stored.to_json() == GRAMMAR.to_json()


def test_parses_with_and_without_tables_are_the_same(written: Path) -> None:
    counted, stored = Parser(GRAMMAR), Parser.load(written)
    for tree in TREES:
        assert stored.parse(tree.text) == counted.parse(tree.text)


def test_the_shipped_tables_belong_to_the_shipped_grammar() -> None:
    assert read_grammar(models.GRAMMAR).counted is not None, "run `python -m grounding train --tables-only`"


@given(st.data())
def test_tables_that_do_not_fit_are_left_aside(tmp_path_factory: pytest.TempPathFactory, data: st.DataObject) -> None:
    path = tmp_path_factory.mktemp("tables") / "grammar.json"
    GRAMMAR.write(path)
    write_tables(path)
    content = bytearray(tables_beside(path).read_bytes())
    where = data.draw(st.integers(0, len(content) - 1))
    content[where] ^= 1 << data.draw(st.integers(0, 7))
    tables_beside(path).write_bytes(bytes(content))
    assert read_grammar(path) == GRAMMAR


def test_tables_of_another_grammar_are_left_aside(written: Path) -> None:
    fewer = Grammar.learn(TREES[1:])
    fewer.write(written)
    stored = read_grammar(written)
    assert stored.counted is None
    assert stored == fewer


def test_a_grammar_file_is_asked_for_by_name_whatever_lies_beside_it(written: Path) -> None:
    written.write_text("{}")
    with pytest.raises(ModelError, match=r"grammar\.json"):
        read_grammar(written)
    written.unlink()
    with pytest.raises(ModelError, match=r"grammar\.json"):
        read_grammar(written)


def test_rows_have_outcomes_without_letters() -> None:
    rows = StoredRows(["a", "b"], ["NN 2  1", "DT 3"])
    assert dict(rows) == {"a": {"NN": 2, "": 1}, "b": {"DT": 3}}
    assert rows.get("c") is None

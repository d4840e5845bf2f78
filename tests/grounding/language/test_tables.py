import pytest
from small_treebank import TREES

from grounding.language.contexts import (
    Contexts,
    State,
    head_contexts,
    label_contexts,
    object_contexts,
    shape_contexts,
    tag_contexts,
)
from grounding.language.events import STOP
from grounding.language.grammar import Grammar
from grounding.language.tables import NOVELTIES

GRAMMAR = Grammar.learn(TREES)
STATE = State("PP", "IN:in", "IN", "R", "^IN", False)


@pytest.mark.parametrize("name", NOVELTIES)
def test_every_row_has_something(name: str) -> None:
    rows = getattr(GRAMMAR.tables, name).rows
    assert rows
    assert all(count > 0 for row in rows.values() for count in row.values())


def test_sides_have_the_tags_of_their_children() -> None:
    for event in GRAMMAR.children:
        if event.child_tag != STOP:
            assert event.child_tag in GRAMMAR.tables.sides[event.tag, event.side]


@pytest.mark.parametrize(
    "contexts",
    [head_contexts("NP", "NN:block"), tag_contexts(STATE), label_contexts(STATE, "NP"),
     object_contexts(STATE, "IN:of"), shape_contexts("IN:in", "NN:row")],
)  # fmt: skip
def test_contexts_go_from_general_to_specific(contexts: Contexts) -> None:
    parts = [context.split("\t") for context in contexts]
    assert contexts[-1] not in contexts[:-1]
    assert [len(part) for part in parts] == sorted(len(part) for part in parts)

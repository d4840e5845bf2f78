import pytest
from small_treebank import TREES

from grounding.language.contexts import State, Symbol
from grounding.language.events import STOP, split_label
from grounding.language.grammar import Grammar
from grounding.language.probabilities import Probabilities

GRAMMAR = Grammar.learn(TREES)
MODEL = Probabilities(GRAMMAR)


def symbols() -> list[Symbol]:
    pairs = {(event.child_tag, event.child_label) for event in GRAMMAR.children if event.child_tag != STOP}
    return [Symbol(tag, label) for tag, label in sorted(pairs) if not label.startswith(">")]


@pytest.mark.parametrize("verb", ["VB:put", "VB:take", "VB:"])
def test_what_can_follow_a_verb_has_at_most_the_whole_probability(verb: str) -> None:
    state = State("VP", verb, "VB", "R", "^VB", False)
    total = MODEL.stop_probability(state) + sum(MODEL.child_probability(state, symbol) for symbol in symbols())
    assert 0.5 < total <= 1.0 + 1e-9


def test_words_decide_attachment() -> None:
    place = Symbol("PP", "IN:on>NN:top")
    after_object = {verb: State("VP", verb, "VB", "R", "NPB", False) for verb in ("VB:put", "VB:take")}
    chances = {verb: MODEL.child_probability(state, place) for verb, state in after_object.items()}
    assert chances["VB:put"] > 5 * chances["VB:take"] > 0.0


def test_labels_with_objects_split_and_are_common_as_they_were_seen() -> None:
    assert split_label("IN:in>NN:row") == ("IN:in", "NN:row")
    assert split_label("NN:row") == ("NN:row", "")
    assert MODEL.share(Symbol("PP", "IN:on>NN:left")) > MODEL.share(Symbol("PP", "IN:on>NN:robot")) > 0.0

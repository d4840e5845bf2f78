"""Figures: which phrases are shown, in which order, and what is marked."""

import numpy as np
import pytest
from tiny_corpus import tiny

from grounding.errors import CorpusError
from grounding.experiments import ExperimentError
from grounding.experiments.figures import OWN, choose, corpus_figures, own_figures
from grounding.experiments.panels import Figure, marks_of_phrase, telling_panels, unsaid_kinds
from grounding.experiments.sheets import draw_figure
from grounding.pictures.palette import MARKS
from grounding.result import PhraseGrounding
from grounding.symbols import parse_symbols

WORLD = tiny().worlds["default"]


def phrase(text, tag, words, depth, symbols, probability=0.9):
    found = tuple((symbol, probability) for symbol in sorted(parse_symbols(symbols), key=str))
    return PhraseGrounding(text, tag, words, depth, found)


PHRASES = (
    phrase("take the last of the five on the right", "VP", (0, 8), 0, "action(pick; b5) action(pick)"),
    phrase("the last", "NP", (1, 2), 1, "ordinal(-1)"),
    phrase("of the five on the right", "PP", (3, 8), 1, "container(row; b1 b2 b3 b4 b5) object(b1) object(b2)"),
    phrase("the five on the right", "NP", (4, 8), 2, "container(row; b1 b2 b3 b4 b5) object(b1) object(b2)"),
    phrase("the robot", "NP", (9, 9), 3, "container(robot; left_hand right_hand) object(left_hand)"),
)


def test_panels_are_what_means_something_the_inner_before_the_outer():
    panels = telling_panels(PHRASES, WORLD)
    assert [panel.text for panel in panels] == ["the five on the right", "take the last of the five on the right"]
    assert panels[0].unsaid == ("row",)
    assert any("row" in row.text for row in panels[0].rows if row.sign == "passed")
    assert panels[1].unsaid == ()


def test_no_more_panels_than_asked_for_and_the_whole_is_among_them():
    (panel,) = telling_panels(PHRASES, WORLD, 1)
    assert panel.text == PHRASES[0].text


def test_marks_are_what_is_likelier_than_not():
    assert {mark.role for mark in marks_of_phrase(PHRASES[3])} == {"container", "object"}
    unlikely = phrase("the five", "NP", (0, 1), 0, "container(row; b1 b2) object(b1)", 0.4)
    assert marks_of_phrase(unlikely) == ()


def test_an_arrangement_is_said_where_a_word_names_it():
    row = parse_symbols("container(row; b1 b2 b3)")
    assert unsaid_kinds("the three on the right", row) == ("row",)
    assert unsaid_kinds("the row on the right", row) == ()
    assert unsaid_kinds("the robot", parse_symbols("container(robot; left_hand)")) == ()


def test_what_shows_most_is_chosen_and_no_words_twice():
    ids = choose(tiny(), 3)
    assert ids[0].startswith("t4-")  # five blocks that nobody calls a row
    assert len({tiny()[name].tree.text for name in ids}) == len(ids) == 3
    assert choose(tiny(), 3) == ids


def test_figures_of_a_corpus_are_learned_from_other_words():
    chosen = [e for e in tiny() if e.world == "default"][:2]
    figures = corpus_figures(tiny(), [e.id for e in chosen])
    assert [figure.name for figure in figures] == [e.id for e in chosen]
    for figure in figures:
        assert "instructions of other words" in figure.note
        assert figure.world is WORLD
    (best,) = corpus_figures(tiny(), [e.id for e in chosen], 1)
    assert best.name in {e.id for e in chosen}


def test_what_cannot_be_drawn_is_refused():
    with pytest.raises(CorpusError, match="no example 'nobody'"):
        corpus_figures(tiny(), ["nobody"])
    single = tiny().select(tiny().examples[:1])
    with pytest.raises(ExperimentError, match="left to learn from"):
        corpus_figures(single, [single.examples[0].id])


def test_in_words_of_our_own_nobody_says_row():
    figures = own_figures()
    assert [figure.name for figure in figures] == [own.name for own in OWN]
    row = next(panel for panel in figures[0].panels if panel.unsaid)
    assert row.unsaid[0] == "row"
    assert {5} == {len(mark.objects) for mark in row.marks if mark.meaning.startswith("row")}
    assert all("row" not in own.text for own in OWN)


def test_a_figure_is_drawn_with_all_its_panels():
    def pixels(image, color):
        return int((np.abs(np.asarray(image, dtype=int) - color).max(axis=2) <= 6).sum())

    figure = Figure("f", "take the last of the five on the right", WORLD, telling_panels(PHRASES, WORLD), "a note")
    whole = draw_figure(figure)
    first = draw_figure(Figure("f", figure.title, WORLD, figure.panels[:1], ""))
    assert whole.width > 1.8 * first.width
    for color in MARKS[:2]:  # the action and the container
        assert pixels(whole, color) > 150
    assert pixels(first, MARKS[0]) < pixels(whole, MARKS[0])
    assert draw_figure(Figure("f", "sing", WORLD, (), "")).width == first.width

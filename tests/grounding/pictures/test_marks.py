from grounding import GroundedAction, Grounding, PhraseGrounding
from grounding.pictures import marks_of, meaning_of
from grounding.pictures.marks import expressed, listed
from grounding.symbols import Container, ObjectSymbol, parse_symbol

ROW = Container("row", ("b1", "b2", "b3"))


def phrase(text, depth, *groundings, tag="NP"):
    return PhraseGrounding(text, tag, (depth, 9), depth, groundings)


def test_what_is_acted_on_is_first_and_named_by_its_phrase():
    grounding = Grounding(
        "pick up the first of the row", "grounded", (GroundedAction("pick", ("b1",), 0.9),),
        phrases=(phrase("the first of the row", 1, (ObjectSymbol("b1"), 0.9)), phrase("the row", 3, (ROW, 0.8))),
    )  # fmt: skip
    first, second = marks_of(grounding)
    assert (first.text, first.role, first.objects) == ("the first of the row", "object", ("b1",))
    assert (second.text, second.role, second.objects) == ("the row", "container", ("b1", "b2", "b3"))
    assert first.color != second.color


def test_phrases_that_mean_the_same_share_a_mark_named_by_the_longest_noun_phrase():
    grounding = Grounding(
        "x", "grounded", (GroundedAction("pick", ("b9",), 0.9),),
        phrases=(
            phrase("in the row of three", 1, (ROW, 0.7), tag="PP"),
            phrase("the row of three", 2, (ROW, 0.8)),
            phrase("the row", 3, (ROW, 0.9)),
        ),
    )  # fmt: skip
    assert [mark.text for mark in marks_of(grounding)] == ["x", "the row of three"]


def test_unlikely_symbols_are_not_marked():
    found = phrase("the blocks", 1, (ObjectSymbol("b1"), 0.9), (ObjectSymbol("b2"), 0.6), (ObjectSymbol("b3"), 0.1))
    assert [symbol.id for symbol, _ in expressed(found)] == ["b1", "b2"]


def test_an_ambiguous_grounding_shows_its_readings_in_different_colours():
    readings = tuple(GroundedAction("pick", (name,), 0.3) for name in ("b1", "b2", "b3"))
    marks = marks_of(Grounding("pick up the block", "ambiguous", alternatives=readings))
    assert [mark.objects for mark in marks] == [("b1",), ("b2",), ("b3",)]
    assert len({mark.color for mark in marks}) == 3


def test_meanings_are_short_words():
    told = {
        "object(b3)": "b3",
        "container(row; b1 b2)": "row of b1 b2",
        "container(row)": "row",
        "region(top, object; b2)": "on b2",
        "region(left, row; b1 b2)": "left of the row of b1 b2",
        "attribute(block, red, left, 3)": "red block left number 3",
        "collection(block, -, -, 5)": "5 block",
        "action(place; b3; top, object; b7)": "place b3 on b7",
        "ordinal(-1)": "last",
    }
    assert {text: meaning_of(parse_symbol(text)) for text in told} == told


def test_a_wider_container_within_a_phrase_that_named_a_narrower_one_is_not_marked():
    row, group = Container("row", ("b1", "b2")), Container("group", ("b1", "b2", "b3"))
    grounding = Grounding(
        "x", "grounded", (GroundedAction("pick", ("b9",), 0.9),),
        phrases=(phrase("the row of red blocks", 1, (row, 0.9)), phrase("red blocks", 3, (group, 0.9))),
    )  # fmt: skip
    assert [mark.objects for mark in marks_of(grounding)] == [("b9",), ("b1", "b2")]


def test_names_are_listed_as_people_count():
    assert listed(["b10", "b9", "a", "b1"]) == "a b1 b9 b10"

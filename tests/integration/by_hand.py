"""Groundings built by hand, so that executor and pictures are tested apart from the grounder."""

from __future__ import annotations

from pathlib import Path

from grounding import Destination, GroundedAction, Grounding, PhraseGrounding, World, load_world
from grounding.symbols import Action, Cardinal, Container, ObjectAttribute, ObjectSymbol, Region, Symbol

SCENES = Path(__file__).parents[2] / "models" / "scenes"


def scene(name: str) -> World:
    return load_world(SCENES / f"{name}.json")


def grounded(kind: str, *objects: str, to: Destination | None = None, text: str = "an instruction") -> Grounding:
    return Grounding(text, "grounded", (GroundedAction(kind, objects, 0.9, to),))


def phrase(
    text: str, tag: str, words: tuple[int, int], depth: int, *groundings: tuple[Symbol, float]
) -> PhraseGrounding:
    return PhraseGrounding(text, tag, words, depth, groundings)


def middle_of_the_row() -> Grounding:
    text = "pick up the middle block in the row of five blocks on the right"
    row = Container("row", ("b1", "b2", "b3", "b4", "b5"))
    phrases = (
        phrase(text, "VP", (0, 12), 0, (Action("pick", ("b3",)), 0.96)),
        phrase(text[8:], "NP", (2, 12), 1, (ObjectSymbol("b3"), 0.97), (ObjectSymbol("b7"), 0.01)),
        phrase("the middle block", "NP", (2, 4), 2, (ObjectAttribute("block", None, "center", 1), 0.98)),
        phrase("in the row of five blocks on the right", "PP", (5, 12), 2, (row, 0.9)),
        phrase("the row of five blocks on the right", "NP", (6, 12), 3, (row, 0.95)),
        phrase("the row of five blocks", "NP", (6, 10), 4, (row, 0.96)),
        phrase("five", "CD", (9, 9), 5, (Cardinal(5), 0.99)),
    )
    return Grounding(text, "grounded", (GroundedAction("pick", ("b3",), 0.96),), milliseconds=2.5, phrases=phrases)


def nearest_on_the_green_tower() -> Grounding:
    """In the scene "tower": b6 on top of b5."""
    text = "put the nearest red block on the small one"
    to = Destination((0.6688, -0.361, 0.831), "top", ("b5",))
    phrases = (
        phrase(text, "VP", (0, 8), 0, (Action("place", ("b6",), Region("top", "object", ("b5",))), 0.9)),
        phrase("the nearest red block", "NP", (1, 4), 1, (ObjectSymbol("b6"), 0.93)),
        phrase("the small one", "NP", (6, 8), 2, (ObjectSymbol("b5"), 0.92)),
    )
    return Grounding(text, "grounded", (GroundedAction("place", ("b6",), 0.9, to),), phrases=phrases)

"""The question that best tells alternatives apart, in words that an answer can use."""

from __future__ import annotations

from collections.abc import Sequence

from grounding.describing import name_objects, told_by_side
from grounding.distinguishing import Describer, Description, listed_descriptions
from grounding.numbers import listed, spelled
from grounding.result import Destination, GroundedAction

NAMED = 3  # alternatives that a question names; the others are counted

_WHERE = {"top": "on", "near": "next to", "front": "in front of", "back": "behind", "between": "between",
          "left": "to the left of", "right": "to the right of", "center": "in the middle of", "bottom": "under",
          "far": "far from"}  # fmt: skip


def question(actions: Sequence[GroundedAction], describer: Describer, more: int = 0) -> str:
    """Asks which action is meant.

    Args:
        actions: the alternatives, the likeliest first; at least one.
        describer: of the world's things.
        more: how many alternatives there are besides.
    """
    meant = list(dict.fromkeys(action.objects for action in actions))
    if len(meant) > 1 or (len(actions) == 1 and more):
        return _which(meant, describer, more)
    kinds = sorted({action.action for action in actions})
    thing = describe_objects(meant[0], describer)
    if len(kinds) > 1:
        return f"Shall I {listed(kinds, 'or')} {thing}?"
    places = list(dict.fromkeys(where(a.destination, describer) for a in actions[:NAMED] if a.destination is not None))
    if len(places) > 1:
        return f"Where do you want {thing}: {listed(places, 'or')}?"
    return f"Do you mean {thing}?"


def which_place(rivals: Sequence[str], describer: Describer) -> str:
    """Asks which of several things a place was named by."""
    found = [describer.describe(name, rivals) for name in rivals[:NAMED]]
    return f"Where do you want it, by {listed_descriptions(found, len(rivals) - len(found))}?"


def describe_objects(names: Sequence[str], describer: Describer, among: Sequence[str] = ()) -> str:
    """What tells objects from others, in words."""
    if len(names) == 1:
        return describer.describe(names[0], among).text
    return name_objects(describer.scene.layout, names)


def where(destination: Destination, describer: Describer) -> str:
    """Where a destination is, in words."""
    if destination.relation is None or not destination.reference:
        x, y, _ = destination.position
        return f"at ({x:.2f}, {y:.2f}) m"
    return f"{_WHERE[destination.relation]} {describe_objects(destination.reference, describer)}"


def offered(meant: Sequence[tuple[str, ...]], describer: Describer, more: int) -> list[str]:
    """The words by which a question names alternatives, those that it names.

    Args:
        meant: ids of the alternatives, the likeliest first.
        describer: of the world's things.
        more: how many alternatives there are besides.
    """
    rivals = () if more else tuple(dict.fromkeys(name for objects in meant for name in objects))
    return [description.text for description in _descriptions(meant[:NAMED], describer, rivals)]


def _descriptions(
    named: Sequence[tuple[str, ...]], describer: Describer, rivals: Sequence[str]
) -> list[Description]:
    """Descriptions of alternatives; sets that are called alike are told apart by where they lie."""
    found = [_description(objects, describer, rivals) for objects in named]
    texts = [description.text for description in found]
    layout = describer.scene.layout
    for text in dict.fromkeys(texts):
        alike = [place for place, other in enumerate(texts) if other == text]
        sides = told_by_side(layout, [named[place] for place in alike]) if len(alike) > 1 else ()
        for place, side in zip(alike, sides, strict=False):
            found[place] = Description(text.replace("the ", f"the {side} ", 1), "")
    return found


def _description(names: Sequence[str], describer: Describer, rivals: Sequence[str]) -> Description:
    if len(names) == 1:
        return describer.describe(names[0], rivals)
    return Description(name_objects(describer.scene.layout, names), "")


def _which(meant: Sequence[tuple[str, ...]], describer: Describer, more: int) -> str:
    rivals = () if more else tuple(dict.fromkeys(name for objects in meant for name in objects))
    named = list(meant[:NAMED])
    rest = len(meant) - len(named) + more
    sizes = {len(objects) for objects in meant}
    if sizes != {1} and len(sizes) == 1 and len(meant) > NAMED:
        return f"Which {spelled(sizes.pop())} of them do you mean?"
    return f"Do you mean {listed_descriptions(_descriptions(named, describer, rivals), rest)}?"

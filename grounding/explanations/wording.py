"""Conditions and features in words."""

from __future__ import annotations

from grounding.meaning.notation_terms import PREPOSITIONS, place_of
from grounding.meaning.referents import PERSON, Condition, Referent

_SIDES = {"left": "left of", "right": "right of", "front": "in front of", "back": "behind", "up": "above",
          "down": "below"}  # fmt: skip
_PEOPLE = {"robot": "you", "speaker": "the speaker"}
_CONCEPTS = {
    "colour": "its colour", "toward": "its direction", "toward.strict": "its exact direction",
    "beside": "being next to", "touching": "touching", "same": "being the same",
    "same.told": "what was told before", "same.stated": "what was stated", "at.side": "its side",
    "at.corner": "its corner", "at.middle": "being in the middle", "at.rim": "being at the edge",
    "on": "being on top", "on_table": "standing on the table", "alone": "standing alone",
    "between": "being between", "surrounded": "being surrounded", "part": "being that part",
    "other": "being another", "before": "being before somebody", "before.side": "somebody's side",
    "member": "belonging to the set", "among": "being one of them", "those": "being one of those",
    "side": "how far to the side", "depth": "how far back or in front", "height": "how high in the stack",
    "point": "how near the point", "corner": "how near the corner", "nearest.person": "nearness to somebody",
    "nearest.thing": "nearness to it", "nearest.place": "nearness to the place",
    "farthest.person": "distance from somebody", "farthest.thing": "distance from it",
    "farthest.place": "distance from the place", "ordinal": "its number", "middle": "being the middle one",
    "lane": "its number in that direction", "measured": "being so far away", "stepped": "being so many steps away",
    "apart": "being apart", "centre": "being in the middle of them",
}  # fmt: skip
_DEGREES = {"T": "how true it is", "P": "which would be meant", "R": "its rank", "best": "being the best of all"}
_WHOLE = {
    "buried": "what carries something is spoken of less", "stacked": "what is stacked is spoken of less",
    "parse": "how likely the parse is", "doubt": "pieces of the text that say nothing", "fragment": "a text in pieces",
    "outside": "being outside the set that is meant", "sole": "others fit as well", "spread": "how many fit",
    "fit": "how well the best fits", "within": "whether what is spoken of on the way is there",
    "looks": "how much it looks like such an arrangement", "shadow": "another arrangement catches the eye more",
    "shadowed": "it is not the most conspicuous arrangement", "number": "another number of members",
    "miscounted": "another number of members than was said", "set": "which set is meant", "nothing":
    "that nothing here is meant", "counted": "lines counted over the whole table", "empty": "nothing fits",
    "only": "whether it is the only one", "form": "the form of the set", "view": "whose directions are meant",
}  # fmt: skip


def feature_text(name: str) -> str:
    """A feature of the model in words."""
    plain, _, limit = name.partition("<")
    plain, _, word = plain.partition(":")
    head, _, rest = plain.partition(".")
    below = f", if below {limit}" if limit else ""
    if head == "view":
        return f"directions are the {rest.partition('.')[0]}'s"
    if head == "form":
        return f"the set is found as: {rest.replace('.', ', ')}"
    if head == "nothing" and rest:
        return f"that nothing here is meant, by {rest}{below}"
    if head not in _DEGREES:
        said = _WHOLE.get(head, plain)
        return f"{said}{f' ({rest})' if rest else ''}{below}"
    if not rest:
        return f"{_DEGREES[head]}, of all that is said{below}"
    concept, more = rest, f' ("{word}")' if word else ""
    if concept.endswith(".nth"):
        concept, more = concept.removesuffix(".nth"), " counted"
    if concept.endswith(".ranked") or concept == "ranked":
        concept, more = concept.removesuffix("ranked").rstrip("."), " before ranks choose"
    denied = concept.startswith("not.")
    concept = concept.removeprefix("not.").removeprefix("set.")
    said = _CONCEPTS.get(concept, concept.replace(".", " ") or "all that is said")
    return f"{_DEGREES[head]}: {'not ' if denied else ''}{said}{more}{below}"


def condition_text(condition: Condition) -> str:
    """A condition nearly as people say it."""
    said = _said(condition)
    return f"not {said}" if condition.negated else said


def referent_text(referent: Referent) -> str:
    """A referent in its own words."""
    if referent.sort == PERSON:
        return _PEOPLE.get(referent.person or "", "somebody")
    return referent.text or "it"


def _said(condition: Condition) -> str:
    others = " and ".join(referent_text(referent) for referent in condition.of)
    words = " and ".join(condition.words)
    match condition.concept:
        case "colour":
            return " or ".join(condition.words)
        case "toward" | "before":
            sides = " and ".join(_SIDES.get(name, name) for name in condition.words)
            return f"{'directly ' if condition.strict else ''}{sides} {others}"
        case "member" | "among" | "those":
            return f"{condition.said if condition.said in ('in', 'of', 'from') else 'one of'} {others}"
        case "extreme":
            rank = condition.rank
            return f"{_place(condition)} most" if rank is None else f"{_number(condition)} {_place(condition)}"
        case "at" | "part":
            return f"at the {_place(condition)}{f' of {others}' if others else ''}"
        case "ordinal":
            return f"number {condition.rank}"
        case "size":
            return "the largest" if (condition.number or 0) > 0 else "the smallest"
        case "same":
            return f"the same as {others}"
        case "on_table" | "alone" | "middle":
            return {"on_table": "on the table", "alone": "alone", "middle": "in the middle"}[condition.concept]
    counted = f"{_number(condition)} " if condition.rank is not None else ""
    preposition = PREPOSITIONS.get(condition.concept, "of") if others else ""
    parts = (counted + condition.concept.replace("_", " "), words, preposition, others)
    return " ".join(part for part in parts if part)


def _place(condition: Condition) -> str:
    return "" if condition.region is None else place_of(condition.region).removesuffix(" together")


def _number(condition: Condition) -> str:
    return "last" if condition.rank == -1 else f"number {condition.rank}"

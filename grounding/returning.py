"""Putting things back: where a thing was before it was handled last."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from grounding.language.tree import Phrase
from grounding.result import Destination, GroundedAction, Grounding
from grounding.world import FURNITURE, World

WHERE_BEFORE = "Where was it before? Say where to put it."
_RETURNING = frozenset("put place set return bring move take puts move".split())
_OWN_PLACES = frozenset("place spot position".split())
_STILL = 0.005  # what lies within this distance of where it was has not been moved [m]


def returns(tree: Phrase) -> bool:
    """Whether a text asks to bring something back to where it was."""
    texts = [leaf.text for leaf in tree.leaves]
    if not _RETURNING & set(texts):
        return False
    tail = " ".join(texts)
    if any(said in tail for said in ("where it was", "where they were", "where it came from", "where you took it")):
        return True
    adverb = texts[-2:-1] not in (["the"], ["very"], ["far"])
    own = {"its", "original", "old", "previous", "initial", "former"} & set(texts) and _OWN_PLACES & set(texts[-1:])
    brings = bool({"put", "return", "bring"} & set(texts))
    return bool(own) or brings and adverb and texts[-1] in ("back", "again")


def returned(answer: Grounding, world: World, before: World | None) -> Grounding:
    """The answer, with the place where its object was before as its destination.

    Args:
        answer: to a text that asks to bring something back.
        world: as it is.
        before: as it was; None where nobody knows.
    """
    asked = answer.actions or (answer.alternatives if answer.question is not None else ())
    if (
        not asked
        or answer.outcome not in ("grounded", "ambiguous")
        or answer.outcome == "ambiguous"
        and (asked[0].action != "place" or asked[0].destination is not None)
    ):
        return answer
    action = replace(asked[0], action="place", destination=None)
    place = None if before is None else _place_of(action, world, before)
    if place is not None:
        taken = _occupied(action.objects[0], place, world)
        if taken is None:
            done = replace(action, destination=Destination(place))
            others = tuple(a for a in answer.alternatives if a.objects != action.objects)
            return replace(
                answer, outcome="grounded", actions=(done,), alternatives=others, question=None, explanation=""
            )
        why = f"where {action.objects[0]} was, there is {taken} now"
    else:
        why = "where it was before is not known"
    listed = (action, *(a for a in answer.alternatives if a.objects != action.objects))
    return replace(answer, outcome="ambiguous", actions=(), alternatives=listed, question=WHERE_BEFORE, explanation=why)


def _place_of(action: GroundedAction, world: World, before: World) -> tuple[float, float, float] | None:
    name = action.objects[0]
    if len(action.objects) != 1 or name not in before.by_id or name not in world.by_id:
        return None
    place = before[name].position
    x, y, z = (float(value) for value in place)
    return x, y, z


def _occupied(name: str, place: tuple[float, float, float], world: World) -> str | None:
    """What stands where a thing is to be put, or None."""
    item = world[name]
    for other in world.objects:
        if other.id == name or other.type in FURNITURE:
            continue
        apart = np.abs(other.position - np.array(place))
        if np.all(apart < other.half_extents + item.half_extents - _STILL):
            return other.id
    return None

"""Where to: directions, distances and references in the order of the words become a point on the table."""

from __future__ import annotations

from dataclasses import dataclass, field, replace

import numpy as np

from grounding.graded import words as w
from grounding.graded.nouns import Noun, read_noun
from grounding.graded.reader import Reader
from grounding.graded.values import Value
from grounding.language.lexicon import meanings
from grounding.language.tree import Phrase, Word
from grounding.symbols import Cardinal, Ordinal
from grounding.world import Array

STEP = 1.08  # a block and the room beside it [edges]
UNSAID = 1.0  # how far "up and to the left" is where nothing is said [steps]
_FRACTIONS = {"half": 0.5, "quarter": 0.25, "third": 0.33, "few": 3.0, "couple": 2.0, "several": 3.0, "bit": 0.5,
              "slightly": 0.6, "little": 0.6, "just": 0.0, "twice": 2.0, "once": 1.0}  # fmt: skip
_SMALL = ("slightly", "bit", "little", "tad")
_ON = frozenset("on onto atop upon top".split())
_LIFTED = frozenset("stack stacked stacks tower pile topping joins join".split())
_BACK = frozenset("originally before back original previous where".split())
_FACES = frozenset("face faces side sides edge edges corner corners".split())
_STOPS = frozenset("so that then and , until".split())


@dataclass(frozen=True)
class Offset:
    """One direction with its length.

    Attributes:
        names: directions.
        steps: how many blocks far, or None where nothing is said.
        between: whether the steps lie between the blocks ("two spaces left of X").
    """

    names: tuple[str, ...]
    steps: float | None = None
    between: bool = True


@dataclass(frozen=True, eq=False)
class Spot:
    """Where something is to go.

    Attributes:
        point: x, y on the table [m].
        relation: a spatial reference to the objects, or None.
        reference: indices of the objects.
        on: whether it goes on top of the reference.
        certainty: how well the words lead there, in [0, 1].
    """

    point: Array
    relation: str | None
    reference: tuple[int, ...]
    on: bool
    certainty: float


@dataclass
class _Scan:
    offsets: list[Offset] = field(default_factory=list)
    steps: float | None = None
    between: bool = True
    on: bool = False
    near: bool = False
    middle: bool = False
    spots: list[Spot] = field(default_factory=list)


def find_spot(phrases: list[Phrase], source: int, reader: Reader) -> Spot | None:
    """Where the words of a destination lead.

    Args:
        phrases: what follows the verb and what it moves, and what is said of "it" afterwards.
        source: index of what is moved.
        reader: of the scene; the source is no reference.
    """
    items: list[Word | Noun] = []
    for phrase in phrases:
        _line_up(phrase, items)
    scan = _Scan()
    for place, item in enumerate(items):
        if isinstance(item, Noun):
            _refer(item, scan, source, reader)
        else:
            _hear(item, items, place, scan)
    if scan.offsets and not scan.spots:
        scan.spots.append(_shifted(_own(source, reader), scan, reader, (), 0.6))
    elif scan.offsets:
        scan.spots.append(_after(scan, reader))
    if not scan.spots:
        return None
    return _merged(scan.spots)


def _line_up(phrase: Phrase, items: list[Word | Noun]) -> None:
    """The words of a phrase in order, noun phrases that name something as one item."""
    for child in (phrase,) if phrase.tag == "NP" else phrase.children:
        if isinstance(child, Word):
            items.append(child)
        elif child.tag != "NP":
            _line_up(child, items)
        else:
            noun = read_noun(child)
            texts = {leaf.text for leaf in child.leaves}
            names_thing = noun.head in ("block", "container", "table") and not noun.conjoined
            counted = noun.head == "block" and noun.number is not None and noun.plural and not noun.colors
            if names_thing and not (counted and _only_measures(noun)) and not _is_step(noun):
                items.append(noun)
            elif noun.head == "place" and (noun.place or noun.middle) and not noun.agent and "its" not in texts:
                items.append(noun)
            elif noun.conjoined and all(read_noun(p).head == "block" for p in noun.conjoined) and _definite(noun):
                items.append(noun)
            else:
                _expand(child, items)


def _expand(phrase: Phrase, items: list[Word | Noun]) -> None:
    for child in phrase.children:
        if isinstance(child, Word):
            items.append(child)
        else:
            _line_up(child, items)


def _definite(noun: Noun) -> bool:
    return not any(_is_step(read_noun(part)) for part in noun.conjoined)


def _is_step(noun: Noun) -> bool:
    """ "one block", "a box" as a length."""
    first = noun.text.split()[:1]
    bare = not (noun.colors or noun.modifiers or noun.directions or noun.ordinals or noun.distance)
    return noun.head == "block" and bare and first in (["one"], ["1"], ["half"], ["two"], ["three"])


def _only_measures(noun: Noun) -> bool:
    return not (noun.modifiers or noun.directions or noun.ordinals or noun.distance) and noun.definite


def _hear(word: Word, items: list[Word | Noun], place: int, scan: _Scan) -> None:
    text = word.text
    before = [item.text for item in items[max(0, place - 3) : place] if isinstance(item, Word)]
    after = [item.text if isinstance(item, Word) else "" for item in items[place + 1 : place + 3]]
    number = next((s.value for s in meanings(text) if isinstance(s, Cardinal)), None)
    if number is None and text in _FRACTIONS:
        number = _FRACTIONS[text]
        if text in ("half", "third", "quarter") and scan.steps and scan.steps >= 1 and "and" in before:
            number = scan.steps + number
        if text == "just":
            return
        if text in _SMALL and scan.offsets and not _direction_follows(after):
            scan.offsets[-1] = replace(scan.offsets[-1], steps=number, between=False)
            return
    if number is not None:
        if _opens(after, items, place) or not scan.offsets or scan.offsets[-1].steps is not None:
            scan.steps = float(number)
            scan.between = not any(w.is_block(t) for t in after)
        else:
            scan.offsets[-1] = replace(scan.offsets[-1], steps=float(number))
        return
    if text in ("between", "in-between", "centered"):
        scan.middle = True
        return
    if text in _ON and (text != "on" or _stacking(after)) and not any(t in ("the", "at") for t in before[-1:] if text == "top" and not _on_top(items, place)):
        if text != "top" or _on_top(items, place):
            scan.on = True
            return
    names = ("back",) if text == "behind" else w.directions(text)
    if text in ("under", "beneath", "underneath"):
        names = ("front",)
    if text == "right" and after[:1] and after[0] in ("next", "on", "in", "beside", "behind", "above", "below", "between", "at"):
        names = ()
    if names:
        if {"its", "it's", "it"} & set(before[-2:]) and after[:1] and after[0] in _FACES:
            return  # "its left side touches ..."
        if scan.offsets and scan.steps is None and scan.offsets[-1].steps is None and not before[-1:] == ["and"] and before[-1:] != ["the"]:
            last = scan.offsets[-1]
            scan.offsets[-1] = replace(last, names=tuple(dict.fromkeys((*last.names, *names))))
            return
        scan.offsets.append(Offset(names, scan.steps, scan.between))
        scan.steps, scan.between = None, True
        return
    if w.is_touching(text) or w.is_beside(text):
        scan.near = True


def _opens(after: list[str], items: list[Word | Noun], place: int) -> bool:
    """Whether a number belongs to the direction after it."""
    for item in items[place + 1 : place + 7]:
        if isinstance(item, Noun):
            return False
        if item.text in ("and", "then", ","):
            return False
        if w.directions(item.text) or item.text == "behind":
            return True
    return False


def _direction_follows(after: list[str]) -> bool:
    return any(w.directions(text) for text in after)


def _stacking(after: list[str]) -> bool:
    return after[:1] in ([""], ["top"], ["it"])


def _on_top(items: list[Word | Noun], place: int) -> bool:
    """ "on top of", "to the top of the stack"."""
    following = [item.text if isinstance(item, Word) else item for item in items[place + 1 : place + 3]]
    return following[:1] == ["of"] and len(following) > 1 and isinstance(following[1], Noun) and following[1].head in (
        "block", "container")  # fmt: skip


def _refer(noun: Noun, scan: _Scan, source: int, reader: Reader) -> None:
    """A reference ends what was said before it."""
    scene = reader.scene
    if noun.head == "table":
        if scan.offsets and scan.offsets[-1].steps is None:
            names = tuple(name for offset in scan.offsets for name in offset.names)
            scan.spots.append(_edge_spot(names, reader))
            scan.offsets = []
        return
    value = reader.noun(noun)
    if value.kind == "place" and value.place is not None:
        scan.spots.append(_place_spot(noun, value, scan, reader))
        scan.offsets, scan.on = [], False
        return
    if value.kind not in ("objects", "sets") or not value.weights.any():
        return
    if scan.middle:
        found = _middle_spot(value, source, reader)
        if found is not None:
            scan.spots.append(found)
            scan.middle = False
            return
    members, certainty = _referents(value, source, reader)
    if not members:
        return
    wants_on = scan.on or (not scan.offsets and not scan.near)
    if wants_on and not scan.offsets:
        highest = max(members, key=lambda i: scene.z[i])
        scan.spots.append(Spot(scene.xy[highest], "top", (highest,), True, certainty))
    elif scan.offsets:
        scan.spots.append(_shifted(members, scan, reader, members, certainty))
    else:
        scan.spots.append(_beside(members, source, reader, certainty))
    scan.offsets, scan.steps, scan.on, scan.near = [], None, False, False


def _referents(value: Value, source: int, reader: Reader) -> tuple[tuple[int, ...], float]:
    if value.kind == "sets" and value.sets:
        mask, weight = value.sets[0]
        return tuple(int(i) for i in np.flatnonzero(mask) if i != source), float(min(weight, 1.0))
    weights = value.weights.copy()
    weights[source] *= 0.02
    best = int(np.argmax(weights))
    total = float(weights.sum())
    return ((best,), float(weights[best] / total)) if total > 1e-9 else ((), 0.0)


def _own(source: int, reader: Reader) -> tuple[int, ...]:
    return (source,)


def _vector(names: tuple[str, ...], reader: Reader) -> Array:
    flat = dict.fromkeys({"up": "back", "down": "front"}.get(name, name) for name in names)
    return np.sum([reader.scene.direction(name, reader.view) for name in flat], axis=0)


def _shifted(members: tuple[int, ...], scan: _Scan, reader: Reader, reference: tuple[int, ...], certainty: float) -> Spot:
    """From what is referred to (or the source) along the offsets."""
    scene = reader.scene
    step = STEP * scene.edge
    points = scene.xy[list(members)]
    low, high = points.min(axis=0), points.max(axis=0)
    point = (low + high) / 2
    for offset in scan.offsets:
        vector = _vector(offset.names, reader)
        steps = offset.steps
        if steps is None:
            length = UNSAID
        elif reference:
            length = steps + 1.0 if offset.between and steps >= 0.5 else steps
        else:
            length = steps
        point = point + vector * (length * step + (high - low) / 2 * np.abs(vector))
    names = scan.offsets[-1].names if scan.offsets else ()
    relation = {"up": "back", "down": "front"}.get(names[0], names[0]) if len(names) == 1 else "near"
    return Spot(point, relation if reference else None, reference, False, certainty)


def _beside(members: tuple[int, ...], source: int, reader: Reader, certainty: float) -> Spot:
    """Next to something, on the side of where it comes from, where there is room."""
    scene = reader.scene
    points = scene.xy[list(members)]
    centre = points.mean(axis=0)
    step = STEP * scene.edge
    others = [i for i in range(scene.n) if i != source]
    best, cost = centre, np.inf
    for member in members:
        for name in ("left", "right", "front", "back"):
            spot = scene.xy[member] + scene.direction(name) * step
            taken = min((float(np.abs(scene.xy[i] - spot).max()) for i in others), default=1.0) < 0.85 * scene.edge
            far = float(np.linalg.norm(spot - scene.xy[source]))
            if far + 100.0 * taken < cost:
                best, cost = spot, far + 100.0 * taken
    return Spot(best, "near", members, False, 0.6 * certainty)


def _middle_spot(value: Value, source: int, reader: Reader) -> Spot | None:
    scene = reader.scene
    if value.sets:
        members = [int(i) for i in np.flatnonzero(value.sets[0][0]) if i != source]
    else:
        members = [int(i) for i in np.argsort(-value.weights)[:2]]
    if len(members) < 2:
        return None
    return Spot(scene.xy[members].mean(axis=0), "between", tuple(members), False, 0.8)


def _edge_spot(names: tuple[str, ...], reader: Reader) -> Spot:
    scene = reader.scene
    centre, half = scene.box
    point = centre + _vector(names, reader) * (half - 0.5 * scene.edge)
    return Spot(np.asarray(point), None, (), False, 0.4)


def _place_spot(noun: Noun, value: Value, scan: _Scan, reader: Reader) -> Spot:
    """A part of the table: its corner, its edge, its middle."""
    scene = reader.scene
    place = value.place
    assert place is not None
    centre, half = scene.box
    if not place.directions:
        point = centre
    else:
        vector = np.clip(np.sum(place.directions, axis=0), -1, 1)
        inside = half - 0.5 * scene.edge
        if place.corner or place.bare or "edge" in noun.text:
            point = centre + vector * inside
        else:
            point = centre + 0.6 * vector * inside
    step = STEP * scene.edge
    for offset in scan.offsets:
        point = point + _vector(offset.names, reader) * step * (offset.steps or UNSAID)
    return Spot(np.asarray(point), None, (), False, 0.4)


def _after(scan: _Scan, reader: Reader) -> Spot:
    """Directions after a reference go on from there: "next to X, then up one"."""
    last = scan.spots.pop()
    step = STEP * reader.scene.edge
    point = last.point.copy()
    for offset in scan.offsets:
        vector = _vector(offset.names, reader)
        point = point + vector * step * (offset.steps if offset.steps is not None else UNSAID * 0.7)
    if last.on and all(set(o.names) <= {"up"} for o in scan.offsets):
        return last
    return replace(last, point=point, on=False, relation="near" if last.reference else None)


def _merged(spots: list[Spot]) -> Spot:
    """Several descriptions of one place: the most certain one that refers, others break no tie."""
    return max(spots, key=lambda spot: (spot.certainty + (0.3 if spot.reference else 0.0)))

"""Noun phrases of arrangements: "the third row", "the largest stack of red blocks", sets restricted and ranked."""

from __future__ import annotations

from dataclasses import replace
from typing import TYPE_CHECKING

import numpy as np

from grounding.graded import sets
from grounding.graded.selectors import adjectives
from grounding.graded.values import SETS, Membership, Rank, Restriction, Value
from grounding.language.lexicon import meanings
from grounding.language.tree import Phrase
from grounding.lexicon import arrangement, colour, degrees, parameters
from grounding.meaning.nouns import Noun, read_noun
from grounding.symbols import Cardinal
from grounding.world import Array
from grounding.world.scene import Scene

if TYPE_CHECKING:
    from grounding.graded.reader import Reader

_LINES = {"row": {"up": 0, "back": 0, "down": -1, "front": -1}, "column": {"left": 0, "right": -1}}


def read_arrangement(reader: Reader, noun: Noun) -> Value:
    """What a noun whose head names an arrangement is worth: sets with their weights."""
    scene = reader.scene
    spoken = _spoken_of(reader, noun)
    if spoken is not None:
        return Value("sets", spoken.astype(float), ((spoken, 1.0),), kinds=noun.kinds)
    colors, number, rest = _contents(noun)
    stuff = np.ones(scene.n, dtype=bool)
    if colors:
        stuff = colour.truth(scene, colors) > 0.5
    wanted = number if not noun.plural else None
    found = sets.arranged(scene, noun.kinds, stuff, wanted)
    exists = sets.existence(found, wanted, noun.kinds)
    lines = _counted_lines(scene, noun, stuff) if number is None else []
    found = _modified(reader, noun, found, rest)
    if lines:
        plain = replace(noun, ordinals=(), directions=(), middle=False)
        found = [*_modified(reader, plain, lines, rest), *((mask, 0.3 * weight) for mask, weight in found)]
    found = [(mask, weight * exists) for mask, weight in found]
    pool = np.zeros(scene.n)
    total = sum(weight for _, weight in found)
    for mask, weight in found:
        pool = pool + mask * (weight / max(total, 1.0))
    return Value("sets", np.minimum(pool, 1.0), tuple(found[: 2 * SETS]), definite=noun.definite, number=number,
                 kinds=noun.kinds)  # fmt: skip


def _spoken_of(reader: Reader, noun: Noun) -> np.ndarray | None:
    """The several that "that cluster" points back to, boolean (n,); None where it points to nothing."""
    if reader.context is None or noun.plural or noun.modifiers or noun.text.split()[0] not in ("that", "this"):
        return None
    spoken = reader.context > 0.3 * degrees.peak(reader.context)
    return spoken if spoken.sum() > 1 else None


def _contents(noun: Noun) -> tuple[tuple[str, ...], int | None, list[Phrase]]:
    """Colours and number of an arrangement's members, and the modifiers that speak of the whole."""
    colors, number = noun.colors, noun.number
    rest = []
    for modifier in noun.modifiers:
        content = _content(modifier)
        if content is None:
            rest.append(modifier)
        else:
            colors = colors or content.colors
            number = number or content.number
    if "-" in noun.text:
        number = number or _hyphenated(noun.text)
    return colors, number, rest


def _content(modifier: Phrase) -> Noun | None:
    """The members that an arrangement is said to have: "of five", "of red blocks"."""
    texts = [word.text for word in modifier.words]
    if modifier.tag == "PP" and texts in (["of"], ["with"], ["containing"]) and modifier.phrases:
        inner = read_noun(modifier.phrases[0])
        if inner.head == "block" and not inner.ordinals and not inner.distance and not inner.modifiers:
            return inner
    return None


def _hyphenated(text: str) -> int | None:
    """The number of "a five-block row"."""
    for word in text.split():
        if "-" in word:
            for symbol in meanings(word.split("-")[0]):
                if isinstance(symbol, Cardinal):
                    return symbol.value
    return None


def _counted_lines(scene: Scene, noun: Noun, stuff: np.ndarray) -> sets.Sets:
    """The "third row", the "last column", the "top row" of all rows that the table is parted into."""
    kind = next((kind for kind in _LINES if kind in noun.kinds), None)
    if kind is None or "diagonal" in noun.kinds or len(noun.directions) > 1:
        return []
    ends = [_LINES[kind][name] for name in noun.directions if name in _LINES[kind]]
    if not (noun.ordinals or ends or noun.middle):
        return []
    found: dict[bytes, tuple[np.ndarray, float]] = {}
    for gap in arrangement.GAPS:
        parts = arrangement.partition(scene, stuff, kind, gap)
        index = noun.ordinals[0] - 1 if noun.ordinals and noun.ordinals[0] > 0 else -1
        if ends:
            index = ends[0] if not noun.ordinals else index if ends[0] == 0 else -1 - index
        elif noun.middle:
            index = len(parts) // 2
        if -len(parts) <= index < len(parts):
            mask = parts[index]
            weight = found.get(mask.tobytes(), (mask, 0.0))[1] + 1.0 / len(arrangement.GAPS)
            found[mask.tobytes()] = (mask, weight)
    return sorted(found.values(), key=lambda item: -item[1])


def _modified(reader: Reader, noun: Noun, found: sets.Sets, modifiers: list[Phrase]) -> sets.Sets:
    """Arrangements restricted and ranked as wholes, each standing at the mean of its members."""
    if not found:
        return found
    scene = reader.scene
    masks = np.array([mask for mask, _ in found], dtype=float)
    shares = masks / masks.sum(axis=1, keepdims=True)
    prior = np.array([weight for _, weight in found])
    weights = prior / max(float(prior.max()), 1e-9)
    ranks: list[Rank] = []
    for modifier in modifiers:
        for effect in reader.effects(modifier, np.ones(scene.n)):
            if isinstance(effect, Restriction):
                weights = weights * degrees.softened(shares @ effect.weights)
            elif isinstance(effect, Membership):
                inside = sum(chance * (shares @ mask) for mask, chance in effect.sets[:SETS])
                weights = weights * np.minimum(1.0, parameters.value("answer.floor") + inside)
            else:
                ranks.append(effect)
    ordinals = list(noun.ordinals)
    for rank in [*ranks, *_own_ranks(scene, reader.view, noun, counting=bool(ordinals and not ranks))]:
        index = rank.ordinal or (ordinals.pop(0) if ordinals else 1)
        weights = _ranked(masks, weights, shares @ rank.key, index, rank.noise)
    if noun.size:
        index = ordinals.pop(0) if ordinals else 1
        weights = _ranked(masks, weights, noun.size * masks.sum(axis=1), index, 0.3)
    return sorted(
        [(mask, float(weight)) for (mask, _), weight in zip(found, weights, strict=True) if weight > 1e-3],
        key=lambda item: -item[1],
    )


def _own_ranks(scene: Scene, view: str, noun: Noun, *, counting: bool) -> list[Rank]:
    """Ranks by the place of an arrangement that a noun's own words ask for, by its size left out.

    Args:
        scene: the world.
        view: whose left is meant where nobody is named.
        noun: of the arrangement.
        counting: whether an ordinal counts and no modifier says from where.
    """
    ranks = adjectives(scene, view, replace(noun, middle=False), np.ones(scene.n))
    if noun.middle and not noun.directions:
        ranks.append(Rank(-np.linalg.norm(scene.xy - scene.box[0], axis=1), None, 0.5 * scene.edge))
    if counting and not ranks and not noun.size:
        name = "left" if set(noun.kinds) & {"column", "tower", "group"} else "back"
        ranks.append(Rank(scene.xy @ scene.direction(name, view), None, 0.3 * scene.edge))
    return ranks


def _ranked(masks: Array, weights: Array, key: Array, index: int, noise: float) -> Array:
    """Rank sets; those that share members do not compete for a place, the likelier one stands for them."""
    keep = np.ones(len(weights), dtype=bool)
    order = np.argsort(-weights, kind="stable")
    for place, i in enumerate(order):
        keep[i] = not any(keep[j] and (masks[i] * masks[j]).any() for j in order[:place])
    ranked = degrees.ranked(weights * keep, key, index, noise)
    for i in np.flatnonzero(~keep):
        rival = weights * keep * ~((masks @ masks[i]) > 0)
        rival[i] = weights[i]
        ranked[i] = 0.6 * degrees.ranked(rival, key, index, noise)[i]
    return np.asarray(ranked)

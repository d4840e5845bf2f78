"""With which parts of a description an object agrees, and how well: what makes the answer fit better than a rival.

What restricts is asked for its own degree. What ranks depends on whom it ranks: its degree is the share of weight that
it leaves an object, that is the description's value with it over that without it.
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator
from dataclasses import dataclass, replace

import numpy as np

from grounding.explanations.tracing import TracedReader
from grounding.explanations.values import Contribution
from grounding.graded import words as w
from grounding.graded.nouns import Noun
from grounding.graded.reader import Reader
from grounding.graded.values import Membership, Rank, Restriction
from grounding.language.lexicon import meanings, size_order
from grounding.language.tree import Phrase
from grounding.symbols import Ordinal
from grounding.world import Array

FLOOR = 0.01  # degrees below this are all the same
_TOLD = 1.15  # a part is told of where the answer agrees with it so many times better


@dataclass(frozen=True, eq=False)
class Part:
    """A part of a description.

    Attributes:
        text: its words.
        degrees: how well every object agrees with it, shape (n,) in [0, 1].
        sharp: whether it holds or does not ("red"), so that no numbers need be told.
    """

    text: str
    degrees: Array
    sharp: bool = False


def parts_of(reader: TracedReader) -> tuple[Part, ...]:
    """The parts of all that was said of what shall be handled."""
    scene = reader.scene
    found: list[Part] = []
    for said, context in reader.spoken:
        plain = Reader(scene, reader.view, reader.history, context)
        found += _of_noun(said, plain) if isinstance(said, Noun) else _of_modifier(said, plain, np.ones(scene.n))
    if not scene.clear.all():
        found.append(Part("free above", np.where(scene.clear, 1.0, 0.1), sharp=True))
    return tuple(found)


def _of_noun(noun: Noun, reader: Reader) -> Iterator[Part]:
    if noun.head not in ("block", "container", "other") or noun.conjoined:
        return
    bare = replace(noun, ordinals=(), distance=None, directions=(), middle=False, size=0, lone=False, colors=(),
                   other=False, modifiers=())  # fmt: skip
    bare = replace(bare, head="block", kinds=()) if noun.head == "other" else bare
    if noun.colors:
        yield Part(" or ".join(noun.colors), _share(reader, replace(bare, colors=noun.colors), bare), sharp=True)
    if noun.lone:
        yield Part(_said(noun, w.is_lone), _share(reader, replace(bare, colors=noun.colors, lone=True),
                                                  replace(bare, colors=noun.colors)))  # fmt: skip
    ranking: list[Phrase] = []
    restricting: list[Phrase] = []
    base = _weights(reader, replace(bare, colors=noun.colors))
    for modifier in noun.modifiers:
        effects = reader.effects(modifier, base)
        if any(not isinstance(effect, Rank) for effect in effects):
            restricting.append(modifier)
            yield from _of_modifier(modifier, reader, base)
        else:
            ranking.append(modifier)
    ranks = noun.ordinals or noun.distance or noun.directions or noun.middle or noun.size or ranking
    if ranks:
        unranked = replace(bare, colors=noun.colors, lone=noun.lone, other=noun.other, modifiers=tuple(restricting))
        words = [_said(noun, _ranks), *(phrase.text for phrase in ranking)]
        yield Part(" ".join(filter(None, words)), _share(reader, noun, unranked))


def _of_modifier(phrase: Phrase, reader: Reader, base: Array) -> Iterator[Part]:
    degrees = np.ones(reader.scene.n)
    said = False
    for effect in reader.effects(phrase, base):
        if isinstance(effect, Restriction):
            degrees, said = degrees * effect.weights, True
        elif isinstance(effect, Membership) and effect.sets:
            best = max(chance for _, chance in effect.sets)
            inside = np.max([mask * (chance / max(best, 1e-9)) for mask, chance in effect.sets], axis=0)
            degrees, said = degrees * inside, True
    if said:
        yield Part(phrase.text, np.asarray(degrees))


def _weights(reader: Reader, noun: Noun) -> Array:
    return reader.noun(noun).weights


def _share(reader: Reader, noun: Noun, without: Noun) -> Array:
    """How much of the weight that objects have without something is left with it."""
    before, after = _weights(reader, without), _weights(reader, noun)
    return np.asarray(np.clip(np.divide(after, before, out=np.zeros_like(after), where=before > 1e-9), 0.0, 1.0))


def _said(noun: Noun, wanted: object) -> str:
    """The words of a noun, its modifiers left out, of some kind."""
    text = f" {noun.text} "
    for modifier in noun.modifiers:
        text = text.replace(f" {modifier.text} ", " ")
    assert callable(wanted)
    return " ".join(word for word in text.split() if wanted(word))


def _ranks(word: str) -> bool:
    return bool(
        w.directions(word) or w.distance(word) or w.is_middle(word) or size_order(word) or word in ("last", "most")
        or any(isinstance(symbol, Ordinal) for symbol in meanings(word))
    )  # fmt: skip


def compared(parts: Iterable[Part], answer: Iterable[int], rival: Iterable[int], name: str) -> tuple[Contribution, ...]:
    """Why a rival fits worse.

    Args:
        parts: of the description.
        answer: indices of the answer's objects.
        rival: of the rival's.
        name: of the rival.

    Returns:
        the parts with which it agrees less, the weightiest first; a weight is log(rival / answer), below 0.
    """
    own, other = list(answer), list(rival)
    kept: dict[str, Contribution] = {}
    for part in parts:
        good = float(part.degrees[own].mean()) if own else 0.0
        bad = float(part.degrees[other].mean()) if other else 0.0
        weight = math.log(max(bad, FLOOR) / max(good, FLOOR))
        if good < FLOOR or weight > -math.log(_TOLD):
            continue
        if part.sharp and bad < 0.2:
            text = f"{name} is not {part.text}"
        else:
            text = f'{name} agrees less with "{part.text}" ({bad:.2f} against {good:.2f})'
        if text not in kept or kept[text].weight > weight:
            kept[text] = Contribution(text, weight)
    return tuple(sorted(kept.values(), key=lambda reason: (reason.weight, reason.text)))

"""Texts, read literally: what they ask to be handled, or what of it is not there."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass

import numpy as np

from grounding.geometry.masks import indices_of, mask_of, single
from grounding.language.tree import Phrase
from grounding.lexicon import words as w
from grounding.lexicon.support import bare
from grounding.literal.following import Follower
from grounding.literal.prepositions import RELATIONS
from grounding.literal.presupposed import forms
from grounding.literal.reader import LiteralReader
from grounding.literal.values import FIRM, Meant, Missing, Unread
from grounding.literal.wider import held, is_missing
from grounding.meaning.discourse.following import read_text
from grounding.meaning.nouns import Noun, read_noun
from grounding.world.scene import Scene

_BACK = frozenset("it its itself them their".split())
_ON = frozenset("on onto atop top".split())
_POINTING = frozenset("the that this".split())


@dataclass(frozen=True)
class Rival:
    """A reference of a destination that holds of several things.

    Attributes:
        text: its words.
        ids: the things.
    """

    text: str
    ids: tuple[str, ...]


@dataclass(frozen=True)
class Literal:
    """What a text means literally.

    Attributes:
        options: ids of what may be handled; one where it is plain what is meant.
        missing: what is not there; None where all is.
        kind: of action.
        rival: what the words for where to leave open, or None where that is plain.
        vague: whether relations were read on which eyes differ.
        plural: whether it speaks of several.
        placed: whether it tells where to, where something is to be put.
    """

    options: tuple[tuple[str, ...], ...] = ()
    missing: Missing | None = None
    kind: str = "pick"
    rival: Rival | None = None
    vague: bool = False
    plural: bool = False
    placed: bool = True


def read_literally(tree: Phrase, scene: Scene, history: Sequence[int] = ()) -> Literal | None:
    """Read a text literally; None where that is not possible.

    Args:
        tree: its parse.
        scene: the world.
        history: indices of the objects handled before, the latest last.
    """
    reader = LiteralReader(scene, tuple(history))
    follower = Follower(reader)
    try:
        told = read_text(tree, follower)
        if told.target is None or told.doubt:
            return None
        vague = reader.vague
        target, together = follower.members(told.target), follower.sets(told.target)
        rival = None if forms(tree) else _check(told.destination, target, reader)
    except Missing as missing:
        return Literal(missing=missing)
    except Unread:
        return None
    ids = scene.layout.ids
    placed = told.kind != "place" or any(piece.phrases for piece in told.destination)
    if together:
        options = [tuple(ids[i] for i in indices_of(mask)) for mask in together]
        return Literal(tuple(dict.fromkeys(options)), kind=told.kind, rival=rival, vague=vague, plural=True,
                       placed=placed)  # fmt: skip
    if not target:
        return None
    handy = mask_of(int(i) for i in np.flatnonzero(reader.scene.clear)) & target
    options = [(ids[i],) for i in indices_of(handy or target)]
    return Literal(tuple(options), kind=told.kind, rival=rival, vague=vague, placed=placed)


def _check(destination: Sequence[Phrase], target: int, reader: LiteralReader) -> Rival | None:
    """What a destination leaves open.

    Raises:
        Missing: something that it speaks of is not there.
    """
    rival: Rival | None = None
    alike = len(reader.layout.colors) < 2
    for piece in destination:
        for phrase, related in _named(piece):
            noun = read_noun(phrase)
            if any(leaf.text in _BACK for leaf in phrase.leaves) or (_measures(noun) and not related):
                continue
            if _stacks(piece, noun) and not reader.scene.towers:
                raise Missing("nothing here is stacked: there is no tower to put it on", FIRM)
            try:
                meant = reader.meant(noun)
            except Unread:
                continue
            except Missing as missing:
                if "tower" in noun.kinds and (alike or not missing.shape):
                    continue  # people call what is lower or higher by the same name, and look from above
                agreement = held(noun, reader.scene, reader.views, reader.history)
                if is_missing(missing, agreement, reader.scene, reader.views, reader.history):
                    raise Missing(str(missing), FIRM) from missing
                continue
            ranks = noun.directions or noun.distance or noun.ordinals or noun.middle or noun.far
            leads = piece.tag in ("PP", "SBAR") and not {"from", "of"} & {word.text for word in piece.words}
            itself = target == meant.chosen
            if leads and not ranks and meant.chosen and itself:
                raise Missing(f"{phrase.text!r} is what is to be moved itself", FIRM)
            if rival is None and phrase.leaves[0].text in _POINTING:
                rival = _left_open(piece, phrase, noun, meant, target, reader)
    return rival


def _left_open(
    piece: Phrase, phrase: Phrase, noun: Noun, meant: Meant, target: int, reader: LiteralReader
) -> Rival | None:
    """The things of which one is meant by a definite noun that does not tell which."""
    if meant.chosen or meant.plural or meant.sort != "things":
        return None
    alike = len(reader.layout.colors) < 2
    if alike and not noun.colors:
        return None  # people speak loosely of places where nothing else tells things apart
    spoken_of = reader.spoken_of is not None and single(reader.spoken_of)
    if spoken_of and not noun.colors and not noun.modifiers:
        return None
    members = [i for i in indices_of(meant.pool) if not target >> i & 1]
    if any(w.is_on(leaf.text) or "up" in w.directions(leaf.text) for leaf in piece.leaves[:3]):
        moved = target.bit_length() - 1 if single(target) else -1
        free = bare(reader.scene, moved)
        members = [i for i in members if free[i] and not reader.scene.supports(i, moved)] or members
    return Rival(phrase.text, tuple(reader.layout.ids[i] for i in members)) if len(members) > 1 else None


def _stacks(piece: Phrase, noun: Noun) -> bool:
    """Whether something goes on top of a tower that is there already."""
    tower = noun.kinds[:1] == ("tower",) and noun.definite and not noun.plural
    return tower and bool(_ON & {leaf.text for leaf in piece.leaves[:3]})


def _measures(noun: Noun) -> bool:
    """Whether a noun may measure a distance: "three blocks", "almost five tiles"."""
    bare = not (noun.colors or noun.modifiers or noun.directions or noun.distance or noun.middle or noun.lone)
    return noun.head == "measure" or (bare and "the" not in noun.text.split())


def _named(phrase: Phrase, *, related: bool = False) -> Iterator[tuple[Phrase, bool]]:
    """The noun phrases of things that are not within others, each with whether a preposition relates to it."""
    if phrase.tag == "NP" and read_noun(phrase).head in ("block", "container"):
        yield phrase, related
        return
    before = ""
    for child in phrase.children:
        if isinstance(child, Phrase):
            yield from _named(child, related=before in RELATIONS and RELATIONS[before] != "near")
        before = "" if isinstance(child, Phrase) else child.text

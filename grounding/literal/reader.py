"""Noun phrases, read literally."""

from __future__ import annotations

import numpy as np

from grounding.geometry.masks import indices_of, mask_of, single
from grounding.graded.values import Effect as GradedEffect
from grounding.graded.values import Rank, Restriction, Value
from grounding.language.tree import Phrase
from grounding.literal.arrangements import mean_arrangement
from grounding.literal.choosing import half
from grounding.literal.modifiers import modify
from grounding.literal.places import mean_place
from grounding.literal.things import mean_things
from grounding.literal.values import FIRM, Effect, Meant, Missing, Unread, as_array
from grounding.meaning import recall
from grounding.meaning.nouns import Noun, read_noun
from grounding.world import Array
from grounding.world.scene import ROBOT, SPEAKER, Scene


class LiteralReader:
    """Reads phrases in one scene, literally.

    It has the face of `grounding.graded.reader.Reader`, so that a text is followed clause by clause as graded readings
    do; what it tells of an object is 1 or 0.

    Args:
        scene: the world.
        history: indices of the objects handled before, the latest last.

    Attributes:
        vague: whether relations were read on which eyes differ.
    """

    def __init__(self, scene: Scene, history: tuple[int, ...] = ()) -> None:
        self.scene = scene
        self.layout = scene.layout
        self.view = ROBOT
        self.history = history
        self.context: Array | None = None
        self.vague = False

    @property
    def views(self) -> tuple[str, ...]:
        """Whose directions may be meant where nobody is named."""
        return (ROBOT,) if self.layout.world.speaker is None else (ROBOT, SPEAKER)

    def mean(self, phrase: Phrase) -> Meant:
        """What a noun phrase means; see `meant`."""
        return self.meant(read_noun(phrase))

    def meant(self, noun: Noun, base: int | None = None) -> Meant:
        """What a noun means.

        Args:
            noun: that was read.
            base: the things among which it is, where they are told already.

        Raises:
            Unread: it is beyond what is read literally.
            Missing: it means nothing that is there.
        """
        try:
            return self._meant(noun, base)
        except Missing as missing:
            missing.noun = missing.noun or noun
            raise

    def _meant(self, noun: Noun, base: int | None) -> Meant:
        if self.history and recall.is_recalled(noun):
            return self._thing(1 << self.history[-1])
        if noun.conjoined:
            return self._joined(noun)
        match noun.head:
            case "agent":
                return Meant("agent", agent=self.person(noun.agent))
            case "table":
                if noun.modifiers or noun.directions:
                    raise Unread(noun.text)
                return Meant("table")
            case "pronoun":
                return self._pronoun(noun)
            case "place":
                return mean_place(self, noun)
            case "container":
                return mean_arrangement(self, noun)
            case "block" | "other":
                return mean_things(self, noun, base)
        raise Unread(noun.text)

    def modify(self, phrase: Phrase, noun: Noun, pool: int) -> list[Effect]:
        """What a modifier does to the things of a noun, see `grounding.literal.modifiers`."""
        return modify(self, phrase, noun, pool)

    def person(self, agent: str | None) -> str:
        """Who is meant: the speaker, where there is one who looks at the robot; else the robot.

        Raises:
            Unread: the speaker looks from the side.
        """
        speaker = self.layout.world.speaker
        if agent != SPEAKER or speaker is None:
            return ROBOT
        if np.cos(speaker.yaw) > -0.7:
            raise Unread("the speaker looks from the side")
        return SPEAKER

    def _thing(self, mask: int) -> Meant:
        return Meant("things", mask, mask)

    def _pronoun(self, noun: Noun) -> Meant:
        if noun.modifiers:
            raise Unread(noun.text)
        if self.context is not None:
            mask = mask_of(np.flatnonzero(self.context > 0.5))
            return Meant("things", mask, mask if single(mask) else 0)
        if not self.history:
            raise Unread(noun.text)
        return self._thing(1 << self.history[-1])

    def _joined(self, noun: Noun) -> Meant:
        """Two things."""
        if noun.modifiers or len(noun.conjoined) != 2:
            raise Unread(noun.text)
        parts = tuple(self.mean(part) for part in noun.conjoined)
        if any(part.sort != "things" for part in parts):
            raise Unread(noun.text)
        pool, chosen = parts[0].pool | parts[1].pool, parts[0].chosen | parts[1].chosen
        if parts[0].chosen & parts[1].chosen:
            raise Unread(noun.text)
        whole = all(part.chosen for part in parts)
        return Meant("things", pool, chosen if whole else 0, "group", True, 2, parts=parts)

    # -- as the reader of a text is asked ---------------------------------------------------------------------------

    def value(self, phrase: Phrase) -> Value:
        """What a noun phrase is worth: 1 for what it means, 0 for all others."""
        return self.noun(read_noun(phrase))

    def noun(self, noun: Noun) -> Value:
        """What a noun that was read is worth."""
        return self._value(self.meant(noun))

    def value_of(self, noun: Noun) -> Array:
        """The weights of a noun."""
        return self.noun(noun).weights

    def _value(self, meant: Meant) -> Value:
        n = self.scene.n
        if meant.sort == "agent":
            return Value("agent", np.zeros(n), agent=meant.agent)
        if meant.sort in ("place", "table"):
            return Value(meant.sort, np.zeros(n))
        mask = meant.chosen or meant.pool
        weights = as_array(mask, n).astype(float)
        if not meant.plural:
            return Value("objects", weights, definite=meant.definite)
        together = meant.sets if meant.sets and not meant.chosen else ((meant.kind, mask),)
        if not meant.chosen and not meant.sets:
            raise Unread("which of them?")
        return Value("sets", weights, tuple((as_array(m, n), 1.0) for _, m in together), definite=meant.definite,
                     number=meant.number)  # fmt: skip

    def effects(self, phrase: Phrase, base: Array) -> list[GradedEffect]:
        """What a phrase says of things that were named before it."""
        inside = mask_of(np.flatnonzero(base > 0.5))
        try:
            meant = self.meant(Noun(head="block", modifiers=(phrase,), text=phrase.text), inside)
        except Missing as missing:
            raise Unread(str(missing)) from missing
        return [Restriction(as_array(meant.chosen or meant.pool, self.scene.n).astype(float))]

    def within(self, noun: Noun, pool: Array) -> Array:
        """What a noun means among things that were spoken of."""
        inside = mask_of(np.flatnonzero(pool > 0.5))
        try:
            return self._value(self.meant(noun, inside)).weights
        except Missing as missing:
            if max(noun.ordinals, default=0) > inside.bit_count() > 0:
                raise Missing(str(missing), FIRM) from missing  # "there is a tower of four. take the fifth"
            return np.zeros(self.scene.n)

    def everything_in(self, noun: Noun) -> Value:
        """All that lies on the table or on a side of it."""
        pool = self.layout.everything
        if noun.head == "place":
            meant = self.meant(noun)
            sides = "half side part section area".split()
            if len(meant.names) != 1 or not set(sides) & set(noun.text.split()):
                raise Unread(noun.text)
            pool = half(self.scene, pool, meant.names[0], clear=not meant.parts)
        if not pool:
            raise Missing(f"there is nothing on {noun.text!r}")
        return self._value(Meant("things", pool, pool, "group", True))

    def ranked_again(self, target: Array, rank: Rank) -> Array:
        """Ranks are taken where they are read."""
        raise Unread("ranked again")

    def members(self, mask: int) -> tuple[int, ...]:
        """The indices of a set."""
        return tuple(indices_of(mask))

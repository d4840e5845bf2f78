"""Noun phrases, read literally."""

from __future__ import annotations

import numpy as np

from grounding.geometry.masks import indices_of, single
from grounding.language.tree import Phrase
from grounding.lexicon.size import vary
from grounding.literal.arrangements import mean_arrangement
from grounding.literal.modifiers import modify
from grounding.literal.places import mean_place
from grounding.literal.things import mean_things
from grounding.literal.values import Effect, Meant, Missing, Unread
from grounding.meaning import recall
from grounding.meaning.nouns import Noun, read_noun
from grounding.world.scene import ROBOT, SPEAKER, Scene


class LiteralReader:
    """Reads phrases in one scene, literally.

    Args:
        scene: the world.
        history: indices of the objects handled before, the latest last.

    Attributes:
        spoken_of: what "it" is, as bits, or None.
        vague: whether relations were read on which eyes differ.
    """

    def __init__(self, scene: Scene, history: tuple[int, ...] = ()) -> None:
        self.scene = scene
        self.layout = scene.layout
        self.history = history
        self.spoken_of: int | None = None
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
        several = noun.head == "table" and bool(noun.colors or noun.directions or noun.other)
        if several or (noun.sized and vary(self.scene)):
            raise Unread(noun.text)  # sizes and tables are compared and not looked up
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
        if self.spoken_of is not None:
            mask = self.spoken_of
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

    def members(self, mask: int) -> tuple[int, ...]:
        """The indices of a set."""
        return tuple(indices_of(mask))

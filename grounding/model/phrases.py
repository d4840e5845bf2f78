"""Single phrases in a scene: what a noun phrase by itself means, for places, questions and descriptions."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from grounding.language.tree import Phrase
from grounding.meaning.nouns import Noun, read_noun
from grounding.meaning.reader import Reader
from grounding.meaning.referents import Referent
from grounding.model.belief import Reading
from grounding.model.cases import Denotation, combined
from grounding.model.evaluator import Evaluator
from grounding.model.surroundings import context_in
from grounding.world import Array
from grounding.world.scene import Scene


class Meant(NamedTuple):
    """What a noun speaks of, and what that is in a scene.

    Attributes:
        referent: as it was read.
        denotation: in the scene.
    """

    referent: Referent
    denotation: Denotation


class PhraseReader:
    """Reads single noun phrases in one scene with one view, after what was told before.

    Args:
        evaluator: of the scene, with the view and the weights.
        mentioned: what "it" is, or None.
        several: whether that are several.
    """

    def __init__(self, evaluator: Evaluator, mentioned: Referent | None = None, *, several: bool = False) -> None:
        self.evaluator = evaluator
        self.context = context_in(evaluator.scene, evaluator.history, mentioned, several=several)

    @property
    def scene(self) -> Scene:
        """The scene."""
        return self.evaluator.scene

    @property
    def view(self) -> str:
        """Whose left is meant where nobody is named."""
        return self.evaluator.view

    def noun(self, noun: Noun) -> Meant:
        """What a noun means."""
        referent = Reader(self.context).refer(noun)
        return Meant(referent, self.evaluator.denote(referent))

    def among(self, referent: Referent, mask: np.ndarray) -> Denotation:
        """What a referent of objects means if nothing but some objects is there.

        Args:
            referent: as it was read.
            mask: of those objects, boolean (n,).
        """
        scene, weights = self.scene, self.evaluator.weights
        cases = self.evaluator.cases(referent, mask.astype(float))
        return combined(cases, weights, scene.n, self.evaluator.truth_within(referent), several=False)

    def phrase(self, phrase: Phrase) -> Meant:
        """What a noun phrase means."""
        return self.noun(read_noun(phrase))

    def weights(self, noun: Noun) -> Array:
        """How likely each object is what a noun means, shape (n,); 1 for the best, all 0 where nothing is."""
        return self.noun(noun).denotation.weights


def reader_of(reading: Reading) -> PhraseReader:
    """A reader of the phrases of a text as one reading has them: "it" is what was spoken of before the command."""
    told = reading.told
    return PhraseReader(reading.evaluator, told.mentioned, several=told.mentioned is not None and told.plural)

"""Places between two arrangements: "between the row and the column", "between the two columns"."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from grounding.lexicon import between
from grounding.lexicon.where import Where
from grounding.meaning.nouns import Noun, read_noun
from grounding.meaning.referents import SETS
from grounding.model.phrases import PhraseReader
from grounding.world import Array


def amid_sets(nouns: Sequence[Noun], reader: PhraseReader, points: Array) -> Array | None:
    """Tells how well places lie between two arrangements, by the same concept as the objects there.

    Args:
        nouns: that are said to be on both sides, one or two of them.
        reader: of the scene.
        points: places, shape (p, 2) in [m].

    Returns:
        shape (p,); None where the nouns name no two arrangements.
    """
    parts = _parts(nouns, reader)
    if len(parts) != 2:
        return None
    return between.amid(Where.points(reader.scene, points), reader.scene, parts, surrounding=False)


def _parts(nouns: Sequence[Noun], reader: PhraseReader) -> list[between.Part]:
    named = [read_noun(phrase) for noun in nouns for phrase in noun.conjoined] or list(nouns)
    found: list[between.Part] = []
    for noun in named:
        referent, denotation = reader.noun(noun)
        if referent.sort != SETS or not referent.kinds or not denotation.sets:
            return []
        several = noun.plural and len(named) == 1
        for mask, _ in denotation.sets:
            apart = not any((part.weights * mask).any() for part in found)
            if mask.sum() > 1 and apart:
                found.append(between.Part(mask.astype(float), None, np.zeros(2)))
                if not several or len(found) == 2:
                    break
    return found

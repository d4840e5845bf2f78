"""Sentences of the project's own wording, drawn as gold trees from productions written by hand."""

from grounding.corpus.wording.sampler import (
    EVERYTHING,
    FAMILIES,
    MARKS,
    PRODUCTIONS,
    Sample,
    Topics,
    renumber,
    sample,
    sample_tree,
    sampled_sentences,
    sentences_of,
)

__all__ = [
    "EVERYTHING",
    "FAMILIES",
    "MARKS",
    "PRODUCTIONS",
    "Sample",
    "Topics",
    "renumber",
    "sample",
    "sample_tree",
    "sampled_sentences",
    "sentences_of",
]

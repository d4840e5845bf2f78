"""Annotated examples: their values and files, the reader of the paper's XML, composed worlds, checks."""

from grounding.corpus.format import Corpus, Example, read_corpus, write_corpus
from grounding.corpus.loading import load_corpus
from grounding.errors import CorpusError, CorpusErrors

__all__ = ["Corpus", "CorpusError", "CorpusErrors", "Example", "load_corpus", "read_corpus", "write_corpus"]

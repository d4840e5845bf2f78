"""A corpus from whatever a path names: a file in the project's format or a folder of the paper's XML."""

from __future__ import annotations

from pathlib import Path

from grounding.corpus.format import Corpus, read_corpus
from grounding.corpus.rss import read_folder
from grounding.errors import CorpusError
from models import ROOT

TREEBANK = ROOT / "treebank" / "treebank.jsonl"


def load_corpus(path: Path | str | None = None, keep_going: bool = False) -> Corpus:
    """Read a corpus.

    Args:
        path: a `.jsonl` file or a folder of `example_*.xml`; the treebank that ships with the project by default.
        keep_going: read everything and raise all refusals together.

    Raises:
        CorpusError: naming the file and the element; `CorpusErrors` with `keep_going`.
    """
    where = TREEBANK if path is None else Path(path)
    if where.is_dir():
        return read_folder(where, keep_going)
    if where.suffix == ".jsonl" or not where.exists():
        return read_corpus(where, keep_going)
    raise CorpusError(f"{where}: a corpus is a .jsonl file or a folder of example_*.xml")

"""The corpus and the folder of an experiment, as its command line names them."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

from grounding.corpus.corrections import apply_corrections, read_corrections
from grounding.corpus.format import Corpus
from grounding.corpus.loading import load_corpus
from grounding.errors import CorpusErrors
from grounding.experiments.errors import ExperimentError


def read_corpus(
    path: Path, corrections: Path | None, keep_going: bool, tell: Callable[[str], None]
) -> tuple[Corpus, bool]:
    """Read a corpus, and correct it.

    Args:
        path: a folder of the paper's XML or a file in the project's format.
        corrections: a file of corrections, or None.
        keep_going: use what is not refused.
        tell: told every refusal, where reading goes on.

    Returns:
        the corpus and whether it is whole.

    Raises:
        CorpusError: something was refused, and `keep_going` is not asked for or nothing is left.
    """
    whole = True
    try:
        corpus = load_corpus(path, keep_going)
    except CorpusErrors as error:
        if error.rest is None:
            raise
        for problem in error.problems:
            tell(f"error: {' '.join(str(problem).split())}")
        corpus, whole = error.rest, False
        tell(f"{len(error.problems)} refused; going on with the other {len(corpus)} examples")
    if corrections is None:
        return corpus, whole
    known = {example.id for example in corpus}
    wanted = read_corrections(corrections, keep_going)
    if not whole:  # corrections of examples that were refused have nothing to correct
        wanted = type(wanted)(wanted.source, tuple(entry for entry in wanted.examples if entry.id in known))
    return apply_corrections(corpus, wanted, keep_going), whole


def make_folder(path: Path) -> None:
    """Make the folder for results.

    Raises:
        ExperimentError: there is a file of that name.
    """
    if path.exists() and not path.is_dir():
        raise ExperimentError(f"{path}: is a file; --output names a folder")
    path.mkdir(parents=True, exist_ok=True)

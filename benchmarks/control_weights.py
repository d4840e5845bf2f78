"""Weights that learning did not choose, as controls for those that it did.

Equal: every concept counts the same, see `grounding.learning.beliefs.EQUAL`. Shuffled: the weights are learned as ever,
but what every text means is drawn from what its readings propose.
"""

from __future__ import annotations

import hashlib
import sys
from pathlib import Path

import grounding
import models
from grounding.corpus.generator import is_held_out
from grounding.corpus.hands import read_hands
from grounding.corpus.loading import load_corpus
from grounding.corpus.making import make_corpus
from grounding.grounder import Grounder
from grounding.learning.beliefs import Text, learn_beliefs, texts_by_hand, texts_of
from grounding.model.cases import Learned
from grounding.model.storage import load_learned, save_learned
from motion.cache import cached_folder

SEED = 0  # of what is drawn and generated
_NAME = "beliefs.json"


def shuffled_weights(grounder: Grounder, generated: int, cache: Path | None = None) -> Learned:
    """The weights learned from shuffled answers; from the cache where they were learned before.

    Args:
        grounder: that reads the texts.
        generated: so many generated texts are learned from beside the treebank and the free texts.
        cache: folder in which the weights are kept; the user's cache by default.
    """

    def build(folder: Path) -> None:
        print("learning from shuffled answers, once; this takes minutes", file=sys.stderr, flush=True)
        texts = training_texts(grounder, generated)
        weights = learn_beliefs(texts, grounder, shuffled=SEED, progress=_say)
        save_learned(weights, folder / _NAME, {"texts": len(texts), "shuffled": SEED})

    return load_learned(cached_folder(f"shuffled-{_digest(generated)}", build, cache) / _NAME)


def training_texts(grounder: Grounder, generated: int) -> list[Text]:
    """What the weights are learned from: the treebank, so many generated texts, the free texts."""
    corpora = [load_corpus(), *([make_corpus(generated, SEED)] if generated else [])]
    kept = [corpus.select(e for e in corpus if not is_held_out(e.tree)) for corpus in corpora]
    return [*(text for corpus in kept for text in texts_of(corpus, grounder)), *texts_by_hand(read_hands(), grounder)]


def _say(text: str) -> None:
    print(f"  {text}", file=sys.stderr, flush=True)


def _digest(generated: int) -> str:
    """What the shuffled weights depend on: the texts, the grammar and the code that turns them into weights."""
    root = Path(grounding.__file__).parent
    learned = [path for folder in (models.TREEBANK, models.HANDS) for path in folder.rglob("*") if path.is_file()]
    digest = hashlib.sha256(f"{generated} {SEED}".encode())
    for path in sorted([*root.rglob("*.py"), *root.rglob("*.toml"), *learned, models.GRAMMAR]):
        digest.update(path.read_bytes())
    return digest.hexdigest()[:16]

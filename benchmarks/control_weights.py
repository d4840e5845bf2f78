"""Weights that learning did not choose, as controls for those that it did.

Equal: every weight keeps its sign and gets the mean absolute weight of its factor (unit weights, Dawes 1979). A feature
is a fact of the context together with a role of the symbol. By itself it speaks neither for nor against: without the
learned signs every proposed symbol would be true. So equal weights still know the learned directions, not the sizes.

Shuffled: the factors are trained as ever, but within each factor the answers are permuted among all its rows (a row is
one symbol judged of one phrase). Contexts, roles and the share of true symbols stay; which are true is chance.
"""

from __future__ import annotations

import hashlib
import sys
from collections.abc import Mapping
from pathlib import Path

import numpy as np

import grounding
import models
from grounding.commands.train import PENALTY
from grounding.corpus.format import Corpus
from grounding.corpus.generator import is_held_out
from grounding.corpus.loading import load_corpus
from grounding.corpus.making import make_corpus
from grounding.factors import Factor, FactorModel, TrainingSet, load_model, save_model, train
from grounding.features.discretiser import strictness
from grounding.geometry.layout import Layout
from grounding.learning.examples import Annotated, annotated, collect
from motion.cache import cached_folder

SEED = 0  # of the permutation and of what is generated
VERSION = 1  # of how answers are shuffled
_TRAINING = ("corpus", "factors", "features", "geometry", "language", "learning")  # packages that shape what is learned
_NAME = "weights"


def equal_weights(model: FactorModel) -> FactorModel:
    """The model with equal weights, see the module."""
    factors = {}
    for name, factor in model.factors.items():
        used = np.abs(factor.weights[factor.weights != 0])
        size = float(used.mean()) if used.size else 0.0
        factors[name] = Factor(factor.facts, factor.roles, size * np.sign(factor.weights))
    return FactorModel(factors, model.notes)


def shuffled_weights(generated: int, cache: Path | None = None) -> FactorModel:
    """The factors trained on shuffled answers, see the module; from the cache where they were trained before.

    Args:
        generated: so many generated examples are learned from beside the treebank.
        cache: folder in which the weights are kept; the user's cache by default.
    """

    def build(folder: Path) -> None:
        print("training on shuffled answers, once; this takes minutes", file=sys.stderr, flush=True)
        save_model(trained_on_shuffled(_examples(generated), {"generated": generated}), folder / _NAME)

    return load_model(cached_folder(f"shuffled-{_digest(generated)}", build, cache) / _NAME)


def trained_on_shuffled(examples: list[Annotated], notes: Mapping[str, object]) -> FactorModel:
    """Train all factors on examples whose answers are permuted within each factor."""
    rng = np.random.default_rng(SEED)
    sets, _ = collect(examples)
    factors = {}
    for name, data in sets.items():
        factors[name] = train(shuffled(data, rng), PENALTY, strictness=strictness)
        print(f"  {name}: {len(data.rows)} rows", file=sys.stderr, flush=True)
    return FactorModel(factors, {"examples": len(examples), "shuffled": SEED, **notes})


def shuffled(data: TrainingSet, rng: np.random.Generator) -> TrainingSet:
    """The rows of a factor with their answers permuted; as many are true as before."""
    cells: dict[tuple[int, tuple[int, ...]], int] = {}
    true = 0
    for (context, roles, label), count in data.rows.items():
        cells[context, roles] = cells.get((context, roles), 0) + round(count)
        true += round(count) if label else 0
    rows: dict[tuple[int, tuple[int, ...], bool], float] = {}
    if cells:
        totals = list(cells.values())
        drawn = rng.multivariate_hypergeometric(totals, true, method="marginals")
        for (context, roles), total, hit in zip(cells, totals, drawn.tolist(), strict=True):
            rows |= {(context, roles, label): count for label, count in ((True, hit), (False, total - hit)) if count}
    return TrainingSet(data.facts, data.roles, data.contexts, rows)


def _examples(generated: int) -> list[Annotated]:
    corpora: list[Corpus] = [load_corpus(), *([make_corpus(generated, SEED)] if generated else [])]
    found = []
    for corpus in corpora:
        layouts = {name: Layout(world) for name, world in corpus.worlds.items()}
        found += [annotated(e.tree, e.groundings, layouts[e.world]) for e in corpus.examples
                  if not e.history and not is_held_out(e.tree)]  # fmt: skip
    return found


def _digest(generated: int) -> str:
    """What the shuffled weights depend on: the treebank, and the code that turns it into weights."""
    root = Path(grounding.__file__).parent
    code = [path for name in _TRAINING for path in (root / name).rglob("*.py")]
    learned = [path for path in models.TREEBANK.rglob("*") if path.is_file()]
    files = [*code, *learned, root / "symbols.py", root / "world.py"]
    digest = hashlib.sha256(f"{VERSION} {generated} {SEED} {PENALTY}".encode())
    for path in sorted(files):
        digest.update(path.read_bytes())
    return digest.hexdigest()[:16]

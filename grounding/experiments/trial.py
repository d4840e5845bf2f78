"""One split: learn from one part, ground the other with every method, compare with the annotation."""

from __future__ import annotations

import time
from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

from grounding.corpus.format import Corpus, Example
from grounding.experiments.engines import ADAPTIVE, PROPOSING, Engine, make_engine
from grounding.experiments.processes import peak_memory
from grounding.experiments.splits import Split, layout_key
from grounding.geometry.layout import Layout
from grounding.inference import Hypothesis, Inference
from grounding.language.grammar import Grammar
from grounding.language.parser import Parser
from grounding.language.tree import Phrase
from grounding.learning import Negatives, learn
from grounding.learning.evaluation import score_tree
from grounding.learning.examples import Annotated, annotated
from grounding.learning.first_pass import count_kept
from grounding.readings import preferred, readings

PARSES = ("annotated", "own")
Variants = tuple[tuple[str, str], ...]  # pairs of parse and engine


@dataclass(frozen=True)
class Settings:
    """What all splits of a run have in common.

    Attributes:
        inference: names of engines.
        parse: of `PARSES`.
        threshold: a symbol counts as found when its probability exceeds this.
        penalty: strength of the L2 regularisation in training.
        readings: how many parses of a text are grounded where the parse is our own; the world decides between them.
        exhaustive: methods that judge all of Γ are run on worlds of at most so many blocks.
        negatives: in training, all of Γ is negative in worlds of up to so many blocks, and what is proposed in others.
    """

    inference: tuple[str, ...] = (ADAPTIVE,)
    parse: tuple[str, ...] = ("annotated",)
    threshold: float = 0.75
    penalty: float = 0.1
    readings: int = 4
    exhaustive: int = 12
    negatives: int = 0

    @property
    def variants(self) -> Variants:
        """Every parse with every engine."""
        return tuple((parse, name) for parse in self.parse for name in self.inference)


def run_trial(corpus: Corpus, split: Split, settings: Settings, variants: Variants) -> dict[str, Any]:
    """Train on one part of a corpus and test on the other.

    Args:
        corpus: parted by `split`.
        split: places of its examples.
        settings: of the run.
        variants: the pairs (parse, engine) to test.

    Returns:
        plain values: `training` (seconds, megabytes, examples, features) and `rows`, one a tested example and variant.
    """
    layouts = {name: Layout(world) for name, world in corpus.worlds.items()}
    train = [corpus.examples[i] for i in split.train]
    test = [corpus.examples[i] for i in split.test]
    before, start = peak_memory(), time.perf_counter()
    negatives = Negatives(things=settings.negatives)
    model = learn([_annotated(example, layouts) for example in train], settings.penalty, negatives=negatives)
    training = {
        "seconds": round(time.perf_counter() - start, 3),
        "megabytes": peak_memory(),
        "megabytes before": before,
        "examples": len(train),
        "features": model.feature_count,
    }
    seen = _Seen(corpus, train)
    parser = Parser(Grammar.learn(e.tree for e in train)) if any(parse == "own" for parse, _ in variants) else None
    rows = []
    for parse, name in variants:
        engine = make_engine(name, model)
        for example in test:
            layout = layouts[example.world]
            if name not in PROPOSING and layout.size > settings.exhaustive:
                continue
            gold = _annotated(example, layouts)
            used = parser if parse == "own" else None
            row = {"id": example.id, "parse": parse, "inference": name, "blocks": layout.size, **seen(example)}
            tested = _tested(example.instruction, gold, engine, used, settings)
            rows.append({**row, **tested, **_kept(engine, gold)})
    return {"split": split.name, "by": split.by, "holdout": split.holdout, "number": split.number,
            "training": training, "rows": rows}  # fmt: skip


def _annotated(example: Example, layouts: Mapping[str, Layout]) -> Annotated:
    return annotated(example.tree, example.groundings, layouts[example.world])


def _tested(text: str, gold: Annotated, engine: Engine, parser: Parser | None, settings: Settings) -> dict[str, Any]:
    """The score of one example by one variant."""
    tree, groundings, layout = gold
    start = time.perf_counter()
    if parser is None:
        inference = engine.infer(tree, layout)
        grounded, hypothesis, count = tree, preferred(inference, layout), inference.evaluations
    else:
        grounded, hypothesis, count = own_parse(parser, text, settings.readings, engine, layout)
    seconds = time.perf_counter() - start
    score = score_tree(tree, groundings, grounded, hypothesis, settings.threshold)
    return {
        "root": score.root, "complete": score.complete, "right": score.right, "phrases": score.phrases,
        "extra": score.extra, "missing": sum(mistake.found is None for mistake in score.mistakes),
        "seconds": round(seconds, 6), "evaluations": count,
    }  # fmt: skip


def _kept(engine: Engine, gold: Annotated) -> dict[str, int]:
    """How many of the kinds of symbols that the phrases of an example need a first pass keeps, if there is one."""
    restriction = getattr(engine, "restriction", None)
    if restriction is None:
        return {}
    kept, needed = count_kept(restriction, gold)
    return {"kinds kept": kept, "kinds needed": needed}


def own_parse(
    parser: Parser, text: str, count: int, engine: Engine, layout: Layout
) -> tuple[Phrase, Hypothesis, int]:
    """Parse a text, ground its likeliest parses, and take the one that makes most sense in the world.

    Returns:
        the tree, the hypothesis that is believed, and how many factors were evaluated for all parses.
    """
    parses = parser.parse(text, count)
    inferred: list[tuple[Inference, float]] = [(engine.infer(p.tree, layout), p.probability) for p in parses]
    best = readings(inferred, layout)[0]
    return best.inference.tree, best.hypothesis, sum(one.evaluations for one, _ in inferred)


class _Seen:
    """Which texts and worlds of a corpus were learned from."""

    def __init__(self, corpus: Corpus, train: list[Example]) -> None:
        self._keys = {name: layout_key(world) for name, world in corpus.worlds.items()}
        self._texts = {example.tree.text for example in train}
        self._worlds = {self._keys[example.world] for example in train}

    def __call__(self, example: Example) -> dict[str, bool]:
        return {"text seen": example.tree.text in self._texts, "world seen": self._keys[example.world] in self._worlds}

"""Whether a change of the code leaves what inference says as it was: groundings, probabilities, evaluations.

    python benchmarks/same_answers.py --corpus FOLDER --folder DIR [--inference adcg] [--most N]

The first run learns factors from the corpus, grounds it and keeps both in the folder. Later runs ground it again with
the same factors and the shipped ones, and compare; the exit code is 1 where anything differs by more than 1e-9.
"""

from __future__ import annotations

import argparse
import json
import sys
from collections.abc import Iterator
from pathlib import Path

import numpy as np

import models
from grounding.corpus.format import Corpus
from grounding.corpus.loading import load_corpus
from grounding.errors import SearchError
from grounding.experiments.large_worlds import compose_large
from grounding.factors import FactorModel, load_model, save_model
from grounding.geometry.layout import Layout
from grounding.inference import ENGINES, Inference, aligned
from grounding.learning import learn
from grounding.learning.examples import annotated

TOLERANCE = 1e-9
LARGE = 20  # blocks of the composed worlds
COMPOSED = 40  # instructions that are grounded in them


def learned(corpus: Corpus, path: Path) -> FactorModel:
    """The factors of the corpus, as the first run learned them."""
    if not path.with_suffix(".npz").exists():
        layouts = {name: Layout(world) for name, world in corpus.worlds.items()}
        save_model(learn([annotated(e.tree, e.groundings, layouts[e.world]) for e in corpus], 0.1), path)
    return load_model(path)


def plain(inference: Inference) -> dict[str, object]:
    """All that was inferred, as plain values."""
    hypotheses = [
        [
            [sorted(map(str, part.symbols)), part.log_probability,
             {str(symbol): p for symbol, p in sorted(part.probabilities.items(), key=lambda item: str(item[0]))}]
            for _, part in aligned(inference.tree, hypothesis)
        ]
        for hypothesis in inference.hypotheses
    ]  # fmt: skip
    sizes = dict(sorted(inference.sizes.items()))
    return {"hypotheses": hypotheses, "evaluations": inference.evaluations, "sizes": sizes}


def answers(corpus: Corpus, models_: dict[str, FactorModel], name: str, most: int) -> Iterator[tuple[str, object]]:
    """What an engine infers for every instruction, in its own world and some in larger ones."""
    layouts = {world: Layout(corpus.worlds[world]) for world in corpus.worlds}
    rng = np.random.default_rng(0)
    large = [Layout(compose_large(rng, LARGE)) for _ in range(4)]
    for which, model in models_.items():
        for number, example in enumerate(list(corpus)[:most]):
            try:
                yield f"{which} {example.id}", plain(ENGINES[name](model).infer(example.tree, layouts[example.world]))
            except SearchError as error:
                yield f"{which} {example.id}", str(error)
            if number < COMPOSED and name.endswith("adcg"):
                layout = large[number % len(large)]
                yield f"{which} {example.id} composed", plain(ENGINES[name](model).infer(example.tree, layout))


def difference(before: object, now: object) -> float:
    """The largest difference of two numbers in the same place; infinite where anything else differs."""
    if isinstance(before, float) and isinstance(now, float):
        return abs(before - now)
    if isinstance(before, list) and isinstance(now, list) and len(before) == len(now):
        return max(map(difference, before, now), default=0.0)
    if isinstance(before, dict) and isinstance(now, dict) and before.keys() == now.keys():
        return max((difference(before[key], now[key]) for key in before), default=0.0)
    return 0.0 if before == now else float("inf")


def main() -> int:
    """Ground, and keep or compare."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--corpus", type=Path, required=True)
    parser.add_argument("--folder", type=Path, required=True)
    parser.add_argument("--inference", default="adcg", choices=list(ENGINES))
    parser.add_argument("--most", type=int, default=1000, help="instructions")
    args = parser.parse_args()
    args.folder.mkdir(parents=True, exist_ok=True)
    corpus = load_corpus(args.corpus)
    known = {"learned": learned(corpus, args.folder / "factors"), "shipped": load_model(models.WEIGHTS)}
    found = dict(answers(corpus, known, args.inference, args.most))
    path = args.folder / f"{args.inference}.json"
    if not path.exists():
        path.write_text(json.dumps(found), encoding="utf-8")
        print(json.dumps({"kept": len(found)}))
        return 0
    before = json.loads(path.read_text(encoding="utf-8"))
    wrong = {key: difference(before.get(key), value) for key, value in found.items()}
    worst = max(wrong.values())
    print(json.dumps({"compared": len(found), "largest difference": worst,
                      "differ": [key for key, value in wrong.items() if value > TOLERANCE][:10]}))  # fmt: skip
    return 0 if worst <= TOLERANCE else 1


if __name__ == "__main__":
    sys.exit(main())

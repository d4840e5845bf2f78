"""Makes whole corpora of composed worlds, world by world, so that what is made can be kept and gone on with."""

from __future__ import annotations

import json
from collections import Counter
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np

from grounding.corpus.compositions import compose_world
from grounding.corpus.format import Corpus, Example, example_from_json, example_to_json
from grounding.corpus.generator import generate, wording_of
from grounding.errors import CorpusError
from grounding.world import World, world_from_json, world_to_json

EACH = 20  # examples a world


def make_corpus(
    count: int, seed: int, each: int = EACH, kept: Path | None = None, tell: Callable[[int], None] | None = None
) -> Corpus:
    """A corpus of so many generated examples in composed worlds.

    Args:
        count: of examples.
        seed: of all chance: the same count, seed and `each` give the same corpus.
        each: at most so many examples a world.
        kept: file in which every finished world is kept; what it holds of the same corpus is not made again.
        tell: told the number of new examples after every world.

    Raises:
        CorpusError: `kept` belongs to another corpus or cannot be read.
    """
    settings = {"count": count, "seed": seed, "each": each}
    examples: list[Example] = []
    worlds: dict[str, World] = {}
    taken: Counter[str] = Counter()
    number = 0
    for name, world, found in _read(kept, settings):
        number += 1
        _add(examples, worlds, taken, name, world, found)
        if tell is not None:
            tell(len(found))
    while len(examples) < count:
        rng = np.random.default_rng([seed, number])
        laid = compose_world(rng, f"g{seed}-{number:05d}")
        number += 1
        found = generate(laid, rng, min(each, count - len(examples)), taken.copy())
        if kept is not None:
            _keep(kept, settings, laid.name, laid.layout.world, found)
        _add(examples, worlds, taken, laid.name, laid.layout.world, found)
        if tell is not None:
            tell(len(found))
    return Corpus(tuple(examples), worlds)


def _add(
    examples: list[Example], worlds: dict[str, World], taken: Counter[str], name: str, world: World,
    found: tuple[Example, ...],
) -> None:  # fmt: skip
    examples += found
    taken.update(wording_of(example.tree) for example in found)
    if found:
        worlds[name] = world


def _keep(path: Path, settings: dict[str, int], name: str, world: World, found: tuple[Example, ...]) -> None:
    fresh = not path.exists()
    line = {"name": name, "world": world_to_json(world), "examples": [example_to_json(example) for example in found]}
    with path.open("a", encoding="utf-8") as file:
        if fresh:
            file.write(json.dumps(settings) + "\n")
        file.write(json.dumps(line) + "\n")


def _read(path: Path | None, settings: dict[str, int]) -> list[tuple[str, World, tuple[Example, ...]]]:
    if path is None or not path.exists():
        return []
    lines = path.read_text(encoding="utf-8").split("\n")
    try:
        if json.loads(lines[0]) != settings:
            raise CorpusError(f"{path}: was left by another run ({lines[0]}); delete it or ask for the same")
        whole = [json.loads(line) for line in lines[1:-1]]  # the last line may have been cut off
    except ValueError as error:
        raise CorpusError(f"{path}: cannot be read as what an earlier run left ({error}); delete it") from error
    if lines[-1]:  # cut off: forget it
        path.write_text("".join(line + "\n" for line in lines[:-1]), encoding="utf-8")
    return [_world(entry, str(path)) for entry in whole]


def _world(entry: dict[str, Any], source: str) -> tuple[str, World, tuple[Example, ...]]:
    world = world_from_json(entry["world"], source)
    known = {entry["name"]: world}
    return entry["name"], world, tuple(example_from_json(example, known) for example in entry["examples"])

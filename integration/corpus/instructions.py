"""Instructions for settled worlds: made in parts that processes share, counted and joined in batches.

Parts of a batch know how often each wording was used in the batches before it, and nothing of one another: so the
corpus is the same for any number of processes. What they make too often between them is dropped when they are joined.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass, field
from typing import Any

import numpy as np

from grounding.corpus.format import Example, example_to_json
from grounding.corpus.generator import MOST_COPIES, generate, is_held_out, wording_of
from grounding.symbols import Action
from integration.corpus.constructions import constructions
from integration.corpus.settings import Folder, Settings
from integration.corpus.settled_worlds import SettledWorld, settled_from_json
from integration.workers import Workers

WORLDS_A_PART = 5
PARTS_A_BATCH = 16
_DRY = 4  # batches in a row that give next to nothing before it ends
_LITTLE = 0.05  # of what a batch was asked for is next to nothing


@dataclass
class Sentences:
    """Instructions, joined so far.

    Attributes:
        items: one a sentence: `example` as a line of a corpus, `said` (its words alone), `wording`, `held_out`,
            `action`, `constructions`.
        taken: how often each wording is among them.
        dropped: how many were dropped as too frequent or said before in the same world.
    """

    items: list[dict[str, Any]] = field(default_factory=list)
    taken: Counter[str] = field(default_factory=Counter)
    dropped: int = 0
    _said: set[tuple[str, str]] = field(default_factory=set)
    _numbers: Counter[str] = field(default_factory=Counter)

    def join(self, made: Sequence[dict[str, Any]], most: int) -> int:
        """Add what a batch made, until there are `most`; how many were added."""
        before = len(self.items)
        for item in made:
            if len(self.items) == most:
                break
            example = item["example"]
            said = example["world"], item["said"]
            if said in self._said or self.taken[item["wording"]] >= MOST_COPIES:
                self.dropped += 1
                continue
            self._said.add(said)
            self.taken[item["wording"]] += 1
            name = f"{example['world']}-{self._numbers[example['world']]}"
            self._numbers[example["world"]] += 1
            self.items.append({**item, "example": {**example, "id": name}})
        return len(self.items) - before


def make_sentences(
    folder: Folder, settings: Settings, worlds: Sequence[SettledWorld], workers: Workers, tell: Callable[[int], None]
) -> Sentences:
    """As many instructions as are wanted, or as the wordings and worlds give.

    Args:
        folder: where parts are kept, and found again.
        settings: of the corpus.
        worlds: in the order of their numbers.
        workers: who work.
        tell: told after every batch how many instructions it added.

    Raises:
        UsageError: a part is damaged or cannot be written.
        WorkFailed: a process died.
    """
    sentences, each = Sentences(), -(-settings.instructions // len(worlds))
    begin, batch, dry = 0, 0, 0
    while len(sentences.items) < settings.instructions and dry < _DRY:
        missing = settings.instructions - len(sentences.items)
        count = min(WORLDS_A_PART * PARTS_A_BATCH, -(-missing // each) + WORLDS_A_PART)
        turns = range(begin, begin + count)
        made = [item for part in _batch(folder, settings, worlds, workers, batch, turns, each, sentences.taken)
                for item in part]  # fmt: skip
        added = sentences.join(made, settings.instructions)
        tell(added)
        dry = dry + 1 if added < _LITTLE * min(missing, count * each) else 0
        begin, batch = begin + count, batch + 1
    return sentences


def _batch(
    folder: Folder, settings: Settings, worlds: Sequence[SettledWorld], workers: Workers, batch: int, turns: range,
    each: int, taken: Counter[str],
) -> Iterator[list[dict[str, Any]]]:  # fmt: skip
    """The parts of a batch, in their order; those that are not there are made."""
    shares = [turns[k : k + WORLDS_A_PART] for k in range(0, len(turns), WORLDS_A_PART)]
    names = [f"sentences-{batch:04d}-{k:02d}" for k in range(len(shares))]
    missing = [k for k, name in enumerate(names) if not folder.has(name)]
    tasks = []
    for k in missing:
        told = [(turn, worlds[turn % len(worlds)].to_json()) for turn in shares[k]]
        tasks.append((settings.seed, told, each, dict(taken)))
    for place, items in workers.run(make_instruction_part, tasks):
        folder.keep(names[missing[place]], items)
    for name in names:
        yield folder.items(name)


def make_instruction_part(
    seed: int, worlds: Sequence[tuple[int, dict[str, Any]]], each: int, taken: dict[str, int]
) -> list[dict[str, Any]]:
    """The instructions of one part as plain values, for processes that share the work.

    Args:
        seed: of the corpus.
        worlds: settled worlds, each with the number of its turn, which chance depends on.
        each: how many instructions a world is asked for.
        taken: how often each wording was used before.
    """
    count = Counter(taken)
    made = []
    for turn, data in worlds:
        rng = np.random.default_rng([seed, 1, turn])
        for example in generate(settled_from_json(data).laid, rng, each, count):
            made.append(_described(example))
    return made


def _described(example: Example) -> dict[str, Any]:
    root = example.groundings[0]
    kinds = sorted({symbol.kind for symbol in root if isinstance(symbol, Action)})
    return {
        "example": example_to_json(example),
        "said": example.tree.text,
        "wording": wording_of(example.tree),
        "held_out": is_held_out(example.tree),
        "action": kinds[0] if kinds else None,
        "constructions": constructions(example),
    }

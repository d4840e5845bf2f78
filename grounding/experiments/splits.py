"""Splits of a corpus into what is learned from and what is held out: by example, or by whole worlds.

A split depends on the seed and on its number only, so every method sees the same splits, and more splits leave the
first ones as they were. The examples held out at 0.2 are among those held out at 0.5: curves over the holdout are
paired, too.
"""

from __future__ import annotations

from collections.abc import Hashable, Sequence
from dataclasses import dataclass

import numpy as np

from grounding.corpus.format import Corpus
from grounding.experiments.errors import ExperimentError
from grounding.world import World

BY = ("random", "worlds")
_DIGITS = 3  # of a position in [m]: worlds whose blocks lie nearer than this are the same


@dataclass(frozen=True)
class Split:
    """One way to part a corpus.

    Attributes:
        by: "random" (examples are held out) or "worlds" (all examples of some worlds are).
        holdout: the share that is held out.
        number: of the split, from 0.
        train: places of the examples that are learned from, ascending.
        test: places of the others, ascending.
    """

    by: str
    holdout: float
    number: int
    train: tuple[int, ...]
    test: tuple[int, ...]

    @property
    def name(self) -> str:
        """A name that is unique among the splits of one seed."""
        return f"{self.by}-{self.holdout:.3f}-{self.number:03d}"


def layout_key(world: World) -> Hashable:
    """What worlds are told apart by: which things lie where, to the millimetre; names do not matter."""
    return frozenset(
        (item.type, item.color, *(round(float(value), _DIGITS) for value in item.position)) for item in world.things
    )


def world_numbers(corpus: Corpus) -> tuple[int, ...]:
    """For every example the number of its world, counted by layout in the order of first mention."""
    keys = {name: layout_key(world) for name, world in corpus.worlds.items()}
    numbers: dict[Hashable, int] = {}
    return tuple(numbers.setdefault(keys[example.world], len(numbers)) for example in corpus)


def make_splits(corpus: Corpus, by: str, holdouts: Sequence[float], count: int, seed: int) -> tuple[Split, ...]:
    """The splits of a corpus, ordered by holdout, then by number.

    Args:
        corpus: to part.
        by: one of `BY`.
        holdouts: shares between 0 and 1: of the examples, or of the worlds.
        count: of splits for each.
        seed: of the order in which examples or worlds are drawn.

    Raises:
        ExperimentError: a holdout that leaves nothing to learn from or nothing to test.
    """
    units = tuple(range(len(corpus))) if by == "random" else world_numbers(corpus)
    kinds = len(set(units))
    splits = []
    for holdout in holdouts:
        held = round(holdout * kinds)
        if not 0 < held < kinds:
            what = "examples" if by == "random" else "worlds"
            raise ExperimentError(f"a holdout of {holdout:g} of {kinds} {what} leaves nothing on one of the sides")
        for number in range(count):
            order = np.random.default_rng((seed, BY.index(by), number)).permutation(kinds)
            out = set(order[:held].tolist())
            train = tuple(i for i, unit in enumerate(units) if unit not in out)
            test = tuple(i for i, unit in enumerate(units) if unit in out)
            splits.append(Split(by, holdout, number, train, test))
    return tuple(splits)


def parse_holdouts(text: str) -> tuple[float, ...]:
    """Read holdouts: one share, several with commas between them, or first:last:step.

    Raises:
        ValueError: naming what is wrong.
    """
    try:
        parts = [float(part) for part in text.replace(":", ",").split(",")]
    except ValueError:
        raise ValueError(f"{text!r} is no list of shares such as 0.2,0.5,0.8 or 0.2:0.8:0.05") from None
    if ":" in text:
        if len(parts) != 3 or not (parts[0] <= parts[1] and parts[2] >= 0.001):
            raise ValueError(f"{text!r} is no range; one looks like 0.2:0.8:0.05, first:last:step")
        first, last, step = parts
        parts = [first + i * step for i in range(int((last - first) / step + 1e-9) + 1)]
    shares = tuple(dict.fromkeys(round(part, 3) for part in parts))
    if not all(0 < share < 1 for share in shares):
        raise ValueError(f"{text!r}: a share that is held out lies between 0 and 1")
    return shares

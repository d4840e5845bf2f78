"""What inference costs in one world size: seconds a phrase, factor evaluations, sizes of spaces, memory.

Each instruction is grounded by an engine that has seen nothing before, so that nothing but the world's measurements is
shared between instructions. The world is measured before, and the time for that is told apart. Every instruction is
grounded once as a whole, and once phrase by phrase in a world measured anew, for the times of single phrases.
"""

from __future__ import annotations

import time
from collections import Counter
from typing import Any, NamedTuple

import numpy as np

from grounding.errors import GroundingError
from grounding.experiments.engines import make_engine
from grounding.experiments.processes import peak_memory
from grounding.factors import FactorModel
from grounding.features.discretiser import shape_roles
from grounding.geometry.layout import Layout
from grounding.language.tree import Phrase
from grounding.lazy import lazy
from grounding.world import World

_WARM = 3  # blocks of the world in which each process grounds once before it is timed


class Cost(NamedTuple):
    """What one engine costs in worlds of one size.

    Attributes:
        inference: the engine.
        blocks: in the world.
        composed: whether the worlds are composed, not the corpus's own.
        instructions: that were measured.
        phrases: of these.
        mean: seconds a phrase, over all.
        median: ditto, of single phrases.
        p95: ditto: 95 of 100 phrases take no longer.
        world: seconds to measure a world, once for all its instructions: the median over worlds.
        evaluations: of factors, a phrase.
        symbols: that were considered, a phrase.
        spaces: the same by family.
        megabytes: the most memory that the process had.
        megabytes_before: ditto before the first instruction: program, corpus and factors.
        refused: why the engine does not ground in such worlds, or None.
    """

    inference: str
    blocks: int
    composed: bool
    instructions: int
    phrases: int
    mean: float | None
    median: float | None
    p95: float | None
    world: float
    evaluations: float | None
    symbols: float | None
    spaces: dict[str, float]
    megabytes: float | None
    megabytes_before: float | None
    refused: str | None = None


def measure_cost(
    model: FactorModel, name: str, composed: bool, worlds: list[World], pairs: list[tuple[Phrase, int]], budget: float
) -> Cost:
    """Measure one engine in worlds of one size.

    Args:
        model: the factors.
        name: of the engine.
        composed: kept in the result.
        worlds: of equal size.
        pairs: trees, and the place in `worlds` of the one that they are grounded in.
        budget: no further instruction is begun after so many seconds.
    """
    before = peak_memory()
    _warm_up(model, name, pairs[0][0], worlds[0])
    (layouts, measuring), (fresh, again) = _measured(worlds), _measured(worlds)
    whole: list[float] = []
    single: list[float] = []
    counts: list[int] = []
    evaluations = 0
    spaces: Counter[str] = Counter()
    start, refused = time.perf_counter(), None
    for tree, place in pairs:
        if whole and time.perf_counter() - start > budget:
            break
        try:
            seconds, inference = _whole(model, name, tree, layouts[place])
            single += _phrases(model, name, tree, fresh[place])
        except GroundingError as error:
            refused = str(error)
            break
        whole.append(seconds)
        counts.append(sum(1 for _ in tree.preorder()))
        evaluations += inference.evaluations
        spaces.update(inference.sizes)
    phrases = sum(counts)
    return Cost(
        inference=name,
        blocks=layouts[0].size,
        composed=composed,
        instructions=len(whole),
        phrases=phrases,
        mean=sum(whole) / phrases if whole else None,
        median=float(np.median(single)) if single else None,
        p95=float(np.quantile(single, 0.95)) if single else None,
        world=float(np.median(measuring + again)),
        evaluations=evaluations / phrases if whole else None,
        symbols=sum(spaces.values()) / phrases if whole else None,
        spaces={family: count / phrases for family, count in sorted(spaces.items())},
        megabytes=peak_memory(),
        megabytes_before=before,
        refused=refused,
    )


def _measured(worlds: list[World]) -> tuple[list[Layout], list[float]]:
    """Every world with all that is computed once for it, and the seconds that took."""
    once = [name for name, value in vars(Layout).items() if isinstance(value, lazy)]
    layouts, seconds = [], []
    for world in worlds:
        start = time.perf_counter()
        layout = Layout(world)
        for name in once:
            getattr(layout, name)
        shape_roles(layout)
        seconds.append(time.perf_counter() - start)
        layouts.append(layout)
    return layouts, seconds


def _warm_up(model: FactorModel, name: str, tree: Phrase, world: World) -> None:
    """Have everything loaded that is loaded late, in a small world that is not used again."""
    few = {item.id for item in world.things[:_WARM]}
    small = world.with_objects(item for item in world.objects if item.id in few or item not in world.things)
    make_engine(name, model).infer(tree, Layout(small))


def _whole(model: FactorModel, name: str, tree: Phrase, layout: Layout) -> tuple[float, Any]:
    """Seconds of a whole instruction, grounded by a fresh engine, and what it inferred."""
    engine = make_engine(name, model)
    start = time.perf_counter()
    inference = engine.infer(tree, layout)
    return time.perf_counter() - start, inference


def _phrases(model: FactorModel, name: str, tree: Phrase, layout: Layout) -> list[float]:
    """Seconds of every single phrase, its children being grounded already."""
    engine: Any = make_engine(name, model)
    memory: dict[object, Any] = {}
    seconds = []
    for phrase in tree.postorder():
        start = time.perf_counter()
        engine.infer(phrase, layout, memory)
        seconds.append(time.perf_counter() - start)
    return seconds

"""Makes scenes with their tasks and writes them: worlds, tasks, and pictures with marks and with numbers."""

from __future__ import annotations

import json
from collections import Counter
from collections.abc import Callable, Iterable
from pathlib import Path
from typing import Any

import numpy as np

from grounding.corpus.by_hand.kinds import KINDS, Scene, lay_scene
from grounding.corpus.by_hand.tasks import Task, choose_tasks
from grounding.corpus.format import write_worlds
from grounding.errors import CorpusError
from grounding.pictures.seen import Marks, draw_seen

_ATTEMPTS = 20


def make_scenes(count: int, seed: int) -> tuple[tuple[Scene, Task, Task], ...]:
    """Scenes of all kinds in turn, each with a pick and a placing; of every kind, every other one has a speaker.

    Args:
        count: of scenes.
        seed: of all chance: the same count and seed give the same scenes.
    """
    kinds = list(KINDS)
    taken: Counter[str] = Counter()
    made = []
    for number in range(count):
        kind = kinds[number % len(kinds)]
        across = bool((number // len(kinds) + number) % 2)
        made.append(_scene(np.random.default_rng([seed, number]), f"s{seed}-{number:03d}", kind, across, taken))
    return tuple(made)


def write_scenes(
    made: Iterable[tuple[Scene, Task, Task]], folder: Path | str, tell: Callable[[], None] | None = None
) -> dict[str, Any]:
    """Write `scenes.worlds.json`, `tasks.jsonl` and three pictures a scene.

    Args:
        made: what `make_scenes` gave.
        folder: is made where it does not exist.
        tell: called after every scene.

    Returns:
        how many there are of what.
    """
    listed, place = list(made), Path(folder)
    place.mkdir(parents=True, exist_ok=True)
    write_worlds({scene.name: scene.world for scene, _, _ in listed}, place / "scenes.worlds.json")
    lines = [json.dumps(task.to_json()) for _, *tasks in listed for task in tasks]
    (place / "tasks.jsonl").write_text("".join(line + "\n" for line in lines), encoding="utf-8")
    for scene, *tasks in listed:
        draw_seen(scene.world, numbered=True).save(place / f"{scene.name}.numbered.png")
        for task in tasks:
            marks = Marks(task.target, None if task.opening is None else task.opening.place, task.title)
            draw_seen(scene.world, marks).save(place / f"{task.id}.marked.png")
        if tell is not None:
            tell()
    return _summary(listed)


def _scene(
    rng: np.random.Generator, name: str, kind: str, across: bool, taken: Counter[str]
) -> tuple[Scene, Task, Task]:
    """The first scene of a kind that has tasks."""
    for attempt in range(_ATTEMPTS):
        scene = lay_scene(rng, name, kind, across)
        try:
            return scene, *choose_tasks(scene, rng, taken)
        except CorpusError:
            if attempt == _ATTEMPTS - 1:
                raise
    raise AssertionError("unreachable")


def _summary(listed: list[tuple[Scene, Task, Task]]) -> dict[str, Any]:
    colors = Counter(len({item.color for item in scene.world.things}) for scene, _, _ in listed)
    openings = Counter(place.opening.kind for _, _, place in listed if place.opening is not None)
    blocks = [len(scene.world.things) for scene, _, _ in listed]
    return {
        "scenes": len(listed), "tasks": 2 * len(listed),
        "kinds": dict(Counter(scene.kind for scene, _, _ in listed)),
        "with a speaker": sum(scene.world.speaker is not None for scene, _, _ in listed),
        "blocks": [min(blocks, default=0), max(blocks, default=0)],
        "colors": dict(sorted(colors.items())), "openings": dict(sorted(openings.items())),
    }  # fmt: skip

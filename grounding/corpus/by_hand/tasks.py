"""What shall be done in a scene: one block to pick up, and one to place where there is an opening."""

from __future__ import annotations

from collections import Counter
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

from grounding.corpus.by_hand.hand import Opening
from grounding.corpus.by_hand.kinds import Scene
from grounding.corpus.by_hand.openings import OPENINGS, openings
from grounding.corpus.by_hand.room import graspable
from grounding.errors import CorpusError
from grounding.pictures.boxes import visible
from grounding.pictures.seen import SIZE, scene_camera
from grounding.world import WorldObject, make_object

SEEN = 0.6  # share of what is marked that the writer sees at least
_MOVED = 0.12  # a placing moves its block so far at least, along the table, in [m]
_CLOSE = 0.085  # neighbours are so near, from centre to centre, in [m]
_TRIES = 12  # openings of a kind that are looked at
_ODD = 0.15  # weight of a block whose colour no other has
_STRAY = 0.35  # weight of a block that belongs to no arrangement


@dataclass(frozen=True)
class Task:
    """Something to be done, about which people write.

    Attributes:
        id: unique in a corpus.
        world: name of its world.
        task: "pick" or "place".
        kind: of the scene.
        target: id of the block that is picked up.
        opening: where it goes, or None.
    """

    id: str
    world: str
    task: str
    kind: str
    target: str
    opening: Opening | None = None

    @property
    def title(self) -> str:
        """What is asked for, in the words of a picture's title."""
        if self.opening is None:
            return "The robot shall pick up the block under the arrow."
        on_top = "on top of a block, " if self.opening.kind == "top" else ""
        return f"The robot shall take the block under the arrow and put it {on_top}where the pale one is drawn."

    def to_json(self) -> dict[str, Any]:
        """The task as the plain values of a line."""
        gold: dict[str, Any] = {"object": self.target}
        if self.opening is not None:
            gold["destination"] = list(self.opening.place)
        return {"id": self.id, "world": self.world, "task": self.task, "kind": self.kind, "gold": gold}


def choose_tasks(scene: Scene, rng: np.random.Generator, taken: Counter[str]) -> tuple[Task, Task]:
    """A pick and a placing.

    Args:
        scene: that has them.
        rng: the only source of chance.
        taken: how often each kind of opening has been used; seldom used ones come first, and the choice is counted.

    Raises:
        CorpusError: nothing can be picked up or placed as it should be.
    """
    camera, things = scene_camera(scene.world), scene.world.things
    shown = visible(things, camera, SIZE)
    blocks = [item for item in things if graspable(item, things) and shown[item.id].share >= SEEN]
    weights = np.array([_weight(item, scene) for item in blocks])
    if not weights.sum() > 0:
        raise CorpusError(f"world {scene.name!r}: no block that can be picked up is worth writing about")
    target = blocks[int(rng.choice(len(blocks), p=weights / weights.sum()))]
    found = openings(scene)
    for kind in sorted(rng.permutation(OPENINGS).tolist(), key=lambda kind: taken[kind]):
        those = [opening for opening in found if opening.kind == kind]
        for number in rng.permutation(len(those))[:_TRIES]:
            moved = _mover(scene, rng, those[int(number)], [item for item in blocks if item is not target])
            if moved is not None:
                taken[kind] += 1
                pick = Task(f"{scene.name}-pick", scene.name, "pick", scene.kind, target.id)
                opening = those[int(number)]
                return pick, Task(f"{scene.name}-place", scene.name, "place", scene.kind, moved.id, opening)
    raise CorpusError(f"world {scene.name!r}: no block can be placed anywhere")


def _weight(item: WorldObject, scene: Scene) -> float:
    """How much there is to be written about a block: whose colour others have, and which belongs to something."""
    same = [other for other in scene.world.things if other.color == item.color and other is not item]
    weight = (1.0 if same else _ODD) * (1.0 if item.id in scene.arranged or not scene.arranged else _STRAY)
    if scene.kind == "alike":
        near = (float(np.linalg.norm(other.position - item.position)) < _CLOSE for other in same)
        return weight if any(near) else 0.0
    return weight


def _mover(
    scene: Scene, rng: np.random.Generator, opening: Opening, blocks: Sequence[WorldObject]
) -> WorldObject | None:
    """A block to go to an opening, where the writer would see it."""
    place = np.array(opening.place)
    ghost = make_object("ghost", position=opening.place)
    shown = visible([*scene.world.things, ghost], scene_camera(scene.world), SIZE)
    others = [
        item
        for item in blocks
        if item.id not in opening.near and float(np.linalg.norm(item.position[:2] - place[:2])) >= _MOVED
    ]
    if not others or shown["ghost"].share < SEEN:
        return None
    weights = np.array([_weight(item, scene) + 0.02 for item in others])
    return others[int(rng.choice(len(others), p=weights / weights.sum()))]

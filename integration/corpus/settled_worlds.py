"""Settled worlds: composed ones that physics confirms, and ones whose blocks were pushed about (Section V-A)."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import Any

import numpy as np

from grounding.corpus.composer import LIMITS
from grounding.corpus.generator import compose_world, recognise
from grounding.corpus.shapes import misfit
from grounding.corpus.treebank import LaidWorld
from grounding.symbols import Container
from grounding.world import World, world_from_json, world_to_json
from integration.errors import IntegrationError
from integration.worlds_and_scenes import scene_of, world_at
from motion import Pose
from motion.sim.settling import Settled, push_about, settle

COMPOSED, PUSHED = "composed", "pushed"
PUSHED_EVERY = 3
"""One world in so many has its blocks pushed about."""
MOVED = 0.003
"""A composed world in which a block moves by more than this, in metres, as it settles is not what was composed."""
_TRIES = 40
_DIGITS, _TURN_DIGITS = 5, 6


class Unsettled(IntegrationError):
    """No world came to rest as it should."""


@dataclass(frozen=True, eq=False)
class SettledWorld:
    """A world at rest.

    Attributes:
        name: in the corpus.
        how: `COMPOSED` or `PUSHED`.
        world: at rest.
        containers: the arrangements that were laid and are still there.
        tries: how many worlds were drawn for it.
    """

    name: str
    how: str
    world: World
    containers: tuple[Container, ...]
    tries: int

    @property
    def laid(self) -> LaidWorld:
        """The world, digested for the generator of sentences."""
        return well_named(recognise(self.name, self.world, self.containers))

    def to_json(self) -> dict[str, Any]:
        """Plain values; `settled_from_json` reads them back."""
        containers = [[container.kind, list(container.objects)] for container in self.containers]
        return {"name": self.name, "how": self.how, "tries": self.tries, "containers": containers,
                "world": world_to_json(self.world)}  # fmt: skip


def settled_from_json(data: dict[str, Any]) -> SettledWorld:
    """A world from the plain values of `SettledWorld.to_json`.

    Raises:
        WorldError: they are no world.
    """
    containers = tuple(Container(kind, tuple(objects)) for kind, objects in data["containers"])
    return SettledWorld(data["name"], data["how"], world_from_json(data["world"], data["name"]), containers,
                        data["tries"])  # fmt: skip


def draw_settled(seed: int, number: int) -> SettledWorld:
    """The settled world of that number: it depends on the seed and the number alone.

    Args:
        seed: of the corpus.
        number: of the world, from 0.

    Raises:
        Unsettled: none of many worlds came to rest as it should.
    """
    how = PUSHED if number % PUSHED_EVERY == PUSHED_EVERY - 1 else COMPOSED
    name = f"{how[0]}{number:05d}"
    rng = np.random.default_rng([seed, 0, number])
    for tries in range(1, _TRIES + 1):
        drawn = compose_world(rng, name)
        found = pushed_about(drawn, rng) if how == PUSHED else confirmed(drawn)
        if found is not None:
            world, containers = found
            return SettledWorld(name, how, world, containers, tries)
    raise Unsettled(f"world {number} of seed {seed}: none of {_TRIES} that were drawn came to rest on the table")


def well_named(laid: LaidWorld) -> LaidWorld:
    """The world without the arrangements that catch the eye but are too crooked for what they would be called."""
    objects = {mask: [laid.layout.world[name] for name in laid.layout.names(mask)] for _, mask in laid.arrangements}
    return replace(laid, arrangements=tuple(a for a in laid.arrangements if misfit(a[0], objects[a[1]]) is None))


def settle_worlds(seed: int, numbers: Sequence[int]) -> list[dict[str, Any]]:
    """Settled worlds as plain values, for processes that share the work."""
    return [draw_settled(seed, number).to_json() for number in numbers]


def confirmed(drawn: LaidWorld) -> tuple[World, tuple[Container, ...]] | None:
    """A composed world after it came to rest; None where a block moved, or what was stacked is stacked no more."""
    world = drawn.layout.world
    before = scene_of(world)
    settled = settle(before)
    if not settled.stable or settled.fallen:
        return None
    for box in settled.scene.boxes:
        if np.linalg.norm(box.position - before.box(box.name).position) > MOVED:
            return None
    rested = _rested(world, settled)
    laid = [Container(kind, drawn.layout.names(mask)) for kind, mask in drawn.arrangements]
    kept = tuple(container for container in laid if _fits(container, rested))
    if any(container.kind == "tower" and container not in kept for container in laid):
        return None
    return rested, kept


def pushed_about(drawn: LaidWorld, rng: np.random.Generator) -> tuple[World, tuple[Container, ...]] | None:
    """A world after its blocks were pushed about; None where too few stayed, or they did not come to rest."""
    world = drawn.layout.world
    settled = push_about(scene_of(world), rng)
    rested = _rested(world, settled)
    if not settled.stable or len(rested.things) < LIMITS[0]:
        return None
    return rested, ()


def _rested(world: World, settled: Settled) -> World:
    """The world with its blocks where they rest, and without those that fell; poses are rounded as files have them."""
    fallen = set(settled.fallen)
    stayed = world.with_objects(item for item in world.objects if item.id not in fallen)
    poses = {box.name: _rounded(box.pose) for box in settled.scene.boxes if not box.fixed}
    return world_at(stayed, poses)


def _rounded(pose: Pose) -> Pose:
    turn = np.round(pose.orientation, _TURN_DIGITS)
    return Pose(np.round(pose.position, _DIGITS), turn / np.linalg.norm(turn))


def _fits(container: Container, world: World) -> bool:
    """Tells whether an arrangement is still what it is called."""
    return misfit(container.kind, [world[name] for name in container.objects]) is None

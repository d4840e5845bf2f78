"""Faults of episodes of the benchmark, drawn from their seeds, and whether the world allows to recover from them."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field

import numpy as np

from grounding.world import World
from integration.benchmark.random_worlds import Episode, reached
from integration.worlds_and_scenes import scene_of
from motion import Box, Fault, Jam, Pose, Push, Scene, Sensor, Slip
from motion.polygons import contains, overlap
from motion.poses import about, quaternion
from motion.robot.state import ARMS

FAULTS = ("slip", "push_before", "push_during", "noise", "gripper", "leaning")
FAULTY_KINDS = ("pick", "place", "on", "beside")
NOISE = (0.0005, 0.003)
"""Radius of the ball in which a noisy sensor shows a block, from and to, in [m]."""
_TURN = 0.01
_PUSH = (0.008, 0.04)
_ON_TOWER = 0.012
_ROOM = 0.015
_STUCK_CLOSED, _STUCK_OPEN = 0.03, 0.0565


@dataclass(frozen=True)
class FaultCase:
    """The fault of an episode.

    Attributes:
        name: one of `FAULTS`, or "none".
        faults: what is injected.
        sensor: how well blocks are seen.
        lost: hands whose gripper never works again.
    """

    name: str = "none"
    faults: tuple[Fault, ...] = ()
    sensor: Sensor = field(default_factory=Sensor)
    lost: tuple[str, ...] = ()


def fault_name(number: int) -> str:
    """The fault of the episode of that number; each has every sixth."""
    return FAULTS[number % len(FAULTS)]


def draw_fault(seed: int, episode: Episode) -> FaultCase:
    """The fault of an episode."""
    rng = np.random.default_rng([seed, episode.number, 2])
    name = fault_name(episode.number)
    if name == "slip":
        phase = str(rng.choice(("lift", "hold") if episode.kind == "pick" else ("lift", "transfer")))
        return FaultCase(name, (Slip(phase, float(rng.uniform(0.1, 0.9))),))
    if name in ("push_before", "push_during"):
        phase = "pregrasp" if name == "push_before" else "approach"
        offset, turn = _draw_push(rng, episode.world, episode.target)
        return FaultCase(name, (Push(episode.target, offset, turn, phase, float(rng.uniform(0.05, 0.8))),))
    if name == "noise":
        return FaultCase(name, sensor=Sensor(float(rng.uniform(*NOISE)), _TURN))
    if name == "gripper":
        share = rng.uniform()
        hands = ARMS if share < 0.7 else (str(rng.choice(ARMS)),)
        lost = () if share < 0.5 else hands
        seconds = float(rng.uniform(0.5, 2.5)) if share < 0.5 else np.inf
        if rng.uniform() < 0.5:
            jams = tuple(Jam(hand, most=_STUCK_CLOSED, phase="pregrasp", seconds=seconds) for hand in hands)
        else:
            jams = tuple(Jam(hand, least=_STUCK_OPEN, seconds=seconds) for hand in hands)
        return FaultCase(name, jams, lost=lost)
    return FaultCase(name)


def recoverable(episode: Episode, case: FaultCase, poses: dict[str, Pose]) -> bool:
    """Tells whether a hand that still works reaches the target where it ended, and its destination.

    Args:
        episode: what was to be done.
        case: what went wrong.
        poses: where everything really was at the end.
    """
    arms = [arm for arm in ARMS if arm not in case.lost]
    scene = scene_of(episode.world)
    start = scene.box(episode.target).pose
    held = poses[episode.target].position[2] > start.position[2] + 0.06
    places = [start if held else poses[episode.target]]
    to = episode.actions[0].destination
    if to is not None:
        places.append(Pose(np.array(to.position), start.orientation))
    return bool(arms) and reached(scene, episode.target, places, arms)


def _draw_push(rng: np.random.Generator, world: World, target: str) -> tuple[tuple[float, float], float]:
    """A push that leads to a free place on what the target stands on."""
    scene = scene_of(world)
    box = scene.box(target)
    tower = not any(scene.box(name).fixed for name in scene.below(target))
    others = [other for other in scene.boxes if not other.fixed and other.name != target and _beside(box, other)]
    for attempt in range(60):
        length = rng.uniform(_PUSH[0], max(_PUSH[0], (_ON_TOWER if tower else _PUSH[1]) * (1 - attempt / 80)))
        angle, turn = rng.uniform(-np.pi, np.pi), float(rng.uniform(-0.3, 0.3)) * (not tower)
        offset = length * np.array([np.cos(angle), np.sin(angle)])
        rotation = about((0, 0, 1), turn) @ box.axes
        moved = box.at(Pose(box.position + np.array([*offset, 0.0]), quaternion(rotation)))
        if all(overlap(moved.footprint, other.footprint) < -_ROOM for other in others) and _stays(scene, box, moved):
            return (float(offset[0]), float(offset[1])), turn
    return (_PUSH[0], 0.0), 0.0


def _beside(box: Box, other: Box) -> bool:
    return bool(other.top > box.bottom + 0.005 and other.bottom < box.top)


def _stays(scene: Scene, box: Box, moved: Box) -> bool:
    """Tells whether a box would still stand on what it stood on, and within reach."""
    below = [scene.box(name) for name in scene.below(box.name)]
    supports = [contains(other.footprint, moved.position[:2], 0.01) for other in below]
    return any(supports) and reached(scene, box.name, [moved.pose])


def told(faults: Sequence[Fault]) -> list[str]:
    """The faults in words, for records."""
    return [repr(fault) for fault in faults]

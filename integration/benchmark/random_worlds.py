"""Random worlds with goals that are known: what an episode of the benchmark is about, drawn from its seed alone."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np

from grounding.result import Destination, GroundedAction
from grounding.world import World, make_object
from integration.worlds_and_scenes import scene_of
from motion import Box, Pose, Scene, Simulator, UnreachableTarget, grasp_candidates, solve_ik
from motion.errors import InvalidGoal
from motion.plan.goals import checked_destination
from motion.polygons import overlap
from motion.poses import about, quaternion
from motion.robot.state import ARMS
from motion.scene import LEANING

KINDS = ("pick", "place", "on", "beside", "stack", "clear")
SHARES = (0.4, 0.2, 0.15, 0.1, 0.05, 0.1)
FEWEST, MOST = 4, 20
GAP = 0.012
"""Least gap between two blocks of a random world, in [m]."""
COLORS = ("red", "green", "blue", "yellow", "orange", "purple", "white", "black")
_TABLE_TOP = 0.711
_TABLE = make_object("table", "table", "white", (0.65, 0.0, _TABLE_TOP - 0.02), size=(0.7, 1.8, 0.04))
_X, _Y = (0.42, 0.76), (-0.75, 0.75)
_BESIDE = 0.04
_TRIES = 60


@dataclass(frozen=True)
class Episode:
    """A world and what is to be done in it.

    Attributes:
        number: of the episode.
        kind: one of `KINDS`.
        world: what is around the robot.
        actions: what is to be done.
    """

    number: int
    kind: str
    world: World
    actions: tuple[GroundedAction, ...]

    @property
    def target(self) -> str:
        """Id of the object that is handled first."""
        return self.actions[0].objects[0]


def draw_episode(seed: int, number: int, *, leaning: bool = False, kinds: Sequence[str] = KINDS) -> Episode:
    """The episode of that number.

    Args:
        seed: of the whole benchmark.
        number: of the episode.
        leaning: whether another block leans on the target.
        kinds: the kinds of goals to draw from.
    """
    rng = np.random.default_rng([seed, number])
    while True:
        world = draw_world(rng, number)
        shares = np.array([SHARES[KINDS.index(kind)] for kind in kinds])
        kind = str(rng.choice(list(kinds), p=shares / shares.sum()))
        action = _draw_action(rng, world, kind)
        if action is None:
            continue
        if leaning:
            leaned = _with_leaning(rng, world, action.objects[0])
            if leaned is None:
                continue
            world = leaned
        return Episode(number, kind, world, (action,))


def draw_world(rng: np.random.Generator, number: int) -> World:
    """A table with 4 to 20 blocks of 4 or 5 cm; every third has turned faces, every fourth a tower."""
    count = int(rng.integers(FEWEST, MOST + 1))
    edge = 0.05 if rng.uniform() < 0.7 else 0.04
    boxes: list[Box] = []
    while len(boxes) < count:
        rotation = about((0, 0, 1), rng.uniform(-np.pi, np.pi))
        if number % 3 == 0:
            rotation = rotation @ _any_face(rng)
        place = (rng.uniform(*_X), rng.uniform(*_Y), _TABLE_TOP + edge / 2)
        box = Box(f"b{len(boxes) + 1}", place, quaternion(rotation), (edge,) * 3)  # type: ignore[arg-type]
        if all(overlap(box.footprint, other.footprint) < -GAP for other in boxes):
            boxes.append(box)
    if number % 4 == 0:
        base = boxes[0]
        boxes[1] = boxes[1].at(Pose(base.position + np.array([0, 0, edge]), base.orientation))
    colors = rng.choice(COLORS, size=count)
    blocks = [
        make_object(box.name, "block", str(color), box.position, box.orientation, box.size)
        for box, color in zip(boxes, colors, strict=True)
    ]
    return World((_TABLE, *blocks))


def reached(scene: Scene, name: str, places: Sequence[Pose], arms: Sequence[str] = ARMS) -> bool:
    """Tells whether some hand, or one for each place, would grasp a block at every place if nothing stood around it."""
    box = scene.box(name)
    tables = tuple(other for other in scene.boxes if other.fixed)
    return all(_grasped(Scene((*tables, box.at(place))), name, arms) for place in places)


def _grasped(scene: Scene, name: str, arms: Sequence[str]) -> bool:
    try:
        grasps = grasp_candidates(scene, name, tuple(arms))
    except InvalidGoal:
        return False
    for grasp in grasps:
        try:
            solve_ik(grasp.arm, grasp.tool, restarts=4)
            solve_ik(grasp.arm, grasp.backed(0.08), restarts=4)
        except UnreachableTarget:
            continue
        return True
    return False


def _draw_action(rng: np.random.Generator, world: World, kind: str) -> GroundedAction | None:
    """A goal of that kind that is within reach, or None where none was found."""
    scene = scene_of(world)
    loose = [box for box in scene.boxes if not box.fixed and not scene.boxes_above(box.name)]
    for _ in range(_TRIES):
        chosen = [loose[int(k)] for k in rng.permutation(len(loose))[:3]]
        target = chosen[0]
        objects: tuple[str, ...] = (target.name,)
        spots: list[np.ndarray] = []
        to: Destination | None = None
        if kind == "pick":
            pass
        elif kind == "clear":
            count = int(rng.integers(2, 4))
            if len(chosen) < count:
                return None
            objects = tuple(box.name for box in chosen[:count])
        else:
            if len(chosen) < 3:
                return None
            if kind == "stack":
                objects = (chosen[0].name, chosen[1].name)
            spot = _spot(rng, scene, kind, chosen)
            if spot is None:
                continue
            spots, to = [spot], Destination(*_told(kind, spot, chosen[-1].name))
        action = "pick" if kind == "pick" else "clear" if kind == "clear" else "place"
        boxes = [scene.box(name) for name in objects]
        if all(reached(scene, box.name, [box.pose, *(Pose(spot, box.orientation) for spot in spots)]) for box in boxes):
            return GroundedAction(action, objects, 1.0, to)
    return None


def _spot(rng: np.random.Generator, scene: Scene, kind: str, chosen: Sequence[Box]) -> np.ndarray | None:
    """Draws where the first of the chosen blocks is to be put, (3,) in [m]: free, on or beside the last of them."""
    target, last = chosen[0], chosen[-1]
    if kind in ("on", "stack"):
        spot = np.array([*last.position[:2], last.top + target.half_extents[2]])
    elif kind == "beside":
        angle = rng.uniform(-np.pi, np.pi)
        far = _BESIDE + float(target.size.max()) / 2 + float(last.size.max()) / 2
        spot = last.position + far * np.array([np.cos(angle), np.sin(angle), 0.0])
        spot[2] = _TABLE_TOP + target.half_extents[2]
    else:
        spot = np.array([rng.uniform(*_X), rng.uniform(*_Y), _TABLE_TOP + target.half_extents[2]])
    if not (_X[0] <= spot[0] <= _X[1] and _Y[0] <= spot[1] <= _Y[1]):
        return None
    room = 0.0 if kind in ("on", "stack") else 0.03
    moved = target.at(Pose(spot, target.orientation))
    others = [box for box in scene.boxes if not box.fixed and box.name not in (target.name, last.name)]
    if room and any(overlap(moved.footprint, box.footprint) > -room for box in others):
        return None
    try:
        checked_destination(scene, target.name, spot, 0.0)
    except InvalidGoal:
        return None
    return spot


def _told(
    kind: str, spot: np.ndarray, reference: str
) -> tuple[tuple[float, float, float], str | None, tuple[str, ...]]:
    x, y, z = (float(value) for value in spot)
    relation = {"on": "top", "stack": "top", "beside": "near"}.get(kind)
    return (x, y, z), relation, (reference,) if relation else ()


def _with_leaning(rng: np.random.Generator, world: World, target: str) -> World | None:
    """The world with one more block, which leans on a face of the target; None where there is no room for it."""
    block, scene = world[target], scene_of(world)
    box, edge = scene.box(target), float(block.size[0])
    if abs(box.bottom - _TABLE_TOP) > 1e-6:
        return None
    for axis in rng.permutation([k for k in range(3) if abs(box.axes[2, k]) < 0.5]):
        outward = box.axes[:, axis] * rng.choice((-1.0, 1.0))
        tilt = np.radians(rng.uniform(56.0, 66.0))
        c, s = np.cos(tilt), np.sin(tilt)
        place = box.position + outward * (edge / 2 + edge * s + edge / 2 * (c - s) + 2e-4)
        place[2] = _TABLE_TOP + edge / 2 * (s + c)
        side = np.cross(outward, (0.0, 0.0, 1.0))
        rotation = about(side, tilt) @ np.column_stack([outward, np.cross((0.0, 0.0, 1.0), outward), (0.0, 0.0, 1.0)])
        leaning = make_object("leaning", "block", "blue", place, quaternion(rotation), block.size)
        grown = world.with_objects([*world.objects, leaning])
        there = scene_of(grown)
        around = [other for other in there.boxes if not other.fixed and other.name not in (target, "leaning")]
        if any(overlap(there.box("leaning").footprint, other.footprint) > -0.06 for other in around):
            continue
        with Simulator(there) as simulator:
            simulator.hold(1.5)
            settled = simulator.scene()
        if settled.box("leaning").lean < 4 * LEANING or target not in _touched(settled):
            continue
        moved = [
            replace(item, position=settled.box(item.id).position, orientation=settled.box(item.id).orientation)
            if item.id in ("leaning", target) else item
            for item in grown.objects
        ]  # fmt: skip
        return grown.with_objects(moved)
    return None


def _touched(scene: Scene) -> tuple[str, ...]:
    """Names of the blocks that the leaning one leans on."""
    return tuple(box.name for box in scene.boxes if "leaning" in scene.leaning_on(box.name))


def _any_face(rng: np.random.Generator) -> np.ndarray:
    quarter = int(rng.integers(4)) * np.pi / 2
    axis = [(1, 0, 0), (0, 1, 0), (0, 0, 1)][int(rng.integers(3))]
    return np.asarray(about(axis, quarter))

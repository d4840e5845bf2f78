"""Picks, places and clears on a stage: symbolic actions become metric goals, plans, movements and checks."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from grounding.result import GroundedAction
from integration import checks
from integration.checks import Check
from integration.errors import NoPlan
from integration.spots import beside, out_of_the_way, region_of
from integration.stage import Stage
from motion import Plan, Scene
from motion.state import ARMS

_TRIES = 12
_APART = 0.07  # spots that are tried after one another are at least so far apart, in [m]


def carry_out(stage: Stage, action: GroundedAction, arm: str) -> tuple[Check, ...]:
    """Does what an action asks for and checks it.

    Args:
        stage: where it is done.
        action: what is to be done.
        arm: "left", "right" or "auto".

    Raises:
        NoPlan: there is no verified plan for it.
    """
    known = {box.name for box in stage.scene.boxes if not box.fixed}
    for name in action.objects:
        if name not in known:
            raise NoPlan(f"{name} is not a thing that can be moved", (name,), "InvalidGoal")
    if not action.objects:
        raise NoPlan("no object to act on was understood", (), "InvalidGoal")
    if action.action == "pick":
        return _pick(stage, action.objects, arm)
    if action.action == "place":
        return _place(stage, action, arm)
    if action.action == "clear":
        return _clear(stage, action.objects, arm)
    message = f"there is no action {action.action!r}; there are pick, place and clear"
    raise NoPlan(message, action.objects, "InvalidGoal")


def _pick(stage: Stage, objects: Sequence[str], arm: str) -> tuple[Check, ...]:
    if len(objects) > len(ARMS):
        raise NoPlan(
            f"{len(objects)} blocks are to be picked up ({', '.join(objects)}), but there are two hands that hold one "
            "each",
            tuple(objects),
            "hands",
        )
    if len(objects) > 1 and arm != "auto":
        raise NoPlan(
            f"the {arm} hand holds one block, not {len(objects)} ({', '.join(objects)}); two need --arm auto",
            tuple(objects),
            "hands",
        )
    before = stage.scene
    plans = _plan_picks(stage, objects, arm)
    for plan, name in zip(plans, objects, strict=True):
        stage.execute(plan, "pick", name)
    arms = {name: plan.arm for plan, name in zip(plans, objects, strict=True)}
    seconds = stage.keep_still(arms)
    after = stage.scene
    found: list[Check] = []
    for name, goal in [(item.object, item.goal) for item in stage.handled[-len(objects) :]]:
        found.append(checks.at_goal(after, name, goal, "lifted to where it should be"))
        found.append(checks.held(name, arms[name], seconds[name]))
    return (*found, checks.others_unmoved(before, after, objects))


def _plan_picks(stage: Stage, objects: Sequence[str], arm: str) -> list[Plan]:
    """A plan for each object; for two objects, whichever pair of hands works."""
    if len(objects) == 1:
        return [stage.plan_pick(objects[0], arm)]
    refusal: NoPlan | None = None
    for first in _hands(stage.scene, objects):
        second = ARMS[1 - ARMS.index(first)]
        try:
            one = stage.plan_pick(objects[0], first)
            scene: Scene = stage.scene.moved({objects[0]: one.goal}) if one.goal is not None else stage.scene
            return [one, stage.plan_pick(objects[1], second, scene=scene, start=one.end)]
        except NoPlan as error:
            refusal = refusal or error
    assert refusal is not None
    raise NoPlan(f"not with one block in each hand: {refusal}", tuple(objects), refusal.reason)


def _hands(scene: Scene, objects: Sequence[str]) -> tuple[str, ...]:
    """Hands for the first of two objects, the one on its side first."""
    one, two = (float(scene.box(name).position[1]) for name in objects)
    return ARMS if one >= two else ARMS[::-1]


def _place(stage: Stage, action: GroundedAction, arm: str) -> tuple[Check, ...]:
    if action.destination is None:
        message = f"where {', '.join(action.objects)} should be put was not understood"
        raise NoPlan(message, action.objects, "destination")
    before, goals = stage.scene, {}
    place = np.asarray(action.destination.position, dtype=float)
    for number, name in enumerate(action.objects):
        if number == 0:
            spots = place[None]
        elif action.destination.relation == "top":
            last = stage.scene.box(action.objects[number - 1])
            spots = np.array([[*last.position[:2], last.top + stage.scene.box(name).half_extents[2]]])
        else:
            spots = beside(stage.scene, name, place)
        goals[name] = _put(stage, "place", name, spots, arm)
    return _laid_down(stage, before, goals, "at its destination")


def _clear(stage: Stage, objects: Sequence[str], arm: str) -> tuple[Check, ...]:
    before, goals = stage.scene, {}
    region = region_of(before, objects)
    heights = {name: float(before.box(name).position[2]) for name in objects}
    for name in sorted(objects, key=lambda name: -round(heights[name], 2)):
        spots = out_of_the_way(stage.scene, name, region)
        if not len(spots):
            raise NoPlan(f"there is no free room on the table to clear {name} to", (name,), "room")
        goals[name] = _put(stage, "clear", name, spots, arm)
    found = list(_laid_down(stage, before, goals, "at its new place"))
    after = stage.scene
    return (*found, *(checks.out_of_region(after, name, region) for name in goals))


def _put(stage: Stage, action: str, name: str, spots: np.ndarray, arm: str) -> np.ndarray:
    """Sets an object down at the first of `spots`, (n, 3) in [m], that a plan leads to; where that is."""
    refusal: NoPlan | None = None
    for spot in _spread(spots):
        try:
            plans = stage.plan_transport(name, spot, arm)
        except NoPlan as error:
            refusal = refusal or error
        else:
            for plan in plans:
                stage.execute(plan, action, name)
            return spot
    if refusal is None:
        raise NoPlan(f"there is no free place on the table for {name}", (name,), "room")
    raise refusal


def _spread(spots: np.ndarray) -> list[np.ndarray]:
    """The first of `spots`, (n, 3), that keep apart, so that tries are not wasted on neighbours of a bad one."""
    chosen: list[np.ndarray] = []
    for spot in spots:
        if len(chosen) == _TRIES:
            break
        if all(np.linalg.norm(spot - other) >= _APART for other in chosen):
            chosen.append(spot)
    return chosen


def _laid_down(stage: Stage, before: Scene, goals: dict[str, np.ndarray], what: str) -> tuple[Check, ...]:
    """The checks of objects that were set down."""
    drift = stage.watch_rest()
    after, contacts = stage.scene, stage.simulator.contacts()
    found: list[Check] = []
    for name, goal in goals.items():
        found.append(checks.at_goal(after, name, goal, what))
        found.append(checks.supported(after, name))
        found.append(checks.released(name, contacts, after.names))
        found.append(checks.at_rest(name, drift[name]))
    return (*found, checks.others_unmoved(before, after, goals))

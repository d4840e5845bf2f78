"""Undoing: everything goes back to where it was, what stood below before what stood on it."""

from __future__ import annotations

from collections.abc import Mapping

from integration.errors import NoPlan
from integration.execute import checks
from integration.execute.checks import UNMOVED, Check, drifts
from integration.execute.laying import Laying
from integration.execute.recovery import spread
from integration.execute.setting_aside import beside, out_of_the_way, region_of
from integration.execute.stage import Stage
from motion import Scene
from motion.plan.goals import heading

Held = Mapping[str, str]
"""Ids of what hands hold, by arm."""


def displaced(now: Scene, then: Scene, held: Held, held_then: Held) -> tuple[str, ...]:
    """Ids of what is not where it was, or in another hand, the lowest first.

    Args:
        now: where everything is.
        then: where everything was.
        held: what hands hold.
        held_then: what they held.
    """
    carried, carried_then = set(held.items()), set(held_then.items())
    changed = {name for _, name in carried ^ carried_then}
    kept = {name for _, name in carried & carried_then}
    moved = {name for name, way in drifts(then, now).items() if way > UNMOVED} - kept
    return tuple(sorted(changed | moved, key=lambda name: (round(then.box(name).bottom, 3), name)))


def move_back(stage: Stage, then: Scene, held_then: Held, arm: str) -> tuple[Check, ...]:
    """Moves everything back to where it was.

    Args:
        stage: where it is done.
        then: where everything was.
        held_then: what hands held, by arm; each is taken again from where the other things leave it.
        arm: "left", "right" or "auto".

    Raises:
        NoPlan: something cannot be moved back.
    """
    held = stage.simulator.state().held
    names = displaced(stage.scene, then, held, held_then)
    again = {name: side for side, name in held_then.items() if name in names}
    laying = Laying(stage, "place", arm)
    left = [name for name in names if name not in again]
    refused: NoPlan | None = None
    while left:
        for name in left:
            try:
                box = then.box(name)
                if not laying.put(name, lambda box=box: box.position[None], yaw=heading(box)):  # type: ignore[misc]
                    return laying.checked(names, "back where it was")
            except NoPlan as error:
                refused = refused or error
            else:
                left.remove(name)
                refused = None
                break
        else:
            assert refused is not None
            if not _step_aside(laying, stage, then, left):
                raise refused
    found = laying.checked([name for name in names if name not in again], "back where it was") if laying.goals else ()
    for name, side in again.items():
        try:
            plan = stage.plan_pick(name, side)
        except NoPlan:  # this hand does not reach it where it lies now, but where it was held
            below = spread(beside(stage.scene, name, then.box(name).position))
            if not laying.put(name, lambda below=below: below):  # type: ignore[misc]
                return (*found, checks.held(name, side, 0.0))
            plan = stage.plan_pick(name, side)
        stage.execute(plan, "pick", name)
        found += (checks.held(name, side, stage.keep_still({name: side})[name]),)
    return found


def _step_aside(laying: Laying, stage: Stage, then: Scene, left: list[str]) -> bool:
    """Puts one of the things that stand where others were to a free place; whether there was one to put."""
    places = region_of(then, left)
    for name in left:
        spots = spread(out_of_the_way(stage.scene, name, places))
        try:
            if len(spots) and name not in laying.goals and laying.put(name, lambda spots=spots: spots):  # type: ignore[misc]
                return True
        except NoPlan:
            continue
    return False

"""Picks, places and clears on a stage: symbolic actions become metric goals, plans, movements and checks."""

from __future__ import annotations

from collections.abc import Sequence
from functools import partial

import numpy as np

from grounding.result import GroundedAction
from integration.errors import NoPlan
from integration.execute import checks
from integration.execute.checks import Check
from integration.execute.laying import Laying
from integration.execute.recovery import free_hands, keep_trying, put_back, remove_leaning, spread
from integration.execute.report import DONE, FAILED, Handled
from integration.execute.setting_aside import beside, out_of_the_way, region_of
from integration.execute.stage import Stage
from integration.execute.uncovering import uncover
from motion import Plan, RobotState, Scene
from motion.robot.state import ARMS


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


def refuse_beyond_hands(actions: Sequence[GroundedAction]) -> None:
    """Refuses actions that would leave more things in the hands than there are hands, before anything is done.

    Raises:
        NoPlan: there are more.
    """
    held: list[str] = []
    for action in actions:
        if action.action == "pick":
            held += [name for name in action.objects if name not in held]
        else:
            held = [name for name in held if name not in action.objects]
        if len(held) > len(ARMS):
            listed = ", ".join(held)
            raise NoPlan(
                f"{len(held)} blocks would be held at once ({listed}), but there are two hands that hold one each; "
                "say where to put one of them before the next is picked up",
                tuple(held),
                "hands",
            )


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
    held_before = tuple(stage.simulator.state().held.values())
    found: tuple[Check, ...] = ()

    def attempt(hand: str) -> None:
        if not free_hands(stage, held_before):
            raise NoPlan("a hand cannot be freed for another try", tuple(objects), "hands")
        put_back(stage, before, _touched(stage, objects))
        for name in objects:
            uncover(stage, name, hand, lambda scene, start: _plan_picks(stage, objects, hand, scene, start))
            remove_leaning(stage, name)
        for plan, name in zip(
            _plan_picks(stage, objects, hand, stage.scene, stage.simulator.state()), objects, strict=True
        ):
            stage.execute(plan, "pick", name)

    def check() -> tuple[Check, ...]:
        nonlocal found
        found = _lifted(stage, before, objects)
        others = [one for one in found if not one.passed]
        only = {one.name for one in others} == {"others_unmoved"}
        if only and put_back(stage, before, _touched(stage, objects)):
            found = _lifted(stage, before, objects)
        return found

    def follow(scene: Scene, start: RobotState) -> object:
        return _plan_picks(stage, objects, arm, scene, start)

    if not keep_trying(stage, objects[0], attempt, check, arm, follow=follow):
        found = _lifted(stage, before, objects)
    return found


def _lifted(stage: Stage, before: Scene, objects: Sequence[str]) -> tuple[Check, ...]:
    """The checks of objects that were picked up."""
    last = {item.object: item for item in stage.handled if item.action == "pick"}
    arms = {name: last[name].arm for name in objects if name in last}
    seconds = stage.keep_still(arms)
    after = stage.look_carefully()
    found: list[Check] = []
    for name in objects:
        if name not in last:
            found.append(checks.held(name, "", 0.0))
            continue
        found.append(checks.at_goal(after, name, last[name].goal, "lifted to where it should be", stage.doubt))
        found.append(checks.held(name, arms[name], seconds[name]))
    return (*found, checks.others_unmoved(before, after, _touched(stage, objects), stage.doubt))


def _touched(stage: Stage, objects: Sequence[str]) -> tuple[str, ...]:
    """The objects, and everything that had to be moved for them."""
    return (*objects, *sorted(stage.moved))


def _plan_picks(stage: Stage, objects: Sequence[str], arm: str, scene: Scene, start: RobotState) -> list[Plan]:
    """A plan for each object; for two objects, whichever pair of hands works."""
    if len(objects) == 1:
        return [stage.plan_pick(objects[0], arm, scene=scene, start=start)]
    refusal: NoPlan | None = None
    for first in _hands(scene, objects):
        second = ARMS[1 - ARMS.index(first)]
        try:
            one = stage.plan_pick(objects[0], first, scene=scene, start=start)
            lifted = scene if one.goal is None else scene.moved({objects[0]: one.goal})
            return [one, stage.plan_pick(objects[1], second, scene=lifted, start=one.end)]
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
    place = np.asarray(action.destination.position, dtype=float)
    places = np.array([action.destination.position, *action.destination.region], dtype=float)
    on_top = action.destination.relation == "top"

    def spots(number: int) -> np.ndarray:
        name = action.objects[number]
        if number == 0:
            return places
        if on_top:
            last = stage.scene.box(action.objects[number - 1])
            return np.array([[*last.position[:2], last.top + stage.scene.box(name).half_extents[2]]])
        return spread(beside(stage.scene, name, place))

    laying = Laying(stage, "place", arm)
    for number, name in enumerate(action.objects):
        box = stage.scene.box(name)
        if not laying.put(name, partial(spots, number), [box.footprint - box.position[:2] + place[:2]]):
            break
    return laying.checked(action.objects, "at its destination")


def _clear(stage: Stage, objects: Sequence[str], arm: str) -> tuple[Check, ...]:
    laying = Laying(stage, "clear", arm)
    before = laying.before
    region = region_of(before, objects)
    left = sorted(objects, key=lambda name: -round(float(before.box(name).position[2]), 2))
    while left:
        done = _one_of(laying, stage, left, region)
        if done is None:
            break
        left.remove(done)
    found = laying.checked(objects, "at its new place")
    after = stage.look_carefully()
    return (*found, *(checks.out_of_region(after, name, region) for name in objects))


def _one_of(laying: Laying, stage: Stage, left: Sequence[str], region: np.ndarray) -> str | None:
    """Clears the first of the objects that there is a plan for; which, or None where that was given up.

    Raises:
        NoPlan: there is a plan for none of them.
    """
    refusal: NoPlan | None = None
    for name in left:
        try:
            done = laying.put(name, lambda name=name: spread(out_of_the_way(stage.scene, name, region)), [region])  # type: ignore[misc]
        except NoPlan as error:
            refusal = refusal or error
        else:
            return name if done else None
    assert refusal is not None
    raise refusal


def verdict(done: Sequence[Check], actions: Sequence[GroundedAction], stage: Stage) -> tuple[str, str, str | None]:
    """Outcome, message and reason; success only where there are checks and all of them passed."""
    broken = [check for check in done if not check.passed]
    told = "; ".join(incident.message for incident in stage.incidents if incident.kind != "check")
    if broken or not done:
        first = broken[0] if broken else None
        said = "nothing was checked" if first is None else f"it is not so that {first.meaning}"
        reason = "unchecked" if first is None else first.name
        return FAILED, f"carried out, but {said}" + (f" ({told})" if told else ""), reason
    parts = []
    if not actions:
        return DONE, "; ".join(check.meaning for check in done), None
    for action in actions:
        names = " and ".join([", ".join(action.objects[:-1])] * (len(action.objects) > 1) + [action.objects[-1]])
        arms = list(dict.fromkeys({item.object: item.arm for item in stage.handled}[name] for name in action.objects))
        hands = f"the {arms[0]} hand" if len(arms) == 1 else "the hands, one in each"
        verb = "is" if len(action.objects) == 1 else "are"
        parts.append(
            f"{names} {verb} in {hands}" if action.action == "pick"
            else f"{names} {verb} where {'it' if verb == 'is' else 'they'} should be" if action.action == "place"
            else f"{names} {verb} out of the way"
        )  # fmt: skip
    return DONE, "; ".join(parts) + (f", although {told}" if told else ""), None


def after_moving(handled: Sequence[Handled]) -> str:
    """The things done before there was no plan, as the beginning of a sentence."""
    names = ", ".join(item.object for item in handled)
    return f"after {names} had been moved: " if names else ""

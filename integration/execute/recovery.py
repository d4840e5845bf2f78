"""Trying again within a bound, or stopping safe: what the executor does when something is not as planned."""

from __future__ import annotations

from collections.abc import Callable, Collection

import numpy as np

from integration.errors import NoPlan
from integration.execute.checks import UNMOVED, Check, drifts
from integration.execute.incidents import Trouble
from integration.execute.setting_aside import beside, out_of_the_way, region_of
from integration.execute.stage import Stage
from motion import MotionError, RobotState, Scene
from motion.plan.goals import heading
from motion.robot.state import ARMS

Follow = Callable[[Scene, RobotState], object]
"""Plans what is to be done once nothing is in the way any more; raises `NoPlan` if that cannot be."""

TRIES = 4
"""Number of attempts at an object."""
_STUCK = 2
"""After so many troubles with a gripper the other hand is used, where that is free to choose."""
_SPOTS = 12
_APART = 0.07  # spots that are tried after one another are at least so far apart, in [m]
_RESTORED = 3
_ASIDE = 3
"""So many blocks are set aside for one, at most."""


def keep_trying(
    stage: Stage,
    name: str,
    attempt: Callable[[str], None],
    check: Callable[[], tuple[Check, ...]],
    arm: str,
    *,
    follow: Follow | None = None,
    room: bool = False,
) -> bool:
    """Attempts something until the checks pass, at most `TRIES` times; each attempt begins with what is seen then.

    Args:
        stage: where it is done.
        name: the object it is about.
        attempt: plans and carries out, by the arm that it is given.
        check: what has to be seen afterwards.
        arm: "left", "right" or "auto".
        follow: plans what is to be done once nothing is in its way any more; raises `NoPlan` if that cannot be.
        room: whether what keeps the hand from the object after a trouble may be set aside: it has to be put back.

    Returns:
        whether the checks passed. If not, the robot has stopped, at home where there was a free way.

    Raises:
        NoPlan: there was no plan for the first attempt.
    """
    stuck: list[str] = []
    for count in range(TRIES):
        try:
            attempt(_hand(arm, stuck))
            broken = [one for one in check() if not one.passed]
            if not broken:
                return True
            stage.note("check", name, f"it is not so that {broken[0].meaning}")
        except Trouble as trouble:
            if trouble.incident.kind == "gripper":
                stuck.append(trouble.arm)
                if stuck.count(trouble.arm) == _STUCK:
                    _withdraw(stage, trouble.arm)
        except NoPlan as refusal:
            first = count == 0
            try:
                helps = follow if first else None
                roomy = count + 1 < TRIES and (room or first) and make_room(stage, name, refusal, helps, back=room)
            except Trouble:
                roomy = True  # something has moved; it is looked at anew
            if not roomy and first:
                raise
            if not roomy:
                stage.note("plan", name, f"there is no plan to go on with {name}: {refusal}")
                break
        stage.come_to_rest()
    stop(stage)
    return False


def _hand(arm: str, stuck: list[str]) -> str:
    """The hand to use: another one than a hand whose gripper failed too often."""
    if arm == "auto":
        for side in ARMS:
            if stuck.count(side) >= _STUCK:
                return ARMS[1 - ARMS.index(side)]
    return arm


def stop(stage: Stage) -> None:
    """Ends it safely: hands that hold nothing go home where there is a free way, all else stays as it is."""
    stage.come_to_rest()
    if not all(_withdraw(stage, arm) for arm in ARMS):
        stage.note("plan", "", "an arm keeps still where it is, for there is no free way home")


def _withdraw(stage: Stage, arm: str) -> bool:
    """Brings an arm home if its hand is empty; False where there is no free way."""
    if arm in stage.simulator.state().held:
        return True
    try:
        stage.execute(stage.plan_home(arm), "home", "")
    except (NoPlan, Trouble, MotionError):
        return False
    return True


def free_hands(stage: Stage, wanted: Collection[str]) -> bool:
    """Sets down what hands hold besides what they held when the action began; whether that was possible."""
    for side, name in stage.simulator.state().held.items():
        if name in wanted:
            continue
        spots = beside(stage.scene, name, stage.scene.box(name).position)
        if not put_at_first(stage, "place", name, spots, side):
            return False
    return True


def put_at_first(stage: Stage, action: str, name: str, spots: np.ndarray, arm: str) -> bool:
    """Sets an object down at one of `spots`, (n, 3) in [m], rather one of the first; False where no plan does."""
    if not len(spots):
        return False
    try:
        plans = stage.plan_transport(name, spread(spots), arm)
    except NoPlan:
        return False
    for plan in plans:
        stage.execute(plan, action, name)
    return True


def remove_leaning(stage: Stage, name: str) -> None:
    """Moves what leans on an object out of the way first, so that it does not fall.

    Raises:
        NoPlan: something leans on it and cannot be moved.
        Trouble: something was not as planned.
    """
    for other in stage.scene.leaning_on(name):
        stage.note("leaning", other, f"{other} leans on {name} and was moved first")
        spots = out_of_the_way(stage.scene, other, region_of(stage.scene, [name]))
        stage.moved.add(other)
        if not put_at_first(stage, "clear", other, spots, "auto"):
            raise NoPlan(f"{other} leans on {name}, and there is no plan to move it first", (name, other), "leaning")


def make_room(stage: Stage, name: str, refusal: NoPlan, follow: Follow | None = None, *, back: bool = True) -> bool:
    """Sets aside what keeps the hand from an object; False where that cannot be done or does not help.

    Only with both hands empty and at home: an arm that is stuck between blocks is not where it is taken to be.

    Args:
        stage: where it is done.
        name: the object.
        refusal: why there is no plan for it.
        follow: plans what is to be done then; where that cannot be, nothing is moved.
        back: whether it is put back at the end; beside a hand that goes on holding there is no way to.

    Raises:
        Trouble: something was not as planned.
    """
    if not _in_the_way(stage, name, refusal):
        return False
    if stage.simulator.state().held or not all(_withdraw(stage, arm) for arm in ARMS):
        return False
    aside = _asides(stage, name, refusal, follow)
    for other, spot in aside:
        stage.note("hemmed", other, f"{other} was in the way of {name} and was set aside" + " until the end" * back)
        if not back:
            stage.moved.add(other)
        if not put_at_first(stage, "clear", other, spot[None], "auto"):
            return False
    return bool(aside)


def _in_the_way(stage: Stage, name: str, refusal: NoPlan) -> list[str]:
    """Names of the blocks besides the object that are why there is no plan for it."""
    bodies = getattr(refusal.__cause__, "bodies", None) or ()
    return sorted({box.name for box in stage.scene.boxes if not box.fixed and box.name != name}.intersection(bodies))


def _asides(stage: Stage, name: str, refusal: NoPlan, follow: Follow | None) -> list[tuple[str, np.ndarray]]:
    """Blocks to be set aside, in order, each with its place, (3,) in [m], so that what follows can be done then."""
    scene, start = stage.scene, stage.simulator.state()
    found: list[tuple[str, np.ndarray]] = []
    for _ in range(_ASIDE):
        others = [other for other in _in_the_way(stage, name, refusal) if other not in dict(found)]
        for other in others:
            spots = spread(out_of_the_way(scene, other, region_of(scene, [name, *others])))
            try:
                plans = stage.plan_transport(other, spots, "auto", scene=scene, start=start) if len(spots) else ()
            except NoPlan:
                continue
            if plans and plans[-1].goal is not None:
                found.append((other, plans[-1].goal.position))
                scene, start = scene.moved({other: plans[-1].goal}), plans[-1].end
                break
        else:
            return []
        try:
            if follow is not None:
                follow(scene, start)
        except NoPlan as error:
            refusal = error
        else:
            return found
    return []


def put_back(stage: Stage, before: Scene, handled: Collection[str]) -> bool:
    """Puts other blocks that incidents moved back where they were; whether there was anything to put back."""
    shifts = drifts(before, stage.look_carefully())
    held = stage.simulator.state().held.values()
    others = [name for name, way in shifts.items() if way > UNMOVED - stage.doubt and name not in {*handled, *held}]
    if not others or len(others) > _RESTORED or all(one.kind == "check" for one in stage.incidents):
        return False
    for name in others:
        box, told = before.box(name), f"{name} was moved by {1000 * shifts[name]:.0f} mm and"
        try:
            for plan in stage.plan_transport(name, box.position, "auto", yaw=heading(box)):
                stage.execute(plan, "place", name)
        except (NoPlan, Trouble):
            stage.note("bystander", name, f"{told} could not be put back")
            return False
        stage.note("bystander", name, f"{told} put back")
    return True


def spread(spots: np.ndarray) -> np.ndarray:
    """The first of `spots`, (n, 3), that keep apart, so that tries are not wasted on neighbours of a bad one."""
    chosen: list[np.ndarray] = []
    for spot in spots:
        if len(chosen) == _SPOTS:
            break
        if all(np.linalg.norm(spot - other) >= _APART for other in chosen):
            chosen.append(spot)
    return np.array(chosen).reshape(-1, 3)

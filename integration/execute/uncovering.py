"""Taking a stack apart where what is meant is not on top: only if the rest can be done, and looking after each step."""

from __future__ import annotations

from collections.abc import Sequence

from numpy.typing import ArrayLike

from integration.errors import NoPlan
from integration.execute.recovery import Follow
from integration.execute.stage import Stage
from motion import stacked_on

_MORE = 2
"""Number of steps beyond the number of blocks, in case one falls back."""


def uncover(stage: Stage, name: str, arm: str, follow: Follow, keep_free: Sequence[ArrayLike] = ()) -> None:
    """Sets aside what stands on an object, the topmost first; nothing moves unless all of it can be done.

    Args:
        stage: where it is done.
        name: the object.
        arm: "left", "right" or "auto".
        follow: what is to be done then.
        keep_free: convex outlines, (n, 2) in [m], where nothing is to be set down.

    Raises:
        NoPlan: something cannot be set aside, or what follows cannot be done.
        Trouble: something was not as planned.
    """
    held = tuple(stage.simulator.state().held.values())
    steps = len(stacked_on(stage.scene, name, held))
    for count in range(steps + _MORE if steps else 0):
        plans = stage.plan_unstacking(name, arm, keep_free)
        if not plans:
            return
        if count == 0:
            goals = {plan.target: plan.goal for plan in plans if plan.target is not None and plan.goal is not None}
            follow(stage.scene.moved(goals), plans[-1].end)
        top = plans[0].target
        assert top is not None
        stage.note("covered", top, f"{top} stood on {name} and was set aside first")
        stage.moved.add(top)
        stage.execute(plans[0], "clear", top)
    if stacked_on(stage.scene, name, held):
        raise NoPlan(f"what stands on {name} could not be set aside in {steps + _MORE} steps", (name,), "covered")

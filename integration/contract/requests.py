"""Requests: goals for programs that need no words, and who turns words into goals."""

from __future__ import annotations

import time
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Protocol

import numpy as np

from grounding.result import Destination, GroundedAction, Grounding
from grounding.world import World
from integration.errors import UsageError
from motion.robot.state import ARMS

Point = tuple[float, float, float]


@dataclass(frozen=True)
class Pick:
    """Take objects, one into each hand, and hold them above where they stood.

    Attributes:
        objects: one id or several.
        arm: "left" or "right"; None for whichever does it better.
    """

    objects: str | tuple[str, ...]
    arm: str | None = None


@dataclass(frozen=True)
class Place:
    """Set an object down.

    Attributes:
        object: its id; it may be in a hand already.
        position: (3,) where its centre shall be [m], or (n, 3) places of which one will do, the best first.
        arm: "left" or "right"; None for whichever does it better.
        on: id of what it is to stand on, where that is no table.
    """

    object: str
    position: Sequence[float] | Sequence[Sequence[float]]
    arm: str | None = None
    on: str | None = None


@dataclass(frozen=True)
class Clear:
    """Move objects out of where they are.

    Attributes:
        objects: one id or several.
        arm: "left" or "right"; None for whichever does it better.
    """

    objects: str | tuple[str, ...]
    arm: str | None = None


@dataclass(frozen=True)
class Home:
    """Bring arms home; what they hold they keep.

    Attributes:
        arm: "left" or "right"; None for both.
    """

    arm: str | None = None


Goal = Pick | Place | Clear | Home


class GrounderLike(Protocol):
    """Anything that turns words into goals, such as `grounding.Grounder`."""

    def ground(self, text: str, world: World, history: Sequence[str] = ()) -> Grounding:
        """The goals that the words mean in this world."""


def grounded(goal: Goal) -> Grounding:
    """A goal as if words had told it.

    Raises:
        UsageError: it is no goal, its place is no place, or there is no such arm.
    """
    if not isinstance(goal, Pick | Place | Clear | Home):
        raise UsageError(f"a goal is Pick, Place, Clear, Home or a text, not {goal!r}")
    if goal.arm is not None and goal.arm not in ARMS:
        raise UsageError(f"there is no arm {goal.arm!r}; there are {' and '.join(ARMS)}")
    if isinstance(goal, Home):
        return Grounding(in_words(goal), "grounded")
    if isinstance(goal, Place):
        best, *others = _points(goal)
        on = None if goal.on is None else "top"
        to = Destination(best, on, () if goal.on is None else (goal.on,), tuple(others))
        return Grounding(in_words(goal), "grounded", (GroundedAction("place", (goal.object,), 1.0, to, goal.arm),))
    names = (goal.objects,) if isinstance(goal.objects, str) else tuple(goal.objects)
    kind = "pick" if isinstance(goal, Pick) else "clear"
    return Grounding(in_words(goal), "grounded", (GroundedAction(kind, names, 1.0, None, goal.arm),))


def in_words(goal: Goal) -> str:
    """A goal in words, for reports."""
    if isinstance(goal, Home):
        return "go home" if goal.arm is None else f"go home with the {goal.arm} arm"
    if isinstance(goal, Place):
        place = ", ".join(f"{value:.3f}" for value in _points(goal)[0])
        return f"place {goal.object} " + (f"on {goal.on}" if goal.on is not None else f"at ({place})")
    names = goal.objects if isinstance(goal.objects, str) else ", ".join(goal.objects)
    return f"{'pick' if isinstance(goal, Pick) else 'clear'} {names}"


def checked_arm(arm: str) -> str:
    """The arm that is to do it.

    Raises:
        UsageError: there is no such arm.
    """
    if arm not in ("auto", *ARMS):
        raise UsageError(f"there is no arm {arm!r}; there are {', '.join(ARMS)} and auto")
    return arm


def loaded(grounder: GrounderLike | None) -> GrounderLike:
    """A grounder, or where there is none the one with the shipped weights."""
    if grounder is not None:
        return grounder
    from grounding import Grounder

    return Grounder.load()


def timed_grounding(grounder: GrounderLike, text: str, world: World, history: Sequence[str]) -> tuple[Grounding, float]:
    """The meaning of a text, and how long that took in seconds.

    Raises:
        LanguageError: the text is empty.
    """
    start = time.perf_counter()
    grounding = grounder.ground(text, world, history)
    return grounding, time.perf_counter() - start


def _points(goal: Place) -> list[Point]:
    try:
        points = np.asarray(goal.position, dtype=float)
    except (TypeError, ValueError):
        points = np.empty(0)
    points = points[None] if points.shape == (3,) else points
    if points.ndim != 2 or points.shape[1:] != (3,) or not len(points) or not np.all(np.isfinite(points)):
        raise UsageError(
            f"{goal.object} is placed at x, y, z in metres, or at one of several such places, not at {goal.position!r}"
        )
    return [(float(x), float(y), float(z)) for x, y, z in points]

"""Reasons why the attempts at a goal failed, told by one error."""

from __future__ import annotations

from collections import Counter

from motion.errors import GraspUnavailable, MotionError, PathNotFound, PlanInCollision, UnreachableTarget
from motion.grasp.candidates import Grasp


class Failures:
    """Reasons why the attempts at a target failed, and the one error that tells it best."""

    def __init__(self, target: str) -> None:
        self._target = target
        self._noted: list[MotionError] = []
        self._pathless: list[Grasp] = []
        self._obstructed: list[Grasp] = []

    def note(self, grasp: Grasp | None, error: MotionError) -> None:
        """One attempt failed."""
        self._noted.append(error)
        if isinstance(error, PathNotFound) and grasp is not None and grasp not in self._pathless:
            self._pathless.append(grasp)
        near = isinstance(error, PlanInCollision) or (isinstance(error, UnreachableTarget) and error.bodies is not None)
        if near and grasp is not None and grasp not in self._obstructed:
            self._obstructed.append(grasp)

    def obstructed(self) -> list[Grasp]:
        """The grasps that failed because something was too near."""
        return list(self._obstructed)

    def without_path(self) -> list[Grasp]:
        """The grasps that failed only because no path was found: worth a longer search."""
        return list(self._pathless)

    def summary(self) -> MotionError:
        """The error to raise: of the attempts that came farthest, the most frequent reason."""
        unreachable = [error for error in self._noted if isinstance(error, UnreachableTarget)]
        others = [error for error in self._noted if not isinstance(error, UnreachableTarget)]
        count = len(self._noted)
        if others:
            kinds = Counter(type(error) for error in others)
            kind = kinds.most_common(1)[0][0]
            example = next(error for error in others if type(error) is kind)
            if isinstance(example, PlanInCollision):
                return PlanInCollision(
                    f"none of the {count} grasps of {self._target!r} has a free way; for example {example}",
                    example.phase,
                    example.bodies,
                    example.clearance,
                    example.place,
                )
            example.add_note(f"this is the most frequent of {count} failed grasps of {self._target!r}")
            return example
        collisions = [error for error in unreachable if error.reason == "collision" and error.bodies]
        if collisions:
            first, second = Counter(error.bodies for error in collisions if error.bodies).most_common(1)[0][0]
            return GraspUnavailable(
                f"every grasp of {self._target!r} that an arm reaches is obstructed, mostly {first} by "
                f"{second}; what stands in the way must be moved first",
                self._target,
                (first, second),
            )
        limited = [error for error in unreachable if error.reason == "joint limit"]
        chosen = (limited or unreachable)[0]
        return UnreachableTarget(
            f"{self._target!r} cannot be reached by any of {count} grasps; for example {chosen}",
            chosen.reason,
            chosen.joints,
            chosen.bodies,
        )

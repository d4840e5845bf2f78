"""Room to let go: which grasps leave the fingers free where the box is set down, seen before any joints are sought."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from motion.errors import GraspUnavailable
from motion.grasp.approaches import release_opening
from motion.grasp.candidates import Grasp, neighbours
from motion.grasp.fingers import Pair, obstacles
from motion.plan.failures import Failures
from motion.plan.ways import Goals
from motion.poses import Pose
from motion.scene import Box, Scene


class Room:
    """The room around destinations of a box.

    Args:
        scene: where everything is.
        box: that is set down.
        grasps: to be tried, the best first.
        failures: where it is noted that there is none.
    """

    def __init__(self, scene: Scene, box: Box, grasps: Sequence[Grasp], failures: Failures) -> None:
        self._scene, self._box, self._grasps, self._failures = scene, box, grasps, failures
        self._grips = [box.pose.inverse() @ grasp.tool for grasp in grasps]

    def releases(self, goals: Goals) -> Iterator[tuple[Grasp, Goals]]:
        """Each grasp with those of the goals where its fingers can let go; none where that are none.

        Args:
            goals: destinations that look the same, so that they have the same neighbours.
        """
        near = neighbours(self._scene, goals[0][0])
        kept: dict[int, list[tuple[Box, str]]] = {}
        for arm in sorted({grasp.arm for grasp in self._grasps}):
            mine = [number for number, grasp in enumerate(self._grasps) if grasp.arm == arm]
            tools = [goal.pose @ self._grips[number] for number in mine for goal, _ in goals]
            openings = [release_opening(self._grasps[number].width) for number in mine for _ in goals]
            met = iter(obstacles(arm, tools, openings, near))
            for number in mine:
                for goal in goals:
                    pair = next(met)
                    if pair is None:
                        kept.setdefault(number, []).append(goal)
                    else:
                        self._failures.note(self._grasps[number], self._met(goal[0].pose, pair))
        for number in sorted(kept):
            yield self._grasps[number], tuple(kept[number])

    def _met(self, place: Pose, pair: Pair) -> GraspUnavailable:
        x, y = place.position[:2]
        return GraspUnavailable(
            f"{self._box.name!r} cannot be let go at ({x:.3f}, {y:.3f}): a finger would overlap a neighbour, "
            f"{pair[0]} and {pair[1]!r}; what stands in the way must be moved first",
            self._box.name,
            pair,
        )

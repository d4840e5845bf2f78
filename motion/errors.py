"""Everything that motion refuses: each message names what was wrong, the value, and what would be right."""

from __future__ import annotations

import math
from collections.abc import Sequence


class MotionError(Exception):
    """Root of every error that motion raises on purpose."""


class RobotUnavailable(MotionError):
    """The robot's description was not found or could not be built."""


class InvalidScene(MotionError):
    """A box or a set of boxes cannot be simulated: NaN, a size that is not positive, a name used twice."""


class UnknownBody(MotionError):
    """A name that the scene does not have.

    Attributes:
        name: the name asked for.
        known: the names there are.
    """

    def __init__(self, name: str, known: Sequence[str]) -> None:
        self.name = name
        self.known = tuple(known)
        super().__init__(f"there is no box named {name!r}; the scene has {', '.join(self.known) or 'no boxes'}")


class InvalidGoal(MotionError):
    """A goal that no motion could meet: not finite, too wide to grasp, occupied, off the table, under another box.

    Attributes:
        target: the name of the box the goal is about, or None.
    """

    def __init__(self, message: str, target: str | None = None) -> None:
        self.target = target
        super().__init__(message)


class UnreachableTarget(MotionError):
    """No joint configuration brings the tool to where it must be.

    Attributes:
        reason: "too far", "joint limit" or "collision".
        joints: the joints that stand at a limit in the best attempt (reason "joint limit").
        bodies: the two bodies that collide in the best attempt (reason "collision"), or None.
    """

    def __init__(
        self, message: str, reason: str, joints: Sequence[str] = (), bodies: tuple[str, str] | None = None
    ) -> None:
        self.reason = reason
        self.joints = tuple(joints)
        self.bodies = bodies
        super().__init__(message)


class GraspUnavailable(MotionError):
    """The box can be reached by no grasp that fits: its width, or the boxes beside it, forbid every one.

    Attributes:
        target: the box.
        bodies: the body of the hand and the box that are in each other's way in the best candidate, or None.
    """

    def __init__(self, message: str, target: str, bodies: tuple[str, str] | None = None) -> None:
        self.target = target
        self.bodies = bodies
        super().__init__(message)


class PlanInCollision(MotionError):
    """A path touches, or comes too near, what it must not.

    Attributes:
        phase: the phase of the plan.
        bodies: the two bodies.
        clearance: signed distance between them in metres; negative is penetration.
        place: where, x, y, z in metres.
    """

    def __init__(
        self,
        message: str,
        phase: str,
        bodies: tuple[str, str],
        clearance: float,
        place: tuple[float, float, float] = (math.nan, math.nan, math.nan),
    ) -> None:
        self.phase = phase
        self.bodies = bodies
        self.clearance = clearance
        self.place = place
        super().__init__(message)


class PathNotFound(MotionError):
    """Start and goal are both free, but no path between them was found within the bound of the search."""


class OutOfTime(MotionError):
    """No plan was found within the time that was allowed.

    Attributes:
        budget: that time, in seconds of processor time.
    """

    def __init__(self, message: str, budget: float) -> None:
        self.budget = budget
        super().__init__(message)


class BackendLost(MotionError):
    """A backend did not answer in time; it was told to stop.

    Attributes:
        asked: what it was asked.
    """

    def __init__(self, message: str, asked: str) -> None:
        self.asked = asked
        super().__init__(message)


class LimitViolation(MotionError):
    """A trajectory exceeds a limit of a joint.

    Attributes:
        joint: the joint.
        quantity: "position", "velocity", "acceleration" or "jerk".
        value: the extreme value, in rad, rad/s, rad/s² or rad/s³.
        limit: the limit it exceeds.
    """

    def __init__(self, joint: str, quantity: str, value: float, limit: float) -> None:
        self.joint = joint
        self.quantity = quantity
        self.value = value
        self.limit = limit
        super().__init__(f"{quantity} of {joint} reaches {value:.4g}; its limit is {limit:.4g}")


class SimulationDiverged(MotionError):
    """The physics produced values that are not finite."""


class RenderingUnavailable(MotionError):
    """No OpenGL could be started without a screen."""

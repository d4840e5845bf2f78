"""The state of the robot's joints and fingers, as a frozen value."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from types import MappingProxyType
from typing import Any

import numpy as np

from motion.errors import InvalidGoal
from motion.poses import Array, frozen
from motion.robot.recipe import recipe

ARMS = ("left", "right")


@dataclass(frozen=True, eq=False)
class RobotState:
    """Joints of both arms, widths of both grippers, and what they hold.

    Attributes:
        left: (7,) joints of the left arm s0, s1, e0, e1, w0, w1, w2, radians.
        right: (7,) the same for the right arm.
        widths: opening of the gripper in metres, by arm.
        held: name of the box each gripper holds, by arm; arms that hold nothing are left out.
    """

    left: Array
    right: Array
    widths: Mapping[str, float] = field(default_factory=lambda: dict.fromkeys(ARMS, recipe().gripper.opened))
    held: Mapping[str, str] = field(default_factory=dict)

    def __post_init__(self) -> None:
        for arm in ARMS:
            joints = frozen(getattr(self, arm))
            if joints.shape != (7,) or not np.all(np.isfinite(joints)):
                raise InvalidGoal(f"the {arm} arm has seven joints with finite angles, not {joints.tolist()}")
            object.__setattr__(self, arm, joints)
        if set(self.widths) != set(ARMS) or not np.all(np.isfinite([float(width) for width in self.widths.values()])):
            raise InvalidGoal(f"both grippers, left and right, have finite widths in metres, not {dict(self.widths)}")
        if not set(self.held) <= set(ARMS):
            raise InvalidGoal(f"the hands that hold something are left and right, not {', '.join(map(str, self.held))}")
        object.__setattr__(self, "widths", MappingProxyType({arm: float(self.widths[arm]) for arm in ARMS}))
        object.__setattr__(self, "held", MappingProxyType(dict(self.held)))

    @classmethod
    def home(cls) -> RobotState:
        """Both arms beside the table's middle, hands open and above everything."""
        return cls(recipe().home["left"], recipe().home["right"])

    def to_json(self) -> dict[str, Any]:
        """Plain values, under the names of the attributes."""
        return {
            **{arm: self.joints(arm).tolist() for arm in ARMS},
            "widths": dict(self.widths),
            "held": dict(self.held),
        }

    def joints(self, arm: str) -> Array:
        """(7,) joints of one arm, radians."""
        return self.left if arm == "left" else self.right

"""One arrangement that people see in a set of blocks, and how well it is formed (Section IV-C)."""

from __future__ import annotations

from dataclasses import dataclass
from math import exp

from grounding.lazy import lazy
from grounding.world import Array


@dataclass(frozen=True)
class Arrangement:
    """Objects that form a shape.

    Attributes:
        kind: row (along y), column (along x), group, circle or tower.
        mask: the members, see `grounding.geometry.masks`.
        count: how many they are.
        centroid: mean position, shape (3,) in [m].
        deviation: root mean square distance from the shape, over the mean gap of neighbours (0 for groups and towers).
        regularity: 1 for even gaps, towards 0 for uneven ones.
        separation: distance to the nearest other object over the largest gap within; large is apart.
        angle: of a line to the axis that its kind is named after, in [rad].
    """

    kind: str
    mask: int
    count: int
    centroid: Array
    deviation: float
    regularity: float
    separation: float
    angle: float = 0.0

    @lazy
    def prominence(self) -> float:
        """How much it catches the eye, for choosing among arrangements that share members; above 0 at all."""
        if self.kind == "tower":
            return 2.0 + self.count
        if self.kind == "group":
            return float(min(self.separation, 4.0) - 1.1) * (1.0 if 3 <= self.count <= 8 else 0.4)
        fit = exp(-((self.deviation / 0.35) ** 2) - (self.angle / 0.4) ** 2 - ((1 - self.regularity) / 0.6) ** 2)
        return fit * float(self.count - (1.0 if self.kind != "circle" else 2.0)) * min(self.separation, 1.5)

    @property
    def noticed(self) -> bool:
        """Whether people who look for one might take it for one, evident or not."""
        return self.prominence > (0.0 if self.kind == "group" else 0.3)

    @lazy
    def evident(self) -> bool:
        """Whether people would name it without being asked: enough members, well formed, apart from others."""
        if self.kind == "tower":
            return True
        if self.kind == "group":
            return self.separation > 2.0 and 3 <= self.count <= 8
        if self.kind == "circle":
            return self.count >= 5 and self.deviation < 0.15 and self.regularity > 0.7 and self.separation > 0.7
        if self.count < 3 or self.angle > 0.4:
            return False
        if self.count == 3:
            return self.deviation < 0.15 and self.regularity > 0.75 and self.separation > 0.9
        return self.deviation < 0.3 and self.regularity > 0.55 and self.separation > 0.7

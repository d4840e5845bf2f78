"""Facts for symbolic planners: what stands on what, what is clear, and what each hand holds."""

from __future__ import annotations

from collections.abc import Mapping
from typing import NamedTuple

from motion import Scene
from motion.robot.state import ARMS


class Fact(NamedTuple):
    """Something that holds of named things.

    Attributes:
        name: "on" (x, y), "on_table" (x, table), "clear" (x), "holding" (arm, x) or "hand_empty" (arm).
        arguments: ids of objects and names of arms.
    """

    name: str
    arguments: tuple[str, ...]

    def __str__(self) -> str:
        return f"{self.name}({', '.join(self.arguments)})"


def facts_of(scene: Scene, held: Mapping[str, str]) -> tuple[Fact, ...]:
    """All facts, in a fixed order.

    Args:
        scene: where everything is.
        held: what hands hold, by arm.
    """
    found: list[Fact] = []
    carried = set(held.values())
    for box in scene.boxes:
        if box.fixed or box.name in carried:
            continue
        for name in sorted(scene.below(box.name)):
            found.append(Fact("on_table" if scene.box(name).fixed else "on", (box.name, name)))
        if not [other for other in scene.boxes_above(box.name) if other.name not in carried]:
            found.append(Fact("clear", (box.name,)))
    for arm in ARMS:
        found.append(Fact("holding", (arm, held[arm])) if arm in held else Fact("hand_empty", (arm,)))
    return tuple(sorted(found))

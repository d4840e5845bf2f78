"""Checks of the simulator's final state, all to be passed before anything counts as done.

Every check is a measurement with its limit; nothing here knows what was planned beyond where a block should be.
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from integration.execute.distances import distances_outside
from motion import RobotState, Scene
from motion.polygons import contains

AT_GOAL = 0.005
UNMOVED = 0.005
HELD_FOR = 2.0
SUPPORT_GAP = 0.002
DRIFT = 0.0005
AT_HOME = 0.02
OUTSIDE = 0.0
_DIGITS = 6


@dataclass(frozen=True)
class Check:
    """One measurement and its verdict.

    Attributes:
        name: at_goal, held, at_home, supported, released, at_rest, out_of_region or others_unmoved.
        object: id of the object that was measured, or the arm; for others_unmoved of the one that moved most ("" if
            there is none).
        passed: whether `measured` keeps the limit.
        measured: what was measured, in `unit`.
        limit: the most that is allowed, or the least where `at_least`.
        unit: "m", "s", "rad" or "contacts".
        meaning: what it means, for people.
        at_least: whether the limit is a lower one.
    """

    name: str
    object: str
    passed: bool
    measured: float
    limit: float
    unit: str
    meaning: str
    at_least: bool = False

    def to_json(self) -> dict[str, Any]:
        """Plain values; a measurement that is not finite is None."""
        return {
            "name": self.name,
            "object": self.object,
            "passed": self.passed,
            "measured": round(self.measured, _DIGITS) if math.isfinite(self.measured) else None,
            "limit": self.limit,
            "unit": self.unit,
            "at_least": self.at_least,
            "meaning": self.meaning,
        }


def at_goal(scene: Scene, name: str, goal: ArrayLike, where: str = "at its goal", doubt: float = 0.0) -> Check:
    """The object's centre is within 5 mm of `goal`, (3,) in [m], for all the `doubt` of seeing, in [m]."""
    return _most("at_goal", name, _distance(scene, name, goal), AT_GOAL - doubt, "m", f"{name} is {where}")


def held(name: str, arm: str, seconds: float, wanted: float = HELD_FOR) -> Check:
    """The object was between the fingers of `arm` for so many seconds without a break, up to now."""
    passed = bool(seconds >= wanted - 1e-9)
    meaning = f"{name} is still held by the {arm} hand"
    return Check("held", name, passed, float(seconds), wanted, "s", meaning, at_least=True)


def at_home(arm: str, joints: ArrayLike) -> Check:
    """Every joint of an arm, (7,) in [rad], is within 0.02 rad of where it is at home."""
    off = float(np.max(np.abs(np.asarray(joints, dtype=float) - RobotState.home().joints(arm))))
    return _most("at_home", arm, off, AT_HOME, "rad", f"the {arm} arm is at home")


def supported(scene: Scene, name: str, doubt: float = 0.0) -> Check:
    """The object rests on what is below its centre: the gap between both is at most 2 mm and the `doubt` of seeing."""
    box = scene.box(name)
    tops = [
        (abs(box.bottom - other.top), other.name)
        for other in scene.boxes
        if other.name != name and contains(other.footprint, np.asarray(box.position[:2]))
    ]
    gap, below = min(tops, default=(math.inf, "nothing"))
    return _most("supported", name, gap, SUPPORT_GAP + doubt, "m", f"{name} rests on {below}")


def released(name: str, contacts: Iterable[tuple[str, str]], boxes: Iterable[str]) -> Check:
    """Nothing of the robot touches the object.

    Args:
        name: the object.
        contacts: pairs of bodies that touch now.
        boxes: the names of everything that is no part of the robot.
    """
    others = {*boxes, "floor"}
    touching = [pair for pair in contacts if name in pair and not set(pair) <= others]
    return _most("released", name, len(touching), 0, "contacts", f"no hand touches {name}")


def at_rest(name: str, drift: float, doubt: float = 0.0) -> Check:
    """The object moved at most 0.5 mm while it was watched, and the `doubt` of seeing."""
    return _most("at_rest", name, drift, DRIFT + 2 * doubt, "m", f"{name} lies still")


def out_of_region(scene: Scene, name: str, region: ArrayLike) -> Check:
    """The object's centre is outside of a convex region, (n, 2) anticlockwise in [m]; measured is how far outside."""
    outside = float(distances_outside(region, scene.box(name).position[:2])[0])
    meaning = f"{name} is out of the region that was to be cleared"
    return Check("out_of_region", name, bool(outside > OUTSIDE), outside, OUTSIDE, "m", meaning, at_least=True)


def others_unmoved(before: Scene, after: Scene, moved: Iterable[str], doubt: float = 0.0) -> Check:
    """Of all loose objects but those named in `moved`, none is farther than 5 mm from where it was."""
    handled = set(moved)
    shifts = [
        (_distance(after, box.name, box.position), box.name)
        for box in before.boxes
        if not box.fixed and box.name not in handled
    ]
    most, name = max(shifts, default=(0.0, ""))
    return _most("others_unmoved", name, most, UNMOVED - doubt, "m", "no other block moved")


def gathered(found: Sequence[Check]) -> tuple[tuple[Check, int], ...]:
    """Checks for people: of those that several objects passed, the nearest to failing, and how many it speaks for."""
    shown: list[tuple[Check, int]] = []
    for name in dict.fromkeys(check.name for check in found):
        alike = [check for check in found if check.name == name]
        shown += [(check, 1) for check in alike if not check.passed]
        passed = [check for check in alike if check.passed]
        if passed:
            shown.append((min(passed, key=lambda c: c.measured if c.at_least else -c.measured), len(passed)))
    return tuple(shown)


def drifts(earlier: Scene, later: Scene) -> Mapping[str, float]:
    """Distances that every loose object moved between two observations, in [m]."""
    return {box.name: _distance(later, box.name, box.position) for box in earlier.boxes if not box.fixed}


def _distance(scene: Scene, name: str, point: ArrayLike) -> float:
    distance = float(np.linalg.norm(scene.box(name).position - np.asarray(point, dtype=float)))
    return distance if math.isfinite(distance) else math.inf


def _most(name: str, subject: str, measured: float, limit: float, unit: str, meaning: str) -> Check:
    """A check with an upper limit; what is not a number does not pass."""
    return Check(name, subject, bool(measured <= limit), float(measured), float(limit), unit, meaning)

"""Random worlds of 4 to 20 blocks: is a pick, and a place, planned, and does physics agree? Prints JSON.

    python benchmarks/motion_picks.py --episodes 100 --seed 0 [--blocks 12] [--plan-only]

Every third world has blocks turned onto other faces, every fourth a tower. A block "within reach" is one over the part
of the table that either arm reaches from above; goals of places are free spots of that part, or tops of other blocks.
"""

from __future__ import annotations

import argparse
import json
import sys
import time
from collections import Counter
from typing import Any

import numpy as np

from motion import (
    Box,
    MotionError,
    RobotState,
    Scene,
    Simulator,
    UnreachableTarget,
    grasp_candidates,
    plan_pick,
    plan_transport,
    solve_ik,
)
from motion.polygons import overlap
from motion.poses import Pose, about, quaternion

TABLE = Box("table", (0.65, 0.0, 0.691), size=(0.7, 1.8, 0.04), color=(0.9, 0.9, 0.9, 1.0), fixed=True)
TABLE_TOP = 0.711
REACH = (0.42, 0.76)


def random_scene(rng: np.random.Generator, episode: int, blocks: int | None = None) -> Scene:
    """A table with so many loose blocks of 4 or 5 cm, 4 to 20 by default, at least 12 mm apart."""
    count = int(rng.integers(4, 21)) if blocks is None else blocks
    edge = 0.05 if rng.uniform() < 0.7 else 0.04
    boxes = [TABLE]
    while len(boxes) <= count:
        x, y = rng.uniform(*REACH), rng.uniform(-0.75, 0.75)
        rotation = about((0, 0, 1), rng.uniform(-np.pi, np.pi))
        if episode % 3 == 0:
            rotation = rotation @ _any_face(rng)
        box = Box(f"b{len(boxes)}", (x, y, TABLE_TOP + edge / 2), quaternion(rotation), (edge,) * 3)
        if all(overlap(box.footprint, other.footprint) < -0.012 for other in boxes[1:]):
            boxes.append(box)
    if episode % 4 == 0:
        base, top = boxes[1], boxes[2]
        boxes[2] = top.at(Pose(base.position + np.array([0, 0, edge]), base.orientation))
    return Scene(tuple(boxes))


def run(episodes: int, seed: int, blocks: int | None = None, plan_only: bool = False) -> dict[str, Any]:
    """Plans and simulates; the report."""
    plan_pick(random_scene(np.random.default_rng(0), 0), "b3")  # what is loaded once does not count
    report: dict[str, Any] = {}
    for kind in ("pick", "place"):
        handed_over = 0
        planning, errors, turned, bystanders, durations, clock = [], [], [], [], [], []
        processor: list[float] = []
        reasons: Counter[str] = Counter()
        outcomes: Counter[str] = Counter()
        failures: list[dict[str, Any]] = []
        for episode in range(episodes):
            rng = np.random.default_rng([seed, episode])
            scene = random_scene(rng, episode, blocks)
            loose = [box for box in scene.boxes if not box.fixed and not scene.boxes_above(box.name)]
            target = loose[int(rng.integers(len(loose)))]
            goal = _goal(scene, target, rng)
            begin, busy = time.perf_counter(), time.process_time()
            try:
                if kind == "pick":
                    plans = (plan_pick(scene, target.name, rng=rng),)
                else:
                    plans = plan_transport(scene, target.name, goal, rng=rng)
            except MotionError as error:
                planning.append(time.perf_counter() - begin)
                processor.append(time.process_time() - busy)
                reasons[type(error).__name__] += 1
                places = [target.pose] if kind == "pick" else [target.pose, Pose(goal, target.orientation)]
                reachable = all(_reached(scene, target, place) for place in places)
                outcomes["not planned, reachable" if reachable else "not planned, out of reach"] += 1
                failures.append({"episode": episode, "target": target.name, "error": str(error)[:300]})
                continue
            planning.append(time.perf_counter() - begin)
            processor.append(time.process_time() - busy)
            if plan_only:
                outcomes["planned"] += 1
                durations.append(sum(part.duration for part in plans))
                continue
            handed_over += len(plans) == 2
            plan, contacts = plans[-1], []
            after = 2.0 if kind == "pick" else 0.5
            busy = time.process_time()
            with Simulator(scene, RobotState.home()) as simulator:
                for part in plans:
                    contacts += simulator.execute(part).contacts
                simulator.hold(after)
                poses = simulator.poses()
                held = target.name in simulator.holding(plan.arm)
                clock.append((time.process_time() - busy) / simulator.time)
            assert plan.goal is not None
            error_m, error_rad = poses[target.name].distance(plan.goal)
            others = max(
                (poses[b.name].distance(b.pose)[0] for b in scene.boxes if b.name != target.name and not b.fixed),
                default=0.0,
            )
            errors.append(1000 * error_m)
            turned.append(error_rad)
            bystanders.append(1000 * others)
            durations.append(sum(part.duration for part in plans))
            met = error_m <= 0.005 and others <= 0.005 and not contacts and held == (kind == "pick")
            outcomes["success" if met else "failed"] += 1
            if not met:
                failures.append(
                    {"episode": episode, "target": target.name, "error_mm": 1000 * error_m, "bystanders_mm": 1000 *
                     others, "contacts": contacts, "held": held}
                )  # fmt: skip
        good = outcomes["success"] + outcomes["planned"]
        report[kind] = {
            "episodes": episodes,
            "outcomes": dict(outcomes),
            "success_rate": good / max(1, episodes - outcomes["not planned, out of reach"]),
            "handed_over": handed_over,
            "errors": dict(reasons),
            "planning_ms": _summary(1000 * np.array(planning)),
            "planning_processor_ms": _summary(1000 * np.array(processor)),
            "position_error_mm": _summary(np.array(errors)),
            "orientation_error_rad": _summary(np.array(turned)),
            "bystander_mm": _summary(np.array(bystanders)),
            "plan_seconds": _summary(np.array(durations)),
            "real_time_factor_by_processor": float(1 / np.median(clock)) if clock else None,
            "failures": failures,
        }
    return report


def _reached(scene: Scene, target: Box, place: Pose) -> bool:
    """Whether some hand would reach some grasp of the box at that place if nothing stood around it."""
    alone = Scene((target.at(place),))
    for grasp in grasp_candidates(alone, target.name):
        try:
            solve_ik(grasp.arm, grasp.tool)
        except UnreachableTarget:
            continue
        return True
    return False


def _any_face(rng: np.random.Generator) -> np.ndarray:
    quarter = int(rng.integers(4)) * np.pi / 2
    axis = [(1, 0, 0), (0, 1, 0), (0, 0, 1)][int(rng.integers(3))]
    return np.asarray(about(axis, quarter))


def _goal(scene: Scene, target: Box, rng: np.random.Generator) -> np.ndarray:
    """A free spot on the table, or one time in three the top of another block."""
    others = [b for b in scene.boxes if not b.fixed and b.name != target.name and not scene.boxes_above(b.name)]
    if others and rng.uniform() < 1 / 3:
        return scene.resting_position(target.name, others[int(rng.integers(len(others)))].position[:2])
    while True:
        spot = np.array([rng.uniform(*REACH), rng.uniform(-0.7, 0.7)])
        distances = [np.linalg.norm(box.position[:2] - spot) for box in scene.boxes if not box.fixed]
        if min(distances) > 0.09:
            return scene.resting_position(target.name, spot)


def _summary(values: np.ndarray) -> dict[str, float]:
    if len(values) == 0:
        return {}
    return {
        "median": round(float(np.median(values)), 4),
        "p95": round(float(np.percentile(values, 95)), 4),
        "p99": round(float(np.percentile(values, 99)), 4),
        "max": round(float(np.max(values)), 4),
    }


def main() -> int:
    """The command line."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--episodes", type=int, default=60)
    parser.add_argument("--seed", type=int, default=0)
    parser.add_argument("--blocks", type=int, help="how many blocks every scene has (default: 4 to 20)")
    parser.add_argument("--plan-only", action="store_true", help="do not simulate")
    args = parser.parse_args()
    json.dump(run(args.episodes, args.seed, args.blocks, args.plan_only), sys.stdout, indent=2)
    print()
    return 0


if __name__ == "__main__":
    sys.exit(main())

"""Inverse kinematics of both arms: success and time beside other solvers, and of collision-free grasps. Prints JSON.

    python benchmarks/ik.py --poses 2000 --seed 0

The poses: the wrist anywhere the arm is long enough for, the hand turned at random; a pose counts if a brute-force
search of its own (hundreds of random starts, batched damped least squares) reaches it. A solver has succeeded when its
tool is within 0.1 mm and 1 mrad of the pose and all joints within their ranges, by forward kinematics. `wall` is what a
clock says, `cpu` what the thread used: they differ when others use the machine. pink and further quadratic programming
solvers are measured when they are installed (`pip install pin-pink proxsuite quadprog`).
"""

from __future__ import annotations

import argparse
import json
import sys
import time
import warnings
from collections.abc import Callable
from typing import Any

import numpy as np
from ik_baselines import Solve, brute_force, damped_least_squares, installed, met, with_mink, with_pink

from motion import Box, GraspUnavailable, Pose, Scene, UnreachableTarget, grasp_candidates, load_robot, solve_ik
from motion.collision.clearance import Rules
from motion.ik.avoidance import Avoidance
from motion.polygons import overlap
from motion.poses import about, quaternion

TRAC_IK = {"solver": "TRAC-IK, Baxter (Beeson and Ames, 2015; published, on another machine)", "success": 0.9983,
           "mean_ms": 0.37}  # fmt: skip
TABLE = Box("table", (0.65, 0.0, 0.691), size=(0.7, 1.8, 0.04), fixed=True)
TABLE_TOP = 0.711
QP_SOLVERS = ("daqp", "proxqp", "quadprog", "osqp")


def reachable_poses(count: int, rng: np.random.Generator, starts: int) -> tuple[list[tuple[str, Pose]], int]:
    """`count` poses that the brute-force search reaches, left and right arm in turn; and how many were drawn."""
    found: list[tuple[str, Pose]] = []
    drawn = 0
    while len(found) < count:
        arm = ("left", "right")[len(found) % 2]
        data = load_robot().arm(arm)
        orientation = rng.normal(size=4)
        orientation /= np.linalg.norm(orientation)
        direction = rng.normal(size=3)
        wrist = data.shoulder + direction / np.linalg.norm(direction) * data.reach * rng.uniform() ** (1 / 3)
        pose = Pose(wrist, orientation)
        pose = Pose(wrist + data.wrist * pose.rotation[:, 2], orientation)
        drawn += 1
        if brute_force(arm, pose, rng, starts):
            found.append((arm, pose))
            _say(f"poses: {len(found)} of {count}")
    _say("", end=True)
    return found, drawn


def measured(
    name: str, poses: list[tuple[str, Pose]], solve: Callable[[str, Pose], np.ndarray | None]
) -> dict[str, Any]:
    """Success and times of one solver."""
    robot, wall, cpu, succeeded = load_robot(), [], [], 0
    for arm in ("left", "right"):  # what is made once is made before
        solve(arm, robot.kinematics(arm).pose(np.array(robot.arm(arm).lower) + 0.5))
    for number, (arm, pose) in enumerate(poses, start=1):
        begin, used = time.perf_counter(), time.thread_time()
        joints = solve(arm, pose)
        wall.append(1000 * (time.perf_counter() - begin))
        cpu.append(1000 * (time.thread_time() - used))
        succeeded += joints is not None and met(robot.kinematics(arm), joints, pose)
        if number % 50 == 0:
            _say(f"{name}: {number} of {len(poses)}")
    _say("", end=True)
    row = {"solver": name, "poses": len(poses), "success": round(succeeded / len(poses), 5), **_times(wall, cpu)}
    print(row, file=sys.stderr, flush=True)
    return row


def ours(arm: str, pose: Pose) -> np.ndarray | None:
    """The library's own solver, as it is by default."""
    try:
        return np.asarray(solve_ik(arm, pose).joints)
    except UnreachableTarget:
        return None


def grasps_over_the_table(count: int, rng: np.random.Generator) -> dict[str, Any]:
    """Collision-free joints for the best top-down grasp of a block among twelve, with 5 mm kept from everything."""
    wall, cpu, succeeded, tried, blocked = [], [], 0, 0, 0
    while tried < count:
        scene = _twelve_blocks(rng)
        for name in scene.names[1:]:
            try:
                grasp = next(grasp for grasp in grasp_candidates(scene, name) if grasp.tilt == 0)
            except (GraspUnavailable, StopIteration):
                continue  # its neighbours leave no room for the fingers
            if tried >= count:
                break
            near = Rules(touching=frozenset({name}), close=scene.below(name))
            avoid = Avoidance(scene, grasp.arm, rules=near, width=grasp.opening)
            begin, used = time.perf_counter(), time.thread_time()
            try:
                solve_ik(grasp.arm, grasp.tool, avoid=avoid)
            except UnreachableTarget as error:
                if error.reason != "collision":
                    continue  # not over the part of the table that this hand reaches from above
                blocked += 1
            else:
                succeeded += 1
            tried += 1
            wall.append(1000 * (time.perf_counter() - begin))
            cpu.append(1000 * (time.thread_time() - used))
        _say(f"grasps: {tried} of {count}")
    _say("", end=True)
    return {"grasps": tried, "free": succeeded, "in_collision": blocked, **_times(wall, cpu)}


def _twelve_blocks(rng: np.random.Generator) -> Scene:
    boxes = [TABLE]
    while len(boxes) <= 12:
        place = (rng.uniform(0.42, 0.76), rng.uniform(-0.7, 0.7), TABLE_TOP + 0.025)
        box = Box(f"b{len(boxes)}", place, quaternion(about((0, 0, 1), rng.uniform(-np.pi, np.pi))))
        if all(overlap(box.footprint, other.footprint) < -0.012 for other in boxes[1:]):
            boxes.append(box)
    return Scene(tuple(boxes))


def run(count: int, slow: int, grasps: int, starts: int, seed: int) -> dict[str, Any]:
    """The report."""
    poses, drawn = reachable_poses(count, np.random.default_rng(seed), starts)
    rows = [measured("lm (this library's default)", poses, ours)]
    few = poses[:slow]
    rows.append(measured("damped least squares, Pinocchio", few, _seeded(damped_least_squares, seed)))
    skipped = []
    import qpsolvers

    for solver in QP_SOLVERS:
        if solver in qpsolvers.available_solvers:
            rows.append(measured(f"mink, {solver}", few, _seeded(with_mink(solver), seed)))
        else:
            skipped.append(f"mink, {solver}: the solver is not installed")
    if installed("pink"):
        rows.append(measured("pink, daqp", few, _seeded(with_pink("daqp"), seed)))
    else:
        skipped.append("pink: not installed (pip install pin-pink)")
    return {
        "poses": {"count": count, "drawn": drawn, "brute_force_starts": starts, "seed": seed},
        "solvers": [*rows, TRAC_IK],
        "skipped": skipped,
        "grasps_free_of_collision": grasps_over_the_table(grasps, np.random.default_rng(seed + 1)),
    }


def _seeded(solve: Solve, seed: int) -> Callable[[str, Pose], np.ndarray | None]:
    rng = np.random.default_rng(seed)
    return lambda arm, pose: solve(arm, pose, rng)


def _times(wall: list[float], cpu: list[float]) -> dict[str, Any]:
    return {
        key: {
            "median_ms": round(float(np.median(values)), 3),
            "mean_ms": round(float(np.mean(values)), 3),
            "p99_ms": round(float(np.percentile(values, 99)), 3),
        }
        for key, values in (("wall", wall), ("cpu", cpu))
    }


def _say(text: str, end: bool = False) -> None:
    if sys.stderr.isatty():
        print(f"\r{text:<60}", end="\n" if end else "", file=sys.stderr, flush=True)


def main() -> int:
    """The command line."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--poses", type=int, default=2000, help="for the library's own solver")
    parser.add_argument("--slow-poses", type=int, default=500, help="of these, for each of the others")
    parser.add_argument("--grasps", type=int, default=300)
    parser.add_argument("--starts", type=int, default=300, help="of the brute-force search for each pose")
    parser.add_argument("--seed", type=int, default=0)
    arguments = parser.parse_args()
    for name in ("poses", "slow_poses", "grasps", "starts"):
        if getattr(arguments, name) < 1:
            parser.error(f"--{name.replace('_', '-')} must be at least 1")
    warnings.simplefilter("ignore")  # qpsolvers remarks on every sparse conversion
    report = run(arguments.poses, arguments.slow_poses, arguments.grasps, arguments.starts, arguments.seed)
    json.dump(report, sys.stdout, indent=2)
    print()
    return 0


if __name__ == "__main__":
    sys.exit(main())

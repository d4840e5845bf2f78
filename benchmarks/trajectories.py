"""How near to time-optimal are trajectories? Every phase beside TOPP-RA on the same path and limits. Prints JSON.

    python benchmarks/trajectories.py --plans 40 --seed 0        # needs toppra: pip install '.[measure]'

TOPP-RA (Pham and Pham, 2018) keeps the limits of velocity and acceleration and none of jerk, which ours keep too: its
duration is a lower bound that nothing with a limit of jerk reaches. While a block is carried, limits are scaled by the
carrying speed, for both.
"""

from __future__ import annotations

import argparse
import json
import logging
import sys
from typing import Any

import numpy as np

from integration.benchmark.measures import distribution, machine
from integration.benchmark.random_worlds import draw_episode
from integration.worlds_and_scenes import scene_of
from motion import MotionError, Plan, Trajectory, plan_pick, plan_transport
from motion.robot.recipe import recipe

_STILL = ("close", "open", "hold")
_POINTS, _GRID = 41, 400


def main() -> int:
    """The command line."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--plans", type=int, default=40)
    parser.add_argument("--seed", type=int, default=0)
    args = parser.parse_args()
    try:
        import toppra  # noqa: F401
    except ImportError:
        print("error: toppra is not installed; pip install '.[measure]'", file=sys.stderr)
        return 2
    logging.getLogger("toppra").setLevel(logging.ERROR)
    rows: dict[str, list[tuple[float, float]]] = {}
    for number in range(args.plans):
        for plan in plans_of(args.seed, number):
            for phase in plan.phases:
                if phase.name not in _STILL and phase.duration > 0.05:
                    speed = recipe().carrying_speed if phase.held else 1.0
                    bound = time_optimal(phase.trajectory, speed)
                    rows.setdefault(phase.name, []).append((phase.duration, bound))
        print(f"{number + 1} of {args.plans} plans", file=sys.stderr)
    print(json.dumps({"ratio": summarised(rows), "machine": machine()}, indent=1))
    return 0


def plans_of(seed: int, number: int) -> tuple[Plan, ...]:
    """The plans of an episode of the benchmark: a pick, or a place where its goal is one."""
    episode = draw_episode(seed, number, kinds=("pick", "place", "on"))
    scene, rng = scene_of(episode.world), np.random.default_rng(number)
    to = episode.actions[0].destination
    try:
        if to is None:
            return (plan_pick(scene, episode.target, rng=rng),)
        return plan_transport(scene, episode.target, to.position, rng=rng)
    except MotionError:
        return ()


def time_optimal(trajectory: Trajectory, speed: float) -> float:
    """Least duration along the path of a trajectory with the limits of velocity and acceleration, in seconds."""
    from toppra import SplineInterpolator, algorithm, constraint

    positions = trajectory.positions
    along = np.concatenate([[0.0], np.cumsum(np.linalg.norm(np.diff(positions, axis=0), axis=1))])
    moving = np.concatenate([[True], np.diff(along) > 1e-7])
    along, positions = along[moving] / along[-1], positions[moving]
    places = np.linspace(0.0, 1.0, _POINTS)
    path = SplineInterpolator(places, np.column_stack([np.interp(places, along, column) for column in positions.T]))
    limits = recipe().limits
    velocity, acceleration = limits.velocity * speed, limits.acceleration * speed**2
    instance = algorithm.TOPPRA(
        [
            constraint.JointVelocityConstraint(np.column_stack([-velocity, velocity])),
            constraint.JointAccelerationConstraint(np.column_stack([-acceleration, acceleration])),
        ],
        path,
        gridpoints=np.linspace(0.0, 1.0, _GRID),
        parametrizer="ParametrizeConstAccel",
    )
    return float(instance.compute_trajectory(0.0, 0.0).duration)


def summarised(rows: dict[str, list[tuple[float, float]]]) -> dict[str, Any]:
    """Ratios of durations, by phase and over all."""
    every = [pair for pairs in rows.values() for pair in pairs]
    ratios = {name: distribution(ours / bound for ours, bound in pairs) for name, pairs in rows.items()}
    ours, bound = (sum(values) for values in zip(*every, strict=True))
    within = float(np.mean([one / other <= 1.15 for one, other in every]))
    return {
        "phases": ratios,
        "all": distribution(one / other for one, other in every),
        "of_the_sums": round(ours / bound, 4),
        "share_within_1.15": round(within, 4),
    }


if __name__ == "__main__":
    sys.exit(main())

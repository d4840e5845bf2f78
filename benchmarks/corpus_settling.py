"""How fast worlds of generated corpora are settled, how many are drawn again, and how still they lie. Prints JSON.

    python benchmarks/corpus_settling.py [--worlds N] [--seed N] [--robot N]

"with the robot" puts the first N worlds of each kind into the simulation that instructions are carried out in, lets a
second pass, and tells how far the block went that moved most: what was settled without the robot should rest there too.
"""

from __future__ import annotations

import argparse
import json
import os
import platform
import sys
import time
from collections.abc import Sequence
from typing import Any

import numpy as np

from grounding.corpus.generator import compose_world
from integration.corpus.settled_worlds import COMPOSED, PUSHED, PUSHED_EVERY, SettledWorld, draw_settled
from integration.worlds_and_scenes import scene_of
from motion import Simulator
from motion.sim.settling import push_about, settle


def timed(seed: int, numbers: Sequence[int]) -> tuple[list[SettledWorld], list[float]]:
    """Settled worlds, and the seconds that each took."""
    worlds, seconds = [], []
    for number in numbers:
        start = time.perf_counter()
        worlds.append(draw_settled(seed, number))
        seconds.append(time.perf_counter() - start)
    return worlds, seconds


def drift(world: SettledWorld) -> float:
    """How far a block goes in a second beside the robot, at most, in [mm]."""
    scene = scene_of(world.world)
    with Simulator(scene) as simulator:
        simulator.settle(1.0)
        after = simulator.scene()
    return 1000 * max(float(np.linalg.norm(box.position - scene.box(box.name).position)) for box in after.boxes)


def physics(seed: int, count: int, how: str) -> dict[str, float]:
    """What becomes of worlds as they are composed: shares of blocks and of worlds, and metres."""
    rng = np.random.default_rng([seed, 7])
    blocks, fallen, stable, depth, seconds, away = 0, 0, 0, 0.0, 0.0, []
    for number in range(count):
        scene = scene_of(compose_world(rng, f"w{number}").layout.world)
        settled = settle(scene) if how == COMPOSED else push_about(scene, rng)
        blocks += sum(not box.fixed for box in scene.boxes)
        fallen += len(settled.fallen)
        stable += settled.stable
        depth = max(depth, settled.depth)
        seconds += settled.seconds
        away += [
            float(np.linalg.norm(box.position - scene.box(box.name).position))
            for box in settled.scene.boxes
            if not box.fixed
        ]
    return {
        "worlds": count,
        "stable": round(stable / count, 4),
        "blocks fallen": round(fallen / blocks, 4),
        "moved by, median [m]": round(float(np.median(away)), 5),
        "moved by, 95th percentile [m]": round(float(np.quantile(away, 0.95)), 5),
        "deepest penetration [m]": round(depth, 6),
        "simulated, mean [s]": round(seconds / count, 2),
    }


def main() -> int:
    """Read the arguments, measure, print."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--worlds", type=int, default=90, help="of each kind (default: 90)")
    parser.add_argument("--seed", type=int, default=0)
    parser.add_argument("--robot", type=int, default=10, help="worlds of each kind tried with the robot (default: 10)")
    args = parser.parse_args()
    kinds: dict[str, Any] = {}
    for how in (COMPOSED, PUSHED):
        pushed = range(PUSHED_EVERY - 1, PUSHED_EVERY * args.worlds, PUSHED_EVERY)
        numbers = pushed if how == PUSHED else [n for n in range(PUSHED_EVERY * args.worlds) if n not in pushed]
        worlds, seconds = timed(args.seed, numbers[: args.worlds])
        drifts = [drift(world) for world in worlds[: args.robot]]
        kinds[how] = {
            "worlds a second": round(len(worlds) / sum(seconds), 1),
            "seconds a world, median": round(float(np.median(seconds)), 4),
            "seconds a world, 95th percentile": round(float(np.quantile(seconds, 0.95)), 4),
            "drawn again": round(sum(world.tries for world in worlds) / len(worlds) - 1, 4),
            "objects, mean": round(float(np.mean([len(world.world.things) for world in worlds])), 1),
            "with the robot, moves at most [mm]": round(max(drifts, default=0.0), 3),
            "physics": physics(args.seed, args.worlds, how),
        }
    report = {"seed": args.seed, "processors": os.cpu_count(), "python": platform.python_version(), "kinds": kinds}
    json.dump(report, sys.stdout, indent=2)
    print()
    return 0


if __name__ == "__main__":
    sys.exit(main())

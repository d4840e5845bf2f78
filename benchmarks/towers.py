"""Towers: is a block that is not on top picked, after what stands on it was set aside? Prints JSON.

    python benchmarks/towers.py --episodes 60 --seed 0

Every world has a tower of 2 to 4 blocks, a little askew, among 4 to 12 others; any block of it but the top one is
picked through the executor, and judged by where everything really ended.
"""

from __future__ import annotations

import argparse
import json
import sys
from collections import Counter
from typing import Any

import numpy as np

from grounding.result import GroundedAction, Grounding
from grounding.world import World, make_object
from integration.benchmark.measures import distribution, machine
from integration.execute.executor import Executor
from integration.worlds_and_scenes import scene_of
from motion import stacked_on
from motion.polygons import overlap
from motion.poses import about, quaternion

_TABLE = make_object("table", "table", "white", (0.65, 0.0, 0.691), size=(0.7, 1.8, 0.04))
_TOP = 0.711
_ASKEW, _GAP = 0.004, 0.03
_LIFTED = 0.09


def main() -> int:
    """The command line."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--episodes", type=int, default=60)
    parser.add_argument("--seed", type=int, default=0)
    args = parser.parse_args()
    records = []
    for number in range(args.episodes):
        records.append(episode(args.seed, number))
        print(f"{number + 1} of {args.episodes}: {records[-1]['outcome']}", file=sys.stderr)
    print(json.dumps(summarised(records), indent=1))
    return 0


def episode(seed: int, number: int) -> dict[str, Any]:
    """One tower, one pick."""
    rng = np.random.default_rng([seed, number, 7])
    world, target = _drawn(rng)
    scene = scene_of(world)
    above = [box.name for box in stacked_on(scene, target)]
    action = GroundedAction("pick", (target,), 1.0, None)
    report = Executor(seed=number).execute(Grounding("a known goal", "grounded", (action,)), world)
    truth = report.truth
    others = [box for box in scene.boxes if not box.fixed and box.name not in (target, *above)]
    moved = max(truth[box.name].distance(box.pose)[0] for box in others)
    lifted = float(truth[target].position[2] - scene.box(target).position[2])
    held = report.state is not None and target in report.state.held.values()
    table = scene.box("table")
    aside = all(abs(truth[name].position[2] - scene.box(name).size[2] / 2 - table.top) < 0.003 for name in above)
    return {
        "episode": number,
        "above": len(above),
        "outcome": report.outcome,
        "message": report.message,
        "success": bool(held and lifted > _LIFTED and moved <= 0.005 and aside and report.outcome == "done"),
        "false_success": bool(report.outcome == "done" and not (held and lifted > _LIFTED and moved <= 0.005)),
        "bystander_mm": round(1000 * moved, 3),
        "contacts": sorted({pair for phase in report.records for pair in phase.contacts}),
        "simulated_seconds": round(sum(step.simulated for step in report.steps), 2),
    }


def summarised(records: list[dict[str, Any]]) -> dict[str, Any]:
    """Shares and failures."""
    return {
        "episodes": len(records),
        "succeeded": sum(record["success"] for record in records),
        "false_successes": sum(record["false_success"] for record in records),
        "outcomes": dict(Counter(record["outcome"] for record in records)),
        "blocks_above": dict(Counter(record["above"] for record in records)),
        "bystander_mm": distribution(record["bystander_mm"] for record in records),
        "with_unintended_contact": sum(bool(record["contacts"]) for record in records),
        "simulated_seconds": distribution(record["simulated_seconds"] for record in records),
        "failures": [record for record in records if not record["success"]],
        "machine": machine(),
    }


def _drawn(rng: np.random.Generator) -> tuple[World, str]:
    edge = float(rng.choice((0.04, 0.05)))
    x, y = float(rng.uniform(0.5, 0.7)), float(rng.uniform(-0.55, 0.55))
    height = int(rng.integers(2, 5))
    blocks = []
    for level in range(height):
        place = (x + rng.uniform(-_ASKEW, _ASKEW), y + rng.uniform(-_ASKEW, _ASKEW), _TOP + edge * (level + 0.5))
        blocks.append(_block(f"t{level}", place, rng, edge))
    wanted = height + int(rng.integers(4, 13))
    while len(blocks) < wanted:
        place = (float(rng.uniform(0.42, 0.76)), float(rng.uniform(-0.75, 0.75)), _TOP + edge / 2)
        world = World((_TABLE, *blocks, _block(f"b{len(blocks)}", place, rng, edge)))
        boxes = scene_of(world).boxes
        if all(overlap(boxes[-1].footprint, box.footprint) < -_GAP for box in boxes[1:-1]):
            blocks = list(world.objects[1:])
    return World((_TABLE, *blocks)), f"t{int(rng.integers(height - 1))}"


def _block(name: str, place: tuple[float, float, float], rng: np.random.Generator, edge: float) -> Any:
    turn = quaternion(about((0, 0, 1), rng.uniform(-np.pi, np.pi)))
    return make_object(name, "block", "red", place, turn, (edge, edge, edge))


if __name__ == "__main__":
    sys.exit(main())

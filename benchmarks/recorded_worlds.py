"""The worlds of a corpus: is every block picked that a hand can reach? Prints JSON.

    python benchmarks/recorded_worlds.py CORPUS [--shift -0.25] [--simulate]

CORPUS is a folder of the paper's XML files. For every block of every world that nothing stands on, a pick is planned
(and with --simulate carried out); a block "in reach" is one that some hand grasps where nothing stands around it.
"""

from __future__ import annotations

import argparse
import json
import sys
import time
from collections import Counter
from pathlib import Path
from typing import Any

import numpy as np

from grounding.corpus.loading import load_corpus
from grounding.corpus.rss_world import shifted
from integration.benchmark.random_worlds import reached
from integration.worlds_and_scenes import scene_of
from motion import MotionError, Scene, Simulator, plan_pick


def main() -> int:
    """The command line."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("corpus", type=Path)
    parser.add_argument("--shift", type=float, default=-0.25, help="move the table along x, in metres")
    parser.add_argument("--simulate", action="store_true", help="carry every pick out as well")
    args = parser.parse_args()
    worlds = load_corpus(args.corpus).worlds
    blocks: list[dict[str, Any]] = []
    for number, (name, world) in enumerate(sorted(worlds.items()), start=1):
        blocks += measured(scene_of(shifted(world, args.shift)), name, args.simulate)
        print(f"{number} of {len(worlds)} worlds, {len(blocks)} blocks", file=sys.stderr)
    print(json.dumps(summarised(blocks, len(worlds)), indent=1))
    return 0


def measured(scene: Scene, world: str, simulate: bool) -> list[dict[str, Any]]:
    """One record a block."""
    records = []
    for box in scene.boxes:
        if box.fixed:
            continue
        record: dict[str, Any] = {"world": world, "block": box.name, "covered": bool(scene.boxes_above(box.name))}
        start = time.process_time()
        try:
            plan = plan_pick(scene, box.name, rng=np.random.default_rng(0))
        except MotionError as error:
            record |= {"picked": False, "error": type(error).__name__, "message": str(error)[:200]}
            record["reach"] = reached(scene, box.name, [box.pose])
        else:
            record |= {"picked": True, "error": None, "reach": True}
            if simulate:
                with Simulator(scene) as simulator:
                    simulator.execute(plan)
                    record["picked"] = box.name in simulator.holding(plan.arm)
        record["planning_ms"] = 1000 * (time.process_time() - start)
        records.append(record)
    return records


def summarised(blocks: list[dict[str, Any]], worlds: int) -> dict[str, Any]:
    """Shares and reasons."""
    free = [block for block in blocks if not block["covered"]]
    reach = [block for block in free if block["reach"]]
    times = [block["planning_ms"] for block in blocks]
    return {
        "worlds": worlds,
        "blocks": len(blocks),
        "covered": len(blocks) - len(free),
        "picked": sum(block["picked"] for block in blocks),
        "picked_of_uncovered": round(sum(block["picked"] for block in free) / max(1, len(free)), 4),
        "in_reach": len(reach),
        "picked_of_those_in_reach": round(sum(block["picked"] for block in reach) / max(1, len(reach)), 4),
        "errors": dict(Counter(block["error"] for block in blocks if block["error"])),
        "planning_processor_ms": {
            "median": round(float(np.median(times)), 1), "p99": round(float(np.percentile(times, 99)), 1)
        },
        "not_picked": [block for block in free if not block["picked"]],
    }  # fmt: skip


if __name__ == "__main__":
    sys.exit(main())

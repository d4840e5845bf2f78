"""Places asked for in words: is "put A beside B" done, and does A really stand there in the end? Prints JSON.

    python benchmarks/places.py --count 60 --seed 0

Of the shipped scenes, twelve ordered pairs of the nearest, farthest, leftmost and rightmost block, and five relations,
so many instructions are drawn and run. Who is right is judged by where everything really ended. With `--exhaustive`,
what was understood and not done is tried once more by a search: every centimetre around B that fits the relation, eight
headings, either hand; what that finds was possible.
"""

from __future__ import annotations

import argparse
import itertools
import json
import sys
import time
from collections import Counter
from typing import Any

import numpy as np

import models
from grounding import load_world
from grounding.world import World
from integration.benchmark.measures import distribution, machine
from integration.execute.executor import Executor
from integration.execute.report import Report
from integration.worlds_and_scenes import scene_of
from motion import InvalidGoal, MotionError, plan_place

RELATIONS: dict[str, tuple[int, int] | None] = {
    "to the left of": (0, 1), "to the right of": (0, -1), "in front of": (-1, 0), "behind": (1, 0), "next to": None
}  # fmt: skip
_BLOCKS = ("nearest", "farthest", "leftmost", "rightmost")
_FARTHEST = 0.35  # between the middles of two blocks that stand beside each other [m]
_UNMOVED = 0.01
_STEP, _HEADINGS = 0.01, 8


def main() -> int:
    """The command line."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--count", type=int, default=60, help="so many are drawn (540 are all there are)")
    parser.add_argument("--seed", type=int, default=0)
    parser.add_argument("--exhaustive", action="store_true", help="search for what could have been done")
    args = parser.parse_args()
    scenes = sorted(path.stem for path in models.SCENES.glob("*.json"))
    every = list(itertools.product(scenes, itertools.permutations(_BLOCKS, 2), RELATIONS))
    drawn = np.random.default_rng(args.seed).permutation(len(every))[: args.count]
    executor = Executor()
    records = []
    for index in drawn:
        scene, (moved, other), relation = every[index]
        text = f"put the {moved} block {relation} the {other} block"
        records.append({"scene": scene, "text": text} | judged(executor, scene, text, relation, args.exhaustive))
        print(f"{len(records)} of {len(drawn)}: {records[-1]['outcome']}", file=sys.stderr)
    print(json.dumps(summarised(records), indent=1))
    return 0


def judged(executor: Executor, scene: str, text: str, relation: str, exhaustive: bool) -> dict[str, Any]:
    """One instruction, run and judged."""
    world = load_world(models.SCENES / f"{scene}.json")
    start = time.process_time()
    report = executor.run(text, world)
    taken = time.process_time() - start
    record: dict[str, Any] = {"outcome": report.outcome, "reason": report.reason, "seconds": round(taken, 3)}
    if report.outcome == "done":
        record["true"] = _true(report, world, relation)
        action = report.grounding.actions[0]
        goal, best = np.array(report.handled[-1].goal), np.array(action.destination.position)  # type: ignore[union-attr]
        record["aside"] = round(float(np.linalg.norm(goal - best)), 4)
    elif report.grounding.actions:
        record["message"] = report.message
        if exhaustive:
            record["possible"] = _possible(report, world, relation)
    return record


def _fits(relation: str, off: np.ndarray, edge: float) -> bool:
    """Whether what lies `off`, (2,) in [m], from something stands in a relation to it."""
    way = RELATIONS[relation]
    near = float(np.linalg.norm(off)) <= _FARTHEST
    if way is None:
        return near
    ahead, aside = float(off @ way), abs(float(off @ way[::-1]))
    return near and ahead > 0.5 * edge and aside < ahead


def _true(report: Report, world: World, relation: str) -> bool:
    """Whether the block really stands where it was to go, and all else where it was."""
    action = report.grounding.actions[0]
    assert action.destination is not None
    name, (other,) = action.objects[0], action.destination.reference
    off = report.truth[name].position[:2] - world[other].position[:2]
    still = all(
        np.linalg.norm(report.truth[item.id].position - item.position) < _UNMOVED
        for item in world.things
        if item.id not in {done.object for done in report.handled}
    )
    return still and _fits(relation, off, float(world[other].size[0]))


def _possible(report: Report, world: World, relation: str) -> bool:
    """Whether any place and heading that fits the relation can be served at all."""
    action = report.grounding.actions[0]
    assert action.destination is not None
    name, scene = action.objects[0], scene_of(world)
    if not action.destination.reference:
        return False
    other = world[action.destination.reference[0]]
    line = np.arange(-_FARTHEST, _FARTHEST + 1e-9, _STEP)
    for off in sorted(itertools.product(line, line), key=lambda off: float(np.hypot(*off))):
        if not _fits(relation, np.array(off), float(other.size[0])):
            continue
        try:
            place = scene.resting_position(name, other.position[:2] + off)
        except InvalidGoal:
            continue
        for yaw in np.arange(_HEADINGS) * np.pi / 2 / _HEADINGS:
            try:
                plan_place(scene, name, place, yaw=float(yaw))
            except MotionError:
                continue
            return True
    return False


def summarised(records: list[dict[str, Any]]) -> dict[str, Any]:
    """Counts, shares and times."""
    tried = [record for record in records if record["outcome"] != "not_grounded"]
    done = [record for record in tried if record["outcome"] == "done"]
    refused = [record["seconds"] for record in tried if record["outcome"] == "no_plan"]
    return {
        "machine": machine(),
        "instructions": len(records),
        "asked or not understood": len(records) - len(tried),
        "done": len(done),
        "truly": sum(record["true"] for record in done),
        "done of what was understood": round(len(done) / max(len(tried), 1), 4),
        "reasons": dict(Counter(str(record["reason"]) for record in tried if record["outcome"] != "done")),
        "aside from the best place [m]": distribution([record["aside"] for record in done]),
        "seconds, done": distribution([record["seconds"] for record in done]),
        "seconds, refused": distribution(refused) if refused else None,
        "not done": [record for record in tried if record["outcome"] != "done"],
        "untrue": [record for record in done if not record["true"]],
    }


if __name__ == "__main__":
    sys.exit(main())

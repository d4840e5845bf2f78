"""Instructions through the executor: how many were understood, done and checked, and how long they took, as JSON.

    python benchmarks/episodes.py [--instructions FILE.jsonl] [--seed N] [--gold]

A line of the file has `scene`, `instruction`, `action`, `objects` and, for a place, `relation` and `reference`. With
`--gold` the expected goals are executed instead of the ones that the words are grounded to: that measures motion alone.
"""

from __future__ import annotations

import argparse
import json
import platform
import statistics
import sys
import time
from pathlib import Path
from typing import Any

from grounding import Destination, GroundedAction, Grounder, Grounding, World
from integration.execute.executor import Executor
from integration.execute.report import DONE, Report
from integration.run import load_scene

INSTRUCTIONS = Path(__file__).resolve().parents[1] / "tests" / "integration" / "instructions.jsonl"


def main() -> None:
    """Run the episodes and print the result."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--instructions", type=Path, default=INSTRUCTIONS)
    parser.add_argument("--seed", type=int, default=0)
    parser.add_argument("--gold", action="store_true", help="execute the expected goals")
    args = parser.parse_args()
    lines = [json.loads(line) for line in args.instructions.read_text(encoding="utf-8").splitlines() if line.strip()]
    grounder = None if args.gold else Grounder.load()
    executor = Executor(grounder, seed=args.seed)
    episodes = [episode(executor, line, args.gold) for line in lines]
    print(json.dumps({"summary": summarised(episodes), "machine": machine(), "episodes": episodes}, indent=1))


def episode(executor: Executor, expected: dict[str, Any], gold: bool = False) -> dict[str, Any]:
    """One instruction: what was expected, what was understood, and what became of it."""
    world = load_scene(expected["scene"])
    start = time.perf_counter()
    text = expected["instruction"]
    report = executor.execute(gold_of(expected, world), world) if gold else executor.run(text, world)
    seconds = time.perf_counter() - start
    print(f"{expected['scene']}: {expected['instruction']}: {report.outcome}", file=sys.stderr)
    return {
        "scene": expected["scene"],
        "instruction": text,
        "expected": expected["objects"],
        "understood": [action.to_json() for action in report.grounding.actions],
        "grounding_outcome": report.grounding.outcome,
        "right": is_right(report.grounding, expected),
        "outcome": report.outcome,
        "message": report.message,
        "checks": {f"{check.name} {check.object}".strip(): check.passed for check in report.checks},
        "seconds": round(seconds, 3),
        "grounding_milliseconds": round(report.grounding.milliseconds, 3),
        "planning_seconds": _seconds(report, "plan "),
        "simulated_seconds": round(sum(step.simulated for step in report.steps), 3),
    }


def is_right(grounding: Grounding, expected: dict[str, Any]) -> bool:
    """Whether the one action that was understood is the one that was expected."""
    if grounding.outcome != "grounded" or len(grounding.actions) != 1:
        return False
    action = grounding.actions[0]
    if action.action != expected["action"] or set(action.objects) != set(expected["objects"]):
        return False
    if expected["action"] != "place":
        return True
    place = action.destination
    return place is not None and (place.relation, set(place.reference)) == (
        expected["relation"],
        set(expected["reference"]),
    )


def gold_of(expected: dict[str, Any], world: World) -> Grounding:
    """The expected goals as a grounding; places are on top of the highest object of their reference."""
    to = None
    if expected["action"] == "place":
        below = max((world[name] for name in expected["reference"]), key=lambda item: float(item.position[2]))
        block = world[expected["objects"][0]]
        x, y, z = (float(value) for value in below.position)
        top = z + float(below.half_extents[2] + block.half_extents[2])
        to = Destination((x, y, top), expected["relation"], tuple(expected["reference"]))
    action = GroundedAction(expected["action"], tuple(expected["objects"]), 1.0, to)
    return Grounding(expected["instruction"], "grounded", (action,))


def summarised(episodes: list[dict[str, Any]]) -> dict[str, Any]:
    """Counts and times of all episodes."""
    right = [item for item in episodes if item["right"]]
    return {
        "instructions": len(episodes),
        "right": len(right),
        "done": sum(item["outcome"] == DONE for item in episodes),
        "right_and_done": sum(item["outcome"] == DONE for item in right),
        "median_seconds": round(statistics.median(item["seconds"] for item in episodes), 3),
        "median_grounding_milliseconds": round(
            statistics.median(item["grounding_milliseconds"] for item in episodes), 3
        ),
        "median_planning_seconds": round(statistics.median(item["planning_seconds"] for item in episodes), 3),
        "failures": [
            f"{item['scene']}: {item['instruction']}: "
            + (f"{item['outcome']}: {item['message']}" if item["right"] else f"understood {item['understood']}")
            for item in episodes
            if not (item["right"] and item["outcome"] == DONE)
        ],
    }


def machine() -> dict[str, str]:
    """What the times were measured on."""
    return {"python": platform.python_version(), "processor": platform.machine(), "system": platform.system()}


def _seconds(report: Report, prefix: str) -> float:
    return round(sum(step.seconds for step in report.steps if step.name.startswith(prefix)), 4)


if __name__ == "__main__":
    main()

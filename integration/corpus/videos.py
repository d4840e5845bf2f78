"""Short videos of instructions of a corpus being picked, placed and cleared: real plans, simulated and checked.

What is carried out is what the annotation says, so that a video shows the meaning and not a grounder's guess. The first
instruction of each slot whose plan is found and whose checks pass is recorded.
"""

from __future__ import annotations

import json
import sys
from collections.abc import Sequence
from pathlib import Path
from typing import Any

import numpy as np

from grounding.corpus.format import Example, example_from_json
from grounding.destinations import find_destination
from grounding.experiments.progress import Progress
from grounding.result import Destination, GroundedAction, Grounding
from grounding.symbols import Action
from grounding.world import World, world_from_json, world_to_json
from integration.benchmark.random_worlds import reached
from integration.corpus.settings import INDEX, VIDEOS, Folder, Settings
from integration.corpus.settled_worlds import SettledWorld
from integration.execute.executor import Executor
from integration.execute.report import DONE
from integration.show.video import Recording
from integration.workers import Workers
from integration.worlds_and_scenes import scene_of
from motion import Pose, rendering_available

ACTIONS = ("pick", "place", "clear")
LONGEST = {"pick": 1, "place": 1, "clear": 2}
"""Of so many objects at most."""
SHORT = 15.0
"""A video shows at most so many simulated seconds."""
_CANDIDATES = 24  # instructions that are tried for one video


def make_videos(
    folder: Folder, settings: Settings, items: Sequence[dict[str, Any]], worlds: Sequence[SettledWorld],
    workers: Workers,
) -> int:  # fmt: skip
    """Record the videos that are missing, and write their index; how many there are.

    Args:
        folder: of the corpus.
        settings: of the corpus.
        items: its instructions, as `Sentences` has them.
        worlds: all of them.
        workers: who work.

    Raises:
        UsageError: a part is damaged or cannot be written.
        WorkFailed: a process died.
    """
    if not settings.videos:
        return 0
    if not rendering_available():
        print("note: no videos, because no OpenGL starts here; install the Debian package libegl1 or libosmesa6 and "
              "run the same command again", file=sys.stderr)  # fmt: skip
        return 0
    known = {world.name: world.world for world in worlds}
    slots = slots_of(items, settings.videos)
    names = [f"videos-{k:02d}" for k in range(len(slots))]
    missing = [k for k, name in enumerate(names) if not folder.complete(name, VIDEOS, "video")]
    tasks = []
    for k in missing:
        action, lines = slots[k]
        told = [(line, world_to_json(known[line["world"]])) for line in lines]
        tasks.append((str(folder.path / VIDEOS), f"{k:02d}-{action}.gif", action, told, settings.seed))
    bar = Progress(len(missing), "videos")
    for place, entries in workers.run(make_video, tasks):
        folder.keep(names[missing[place]], entries)
        bar.step("".join(entry["id"] for entry in entries))
    entries = [entry for name in names for entry in folder.items(name)]
    if len(entries) < settings.videos:
        print(f"note: {len(entries)} of {settings.videos} videos: too few of the instructions can be carried out; more "
              "instructions give more", file=sys.stderr)  # fmt: skip
    if entries:
        folder.write(f"{VIDEOS}/{INDEX}", json.dumps(entries, indent=1, ensure_ascii=False) + "\n")
    return len(entries)


def slots_of(items: Sequence[dict[str, Any]], count: int) -> list[tuple[str, list[dict[str, Any]]]]:
    """For each video the action that it shows, and lines of examples to try, one a world: first of its own worlds."""
    actions = [ACTIONS[slot % len(ACTIONS)] for slot in range(count)]
    numbers = {name: k for k, name in enumerate(dict.fromkeys(item["example"]["world"] for item in items))}
    slots = []
    for slot, action in enumerate(actions):
        same = [k for k in range(count) if actions[k] == action]
        fitting = [item["example"] for item in items
                   if item["action"] == action and item["example"]["outcome"] == "grounded"]  # fmt: skip
        own = [line for line in _one_a_world(fitting) if numbers[line["world"]] % count == slot]
        rest = [line for line in _one_a_world(fitting) if numbers[line["world"]] % count not in same]
        slots.append((action, [*own, *rest[same.index(slot) :: len(same)]][:_CANDIDATES]))
    return slots


def _one_a_world(lines: Sequence[dict[str, Any]]) -> list[dict[str, Any]]:
    return list({line["world"]: line for line in reversed(lines)}.values())[::-1]


def make_video(
    folder: str, name: str, action: str, told: Sequence[tuple[dict[str, Any], dict[str, Any]]], seed: int
) -> list[dict[str, Any]]:
    """Record the first instruction that can be carried out, for processes that share the work.

    Args:
        folder: where the video is written.
        name: of its file.
        action: that it shows.
        told: lines of examples with their worlds.
        seed: of all chance.

    Returns:
        its entry in the index, or nothing.
    """
    for line, data in told:
        world = world_from_json(data, line["world"])
        example = example_from_json(line, {line["world"]: world})
        goal = goal_of(example, world, action)
        if goal is None or not _within_reach(goal, world):
            continue
        grounding = Grounding(example.instruction, "grounded", (goal,))
        executor = Executor(object(), seed=seed)  # type: ignore[arg-type]  # it has no words to ground
        tried = executor.execute(grounding, world)
        if tried.outcome != DONE or sum(step.simulated for step in tried.steps) > SHORT:
            continue
        path = Path(folder) / name
        with Recording(scene_of(world), path) as recording:
            report = executor.execute(grounding, world, watch=recording)
        if report.outcome != DONE:
            path.unlink(missing_ok=True)
            continue
        arms = sorted({item.arm for item in report.handled})
        return [{"video": name, "id": example.id, "world": example.world, "instruction": example.instruction,
                 "action": goal.to_json(), "arms": arms, "outcome": report.outcome, "message": report.message,
                 "simulated_seconds": round(sum(step.simulated for step in report.steps), 2)}]  # fmt: skip
    return []


def goal_of(example: Example, world: World, kind: str) -> GroundedAction | None:
    """The goal by the annotation of an example, if it is one action of that kind on few objects.

    Args:
        example: annotated.
        world: that it is in.
        kind: pick, place or clear.
    """
    actions = [symbol for symbol in example.groundings[0] if isinstance(symbol, Action) and symbol.objects]
    if len(actions) != 1 or actions[0].kind != kind or len(actions[0].objects) > LONGEST[kind]:
        return None
    objects, region = actions[0].objects, actions[0].destination
    to: Destination | None = None
    if kind == "place":
        to = None if region is None else find_destination(region, objects, world)
        if to is None:
            return None
    return GroundedAction(kind, objects, 1.0, to)


def _within_reach(goal: GroundedAction, world: World) -> bool:
    """Tells whether some hand would reach everything if nothing stood around it; a quick look before planning."""
    scene = scene_of(world)
    for name in goal.objects:
        box = scene.box(name)
        places = [box.pose]
        if goal.destination is not None and name == goal.objects[0]:
            places.append(Pose(np.array(goal.destination.position), box.orientation))
        if not reached(scene, name, places):
            return False
    return True

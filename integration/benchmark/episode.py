"""One episode of the benchmark: carried out by the executor, judged by where everything really ended."""

from __future__ import annotations

import time
from collections.abc import Mapping
from typing import Any

import numpy as np

import motion
from grounding.result import Grounding
from integration.benchmark.fault_cases import FAULTY_KINDS, FaultCase, draw_fault, fault_name, recoverable, told
from integration.benchmark.random_worlds import KINDS, Episode, draw_episode
from integration.benchmark.spoken_goals import draw_spoken
from integration.execute.checks import AT_GOAL, UNMOVED
from integration.execute.distances import distances_outside
from integration.execute.executor import Executor
from integration.execute.report import DONE, Report
from integration.execute.setting_aside import region_of
from integration.execute.stage import Watch
from integration.worlds_and_scenes import scene_of
from motion import Plan, Pose, Scene
from motion.robot.recipe import recipe

_LIFTED = 0.06
_LIFT_PHASES = ("home", "pregrasp", "approach", "close", "lift")


def run_episode(
    seed: int, number: int, faults: bool = False, language: bool = False, *, watch: Watch | None = None
) -> dict[str, Any]:
    """Carry an episode out; the record depends on the seed and the number alone, but for what clocks measured.

    Args:
        seed: of the benchmark.
        number: of the episode.
        faults: whether something goes wrong in it.
        language: whether the goal is given in words.
        watch: called with the simulator after every step of physics.
    """
    episode = prepared(seed, number, faults, language)
    text = draw_spoken(seed, number)[1] if language else "a known goal"
    case = draw_fault(seed, episode) if faults else FaultCase()
    planner = _Recorder()
    executor = Executor(seed=number, planner=planner, faults=case.faults, sensor=case.sensor)
    start, processor = time.perf_counter(), time.process_time()
    if language:
        report = executor.run(text, episode.world, watch=watch)
    else:
        report = executor.execute(Grounding(text, "grounded", episode.actions), episode.world, watch)
    spent = time.perf_counter() - start, time.process_time() - processor
    return _record(episode, case, report, planner, spent, text if language else None)


def prepared(seed: int, number: int, faults: bool, language: bool) -> Episode:
    """The world and the goal of an episode."""
    if language:
        return draw_spoken(seed, number)[0]
    kinds = FAULTY_KINDS if faults else KINDS
    return draw_episode(seed, number, leaning=faults and fault_name(number) == "leaning", kinds=kinds)


class _Recorder:
    """Motion's planner, with a note of every plan and of the time it took."""

    def __init__(self) -> None:
        self.plans: list[Plan] = []
        self.milliseconds: list[float] = []
        self.processor: list[float] = []

    def plan_pick(self, scene: Scene, target: str, **options: Any) -> Plan:
        """A plan of a pick."""
        (plan,) = self._noted(lambda: (motion.plan_pick(scene, target, **options),))
        return plan

    def plan_transport(self, scene: Scene, target: str, position: Any, **options: Any) -> tuple[Plan, ...]:
        """Plans of a place."""
        return self._noted(lambda: motion.plan_transport(scene, target, position, **options))

    def _noted(self, plan: Any) -> tuple[Plan, ...]:
        start, processor = time.perf_counter(), time.process_time()
        try:
            plans: tuple[Plan, ...] = plan()
        finally:
            self.milliseconds.append(1000 * (time.perf_counter() - start))
            self.processor.append(1000 * (time.process_time() - processor))
        self.plans += plans
        return plans


def _record(
    episode: Episode, case: FaultCase, report: Report, planner: _Recorder, spent: tuple[float, float], text: str | None
) -> dict[str, Any]:
    """Everything about an episode as plain values."""
    measured = _judged(episode, report)
    success = bool(measured["at_goal"]) and measured["bystander_mm"] <= 1000 * UNMOVED
    reported = report.outcome == DONE
    moving = [step for step in report.steps if step.simulated]
    record: dict[str, Any] = {
        "episode": episode.number,
        "kind": episode.kind,
        "blocks": sum(item.type == "block" for item in episode.world.objects),
        "objects": list(episode.actions[0].objects),
        "fault": case.name,
        "injected": told(case.faults) + ([repr(case.sensor)] if not case.sensor.exact else []),
        "outcome": report.outcome,
        "reason": report.reason,
        "message": report.message,
        "incidents": [incident.kind for incident in report.incidents],
        "success": success and reported,
        "false_success": reported and not success,
        **measured,
        "contacts": sorted({pair for phase in report.records for pair in phase.contacts}),
        "tracking_error_rad": round(max((phase.tracking_error for phase in report.records), default=0.0), 5),
        "limit_use": {name: round(value, 4) for name, value in _limit_use(planner.plans).items()},
        "lifted_seconds": _lifted_seconds(planner.plans) if episode.kind == "pick" else None,
        "simulated_seconds": round(sum(step.simulated for step in report.steps), 3),
        "timings": {
            "planning_ms": [round(value, 2) for value in planner.milliseconds],
            "planning_processor_ms": [round(value, 2) for value in planner.processor],
            "simulating_seconds": round(sum(step.seconds for step in moving), 4),
            "seconds": round(spent[0], 3),
            "processor_seconds": round(spent[1], 3),
        },
    }
    if text is not None:
        record["instruction"] = text
        record["understood"] = [action.to_json() for action in report.grounding.actions]
    if case.name != "none":
        record["recoverable"] = success or (bool(report.truth) and recoverable(episode, case, dict(report.truth)))
        record["stopped_safe"] = not reported and not record["contacts"]
    return record


def _judged(episode: Episode, report: Report) -> dict[str, Any]:
    """Judges by the true poses at the end whether the goal is met, by how much it is missed, and who else moved."""
    action, before = episode.actions[0], scene_of(episode.world)
    poses: Mapping[str, Pose] = report.truth or {box.name: box.pose for box in before.boxes}
    exempt = {*action.objects, "leaning"}
    shifts = [poses[box.name].distance(box.pose)[0] for box in before.boxes if not box.fixed and box.name not in exempt]
    goals = {item.object: np.array(item.goal) for item in report.handled if item.object in action.objects}
    if action.destination is not None:
        goals[action.objects[0]] = np.array(action.destination.position)
    errors = [
        float(np.linalg.norm(poses[name].position - goals[name])) if name in goals else np.inf
        for name in action.objects
    ]
    met = max(errors) <= AT_GOAL
    if action.action == "pick":
        name = action.objects[0]
        lowest = max(box.top for box in before.boxes if box.fixed) + before.box(name).half_extents[2]
        risen = poses[name].position[2] - lowest
        met = met and risen > _LIFTED and report.state is not None and name in report.state.held.values()
    elif action.action == "clear":
        region = region_of(before, action.objects)
        met = met and all(distances_outside(region, poses[name].position[:2])[0] > 0 for name in action.objects)
    return {
        "at_goal": bool(met),
        "error_mm": round(1000 * max(errors), 3) if np.isfinite(max(errors)) else None,
        "bystander_mm": round(1000 * max(shifts, default=0.0), 3),
    }


def _lifted_seconds(plans: list[Plan]) -> float | None:
    """Simulated seconds from home to the lifted block by the first plan."""
    if not plans:
        return None
    return round(sum(phase.duration for phase in plans[0].phases if phase.name in _LIFT_PHASES), 3)


def _limit_use(plans: list[Plan]) -> dict[str, float]:
    """The largest share of the limits that any sample of any plan uses."""
    limits = recipe().limits
    use = {"velocity": 0.0, "acceleration": 0.0, "jerk": 0.0}
    for plan in plans:
        for phase in plan.phases:
            path = phase.trajectory
            rates = {"velocity": path.velocities, "acceleration": path.accelerations}
            if len(path.positions) > 1:
                rates["jerk"] = np.diff(path.accelerations, axis=0) / path.period
            for name, values in rates.items():
                use[name] = max(use[name], float(np.max(np.abs(values) / getattr(limits, name))))
    return use

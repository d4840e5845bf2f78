"""The figures of a benchmark: from records of episodes to one summary."""

from __future__ import annotations

import os
import platform
from collections import Counter
from collections.abc import Iterable, Sequence
from typing import Any

import numpy as np

_LISTED = 40


def summarised(records: Sequence[dict[str, Any]]) -> dict[str, Any]:
    """All figures of the records of episodes."""
    done = [record for record in records if record["success"]]
    picks = [record for record in records if record["kind"] == "pick"]
    summary: dict[str, Any] = {
        "episodes": len(records),
        "succeeded": len(done),
        "success_rate": _share(len(done), len(records)),
        "false_successes": sum(record["false_success"] for record in records),
        "by_kind": _by(records, "kind"),
        "by_blocks": _by([{**record, "size": _size(record["blocks"])} for record in records], "size"),
        "outcomes": dict(Counter(str(record["outcome"]) for record in records)),
        "planning_ms": _planning_of(records, picks, "planning_ms"),
        "planning_processor_ms": _planning_of(records, picks, "planning_processor_ms"),
        "position_error_mm": distribution(r["error_mm"] for r in done if r["kind"] != "pick"),
        "lifted_error_mm": distribution(r["error_mm"] for r in done if r["kind"] == "pick"),
        "bystander_mm": distribution(record["bystander_mm"] for record in records),
        "tracking_error_rad": distribution(record["tracking_error_rad"] for record in records),
        "limit_use_largest": {
            name: max((record["limit_use"][name] for record in records), default=0.0)
            for name in ("velocity", "acceleration", "jerk")
        },
        "episodes_with_unintended_contact": sum(bool(record["contacts"]) for record in records),
        "home_to_lifted_seconds": distribution(r["lifted_seconds"] for r in picks if r["lifted_seconds"] is not None),
        "simulated_seconds": distribution(record["simulated_seconds"] for record in records),
        "times_real_time": distribution(
            record["simulated_seconds"] / record["timings"]["simulating_seconds"]
            for record in records
            if record["timings"]["simulating_seconds"] > 0
        ),
        "times_real_time_by_processor": distribution(
            record["simulated_seconds"] / (timings["processor_seconds"] - sum(timings["planning_processor_ms"]) / 1000)
            for record in records
            if "processor_seconds" in (timings := record["timings"])
        ),
    }
    if any(record["fault"] != "none" for record in records):
        summary["faults"] = _of_faults(records)
    if any("instruction" in record for record in records):
        summary["understood"] = sum(_understood(record) for record in records)
    summary["failures"] = [_failure(record) for record in records if not record["success"]][:_LISTED]
    return summary


def distribution(values: Iterable[float]) -> dict[str, float]:
    """Count, median, 95th and 99th percentile and largest."""
    array = np.array(list(values), dtype=float)
    if not len(array):
        return {"count": 0}
    shares = {"median": 50, "p95": 95, "p99": 99, "max": 100}
    return {"count": len(array), **{name: round(float(np.percentile(array, q)), 3) for name, q in shares.items()}}


def machine() -> dict[str, Any]:
    """The machine that the times were measured on."""
    return {
        "python": platform.python_version(),
        "processor": platform.machine(),
        "system": platform.system(),
        "cores": os.cpu_count(),
    }


def _of_faults(records: Sequence[dict[str, Any]]) -> dict[str, Any]:
    """Outcomes of the episodes in which something went wrong."""
    possible = [record for record in records if record["recoverable"]]
    unmet = [record for record in records if not record["success"]]
    return {
        "recoverable": len(possible),
        "recovered": sum(record["success"] for record in possible),
        "recovered_rate": _share(sum(record["success"] for record in possible), len(possible)),
        "others": len(records) - len(possible),
        "stopped_safe": sum(bool(record["stopped_safe"]) for record in unmet),
        "not_stopped_safe": sum(not record["stopped_safe"] for record in unmet),
        "by_fault": {
            name: {
                "episodes": len(group),
                "recoverable": sum(record["recoverable"] for record in group),
                "succeeded": sum(record["success"] for record in group),
                "noticed": sum(bool(record["incidents"]) for record in group),
            }
            for name, group in _groups(records, "fault")
        },
    }


def _by(records: Sequence[dict[str, Any]], key: str) -> dict[str, Any]:
    return {
        str(name): {"episodes": len(group), "succeeded": sum(record["success"] for record in group)}
        for name, group in _groups(records, key)
    }


def _groups(records: Sequence[dict[str, Any]], key: str) -> list[tuple[Any, list[dict[str, Any]]]]:
    names = sorted({record[key] for record in records})
    return [(name, [record for record in records if record[key] == name]) for name in names]


def _size(blocks: int) -> str:
    low = 4 * ((blocks - 1) // 4) + 1
    return f"{low:02d} to {low + 3:02d} blocks"


def _planning_of(records: Sequence[dict[str, Any]], picks: Sequence[dict[str, Any]], key: str) -> dict[str, Any]:
    """Times of planning by the clock on the wall or by the processor's, of plans that failed too."""

    def values(chosen: Iterable[dict[str, Any]]) -> dict[str, float]:
        return distribution(value for record in chosen for value in record["timings"].get(key, ()))

    return {
        "picks": values(picks),
        "picks_among_10_to_14": values(record for record in picks if 10 <= record["blocks"] <= 14),
        "others": values(record for record in records if record["kind"] != "pick"),
    }


def _understood(record: dict[str, Any]) -> bool:
    return any(action["objects"] == record["objects"] for action in record["understood"])


def _failure(record: dict[str, Any]) -> dict[str, Any]:
    keys = ("episode", "kind", "fault", "outcome", "reason", "message", "incidents", "recoverable", "stopped_safe")
    return {key: record[key] for key in keys if key in record}


def _share(part: int, whole: int) -> float | None:
    return round(part / whole, 4) if whole else None

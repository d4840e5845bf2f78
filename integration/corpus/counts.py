"""Counts of what a generated corpus holds."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable, Sequence
from typing import Any

import numpy as np

from integration.corpus.instructions import Sentences
from integration.corpus.settled_worlds import SettledWorld


def counted(sentences: Sentences, worlds: Sequence[SettledWorld]) -> dict[str, Any]:
    """Counts of instructions by outcome, action and construction, and of worlds.

    Args:
        sentences: all of them.
        worlds: all of them.
    """
    items = sentences.items
    grounded = [item for item in items if item["example"]["outcome"] == "grounded"]
    return {
        "instructions": len(items),
        "wordings": len(sentences.taken),
        "held_out": sum(item["held_out"] for item in items),
        "dropped": sentences.dropped,
        "outcomes": _counts(item["example"]["outcome"] for item in items),
        "actions": _counts(item["action"] or "none" for item in grounded),
        "constructions": _counts(name for item in items for name in item["constructions"]),
        "worlds": {
            "count": len(worlds),
            "how": _counts(world.how for world in worlds),
            "drawn": sum(world.tries for world in worlds),
            "objects": _spread([len(world.world.things) for world in worlds]),
            "colors": _spread([len({item.color for item in world.world.things}) for world in worlds]),
            "with_speaker": sum(world.world.speaker is not None for world in worlds),
        },
    }


def _counts(names: Iterable[str]) -> dict[str, int]:
    """The most frequent first."""
    return dict(sorted(Counter(names).items(), key=lambda pair: (-pair[1], pair[0])))


def _spread(values: Sequence[int]) -> dict[str, float]:
    return {"least": min(values), "median": float(np.median(values)), "most": max(values)}

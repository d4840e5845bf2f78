"""How well instructions that people wrote are understood, with slices, as JSON.

    python benchmarks/people.py SET.jsonl WORLDS.json [--wrong N]

SET has a line for each instruction: {"id", "world", "instruction", "history"?, "gold": {"object", "destination"?},
"human_accuracy"?}. Object: the only action handles exactly the gold object; questions and refusals count as wrong. Best
guess: the same for the likeliest reading, asked or answered. Destinations are measured in block lengths; a missing one
counts as staying. Calibration: expected calibration error of the answers, ten bins. Times are of the processor.

Slices: texts that relate what is meant to other things; with one modifier or several; with zero, one, more words that
the grammar does not know; texts that most people resolve; targets amid others of their colour.
"""

from __future__ import annotations

import argparse
import json
import statistics
import sys
import time
from collections import Counter
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np

from grounding.grounder import Grounder, Understanding
from grounding.language.tree import Phrase
from grounding.lexicon import words as w
from grounding.meaning.nouns import read_noun
from grounding.result import Grounding
from grounding.world import World, load_worlds

_NEAR = 2.0  # [block lengths]: what lies so near to another of its colour is amid them
_THINGS = ("block", "container")


@dataclass(frozen=True)
class Line:
    """One instruction and what became of it.

    Attributes:
        given: the line of the set.
        understood: how it was read.
        result: the answer.
        milliseconds: of the processor.
        world: in which.
    """

    given: dict[str, Any]
    understood: Understanding
    result: Grounding
    milliseconds: float
    world: World

    @property
    def right(self) -> bool:
        """Whether the answer handles the gold object."""
        return bool(self.result.actions) and self.result.actions[0].objects == (self.given["gold"]["object"],)

    @property
    def guessed(self) -> bool:
        """Whether the likeliest reading handles the gold object."""
        listed = (*self.result.actions, *self.result.alternatives)
        return bool(listed) and listed[0].objects == (self.given["gold"]["object"],)


def main() -> None:
    """Ground every line, score, slice."""
    parser = argparse.ArgumentParser(description=(__doc__ or "").splitlines()[0])
    parser.add_argument("set", type=Path)
    parser.add_argument("worlds", type=Path)
    parser.add_argument("--wrong", type=int, default=0, metavar="N", help="show N that are wrong on standard error")
    args = parser.parse_args()
    worlds = load_worlds(args.worlds)
    grounder = Grounder.load()
    lines = []
    for text in args.set.read_text(encoding="utf-8").splitlines():
        given = json.loads(text)
        world, history = worlds[given["world"]], tuple(given.get("history") or ())
        start = time.process_time()
        result = grounder.ground(given["instruction"], world, history)
        spent = 1000 * (time.process_time() - start)
        understood = grounder.understand(given["instruction"], world, history)
        lines.append(Line(given, understood, result, spent, world))
    for line in [line for line in lines if not line.right][: args.wrong]:
        print(line.given["id"], line.result.outcome, line.given["instruction"], file=sys.stderr)
    report = {**_scores(lines), "slices": {name: _scores(kept, brief=True) for name, kept in _slices(lines).items()}}
    print(json.dumps(report))


def _scores(lines: list[Line], *, brief: bool = False) -> dict[str, Any]:
    answered = [line for line in lines if line.result.outcome == "grounded"]
    scores: dict[str, Any] = {
        "instructions": len(lines),
        "object": _share(line.right for line in lines),
        "answered": _share(line.result.outcome == "grounded" for line in lines),
        "object of the answered": _share(line.right for line in answered),
        "best guess": _share(line.guessed for line in lines),
    }
    people = [line.given["human_accuracy"] for line in lines if line.given.get("human_accuracy") is not None]
    if people:
        scores["people"] = round(statistics.fmean(people), 4)
    if brief:
        return scores
    scores["calibration error"] = _calibration(answered)
    scores["outcomes"] = dict(Counter(line.result.outcome for line in lines))
    scores["milliseconds"] = round(statistics.median(line.milliseconds for line in lines), 2)
    moved = [line for line in lines if line.given["gold"].get("destination") is not None]
    if moved:
        scores["destinations"] = _destinations(moved)
    return scores


def _share(values: Any) -> float | None:
    found = list(values)
    return round(sum(found) / len(found), 4) if found else None


def _calibration(lines: list[Line]) -> float | None:
    bins: list[list[tuple[float, bool]]] = [[] for _ in range(10)]
    for line in lines:
        probability = line.result.actions[0].probability
        bins[min(int(probability * 10), 9)].append((probability, line.right))
    gaps = sum(abs(sum(p for p, _ in b) - sum(r for _, r in b)) for b in bins)
    return round(gaps / len(lines), 4) if lines else None


def _destinations(lines: list[Line]) -> dict[str, Any]:
    errors, given = [], []
    for line in lines:
        item = line.world[line.given["gold"]["object"]]
        target = np.array(line.given["gold"]["destination"])
        place = line.result.actions[0].destination if line.result.actions else None
        error = float(np.linalg.norm((item.position if place is None else np.array(place.position)) - target))
        errors.append(error / float(item.size[0]))
        if place is not None:
            given.append(errors[-1])
    return {
        "given": len(given), "median of the given": round(statistics.median(given), 3) if given else None,
        "median": round(statistics.median(errors), 3), "within one": _share(error <= 1 for error in errors),
    }  # fmt: skip


def _slices(lines: list[Line]) -> dict[str, list[Line]]:
    tests: dict[str, Callable[[Line], bool]] = {
        "related": lambda line: _relates(line.understood.parses[0].tree),
        "not related": lambda line: not _relates(line.understood.parses[0].tree),
        "one modifier": lambda line: _modifiers(line.understood.parses[0].tree) <= 1,
        "several modifiers": lambda line: _modifiers(line.understood.parses[0].tree) > 1,
        "no unknown word": lambda line: not line.understood.parses[0].unknown_words,
        "one unknown word": lambda line: len(line.understood.parses[0].unknown_words) == 1,
        "more unknown words": lambda line: len(line.understood.parses[0].unknown_words) > 1,
        "most people right": lambda line: (line.given.get("human_accuracy") or 0) >= 0.6,
        "amid its colour": lambda line: _amid(line.world, line.given["gold"]["object"]),
    }
    found = {name: [line for line in lines if test(line)] for name, test in tests.items()}
    return {name: kept for name, kept in found.items() if kept}


def _relates(tree: Phrase) -> bool:
    """Whether a modifier within a text relates to another thing."""
    for phrase in tree.preorder():
        if phrase.tag not in ("PP", "SBAR", "S", "VP"):
            continue
        texts = [word.text for word in phrase.words]
        named = any(
            w.is_between(t) or w.is_surrounded(t) or w.is_touching(t) or w.is_beside(t) or w.directions(t) or
            w.distance(t) or t in ("behind", "of", "with", "under") for t in texts
        )  # fmt: skip
        if named and any(p.tag == "NP" and read_noun(p).head in _THINGS for p in phrase.phrases):
            return True
    return False


def _modifiers(tree: Phrase) -> int:
    return sum(phrase.tag in ("PP", "SBAR") for phrase in tree.preorder())


def _amid(world: World, name: str) -> bool:
    item = world[name]
    others = [o for o in world.objects if o.type == item.type and o.color == item.color and o.id != name]
    reach = _NEAR * float(item.size[0])
    return sum(float(np.linalg.norm(o.position - item.position)) <= reach for o in others) > 0


if __name__ == "__main__":
    main()

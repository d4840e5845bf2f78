"""`python -m grounding ground`: one instruction and a world to goals."""

from __future__ import annotations

import argparse
import json
from pathlib import Path
from typing import Any

import models
from grounding.commands import SUMMARIES
from grounding.result import GroundedAction, Grounding
from grounding.world import load_world

NOT_GROUNDED = 3


def add_arguments(subparsers: Any) -> None:
    """Add the parser of `ground`."""
    parser = subparsers.add_parser("ground", help=SUMMARIES["ground"], description=SUMMARIES["ground"])
    parser.add_argument("text", help="the instruction")
    parser.add_argument("--world", type=Path, default=models.SCENES / "default.json", metavar="FILE",
                        help="world file (default: the default scene)")  # fmt: skip
    parser.add_argument("--explain", action="store_true", help="show what every phrase was taken to mean")
    parser.add_argument("--json", action="store_true", help="print the result as JSON")


def run(args: argparse.Namespace) -> int:
    """Ground the instruction; exit code 3 when there is nothing to do."""
    from grounding.grounder import Grounder  # loaded late: other commands do not need it

    world = load_world(args.world)
    result = Grounder.load().ground(args.text, world)
    if args.json:
        print(json.dumps(result.to_json()))
    else:
        print("\n".join(describe(result, args.explain)))
    return 0 if result.outcome == "grounded" else NOT_GROUNDED


def describe(result: Grounding, explain: bool) -> list[str]:
    """The lines that tell a person what was understood."""
    lines = [f"{result.outcome}: {result.explanation}" if result.explanation else result.outcome]
    lines += [f"  {_action(action)}" for action in result.actions]
    if result.question:
        lines.append(f"  {result.question}")
    if result.alternatives:
        lines.append("  other readings:" if result.actions else "  readings:")
        lines += [f"    {_action(action)}" for action in result.alternatives]
    if result.unknown_words:
        lines.append(f"  unknown words: {', '.join(result.unknown_words)}")
    if explain:
        for phrase in result.phrases:
            told = ", ".join(f"{symbol} {probability:.2f}" for symbol, probability in phrase.groundings) or "nothing"
            lines.append(f"  {'  ' * phrase.depth}{phrase.tag} {phrase.text!r}: {told}")
    return lines


def _action(action: GroundedAction) -> str:
    where = ""
    if action.destination is not None:
        x, y, z = action.destination.position
        where = f" to ({x:.3f}, {y:.3f}, {z:.3f}) m"
        if action.destination.relation is not None:
            where += f", {action.destination.relation} of {' '.join(action.destination.reference) or 'the robot'}"
    return f"{action.action} {' '.join(action.objects)}{where}  ({action.probability:.2f})"

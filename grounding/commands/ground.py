"""`python -m grounding ground`: one instruction and a world to goals."""

from __future__ import annotations

import argparse
import json
import sys
from pathlib import Path
from typing import Any

import models
from grounding.commands import SUMMARIES
from grounding.errors import PictureError
from grounding.result import GroundedAction, Grounding
from grounding.world import load_world

NOT_GROUNDED = 3
PICTURES = (".png", ".jpg", ".jpeg")


def add_arguments(subparsers: Any) -> None:
    """Add the parser of `ground`."""
    parser = subparsers.add_parser("ground", help=SUMMARIES["ground"], description=SUMMARIES["ground"])
    parser.add_argument("text", help="the instruction")
    parser.add_argument("--world", type=Path, default=models.SCENES / "default.json", metavar="FILE",
                        help="world file (default: the default scene)")  # fmt: skip
    parser.add_argument("--explain", action="store_true",
                        help="tell what every phrase was taken for, what spoke for it, what lost and why")  # fmt: skip
    parser.add_argument("--picture", type=Path, metavar="FILE.png",
                        help="draw what every phrase weighs, from above; with or without --explain")  # fmt: skip
    parser.add_argument("--json", action="store_true", help="print the result as JSON")


def run(args: argparse.Namespace) -> int:
    """Ground the instruction; exit code 3 when there is nothing to do."""
    from grounding.grounder import Grounder  # loaded late: other commands do not need it

    world = load_world(args.world)
    if not (args.explain or args.picture):
        result = Grounder.load().ground(args.text, world)
        print(json.dumps(result.to_json()) if args.json else "\n".join(describe(result)))
        return _code(result)
    from grounding.explanations import explain, told

    picture = None if args.picture is None else _picture_file(args.picture)
    result, explanation = explain(Grounder.load(), args.text, world)
    if picture is not None:
        from grounding.explanations.picture import draw_explanation

        draw_explanation(world, result, explanation).save(picture)
        print(f"picture: {picture}", file=sys.stderr)
    if args.json:
        more = {"explanation": explanation.to_json()} if args.explain else {}
        print(json.dumps({**result.to_json(), **more}))
    else:
        print("\n".join([*describe(result), *(told(explanation, bool(result.actions)) if args.explain else ())]))
    return _code(result)


def _code(result: Grounding) -> int:
    return 0 if result.outcome in ("grounded", "answered") else NOT_GROUNDED


def _picture_file(path: Path) -> Path:
    """Where a picture is written, checked before anything is computed.

    Raises:
        PictureError: it is no PNG or JPEG file, or its folder is not there.
    """
    if path.suffix.lower() not in PICTURES:
        raise PictureError(f"{path}: a picture is written as {' or '.join(PICTURES)}")
    if path.is_dir() or not path.parent.is_dir():
        raise PictureError(f"{path}: {'is a folder' if path.is_dir() else 'its folder does not exist'}")
    return path


def describe(result: Grounding) -> list[str]:
    """The lines that tell a person what was understood."""
    told = result.answer or result.explanation
    lines = [f"{result.outcome}: {told}" if told else result.outcome]
    lines += [f"  {_action(action)}" for action in result.actions]
    if result.question:
        lines.append(f"  {result.question}")
    if result.alternatives:
        lines.append("  other readings:" if result.actions else "  readings:")
        lines += [f"    {_action(action)}" for action in result.alternatives]
    if result.mended:
        lines.append(f"  read as: {', '.join(f'{written} as {read}' for written, read in result.mended)}")
    if result.unknown_words:
        lines.append(f"  unknown words: {', '.join(result.unknown_words)}")
    return lines


def _action(action: GroundedAction) -> str:
    where = ""
    if action.destination is not None:
        x, y, z = action.destination.position
        where = f" to ({x:.3f}, {y:.3f}, {z:.3f}) m"
        if action.destination.relation is not None:
            where += f", {action.destination.relation} of {' '.join(action.destination.reference) or 'the robot'}"
    hand = "" if action.arm is None else f" with the {action.arm} hand"
    return f"{action.action} {' '.join(action.objects)}{where}{hand}  ({action.probability:.2f})"

"""`python -m motion reach`: the reach map of a table as a picture, or what it says of one place."""

from __future__ import annotations

import argparse
import json
import sys
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from motion.commands import SUMMARIES
from motion.commands.finite_numbers import finite, positive
from motion.errors import InvalidGoal
from motion.robot.state import ARMS

if TYPE_CHECKING:
    from motion.grasp.reach_map import ReachMap
    from motion.scene import Box

_TABLE = (0.65, 0.0, 0.691, 0.7, 1.8, 0.04)
_BLOCK = 50.0


def add_arguments(subparsers: Any) -> None:
    """Add the parser of `reach`."""
    parser = subparsers.add_parser(
        "reach",
        help=SUMMARIES["reach"],
        description="Which hand takes a block where on the table, and how far it must tilt. Without --at a picture of "
        "all of the table; with it, what is possible there. A map is made once (a minute) and kept.",
    )
    parser.add_argument("--at", nargs=2, type=finite, metavar=("X", "Y"), help="ask for one place, metres")
    parser.add_argument("--block", type=positive, default=_BLOCK, metavar="MM",
                        help="edge of the cube, millimetres (default: 50)")  # fmt: skip
    parser.add_argument("--table", nargs=6, type=finite, default=_TABLE, metavar=("X", "Y", "Z", "L", "W", "H"),
                        help="the table's centre and edges, metres (default: 0.65 0 0.691 0.7 1.8 0.04)")  # fmt: skip
    parser.add_argument("--spacing", type=positive, default=0.05, metavar="M", help="of the grid (default: 0.05)")
    parser.add_argument("--output", type=Path, default=Path("output/reach.png"), metavar="FILE",
                        help="where the picture goes (default: output/reach.png)")  # fmt: skip
    parser.add_argument("--json", action="store_true", help="print the answer as JSON")


def run(args: argparse.Namespace) -> int:
    """Make or read the map, and answer."""
    from motion.grasp.reach_map import reach_map
    from motion.poses import frozen
    from motion.scene import Box

    edge = args.block / 1000
    table = Box("table", frozen(args.table[:3]), size=frozen(args.table[3:]), fixed=True)
    if args.at is None and args.output.suffix.lower() not in (".png", ".jpg", ".jpeg", ".webp"):
        raise InvalidGoal(f"{args.output}: a picture's name ends with .png, .jpg or .webp")
    reach = reach_map(table, (edge, edge, edge), spacing=args.spacing)
    answer = _of_place(reach, table, edge, *args.at) if args.at else _of_table(reach, args.output)
    if args.json:
        json.dump(answer, sys.stdout, indent=2)
        print()
        return 0
    print(answer["text"])
    return 0


def _of_place(reach: ReachMap, table: Box, edge: float, x: float, y: float) -> dict[str, Any]:
    """The map's answer for a place.

    Raises:
        UnreachableTarget: no hand reaches it, with the reason.
    """
    ways = reach.at(x, y)
    place = f"({x:.3f}, {y:.3f})"
    if not ways:
        from motion.grasp.reach import reach_box
        from motion.poses import frozen
        from motion.scene import Box, Scene

        block = Box("the block there", frozen((x, y, table.top + edge / 2)), size=frozen((edge,) * 3))
        reach_box(Scene((table, block)), block.name)  # the map is a grid: near its boundary a place may be within reach
        return {"x": x, "y": y, "ways": [], "text": f"At {place}: only just, and only from some turns of the block."}
    lines = [
        f"  {way.arm} hand, tilted by {np.degrees(way.tilt):.0f} degrees: {100 * way.share:.0f} % of the block's turns"
        for way in ways
    ]
    listed = [{"arm": way.arm, "tilt": round(way.tilt, 4), "share": round(way.share, 3)} for way in ways]
    return {"x": x, "y": y, "ways": listed, "text": "\n".join([f"At {place}:", *lines])}


def _of_table(reach: ReachMap, output: Path) -> dict[str, Any]:
    """Draws the map, and says how much of the table is within reach."""
    from motion.grasp.reach_picture import reach_picture

    output.parent.mkdir(parents=True, exist_ok=True)
    reach_picture(reach).save(output)
    within = reach.hands() > 0
    shares = {arm: round(float(within[side].mean()), 3) for side, arm in enumerate(ARMS)}
    either, upright = float(within.any(axis=0).mean()), float((reach.share[:, 0] > 0).any(axis=0).mean())
    text = (
        f"Of the table, {100 * either:.0f} % is within reach of a hand ({100 * upright:.0f} % from straight above), "
        f"{100 * shares['left']:.0f} % of the left one and {100 * shares['right']:.0f} % of the right one.\n"
        f"Picture: {output}"
    )
    return {"within_reach": {**shares, "either": round(either, 3), "from_above": round(upright, 3)},
            "picture": str(output), "text": text}  # fmt: skip

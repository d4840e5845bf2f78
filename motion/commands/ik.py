"""`python -m motion ik`: joints that bring a hand's tool frame to a pose."""

from __future__ import annotations

import argparse
import json
import sys
from typing import Any

from motion.commands import SUMMARIES
from motion.commands.finite_numbers import finite

_DOWN = (0.0, 0.0, 1.0, 0.0)


def add_arguments(subparsers: Any) -> None:
    """Add the parser of `ik`."""
    parser = subparsers.add_parser("ik", help=SUMMARIES["ik"], description=SUMMARIES["ik"])
    parser.add_argument("arm", help="left or right")
    parser.add_argument("position", nargs=3, type=finite, metavar=("X", "Y", "Z"), help="of the tool frame, metres")
    parser.add_argument("--orientation", nargs=4, type=finite, default=_DOWN, metavar=("W", "X", "Y", "Z"),
                        help="unit quaternion (default: pointing down)")  # fmt: skip
    parser.add_argument("--solver", default="lm", help="lm, or a QP solver for mink: daqp, osqp, ... (default: lm)")
    parser.add_argument("--json", action="store_true", help="print the answer as JSON")


def run(args: argparse.Namespace) -> int:
    """Solve and print."""
    from motion.ik.solver import solve_ik
    from motion.poses import Pose, frozen
    from motion.robot.load import load_robot

    solution = solve_ik(args.arm, Pose(frozen(args.position), frozen(args.orientation)), solver=args.solver)
    names = load_robot().arm(args.arm).joints
    joints = {name: round(float(value), 6) for name, value in zip(names, solution.joints, strict=True)}
    if args.json:
        errors = {"position_error": solution.position_error, "orientation_error": solution.orientation_error}
        json.dump({"joints": joints, **errors, "attempts": solution.attempts}, sys.stdout, indent=2)
        print()
        return 0
    for name, value in joints.items():
        print(f"{name:9} {value:9.4f} rad")
    left = 1e6 * solution.position_error, 1e6 * solution.orientation_error
    print(f"left over: {left[0]:.1f} micrometres, {left[1]:.1f} microradians")
    return 0

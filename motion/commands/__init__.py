"""The subcommands of `python -m motion`, one module each, imported only when asked for.

A module has `add_arguments(subparsers)`, which adds its parser under the module's name, and `run(args)`, which returns
the exit code. Errors of `MotionError` and `OSError` are left to `motion.__main__`.
"""

SUMMARIES = {
    "reach": "which hand takes a block where on the table, and how far tilted",
    "ik": "joints that bring a hand to a pose, or the reason why none do",
}

"""`python -m integration.run TEXT`: ground an instruction, carry it out in MuJoCo, check it, and show what happened.

Exit codes: 0 done and checked; 2 bad usage or file; 3 not grounded; 4 no plan; 5 executed, but the check failed; 130
after Ctrl-C. Standard output is for the answer, standard error for everything else.
"""

from __future__ import annotations

import argparse
import json
import os
import sys
from collections.abc import Sequence
from contextlib import ExitStack, contextmanager, nullcontext
from pathlib import Path
from typing import TYPE_CHECKING, Any, NoReturn

from integration.arguments import BAD_INPUT, INTERRUPTED, OneLineParser, whole_number
from integration.interrupts import Interrupts

if TYPE_CHECKING:
    from collections.abc import Iterator

    from grounding.world import World
    from integration.execute.report import Report

BROKEN_PIPE = 141  # as a shell reports SIGPIPE
SCENES = Path(__file__).resolve().parents[1] / "models" / "scenes"


def main(argv: Sequence[str] | None = None) -> int:
    """Run the command.

    Args:
        argv: its arguments; those of the process by default.

    Returns:
        the exit code.
    """
    interrupts = Interrupts()
    try:
        with interrupts:
            code = _run(_arguments(argv), interrupts)
            sys.stdout.flush()
        return INTERRUPTED if interrupts.seen else code
    except SystemExit as exit_:
        return exit_.code if isinstance(exit_.code, int) else BAD_INPUT
    except KeyboardInterrupt:
        print("interrupted", file=sys.stderr)
        return INTERRUPTED
    except BrokenPipeError:
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())  # the interpreter flushes once more at exit
        return BROKEN_PIPE
    except _expected() as error:
        print(f"error: {' '.join(str(error).split())}", file=sys.stderr)
        return BAD_INPUT


def _arguments(argv: Sequence[str] | None) -> argparse.Namespace:
    parser = OneLineParser(
        "python -m integration.run", description="Have Baxter do what an instruction says, and check it."
    )
    parser.add_argument("text", metavar="TEXT", help="the instruction, such as 'pick up the nearest block'")
    parser.add_argument("--scene", default="default", help=f"a world file, or one of {', '.join(scene_names())}")
    parser.add_argument("--arm", default="auto", choices=("auto", "left", "right"), help="which arm is to do it")
    parser.add_argument(
        "--seed", type=whole_number, default=0, help="of all chance; the same seed, the same run (default: 0)"
    )
    parser.add_argument("--view", action="store_true", help="show the simulation in a window")
    parser.add_argument("--video", type=Path, metavar="FILE", help="record the simulation: a .gif, or an .mp4")
    parser.add_argument("--json", action="store_true", help="write the whole report as JSON")
    parser.add_argument("--output", type=Path, default=Path("output"), metavar="DIR", help="where pictures are written")
    parser.add_argument("--no-pictures", action="store_true", help="draw no pictures")
    return parser.parse_args(argv)


def scene_names() -> tuple[str, ...]:
    """The scenes that can be named."""
    return tuple(sorted(path.stem for path in SCENES.glob("*.json")))


def load_scene(name: str) -> World:
    """The world of a scene by its name, or of a world file.

    Raises:
        UsageError: there is neither.
        WorldError: the file is not as it should be.
    """
    from grounding import load_world
    from integration.errors import UsageError

    if name in scene_names():
        return load_world(SCENES / f"{name}.json")
    if Path(name).suffix or Path(name).exists() or os.sep in name:
        return load_world(name)
    raise UsageError(f"there is no scene {name!r}; there are {', '.join(scene_names())}, and world files (.json)")


def _run(args: argparse.Namespace, interrupts: Interrupts) -> int:
    from integration.errors import UsageError

    if not args.text.strip():
        raise UsageError("the instruction is empty; say something like 'pick up the nearest block'")
    world = load_scene(args.scene)
    from integration.execute.startup import started

    with _watching(args, world) as watch:
        executor, loading = started(arm=args.arm, seed=args.seed)
        interrupts.heed()
        grounding, step = executor.ground(args.text, world)
        drawing = None
        if not args.no_pictures:
            from integration.show.pictures import Drawing

            drawing = Drawing(grounding, world, args.output)
        interrupts.heed()
        with drawing or nullcontext():
            report = executor.execute(grounding, world, watch, (loading, step))
            report, hint = (report, None) if drawing is None else drawing.finished(report)
    _show(report, args, hint)
    return report.exit_code


def _show(report: Report, args: argparse.Namespace, hint: str | None) -> None:
    """Writes the answer to standard output, and what else there is to say to standard error."""
    if args.json:
        print(json.dumps(report.to_json(), indent=2))
    else:
        from integration.show.report_text import Style, summary

        print(summary(report, Style.of(sys.stdout)))
    if hint:
        print(f"note: {hint}", file=sys.stderr)
    if args.json and report.exit_code:
        print(f"{report.outcome.replace('_', ' ')}: {' '.join(report.message.split())}", file=sys.stderr)


@contextmanager
def _watching(args: argparse.Namespace, world: World) -> Iterator[Any]:
    """The watcher of the simulation: a recording, a window, both, or none."""
    watchers: list[Any] = []

    def watch(simulator: Any) -> None:
        for watcher in watchers:
            watcher(simulator)

    window = None
    with ExitStack() as stack:
        if args.video is not None:
            from integration.show.video import Recording
            from integration.worlds_and_scenes import scene_of

            watchers.append(stack.enter_context(Recording(scene_of(world), args.video)))
        if args.view:
            from integration.show.viewer import Window
            from integration.worlds_and_scenes import scene_of

            window = Window(scene_of(world))
            watchers.append(window)
        yield watch if watchers else None
    if window is not None:
        print("close the window to go on", file=sys.stderr)
        window.wait()


def _expected() -> tuple[type[BaseException], ...]:
    """The errors that are told in one line; imported late, so that the command starts fast."""
    from grounding.errors import GroundingError
    from integration.errors import IntegrationError
    from motion.errors import MotionError

    return GroundingError, IntegrationError, MotionError, OSError


def _leave(code: int) -> NoReturn:
    """End the process; after an interrupt at once, as compiled modules may still be loading in a thread."""
    if code == INTERRUPTED:
        sys.stdout.flush()
        sys.stderr.flush()
        os._exit(code)
    sys.exit(code)


if __name__ == "__main__":
    _leave(main())

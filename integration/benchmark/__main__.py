"""`python -m integration.benchmark`: random worlds with known goals, end to end; every figure as JSON.

    python -m integration.benchmark --episodes 1000 --seed 0 --jobs 2      # known goals: motion by itself
    python -m integration.benchmark --episodes 300 --faults                # something goes wrong in each
    python -m integration.benchmark --episodes 200 --language              # the goals are given in words
    python -m integration.benchmark --replay 17 --faults --video 17.gif    # one of them once more

Records are kept as they come in; the same command again goes on where the last one stopped. An episode depends on the
seed and its number alone. Exit codes: 0 measured; 2 bad usage or file; 130 after Ctrl-C.
"""

from __future__ import annotations

import argparse
import json
import sys
import time
from collections.abc import Sequence
from pathlib import Path

from integration.arguments import BAD_INPUT, INTERRUPTED, OneLineParser, positive_number, whole_number


def main(argv: Sequence[str] | None = None) -> int:
    """Run the command.

    Args:
        argv: its arguments; those of the process by default.

    Returns:
        the exit code.
    """
    from grounding.errors import GroundingError
    from integration.errors import IntegrationError
    from motion.errors import MotionError

    try:
        args = _arguments(argv)
        if args.replay is not None:
            return _replay(args)
        return _measure(args)
    except SystemExit as exit_:
        return exit_.code if isinstance(exit_.code, int) else BAD_INPUT
    except KeyboardInterrupt:
        print("interrupted; the same command goes on from here", file=sys.stderr)
        return INTERRUPTED
    except (GroundingError, IntegrationError, MotionError, OSError) as error:
        print(f"error: {' '.join(str(error).split())}", file=sys.stderr)
        return BAD_INPUT


def _arguments(argv: Sequence[str] | None) -> argparse.Namespace:
    parser = OneLineParser("python -m integration.benchmark", description="Random worlds with known goals, end to end.")
    parser.add_argument("--episodes", type=positive_number, default=1000, help="how many (default: 1000)")
    parser.add_argument("--seed", type=whole_number, default=0, help="of all chance (default: 0)")
    parser.add_argument(
        "--jobs", type=positive_number, default=1, help="processes that work at the same time (default: 1)"
    )
    parser.add_argument("--faults", action="store_true", help="something goes wrong in every episode")
    parser.add_argument("--language", action="store_true", help="goals are given in words, and grounded")
    parser.add_argument("--output", type=Path, metavar="FILE", help="where records are kept (default: under output/)")
    parser.add_argument("--restart", action="store_true", help="begin anew instead of going on")
    parser.add_argument(
        "--replay", type=whole_number, metavar="EPISODE", help="run one episode once more and print its record"
    )
    parser.add_argument("--video", type=Path, metavar="FILE", help="with --replay: record it, a .gif or an .mp4")
    args = parser.parse_args(argv)
    if args.video is not None and args.replay is None:
        parser.error("--video needs --replay EPISODE")
    if args.faults and args.language:
        parser.error("--faults and --language are measured apart")
    return args


def _measure(args: argparse.Namespace) -> int:
    """Runs what is still to be run and prints the summary."""
    from grounding.experiments.progress import Progress
    from integration.benchmark.episode import run_episode
    from integration.benchmark.measures import machine, summarised
    from integration.benchmark.records import Records
    from integration.workers import Workers
    from motion import load_robot

    settings = {"seed": args.seed, "faults": args.faults, "language": args.language}
    records = Records(args.output or _default_path(args), settings, args.restart)
    load_robot()  # built once, before several processes would each build it
    missing = [number for number in range(args.episodes) if number not in records.done]
    if len(missing) < args.episodes:
        print(f"{args.episodes - len(missing)} of {args.episodes} episodes were there already", file=sys.stderr)
    progress, failed = Progress(len(missing), "episodes"), 0
    start = time.perf_counter()
    tasks = [(args.seed, number, args.faults, args.language) for number in missing]
    try:
        with Workers(args.jobs) as workers:
            for _, record in workers.run(run_episode, tasks):
                records.add(record)
                failed += not record["success"]
                progress.step(f"{failed} without success")
    finally:
        records.close()
    chosen = [records.done[number] for number in range(args.episodes)]
    result = {
        "settings": {**settings, "episodes": args.episodes, "jobs": args.jobs},
        "summary": summarised(chosen),
        "machine": machine(),
        "seconds": round(time.perf_counter() - start, 1),
        "records": str(records.path),
    }
    print(json.dumps(result, indent=1))
    return 0


def _replay(args: argparse.Namespace) -> int:
    """Runs one episode, perhaps with a video, and prints its record."""
    from integration.benchmark.episode import prepared, run_episode

    episode = args.seed, args.replay, args.faults, args.language
    if args.video is None:
        record = run_episode(*episode)
    else:
        from integration.show.video import Recording
        from integration.worlds_and_scenes import scene_of

        with Recording(scene_of(prepared(*episode).world), args.video) as recording:
            record = run_episode(*episode, watch=recording)
        print(f"wrote {args.video}", file=sys.stderr)
    print(json.dumps(record, indent=1))
    return 0


def _default_path(args: argparse.Namespace) -> Path:
    kind = "faults" if args.faults else "language" if args.language else "goals"
    return Path("output") / "benchmark" / f"{kind}-{args.seed}.jsonl"


if __name__ == "__main__":
    sys.exit(main())

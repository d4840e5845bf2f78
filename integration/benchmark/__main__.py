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
import os
import signal
import sys
import time
from collections.abc import Iterator, Sequence
from concurrent.futures import FIRST_COMPLETED, ProcessPoolExecutor, wait
from multiprocessing import get_context
from pathlib import Path
from typing import Any

from integration.arguments import BAD_INPUT, OneLineParser

INTERRUPTED = 130
_REPORTED = 0.1
_THREADS = ("OPENBLAS_NUM_THREADS", "OMP_NUM_THREADS", "MKL_NUM_THREADS")


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
        for name in _THREADS:  # before numpy is imported by the processes that work
            os.environ.setdefault(name, "1")
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
    parser.add_argument("--episodes", type=_positive, default=1000, help="how many (default: 1000)")
    parser.add_argument("--seed", type=_number, default=0, help="of all chance (default: 0)")
    parser.add_argument("--jobs", type=_positive, default=1, help="processes that work at the same time (default: 1)")
    parser.add_argument("--faults", action="store_true", help="something goes wrong in every episode")
    parser.add_argument("--language", action="store_true", help="goals are given in words, and grounded")
    parser.add_argument("--output", type=Path, metavar="FILE", help="where records are kept (default: under output/)")
    parser.add_argument("--restart", action="store_true", help="begin anew instead of going on")
    parser.add_argument(
        "--replay", type=_number, metavar="EPISODE", help="run one episode once more and print its record"
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
    from integration.benchmark.measures import machine, summarised
    from integration.benchmark.records import Records
    from motion import load_robot

    settings = {"seed": args.seed, "faults": args.faults, "language": args.language}
    records = Records(args.output or _default_path(args), settings, args.restart)
    load_robot()  # built once, before several processes would each build it
    missing = [number for number in range(args.episodes) if number not in records.done]
    bar = _Bar(args.episodes, args.episodes - len(missing))
    start = time.perf_counter()
    try:
        for record in _run(missing, args):
            records.add(record)
            bar.step(record["success"])
    finally:
        records.close()
        bar.close()
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


def _run(numbers: Sequence[int], args: argparse.Namespace) -> Iterator[dict[str, Any]]:
    """Records as they come in."""
    if args.jobs == 1 or len(numbers) < 2:
        for number in numbers:
            yield _episode(args.seed, number, args.faults, args.language)
        return
    pool = ProcessPoolExecutor(args.jobs, mp_context=get_context("spawn"), initializer=_heed_no_interrupt)
    try:
        waiting = iter(numbers)
        running = set()
        while True:
            for number in waiting:
                running.add(pool.submit(_episode, args.seed, number, args.faults, args.language))
                if len(running) >= 2 * args.jobs:
                    break
            if not running:
                return
            finished, running = wait(running, return_when=FIRST_COMPLETED)
            for future in finished:
                yield future.result()
    finally:
        pool.shutdown(wait=False, cancel_futures=True)


def _heed_no_interrupt() -> None:
    """Ctrl-C is for the process that hands out the work; what works ends with its episode."""
    signal.signal(signal.SIGINT, signal.SIG_IGN)


def _episode(seed: int, number: int, faults: bool, language: bool) -> dict[str, Any]:
    from integration.benchmark.episode import run_episode

    return run_episode(seed, number, faults=faults, language=language)


def _replay(args: argparse.Namespace) -> int:
    """Runs one episode, perhaps with a video, and prints its record."""
    from integration.benchmark.episode import prepared, run_episode

    recording = None
    if args.video is not None:
        from integration.show.video import Recording
        from integration.worlds_and_scenes import scene_of

        recording = Recording(scene_of(prepared(args.seed, args.replay, args.faults, args.language).world), args.video)
    try:
        record = run_episode(args.seed, args.replay, faults=args.faults, language=args.language, watch=recording)
    except BaseException:
        if recording is not None:
            recording.abandon()
        raise
    if recording is not None:
        recording.close()
        print(f"wrote {args.video}", file=sys.stderr)
    print(json.dumps(record, indent=1))
    return 0


def _default_path(args: argparse.Namespace) -> Path:
    kind = "faults" if args.faults else "language" if args.language else "goals"
    return Path("output") / "benchmark" / f"{kind}-{args.seed}.jsonl"


class _Bar:
    """Progress on standard error: in place on a terminal, a line for every tenth elsewhere."""

    def __init__(self, total: int, done: int) -> None:
        self._total, self._done, self._before = total, done, done
        self._failed, self._start, self._told = 0, time.perf_counter(), done / total
        self._terminal = sys.stderr.isatty()
        if done:
            print(f"{done} of {total} episodes were there already", file=sys.stderr)

    def step(self, success: bool) -> None:
        """One more episode."""
        self._done += 1
        self._failed += not success
        left = (time.perf_counter() - self._start) / (self._done - self._before) * (self._total - self._done)
        text = f"{self._done}/{self._total}, {self._failed} without success, {left / 60:.0f} min left"
        if self._terminal:
            filled = round(30 * self._done / self._total)
            sys.stderr.write(f"\rEpisodes [{'#' * filled}{'.' * (30 - filled)}] {text:<50}")
            sys.stderr.flush()
        elif self._done / self._total >= self._told + _REPORTED:
            self._told = self._done / self._total
            print(f"Episodes {text}", file=sys.stderr, flush=True)

    def close(self) -> None:
        """Ends the line."""
        if self._terminal:
            sys.stderr.write("\n")


def _positive(text: str) -> int:
    value = _number(text)
    if value < 1:
        raise argparse.ArgumentTypeError(f"{text!r} is not a whole number above 0")
    return value


def _number(text: str) -> int:
    try:
        value = int(text)
    except ValueError:
        value = -1
    if value < 0:
        raise argparse.ArgumentTypeError(f"{text!r} is not a whole number from 0 on")
    return value


if __name__ == "__main__":
    sys.exit(main())

"""How long whole commands take from start to exit, each in a process of its own, with warm caches. Prints JSON.

    python benchmarks/startup.py [--repeats N]

Each command is run once before it is measured, so that the robot is built and the files are in memory. "first build" is
the main command with an empty cache folder: the robot is built from its URDF on the way.
"""

from __future__ import annotations

import argparse
import json
import os
import platform
import statistics
import subprocess
import sys
import tempfile
import time
from collections.abc import Mapping
from pathlib import Path
from typing import Any

ROOT = Path(__file__).resolve().parents[1]
TEXT = "pick up the middle block in the row of five blocks on the right"
COMMANDS: Mapping[str, tuple[str, ...]] = {
    "run": ("integration.run", TEXT),
    "run without pictures": ("integration.run", TEXT, "--no-pictures"),
    "run without OpenGL": ("integration.run", TEXT),
    "ground": ("grounding", "ground", TEXT),
}
WITHOUT_OPENGL = {"MUJOCO_GL": "disable"}


def seconds_of(arguments: tuple[str, ...], folder: Path, environment: Mapping[str, str]) -> float:
    """Wall-clock seconds of `python -m ARGUMENTS`, run in `folder`."""
    start = time.perf_counter()
    result = subprocess.run(
        [sys.executable, "-m", *arguments],
        cwd=folder, env={**os.environ, "PYTHONPATH": str(ROOT), **environment}, capture_output=True, text=True,
    )  # fmt: skip
    seconds = time.perf_counter() - start
    if result.returncode:
        raise SystemExit(f"python -m {' '.join(arguments)}: exit code {result.returncode}\n{result.stderr}")
    return seconds


def measured(repeats: int, folder: Path) -> dict[str, Any]:
    """Seconds of every command."""
    found: dict[str, Any] = {}
    for name, arguments in COMMANDS.items():
        environment = WITHOUT_OPENGL if name.endswith("OpenGL") else {}
        seconds_of(arguments, folder, environment)
        times = [seconds_of(arguments, folder, environment) for _ in range(repeats)]
        found[name] = {
            "min": round(min(times), 2),
            "median": round(statistics.median(times), 2),
            "max": round(max(times), 2),
        }
    empty = {"XDG_CACHE_HOME": str(folder / "cache")}
    found["first build"] = {"seconds": round(seconds_of(COMMANDS["run"], folder, empty), 2)}
    return found


def main() -> int:
    """Read the arguments, measure, print."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--repeats", type=int, default=5, help="runs of every command (default: 5)")
    args = parser.parse_args()
    with tempfile.TemporaryDirectory() as folder:
        seconds = measured(args.repeats, Path(folder))
    report = {
        "repeats": args.repeats,
        "processors": os.cpu_count(),
        "python": platform.python_version(),
        "seconds": seconds,
    }
    json.dump(report, sys.stdout, indent=2)
    print()
    return 0


if __name__ == "__main__":
    sys.exit(main())

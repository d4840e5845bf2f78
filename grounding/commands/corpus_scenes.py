"""`python -m grounding corpus scenes`: scenes for people to write about, with a block to pick up and a placing each."""

from __future__ import annotations

import argparse
import json
from collections.abc import Callable
from pathlib import Path
from typing import Any

from grounding.corpus.by_hand import make_scenes, write_scenes
from grounding.errors import CorpusError
from grounding.experiments.progress import Progress


def add_scenes(verbs: Any, count: Callable[[str], int]) -> None:
    """Add the parser of the verb `scenes`; `count` reads a number from 1."""
    scenes = verbs.add_parser("scenes", help="lay and draw scenes for people to write about")
    scenes.add_argument("--count", type=count, default=64, metavar="N", help="so many scenes")
    scenes.add_argument("--seed", type=int, default=0, help="the same one gives the same scenes")
    scenes.add_argument("--output", type=Path, required=True, metavar="DIR", help="folder of worlds, tasks, pictures")


def run_scenes(args: argparse.Namespace) -> int:
    """Lay, draw and write the scenes that were asked for."""
    if args.seed < 0:
        raise CorpusError(f"seed {args.seed}: scenes are made from a seed from 0")
    progress = Progress(args.count, "scenes")
    print(json.dumps(write_scenes(make_scenes(args.count, args.seed), args.output, progress.step)))
    return 0

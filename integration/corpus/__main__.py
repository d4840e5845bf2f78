"""`python -m integration.corpus generate`: worlds settled by physics, annotated instructions, images and videos.

    python -m integration.corpus generate --output output/corpus --instructions 20000 --jobs 2

Finished parts are kept; the same command again goes on where the last one stopped. The corpus depends on the seed and
the counts alone, not on the number of jobs. Standard output is a summary as JSON. Exit codes: 0 generated; 2 bad usage
or file; 130 after Ctrl-C.
"""

from __future__ import annotations

import argparse
import json
import os
import sys
from collections.abc import Sequence
from pathlib import Path

from integration.arguments import BAD_INPUT, INTERRUPTED, OneLineParser, positive_number, whole_number
from integration.interrupts import Interrupts

_A_WORLD = 20  # instructions, if the number of worlds is not told


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

    interrupts = Interrupts()
    try:
        with interrupts:
            args = _arguments(argv)
            code = _generate(args, interrupts)
        return INTERRUPTED if interrupts.seen else code
    except SystemExit as exit_:
        return exit_.code if isinstance(exit_.code, int) else BAD_INPUT
    except KeyboardInterrupt:
        print("\ninterrupted; what is finished is kept, and the same command goes on from here", file=sys.stderr)
        return INTERRUPTED
    except (GroundingError, IntegrationError, MotionError, OSError) as error:
        print(f"error: {' '.join(str(error).split())}", file=sys.stderr)
        return BAD_INPUT


def _generate(args: argparse.Namespace, interrupts: Interrupts) -> int:
    from integration.corpus.generation import generate_corpus
    from integration.corpus.settings import Folder, Settings

    worlds = args.worlds or max(1, args.instructions // _A_WORLD)
    settings = Settings(args.instructions, worlds, args.images, args.videos, args.seed)
    folder = Folder(args.output, settings, args.restart)
    interrupts.heed()
    summary = generate_corpus(folder, settings, args.jobs)
    print(json.dumps(summary, indent=1))
    return 0


def _arguments(argv: Sequence[str] | None) -> argparse.Namespace:
    parser = OneLineParser("python -m integration.corpus", description="Corpora of settled worlds and instructions.")
    verbs = parser.add_subparsers(dest="verb", metavar="VERB", required=True, parser_class=OneLineParser)
    generate = verbs.add_parser("generate", help="generate a corpus", description=__doc__,
                                formatter_class=argparse.RawDescriptionHelpFormatter)  # fmt: skip
    generate.add_argument("--output", type=Path, required=True, metavar="DIR", help="where everything is written")
    generate.add_argument("--instructions", type=positive_number, default=20_000, metavar="N", help="default: 20000")
    generate.add_argument("--worlds", type=positive_number, metavar="N",
                          help="how many are settled (default: one for 20 instructions)")  # fmt: skip
    generate.add_argument("--images", type=whole_number, default=128, metavar="N", help="default: 128")
    generate.add_argument("--videos", type=whole_number, default=8, metavar="N", help="default: 8")
    generate.add_argument("--seed", type=whole_number, default=0, help="of all chance (default: 0)")
    generate.add_argument("--jobs", type=positive_number, default=min(2, os.cpu_count() or 1), metavar="N",
                          help="processes that work at the same time (default: 2)")  # fmt: skip
    generate.add_argument("--restart", action="store_true", help="begin anew instead of going on")
    return parser.parse_args(argv)


if __name__ == "__main__":
    sys.exit(main())

"""`python -m integration.figures`: groundings of phrases drawn over rendered views of their scenes (Figures 6 and 7).

The same figures as `python -m grounding experiments figures` draws as plans. Exit codes: 0 drawn; 2 bad usage or file,
or no OpenGL; 130 after Ctrl-C.
"""

from __future__ import annotations

import argparse
import sys
from collections.abc import Sequence
from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING

from grounding.errors import CorpusErrors, GroundingError
from integration.arguments import BAD_INPUT, INTERRUPTED, positive_number

if TYPE_CHECKING:
    from PIL import Image

    from grounding.experiments.panels import Figure

_SIZE = (860, 580)  # of the view of a panel in pixels


def main(argv: Sequence[str] | None = None) -> int:
    """Run the command.

    Args:
        argv: its arguments; those of the process by default.

    Returns:
        the exit code.
    """
    from integration.errors import IntegrationError
    from motion.errors import MotionError

    try:
        return _run(_arguments(argv))
    except CorpusErrors as error:
        return _refuse(*map(str, error.problems))
    except (GroundingError, IntegrationError, MotionError, OSError) as error:
        return _refuse(str(error))
    except KeyboardInterrupt:
        return INTERRUPTED


def rendered(figure: Figure) -> Image.Image:
    """The phrases of a figure over rendered views of its world.

    Raises:
        RenderingUnavailable: no OpenGL can be started.
        InvalidScene: the world cannot be rendered.
    """
    from grounding.experiments.sheets import nothing, on_sheet
    from integration.show.views import Studio, close_camera

    panels = figure.panels or (nothing(figure),)
    with Studio(figure.world, _SIZE, close_camera(figure.world)) as studio:
        views = [studio.marked(figure.world, panel.marks, "", panel.rows) for panel in panels]
    return on_sheet(replace(figure, panels=panels), views)


def _run(args: argparse.Namespace) -> int:
    from grounding.experiments.figures import CANDIDATES, choose, corpus_figures, own_figures
    from grounding.experiments.progress import Progress
    from grounding.experiments.reading import make_folder, read_corpus

    corpus, whole = read_corpus(args.corpus, args.corrections, args.keep_going, _say)
    make_folder(args.output)
    ids = args.id or choose(corpus, CANDIDATES * args.count)
    figures = (*corpus_figures(corpus, ids, None if args.id else args.count), *own_figures())
    progress = Progress(len(figures), "figures")
    for figure in figures:
        path = args.output / f"{figure.name}_view.png"
        rendered(figure).save(path)
        progress.step(figure.name)
        print(path)
    return 0 if whole else BAD_INPUT


def _arguments(argv: Sequence[str] | None) -> argparse.Namespace:
    parser = argparse.ArgumentParser(
        "python -m integration.figures", description="Groundings of phrases over rendered views of their scenes."
    )
    parser.add_argument("--corpus", type=Path, required=True, metavar="PATH",
                        help="a folder of example_*.xml or a .jsonl file")  # fmt: skip
    parser.add_argument("--output", type=Path, required=True, metavar="DIR", help="where pictures are written")
    parser.add_argument("--corrections", type=Path, metavar="FILE", help="corrections of annotations, applied first")
    parser.add_argument("--id", action="append", metavar="ID", help="an example to draw, may be given several times "
                        "(default: those that show most)")  # fmt: skip
    parser.add_argument("--count", type=positive_number, default=4, metavar="N",
                        help="so many examples of the corpus, where none is named (default: 4)")  # fmt: skip
    parser.add_argument("--keep-going", action="store_true",
                        help="list all that is refused and use the rest; the exit code is 2 all the same")  # fmt: skip
    return parser.parse_args(argv)


def _refuse(*messages: str) -> int:
    for message in messages:
        _say(f"error: {' '.join(message.split())}")
    return BAD_INPUT


def _say(text: str) -> None:
    print(text, file=sys.stderr, flush=True)


if __name__ == "__main__":
    sys.exit(main())

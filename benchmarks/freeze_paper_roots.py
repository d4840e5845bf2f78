"""Writes the single-block roots of the paper's corpus as a set of instructions with the answers that are right.

    python benchmarks/freeze_paper_roots.py CORPUS OUTPUT_DIR

OUTPUT_DIR gets `paper_roots.jsonl` and `paper_roots.worlds.json`, the same bytes whenever the corpus is the same. They
are other people's data and do not belong into the repository.
"""

from __future__ import annotations

import argparse
import json
from pathlib import Path

from instructions import Instruction, instruction_of, write_instructions

from grounding.corpus.format import Corpus
from grounding.corpus.loading import load_corpus

NAME = "paper_roots.jsonl"


def main() -> None:
    """Read, select, write."""
    parser = argparse.ArgumentParser(description=(__doc__ or "").splitlines()[0])
    parser.add_argument("corpus", type=Path, help="folder of example_*.xml")
    parser.add_argument("output", type=Path, metavar="OUTPUT_DIR")
    args = parser.parse_args()
    corpus = load_corpus(args.corpus)
    found = single_roots(corpus)
    write_instructions(found, corpus.worlds, args.output / NAME)
    print(json.dumps({"instructions": len(found), "output": str(args.output / NAME)}))


def single_roots(corpus: Corpus) -> tuple[Instruction, ...]:
    """The instructions whose annotated root means a single block, with it as the answer that is right."""
    found = (instruction_of(example, corpus.worlds[example.world]) for example in corpus.examples)
    return tuple(Instruction(i.id, i.world, i.text, i.history, {"object": i.gold["object"]})
                 for i in found if "object" in i.gold)  # fmt: skip


if __name__ == "__main__":
    main()

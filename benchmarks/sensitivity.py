"""How much depends on each parameter of the concepts, as JSON.

    python benchmarks/sensitivity.py SET.jsonl WORLDS.json [--by SHARE] [--every N] [--only NAME ...]

SET has a line for each instruction, see `benchmarks/instructions.py`. Every parameter of the concepts is made smaller
and larger by SHARE, a quarter by default, within its range. Told are the share of right answers with each, and how many
answers become others: right ones and wrong ones. The weights stay as they are; every N-th instruction is asked.
"""

from __future__ import annotations

import argparse
import json
import sys
from collections.abc import Sequence
from pathlib import Path

from deciders import Remembering
from instructions import Instruction, read_instructions

import models
from grounding.grounder import Grounder
from grounding.language.parser import Parser
from grounding.lexicon.parameters import Parameter, parameters, varied
from grounding.model.storage import load_learned
from grounding.result import Grounding
from grounding.world import World

Answers = list[Grounding]


def answers(grounder: Grounder, kept: Sequence[Instruction], worlds: dict[str, World]) -> Answers:
    """The answers to instructions."""
    return [grounder.ground(i.text, worlds[i.world], i.history) for i in kept]


def right(found: Answers, kept: Sequence[Instruction]) -> float:
    """The share of right answers."""
    return round(sum(i.is_answered_by(one) for i, one in zip(kept, found, strict=True)) / max(len(kept), 1), 4)


def values(parameter: Parameter, share: float) -> tuple[float, float]:
    """A smaller and a larger value, within the range."""
    step = share * abs(parameter.value) if parameter.value else share * (parameter.high - parameter.low)
    return max(parameter.value - step, parameter.low), min(parameter.value + step, parameter.high)


def main() -> None:
    """Vary every parameter, ask everything again, print."""
    parser = argparse.ArgumentParser(description=(__doc__ or "").splitlines()[0])
    parser.add_argument("set", type=Path)
    parser.add_argument("worlds", type=Path)
    parser.add_argument("--by", type=float, default=0.25, metavar="SHARE")
    parser.add_argument("--every", type=int, default=1, metavar="N")
    parser.add_argument("--only", nargs="+", metavar="NAME", choices=sorted(parameters()))
    args = parser.parse_args()
    instructions, worlds = read_instructions(args.set, args.worlds)
    kept = instructions[:: max(args.every, 1)]
    grounder = Grounder(Remembering(Parser.load(models.GRAMMAR)), load_learned(models.BELIEFS))
    before = answers(grounder, kept, worlds)
    as_it_is = right(before, kept)
    found = {}
    for name in args.only or parameters():
        row = {}
        for side, number in zip(("less", "more"), values(parameters()[name], args.by), strict=True):
            with varied(**{name.replace(".", "__"): number}):
                told = answers(grounder, kept, worlds)
            changed = sum(_meant(one) != _meant(other) for one, other in zip(before, told, strict=True))
            row[side] = {"value": round(number, 4), "right": right(told, kept), "changed": changed}
        found[name] = row
        print(f"{name:<28}{row['less']['right']:>8}{row['more']['right']:>8}", file=sys.stderr, flush=True)
    print(json.dumps({"instructions": len(kept), "by": args.by, "right": as_it_is, "parameters": found}))


def _meant(answer: Grounding) -> tuple[str, tuple[tuple[str, ...], ...]]:
    return answer.outcome, tuple(action.objects for action in answer.actions)


if __name__ == "__main__":
    main()

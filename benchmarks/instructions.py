"""Sets of instructions with the answers that are right, as files: `NAME.jsonl` beside `NAME.worlds.json`.

A line holds {"id", "world", "instruction", "history", "gold"}; the worlds file has every world under its name. Gold is
`object` where a single object is meant, `outcome` where the right answer is no action, and may list all `actions` as
[kind, [ids]].
"""

from __future__ import annotations

import json
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from grounding.corpus.format import Example, write_worlds
from grounding.geometry.layout import Layout
from grounding.readings import pick_of
from grounding.result import Grounding
from grounding.symbols import Action
from grounding.world import World, load_worlds

Asked = frozenset[tuple[str, tuple[str, ...]]]


@dataclass(frozen=True, eq=False)
class Instruction:
    """One instruction, its world and the answer that is right.

    Attributes:
        id: its name, unique in a set.
        world: name of the world it was given in.
        text: as it was written.
        history: ids of the objects handled before, the latest last.
        gold: see the module.
    """

    id: str
    world: str
    text: str
    history: tuple[str, ...]
    gold: Mapping[str, Any]

    @property
    def outcome(self) -> str:
        """The outcome that is right."""
        return str(self.gold.get("outcome", "grounded"))

    @property
    def actions(self) -> Asked:
        """The actions that are right, as (kind, ids); none where no action is right, or none are listed."""
        return frozenset((kind, tuple(names)) for kind, names in self.gold.get("actions", ()))

    @property
    def objects(self) -> frozenset[tuple[str, ...]]:
        """What the right actions handle, as ids for each."""
        if self.outcome != "grounded":
            return frozenset()
        return frozenset({(self.gold["object"],)}) if "object" in self.gold else frozenset(o for _, o in self.actions)

    def is_answered_by(self, result: Grounding) -> bool:
        """Whether an answer handles exactly what it should, or has the outcome that is right instead."""
        if self.outcome != "grounded":
            return result.outcome == self.outcome
        return len(result.actions) == len(self.objects) and {a.objects for a in result.actions} == self.objects


def read_instructions(lines: Path, worlds: Path) -> tuple[tuple[Instruction, ...], dict[str, World]]:
    """Read a set and its worlds."""
    found = []
    for line in lines.read_text(encoding="utf-8").splitlines():
        data = json.loads(line)
        found.append(Instruction(data["id"], data["world"], data["instruction"], tuple(data.get("history") or ()),
                                 data["gold"]))  # fmt: skip
    return tuple(found), dict(load_worlds(worlds))


def write_instructions(instructions: Sequence[Instruction], worlds: Mapping[str, World], path: Path) -> None:
    """Write a set as `path`, which ends in .jsonl, and its worlds beside it; the same set gives the same bytes."""
    path.parent.mkdir(parents=True, exist_ok=True)
    lines = [
        {"id": i.id, "world": i.world, "instruction": i.text, "history": list(i.history), "gold": dict(i.gold)}
        for i in instructions
    ]
    path.write_text("".join(json.dumps(line, ensure_ascii=False) + "\n" for line in lines), encoding="utf-8")
    needed = {i.world for i in instructions}
    write_worlds({name: worlds[name] for name in sorted(needed)}, path.with_suffix(".worlds.json"))


def instruction_of(example: Example, world: World) -> Instruction:
    """An annotated example as an instruction with the answer that is right."""
    return Instruction(example.id, example.world, example.instruction, example.history, gold_of(example, world))


def gold_of(example: Example, world: World) -> dict[str, Any]:
    """What the annotation of an example asks for; a noun phrase alone asks to pick up what it means."""
    if example.outcome != "grounded":
        return {"outcome": example.outcome}
    actions = sorted(_actions(example.groundings[0], world))
    gold: dict[str, Any] = {"actions": [[kind, list(names)] for kind, names in actions]}
    handled = {names for _, names in actions}
    if len(handled) == 1 and len(next(iter(handled))) == 1:
        gold = {"object": next(iter(handled))[0], **gold}
    return gold


def _actions(root: Iterable[object], world: World) -> set[tuple[str, tuple[str, ...]]]:
    symbols = frozenset(root)
    asked = {(s.kind, s.objects) for s in symbols if isinstance(s, Action) and s.objects}
    return asked or {(a.kind, a.objects) for a in pick_of(symbols, Layout(world))}  # type: ignore[arg-type]

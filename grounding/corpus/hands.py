"""The corpus of many hands: free texts about drawn scenes, each with the block that it means and where that goes.

`hands.jsonl` holds one text a line; `hands.worlds.json` beside it holds `{"schema": 1, "worlds": {name: world}}`.
"""

from __future__ import annotations

import json
from collections.abc import Callable, Iterable, Iterator, Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from grounding.errors import CorpusError, CorpusErrors, HandsError, WorldError
from grounding.world import SCHEMA, World, load_worlds, world_to_json
from models import HANDS

KINDS = ("rows", "grid", "cluster", "towers", "ring", "clutter", "alike", "mixed")
TASKS = ("pick", "place")
SPLITS = ("train", "dev", "test")
_KEYS = ("id", "world", "instruction", "history", "gold", "manner", "task", "kind", "split")
_FAR = 10.0  # no destination is so far from the origin, in [m]

Place = tuple[float, float, float]


@dataclass(frozen=True)
class HandText:
    """One text.

    Attributes:
        id: its name, unique in the corpus.
        world: name of the world that it speaks of.
        instruction: as it was written.
        object: id of the block that it means.
        manner: number of the manner in which it was written, from 1.
        task: one of `TASKS`.
        kind: of the scene, one of `KINDS`.
        split: one of `SPLITS`.
        destination: centre (x, y, z) in [m] of where the block goes; None for a pick.
        history: ids of what was moved before, the latest last.
    """

    id: str
    world: str
    instruction: str
    object: str
    manner: int
    task: str
    kind: str
    split: str
    destination: Place | None = None
    history: tuple[str, ...] = ()

    def to_json(self) -> dict[str, Any]:
        """The text as the plain values of a line."""
        gold = {"object": self.object} | ({} if self.destination is None else {"destination": list(self.destination)})
        return {"id": self.id, "world": self.world, "instruction": self.instruction, "history": list(self.history),
                "gold": gold, "manner": self.manner, "task": self.task, "kind": self.kind,
                "split": self.split}  # fmt: skip


@dataclass(frozen=True, eq=False)
class Hands:
    """Texts and the worlds they speak of.

    Attributes:
        texts: in the order of the file.
        worlds: by their names.
    """

    texts: tuple[HandText, ...]
    worlds: Mapping[str, World]

    def __len__(self) -> int:
        return len(self.texts)

    def __iter__(self) -> Iterator[HandText]:
        return iter(self.texts)

    def __getitem__(self, text_id: str) -> HandText:
        for text in self.texts:
            if text.id == text_id:
                return text
        raise CorpusError(f"no text {text_id!r} among the {len(self.texts)} of this corpus")

    def select(self, texts: Iterable[HandText]) -> Hands:
        """A corpus of these texts, with the worlds that they need."""
        kept = tuple(texts)
        names = {text.world for text in kept}
        return Hands(kept, {name: world for name, world in self.worlds.items() if name in names})


def read_hands(path: Path | str = HANDS, keep_going: bool = False) -> Hands:
    """Read a corpus of texts.

    Args:
        path: of the folder, or of its `.jsonl` file; by default the corpus that ships with the project.
        keep_going: read all lines and raise all refusals together.

    Raises:
        HandsError: a line is refused; names file, line and key, and says what would be right.
        CorpusError: a file is missing or unreadable; `CorpusErrors` with `keep_going` and refused lines.
    """
    file = Path(path) / "hands.jsonl" if Path(path).is_dir() else Path(path)
    try:
        lines = file.read_text(encoding="utf-8").split("\n")
        worlds = load_worlds(file.with_suffix(".worlds.json"))
    except FileNotFoundError:
        raise CorpusError(f"{file}: no such file of texts") from None
    except (OSError, UnicodeDecodeError, WorldError) as error:
        raise CorpusError(str(error) if isinstance(error, WorldError) else f"{file}: unreadable: {error}") from error
    texts: dict[str, HandText] = {}
    problems: list[CorpusError] = []
    for number, line in enumerate(lines, start=1):
        try:
            if line.strip():
                text = _parsed(line, worlds, f"{file}", number)
                if text.id in texts:
                    raise HandsError(f"{file}", number, "id", f"{text.id!r} occurs twice", "an id of its own")
                texts[text.id] = text
        except HandsError as error:
            if not keep_going:
                raise
            problems.append(error)
    if problems:
        raise CorpusErrors(problems)
    return Hands(tuple(texts.values()), worlds)


def write_hands(corpus: Hands, folder: Path | str) -> None:
    """Write `hands.jsonl` and `hands.worlds.json`, both one element a line; the same bytes for the same corpus."""
    lines = [json.dumps(text.to_json(), ensure_ascii=False) for text in corpus.texts]
    worlds = [f"{json.dumps(name)}: {json.dumps(world_to_json(world))}" for name, world in corpus.worlds.items()]
    place = Path(folder)
    place.mkdir(parents=True, exist_ok=True)
    (place / "hands.jsonl").write_text("".join(line + "\n" for line in lines), encoding="utf-8")
    whole = f'{{"schema": {SCHEMA}, "worlds": {{' + ",\n ".join(worlds) + "}}\n"
    (place / "hands.worlds.json").write_text(whole, encoding="utf-8")


def _parsed(line: str, worlds: Mapping[str, World], file: str, number: int) -> HandText:
    """A line's text, checked."""

    def need(holds: bool, key: str, problem: str, right: str) -> None:
        if not holds:
            raise HandsError(file, number, key, problem, right)

    try:
        data = json.loads(line)
    except (ValueError, RecursionError) as error:
        raise HandsError(file, number, None, f"not a whole JSON object ({error})", "one object a line") from error
    need(isinstance(data, dict), "id", f"the line is {data!r:.40}", f"an object with the keys {', '.join(_KEYS)}")
    for key in dict.fromkeys((*_KEYS, *data)):
        need(key in data, key, "is missing", f"all of {', '.join(_KEYS)}")
        need(key in _KEYS, key, "is unknown", f"only {', '.join(_KEYS)}")
    for key in ("id", "instruction"):
        value = data[key]
        need(isinstance(value, str) and bool(value.strip()), key, f"is {value!r:.60}", "a text that is not empty")
    for key, allowed in (("world", tuple(worlds)), ("task", TASKS), ("kind", KINDS), ("split", SPLITS)):
        need(data[key] in allowed, key, f"is {data[key]!r:.60}", f"one of {', '.join(allowed[:12]) or 'the worlds'}")
    manner = data["manner"]
    need(type(manner) is int and manner >= 1, "manner", f"is {manner!r:.60}", "a whole number from 1")
    blocks = tuple(item.id for item in worlds[data["world"]].things)
    history, gold = data["history"], data["gold"]
    listed = isinstance(history, list) and all(name in blocks for name in history)
    need(listed, "history", f"is {history!r:.60}", f"a list of blocks of its world: {', '.join(blocks)}")
    destination = _gold(gold, data["task"], blocks, need)
    return HandText(data["id"], data["world"], data["instruction"], gold["object"], manner, data["task"],
                    data["kind"], data["split"], destination, tuple(history))  # fmt: skip


def _gold(gold: Any, task: str, blocks: tuple[str, ...], need: Callable[[bool, str, str, str], None]) -> Place | None:
    """Where the block goes; what is meant, checked."""
    need(isinstance(gold, dict), "gold", f"is {gold!r:.60}", 'an object with "object" and, for placings, "destination"')
    wanted = {"object"} | ({"destination"} if task == "place" else set())
    need(set(gold) == wanted, "gold", f"has the keys {sorted(gold)}", f"{sorted(wanted)} where task is {task!r}")
    need(gold["object"] in blocks, "gold.object", f"is {gold['object']!r:.60}", f"one of {', '.join(blocks)}")
    if task == "pick":
        return None
    place = gold["destination"]
    numbers = isinstance(place, list) and all(type(n) in (int, float) and abs(n) < _FAR for n in place)
    right = f"the centre's x, y and z in metres, within {_FAR:g}"
    need(numbers and len(place) == 3, "gold.destination", f"is {place!r:.60}", right)
    return float(place[0]), float(place[1]), float(place[2])

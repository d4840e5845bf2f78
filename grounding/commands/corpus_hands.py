"""`python -m grounding corpus show`, `check` and `worlds` for corpora of free texts."""

from __future__ import annotations

import sys
from collections import Counter
from pathlib import Path

from grounding.corpus.check import Finding
from grounding.corpus.hands import Hands, HandText, read_hands
from grounding.corpus.hands_check import check_hands
from grounding.corpus.pretty import Paint

_HEAD = 4096  # characters of a file that are looked at


def holds_texts(path: Path | None) -> bool:
    """Whether a path names a corpus of texts: a folder with `hands.jsonl`, or a file whose first line has gold."""
    if path is None:
        return False
    if path.is_dir():
        return (path / "hands.jsonl").exists()
    if path.suffix != ".jsonl" or not path.is_file():
        return False
    with path.open(encoding="utf-8", errors="replace") as file:
        head = file.read(_HEAD).lstrip().split("\n")[0]
    return path.name == "hands.jsonl" or ('"gold"' in head and '"tree"' not in head)


def show_texts(path: Path, text_id: str | None, limit: int | None) -> int:
    """Print texts with what they mean."""
    corpus = read_hands(path)
    paint = Paint.for_stream(sys.stdout)
    texts = [corpus[text_id]] if text_id is not None else corpus.texts[:limit]
    for number, text in enumerate(texts):
        print(("\n" if number else "") + pretty_text(text, corpus, paint))
    return 0


def pretty_text(text: HandText, corpus: Hands, paint: Paint) -> str:
    """A text on three lines: its names, the words, what is meant."""
    world = corpus.worlds[text.world]
    meant = f"{text.task} {text.object} ({world[text.object].color})"
    if text.destination is not None:
        meant += " at ({:.3f}, {:.3f}, {:.3f})".format(*text.destination)
    head = f"world {text.world!r}  {text.kind}  manner {text.manner}  {text.split}"
    return f"{paint('bold', text.id)}  {head}\n{text.instruction}\n    {paint('action', meant)}"


def check_texts(path: Path, keep_going: bool) -> tuple[dict[str, int], tuple[Finding, ...]]:
    """How much there is of what, and the findings."""
    corpus = read_hands(path, keep_going)
    return {"texts": len(corpus), "worlds": len(corpus.worlds)}, check_hands(corpus)


def list_worlds(path: Path) -> int:
    """Print the worlds with their colours and the number of their texts."""
    corpus = read_hands(path)
    used = Counter(text.world for text in corpus)
    for name, world in corpus.worlds.items():
        colors = Counter(item.color for item in world.things)
        listed = ", ".join(f"{count} {color}" for color, count in sorted(colors.items()))
        print(f"{name}\t{len(world.things)} objects ({listed})\t{used[name]} texts")
    return 0



"""Images of worlds with boxes around what instructions speak of, and their index.

Rendered where OpenGL starts, drawn from above elsewhere. `index.json` tells of every image the boxes in pixels, the
instruction and the symbols of its phrases.
"""

from __future__ import annotations

import io
import json
from collections.abc import Sequence
from itertools import zip_longest
from pathlib import Path
from typing import Any

from grounding.corpus.format import example_from_json
from grounding.experiments.progress import Progress
from grounding.world import world_from_json, world_to_json
from integration.corpus.bounding_boxes import pictured
from integration.corpus.settings import IMAGES, INDEX, Folder, Settings, write_whole
from integration.corpus.settled_worlds import SettledWorld
from integration.workers import Workers

IMAGES_A_PART = 4
_KINDS = ("circle", "tower", "column", "row", "group")


def make_images(
    folder: Folder, settings: Settings, items: Sequence[dict[str, Any]], worlds: Sequence[SettledWorld],
    workers: Workers,
) -> int:  # fmt: skip
    """Draw the images that are missing, and write their index; how many there are.

    Args:
        folder: of the corpus.
        settings: of the corpus.
        items: its instructions, as `Sentences` has them.
        worlds: all of them.
        workers: who work.

    Raises:
        UsageError: a part is damaged or cannot be written.
        WorkFailed: an image could not be made.
    """
    chosen = choose(items, settings.images)
    known = {world.name: world.world for world in worlds}
    shares = [range(k, min(k + IMAGES_A_PART, len(chosen))) for k in range(0, len(chosen), IMAGES_A_PART)]
    names = [f"images-{k:04d}" for k in range(len(shares))]
    missing = [k for k, name in enumerate(names) if not folder.complete(name, IMAGES, "image")]
    bar = Progress(sum(len(shares[k]) for k in missing), "images")
    tasks = [(str(folder.path / IMAGES), [(f"{n:04d}.png", chosen[n], world_to_json(known[chosen[n]["world"]]))
                                          for n in shares[k]]) for k in missing]  # fmt: skip
    for place, entries in workers.run(make_image_part, tasks):
        folder.keep(names[missing[place]], entries)
        for entry in entries:
            bar.step(entry["id"])
    entries = [entry for name in names for entry in folder.items(name)]
    if entries:
        lines = ",\n ".join(json.dumps(entry, ensure_ascii=False) for entry in entries)
        folder.write(f"{IMAGES}/{INDEX}", f"[{lines}]\n")
    return len(entries)


def choose(items: Sequence[dict[str, Any]], count: int) -> list[dict[str, Any]]:
    """Lines of examples to be pictured: those that speak of arrangements, of each kind in turn, worlds apart first."""
    kinds: dict[str, list[dict[str, Any]]] = {kind: [] for kind in _KINDS}
    others: list[dict[str, Any]] = []
    for item in items:
        kind = next((kind for kind in _KINDS if kind in item["constructions"]), None)
        if kind is None or item["example"]["outcome"] != "grounded":
            others.append(item["example"])
        else:
            kinds[kind].append(item["example"])
    speaking = [line for turn in zip_longest(*kinds.values()) for line in turn if line is not None]
    first: list[dict[str, Any]] = []
    again: list[dict[str, Any]] = []
    seen: set[str] = set()
    for line in speaking:
        (again if line["world"] in seen else first).append(line)
        seen.add(line["world"])
    return [*first, *again, *others][:count]


def make_image_part(folder: str, told: Sequence[tuple[str, dict[str, Any], dict[str, Any]]]) -> list[dict[str, Any]]:
    """Draw some images, and give their entries in the index, for processes that share the work.

    Args:
        folder: where images are written.
        told: of each, the name of its file, the line of its example, and its world.
    """
    entries = []
    for name, line, data in told:
        world = world_from_json(data, line["world"])
        example = example_from_json(line, {line["world"]: world})
        image, entry = pictured(example, world)
        stream = io.BytesIO()
        image.save(stream, "PNG", compress_level=6)
        write_whole(Path(folder) / name, stream.getvalue())
        entries.append({"image": name, **entry})
    return entries

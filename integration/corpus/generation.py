"""The making of a corpus, step by step: worlds, instructions, files, pictures."""

from __future__ import annotations

import json
import sys
import time
from collections.abc import Sequence
from typing import Any

from grounding.corpus.format import worlds_path, write_worlds
from grounding.experiments.progress import Progress
from integration.corpus.counts import counted
from integration.corpus.images import make_images
from integration.corpus.instructions import Sentences, make_sentences
from integration.corpus.settings import CORPUS, HELD_OUT, SUMMARY, Folder, Settings
from integration.corpus.settled_worlds import SettledWorld, settle_worlds, settled_from_json
from integration.corpus.videos import make_videos
from integration.workers import Workers

SETTLED_A_PART = 20


def generate_corpus(folder: Folder, settings: Settings, jobs: int) -> dict[str, Any]:
    """Make what is not there yet, and write the corpus.

    Args:
        folder: of the corpus.
        settings: of the corpus.
        jobs: processes that work at the same time.

    Returns:
        the summary, as plain values.

    Raises:
        UsageError: a part is damaged, or something cannot be written.
        WorkFailed: a process died, or was refused.
        Unsettled: no world came to rest.
    """
    seconds: dict[str, float] = {}
    clock = _Clock(seconds)
    with Workers(jobs) as workers:
        worlds = _settled(folder, settings, workers)
        clock.lap("worlds")
        bar = _Bar(settings.instructions, "instructions")
        sentences = make_sentences(folder, settings, worlds, workers, bar.steps)
        clock.lap("instructions")
        _write(folder, sentences, worlds)
        clock.lap("files")
        images = make_images(folder, settings, sentences.items, worlds, workers)
        clock.lap("images")
        videos = make_videos(folder, settings, sentences.items, worlds, workers)
        clock.lap("videos")
    told = counted(sentences, worlds)
    counts = {**told, "images": images, "videos": videos}
    result = {"settings": settings.to_json(), **counts}
    folder.write(SUMMARY, json.dumps(result, indent=1) + "\n")
    if len(sentences.items) < settings.instructions:
        print(f"note: {len(sentences.items)} of {settings.instructions} instructions: no wording is used more often "
              "than the generator allows; more worlds give more", file=sys.stderr)  # fmt: skip
    return {**result, "jobs": jobs, "seconds": {**seconds, "total": round(sum(seconds.values()), 1)},
            "output": str(folder.path)}  # fmt: skip


class _Clock:
    """Wall-clock seconds of one step after the other."""

    def __init__(self, seconds: dict[str, float]) -> None:
        self._seconds, self._last = seconds, time.perf_counter()

    def lap(self, name: str) -> None:
        """A step ends."""
        now = time.perf_counter()
        self._seconds[name], self._last = round(now - self._last, 1), now


class _Bar:
    """Progress that may go on by many steps at once."""

    def __init__(self, total: int, unit: str) -> None:
        self._progress = Progress(total, unit)

    def steps(self, count: int) -> None:
        """So many steps are done."""
        if count:
            self._progress.done += count - 1
            self._progress.step()


def _settled(folder: Folder, settings: Settings, workers: Workers) -> tuple[SettledWorld, ...]:
    """All worlds, in the order of their numbers; those whose parts are missing are settled."""
    shares = [range(k, min(k + SETTLED_A_PART, settings.worlds)) for k in range(0, settings.worlds, SETTLED_A_PART)]
    names = [f"worlds-{k:04d}" for k in range(len(shares))]
    missing = [k for k, name in enumerate(names) if not folder.has(name)]
    there = settings.worlds - sum(len(shares[k]) for k in missing)
    if there:
        print(f"{there} of {settings.worlds} worlds were there already", file=sys.stderr)
    bar = _Bar(settings.worlds - there, "worlds settled")
    for place, items in workers.run(settle_worlds, [(settings.seed, tuple(shares[k])) for k in missing]):
        folder.keep(names[missing[place]], items)
        bar.steps(len(items))
    return tuple(settled_from_json(item) for name in names for item in folder.items(name))


def _write(folder: Folder, sentences: Sentences, worlds: Sequence[SettledWorld]) -> None:
    """The corpus as two files, and which of its instructions are held out."""
    lines = [json.dumps(item["example"], ensure_ascii=False) for item in sentences.items]
    used = {item["example"]["world"] for item in sentences.items}
    target = worlds_path(folder.path / CORPUS)
    unfinished = target.with_name(f".{target.name}")
    write_worlds({world.name: world.world for world in worlds if world.name in used}, unfinished)
    unfinished.replace(target)
    folder.write(CORPUS, "".join(line + "\n" for line in lines))
    held_out = [item["example"]["id"] for item in sentences.items if item["held_out"]]
    folder.write(HELD_OUT, json.dumps(held_out, indent=0) + "\n")

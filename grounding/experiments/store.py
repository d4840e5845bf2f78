"""Finished splits on disk, so that a run that was broken off goes on where it ended.

They are kept under a key of all that decides them: corpus, settings, and the code that learns and infers. A split that
was done under another key is done again.
"""

from __future__ import annotations

import hashlib
import json
import os
from dataclasses import asdict
from functools import lru_cache
from pathlib import Path
from typing import Any

import grounding
from grounding.corpus.format import Corpus, example_to_json
from grounding.experiments.trial import Settings
from grounding.world import world_to_json

Variant = tuple[str, str]
_SOURCES = ("factors", "features", "geometry", "inference", "language", "learning", "experiments", "")
_KEY = 16


class Store:
    """The folder of one run's splits.

    Args:
        folder: where splits of all keys are kept.
        corpus: that is split.
        settings: of the run.
        seed: of the splits.
    """

    def __init__(self, folder: Path, corpus: Corpus, settings: Settings, seed: int) -> None:
        self.folder = folder / _key(corpus, settings, seed)
        self.folder.mkdir(parents=True, exist_ok=True)

    def read(self, name: str) -> dict[str, Any] | None:
        """What is known of a split; None where nothing is."""
        try:
            trial: dict[str, Any] = json.loads(self._path(name).read_text(encoding="utf-8"))
        except (FileNotFoundError, ValueError):  # not there, or written by half
            return None
        return trial

    def missing(self, name: str, variants: tuple[Variant, ...]) -> tuple[Variant, ...]:
        """The variants of a split that are still to be done."""
        trial = self.read(name)
        done = [] if trial is None else [tuple(pair) for pair in trial["variants"]]
        return tuple(pair for pair in variants if pair not in done)

    def add(self, trial: dict[str, Any], variants: tuple[Variant, ...]) -> None:
        """Keep a finished split, beside what other variants gave before."""
        before = self.read(trial["split"]) or {"variants": [], "rows": []}
        whole = {**trial, "variants": before["variants"] + [list(pair) for pair in variants],
                 "rows": before["rows"] + trial["rows"]}  # fmt: skip
        path = self._path(trial["split"])
        part = path.with_suffix(".part")
        part.write_text(json.dumps(whole), encoding="utf-8")
        os.replace(part, path)

    def _path(self, name: str) -> Path:
        return self.folder / f"{name}.json"


def fingerprint(corpus: Corpus) -> str:
    """A checksum of the examples and worlds of a corpus."""
    digest = hashlib.sha256()
    for example in corpus:
        digest.update(json.dumps(example_to_json(example)).encode())
    for name, world in sorted(corpus.worlds.items()):
        digest.update(json.dumps([name, world_to_json(world)]).encode())
    return digest.hexdigest()[:_KEY]


def _key(corpus: Corpus, settings: Settings, seed: int) -> str:
    decides = {name: value for name, value in asdict(settings).items() if name not in ("inference", "parse")}
    text = json.dumps([fingerprint(corpus), _code(), seed, decides], sort_keys=True)
    return hashlib.sha256(text.encode()).hexdigest()[:_KEY]


@lru_cache(maxsize=1)
def _code() -> str:
    """A checksum of the code that splits, learns, infers and compares."""
    root = Path(grounding.__file__).parent
    digest = hashlib.sha256()
    for folder in _SOURCES:
        for path in sorted((root / folder).glob("*.py")):
            digest.update(path.name.encode() + path.read_bytes())
    return digest.hexdigest()[:_KEY]

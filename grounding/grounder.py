"""The face of the package: a text and a world become a `Grounding`."""

from __future__ import annotations

import time
from collections import OrderedDict
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

import models
from grounding.dialogue import decide
from grounding.factors import load_model
from grounding.geometry.layout import Layout
from grounding.graded.belief import GradedBelief, believe
from grounding.graded.scene import Scene
from grounding.inference import Adcg
from grounding.language.parser import Parse, Parser
from grounding.readings import Reading, readings
from grounding.result import Grounding
from grounding.world import World

KEPT_SCENES = 16


@dataclass(frozen=True, eq=False)
class Understanding:
    """What a text was taken for, before it is decided what follows.

    Attributes:
        text: the instruction.
        parses: of the text, the likeliest first.
        scene: the world, measured.
        graded: what the parses ask for by their graded readings.
        readings: by the factors, of the parses that agree best with the world; the likeliest first.
    """

    text: str
    parses: tuple[Parse, ...]
    scene: Scene
    graded: GradedBelief
    readings: tuple[Reading, ...]

    def decided(self) -> Grounding:
        """The answer."""
        return decide(self.text, self.readings, self.scene, self.parses[0].unknown_words, self.graded)


class Grounder:
    """Grounds instructions with one grammar and one set of factors.

    Args:
        parser: from text to phrase trees.
        inference: from phrase trees to symbols.
        parses: how many parses of a text are kept and read; the world decides between them.
        inferred: how many of those that agree best with the world are grounded by the factors.
    """

    def __init__(self, parser: Parser, inference: Adcg, parses: int = 4, inferred: int = 1) -> None:
        self.parser = parser
        self.inference = inference
        self.parses = parses
        self.inferred = inferred
        self._scenes: OrderedDict[int, tuple[World, Scene]] = OrderedDict()

    @classmethod
    def load(cls, grammar: Path = models.GRAMMAR, weights: Path = models.WEIGHTS) -> Grounder:
        """Read the shipped grammar and weights, or others.

        Raises:
            ModelError: a file is missing, damaged or of another version.
        """
        return cls(Parser.load(grammar), Adcg(load_model(weights)))

    def ground(self, text: str, world: World, history: Sequence[str] = ()) -> Grounding:
        """Understand an instruction.

        Args:
            text: what the person said.
            world: what is there.
            history: ids of the objects handled before, the latest last.

        Raises:
            LanguageError: the text has no words.
        """
        start = time.perf_counter()
        result = self.understand(text, world, history).decided()
        return result.timed(1000 * (time.perf_counter() - start))

    def understand(self, text: str, world: World, history: Sequence[str] = ()) -> Understanding:
        """Read an instruction in every way that is likely; see `ground`."""
        parses = self.parser.parse(text, self.parses)
        scene = self.scene(world)
        graded = believe(parses, scene, history)
        kept = graded.parses()[: self.inferred] or range(min(len(parses), self.inferred))
        likely = [parses[place] for place in kept]
        memory: dict[object, list] = {}
        inferred = [(self.inference.infer(parse.tree, scene.layout, memory), parse.probability) for parse in likely]
        return Understanding(text, parses, scene, graded, readings(inferred, scene.layout))

    def layout(self, world: World) -> Layout:
        """The world, measured; the latest ones are kept."""
        return self.scene(world).layout

    def scene(self, world: World) -> Scene:
        """The world, measured for graded readings."""
        key = id(world)
        if key in self._scenes:
            self._scenes.move_to_end(key)
            return self._scenes[key][1]
        self._scenes[key] = (world, Scene(Layout(world)))
        if len(self._scenes) > KEPT_SCENES:
            self._scenes.popitem(last=False)
        return self._scenes[key][1]

"""The face of the package: a text and a world become a `Grounding`."""

from __future__ import annotations

import time
from collections import OrderedDict
from collections.abc import Sequence
from pathlib import Path

import models
from grounding.dialogue import decide
from grounding.factors import load_model
from grounding.geometry.layout import Layout
from grounding.inference import Adcg
from grounding.language.parser import Parser
from grounding.readings import readings
from grounding.result import Grounding
from grounding.world import World

KEPT_LAYOUTS = 16
NEGLIGIBLE = 1e-3  # parses less likely than the best by this factor are not grounded


class Grounder:
    """Grounds instructions with one grammar and one set of factors.

    Args:
        parser: from text to phrase trees.
        inference: from phrase trees to symbols.
        parses: how many parses of a text are kept and grounded; the world decides between them.
    """

    def __init__(self, parser: Parser, inference: Adcg, parses: int = 4) -> None:
        self.parser = parser
        self.inference = inference
        self.parses = parses
        self._layouts: OrderedDict[int, tuple[World, Layout]] = OrderedDict()

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
        parses = self.parser.parse(text, self.parses)
        layout = self.layout(world)
        memory: dict[object, list] = {}
        likely = [parse for parse in parses if parse.probability >= NEGLIGIBLE * parses[0].probability]
        inferred = [(self.inference.infer(parse.tree, layout, memory), parse.probability) for parse in likely]
        unknown = parses[0].unknown_words
        result = decide(text, readings(inferred, layout), layout, unknown)
        return result.timed(1000 * (time.perf_counter() - start))

    def layout(self, world: World) -> Layout:
        """The world, measured; the latest ones are kept."""
        key = id(world)
        if key in self._layouts:
            self._layouts.move_to_end(key)
            return self._layouts[key][1]
        self._layouts[key] = (world, Layout(world))
        if len(self._layouts) > KEPT_LAYOUTS:
            self._layouts.popitem(last=False)
        return self._layouts[key][1]

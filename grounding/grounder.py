"""The face of the package: a text and a world become a `Grounding`."""

from __future__ import annotations

import time
from collections import OrderedDict
from collections.abc import Sequence
from dataclasses import dataclass, replace
from pathlib import Path

import models
from grounding.course import Course
from grounding.dialogue import decide
from grounding.factors import load_model
from grounding.forbidding import without_forbidden
from grounding.geometry.layout import Layout
from grounding.graded.belief import GradedBelief, believe
from grounding.graded.scene import Scene
from grounding.inference import Adcg
from grounding.language.parser import Parse, Parser
from grounding.readings import Reading, readings
from grounding.result import Grounding
from grounding.steps import Step, split
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
        tree = self.readings[0].inference.tree
        parse = next((parse for parse in self.parses if parse.tree is tree), self.parses[0])
        result = decide(self.text, self.readings, self.scene, parse.unknown_words, self.graded)
        return replace(result, mended=parse.mended)


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
        return self.follow(self.course(text, world, history))[0]

    def course(self, text: str, world: World, history: Sequence[str] = ()) -> Course:
        """The steps of an instruction, none of them grounded yet; see `ground`."""
        start = time.perf_counter()
        steps = split(self._parsed(text), self.scene(world), history)
        return Course(text, steps, world, tuple(history), milliseconds=1000 * (time.perf_counter() - start))

    def follow(self, course: Course) -> tuple[Grounding, Course]:
        """Ground the steps that are left, as far as they have answers.

        Returns:
            the answer to all, or what is to be said of the first step that has none, and the course as far as it came.
        """
        start = time.perf_counter()
        last = None
        while last is None and (step := course.next) is not None:
            scene = self.scene(course.world)
            text = course.text if len(course.steps) == 1 else step[0].tree.text
            answer = self._read(text, step, scene, course.history).decided()
            if answer.outcome == "grounded":
                course = course.after(answer)
            else:
                last = answer
        return course.result(last).timed(course.milliseconds + 1000 * (time.perf_counter() - start)), course

    def understand(self, text: str, world: World, history: Sequence[str] = ()) -> Understanding:
        """Read an instruction as one thing to do, in every way that is likely; see `ground`."""
        return self._read(text, self._parsed(text), self.scene(world), history)

    def _parsed(self, text: str) -> tuple[Parse, ...]:
        """The parses, without sentences that forbid where others tell what to do."""
        return tuple(replace(p, tree=without_forbidden(p.tree)) for p in self.parser.parse(text, self.parses))

    def _read(self, text: str, parses: Step, scene: Scene, history: Sequence[str]) -> Understanding:
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

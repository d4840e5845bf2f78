"""The face of the package: a text and a world become a `Grounding`."""

from __future__ import annotations

import time
from collections import OrderedDict
from collections.abc import Collection, Sequence
from dataclasses import dataclass, replace
from pathlib import Path

import models
from grounding.course import Course
from grounding.dialogue import action_of, decide
from grounding.errors import GroundingError, LanguageError
from grounding.forbidding import without_forbidden
from grounding.geometry.layout import Layout
from grounding.inquiries import answered, inquiry_of
from grounding.language.instruments import without_hands
from grounding.language.lexicon import meanings
from grounding.language.parser import Parse, Parser
from grounding.language.tree import Phrase
from grounding.lexicon.colour import taken_for
from grounding.literal import SILENT, LiteralBelief, believe_literally
from grounding.meaning.discourse.told import Told
from grounding.model.belief import Belief, Option, Seen, read
from grounding.model.belief import Reading as Meant
from grounding.model.belief import believe as weigh
from grounding.model.cases import Learned, Weights
from grounding.model.evaluator import Evaluator
from grounding.model.opinions import Opinion, with_opinions
from grounding.model.storage import load_learned
from grounding.plans import planned
from grounding.result import GroundedAction, Grounding
from grounding.returning import returned, returns
from grounding.standpoint import unknown_side
from grounding.steps import Step, split
from grounding.symbols import ObjectColor
from grounding.unanswered import open_options
from grounding.world import World
from grounding.world.scene import Scene

READERS = ("meanings", "literal")
"""Who proposes what may be meant; each can be left out, see `Grounder`."""
KEPT_SCENES = 16
KEPT_VIEWS = 8  # of a scene, by who looks and what was handled before
LONGEST = 200  # words that an instruction may have
SENTENCE = 50  # words of a sentence that are parsed as one; longer ones are parsed in pieces


def shortened(words: Sequence[str], most: int) -> str:
    """A text whose sentences have at most so many words: longer ones end after a comma, else where they must."""
    texts: list[str] = []
    start = 0
    for place, word in enumerate(words):
        texts.append(word)
        if word[-1] in ".!?;":
            start = place + 1
        elif place - start + 1 >= most or (place - start + 1 > most // 2 and word[-1] == ","):
            texts[-1] += "."
            start = place + 1
    return " ".join(texts)


@dataclass(frozen=True, eq=False)
class Heard:
    """A text as it was read, before it is weighed what is meant.

    Attributes:
        literal: what its parses ask for literally.
        meanings: the readings whose candidates are weighed, with what the literal one holds of these.
    """

    literal: LiteralBelief
    meanings: tuple[Meant, ...]


def opinion_of(literal: LiteralBelief) -> Opinion:
    """What a literal reading holds of what may be meant."""
    shares: dict[tuple[str, ...], float] = {}
    for (_, names), share in literal.options:
        key = tuple(sorted(names))
        shares[key] = shares.get(key, 0.0) + share
    sort = "plural" if literal.plural else "alike" if literal.alike else "vague" if literal.vague else "sharp"
    notes = (sort, "open") if literal.is_open else (sort,)
    return Opinion("literal", shares, notes, 1.0 if literal.missing else 0.0)


@dataclass(frozen=True, eq=False)
class Understanding:
    """What a text was taken for, before it is decided what follows.

    Attributes:
        text: the instruction.
        parses: of the text, the likeliest first.
        scene: the world, measured.
        literal: what the parses ask for literally.
        belief: what learned weights make of the meanings of the parses and of what the literal one holds of them.
    """

    text: str
    parses: tuple[Parse, ...]
    scene: Scene
    literal: LiteralBelief
    belief: Belief

    @property
    def parse(self) -> Parse:
        """The parse that agrees best with the world."""
        return self.parses[next(iter(self.belief.parses()), 0)]

    def decided(self, before: World | None = None) -> Grounding:
        """The answer.

        Args:
            before: the world before the latest object was handled, where that is known.
        """
        parse = self.parse
        tree = parse.tree
        result = decide(self.text, tree, self.scene, parse.unknown_words, self.belief, self.literal)
        if returns(tree):
            result = returned(result, self.scene.layout.world, before)
        if result.outcome == "grounded" and not result.explanation:
            result = replace(result, explanation=unknown_side(tree, self.scene.layout.world))
        return replace(result, mended=(*parse.mended, *self._recolored(tree)))

    def _recolored(self, tree: Phrase) -> list[tuple[str, str]]:
        """The colours that were said and that others were taken for, as nothing here has them."""
        symbols = (symbol for leaf in tree.leaves for symbol in meanings(leaf.text))
        said = dict.fromkeys(symbol.name for symbol in symbols if isinstance(symbol, ObjectColor))
        others = ((color, taken_for(self.scene, color)) for color in said)
        return [(color, other) for color, other in others if other is not None]

    def options(self) -> tuple[Option, ...]:
        """All that may be spoken of, the likeliest first; those that are left open where nothing helped."""
        found = self.belief.listed()
        if found:
            return found
        bare = open_options(self.parse.tree, self.scene)
        return tuple(Option(names, 1 / len(bare), ((kind, 1.0),)) for kind, names in bare)

    def action(self, option: Option) -> GroundedAction:
        """What is to be done where an option is meant."""
        return action_of(option, self.parse.tree, self.belief)


@dataclass(frozen=True, eq=False)
class Followed:
    """How far the steps of an instruction were grounded.

    Attributes:
        grounding: the answer to all, or what is to be said of the first step that has none.
        course: with the steps that have answers.
        last: what is to be said of the step that has none, by itself; None where all have.
        understanding: of the step that was read last.
    """

    grounding: Grounding
    course: Course
    last: Grounding | None
    understanding: Understanding | None


class Grounder:
    """Grounds instructions with one grammar and one set of weights that decide.

    Args:
        parser: from text to phrase trees.
        learned: the weights of the features of what may be meant.
        parses: how many parses of a text are kept and read; the world decides between them.
        without: names of `READERS` that are left out: they believe in nothing, and no other reader hears of them. What
            is answered then tells what they are worth.

    Raises:
        GroundingError: there is no reader of such a name.
    """

    def __init__(
        self, parser: Parser, learned: Learned, parses: int = 4, without: Collection[str] = ()
    ) -> None:
        for name in without:
            if name not in READERS:
                raise GroundingError(f"no reader is called {name!r}; there are {', '.join(READERS)}")
        self.parser = parser
        self.learned = learned
        self.parses = parses
        self.without = frozenset(without)
        self._scenes: OrderedDict[int, tuple[World, Scene]] = OrderedDict()
        self._known: OrderedDict[int, tuple[Scene, dict[Seen, Evaluator]]] = OrderedDict()

    @property
    def weights(self) -> Weights:
        """The weights by which it is decided what a text means."""
        return self.learned.deciding

    @classmethod
    def load(
        cls, grammar: Path = models.GRAMMAR, beliefs: Path = models.BELIEFS, without: Collection[str] = ()
    ) -> Grounder:
        """Read the shipped grammar and weights, or others.

        Args:
            grammar: of the parser.
            beliefs: the weights that decide.
            without: names of `READERS` that are left out.

        Raises:
            ModelError: a file is missing, damaged or of another version.
        """
        return cls(Parser.load(grammar), load_learned(beliefs), without=without)

    def ground(self, text: str, world: World, history: Sequence[str] = (), before: World | None = None) -> Grounding:
        """Understand an instruction.

        Args:
            text: what the person said.
            world: what is there.
            history: ids of the objects handled before, the latest last.
            before: the world before the latest was handled, where that is known ("put it back").

        Raises:
            LanguageError: the text has no words, or more than `LONGEST`.
        """
        asked = self.inquired(text, world)
        return asked or self.follow(self.course(text, world, history, before)).grounding

    def inquired(self, text: str, world: World) -> Grounding | None:
        """The answer to a question about the world, None for a text that asks for something to be done."""
        start = time.perf_counter()
        inquiry = inquiry_of(text)
        if inquiry is None:
            return None
        found = answered(text, inquiry, self.parser, self.scene(world), self.learned.referring)
        return found.timed(1000 * (time.perf_counter() - start))

    def course(self, text: str, world: World, history: Sequence[str] = (), before: World | None = None) -> Course:
        """The steps of an instruction, none of them grounded yet; see `ground`."""
        start = time.perf_counter()
        said, arms = without_hands(text)
        steps = split(self._parsed(said), self.scene(world), history)
        if len(set(arms)) > 1 and len(arms) != len(steps):
            raise LanguageError("several hands are named; say one for each thing to do")
        return Course(text, steps, world, tuple(history), milliseconds=1000 * (time.perf_counter() - start),
                      before=before, arms=arms)  # fmt: skip

    def follow(self, course: Course) -> Followed:
        """Ground the steps that are left, as far as they have answers."""
        start = time.perf_counter()
        last, understanding = None, None
        while last is None and (step := course.next) is not None:
            scene = self.scene(course.world)
            text = course.text if len(course.steps) == 1 else step[0].tree.text
            answer = self._planned(text, step, scene, course.history)
            if answer is None:
                understanding = self._read(text, step, scene, course.history)
                answer = understanding.decided(course.before)
            answer = course.with_arm(answer)
            if answer.outcome == "grounded":
                course = course.after(answer)
            else:
                last = answer
        result = course.result(last).timed(course.milliseconds + 1000 * (time.perf_counter() - start))
        return Followed(result, course, last, understanding)

    def _planned(self, text: str, step: Step, scene: Scene, history: Sequence[str]) -> Grounding | None:
        """The moves of a step that takes several, None for all others."""
        handled = tuple(scene.layout.index[name] for name in history if name in scene.layout.index)
        return planned(text, step, scene, handled, self.learned.referring)

    def understand(self, text: str, world: World, history: Sequence[str] = ()) -> Understanding:
        """Read an instruction as one thing to do, in every way that is likely; see `ground`."""
        return self._read(text, self._parsed(without_hands(text).text), self.scene(world), history)

    def _parsed(self, text: str) -> tuple[Parse, ...]:
        """The parses, without sentences that forbid where others tell what to do.

        Raises:
            LanguageError: the text has no words, or far more than an instruction has.
        """
        words = text.split()
        if len(words) > LONGEST:
            raise LanguageError(f"expected at most {LONGEST} words and found {len(words)}; say it in fewer")
        text = text if len(words) <= SENTENCE else shortened(words, SENTENCE)
        return tuple(replace(p, tree=without_forbidden(p.tree)) for p in self.parser.parse(text, self.parses))

    def _read(self, text: str, parses: Step, scene: Scene, history: Sequence[str]) -> Understanding:
        heard = self.hear(parses, scene, history)
        belief = weigh(heard.meanings, self.learned.deciding)
        return Understanding(text, parses, scene, heard.literal, belief)

    def hear(self, parses: Sequence[Parse], scene: Scene, history: Sequence[str] = ()) -> Heard:
        """Read parses in every way, before it is weighed what is meant; for learning the weights as well."""
        meanings = read(parses, scene, history, self.learned.referring, self._evaluators(scene))
        literal = SILENT
        if "literal" not in self.without:
            literal = believe_literally(parses, scene, weigh(meanings, self.learned.referring), history)
        found = () if "meanings" in self.without else meanings
        told = Told(kind=literal.options[0][0][0]) if literal.options else Told()
        return Heard(literal, with_opinions(found, (opinion_of(literal),), Evaluator(scene), told))

    def _evaluators(self, scene: Scene) -> dict[Seen, Evaluator]:
        """What was found out about a scene for texts before; of the latest scenes."""
        key = id(scene)
        known = self._known.setdefault(key, (scene, {}))[1]
        self._known.move_to_end(key)
        if len(known) > KEPT_VIEWS:
            known.clear()
        if len(self._known) > KEPT_SCENES:
            self._known.popitem(last=False)
        return known

    def layout(self, world: World) -> Layout:
        """The world, measured; the latest ones are kept."""
        return self.scene(world).layout

    def scene(self, world: World) -> Scene:
        """The world, measured."""
        key = id(world)
        if key in self._scenes:
            self._scenes.move_to_end(key)
            return self._scenes[key][1]
        self._scenes[key] = (world, Scene(Layout(world)))
        if len(self._scenes) > KEPT_SCENES:
            self._scenes.popitem(last=False)
        return self._scenes[key][1]

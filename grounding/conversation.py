"""A conversation: what is asked back is answered, what was handled is remembered."""

from __future__ import annotations

import time
from collections.abc import Iterable
from dataclasses import dataclass, replace

from grounding.answers import Answer, by_description, by_offer, by_words, commands, words_of
from grounding.course import Course, world_after
from grounding.denying import denies, others_than, points_at_other
from grounding.dialogue import LISTED, MOST
from grounding.distinguishing import Describer
from grounding.errors import LanguageError
from grounding.grounder import Followed, Grounder, Understanding
from grounding.model.belief import Option
from grounding.questions import NAMED, offered, question
from grounding.result import GroundedAction, Grounding
from grounding.world import World

PATIENCE = 2  # answers that do not help are borne so often, then the question is dropped
_BARE = (["no"], ["nope"], ["nah"])  # answers that tell nothing where two are named
_BACK = frozenset(("it", "them"))


@dataclass(frozen=True, eq=False)
class Pending:
    """A question that waits for its answer.

    Attributes:
        course: with the step that is asked about as its next.
        understanding: of that step.
        options: what may be meant, the likeliest first.
        named: how many of them the question names.
        where: whether it asks where to put the first one.
        asked: how often it was asked without an answer that helped.
    """

    course: Course
    understanding: Understanding
    options: tuple[Option, ...]
    named: int
    where: bool = False
    asked: int = 0


class Conversation:
    """Understands what is said in turn.

    What has an answer is taken as done: its objects are remembered, and placed ones are where they were to be placed.
    Who carries it out tells by `observe` what the world is like afterwards.

    Args:
        grounder: with its grammar and weights.
        world: what is there.
        history: ids of the objects handled before, the latest last.
    """

    def __init__(self, grounder: Grounder, world: World, history: Iterable[str] = ()) -> None:
        self._grounder = grounder
        self._world = world
        self._history = tuple(history)
        self._before: World | None = None
        self._pending: Pending | None = None
        self._latest: tuple[Course, Understanding] | None = None  # what was done last, before it was

    @property
    def world(self) -> World:
        """As it is taken to be."""
        return self._world

    @property
    def history(self) -> tuple[str, ...]:
        """Ids of the objects handled, the latest last."""
        return self._history

    @property
    def waits(self) -> bool:
        """Whether a question is open."""
        return self._pending is not None

    def handled(self, ids: Iterable[str]) -> None:
        """Tell that objects were handled, the latest last.

        Raises:
            WorldError: one of them is not there.
        """
        names = tuple(ids)
        for name in names:
            self._world[name]
        self._history += names

    def observe(self, world: World) -> None:
        """Tell what the world is like now; a question that is open is asked about the new world."""
        moved = {
            i for i in world.by_id if i not in self._world.by_id or (world[i].position != self._world[i].position).any()
        }
        if moved:
            self._before = self._world
        self._world = world
        self._pending = self._latest = None

    def say(self, text: str) -> Grounding:
        """Understand what is said: an instruction, or the answer to the question that is open.

        Args:
            text: what the person says.

        Raises:
            LanguageError: the text has no words.
        """
        start = time.perf_counter()
        pending = self._pending
        if pending is None:
            return self._instructed(text)
        if not words_of(text):
            raise LanguageError(f"expected an answer and found a text without words: {text[:40]!r}")
        result = self._placed(text, pending) if pending.where else self._chosen(text, pending)
        return replace(result, instruction=text).timed(1000 * (time.perf_counter() - start))

    # -- instructions ----------------------------------------------------------------------------------------------

    def _instructed(self, text: str) -> Grounding:
        if self._latest is not None and denies(text):
            return self._taken_back(text, *self._latest)
        asked = self._grounder.inquired(text, self._world)
        if asked is not None:
            return asked
        course = self._grounder.course(text, self._world, self._history, self._before)
        followed = self._grounder.follow(course)
        result = self._taken(followed)
        self._remember(course, followed.understanding, result)
        return result

    def _remember(self, course: Course, understanding: Understanding | None, result: Grounding) -> None:
        """What was done, in case that it was not what was meant."""
        done = result.outcome == "grounded" and len(course.steps) == 1 and understanding is not None
        self._latest = (course, understanding) if done and understanding is not None else None

    def _taken(self, followed: Followed) -> Grounding:
        """Remembers what follows from an answer: what is done, or what is asked."""
        result, self._pending = followed.grounding, None
        if result.outcome == "grounded":
            self._done(result.actions)
        elif followed.last is not None and followed.last.outcome == "ambiguous" and followed.understanding is not None:
            self._pending = _pending(followed.course, followed.understanding, followed.last)
        return result

    def _taken_back(self, text: str, course: Course, understanding: Understanding) -> Grounding:
        """What was done was not what was meant: it is as if it had not been done, and the others are left."""
        denied = set(self._history[len(course.history) :])
        self._latest = None
        self._world, self._history, self._before = course.world, course.history, course.before
        scene = understanding.scene
        options = others_than(understanding.options(), denied, scene.layout)
        if not options:
            why = "nothing else was understood; say in other words what is meant"
            return Grounding(text, "not_understood", explanation=why)
        pending = Pending(course, understanding, options, min(NAMED, len(options)))
        if points_at_other(text, options, denied, scene.layout):
            return replace(self._decided(pending, understanding.action(options[0])), instruction=text)
        return self._ask(text, pending, "another one is meant")

    def _done(self, actions: Iterable[GroundedAction]) -> None:
        for action in actions:
            after = world_after(self._world, action)
            if after is not self._world or action.action == "pick":  # where it lay is where it goes back
                self._before, self._world = self._world, after
            self._history += action.objects

    # -- answers ---------------------------------------------------------------------------------------------------

    def _chosen(self, text: str, pending: Pending) -> Grounding:
        count = len(pending.options)
        answer = by_words(text, count, pending.named) or by_offer(text, self._offers(pending))
        if answer is None:
            return self._described(text, pending)
        if answer.kind == "none" and answer.rest:
            rest = replace(pending, options=pending.options)
            return self._described(answer.rest, rest)
        return self._follows(answer, text, pending)

    @staticmethod
    def _offers(pending: Pending) -> list[str]:
        """The words by which the open question named alternatives."""
        listed = [option.objects for option in pending.options[:MOST]]
        describer = Describer(pending.understanding.scene)
        return offered(listed, describer, len(pending.options) - len(listed)) if len(listed) > 1 else []

    def _described(self, text: str, pending: Pending) -> Grounding:
        """An answer in words of its own, or an instruction that comes instead of one."""
        parses = self._grounder.parser.parse(text, 2)
        scene = pending.understanding.scene
        if commands(parses[0]) and len(pending.options) == 1 and not _BACK.isdisjoint(words_of(text)):
            self._decided(pending, pending.understanding.action(pending.options[0]))  # whoever goes on with "it" agrees
            return self._instructed(text)
        options = [option.objects for option in pending.options]
        answer = by_description(parses, scene, options, self._grounder.learned.referring)
        if commands(parses[0]) or answer.kind == "other":
            course = self._grounder.course(text, self._world, self._history, self._before)
            fresh = self._grounder.follow(course)
            if fresh.grounding.outcome == "grounded" and commands(parses[0]):
                return self._taken(fresh)
            if fresh.grounding.outcome == "grounded" and answer.kind == "other":
                return self._instead(fresh.grounding.actions[0], pending)
            if answer.kind == "other":
                if commands(parses[0]):
                    return self._taken(fresh)
                return self._again(text, pending, fresh.grounding.explanation)
        return self._follows(answer, text, pending)

    def _instead(self, action: GroundedAction, pending: Pending) -> Grounding:
        """Another thing than those that were named: done with it is what was asked for."""
        kinds = pending.options[0].kinds if pending.options else (("pick", 1.0),)
        option = Option(action.objects, action.probability, kinds)
        return self._decided(pending, pending.understanding.action(option))

    def _follows(self, answer: Answer, text: str, pending: Pending) -> Grounding:
        if answer.kind == "forgotten":
            self._pending = None
            return Grounding(text, "not_understood", explanation="nothing is done")
        left = tuple(pending.options[i] for i in answer.places)
        if answer.kind == "chosen" and left:
            names = tuple(dict.fromkeys(name for option in left for name in option.objects))
            option = Option(names, answer.probability, left[0].kinds)
            return self._decided(pending, pending.understanding.action(option))
        if answer.kind == "none" and not left and pending.named > 1 and words_of(text) in _BARE:
            return self._again(text, pending, "yes or no does not tell which; name one, or say it in other words")
        if answer.kind == "none" and not left:
            self._pending = None
            why = "none of the things that could be meant is; say it in other words"
            return Grounding(text, "no_referent", explanation=why)
        if answer.kind == "first":
            return self._ask(text, replace(pending, named=1, asked=pending.asked + 1))
        named = 1 if len(left) == 1 else min(NAMED, len(left))
        return self._ask(text, replace(pending, options=left, named=named, asked=0))

    def _again(self, text: str, pending: Pending, why: str = "") -> Grounding:
        """An answer that did not help."""
        return self._ask(text, replace(pending, asked=pending.asked + 1), why)

    def _ask(self, text: str, pending: Pending, why: str = "") -> Grounding:
        if pending.asked >= PATIENCE:
            self._pending = None
            why = "it is still open what is meant; say the whole instruction in other words"
            return Grounding(text, "not_understood", explanation=why)
        total = sum(option.probability for option in pending.options) or 1.0
        options = tuple(replace(option, probability=option.probability / total) for option in pending.options)
        self._pending = replace(pending, options=options)
        listed = tuple(pending.understanding.action(option) for option in options[:MOST])
        describer = Describer(pending.understanding.scene)
        if pending.where:
            asked = "Where shall I put it?"
        elif pending.named == 1 and len(options) > 1:
            alone = len(listed[0].objects) == 1
            named = None if alone else offered([action.objects for action in listed], describer, 0)[0]
            asked = question(listed[:1], describer) if named is None else f"Do you mean {named}?"
        else:
            asked = question(listed, describer, len(options) - len(listed))
        count = len(options)
        why = why or (f"{count} readings are possible" if count > 1 else "it is not sure that this is meant")
        return Grounding(text, "ambiguous", (), listed, asked, why)

    def _placed(self, text: str, pending: Pending) -> Grounding:
        """The answer to where something shall be put."""
        if (answer := by_words(text, 1, 1)) is not None and answer.kind == "forgotten":
            return self._follows(answer, text, pending)
        names = pending.options[0].objects
        parse = self._grounder.parser.parse(text, 1)[0]
        told = None if commands(parse) else self._beside(text, pending)
        if told is not None:
            return self._decided(pending, replace(told, objects=names))
        if not commands(parse):
            history = (*pending.course.history, *names)
            said = f"put {'it' if len(names) == 1 else 'them'} {text}"
            found = self._grounder.ground(said, pending.course.world, history, pending.course.before)
            action = found.actions[0] if found.actions else None
            if action is not None and action.action == "place" and action.destination is not None:
                return self._decided(pending, replace(action, objects=names))
            return self._again(text, pending, found.explanation)
        course = self._grounder.course(text, self._world, (*self._history, *names), self._before)
        return self._taken(self._grounder.follow(course))

    def _beside(self, text: str, pending: Pending) -> GroundedAction | None:
        """What follows where an answer tells which of several things a place was named by."""
        rival = pending.understanding.literal.rival
        if rival is None:
            return None
        answer = by_words(text, len(rival.ids), min(NAMED, len(rival.ids)))
        if answer is None:
            parses = self._grounder.parser.parse(text, 2)
            options = [(name,) for name in rival.ids]
            answer = by_description(parses, pending.understanding.scene, options, self._grounder.learned.referring)
        if answer.kind != "chosen" or len(answer.places) != 1:
            return None
        chosen = Describer(pending.understanding.scene).describe(rival.ids[answer.places[0]]).text
        before, _, after = pending.understanding.parses[0].tree.text.rpartition(rival.text)
        course = pending.course
        said = self._grounder.understand(f"{before}{chosen}{after}", course.world, course.history)
        found = said.decided(course.before)
        action = found.actions[0] if found.actions else None
        return action if action is not None and action.destination is not None else None

    def _decided(self, pending: Pending, action: GroundedAction) -> Grounding:
        """The step that was asked about has its answer; the further ones follow."""
        step = pending.understanding
        if action.action == "place" and action.destination is None:
            option = Option(action.objects, action.probability, (("place", 1.0),))
            return self._ask(step.text, Pending(pending.course, step, (option,), 1, where=True))
        answer = pending.course.with_arm(
            Grounding(step.text, "grounded", (action,), phrases=step.decided().phrases)
        )
        result = self._taken(self._grounder.follow(pending.course.after(answer)))
        self._remember(pending.course, step, result)
        return result


def _pending(course: Course, understanding: Understanding, asked: Grounding) -> Pending | None:
    options = understanding.options()
    if not options:
        return None
    where = asked.alternatives[:1] and asked.alternatives[0].action == "place" and not (
        asked.question or "").startswith(("Do you", "Which", "Shall"))  # fmt: skip
    if where:
        first = asked.alternatives[0]
        chosen = Option(first.objects, first.probability, (("place", 1.0),))
        return Pending(course, understanding, (chosen,), 1, where=True)
    least = min(LISTED, 0.2 * options[0].probability)
    likely = tuple(option for option in options if option.probability >= least)
    return Pending(course, understanding, likely, min(NAMED, len(likely)))

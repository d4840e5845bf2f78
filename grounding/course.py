"""An instruction of several steps on its way: each step is grounded in the world that those before it leave."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace

from grounding.result import GroundedAction, Grounding, PhraseGrounding
from grounding.steps import Step
from grounding.symbols import Action
from grounding.world import World


@dataclass(frozen=True)
class Course:
    """What was decided of an instruction, and what is left.

    Attributes:
        text: the instruction.
        steps: all of them.
        world: as it is once what was decided is done.
        history: ids of the objects handled before, the latest last.
        done: the answers to the first steps.
        milliseconds: that finding the steps took.
        before: the world before what was handled last was moved, where that is known.
        arms: the hands that were named, one for all steps or one for each; none where none was.
    """

    text: str
    steps: tuple[Step, ...]
    world: World
    history: tuple[str, ...] = ()
    done: tuple[Grounding, ...] = ()
    milliseconds: float = 0.0
    before: World | None = None
    arms: tuple[str, ...] = ()

    def with_arm(self, answer: Grounding) -> Grounding:
        """The answer to the next step, with the hand that was named for it."""
        if not self.arms:
            return answer
        arm = self.arms[min(len(self.done), len(self.arms) - 1)]
        return replace(answer, actions=tuple(replace(a, arm=arm) for a in answer.actions),
                       alternatives=tuple(replace(a, arm=arm) for a in answer.alternatives))  # fmt: skip

    @property
    def next(self) -> Step | None:
        """The step that is to be grounded next."""
        return self.steps[len(self.done)] if len(self.done) < len(self.steps) else None

    def after(self, answer: Grounding) -> Course:
        """The course once a step has its answer."""
        world = self.world
        for action in answer.actions:
            world = world_after(world, action)
        handled = tuple(name for action in answer.actions for name in action.objects)
        picked = any(action.action == "pick" for action in answer.actions)  # where it lay is where it goes back
        before = self.world if picked or world is not self.world else self.before
        return replace(self, world=world, before=before, history=(*self.history, *handled), done=(*self.done, answer))

    def result(self, last: Grounding | None = None) -> Grounding:
        """The answer to all of it; where a step has none, what is to be said of that step.

        Args:
            last: of the step that has no answer.
        """
        found = self.done if last is None else (*self.done, last)
        if len(self.steps) == 1:
            return found[0]
        words = tuple(dict.fromkeys(word for one in found for word in one.unknown_words))
        mended = tuple(dict.fromkeys(pair for one in found for pair in one.mended))
        actions = tuple(action for one in found for action in one.actions)
        if last is not None:
            number = len(found)
            why = f"step {number} of {len(self.steps)}, {self.steps[number - 1][0].tree.text!r}: {last.explanation}"
            return replace(last, instruction=self.text, explanation=why, unknown_words=words, mended=mended,
                           phrases=_joined(self.steps, found, ()))  # fmt: skip
        told = "; ".join(dict.fromkeys(one.explanation for one in found if one.explanation))
        return Grounding(self.text, "grounded", actions, explanation=told, unknown_words=words, mended=mended,
                         phrases=_joined(self.steps, found, actions))  # fmt: skip


def world_after(world: World, action: GroundedAction) -> World:
    """The world once something was placed; what is picked up or cleared stays where it was, as nobody said where to."""
    if action.action != "place" or action.destination is None or len(action.objects) != 1:
        return world
    name = action.objects[0]
    moved = world[name].moved(action.destination.position)
    return world.with_objects(moved if item.id == name else item for item in world.objects)


def _joined(
    steps: Sequence[Step], found: Sequence[Grounding], actions: Sequence[GroundedAction]
) -> tuple[PhraseGrounding, ...]:
    """The phrases of all steps below one root, which means all that is to be done."""
    inner = [replace(phrase, depth=phrase.depth + 1) for one in found for phrase in one.phrases]
    leaves = [leaf for step in steps for leaf in step[0].tree.leaves]
    leaves = sorted({leaf.index: leaf for leaf in leaves}.values(), key=lambda leaf: leaf.index)
    text = " ".join(leaf.text for leaf in leaves)
    symbols = tuple((Action(a.action, tuple(sorted(a.objects))), a.probability) for a in actions)
    span = (leaves[0].index, leaves[-1].index)
    return (PhraseGrounding(text, "FRAG", span, 0, symbols), *inner)

"""Whether what the product says and does is understood by itself, over composed worlds, as JSON.

    python benchmarks/crossing.py [--worlds N] [--seed S] [--wrong N]

Described: an object of every world is described, and "pick up" with that description is grounded in the same world; it
should pick the object. Objects that no description singles out are counted apart. Placed: "put X REL Y" is grounded and
carried out on paper, and "pick up the block REL Y" is grounded in the world that comes about; it should pick X. X and Y
are called by what is understood, without modifiers behind their nouns, and nothing else stood so before: all that is
truer than one third is in the way.
"""

from __future__ import annotations

import argparse
import json
import sys
import time
from collections import Counter
from collections.abc import Iterator
from dataclasses import dataclass, field

import numpy as np

from grounding.corpus.compositions import compose_world
from grounding.distinguishing import Describer
from grounding.grounder import Grounder
from grounding.meaning.reader import Reader
from grounding.meaning.reading import Context
from grounding.model.evaluator import Evaluator
from grounding.world import World
from grounding.world.scene import ROBOT, Scene

ONE = ("to the left of {}", "to the right of {}", "in front of {}", "behind {}", "next to {}", "on {}", "touching {}",
       "near {}", "directly behind {}", "directly to the left of {}", "diagonal from {}")  # fmt: skip
TWO = ("between {} and {}",)
NONE = ("in the front left corner", "in the back right corner", "on the left side of the table",
        "at the back of the table", "in the middle of the table")  # fmt: skip
IN_THE_WAY = 1 / 3  # what holds so well of something else leaves open which is meant
_BEHIND = frozenset("to from in on at of next behind under my your".split())
_SWAPPED = {"me": "you", "you": "me", "my": "your", "your": "my"}


@dataclass
class Count:
    """What was tried and what became of it.

    Attributes:
        outcomes: by relation, or "" for descriptions: "right", "wrong", or why it was left out.
        wrong: texts that were, with their worlds.
    """

    outcomes: dict[str, Counter[str]] = field(default_factory=dict)
    wrong: list[str] = field(default_factory=list)

    def add(self, name: str, outcome: str, text: str = "") -> None:
        """Count one."""
        self.outcomes.setdefault(name, Counter())[outcome] += 1
        if outcome == "wrong":
            self.wrong.append(text)

    def share(self, *names: str) -> float | None:
        """The share of those that were tried that were right."""
        told = [self.outcomes[name] for name in names or self.outcomes]
        tried = sum(c["right"] + c["wrong"] for c in told)
        return round(sum(c["right"] for c in told) / tried, 4) if tried else None


class Crossing:
    """Describes and places in one world after the other.

    Args:
        grounder: that understands.
    """

    def __init__(self, grounder: Grounder) -> None:
        self.grounder = grounder
        self.described = Count()
        self.placed = Count()

    def _name(self, world: World, name: str) -> str | None:
        """What a person would call an object, where that is understood; None where no description singles it out."""
        text = Describer(self.grounder.scene(world)).describe(name).text
        if text.endswith(name):
            return None
        return " ".join(_SWAPPED.get(word, word) for word in text.split())

    def _picks(self, text: str, world: World, name: str) -> bool:
        return [a.objects for a in self.grounder.ground(text, world).actions] == [(name,)]

    def describe(self, world: World, label: str, name: str) -> None:
        """Describe an object and read the description back."""
        said = self._name(world, name)
        if said is None:
            self.described.add("", "not described")
            return
        text = f"pick up {said}"
        right = self._picks(text, world, name)
        self.described.add("", "right" if right else "wrong", f"{label} {name}: {text}")

    def place(self, world: World, label: str, relation: str, names: tuple[str, ...]) -> None:
        """Put the first object in relation to the others, and ask for what is in that relation."""
        thing, *others = names
        called = [self._name(world, name) for name in names]
        if not all(map(_is_plain, called)):
            self.placed.add(relation, "not called plainly")
            return
        if not all(
            self._picks(f"pick up {said}", world, name) for said, name in zip(called, names, strict=True)
        ):
            self.placed.add(relation, "not called")
            return
        where = relation.format(*called[1:])
        if self._in_the_way(world, where, thing):
            self.placed.add(relation, "in the way")
            return
        told = f"put {called[0]} {where}"
        answer = self.grounder.ground(told, world)
        if not answer.actions or answer.actions[0].objects != (thing,) or answer.actions[0].destination is None:
            self.placed.add(relation, f"not placed: {answer.outcome}")
            return
        destination = answer.actions[0].destination.position
        moved = world.with_objects(o.moved(destination) if o.id == thing else o for o in world.objects)
        again = called[1:] if relation.startswith("on ") else [self._name(moved, name) for name in others]
        if not all(map(_is_plain, again)):
            self.placed.add(relation, "not called plainly")
            return
        text = f"pick up the {world[thing].type} {relation.format(*again)}"
        right = self._picks(text, moved, thing)
        self.placed.add(relation, "right" if right else "wrong", f"{label} {thing}: {told} > {text}")

    def _in_the_way(self, world: World, where: str, thing: str) -> bool:
        """Whether something else is where something is to be put."""
        scene = self.grounder.scene(world)
        tree = self.grounder.parser.parse(f"pick up the {world[thing].type} {where}")[0].tree
        phrase = next(p for p in tree.preorder() if p.tag == "NP")
        referent = Reader(Context()).phrase(phrase)
        held = np.max([case.truth for case in Evaluator(scene, ROBOT).cases(referent)] or [np.zeros(scene.n)], axis=0)
        return any(held[i] > IN_THE_WAY for i in range(scene.n) if scene.layout.ids[i] != thing)


def _is_plain(said: str | None) -> bool:
    """Whether words call an object without a modifier behind its noun."""
    return said is not None and not _BEHIND & set(said.split())


def trials(rng: np.random.Generator, world: World, scene: Scene) -> Iterator[tuple[str, tuple[str, ...]]]:
    """Relations with the objects that are to be placed so."""
    clear = [name for name, free in zip(scene.layout.ids, scene.clear, strict=True) if free]
    if len(clear) < 3:
        return
    names = [str(name) for name in rng.permutation(clear)]
    for relations, count in ((ONE, 2), (TWO, 3), (NONE, 1)):
        yield str(rng.choice(relations)), tuple(names[:count])


def main() -> None:
    """Compose, describe, place, count, print."""
    parser = argparse.ArgumentParser(description=(__doc__ or "").splitlines()[0])
    parser.add_argument("--worlds", type=int, default=1000, metavar="N")
    parser.add_argument("--seed", type=int, default=0)
    parser.add_argument("--wrong", type=int, default=0, metavar="N", help="show N that are wrong on standard error")
    args = parser.parse_args()
    crossing, start = Crossing(Grounder.load()), time.perf_counter()
    for number in range(args.worlds):
        rng = np.random.default_rng([args.seed, number])
        label = f"w{number}"
        world = compose_world(rng, label).layout.world
        scene = crossing.grounder.scene(world)
        if not scene.n:
            continue
        crossing.describe(world, label, str(rng.choice(scene.layout.ids)))
        for relation, names in trials(rng, world, scene):
            crossing.place(world, label, relation, names)
    for line in [*crossing.described.wrong[: args.wrong], *crossing.placed.wrong[: args.wrong]]:
        print(line, file=sys.stderr)
    placed = crossing.placed
    print(json.dumps({
        "worlds": args.worlds, "described": crossing.described.share(), "placed": placed.share(),
        "by relation": {name: placed.share(name) for name in sorted(placed.outcomes)},
        "counts": {"described": crossing.described.outcomes.get("", {}), "placed": placed.outcomes},
        "seconds": round(time.perf_counter() - start, 1),
    }))  # fmt: skip


if __name__ == "__main__":
    main()

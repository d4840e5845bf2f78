"""What referents mean in a scene: their conditions become cases, candidates and features, and weights decide."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from grounding.lexicon import arrangement, colour, place
from grounding.lexicon.parameters import values
from grounding.lexicon.where import Where
from grounding.meaning.notation import write_referent
from grounding.meaning.referents import OBJECTS, PERSON, PLACE, SETS, Referent, Region
from grounding.model.arranging import arrangement_cases, conjoined_cases
from grounding.model.cases import Case, Denotation, Weights, combined
from grounding.model.things import thing_cases
from grounding.world import Array
from grounding.world.scene import ROBOT, Scene

KEPT = 200
"""An evaluator that has found so many meanings forgets them."""
EVEN = Weights({"set": 1.0, "looks": 1.0, "number": 1.0, "shadow": 1.0, "parse": 0.5, "parse.long": 0.3, "buried": -2.3,
                "stacked": -1.0})  # fmt: skip
"""Equal weights for all concepts."""


_Asked = tuple[tuple[str, ...], bytes, int | None, tuple[str, ...]]
"""Kinds of arrangement, of which objects they are made, their number, and the colours that were said."""


class Evaluator:
    """Evaluates referents in one scene with one view for unmarked directions.

    Args:
        scene: the world.
        view: whose left is meant where nobody is named.
        history: indices of the objects handled before, the latest last.
        weights: of features.
    """

    def __init__(
        self, scene: Scene, view: str = ROBOT, history: tuple[int, ...] = (), weights: Weights = EVEN
    ) -> None:
        self.scene = scene
        self.view = view
        self.history = history
        self.weights = weights
        self.where = Where.objects(scene)
        self._kept: dict[tuple[int, bytes, bool], tuple[Referent, Denotation]] = {}
        self._alike: dict[tuple[str, bytes, bool], Denotation] = {}
        self._candidates: dict[str, tuple[Case, ...]] = {}
        self._values = values()
        self._arranged: dict[_Asked, tuple[arrangement.Candidate, ...]] = {}

    def renewed(self) -> Evaluator:
        """Itself for another text: what referents mean by their words is kept, as long as that is not too much.

        Where parameters have other values than before (`grounding.lexicon.parameters.varied`) nothing is kept.
        """
        self._kept.clear()
        if len(self._alike) > KEPT or values() != self._values:
            self._values = values()
            self._alike.clear()
            self._candidates.clear()
            self._arranged.clear()
        return self

    def spot(self, region: Region) -> place.Spot:
        """A place as whoever is meant sees it."""
        return place.make_spot(self.scene, region.names, region.owner or self.view, middle=region.middle,
                               corner=region.corner, rim=region.rim, table=region.table)  # fmt: skip

    def arrangements(
        self, kinds: tuple[str, ...], stuff: np.ndarray, number: int | None, colours: tuple[str, ...] = ()
    ) -> tuple[arrangement.Candidate, ...]:
        """The arrangements of some kinds among objects, found once; see `arrangement.candidates`."""
        key = (kinds, stuff.tobytes(), number, colours)
        if key not in self._arranged:
            parts = [colour.truth(self.scene, (name,)) for name in colours] if len(colours) > 1 else []
            self._arranged[key] = tuple(arrangement.candidates(self.scene, kinds, stuff, number, parts))
        return self._arranged[key]

    def denote(self, referent: Referent, base: Array | None = None, *, carrying: bool = False) -> Denotation:
        """What a referent means; parses differ in trees more than in meanings, and what means the same is found once.

        Args:
            referent: of a text.
            base: how well every object is of the kind of what it modifies, shape (n,), where it is of that kind.
            carrying: whether it is spoken of because of what it carries.
        """
        alike = base if referent.like else None
        said = b"" if alike is None else alike.tobytes()
        key = (id(referent), said, carrying)
        if key not in self._kept:
            meant = (write_referent(referent), said, carrying)
            if meant not in self._alike:
                self._alike[meant] = self._denote(referent, alike, carrying=carrying)
            self._kept[key] = (referent, self._alike[meant])
        return self._kept[key][1]

    def candidates(self, referent: Referent) -> list[Case]:
        """All that a referent of things may mean, as cases of one's own to which more can be noted."""
        meant = write_referent(referent)
        if meant not in self._candidates:
            self._candidates[meant] = tuple(self.cases(referent))
        return [replace(case, scalars=dict(case.scalars), columns=dict(case.columns))
                for case in self._candidates[meant]]  # fmt: skip

    def cases(self, referent: Referent, base: Array | None = None, *, carrying: bool = False) -> list[Case]:
        """All that a referent of things may mean."""
        if referent.parts:
            return conjoined_cases(self, referent)
        if referent.sort == SETS and referent.kinds and not any(c.concept == "those" for c in referent.conditions):
            return arrangement_cases(self, referent)
        return thing_cases(self, referent, base, carrying=carrying)

    def _denote(self, referent: Referent, base: Array | None, *, carrying: bool) -> Denotation:
        n = self.scene.n
        if referent.sort == PERSON:
            return Denotation(np.zeros(n), person=referent.person)
        if referent.sort == PLACE and referent.region is not None:
            return Denotation(np.zeros(n), spot=self.spot(referent.region))
        if referent.sort not in (OBJECTS, SETS) or not n:
            return Denotation(np.zeros(n), truth=0.0 if referent.sort in (OBJECTS, SETS) else 1.0)
        cases = self.cases(referent, base, carrying=carrying)
        return combined(cases, self.weights, n, self.truth_within(referent, base), several=referent.sort == SETS)

    def truth_within(self, referent: Referent, base: Array | None = None) -> float:
        """The smallest truth of the referents to which a referent relates."""
        related = [r for c in referent.conditions if not c.negated for r in c.of] + list(referent.parts)
        return min((self.denote(r, base).truth for r in related if r.sort in (OBJECTS, SETS)), default=1.0)

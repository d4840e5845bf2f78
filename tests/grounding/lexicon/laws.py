"""Worlds in which concepts obey laws, and concepts asked for in them."""

from typing import NamedTuple

import numpy as np
from hypothesis import strategies as st

from grounding import World, make_object
from grounding.geometry.layout import Layout
from grounding.lexicon import alone, amount, between, colour, direction, nearness, person, place, rank
from grounding.lexicon.where import Where
from grounding.world import Viewpoint
from grounding.world.scene import ROBOT, SPEAKER, Scene

EDGE, TOP = 0.05, 0.736
TABLE = {"position": (0.65, 0.0, 0.691), "size": (0.7, 1.8, 0.04)}


class Setting(NamedTuple):
    """Where blocks lie and somebody stands, so that it can be mirrored, moved and shuffled.

    Attributes:
        points: of the blocks, shape (n, 2); the first three are references.
        colors: of the blocks.
        speaker: where the speaker stands (2,), looking at the table's middle.
        yaw: of the speaker.
        turn: of all blocks.
    """

    points: np.ndarray
    colors: tuple[str, ...]
    speaker: np.ndarray = np.array([1.6, 0.2])
    yaw: float = np.pi
    turn: float = 0.0

    def scene(self, order=None, table=True):
        """The setting measured, its blocks in some order."""
        turned = (np.cos(self.turn / 2), 0.0, 0.0, np.sin(self.turn / 2))
        blocks = [make_object(f"b{i}", color=self.colors[i], position=(*self.points[i], TOP), orientation=turned,
                              size=(EDGE,) * 3) for i in order or range(len(self.points))]  # fmt: skip
        top = [make_object("table", "table", "white", **TABLE)] if table else []
        return Scene(Layout(World((*top, *blocks), Viewpoint(np.array([*self.speaker, 0.0]), self.yaw))))

    def mirrored(self):
        """The same with left and right exchanged."""
        across = np.array([1.0, -1.0])
        return self._replace(points=self.points * across, speaker=self.speaker * across, yaw=-self.yaw,
                             turn=-self.turn)  # fmt: skip

    def moved(self, angle, shift):
        """The same, turned about the origin and shifted, with the one who looks."""
        c, s = np.cos(angle), np.sin(angle)
        turn = np.array([[c, -s], [s, c]])
        return self._replace(points=self.points @ turn.T + shift, speaker=turn @ self.speaker + shift,
                             yaw=self.yaw + angle, turn=self.turn + angle)  # fmt: skip


cells = st.lists(st.tuples(st.integers(0, 5), st.integers(-6, 6)), min_size=4, max_size=7, unique=True)
jitter = st.floats(0, 0.01)


@st.composite
def settings_of_blocks(draw):
    """Blocks on a grid, each a little off, so that none overlap and few are as good as others."""
    points = [(0.42 + 0.08 * x + draw(jitter), 0.09 * y + draw(jitter)) for x, y in draw(cells)]
    colors = tuple(draw(st.sampled_from(["red", "blue", "unknown"])) for _ in points)
    return Setting(np.array(points), colors)


def references(scene, *numbers):
    return [scene.layout.index[f"b{i}"] for i in numbers]


def whole(scene, value=1.0):
    return np.full(scene.n, value)


def _direction(strict):
    def held(scene, where, side, owner=ROBOT):
        (i,) = references(scene, 0)
        vector = direction.unit(scene, (side,), owner)
        return direction.truth(where, scene.xy[[i]], scene.edge, vector, strict=strict)[:, 0]

    return held


def _beyond(scene, where, side, owner=ROBOT):
    vector = direction.unit(scene, (side,), owner)
    return direction.truth_of_set(where, scene.xy[references(scene, 0, 1)], scene.edge, vector)


def _near(reach):
    def held(scene, where, side, owner=ROBOT):
        (i,) = references(scene, 0)
        return nearness.truth(where.gaps[:, i], scene.edge, reach)

    return held


def _between(scene, where, side, owner=ROBOT):
    first, second = scene.xy[references(scene, 0, 1)]
    return between.truth(where.xy, first, second, scene.edge)


def _measured(scene, where, side, owner=ROBOT):
    start = (scene.xy[references(scene, 0)[0]], 1.0)
    return amount.measured(where.xy, scene.edge, [start], scene.direction(side, owner), 2.0)


def _stepped(scene, where, side, owner=ROBOT):
    start = (scene.xy[references(scene, 0)[0]], 1.0)
    ways = [(scene.direction(side, owner), 1.0), (scene.direction("back", owner), 2.0)]
    return amount.stepped(where.xy, scene.edge, [start], ways)


ANYWHERE = {
    "toward": _direction(strict=False), "directly toward": _direction(strict=True), "beyond two": _beyond,
    "beside": _near(nearness.BESIDE), "touching": _near(nearness.TOUCHING), "between two": _between,
    "two blocks away": _measured, "steps away": _stepped,
    "preferred toward": lambda scene, where, side, owner=ROBOT: direction.preference(
        where.gaps[:, references(scene, 0)[0]], scene.edge),
}  # fmt: skip
"""Concepts of any place (scene, where, side, owner): by scene and place alone, whoever looks."""


def _spot(*names, **said):
    def spot(scene, side):
        return place.make_spot(scene, tuple(side if name == "side" else name for name in names), ROBOT, **said)

    return spot


SPOTS = {
    "side": _spot("side"), "back side": _spot("back"), "corner": _spot("side", "back"), "middle": _spot(middle=True),
    "middle of a side": _spot("side", middle=True), "a corner of a side": _spot("side", corner=True),
    "the edge": _spot(rim=True), "the table's side": _spot("side", table=True),
}  # fmt: skip


def _enclosed(scene, side):
    return between.enclosed(Where.objects(scene), scene, [between.Part(whole(scene), 3)])


def _between_some(scene, side):
    red = colour.truth(scene, ("red",))
    return between.between_two(Where.objects(scene), scene, red, red)


OF_OBJECTS = {
    **{f"at {name}": lambda scene, side, spot=spot: place.truth(scene, spot(scene, side))
       for name, spot in SPOTS.items()},
    **{f"deep in {name}": lambda scene, side, spot=spot: place.preference(scene, spot(scene, side), whole(scene) > 0)
       for name, spot in SPOTS.items()},
    "colour": lambda scene, side: colour.truth(scene, ("red",)),
    "alone": lambda scene, side: alone.truth(scene, whole(scene)),
    "alone of its colour": lambda scene, side: alone.truth(scene, colour.truth(scene, ("red",))),
    "before": lambda scene, side: person.before(scene, ROBOT),
    "outermost": lambda scene, side: rank.truth(whole(scene), scene.xy @ scene.direction(side), 1, rank.blur(scene)),
    "second": lambda scene, side: rank.truth(whole(scene, 0.7), scene.xy @ scene.direction(side), 2, rank.blur(scene)),
    "middle": lambda scene, side: rank.middle(scene, whole(scene), chosen=True),
    "enclosed": _enclosed, "between some": _between_some,
}  # fmt: skip
"""Concepts of objects (scene, side), as the robot sees them."""


def by_id(scene, degrees):
    """Degrees of objects by their ids, so that scenes in other orders compare."""
    return dict(zip(scene.layout.ids, degrees, strict=True))


__all__ = ["ANYWHERE", "OF_OBJECTS", "SPEAKER", "Setting", "by_id", "references", "settings_of_blocks"]

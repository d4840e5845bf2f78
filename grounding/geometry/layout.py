"""Υ, digested: what the features ask of a world, computed on demand, once, and shared by all its phrases."""

from __future__ import annotations

from collections.abc import Iterable, Mapping

import numpy as np

from grounding.geometry.arrangements import Arrangement, find_arrangements
from grounding.geometry.masks import indices_of, mask_of
from grounding.geometry.prominence import evident, prominent
from grounding.geometry.regions import in_any_region, in_region
from grounding.lazy import lazy
from grounding.symbols import LAST, Region
from grounding.world import Array, World

UPRIGHT = {"top": "back", "bottom": "front"}  # on a table seen from above, top is away
ABSOLUTE = ("left", "right", "front", "back", "near", "far", "top", "bottom")


class Layout:
    """Measurements of one world; index i is the i-th of `world.things`, sets are masks.

    Directions are the robot's: left is +y, back is +x, near and far are distances from the origin on the floor,
    center is closeness to the mean of the set that is looked at. Nothing here changes after it was computed.
    """

    def __init__(self, world: World) -> None:
        self.world = world
        self.things = world.things
        self.ids = tuple(item.id for item in self.things)
        self.index = {object_id: i for i, object_id in enumerate(self.ids)}
        self.size = len(self.things)
        self.everything = (1 << self.size) - 1
        self.positions = world.positions
        self._ranked: dict[tuple[int, str], tuple[int, ...]] = {}
        self._regions: dict[Region, int] = {}
        self._fitting: dict[tuple[tuple[str, ...], int, frozenset[int]], tuple[Arrangement, ...]] = {}
        self._evident_of: dict[tuple[tuple[str, ...], int], tuple[Arrangement, ...]] = {}
        self._names: dict[int, tuple[str, ...]] = {}
        self._stacked: dict[int, bool] = {}
        self._mean_extent: dict[tuple[int, str], float] = {}
        self._matching: dict[tuple[str | None, str | None], int] = {}

    @lazy
    def edges(self) -> Array:
        """Mean edge of every object, shape (n,) in [m]."""
        return np.array([item.size.mean() for item in self.things])

    @lazy
    def edge(self) -> float:
        """The typical edge in [m]."""
        return float(np.median(self.edges)) if self.size else 0.05

    @lazy
    def arrangements(self) -> tuple[Arrangement, ...]:
        """Lines, circles, clusters and towers."""
        return find_arrangements(self.positions, self.edges)

    @lazy
    def evident(self) -> frozenset[tuple[str, int]]:
        """What people would name unasked, by kind and members; see `evident`."""
        return evident(self.arrangements)

    def fitting(self, kinds: tuple[str, ...], wanted: int, counts: frozenset[int]) -> tuple[Arrangement, ...]:
        """The prominent arrangements of some kinds (any if empty), made of wanted objects, of some counts (any)."""
        key = (kinds, wanted, counts)
        if key not in self._fitting:
            self._fitting[key] = self.prominent(
                a
                for a in self.arrangements
                if (not kinds or a.kind in kinds) and not a.mask & ~wanted and (not counts or a.count in counts)
            )
        return self._fitting[key]

    def evident_of(self, kinds: tuple[str, ...], wanted: int) -> tuple[Arrangement, ...]:
        """The evident arrangements of some kinds (any if empty), made of wanted objects; most prominent first."""
        key = (kinds, wanted)
        if key not in self._evident_of:
            found = [
                a
                for a in self.arrangements
                if (a.kind, a.mask) in self.evident and (not kinds or a.kind in kinds) and not a.mask & ~wanted
            ]
            self._evident_of[key] = tuple(sorted(found, key=lambda a: (-a.prominence, a.kind, a.mask)))
        return self._evident_of[key]

    @lazy
    def by_members(self) -> Mapping[tuple[str, int], Arrangement]:
        """The arrangements by kind and members."""
        return {(a.kind, a.mask): a for a in self.arrangements}

    prominent = staticmethod(prominent)

    @lazy
    def clear_top(self) -> int:
        """The objects that carry no other one."""
        mask = self.everything
        for tower in self.arrangements:
            if tower.kind == "tower":
                members = list(indices_of(tower.mask))
                highest = max(members, key=lambda i: self.positions[i, 2])
                mask &= ~tower.mask | (1 << highest)
        return mask

    @lazy
    def colors(self) -> frozenset[str]:
        """The colours that occur among the things."""
        return frozenset(item.color for item in self.things)

    @lazy
    def types(self) -> frozenset[str]:
        """The types that occur in the world, furniture included."""
        return frozenset(item.type for item in self.world.objects)

    @lazy
    def kinds(self) -> frozenset[str]:
        """The types of what can be handled."""
        return frozenset(item.type for item in self.things)

    @lazy
    def _scores(self) -> dict[str, Array]:
        x, y, z = self.positions.T
        distance = np.hypot(x, y)
        return {
            "left": y, "right": -y, "front": -x, "back": x, "near": -distance, "far": distance, "top": z, "bottom": -z,
        }  # fmt: skip

    def mask(self, ids: Iterable[str]) -> int:
        """The set of the given ids; ids of furniture are left out."""
        return mask_of(self.index[i] for i in ids if i in self.index)

    def names(self, mask: int) -> tuple[str, ...]:
        """The ids in a set."""
        found = self._names.get(mask)
        if found is None:
            found = self._names[mask] = tuple([self.ids[i] for i in indices_of(mask)])
        return found

    def matching(self, object_type: str | None, color: str | None) -> int:
        """The things of a type and a colour; None where nothing is asked.

        A thing whose colour nobody knows may have the colour asked for, where none is known to have it.
        """
        key = (object_type, color)
        if key not in self._matching:
            of_type = [i for i, item in enumerate(self.things) if object_type is None or item.type == object_type]
            known = [i for i in of_type if color is None or self.things[i].color == color]
            self._matching[key] = mask_of(known or [i for i in of_type if self.things[i].color == "unknown"])
        return self._matching[key]

    def extent(self, mask: int, direction: str) -> Array:
        """How far each member of a set lies in a direction, in the order of `indices_of(mask)`, in [m]."""
        members = list(indices_of(mask))
        if direction == "center" and members:
            points = self.positions[members]
            return np.asarray(-np.linalg.norm(points[:, :2] - points[:, :2].mean(axis=0), axis=1))
        return self._scores.get(direction, self.positions[:, 2])[members]

    def mean_extent(self, mask: int, direction: str) -> float:
        """How far a set lies in a direction on average, in [m]."""
        key = (mask, direction)
        if key not in self._mean_extent:
            self._mean_extent[key] = float(self.extent(mask, direction).mean())
        return self._mean_extent[key]

    def ranked(self, mask: int, direction: str) -> tuple[int, ...]:
        """The members of a set, the most extreme in a direction first; equal ones: the higher, then by id."""
        key = (mask, direction)
        if key not in self._ranked:
            members = list(indices_of(mask))
            if direction in ("between",) or not members:
                self._ranked[key] = ()
            else:
                score = self.extent(mask, direction)
                heights = self.positions[members, 2]
                order = np.lexsort((np.array(members), -heights, -np.round(score, 4)))
                self._ranked[key] = tuple(members[i] for i in order)
        return self._ranked[key]

    def nth(self, mask: int, direction: str, index: int) -> int:
        """The set of the index-th member in a direction (from 1; `LAST` is the last); empty where there is none."""
        order = self.ranked(mask, direction)
        if index == LAST:
            return 1 << order[-1] if order else 0
        return 1 << order[index - 1] if 0 < index <= len(order) else 0

    def central(self, mask: int) -> int:
        """The member nearest to the middle of everything that lies there."""
        members = list(indices_of(mask))
        if not members:
            return 0
        away = np.linalg.norm(self.positions[members, :2] - self.positions[:, :2].mean(axis=0), axis=1)
        return 1 << members[int(np.argmin(away))]

    def extreme(self, mask: int, direction: str, count: int) -> int:
        """The `count` most extreme members in a direction; empty where there are fewer."""
        order = self.ranked(mask, direction)
        return mask_of(order[:count]) if 0 < count <= len(order) else 0

    def median(self, mask: int) -> int:
        """The middle member by rank along the set's main axis; empty for an even number."""
        members = list(indices_of(mask))
        if len(members) % 2 == 0:
            return 0
        points = self.positions[members]
        axis = np.linalg.svd(points - points.mean(axis=0), full_matrices=False)[2][0]
        return 1 << members[int(np.argsort(points @ axis, kind="stable")[len(members) // 2])]

    def within(self, region: Region) -> int:
        """The things in a region; everything where it is the robot's.

        A region of a container lies outside the container as a whole. Of several objects that are no container, it is
        enough to lie in the region of one ("behind a green block").
        """
        if region.kind == "robot":
            return self.everything
        if region not in self._regions:
            items = [self.world.by_id[i] for i in region.objects if i in self.world.by_id]
            if region.kind == "object" and len(items) > 1 and region.relation != "between":
                inside = mask_of(np.flatnonzero(in_any_region(region.relation, items, self.things)))
            else:
                inside = mask_of(np.flatnonzero(in_region(region.relation, items, self.things)))
                inside &= ~self.mask(region.objects)
            self._regions[region] = inside
        return self._regions[region]

    def side(self, direction: str) -> int | None:
        """The things on one half of the table; None where the direction has no half."""
        if direction not in ("left", "right", "front", "back"):
            return None
        tables = tuple(item.id for item in self.world.objects if item.type == "table")[:1]
        if tables:
            return self.within(Region(direction, "object", tables))
        extent = self.extent(self.everything, direction)
        return mask_of(np.flatnonzero(extent > extent.mean())) if len(extent) else 0

    def stacked(self, mask: int) -> bool:
        """Whether members of a set lie at different heights."""
        if mask not in self._stacked:
            heights = self.positions[list(indices_of(mask)), 2]
            self._stacked[mask] = len(heights) > 1 and float(heights.max() - heights.min()) > 0.5 * self.edge
        return self._stacked[mask]

    @lazy
    def has_stacks(self) -> bool:
        """Whether things lie at different heights."""
        return self.stacked(self.everything)

    def distance_to(self, mask: int, reference: tuple[str, ...]) -> Array:
        """Distance of each member of a set to the nearest reference object, on the floor, in [m]."""
        points = np.array([self.world.by_id[i].position[:2] for i in reference if i in self.world.by_id])
        members = self.positions[list(indices_of(mask)), :2]
        return np.linalg.norm(members[:, None] - points[None], axis=2).min(axis=1)

"""Sets of objects named by how they come about: reference sets, and selections from them.

`nth[mod.in|head|head]` is the object that the head's index and the head's direction select within what the modifier
grounded to. Restrictors come before selectors: type, colour, containers, regions and sides make the reference sets,
ordinals, superlatives and counts select from them.
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from grounding.features.sources import NOTHING, Source
from grounding.geometry.layout import UPRIGHT, Layout
from grounding.geometry.masks import indices_of, single
from grounding.lazy import lazy
from grounding.symbols import ObjectAttribute

_SAYING = ("own", "head", "mod", "inner", "object", "below")  # whose directions, indices and numbers count


class NamedSets:
    """The sets of one phrase, computed when asked for."""

    def __init__(self, sources: dict[str, Source], layout: Layout) -> None:
        self.sources = sources
        self.layout = layout

    def first(self, what: str) -> str | None:
        """The first type or colour that the phrase or its head speaks of."""
        for role in ("own", "head", "object", "mod", "inner"):
            values = getattr(self.sources.get(role, NOTHING), what)
            if role == "mod" and not self.sources.get("head", NOTHING).kinds:
                continue  # what a modifier of an object speaks of is another thing
            if values:
                return str(values[0])
        return None

    @lazy
    def base(self) -> int:
        """The things of the type and the colour that the phrase speaks of."""
        return self.layout.matching(self.first("types"), self.first("colors"))

    @lazy
    def references(self) -> dict[str, int]:
        """Sets within which something may be selected."""
        layout, base = self.layout, self.base
        found = {"all": base}
        for role in ("head", "mod", "inner", "object", "part"):
            source = self.sources.get(role)
            if source is None:
                continue
            if source.containers:
                found[f"{role}.in"] = base & max((mask for _, mask in source.containers), key=int.bit_count)
            elif source.objects:
                found[f"{role}.in"] = base & source.objects
            for region in source.regions[:1]:
                if region.kind != "robot":
                    found[f"{role}.region"] = base & layout.within(region)
            if role == "mod" and source.relations:
                side = layout.side(source.relations[0])
                if side is not None:
                    found["mod.side"] = base & side
        if "mod.region" in found or "mod.in" in found:
            del found["all"]  # what a modifier restricts is looked for within it only
        if self.ranked_again:
            found.pop("head.in", None)
        for role in ("head", "inner", "object"):  # what was carried upward: a set and a region
            if f"{role}.in" in found and f"{role}.region" in found:
                found[f"{role}.both"] = found[f"{role}.in"] & found[f"{role}.region"]
        return found

    @lazy
    def ranked_again(self) -> bool:
        """Whether the one that the head has ranked among all is to be ranked again, within what the modifier means.

        "The middle block" is some block; "the middle block of the row" need not be that one.
        """
        head, mod = self.sources.get("head", NOTHING), self.sources.get("mod", NOTHING)
        restricted = bool(mod.containers) or any(region.kind != "robot" for region in mod.regions)
        ranks = any(a.relation is not None and a.index is not None for a in head.attributes)
        return restricted and ranks and single(head.objects)

    @lazy
    def lined(self) -> frozenset[str]:
        """The reference sets that are rows, columns or towers: their middle is by rank."""
        return frozenset(
            f"{role}.in"
            for role, source in self.sources.items()
            if any(kind in ("row", "column", "tower") for kind, _ in source.containers)
        )

    @lazy
    def directions(self) -> tuple[tuple[str, str], ...]:
        """(who says it, direction), every one that is spoken of; ranks without one may be counted from the robot."""
        said = tuple((role, d) for role in _SAYING for d in self.sources.get(role, NOTHING).relations)
        if said or not any(self.sources.get(role, NOTHING).indices for role in _SAYING):
            return said
        return (("unsaid", "near"),)

    @lazy
    def indices(self) -> tuple[tuple[str, int], ...]:
        """(who says it, rank); ("first", 1) where nobody says one."""
        said = tuple((role, i) for role in _SAYING for i in self.sources.get(role, NOTHING).indices)
        return said or (("first", 1),)

    @lazy
    def numbers(self) -> tuple[tuple[str, int], ...]:
        """(who says it, count)."""
        return tuple((role, k) for role in _SAYING for k in self.sources.get(role, NOTHING).numbers)

    @lazy
    def named(self) -> dict[str, int]:
        """All sets by their names; empty ones are left out."""
        layout = self.layout
        found: dict[str, int] = {}
        for ref, mask in self.references.items():
            if not mask:
                continue
            found[f"all[{ref}]"] = mask
            if single(mask):
                found[f"only[{ref}]"] = mask
            for who, count in self.numbers:
                if mask.bit_count() == count:
                    found[f"count[{ref}|{who}]"] = mask
            for who, direction in self.directions:
                if direction == "between":
                    continue
                flat = UPRIGHT.get(direction)
                upright = flat is None or layout.stacked(mask)
                if direction == "center" and ref in self.lined:
                    found[f"middle[{ref}]"] = layout.median(mask)
                    continue
                for index_who, index in self.indices:
                    if upright:
                        found[f"nth[{ref}|{who}|{index_who}]"] = layout.nth(mask, direction, index)
                    if flat is not None:
                        found[f"flat[{ref}|{who}|{index_who}]"] = layout.nth(mask, flat, index)
                if direction == "center":
                    found[f"middle[{ref}]"] = layout.median(mask)
                    found[f"central[{ref}]"] = layout.central(mask)
                for count_who, count in self.numbers:
                    found[f"k[{ref}|{who}|{count_who}]"] = layout.extreme(mask, flat or direction, count)
        found.update(self._closest())
        found.update(self._members_of_regions())
        return {name: mask for name, mask in found.items() if mask}

    def _nearest(self, pool: int, names: tuple[str, ...]) -> int:
        away = self.layout.distance_to(pool, names)
        members = list(indices_of(pool))
        order = np.argsort(away, kind="stable")
        if len(order) > 1 and away[order[0]] > 0.75 * away[order[1]] and "table" in names:
            return 0
        return 1 << members[int(order[0])]

    def _members_of_regions(self) -> dict[str, int]:
        """What lies in a region's direction among the region's own reference: the top of a tower, the end of a row."""
        found = {}
        for role in ("mod", "inner"):
            for region in self.sources.get(role, NOTHING).regions[:1]:
                pool = self.base & self.layout.mask(region.objects)
                if pool and region.relation != "between":
                    found[f"nth[{role}.of]"] = self.layout.nth(pool, region.relation, 1)
                    if region.relation == "center":
                        found[f"middle[{role}.of]"] = self.layout.median(pool)
                    flat = UPRIGHT.get(region.relation)
                    if flat is not None:
                        found[f"flat[{role}.of]"] = self.layout.nth(pool, flat, 1)
        return found

    def _closest(self) -> dict[str, int]:
        found = {}
        for role in ("mod", "inner"):
            source = self.sources.get(role)
            if source is None:
                continue
            names = self.layout.names(source.objects)
            if not names and source.regions and source.regions[0].kind != "robot":
                names = source.regions[0].objects
            pool = self.base & ~self.layout.mask(names)
            if names and pool:
                found[f"closest[{role}]"] = self._nearest(pool, names)
            inside = self.references.get(f"{role}.region", 0)
            if names and inside & (inside - 1):
                found[f"closest[{role}.region]"] = self._nearest(inside, names)
        return found

    def ranked_by(self, who: str, attributes: Sequence[ObjectAttribute]) -> dict[str, int]:
        """What the first of some attributes selects within every reference set, by its relation and its index."""
        found: dict[str, int] = {}
        for attribute in attributes[:1]:
            if attribute.index is None or attribute.relation in (None, "between"):
                continue
            for ref, mask in self.references.items():
                upright = attribute.relation not in UPRIGHT or self.layout.stacked(mask)
                direction = attribute.relation if upright else UPRIGHT[attribute.relation]
                if direction == "center" and ref in self.lined:
                    chosen = self.layout.median(mask) or self.layout.central(mask)
                else:
                    chosen = self.layout.nth(mask, direction, attribute.index)
                if chosen:
                    found[f"ranked[{ref}|{who}]"] = chosen
        return found

    @lazy
    def of_object(self) -> dict[int, tuple[str, ...]]:
        """For every object that is in some set, by index: the names of its sets."""
        found: dict[int, list[str]] = {}
        for name, mask in self.named.items():
            for index in indices_of(mask):
                found.setdefault(index, []).append(name)
        return {index: tuple(names) for index, names in found.items()}

    @lazy
    def by_mask(self) -> dict[int, tuple[str, ...]]:
        """The names of every set, by its members."""
        found: dict[int, list[str]] = {}
        for name, mask in self.named.items():
            found.setdefault(mask, []).append(name)
        return {mask: tuple(names) for mask, names in found.items()}

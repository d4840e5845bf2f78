"""Arrangements that a phrase may mean, named by how they come about: the only fitting row, the leftmost of them, ..."""

from __future__ import annotations

import numpy as np

from grounding.features.sets import NamedSets
from grounding.features.sources import NOTHING, Source
from grounding.geometry.arrangements import Arrangement
from grounding.geometry.layout import UPRIGHT, Layout
from grounding.lazy import lazy


class Fitting:
    """The arrangements of one phrase, computed when asked for."""

    def __init__(self, sources: dict[str, Source], sets: NamedSets, layout: Layout) -> None:
        self.sources = sources
        self.sets = sets
        self.layout = layout

    @lazy
    def kinds(self) -> tuple[str, ...]:
        """The kinds that the phrase or its parts speak of, those of the phrase and its head first."""
        for roles in (("own", "head"), ("inner", "mod", "object")):
            kinds = [kind for role in roles for kind in self.sources.get(role, NOTHING).kinds]
            if kinds:
                return tuple(dict.fromkeys(kinds))
        return ()

    @lazy
    def wanted(self) -> int:
        """The objects that its members may be: by what any part says of type and colour."""
        types = [t for source in self.sources.values() for t in source.types]
        colors = [c for source in self.sources.values() for c in source.colors]
        return self.layout.matching(types[0] if types else None, colors[0] if colors else None)

    @lazy
    def lists(self) -> dict[str, tuple[Arrangement, ...]]:
        """Lists of candidates, by how they were narrowed down; the most prominent of overlapping ones only."""
        layout = self.layout
        seen = layout.fitting(self.kinds, self.wanted, frozenset())
        found = {"seen": seen, "evident": layout.evident_of(self.kinds, self.wanted)}
        counts = frozenset(count for _, count in self.sets.numbers)
        if counts:
            found["counted"] = layout.fitting(self.kinds, self.wanted, counts)
            found["evident counted"] = tuple(a for a in found["evident"] if a.count in counts)
        for role in ("mod", "inner", "head"):
            source = self.sources.get(role)
            if source is None:
                continue
            inside = None
            if source.regions and source.regions[0].kind != "robot":
                inside = layout.within(source.regions[0])
            elif source.objects and not source.containers:
                inside = source.objects
            elif role == "mod" and source.relations:
                inside = self.layout.side(source.relations[0])
            if inside is not None:
                base = found.get("evident counted") or found.get("counted", found["evident"] or seen)
                found[f"{role}.side" if source.relations and not source.regions else f"{role}.within"] = tuple(
                    a for a in base if not a.mask & ~inside
                )
        return found

    @lazy
    def named(self) -> dict[tuple[str, int], tuple[str, ...]]:
        """The names of every fitting arrangement, by kind and members."""
        found: dict[tuple[str, int], list[str]] = {}
        for name, arrangements in self.lists.items():
            if not arrangements:
                continue
            for a in arrangements:
                found.setdefault((a.kind, a.mask), []).append(f"in[{name}]")
            if len(arrangements) == 1:
                found[arrangements[0].kind, arrangements[0].mask].append(f"only[{name}]")
            else:
                best = "clear best" if arrangements[0].prominence > 1.5 * arrangements[1].prominence else "best"
                found[arrangements[0].kind, arrangements[0].mask].append(f"{best}[{name}]")
                by_size = sorted(arrangements, key=lambda a: -a.count)
                if by_size[0].count > by_size[1].count:
                    found[by_size[0].kind, by_size[0].mask].append(f"largest[{name}]")
                if by_size[-1].count < by_size[-2].count:
                    found[by_size[-1].kind, by_size[-1].mask].append(f"smallest[{name}]")
            for who, direction in self.sets.directions:
                order = self._ranked(arrangements, UPRIGHT.get(direction, direction))
                for index_who, index in self.sets.indices:
                    place = len(order) - 1 if index < 0 else index - 1
                    if 0 <= place < len(order):
                        chosen = order[place]
                        found[chosen.kind, chosen.mask].append(f"nth[{name}|{who}|{index_who}]")
        return {key: tuple(names) for key, names in found.items()}

    def _ranked(self, arrangements: tuple[Arrangement, ...], direction: str) -> list[Arrangement]:
        if direction == "between":
            return []
        if direction == "center":
            middle = self.layout.positions[:, :2].mean(axis=0)
            score = [-float(np.hypot(*(a.centroid[:2] - middle))) for a in arrangements]
        else:
            score = [self.layout.mean_extent(a.mask, direction) for a in arrangements]
        return [arrangements[i] for i in sorted(range(len(arrangements)), key=lambda i: -score[i])]

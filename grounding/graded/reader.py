"""The graded reading of phrases: every noun phrase and modifier is worth a degree for every object."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from grounding.graded import history as past
from grounding.graded import scores, sets
from grounding.graded import words as w
from grounding.graded.nouns import Noun, read_noun, read_words
from grounding.graded.scene import ROBOT, Scene
from grounding.graded.values import Effect, Membership, Place, Rank, Restriction, Value
from grounding.language.lexicon import meanings
from grounding.language.tree import Phrase, Word
from grounding.symbols import Cardinal, Ordinal
from grounding.world import Array

FLOOR = 0.02  # a restriction that does not hold leaves so much: words and eyes err
STRANGE = 0.08  # a thing called by an unknown name is hardly one of those that are there
BURIED = 0.1  # what carries something is less likely spoken of
STACKED = 0.35  # who means the top of a stack mostly says so
SETS = 5  # of the sets that a modifier may mean, so many are tried
_ALIASES = {
    "blue": ("purple",), "purple": ("blue",), "orange": ("red", "brown"), "red": ("orange", "pink"),
    "yellow": ("orange",), "gray": ("white", "black"), "brown": ("orange",), "pink": ("red", "purple"),
}  # fmt: skip
VIEWS = frozenset("perspective view viewpoint standpoint vantage position point".split())
_OPPOSITE = {"left": "right", "right": "left", "front": "back", "back": "front", "up": "down", "down": "up"}
_HORIZONTAL = {"up": "back", "down": "front"}


class Reader:
    """Reads phrases in one scene with one view for unmarked directions.

    Args:
        scene: the world.
        view: whose left is meant where nobody is named.
        history: indices of the objects handled before, the latest last.
        context: what was spoken of before, weights (n,), or None.
    """

    def __init__(self, scene: Scene, view: str = ROBOT, history: tuple[int, ...] = (), context: Array | None = None):
        self.scene = scene
        self.view = view
        self.history = history
        self.context = context
        self.unknown: list[str] = []
        self._depth = 0

    # -- noun phrases ----------------------------------------------------------------------------------------------

    def value(self, phrase: Phrase) -> Value:
        """What a noun phrase is worth."""
        return self.noun(read_noun(phrase))

    def noun(self, noun: Noun) -> Value:
        """What a noun that was read is worth."""
        n = self.scene.n
        if self.history and past.is_recalled(noun):
            return Value("objects", past.latest(self.history, self._base(noun)))
        if noun.conjoined:
            return self._conjoined(noun)
        if noun.head == "agent":
            return Value("agent", np.zeros(n), agent=noun.agent)
        if noun.head == "table":
            return Value("table", np.zeros(n))
        if noun.head == "pronoun":
            return self._pronoun(noun)
        if noun.head == "place":
            return self._place_value(noun)
        if noun.head == "container":
            return self._container(noun)
        if noun.head in ("block", "other"):
            return self._objects(noun)
        return Value("nothing", np.zeros(n))

    def value_of(self, noun: Noun) -> Array:
        """The weights of a noun."""
        return self.noun(noun).weights

    def everything_in(self, noun: Noun) -> Value:
        """All that lies on the table or on a side of it: what "clear the left side" means."""
        scene = self.scene
        value = self.noun(noun)
        inside = np.ones(scene.n, dtype=bool)
        for direction in value.place.directions if value.place is not None else ():
            inside &= scene.scaled @ direction > 0
        weights = inside.astype(float)
        return Value("sets", weights, ((inside, 1.0),)) if inside.any() else Value("nothing", weights)

    def within(self, noun: Noun, pool: Array) -> Array:
        """What a noun means among objects that were spoken of, weights (n,)."""
        inside = np.where(pool > 0.3 * max(float(pool.max(initial=0)), 1e-9), 1.0, FLOOR * FLOOR)
        return self._select(*self._modified(noun, self._base(noun) * inside)).weights

    def ranked_again(self, target: Array, rank: Rank) -> Array:
        """Objects that were found, ranked by what is said afterwards."""
        return target * scores.ranked(
            target / max(float(target.max(initial=0)), 1e-9), rank.key, rank.ordinal or 1, rank.noise
        )

    def _pronoun(self, noun: Noun) -> Value:
        if self.context is not None:
            return Value("objects", self.context)
        weights = np.zeros(self.scene.n)
        if self.history:
            weights[self.history[-1]] = 1.0
        return Value("objects", weights) if self.history else Value("nothing", weights)

    def _conjoined(self, noun: Noun) -> Value:
        first = read_noun(noun.conjoined[0])
        if first.head == "block" and all(not _has_noun(part) for part in noun.conjoined[1:]):
            return self.noun(replace(first, modifiers=(*first.modifiers, *noun.conjoined[1:], *noun.modifiers)))
        parts = [self.value(part) for part in noun.conjoined]
        pools = [p.weights for p in parts if p.kind in ("objects", "sets")]
        if not pools:
            return Value("nothing", np.zeros(self.scene.n))
        found = []
        if len(pools) == 2:
            one, other = pools
            order = [(float(one[i] * other[j]), i, j) for i in np.argsort(-one)[:4] for j in np.argsort(-other)[:4]]
            for weight, i, j in sorted(order, key=lambda item: -item[0])[:SETS]:
                if i != j and weight > 0.01:
                    mask = np.zeros(self.scene.n, dtype=bool)
                    mask[[i, j]] = True
                    found.append((mask, weight))
        return Value("sets", np.max(pools, axis=0), tuple(found), definite=noun.definite, number=len(parts))

    def _base(self, noun: Noun) -> Array:
        scene = self.scene
        weights = np.ones(scene.n)
        if noun.colors:
            known = scene.layout.colors
            wanted = set(noun.colors)
            if not wanted & known:
                wanted |= {alias for color in noun.colors for alias in _ALIASES.get(color, ())}
            has = np.array([item.color in wanted or item.color == "unknown" for item in scene.layout.things])
            weights = np.where(has, 1.0, 0.0)
        return weights

    def _objects(self, noun: Noun) -> Value:
        scene = self.scene
        if noun.head == "other" and not (noun.modifiers or noun.colors):
            return Value("nothing", np.zeros(scene.n))
        base = self._base(noun) * (STRANGE if noun.strange else 1.0)
        return self._select(*self._modified(noun, base))

    def _modified(self, noun: Noun, base: Array) -> tuple[Noun, Array, list[Effect]]:
        """A noun with the effects of its modifiers; "closest ... to you" is taken together."""
        effects: list[Effect] = []
        for modifier in noun.modifiers:
            if noun.distance and (reference := _complement(modifier)) is not None:
                found = self._distance_rank(read_noun(reference), noun.distance, None, "from" in modifier.text.split())
                if found:
                    noun = replace(noun, distance=None)
                    effects += found
                    continue
            effects += self.effects(modifier, base)
        return noun, base, effects

    def _select(self, noun: Noun, base: Array, effects: list[Effect]) -> Value:
        """Restrictors before selectors."""
        scene = self.scene
        weights = base.copy()
        in_stack = any(
            isinstance(e, Membership) and any((m.any() and scene.stacked[m].all()) for m, _ in e.sets) for e in effects
        )
        memberships: list[Membership] = []
        ranks: list[Rank] = []
        preference = np.ones(scene.n)
        for effect in effects:
            if isinstance(effect, Restriction) and effect.preferred:
                preference = preference * (FLOOR + (1 - FLOOR) * effect.weights)
            elif isinstance(effect, Restriction):
                weights = weights * (FLOOR + (1 - FLOOR) * _counted(effect, noun))
                if effect.order is not None and noun.ordinals:
                    ranks.append(Rank(effect.order, None, 0.3 * scene.edge))
            elif isinstance(effect, Membership):
                memberships.append(effect)
            else:
                ranks.append(effect)
        if noun.lone:
            weights = weights * (FLOOR + (1 - FLOOR) * self._lone(base))
        if noun.other and self.context is not None:
            weights = weights * (1 - 0.98 * self.context)
        elif noun.other and self.history:
            colors = tuple(item.color for item in scene.layout.things)
            weights = weights * (FLOOR + (1 - FLOOR) * past.others(self.history, colors, noun))
        if not in_stack and not noun.plural and "up" not in noun.directions and "down" not in noun.directions:
            weights = weights * np.where(scene.clear, np.where(scene.stacked, STACKED, 1.0), BURIED)
        choices = [(np.ones(scene.n), 1.0)]
        for membership in memberships:
            tops = list(membership.sets[:SETS])
            choices = [
                (mask * member, weight * chance) for mask, weight in choices for member, chance in tops
            ] or choices
        total = np.zeros(scene.n)
        found: list[tuple[np.ndarray, float]] = []
        for member, chance in choices:
            pool = weights * np.where(member > 0, 1.0, FLOOR * FLOOR)
            if noun.only and memberships:
                chance *= float(np.exp(-1.2 * abs(int((pool > 0.3).sum()) - 1)))
            kinds = memberships[0].kinds if memberships else ()
            picked = self._ranked(noun, pool, list(ranks), bool(memberships), in_stack, kinds)
            if noun.plural and not picked[1]:
                found += [(m, s * chance) for m, s in self._several(noun, pool, ranks)]
            total += chance * picked[0]
        total = total / max(1.0, sum(c for _, c in choices))
        ranking = bool(ranks or noun.ordinals or noun.distance or noun.directions)
        total = total * preference ** (0.15 if ranking else 1.0)
        if noun.plural:
            found = sorted(found, key=lambda item: -item[1])[:SETS]
            pool = np.zeros(scene.n)
            for mask, weight in found:
                pool = np.maximum(pool, mask * weight)
            return Value("sets", pool, tuple(found), definite=noun.definite, number=noun.number)
        return Value("objects", total, definite=noun.definite)

    def _several(self, noun: Noun, pool: Array, ranks: list[Rank]) -> list[tuple[np.ndarray, float]]:
        ranks = ranks + self._adjectives(noun, pool, False, False)
        if ranks and noun.number:
            likely = np.flatnonzero(pool > 0.3 * max(float(pool.max(initial=0)), 1e-9))
            if len(likely) >= noun.number:
                key = sum(r.key / r.noise for r in ranks)
                order = likely[np.argsort(-np.asarray(key)[likely], kind="stable")][: noun.number]
                mask = np.zeros(self.scene.n, dtype=bool)
                mask[order] = True
                return [(mask, float(pool[order].mean()))]
        return sets.collected(self.scene, pool, noun.number, noun.universal)

    def _ranked(
        self, noun: Noun, pool: Array, ranks: list[Rank], chosen: bool, in_stack: bool, kinds: tuple[str, ...] = ()
    ) -> tuple[Array, bool]:
        ranks = ranks + self._adjectives(noun, pool, chosen, in_stack)
        ordinals = list(noun.ordinals)
        if noun.plural:
            return pool, False
        if ordinals and not any(r.ordinal is None for r in ranks):
            if ranks:
                ordinals = []
            else:
                return self._counted_off(pool, ordinals[0], kinds), False
        weights = pool
        scale = 1.0 if len(ranks) < 2 else 2.5
        for rank in ranks:
            index = rank.ordinal or (ordinals.pop(0) if ordinals else 1)
            noise = rank.noise * (scale if index == 1 else 1.0)
            part = scores.ranked(pool, rank.key, index, noise)
            weights = weights * part if len(ranks) > 1 else part
        if noun.middle and not noun.directions:
            weights = self._middle(weights, chosen)
        return weights, False

    def _counted_off(self, pool: Array, ordinal: int, kinds: tuple[str, ...]) -> Array:
        """An ordinal without a direction: from the left, from the nearest, or from the right."""
        scene = self.scene
        noise = 0.3 * scene.edge
        if "row" in kinds or "column" in kinds:
            name = "left" if "row" in kinds else "back"
            key = scene.xy @ scene.direction(name, self.view)
            return np.asarray(
                0.85 * scores.ranked(pool, key, ordinal, noise) + 0.15 * scores.ranked(pool, -key, ordinal, noise)
            )
        spread = scene.xy[pool > 0.3 * pool.max(initial=1e-9)]
        along = np.ptp(spread, axis=0) if len(spread) else np.ones(2)
        sideways = float(along[1] / max(along.sum(), 1e-9))
        left = scene.xy @ scene.direction("left", self.view)
        near = -np.linalg.norm(scene.xy - scene.viewpoint(ROBOT).position[:2], axis=1)
        return np.asarray(
            0.65 * sideways * scores.ranked(pool, left, ordinal, noise)
            + 0.15 * sideways * scores.ranked(pool, -left, ordinal, noise)
            + (1 - 0.8 * sideways) * scores.ranked(pool, near, ordinal, noise)
        )

    def _adjectives(self, noun: Noun, pool: Array, chosen: bool, in_stack: bool) -> list[Rank]:
        """Ranks from words before the head: "nearest", "leftmost", "top left"."""
        scene = self.scene
        ranks = []
        noise = 0.3 * scene.edge
        names = list(noun.directions)
        if in_stack or (self._upright(pool) and not chosen):
            for name, sign in (("up", 1.0), ("down", -1.0)):
                if name in names and (in_stack or len(names) == 1):
                    ranks.append(Rank(sign * scene.z, None, 0.3 * scene.edge))
                    names.remove(name)
        if names or (noun.middle and noun.directions):
            owner = noun.agent or self.view
            place = self._make_place(names, owner, noun.middle, len(names) > 1, bare=True)
            ranks.append(Rank(self._closeness(place, pool if chosen else None), None, noise))
        if noun.distance and not (noun.distance == "far" and noun.directions):  # "the farthest left" is the leftmost
            sign = 1.0 if noun.distance == "near" else -1.0
            ranks.append(Rank(-sign * self._from_agent(noun.agent or ROBOT), None, noise))
        return ranks

    def _upright(self, pool: Array) -> bool:
        """Whether all that is likely belongs to stacks."""
        likely = pool > 0.5 * max(float(pool.max(initial=0)), 1e-9)
        return bool(likely.any()) and bool(self.scene.stacked[likely].all())

    def _from_agent(self, agent: str) -> Array:
        viewpoint = self.scene.viewpoint(agent)
        offset = self.scene.xy - viewpoint.position[:2]
        return np.asarray(np.hypot(offset[:, 0], 0.8 * offset[:, 1]))

    def _middle(self, pool: Array, chosen: bool) -> Array:
        """The middle one: nearest to the centre, and by rank along the longer side."""
        scene = self.scene
        total = float(pool.sum())
        if total < 1e-9:
            return pool
        noise = 0.35 * scene.edge
        centre = pool @ scene.xy / total
        by_centre = scores.ranked(pool, -np.linalg.norm(scene.xy - centre, axis=1), 1, noise)
        likely = np.flatnonzero(pool > 0.3 * pool.max())
        by_rank = np.zeros(scene.n)
        if len(likely) > 2:
            points = scene.xy[likely]
            axis = np.linalg.svd(points - points.mean(axis=0), full_matrices=False)[2][0]
            order = likely[np.argsort(points @ axis, kind="stable")]
            middle = order[(len(order) - 1) // 2 : len(order) // 2 + 1]
            by_rank[middle] = pool[middle] / len(middle)
        if chosen:
            return np.asarray(0.5 * by_centre + 0.5 * by_rank)
        of_all = scores.ranked(pool, -np.linalg.norm(scene.xy - scene.box[0], axis=1), 1, noise)
        return np.asarray(0.4 * by_centre + 0.3 * by_rank + 0.3 * of_all)

    def _lone(self, base: Array) -> Array:
        scene = self.scene
        if scene.n < 2:
            return np.ones(scene.n)
        gaps = scene.gaps + np.where(np.eye(scene.n, dtype=bool), np.inf, 0.0)
        nearest = gaps.min(axis=1)
        same = np.where(base[None, :] > 0.5, gaps, np.inf).min(axis=1)
        same = np.where(np.isfinite(same), same, nearest.max(initial=0.0) * 2)
        alone = scores.ranked(base, nearest, 1, 0.4 * scene.edge)
        apart = scores.ranked(base, same, 1, 0.4 * scene.edge)
        single = scores.logistic((nearest / scene.edge - 0.7) / 0.25) * ~scene.stacked
        return np.asarray(0.2 * alone + 0.15 * apart + 0.65 * single)

    # -- arrangements ----------------------------------------------------------------------------------------------

    def _container(self, noun: Noun) -> Value:
        scene = self.scene
        colors = noun.colors
        number = noun.number
        rest = []
        stuff = np.ones(scene.n, dtype=bool)
        for modifier in noun.modifiers:
            content = self._content(modifier)
            if content is None:
                rest.append(modifier)
            else:
                colors = colors or content.colors
                number = number or content.number
        if noun.text and "-" in noun.text:
            number = number or _hyphenated(noun.text)
        if colors:
            stuff = self._base(replace(noun, colors=colors)) > 0.5
        wanted = number if not noun.plural else None
        found = sets.arranged(scene, noun.kinds, stuff, wanted)
        exists = sets.existence(found, wanted, noun.kinds)
        lines = self._counted_lines(noun, stuff) if number is None else []
        found = self._modified_sets(noun, found, rest)
        if lines:
            plain = replace(noun, ordinals=(), directions=(), middle=False)
            found = [*self._modified_sets(plain, lines, rest), *((mask, 0.3 * weight) for mask, weight in found)]
        found = [(mask, weight * exists) for mask, weight in found]
        pool = np.zeros(scene.n)
        total = sum(weight for _, weight in found)
        for mask, weight in found:
            pool = pool + mask * (weight / max(total, 1.0))
        return Value("sets", np.minimum(pool, 1.0), tuple(found[: 2 * SETS]), definite=noun.definite, number=number,
                     kinds=noun.kinds)  # fmt: skip

    def _counted_lines(self, noun: Noun, stuff: np.ndarray) -> list[tuple[np.ndarray, float]]:
        """The "third row", the "last column", the "top row" of all rows that the table is parted into."""
        kind = next((k for k in ("row", "column") if k in noun.kinds), None)
        names = {"up": 0, "back": 0, "down": -1, "front": -1} if kind == "row" else {"left": 0, "right": -1}
        ends = [names[name] for name in noun.directions if name in names]
        if (
            kind is None
            or "diagonal" in noun.kinds
            or not (noun.ordinals or ends or noun.middle)
            or len(noun.directions) > 1
        ):
            return []
        found: dict[bytes, tuple[np.ndarray, float]] = {}
        for gap in sets.GAPS:
            parts = sets.partition(self.scene, stuff, kind, gap)
            index = noun.ordinals[0] - 1 if noun.ordinals and noun.ordinals[0] > 0 else -1
            if ends:
                index = ends[0] if not noun.ordinals else index if ends[0] == 0 else -1 - index
            elif noun.middle:
                index = len(parts) // 2
            if -len(parts) <= index < len(parts):
                mask = parts[index]
                weight = found.get(mask.tobytes(), (mask, 0.0))[1] + 1.0 / len(sets.GAPS)
                found[mask.tobytes()] = (mask, weight)
        return sorted(found.values(), key=lambda item: -item[1])

    def _content(self, modifier: Phrase) -> Noun | None:
        """The members that an arrangement is said to have: "of five", "of red blocks"."""
        texts = [word.text for word in modifier.words]
        if modifier.tag == "PP" and texts in (["of"], ["with"], ["containing"]) and modifier.phrases:
            inner = read_noun(modifier.phrases[0])
            if inner.head == "block" and not inner.ordinals and not inner.distance and not inner.modifiers:
                return inner
        return None

    def _modified_sets(
        self, noun: Noun, found: list[tuple[np.ndarray, float]], modifiers: list[Phrase]
    ) -> list[tuple[np.ndarray, float]]:
        """Arrangements restricted and ranked as wholes, each standing at the mean of its members."""
        scene = self.scene
        if not found:
            return found
        masks = np.array([mask for mask, _ in found], dtype=float)
        shares = masks / masks.sum(axis=1, keepdims=True)
        prior = np.array([weight for _, weight in found])
        weights = prior / max(float(prior.max()), 1e-9)
        ranks: list[Rank] = []
        for modifier in modifiers:
            for effect in self.effects(modifier, np.ones(scene.n)):
                if isinstance(effect, Restriction):
                    weights = weights * (FLOOR + (1 - FLOOR) * (shares @ effect.weights))
                elif isinstance(effect, Membership):
                    inside = sum(chance * (shares @ mask) for mask, chance in effect.sets[:SETS])
                    weights = weights * np.minimum(1.0, FLOOR + inside)
                else:
                    ranks.append(effect)
        bare = replace(noun, middle=False)
        ranks += self._adjectives(bare, np.ones(scene.n), False, False)
        if noun.middle and not noun.directions:
            ranks.append(Rank(-np.linalg.norm(scene.xy - scene.box[0], axis=1), None, 0.5 * scene.edge))
        if noun.size:
            ranks.append(Rank(np.zeros(scene.n), None, 1.0))
        ordinals = list(noun.ordinals)
        if ordinals and not ranks:
            name = "left" if set(noun.kinds) & {"column", "tower", "group"} else "back"
            ranks.append(Rank(scene.xy @ scene.direction(name, self.view), None, 0.3 * scene.edge))
        for rank in ranks:
            key = shares @ rank.key if not (noun.size and rank is ranks[-1]) else noun.size * masks.sum(axis=1)
            index = rank.ordinal or (ordinals.pop(0) if ordinals else 1)
            noise = rank.noise if not (noun.size and rank is ranks[-1]) else 0.3
            weights = self._rank_sets(masks, weights, key, index, noise)
        return sorted(
            [(mask, float(weight)) for (mask, _), weight in zip(found, weights, strict=True) if weight > 1e-3],
            key=lambda item: -item[1],
        )

    def _rank_sets(self, masks: Array, weights: Array, key: Array, index: int, noise: float) -> Array:
        """Rank sets; those that share members do not compete for a place, the likelier one stands for them."""
        keep = np.ones(len(weights), dtype=bool)
        order = np.argsort(-weights, kind="stable")
        for place, i in enumerate(order):
            keep[i] = not any(keep[j] and (masks[i] * masks[j]).any() for j in order[:place])
        ranked = scores.ranked(weights * keep, key, index, noise)
        for i in np.flatnonzero(~keep):
            rival = weights * keep * ~((masks @ masks[i]) > 0)
            rival[i] = weights[i]
            ranked[i] = 0.6 * scores.ranked(rival, key, index, noise)[i]
        return np.asarray(ranked)

    # -- places ----------------------------------------------------------------------------------------------------

    def _make_place(
        self, names: list[str] | tuple[str, ...], owner: str, middle: bool, corner: bool, bare: bool
    ) -> Place:
        flat = [_HORIZONTAL.get(name, name) for name in names]
        vectors = tuple(self.scene.direction(name, owner) for name in dict.fromkeys(flat))
        return Place(vectors, tuple(names), middle, corner or len(vectors) > 1, bare, owner=owner)

    def _place_value(self, noun: Noun) -> Value:
        scene = self.scene
        owner = noun.agent or self.view
        names = list(noun.directions)
        bare = noun.place is None
        if not names and noun.agent and not noun.middle:
            names = ["front"]  # "your side"
        of = self._owner_of(noun)
        if (
            of is not None
            and of.kind == "sets"
            and not (noun.directions or noun.middle)
            and "part" in noun.text.split()
        ):
            return of
        if of is not None and of.place is not None and of.kind == "place":  # "the middle of the left edge"
            names += [name for name in of.place.names if name not in names]
        place = self._make_place(names, owner, noun.middle, noun.place == "corner", bare)
        if of is not None and of.kind in ("sets", "objects") and of.weights.any():
            return self._part(place, of, noun)
        weights = self._in_place(place, np.ones(scene.n))
        for modifier in noun.modifiers:
            for effect in self.effects(modifier, np.ones(scene.n)):
                if isinstance(effect, Restriction):
                    weights = weights * (FLOOR + (1 - FLOOR) * effect.weights)
        return Value("place", weights, place=place)

    def _owner_of(self, noun: Noun) -> Value | None:
        """What a place is a part of: "of the row"."""
        for modifier in noun.modifiers:
            if modifier.tag == "PP" and [word.text for word in modifier.words][-1:] in (["of"], ["in"], ["from"]):
                for child in modifier.phrases:
                    return self.value(child)
        return None

    def _part(self, place: Place, of: Value, noun: Noun) -> Value:
        """The members of a set that lie at its end, its middle or its top."""
        scene = self.scene
        total = np.zeros(scene.n)
        for mask, chance in (of.sets or ((of.weights > 0.5 * of.weights.max(), 1.0),))[:SETS]:
            pool = mask.astype(float)
            upright = bool(scene.stacked[mask].all()) if mask.any() else False
            if upright and ("up" in place.names or "down" in place.names):
                key = scene.z if "up" in place.names else -scene.z
                total += chance * scores.ranked(pool, key, 1, 0.3 * scene.edge)
            elif place.middle and not place.directions:
                total += chance * self._middle(pool, True)
            else:
                total += chance * scores.ranked(pool, self._closeness(place, pool), 1, 0.3 * scene.edge)
        return Value("objects", total, place=place)

    def _closeness(self, place: Place, pool: Array | None = None) -> Array:
        """How near every object is to a place, in [m], negative distances; larger is nearer."""
        scene = self.scene
        if not place.directions:
            return np.asarray(-np.linalg.norm(scene.xy - scene.box[0], axis=1))
        if len(place.directions) == 1 and not place.middle:
            return np.asarray(scene.xy @ place.directions[0])
        centre, half = scene.box
        target = centre + sum(place.directions) * half
        return np.asarray(-np.linalg.norm(scene.xy - target, axis=1))

    def _in_place(self, place: Place, base: Array) -> Array:
        """How well every object lies in a place."""
        scene = self.scene
        if not scene.n:
            return np.zeros(0)
        compared = base > 0.5
        if not place.directions:
            away = np.linalg.norm(scene.scaled, axis=1)
            best = float(away[compared].min(initial=9.0))
            return np.asarray(
                np.exp(-0.5 * (np.maximum(away - 0.1, 0) / 0.45) ** 2) * np.exp(-1.5 * (away - best).clip(0))
            )
        if len(place.directions) > 1 or place.middle or place.corner:
            vectors = np.array(place.directions)
            target = vectors.sum(axis=0)
            offset = scene.scaled - target
            if len(place.directions) == 1 and place.corner:
                along = offset @ vectors[0]
                across = np.abs(np.abs(scene.scaled @ np.array([-vectors[0][1], vectors[0][0]])) - 1.0)
                away = np.hypot(along, across)
            else:
                away = np.linalg.norm(offset, axis=1)
            best = float(away[compared].min(initial=9.0))
            return np.asarray(np.exp(-0.5 * (away / 0.7) ** 2) * np.exp(-2.5 * (away - best).clip(0)))
        along = scene.scaled @ place.directions[0]
        return scores.side(along, along[compared])

    # -- modifiers -------------------------------------------------------------------------------------------------

    def effects(self, phrase: Phrase, base: Array) -> list[Effect]:
        """What a modifier does to the objects `base` (n,) of the noun that it follows."""
        if phrase.tag in ("WHNP", "INTJ") or _takes_view(phrase):
            return []
        if phrase.tag == "NP":
            return self._predicate(phrase, base)
        own = [word.text for word in phrase.words]
        if phrase.tag in ("SBAR", "S", "VP") and not any(_relates(text) for text in own):
            found: list[Effect] = []
            verb = phrase.tag == "VP"
            for child in phrase.phrases:
                if child.tag == "NP" and not verb and read_noun(child).head in ("pronoun", "other", "agent"):
                    continue
                if child.tag == "NP" and verb and any(t in ("has", "have", "having") for t in own):
                    found += self._has(child, base)
                    continue
                found += self.effects(child, base)
            return found
        if any(text in ("not", "n't", "isn't", "without", "except") for text in own):
            return self._negated(phrase, base)
        inner = [child for child in phrase.phrases if child.tag in ("PP", "ADVP", "ADJP", "PRT")]
        if phrase.phrases and len(inner) == len(phrase.phrases) and len(inner) > 1:
            return self._joined(inner, base)
        return self._modifier(phrase, base)

    def _joined(self, parts: list[Phrase], base: Array) -> list[Effect]:
        """Directions that share a reference: "above and to the left of X"."""
        bare = [part for part in parts if not any(p.tag == "NP" for p in part.preorder())]
        names = tuple(name for part in bare for leaf in part.leaves for name in w.directions(leaf.text))
        referring = [part for part in parts if part not in bare]
        if names and len(referring) == 1:
            return self._modifier(referring[0], base, names)
        found: list[Effect] = []
        for part in parts:
            found += self.effects(part, base)
        return found

    def _negated(self, phrase: Phrase, base: Array) -> list[Effect]:
        found: list[Effect] = []
        for child in phrase.phrases:
            for effect in self.effects(child, base):
                if isinstance(effect, Restriction):
                    found.append(Restriction(1.0 - effect.weights))
                elif isinstance(effect, Membership):
                    inside = np.zeros(self.scene.n)
                    for mask, chance in effect.sets[:SETS]:
                        inside = np.maximum(inside, mask * chance)
                    found.append(Restriction(1.0 - inside))
        return found

    def _has(self, child: Phrase, base: Array) -> list[Effect]:
        noun = read_noun(child)
        plain = replace(noun, modifiers=tuple(m for m in noun.modifiers if not _of_itself(m)))
        value = self.noun(plain)
        if value.kind not in ("objects", "sets"):
            return []
        found: list[Effect] = []
        for modifier in noun.modifiers:
            if _of_itself(modifier):
                names = tuple(n for leaf in modifier.leaves for n in w.directions(leaf.text))
                opposite = tuple(_OPPOSITE[name] for name in names)
                found.append(Restriction(self._directed(value, opposite, self.view, False)))
        return found or [Restriction(self._near(value, 1.2))]

    def _predicate(self, phrase: Phrase, base: Array) -> list[Effect]:
        """A noun phrase that says more of the same thing: "that is the closest one to you"."""
        noun = read_noun(phrase)
        if noun.head in ("agent", "pronoun", "table", "measure") and not noun.lone:
            return []
        if noun.head == "place" and noun.place is None and not self._owner_of(noun) and not noun.agent:
            noun = replace(noun, head="block")
        if noun.head == "place":
            return self._located(self._place_value(noun), base)
        if noun.head == "block" and noun.plural and noun.modifiers and not noun.colors:
            return [e for m in noun.modifiers for e in self.effects(m, base)]  # "two blocks behind X"
        if noun.head in ("block", "other") and not noun.conjoined:
            own = replace(noun, head="block", plural=False)
            value = self._select(*self._modified(own, base * self._base(own)))
        else:
            value = self.noun(noun)
        if value.kind == "objects" and value.weights.any():
            return [Restriction(value.weights / max(float(value.weights.max()), 1e-9))]
        return []

    def _modifier(self, phrase: Phrase, base: Array, further: tuple[str, ...] = ()) -> list[Effect]:
        scene = self.scene
        leaves = _without_emphasis(phrase.words)
        said = read_words(leaves)
        texts = [word.text for word in leaves]
        phrases = [c for c in phrase.phrases if c.tag == "NP"]
        measure = next((m for c in phrases if (m := _measure(c)) is not None), None)
        child = next((c for c in phrases if _measure(c) is None), None)
        nested = next((c for c in phrase.phrases if c.tag in ("PP", "ADVP")), None)
        if (
            child is None
            and nested is not None
            and not said.distance
            and not said.ordinals
            and measure is None
            and not said.directions
        ):
            return self.effects(nested, base)
        if child is None and nested is not None:
            child = next((c for c in nested.phrases if c.tag == "NP"), None)
            texts += [word.text for word in _without_emphasis(nested.words)]
        noun = read_noun(child) if child is not None else None
        ordinal = said.ordinals[0] if said.ordinals else None
        strict = any(w.is_strict(text) for text in texts) or len(leaves) < len(phrase.words)
        ranking = [text for text in texts if w.is_ranking(text)]
        if said.lone or (noun is not None and noun.lone and not noun.colors and not noun.modifiers):
            return [Restriction(self._lone(base))]
        if noun is None:
            return self._alone(said, texts, base, ordinal)
        if ranking:
            return self._distance_rank(noun, w.distance(ranking[-1]) or "near", ordinal, "from" in texts)
        if any(w.is_between(text) for text in texts):
            return [Restriction(self._between(noun))]
        if any(w.is_surrounded(text) for text in texts):
            return [Restriction(self._surrounded(noun))]
        start = noun.head in ("place", "agent") or (noun.directions and _plain(noun))
        if ordinal is not None or (texts and texts[-1] == "from" and start and not said.distance):
            found = self._counted_from(noun, ordinal, base)
            if found:
                return found
        if said.distance == "far" and texts[-1:] == ["from"]:
            return self._distance_rank(noun, "far", ordinal, True)
        if "way" in texts or (said.distance == "far" and noun.head == "place"):
            value = self.noun(noun)
            if value.place is not None and value.kind == "place":
                return [Rank(self._closeness(value.place), ordinal, 0.3 * scene.edge)]
        touching = any(w.is_touching(text) for text in texts)
        names = [*further, *(name for text in texts for name in w.directions(text))]
        if texts[-1:] == ["behind"] or "behind" in texts:
            names = ["back"]
        if any(text in ("under", "beneath", "underneath") for text in texts):
            names = ["down"]
        if any(text == "over" for text in texts):
            names = ["up"]
        if noun.head == "place" and noun.place is None and not noun.middle:
            of = self._owner_of(noun)
            agent = noun.agent
            if of is not None and of.kind == "agent":
                return self._before_agent(of.agent or ROBOT, noun.directions, strict)
            if of is not None and of.kind in ("objects", "sets"):
                inside = (
                    of.kind == "sets"
                    and texts[:1] in (["in"], ["at"], ["from"], ["of"])
                    and "front" not in noun.directions
                )
                if not inside:
                    toward = (*further, *noun.directions)
                    if measure is not None:
                        return [Restriction(self._measured(of, toward, measure))]
                    return [self._along(of, toward, agent or self.view, strict)]
            if names and not agent:
                noun = replace(noun, directions=(*noun.directions, *names))
        if child is not None and texts[-1:] == ["with"] and noun.head in ("block", "container"):
            return self._has(child, base)
        value = self.noun(noun)
        if noun.head == "place" and noun.middle and not noun.directions and value.kind == "objects":
            return [Restriction(np.maximum(value.weights, self._amid(self._owner_of(noun))))]
        if _APART & set(texts) and value.kind in ("objects", "sets") and value.weights.any():
            return [Restriction(1.0 - self._near(value, 1.0)), Rank(self._distance_to(value), None, scene.edge)]
        if value.kind == "agent":
            if names:
                return self._before_agent(value.agent or ROBOT, tuple(names), strict)
            return [Rank(-self._from_agent(value.agent or ROBOT), ordinal, scene.edge)] if said.distance else []
        if names and measure is not None and value.kind in ("objects", "sets", "place"):
            return [Restriction(self._measured(value, tuple(names), measure))]
        if names and value.kind in ("objects", "sets"):
            return [self._along(value, tuple(names), self.view, strict)]
        if touching and value.kind in ("objects", "sets"):
            return [Restriction(self._near(value, 0.22))]
        if any(w.is_beside(text) for text in texts) and value.kind in ("objects", "sets"):
            return [Restriction(self._near(value, 0.8))]
        if value.kind == "place":
            return self._located(value, base)
        if value.kind == "objects" and value.place is not None:
            return [Restriction(value.weights)]
        if value.kind == "sets":
            return [Membership(value.sets, value.kinds)] if value.sets else []
        if value.kind == "objects" and texts[-1:] in (["on"], ["onto"], ["atop"], ["upon"]):
            return [Restriction(self._on(value))]
        if value.kind == "objects" and texts[-1:] in (["of"], ["from"], ["in"], ["among"]):
            return [Membership(((value.weights > 0.3 * value.weights.max(initial=1e-9), 1.0),))]
        return []

    def _alone(self, said: Noun, texts: list[str], base: Array, ordinal: int | None) -> list[Effect]:
        """A modifier without a noun phrase: "farthest away", "above", "third"."""
        scene = self.scene
        if said.distance and any(w.is_ranking(t) for t in texts):
            sign = 1.0 if said.distance == "near" else -1.0
            return [Rank(-sign * self._from_agent(said.agent or ROBOT), ordinal, 0.3 * scene.edge)]
        if said.directions:
            place = self._make_place(list(said.directions), said.agent or self.view, said.middle, False, True)
            return self._located(Value("place", base, place=place), base)
        if said.middle:
            return [Restriction(self._in_place(Place(middle=True), base))]
        return []

    def _located(self, value: Value, base: Array) -> list[Effect]:
        place = value.place
        if place is None:
            return []
        return [Restriction(self._in_place(place, base))]

    def _distance_rank(self, noun: Noun, distance: str, ordinal: int | None, away: bool) -> list[Effect]:
        """Ranks by distance: "closest to X", "farthest from X", "furthest to the left"."""
        scene = self.scene
        noise = 0.3 * scene.edge
        value = self.noun(noun)
        sign = 1.0 if distance == "near" else -1.0
        if value.kind == "agent":
            return [Rank(-sign * self._from_agent(value.agent or ROBOT), ordinal, noise)]
        if value.kind == "place" and value.place is not None:
            place = value.place
            key = self._closeness(place)
            return [Rank(-key if distance == "far" and away else key, ordinal, noise)]
        if value.kind == "table":
            return []
        if value.kind in ("objects", "sets") and value.weights.any():
            return [Rank(-sign * self._distance_to(value), ordinal, noise)]
        return []

    def _counted_from(self, noun: Noun, ordinal: int | None, base: Array) -> list[Effect]:
        scene = self.scene
        if noun.head == "block" and noun.directions and _plain(noun):
            noun = replace(noun, head="place")  # "third from the bottom block"
        value = self.noun(noun)
        noise = 0.3 * scene.edge
        if value.kind == "place" and value.place is not None:
            return [Rank(self._closeness(value.place), ordinal, noise)]
        if value.kind == "agent":
            return [Rank(-self._from_agent(value.agent or ROBOT), ordinal, noise)]
        if value.kind == "objects" and value.place is not None and value.weights.any():
            return [Rank(-self._distance_to(value), ordinal, noise)]
        return []

    def _before_agent(self, agent: str, names: tuple[str, ...], strict: bool) -> list[Effect]:
        """Before or beside somebody: "in front of you", "to the left of you"."""
        scene = self.scene
        if "front" in names or "back" in names:
            offset = scene.xy - scene.viewpoint(agent).position[:2]
            ahead = scene.direction("back", agent)
            along = offset @ ahead
            side = np.abs(offset[:, 0] * ahead[1] - offset[:, 1] * ahead[0])
            centred = np.exp(-0.5 * (side / (2.0 * scene.edge)) ** 2)
            near = np.exp(-(along - along.min(initial=np.inf)) / (4 * scene.edge)) if scene.n else along
            return [Restriction(np.asarray(centred * near), preferred=True)]
        place = self._make_place(list(names), agent, False, False, True)
        return [Restriction(self._in_place(place, np.ones(scene.n)))]

    # -- relations -------------------------------------------------------------------------------------------------

    def _pairwise(self, value: Value, relation: Array) -> Array:
        """A relation (n, n) of objects to references, made one of objects to what a phrase means."""
        scene = self.scene
        np.fill_diagonal(relation, 0.0)
        if value.kind == "sets" and value.sets:
            total = np.zeros(scene.n)
            for mask, chance in value.sets[:SETS]:
                inside = relation[:, mask]
                if not mask.any():
                    continue
                count = int(mask.sum())
                held = inside.mean(axis=1) if 1 < count <= 3 and value.number else inside.max(axis=1)
                total = np.maximum(total, chance * held * ~mask)
            return total
        likely = value.weights / max(float(value.weights.max(initial=0.0)), 1e-9)
        return np.asarray(1.0 - np.exp(np.log1p(-np.minimum(relation * likely[None, :], 1 - 1e-9)).sum(axis=1)))

    def _near(self, value: Value, reach: float) -> Array:
        scene = self.scene
        return self._pairwise(value, scores.beside(scene.gaps, scene.edge, reach))

    def _directed(self, value: Value, names: tuple[str, ...], owner: str, strict: bool) -> Array:
        scene = self.scene
        if ("up" in names or "down" in names) and scene.towers:
            vertical = self._vertical(value, 1.0 if "up" in names else -1.0)
            if vertical.max(initial=0.0) > 0.3:
                return vertical
        flat = list(dict.fromkeys(_HORIZONTAL.get(name, name) for name in names))
        vectors = [scene.direction(name, owner) for name in flat]
        if not vectors:
            return np.ones(scene.n)
        direction = np.sum(vectors, axis=0)
        length = float(np.linalg.norm(direction))
        if length < 1e-6:
            return np.ones(scene.n)
        offset = scene.xy[:, None] - scene.xy[None]
        return self._pairwise(value, scores.directed(offset, scene.gaps, direction / length, scene.edge, strict=strict))

    def _along(self, value: Value, names: tuple[str, ...], owner: str, strict: bool) -> Restriction:
        """A direction from a reference; ordinals count away from it."""
        return Restriction(self._directed(value, names, owner, strict), -self._distance_to(value))

    def _measured(self, value: Value, names: tuple[str, ...], steps: float) -> Array:
        """So many blocks away in a direction, counted between the blocks or from centre to centre."""
        scene = self.scene
        flat = dict.fromkeys(_HORIZONTAL.get(name, name) for name in names)
        vector = np.sum([scene.direction(name, self.view) for name in flat], axis=0)
        total = np.zeros(scene.n)
        if value.kind == "place" and value.place is not None:
            centre, half = scene.box
            start = centre + (np.sum(value.place.directions, axis=0) * half if value.place.directions else 0.0)
            starts = [(start, 1.0)]
        elif value.kind == "sets":
            starts = [(scene.xy[mask].mean(axis=0), chance) for mask, chance in value.sets[:SETS] if mask.any()]
        else:
            best = max(float(value.weights.max(initial=0.0)), 1e-9)
            starts = [(scene.xy[i], float(value.weights[i]) / best) for i in np.argsort(-value.weights)[:4]]
        for start, chance in starts:
            for count, likely in ((steps, 0.8), (steps + 1, 1.0)):
                target = start + vector * count * 1.08 * scene.edge
                away = np.linalg.norm(scene.xy - target, axis=1) / scene.edge
                held = np.exp(-0.5 * (away / (0.7 + 0.25 * steps)) ** 2)
                total = np.maximum(total, chance * likely * held)
        return total

    def _vertical(self, value: Value, sign: float) -> Array:
        """On top of a reference, or under it: the reference of what is on it carries something."""
        scene = self.scene
        if value.kind == "objects":
            undone = value.weights / np.where(scene.clear, np.where(scene.stacked, STACKED, 1.0), BURIED)
            value = replace(value, weights=undone)
        over = scene.apart < 0.5 * scene.edge
        step = sign * (scene.z[:, None] - scene.z[None]) / scene.edge
        return self._pairwise(value, np.where(over & (step > 0.5), np.exp(-0.3 * np.maximum(step - 1, 0)), 0.0))

    def _on(self, value: Value) -> Array:
        return self._vertical(value, 1.0)

    def _distance_to(self, value: Value) -> Array:
        scene = self.scene
        if value.kind == "sets" and value.sets:
            total = np.zeros(scene.n)
            share = sum(chance for _, chance in value.sets[:SETS]) or 1.0
            for mask, chance in value.sets[:SETS]:
                nearest = scene.apart[:, mask].min(axis=1) if mask.any() else np.zeros(scene.n)
                total += chance / share * np.where(mask, 10.0, nearest)
            return total
        likely = value.weights / max(float(value.weights.sum()), 1e-9)
        if not value.definite:
            close = np.where(value.weights[None, :] > 0.5, scene.apart + 10.0 * np.eye(scene.n), np.inf).min(axis=1)
            return np.asarray(np.where(np.isfinite(close), close, 10.0))
        return np.asarray(scene.apart @ likely + 10.0 * likely)

    def _between(self, noun: Noun) -> Array:
        """Between two, or amid several."""
        return self._amid(self.noun(noun))

    def _amid(self, value: Value | None) -> Array:
        scene = self.scene
        if value is None:
            return np.zeros(scene.n)
        total = np.zeros(scene.n)
        if value.kind == "sets":
            for mask, chance in value.sets[:SETS]:
                members = np.flatnonzero(mask)
                held = np.zeros(scene.n)
                if len(members) == 2:
                    held = scores.between(scene.xy, scene.xy[members[0]], scene.xy[members[1]], scene.edge)
                elif len(members) > 2:
                    for a in range(len(members)):
                        for b in range(a):
                            held = np.maximum(
                                held,
                                0.8 * scores.between(scene.xy, scene.xy[members[a]], scene.xy[members[b]], scene.edge),
                            )
                total = np.maximum(total, chance * held * ~mask)
            if value.sets and total.max(initial=0.0) > 0.1:
                return total
        likely = np.flatnonzero(value.weights > 0.4 * max(float(value.weights.max(initial=0)), 1e-9))[:12]
        for a in range(len(likely)):
            for b in range(a):
                held = scores.between(scene.xy, scene.xy[likely[a]], scene.xy[likely[b]], scene.edge)
                held[[likely[a], likely[b]]] = 0.0
                total = np.maximum(total, held)
        return total

    def _surrounded(self, noun: Noun) -> Array:
        scene = self.scene
        value = self.noun(noun)
        weights = value.weights / max(float(value.weights.max(initial=0)), 1e-9)
        if not value.weights.any():
            weights = np.ones(scene.n)
        close = scores.beside(scene.gaps, scene.edge, 1.5) * weights[None, :]
        np.fill_diagonal(close, 0.0)
        count = close.sum(axis=1)
        wanted = value.number or 3
        return np.asarray(1.0 / (1.0 + np.exp(-(count - 0.6 * wanted) / 0.4)))


def _measure(phrase: Phrase) -> float | None:
    """How many blocks a noun phrase measures: "two spaces", "half a block", "one"; None where it measures nothing."""
    texts = [leaf.text for leaf in phrase.leaves]
    noun = read_noun(phrase)
    bare = not (noun.colors or noun.modifiers or noun.directions or noun.distance or noun.middle or noun.lone)
    counted = next((s.value for t in texts for s in meanings(t) if isinstance(s, Cardinal)), None)
    if noun.head == "measure" or (
        bare and counted is not None and "the" not in texts and noun.head in ("block", "other")
    ):
        if "half" in texts:
            return 0.5 if counted is None or counted == 1 else counted + 0.5
        return float(counted) if counted is not None else 3.0 if "few" in texts else 1.0
    return None


def _plain(noun: Noun) -> bool:
    """Whether a noun says nothing but what stands before it: "the bottom block"."""
    return not (noun.modifiers or noun.ordinals or noun.distance or noun.colors)


def _complement(modifier: Phrase) -> Phrase | None:
    """The noun phrase of "to X" and "from X", nothing else before it."""
    texts = [word.text for word in modifier.words]
    if modifier.tag == "PP" and texts in (["to"], ["from"], ["away", "from"]) and len(modifier.phrases) == 1:
        return modifier.phrases[0] if modifier.phrases[0].tag == "NP" else None
    return None


def _has_noun(phrase: Phrase) -> bool:
    """Whether a noun phrase names a kind of thing itself."""
    return any(w.is_block(leaf.text) or w.containers(leaf.text) for leaf in phrase.leaves)


def _of_itself(modifier: Phrase) -> bool:
    """Whether a modifier relates to the thing itself: "to its left"."""
    texts = [leaf.text for leaf in modifier.leaves]
    return bool({"its", "it"} & set(texts)) and any(w.directions(text) for text in texts)


_APART = frozenset("separated apart isolated detached separate".split())
_EMPHASIZED = frozenset("next in beside behind above below on at by near under to against between up".split())


def _without_emphasis(words: tuple[Word, ...]) -> tuple[Word, ...]:
    """Words without a "right" that stands for "directly": "right next to"."""
    return tuple(
        word
        for place, word in enumerate(words)
        if not (word.text == "right" and place + 1 < len(words) and words[place + 1].text in _EMPHASIZED)
    )


def _counted(effect: Restriction, noun: Noun) -> Array:
    """How well a restriction holds; where an ordinal counts along it, distance does not speak against."""
    if effect.order is None or not noun.ordinals:
        return effect.weights
    return np.asarray(np.sqrt(np.sqrt(effect.weights)))


def _takes_view(phrase: Phrase) -> bool:
    """Whether a modifier only names a viewpoint: "from your perspective"."""
    return phrase.tag == "PP" and any(leaf.text in VIEWS for leaf in phrase.leaves) and len(phrase.leaves) <= 6


def _relates(text: str) -> bool:
    return bool(
        w.is_touching(text) or w.is_between(text) or w.is_surrounded(text) or w.directions(text) or w.distance(text)
        or w.is_beside(text) or any(isinstance(s, Ordinal) for s in meanings(text))
        or text in ("not", "behind", "facing")
    )  # fmt: skip


def _hyphenated(text: str) -> int | None:
    for word in text.split():
        if "-" in word:
            for symbol in meanings(word.split("-")[0]):
                if isinstance(symbol, Cardinal):
                    return symbol.value
    return None

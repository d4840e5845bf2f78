"""All symbols of Γ: each once and with the roles that adaptive inference gives it, judged at once as one by one."""

import functools
from collections import Counter

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from grounding.corpus.composer import compose
from grounding.errors import SearchError
from grounding.features import FAMILIES, STAGES, Scope, family_of
from grounding.features.exhaustive import MOST_THINGS, every
from grounding.geometry.layout import Layout
from grounding.language.lexicon import known_colors
from grounding.language.tree import from_brackets
from grounding.space import SymbolSpace
from grounding.symbols import Action, ObjectType, Ordinal, parse_symbols
from grounding.world import World, make_object

PHRASES = (  # a phrase, its children's symbols, its own concrete and its own abstract ones; {} are two ids
    ("(NP (DT the) (JJS nearest) (JJ red) (NN block))", (), "type(block) color(red) spatial(near)", ""),
    ("(NP (DT the) (CD two) (NNS blocks))", (), "type(block) cardinal(2)", "container(group; {0} {1})"),
    ("(NP (DT the) (NN row))", (), "container(row)", ""),
    ("(NP (NP (DT the) (JJ second) (NN block)) (PP (IN from) (NP (DT the) (NN left))))",
     ("attribute(block, -, -, 2)", "spatial(left)"), "", ""),
    ("(NP (NP (DT the) (NNS blocks)) (PP (IN in) (NP (DT the) (NN group))))",
     ("type(block) collection(block, -, -, 3)", "container(group; {0} {1})"), "", ""),
    ("(PP (IN behind) (NP (DT the) (NN block)))", ("object({0})",), "spatial(back)", ""),
    ("(PP (IN between) (NP (DT the) (NNS blocks)))", ("object({0}) object({1})",), "spatial(between)", ""),
    ("(PP (IN on) (NP (PRP you)))", ("container(robot)",), "spatial(left)", ""),
    ("(VP (VB take) (NP (DT the) (JJ red) (NN block)))", ("attribute(block, red, -, -)",), "action(pick)", ""),
    ("(VP (VB clear) (NP (DT the) (NNS blocks)))", ("object({0}) object({1})",), "action(clear)", ""),
    ("(VP (VB put) (NP (DT the) (NN block)) (PP (IN on) (NP (DT the) (NN block))))",
     ("object({0})", "region(top, object; {1})"), "action(place)", ""),
    ("(VP (VB move) (NP (DT the) (NN block)) (PP (TO to) (NP (DT the) (NN right))))",
     ("object({0})", "spatial(right)"), "action(place)", ""),
)  # fmt: skip
STAGE_OF = {family.name: family.stage for family in FAMILIES}
families = pytest.mark.parametrize("family", list(STAGE_OF))
phrases = pytest.mark.parametrize("number", range(len(PHRASES)), ids=[phrase[0] for phrase in PHRASES])


@functools.cache
def composed(most=8):
    """Worlds of a few things."""
    worlds = [compose(np.random.default_rng(seed)).world for seed in range(60)]
    return tuple(world for world in worlds if 2 <= len(world.things) <= most)[:4]


@functools.cache
def layout_of(which, most=8):
    return Layout(composed(most)[which])


def scope_of(number, layout, stage):
    text, children, concrete, abstract = PHRASES[number]
    ids = layout.ids
    scope = Scope(from_brackets(text)[0], [parse_symbols(symbols.format(*ids)) for symbols in children], layout)
    if stage > 0:
        scope = scope.with_concrete(parse_symbols(concrete))
    return scope.with_abstract(parse_symbols(abstract.format(*ids))) if stage > 1 else scope


def space_of(number, layout, family):
    return every(scope_of(number, layout, STAGE_OF[family]), family)


def weights_of(names):
    """Some weight for every role, always the same."""
    return np.array([np.random.default_rng([*name.encode(), 7]).normal() if name else 0.0 for name in names])


def cells(space):
    """The symbols of the blocks, those that are listed left out, with their roles."""
    for block, dropped in zip(space.blocks, space.dropped, strict=True):
        for place in set(range(block.size)) - set(dropped):
            yield block.symbol(place), block.roles(place), block, place


@phrases
def test_all_of_gamma_each_once(number):
    layout = layout_of(0, 4)
    scope = scope_of(number, layout, 1)
    gamma = SymbolSpace.of_world(layout.world, ("block", *(s.name for s in scope.named if isinstance(s, ObjectType))),
                                 known_colors())  # fmt: skip
    expected = set(gamma)
    found = Counter()
    alike = 0
    for family in STAGE_OF:
        space = space_of(number, layout, family)
        found.update(symbol for symbol, _ in space.listed)
        found.update(symbol for symbol, _, _, _ in cells(space))
        alike += sum(count for _, count in space.alike)
    assert max(found.values()) == 1
    missing = expected - set(found)
    assert all(isinstance(symbol, Action) and symbol.destination for symbol in missing)
    assert len(missing) == alike
    proposed = {s for f in FAMILIES for s, _ in f.propose(scope_of(number, layout, f.stage))}
    assert set(found) - expected <= proposed


@phrases
@families
@pytest.mark.parametrize("which", [0, 1])
def test_what_is_proposed_has_the_same_roles(which, family, number):
    layout = layout_of(which)
    scope = scope_of(number, layout, STAGE_OF[family])
    proposals = {f.name: f.propose for f in FAMILIES}[family](scope)
    space = every(scope, family)
    assert space.listed[: space.proposed] == proposals
    odds = {symbol: weights_of(roles).sum() for symbol, roles in space.listed}
    assert all(odds[symbol] == weights_of(roles).sum() for symbol, roles in proposals)


@phrases
@families
def test_blocks_are_what_their_symbols_are(number, family):
    space = space_of(number, layout_of(2), family)
    rng = np.random.default_rng(number)
    for block, dropped in zip(space.blocks, space.dropped, strict=True):
        odds = block.log_odds(weights_of)
        assert odds.shape == (block.size,)
        for place in (*rng.integers(block.size, size=20).tolist(), *dropped):
            symbol = block.symbol(place)
            assert family_of(symbol) == family
            assert block.find(symbol) == place
            assert odds[place] == pytest.approx(weights_of(block.roles(place)).sum())
        assert {block.symbol(place) for place in dropped} <= {symbol for symbol, _ in space.listed}
        assert block.find(Ordinal(1)) is None


@phrases
@pytest.mark.parametrize("family", ["attribute", "container", "region", "action"])
def test_groups_merge_what_is_alike(number, family):
    space = space_of(number, layout_of(0, 4), family)
    for block, dropped in zip(space.blocks, space.dropped, strict=True):
        merged = Counter({tuple(roles): count for roles, count in block.groups(dropped)})
        single = Counter(tuple(block.roles(place)) for place in set(range(block.size)) - set(dropped))
        assert merged == single
    total = sum(count for _, count in space.unlisted(10**9, np.random.default_rng(0)))
    assert total + len(space.listed) == space.size


@given(st.integers(0, 2**32 - 1), st.integers(1, 100))
@settings(max_examples=20)
def test_a_sample_stands_for_all(seed, count):
    space = space_of(2, layout_of(1), "container")
    for block, dropped in zip(space.blocks, space.dropped, strict=True):
        drawn = block.sampled(count, np.random.default_rng(seed), dropped)
        every_one = {tuple(roles) for roles, _ in block.groups(dropped)}
        assert sum(number for _, number in drawn) == pytest.approx(block.size - len(dropped))
        assert {tuple(roles) for roles, _ in drawn} <= every_one
        kept = {tuple(block.roles(place)) for place in set(block.salient) - set(dropped)}
        assert kept <= {tuple(roles) for roles, _ in drawn}


def test_a_sample_is_true_on_average():
    space = space_of(2, layout_of(1), "container")
    block, dropped = max(zip(space.blocks, space.dropped, strict=True), key=lambda pair: pair[0].size)
    exact = Counter({tuple(roles): number for roles, number in block.groups(dropped)})
    mean = Counter()
    rng = np.random.default_rng(0)
    for _ in range(400):
        for roles, number in block.sampled(20, rng, dropped):
            mean[tuple(roles)] += number / 400
    common = [roles for roles, number in exact.items() if number >= 5]
    assert all(mean[roles] == pytest.approx(exact[roles], rel=0.5) for roles in common)
    assert sum(mean.values()) == pytest.approx(sum(exact.values()))


@phrases
def test_symbols_can_be_listed_with_their_own_roles(number):
    space = space_of(number, layout_of(2), "region")
    symbol, roles, _, _ = next(cells(space))
    more = space.listing([symbol, space.listed[0][0]])
    assert more.listed == [*space.listed, (symbol, roles)]
    assert more.size == space.size
    assert symbol not in {other for other, _, _, _ in cells(more)}


@families
def test_an_empty_world(family):
    scope = Scope(from_brackets("(NP (DT the) (NN block))")[0], (), Layout(World(())))
    if STAGE_OF[family] > 0:
        scope = scope.with_concrete(parse_symbols("type(block)"))
    if STAGE_OF[family] > 1:
        scope = scope.with_abstract(frozenset())
    space = every(scope, family)
    assert all(not getattr(symbol, "objects", ()) for symbol, _ in space.listed)
    assert sum(count for _, count in space.unlisted(9, np.random.default_rng(0))) + len(space.listed) == space.size


def test_worlds_that_are_too_large_are_refused():
    many = World(tuple(make_object(f"b{i}", position=(i, 0, 0)) for i in range(MOST_THINGS + 1)))
    scope = Scope(from_brackets("(NP (DT the) (NN row))")[0], (), Layout(many)).with_concrete(frozenset())
    with pytest.raises(SearchError, match="65,535 sets"):
        every(scope, "container")


def test_every_stage_has_its_families():
    assert sorted(STAGE_OF.values()) == sorted(stage for stage, found in enumerate(STAGES) for _ in found)

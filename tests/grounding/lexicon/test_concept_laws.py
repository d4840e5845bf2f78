"""Laws that every concept obeys: bounds, mirrors, permutations, points beside objects, rigid motion."""

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from laws import ANYWHERE, OF_OBJECTS, SPEAKER, by_id, references, settings_of_blocks

from grounding.lexicon import person
from grounding.lexicon.parameters import varied
from grounding.lexicon.where import Where

some = settings(max_examples=40, deadline=None)
sides = st.sampled_from(["left", "right"])
OTHER = {"left": "right", "right": "left"}
anywhere = pytest.mark.parametrize("concept", ANYWHERE)
EVERY = {**OF_OBJECTS, **{
    name: lambda scene, side, held=held: held(scene, Where.objects(scene), side) for name, held in ANYWHERE.items()
}}  # fmt: skip
every = pytest.mark.parametrize("concept", EVERY)


def same(one, other):
    assert set(one) == set(other)
    for name, degree in one.items():
        assert other[name] == pytest.approx(degree, abs=1e-6)


@every
@given(settings_of_blocks(), sides)
@some
def test_degrees_are_within_0_and_1(concept, setting, side):
    scene = setting.scene()
    held = EVERY[concept](scene, side)
    assert held.shape == (scene.n,)
    assert ((held >= 0) & (held <= 1 + 1e-9)).all()


@every
@given(settings_of_blocks(), sides)
@some
def test_in_a_mirror_left_is_right(concept, setting, side):
    scene, mirror = setting.scene(), setting.mirrored().scene()
    same(by_id(scene, EVERY[concept](scene, side)), by_id(mirror, EVERY[concept](mirror, OTHER[side])))


@every
@given(settings_of_blocks(), sides, st.data())
@some
def test_the_order_of_objects_changes_nothing(concept, setting, side, data):
    order = data.draw(st.permutations(range(len(setting.points))))
    scene, shuffled = setting.scene(), setting.scene(order)
    same(by_id(scene, EVERY[concept](scene, side)), by_id(shuffled, EVERY[concept](shuffled, side)))


@anywhere
@given(settings_of_blocks(), sides)
@some
def test_points_where_objects_stand_are_as_the_objects(concept, setting, side):
    scene = setting.scene()
    points = Where.points(scene, scene.xy, scene.z)
    others = np.ones(scene.n, dtype=bool)
    others[references(scene, 0, 1)] = False
    held = [ANYWHERE[concept](scene, where, side)[others] for where in (Where.objects(scene), points)]
    np.testing.assert_allclose(*held, atol=1e-9)


@anywhere
@given(settings_of_blocks(), sides, st.floats(-np.pi, np.pi), st.floats(-1, 1), st.floats(-1, 1))
@some
def test_turning_everything_with_the_one_who_looks_changes_nothing(concept, setting, side, angle, x, y):
    scene, moved = setting.scene(), setting.moved(angle, np.array([x, y])).scene()
    held = [ANYWHERE[concept](s, Where.objects(s), side, SPEAKER) for s in (scene, moved)]
    np.testing.assert_allclose(*held, atol=1e-6)


@given(settings_of_blocks(), st.floats(-np.pi, np.pi), st.floats(-1, 1), st.floats(-1, 1), st.floats(0.5, 1.2))
@some
def test_distances_from_somebody_and_what_is_before_them_move_along(setting, angle, x, y, sideways):
    scene, moved = setting.scene(), setting.moved(angle, np.array([x, y])).scene()
    np.testing.assert_allclose(person.before(scene, SPEAKER), person.before(moved, SPEAKER), atol=1e-6)
    with varied(rank__sideways=sideways):
        found = [person.distance_from(s, SPEAKER) for s in (scene, moved)]
        np.testing.assert_allclose(*found, atol=1e-6)

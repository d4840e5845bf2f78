"""Worlds read from a MuJoCo model that somebody else simulates, and poses written back to it."""

import mujoco
import numpy as np
import pytest

from grounding import Grounder
from integration import Place, Session, UsageError
from integration.worlds import from_mujoco, write_poses

MODEL = """
<mujoco>
  <worldbody>
    <geom name="ground" type="plane" size="3 3 0.1"/>
    <body name="stand" pos="{x} 0 0">
      <geom name="table" type="box" pos="0.65 0 0.691" size="0.35 0.9 0.02"/>
    </body>
    <body name="cube" pos="{x0} -0.2 0.736"><freejoint/>
      <geom type="box" size="0.025 0.025 0.025" rgba="0.8 0.1 0.1 1"/></body>
    <body name="other" pos="{x1} 0.2 0.736" euler="0 0 30"><freejoint/>
      <geom type="box" size="0.025 0.025 0.025" rgba="0.1 0.2 0.8 1"/></body>
    {more}
  </worldbody>
</mujoco>
"""


def loaded(x=0.0, more=""):
    text = MODEL.format(x=x, x0=0.6 + x, x1=0.55 + x, more=more)
    model = mujoco.MjModel.from_xml_string(text)
    return model, mujoco.MjData(model)


def test_bodies_that_move_freely_are_blocks_with_their_colours_and_places():
    world = from_mujoco(*loaded())
    assert {item.id: item.type for item in world.objects} == {"cube": "block", "other": "block", "table": "table"}
    assert world["cube"].position == pytest.approx([0.6, -0.2, 0.736])
    assert world["table"].size == pytest.approx([0.7, 1.8, 0.04])
    grounder = Grounder.load()
    assert grounder.ground("pick up the blue block", world).actions[0].objects == ("other",)
    assert grounder.ground("pick up the red one", world).actions[0].objects == ("cube",)


def test_the_robot_may_stand_elsewhere_in_the_model():
    here, there = from_mujoco(*loaded()), from_mujoco(*loaded(1.5), base="stand")
    for item in here.objects:
        assert there[item.id].position == pytest.approx(item.position, abs=1e-9)
        assert there[item.id].orientation == pytest.approx(item.orientation, abs=1e-9)


@pytest.mark.parametrize(("x", "base"), [(0.0, None), (1.5, "stand")])
def test_what_was_done_is_written_back(x, base):
    model, data = loaded(x)
    with Session(from_mujoco(model, data, base=base)) as session:
        assert session.do(Place("cube", (0.5, -0.4, 0.736))).outcome == "done"
        write_poses(session.world, model, data, base=base)
        again = from_mujoco(model, data, base=base)
        for item in session.world.objects:
            assert again[item.id].position == pytest.approx(item.position, abs=1e-6)
    assert data.body("cube").xpos == pytest.approx([0.5 + x, -0.4, 0.736], abs=0.005)
    assert np.all(np.isfinite(data.qpos))


def test_types_are_told_by_name_and_only_some_count():
    world = from_mujoco(*loaded(), only=["cube"], types={"cube": "brick"})
    assert [(item.id, item.type) for item in world.things] == [("cube", "brick")]


BALL = '<body name="ball" pos="0.6 0.4 0.74"><freejoint/><geom type="sphere" size="0.03"/></body>'


@pytest.mark.parametrize(
    ("more", "options", "told"),
    [("", {"tables": ["desk"]}, "no body and no geom 'desk'"), ("", {"only": ["nobody"]}, "'nobody'"),
     (BALL, {}, "body 'ball' of the model has 1 shapes, of which 0 are boxes"), ("", {"base": "moon"}, "'moon'"),
     ("", {"types": {"moon": "block"}}, "no body 'moon'"), ("", {"tables": ["ground"]}, "is no box")],
)  # fmt: skip
def test_what_is_not_as_it_should_be_is_named(more, options, told):
    with pytest.raises(UsageError, match=told):
        from_mujoco(*loaded(more=more), **options)


def test_a_thing_that_the_model_does_not_have_is_refused():
    world = from_mujoco(*loaded())
    model = mujoco.MjModel.from_xml_string("<mujoco><worldbody/></mujoco>")
    with pytest.raises(UsageError, match="no body 'cube'"):
        write_poses(world, model, mujoco.MjData(model))

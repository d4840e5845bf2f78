import os
import subprocess
import sys

import numpy as np
import pytest

from motion import Marker, MotionError, Renderer, RenderingUnavailable, Simulator, UnknownBody, rendering_available
from motion.sim.rendering import CAMERAS

needs_opengl = pytest.mark.skipif(not rendering_available(), reason="no OpenGL on this machine")


@needs_opengl
@pytest.mark.parametrize("camera", sorted(CAMERAS))
def test_blocks_are_seen_where_the_projection_says(one_block, camera):
    with Renderer(one_block, 480, 360) as renderer:
        picture = renderer.render(camera=camera)
        marked = renderer.render(camera=camera, markers=[Marker(one_block.box("b").position, 0.08, (0, 1, 0, 1))])
        x, y = renderer.project(one_block.box("b").position, camera)[0]
    assert picture.shape == (360, 480, 3)
    assert picture.dtype == np.uint8
    rows, columns = np.nonzero(np.any(picture != marked, axis=2))
    assert abs(columns.mean() - x) < 6
    assert abs(rows.mean() - y) < 6
    red, green, _ = marked[round(y), round(x)].astype(int)
    assert green > 2 * red


@needs_opengl
def test_pictures_follow_the_simulation(one_block):
    with Simulator(one_block) as simulator, Renderer(one_block, 320, 240) as renderer:
        before = renderer.render(simulator)
        assert np.array_equal(before, renderer.render())
        simulator.settle()
        again = renderer.render(simulator)
        assert np.mean(before != again) < 0.01


@needs_opengl
def test_mistakes_are_named(one_block):
    with Renderer(one_block, 64, 48) as renderer:
        with pytest.raises(UnknownBody, match=r"'behind'.*front"):
            renderer.render(camera="behind")
        with pytest.raises(UnknownBody, match=r"'cone'.*box"):
            renderer.render(markers=[Marker((0, 0, 1), shape="cone")])
    with pytest.raises(RenderingUnavailable, match="closed"):
        renderer.render()
    with pytest.raises(MotionError, match="pixels"):
        Renderer(one_block, 100_000, 10)


def test_without_opengl_the_rest_works_and_says_what_to_install():
    code = (
        "import motion\n"
        "assert not motion.rendering_available()\n"
        "scene = motion.Scene((motion.Box('b', (0.5, 0, 0.025)),))\n"
        "motion.Simulator(scene).hold(0.01)\n"
        "try:\n    motion.Renderer(scene)\n"
        "except motion.RenderingUnavailable as error:\n    print(error)\n"
    )
    environment = {**os.environ, "MUJOCO_GL": "disable"}
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, env=environment, check=True)
    assert "libegl1" in done.stdout
    assert "libosmesa6" in done.stdout


def test_a_wish_that_cannot_be_met_does_not_stop_the_physics():
    code = (
        "import ctypes.util, sys, builtins\n"
        "load = builtins.__import__\n"
        "def refuse(name, *rest, **more):\n"
        "    if name.startswith('OpenGL'): raise ImportError('no ' + name)\n"
        "    return load(name, *rest, **more)\n"
        "builtins.__import__ = refuse\n"
        "import motion\n"
        "motion.Simulator(motion.Scene(())).hold(0.01)\n"
        "print(motion.rendering_available())\n"
    )
    environment = {**os.environ, "MUJOCO_GL": "osmesa"}
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, env=environment, check=True)
    assert done.stdout.strip() == "False"


@pytest.mark.parametrize("wished", ["osmesa", "egl", "nonsense"])
def test_whatever_backend_is_wished_for_motion_can_be_imported(wished):
    code = "import motion\nprint(len(motion.Scene(()).boxes))"
    environment = {**os.environ, "MUJOCO_GL": wished}
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, env=environment, check=True)
    assert done.stdout.strip() == "0"

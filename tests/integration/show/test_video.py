from pathlib import Path

import pytest
from by_hand import grounded, scene
from PIL import Image

from integration.errors import UsageError, VideoUnavailable
from integration.execute.executor import Executor
from integration.show.video import Recording
from integration.worlds_and_scenes import scene_of
from motion import rendering_available

pytestmark = pytest.mark.skipif(not rendering_available(), reason="no OpenGL starts here")


def test_a_gif_has_frames_of_the_whole_run(tmp_path):
    world = scene("four")
    recording = Recording(scene_of(world), tmp_path / "run.gif")
    report = Executor().execute(grounded("pick", "b3"), world, watch=recording)
    recording.close()
    simulated = sum(step.simulated for step in report.steps)
    with Image.open(tmp_path / "run.gif") as video:
        assert video.n_frames > 0.5 * simulated * 10
        assert video.size == (640, 480)


def test_other_kinds_are_refused():
    with pytest.raises(UsageError, match=r"\.gif or \.mp4"):
        Recording(scene_of(scene("four")), Path("run.avi"))


def test_mp4_without_an_encoder_says_what_to_install(tmp_path):
    try:
        import imageio_ffmpeg  # noqa: F401
    except ImportError:
        with pytest.raises(VideoUnavailable, match="imageio-ffmpeg"):
            Recording(scene_of(scene("four")), tmp_path / "run.mp4")

import sys

import pytest
from by_hand import scene

from integration.errors import ViewerUnavailable
from integration.show.viewer import Window
from integration.worlds_and_scenes import scene_of


@pytest.mark.skipif(not sys.platform.startswith("linux"), reason="other systems have other variables")
def test_without_a_screen_there_is_a_message(monkeypatch):
    monkeypatch.delenv("DISPLAY", raising=False)
    monkeypatch.delenv("WAYLAND_DISPLAY", raising=False)
    with pytest.raises(ViewerUnavailable, match="--video"):
        Window(scene_of(scene("four")))

"""Videos of a run: GIF through Pillow, MP4 where an encoder is installed."""

from __future__ import annotations

import importlib
from pathlib import Path
from types import ModuleType, TracebackType
from typing import Any

import numpy as np
from PIL import Image

from integration.errors import UsageError, VideoUnavailable
from motion import Renderer, RenderingUnavailable, Scene, Simulator

KINDS = (".gif", ".mp4")
_SIZE = (640, 480)
_RATE = {".gif": 10, ".mp4": 25}  # frames a simulated second
_COLORS = 128


class Recording:
    """Takes a frame every so many simulated seconds; give it to the executor as `watch`.

    The file is written by `close`, or at the end of a `with` block that no error leaves.

    Args:
        scene: what stands around the robot.
        path: a file that ends in .gif or .mp4.

    Raises:
        UsageError: the file's name ends otherwise.
        VideoUnavailable: there is no OpenGL, or no encoder for MP4; says what to install.
    """

    def __init__(self, scene: Scene, path: Path) -> None:
        kind = path.suffix.lower()
        if kind not in KINDS:
            raise UsageError(f"{path}: videos end in {' or '.join(KINDS)}, not in {kind or 'nothing'!r}")
        self._encoder = _encoder() if kind == ".mp4" else None
        try:
            self._renderer = Renderer(scene, *_SIZE)
        except RenderingUnavailable as error:
            raise VideoUnavailable(f"a video needs OpenGL: {error}") from error
        self._path, self._every = path, 1.0 / _RATE[kind]
        self._frames: list[Image.Image] = []
        self._next = 0.0
        self._stream: Any = None

    def __call__(self, simulator: Simulator) -> None:
        """Called after every step of physics."""
        if simulator.time >= self._next:
            self._next = simulator.time + self._every
            self._add(self._renderer.render(simulator))

    def __enter__(self) -> Recording:
        return self

    def __exit__(
        self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
    ) -> None:
        if error is None:
            self.close()
        else:
            self.abandon()

    def abandon(self) -> None:
        """Frees what is held without writing a file."""
        self._renderer.close()
        if self._stream is not None:
            self._stream.close()

    def close(self) -> None:
        """Writes the file.

        Raises:
            UsageError: it cannot be written.
        """
        self._renderer.close()
        try:
            if self._stream is not None:
                self._stream.close()
            elif self._frames:
                self._path.parent.mkdir(parents=True, exist_ok=True)
                first, rest = self._frames[0], self._frames[1:]
                first.save(self._path, save_all=True, append_images=rest, duration=round(1000 * self._every), loop=0)
        except OSError as error:
            raise UsageError(f"{self._path} cannot be written: {error}") from error

    def _add(self, frame: np.ndarray) -> None:
        if self._encoder is None:
            palette = self._frames[0] if self._frames else None
            image = Image.fromarray(frame)
            self._frames.append(image.quantize(_COLORS, dither=Image.Dither.NONE, palette=palette))
            return
        if self._stream is None:
            self._path.parent.mkdir(parents=True, exist_ok=True)
            self._stream = self._encoder.write_frames(str(self._path), _SIZE, fps=1 / self._every)
            self._stream.send(None)
        self._stream.send(np.ascontiguousarray(frame))


def _encoder() -> ModuleType:
    try:
        return importlib.import_module("imageio_ffmpeg")
    except ImportError:
        raise VideoUnavailable(
            "MP4 needs an encoder: pip install imageio-ffmpeg (or '.[video]'); a name that ends in .gif needs none"
        ) from None

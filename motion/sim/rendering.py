"""Pictures of a scene without a screen, by EGL or OSMesa, whichever starts; and where points of the world are."""

from __future__ import annotations

import copy
import os
from collections.abc import Iterable
from dataclasses import dataclass
from functools import lru_cache
from types import MappingProxyType, TracebackType
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from motion.collision.scene_model import scene_model
from motion.errors import MotionError, RenderingUnavailable, UnknownBody
from motion.physics_engine import mujoco
from motion.poses import Array, frozen, matrix
from motion.robot.state import RobotState
from motion.scene import Scene
from motion.sim.simulator import Simulator

_BACKENDS = ("egl", "osmesa")
_HELP = (
    "install one of the Debian packages libegl1 or libosmesa6 (apt install libegl1), or set MUJOCO_GL to what you have"
)
_FIELD_OF_VIEW = 45.0
_LARGEST = (3840, 2160)


@dataclass(frozen=True, eq=False)
class Camera:
    """A pinhole camera, level, that looks at a point.

    Attributes:
        position: (3,) metres.
        target: (3,) metres, in the middle of the picture.
        field_of_view: vertical, degrees.
    """

    position: Array
    target: Array
    field_of_view: float = _FIELD_OF_VIEW

    def __post_init__(self) -> None:
        object.__setattr__(self, "position", frozen(self.position))
        object.__setattr__(self, "target", frozen(self.target))

    @property
    def axes(self) -> Array:
        """(3, 3): right, up and forward of the picture, in columns, in the world's frame."""
        forward = self.target - self.position
        forward = forward / np.linalg.norm(forward)
        right = np.cross(forward, [0.0, 0.0, 1.0])
        # A camera that looks straight down has the robot at the bottom of its picture.
        right = np.array([0.0, -1.0, 0.0]) if np.linalg.norm(right) < 1e-6 else right / np.linalg.norm(right)
        return np.column_stack([right, np.cross(right, forward), forward])


CAMERAS = MappingProxyType(
    {
        "front": Camera(frozen([2.35, 0.0, 1.75]), frozen([0.45, 0.0, 0.82])),
        "robot": Camera(frozen([0.30, 0.0, 1.68]), frozen([0.68, 0.0, 0.72]), 80.0),
        "top": Camera(frozen([0.62, 0.0, 2.6]), frozen([0.62, 0.0, 0.7])),
        "side": Camera(frozen([0.75, -2.3, 1.45]), frozen([0.5, 0.0, 0.85])),
    }
)
"""Cameras by name: "front" faces the robot over the table, "robot" is the robot's own view, "top" is from above (the
robot at the bottom of the picture), "side" is from the robot's right."""


@dataclass(frozen=True, eq=False)
class Marker:
    """A coloured shape drawn into a picture, which physics does not know.

    Attributes:
        position: (3,) centre, metres.
        size: full edges of a box, or diameters of a sphere: (3,) metres, or one number for all.
        color: red, green, blue, opacity in [0, 1].
        shape: "box" or "sphere".
        orientation: (4,) unit quaternion w, x, y, z.
    """

    position: Array
    size: ArrayLike = 0.06
    color: tuple[float, float, float, float] = (0.1, 0.7, 0.2, 0.4)
    shape: str = "box"
    orientation: ArrayLike = (1.0, 0.0, 0.0, 0.0)


@lru_cache(maxsize=1)
def _context_class() -> Any:
    """The class of OpenGL contexts that can be started on this machine.

    Raises:
        RenderingUnavailable: none can.
    """
    wished = os.environ.get("MUJOCO_GL", "").strip().lower()
    if wished in ("disable", "disabled", "off", "false", "0"):
        raise RenderingUnavailable(f"MUJOCO_GL={wished} forbids rendering; unset it, and {_HELP}")
    reasons = []
    for name in (wished,) if wished in (*_BACKENDS, "glfw") else _BACKENDS:
        configured = os.environ.get("PYOPENGL_PLATFORM")
        try:
            module = __import__(f"mujoco.{name}", fromlist=["GLContext"])
            context = module.GLContext(16, 16)
            context.make_current()
            context.free()
        except Exception as error:  # whatever a missing or broken OpenGL raises: ImportError, AttributeError, its own
            reasons.append(f"{name}: {error}")
            if configured is None:
                os.environ.pop("PYOPENGL_PLATFORM", None)
        else:
            return module.GLContext
    raise RenderingUnavailable(f"no OpenGL without a screen ({'; '.join(reasons)}); {_HELP}")


def rendering_available() -> bool:
    """Tells whether pictures can be rendered on this machine."""
    try:
        _context_class()
    except RenderingUnavailable:
        return False
    return True


class Renderer:
    """Draws one scene; close it when done, or use it as a context manager.

    Args:
        scene: what stands around the robot; its loose boxes may have moved when a picture is taken.
        width: of the pictures, pixels.
        height: ditto.
        shadows: whether lights cast shadows; much slower without a graphics card.

    Raises:
        RenderingUnavailable: no OpenGL can be started; says which packages help.
        MotionError: the picture is larger than the buffer.
    """

    def __init__(self, scene: Scene, width: int = 960, height: int = 720, shadows: bool = False) -> None:
        if not (0 < width <= _LARGEST[0] and 0 < height <= _LARGEST[1]):
            raise MotionError(f"pictures have 1 to {_LARGEST[0]} by {_LARGEST[1]} pixels, not {width} by {height}")
        self.width, self.height = width, height
        self._scene = scene
        self._indices = scene_model(scene, visuals=True)
        self._model: Any = copy.copy(self._indices.model)
        self._model.vis.global_.offwidth, self._model.vis.global_.offheight = width, height
        self._model.vis.quality.shadowsize = 2048 if shadows else 0
        self._data: Any = mujoco.MjData(self._model)
        self._gl: Any = None
        self._context: Any = None
        gl = _context_class()(width, height)
        try:
            gl.make_current()
            self._context = mujoco.MjrContext(self._model, mujoco.mjtFontScale.mjFONTSCALE_100.value)
            mujoco.mjr_setBuffer(mujoco.mjtFramebuffer.mjFB_OFFSCREEN.value, self._context)
        except Exception as error:
            gl.free()
            raise RenderingUnavailable(f"OpenGL started but cannot draw ({error}); {_HELP}") from error
        self._gl = gl
        self._view = mujoco.MjvScene(self._model, maxgeom=2000)
        self._view.flags[mujoco.mjtRndFlag.mjRND_SHADOW] = shadows
        self._view.flags[mujoco.mjtRndFlag.mjRND_REFLECTION] = False
        self._option = mujoco.MjvOption()
        self._option.geomgroup[:] = [1, 1, 1, 0, 0, 0]
        self._option.sitegroup[:] = 0

    def __enter__(self) -> Renderer:
        return self

    def __exit__(
        self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
    ) -> None:
        self.close()

    def close(self) -> None:
        """Frees OpenGL's memory."""
        if self._gl is not None:
            self._gl.make_current()
            self._context.free()
            self._gl.free()
            self._gl = self._context = None

    def render(
        self, simulator: Simulator | None = None, camera: str | Camera = "front", markers: Iterable[Marker] = ()
    ) -> NDArray[np.uint8]:
        """A picture.

        Args:
            simulator: where everything is now; by default the scene as given, with the robot at home.
            camera: a name out of `CAMERAS`, or a camera of one's own.
            markers: shapes to draw over it.

        Returns:
            (height, width, 3) red, green, blue.

        Raises:
            UnknownBody: there is no camera of that name.
            RenderingUnavailable: the renderer is closed.
        """
        if self._gl is None:
            raise RenderingUnavailable("this renderer is closed; make another")
        view = self.camera(camera)
        if simulator is None:
            self._indices.write_boxes(self._data, self._scene)
            self._indices.write_robot(self._data, RobotState.home())
        else:
            simulator.copy_positions(self._data)
        mujoco.mj_kinematics(self._model, self._data)
        mujoco.mj_comPos(self._model, self._data)
        mujoco.mj_camlight(self._model, self._data)
        self._model.vis.global_.fovy = view.field_of_view
        mujoco.mjv_updateScene(
            self._model,
            self._data,
            self._option,
            None,
            _free_camera(view),
            mujoco.mjtCatBit.mjCAT_ALL.value,
            self._view,
        )
        for marker in markers:
            self._draw(marker)
        self._gl.make_current()
        picture = np.empty((self.height, self.width, 3), np.uint8)
        area = mujoco.MjrRect(0, 0, self.width, self.height)
        mujoco.mjr_render(area, self._view, self._context)
        mujoco.mjr_readPixels(picture, None, area, self._context)
        return np.ascontiguousarray(picture[::-1])

    def project(self, points: ArrayLike, camera: str | Camera = "front") -> Array:
        """Projects points of the world into the pictures of a camera.

        Args:
            points: (n, 3) metres.
            camera: as for `render`.

        Returns:
            (n, 2) pixels from the left and from the top; NaN for points behind the camera.
        """
        view = self.camera(camera)
        right, up, depth = ((np.atleast_2d(np.asarray(points, float)) - view.position) @ view.axes).T
        scale = self.height / 2 / np.tan(np.radians(view.field_of_view) / 2)
        with np.errstate(divide="ignore", invalid="ignore"):
            pixels = np.column_stack([self.width / 2 + scale * right / depth, self.height / 2 - scale * up / depth])
        pixels[depth <= 0] = np.nan
        return pixels

    @staticmethod
    def camera(camera: str | Camera) -> Camera:
        """A camera by its name; a camera is returned as it is.

        Raises:
            UnknownBody: there is none of that name.
        """
        if isinstance(camera, Camera):
            return camera
        if camera not in CAMERAS:
            raise UnknownBody(camera, tuple(CAMERAS))
        return CAMERAS[camera]

    def _draw(self, marker: Marker) -> None:
        if self._view.ngeom >= self._view.maxgeom:
            return
        kinds = {"box": mujoco.mjtGeom.mjGEOM_BOX, "sphere": mujoco.mjtGeom.mjGEOM_ELLIPSOID}
        if marker.shape not in kinds:
            raise UnknownBody(marker.shape, tuple(kinds))
        geom = self._view.geoms[self._view.ngeom]
        mujoco.mjv_initGeom(
            geom,
            kinds[marker.shape].value,
            np.broadcast_to(np.asarray(marker.size, float) / 2, (3,)).copy(),
            np.asarray(marker.position, float),
            matrix(marker.orientation).ravel(),
            np.asarray(marker.color, np.float32),
        )
        self._view.ngeom += 1


def _free_camera(view: Camera) -> Any:
    """MuJoCo's free camera, which is told where it looks, from how far, and at which angles."""
    camera = mujoco.MjvCamera()
    forward = view.axes[:, 2]
    camera.type = mujoco.mjtCamera.mjCAMERA_FREE.value
    camera.lookat[:] = view.target
    camera.distance = float(np.linalg.norm(view.target - view.position))
    camera.elevation = float(np.degrees(np.arcsin(np.clip(forward[2], -1, 1))))
    level = view.axes[:, 1] if abs(forward[2]) > 1 - 1e-9 else forward
    camera.azimuth = float(np.degrees(np.arctan2(level[1], level[0])))
    return camera

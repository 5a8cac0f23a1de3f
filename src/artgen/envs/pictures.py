"""Pictures of a scene, drawn by OpenGL without a window."""

from typing import Any

import numpy as np
from numpy.typing import NDArray

from artgen.envs.robot import simulator
from artgen.envs.scene import Scene
from artgen.view import gl

_SEEN = 2  # the geom group of what is seen
_GROUPS = 6


class Pictures:
    """Draws scenes, one after another; it keeps what the last one needs of the graphics card."""

    def __init__(self) -> None:
        self._scene: Scene | None = None
        self._size = 0
        self._gl: Any = None
        self._context: Any = None
        self._view: Any = None
        self._option: Any = None

    def take(self, scene: Scene, size: int, camera: str, *, shadows: bool) -> NDArray[np.uint8]:
        """Return a picture, shape (size, size, 3).

        Args:
            scene: The scene.
            size: Pixels on a side.
            camera: One of `CAMERAS`.
            shadows: Whether things cast shadows; without a graphics card that takes more than twice as long.

        Raises:
            RenderError: There is no way to draw without a window.
        """
        mujoco = simulator()
        if scene is not self._scene or size != self._size:
            self._open(scene, size)
        self._gl.make_current()
        model, data = scene.model, scene.data
        mujoco.mj_camlight(model, data)
        eye = mujoco.MjvCamera()
        eye.type = mujoco.mjtCamera.mjCAMERA_FIXED
        eye.fixedcamid = model.camera(scene.camera(camera)).id
        every = mujoco.mjtCatBit.mjCAT_ALL
        mujoco.mjv_updateScene(model, data, self._option, None, eye, every, self._view)
        self._view.flags[mujoco.mjtRndFlag.mjRND_SHADOW] = shadows
        rectangle = mujoco.MjrRect(0, 0, size, size)
        pixels = np.empty((size, size, 3), np.uint8)
        mujoco.mjr_render(rectangle, self._view, self._context)
        mujoco.mjr_readPixels(pixels, None, rectangle, self._context)
        return np.ascontiguousarray(pixels[::-1])

    def close(self) -> None:
        """Free the graphics card's memory."""
        if self._gl is not None:
            self._gl.make_current()
            self._context.free()
            self._gl.free()
        self._gl = self._context = self._view = self._scene = None

    def _open(self, scene: Scene, size: int) -> None:
        mujoco = simulator()
        if self._gl is not None and size != self._size:
            self.close()
        if self._gl is None:
            gl.claim_process()
            self._gl = gl.context(size, size)
        else:
            self._gl.make_current()
            self._context.free()
        self._gl.make_current()
        visual = scene.model.vis.global_
        visual.offwidth = visual.offheight = size
        self._context = mujoco.MjrContext(scene.model, mujoco.mjtFontScale.mjFONTSCALE_100)
        mujoco.mjr_setBuffer(mujoco.mjtFramebuffer.mjFB_OFFSCREEN, self._context)
        self._view = mujoco.MjvScene(scene.model, scene.model.ngeom + 10)
        self._option = mujoco.MjvOption()
        for number in range(_GROUPS):
            self._option.geomgroup[number] = number == _SEEN
        self._scene, self._size = scene, size

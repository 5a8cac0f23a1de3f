"""MuJoCo's Filament renderer: physically based, with all maps of a material; Vulkan without a window."""

import contextlib
import importlib
import importlib.util
import math
import os
import subprocess
import sys
import threading
from collections.abc import Callable, Iterator
from concurrent.futures import Future
from dataclasses import dataclass, field
from functools import lru_cache
from queue import SimpleQueue
from typing import Any, TypeVar

import numpy as np
from numpy.typing import NDArray

from artgen._arrays import Array
from artgen.errors import RenderError
from artgen.materials import Material
from artgen.materials.textures import Kind, displayed, encoded, kinds, map_name
from artgen.view.camera import Camera
from artgen.view.classic import KEY, body_of_glass, key_light, spread
from artgen.view.environment import image_light
from artgen.view.scene import Layer, RenderScene
from artgen.view.studio import Backdrop

Result = TypeVar("Result")


class OneThread:
    """Runs calls of all threads one after another in a single thread.

    The thread begins with the first call and ends with the process. Objects that calls create for later ones
    must be released by a call, too.
    """

    def __init__(self, name: str) -> None:
        self._name = name
        self._calls: SimpleQueue[tuple[Callable[[], Any], Future[Any]]] = SimpleQueue()
        self._beginning = threading.Lock()
        self._thread: threading.Thread | None = None

    def begun(self) -> bool:
        """Tell whether there was a call."""
        return self._thread is not None

    def run(self, call: Callable[[], Result]) -> Result:
        """Return the result of a call in the thread, or raise its exception."""
        with self._beginning:
            if self._thread is None:
                # a daemon, so that the process can end; functions at exit may still use it
                self._thread = threading.Thread(target=self._work, name=self._name, daemon=True)
                self._thread.start()
        if threading.current_thread() is self._thread:
            return call()
        answer: Future[Result] = Future()
        self._calls.put((call, answer))
        return answer.result()

    def _work(self) -> None:
        while True:
            _answer(*self._calls.get())


def _answer(call: Callable[[], Any], answer: "Future[Any]") -> None:
    """Run a call in a separate function, which keeps none of its objects alive until the next call."""
    try:
        answer.set_result(call())
    except BaseException as error:  # noqa: BLE001 - whoever asked for the call gets it
        answer.set_exception(error)


THREAD = OneThread("filament")
"""Thread of all calls of Filament, which ends the process when called from two threads."""

_SAMPLES_OF_A_FRAME = 4  # every frame smooths edges and shadows by itself
_IMAGE_LIGHT = "studio_light.ktx"
_ROLES: dict[Kind, str] = {"albedo": "mjTEXROLE_RGB", "orm": "mjTEXROLE_ORM", "normal": "mjTEXROLE_NORMAL"}
_AMBIENT, _SUN = 17500.0, 45000.0  # candela: the sum shows white paper as white
_WHITE = 6.0  # background value that is shown as white
_TONES = "pbr_neutral"  # keeps the colors of materials; only highlights are compressed


@dataclass
class FilamentDress:
    """Materials of Filament: metalness and roughness, with their maps."""

    known: dict[str, tuple[Layer, ...]] = field(default_factory=dict)
    textures: set[str] = field(default_factory=set)

    def layers(self, spec: Any, material: Material, textures: int) -> tuple[Layer, ...]:
        """Add the textures and materials of a surface; return the material passes in draw order."""
        if material.name not in self.known:
            self._add(spec, material, textures)
            self.known[material.name] = (Layer(material.name),)
        return self.known[material.name]

    def _add(self, spec: Any, material: Material, textures: int) -> None:
        import mujoco

        color, metalness, roughness = (
            displayed(material.base_color),
            material.base_metalness,
            material.specular_roughness,
        )
        roles = [""] * int(mujoco.mjtTextureRole.mjNTEXROLE)
        for kind in kinds(material) if textures else ():
            if kind in _ROLES:
                roles[int(getattr(mujoco.mjtTextureRole, _ROLES[kind]))] = self._texture(
                    spec, material, kind, textures
                )
        if roles[int(mujoco.mjtTextureRole.mjTEXROLE_RGB)]:
            color = np.ones(3)
        if roles[int(mujoco.mjtTextureRole.mjTEXROLE_ORM)]:
            metalness = roughness = 1.0
        color = color * body_of_glass(material)
        made = spec.add_material(
            name=material.name,
            rgba=[*(float(each) for each in color), material.opacity],
            metallic=metalness,
            roughness=max(roughness, 0.04),
            emission=max(material.emission),
            reflectance=0.0,
        )
        made.textures = roles

    def _texture(self, spec: Any, material: Material, kind: Kind, size: int) -> str:
        import mujoco

        name = map_name(material, kind)
        if name not in self.textures:
            self.textures.add(name)
            spec.assets[f"{name}.png"] = encoded(material, kind, size, "png")
            spec.add_texture(
                name=name,
                type=mujoco.mjtTexture.mjTEXTURE_2D,
                file=f"{name}.png",
                colorspace=mujoco.mjtColorSpace.mjCOLORSPACE_SRGB
                if kind == "albedo"
                else mujoco.mjtColorSpace.mjCOLORSPACE_LINEAR,
            )
        return name

    def surroundings(self, spec: Any, place: Backdrop) -> None:
        """Add lights and the sky to a specification."""
        import mujoco

        spec.assets[_IMAGE_LIGHT] = image_light()
        spec.add_texture(name="studio_light", type=mujoco.mjtTexture.mjTEXTURE_2D, file=_IMAGE_LIGHT)
        spec.worldbody.add_light(
            name="around", type=mujoco.mjtLightType.mjLIGHT_IMAGE, texture="studio_light", intensity=_AMBIENT
        )
        spec.worldbody.add_light(
            name="key",
            type=mujoco.mjtLightType.mjLIGHT_DIRECTIONAL,
            castshadow=True,
            intensity=_SUN,
            diffuse=[1.0] * 3,
            dir=(-KEY).tolist(),
            pos=(place.center + 4.0 * place.radius * KEY).tolist(),
            bulbradius=0.05 * place.radius,
        )
        spec.add_text(name="filament.cg.tone_mapping", data=_TONES)
        spec.visual.quality.shadowsize = 2048
        spec.visual.quality.offsamples = 4
        spec.visual.headlight.active = 0


class FilamentRenderer:
    """Draws one scene with Filament; only for use in `THREAD`."""

    def __init__(self, scene: RenderScene) -> None:
        context = _context()
        from mujoco.rendering.filament.model_scene import ModelScene
        from mujoco.rendering.filament.renderer import Renderer

        self.scene = scene
        self._renderer = Renderer(context)
        self._model = ModelScene(context, scene.model, self._renderer.scene("main"))
        self._renderer.scene("main").set_msaa(4)
        context.set_clear_color([_WHITE] * 3)

    def close(self) -> None:
        """Free the graphics memory."""
        # release the parts of a scene before the scene
        self._model = self._renderer = None

    def fits(self, size: tuple[int, int]) -> bool:
        """Tell whether pictures of a size can be drawn."""
        return True

    def color(
        self, camera: Camera, poses: list[Array], size: tuple[int, int], samples: int
    ) -> NDArray[np.uint8]:
        """Return the colors, shape (height, width, 3)."""
        import mujoco
        from mujoco.rendering.filament.renderer import View

        width, height = size
        near, far = self.scene.depth_range(camera, poses)
        buffer = np.zeros((height, width, 3), np.uint8)
        self._renderer.target("color", buffer)
        total = np.zeros((height, width, 3), np.float32)
        eye = mujoco.MjvGLCamera()
        right, eye.up, forward = camera.axes()
        eye.pos, eye.frustum_near, eye.frustum_far = camera.position, near, far
        half = near * math.tan(camera.field_of_view / 2.0)
        eye.frustum_width = half * width / height
        pixel = 2.0 * half / height
        frames = max(1, samples // _SAMPLES_OF_A_FRAME)
        for number in range(frames):
            across, along, *place, _, _ = spread(number, frames)
            self.scene.data.light_xdir[1] = -key_light(*place)
            self._model.update(self.scene.data)
            # Filament has no frustum shifted to the side: a rotation by less than a pixel has the same effect
            eye.forward = forward + (across - 0.5) * pixel / near * right
            shift = (along - 0.5) * pixel
            eye.frustum_bottom, eye.frustum_top = shift - half, shift + half
            self._renderer.render([View(scene="main", target="color", camera=eye)])
            total += buffer
        return np.rint(total / frames).astype(np.uint8)


@lru_cache(maxsize=1)
def _context() -> Any:
    """Return the context of this process."""
    _require()
    with _silence():
        # this module provides Filament's shaders: without it the process ends
        importlib.import_module("mujoco.studio._studio")
        from mujoco import mjrf

        config = mjrf.ContextConfig()
        config.graphics_api = mjrf.GraphicsApi.GRAPHICS_API_VULKAN
        config.software_rendering = True
        return mjrf.Context(config)


def forget_context() -> None:
    """Free the context of this process after all its objects; only for use in `THREAD`."""
    _context.cache_clear()


@contextlib.contextmanager
def _silence() -> Iterator[None]:
    """Suppress the output of a library to the process's own streams."""
    sys.stdout.flush()
    sys.stderr.flush()
    saved = [os.dup(number) for number in (1, 2)]
    try:
        with open(os.devnull, "wb") as nothing:  # noqa: PTH123 - a file descriptor is what is needed
            for number in (1, 2):
                os.dup2(nothing.fileno(), number)
        yield
    finally:
        for number, before in zip((1, 2), saved, strict=True):
            os.dup2(before, number)
            os.close(before)


@lru_cache(maxsize=1)
def works() -> bool:
    """Tell whether Filament works here; a child process tries it, because a bad driver ends its process."""
    try:
        _require_packages()
    except RenderError:
        return False
    try:
        child = subprocess.run(  # noqa: S603 - Python, with a program of ours
            [sys.executable, "-c", _TRIAL], capture_output=True, timeout=_PATIENCE, check=False
        )
    except (OSError, subprocess.TimeoutExpired):
        return False
    return child.returncode == 0 and b"drawn" in child.stdout


def _require() -> None:
    _require_packages()
    if not works():
        raise RenderError(
            "Filament does not work here: it needs Vulkan (Debian: libvulkan1 mesa-vulkan-drivers); "
            "use backend='classic'"
        )


def _require_packages() -> None:
    if sys.version_info < (3, 12):
        raise RenderError(
            f"Filament needs Python 3.12 or newer, this is {sys.version_info[0]}.{sys.version_info[1]}; "
            "use backend='classic'"
        )
    try:
        found = importlib.util.find_spec("mujoco.studio") is not None
    except ModuleNotFoundError:
        found = False
    if not found:
        raise RenderError('Filament needs MuJoCo 4 with mujoco-studio: pip install "artgen[sim]"')


_PATIENCE = 60.0  # time limit of the trial [s]
_TRIAL = """
import importlib
importlib.import_module("mujoco.studio._studio")
import mujoco, numpy
from mujoco import mjrf
from mujoco.rendering.filament.model_scene import ModelScene
from mujoco.rendering.filament.renderer import Renderer, View
config = mjrf.ContextConfig()
config.graphics_api = mjrf.GraphicsApi.GRAPHICS_API_VULKAN
config.software_rendering = True
context = mjrf.Context(config)
model = mujoco.MjModel.from_xml_string("<mujoco><worldbody><geom size='1'/></worldbody></mujoco>")
data = mujoco.MjData(model)
mujoco.mj_forward(model, data)
renderer = Renderer(context)
scene = ModelScene(context, model, renderer.scene("main"))
scene.update(data)
pixels = numpy.zeros((16, 16, 3), numpy.uint8)
renderer.target("color", pixels)
camera = mujoco.MjvCamera()
mujoco.mjv_defaultFreeCamera(model, camera)
renderer.render([View(scene="main", target="color", camera=mujoco.mjv_camera2GLCamera(model, data, camera))])
if pixels.any():
    print("drawn", flush=True)
del scene, renderer, context
"""

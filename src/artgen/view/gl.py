"""OpenGL without a window, for MuJoCo's renderer."""

import ctypes
import os
import sys
from typing import Any

from artgen.errors import RenderError

_LIBRARIES = {"egl": ("libEGL.so.1", "libGL.so.1"), "osmesa": ("libOSMesa.so.8", "libOSMesa.so.6")}
_NEEDED = (
    "MuJoCo's renderer needs EGL (Debian: libegl1 libgl1 libegl-mesa0 libgl1-mesa-dri) or OSMesa "
    "(Debian: libosmesa6 libgl1); MUJOCO_GL=egl or MUJOCO_GL=osmesa chooses one"
)


_process: dict[str, int] = {}  # id of the drawing process; in a forked process, that of its parent


def claim_process() -> None:
    """Allow drawing in this process, and not in processes forked from it."""
    if _process.setdefault("id", os.getpid()) != os.getpid():
        raise RenderError(
            "this process was forked from one that had drawn a picture, which graphics drivers do not "
            "survive; start processes by multiprocessing's 'spawn' or 'forkserver', or fork before the first "
            "picture"
        )


def available() -> str:
    """Return the OpenGL backend: `egl`, `osmesa` or, with a display, `window`.

    The environment variable MUJOCO_GL decides; by default the first of EGL and OSMesa whose library loads.
    """
    chosen = os.environ.get("MUJOCO_GL", "").lower().strip()
    if chosen in ("disable", "disabled", "off", "false", "0"):
        raise RenderError(f"MUJOCO_GL={chosen} disables pictures; unset it")
    if not sys.platform.startswith("linux") or chosen in ("glfw", "glx"):
        return "window"
    if chosen in _LIBRARIES:
        if not _loads(chosen):
            raise RenderError(f"MUJOCO_GL={chosen}, but its library cannot be loaded. {_NEEDED}")
        return chosen
    for name in _LIBRARIES:
        if _loads(name):
            return name
    raise RenderError(f"no library for OpenGL without a window was found. {_NEEDED}")


def _loads(name: str) -> bool:
    names = _LIBRARIES[name]
    found = [_library(each) for each in names]
    return all(found) if name == "egl" else any(found)


def _library(name: str) -> bool:
    try:
        ctypes.CDLL(name)
    except OSError:
        return False
    return True


def context(width: int, height: int) -> Any:
    """Return an OpenGL context, with `make_current()` and `free()`."""
    name = available()
    try:
        if name == "egl":
            from mujoco.egl import GLContext
        elif name == "osmesa":
            from mujoco.osmesa import GLContext
        else:
            from mujoco.gl_context import GLContext
        return GLContext(width, height)
    except (ImportError, AttributeError, OSError, RuntimeError) as error:
        other = "osmesa" if name == "egl" else "egl"
        raise RenderError(
            f"OpenGL by {name} does not work: {error}. {_NEEDED}; try MUJOCO_GL={other}"
        ) from error

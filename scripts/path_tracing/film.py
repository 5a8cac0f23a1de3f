"""From radiance to an sRGB picture: noise removal and tone mapping."""

import importlib
from typing import Any

import numpy as np
from numpy.typing import NDArray

from artgen.materials import textures

Array = NDArray[np.float32]

_SHOULDER = 0.76  # radiance up to which colors are reproduced as they are
_WASH = 0.15  # how soon what is brighter turns white
_TOE = 0.02  # radiance below which blacks are deepened


def tone_mapped(radiance: Array) -> Array:
    """Return display-linear colors in 0..1, shape (h, w, 3).

    Ordinary colors stay unchanged; brighter ones approach white. The curve is PBR Neutral of Khronos, applied
    to the brightest channel, so that hues do not change.
    """
    light = np.maximum(np.nan_to_num(radiance, posinf=0.0), 0.0).astype(np.float64)
    light *= light / (light + _TOE) * (1.0 + _TOE)
    peak = light.max(axis=-1, keepdims=True)
    room = 1.0 - _SHOULDER
    rolled = 1.0 - room * room / (np.maximum(peak, _SHOULDER) + room - _SHOULDER)
    scaled = light * (rolled / np.maximum(peak, _SHOULDER))
    white = 1.0 - 1.0 / (_WASH * (np.maximum(peak, _SHOULDER) - rolled) + 1.0)
    return np.asarray(np.where(peak < _SHOULDER, light, scaled * (1.0 - white) + rolled * white), np.float32)


def displayed(linear: Array) -> NDArray[np.uint8]:
    """Return display-linear colors encoded as sRGB."""
    return textures.as_bytes(textures.displayed(linear))


def denoised(color: Array, albedo: Array, normals: Array) -> Array:
    """Return a picture without noise, by Intel Open Image Denoise if the package `oidn` is installed.

    Args:
        color: Display-linear colors in 0..1, shape (h, w, 3).
        albedo: What the surfaces reflect, shape (h, w, 3).
        normals: Unit normals of the surfaces, shape (h, w, 3).
    """
    try:
        oidn = importlib.import_module("oidn")
    except (ImportError, OSError, RuntimeError):  # not installed, without its library, or on another system
        return color
    return _filtered(oidn, color, albedo, normals)


def _filtered(oidn: Any, color: Array, albedo: Array, normals: Array) -> Array:
    height, width = color.shape[:2]
    result = np.zeros_like(color)
    layers = {
        "color": np.ascontiguousarray(color),
        "albedo": np.ascontiguousarray(np.clip(albedo, 0.0, 1.0), np.float32),
        "normal": np.ascontiguousarray(np.clip(normals, -1.0, 1.0), np.float32),
        "output": result,
    }
    device = oidn.NewDevice()
    oidn.CommitDevice(device)
    removal = oidn.NewFilter(device, "RT")
    for name, pixels in layers.items():
        oidn.SetSharedFilterImage(removal, name, pixels, oidn.FORMAT_FLOAT3, width, height)
    oidn.CommitFilter(removal)
    oidn.ExecuteFilter(removal)
    oidn.ReleaseFilter(removal)
    oidn.ReleaseDevice(device)
    return result if result.any() else color

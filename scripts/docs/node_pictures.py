"""Pictures of the examples of nodes: 320 pixels, cached by their content."""

import hashlib
import io
from collections.abc import Mapping

import numpy as np
from PIL import Image

from artgen import MATERIALS, circle, cylinder_between, detail, extrude, part, sphere, sweep, weld
from artgen import _disk_cache as disk_cache
from artgen.asset import Asset
from artgen.graph.evaluation import evaluate
from artgen.graph.handle import Handle
from artgen.nodes.handles import Body, Path, Profile, Solid
from artgen.view import View, opened, render

SIZE = 320
"""Width and height of a picture [pixels]."""

_VERSION = "3"  # of how things are drawn
_PLAIN = MATERIALS["abs"].with_(name="plain", base_color=(0.28, 0.45, 0.62), texture="", tile=None)
_SIGN = MATERIALS["abs"].with_(name="sign", base_color=(0.8, 0.2, 0.12), texture="", tile=None)
_SOLID = View(-0.55, 0.42, margin=0.1)
_FACE = View(-0.25, 0.14, margin=0.1)
_FLAT = 0.12  # depth over height, below which a thing is looked at from in front
_THIN = 0.03  # thickness of profiles and paths, over their size
_OPEN = 0.8  # share of their range that joints are opened
_ARROW = (0.3, 0.01)  # length and radius of the sign of a hand, over the size of the body


def picture(made: Handle) -> bytes:
    """Return a picture of a handle as WebP; of a body that moves, closed and open.

    Raises:
        TypeError: The handle cannot be drawn.
        RenderError: Embree is missing.
    """
    asset = _asset(_body(made))
    low, high = asset.bounds()
    size = high - low
    view = _FACE if isinstance(made, Profile | Path) or size[1] < _FLAT * size[2] else _SOLID
    poses = [{}, opened(asset, _OPEN)] if asset.joints else [{}]
    key = _key(asset, view, poses)
    cached = disk_cache.read("docs_pictures", key)
    if cached is not None:
        return cached
    pixels = [
        render(asset, q, camera=view, size=SIZE, studio="none", textures=0, samples=4).color for q in poses
    ]
    file = io.BytesIO()
    Image.fromarray(np.hstack(pixels)).save(file, "WEBP", quality=82, method=6)
    disk_cache.write("docs_pictures", key, file.getvalue())
    return file.getvalue()


def _body(made: Handle) -> Body:
    """Return the body that shows a handle in a picture."""
    if isinstance(made, Body):
        return _with_hands(made)
    if isinstance(made, Solid):
        return part(made, "example", _PLAIN)
    if isinstance(made, Profile):
        low, high = evaluate(extrude(made, 1.0)).value.bounds()
        return part(extrude(made, _THIN * float((high - low)[:2].max()), axis=(0, -1, 0)), "example", _PLAIN)
    if isinstance(made, Path):
        curve = evaluate(made).value.points
        return part(sweep(circle(0.5 * _THIN * float(np.ptp(curve, axis=0).max())), made), "example", _PLAIN)
    raise TypeError(
        f"a {type(made).__name__} cannot be drawn; let the example end in a profile, path, solid or body"
    )


def _with_hands(body: Body) -> Body:
    """Add an arrow at each grasp or push of the base of a body."""
    link = evaluate(body).value.link
    low, high = _asset(body).bounds()
    length, radius = np.array(_ARROW) * float((high - low).max())
    for hold in (*link.grasps, *link.pushes):
        tip, back = hold.frame[:3, 3], hold.frame[:3, 3] - length * hold.frame[:3, 2]
        arrow = cylinder_between(back, tip, radius) | sphere(2.5 * radius).at(tip)
        body = weld(body, detail(arrow, "hand", _SIGN))
    return body


def _asset(body: Body) -> Asset:
    return Asset.from_tree(
        evaluate(body).value, "example", "example", base="fixed", version="", parameters={}, labels=()
    )


def _key(asset: Asset, view: View, poses: list[Mapping[str, float]]) -> str:
    """Return the cache key of a picture, which depends on all visible content."""
    content = hashlib.blake2b(digest_size=16)
    content.update(repr((_VERSION, SIZE, view, poses, list(asset.joints))).encode())
    for link in asset.links:
        for surface in link.surfaces:
            content.update(repr(surface.material).encode())
            content.update(surface.mesh.vertices.tobytes() + surface.mesh.triangles.tobytes())
    return content.hexdigest()

"""Colors of the surfaces of a picture: lamps with soft shadows, mirrors, and glass.

Light is gathered along few rays for each point; points of one plane share it (`_smoothed`), so neighbors use
different rays. Rays follow fixed sequences: equal pictures have equal pixels.
"""

from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from artgen.materials import Material
from artgen.materials.textures import maps
from artgen.view.camera import Camera
from artgen.view.picture import Pixels
from artgen.view.studio import BOXES, POINTS, Floats, dome, dome_light, environment, spread
from artgen.view.tracing import World, clear, cosine_lobe, dot, mirrored, turned, unit

_BAND = 256  # rows of points that are drawn together
_TAPS, _STRIDES = 4, (1, 3)  # neighbors at both sides that share their light, and their distances [points]
_ALIKE = 0.12  # difference of light that distant neighbors may have, relative to their sum
_REACH = 16  # rows of points beyond a band that share its light
_LAYERS = 8  # most faces of glass in front of a surface
_TILE = np.array([[0, 8, 2, 10], [12, 4, 14, 6], [3, 11, 1, 9], [15, 7, 13, 5]])  # order of rays (Bayer)
_PLACES = np.array([[[0.375, 0.125], [0.875, 0.375]], [[0.125, 0.625], [0.625, 0.875]]])  # points in a pixel
_DULL, _MATT = 0.75, 0.5  # roughness from which a surface mirrors no objects, and the light that it mirrors
_WHITE, _DARK = 1e3, 0.7  # radiance behind all surfaces: without a studio, and below its floor
_GLOW = 2.2  # radiance of an emission of 1


def colors(world: World, camera: Camera, size: tuple[int, int], samples: int, texels: int) -> Pixels:
    """Return the colors of a picture, sRGB, shape (height, width, 3).

    Args:
        world: The surfaces.
        camera: In studio coordinates.
        size: Width and height [pixels].
        samples: Number of rays to the lamps and around for each pixel.
        texels: Texels per side of the material maps; 0 for plain colors.
    """
    painter = _Painter(world, camera, size, max(1, round(samples / 8)), texels)
    rows = 2 * size[1]
    bands = [painter.band(first, min(first + _BAND, rows)) for first in range(0, rows, _BAND)]
    return np.concatenate(bands)


@dataclass(frozen=True, eq=False)
class _Points:
    """The visible points of surfaces."""

    at: Floats
    view: Floats  # directions from the camera
    normal: Floats  # of the smooth surface, towards the camera
    bumped: Floats  # of the material's relief
    triangle: NDArray[Any]
    u: Floats
    v: Floats
    color: Floats  # base colors
    metal: Floats
    rough: Floats
    material: NDArray[Any]


class _Painter:
    """Draws bands of one picture."""

    def __init__(self, world: World, camera: Camera, size: tuple[int, int], rounds: int, texels: int) -> None:
        self.world, self.camera, self.size, self.rounds = world, camera, size, rounds
        self.kind, self.radius = world.place.kind, world.place.radius
        self.eye = np.array(camera.position - world.place.center, np.float32)[:, None]
        self.pixel = np.float32(2.0 * np.tan(camera.field_of_view / 2.0) / size[1])  # at a depth of 1
        every = world.materials
        self.table = {
            name: np.array([getattr(each, name) for each in every], np.float32)
            for name in (
                "base_color", "base_metalness", "specular_roughness", "coat_weight", "coat_roughness",
                "transmission_weight", "opacity", "emission",
            )
        }  # fmt: skip
        self.clear = np.array([clear(each) for each in every])
        self.maps = {
            number: _pyramids(each, texels) for number, each in enumerate(every) if texels and each.texture
        }

    def band(self, first: int, last: int) -> Pixels:
        """Return the colors of the pixels of a band of rows of points."""
        width, height = 2 * self.size[0], 2 * self.size[1]
        above, below = min(first, _REACH), min(height - last, _REACH)
        rows = np.arange(first - above, last + below)
        row, column = (each.ravel() for each in np.meshgrid(rows, np.arange(width), indexing="ij"))
        view = self._rays(row, column)
        points, behind, through, over = self._visible(view)
        order = _order(row, column)
        shape = (len(rows), width)
        background = _WHITE if self.kind == "none" else _DARK
        color: Floats = np.full((3, row.size), background, np.float32)
        if behind.size:
            light = self._light(points, order[behind])
            mirror = self._mirror(points, order[behind])
            light, mirror = self._smoothed(points, behind, shape, light, mirror)
            color[:, behind] = self._shaded(points, light, mirror)
        color = color * through + over
        inner = color.reshape(3, *shape)[:, above : above + last - first]
        return _shown(inner)

    def _rays(self, row: Any, column: Any) -> Floats:
        width, height = self.size
        right, up, forward = (each.astype(np.float32)[:, None] for each in self.camera.axes())
        place = _PLACES[row % 2, column % 2]
        x = ((column // 2 + place[:, 0]) - width / 2.0).astype(np.float32) * self.pixel
        y = (height / 2.0 - (row // 2 + place[:, 1])).astype(np.float32) * self.pixel
        return unit(forward + x * right + y * up)

    def _visible(self, view: Floats) -> tuple[_Points, NDArray[Any], Floats, Floats]:
        """Return what rays meet behind glass, which rays meet it, and the light through and from glass."""
        world, count = self.world, view.shape[1]
        through, over = np.ones((3, count), np.float32), np.zeros((3, count), np.float32)
        ray = np.arange(count)
        origin = np.repeat(self.eye, count, axis=1)
        found = []
        for layer in range(_LAYERS):
            last = layer == _LAYERS - 1
            hits = world.run(world.opaque if last else world.all, origin, view[:, ray])
            met = hits["primID"] >= 0
            ray, origin = ray[met], origin[:, met]
            triangle, distance = hits["primID"][met], hits["tfar"][met]
            u, v = hits["u"][met], hits["v"][met]
            at = origin + distance * view[:, ray]
            glass = self.clear[world.material[triangle]]
            found.append([ray[~glass], at[:, ~glass], triangle[~glass], u[~glass], v[~glass]])
            if not glass.any():
                break
            ray, at, triangle, u, v = ray[glass], at[:, glass], triangle[glass], u[glass], v[glass]
            passed, added = self._pane(self._points(at, view[:, ray], triangle, u, v))
            over[:, ray] += through[:, ray] * added
            through[:, ray] *= passed
            origin = at + world.offset * view[:, ray]
        ray, at, triangle, u, v = (np.concatenate(each, axis=-1) for each in zip(*found, strict=True))
        return self._points(at, view[:, ray], triangle, u, v), ray, through, over

    def _points(self, at: Floats, view: Floats, triangle: Any, u: Floats, v: Floats) -> _Points:
        world = self.world
        normal = world.normals_at(triangle, u, v)
        normal = normal * -np.sign(dot(world.flat[triangle].T, view))
        normal = unit(normal - (np.maximum(dot(normal, view), 0.0) + np.float32(1e-3)) * view)
        number = world.material[triangle]
        color = self.table["base_color"][number].T.copy()
        metal = self.table["base_metalness"][number]
        rough = self.table["specular_roughness"][number]
        bumped = normal.copy()
        depth = np.sqrt(dot(at - self.eye, at - self.eye))
        for each in np.unique(number):
            if each not in self.maps:
                continue
            here = np.flatnonzero(number == each)
            uv = world.uvs_at(triangle[here], u[here], v[here])
            facing = np.maximum(np.abs(dot(normal[:, here], view[:, here])), np.float32(0.2))
            self._textured(
                each, here, uv, self.pixel / 2.0 * depth[here] / facing, color, metal, rough, bumped, triangle
            )
        return _Points(at, view, normal, bumped, triangle, u, v, color, metal, rough, number)

    def _textured(
        self,
        number: int,
        here: Any,
        uv: Floats,
        wide: Floats,
        color: Floats,
        metal: Floats,
        rough: Floats,
        bumped: Floats,
        triangle: Any,
    ) -> None:
        levels, texel = self.maps[number]
        level = np.clip(np.log2(np.maximum(wide / texel, 1e-6)) + 0.3, 0, len(levels) - 1).astype(int)
        for step in np.unique(level):
            some = np.flatnonzero(level == step)
            at, maps_ = here[some], levels[step]
            values = _texel(maps_, uv[:, some])
            rough[at] = values[0]
            tilt = values[1:3]
            rest = 3
            if maps_.shape[2] in (6, 7):
                color[:, at] = values[3:6]
                rest = 6
            if maps_.shape[2] in (4, 7):
                metal[at] = values[rest]
            normal = bumped[:, at]
            along = self.world.tangents[triangle[at]].T
            along = unit(along - dot(along, normal) * normal)
            up = np.cross(normal, along, axis=0)
            bumped[:, at] = unit(normal + tilt[0] * along + tilt[1] * up)

    def _light(self, points: _Points, order: NDArray[Any]) -> Floats:
        """Return the light that arrives at points: the radiance of white paper there, by color."""
        world = self.world
        total = np.zeros_like(points.at)
        origin = points.at + world.offset * points.normal
        lamps = world.lamp_light(origin, points.normal)
        for turn in range(self.rounds):
            number = (order + 16 * turn) % POINTS
            path = turned(cosine_lobe()[:, number], points.normal)
            triangle = world.first(origin, path)
            # what is in the way takes light from that of an open place, so that open places have no noise
            met = np.flatnonzero(triangle >= 0)
            total[:, met] += world.glow[triangle[met]].T - dome(path[2, met])
            total -= world.hidden(origin, points.normal, lamps, number)
        total = total / np.float32(self.rounds) + lamps.sum(axis=0) + dome_light(points.normal[2])
        return np.asarray(np.maximum(total, 0.0))

    def _mirror(self, points: _Points, order: NDArray[Any]) -> Floats:
        """Return the light that points mirror."""
        total = np.zeros_like(points.at)
        for turn in range(self.rounds):
            across, along = spread(POINTS)[:, (order + 16 * turn) % POINTS].astype(np.float32)
            total += self._reflected(points, across, along)
        return np.asarray(total / np.float32(self.rounds))

    def _reflected(self, points: _Points, across: Floats, along: Floats) -> Floats:
        """Return the light from the direction of the mirror, from objects in a random one near it."""
        result = np.full_like(points.at, _MATT)
        coat = self.table["coat_weight"][points.material] > 0.0
        seen = np.flatnonzero((points.rough < _DULL) | coat)
        if not seen.size:
            return result
        normal, base = points.bumped[:, seen], points.normal[:, seen]
        way = mirrored(points.view[:, seen], normal)
        # below the horizon of the surface there is none
        way = unit(way - 2.0 * np.minimum(dot(way, base), 0.0) * base)
        result[:, seen] = environment(points.at[:, seen], way, points.rough[seen], self.radius)
        rough = points.rough[seen]
        alpha = rough * rough * _blurred(rough)
        tangent = alpha * np.sqrt(across[seen] / np.maximum(1.0 - across[seen], 0.02))
        angle = np.float32(2.0 * np.pi) * along[seen]
        half = turned(
            unit(np.stack([tangent * np.cos(angle), tangent * np.sin(angle), np.ones_like(angle)])), normal
        )
        ray = mirrored(points.view[:, seen], half)
        ray = unit(ray - 2.0 * np.minimum(dot(ray, base), 0.0) * base)
        met, distance, light = self._seen(points.at[:, seen] + self.world.offset * base, ray, rough)
        # the floor ends without an edge
        far = np.clip((distance / self.radius - 3.0) / 9.0, 0.0, 1.0)
        result[:, seen[met]] += (1.0 - far) * (light - result[:, seen[met]])
        return result

    def _seen(self, origin: Floats, ray: Floats, rough: Floats) -> tuple[NDArray[Any], Floats, Floats]:
        """Return which rays meet a surface, how far away, and the light from there."""
        world = self.world
        hits = world.run(world.opaque, origin, ray)
        met = np.flatnonzero(hits["primID"] >= 0)
        triangle, u, v = hits["primID"][met], hits["u"][met], hits["v"][met]
        light = world.glow_at(triangle, u, v)
        number = world.material[triangle]
        metal = np.flatnonzero(self.table["base_metalness"][number] > 0.5)
        if metal.size:
            at = origin[:, met[metal]] + hits["tfar"][met[metal]] * ray[:, met[metal]]
            normal = world.normals_at(triangle[metal], u[metal], v[metal])
            way = mirrored(ray[:, met[metal]], normal)
            own = np.maximum(self.table["specular_roughness"][number[metal]], rough[met[metal]])
            sky = environment(at, way, own, self.radius)
            color = self.table["base_color"][number[metal]].T
            arriving = world.light_at(triangle[metal], u[metal], v[metal])
            light[:, metal] = color * np.minimum(sky, 0.5 * sky + 0.7 * arriving)
        return met, hits["tfar"][met], light

    def _pane(self, points: _Points) -> tuple[Floats, Floats]:
        """Return the share of light through faces of glass, and the light from them."""
        number = points.material
        half = np.full(number.shape, 0.5, np.float32)
        bright = self._reflected(points, half * 0.0, half)
        facing = np.minimum(np.abs(dot(points.view, points.bumped)), 1.0)
        fresnel = 0.04 + 0.96 * (1.0 - facing) ** 5
        color = points.color
        share, opacity = self.table["transmission_weight"][number], self.table["opacity"][number]
        # frosted glass scatters, clear glass does not; what has no transmission is a fine weave
        haze = np.where(share > 0.0, np.clip(points.rough / 0.5, 0.0, 1.0), 1.0)
        scatter = np.where(share > 0.0, 1.0 - share * (1.0 - haze * opacity), opacity)
        light = self.world.light_at(points.triangle, points.u, points.v)
        passed = (1.0 - fresnel) * (1.0 - scatter) * np.where(share > 0.0, np.sqrt(color), 1.0)
        return passed, fresnel * bright + (1.0 - fresnel) * scatter * color * light

    def _smoothed(
        self, points: _Points, behind: NDArray[Any], shape: tuple[int, int], light: Floats, mirror: Floats
    ) -> tuple[Floats, Floats]:
        """Average light among points of one plane, and mirrored light as far as they are rough."""
        count = shape[0] * shape[1]
        offset = points.at - self.eye
        reach = 1.0 / (6.0 * self.pixel * np.sqrt(dot(offset, offset)))
        known = [*points.at, *points.normal, np.ones_like(reach), reach, *light, *mirror]
        spread_out = np.zeros((len(known), count), np.float32)
        spread_out[:, behind] = known
        grid = spread_out.reshape(-1, *shape)
        guide, values = grid[:8], grid[8:]
        for stride in _STRIDES:
            for axis in (1, 2):
                values = _averaged(values, guide, axis, stride)
        found = values.reshape(6, count)[:, behind]
        return found[:3], mirror + _blurred(points.rough) * (found[3:] - mirror)

    def _shaded(self, points: _Points, light: Floats, mirror: Floats) -> Floats:
        number = points.material
        color, metal, rough = points.color, points.metal, points.rough
        # a relief is brighter where it faces the key lamp
        key = np.array(BOXES[0].center, np.float32)
        key /= np.linalg.norm(key)
        relief = points.bumped - points.normal
        light = light * np.clip(
            1.0 + 0.9 * dot(np.broadcast_to(key[:, None], relief.shape), relief), 0.3, 1.7
        )
        facing = np.clip(-dot(points.view, points.bumped), 0.02, 1.0)
        scale, bias = _fresnel(rough, facing)
        normal_share = 0.04 + (color - 0.04) * metal
        specular = normal_share * scale + bias
        result = (1.0 - metal) * (1.0 - specular) * color * light + specular * mirror
        coat = self.table["coat_weight"][number]
        coated = np.flatnonzero(coat > 0.0)
        if coated.size:
            view = points.view[:, coated]
            way = mirrored(view, points.normal[:, coated])
            glossy = self.table["coat_roughness"][number[coated]]
            sky = environment(points.at[:, coated], way, glossy, self.radius)
            level = np.minimum(sky, 0.3 * sky + 0.7 * mirror[:, coated] + 0.5 * light[:, coated])
            share = coat[coated] * (0.04 + 0.96 * (1.0 - facing[coated]) ** 5)
            result[:, coated] = (1.0 - share) * result[:, coated] + share * level
        return np.asarray(result + np.float32(_GLOW) * self.table["emission"][number].T)


def _blurred(rough: Floats) -> Floats:
    """Return how far the mirrored light of neighbors is averaged, 0..1; a polished surface has no blur."""
    return np.asarray(np.clip((rough - np.float32(0.1)) / np.float32(0.14), 0.0, 1.0))


def _fresnel(rough: Floats, facing: Floats) -> tuple[Floats, Floats]:
    """Return the factors of a surface's reflectance (Karis 2014)."""
    first = np.minimum((1.0 - rough) ** 2, np.exp2(-9.28 * facing)) * (1.0 - rough) + (
        0.0425 - 0.0275 * rough
    )
    return (-1.04 * first + 1.04 - 0.572 * rough).clip(0.0), (1.04 * first + 0.022 * rough - 0.04).clip(0.0)


def _averaged(values: Floats, guide: Floats, axis: int, stride: int) -> Floats:
    """Average values over points of one plane along one axis; with wide strides, only over similar values."""
    total = values * guide[6]
    weights = guide[6].copy()
    length = values.shape[axis]
    for number in range(1, _TAPS + 1):
        step = stride * number
        if step >= length:
            break
        one = (slice(None),) * axis + (slice(0, length - step),)
        other = (slice(None),) * axis + (slice(step, length),)
        a, b = guide[one], guide[other]
        facing = a[3] * b[3] + a[4] * b[4] + a[5] * b[5]
        x, y, z = b[0] - a[0], b[1] - a[1], b[2] - a[2]
        apart = np.abs(x * a[3] + y * a[4] + z * a[5]) + np.abs(x * b[3] + y * b[4] + z * b[5])
        near = a[7] / np.float32(stride)
        weight = np.clip(8.0 * facing - 7.0, 0.0, 1.0) * np.clip(1.5 - apart * near * 2.0, 0.0, 1.0)
        weight *= a[6] * b[6] * np.float32(np.exp(-((number / _TAPS) ** 2)))
        first, second = values[one], values[other]
        if stride > 1:
            unlike = np.abs(first[1] - second[1]) / (first[1] + second[1] + np.float32(0.3))
            weight *= np.clip(1.5 - unlike / np.float32(_ALIKE), 0.0, 1.0)
        total[one] += weight * second
        total[other] += weight * first
        weights[one[1:]] += weight
        weights[other[1:]] += weight
    return np.asarray(total / np.maximum(weights, np.float32(1e-6)))


def _order(row: NDArray[Any], column: NDArray[Any]) -> NDArray[Any]:
    """Return the number of the first ray of each point: neighbors in a tile have successive numbers."""
    i, j = row // 4, column // 4
    run = (i * 2654435761 + j * 2246822519) & 0xFFFFFFFF
    run = ((run ^ (run >> 15)) * 2146121005) & 0xFFFFFFFF
    run = (run ^ (run >> 13)) % (POINTS // 16)
    return np.asarray(16 * run + _TILE[row % 4, column % 4])


def _pyramids(material: Material, texels: int) -> tuple[list[Floats], float]:
    """Return the maps of a material at full and smaller sizes, and the size of a texel [m].

    Channels are roughness, two slopes of the relief, the color if it has a map, and the metalness if so.
    """
    from artgen.materials.textures import tile_of

    found = maps(material, texels)
    rough = found.roughness.astype(np.float32)[..., None] / 255.0
    slopes = np.zeros((*rough.shape[:2], 2), np.float32)
    if found.normal is not None:
        normal = found.normal.astype(np.float32) / 127.5 - 1.0
        slopes = normal[..., :2] / np.maximum(normal[..., 2:], 0.1)
    layers = [rough, slopes]
    if found.albedo is not None:
        layers.append(_LINEAR[found.albedo])
    if found.metalness is not None:
        layers.append(found.metalness.astype(np.float32)[..., None] / 255.0)
    levels = [np.concatenate(layers, axis=-1)]
    while len(levels[-1]) > 1:
        large = levels[-1]
        levels.append((large[::2, ::2] + large[1::2, ::2] + large[::2, 1::2] + large[1::2, 1::2]) / 4.0)
    return levels, float(max(tile_of(material))) / texels


_CODES = np.arange(256) / 255.0
_LINEAR = np.where(_CODES <= 0.04045, _CODES / 12.92, ((_CODES + 0.055) / 1.055) ** 2.4).astype(np.float32)


def _texel(level: Floats, uv: Floats) -> Floats:
    """Return the channels of a map at texture coordinates, interpolated, shape (channels, n)."""
    size = len(level)
    x, y = uv[0] * size - 0.5, -uv[1] * size - 0.5
    left, top = np.floor(x), np.floor(y)
    right, down = (x - left)[:, None], (y - top)[:, None]
    i, j = top.astype(np.int64) % size, left.astype(np.int64) % size
    k, m = (i + 1) % size, (j + 1) % size
    upper = level[i, j] * (1.0 - right) + level[i, m] * right
    lower = level[k, j] * (1.0 - right) + level[k, m] * right
    return np.asarray((upper * (1.0 - down) + lower * down).T, np.float32)


_SHOULDER, _WASH = 0.78, 0.15


def _shown(light: Floats) -> Pixels:
    """Return radiances of points as pixels: highlights compressed and whitened (PBR Neutral of Khronos)."""
    light = np.maximum(light, 0.0)
    peak = light.max(axis=0)
    room = 1.0 - _SHOULDER
    over = np.maximum(peak, _SHOULDER)
    rolled = 1.0 - room * room / (over + room - _SHOULDER)
    white = 1.0 - 1.0 / (_WASH * (over - rolled) + 1.0)
    toned = np.where(peak < _SHOULDER, light, light * (rolled / over) * (1.0 - white) + rolled * white)
    mean = (toned[:, ::2, ::2] + toned[:, 1::2, ::2] + toned[:, ::2, 1::2] + toned[:, 1::2, 1::2]) / 4.0
    code = np.where(mean <= 0.0031308, 12.92 * mean, 1.055 * np.maximum(mean, 1e-6) ** (1 / 2.4) - 0.055)
    return np.asarray(np.rint(np.clip(code, 0.0, 1.0) * 255.0).astype(np.uint8).transpose(1, 2, 0))

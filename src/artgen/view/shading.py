"""Colors of the surfaces of a picture: lamps with soft shadows, mirrors, and glass.

A pixel has four points, and sixteen where these or those of a neighbor lie on several faces. One point stands
for those of a pixel on one face (`_apart`). Light is gathered along few rays for one point of each pixel;
points of one plane share it (`_smoothed`), so neighbors use different rays. Rays follow fixed sequences, and
threads draw separate bands: equal pictures have equal pixels.
"""

from collections.abc import Callable, Sequence
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass, fields, replace
from typing import Any, Self

import numpy as np
from numpy.typing import NDArray

from artgen.materials import Material
from artgen.materials.textures import maps, tile_of
from artgen.view.camera import Camera
from artgen.view.picture import Pixels
from artgen.view.studio import BOXES, POINTS, Floats, dome, dome_light, environment, spread
from artgen.view.tracing import THREADS, World, clear, cosine_lobe, dot, mirrored, turned, unit

_BAND, _MOST_PIXELS = 256, 131_072  # most rows, and most pixels, that are drawn together
_TAPS, _STRIDES = 3, (1, 3)  # neighbors at both sides that share their light, and their distances [pixels]
# weights of neighbors below which a point gathers its own light, along how many times more rays
_ALONE, _SUPPORT, _ALONE_ROUNDS = 0.05, 3.0, 2
# factors of the roughness of brushed metal across the strokes and along them, slopes of its facets across the
# strokes, and the size of the smudges that it lacks [m]
_ACROSS, _ALONG, _SLOPES, _SMUDGE = 1.9, 0.75, (-1.7, -0.8, -0.35, 0.0, 0.35, 0.8, 1.7), 0.03
_STREAKS = {"brushed": 2.7, "satin": 1.0}  # brightness of strokes for their deviation of roughness
_FUZZ = {
    "pile": 0.9,
    "linen": 0.2,
    "canvas": 0.15,
}  # light that upright fibers of textures scatter at grazing
_MUCH = 0.2  # change of a ray's light by what is in its way, from which there are more rays
_ALIKE = 0.3  # difference of light that distant neighbors may have, relative to their sum
_FAINT = 0.06  # share of the light at a point that the picture shows, up to which one ray is enough
_DIM = 0.2  # share of light through glass, up to which edges behind it have few points
_REACH = 15  # rows of pixels beyond a band that share its light
_BESIDE = ((0, 0), (0, 1), (0, -1), (1, 0), (-1, 0))  # pixels that lend light to a point
_LAYERS = 8  # most faces of glass in front of a surface
# points in a pixel [sixteenths]: the first four, and all, are spread evenly over rows, columns and squares
_PLACES = 0.5 + np.array(
    [
        [2, 12], [10, 7], [6, 2], [14, 8], [1, 5], [9, 14], [5, 11], [13, 0],
        [3, 1], [11, 10], [7, 15], [15, 4], [0, 9], [8, 3], [4, 6], [12, 13],
    ]
)  # fmt: skip
_QUARTERS = (_PLACES // 8.0) @ [1, 2]  # of the pixel, for each point
_FEW, _ALL = 4, len(_PLACES)  # points in a pixel without an edge, and with one
_DULL, _MATT = 0.75, 0.5  # roughness from which a surface mirrors no objects, and the light that it mirrors
_WHITE, _DARK = 1e3, 0.7  # radiance behind all surfaces: without a studio, and below its floor
_FLAT = 0.9  # least cosine between the faces that a point stands for
_POLISHED = 0.2  # roughness up to which a metal mirrors edges
# most difference of the normals for which a point stands, and what it adds to the square of a lobe's width
_MOST_TURN, _BROADER = 1.2, 1.0 / 6.0
_BENT = 0.2  # difference of the normals in a pixel from which they are averaged
_LEVEL = 0.85  # least width of a point for a map, relative to its texel
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
    painter = _Painter(world, camera, size, max(1, round(samples / 2)), texels)
    height = max(_REACH, min(_BAND, _MOST_PIXELS // size[0]))
    firsts = range(0, size[1], height)
    with ThreadPoolExecutor(min(THREADS, len(firsts))) as pool:
        bands = pool.map(lambda first: painter.band(first, min(first + height, size[1])), firsts)
        return np.concatenate(list(bands))


_Spread = Callable[[NDArray[np.bool_]], NDArray[np.bool_]]


class _Rows:
    """Arrays of equal length."""

    def take(self, some: NDArray[Any]) -> Self:
        """Return some of the columns."""
        each: Any = type(self)
        return each(*(getattr(self, field.name)[..., some] for field in fields(each)))  # type: ignore[no-any-return]


@dataclass(frozen=True, eq=False)
class _Points(_Rows):
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
    streak: Floats  # deviation of roughness along a stroke of a brush
    material: NDArray[Any]
    shown: Floats  # share of their light that arrives at the camera through glass


@dataclass(frozen=True, eq=False)
class _Found(_Rows):
    """Hits of rays, in the order of their pixels."""

    ray: NDArray[Any]
    pixel: NDArray[Any]
    quarter: NDArray[Any]  # of the pixel
    at: Floats
    triangle: NDArray[Any]
    u: Floats
    v: Floats


@dataclass(frozen=True, eq=False)
class _Seen:
    """What rays meet."""

    view: Floats  # their directions
    through: Floats  # share of light through glass, shape (3, rays)
    over: Floats  # light from glass
    layers: list[_Found]  # first hits, and those behind each face of glass
    found: _Found  # first hits of what lets no light through


def _joined(found: Sequence[_Found]) -> _Found:
    """Return all hits, in the order of their pixels."""
    every = [
        np.concatenate([getattr(each, field.name) for each in found], axis=-1) for field in fields(_Found)
    ]
    merged = _Found(*every)
    return merged if len(found) == 1 else merged.take(np.argsort(merged.pixel, kind="stable"))


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
        self.polished = np.array(
            [each.base_metalness > 0.5 and each.specular_roughness < _POLISHED for each in every]
        )
        self.strokes = np.array(
            [_STREAKS.get(each.texture, 0.0) if texels else 0.0 for each in every], np.float32
        )
        self.fuzz = np.array([_FUZZ.get(each.texture, 0.0) for each in every], np.float32)
        self.brushed = self.strokes > 0.0
        textured = [number for number, each in enumerate(every) if texels and each.texture]
        with ThreadPoolExecutor(THREADS) as pool:
            pyramids = pool.map(lambda number: _pyramids(every[number], texels), textured)
            self.maps = dict(zip(textured, pyramids, strict=True))

    def band(self, first: int, last: int) -> Pixels:
        """Return the colors of a band of rows of pixels."""
        width, height = self.size
        above, below = min(first, _REACH), min(height - last, _REACH)
        rows = np.arange(first - above, last + below)
        shape = len(rows), width
        count = len(rows) * width
        few = self._visible(np.repeat(np.arange(count), _FEW), np.tile(np.arange(_FEW), count), rows[0])
        marks = np.zeros(shape, bool)
        plain = few.through.max(axis=0) > _DIM
        for layer, hits in enumerate(few.layers):
            marks.ravel()[self._edges(hits.take(plain[hits.ray]) if layer else hits)] = True
        edges = np.flatnonzero(_widened(marks, 1))
        more = self._visible(
            np.repeat(edges, _ALL - _FEW), np.tile(np.arange(_FEW, _ALL), len(edges)), rows[0]
        )
        found = _joined([few.found, replace(more.found, ray=more.found.ray + _FEW * count)])
        background = _WHITE if self.kind == "none" else _DARK
        color: Floats = np.full((3, _FEW * count + more.view.shape[1]), background, np.float32)
        view, through, over = (
            np.concatenate([getattr(each, name) for each in (few, more)], axis=1)
            for name in ("view", "through", "over")
        )
        if found.ray.size:
            some, number, wide = self._apart(found)
            points = self._points(found, some, number, view, wide, through)
            color[:, found.ray] = self._lit(points, found.pixel[some], int(rows[0]), shape)[:, number]
        color *= through
        color += over
        color = _toned(color)
        mean = color[:, : _FEW * count].reshape(3, count, _FEW).sum(axis=2)
        mean[:, edges] += color[:, _FEW * count :].reshape(3, len(edges), _ALL - _FEW).sum(axis=2)
        mean /= np.float32(_FEW)
        mean[:, edges] *= np.float32(_FEW / _ALL)
        return _shown(mean.reshape(3, *shape)[:, above : above + last - first])

    def _rays(self, pixel: NDArray[Any], point: NDArray[Any], top: int) -> Floats:
        """Return the directions through points in pixels, whose first row is `top`."""
        width, height = self.size
        right, up, forward = (each.astype(np.float32)[:, None] for each in self.camera.axes())
        across, down = (_PLACES.T / 16.0).astype(np.float32)
        x = ((pixel % width) + across[point] - np.float32(width / 2.0)) * self.pixel
        y = (np.float32(height / 2.0) - (top + pixel // width) - down[point]) * self.pixel
        return unit(forward + x.astype(np.float32) * right + y.astype(np.float32) * up)

    def _visible(self, pixel: NDArray[Any], point: NDArray[Any], top: int) -> _Seen:
        """Return what rays through points in pixels meet, behind glass and on it."""
        world, count = self.world, len(pixel)
        view, quarter = self._rays(pixel, point, top), _QUARTERS[point].astype(np.int8)
        through, over = np.ones((3, count), np.float32), np.zeros((3, count), np.float32)
        ray = np.arange(count)
        origin = np.repeat(self.eye, count, axis=1)
        layers, found = [], []
        for layer in range(_LAYERS):
            last = layer == _LAYERS - 1
            hits = world.run(world.opaque if last else world.all, origin, view[:, ray])
            met = np.flatnonzero(hits["primID"] >= 0)
            ray = ray[met]
            triangle, u, v = (hits[name][met] for name in ("primID", "u", "v"))
            at = origin[:, met] + hits["tfar"][met] * view[:, ray]
            hit = _Found(ray, pixel[ray], quarter[ray], at, triangle, u, v)
            layers.append(hit)
            glass = self.clear[world.material[triangle]]
            if not glass.any():
                found.append(hit)
                break
            found.append(hit.take(~glass))
            pane = hit.take(glass)
            some, number, wide = self._apart(pane)
            passed, added = self._pane(self._points(pane, some, number, view, wide, through))
            ray = pane.ray
            over[:, ray] += through[:, ray] * added[:, number]
            through[:, ray] *= passed[:, number]
            origin = pane.at + world.offset * view[:, ray]
        return _Seen(view, through, over, layers, _joined(found))

    def _edges(self, hits: _Found) -> NDArray[Any]:
        """Return the pixels whose first points lie on several faces, or meet nothing in part."""
        first = np.diff(hits.pixel, prepend=-1) > 0
        lead = np.flatnonzero(first)[np.cumsum(first) - 1]
        apart = hits.pixel[~self._on_one_face(hits, np.arange(len(lead)), lead)]
        return np.concatenate([apart, np.flatnonzero(np.bincount(hits.pixel) % _FEW)])

    def _apart(self, hits: _Found) -> tuple[NDArray[Any], NDArray[Any], Floats]:
        """Return which hits are shaded, which of these stands for each hit, and their widths [pixels]."""
        every = np.arange(hits.ray.size)
        sharp = self.polished[self.world.material[hits.triangle]]  # what it mirrors has edges
        stands, left = every.copy(), every
        while left.size:
            first = np.diff(hits.pixel[left], prepend=-1) > 0
            lead = left[first][np.cumsum(first) - 1]
            joins = self._on_one_face(hits, left, lead)
            joins &= ~sharp[left] | (hits.quarter[left] == hits.quarter[lead])
            stands[left[joins]] = lead[joins]
            left = left[~joins]
        leads = stands == every
        some, number = np.flatnonzero(leads), (np.cumsum(leads) - 1)[stands]
        share = np.bincount(number) / np.bincount(hits.pixel)[hits.pixel[some]]
        return some, number, np.sqrt(np.maximum(share, 0.25)).astype(np.float32)

    def _on_one_face(self, hits: _Found, one: NDArray[Any], other: NDArray[Any]) -> NDArray[np.bool_]:
        """Tell which pairs of hits lie on one face."""
        world = self.world
        a, b = hits.triangle[one], hits.triangle[other]
        same = np.asarray(a == b)
        mixed = np.flatnonzero(~same)
        if mixed.size:
            a, b, one, other = a[mixed], b[mixed], one[mixed], other[mixed]
            flat = world.flat[b]
            at = hits.at[:, other]
            away = np.abs(dot(hits.at[:, one] - at, flat.T))
            close = away < self.pixel * np.linalg.norm(at - self.eye, axis=0)
            close &= (flat * world.flat[a]).sum(axis=1) > _FLAT
            same[mixed] = close & (world.material[a] == world.material[b])
        return same

    def _normals(
        self, hits: _Found, some: NDArray[Any], number: NDArray[Any], view: Floats
    ) -> tuple[Floats, Floats]:
        """Return the normals at hits, averaged where these stand for bent faces, and how far they differ."""
        world = self.world

        def facing(these: NDArray[Any]) -> Floats:
            triangle = hits.triangle[these]
            normal = world.normals_at(triangle, hits.u[these], hits.v[these])
            return np.asarray(normal * -np.sign(dot(world.flat[triangle].T, view[:, hits.ray[these]])))

        normals = facing(some)
        far = np.sqrt(dot(hits.at - self.eye, hits.at - self.eye))
        bent = np.zeros(len(some), bool)
        bent[number[world.curvature[hits.triangle] * far * self.pixel > _BENT]] = True
        members = np.flatnonzero(bent[number])
        total = [np.bincount(number[members], each, len(some))[bent] for each in facing(members)]
        mean = np.array(total, np.float32)
        normals[:, bent] = unit(mean)
        turn = np.zeros(len(some), np.float32)
        share = np.linalg.norm(mean, axis=0) / np.bincount(number)[bent]
        # what adds the variance of the normals to the square of a lobe's width
        turn[bent] = np.sqrt(np.maximum(1.0 - share, 0.0) / _BROADER)
        return normals, turn

    def _points(
        self,
        hits: _Found,
        some: NDArray[Any],
        number: NDArray[Any],
        view: Floats,
        wide: Floats,
        through: Floats,
    ) -> _Points:
        """Return the surface at the hits `some`, with maps averaged over widths [pixels]."""
        world = self.world
        normal, turn = self._normals(hits, some, number, view)
        at, view, triangle, u, v = (
            hits.at[:, some], view[:, hits.ray[some]], hits.triangle[some], hits.u[some], hits.v[some],
        )  # fmt: skip
        normal = unit(normal - (np.maximum(dot(normal, view), 0.0) + np.float32(1e-3)) * view)
        number = world.material[triangle]
        points = _Points(
            at, view, normal, normal.copy(), triangle, u, v,
            self.table["base_color"][number].T.copy(), self.table["base_metalness"][number],
            self.table["specular_roughness"][number], np.zeros(len(some), np.float32), number,
            through[:, hits.ray[some]].max(axis=0),
        )  # fmt: skip
        wide = wide * self.pixel * np.sqrt(dot(at - self.eye, at - self.eye))
        for each in np.unique(number):
            if each in self.maps:
                here = np.flatnonzero(number == each)
                facing = np.maximum(np.abs(dot(normal[:, here], view[:, here])), np.float32(0.2))
                self._textured(points, each, here, wide[here] / facing)
        # a point stands for all normals within its width
        turn = np.minimum(np.maximum(world.curvature[triangle] * wide, turn), _MOST_TURN)
        alpha = points.rough * points.rough
        points.rough[:] = np.sqrt(np.sqrt(alpha * alpha + np.float32(_BROADER) * turn * turn))
        return points

    def _textured(self, points: _Points, number: int, here: Any, wide: Floats) -> None:
        """Set the values of maps at points of a material, averaged over widths [m]."""
        uv = self.world.uvs_at(points.triangle[here], points.u[here], points.v[here])
        levels, texels = self.maps[number]
        level, smudge = (
            np.maximum(np.searchsorted(texels, each / _LEVEL, side="right") - 1, 0)
            for each in (wide, _SMUDGE)
        )
        brushed = self.brushed[number]
        for step in np.unique(level):
            some = np.flatnonzero(level == step)
            at, maps_ = here[some], levels[step]
            values = _texel(maps_, uv[:, some])
            if brushed:
                mean = _texel(levels[smudge][..., :1], uv[:, some])[0]
                points.streak[at] = values[0] - mean
                values[0] = points.rough[at]
            points.rough[at] = values[0]
            rest = 3
            if maps_.shape[2] in (6, 7):
                points.color[:, at] = values[3:6]
                rest = 6
            if maps_.shape[2] in (4, 7):
                points.metal[at] = values[rest]
            if not brushed:
                along, up = self._frame(points, at)
                points.bumped[:, at] = unit(points.normal[:, at] + values[1] * along + values[2] * up)

    def _frame(self, points: _Points, some: NDArray[Any]) -> tuple[Floats, Floats]:
        """Return the directions of the texture's axes at some points."""
        normal = points.normal[:, some]
        along = self.world.tangents[points.triangle[some]].T
        along = unit(along - dot(along, normal) * normal)
        return along, np.cross(normal, along, axis=0)

    def _lit(self, points: _Points, pixel: NDArray[Any], top: int, shape: tuple[int, int]) -> Floats:
        """Return the light from points of pixels whose first row is `top`."""
        order = _order(top + pixel // shape[1], pixel % shape[1])
        first = np.diff(pixel, prepend=-1) > 0
        main, rest = np.flatnonzero(first), np.flatnonzero(~first)
        mirror, smooth = np.zeros_like(points.at), np.zeros((6, len(pixel)), np.float32)
        few, alone = points.take(main), np.zeros(len(pixel), bool)
        mirror[:, main] = self._mirror(few, order[main])

        def around(marks: NDArray[np.bool_]) -> NDArray[np.bool_]:
            grid = np.zeros(shape, bool)
            grid.ravel()[pixel[main]] = marks
            return np.asarray(_widened(grid, 2).ravel()[pixel[main]])

        light = self._light(few, order[main], around)
        guide, values = self._smoothed(few, pixel[main], shape, light, mirror[:, main])
        smooth[:, main] = values[:, pixel[main]]
        alone[main] = guide[6, pixel[main]] == 0.0
        if rest.size:
            smooth[:, rest], weights = self._borrowed(points.take(rest), pixel[rest], shape, guide, values)
            alone[rest] = weights < _ALONE
        own = alone | (_blurred(points.rough) < 1.0)
        some = rest[own[rest]]
        mirror[:, some] = self._mirror(points.take(some), order[some])
        some = np.flatnonzero(alone)
        smooth[:3, some] = self._light(points.take(some), order[some])
        smooth[3:, some] = mirror[:, some]
        for stride in _STRIDES:  # thin faces share it with what continues them in pixels around
            guide[6] = 0.0
            guide[:7, pixel[some]] = [*points.at[:, some], *points.normal[:, some], np.ones(len(some))]
            values[:, pixel[some]] = smooth[:, some]
            shared, weights = self._borrowed(points.take(some), pixel[some], shape, guide, values, stride)
            smooth[:, some] = (smooth[:, some] + weights * shared) / (1.0 + weights)
        blur = _blurred(points.rough)
        mirrored_light = np.where(own, mirror + blur * (smooth[3:] - mirror), smooth[3:])
        return self._shaded(points, smooth[:3], mirrored_light)

    def _borrowed(
        self,
        points: _Points,
        pixel: NDArray[Any],
        shape: tuple[int, int],
        guide: Floats,
        values: Floats,
        stride: int = 1,
    ) -> tuple[Floats, Floats]:
        """Return the average of values of pixels beside points, and the weights of all."""
        row, column = pixel // shape[1], pixel % shape[1]
        total = np.zeros((len(values), len(pixel)), np.float32)
        weights = np.zeros(len(pixel), np.float32)
        near = self._near(points)
        for down, right in _BESIDE:
            beside = np.clip(row + stride * down, 0, shape[0] - 1) * shape[1] + np.clip(
                column + stride * right, 0, shape[1] - 1
            )
            other = guide[:, beside]
            weight = _together([*points.at, *points.normal], other, near) * other[6]
            total += weight * values[:, beside]
            weights += weight
        return total / np.maximum(weights, np.float32(1e-6)), weights

    def _near(self, points: _Points) -> Floats:
        """Return the inverse of the distance that points of one plane may have from it."""
        offset = points.at - self.eye
        return np.asarray(1.0 / (6.0 * self.pixel * np.sqrt(dot(offset, offset))))

    def _light(self, points: _Points, order: NDArray[Any], around: _Spread | None = None) -> Floats:
        """Return the light that arrives at points: the radiance of white paper there, by color."""
        # with a function that spreads a mark to neighbors, points with nothing in the way have one ray
        lost, shaded = self._lost(points, order, range(1))
        bright = (1.0 - points.metal) * points.color.max(axis=0) * points.shown > _FAINT
        few = np.flatnonzero(bright if around is None else around(shaded & bright))
        if few.size and self.rounds > 1:
            rounds = self.rounds * (_ALONE_ROUNDS if around is None else 1)
            lost[:, few] += self._lost(points.take(few), order[few], range(1, rounds))[0]
            lost[:, few] /= np.float32(rounds)
        lamps = self.world.lamp_light(points.at, points.normal).sum(axis=0)
        return np.asarray(np.maximum(lamps + dome_light(points.normal[2]) - lost, 0.0))

    def _lost(self, points: _Points, order: NDArray[Any], turns: range) -> tuple[Floats, NDArray[np.bool_]]:
        """Return the light that points lack, summed over turns, and where they have much less or more."""
        world = self.world
        total = np.zeros_like(points.at)
        shaded = np.zeros(len(order), bool)
        origin = points.at + world.offset * points.normal
        lamps = world.lamp_light(origin, points.normal)
        for turn in turns:
            number = _number(order, turn)
            path = turned(cosine_lobe()[:, number], points.normal)
            triangle = world.first(origin, path)
            # what is in the way takes light from that of an open place, so that open places have no noise
            met = np.flatnonzero(triangle >= 0)
            change = dome(path[2, met]) - world.glow[triangle[met]].T
            total[:, met] += change
            hidden = world.hidden(origin, points.normal, lamps, number)
            total += hidden
            shaded |= hidden > 0.0
            shaded[met] |= np.abs(change[1]) > _MUCH
        return total, shaded

    def _mirror(self, points: _Points, order: NDArray[Any]) -> Floats:
        """Return the light that points mirror."""
        result = np.full_like(points.at, _MATT)
        coat = self.table["coat_weight"][points.material] > 0.0
        seen = np.flatnonzero((points.rough < _DULL) | coat)
        if not seen.size:
            return result
        some = points.take(seen)
        sky = self._sky(some)
        once = self._reflected(some, sky, order[seen])
        # a surface that is neither mirror nor matt shows the noise of few rays most
        blur = _blurred(some.rough)
        these = np.flatnonzero((blur > 0.0) & ((some.metal > 0.5) | (blur < 1.0)) & (some.shown > _FAINT))
        if these.size:
            few, above, number = some.take(these), sky[these], order[seen[these]]
            for turn in range(1, self.rounds):
                once[:, these] += self._reflected(few, above, _number(number, turn))
            once[:, these] /= np.float32(self.rounds)
        result[:, seen] = once
        return result

    def _sky(self, points: _Points) -> Floats:
        """Return the light of the studio that points mirror, shape (n,)."""
        way = _above(mirrored(points.view, points.bumped), points.normal)
        result = environment(points.at, way, points.rough, self.radius)
        brushed = np.flatnonzero(self.brushed[points.material])
        if brushed.size:
            some = points.take(brushed)
            along, _ = self._frame(points, brushed)
            alpha = some.rough * some.rough
            total = np.zeros(len(brushed), np.float32)
            for slope in _SLOPES:
                half = unit(some.bumped + (slope * _ACROSS) * alpha * along)
                way = _above(mirrored(some.view, half), some.normal)
                total += environment(some.at, way, some.rough * np.float32(_ALONG), self.radius)
            result[brushed] = total / len(_SLOPES)
        return result

    def _reflected(self, points: _Points, sky: Floats, order: NDArray[Any]) -> Floats:
        """Return the light from the direction of the mirror, from objects in a random one near it."""
        across, turn = spread(POINTS)[:, order % POINTS].astype(np.float32)
        result = np.broadcast_to(sky, points.at.shape).copy()
        normal, base, rough = points.bumped, points.normal, points.rough
        alpha = rough * rough * _blurred(rough)
        tangent = alpha * np.sqrt(across / np.maximum(1.0 - across, np.float32(0.02)))
        angle = np.float32(2.0 * np.pi) * turn
        local = np.stack([tangent * np.cos(angle), tangent * np.sin(angle), np.ones_like(angle)])
        half = unit(turned(local, normal))
        brushed = np.flatnonzero(self.brushed[points.material])
        if brushed.size:
            along, up = self._frame(points, brushed)
            x, y, _ = local[:, brushed]
            half[:, brushed] = unit(normal[:, brushed] + _ACROSS * x * along + _ALONG**2 * y * up)
        ray = _above(mirrored(points.view, half), base)
        met, distance, light = self._seen(points.at + self.world.offset * base, ray, rough)
        # the floor ends without an edge
        far = np.clip((distance / self.radius - 3.0) / 9.0, 0.0, 1.0)
        result[:, met] += (1.0 - far) * (light - result[:, met])
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
        bright = self._reflected(points, self._sky(points), 0 * number)
        facing = np.minimum(np.abs(dot(points.view, points.bumped)), 1.0)
        fresnel = 0.04 + 0.96 * (1.0 - facing) ** 5
        color = points.color
        share, opacity = self.table["transmission_weight"][number], self.table["opacity"][number]
        # frosted glass scatters, clear glass does not; what has no transmission is a fine weave
        haze = np.where(share > 0.0, np.clip(points.rough / 0.5, 0.0, 1.0), 1.0)
        scatter = np.where(share > 0.0, 1.0 - share * (1.0 - haze * opacity), opacity)
        light = self.world.light_at(points.triangle, points.u, points.v)
        passed = (1.0 - fresnel) * (1.0 - scatter) * np.where(share > 0.0, np.sqrt(color), 1.0)
        shines = np.float32(_GLOW) * self.table["emission"][number].T
        return passed, fresnel * bright + (1.0 - fresnel) * scatter * color * light + shines

    def _smoothed(
        self, points: _Points, pixel: NDArray[Any], shape: tuple[int, int], light: Floats, mirror: Floats
    ) -> tuple[Floats, Floats]:
        """Return the planes of pixels with one point each, and the light of each averaged over its plane."""
        # the rows of a plane are a place, a normal, whether there is one with neighbors, and `_near`
        near = self._near(points)
        known = [*points.at, *points.normal, np.ones_like(near), near, *light, *mirror]
        grid = np.zeros((len(known), shape[0] * shape[1]), np.float32)
        grid[:, pixel] = known
        guide, values = grid[:8].reshape(-1, *shape), grid[8:].reshape(-1, *shape)
        support = np.ones(shape, np.float32)
        for stride in _STRIDES:
            for axis in (1, 2):
                values, weights = _averaged(values, guide, axis, stride)
                support *= weights
        guide[6] *= support > _SUPPORT
        return grid[:8], values.reshape(6, -1)

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
        mirror = mirror * np.clip(1.0 - self.strokes[number] * points.streak, 0.7, 1.3)
        facing = np.clip(-dot(points.view, points.bumped), 0.02, 1.0)
        scale, bias = _fresnel(rough, facing)
        normal_share = 0.04 + (color - 0.04) * metal
        specular = normal_share * scale + bias
        result = (1.0 - metal) * (1.0 - specular) * color * light + specular * mirror
        fibers = np.flatnonzero(self.fuzz[number] > 0.0)
        if fibers.size:
            share = self.fuzz[number[fibers]] * (1.0 - facing[fibers]) ** 3
            result[:, fibers] += share * np.sqrt(color[:, fibers]) * light[:, fibers]
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


def _widened(marks: NDArray[np.bool_], reach: int) -> NDArray[np.bool_]:
    """Return marks with some neighbors at all sides."""
    wide = marks.copy()
    for grid in (wide, wide.T):
        old = grid.copy()
        for step in range(1, reach + 1):
            grid[step:] |= old[:-step]
            grid[:-step] |= old[step:]
    return wide


def _together(a: Sequence[Floats] | Floats, b: Sequence[Floats] | Floats, near: Floats) -> Floats:
    """Return how far points, given with their normals, lie in one plane, 0..1."""
    way = [b[axis] - a[axis] for axis in range(3)]
    facing, apart = dot(a[3:], b[3:]), np.abs(dot(way, a[3:])) + np.abs(dot(way, b[3:]))
    return np.asarray(np.clip(8.0 * facing - 7.0, 0.0, 1.0) * np.clip(1.5 - apart * near * 2.0, 0.0, 1.0))


def _above(way: Floats, base: Floats) -> Floats:
    """Return directions that do not point below a surface."""
    return unit(way - 2.0 * np.minimum(dot(way, base), 0.0) * base)


def _averaged(values: Floats, guide: Floats, axis: int, stride: int) -> tuple[Floats, Floats]:
    """Average values over points of one plane along one axis; return these and the sums of weights."""
    # with wide strides, the average is over similar values only
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
        weight = _together(a, b, a[7] / np.float32(stride))
        weight *= a[6] * b[6] * np.float32(np.exp(-((number / _TAPS) ** 2)))
        first, second = values[one], values[other]
        if stride > 1:
            unlike = np.abs(first[1] - second[1]) / (first[1] + second[1] + np.float32(0.3))
            weight *= np.clip(1.5 - unlike / np.float32(_ALIKE), 0.0, 1.0)
        total[one] += weight * second
        total[other] += weight * first
        weights[one[1:]] += weight
        weights[other[1:]] += weight
    return np.asarray(total / np.maximum(weights, np.float32(1e-6))), weights


def _order(row: NDArray[Any], column: NDArray[Any]) -> NDArray[Any]:
    """Return the number of the first ray of each pixel: four neighbors share 16 successive numbers."""
    i, j = row // 2, column // 2
    run = (i * 2654435761 + j * 2246822519) & 0xFFFFFFFF
    run = ((run ^ (run >> 15)) * 2146121005) & 0xFFFFFFFF
    run = (run ^ (run >> 13)) % (POINTS // 16)
    return np.asarray(16 * run + 2 * (row % 2) + column % 2)


def _number(order: NDArray[Any], turn: int) -> NDArray[Any]:
    """Return the number of another ray: the four lamps take turns within a pixel and among neighbors."""
    lamp = (order + turn) % 4
    return np.asarray((order - order % 4 + 16 * (turn // 4) + 4 * (turn % 4) + lamp) % POINTS)


def _pyramids(material: Material, texels: int) -> tuple[list[Floats], Floats]:
    """Return the maps of a material at full and smaller sizes, and the shorter sides of their texels [m]."""
    # channels: roughness, two slopes, the color and metalness if there are maps; texels become square first
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
    sides = [np.array(tile_of(material)[::-1]) / texels]  # of a texel along the grain and across
    while min(levels[-1].shape[:2]) > 1:
        level, side = levels[-1], sides[-1].copy()
        for axis in (0, 1):
            if side[axis] < 1.5 * sides[-1].min():
                halves = (slice(None),) * axis
                level = (level[(*halves, slice(0, None, 2))] + level[(*halves, slice(1, None, 2))]) * _HALF
                side[axis] *= 2.0
        levels.append(level)
        sides.append(side)
    return levels, np.min(sides, axis=1).astype(np.float32)


_HALF = np.float32(0.5)
_CODES = np.arange(256) / 255.0
_LINEAR = np.where(_CODES <= 0.04045, _CODES / 12.92, ((_CODES + 0.055) / 1.055) ** 2.4).astype(np.float32)


def _texel(level: Floats, uv: Floats) -> Floats:
    """Return the channels of a map at texture coordinates, interpolated, shape (channels, n)."""
    height, width = level.shape[:2]
    x, y = uv[0] * width - 0.5, -uv[1] * height - 0.5
    left, top = np.floor(x), np.floor(y)
    right, down = (x - left)[:, None], (y - top)[:, None]
    i, j = top.astype(np.int64) % height, left.astype(np.int64) % width
    k, m = (i + 1) % height, (j + 1) % width
    upper = level[i, j] * (1.0 - right) + level[i, m] * right
    lower = level[k, j] * (1.0 - right) + level[k, m] * right
    return np.asarray((upper * (1.0 - down) + lower * down).T, np.float32)


_SHOULDER, _WASH = 0.78, 0.15


def _toned(light: Floats) -> Floats:
    """Compress and whiten highlights (PBR Neutral of Khronos)."""
    np.maximum(light, 0.0, out=light)
    bright = np.flatnonzero(light.max(axis=0) >= _SHOULDER)
    some = light[:, bright]
    peak, room = some.max(axis=0), 1.0 - _SHOULDER
    rolled = 1.0 - room * room / (peak + room - _SHOULDER)
    white = 1.0 - 1.0 / (_WASH * (peak - rolled) + 1.0)
    light[:, bright] = some * (rolled / peak) * (1.0 - white) + rolled * white
    return light


def _shown(light: Floats) -> Pixels:
    """Return linear light, shape (3, height, width), as pixels."""
    code = np.where(light <= 0.0031308, 12.92 * light, 1.055 * np.maximum(light, 1e-6) ** (1 / 2.4) - 0.055)
    return np.asarray(np.rint(np.clip(code, 0.0, 1.0) * 255.0).astype(np.uint8).transpose(1, 2, 0))

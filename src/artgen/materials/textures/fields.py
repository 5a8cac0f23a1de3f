"""Fields: numbers on a tile that repeat in both directions, with features in metres.

Every field is the same at every size except for detail: noise is drawn by frequency, so that more texels add
finer waves, and cells keep their places.
"""

from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from itertools import product
from typing import Any, Literal, NamedTuple, TypeVar

import numpy as np
from numpy.typing import NDArray

from artgen._arrays import Array, FrozenArrays

Color = tuple[float, float, float]
Varying = Literal["albedo", "metalness", "normal"]

SEEN: tuple[Varying, ...] = ("albedo", "normal")
"""Maps of surfaces with a pattern of colors and a relief."""

_GREY: Color = (0.5, 0.5, 0.5)


@dataclass(frozen=True, eq=False)
class Pattern(FrozenArrays):
    """One tile of a surface; row 0 is its top (largest v), column 0 its left side (smallest u).

    Attributes:
        albedo: Linear RGB albedo with the recipe's `base_color` as its mean, shape (n, n, 3); None without
            visible variation.
        roughness: Deviation of the GGX roughness from the material's, mean 0, shape (n, n).
        metalness: Share of bare metal, shape (n, n); None if it is uniform.
        height: Relief [m], shape (n, n); None without a visible relief.
    """

    albedo: Array | None
    roughness: Array
    metalness: Array | None = None
    height: Array | None = None


@dataclass(frozen=True)
class Recipe:
    """Recipe of a texture.

    Attributes:
        name: Identifier.
        base_color: Linear RGB mean of the baked albedo; materials of other colors are tinted.
        make: Function `make(stream, size)` for a pattern, from a random stream of the recipe and variant, and
            the number of texels per side.
        tile: Size of one repeat, across and along the grain (u and v) [m].
        variants: Number of different patterns.
        varying: Maps in addition to roughness: `albedo`, `metalness` and `normal`; None determines them by
            baking a small tile.
        shifts: Whether the pattern of a part may begin anywhere across and along the grain; False if it has
            to meet the edges of parts.
        cached: Whether its maps are cached on disk by a digest of this package's code; False for recipes in
            other code.
    """

    name: str
    base_color: Color
    make: Callable[[np.random.Generator, int], Pattern]
    tile: tuple[float, float] = (0.5, 0.5)
    variants: int = 1
    varying: tuple[Varying, ...] | None = None
    shifts: tuple[bool, bool] = (True, True)
    cached: bool = False


RECIPES: dict[str, Recipe] = {}
"""The recipes by name."""

Value = TypeVar("Value", bound=np.generic)

_FIRST = 256  # texels per side of the smallest maps: their waves are drawn first, then those of twice as many
_WHOLE = 1024  # texels per side that show all of a noise: its deviation there is 1
_NEGLIGIBLE = 1e-4  # share of the largest amplitude
_STRIP = 1 << 16  # texels processed at a time


class Cells(NamedTuple):
    """Distances to the nearest of random points on a tile."""

    nearest: Array  # distance to the nearest point [m], shape (n, n)
    second: Array  # distance to the second nearest point [m], shape (n, n)
    number: NDArray[np.int64]  # number of the nearest point, shape (n, n)
    total: int  # number of points


class Tile:
    """A tile of a pattern under construction.

    Attributes:
        size: Texels per side.
        extent: Size across and along the grain, shape (2,) [m].
        u: Position of the texels' centers across the grain, 0 at the left, shape (1, n) [m].
        v: Position of the texels' centers along the grain, 0 at the bottom, shape (n, 1) [m].
        stream: Random numbers that do not depend on the size.
    """

    def __init__(self, stream: np.random.Generator, size: int, extent: tuple[float, float]) -> None:
        self.size = size
        self.extent = extent
        self.stream = stream
        centers = (np.arange(size) + 0.5) / size
        self.u: Array = centers[None, :] * extent[0]
        self.v: Array = centers[::-1, None] * extent[1]

    def noise(self, spectrum: Callable[[Array, Array], Array]) -> Array:
        """Return noise with a spectrum, mean 0 and deviation 1, shape (n, n)."""
        half = max(self.size, _WHOLE) // 2
        wave = np.arange(half)
        amplitude = np.broadcast_to(
            spectrum(wave[None, :] / self.extent[0], wave[:, None] / self.extent[1]), (half, half)
        ).copy()
        amplitude[0, 0] = 0.0
        coefficients = _coefficients(self.stream, self.size, amplitude)
        coefficients /= _deviation(coefficients, amplitude)
        # phases of the waves at the centers of the texels
        phase = np.exp(1j * np.pi * np.fft.fftfreq(self.size))
        columns = coefficients.shape[1]
        coefficients *= phase[:, None] * phase[None, :columns]
        np.fft.ifft(coefficients, axis=0, out=coefficients)
        result = np.fft.irfft(coefficients, n=self.size, axis=1)
        result *= float(self.size) ** 2
        return np.asarray(result)

    def streaks(self, across: float, along: float) -> Array:
        """Return smooth noise with features of a size [m], mean 0 and deviation 1, shape (n, n)."""
        return self.noise(lambda u, v: np.exp(-((0.8 * across * u) ** 2)) * np.exp(-((0.8 * along * v) ** 2)))

    def fibres(self, along: float, slope: float = 0.6) -> Array:
        """Return noise of lines along the grain, of all widths and about a length [m], shape (n, n)."""
        return self.noise(
            lambda u, v: np.maximum(u, 8.0 / self.extent[0]) ** -slope * np.exp(-((0.8 * along * v) ** 2))
        )

    def cloud(self, longest: float, slope: float = 2.0, stretch: float = 1.0) -> Array:
        """Return noise of all scales, mean 0 and deviation 1, shape (n, n)."""
        lowest = 1.0 / longest
        return self.noise(lambda u, v: np.maximum(u**2 + (stretch * v) ** 2, lowest**2) ** (-0.5 * slope))

    def band(self, wavelength: float, spread: float = 0.4, stretch: float = 1.0) -> Array:
        """Return noise of waves of about one length [m], mean 0 and deviation 1, shape (n, n)."""
        return self.noise(
            lambda u, v: np.exp(-(((np.sqrt(u**2 + (stretch * v) ** 2) * wavelength - 1.0) / spread) ** 2))
        )

    def smudges(self, longest: float = 0.12) -> Array:
        """Return soft patches where a surface was touched and wiped, mean 0, about -1..3, shape (n, n)."""
        patches = self.cloud(longest, 2.4)
        wiped = self.cloud(longest / 3.0, 1.6)
        return centered(np.maximum(patches, -0.6) + 0.35 * wiped * smoothstep(-0.5, 1.5, patches))

    def cells(self, spacing: float, jitter: float = 1.0) -> Cells:
        """Place random points about a distance [m] apart, and return the distances to them."""
        across, along = (max(3, round(length / spacing)) for length in self.extent)
        place = 0.5 + jitter * (self.stream.random((2, along, across)) - 0.5)
        u, v = self.u[0] * (across / self.extent[0]), self.v[:, 0] * (along / self.extent[1])
        column, row = u.astype(np.int64), v.astype(np.int64)
        u, v = u - column, v - row
        step_u, step_v = self.extent[0] / across, self.extent[1] / along

        nearest = np.full((self.size, self.size), np.inf)
        second, number = nearest.copy(), np.zeros((self.size, self.size), np.int64)
        height = max(1, _STRIP // self.size)
        for strip in (slice(start, start + height) for start in range(0, self.size, height)):
            for down, right in product((-1, 0, 1), (-1, 0, 1)):
                rows, columns = (row[strip] + down) % along, (column + right) % across
                index = np.ix_(rows, columns)
                distance = ((place[0][index] + (right - u[None, :])) * step_u) ** 2
                distance += ((place[1][index] + (down - v[strip, None])) * step_v) ** 2
                closer = distance < nearest[strip]
                np.minimum(second[strip], np.maximum(distance, nearest[strip]), out=second[strip])
                np.minimum(nearest[strip], distance, out=nearest[strip])
                np.copyto(number[strip], rows[:, None] * across + columns[None, :], where=closer)
        return Cells(np.sqrt(nearest), np.sqrt(second), number, along * across)

    def moved(self, values: Array, across: Array | float, along: Array | float) -> Array:
        """Return the value of a field at an offset to the right and up [m] from each texel, shape (n, n)."""
        numbers = np.arange(self.size)
        field = (self.size, self.size)

        def there(number: NDArray[np.int64], across: Array, along: Array) -> Array:
            column = numbers[None, :] + across * (self.size / self.extent[0])
            row = number[:, None] - along * (self.size / self.extent[1])
            left, top = np.floor(column), np.floor(row)
            right_share, low_share = column - left, row - top
            left, top = left.astype(np.int64) % self.size, top.astype(np.int64) % self.size
            right, low = (left + 1) % self.size, (top + 1) % self.size
            upper = values[top, left] * (1.0 - right_share) + values[top, right] * right_share
            lower = values[low, left] * (1.0 - right_share) + values[low, right] * right_share
            return np.asarray(upper * (1.0 - low_share) + lower * low_share)

        return in_strips(there, numbers, np.broadcast_to(across, field), np.broadcast_to(along, field))


def recipe(
    name: str,
    extent: tuple[float, float],
    base_color: Color = _GREY,
    *,
    variants: int = 1,
    varying: tuple[Varying, ...] = ("normal",),
    shifts: tuple[bool, bool] = (True, True),
) -> Callable[[Callable[[Tile], Pattern]], None]:
    """Register a function that draws a tile of a size [m] as a recipe with cached maps.

    The albedo that it draws is scaled to the mean `base_color`, and the roughness is centered.
    """

    def register(draw: Callable[[Tile], Pattern]) -> None:
        def make(stream: np.random.Generator, size: int) -> Pattern:
            drawn = draw(Tile(stream, size, extent))
            albedo = None if drawn.albedo is None else with_mean(drawn.albedo, base_color)
            return replace(drawn, albedo=albedo, roughness=centered(drawn.roughness))

        RECIPES[name] = Recipe(name, base_color, make, extent, variants, varying, shifts, cached=True)

    return register


def _coefficients(stream: np.random.Generator, size: int, amplitude: Array) -> NDArray[np.complex128]:
    """Return the amplitudes of the waves of maps of a size, as `numpy.fft.irfft2` expects them."""
    blocks: list[tuple[int, np.random.Generator]] = []
    halves = [_FIRST // 2 * 2**number for number in range((size // _FIRST).bit_length())]
    for half, child in zip(halves, stream.spawn(4), strict=False):
        inner = half // 2 if blocks else 0
        outer = max(amplitude[inner:half, :half].max(), amplitude[:inner, inner:half].max(initial=0.0))
        if inner and outer < _NEGLIGIBLE * amplitude.max():
            break
        blocks.append((half, child))
    half = blocks[-1][0]
    result = np.zeros((size, half), np.complex128)
    for block, child in reversed(blocks):
        drawn = child.standard_normal((2 * block - 1, block, 2)).view(np.complex128)[..., 0]
        result[:block, :block] = drawn[block - 1 :]
        result[-(block - 1) :, :block] = drawn[: block - 1]
    result[:half, :] *= amplitude[:half, :half]
    result[-(half - 1) :, :] *= amplitude[half - 1 : 0 : -1, :half]
    # waves along the grain appear twice in that column, once for each direction
    result[1:, 0] = (result[1:, 0] + result[:0:-1, 0].conj()) * np.sqrt(0.5)
    result *= np.sqrt(0.5)
    return result


def _deviation(coefficients: NDArray[np.complex128], amplitude: Array) -> float:
    """Return the deviation of noise at all sizes: exact for coarse waves, average for finer ones."""
    half = _FIRST // 2
    coarse = np.concatenate([coefficients[:half, :half], coefficients[-(half - 1) :, :half]])
    power = np.abs(coarse) ** 2
    counted = 2.0 * power.sum() - power[:, 0].sum()
    squared = amplitude[: _WHOLE // 2, : _WHOLE // 2] ** 2
    fine = 4.0 * (squared.sum() - squared[:half, :half].sum())
    return float(np.sqrt(counted + fine))


def centered(values: Array) -> Array:
    """Return values minus their mean."""
    return np.asarray(values - values.mean())


def in_strips(make: Callable[..., NDArray[Value]], *fields: NDArray[Any]) -> NDArray[Value]:
    """Apply a function to fields texel by texel, in strips of rows.

    Large maps span many pages of memory, whose allocation costs more than the computation.
    """
    rows = max(1, _STRIP // max(1, *(field[0].size for field in fields)))
    first = make(*(field[:rows] for field in fields))
    result = np.empty((len(fields[0]), *first.shape[1:]), first.dtype)
    result[:rows] = first
    for start in range(rows, len(result), rows):
        result[start : start + rows] = make(*(field[start : start + rows] for field in fields))
    return result


def smoothstep(low: float, high: float, values: Array) -> Array:
    """Return 0 below low, 1 above high, and a smooth transition between; it falls for low above high."""

    def risen(values: Array) -> Array:
        share = np.clip((values - low) / (high - low), 0.0, 1.0)
        return np.asarray(share * share * (3.0 - 2.0 * share))

    return in_strips(risen, values)


def blend(values: Array, stops: Sequence[tuple[float, tuple[float, float, float]]]) -> Array:
    """Return colors for values in 0..1, between stops of value and linear RGB, shape (n, n, 3)."""
    places = [place for place, _ in stops]
    steps = np.linspace(0.0, 1.0, 2049)
    table = np.stack([np.interp(steps, places, [color[c] for _, color in stops]) for c in range(3)], axis=-1)
    return in_strips(
        lambda values: table[np.rint(np.clip(values, 0.0, 1.0) * 2048.0).astype(np.int64)], values
    )


def with_mean(albedo: Array, mean: tuple[float, float, float]) -> Array:
    """Return linear albedo with a color as its mean, shape (n, n, 3)."""
    return np.asarray(albedo * (np.array(mean) / albedo.mean(axis=(0, 1))))

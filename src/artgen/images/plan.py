"""What a set of images is to hold: assets, how many pictures of each, and what varies in them."""

import math
from collections.abc import Mapping
from dataclasses import dataclass
from numbers import Real
from typing import Any, ClassVar, Literal, get_args

from artgen.dataset.plan import Draws
from artgen.errors import ParameterError, nearest
from artgen.images.labels import Vocabulary
from artgen.images.split import PARTS
from artgen.materials.textures import check_size
from artgen.view.rendering import checked_size

PictureFormat = Literal["png", "jpg"]
Range = tuple[float, float]

RANDOM = ("backdrop", "floor", "light")
"""What can be drawn anew for each picture."""


@dataclass(frozen=True)
class ImagePlan(Draws):
    """What a set of images holds and how it is made; two runs with equal plans write the same numbers.

    The pictures' bytes are the same on one machine; another graphics driver may colour edges otherwise.

    Attributes:
        images: How many pictures are taken of each asset.
        size: Width and height of a picture [pixels].
        labels: Which labels have masks: NAME, NEW=OLD+OLD for several as one, each with CATEGORY: before it
            for one category only; all of them if there are none.
        random: What is drawn anew for each picture, of `RANDOM`; the rest is plain.
        depth: Whether depths are written.
        normals: Whether normals are written.
        field_of_view: Between which angles it is drawn [rad].
        elevation: Between which angles above the horizon cameras stand, evenly on the sphere [rad].
        azimuth: How far to each side of the front they stand; pi is all around [rad].
        margin: Between which shares the picture's edges stay free; the distance follows from it.
        samples: How finely shadows and edges are drawn.
        texture_size: Texels on a side of the materials' maps; 0 for plain colours.
        picture: What pictures are written as.
        split: Shares of the assets that are for training, validation and test; together 1.
    """

    FORMAT: ClassVar[str] = "artgen-images-1"

    images: int = 12
    size: int = 1024
    labels: tuple[str, ...] = ()
    random: tuple[str, ...] = ()
    depth: bool = False
    normals: bool = False
    field_of_view: Range = (math.radians(26.0), math.radians(57.0))
    elevation: Range = (math.radians(6.0), math.radians(75.0))
    azimuth: float = math.pi
    margin: Range = (0.03, 0.45)
    samples: int = 4
    texture_size: int = 512
    picture: PictureFormat = "png"
    split: tuple[float, ...] = (0.8, 0.1, 0.1)

    def __post_init__(self) -> None:
        """Refuse what no run could do, before anything is written.

        Raises:
            ParameterError: A category, label, number or override is unknown or not allowed.
        """
        _check_whole("images", self.images, 1, 100_000)
        checked_size(self.size)
        _check_whole("samples", self.samples, 1, 1024)
        for name in self.random:
            if name not in RANDOM:
                raise ParameterError(f"there is no {name!r} to draw anew.{nearest(str(name), RANDOM)}")
        _check_range("field_of_view", self.field_of_view, 0.1, 2.0)
        _check_range("elevation", self.elevation, 0.0, math.pi / 2)
        _check_range("azimuth", (0.0, self.azimuth), 0.0, math.pi)
        _check_range("margin", self.margin, 0.0, 0.9)
        if self.texture_size != 0:
            check_size(self.texture_size)
        if self.picture not in get_args(PictureFormat):
            raise ParameterError(f"pictures are written as png or jpg, not {self.picture!r}")
        _check_split(self.split)
        super().__post_init__()
        self.vocabulary()

    def vocabulary(self) -> Vocabulary:
        """Return which labels have masks.

        Raises:
            ParameterError: One is unknown, or named twice.
        """
        return Vocabulary.of(self.categories, self.labels)

    def to_data(self) -> dict[str, Any]:
        """Return the plan as JSON data."""
        return super().to_data() | {"random": sorted(self.random)}

    @classmethod
    def from_data(cls, data: Mapping[str, Any]) -> "ImagePlan":
        """Return the plan of JSON data.

        Raises:
            ParameterError: They are not those of a plan.
        """
        return super().from_data(data)


def _check_whole(name: str, value: Any, least: int, most: int) -> None:
    if isinstance(value, bool) or not isinstance(value, int) or not least <= value <= most:
        raise ParameterError(f"{name} {value!r} must be a whole number in {least}..{most}")


def _check_range(name: str, value: Any, least: float, most: float) -> None:
    fine = isinstance(value, tuple) and len(value) == 2 and all(isinstance(each, Real) for each in value)
    if not fine or not least <= value[0] <= value[1] <= most:
        shown = value[1] if name == "azimuth" and fine else value
        raise ParameterError(f"{name} {shown!r} must lie in {least:g}..{most:g}, the lower number first")


def _check_split(shares: Any) -> None:
    fine = isinstance(shares, tuple) and len(shares) == len(PARTS)
    if not fine or any(share < 0.0 for share in shares) or abs(sum(shares) - 1.0) > 1e-9:
        raise ParameterError(
            f"the split {shares!r} must be the shares of {', '.join(PARTS)}, together 1, such as 0.8,0.1,0.1"
        )

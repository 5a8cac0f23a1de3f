"""The plan of a set of images."""

import math
import os
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from importlib.util import find_spec
from numbers import Real
from typing import Any, ClassVar, Literal, Self, get_args

from artgen.dataset.places import Place
from artgen.dataset.plan import BasePlan, Item, check_whole
from artgen.errors import ParameterError, RenderError, nearest
from artgen.images.pictures import PARTS, pictures_of, write_coco
from artgen.materials.textures import check_size
from artgen.view import gl
from artgen.view.picture import checked_size

PictureFormat = Literal["png", "jpg"]
Range = tuple[float, float]

RANDOM = ("backdrop", "floor", "light")  # parts of a picture that can vary


@dataclass(frozen=True)
class ImagePlan(BasePlan):
    """The content of a set of images; two runs with equal plans write the same numbers.

    The bytes of the pictures are equal on one machine; other graphics drivers may color edges differently.

    Attributes:
        images: Number of pictures of each asset.
        size: Width and height of a picture [pixels].
        labels: Labels with masks: NAME, or NEW=OLD+OLD to join several, with a prefix CATEGORY: for one
            category only; all labels by default.
        random: Parts of each picture that vary, a subset of `RANDOM`; the others are plain.
        depth: Whether to write depths.
        normals: Whether to write normals.
        field_of_view: Range of the field of view [rad].
        elevation: Range of the camera's angle above the horizon, uniform on the sphere [rad].
        azimuth: Largest angle of the camera to each side of the front; pi is all around [rad].
        margin: Range of the free margin of a picture, relative to its size; it determines the distance.
        samples: Number of samples of shadows and edges.
        texture_size: Texels per side of texture maps; 0 for plain colors.
        picture: File format of pictures.
        split: Shares of the assets for training, validation and test; their sum is 1.
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
        """Check the plan before anything is written.

        Raises:
            ParameterError: A category, label, number or override is unknown or not allowed.
        """
        check_whole("images", self.images, 1, 100_000)
        checked_size(self.size)
        check_whole("samples", self.samples, 1, 1024)
        for name in self.random:
            if name not in RANDOM:
                raise ParameterError(f"no part of a picture is called {name!r}.{nearest(str(name), RANDOM)}")
        _check_range("field_of_view", self.field_of_view, 0.1, 2.0)
        _check_range("elevation", self.elevation, 0.0, math.pi / 2)
        _check_range("azimuth", (0.0, self.azimuth), 0.0, math.pi)
        _check_range("margin", self.margin, 0.0, 0.9)
        check_size(self.texture_size, plain=True)
        if self.picture not in get_args(PictureFormat):
            raise ParameterError(f"pictures are written as png or jpg, not {self.picture!r}")
        shares: Any = self.split
        fine = isinstance(shares, tuple) and len(shares) == len(PARTS)
        if not fine or any(share < 0.0 for share in shares) or abs(sum(shares) - 1.0) > 1e-9:
            raise ParameterError(
                f"the split {shares!r} must be the shares of {', '.join(PARTS)} with the sum 1, such as "
                "0.8,0.1,0.1"
            )
        super().__post_init__()
        self.mask_names()

    def mask_names(self) -> dict[str, dict[str, str]]:
        """Return the name of the mask of each label, by category and label."""
        known = {name: self.category(name).labels for name in self.categories}
        if not self.labels:
            return {name: {label: label for label in labels} for name, labels in known.items()}
        found: dict[str, dict[str, str]] = {name: {} for name in known}
        for text in self.labels:
            owner, colon, rest = text.partition(":")
            if colon and owner.strip() not in known:
                raise ParameterError(
                    f"the label {text!r} is for {owner!r}, which is not in the plan; its categories are "
                    f"{', '.join(known)}"
                )
            owners = [owner.strip()] if colon else list(known)
            new, equals, old = (rest if colon else text).partition("=")
            for label in map(str.strip, (old if equals else new).split("+")):
                having = [owner for owner in owners if label in known[owner]]
                if not having or not new.strip():
                    allowed = [each for owner in owners for each in known[owner]]
                    where = ", ".join(owners)
                    raise ParameterError(f"{where}: there is no label {label!r}.{nearest(label, allowed)}")
                for owner in having:
                    if label in found[owner]:
                        raise ParameterError(
                            f"the label {label!r} of {owner} is named twice; leave one of them out"
                        )
                    found[owner][label] = new.strip()
        return found

    def coco_categories(self) -> list[dict[str, Any]]:
        """Return the categories of COCO: one for each mask of each category, numbered from 1."""
        parts = [
            (owner, name)
            for owner, names in self.mask_names().items()
            for name in dict.fromkeys(names.values())
        ]
        return [
            {"id": number, "name": name, "supercategory": owner}
            for number, (owner, name) in enumerate(parts, start=1)
        ]

    @property
    def time_limit(self) -> float:
        """Default time limit for one asset: ten minutes, and one more per picture [s]."""
        return super().time_limit + 60.0 * self.images

    def prepared(self, place: Place) -> Self:
        """Return the plan after a check of OpenGL and the packages."""
        gl.available()
        needed = {"mujoco": "draws pictures", "pycocotools": "encodes masks"}
        if self.normals:
            needed["embreex"] = "finds normals"
        for name, purpose in needed.items():
            if find_spec(name) is None:
                raise RenderError(f'{name}, which {purpose}, is not installed: pip install "artgen[images]"')
        gl.claim_process()
        gl.context(16, 16).free()
        os.environ.setdefault("LP_NUM_THREADS", "0")  # otherwise Mesa uses all cores in every process
        return super().prepared(place)

    def files(self, item: Item) -> dict[str, bytes]:
        """Return the pictures of an asset, their annotations, and its `asset.json`."""
        return pictures_of(item, self)

    def finish(self, place: Place, records: Sequence[Mapping[str, Any]]) -> None:
        """Write the files of COCO."""
        write_coco(place, records, self)

    def to_data(self) -> dict[str, Any]:
        """Return the plan as JSON data."""
        return super().to_data() | {"random": sorted(self.random)}


def _check_range(name: str, value: Any, least: float, most: float) -> None:
    fine = isinstance(value, tuple) and len(value) == 2 and all(isinstance(each, Real) for each in value)
    if not fine or not least <= value[0] <= value[1] <= most:
        one = fine and name == "azimuth"  # its lower end is fixed
        shown, limits = value[1] if one else value, f"{least:g}..{most:g}"
        if fine and name != "margin":
            given = ", ".join(f"{math.degrees(each):.4g}" for each in (value[1:] if one else value))
            limits += f" rad ({given} of {math.degrees(least):.4g} to {math.degrees(most):.4g} degrees)"
        raise ParameterError(f"{name} {shown!r} must be within {limits}, the lower number first")

"""Pictures for training: random cameras, lights and poses, with masks of the parts in the format of COCO."""

from artgen.images.plan import ImagePlan
from artgen.images.run import make_images

__all__ = ["ImagePlan", "make_images"]

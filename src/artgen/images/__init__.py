"""Pictures for training: random cameras, lights and poses, with masks of the parts in COCO format."""

from artgen.images.plan import ImagePlan

__all__ = ["ImagePlan"]

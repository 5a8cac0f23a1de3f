"""The stream that PyTorch's DataLoader knows how to iterate; imported only where torch is."""

from torch.utils.data import IterableDataset

from artgen.asset import Asset
from artgen.dataset.streams import Stream


class TorchStream(Stream, IterableDataset[Asset]):  # type: ignore[misc]
    """Assets without end; see `artgen.stream`."""

"""What several tests share: independent checks of geometry, and readers that are not artgen's."""

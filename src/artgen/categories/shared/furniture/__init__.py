"""Parts of furniture and doors: carcasses, fronts, slabs, shelves."""

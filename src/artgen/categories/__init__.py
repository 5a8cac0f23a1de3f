"""The categories: the package of each defines it, and importing the package enters it in the catalog."""

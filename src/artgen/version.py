"""The version of the package, also recorded in every exported asset."""

__version__ = "0.1.0"

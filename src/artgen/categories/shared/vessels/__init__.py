"""Turned and blown bodies that hold something."""

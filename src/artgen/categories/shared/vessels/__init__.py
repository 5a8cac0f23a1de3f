"""Turned and blown containers."""

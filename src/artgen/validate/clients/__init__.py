"""Clients: simulators, validators and converters that people read assets with, each in its own process."""

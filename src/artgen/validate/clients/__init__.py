"""Clients: simulators, validators and converters for assets, each in its own process."""

"""Clients: the simulators, validators and converters that people read assets with, each in a process of its own."""

"""Checks of exported assets: solids, tree, colliders, files, formats, hands, behavior, simulators."""

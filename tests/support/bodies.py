"""Assets of bodies that no category makes."""

from artgen import Body, Graph
from artgen.asset import Asset
from artgen.graph import Cache


def asset_of(body: Body) -> Asset:
    return Asset.from_tree(Graph(body).evaluate({}, Cache()).value, "sample", "sample")

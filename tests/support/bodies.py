"""Assets of bodies that no category makes."""

from artgen import Body, Cache, Graph
from artgen.asset import Asset


def asset_of(body: Body) -> Asset:
    return Asset.from_tree(Graph(body).evaluate({}, Cache()).value, "sample", "sample")

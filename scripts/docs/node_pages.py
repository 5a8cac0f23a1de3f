"""The pages of the nodes: docstring, example and picture of each."""

from collections.abc import Iterator, Mapping
from dataclasses import dataclass

from node_examples import Example, examples

FOLDER = "nodes"


@dataclass(frozen=True)
class NodePage:
    """The content of a page.

    Attributes:
        name: Name of its file.
        title: Its heading.
        intro: Purpose of its nodes.
        modules: Modules below `artgen.nodes`; all their nodes are shown.
        handles: Handles that are shown with their methods.
    """

    name: str
    title: str
    intro: str
    modules: tuple[str, ...]
    handles: tuple[str, ...] = ()

    def shows(self, example: Example) -> bool:
        """Tell whether a node is on this page."""
        first = example.name.split(".")[0]
        if first in HANDLES:
            return first in self.handles
        return example.home.removeprefix("artgen.nodes.") in self.modules


PAGES = (
    NodePage(
        "numbers",
        "Numbers and conditions",
        "`Float` and `Bool` stand for numbers that are not known yet. Operators work on them; these "
        "functions do what Python's own `min`, `math.sin` or `if` cannot.",
        ("scalar",),
        ("Float", "Bool"),
    ),
    NodePage(
        "vectors",
        "Vectors and points",
        "A `Vector` is a point or a direction; a tuple of three numbers is taken for one everywhere. "
        "`Points` are where `array` and `repeat` put copies. `X`, `Y` and `Z` are the axes: right, "
        "back and up.",
        ("vector",),
        ("Vector", "Points"),
    ),
    NodePage(
        "profiles",
        "Profiles",
        "A `Profile` is a region of the plane, x to the right and y up. `extrude`, `revolve`, `sweep`"
        " and `loft` make solids of it. `a | b`, `a - b` and `a & b` combine profiles.",
        ("profile", "text"),
        ("Profile",),
    ),
    NodePage(
        "paths",
        "Paths",
        "A `Path` is a line in space for `sweep`. The pictures show thin rods.",
        ("path",),
        ("Path",),
    ),
    NodePage(
        "regions",
        "Regions",
        "A `Region` is a box of planned space. It is divided, shrunk and moved before any solid exists; "
        "parts take their sizes and places from it.",
        (),
        ("Region",),
    ),
    NodePage(
        "primitives",
        "Primitive solids",
        "Solids of one call. Each is its own collider, or a few convex pieces that contain it. Unless"
        " it says otherwise, a solid is centered on the origin.",
        ("primitive",),
    ),
    NodePage(
        "swept",
        "Solids from profiles",
        "Solids that a profile makes when it is drawn out, turned or moved along a path.",
        ("extrude", "sweep", "loft"),
    ),
    NodePage(
        "solids",
        "Combining, placing and measuring solids",
        "`a | b` unites, `a - b` cuts away, `a & b` keeps what both have. Methods place and measure; "
        "what they return is known at evaluation, like every socket.",
        ("csg",),
        ("Solid",),
    ),
    NodePage(
        "bodies",
        "Bodies",
        "A `Body` is a link with everything that is joined to it. Only `part` makes links; `attach` "
        "and `repeat` join them, `weld` adds more to the same link. A red arrow shows where a hand "
        "acts.",
        ("body", "grasp_frames"),
        ("Body",),
    ),
    NodePage(
        "joints",
        "Joints, couplings and dependencies",
        "Axis and pivot are in asset coordinates at rest. Each picture shows the joint closed and open.",
        ("joint",),
        ("Joint", "Coupling", "Condition", "Dependency"),
    ),
    NodePage(
        "print",
        "Print, icons and displays",
        "Details that are only seen. Most are profiles; `details.printed`, `details.raised` and "
        "`details.engraved` put them on a face.",
        tuple(f"details.{name}" for name in ("dials", "displays", "icons", "lettering", "plates", "relief")),
    ),
    NodePage(
        "hardware",
        "Screws, seals, vents and racks",
        "Small hardware. Screws are only seen; racks and gaskets are solids like any other.",
        ("details.racks", "details.screws", "details.seals", "details.vents"),
    ),
    NodePage(
        "fittings",
        "Fittings",
        "Bought parts after `from artgen import fittings`: `panel.install(fittings.dial(), at=place)` cuts "
        "the hole, welds what is fixed and joins what moves. Each picture shows the joints closed and open. "
        "[Sizes and forces](../fittings.md) are in a table.",
        (),
        ("fittings",),
    ),
)

HANDLES = {handle for page in PAGES for handle in page.handles}


def placed() -> dict[str, list[Example]]:
    """Return the nodes of each page by its name.

    Raises:
        LookupError: A node is on no page.
    """
    found: dict[str, list[Example]] = {page.name: [] for page in PAGES}
    for example in examples().values():
        home = next((page for page in PAGES if page.shows(example)), None)
        if home is None:
            raise LookupError(
                f"{example.home} defines {example.name}, and no page of PAGES shows that module"
            )
        found[home.name].append(example)
    return found


def picture_of(example: Example) -> str:
    """Return the path of a node's picture below the documentation."""
    return f"{FOLDER}/pictures/{example.name}.webp"


def written(page: NodePage, shown: list[Example]) -> str:
    """Return the page, in Markdown."""
    return "\n".join(_lines(page, shown))


def _lines(page: NodePage, shown: list[Example]) -> Iterator[str]:
    yield from (f"# {page.title}", "", page.intro, "")
    for example in shown:
        yield from (f"::: {example.address}", "    options:", f"      heading: {example.name}")
        yield from (f"      toc_label: {example.name}", "      members: false")
        picture = picture_of(example).removeprefix(f"{FOLDER}/")
        yield from ("", f"![What the example of {example.name} gives]({picture}){{ .node loading=lazy }}", "")


def index(placed: Mapping[str, list[Example]]) -> str:
    """Return the page of all nodes: a line for each."""
    lines = [
        "# All nodes",
        "",
        (
            "Everything that a category is made of. Each entry has an example that runs as it stands "
            "after `from artgen import *`, and a picture of what it gives."
        ),
        "",
    ]
    for page in PAGES:
        names = ", ".join(f"[`{each.name}`]({page.name}.md#{each.address})" for each in placed[page.name])
        lines += [f"- [{page.title}]({page.name}.md): {names}"]
    return "\n".join(lines) + "\n"

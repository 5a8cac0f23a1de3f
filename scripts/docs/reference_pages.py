"""The pages of the API reference: public classes and functions other than nodes."""

from collections.abc import Mapping

FOLDER = "reference"

PAGES: Mapping[str, tuple[str, tuple[str, ...]]] = {
    "generation": (
        "Categories and generation",
        (
            "generate",
            "catalog.find",
            "catalog.categories",
            "category",
            "generator.declare.generator",
            "one_of",
            "shades",
            "Generator",
        ),
    ),
    "distributions": (
        "Distributions",
        (
            "uniform",
            "truncated_normal",
            "loguniform",
            "choice",
            "count",
            "by",
            "fixed",
            "given",
            "sampling.Distribution",
        ),
    ),
    "assets": ("Assets", ("Asset", "load", "asset.Link", "asset.AssetJoint", "asset.affordance.Affordance")),
    "proof": (
        "Certificate and checks",
        (
            "asset.certificate.Certificate",
            "asset.certificate.PairResult",
            "asset.certificate.Witness",
            "prove_range",
            "proof.recheck.recheck",
            "asset.report.Report",
            "testing.check_category",
        ),
    ),
    "joints": ("Springs, feel and fittings", ("Spring", "nodes.joint.Feel", "feel", "nodes.fitting.Fitting")),
    "materials": (
        "Materials",
        ("Material", "materials.material.material", "colored", "MATERIALS", "materials.COLORS"),
    ),
    "graphs": ("Graphs", ("Graph", "graph.Cache", "graph.Evaluation")),
    "datasets": ("Datasets", ("Dataset", "stream", "dataset.generate_many", "dataset.Plan")),
    "images": ("Images for training", ("images.ImagePlan",)),
    "tasks": (
        "Manipulation tasks",
        (
            "envs.ManipulationEnv",
            "envs.Task",
            "envs.one_joint",
            "envs.by_lever",
            "envs.Target",
            "envs.Stage",
            "demos.make_demos",
            "demos.record",
        ),
    ),
    "views": (
        "Pictures",
        (
            "view.render",
            "view.opened",
            "view.Picture",
            "view.View",
            "view.Camera",
            "view.page_of",
            "view.Page",
        ),
    ),
    "types": (
        "Types of arguments",
        ("Scalar", "VectorLike", "Span", "Frame", "X", "Y", "Z", "details.ICONS", "details.BRANDS"),
    ),
    "errors": (
        "Errors",
        (
            "ArtgenError",
            "ParameterError",
            "BuildError",
            "errors.GraphError",
            "errors.EvaluationError",
            "InfeasibleError",
            "errors.AssetError",
            "errors.CheckError",
            "errors.ExportError",
            "errors.ClientError",
            "errors.RenderError",
            "errors.EnvError",
        ),
    ),
}
"""Title and names after `artgen.` of each page, by its file's name."""


def written(name: str) -> str:
    """Return a page, in Markdown."""
    title, names = PAGES[name]
    return "\n\n".join([f"# {title}", *(f"::: artgen.{each}" for each in names)]) + "\n"

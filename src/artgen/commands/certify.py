"""`artgen certify`: the range proof of a category."""

import json
from pathlib import Path
from typing import Annotated

import typer

from artgen.commands.progress import progress_bar
from artgen.errors import ExportError
from artgen.generator.overrides import parse_overrides
from artgen.range_proof import prove_range

_FAULT = 1  # exit code


def certify(
    category: Annotated[
        str, typer.Argument(help="Name of a category, which `artgen list` shows, or a file that defines one.")
    ],
    *,
    samples: Annotated[int, typer.Option(metavar="NUMBER", help="How many seeds are drawn.")] = 500,
    corners: Annotated[
        bool, typer.Option(help="Certify the corners of the parameter ranges too, at most about 256.")
    ] = True,
    overrides: Annotated[
        list[str] | None,
        typer.Option(
            "--set",
            metavar="NAME=VALUE",
            help="A value or distribution for a parameter: 'width=uniform(0.6, 1.2)'. May be given several "
            "times.",
        ),
    ] = None,
    seed: Annotated[int, typer.Option(help="The first seed.")] = 0,
    tolerance: Annotated[
        float, typer.Option(metavar="METRES", help="Clearance between links that has to be proven.")
    ] = 0.0,
    json_file: Annotated[
        Path | None,
        typer.Option("--json", metavar="FILE", help="Write all that was found to a file as well."),
    ] = None,
) -> None:
    """Prove samples and corners of a category free of collisions; exit code 1 if a proof fails."""
    if json_file is not None and (json_file.is_dir() or not json_file.absolute().parent.is_dir()):
        raise ExportError(f"cannot write {json_file}: give a file in a directory that exists")
    with progress_bar() as bar:
        task = bar.add_task(category, total=None)
        proof = prove_range(
            category,
            samples,
            corners=corners,
            seed=seed,
            overrides=parse_overrides(overrides or ()),
            tolerance=tolerance,
            progress=lambda done, total: bar.update(task, completed=done, total=total),
        )
    typer.echo(proof)
    if json_file is not None:
        text = json.dumps(proof.to_data(), indent=1, ensure_ascii=False, allow_nan=False) + "\n"
        try:
            json_file.write_text(text, encoding="utf-8")
        except OSError as error:
            raise ExportError(f"cannot write {json_file}: {error.strerror}") from error
    if not proof.sound:
        raise typer.Exit(_FAULT)

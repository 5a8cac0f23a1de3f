"""`artgen demos`: demonstrations of a task by the scripted policy."""

from pathlib import Path
from typing import Annotated

import typer

from artgen.commands.progress import rate_bar
from artgen.dataset.places import GO_ON

_INTERRUPTED = 130  # exit code
_SHOWN = 20  # most listed seeds that failed


def demos(
    task: Annotated[
        str, typer.Argument(metavar="TASK", help="Name of a task, such as OpenDrawer; a wrong one lists all.")
    ],
    *,
    out: Annotated[
        Path, typer.Option(metavar="DIRECTORY", help="Where to; demo.hdf5 in it is complete or absent.")
    ],
    count: Annotated[
        int, typer.Option("--count", "-n", min=1, help="How many, each with another asset.")
    ] = 100,
    seed: Annotated[int, typer.Option(help="Of the first asset; the same seed, the same bytes.")] = 0,
    image: Annotated[
        int, typer.Option(metavar="PIXELS", help="Add pictures of that size to the observations; 0 for none.")
    ] = 0,
    noise: Annotated[
        float,
        typer.Option(
            metavar="SPREAD",
            help="Disturb the motion of the arm at random, so that demonstrations show how to get back to "
            "the way; the actions that are written are the wanted ones.",
        ),
    ] = 0.0,
    jobs: Annotated[
        int | None, typer.Option(min=1, help="How many processes work; all cores by default.")
    ] = None,
) -> None:
    """Write successful demonstrations of a task in robomimic's HDF5 layout; needs artgen[demos].

    A repeated command continues an interrupted run.
    """
    from artgen.demos import make_demos

    try:
        with rate_bar() as bar:
            row, missed = bar.add_task(task, total=count, failed=""), 0

            def step(succeeded: bool) -> None:  # noqa: FBT001 - it is called so
                nonlocal missed
                missed += not succeeded
                bar.update(row, advance=int(succeeded), failed=f"{missed} failed" if missed else "")

            done = make_demos(task, count, out, seed=seed, image=image, noise=noise, jobs=jobs, progress=step)
    except KeyboardInterrupt:
        typer.echo(f"interrupted; {GO_ON}", err=True)
        raise typer.Exit(_INTERRUPTED) from None
    for failed, reason in list(done.failed.items())[:_SHOWN]:
        typer.echo(f"seed {failed}: {reason}", err=True)
    if len(done.failed) > _SHOWN:
        typer.echo(f"and {len(done.failed) - _SHOWN} more", err=True)
    tried = done.demos + len(done.failed)
    typer.echo(
        f"wrote {done.demos} demonstrations, {done.steps} steps, of {tried} attempts in {done.seconds:.0f} s"
        f": {done.file}"
    )

"""What training asks for: steps by collider budget, assets by level of detail, and pictures."""

import statistics
import tempfile
from collections.abc import Callable, Iterator, Mapping, Sequence
from contextlib import ExitStack, contextmanager
from functools import partial
from pathlib import Path

import numpy as np
from peer import WARP, Peer, directory, peer
from report import Cell, Section, Table, shown, span
from surveys.speed import STEP, speed
from timing import alternating, seconds

import artgen
from artgen.asset import Asset
from artgen.errors import ClientError, RenderError
from artgen.proof.fewer import fewer_colliders
from artgen.validate.clients.install import python_of
from artgen.view import gl

BUDGETS = (48, 16, 8)
DETAILS = ("full", "medium", "low")

_EXACT = "exact"
_SIDE = 256  # of pictures [pixels]
_COMPARED = f"""
Assets of seed 0. The first table steps each with its own colliders (*exact*) and with budgets for the whole
asset (`with_colliders`), in MuJoCo and in MuJoCo Warp on the processor, from rest, at {1e3 * STEP:g} ms.
Steps are those of single worlds, and ratios are to the exact colliders in the same run. A budget that cannot
be reached is measured with the fewest colliders that were found: with fewer, pieces would touch another link,
stand in the way of a hand or close an opening. Columns of MuJoCo Warp are empty where it was not installed;
its kernels take minutes to compile for each asset. The second table makes the assets at the three levels of
detail, certificate included. The third draws low and full detail without maps, {_SIDE} x {_SIDE} pixels, with
MuJoCo's renderer.
"""

Steps = Mapping[str, tuple[int, float, float | None]]  # by budget: colliders, and steps/s in both engines


def measure(*, quick: bool) -> Section:
    """Run the benchmark, in MuJoCo Warp only where that can be installed."""
    names = ["drawer"] if quick else ["door", "drawer", "refrigerator", "oven", "toaster", "lamp"]
    budgets = BUDGETS[:1] if quick else BUDGETS
    with _warp(quick=quick) as warp:
        version = "" if warp is None else warp.version
        steps = {name: _steps(name, budgets, warp, quick=quick) for name in names}
    details = {name: _details(name) for name in names}
    frames = {name: _frames(name, quick=quick) for name in names}
    return Section(
        "colliders, detail and pictures for training",
        _COMPARED,
        [_step_table(steps), _detail_table(details), _frame_table(frames)],
        _findings(steps, details, frames),
        {WARP: version},
    )


@contextmanager
def _warp(*, quick: bool) -> Iterator[Peer | None]:
    """Start MuJoCo Warp; None if its environment cannot be made, or for a quick run if there is none."""
    if quick and python_of(directory() / WARP) is None:
        yield None
        return
    with ExitStack() as stack:
        try:
            found = stack.enter_context(peer(WARP))
        except ClientError:
            found = None
        yield found


def _steps(name: str, budgets: Sequence[int], warp: Peer | None, *, quick: bool) -> Steps:
    """Return the colliders and the speed of an asset with its own colliders and with budgets."""
    asset = artgen.generate(name, seed=0)
    made, missed = {_EXACT: asset}, ""
    for most in sorted(budgets, reverse=True):  # below the fewest that are found, they stay the same
        before = made[next(reversed(made))]
        made[str(most)], missed = (before, missed) if missed else fewer_colliders(asset, most)
    counts = {budget: sum(len(link.colliders) for link in each.links) for budget, each in made.items()}
    different = {count: made[budget] for budget, count in counts.items()}  # equal numbers are equal assets
    with tempfile.TemporaryDirectory() as directory:
        paths = {
            count: each.export(Path(directory) / str(count), formats=("mjcf",), textures=0, frames=False)
            / f"{each.name}.xml"
            for count, each in different.items()
        }
        ours = {count: speed(each, paths[count], {}) / STEP for count, each in different.items()}
        theirs: dict[int, float] = {}
        if warp is not None:
            worlds, steps, rounds = (2, 2, 1) if quick else (32, 20, 3)
            answer = warp.ask(paths=[*map(str, paths.values())], worlds=worlds, steps=steps, rounds=rounds)
            theirs = dict(zip(paths, answer["steps"], strict=True))
    return {budget: (count, ours[count], theirs.get(count)) for budget, count in counts.items()}


def _details(name: str) -> dict[str, tuple[int, float]]:
    """Return triangles, and seconds from the seed to the certified asset, for each level of detail."""
    triangles: dict[str, int] = {}

    def make(detail: str) -> None:
        asset = artgen.generate(name, seed=0, detail=detail, cache=artgen.graph.Cache())
        triangles[detail] = _triangles(asset)

    works = {detail: partial(seconds, partial(make, detail)) for detail in DETAILS}
    found = alternating(works, 1)
    return {detail: (triangles[detail], found[detail]) for detail in DETAILS}


def _triangles(asset: Asset) -> int:
    return sum(len(surface.mesh.triangles) for link in asset.links for surface in link.surfaces)


def _frames(name: str, *, quick: bool) -> dict[str, float]:
    """Return pictures per second of the processor for full and low detail; empty without OpenGL."""
    try:
        window = gl.context(_SIDE, _SIDE)
    except RenderError:
        return {}
    window.make_current()
    works = {}
    for detail in ("full", "low"):
        asset = artgen.generate(name, seed=0, detail=detail)
        works[detail] = partial(_drawn, _drawing(asset), 2 if quick else 20)
        works[detail]()  # the first picture pays for what is set up with it
    found = alternating(works, 1 if quick else 3)
    window.free()
    return found


def _drawing(asset: Asset) -> Callable[[], None]:
    """Return a function that draws an asset at rest into an array."""
    import mujoco

    model = asset.to_mjspec(textures=0).compile()
    data = mujoco.MjData(model)
    mujoco.mj_forward(model, data)
    scene, options = mujoco.MjvScene(model, maxgeom=2 * model.ngeom), mujoco.MjvOption()
    context = mujoco.MjrContext(model, mujoco.mjtFontScale.mjFONTSCALE_100)
    mujoco.mjr_setBuffer(mujoco.mjtFramebuffer.mjFB_OFFSCREEN, context)
    camera = mujoco.MjvCamera()
    mujoco.mjv_defaultFreeCamera(model, camera)
    view, pixels = mujoco.MjrRect(0, 0, _SIDE, _SIDE), np.empty((_SIDE, _SIDE, 3), np.uint8)

    def draw() -> None:
        mujoco.mjv_updateScene(model, data, options, None, camera, mujoco.mjtCatBit.mjCAT_ALL, scene)
        mujoco.mjr_render(view, scene, context)
        mujoco.mjr_readPixels(pixels, None, view, context)

    return draw


def _drawn(draw: Callable[[], None], count: int) -> float:
    """Return pictures per second."""

    def several() -> None:
        for _ in range(count):
            draw()

    return count / seconds(several)


def _step_table(found: Mapping[str, Steps]) -> Table:
    rows: list[tuple[Cell, ...]] = []
    for name, each in found.items():
        _, exact, exact_warp = each[_EXACT]
        for budget, (count, ours, theirs) in each.items():
            reached = budget == _EXACT or count <= int(budget)
            share = theirs / exact_warp if theirs and exact_warp else None
            rows.append(
                (
                    name,
                    budget if reached else f"{budget}, not reached",
                    count,
                    ours,
                    ours / exact,
                    theirs,
                    share,
                )
            )
    columns = ("asset", "budget", "colliders", "MuJoCo, steps/s", "to exact", "Warp, steps/s", "to exact")
    return Table("Steps by collider budget", columns, rows)


def _detail_table(found: Mapping[str, Mapping[str, tuple[int, float]]]) -> Table:
    rows: list[tuple[Cell, ...]] = [
        (
            name,
            *(each[detail][0] for detail in DETAILS),
            *(each[detail][1] for detail in DETAILS),
            each["low"][1] / each["full"][1],
        )
        for name, each in found.items()
    ]
    columns = (f"{what}, {detail}" for what in ("triangles", "seed to asset [s]") for detail in DETAILS)
    return Table("By level of detail", ("asset", *columns, "low / full [s]"), rows)


def _frame_table(found: Mapping[str, Mapping[str, float]]) -> Table:
    rows: list[tuple[Cell, ...]] = [
        (name, each.get("low"), each.get("full"), each["low"] / each["full"] if each else None)
        for name, each in found.items()
    ]
    return Table("Pictures", ("asset", "frames/s, low", "frames/s, full", "low / full"), rows)


def _findings(
    steps: Mapping[str, Steps],
    details: Mapping[str, Mapping[str, tuple[int, float]]],
    frames: Mapping[str, Mapping[str, float]],
) -> list[str]:
    said = []
    for number, engine in ((1, "MuJoCo"), (2, "MuJoCo Warp")):
        best = [
            max(each[number] for each in of.values()) / of[_EXACT][number]
            for of in steps.values()
            if of[_EXACT][number]
        ]
        if best:
            said.append(
                f"With the best budget, {engine} makes {span(best)} times as many steps as with exact "
                "colliders."
            )
    fewest = {name: min(count for count, *_ in of.values()) for name, of in steps.items()}
    said.append(
        "The fewest colliders: " + ", ".join(f"{name} {count}" for name, count in fewest.items()) + "."
    )
    share = statistics.median(of["full"][0] / of["low"][0] for of in details.values())
    time = statistics.median(of["low"][1] / of["full"][1] for of in details.values())
    said.append(
        f"Full detail has {shown(share)} times the triangles of low detail, which takes {shown(time)} times "
        "as long to the asset (medians)."
    )
    ratios = [of["low"] / of["full"] for of in frames.values() if of]
    if ratios:
        said.append(
            f"Without a graphics card, low detail is drawn {span(ratios)} times as fast as full detail."
        )
    return said

"""Spouts of faucets: they turn about the z axis above the plane z = 0, the lower end of their foot."""

import math
from typing import Literal

import artgen as ag
from artgen.categories.shared.finish import casting
from artgen.nodes.handles import Path

SpoutStyle = Literal["gooseneck", "arc", "angular", "low", "beam"]
"""A gooseneck, a low arc, a bent square tube, a spout below a bar, or a straight spout."""

GAP = 0.0006
"""Gap between a spout and its base [m]."""

AERATOR = 0.015
"""Length of an aerator [m]."""

HEAD = 0.085
"""Length of a spray head [m]."""

_FOOT = 0.024  # height of the hub of a spout [m]
_BORE = 0.0084  # radius of the bore for a hose [m]
_LEAST = 0.0104  # least radius of a spout with that bore [m]
_HOSE = 0.0056  # radius of the hose [m]
_DOCK = 0.010  # length of the hose inside the spout while the head is out [m]
_SIDES = 12  # number of facets of hollow colliders under a smooth surface
_MESH = ag.material("black_abs").with_(name="aerator_mesh", base_color=(0.10, 0.10, 0.10))


def swivel(*, limit: ag.Scalar, friction: ag.Scalar, pivot: ag.Vector) -> ag.Joint:
    """Make the joint of a spout, which points to the front at 0."""
    return ag.Revolute(
        "spout_swivel",
        axis=ag.Z,
        pivot=pivot,
        limits=(-limit, limit),
        friction=friction,
        damping=0.05,
        armature=0.0005,
        effort=8.0,
    )


def aerator(radius: ag.Scalar, finish: ag.Material) -> ag.Body:
    """Make an aerator with its sieve, from the origin down."""
    ring_ = ag.cylinder(radius, AERATOR, bevel=0.0014).align((0.0, 0.0, 0.001), z=1)
    sieve = ag.cylinder(0.74 * radius, 0.0008).at(0.0, 0.0, 0.001 - AERATOR)
    holes = ag.cylinder(0.50 * radius, 0.0010).at(0.0, 0.0, 0.0009 - AERATOR)
    return ag.weld(
        ag.part(ring_, "aerator", casting(finish, 0.6)),
        ag.detail(sieve, "aerator", _MESH),
        ag.detail(
            holes, "aerator", ag.material("stainless").with_(name="sieve_steel", specular_roughness=0.5)
        ),
    )


def _course(style: SpoutStyle, height: ag.Scalar, reach: ag.Scalar, fall: ag.Scalar) -> Path:
    """Return the center line of a spout from its foot to its end, which points down."""
    low = 0.004
    match style:
        case "gooseneck":
            height = ag.require(
                height,
                height - low > 0.5 * reach,
                "height of a gooseneck must exceed half of its reach: raise height, or lower reach",
            )
            return ag.polyline(
                [(0.0, 0.0, low), (0.0, 0.0, height), (0.0, -reach, height), (0.0, -reach, fall)],
                fillet=0.4985 * reach,
            )
        case "arc":
            drop = height - fall
            return ag.spline(
                [
                    (0.0, 0.0, low),
                    (0.0, 0.0, 0.50 * height),
                    (0.0, -0.16 * reach, 0.86 * height),
                    (0.0, -0.52 * reach, height),
                    (0.0, -0.88 * reach, height - 0.30 * drop),
                    (0.0, -reach, fall + 0.35 * drop),
                    (0.0, -reach, fall),
                ]
            )
        case _:
            return ag.polyline(
                [(0.0, 0.0, low), (0.0, 0.0, height), (0.0, -reach, height), (0.0, -reach, fall)],
                fillet=0.020,
            )


def rising_spout(
    style: SpoutStyle,
    *,
    height: ag.Scalar,
    reach: ag.Scalar,
    fall: ag.Scalar,
    radius: ag.Scalar,
    finish: ag.Material,
) -> ag.Body:
    """Make a spout that goes up from its foot: the link `spout`."""
    section: ag.Profile = ag.circle(radius)
    if style == "angular":
        section = ag.rectangle(1.8 * radius, 1.8 * radius, radius=0.3 * radius)
    pipe = ag.sweep(section, _course(style, height, reach, fall))
    hub = ag.frustum(radius + 0.0065, radius + 0.0035, _FOOT, bevel=0.0015).align((0.0, 0.0, GAP), z=-1)
    end = ag.vector(0.0, -reach, fall)
    metal = casting(finish, 0.32)
    tip = aerator(radius + 0.0012, finish).at(end)
    hold = ag.frame(end + ag.Z * 0.004, approach=ag.Y, closing=ag.X)
    return ag.weld(
        ag.part(hub, "spout", metal, grasp=hold, grasp_width=2.0 * radius + 0.012),
        ag.part(pipe, "spout", metal),
        tip,
    )


def hanging_spout(*, reach: ag.Scalar, radius: ag.Scalar, finish: ag.Material) -> ag.Body:
    """Make a spout below its foot that goes forward and a little up: the link `spout`."""
    low, fall = -0.050, -0.062
    course = ag.polyline(
        [(0.0, 0.0, -0.004), (0.0, 0.0, low), (0.0, -reach, -0.028), (0.0, -reach, fall)], fillet=0.021
    )
    hub = ag.frustum(radius + 0.0035, radius + 0.0065, _FOOT, bevel=0.0015).align((0.0, 0.0, -GAP), z=1)
    end = ag.vector(0.0, -reach, fall)
    metal = casting(finish, 0.32)
    hold = ag.frame(end + ag.Z * 0.006, approach=ag.Y, closing=ag.X)
    return ag.weld(
        ag.part(hub, "spout", metal, grasp=hold, grasp_width=2.0 * radius + 0.012),
        ag.part(ag.sweep(ag.circle(radius), course), "spout", metal),
        aerator(radius + 0.0012, finish).at(end),
    )


def beam_spout(
    *, hub: ag.Scalar, tall: ag.Scalar, reach: ag.Scalar, radius: ag.Scalar, square: bool, finish: ag.Material
) -> ag.Body:
    """Make a straight spout from a ring about a column: the link `spout`.

    The ring has few facets under a smooth surface, which is visual only.
    """
    metal = casting(finish, 0.35)
    core = core_radius(hub)
    inner = (core + 0.0004) * 1.04  # the facets clear the core
    low, high = GAP, tall - 2.0 * GAP
    wall = ag.revolve(
        ag.rectangle(hub - 0.0006 - inner, high - low).at(0.5 * (hub - 0.0006 + inner), 0.5 * (low + high)),
        sides=_SIDES,
    )
    skin = ag.tube(hub, hub - 0.0016, high - low, bevel=0.0006).at(0.0, 0.0, 0.5 * (low + high))
    middle = 0.5 * tall
    end = ag.vector(0.0, -reach, middle - radius)
    if square:
        pipe = ag.Region.between(
            (-1.3 * radius, -reach - 1.1 * radius, middle - 0.75 * radius),
            (1.3 * radius, -0.80 * hub, middle + 0.75 * radius),
        ).box(bevel=0.0025)
        end = ag.vector(0.0, -reach, middle - 0.75 * radius)
    else:
        course = ag.polyline(
            [(0.0, -0.80 * hub, middle), (0.0, -reach, middle), (0.0, -reach, middle - 1.6 * radius)],
            fillet=1.25 * radius,
        )
        pipe = ag.sweep(ag.circle(radius), course)
        end = ag.vector(0.0, -reach, middle - 1.6 * radius)
    hold = ag.grasp_on(pipe, approach=ag.Y, closing=ag.X, depth=0.018)
    return ag.weld(
        ag.part(wall, "spout", metal),
        ag.detail(skin, "spout", finish),
        ag.part(pipe, "spout", metal, grasp=hold),
        aerator(0.92 * radius, finish).at(end),
    )


def core_radius(hub: ag.Scalar) -> ag.Scalar:
    """Return the radius of the fixed core in the ring of a beam spout [m]."""
    return 0.60 * hub


def pull_down_spout(
    *,
    height: ag.Scalar,
    reach: ag.Scalar,
    radius: ag.Scalar,
    travel: ag.Scalar,
    fall: ag.Scalar,
    finish: ag.Material,
) -> ag.Body:
    """Make a gooseneck with space for the hose of a spray head in its end: the link `spout`."""
    metal = casting(finish, 0.32)
    radius = ag.require(
        radius, radius > _LEAST, f"the spout holds the hose of a spray head: girth must be > {_LEAST:g} m"
    )
    deep = travel + _DOCK + 0.006  # depth of the bore
    pipe = ag.sweep(ag.circle(radius), _course("gooseneck", height, reach, fall + deep))
    hub = ag.frustum(radius + 0.0065, radius + 0.0035, _FOOT, bevel=0.0015).align((0.0, 0.0, GAP), z=-1)
    # facets inside the smooth surface
    out, inner = radius - 0.0006, _BORE / 0.966
    leg = ag.revolve(
        ag.rectangle(out - inner, deep + 0.0005).at(0.5 * (out + inner), 0.5 * deep), sides=_SIDES
    )
    skin = ag.tube(radius, radius - 0.0014, deep + 0.0006).at(0.0, 0.0, 0.5 * deep + 0.0003)
    end = ag.vector(0.0, -reach, fall)
    hold = ag.frame(end + ag.Z * 0.012, approach=ag.Y, closing=ag.X)
    return ag.weld(
        ag.part(hub, "spout", metal, grasp=hold, grasp_width=2.0 * radius + 0.012),
        ag.part(pipe, "spout", metal),
        ag.part(leg.at(end), "spout", casting(finish, 0.8)),
        ag.detail(skin.at(end), "spout", finish),
    )


def spray_head(*, radius: ag.Scalar, travel: ag.Scalar, finish: ag.Material) -> ag.Body:
    """Make a spray head below the origin, with the hose above it: the link `spray_head`."""
    low = -HEAD - GAP
    wide = radius + 0.0045
    grip = ag.frustum(wide, radius + 0.0004, 0.75 * HEAD, bevel=0.001).align((0.0, 0.0, -GAP), z=1)
    nose = ag.cylinder(wide, 0.26 * HEAD, bevel=0.002).align((0.0, 0.0, low), z=-1)
    hose = ag.cylinder(_HOSE, travel + _DOCK + 0.002).align((0.0, 0.0, -GAP - 0.002), z=-1)
    metal = casting(finish, 0.28)
    dark = ag.material("black_abs")
    at = [
        (ring * wide * math.cos(turn), ring * wide * math.sin(turn), low - 0.0006)
        for ring, count in ((0.3, 6), (0.62, 12))
        for turn in (math.tau * step / count for step in range(count))
    ]
    rocker = ag.Region.between((-0.0042, -wide - 0.0012, -0.62 * HEAD), (0.0042, -radius, -0.36 * HEAD)).box(
        bevel=0.0016
    )
    face = ag.cylinder(0.84 * wide, 0.0012).at(0.0, 0.0, low + 0.0001)
    hold = ag.grasp_on(grip, approach=ag.Y, closing=ag.X)
    return ag.weld(
        ag.part(grip, "spray_head", metal, grasp=hold),
        ag.part(nose, "spray_head", metal),
        ag.part(hose, "hose", ag.material("rubber")),
        ag.detail(rocker, "spray_head", dark),
        ag.detail(face, "aerator", dark),
        ag.detail(ag.array(ag.cylinder(0.0012, 0.0012), at=at), "aerator", ag.material("silicone")),
    )


def pull_out(*, travel: ag.Scalar, force: ag.Scalar, pivot: ag.Vector) -> ag.Joint:
    """Make the joint of a spray head; the weight on its hose draws it back.

    A weight of 0.5-0.8 kg is on the hose under the sink; friction in the bend takes part of its force.
    """
    preload = 0.75 * force
    stiffness = (force - preload) / travel
    return ag.Prismatic(
        "spray_head_slide",
        axis=-ag.Z,
        pivot=pivot,
        limits=(0.0, travel),
        stiffness=stiffness,
        rest=-preload / stiffness,
        friction=1.0,
        damping=12.0,
        armature=0.5,  # inertia of the weight on the hose
        effort=40.0,
    )

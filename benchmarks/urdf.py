"""Contents of any URDF: triangles, colors, inertia, and penetrations of links."""

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from itertools import combinations
from pathlib import Path
from typing import Any

import fcl
import numpy as np
import trimesh
import yourdfpy
from contacts import Body, Links, convex_body, mesh_body
from numpy.typing import NDArray

Array = NDArray[np.float64]
Positions = Mapping[str, float]

TOUCHING = 1e-4
"""Links that are in each other by less count as touching [m]."""

_CONVEX = 1e-3  # share of its hull that a mesh may leave empty and count as convex
_IMAGES = (".png", ".jpg", ".jpeg")


@dataclass(frozen=True)
class Contents:
    """Contents of a URDF.

    Attributes:
        bodies: Links with visible surfaces; the others are frames.
        joints: Number of movable joints.
        vertices: Vertices of the visible surfaces.
        faces: Triangles of the visible surfaces.
        colors: Number of different colors.
        maps: Number of image files next to it.
        colliders: Number of colliders.
        mass: Total mass [kg].
        massive: Bodies with a mass.
        triangular: Bodies whose tensor of inertia is positive and keeps the triangle inequality.
        fitting: Those of them whose mass and size allow such a tensor.
    """

    bodies: int
    joints: int
    vertices: int
    faces: int
    colors: int
    maps: int
    colliders: int
    mass: float
    massive: int
    triangular: int
    fitting: int


@dataclass(frozen=True)
class Penetration:
    """Penetrations of links.

    Attributes:
        share: Share of the states with a penetration deeper than `TOUCHING`.
        deepest: Largest depth [m].
    """

    share: float
    deepest: float


def read(path: Path) -> Any:
    """Read a URDF without its meshes."""
    return yourdfpy.URDF.load(str(path), load_meshes=False)


def contents(path: Path) -> Contents:
    """Count the contents of a URDF and the files next to it."""
    robot = read(path).robot
    seen = {
        link.name: [_mesh(each.geometry, each.origin, path) for each in link.visuals] for link in robot.links
    }
    colors = {
        tuple(np.round(each.color.rgba, 3))
        for each in [*robot.materials, *(visual.material for link in robot.links for visual in link.visuals)]
        if each is not None and each.color is not None
    }
    sound = [_inertia(link.inertial, seen[link.name]) for link in robot.links if seen[link.name]]
    return Contents(
        bodies=len(sound),
        joints=sum(joint.type != "fixed" for joint in robot.joints),
        vertices=sum(len(mesh.vertices) for meshes in seen.values() for mesh in meshes),
        faces=sum(len(mesh.faces) for meshes in seen.values() for mesh in meshes),
        colors=len(colors),
        maps=sum(file.suffix in _IMAGES for file in path.parent.rglob("*")),
        colliders=sum(len(link.collisions) for link in robot.links),
        mass=sum(link.inertial.mass or 0.0 for link in robot.links if link.inertial is not None),
        massive=sum(each[0] for each in sound),
        triangular=sum(each[1] for each in sound),
        fitting=sum(each[2] for each in sound),
    )


def penetration(
    path: Path, states: int, forbidden: Callable[[Positions], bool] = lambda _: False, seed: int = 0
) -> Penetration:
    """Draw joint positions within the limits, and measure the penetrations of colliders.

    Boxes, cylinders, spheres and convex meshes are solid. Other meshes collide with their surface only, so
    that objects wholly inside them do not count.

    Args:
        path: The URDF.
        states: How many random states, uniform within the limits.
        forbidden: Tells of positions that they do not count.
        seed: Of the states.
    """
    model = read(path)
    robot = model.robot
    bodies = {link.name: [_body(each, path) for each in link.collisions] for link in robot.links}
    links = Links({name: each for name, each in bodies.items() if each})
    pairs = _moving_pairs(robot, [name for name, each in bodies.items() if each])
    draw = np.random.default_rng(seed)
    depths: list[float] = []
    for _ in range(100 * states):
        if len(depths) == states:
            break
        q = {joint.name: float(draw.uniform(*_limits(joint))) for joint in model.actuated_joints}
        if forbidden(q):
            continue
        model.update_cfg(q)
        links.place({name: model.get_transform(name) for name, each in bodies.items() if each})
        depths.append(max(links.depths(pairs).values(), default=0.0))
    deep = [depth > TOUCHING for depth in depths]
    return Penetration(float(np.mean(deep)) if deep else 0.0, max(depths, default=0.0))


def _limits(joint: Any) -> tuple[float, float]:
    if joint.type == "continuous" or joint.limit is None:
        return -np.pi, np.pi
    return float(joint.limit.lower), float(joint.limit.upper)


def _moving_pairs(robot: Any, names: list[str]) -> list[tuple[str, str]]:
    """Return the pairs of links that are not connected by fixed joints."""
    group = {link.name: link.name for link in robot.links}
    for joint in robot.joints:
        if joint.type == "fixed":
            one, other = group[joint.parent], group[joint.child]
            group = {name: one if own == other else own for name, own in group.items()}
    return [(a, b) for a, b in combinations(names, 2) if group[a] != group[b]]


def _mesh(geometry: Any, origin: Array | None, path: Path) -> Any:
    """Return a shape as triangles, in the frame of its link."""
    if geometry.box is not None:
        mesh = trimesh.creation.box(geometry.box.size)
    elif geometry.cylinder is not None:
        mesh = trimesh.creation.cylinder(geometry.cylinder.radius, geometry.cylinder.length)
    elif geometry.sphere is not None:
        mesh = trimesh.creation.icosphere(radius=geometry.sphere.radius)
    else:
        file = path.parent / geometry.mesh.filename
        mesh = trimesh.load(file, force="mesh", process=False, skip_materials=True)
        if geometry.mesh.scale is not None:
            mesh.apply_scale(geometry.mesh.scale)
    mesh.apply_transform(np.eye(4) if origin is None else origin)
    return mesh


def _body(collision: Any, path: Path) -> Body:
    """Return the collision geometry of a shape."""
    geometry, pose = collision.geometry, np.eye(4) if collision.origin is None else collision.origin
    if geometry.box is not None:
        return Body(fcl.Box(*map(float, geometry.box.size)), pose)
    if geometry.cylinder is not None:
        return Body(fcl.Cylinder(geometry.cylinder.radius, geometry.cylinder.length), pose)
    if geometry.sphere is not None:
        return Body(fcl.Sphere(geometry.sphere.radius), pose)
    mesh = _mesh(geometry, pose, path)
    mesh.merge_vertices(merge_tex=True, merge_norm=True)
    hull = mesh.convex_hull
    if hull.volume - mesh.volume <= _CONVEX * hull.volume:
        return convex_body(np.array(hull.vertices), np.array(hull.faces), np.eye(4))
    return mesh_body(np.array(mesh.vertices), np.array(mesh.faces), np.eye(4))


def _inertia(inertial: Any, meshes: list[Any]) -> tuple[bool, bool, bool]:
    """Tell whether a body has a mass, a valid inertia tensor, and one that fits its size."""
    if inertial is None or not inertial.mass or inertial.mass <= 0.0 or inertial.inertia is None:
        return False, False, False
    moments = np.linalg.eigvalsh(np.asarray(inertial.inertia, np.float64))
    if moments[0] <= 0.0 or moments[2] > (1.0 + 1e-6) * (moments[0] + moments[1]):
        return True, False, False
    center = np.zeros(3) if inertial.origin is None else np.asarray(inertial.origin)[:3, 3]
    corners = np.concatenate([mesh.bounds for mesh in meshes])
    far = np.maximum(corners.max(axis=0) - center, center - corners.min(axis=0))
    # no point of the body is further away than a corner of the box around it
    return True, True, bool(moments[2] <= inertial.mass * float(far @ far))

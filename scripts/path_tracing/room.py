"""Rooms for pictures: painted walls, skirting boards, a boarded floor, light from a window."""

import math
from dataclasses import replace

import numpy as np
from manifold3d import CrossSection, Manifold, OpType

from artgen._arrays import Array
from artgen.asset.shape import Mesh
from artgen.materials import Material, material
from path_tracing.studio import Rig, Surroundings

_WALL = Material("wall", (0.50, 0.485, 0.46), specular_roughness=0.9)
_BOARD = Material("skirting", (0.80, 0.79, 0.77), specular_roughness=0.4)
_DARK = Material("joint", (0.05, 0.035, 0.025), specular_roughness=0.9)
_REACH = 7.0  # how far walls and floors go [m]
_HIGH = 3.6  # [m]
_FAR = 2.6  # from a doorway to the wall behind it [m]
_SKIRTING = (0.012, 0.085)  # thickness and height [m]
_PLANK = (0.14, 0.0008)  # width of a floor board and the joint beside it [m]
_IN_WALL = 0.013  # how deep a frame's trim lies before the wall, and how far the wall reaches behind it [m]
_NEAREST_LAMP = 0.9  # scale that the lamps of a room are never smaller than [m]


def room(rig: Rig) -> Surroundings:
    """Return a wall behind the asset, and the floor."""
    rig = _square(rig)
    back = float(rig.back[1])
    near = float(rig.center[1] + back * rig.depth)
    profile = CrossSection([[[-_REACH, 0.0], [_REACH, 0.0], [_REACH, _HIGH], [-_REACH, _HIGH]]])
    ends = sorted((near + back * 0.03, near + back * 0.15))
    surfaces = _wall(rig, profile, (ends[0], ends[1]), ())
    return Surroundings(_lamps(rig), surfaces + _floor(rig))


def doorway(rig: Rig, frame: Array) -> Surroundings:
    """Return a wall with a hole for the asset, the floor, and the room behind it.

    Args:
        rig: Frame of the studio.
        frame: Points of what is built into the wall, shape (n, 3) [m].
    """
    rig = _square(rig)
    hole = _hole(frame - [0.0, 0.0, rig.floor])
    rectangle = CrossSection([[[-_REACH, 0.0], [_REACH, 0.0], [_REACH, _HIGH], [-_REACH, _HIGH]]])
    front, rear = float(frame[:, 1].min()), float(frame[:, 1].max())
    inset = min(_IN_WALL, (rear - front) / 4.0)
    left, _, right, _ = hole.bounds()
    surfaces = _wall(rig, rectangle - hole, (front + inset, rear - inset), (left, right))
    away = float(rig.back[1]) * _FAR
    far = sorted((rig.center[1] + away, rig.center[1] + away + math.copysign(0.1, away)))
    surfaces += _wall(rig, rectangle, (float(far[0]), float(far[1])), ())
    lamp = rig.center + [0.0, away / 2.0, 1.6 * rig.scale]
    lamps = _lamps(rig) | {"behind": rig.softbox(lamp, (0.7, 0.7), (9.0, 8.5, 7.8))}
    return Surroundings(lamps, surfaces + _floor(rig))


def _square(rig: Rig) -> Rig:
    """Return a frame along the normal of the wall, so that the room does not rotate with the camera."""
    back = np.array([0.0, 1.0 if rig.back[1] >= 0.0 else -1.0, 0.0])
    return replace(rig, back=back, scale=max(rig.scale, _NEAREST_LAMP), side=1.0)


def _lamps(rig: Rig) -> dict[str, dict[str, object]]:
    """Return the lights: a window with two sashes at the left, weak light of another room, the ceiling."""
    sashes = {
        f"window_{side}": rig.softbox(
            rig.around(-58 + 15 * side, 24, 2.7), (0.33, 1.0), (16.0, 16.3, 16.8), edge=0.06
        )
        for side in (-1, 1)
    }
    return {
        **sashes,
        "overhead": rig.softbox(rig.around(10, 70, 2.8), (1.2, 0.8), (1.3, 1.25, 1.2)),
        "dome": rig.dome(0.12, 0.34),
    }


def _hole(frame: Array) -> CrossSection:
    """Return the outline of an asset in a wall, slightly smaller than the asset, down through the floor."""
    outline = Manifold.hull_points(
        np.concatenate([frame * [1, 0, 1], frame * [1, 0, 1] + [0.0, 1.0, 0.0]])
    ).rotate([-90.0, 0.0, 0.0])
    section = outline.slice(outline.bounding_box()[2] + 0.5).offset(-_IN_WALL)
    return section + section.translate([0.0, -4.0 * _IN_WALL])


def _wall(
    rig: Rig, outline: CrossSection, span: tuple[float, float], hole: tuple[float, ...]
) -> list[tuple[Mesh, Material]]:
    """Return a wall between two places along y with skirting boards on both sides, clear of a hole in x."""

    def stood(section: CrossSection, near: float, far: float) -> Manifold:
        solid = Manifold.extrude(section, far - near).rotate([90.0, 0.0, 0.0])
        return solid.translate([0.0, far, rig.floor])

    wall = stood(outline, *span)
    thick, tall = _SKIRTING
    runs = [(-_REACH, _REACH)] if not hole else [(-_REACH, hole[0]), (hole[1], _REACH)]
    boards = []
    for low, high in runs:
        strip = CrossSection([[[low, 0.0], [high, 0.0], [high, tall], [low, tall]]])
        boards += [stood(strip, span[0] - thick, span[0]), stood(strip, span[1], span[1] + thick)]
    return [(_flat(wall), _WALL), (_flat(Manifold.batch_boolean(boards, OpType.Add)), _BOARD)]


def _floor(rig: Rig) -> list[tuple[Mesh, Material]]:
    """Return boards along y in three shades over a dark ground, which is visible between them."""
    stream = np.random.default_rng(7)
    wide, joint = _PLANK
    corners: list[list[Array]] = [[], [], []]
    for start in np.arange(-_REACH, _REACH, wide):
        y = -_REACH - stream.uniform(0.0, 1.0)
        while y < _REACH:
            long = stream.uniform(1.1, 2.2)
            low, high = (start + joint, y + joint), (start + wide, y + long)
            corners[stream.integers(3)].append(
                np.array([[low[0], low[1]], [high[0], low[1]], [high[0], high[1]], [low[0], high[1]]])
            )
            y += long
    oak = material("oak")
    result = [
        (_boards([np.array([[-9.0, -9.0], [9.0, -9.0], [9.0, 9.0], [-9.0, 9.0]])], rig.floor - 0.002), _DARK)
    ]
    for number, shade in enumerate((0.92, 1.0, 1.08)):
        color = tuple(channel * shade for channel in oak.base_color)
        dressed = oak.with_(
            name=f"floor_{number}", base_color=color, variant=number, specular_roughness=0.38, turned=False
        )
        result.append((_boards(corners[number], rig.floor - 0.0005), dressed))
    return result


def _boards(corners: list[Array], height: float) -> Mesh:
    """Return horizontal rectangles, each with its own region of the map."""
    stream = np.random.default_rng(11)
    flat = np.concatenate(corners)
    shifts = np.repeat(stream.uniform(0.0, 5.0, (len(corners), 2)), 4, axis=0)
    vertices = np.column_stack([flat, np.full(len(flat), height)])
    first = 4 * np.arange(len(corners))[:, None]
    triangles = np.concatenate([first + [0, 1, 2], first + [0, 2, 3]])
    normals = np.broadcast_to([0.0, 0.0, 1.0], vertices.shape)
    return Mesh(vertices, normals, flat + shifts, np.zeros(len(flat), np.int64), triangles)


def _flat(solid: Manifold) -> Mesh:
    """Return the faces of a solid, each with its own normals, laid out in metres from the side."""
    mesh = solid.to_mesh64()
    vertices = np.asarray(mesh.vert_properties)[:, :3][np.asarray(mesh.tri_verts).ravel()]
    sides = vertices.reshape(-1, 3, 3)
    normals = np.cross(sides[:, 1] - sides[:, 0], sides[:, 2] - sides[:, 0])
    normals /= np.maximum(np.linalg.norm(normals, axis=1, keepdims=True), 1e-12)
    triangles = np.arange(len(vertices)).reshape(-1, 3)
    return Mesh(
        vertices,
        np.repeat(normals, 3, axis=0),
        vertices[:, [0, 2]],
        np.zeros(len(vertices), np.int64),
        triangles,
    )

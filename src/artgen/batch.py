"""Batches: many different assets in the worlds of one simulation.

The worlds of a batch share links, joints and colliders; `topology="fixed"` makes assets so. `groups` tells
which assets an engine can put into one batch; `mjlab`, `mujoco_warp`, `mjx`, `isaaclab` and `genesis` hand
assets over to these engines.
"""

import dataclasses
from collections.abc import Callable, Hashable, Iterable, Mapping, Sequence
from io import BytesIO
from pathlib import Path
from typing import TYPE_CHECKING, Any, Literal, get_args
from weakref import WeakKeyDictionary

import numpy as np
from numpy.typing import NDArray

from artgen._arrays import cached_property
from artgen._names import ByName
from artgen.asset import Asset
from artgen.asset.link import BareLink, Collider, DerivedLink
from artgen.catalog import generate
from artgen.errors import ParameterError, needed
from artgen.export.frames import apart, coupling, linear_coupling
from artgen.export.mjcf import OFF, Tendons, tendons_of
from artgen.export.objects import mjspec
from artgen.generator import Generator
from artgen.generator.generator import check_flag
from artgen.topology import Topology
from artgen.topology.template import checked_assets

if TYPE_CHECKING:
    import mujoco

Rule = Literal["isaaclab", "mjlab", "mujoco_warp"]
"""Engines by the structure that the worlds of one batch must share."""

ASSET_SITE = "artgen_asset"
"""Site of a model for MJX whose x is the number of the asset in the world."""

_LEAST_FRICTION = 1e-9  # dry friction of a joint that has none, where another asset has some [N or N m]
_UNLIMITED = 1e6  # range of a joint without limits: worlds share whether a joint has limits [rad or m]
# where things are: MuJoCo Warp places those that do not move only once
_PLACES = ("xpos", "xquat", "xmat", "xipos", "ximat", "geom_xpos", "geom_xmat")
_SIMPLE = "body_simple"  # whether a body allows a shortcut, which no world takes unless all can
_ACTING = ("has_tendon_stiffness", "has_tendon_damping")  # whether MuJoCo Warp computes them in any world
# fields that may differ: also weights of speeds for sleep, which batches do not use, and a part of the state
_OWN = (_SIMPLE, "dof_length", "eq_active0", *_ACTING)
_OF_MJLAB = ("geom_dataid", "geom_matid", "body_subtreemass")  # which mjlab gives each world itself
_SEEN = ("mat_", "nmat", "cam_", "light_", "tex_", "flex_rgba")  # fields of the model that only cameras need
# addresses in the arrays of meshes, and the array whose length they grow by
_ADDRESSES = {
    "mesh_vertadr": "mesh_vert", "mesh_normaladr": "mesh_normal", "mesh_faceadr": "mesh_face",
    "mesh_graphadr": "mesh_graph", "mesh_polyadr": "mesh_polynormal", "mesh_polyvertadr": "mesh_polyvert",
    "mesh_polymapadr": "mesh_polymap",
}  # fmt: skip


def groups(assets: Iterable[Asset], rule: Rule) -> list[list[Asset]]:
    """Return the groups of assets that can share one batch of an engine, in order of their first assets.

    Args:
        assets: The assets.
        rule: `mujoco_warp`: the tree, the kinds of joints and the kinds of colliders of each link, in order,
            are the same. `mjlab` and `isaaclab`: also the names of links and joints; kinds and order name the
            colliders.

    Raises:
        ParameterError: The rule is unknown, or something else than assets is given.
    """
    if rule not in get_args(Rule):
        allowed = ", ".join(map(repr, get_args(Rule)))
        raise ParameterError(f"rule = {rule!r} is not allowed: it must be one of {allowed}")
    found: dict[Hashable, list[Asset]] = {}
    for asset in checked_assets("groups", assets, Asset):
        structure: list[Hashable] = [_structure(asset)]
        if rule != "mujoco_warp":
            structure += [asset.links.names, asset.joints.names]
        found.setdefault(tuple(structure), []).append(asset)
    return list(found.values())


def _structure(asset: Asset) -> Hashable:
    """Return the tree, the kinds of joints, and the kinds of colliders, which name them in USD."""
    numbers = {link.name: number for number, link in enumerate(asset.links)}
    joints = [(numbers[each.parent], numbers[each.child], each.kind, each.locked) for each in asset.joints]
    colliders = [tuple(each.convex.kind for each in link.colliders) for link in asset.links]
    return tuple(joints), tuple(colliders)


def mjlab(
    category: str | Generator, seeds: Iterable[int], *, touching: bool = True, **options: Any
) -> "list[mujoco.MjSpec]":
    """Return editable models of MuJoCo with one structure, for the variants of an entity of mjlab.

    mjlab 1.6 takes variants with a free base only. It varies meshes, masses and inertias from world to world,
    and takes all other numbers from the first variant; `mjlab_event` gives them to the worlds.

    The models have the colliders of the assets, without visual surfaces, grasps, keyframes, and colliders
    that are spare in all of the assets. A joint without limits has a range of 1e6 to either side. Couplings
    and pins of other assets are there, but not active.

    Args:
        category: Name of a category, or a generator.
        seeds: Seeds of the assets.
        touching: Whether contacts are left only to those links of an asset that can touch each other; see
            `specs`.
        **options: Options of `generate`; `base` is "free" by default, `topology` is "fixed", and with
            `colliders` that of these assets.

    Raises:
        AssetError: A seed does not fit the topology.
        ExportError: MuJoCo is not installed.
        ParameterError: There are no seeds, or an option is not allowed.
    """
    import trimesh

    result = specs(_generated(category, seeds, {"base": "free"} | options), touching=touching)
    import mujoco  # `specs` has told if it is not installed

    for spec in result:
        for geom in (geom for geom in spec.geoms if geom.margin == OFF):
            geom.margin, geom.userdata = 0.0, [1.0]  # mjlab takes no margins in its first model
        for mesh in spec.meshes:  # mjlab copies neither files nor how meshes are centered
            shape = trimesh.load_mesh(BytesIO(spec.assets[mesh.file]), "obj", process=False)
            mesh.uservert, mesh.userface = shape.vertices.ravel(), shape.faces.ravel()
            mesh.file, mesh.inertia = "", mujoco.mjtMeshInertia.mjMESH_INERTIA_LEGACY
        spec.assets = {}
    return result


def mjlab_event(specs: "Sequence[mujoco.MjSpec]", entity: str) -> Callable[[Any, Any], None]:
    """Return an event of mjlab that gives every world the numbers of its variant.

    From world to world, a `VariantEntityCfg` varies meshes, masses and inertias; places, limits and springs
    of joints, primitive colliders, couplings and tendons are those of the first variant in all worlds. Use
    the event in two terms: with mode "startup", and with mode "reset", as a reset activates the couplings of
    the first variant.

    Args:
        specs: The models of the variants in their order, from `mjlab`.
        entity: Name of the entity in the scene.

    Returns:
        A function of an environment and the numbers of worlds, which it ignores: it sets all worlds.
    """
    models = [spec.copy().compile() for spec in specs]
    couplings: WeakKeyDictionary[Any, tuple[slice, NDArray[np.bool_]]] = WeakKeyDictionary()  # by simulation

    def event(env: Any, _: Any) -> None:
        if env.sim not in couplings:
            of = env.sim.world_to_variant[entity].cpu().numpy()
            blocks = _blocks(models[0], env.sim.mj_model, entity)
            _give_numbers(env.sim, models, of, blocks)
            active = np.stack([model.eq_active0 for model in models]).astype(bool)
            couplings[env.sim] = blocks.get("eq", slice(0)), active[of]
        _put(env.sim.data.eq_active, *couplings[env.sim])

    return event


def _blocks(model: "mujoco.MjModel", scene: "mujoco.MjModel", entity: str) -> dict[str, slice]:
    """Return the indices of a model's objects in a scene, by the prefix of the names of their fields."""
    root = scene.body(f"{entity}/{model.body(1).name}").id
    joint = scene.joint(f"{entity}/{model.joint(0).name}").id
    start = {"body": root, "jnt": joint, "dof": scene.jnt_dofadr[joint], "qpos": scene.jnt_qposadr[joint]}
    counts = {"body": model.nbody - 1, "jnt": model.njnt, "dof": model.nv, "qpos": model.nq}
    if model.ngeom:  # mjlab renames meshes
        start["geom"] = scene.body_geomadr[root + model.geom_bodyid[0] - 1]
    for kind, known in (("site", "site"), ("tendon", "tendon"), ("eq", "equality")):
        counts[kind] = getattr(model, f"n{kind}")
        if counts[kind]:
            start[kind] = getattr(scene, known)(f"{entity}/{getattr(model, known)(0).name}").id
    counts["geom"] = model.ngeom
    return {kind: slice(first, first + counts[kind]) for kind, first in start.items()}


def _give_numbers(
    simulation: Any, models: "Sequence[mujoco.MjModel]", of: NDArray[np.int64], blocks: Mapping[str, slice]
) -> None:
    """Write the fields that mjlab takes from the first variant, with the numbers of each world's variant."""
    found = {}
    for name in _batched(simulation.wp_model):
        kind = "qpos" if name.startswith("qpos") else name.split("_")[0]
        if kind in blocks and name not in _OF_MJLAB:
            values = np.stack([getattr(model, name) for model in models])
            found[name] = kind, values[:, 1:] if kind == "body" else values
    spare = np.stack([model.geom_user.any(axis=1) for model in models])
    found["geom_margin"] = "geom", np.where(spare, OFF, 0.0)
    found["geom_rbound"] = "geom", np.where(spare, -OFF, found["geom_rbound"][1])  # as in `joined`
    differ = {name: each for name, each in found.items() if (each[1] != each[1][0]).any()}
    simulation.expand_model_fields(tuple(differ))
    for name, (kind, values) in differ.items():
        _put(getattr(simulation.model, name), blocks[kind], values[of])
    warp_model = simulation.wp_model
    simple = getattr(warp_model, _SIMPLE).numpy()
    simple[blocks["body"]] = np.min([model.body_simple for model in models], axis=0)[1:]
    getattr(warp_model, _SIMPLE).assign(simple)
    for name in _ACTING:
        acts = any(getattr(model, name.removeprefix("has_")).any() for model in models)
        setattr(warp_model, name, acts or getattr(warp_model, name, False))
    simulation.create_graph()  # of the new arrays


def _put(target: Any, block: slice, values: NDArray[Any]) -> None:
    """Write values, shape (worlds, objects, ...), into a block of an array of mjlab."""
    import torch

    target[:, block] = torch.as_tensor(values).to(target.device, target.dtype).reshape(target[:, block].shape)


def specs(assets: Iterable[Asset], *, touching: bool = True) -> "list[mujoco.MjSpec]":
    """Return the models of `mjlab` for assets of one topology.

    Args:
        assets: The assets.
        touching: Whether pairs of links are excluded from contacts that cannot touch each other in any of the
            assets, as long as dependencies of joints hold. Their contact pairs are most of the work of the
            broad phase. Contacts with other things are not affected.

    Raises:
        ParameterError: The assets do not share a structure, or something else than assets is given.
    """
    assets = checked_assets("specs", assets, Asset)
    check_flag("touching", touching)
    _check_shared(assets, "mujoco_warp")
    common = Common.of(assets)
    needed = [
        tuple(
            any(not each.spare for each in same)
            for same in zip(*(link.colliders for link in links), strict=True)
        )
        for links in zip(*(asset.links for asset in assets), strict=True)
    ]
    return [_spec(asset, common, needed, touching=touching) for asset in assets]


@dataclasses.dataclass(frozen=True)
class Common:
    """The couplings, pins, tendons and pairs of links without contact of all assets of a batch.

    Models of MuJoCo share a batch if these are the same, beside links, joints and colliders.

    Attributes:
        couplings: The following and the leading joint of each coupling.
        pins: The links of each pin of a closed chain.
        tendons: Largest number of ridges of each joint, and whether it closes softly, for the writer of MJCF.
        apart: Pairs of links that cannot touch each other in any of the assets.
    """

    couplings: tuple[tuple[str, str], ...]
    pins: tuple[tuple[str, str], ...]
    tendons: Tendons
    apart: tuple[tuple[str, str], ...]

    @classmethod
    def of(cls, assets: Sequence[Asset]) -> "Common":
        """Collect them from all assets, whose links and joints have the same names."""
        couplings = dict.fromkeys(
            (joint.name, law.leader)
            for asset in assets
            for joint in asset.joints
            if not joint.locked and (law := linear_coupling(asset, joint)) is not None
        )
        pins = dict.fromkeys(loop.links for asset in assets for loop in asset.loops)
        own = [tendons_of(asset) for asset in assets]
        tendons = {
            name: (max(each[name][0] for each in own), any(each[name][1] for each in own)) for name in own[0]
        }
        pairs = [apart(asset) for asset in assets]
        never = tuple(each for each in pairs[0] if all(each in other for other in pairs[1:]))
        return cls(tuple(couplings), tuple(pins), tendons, never)

    def align(self, asset: Asset, spec: "mujoco.MjSpec", *, touching: bool) -> None:
        """Give a model of one of the assets the couplings and pins of all; those of others are not active.

        Args:
            asset: The asset.
            spec: Its model, which is changed.
            touching: Whether pairs of `apart` are excluded from contacts.
        """
        import mujoco

        for joint in spec.joints:
            if joint.type != mujoco.mjtJoint.mjJNT_FREE and not asset.joint(joint.name).limits:
                joint.limited, joint.range = mujoco.mjtLimited.mjLIMITED_TRUE, (-_UNLIMITED, _UNLIMITED)
        own = {
            (each.name1, each.name2): tuple(map(np.copy, (each.data, each.solref, each.solimp)))
            for each in spec.equalities
        }
        others = next(((np.zeros_like(data), *numbers) for data, *numbers in own.values()), None)
        for each in list(spec.equalities):
            spec.delete(each)
        kinds = ((mujoco.mjtEq.mjEQ_JOINT, mujoco.mjtObj.mjOBJ_JOINT, self.couplings),
                 (mujoco.mjtEq.mjEQ_CONNECT, mujoco.mjtObj.mjOBJ_BODY, self.pins))  # fmt: skip
        for kind, objects, pairs in kinds:  # in the same order in all models
            for pair in pairs:
                first, second = pair
                added = spec.add_equality(
                    name="_".join(pair),
                    type=kind,
                    objtype=objects,
                    name1=first,
                    name2=second,
                    active=pair in own,
                )
                numbers = own.get(pair, others)
                if numbers is not None:
                    added.data[:], added.solref[:], added.solimp[:] = numbers
        for first, second in self.apart if touching else ():
            spec.add_exclude(bodyname1=first, bodyname2=second)


def _check_shared(assets: Sequence[Asset], rule: Rule) -> None:
    found = groups(assets, rule)
    if len(found) != 1:
        raise ParameterError(
            f"{len(assets)} assets have {len(found)} structures and cannot share a batch; generate them with "
            "topology='fixed', or pad them with Topology.of(assets).pad"
        )


def usd(
    category: str | Generator,
    seeds: Iterable[int],
    folder: str | Path,
    *,
    textures: int = 512,
    **options: Any,
) -> list[Path]:
    """Write a USD file for each seed, in which links, joints and colliders have equal paths and schemas.

    The paths are equal below the default prims. Visual surfaces, materials, grasps and pushes differ.

    Args:
        category: Name of a category, or a generator.
        seeds: Seeds of the assets.
        folder: Folder for a folder of each asset.
        textures: Width of material maps in pixels; 0 writes none.
        **options: Options of `generate`; `topology` is "fixed" by default, and with `colliders` that of these
            assets.

    Raises:
        AssetError: A seed does not fit the topology.
        ParameterError: There are no seeds, an option is not allowed, or the assets do not share a structure.
    """
    assets = _generated(category, seeds, options)
    _check_shared(assets, "isaaclab")
    folders = [each.export(Path(folder) / each.name, formats=("usd",), textures=textures) for each in assets]
    return [place / f"{each.name}.usda" for place, each in zip(folders, assets, strict=True)]


def isaaclab(
    category: str | Generator,
    seeds: Iterable[int],
    folder: str | Path,
    *,
    textures: int = 512,
    **options: Any,
) -> Any:
    """Return a spawner of Isaac Lab that gives worlds the assets of seeds in turn, a `MultiUsdFileCfg`.

    It reads the files of `usd`, which are written first. Use it as `spawn` of an `ArticulationCfg`, in a
    scene with `replicate_physics=False`. The arguments and other errors are those of `usd`.

    Raises:
        ExportError: Isaac Lab cannot be loaded.
    """
    with needed(
        "a spawner of Isaac Lab needs isaaclab, which cannot be loaded ({error}): pip install 'isaaclab"
        "[isaacsim]' --extra-index-url https://pypi.nvidia.com, and start its AppLauncher first; "
        "`usd` writes the files without it"
    ):
        from isaaclab.sim import MultiUsdFileCfg
    paths = usd(category, seeds, folder, textures=textures, **options)
    return MultiUsdFileCfg(usd_path=[str(each.resolve()) for each in paths], random_choice=False)


def genesis(
    category: str | Generator,
    seeds: Iterable[int],
    folder: str | Path,
    *,
    textures: int = 512,
    **options: Any,
) -> list[Any]:
    """Return morphs of Genesis with one kinematic tree, one for each seed, for one heterogeneous entity.

    `scene.add_entity(genesis(...))` gives contiguous blocks of worlds the assets in turn. They are
    `morphs.MJCF` of files that are written first. Genesis asks only for equal links and joints, so the files
    have no spare colliders. It takes the couplings of the first asset for all of them. The arguments and
    other errors are those of `usd`.

    Raises:
        ExportError: Genesis cannot be loaded.
        ParameterError: The assets do not share links and joints, their couplings differ, or one has loose
            links.
    """
    text = "a batch of Genesis needs genesis-world, which cannot be loaded ({error}): pip install "
    with needed(text + "genesis-world torch"):
        import genesis as engine
    assets = [
        dataclasses.replace(asset, links=ByName(map(_OwnLink.of, asset.links)))
        for asset in _generated(category, seeds, options)
    ]
    _check_kinematics(assets)
    paths = [
        each.export(Path(folder) / each.name, formats=("mjcf",), textures=textures) / f"{each.name}.xml"
        for each in assets
    ]
    # by default, Genesis adds armature and moves the frames of links
    return [engine.morphs.MJCF(file=str(each.resolve()), default_armature=0.0, align=False) for each in paths]


@dataclasses.dataclass(frozen=True, eq=False, repr=False)
class _OwnLink(DerivedLink):
    """A link without its spare colliders."""

    @cached_property
    def colliders(self) -> tuple[Collider, ...]:
        """Those that cover its solids."""
        return tuple(each for each in self.source.colliders if not each.spare)


def _check_kinematics(assets: Sequence[Asset]) -> None:
    """Check that assets can be one heterogeneous entity of Genesis."""
    joints = [[(each.name, each.kind, each.parent, each.child) for each in one.joints] for one in assets]
    if any(each != joints[0] for each in joints):
        raise ParameterError(
            "the assets do not have the same links and joints; generate them with topology='fixed', or pad "
            "them with Topology.of(assets).pad"
        )
    for asset in assets:
        if asset.loose:
            raise ParameterError(
                f"asset {asset.name!r} has the loose links {', '.join(asset.loose)}, and Genesis takes only "
                "entities of one base into a batch; leave this category or style out"
            )
        if _pins(asset) != _pins(assets[0]):
            raise ParameterError(
                f"closed chains differ in {asset.name!r} and {assets[0].name!r}, and Genesis takes the pins "
                "of the first asset for all; batch such seeds apart"
            )
        for joint, first in zip(asset.joints, assets[0].joints, strict=True):
            if coupling(asset, joint) != coupling(assets[0], first):
                raise ParameterError(
                    f"joint {joint.name!r} follows another law in {asset.name!r} than in {assets[0].name!r}, "
                    "and Genesis takes the couplings of the first asset for all; batch such seeds apart"
                )


def _pins(asset: Asset) -> list[tuple[tuple[str, str], list[float]]]:
    """Return the links of each pin, and its place in the frame of the first."""
    return [
        (loop.links, np.round(loop.point - asset.origin(loop.links[0]), 9).tolist()) for loop in asset.loops
    ]


def _generated(category: str | Generator, seeds: Iterable[int], options: dict[str, Any]) -> list[Asset]:
    """Return assets of one topology: the recorded one, or with `colliders` that of these assets."""
    if not isinstance(seeds, Iterable):
        raise ParameterError(f"seeds = {seeds!r} is not allowed: give several seeds, such as range(4)")
    if "seed" in options:
        raise ParameterError(f"seed = {options['seed']!r} is not allowed: `seeds` has the seeds of a batch")
    own = options.get("colliders") is not None and "topology" not in options
    assets = [
        generate(category, seed=seed, **{"topology": "own" if own else "fixed"} | options) for seed in seeds
    ]
    if not assets:
        raise ParameterError("a batch needs at least one seed; give some")
    if own:
        topology = Topology.of(assets)
        assets = [topology.pad(asset) for asset in assets]
        for asset in assets if options.get("certify", True) else ():
            asset.certify(options.get("tolerance", 0.0))
    return assets


def _spec(
    asset: Asset, common: Common, needed: Sequence[tuple[bool, ...]], *, touching: bool
) -> "mujoco.MjSpec":
    """Return the model of an asset for a batch."""
    links = [
        BareLink.of(link, grasps=(), pushes=(), needed=each)
        for link, each in zip(asset.links, needed, strict=True)
    ]
    spec = mjspec(dataclasses.replace(asset, links=ByName(links)), 0, common.tendons)
    for each in (*spec.keys, *spec.texts, *spec.materials, *spec.textures):
        spec.delete(each)
    for joint in spec.joints:
        if joint.name == f"{asset.name}_free":
            joint.name = f"{asset.links[0].name}_free"  # the same in all models
    common.align(asset, spec, touching=touching)
    return spec


@dataclasses.dataclass(frozen=True, eq=False)
class Worlds:
    """Different assets in the worlds of one model of MuJoCo Warp.

    Attributes:
        assets: The assets.
        of: Number of the asset in each world, shape (worlds,).
        compiled: MuJoCo's model of each asset.
        model: MuJoCo Warp's model of all worlds.
        data: Its state.
    """

    assets: tuple[Asset, ...]
    of: NDArray[np.int64]
    compiled: "tuple[mujoco.MjModel, ...]"
    model: Any
    data: Any

    def reset(self) -> None:
        """Reset all worlds to the initial states of their assets.

        `mujoco_warp.reset_data` alone activates the couplings and pins of the first asset in all worlds.
        """
        _warp().reset_data(self.model, self.data)
        states = [_state(each) for each in self.compiled]
        for name in ("qpos", "eq_active", *_PLACES):
            values = np.stack([getattr(states[number], name) for number in self.of])
            array = getattr(self.data, name)
            array.assign(values.astype(array.numpy().dtype).reshape(array.numpy().shape))


def mujoco_warp(
    category: str | Generator,
    seeds: Iterable[int],
    worlds: int | None = None,
    *,
    touching: bool = True,
    **options: Any,
) -> Worlds:
    """Return a model of MuJoCo Warp whose worlds have different assets of one category.

    Worlds get the assets in turn. The structure of their models, the other arguments and the other errors are
    those of `mjlab`.

    Args:
        worlds: Number of worlds; by default one for each asset.
        **options: Those of `usd`. `nconmax` and `njmax` set the room for contacts and constraints of each
            world, as in `mujoco_warp.make_data`.

    Raises:
        ExportError: MuJoCo or MuJoCo Warp is not installed.
        ParameterError: There are no worlds.
    """
    room = {name: options.pop(name) for name in ("nconmax", "njmax") if name in options}
    assets = _generated(category, seeds, options)
    count = len(assets) if worlds is None else worlds
    if count < 1:
        raise ParameterError(f"worlds = {worlds!r} is not allowed: it must be a whole number from 1 on")
    warp = _warp()
    compiled = [spec.compile() for spec in specs(assets, touching=touching)]
    of = np.arange(count) % len(assets)
    model = joined(compiled[0], [warp.put_model(each) for each in compiled], of.tolist())
    data = warp.make_data(compiled[0], nworld=count, **room)
    result = Worlds(tuple(assets), of, tuple(compiled), model, data)
    result.reset()
    return result


def _state(model: "mujoco.MjModel") -> "mujoco.MjData":
    """Return the state in which a simulation begins."""
    import mujoco

    data = mujoco.MjData(model)
    mujoco.mj_forward(model, data)
    return data


@dataclasses.dataclass(frozen=True, eq=False)
class MjxWorlds:
    """Different assets for the worlds of one model of MJX.

    Attributes:
        assets: The assets.
        model: MuJoCo's model of the first asset, for `mjx.put_model`.
        active: Whether each equality constraint is active, shape (assets, constraints).
        fields: Arrays of the model that differ between assets, by name, shape (assets, ...).
    """

    assets: tuple[Asset, ...]
    model: "mujoco.MjModel"
    active: NDArray[np.bool_]
    fields: dict[str, NDArray[Any]]

    def randomize(self, model: Any, rng: Any) -> tuple[Any, Any]:
        """Return MJX's model of worlds that get the assets in turn, and its axes for `jax.vmap`.

        This is a domain randomization function of MuJoCo Playground.

        Args:
            model: MJX's model of one world.
            rng: One key for each world; only their number counts.
        """
        import jax

        of = np.arange(len(rng)) % len(self.assets)
        axes = jax.tree_util.tree_map(lambda _: None, model).tree_replace(dict.fromkeys(self.fields, 0))
        values = {name: jax.numpy.asarray(each[of]) for name, each in self.fields.items()}
        return model.tree_replace(values), axes


def mjx(category: str | Generator, seeds: Iterable[int], **options: Any) -> MjxWorlds:
    """Return models for MJX whose worlds have different assets of one category.

    MJX takes only numbers from world to world, so all worlds have the meshes of the first asset. Therefore
    colliders are there, but do not touch: links of proven assets cannot touch each other, except latches,
    detents and the like. The model has a site `artgen_asset` whose x is the number of the asset. The
    arguments and other errors are those of `usd`.

    Raises:
        ExportError: MuJoCo or MJX is not installed.
    """
    return mjx_worlds(_generated(category, seeds, options))


def mjx_worlds(assets: Sequence[Asset]) -> MjxWorlds:
    """Return the models of `mjx` for assets of one topology.

    Raises:
        ExportError: MuJoCo or MJX is not installed.
        ParameterError: The assets do not share a structure.
    """
    with needed("a batch of MJX needs mujoco-mjx, which cannot be loaded ({error}): pip install mujoco-mjx"):
        import jax
        from mujoco import mjx as engine
    models = []
    for number, spec in enumerate(specs(assets)):
        spec.worldbody.add_site(name=ASSET_SITE, pos=(number, 0.0, 0.0))
        for geom in spec.geoms:
            geom.contype = geom.conaffinity = 0
        models.append(spec.compile())
    first = models[0]
    # MJX leaves out the dry friction of joints where the first model has none
    rough = np.max([model.dof_frictionloss for model in models], axis=0) > 0.0
    first.dof_frictionloss[rough] = np.maximum(first.dof_frictionloss[rough], _LEAST_FRICTION)
    put = engine.put_model(first)
    fields = {}
    for field in dataclasses.fields(put):
        if isinstance(getattr(put, field.name), jax.Array) and not field.name.startswith(("_", *_SEEN)):
            values = np.stack([getattr(model, field.name) for model in models])
            if (values != values[0]).any():
                fields[field.name] = values
    active = np.stack([model.eq_active0 for model in models]).astype(bool)
    return MjxWorlds(tuple(assets), first, active, fields)


def _warp() -> Any:
    text = "a batch of MuJoCo Warp needs mujoco-warp, which cannot be loaded ({error}): pip install "
    with needed(text + "mujoco-warp"):
        import mujoco_warp as warp
    return warp


def structure(model: Any) -> Hashable:
    """Return what models of MuJoCo Warp must have in common to become one model."""
    import warp

    common: list[Hashable] = []
    for field in dataclasses.fields(model):
        name, value = field.name, getattr(model, field.name)
        if name in (*_batched(model), *_OWN) or name.startswith(("mesh_", "nmesh", "npolygonmax", *_SEEN)):
            continue
        if isinstance(value, warp.array):
            common.append((name, value.shape, value.numpy().tobytes()))
        elif isinstance(value, np.ndarray):
            common.append((name, value.shape, value.tobytes()))
        elif isinstance(value, int | tuple):
            common.append((name, repr(_plain(value))))
    shapes = tuple(getattr(model, name).shape for name in _batched(model) if not name.startswith(_SEEN))
    return (shapes, *common)


def joined(mujoco_model: Any, models: Sequence[Any], of: Sequence[int]) -> Any:
    """Return one model of MuJoCo Warp for worlds whose models share structure.

    Args:
        mujoco_model: MuJoCo's model of the first.
        models: MuJoCo Warp's models.
        of: Number of the model of each world.
    """
    import mujoco_warp
    import warp

    if len(models) == 1:
        return models[0]
    values: dict[str, list[Any]] = {}
    for name in _batched(models[0]):
        each = [getattr(model, name).numpy()[0] for model in models]
        if len({value.shape for value in each}) == 1:  # fields of cameras may be in one model only
            values[name] = each
    meshes = 0
    for number, model in enumerate(models):
        of_mesh = values["geom_dataid"][number]
        values["geom_dataid"][number] = np.where(of_mesh >= 0, of_mesh + meshes, of_mesh)
        meshes += model.nmesh
    spare = np.stack(values["geom_margin"]) == OFF
    # the test of the broad phase for balls adds radii and margins: so it rejects most pairs at once
    values["geom_rbound"] = [
        np.where(own, -OFF, each) for own, each in zip(spare, values["geom_rbound"], strict=True)
    ]
    differ = {name for name, each in values.items() if any((one != each[0]).any() for one in each)}
    result = mujoco_warp.put_model(mujoco_model, batch_sizes=dict.fromkeys(differ, len(of)))
    for name in differ:
        array = getattr(result, name)
        array.assign(np.stack([values[name][number] for number in of]).astype(array.numpy().dtype))
    _join_meshes(result, models)
    pairs = result.nxn_geom_pair_filtered.numpy()
    used = (~spare[:, pairs]).all(axis=2).any(axis=0) | (result.nxn_pairid_filtered.numpy() >= 0).any(axis=1)
    for name in ("nxn_geom_pair_filtered", "nxn_pairid_filtered"):
        old = getattr(result, name)
        setattr(result, name, warp.array(old.numpy()[used], dtype=old.dtype, device=old.device))
    simple = np.min([getattr(model, _SIMPLE).numpy() for model in models], axis=0)
    getattr(result, _SIMPLE).assign(simple)
    for field in dataclasses.fields(result):
        if field.name.startswith("nmesh") or field.name == "npolygonmax":
            combine = max if field.name.endswith("max") else sum
            setattr(result, field.name, combine(getattr(model, field.name) for model in models))
    for name in _ACTING:
        setattr(result, name, any(getattr(model, name, False) for model in models))
    return result


def _join_meshes(result: Any, models: Sequence[Any]) -> None:
    """Give a model the meshes of all models."""
    import warp

    names = [field.name for field in dataclasses.fields(result) if field.name.startswith("mesh_")]
    for name in names:
        parts, grown = [], 0
        for model in models:
            part = getattr(model, name).numpy()
            parts.append(np.where(part >= 0, part + grown, part) if name in _ADDRESSES else part)
            grown += len(getattr(model, _ADDRESSES[name])) if name in _ADDRESSES else 0
        old = getattr(result, name)
        setattr(result, name, warp.array(np.concatenate(parts), dtype=old.dtype, device=old.device))


def _batched(model: Any) -> list[str]:
    """Return the names of the arrays that may differ from world to world."""
    result = []
    for field in dataclasses.fields(model):
        shape = getattr(field.type, "shape", ())
        if shape and shape[0] == "*":
            result.append(field.name)
    return result


def _plain(value: Any) -> Any:
    """Return a value with arrays in it as lists."""
    if isinstance(value, tuple):
        return tuple(_plain(item) for item in value)
    if dataclasses.is_dataclass(value):
        return {name: _plain(item) for name, item in vars(value).items()}
    return value.numpy().tolist() if hasattr(value, "numpy") else value

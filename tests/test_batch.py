"""Batches: assets of one topology share one model, and engines get what they ask for."""

import importlib
import importlib.util
import sys
import types

import mujoco
import numpy as np
import pytest
from pxr import Usd

import artgen as ag
from artgen import batch
from artgen.asset import Asset
from artgen.errors import EnvError, ExportError, ParameterError
from artgen.graph import evaluate
from artgen.topology import Topology


@pytest.fixture(scope="module")
def doors():
    """Doors with unlike latches, of which one follows its lever."""
    return [ag.generate("door", seed=seed, certify=False) for seed in (0, 1)]


@pytest.mark.parametrize("rule", ["isaaclab", "mjlab", "mujoco_warp"])
def test_padded_assets_are_one_group_and_plain_ones_several(doors, rule) -> None:
    assert len(batch.groups(doors, rule)) == 2
    assert len(batch.groups(map(Topology.of(doors).pad, doors), rule)) == 1


def test_only_rules_with_names_tell_other_names_apart(doors) -> None:
    padded = list(map(Topology.of(doors).pad, doors))
    renamed = [padded[0], Topology.of(doors[:1]).pad(doors[0]), padded[1]]
    assert [len(group) for group in batch.groups(renamed, "mujoco_warp")] == [2, 1]
    with pytest.raises(ParameterError, match=r"rule = 'newton' is not allowed: it must be one of 'isaaclab'"):
        batch.groups(doors, "newton")  # type: ignore[arg-type]


def test_assets_and_seeds_of_a_batch_are_several() -> None:
    with pytest.raises(ParameterError, match=r"groups takes several assets, not 'switch'; write a list"):
        batch.groups("switch", "mjlab")  # type: ignore[arg-type]
    with pytest.raises(ParameterError, match=r"groups takes assets, not 'switch'; generate one, such as"):
        batch.groups(["switch"], "mjlab")  # type: ignore[list-item]
    with pytest.raises(
        ParameterError, match=r"seeds = 3 is not allowed: give several seeds, such as range\(4\)"
    ):
        batch.mjlab("switch", 3)  # type: ignore[arg-type]
    with pytest.raises(ParameterError, match=r"seed = 1 is not allowed: `seeds` has the seeds of a batch"):
        batch.mjlab("switch", range(1), seed=1)
    with pytest.raises(ParameterError, match=r"specs takes several assets, not 'switch'; write a list"):
        batch.specs("switch")  # type: ignore[arg-type]
    with pytest.raises(ParameterError, match=r"touching = 'no' is not allowed: it must be True or False"):
        batch.specs([], touching="no")  # type: ignore[arg-type]


def test_models_for_mjlab_have_one_structure(doors) -> None:
    specs = batch.specs(map(Topology.of(doors).pad, doors))
    first, second = models = [spec.compile() for spec in specs]
    for name in ("nbody", "njnt", "ngeom", "nv", "neq", "nsite", "nkey"):
        assert getattr(first, name) == getattr(second, name), name
    for name in (
        "geom_type",
        "geom_bodyid",
        "jnt_type",
        "jnt_limited",
        "eq_obj1id",
        "eq_obj2id",
        "body_simple",
    ):
        assert (getattr(first, name) == getattr(second, name)).all(), name
    assert first.jnt_limited.all()
    assert first.nsite == first.nkey == 0
    followers = [sum(joint.follows is not None for joint in door.joints) for door in doors]
    assert [int(model.eq_active0.sum()) for model in models] == followers
    assert first.neq > min(followers)  # couplings of the other door are there, but hold nothing


def test_models_for_mjlab_with_a_free_base_share_all_names() -> None:
    specs = batch.mjlab("drawer", [202, 203], certify=False)
    for kind in ("bodies", "joints", "tendons", "equalities", "sites"):
        first, second = ([each.name for each in getattr(spec, kind)] for spec in specs)
        assert first == second, kind
    assert specs[0].joints[0].type == mujoco.mjtJoint.mjJNT_FREE
    assert specs[0].tendons, "one of them has a soft closing"


@pytest.mark.filterwarnings("ignore:MULTICCD is enabled")
@pytest.mark.parametrize(("category", "seeds"), [("drawer", (202, 203)), ("door", (204, 203))])
def test_worlds_of_mjlab_step_like_mujoco_after_the_event(category, seeds) -> None:
    """By itself, mjlab takes the places and limits of joints and the tendons from the first variant."""
    variants = pytest.importorskip("mjlab.entity.variants", reason="pip install mjlab")
    import torch
    from mjlab.scene import Scene, SceneCfg
    from mjlab.sim import Simulation, SimulationCfg

    specs = batch.mjlab(category, seeds, certify=False)
    made = {str(number): spec.copy for number, spec in enumerate(specs)}
    scene = Scene(SceneCfg(num_envs=2, entities={"it": variants.VariantEntityCfg(variants=made)}), "cpu")
    options = {"spec": scene.spec, "variant_info": scene.collect_variant_info(), "device": "cpu"}
    simulation = Simulation(2, SimulationCfg(njmax=300, nconmax=100), **options)
    scene.initialize(simulation.mj_model, simulation.model, simulation.data)
    event = batch.mjlab_event(specs, "it")
    worst = []
    for with_event in (False, True, True):
        simulation.reset()
        if with_event:
            event(types.SimpleNamespace(sim=simulation), None)
        models = [spec.copy() for spec in specs]
        for each in models:
            each.option.timestep = simulation.mj_model.opt.timestep
        compiled = [each.compile() for each in models]
        for each in compiled:
            each.geom_margin[each.geom_user.any(axis=1)] = -1000.0  # spare colliders
        data = [mujoco.MjData(each) for each in compiled]
        start = np.stack([each.qpos for each in data])
        simulation.data.qpos[:] = torch.as_tensor(start, dtype=torch.float32)
        simulation.data.qvel[:] = 0.0
        for _ in range(40):
            simulation.step()
            for each, state in zip(compiled, data, strict=True):
                mujoco.mj_step(each, state)
        wanted = np.stack([each.xpos for each in data])
        worst.append(np.abs(simulation.data.xpos[:].numpy() - wanted).max())
    assert worst[0] > 0.01
    assert max(worst[1:]) < 1e-5


def test_colliders_that_are_spare_in_all_assets_are_left_out(doors) -> None:
    topology = Topology.of(doors)
    models = [
        [spec.compile() for spec in batch.specs(list(map(each.pad, doors)))]
        for each in (topology, topology.with_room(0.5))
    ]
    for wanted, model in zip(*models, strict=True):
        assert model.ngeom == wanted.ngeom == topology.size[1]
        assert (model.geom_margin == wanted.geom_margin).all()
        assert np.abs(model.geom_pos - wanted.geom_pos)[wanted.geom_margin == 0.0].max() == 0.0
    used = np.any([model.geom_margin == 0.0 for model in models[1]], axis=0)
    assert used.all()


def test_a_batch_of_assets_with_fewer_colliders_has_their_topology() -> None:
    seeds, options = range(2), {"colliders": 50, "openings": 0.1}
    fewer = [ag.generate("drawer", seed, **options) for seed in seeds]
    specs = batch.mjlab("drawer", seeds, **options)
    topology = Topology.of(fewer)
    assert [spec.compile().ngeom for spec in specs] == [topology.size[1]] * 2
    assert max(sum(len(link.colliders) for link in asset.links) for asset in fewer) <= 50
    padded = ag.generate("drawer", 1, topology=topology, **options)
    assert padded.certificate.proven
    assert sum(len(link.colliders) for link in padded.links) == topology.size[1]


def test_pairs_that_cannot_touch_in_any_asset_may_be_excluded(doors) -> None:
    padded = list(map(Topology.of(doors).pad, doors))
    plain = [each.compile() for each in batch.specs(padded, touching=False)]
    fewer = [each.compile() for each in batch.specs(padded)]
    assert [model.nexclude for model in plain] == [0, 0]
    assert fewer[0].nexclude > 0
    assert (fewer[0].exclude_signature == fewer[1].exclude_signature).all()
    pairs = {
        frozenset(fewer[0].body(int(number)).name for number in divmod(int(each), 1 << 16))
        for each in fewer[0].exclude_signature
    }
    assert frozenset(("door", "frame")) in pairs
    assert frozenset(("latch", "frame")) not in pairs  # their contact holds the door


def test_couplings_in_a_batch_are_those_of_the_plain_asset(doors) -> None:
    specs = batch.specs(list(map(Topology.of(doors).pad, doors)))
    for door, model in zip(doors, (spec.compile() for spec in specs), strict=True):
        plain = door.to_mjspec(textures=0).compile()
        active = np.flatnonzero(model.eq_active0)
        for name in ("eq_data", "eq_solref", "eq_solimp"):
            assert (getattr(model, name)[active] == getattr(plain, name)).all(), name


def test_each_coupling_of_a_batch_keeps_its_impedance() -> None:
    steel, cube = ag.material("steel"), ag.box(0.1, 0.1, 0.1)
    turn = ag.Screw("turn", pitch=0.01, axis=ag.Z, limits=(0.0, 3.0))
    follower = ag.Revolute("follower", axis=ag.Z, follows=2.0 * turn)
    links = [ag.part(cube.at(x=0.2 * number), f"cube_{number}", steel) for number in range(3)]
    tree = evaluate(links[0].attach(links[1], turn).attach(links[2], follower)).value
    asset = Asset.from_tree(tree, "made", "made")
    (spec,) = batch.specs([Topology.of([asset]).pad(asset)])
    plain = asset.to_mjspec(textures=0).compile()
    assert len({tuple(each) for each in plain.eq_solimp}) == 2
    assert (spec.compile().eq_solimp == plain.eq_solimp).all()


def test_assets_of_several_structures_share_no_batch(doors) -> None:
    with pytest.raises(ParameterError, match="2 assets have 2 structures and cannot share a batch; generate"):
        batch.specs(doors)
    with pytest.raises(ParameterError, match="a batch needs at least one seed"):
        batch.mjlab("door", [])
    specs = batch.mjlab("drawer", [3], certify=False)
    joints = ag.generate("drawer", 4, topology="fixed", certify=False).joints
    assert specs[0].compile().njnt == 1 + len(joints), "the free joint of the base, too"


def test_worlds_of_mujoco_warp_step_like_mujoco() -> None:
    if importlib.util.find_spec("mujoco_warp") is None:
        with pytest.raises(ExportError, match=r"cannot be loaded .*: pip install mujoco-warp"):
            batch.mujoco_warp("drawer", [0, 1], certify=False)
        return
    import mujoco_warp

    worlds = batch.mujoco_warp("drawer", [0, 203], 3, touching=False, certify=False, nconmax=32, njmax=128)
    assert worlds.of.tolist() == [0, 1, 0]
    assert [bool(each.tendon_stiffness.any()) for each in worlds.compiled] == [False, True]
    pairs = worlds.model.nxn_geom_pair_filtered.numpy()
    own = np.stack([each.geom_margin == 0.0 for each in worlds.compiled])
    assert own[:, pairs].all(axis=2).any(axis=0).all(), "a pair that touches in no world is tested"
    assert len(pairs) < len(mujoco_warp.put_model(worlds.compiled[0]).nxn_geom_pair_filtered)
    data = [mujoco.MjData(worlds.compiled[number]) for number in worlds.of]
    force = np.zeros((3, worlds.compiled[0].nv))
    force[:, 0] = 40.0
    worlds.data.qfrc_applied.assign(force.astype(np.float32))
    for _ in range(20):
        mujoco_warp.step(worlds.model, worlds.data)
        for number, each in enumerate(data):
            each.qfrc_applied[:] = force[number]
            mujoco.mj_step(worlds.compiled[worlds.of[number]], each)
    wanted = np.stack([each.qpos for each in data])
    assert np.abs(worlds.data.qpos.numpy() - wanted).max() < 1e-5
    assert np.abs(wanted[:, 0]).min() > 1e-3


def test_reset_worlds_have_their_own_couplings() -> None:
    engine = pytest.importorskip("mujoco_warp", reason="pip install mujoco-warp")
    worlds = batch.mujoco_warp("door", [0, 1], certify=False)
    active = np.stack([each.eq_active0 for each in worlds.compiled])
    assert (active[0] != active[1]).any()
    worlds.data.qvel.assign(np.ones_like(worlds.data.qvel.numpy()))
    engine.reset_data(worlds.model, worlds.data)
    assert (worlds.data.eq_active.numpy() == active[0]).all(), "those of the first door"
    worlds.reset()
    np.testing.assert_array_equal(worlds.data.eq_active.numpy(), active)
    assert not worlds.data.qvel.numpy().any()


def test_usd_files_of_a_batch_have_equal_bodies_joints_and_colliders(tmp_path) -> None:
    prims = []
    for path in batch.usd("drawer", [0, 1], tmp_path, textures=0, certify=False):
        stage = Usd.Stage.Open(str(path))
        root = stage.GetDefaultPrim().GetPath()
        prims.append(
            {
                name: (prim.GetTypeName(), prim.GetAppliedSchemas())
                for prim in stage.Traverse()
                if not {"visuals", "looks", "grasps", "pushes"}
                & set((name := str(prim.GetPath().MakeRelativePath(root))).split("/"))
            }
        )
    first, second = prims
    assert first == second
    kinds = {schema for _, schemas in first.values() for schema in schemas}
    assert {"PhysicsRigidBodyAPI", "PhysicsCollisionAPI"} <= kinds
    assert sum(kind == "PhysicsPrismaticJoint" for kind, _ in first.values()) == 15


def test_a_spawner_of_isaac_lab_gives_the_files_in_turn(tmp_path, monkeypatch) -> None:
    if importlib.util.find_spec("isaaclab") is None:
        with pytest.raises(ExportError, match=r"cannot be loaded .*: pip install 'isaaclab"):
            batch.isaaclab("cabinet", [0], tmp_path)
        assert not list(tmp_path.iterdir())  # it is said before anything is made
    made = types.ModuleType("isaaclab.sim")
    made.MultiUsdFileCfg = types.SimpleNamespace  # type: ignore[attr-defined]
    monkeypatch.setitem(sys.modules, "isaaclab", types.ModuleType("isaaclab"))
    monkeypatch.setitem(sys.modules, "isaaclab.sim", made)
    found = batch.isaaclab("cabinet", [1, 0], tmp_path, textures=0, certify=False)
    assert found.usd_path == [str(tmp_path / name / f"{name}.usda") for name in ("cabinet_1", "cabinet_0")]
    assert found.random_choice is False


@pytest.fixture
def engine(monkeypatch):
    """A stand-in for Genesis, whose morphs keep their options."""
    made = types.ModuleType("genesis")
    made.morphs = types.SimpleNamespace(MJCF=types.SimpleNamespace)  # type: ignore[attr-defined]
    monkeypatch.setitem(sys.modules, "genesis", made)


@pytest.mark.usefixtures("engine")
def test_morphs_of_genesis_share_links_and_joints_and_have_no_spare_colliders(tmp_path) -> None:
    morphs = batch.genesis("drawer", [0, 1], tmp_path, textures=0, certify=False)
    assert [each.default_armature for each in morphs] == [0.0, 0.0]
    models = [mujoco.MjModel.from_xml_path(each.file) for each in morphs]
    names = [[model.joint(number).name for number in range(model.njnt)] for model in models]
    assert names[0] == names[1]
    assert [model.nbody for model in models] == [models[0].nbody] * 2
    for seed, model in enumerate(models):
        plain = ag.generate("drawer", seed, certify=False)
        collides = model.geom_contype != 0
        assert collides.sum() == sum(len(link.colliders) for link in plain.links)
        assert model.geom_margin.max() == model.geom_margin.min() == 0.0


@pytest.mark.usefixtures("engine")
def test_genesis_refuses_what_it_would_simulate_wrongly(tmp_path) -> None:
    with pytest.raises(ParameterError, match="do not have the same links and joints"):
        batch.genesis("drawer", [0, 1], tmp_path, topology="own", certify=False)
    with pytest.raises(ParameterError, match=r"joint '\w+' follows another law in 'door_1' than in 'door_0'"):
        batch.genesis("door", [0, 1], tmp_path, certify=False)
    assert not list(tmp_path.iterdir())


def test_a_batch_of_genesis_needs_genesis(tmp_path, monkeypatch) -> None:
    monkeypatch.setitem(sys.modules, "genesis", None)
    with pytest.raises(ExportError, match=r"cannot be loaded .*: pip install genesis-world torch"):
        batch.genesis("drawer", [0], tmp_path)


def test_missing_mjx_and_playground_are_errors(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setitem(sys.modules, "jax", None)
    drawers = [ag.generate("drawer", seed, topology="fixed", certify=False) for seed in range(1)]
    with pytest.raises(ExportError, match=r"cannot be loaded .*: pip install mujoco-mjx"):
        batch.mjx_worlds(drawers)
    monkeypatch.delitem(sys.modules, "artgen.envs.playground", raising=False)
    with pytest.raises(EnvError, match=r"MuJoCo Playground cannot be loaded .*: pip install playground"):
        importlib.import_module("artgen.envs.playground")

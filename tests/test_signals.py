"""Outputs: their signals, the controller that computes them, and their use in files, rooms and checks."""

from dataclasses import replace

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

import artgen as ag
from artgen import signals
from artgen.asset import AssetOutput, AssetSignal
from artgen.asset.controller import Controller
from artgen.asset.valid_states import ValidStates
from artgen.errors import ArtgenError, AssetError
from artgen.scene import Scene
from artgen.validate.outputs import check_outputs
from support.bodies import asset_of
from support.exports import edit_json

FORMATS = {"urdf": "urdf", "mjcf": "xml", "usd": "usda", "glb": "glb", "sdf": "sdf"}
STEEL = ag.material("steel")
LENS = ag.material("black_abs").with_(name="lens")

KEY = ag.Prismatic("key", axis=ag.Y, limits=(0, 0.003), spring=ag.Spring(preload=1.0, force=3.0))
STOP = ag.Prismatic("stop", axis=ag.Y, limits=(0, 0.003), spring=ag.Spring(preload=1.0, force=3.0))
KNOB = ag.Revolute("knob", axis=ag.Y, limits=(0, 3.0), friction=0.05)
DOOR = ag.Revolute("door", axis=ag.Z, pivot=(0.2, 0, 0), limits=(0, 1.5), friction=0.05)
FAN = ag.Revolute("fan", axis=ag.Z, driven="a motor", friction=0.001, velocity=30.0)


def cube(name, x):
    return ag.part(ag.box(0.04, 0.04, 0.04).at(x), name, STEEL)


def panel():
    """A box with a lens, two keys, a knob, a door and a fan, all far from each other."""
    body = ag.weld(cube("case", 0), ag.part(ag.box(0.02, 0.02, 0.02).at(0, 0, 0.03), "lens", LENS))
    for number, (name, joint) in enumerate(
        {"key": KEY, "stop": STOP, "knob": KNOB, "door": DOOR, "fan": FAN}.items(), start=1
    ):
        body = body.attach(cube(name, 0.1 * number), joint)
    return body


def traced(signal, *rows, seconds=1.0):
    """Return the values of a signal of the panel for positions of its joints, one after the other."""
    asset = asset_of(panel().output("out", signal, kind="light"))
    controller = asset.controller()
    return [
        float(controller.step([row.get(name, 0.0) for name in asset.dof_names], seconds)["out"][0])
        for row in rows
    ]


DOWN, UP = {"key": 0.003}, {"key": 0.0}


def test_a_level_is_the_share_of_the_way():
    assert traced(signals.level(KNOB), {}, {"knob": 0.75}, {"knob": 3.0}) == [0.0, 0.25, 1.0]
    turned = signals.level("knob", ends=(3.0, 1.0))
    assert traced(turned, {"knob": 3.0}, {"knob": 2.0}, {}) == [0.0, 0.5, 1.0]


def test_a_pressed_key_has_hysteresis():
    rows = [{"key": 0.001 * each} for each in (0, 1.5, 2.1, 1.5, 0.9, 1.5)]
    assert traced(signals.pressed(KEY), *rows) == [0, 0, 1, 1, 0, 0]


def test_a_toggle_changes_with_each_press_and_is_off_while_it_is_held_off():
    on = signals.toggle(signals.pressed(KEY), unless=DOOR > 0.1)
    opened = {"door": 1.0}
    rows = (UP, DOWN, DOWN, UP, DOWN, UP, DOWN, UP | opened, DOWN | opened, UP, DOWN)
    assert traced(on, *rows) == [0, 1, 1, 1, 0, 0, 1, 0, 0, 0, 1]


def test_a_timer_runs_from_the_last_press_and_ends_early():
    runs = signals.timer(signals.pressed(KEY), 2.5, unless=signals.pressed(STOP))
    assert traced(runs, UP, DOWN, UP, UP, UP, DOWN, UP, DOWN, UP, UP, UP) == [
        0, 1, 1, 1, 0, 1, 1, 1, 1, 1, 0
    ]  # fmt: skip
    assert traced(runs, UP, DOWN, {"stop": 0.003}, UP) == [0, 1, 0, 0]


def test_latest_is_the_value_of_the_key_that_was_pressed_last():
    speed = signals.latest([signals.pressed(KEY), signals.pressed(STOP), KNOB > 1.0], [0.4, 0.0, 1.0])
    rows = (UP, DOWN, UP, {"knob": 2.0}, {"knob": 2.0, **DOWN}, {"stop": 0.003})
    assert traced(speed, *rows) == [0, 0.4, 0.4, 1.0, 0.4, 0.0]


def test_signals_combine_as_the_smaller_the_greater_the_rest_and_a_share():
    level, held = signals.level(KNOB), signals.pressed(KEY)
    rows = ({"knob": 0.75}, {"knob": 0.75, **DOWN})
    assert traced(level & held, *rows) == [0.0, 0.25]
    assert traced(level | held, *rows) == [0.25, 1.0]
    assert traced(~level, *rows) == [0.75, 0.75]
    assert traced(0.5 * (level * 0.5), *rows) == [0.0625, 0.0625]
    assert traced((DOOR > 0.1) | held, {}, {"door": 1.0}, DOWN) == [0, 1, 1]
    assert traced(held & (DOOR < 0.1), DOWN, {"door": 1.0, **DOWN}) == [1, 0]


def test_nothing_rises_in_the_first_step_and_after_a_reset():
    asset = asset_of(panel().output("on", signals.toggle(signals.pressed(KEY)), kind="light"))
    controller, pressed = asset.controller(2), np.zeros((2, len(asset.dof_names)))
    pressed[:, asset.dof_names.index("key")] = 0.003
    assert controller.step(pressed, 0.1)["on"].tolist() == [0, 0]
    controller.step(0 * pressed, 0.1)
    assert controller.step(pressed, 0.1)["on"].tolist() == [1, 1]
    controller.reset([False, True])
    assert controller.step(pressed, 0.1)["on"].tolist() == [1, 0]
    controller.reset()
    assert controller.step(pressed, 0.1)["on"].tolist() == [0, 0]


def machine():
    off = signals.pressed(STOP) | (DOOR > 0.1)
    runs = signals.timer(signals.pressed(KEY), 3.0, unless=off)
    body = panel().output("lamp", runs | (DOOR > 0.1), kind="light", material=LENS)
    speed = signals.latest([signals.pressed(KEY), signals.level(KNOB)], [0.5, 1.0], unless=off)
    body = body.output("motor", runs & speed, kind="motor", moves=FAN, speed=20.0)
    return body.output("heat", 0.5 * (runs & signals.level(KNOB)), kind="heat")


MACHINE = asset_of(machine())
WALKS = st.lists(st.lists(st.integers(0, 2), min_size=5, max_size=5), min_size=1, max_size=25)


def states_of(walk, asset=MACHINE):
    """Return positions of an asset in the middle or at the ends of its ranges, shape (steps, dof)."""
    low, high = np.maximum(asset.valid_states.lower, -1.0), np.minimum(asset.valid_states.upper, 3.0)
    return low + np.array(walk) / 2 * (high - low)


@given(WALKS)
def test_worlds_do_not_meet(walk):
    walks = [walk, walk[::-1], [[0] * 5] * len(walk)]
    together = MACHINE.controller(3)
    alone = [MACHINE.controller() for _ in walks]
    for rows in zip(*map(states_of, walks), strict=True):
        found = together.step(rows, 0.7)
        for number, (controller, row) in enumerate(zip(alone, rows, strict=True)):
            values = controller.step(row, 0.7)
            assert {name: each[0] for name, each in values.items()} == {
                name: each[number] for name, each in found.items()
            }


@given(WALKS)
def test_values_are_those_of_a_machine_that_is_written_by_hand(walk):
    """The same rules as plain statements about one machine."""
    left, speed, before, controller = 0.0, 0.0, None, MACHINE.controller()
    held = {"key": False, "stop": False}
    for row in states_of(walk):
        q = dict(zip(MACHINE.dof_names, row, strict=True))
        held = {name: q[name] / 0.003 > (1 / 3 if was else 2 / 3) for name, was in held.items()}
        level = q["knob"] / 3.0
        seen = (held["key"], level > 0.5)
        rises = [
            now and before is not None and not then for now, then in zip(seen, before or seen, strict=True)
        ]
        off = held["stop"] or q["door"] > 0.1
        left = 0.0 if off else 3.0 if rises[0] else max(left - 0.7, 0.0)
        speed = 1.0 if rises[1] else 0.5 if rises[0] else speed
        speed, before = 0.0 if off else speed, seen
        runs = float(left > 0.0)
        found = {name: value[0] for name, value in controller.step(row, 0.7).items()}
        expected = {"lamp": max(runs, float(q["door"] > 0.1)), "motor": min(runs, speed)}
        assert found == pytest.approx(expected | {"heat": 0.5 * min(runs, level)})


@pytest.fixture(scope="module")
def export(tmp_path_factory):
    return MACHINE.export(tmp_path_factory.mktemp("signals") / "machine", formats=tuple(FORMATS), textures=0)


@pytest.mark.parametrize("form", FORMATS)
def test_every_file_carries_the_outputs(export, form):
    controller = Controller(ValidStates.read(export / f"{MACHINE.name}.{FORMATS[form]}"), worlds=1)
    assert set(controller.outputs) == {"lamp", "motor", "heat"}
    assert controller.outputs["motor"]["joint"] == "fan"
    assert controller.outputs["motor"]["speed"] == 20.0
    assert controller.outputs["lamp"]["material"] == "lens"
    own, random = MACHINE.controller(), np.random.default_rng(1)
    for row in states_of(random.integers(0, 3, (40, 5))):
        assert controller.step(row, 0.7) == own.step(row, 0.7)


def test_an_asset_that_was_read_has_the_same_outputs(export):
    loaded = ag.load(export)
    assert loaded.outputs == MACHINE.rounded().outputs
    off = "off while stop pressed or door > 0.1"
    assert str(loaded.outputs[1]) == (
        f"motor (motor): (3 s after key pressed, {off}) and "
        f"(0.5 after key pressed, 1 after level of knob, {off})"
    )


def test_an_asset_with_outputs_of_unknown_joints_is_refused(export, tmp_path):
    folder = MACHINE.export(tmp_path / "changed", formats=("urdf",), textures=0)
    edit_json(
        folder / "asset.json",
        lambda data: data["outputs"][0]["signal"]["terms"][1]["condition"].update(joint="gate"),
    )
    with pytest.raises(AssetError, match=r"output 'lamp' reads 'gate', which is not a joint of this asset"):
        ag.load(folder)


def test_copies_have_outputs_of_their_own():
    tap = cube("tap", 0.0).attach(cube("lever", 0.1), KNOB).output("water", signals.level(KNOB), kind="flow")
    pair = ag.weld(cube("wall", 0.5), tap.suffixed("_hot"), tap.at(0, 0.3).suffixed("_cold"))
    assert {each.name: each.joints() for each in asset_of(pair).outputs} == {
        "water_hot": ("knob_hot",), "water_cold": ("knob_cold",)
    }  # fmt: skip
    plate = cube("plate", 0.5)
    copies = plate.repeat(
        tap, ag.Prismatic("slide", axis=ag.X, limits=(0, 0.01)), at=[(0, 0, 0), (0, 0.3, 0)]
    )
    assert [each.name for each in asset_of(copies).outputs] == ["water_0", "water_1"]
    both = cube("plate", 0.0).attach_pair(tap.at(0.3), ag.Prismatic("slide", axis=ag.X, limits=(0, 0.01)))
    assert {each.name for each in asset_of(both).outputs} == {"water_left", "water_right"}


def test_a_lamp_in_a_room_shines_alone():
    room = Scene("room", width=2.4, depth=2.0)
    for at in (0.6, 1.8):
        room.against("back", "lamp", at=at, style="mushroom")
    made = room.build()
    names = [each.name for each in made.outputs]
    assert len(set(names)) == 2
    assert all(name.endswith("_light") for name in names)
    assert len({each.material for each in made.outputs}) == 2
    lit = made.with_outputs({names[0]: 1.0})
    shining = {link.name for link in lit.links for each in link.surfaces if max(each.material.emission) > 0.5}
    assert shining
    assert all(name.startswith(names[0].removesuffix("light")) for name in shining)


def test_padded_assets_keep_their_outputs():
    plain = ag.generate("lamp", seed=9, certify=False)
    padded = ag.generate("lamp", seed=9, certify=False, topology="fixed")
    assert [each.name for each in padded.outputs] == [each.name for each in plain.outputs]
    for output in padded.outputs:
        assert [padded.originals[name] for name in output.joints()] == [
            name for each in plain.outputs if each.name == output.name for name in each.joints()
        ]
    assert check_outputs(padded).findings == ()


def test_outputs_shine_in_pictures_and_files():
    lit = MACHINE.with_outputs({"lamp": 0.5})
    (lens,) = [each for each in lit.materials if each.name == "lens"]
    assert lens.emission == pytest.approx((0.5, 0.42, 0.31))
    assert {each.name: each for each in lit.materials if each.name != "lens"} == {
        each.name: each for each in MACHINE.materials if each.name != "lens"
    }
    dark, bright = (each.render(size=128).color.astype(float) for each in (MACHINE, lit))
    assert (bright - dark).max() > 60


@pytest.mark.parametrize(
    ("values", "message"),
    [
        ({"lamb": 1.0}, "output 'lamb': asset 'machine' has no such output. Did you mean 'lamp'?"),
        ({"heat": 1.0}, "output 'heat': asset 'machine' has no material that shines"),
        ({"lamp": 2.0}, "output 'lamp' cannot be 2.0; give a number from 0 to 1"),
        ({"lamp": True}, "output 'lamp' cannot be True; give a number from 0 to 1"),
    ],
)
def test_wrong_outputs_of_a_picture(values, message):
    asset = replace(MACHINE, name="machine")
    with pytest.raises(AssetError) as caught:
        asset.with_outputs(values)
    assert message in str(caught.value)


@pytest.mark.parametrize(
    ("made", "message"),
    [
        (lambda: panel().output("x", signals.level("nob"), kind="flow"), "reads 'nob', which is not a joint"),
        (lambda: panel().output("x", signals.level(FAN), kind="flow"), "joint 'fan', which has no range"),
        (lambda: machine().output("lamp", KNOB > 1, kind="light"), "the output name 'lamp' is used twice"),
        (lambda: panel().output("a b", KNOB > 1, kind="light"), "output name 'a b' is not allowed"),
        (
            lambda: panel().output("x", KNOB > 1, kind="light", color=(1, 1, 1)),
            "a material shines in a color",
        ),
        (lambda: panel().output("x", KNOB > 1, kind="light", moves=FAN, speed=1.0), "a motor moves a joint"),
        (lambda: panel().output("x", KNOB > 1, kind="motor"), "a motor moves a joint at a speed"),
        (lambda: panel().output("x", KNOB > 1, kind="lamp"), "lamp"),
        (lambda: panel().output("x", KNOB, kind="light"), "output(..., signal=...)"),
        (lambda: panel().output("x", signals.level(3), kind="light"), "a signal reads a Joint, or the name"),
        (lambda: panel().output("x", signals.timer(KNOB > 1, 0.0), kind="heat"), "a timer of 0 s never runs"),
        (lambda: panel().output("x", 2.0 * signals.level(KNOB), kind="heat"), "it must be from 0 to 1"),
        (
            lambda: panel().output("x", signals.latest([KNOB > 1], []), kind="heat"),
            "latest has 1 signals and 0 values",
        ),
        (lambda: panel().output("x", signals.latest([KNOB > 1], [3]), kind="heat"), "a value of latest is 3"),
        (lambda: panel().output("x", signals.level(KNOB, (1.0, 1.0)), kind="heat"), "ends of joint 'knob'"),
    ],
)
def test_wrong_outputs_of_an_author(made, message):
    with pytest.raises(ArtgenError) as caught:
        asset_of(made())
    assert message in str(caught.value)


@pytest.mark.parametrize(
    ("data", "message"),
    [
        ({"kind": "level"}, "a signal of the kind 'level' has no joint"),
        ({"kind": "timer", "terms": [{"kind": "level", "joint": "a"}]}, "of the kind 'timer' has no seconds"),
        ({"kind": "toggle", "terms": []}, "a signal of the kind 'toggle' cannot have 0 terms"),
        ({"kind": "not", "terms": [{"kind": "level", "joint": "a"}] * 2}, "'not' cannot have 2 terms"),
        (
            {"kind": "latest", "terms": [{"kind": "level", "joint": "a"}], "values": []},
            "1 terms and 0 values",
        ),
        ({"kind": "glow"}, "kind is 'glow', but it must be one of"),
    ],
)
def test_signals_of_files_are_checked(data, message):
    with pytest.raises(AssetError) as caught:
        AssetSignal.from_data(data)
    assert message in str(caught.value)


@pytest.mark.parametrize("worlds", [0, -1, 1.5, "2", True])
def test_a_wrong_number_of_worlds_is_refused(worlds):
    with pytest.raises(AssetError, match="number of worlds must be a whole number of at least 1"):
        MACHINE.controller(worlds)


def test_positions_of_another_shape_are_refused():
    controller = MACHINE.controller(3)
    with pytest.raises(
        ValueError, match=r"positions have the shape \(3, 5\), by key, stop, .*; got \(4, 5\)"
    ):
        controller.step(np.zeros((4, 5)), 0.1)


def test_lamps_that_low_detail_leaves_out_are_no_faults():
    toaster = ag.generate("toaster", seed=0, detail="low", certify=False)
    assert toaster.outputs[0].material not in {each.name for each in toaster.materials}
    assert faults(toaster) == []


def test_locked_controls_of_independent_limits_are_no_faults():
    cooktop = ag.generate("cooktop", seed=0, certify=False)
    assert faults(cooktop) == faults(cooktop.with_limits("independent")) == []


def faults(asset):
    return [each.message for each in check_outputs(asset).findings]


def test_the_check_finds_outputs_that_do_nothing():
    assert faults(MACHINE) == []
    assert check_outputs(MACHINE).detail == "3 outputs of 4 controls"
    dead = signals.toggle(signals.pressed(KEY), unless=DOOR > -1.0)
    assert faults(asset_of(panel().output("dead", dead, kind="light"))) == [
        "output 'dead' stays 0, whatever its controls key, door do"
    ]
    dark = panel().output("dark", KNOB > 1, kind="light", material=ag.material("oak"))
    assert faults(asset_of(dark)) == ["output 'dark' lights up the material 'oak', which no part has"]
    wheel = ag.Revolute("wheel", axis=ag.Z, follows=2.0 * FAN)
    geared = panel().attach(cube("wheel", 0.7), wheel)
    held = geared.output("held", KNOB > 1, kind="motor", moves=wheel, speed=1.0)
    assert faults(asset_of(held)) == ["output 'held' moves joint 'wheel', which is locked or follows another"]
    fast = panel().output("fast", KNOB > 1, kind="motor", moves=FAN, speed=-40.0)
    assert faults(asset_of(fast)) == ["output 'fast' moves joint 'fan' at -40, beyond its velocity of 30"]


def test_records_come_back_from_their_data():
    for output in MACHINE.outputs:
        assert AssetOutput.from_data(output.to_data()) == output
        assert AssetSignal.from_data(output.signal.to_data()) == output.signal

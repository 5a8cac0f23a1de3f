"""The manipulation tasks: category, joints to move, contacts and time limit of each; and their assets."""

import copy
from collections import OrderedDict
from collections.abc import Hashable, Mapping, Sequence
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

import numpy as np

from artgen._arrays import cached_property
from artgen.asset import Asset
from artgen.catalog import generate
from artgen.dataset import Dataset
from artgen.envs.motion import FAR_BACK, Stage, Target
from artgen.envs.placing import place
from artgen.envs.scene import TaskScene, compiled
from artgen.envs.stages import (
    AJAR,
    Chooser,
    by_lever,
    by_output,
    check_positive,
    one_joint,
    open_and_close,
    open_dishwasher,
    third_drawer,
)
from artgen.errors import EnvError, ParameterError, nearest
from artgen.sampling import by, choice
from artgen.scene import ROOMS


@dataclass(frozen=True, eq=False)
class Task:
    """A manipulation task with the assets of a category.

    Attributes:
        name: Name, such as `PushDoor`; its environment is registered as `artgen/PushDoor-v0`.
        category: Name of the category, or of a room, such as `kitchen`.
        seconds: Time limit [s].
        doc: Description, in one sentence.
        choose: Yields the possible stages of the task on an asset.
        overrides: Values or distributions of parameters for assets that have the part.
        raised: Whether the asset stands on a table next to the robot.
    """

    name: str
    category: str
    seconds: float
    doc: str
    choose: Chooser
    overrides: Mapping[str, Any] = field(default_factory=dict)
    raised: bool = False

    def __post_init__(self) -> None:
        check_positive("seconds", self.seconds)
        if not callable(self.choose):
            raise ParameterError(
                f"choose of {self.name} is a function, such as one_joint(...), got {self.choose!r}"
            )

    def generate(self, seed: int) -> Asset:
        """Generate an asset that is suitable for the task, without a certificate; a room of light assets."""
        if self.category in ROOMS:
            return ROOMS[self.category].generate(seed, detail="low", **self.overrides)
        return generate(self.category, seed, certify=False, **self.overrides)

    def target(self, asset: Asset, rng: np.random.Generator) -> Target:
        """Return the stages of the task on an asset, and a place of a Panda from which it reaches them.

        Args:
            asset: An asset of any category with the required parts.
            rng: Draws the part, the place of the robot, and the pose of its hand.

        Raises:
            EnvError: The asset lacks the part, or there is no place from which the robot reaches it.
        """
        tried = 0
        raised = self.raised or asset.parameters.get("kind") == "wall"  # a wall has room below the asset
        for stages in self.choose(asset, rng):
            tried += 1
            if isinstance(stages, Stage):
                raise EnvError(
                    f"choose of {self.name} yields a Stage; it must yield tuples of stages: (stage,)"
                )
            found = place(asset, stages, rng, raised=raised)
            if found is not None:
                return found
        if not tried:
            raise EnvError(
                f"asset {asset.name!r} of category {asset.category!r} has nothing for {self.name}: "
                f"{self.doc} Take assets that the task's generate(seed) draws"
            )
        raise EnvError(
            f"{self.name}: there is no place from which a Panda reaches the parts of asset {asset.name!r} "
            f"({tried} choices tried); leave the asset out, or make it with another seed"
        )


_DOCS = {
    "PushDoor": "Turn the lever by at least 0.3 rad to free the latch, then push the leaf open by 0.3 rad.",
    "PushToasterLever": "Push a lever of the toaster down.",
    "OpenFridge": "Open a door of the refrigerator to 9 degrees and more.",
    "OpenDrawer": "Pull a drawer open by half its way.",
    "OpenDishwasher": "Open the door of the dishwasher, then pull a rack out by half its way.",
    "PressMicrowaveButton": "Press a key or button of the microwave oven.",
    "TurnFaucet": "Open the faucet by four fifths of the range of its handle.",
    "OpenTrashcan": "Press the pedal that lifts the lid.",
    "OpenMicrowave": "Open the door of the microwave oven by 0.4 rad.",
    "OpenCabinet": "Open a door of the cabinet by 0.4 rad.",
    "OpenOven": "Open the door of the oven by 0.5 rad.",
    "OpenToasterOven": "Open the door of the toaster oven by 0.5 rad.",
    "OpenAirFryer": "Open a drawer of the air fryer by half of its length.",
    "OpenLaptop": "Open the screen of the laptop by 1 rad.",
    "OpenBox": "Open the lid of the mailer or pizza box by 0.8 rad.",
    "OpenKettle": "Open the lid of the kettle by 0.8 rad.",
    "OpenBottle": "Flip the cap of the bottle open by 0.8 rad.",
    "OpenDesk": "Pull a drawer of the desk or bedside table open by half its way.",
    "OpenToolCart": "Pull a drawer of the tool cart open by half its way.",
    "OpenDetergentDrawer": "Pull the detergent drawer of the washing machine out by half its way.",
    "OpenWindow": "Turn the handle of a window, then open its sash by 0.2 rad.",
    "OpenSafe": "Turn the key or the dial of the safe, then its handle, then open the door by 0.3 rad.",
    "LiftToiletLid": "Lift the lid of the toilet by 0.8 rad.",
    "LiftTrashcanLid": "Lift the lid of the bin by 0.8 rad.",
    "LiftPailLid": "Lift the lid off the pail, by 0.06 m.",
    "LiftBail": "Swing the bail of the bucket up by 1.4 rad.",
    "LiftBlenderLid": "Lift the lid off the jug of the blender, by 0.06 m.",
    "LiftBlenderJug": "Turn the jug of the blender out of its lock, then lift it by 0.05 m.",
    "LiftCoffeeLever": "Lift the lever of the capsule machine by three fifths of its range.",
    "TurnStoveKnob": "Turn a knob of the cooktop by 0.8 rad.",
    "TurnMixerKnob": "Turn the speed knob of the stand mixer by 1 rad.",
    "TurnValve": "Open the valve by four fifths of the range of its lever.",
    "TurnSpout": "Turn the spout over the sink by two fifths of its range.",
    "TurnHandle": "Turn a door handle by four fifths of its range.",
    "TurnDimmer": "Turn the knob of the dimmer by 1 rad.",
    "FlipSwitch": "Flip a rocker of the light switch.",
    "FlushToilet": "Press a flush button of the toilet.",
    "PressCoffeeButton": "Press a button of the coffee machine.",
    "PressLampButton": "Press the button of the lamp.",
    "PressStapler": "Press the arm of the stapler down.",
    "PumpSoap": "Press the nozzle of the soap dispenser down.",
    "OpenClockDoor": "Open the glazed door of the clock by 0.5 rad.",
    "OpenFlipPhone": "Open the lid of the flip phone by 0.8 rad.",
    "LiftHandset": "Lift the handset off the telephone, by 0.06 m.",
    "PressRemoteButton": "Press a button of the remote control.",
    "PressSnooze": "Press the bar on top of the alarm clock.",
    "PressShutter": "Press the button of the camera's shutter.",
    "OpenShower": "Open the door of the shower by 0.5 rad.",
    "OpenRiceCooker": "Press the button that lets the lid of the rice cooker spring open.",
    "LiftCookerLid": "Lift the lid off the slow cooker, by 0.06 m.",
    "PullVisor": "Pull the visor of the range hood out by half its way.",
    "SqueezeClip": "Press the lever of the clothespin or clip, so that its jaws open.",
    "TurnOnLamp": "Switch the lamp on.",
    "TurnOnBurner": "Turn a knob of the cooktop until its burner heats, at three tenths or more.",
    "TurnOnTap": "Open the faucet until water runs, three tenths of the most or more.",
    "TurnOnOven": "Turn the knobs of the oven, for its function and its heat, until it heats.",
    "TurnOnAirFryer": "Turn the knobs of the air fryer until it heats.",
    "TurnOnFan": "Switch the fan on.",
    "TurnOnHood": "Switch the fan of the range hood on.",
    "TurnOnSwitch": "Move a light switch or dimmer until its lamp shines.",
    "StartMicrowave": "Press a key of the microwave oven that makes it heat.",
    "StartCoffee": "Press the buttons of the coffee machine, the main switch first, until coffee flows.",
    "StartDishwasher": "Press the button that starts the dishwasher.",
    "StartWasher": "Press the button that starts the drum of the washing machine or dryer.",
    "StartBlender": "Press a button or turn the knob of the blender until its blades turn.",
    "StartMixer": "Turn the knob of the stand mixer until it runs at three tenths of its speed or more.",
    "StartCopy": "Press the button of the printer that copies a page.",
    "StartRice": "Press the button or lever of the cooker that makes it cook.",
    "BoilWater": "Press the switch of the kettle.",
    "LightGrill": "Turn a knob of the gas grill until its burner heats, at three tenths or more.",
    "UnlockSafe": "Type on the keypad of the safe and press its enter key.",
}
push_door = by_lever("handle", 0.3, 0.34, pushes=True)
_press = one_joint("", "push", "prismatic", 0.8, back=FAR_BACK)
_tip = one_joint("", "push", "revolute", 0.8, back=FAR_BACK)
_lever = one_joint("lever", "grasp", "revolute", 0.6)
_off = one_joint("lid", "grasp", "prismatic", at_least=0.06)
_pull = one_joint("drawer", "grasp", "prismatic", 0.5)
_door = one_joint("door", "grasp", "revolute", at_least=0.5)
_lid = one_joint("lid", "grasp", "revolute", at_least=0.8)


def _knob(part: str, share: float = 0.0, *, at_least: float = 0.0) -> Chooser:
    return one_joint(part, "grasp", "revolute", share, at_least=at_least, back=FAR_BACK)


_SHUTTER = one_joint("shutter", "push", "prismatic", 0.8, back=FAR_BACK)
_KEYS, _GRIPS = {"controls": choice("keypad", "mixed")}, {"handle": choice("bar", "pocket")}
_BAILS = {"style": choice("household", "builder", "zinc", "wood")}
_FLAT = {"burner": choice("radiant", "coil", "induction")}
_LOCKED = {
    "style": choice("home", "fire"),
    "lock": choice("key", "dial"),
    "handle": by("style", home="knob", fire="spokes"),
}
_HUNG = {"style": choice("chimney", "inclined", "island")}
_LATCHED, _VISOR = {"style": "hinged"}, {"style": "telescopic"}
_Row = tuple[str, float, Chooser, Mapping[str, Any], bool]
_ROWS: dict[str, _Row] = {  # category, time limit [s], stages, overrides, raised
    "PushDoor": ("door", 10.0, push_door, {"opener": "lever", "layout": "single"}, False),
    "PushToasterLever": ("toaster", 8.0, one_joint("lever", "push", "prismatic", 0.9), {}, False),
    "OpenFridge": ("refrigerator", 10.0, one_joint("door", "grasp", "revolute", at_least=0.16), {}, False),
    "OpenDrawer": ("drawer", 10.0, _pull, {}, False),
    "OpenDishwasher": ("dishwasher", 30.0, open_dishwasher, {"racks": choice(2, 3)}, False),
    "PressMicrowaveButton": ("microwave", 5.0, _press, _KEYS, True),
    "TurnFaucet": ("faucet", 6.0, _knob("handle", 0.8), {}, False),
    "OpenTrashcan": ("trashcan", 8.0, one_joint("pedal", "push", "revolute", 0.8), {"style": "pedal"}, False),
    "OpenMicrowave": ("microwave", 10.0, one_joint("door", "grasp", "revolute", at_least=0.4), _GRIPS, True),
    "OpenCabinet": ("cabinet", 10.0, one_joint("door", "grasp", "revolute", at_least=0.4), {}, False),
    "OpenOven": ("oven", 12.0, _door, {}, False),
    "OpenToasterOven": ("toaster_oven", 10.0, _door, {"style": "oven"}, True),
    "OpenAirFryer": ("toaster_oven", 10.0, _pull, {"style": choice("fryer", "dual")}, True),
    "OpenLaptop": ("laptop", 10.0, one_joint("screen", "grasp", "revolute", at_least=1.0), {}, True),
    "OpenBox": ("box", 10.0, _lid, {"style": choice("mailer", "pizza")}, True),
    "OpenKettle": ("kettle", 8.0, _lid, {"style": "spout"}, True),
    "OpenBottle": ("bottle", 8.0, _lid, {"style": "flip"}, True),
    "OpenDesk": ("table", 10.0, _pull, {"style": choice("desk", "side")}, False),
    "OpenToolCart": ("cart", 10.0, _pull, {"style": "tool"}, False),
    "OpenDetergentDrawer": ("washing_machine", 10.0, _pull, {"kind": "front"}, False),
    "OpenWindow": ("window", 12.0, by_lever("", 0.2, 0.24), {"style": choice("casement", "awning")}, False),
    "OpenSafe": ("safe", 20.0, by_lever("", 0.3, 0.34), _LOCKED, False),
    "LiftToiletLid": ("toilet", 12.0, _lid, {}, False),
    "LiftTrashcanLid": ("trashcan", 10.0, _lid, {"style": "lift"}, False),
    "LiftPailLid": ("bucket", 8.0, _off, {"style": "pail"}, True),
    "LiftBail": ("bucket", 12.0, one_joint("bail", "grasp", "revolute", at_least=1.4), _BAILS, True),
    "LiftBlenderLid": ("blender", 8.0, _off, {"style": choice("jug", "retro")}, True),
    "LiftBlenderJug": ("blender", 10.0, by_lever("", 0.05, 0.055), {}, True),
    "LiftCoffeeLever": ("coffee_machine", 10.0, _lever, {"style": "capsule"}, True),
    "TurnStoveKnob": ("cooktop", 8.0, _knob("dial", at_least=0.8), _FLAT, True),
    "TurnMixerKnob": ("stand_mixer", 8.0, _knob("knob", at_least=1.0), {}, True),
    "TurnValve": ("valve", 16.0, _knob("lever", 0.8), {"style": choice("ball", "butterfly")}, True),
    "TurnSpout": ("sink", 8.0, one_joint("spout", "grasp", "revolute", 0.4), {}, False),
    "TurnHandle": ("handle", 8.0, _knob("handle", 0.8), {}, True),
    "TurnDimmer": ("switch", 8.0, _knob("knob", at_least=1.0), {"style": "dimmer"}, True),
    "FlipSwitch": ("switch", 6.0, _tip, {"style": "rocker"}, True),
    "FlushToilet": ("toilet", 6.0, _press, {"flush": choice("button", "keys")}, False),
    "PressCoffeeButton": ("coffee_machine", 6.0, _press, {}, True),
    "PressLampButton": ("lamp", 6.0, _press, {"switch": "button"}, True),
    "PressStapler": ("stapler", 6.0, _tip, {"style": choice("full", "half")}, True),
    "OpenClockDoor": ("clock", 10.0, _door, {"style": "mantel"}, True),
    "OpenFlipPhone": ("phone", 10.0, _lid, {"style": "flip"}, True),
    "LiftHandset": (
        "phone",
        8.0,
        one_joint("handset", "grasp", "prismatic", at_least=0.06),
        {"style": "desk"},
        True,
    ),
    "PressRemoteButton": ("remote", 6.0, _press, {"style": choice("tv", "stick", "gate")}, True),
    "PressSnooze": ("clock", 6.0, one_joint("snooze", "push", "prismatic", 0.8), {"style": "digital"}, True),
    "PressShutter": ("camera", 6.0, _SHUTTER, {"style": choice("compact", "reflex", "film")}, True),
    "OpenShower": ("shower", 10.0, _door, {"style": choice("hinged", "pivot")}, False),
    "OpenRiceCooker": ("rice_cooker", 6.0, one_joint("open", "push", "prismatic", 0.8), _LATCHED, True),
    "LiftCookerLid": ("rice_cooker", 8.0, _off, {"style": "slow"}, True),
    "PullVisor": ("range_hood", 8.0, one_joint("visor", "grasp", "prismatic", 0.5), _VISOR, True),
    "SqueezeClip": ("clothespin", 6.0, _tip, {"style": choice("wood", "plastic", "bag")}, True),
    "PumpSoap": ("soap_dispenser", 6.0, _press, {"style": choice("bottle", "holder")}, True),
    "TurnOnLamp": ("lamp", 8.0, by_output("light"), {"switch": choice("button", "rocker")}, True),
    "TurnOnBurner": ("cooktop", 8.0, by_output("burner"), _FLAT, True),
    "TurnOnTap": ("faucet", 8.0, by_output(), {}, False),
    "TurnOnOven": ("oven", 16.0, by_output("oven"), {"build": "built_in", "dials": choice(2, 3)}, False),
    "TurnOnAirFryer": ("toaster_oven", 16.0, by_output("heat"), {"style": choice("fryer", "dual")}, True),
    "TurnOnFan": ("fan", 8.0, by_output("blow"), {"style": choice("desk", "pedestal", "box")}, True),
    "TurnOnHood": ("range_hood", 8.0, by_output("fan"), _HUNG, True),
    "TurnOnSwitch": ("switch", 8.0, by_output("lamp"), {"style": choice("rocker", "dimmer", "timer")}, True),
    "StartMicrowave": ("microwave", 6.0, by_output("heat"), _KEYS, True),
    "StartCoffee": ("coffee_machine", 12.0, by_output("coffee"), {}, True),
    "StartDishwasher": ("dishwasher", 6.0, by_output("wash"), {"buttons": choice(3, 4, 5)}, False),
    "StartWasher": ("washing_machine", 8.0, by_output("drum"), {}, False),
    "StartBlender": ("blender", 8.0, by_output("blend"), {"style": choice("jug", "retro")}, True),
    "StartMixer": ("stand_mixer", 8.0, by_output("mix"), {}, True),
    "StartCopy": ("printer", 6.0, by_output("copying"), {"style": choice("laser", "multi"), "keys": 3}, True),
    "StartRice": ("rice_cooker", 8.0, by_output("cook"), {}, True),
    "BoilWater": ("kettle", 6.0, by_output("heat"), {"style": "spout"}, True),
    "LightGrill": ("grill", 8.0, by_output("burner"), {"style": choice("gas", "portable")}, True),
    "UnlockSafe": ("safe", 12.0, by_output("unlocking"), {"lock": "keypad"}, True),
}
TASKS = {
    name: Task(name, category, seconds, _DOCS[name], choose, overrides, raised)
    for name, (category, seconds, choose, overrides, raised) in _ROWS.items()
}


_KITCHEN_ROWS: dict[str, tuple[float, str, Chooser]] = {  # time limit [s], description, stages
    "OpenKitchenDrawer": (15.0, "Pull the third drawer of a base unit open by half its way.", third_drawer),
    "OpenAndCloseFridge": (
        25.0,
        f"Open a door of the refrigerator by {AJAR:g} rad, then shut it.",
        open_and_close,
    ),
}
KITCHEN_TASKS = {
    name: Task(name, "kitchen", seconds, doc, choose)
    for name, (seconds, doc, choose) in _KITCHEN_ROWS.items()
}
"""Tasks in a kitchen, which is drawn for each episode."""


def find_task(name: str) -> Task:
    """Return the task of a name."""
    known = {**TASKS, **KITCHEN_TASKS}
    if name not in known:
        raise ParameterError(f"there is no task {name!r}.{nearest(str(name), known)}")
    return known[name]


Source = str | Path | Dataset | Sequence[Asset] | range | None
"""A folder made by `artgen generate`, a dataset, assets, a range of seeds, or None for all seeds."""

_SEEDS = 2**31  # number of all seeds


class Assets:
    """Assets of a task by number, made or read on access; of a dataset, those of the category of the task."""

    def __init__(self, task: Task, source: Source = None) -> None:
        self.task = task
        self.keys: Sequence[int] = range(_SEEDS)  # indices in a dataset or list, or seeds
        self._known: Sequence[Asset] | None = None
        if isinstance(source, range):
            self.keys = source
        elif source is not None:
            stored = isinstance(source, str | Path | Dataset)
            self._known = _of_category(task, source) if stored else _checked(task, source)
            self.keys = range(len(self._known))
        if not len(self.keys):
            raise EnvError(
                f"{task.name} got no assets: give a folder, assets or a range of seeds that is not empty, "
                f"or None for a new {task.category} in each episode"
            )
        if self._known is None and min(self.keys[0], self.keys[-1]) < 0:
            raise EnvError(f"{task.name} got the seeds {self.keys}; seeds must be >= 0")

    def draw(self, rng: np.random.Generator) -> int:
        """Return one of the numbers at random."""
        return int(self.keys[int(rng.integers(len(self.keys)))])

    def identity(self, key: int) -> Hashable:
        """Return the key of an asset in the cache, equal for equal sources and tasks."""
        if self._known is None:
            return self.task
        if isinstance(self._known, Dataset):
            return self.task, str(self._known.directory), str(self._known.records[key]["path"])
        return self.task, self._known[key]

    def load(self, key: int) -> Asset:
        """Return the asset of a number, or raise an EnvError if there is none."""
        if key not in self.keys:
            raise EnvError(
                f"{self.task.name} has no asset {key!r}; the numbers are {self.keys[0]} to {self.keys[-1]}"
            )
        return self.task.generate(key) if self._known is None else self._known[key]


def _of_category(task: Task, source: Any) -> Dataset:
    dataset = source if isinstance(source, Dataset) else Dataset(source)
    found = sorted({str(record["category"]) for record in dataset.records})
    if task.category not in found:
        held = f"assets of {', '.join(found)}" if found else "no assets"
        raise EnvError(
            f"{task.name} needs assets of the category {task.category!r}, but {dataset.directory} holds "
            f"{held}; `artgen generate {task.category} -n 100 --out FOLDER` makes some"
        )
    return dataset.filter(task.category)


def _checked(task: Task, assets: Any) -> Sequence[Asset]:
    for asset in assets if isinstance(assets, Sequence) else (assets,):
        if not isinstance(asset, Asset):
            raise EnvError(
                f"{task.name} got {asset!r} for an asset; give a folder, assets, a range of seeds, or None"
            )
        if asset.category != task.category:
            raise EnvError(
                f"{task.name} needs assets of the category {task.category!r}, but {asset.name!r} is of "
                f"{asset.category!r}"
            )
    return tuple(assets)


class CompiledAsset:
    """An asset with its compiled model and its variants of a task."""

    def __init__(self, task: Task, asset: Asset, key: int, *, visual: bool, textures: int) -> None:
        self.asset = asset
        self._task, self._key, self._visual, self._textures = task, key, visual, textures
        self._targets: dict[int, Target | str] = {}

    @cached_property
    def _model(self) -> Any:
        return compiled(self.asset, visual=self._visual, textures=self._textures)

    def scene(self) -> TaskScene:
        """Return a scene with its own model, whose robot can move."""
        return TaskScene(self.asset, copy.copy(self._model))

    def target(self, number: int) -> Target:
        """Return a variant of the task, which depends only on the asset and the number."""
        if number not in self._targets:
            rng = np.random.default_rng([self._key, number])
            try:
                self._targets[number] = self._task.target(self.asset, rng)
            except EnvError as error:
                self._targets[number] = str(error)
        found = self._targets[number]
        if isinstance(found, str):
            raise EnvError(found)
        return found


_cache: OrderedDict[Hashable, CompiledAsset] = OrderedDict()


def compiled_asset(assets: Assets, key: int, *, visual: bool, textures: int, most: int) -> CompiledAsset:
    """Return the compiled asset of a number from the cache of the process with the `most` recent ones."""
    name = (assets.identity(key), key, visual, textures)
    if name not in _cache:
        while len(_cache) >= most:
            _cache.popitem(last=False)
        _cache[name] = CompiledAsset(assets.task, assets.load(key), key, visual=visual, textures=textures)
    _cache.move_to_end(name)
    return _cache[name]

"""The moving parts of the system that artgen replaces: each of them is there, in every number that it has."""

import re
from collections.abc import Iterable
from dataclasses import dataclass
from functools import cache

import pytest

from artgen.catalog import categories, find
from artgen.errors import InfeasibleError
from artgen.graph import Graph
from artgen.graph.handle import folding
from artgen.materials import Material
from support.cases import some
from support.joint_outline import PlannedJoint, joints_of

FEWEST, MOST = 25, 300
"""Seeds of a category that are drawn: at least, and at most until every number has occurred."""


@dataclass(frozen=True)
class Moving:
    """A row's label, and the joints that stand for it.

    Attributes:
        joint: Pattern of their names, without the number of a copy.
        kind: Whether they turn or slide.
        counts: How many of them an asset has: each of these numbers occurs, and no other one.
        unlimited: Whether they turn without limits; None where some do.
    """

    joint: str
    kind: str
    counts: Iterable[int]
    unlimited: bool | None = False


def turns(joint: str, counts: Iterable[int], *, unlimited: bool | None = False) -> Moving:
    return Moving(joint, "revolute", counts, unlimited)


def slides(joint: str, counts: Iterable[int]) -> Moving:
    return Moving(joint, "prismatic", counts)


SIDED = "(_left|_right)?"

CHECKLIST: dict[str, dict[str, Moving]] = {
    "box": {
        "flap": turns(f"flap_(front|back|left|right|upper|lower)_hinge{SIDED}", (0, 1, 2, 4, 8)),
        "lid": turns(f"lid_hinge{SIDED}", (0, 1, 2)),
        "tuck": turns(f"tuck_(front|left|right|lower)_hinge{SIDED}", (0, 1, 2, 3)),
        "ear of a tuck": turns(f"ear_(front|back|left|right)_hinge{SIDED}", (0, 2, 4)),
        "lip of a flap": turns("lip_(front|back)_hinge(_left|_right)", (0, 4)),
        "crease": turns(f".*_hinge{SIDED}", (0, 2, 4, 6, 8, 12, 16)),
        "lid that lifts off": slides("lid_lift", (0, 1)),
        "cover": slides("sleeve_lift", (0, 1)),
        "drawer": slides("drawer_slide", (0, 1)),
        "bottle": slides("bottle_lift", (0, 2, 3, 6, 12)),
    },
    "blender": {
        "jug on its bayonet": turns("jug_turn", (1,)),
        "jug that lifts off": slides("jug_lift", (1,)),
        "lid that lifts off": slides("lid_lift", (0, 1)),
        "filler cap": slides("cap_lift", (0, 1)),
        "blade": turns("blade_spin", (0, 1), unlimited=True),
        "dial": turns("dial_turn", (0, 1)),
        "button": slides("button_slide", (0, 1, 2, 3, 4)),
    },
    "bottle": {
        "cap on a thread": turns("cap_turn", (0, 1)),
        "lid on a thread": turns("lid_turn", (0, 1)),
        "rise of a thread": slides("(cap|lid)_turn_rise", (0, 1)),
        "lid with a hinge": turns("lid_hinge", (0, 1)),
        "nozzle": slides("nozzle_slide", (0, 1)),
        "stopper that lifts off": slides("stopper_lift", (0, 1)),
        "trigger": turns("trigger_pull", (0, 1)),
    },
    "bucket": {
        "bail": turns("bail_swing", (0, 1)),
        "hanging handle": turns("handle_swing_(left|right)", (0, 2)),
        "lid that lifts off": slides("lid_lift", (0, 1)),
    },
    "cabinet": {"door": turns(f"door_hinge{SIDED}", (1, 2))},
    "clothespin": {
        "jaw": turns("jaw_hinge", (1,)),
        "wire arm": turns("arm_turn", (0, 2)),
        "pad": turns("pad_turn", (0, 2)),
    },
    "coffee_machine": {
        "lid of the tank": turns("tank_lid_hinge", (1,)),
        "jug that slides out": slides("jug_slide", (0, 1)),
        "jug that lifts off": slides("jug_lift", (0, 1)),
        "lid of a jug": turns("lid_hinge", (0, 1)),
        "basket that swings": turns("basket_turn", (0, 1)),
        "basket that lifts out": slides("basket_lift", (0, 1)),
        "lever": turns("lever_turn", (0, 1)),
        "tank that lifts off": slides("tank_lift", (0, 1)),
        "drip tray": slides("drip_tray_slide", (0, 1)),
        "portafilter": turns("portafilter_turn", (0, 1)),
        "portafilter out of its group": slides("portafilter_lower", (0, 1)),
        "wand": turns("wand_turn", (0, 1)),
        "dial": turns("steam_turn", (0, 1)),
        "button": slides("button_slide", (1, 2, 3)),
    },
    "cart": {
        "caster that swivels": turns("caster_swivel_\\d", (0, 2, 4), unlimited=True),
        "wheel of a caster": turns("caster_roll_\\d", (0, 2, 4), unlimited=True),
        "large wheel": turns("wheel_roll(_left|_right)", (0, 2), unlimited=True),
        "drawer": slides("drawer_slide", (0, 3, 4, 5, 6)),
        "handle that folds": turns("handle_fold", (0, 1)),
        "toe that folds": turns("toe_fold", (0, 1)),
    },
    "chair": {
        "lift of the seat": slides("seat_lift", (0, 1)),
        "swivel of the seat": turns("seat_swivel", (0, 1), unlimited=True),
        "lever of the lift": turns("lever_pull", (0, 1)),
        "back": turns("back_tilt", (0, 1)),
        "footrest": turns("footrest_turn", (0, 1)),
        "seat that turns up": turns("seat_fold", (0, 1)),
        "rear legs": turns("legs_fold", (0, 1)),
        "struts of the rear legs": turns("strut_turn", (0, 1)),
        "fork of a caster": turns("caster_swivel", (0, 5), unlimited=True),
        "wheel of a caster": turns("caster_roll", (0, 5), unlimited=True),
    },
    "cooktop": {
        "burner dial": turns("burner_dial_turn", range(2, 7)),
        "push of a gas dial": slides("burner_dial_push", (0, 2, 3, 4, 5, 6)),
        "dial of a timer or fan": turns("(timer|fan)_dial_turn", (0, 1, 2)),
        "grate": slides("grate_lift", (0, 2, 3, 4, 5, 6)),
    },
    "dishwasher": {
        "door": turns("door_hinge", (1,)),
        "rack": slides("rack_slide", (1, 2, 3)),
        "button": slides("button_slide", range(9)),
        "knob": turns("knob_turn", (0, 1)),
        "detergent flap": slides("detergent_flap_slide", (1,)),
        "spray arm": turns("spray_arm_spin", (1, 2), unlimited=True),
    },
    "camera": {
        "button of the shutter": slides("shutter_slide", (0, 1)),
        "ring of the lens": turns("(zoom|focus)_ring_turn", (0, 1)),
        "front of the lens": slides("barrel_slide", (0, 1)),
        "first step of the lens": slides("sleeve_slide", (0, 1)),
        "dial": turns("(mode|speed)_dial_turn", (0, 1)),
        "flash": turns("flash_hinge", (0, 1)),
        "screen that swings": turns("screen_hinge", (0, 1)),
        "lever that winds": turns("lever_turn", (0, 1)),
        "knob that rewinds": turns("rewind_knob_turn", (0, 1), unlimited=True),
        "back": turns("back_hinge", (0, 1)),
        "flap": turns("flap_hinge", (0, 1)),
        "picture": slides("photo_slide", (0, 1)),
        "leg of the clip": turns("leg_hinge", (0, 1)),
        "neck": turns("neck_turn", (0, 1)),
        "head": turns("head_tilt", (0, 1)),
        "slider": slides("slider_slide", (0, 1)),
        "key": slides("button_slide", (0, 2, 3)),
    },
    "clock": {
        "hour hand": turns("hour_turn", (0, 1)),
        "minute hand": turns("minute_turn", (0, 1), unlimited=None),
        "second hand": turns("second_turn", (0, 1), unlimited=True),
        "pendulum": turns("pendulum_swing", (0, 1)),
        "door": turns("((trunk|hood)_)?door_hinge", (0, 1, 2)),
        "knob that sets the hands": turns("set_turn", (0, 1), unlimited=True),
        "knob of the alarm": turns("alarm_turn", (0, 1), unlimited=True),
        "hand of the alarm": turns("alarm_hand_turn", (0, 1)),
        "key": turns("key_turn", (0, 1), unlimited=True),
        "hammer": turns("hammer_swing", (0, 1)),
        "bar that silences": slides("snooze_slide", (0, 1)),
        "key of digits": slides("button_slide", (0, 3, 4, 5)),
    },
    "display": {
        "stand that turns": turns("stand_swivel", (0, 1)),
        "stand that rises": slides("height_slide", (0, 1)),
        "screen that tilts": turns("screen_tilt", (0, 1)),
        "key": slides("button_slide", (1, 2, 3, 4, 5)),
    },
    "door": {
        "door": turns(f"door_hinge{SIDED}", (1, 2)),
        "handle that turns": turns("handle_turn", (0, 1)),
        "handle that slides": slides("handle_push", (0, 1)),
        "latch bolt": slides("latch_slide", (0, 1)),
        "thumb-turn": turns("lock_turn", (0, 1)),
    },
    "drawer": {"drawer": slides("drawer_slide", (1, 2, 3, 4, 5, 6, 8, 9, 10, 12, 15))},
    "faucet": {
        "spout": turns("spout_swivel", (1,)),
        "handle": turns(f"handle_turn{SIDED}", (1, 2)),
        "lift of a lever": turns("handle_lift", (0, 1)),
        "spray head": slides("spray_head_slide", (0, 1)),
        "rod of the drain": slides("lift_rod_slide", (0, 1)),
        "pivot rod of the drain": turns("pivot_rod_turn", (0, 1)),
        "plug of the drain": slides("plug_slide", (0, 1)),
    },
    "handle": {
        "handle": turns("handle_turn", (1,)),
        "lock that turns": turns("lock_turn", (0, 1)),
        "lock that is pushed": slides("lock_push", (0, 1)),
        "thumb latch": turns("thumb_press", (0, 1)),
        "latch bolt": slides("latch_slide", (1,)),
    },
    "kettle": {
        "jug that lifts off": slides("jug_lift", (0, 1)),
        "jug on its base": turns("jug_turn", (0, 1), unlimited=True),
        "lid with a hinge": turns("lid_hinge", (0, 1)),
        "lid that lifts off": slides("lid_lift", (0, 1)),
        "switch": turns("switch_turn", (0, 1)),
        "folding handle": turns("bail_turn", (0, 1)),
        "whistle": turns("whistle_hinge", (0, 1)),
    },
    "keyboard": {
        "key": slides("key_press", (12, 17, 61, 87, 104)),
        "knob": turns("knob_turn", (0, 1), unlimited=True),
        "folding foot": turns("foot_hinge", (0, 2)),
    },
    "lamp": {
        "arm_lower": turns("arm_lower_hinge", (0, 1)),
        "arm_upper": turns("arm_upper_hinge", (0, 1)),
        "arm about z": turns("arm_swivel", (0, 1), unlimited=True),
        "shade": turns("shade_hinge", (0, 1)),
        "slide on the pole": slides("height_slide", (0, 1)),
        "button": slides("switch_slide", (0, 1)),
        "rocker": turns("switch_rock", (0, 1)),
        "dial": turns("switch_turn", (0, 1), unlimited=True),
        "pull chain": slides("switch_pull", (0, 1)),
    },
    "laptop": {
        "screen": turns("screen_hinge", (1,)),
        "second axis of a screen": turns("base_hinge", (0, 1)),
        "trackpad": slides("trackpad_press", (1,)),
        "power key": slides("power_press", (1,)),
        "tray": slides("tray_slide", (0, 1)),
    },
    "microwave": {
        "door": turns("door_hinge", (1,)),
        "plate": turns("plate_spin", (1,), unlimited=True),
        "ring of rollers": turns("ring_spin", (1,)),
        "button": slides("button_slide", (0, 1)),
        "latch": slides("latch_slide", (0, 1)),
        "key of a keypad": slides("key_slide", (0, 3, 6, 9, 12)),
        "dial": turns("dial_turn", range(4), unlimited=True),
    },
    "oven": {
        "door": turns("door_hinge", (1,)),
        "rack": slides("rack_slide", (1, 2, 3)),
        "drawer": slides("drawer_slide", (0, 1)),
        "dial": turns("dial_turn", range(7)),
        "grate": slides("grate_lift", (0, 2, 3)),
    },
    "pepper_grinder": {
        "top": turns("top_turn", (0, 1), unlimited=True),
        "crank": turns("crank_turn", (0, 1), unlimited=True),
        "knob of the crank": turns("knob_spin", (0, 1), unlimited=True),
    },
    "mouse": {
        "button": turns("button_(left|right)_press", (2,)),
        "wheel": turns("wheel_turn", (1,), unlimited=True),
        "middle button": slides("axle_press", (1,)),
        "key for the thumb": slides("thumb_press", (0, 2)),
        "receiver": slides("receiver_slide", (0, 1)),
    },
    "phone": {
        "lid": turns("lid_hinge", (0, 1)),
        "upper half": slides("slide_up", (0, 1)),
        "key": slides("key_press", (0, 15, 18, 20, 25)),
        "key in the side": slides("(volume_up|volume_down|power)_press", (0, 3)),
        "handset": slides("handset_lift", (0, 1)),
    },
    "plier": {"jaw": turns("jaw_hinge", (1,)), "slip joint": slides("pivot_slide", (0, 1))},
    "pot": {
        "lid that lifts off": slides("lid_lift", (0, 1)),
        "lid that turns": turns("lid_turn", (0, 1), unlimited=None),
        "lid with a hinge": turns("lid_hinge", (0, 1)),
        "side handle": turns("handle_swing(_right|_left)", (0, 2)),
        "lock": slides("lock_slide", (0, 1)),
        "valve": slides("valve_lift", (0, 1)),
    },
    "printer": {
        "cassette": slides("cassette_slide", (1, 2)),
        "flap": turns("flap_hinge", (0, 1)),
        "lid of a scanner": turns("lid_hinge", (0, 1)),
        "panel that tilts": turns("panel_tilt", (0, 1)),
        "key": slides("button_slide", range(2, 7)),
    },
    "grill": {
        "lid": turns("lid_hinge", (1,)),
        "plate that floats": slides("lid_lift", (0, 1)),
        "grate": slides("grate_lift", (0, 1)),
        "vent": turns("vent_turn", (0, 1)),
        "damper": slides("damper_slide", (0, 1)),
        "lever for ash": turns("ash_turn", (0, 1)),
        "wheel": turns("wheel_roll(_right|_left)", (0, 2), unlimited=True),
        "door": turns("door_hinge(_right|_left)", (0, 2)),
        "shelf": turns("shelf_hinge(_right|_left)", (0, 2)),
        "knob": turns("dial_turn", (0, 1, 2, 3, 4)),
        "drip tray": slides("tray_slide", (0, 1)),
        "switch": slides("button_slide", (0, 1)),
    },
    "range_hood": {
        "filter": turns("filter_hinge", (0, 2, 3)),
        "catch of a filter": slides("catch_slide", (0, 2, 3)),
        "visor": slides("visor_slide", (0, 1)),
        "flap": turns("flap_hinge", (0, 1)),
        "inclined pane": turns("panel_hinge", (0, 1)),
        "key": slides("button_slide", (0, 1, 4, 5)),
        "slider": slides("slider_slide", (0, 2)),
        "dial": turns("dial_turn", (0, 1)),
    },
    "refrigerator": {
        "door": turns(f"door_hinge{SIDED}", (1, 2)),
        "freezer door": turns("freezer_door_hinge", (0, 1)),
        "inner drawer": slides("inner_drawer_slide", (0, 1, 2, 3)),
        "outer drawer": slides("outer_drawer_slide", (0, 1, 2)),
    },
    "rice_cooker": {
        "lid with a hinge": turns("lid_hinge", (0, 1)),
        "lid that lifts off": slides("lid_lift", (0, 1)),
        "lid that turns": turns("lid_turn", (0, 1), unlimited=None),
        "pot": slides("pot_lift", (1,)),
        "button of a lid": slides("open_slide", (0, 1)),
        "lock of a lid": turns("lock_turn", (0, 1)),
        "latch": slides("latch_slide", (0, 1)),
        "cap of a vent": slides("vent_lift", (0, 1)),
        "bail": turns("bail_swing", (0, 1)),
        "lever": slides("lever_slide", (0, 1)),
        "outlet of steam": turns("valve_turn", (0, 1)),
        "dial": turns("dial_turn", (0, 1), unlimited=None),
        "key": slides("button_slide", (0, 4, 6)),
    },
    "usb_stick": {
        "body": turns("body_turn", (0, 1)),
        "plug": slides("plug_slide", (0, 1)),
        "cap": slides("cap_slide", (0, 1)),
        "tube": turns("cap_turn", (0, 1)),
        "rise of a tube": slides("cap_turn_rise", (0, 1)),
    },
    "pen": {
        "button": slides("button_slide", (0, 1)),
        "top": turns("top_turn", (0, 1)),
        "refill": slides("refill_slide", (0, 1)),
        "cap that is drawn off": slides("cap_slide", (0, 1)),
        "cap on a thread": turns("cap_turn", (0, 1)),
        "rise of a cap": slides("cap_turn_rise", (0, 1)),
    },
    "lighter": {
        "lid": turns("lid_hinge", (0, 1)),
        "wheel": turns("wheel_turn", (0, 1), unlimited=True),
        "lever": turns("lever_press", (0, 1)),
        "snuffer": turns("snuffer_hinge", (0, 1)),
        "button": slides("button_slide", (0, 1)),
        "trigger": slides("trigger_slide", (0, 1)),
        "insert": slides("insert_lift", (0, 1)),
    },
    "knife": {
        "blade that turns": turns("blade_hinge", (0, 1)),
        "blade that slides": slides("blade_slide", (0, 1)),
        "tool": turns("(opener|lifter)_hinge", (0, 2)),
        "ring": turns("ring_turn", (0, 1)),
        "screw": turns("lock_turn", (0, 1)),
    },
    "eyeglasses": {"temple": turns("temple_hinge(_right|_left)", (2,))},
    "globe": {
        "ball": turns("ball_spin", (1,), unlimited=True),
        "meridian": turns("meridian_turn", (0, 1)),
        "button": slides("button_slide", (0, 1)),
    },
    "scissors": {
        "blade": turns("blade_hinge", (0, 1)),
        "arm of tongs": turns("arm_hinge", (0, 1)),
        "ring of tongs": slides("ring_slide", (0, 1)),
    },
    "shower": {
        "hinged door": turns("door_hinge", (0, 1)),
        "second leaf": turns("fold_hinge", (0, 1)),
        "sliding door": slides("door_slide", (0, 1, 2)),
        "curved door": turns("door_roll", (0, 2)),
    },
    "sink": {
        "spout": turns("spout_swivel", (1,)),
        "handle": turns(f"handle_turn{SIDED}", (1, 2)),
        "lift of a lever": turns("handle_lift", (0, 1)),
        "spray head": slides("spray_head_slide", (0, 1)),
        "basket that lifts off": slides("strainer_lift(_right)?", (0, 1, 2)),
        "knob of a drain": turns("knob_turn", (0, 1)),
        "basket that the knob lifts": slides("strainer_slide", (0, 1)),
        "plug that lifts off": slides("plug_lift", (0, 1)),
        "rod of the drain": slides("lift_rod_slide", (0, 1)),
        "pivot rod of the drain": turns("pivot_rod_turn", (0, 1)),
        "plug of the drain": slides("plug_slide", (0, 1)),
    },
    "soap_dispenser": {
        "nozzle that slides": slides("nozzle_slide", (0, 1)),
        "nozzle that turns": turns("nozzle_turn", (0, 1), unlimited=True),
        "button on a wall": slides("button_slide", (0, 1)),
        "lever on a wall": turns("lever_hinge", (0, 1)),
    },
    "fan": {
        "blades": turns("blades_spin", (1,), unlimited=True),
        "swing of the head": turns("head_swing", (0, 1)),
        "tilt of the head": turns("head_tilt", (0, 1)),
        "pole": slides("pole_slide", (0, 1)),
        "jaw of a clip": turns("jaw_turn", (0, 1)),
        "clutch of the swing": slides("knob_pull", (0, 1)),
        "key": slides("button_slide", (0, 4)),
        "dial": turns("dial_turn", (0, 1)),
    },
    "stand_mixer": {
        "head": turns("head_tilt", (0, 1)),
        "lock of the head": slides("button_slide", (0, 1)),
        "crank": turns("crank_turn", (0, 1)),
        "arms": slides("carriage_slide", (0, 1)),
        "bowl out of its seat": turns("bowl_turn", (0, 1)),
        "bowl that lifts off": slides("bowl_lift", (1,)),
        "beater": turns("beater_spin", (1,), unlimited=True),
        "speed": turns("knob_turn", (1,)),
    },
    "remote": {
        "key": slides(
            "key_press", (1, 2, 3, 4, 12, 13, 15, 16, 17, 18, 21, 24, 27, 29, 30, 33, 36, 39, 42, 45)
        ),
        "battery cover": slides("battery_slide", (0, 1)),
        "cover over keys": slides("front_slide", (0, 1)),
        "blade of a key": turns("blade_turn", (0, 1)),
        "ring of a fob": turns("ring_swing", (0, 1)),
    },
    "safe": {
        "door": turns("door_hinge", (1,)),
        "bolts": slides("bolts_slide", (1,)),
        "bolt of the lock": slides("tongue_slide", (1,)),
        "handle": turns("handle_turn", (1,)),
        "key": turns("key_turn", (0, 1)),
        "dial": turns("dial_turn", (0, 1)),
        "key of a keypad": slides("button_slide", (0, 12)),
    },
    "stapler": {
        "arm": turns("arm_hinge", (0, 1)),
        "lever of a plier": turns("lever_hinge", (0, 1)),
        "anvil": turns("anvil_turn", (0, 1)),
        "magazine": slides("magazine_slide", (0, 1)),
        "pin of a punch": slides("pin_slide", (0, 2)),
        "guide of a punch": slides("guide_slide", (0, 1)),
    },
    "suitcase": {
        "lid": turns("lid_hinge", (1,)),
        "latch": turns(r"latch_turn_(left|right)", (2,)),
        "handle": turns("handle_turn", (1,)),
        "telescopic handle": slides("pull_slide", (0, 1)),
        "button of the handle": slides("button_press", (0, 1)),
        "caster": turns("caster_swivel", (0, 4), unlimited=True),
        "wheel": turns("caster_roll", (0, 2, 4), unlimited=True),
    },
    "switch": {
        "rocker": turns("rocker_tilt", (0, 1, 2, 3)),
        "toggle": turns("toggle_tilt", (0, 1)),
        "knob": turns("knob_turn", (0, 1)),
        "emergency stop": slides("stop_push", (0, 1)),
    },
    "syringe": {
        "plunger": slides("plunger_slide", (0, 1)),
        "cap": slides("cap_slide", (0, 1)),
        "dial": turns("dial_turn", (0, 1)),
        "button": slides("button_slide", (0, 1)),
        "nozzle": turns("nozzle_turn", (0, 1)),
    },
    "table": {
        "drawer": slides("drawer_slide", (0, 1, 2, 3)),
        "leaf": turns("leaf_hinge(_right|_left)", (0, 2)),
        "support of a leaf": slides("support_slide(_right|_left)", (0, 2)),
        "rising top": slides("top_lift", (0, 1)),
        "key": slides("key_press(_up|_down)", (0, 2)),
    },
    "toaster": {
        "lever": slides(f"lever_slide{SIDED}", (1, 2)),
        "button": slides("button_slide", range(5)),
        "knob": turns(f"knob_turn{SIDED}", (0, 1, 2)),
        "crumb tray": slides("crumb_tray_slide", (1,)),
    },
    "toaster_oven": {
        "door": turns("door_hinge", (0, 1)),
        "rack": slides("rack_slide", (0, 1)),
        "crumb tray": slides("crumb_tray_slide", (0, 1)),
        "drawer": slides("drawer_slide", (0, 1)),
        "basket that lifts out": slides("basket_lift", (0, 1)),
        "dial": turns("dial_turn", (2, 3, 4)),
    },
    "toilet": {
        "lid": turns("lid_hinge", (1,)),
        "seat": turns("seat_hinge", (1,)),
        "button or key": slides("flush_slide(_half|_full)?", (0, 1, 2)),
        "lever": turns("flush_turn", (0, 1)),
    },
    "trashcan": {
        "lid": turns(f"lid_hinge{SIDED}", (0, 1, 2)),
        "pedal": turns("pedal_hinge", (0, 1)),
        "bucket": slides("bucket_slide", (0, 1)),
        "button": slides("button_slide", (0, 1)),
    },
    "valve": {
        "lever": turns("lever_turn", (0, 1)),
        "hand wheel": turns("wheel_turn", (0, 1)),
        "stem of a gate valve": slides("stem_rise", (0, 1)),
        "rise of a globe valve": slides("wheel_turn_rise", (0, 1)),
        "knob of a needle valve": turns("knob_turn", (0, 1, 2, 3)),
        "rise of a knob": slides("knob_turn_\\d_rise", (0, 1, 2, 3)),
    },
    "washing_machine": {
        "door": turns("door_hinge", (0, 1)),
        "lid": turns("lid_hinge", (0, 1)),
        "handle of the door": turns("handle_pull", (0, 1)),
        "drum": turns("drum_spin", (1,), unlimited=True),
        "agitator": turns("agitator_turn", (0, 1), unlimited=True),
        "drawer": slides("drawer_slide", (0, 1)),
        "filter flap": turns("flap_hinge", (0, 1)),
        "dial": turns("dial_turn", range(4), unlimited=True),
        "button": slides("button_slide", range(2, 7)),
    },
    "window": {
        "pane that turns": turns("pane_hinge", (0, 1, 2, 4)),
        "pane that slides": slides("pane_slide(_upper|_lower)?", (0, 1, 2)),
        "lock that turns": turns("handle_turn|lock_turn", (0, 1, 2, 4)),
        "lock that slides": slides("lock_slide", (0, 1, 2)),
        "bolt of a lock": slides("bolt_slide", (0, 1, 2, 4)),
        "shutter": turns(f"shutter_hinge{SIDED}", (0, 2)),
    },
}


@cache
def drawn(category: str) -> tuple[tuple[PlannedJoint, ...], ...]:
    """Return the joints of each of many seeds, from their graphs; what cannot be made is left out."""
    found: list[tuple[PlannedJoint, ...]] = []
    missing = {label: set(moving.counts) for label, moving in CHECKLIST[category].items()}
    extremes = set(find(category).joints)
    texts = {name for name, each in find(category).own.items() if each.kind is str}
    known: set[str] = set()
    for seed in range(MOST):
        if seed >= FEWEST and not any(missing.values()) and not extremes:
            break
        values = find(category).sample(seed)
        kept = values.keys() - texts - {name for name in values if isinstance(values[name], float | Material)}
        outline = repr([(name, values[name]) for name in sorted(kept)])
        if outline in known:
            continue  # joints depend on neither lengths nor materials nor texts
        known.add(outline)
        try:
            with folding():  # a graph without nodes for known numbers is built in half the time
                found.append(joints_of(Graph(find(category).build(values))))
        except InfeasibleError:
            continue
        extremes.discard(len(found[-1]))
        for label, moving in CHECKLIST[category].items():
            missing[label].discard(len(matching(found[-1], moving)))
    return tuple(found)


def matching(joints: Iterable[PlannedJoint], moving: Moving) -> list[PlannedJoint]:
    pattern = re.compile(f"({moving.joint})(_\\d+)?")
    return [joint for joint in joints if pattern.fullmatch(joint.name)]


@pytest.mark.parametrize("category", some(categories(), 5))
def test_every_moving_part_of_the_checklist_is_there_in_every_number(category: str) -> None:
    for label, moving in CHECKLIST[category].items():
        found = [matching(joints, moving) for joints in drawn(category)]
        assert {len(joints) for joints in found} == set(moving.counts), f"{category}: {label}"
        kinds = {joint.kind for joints in found for joint in joints}
        assert kinds == {moving.kind}, f"{category}: {label}"
        if moving.unlimited is not None:
            ends = {joint.unlimited for joints in found for joint in joints}
            assert ends == {moving.unlimited}, f"{category}: {label}"


@pytest.mark.parametrize("category", some(categories(), 3, 1))
def test_a_category_says_how_many_joints_its_assets_have(category: str) -> None:
    counts = [len(joints) for joints in drawn(category)]
    assert find(category).joints == (min(counts), max(counts))

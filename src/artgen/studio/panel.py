"""Panel in the browser: parameters, joints, display options, certificate and export."""

import html
import math
from collections.abc import Callable, Mapping
from pathlib import Path
from typing import Any

from artgen.export.layouts import DEFAULT_FORMATS, FORMATS
from artgen.studio.controls import JointControl, ParameterControl
from artgen.studio.session import Session
from artgen.studio.signs import SIGNS, Sign

Ask = Callable[[str, Callable[[], None]], None]
"""Callback that queues a request by name; the latest request of a name wins."""

_NONE = "(none)"  # menu text of an empty string
_SET = "\N{BULLET} "  # prefix of the name of an overridden parameter
_MAPS = ("0", "256", "512", "1024")
_SIGN_NAMES = {
    "colliders": "colliders",
    "joints": "joint axes and limits",
    "grasps": "grasp frames",
    "masses": "centers of mass",
}
_WITNESSES = 6  # formats with buttons
_BOX = (
    "margin:0.4em 0.4em 0.6em;padding:0.5em 0.7em;border-radius:4px;font-size:0.8em;overflow-wrap:anywhere;"
)
_COLORS = {
    "fault": "#fde8e6;color:#8c1d13",
    "held": "#fff4d6;color:#6b4e00",
    "plain": "#eef2f6;color:#23313f",
}


class Panel:
    """The controls of a session in a viser server."""

    def __init__(
        self,
        server: Any,
        session: Session,
        ask: Ask,
        actions: Mapping[str, Callable[..., None]],
        *,
        out: Path,
        waits: Callable[[str], bool],
        rich_light: bool,
    ) -> None:
        self._gui = server.gui
        self._session = session
        self._ask = ask
        self._out = out
        self._waits = waits
        self._actions = actions
        self._controls: dict[str, tuple[tuple[Any, ...], Any]] = {}
        self._folders: dict[str, Any] = {}
        self._sliders: dict[str, tuple[tuple[Any, ...], Any]] = {}
        self._witnesses: list[Any] = []
        self._gui.configure_theme(
            show_logo=False, show_share_button=False, brand_color=(0, 114, 178), control_width="large"
        )
        self._gui.set_panel_label("artgen studio")
        self._gui.main_panel.dock_right()
        self.status = self._gui.add_html("")
        self.fault = self._gui.add_html("", visible=False)
        tabs = self._gui.add_tab_group()
        self._parameters = tabs.add_tab("Parameters")
        self._joints = tabs.add_tab("Joints")
        with tabs.add_tab("View"):
            self._add_view(rich_light=rich_light)
        self._proof = tabs.add_tab("Certificate")
        with tabs.add_tab("Export"):
            self._add_export()
        with self._parameters:
            self.seed = self._gui.add_number(
                "seed", session.seed, min=0, step=1, hint="decides every draw", order=-2.0
            )
            self.seed.on_update(self._by_person(lambda value: self._actions["seed"](int(value)), "seed"))
            buttons = self._gui.add_button_group("draw", ("resample", "reset"), order=-1.0)
            buttons.on_click(self._press)
        with self._joints:
            self.held = self._gui.add_html("", visible=False)
            buttons = self._gui.add_button_group("all", ("close", "open"))
            buttons.on_click(self._press)
        with self._proof:
            self.verdict = self._gui.add_html("")

    def _add_view(self, *, rich_light: bool) -> None:
        for kind in SIGNS:
            box = self._gui.add_checkbox(_SIGN_NAMES[kind], initial_value=False)
            box.on_update(self._sign(kind))
        labels = self._gui.add_checkbox("semantic colors", initial_value=False)
        labels.on_update(self._by_person(self._actions["labels"], "labels"))
        maps = self._gui.add_dropdown(
            "textures", _MAPS, initial_value="512", hint="texels on a side of the maps; 0 for colors alone"
        )
        maps.on_update(self._by_person(lambda value: self._actions["textures"](int(value)), "textures"))
        light = self._gui.add_checkbox(
            "reflections and shadows", rich_light, hint="slow where the browser has no GPU"
        )
        light.on_update(self._by_person(self._actions["light"], "light"))

    def _sign(self, kind: Sign) -> Callable[[Any], None]:
        return self._by_person(lambda value: self._actions["sign"](kind, value), f"sign {kind}")

    def _add_export(self) -> None:
        self._folder = self._gui.add_text("folder", "", hint=f"below {self._out}; created if missing")
        self._formats = {
            name: self._gui.add_checkbox(name, initial_value=name in DEFAULT_FORMATS) for name in FORMATS
        }
        self._gui.add_button("export").on_click(
            lambda _: self._ask("export", lambda: self._actions["export"](self._folder.value, self._chosen()))
        )
        self.exported = self._gui.add_html("", visible=False)
        self._gui.add_markdown("**As Python**")
        self.python = self._gui.add_html("")

    def _press(self, event: Any) -> None:
        """Run the action of the pressed button; a malformed message names another one."""
        if event.target.value in event.target.options:
            self._actions[event.target.value]()

    def _chosen(self) -> tuple[str, ...]:
        return tuple(name for name, box in self._formats.items() if box.value)

    def _by_person(self, act: Callable[[Any], None], name: str) -> Callable[[Any], None]:
        """Return a callback for values set by a user, not by this program."""

        def changed(event: Any) -> None:
            if event.client is not None:
                value = event.target.value
                self._ask(name, lambda: act(value))

        return changed

    # updates from the session

    def show(self) -> None:
        """Update the panel to a new asset: its parameters and joints, with their values."""
        if self._session.shown is None:
            return
        self._show_parameters(self._session.controls())
        self._show_joints(self._session.joints())
        if not self._folder.value or self._folder.value == getattr(self, "_suggested", ""):
            self._suggested = self._session.asset.name
            self._folder.value = self._suggested

    def _show_parameters(self, controls: tuple[ParameterControl, ...]) -> None:
        wanted = {control.name: control for control in controls}
        for name in [name for name in self._controls if name not in wanted]:
            self._controls.pop(name)[1].remove()
        groups = {control.group for control in controls if control.group}
        groups |= {
            group.rsplit(".", 2 * depth)[0] for group in groups for depth in range(group.count(".") // 2)
        }
        for order, control in enumerate(controls):
            is_set = self._session.is_set(control)
            shape, handle = self._controls.get(control.name, ((), None))
            if handle is not None and shape != control.shape:
                handle.remove()
                handle = None
            if handle is None:
                with self._folder_of(control.group, order):
                    handle = self._add(control, float(order))
                handle.on_update(self._changed(control.name))
                self._controls[control.name] = (control.shape, handle)
            elif not self._waits(_wish(control.name)):  # a user has moved it in the meantime
                handle.value = _displayed(control)
            handle.label = _label(control, is_set=is_set)
        used = {self._key(control.group) for control in controls}
        for name in [name for name in self._folders if not any(each.startswith(name) for each in used)]:
            self._folders.pop(name).remove()

    def _key(self, group: str) -> str:
        return group + "."

    def _folder_of(self, group: str, order: int) -> Any:
        """Return the folder of a generator's parameters, inside the folders of its selecting generators."""
        if not group:
            return self._parameters
        key = self._key(group)
        if key not in self._folders:
            parent, _, generator = group.rpartition(".")
            owner, _, parameter = parent.rpartition(".")
            with self._folder_of(owner, order):
                self._folders[key] = self._gui.add_folder(f"{parameter}: {generator}", order=order - 0.5)
        return self._folders[key]

    def _changed(self, name: str) -> Callable[[Any], None]:
        def act(value: Any) -> None:
            self._actions["set"](name, "" if value == _NONE else value)

        return self._by_person(act, _wish(name))

    def _add(self, control: ParameterControl, order: float) -> Any:
        label, value = _label(control, is_set=False), _displayed(control)
        common = {"hint": control.hint, "order": order}
        if control.kind == "checkbox":
            return self._gui.add_checkbox(label, value, **common)
        if control.kind == "menu":
            options = [option or _NONE for option in control.options]
            return self._gui.add_dropdown(label, options, initial_value=value, **common)
        if control.kind == "vector":
            return self._gui.add_vector3(label, value, step=control.step or 0.001, **common)
        if control.kind == "text":
            return self._gui.add_text(label, value, **common)
        if control.kind == "number":
            return self._gui.add_number(
                label, value, min=control.low, max=control.high, step=_as(value, control.step), **common
            )
        low, high = _as(value, control.low), _as(value, control.high)
        return self._gui.add_slider(label, low, high, _as(value, control.step), value, **common)

    def _show_joints(self, joints: tuple[JointControl, ...]) -> None:
        wanted = {joint.name for joint in joints}
        for name in [name for name in self._sliders if name not in wanted]:
            self._sliders.pop(name)[1].remove()
        for order, joint in enumerate(joints):
            shape, handle = self._sliders.get(joint.name, ((), None))
            if handle is not None and shape != joint.shape:
                handle.remove()
                handle = None
            if handle is None:
                handle = self._add_joint(joint, float(order))
                self._sliders[joint.name] = (joint.shape, handle)
            handle.value = _position(joint)

    def _add_joint(self, joint: JointControl, order: float) -> Any:
        with self._joints:
            handle = self._gui.add_slider(
                f"{joint.name} [{joint.unit}]",
                joint.low,
                joint.high,
                joint.step,
                _position(joint),
                hint=joint.hint,
                disabled=joint.follows,
                order=1000.0 + order,
            )
        if not joint.follows:
            name = joint.name
            handle.on_update(
                self._by_person(lambda value: self._actions["move"](name, value), f"move {name}")
            )
        return handle

    def show_positions(self, moving: str = "") -> None:
        """Update the joints to the session; a joint held by a user only if it is blocked."""
        for joint in self._session.joints():
            handle = self._sliders[joint.name][1]
            if joint.name != moving or self._session.held:
                handle.value = _position(joint)
        tell(self.held, self._session.held, "held")

    def show_fault(self) -> None:
        """Show the error of the last request, or the summary of the asset."""
        session = self._session
        tell(self.fault, session.fault, "fault")
        if session.shown is None:
            return
        asset, milliseconds = session.asset, 1e3 * session.shown.seconds
        runs = sum(session.shown.evaluation.runs.values())
        parts = [f"{asset.name}: {len(asset.links)} links, {len(asset.joints)} joints"]
        if session.certificate is not None:  # masses take a while: not while a slider is dragged
            parts[0] += f", {asset.mass:.3g} kg"
            parts.append("proven" if session.certificate.proven else "not proven")
        parts.append(f"{runs} nodes in {milliseconds:.0f} ms")
        self.status.content = _text("; ".join(parts), "plain")
        self.python.content = _code(session.python())

    def show_proof(self, state: str = "") -> None:
        """Show the result or the progress of the certificate."""
        for button in self._witnesses:
            button.remove()
        self._witnesses = []
        certificate = self._session.certificate
        if certificate is None:
            self.verdict.content = _text(state, "plain")
            return
        self.verdict.content = _text(str(certificate), "plain" if certificate.proven else "fault")
        with self._proof:
            for number, pair in enumerate(self._session.collisions[:_WITNESSES]):
                assert pair.witness is not None
                depth = 1e3 * pair.witness.depth
                what = "worst pose" if number == 0 else "pose"
                button = self._gui.add_button(
                    f"{what}: {pair.links[0]}, {pair.links[1]} ({depth:.2f} mm)", color="red"
                )
                button.on_click(
                    lambda _, number=number: self._ask("pose", lambda: self._actions["worst"](number))
                )
                self._witnesses.append(button)


def _wish(parameter: str) -> str:
    return f"set {parameter}"


def _label(control: ParameterControl, *, is_set: bool) -> str:
    name = control.name.rpartition(".")[2]
    unit = f" [{control.unit}]" if control.unit else ""
    return f"{_SET if is_set else ''}{name}{unit}"


def _displayed(control: ParameterControl) -> Any:
    value = control.value
    if control.kind == "menu":
        return value or _NONE
    if control.kind in ("slider", "number"):
        return _short(value, control.step, control.low, control.high)
    return value


def _short(value: Any, step: float, low: float | None, high: float | None) -> Any:
    """Return a number with the digits of its step, for a narrow box."""
    digits = max(0, -math.floor(math.log10(step)))
    rounded = round(value, digits)
    lowest, highest = (_as(value, end) for end in (low, high))
    rounded = rounded if lowest is None else max(rounded, lowest)
    return rounded if highest is None else min(rounded, highest)


def _position(joint: JointControl) -> float:
    return float(_short(joint.value, joint.step, joint.low, joint.high))


def _as(value: Any, number: float | None) -> Any:
    """Return a number of the same type as a value."""
    return None if number is None else type(value)(number)


def tell(box: Any, text: str, style: str) -> None:
    """Show text in a box, which is hidden for an empty text."""
    box.content = _text(text, style) if text else ""
    box.visible = bool(text)


def _text(text: str, style: str) -> str:
    """Return text as escaped HTML in a box."""
    return f'<div style="{_BOX}white-space:pre-wrap;background:{_COLORS[style]}">{html.escape(text)}</div>'


def _code(text: str) -> str:
    """Return source as HTML with a copy button."""
    copy = "navigator.clipboard.writeText(this.previousElementSibling.textContent)"
    return (
        f'<div style="{_BOX}background:{_COLORS["plain"]}">'
        f'<pre style="white-space:pre-wrap;margin:0 0 0.5em;user-select:all">{html.escape(text)}</pre>'
        f'<button type="button" onclick="{copy}">copy as Python</button></div>'
    )

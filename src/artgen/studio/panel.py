"""Panel in the browser: parameters, joints, display options, certificate and export."""

import html
import math
import threading
from collections.abc import Callable, Mapping, Sequence
from functools import partial
from pathlib import Path
from typing import Any

from artgen.errors import ArtgenError, ParameterError
from artgen.export.layouts import DEFAULT_FORMATS, FORMATS
from artgen.studio.controls import StudioControl
from artgen.studio.session import Session, message_of
from artgen.studio.stage import Viewport
from artgen.studio.symbols import SYMBOLS
from artgen.view import opened


class Requests:
    """Requests of browsers by name; a new request replaces an earlier one of the same name."""

    def __init__(self) -> None:
        self._changed = threading.Condition()
        self._waiting: dict[str, Callable[[], None]] = {}

    def add(self, name: str, request: Callable[[], None]) -> None:
        """Queue a request."""
        with self._changed:
            self._waiting.pop(name, None)
            self._waiting[name] = request
            self._changed.notify()

    def __contains__(self, name: str) -> bool:
        with self._changed:
            return name in self._waiting

    def take(self, seconds: float) -> list[Callable[[], None]]:
        """Return the queued requests; if there are none, wait for at most this time [s]."""
        with self._changed:
            if not self._waiting:
                self._changed.wait(seconds)
            found, self._waiting = [*self._waiting.values()], {}
        return found


_NONE = "(none)"  # menu text of an empty string
_SET = "\N{BULLET} "  # prefix of the name of an overridden parameter
_MAPS = ("0", "256", "512", "1024")
_WITNESSES = 6  # most buttons of colliding poses
_BOX = (
    "margin:0.4em 0.4em 0.6em;padding:0.5em 0.7em;border-radius:4px;font-size:0.8em;overflow-wrap:anywhere;"
)
_COLORS = {
    "error": "#fde8e6;color:#8c1d13",
    "blocked": "#fff4d6;color:#6b4e00",
    "plain": "#eef2f6;color:#23313f",
}
_Handles = dict[str, tuple[tuple[Any, ...], Any]]  # shape and handle of each control by name


class Panel:
    """The controls of a session in a viser server, and their requests.

    Attributes:
        status: Summary of the asset.
        error: Error of the last request.
        seed: Control of the seed.
        verdict: Result of the certificate.
        exported: Result of the last export.
        python: Source of the asset.
    """

    def __init__(self, server: Any, session: Session, stage: Viewport, requests: Requests, out: Path) -> None:
        self._gui = server.gui
        self._session = session
        self._stage = stage
        self._requests = requests
        self._out = out
        self._controls: _Handles = {}
        self._folders: dict[str, Any] = {}
        self._sliders: _Handles = {}
        self._witnesses: list[Any] = []
        self._suggested = ""
        gui = self._gui
        gui.configure_theme(
            show_logo=False, show_share_button=False, brand_color=(0, 114, 178), control_width="large"
        )
        gui.set_panel_label("artgen studio")
        gui.main_panel.dock_right()
        self.status = gui.add_html("")
        self.error = gui.add_html("", visible=False)
        tabs = gui.add_tab_group()
        self._parameters = tabs.add_tab("Parameters")
        self._joints = tabs.add_tab("Joints")
        with tabs.add_tab("View"):
            self._add_view()
        self._proof = tabs.add_tab("Certificate")
        with tabs.add_tab("Export"):
            self._add_export()
        with self._parameters:
            self.seed = gui.add_number(
                "seed", session.seed, min=0, step=1, hint="determines all random values", order=-2.0
            )
            self._on_update(self.seed, "seed", lambda value: session.resample(int(value)))
            self._add_buttons("draw", {"resample": self._resample, "reset": session.reset}, order=-1.0)
        with self._joints:
            self.blocked = gui.add_html("", visible=False)
            self._add_buttons(
                "all", {"close": lambda: self._pose({}), "open": lambda: self._pose(opened(session.asset))}
            )
        with self._proof:
            self.verdict = gui.add_html("")

    def _add_buttons(self, name: str, actions: dict[str, Callable[[], None]], **options: Any) -> None:
        def press(event: Any) -> None:
            if event.target.value in actions:  # a malformed message may name another one
                self._requests.add(name, actions[event.target.value])

        self._gui.add_button_group(name, tuple(actions), **options).on_click(press)

    def _on_update(self, handle: Any, name: str, act: Callable[[Any], None]) -> None:
        """Queue a request for each value that a user sets, but not for those that this program sets."""

        def changed(event: Any) -> None:
            if event.client is not None:
                value = event.target.value
                self._requests.add(name, lambda: act(value))

        handle.on_update(changed)

    def _add_view(self) -> None:
        gui, stage = self._gui, self._stage
        for kind, title in SYMBOLS.items():
            box = gui.add_checkbox(title, initial_value=False)
            self._on_update(box, f"symbol {kind}", partial(stage.symbols.switch, kind))
        labels = gui.add_checkbox("semantic colors", initial_value=False)
        self._on_update(labels, "labels", lambda value: stage.update_materials(by_label=value))
        maps = gui.add_dropdown(
            "textures", _MAPS, initial_value="512", hint="texels per side of the maps; 0 for plain colors"
        )
        self._on_update(maps, "textures", lambda value: stage.update_materials(textures=int(value)))
        light = gui.add_checkbox(
            "reflections and shadows", stage.rich_light, hint="slow if the browser has no GPU"
        )
        self._on_update(light, "light", lambda value: stage.light(rich=value))

    def _add_export(self) -> None:
        gui = self._gui
        self._folder = gui.add_text("folder", "", hint=f"below {self._out}; created if missing")
        self._formats = {name: gui.add_checkbox(name, name in DEFAULT_FORMATS) for name in FORMATS}
        gui.add_button("export").on_click(lambda _: self._requests.add("export", self._export))
        self.exported = gui.add_html("", visible=False)
        gui.add_markdown("**As Python**")
        self.python = gui.add_html("")

    # requests

    def _resample(self) -> None:
        self._session.resample(self._session.seed + 1)
        self.seed.value = self._session.seed

    def _move(self, joint: str, position: float) -> None:
        if joint in self._session.asset.positions():  # a new asset may not have the joint
            self._session.move(joint, position)
            self._show_pose(joint)

    def _pose(self, q: Mapping[str, float], red: Sequence[str] = ()) -> None:
        self._session.pose(q)
        self._show_pose(red=red)

    def _show_pose(self, dragged: str = "", red: Sequence[str] = ()) -> None:
        self._stage.pose(self._session.q)
        self._stage.update_materials(red=red)
        self.show_positions(dragged)

    def _export(self) -> None:
        folder = self._folder.value.strip()
        formats = tuple(name for name, box in self._formats.items() if box.value)
        try:
            path = self._session.export(self._below(folder) if folder else "", formats)
        except ArtgenError as error:
            _show_text(self.exported, message_of(error), "error")
        else:
            _show_text(self.exported, f"written to {path.resolve()}", "plain")

    def _below(self, folder: str) -> Path:
        """Return a folder below `out`, with links resolved."""
        try:
            path = (self._out / folder).resolve()
        except (OSError, RuntimeError, ValueError):  # a loop of links, or a NUL character
            path = None
        if path is None or not path.is_relative_to(self._out):
            raise ParameterError(
                f"folder {folder!r} is not allowed: give a folder below {self._out}, "
                "or start the studio with another --out"
            )
        return path

    # updates from the session

    def show(self) -> None:
        """Update the panel to a new asset: its parameters and joints, with their values."""
        controls = self._session.controls()
        self._renew(self._controls, controls, self._add_parameter)
        for control in controls:
            handle = self._controls[control.name][1]
            if f"set {control.name}" not in self._requests:  # a user has not changed it since
                handle.value = _displayed(control)
            handle.label = (_SET if self._session.is_set(control) else "") + _label(control)
        groups = [f"{control.group}." for control in controls]
        for name in list(self._folders):
            if not any(group.startswith(f"{name}.") for group in groups):
                self._folders.pop(name).remove()
        self._renew(self._sliders, self._session.joints(), self._add_joint)
        self.show_positions()
        if self._folder.value in ("", self._suggested):
            self._suggested = self._folder.value = self._session.asset.name

    def _renew(
        self, handles: _Handles, controls: Sequence[StudioControl], add: Callable[[StudioControl, float], Any]
    ) -> None:
        """Remove the controls that are gone, and add new ones and those with another shape."""
        shapes = {control.name: control.shape for control in controls}
        for name in [name for name, (shape, _) in handles.items() if shape != shapes.get(name)]:
            handles.pop(name)[1].remove()
        for order, control in enumerate(controls):
            if control.name not in handles:
                handles[control.name] = (control.shape, add(control, float(order)))

    def _folder_of(self, group: str, order: float) -> Any:
        """Return the folder of a generator's parameters, inside the folders of its selecting generators."""
        if not group:
            return self._parameters
        if group not in self._folders:
            parent, _, generator = group.rpartition(".")
            owner, _, parameter = parent.rpartition(".")
            with self._folder_of(owner, order):
                self._folders[group] = self._gui.add_folder(f"{parameter}: {generator}", order=order - 0.5)
        return self._folders[group]

    def _add_parameter(self, control: StudioControl, order: float) -> Any:
        name = control.name
        with self._folder_of(control.group, order):
            handle = self._add_control(control, order)
        self._on_update(
            handle, f"set {name}", lambda value: self._session.set(name, "" if value == _NONE else value)
        )
        return handle

    def _add_control(self, control: StudioControl, order: float) -> Any:
        gui, label, value = self._gui, _label(control), _displayed(control)
        common = {"hint": control.hint, "order": order}
        if control.kind == "checkbox":
            return gui.add_checkbox(label, value, **common)
        if control.kind == "menu":
            options = [option or _NONE for option in control.options]
            return gui.add_dropdown(label, options, initial_value=value, **common)
        if control.kind == "vector":
            return gui.add_vector3(label, value, step=0.001, **common)
        if control.kind == "text":
            return gui.add_text(label, value, **common)
        number: Any = type(value)  # all numbers of a control are of one type
        if control.kind == "number":
            step = number(control.step)
            return gui.add_number(label, value, min=control.low, max=control.high, step=step, **common)
        low, high, step = map(number, (control.low, control.high, control.step))
        return gui.add_slider(label, low, high, step, value, disabled=control.follows, **common)

    def _add_joint(self, joint: StudioControl, order: float) -> Any:
        with self._joints:
            handle = self._add_control(joint, 1000.0 + order)
        if not joint.follows:
            self._on_update(handle, f"move {joint.name}", lambda value: self._move(joint.name, value))
        return handle

    def show_positions(self, dragged: str = "") -> None:
        """Update the joints to the session; the joint that a user moves only if it is blocked."""
        for joint in self._session.joints():
            if joint.name != dragged or self._session.blocked:
                self._sliders[joint.name][1].value = _displayed(joint)
        _show_text(self.blocked, self._session.blocked, "blocked")

    def show_error(self) -> None:
        """Show the error of the last request, or the summary of the asset."""
        session, shown = self._session, self._session.shown
        _show_text(self.error, session.error, "error")
        if shown is None:
            return
        asset = shown.asset
        parts = [f"{asset.name}: {len(asset.links)} links, {len(asset.joints)} joints"]
        if session.certificate is not None:  # masses take too long while a slider is dragged
            parts[0] += f", {asset.mass:.3g} kg"
            parts.append("proven" if session.certificate.proven else "not proven")
        parts.append(f"{sum(shown.evaluation.runs.values())} nodes in {1e3 * shown.seconds:.0f} ms")
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
        self.verdict.content = _text(str(certificate), "plain" if certificate.proven else "error")
        with self._proof:
            for number, pair in enumerate(self._session.collisions[:_WITNESSES]):
                assert pair.witness is not None
                depth = 1e3 * pair.witness.depth
                title = f"{'pose' if number else 'worst pose'}: {', '.join(pair.links)} ({depth:.2f} mm)"
                button = self._gui.add_button(title, color="red")
                show = partial(self._pose, pair.witness.pose, pair.links)
                button.on_click(lambda _, show=show: self._requests.add("pose", show))
                self._witnesses.append(button)


def _label(control: StudioControl) -> str:
    name = control.name.rpartition(".")[2]
    return f"{name} [{control.unit}]" if control.unit else name


def _displayed(control: StudioControl) -> Any:
    """Return a value for its control: a number has the digits of its step, to fit a narrow box."""
    value = control.value
    if control.kind == "menu":
        return value or _NONE
    if control.kind not in ("slider", "number"):
        return value
    rounded = round(value, max(0, -math.floor(math.log10(control.step))))
    if control.low is None or control.high is None:
        return rounded
    return type(value)(min(max(rounded, control.low), control.high))


def _show_text(box: Any, text: str, style: str) -> None:
    """Show text in a box; hide the box if the text is empty."""
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

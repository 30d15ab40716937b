"""The page itself, in NiceGUI: it shows what a `Session` says, and passes on what is typed, moved and clicked.

Tried beside Panel with the same page (a number field that redraws a picture of 500 points, in headless Chromium):
30 ms a change against 84 ms, 29 MB installed against 150 MB; neither asks another machine for anything.
"""

from __future__ import annotations

import tempfile
from pathlib import Path
from typing import Any

from nicegui import events, run, ui

from mpsolve.errors import InputError, MpsolveError
from mpsolve.explorer.form import Form, heading
from mpsolve.explorer.player import BLUE, CSS, SCRIPT
from mpsolve.explorer.proof_panel import ProofPanel, vibration
from mpsolve.explorer.session import Session
from mpsolve.presets.written import names, problem_of
from mpsolve.problem.inputfile import read_problem
from mpsolve.problem.problem import Problem

_TICK = 0.04
_PATIENCE = 60.0  # s that a browser may be silent, as on a busy machine, before what it shows is given up


def serve(problem: Problem, title: str, port: int, show: bool) -> None:
    """Serve the page on this machine only, until it is stopped."""

    @ui.page("/")
    def _page() -> None:
        Tab(Session.of(problem, title)).build()

    ui.add_css(CSS, shared=True)
    ui.add_head_html(SCRIPT, shared=True)
    ui.run(
        host="127.0.0.1", port=port, show=show, reload=False, title="mpsolve explorer", dark=None,
        show_welcome_message=False, uvicorn_logging_level="warning", favicon="🛤", reconnect_timeout=_PATIENCE,
    )  # fmt: skip


class Tab:
    """One open page."""

    def __init__(self, session: Session) -> None:
        self.session = session
        self.busy = False
        self.refused: dict[str, str] = {}

    # --- what stands where ---------------------------------------------------------------------------------

    def build(self) -> None:
        ui.colors(primary=BLUE)
        with ui.header().classes("items-center gap-2"):
            ui.label("mpsolve explorer").classes("text-lg font-bold").props("role=heading aria-level=1")
            ui.space()
            ui.button("Undo", on_click=self.undo).props("flat color=white id=undo")
            ui.button("Redo", on_click=self.redo).props("flat color=white id=redo")
            ui.button("Save as TOML", on_click=self.save).props("flat color=white id=save")
        with ui.element("main").classes("w-full grid grid-cols-1 lg:grid-cols-3 gap-4 max-w-screen-2xl"):
            with ui.column().classes("w-full"):
                self._sources()
                self.form = Form(self.session)
            with ui.column().classes("w-full lg:col-span-2 order-first lg:order-none"):
                self._results()
        self.form.draw()
        self.draw()
        ui.timer(_TICK, self.tick)
        ui.context.client.on_disconnect(self.session.stop_proof)

    def _sources(self) -> None:
        with ui.expansion("Start from a preset or a file").classes("w-full").props("id=sources"):
            self.track = ui.select(list(names("track")), label="Track").classes("w-full")
            self.vehicle = ui.select(
                ["its usual one", *names("vehicle")], value="its usual one", label="Vehicle"
            ).classes("w-full")
            ui.button("Open the preset", on_click=self.open_preset).props("id=open-preset")
            ui.upload(label="An input file (TOML)", auto_upload=True, on_upload=self.open_file).props(
                "accept=.toml"
            ).classes("w-full")

    def _results(self) -> None:
        self.verdict = ui.label().classes("text-base font-bold").props("aria-live=polite id=verdict role=status")
        self.proof = ProofPanel(self.session, self.draw_chart, self.show_chart)
        heading("Vibrations, and the cuts of the track")
        with ui.row().classes("gap-2"):
            ui.button("Zoom in", on_click=lambda: self.zoom(0.5)).props("outline dense id=zoom-in")
            ui.button("Zoom out", on_click=lambda: self.zoom(2.0)).props("outline dense id=zoom-out")
            ui.button("Fit", on_click=lambda: self.zoom(None)).props("outline dense id=fit")
        self.plane = ui.html("", sanitize=False).classes("w-full").props("id=plane")
        self.roots = (
            ui.select({}, label="Vibration that is shown below", on_change=self.choose)
            .classes("w-full")
            .props("id=roots")
        )
        self.shape = ui.html("", sanitize=False).classes("w-full").props("id=shape")
        heading("Growing vibrations over two parameters")
        with ui.row().classes("items-center gap-2 w-full"):
            self.chart_x = ui.select({}, label="Chart over").classes("w-64")
            self.chart_y = ui.select({}, label="and over").classes("w-64")
            self.draw_axes()
            ui.button("Draw the chart", on_click=self.draw_chart).props("outline id=draw-chart")
        self.chart = ui.html("", sanitize=False).classes("w-full").props("id=chart")
        heading("The motion in time")
        with ui.row().classes("items-center gap-2"):
            self.duration = ui.input(label="Time after it is put on the track", value="2 s").props(
                "for=duration dense"
            )
            ui.button("Show the motion", on_click=self.draw_motion).props("outline id=draw-motion")
        self.moving = ui.html("", sanitize=False).classes("w-full").props("id=moving")
        self.motion = ui.html("", sanitize=False).classes("w-full").props("id=motion")

    def draw_axes(self) -> None:
        """The parameters that a chart can be over; those that were chosen stay, where the problem has them."""
        axes = self.session.axes()
        second = next((path for path in axes if "wheel" in path or path.endswith(".M")), list(axes)[-1])
        for select, usual in ((self.chart_x, next(iter(axes))), (self.chart_y, second)):
            select.set_options(axes, value=select.value if select.value in axes else usual)

    def draw(self) -> None:
        session = self.session
        self.verdict.set_text(session.verdict())
        self.plane.set_content(session.plane())
        view = session.view
        labels = {} if view is None else {k: vibration(q) for k, q in enumerate(view.roots) if q.real >= 0}
        self.roots.set_options(labels, value=session.chosen if session.chosen in labels else None)
        self.shape.set_content(session.shape())
        self.show_chart()
        self.show_motion()

    # --- what is done --------------------------------------------------------------------------------------

    async def tick(self) -> None:
        """Take what was typed and moved since; of many quick changes only the last one counts."""
        self.proof.watch()
        if self.busy or not (self.form.pending or self.session.quick):
            return
        self.busy = True
        changes = self.form.taken()
        try:
            if changes:
                self.refused.clear()
            for path, value in changes.items():
                await self._take(path, value)
            if not changes:
                await run.io_bound(self.session.settle)
            self.draw()
            if self.refused:
                self.verdict.set_text(list(self.refused.values())[-1])
        finally:
            self.busy = False

    async def _take(self, path: str, value: object) -> None:
        """A change, and what has waited for it; or why it cannot be."""
        waited = set(self.session.waiting.values)
        axes = set(self.session.axes())
        try:
            await run.io_bound(self.session.nudge, path, value)
        except InputError as error:
            self.refused[path] = str(error)
            return
        for one in {path} | waited - set(self.session.waiting.values):
            self.refused.pop(one, None)
            self.form.follow(one)
        if set(self.session.axes()) != axes:
            self.draw_axes()

    def undo(self) -> None:
        self.session.undo()
        self.redraw()

    def redo(self) -> None:
        self.session.redo()
        self.redraw()

    def redraw(self) -> None:
        self.refused.clear()
        self.draw_axes()
        self.form.draw()
        self.draw()

    def zoom(self, factor: float | None) -> None:
        self.session.zoom(factor)
        self.draw()

    def choose(self, event: events.ValueChangeEventArguments[Any]) -> None:
        if event.value is not None and event.value != self.session.chosen:
            self.session.choose(event.value)
            self.plane.set_content(self.session.plane())
            self.shape.set_content(self.session.shape())

    def open_preset(self) -> None:
        if self.track.value is None:
            self.verdict.set_text("Choose a track first.")
            return
        vehicle = None if self.vehicle.value == "its usual one" else self.vehicle.value
        try:
            self.session.open(*problem_of(self.track.value, vehicle))
        except InputError as error:
            self.verdict.set_text(str(error))
            return
        self.redraw()

    async def open_file(self, event: events.UploadEventArguments) -> None:
        with tempfile.TemporaryDirectory() as folder:
            path = Path(folder) / "input.toml"
            path.write_bytes(await event.file.read())
            try:
                read = read_problem(path)
                self.session.open(read.problem, read.title)
            except InputError as error:
                self.verdict.set_text(str(error).replace(str(path), event.file.name))
                return
        self.redraw()

    def save(self) -> None:
        try:
            ui.download(self.session.toml().encode(), "problem.toml")
        except InputError as error:
            self.verdict.set_text(str(error))

    async def draw_chart(self) -> None:
        try:
            await run.io_bound(self.session.draw_chart, self.chart_x.value, self.chart_y.value)
        except InputError as error:
            self.verdict.set_text(str(error))
        self.show_chart()

    def show_chart(self) -> None:
        self.chart.set_content(self.session.chart_picture())

    async def draw_motion(self) -> None:
        try:
            await run.io_bound(self.session.draw_motion, self.duration.value)
        except (MpsolveError, ArithmeticError) as error:
            self.verdict.set_text(str(error))
        self.show_motion()

    def show_motion(self) -> None:
        self.moving.set_content(self.session.moving)
        self.motion.set_content(self.session.motion)

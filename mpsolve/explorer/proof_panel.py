"""The part of the page that proves: its buttons, how far the work is, the answer, its certificate and the report."""

from __future__ import annotations

import tempfile
from collections.abc import Awaitable, Callable
from contextlib import suppress
from pathlib import Path
from typing import TYPE_CHECKING

from nicegui import ui

from mpsolve.errors import MpsolveError
from mpsolve.explorer.proving import Proving
from mpsolve.explorer.session import Session

if TYPE_CHECKING:
    from mpsolve.spectrum.spectrum import Spectrum


class ProofPanel:
    """Buttons and what they lead to; `watch` is called again and again and takes what has arrived."""

    def __init__(self, session: Session, draw: Callable[[], Awaitable[None]], show: Callable[[], None]) -> None:
        """draw: make a chart; show: put it on the page with what has been proved."""
        self.session, self.draw_chart, self.show_chart = session, draw, show
        with ui.row().classes("items-center gap-2"):
            ui.button("Prove what is shown", on_click=self.prove).props("id=prove")
            self.stop = ui.button("Stop", on_click=session.stop_proof).props("outline id=stop")
            bar = ui.linear_progress(value=0, show_value=False).classes("w-40")
            self.progress = bar.props('aria-label="progress of the proof"')
            save = ui.button("Certificate", on_click=self.save_certificate)
            self.certificate = save.props("outline id=certificate")
            ui.button("Report", on_click=session.start_report).props("outline id=report")
            self.writing = ui.label().props("aria-live=polite id=writing role=status")
        self.proof = ui.label().classes("whitespace-pre-line").props("aria-live=polite id=proof role=status")
        self._busy(False)
        self.certificate.set_visibility(False)

    def _busy(self, busy: bool) -> None:
        self.stop.set_visibility(busy)
        self.progress.set_visibility(busy)

    async def prove(self) -> None:
        if self.session.chart_axes() is None:
            await self.draw_chart()
        self.session.start_proof(self.session.chart_axes() or ())
        self.certificate.set_visibility(False)
        self._busy(True)
        self.proof.set_text("Proving …")

    def watch(self) -> None:
        self._watch_proof()
        self._watch_report()

    def _watch_proof(self) -> None:
        proving = self.session.proving
        if proving is None:
            return
        proving.poll()
        self.progress.set_value(proving.fraction)
        if self.session.note_proof():
            self.show_chart()
        if proving.running:
            self.proof.set_text(f"Proving: {proving.stage}")
            return
        self._busy(False)
        text = told(proving.answer) if proving.answer is not None else f"The proof ended: {proving.failure}"
        text += region_told(proving)
        if proving.problem != self.session.problem:
            text += "\n(of the state at which it was started)"
        self.proof.set_text(text)
        self.certificate.set_visibility(proving.answer is not None and proving.answer.certificate is not None)

    def _watch_report(self) -> None:
        """Say how far the report is, and hand it out once."""
        writing = self.session.reporting
        if writing is None:
            return
        writing.poll()
        if writing.running:
            self.writing.set_text(f"Report: {writing.stage}")
            return
        self.session.reporting = None
        if writing.answer is None:
            self.writing.set_text(f"The report ended: {writing.failure}")
        else:
            self.writing.set_text("The report is written.")
            ui.download(writing.answer.encode(), "report.html")

    def save_certificate(self) -> None:
        proving = self.session.proving
        if proving is None or proving.answer is None:
            return
        with tempfile.TemporaryDirectory() as folder, suppress(MpsolveError):
            path = Path(proving.answer.certificate.save(Path(folder) / "certificate.json"))
            ui.download(path.read_bytes(), "certificate.json")


def vibration(q: complex) -> str:
    """A root as a vibration."""
    frequency, rate = abs(q.real) / 6.283185307179586, -q.imag
    grows = f"doubles every {0.6931471805599453 / rate:.3g} s" if rate > 0 else f"decays at {-rate:.3g} 1/s"
    return f"{frequency:.4g} Hz, {grows}"


def region_told(proving: Proving) -> str:
    """What is proved of the region, in words."""
    if proving.region is None:
        return ""
    ends = (f"{path} from {float(a):.5g} to {float(b):.5g}" for path, (a, b) in proving.region.items())
    return f"\nStable all over {' and '.join(ends)}: proved; outlined on the chart."


def told(answer: Spectrum) -> str:
    """The verdict of a proof, what is proved, and what has confirmed it; the equations stand in the certificate."""
    from mpsolve.report import spectrum_words

    confirmed = spectrum_words.verified(answer).split("\n")[0]
    return "\n".join([spectrum_words.verdict(answer), *spectrum_words.proved(answer), confirmed])

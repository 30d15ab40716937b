"""The panel says how far a proof is, what came of it, and of which state."""

from __future__ import annotations

from fractions import Fraction
from types import SimpleNamespace
from typing import Any

import pytest

from mpsolve import certify, read_problem
from mpsolve.explorer.proof_panel import ProofPanel, region_told, told, vibration
from mpsolve.explorer.proving import Proving

pytest.importorskip("nicegui", reason="the extra `explore` is not installed")


class Widget:
    """What a label, a button or a bar was told."""

    text, visible, value = "", True, 0.0

    def set_text(self, text: str) -> None:
        self.text = text

    def set_visibility(self, visible: bool) -> None:
        self.visible = visible

    def set_value(self, value: float) -> None:
        self.value = value


def work(**more: Any) -> Any:
    """Work of one problem, under way."""
    usual = {"running": True, "stage": "counting", "fraction": 0.5, "answer": None, "failure": "", "region": None}
    return SimpleNamespace(poll=lambda: None, problem="this", **usual | more)


@pytest.fixture
def panel() -> ProofPanel:
    """A panel without a page."""
    made, shown = object.__new__(ProofPanel), []
    made.session = SimpleNamespace(proving=None, reporting=None, problem="this", note_proof=lambda: True)
    made.stop, made.progress, made.certificate, made.proof, made.writing = (Widget() for _ in range(5))
    made.show_chart = lambda: shown.append(1)
    made.shown = shown
    return made


def test_a_proof_under_way_and_stopped(panel: ProofPanel) -> None:
    panel.watch()
    assert panel.proof.text == ""
    panel.session.proving = work()
    panel.watch()
    assert (panel.proof.text, panel.progress.value, len(panel.shown)) == ("Proving: counting", 0.5, 1)
    panel.session.proving, panel.session.problem = work(running=False, failure="stopped"), "another"
    panel.watch()
    assert panel.proof.text == "The proof ended: stopped\n(of the state at which it was started)"
    assert (panel.stop.visible, panel.certificate.visible) == (False, False)


def test_a_report_under_way_and_refused(panel: ProofPanel) -> None:
    panel.session.reporting = work(stage="drawing")
    panel.watch()
    assert panel.writing.text == "Report: drawing"
    panel.session.reporting = work(running=False, failure="no room")
    panel.watch()
    assert panel.writing.text == "The report ended: no room"
    assert panel.session.reporting is None


PROBLEM = read_problem("examples/two_layer_bogie.toml").problem


def test_a_vibration_grows_or_decays() -> None:
    assert vibration(62.831853 - 0.1j) == "10 Hz, doubles every 6.93 s"
    assert vibration(62.831853 + 0.1j) == "10 Hz, decays at 0.1 1/s"


def test_a_proof_and_its_region() -> None:
    answer = certify(PROBLEM, region="unstable", digits=15)
    assert told(answer).startswith("STABLE")
    assert "verifier confirms" in told(answer)
    assert len(told(answer).splitlines()) < 8  # no equations
    proving = Proving(PROBLEM)
    assert region_told(proving) == ""
    proving.region = {"v": (Fraction(50), Fraction(150)), "vehicles[0].wheel": (Fraction(1, 3), Fraction(2))}
    assert "v from 50 to 150 and vehicles[0].wheel from 0.33333 to 2: proved" in region_told(proving)

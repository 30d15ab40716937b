"""The page in a real browser: its numbers are the library's, the last quick change counts, the certificate holds."""

from __future__ import annotations

import os
import signal
import socket
import subprocess
import sys
import time
from collections.abc import Iterator
from contextlib import closing
from pathlib import Path
from typing import Any

import pytest

from mpsolve import Problem, read_problem, vehicles, verify
from mpsolve.batch.view import look
from tests.browsers import NONE, browser

pytest.importorskip("nicegui", reason="the extra `explore` is not installed")
driver = pytest.importorskip("playwright.sync_api", reason="playwright, which drives a browser, is not installed")

FILE = Path("examples/two_layer_bogie.toml")


pytestmark = pytest.mark.skipif(browser() is None, reason=NONE)


@pytest.fixture(scope="module")
def address() -> Iterator[str]:
    with closing(socket.socket()) as free:
        free.bind(("127.0.0.1", 0))
        port = free.getsockname()[1]
    command = [sys.executable, "-m", "mpsolve", "explore", str(FILE), "--port", str(port), "--no-browser"]
    quiet = {key: value for key, value in os.environ.items() if not key.startswith(("PYTEST", "NICEGUI"))}
    server = subprocess.Popen(command, env=quiet, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
    end = time.monotonic() + 60
    while time.monotonic() < end:
        with closing(socket.socket()) as probe:
            if probe.connect_ex(("127.0.0.1", port)) == 0:
                break
        time.sleep(0.1)
    yield f"http://127.0.0.1:{port}/"
    server.send_signal(signal.SIGINT)
    server.communicate(timeout=30)


@pytest.fixture(scope="module")
def chromium() -> Iterator[Any]:
    with driver.sync_playwright() as play:
        opened = play.chromium.launch(executable_path=browser(), args=["--no-sandbox"])
        yield opened
        opened.close()


class Seen:
    """A tab, what its console said, and what it asked of other machines."""

    def __init__(self, chromium: Any, address: str) -> None:
        self.page = chromium.new_page(viewport={"width": 1300, "height": 900})
        self.said: list[str] = []
        self.asked: list[str] = []
        self.page.on("console", lambda m: self.said.append(m.text) if m.type in ("error", "warning") else None)
        self.page.on("pageerror", lambda e: self.said.append(str(e)))
        self.page.on(
            "request",
            lambda r: (
                self.asked.append(r.url)
                if not r.url.startswith((address, "data:", "blob:", address.replace("http", "ws")))
                else None
            ),
        )
        self.page.goto(address)
        self.page.wait_for_selector("#plane svg")

    def type(self, name: str, text: str) -> None:
        field = self.page.locator(f"#field-{name}")
        field.fill(text)
        field.blur()

    def verdict(self, pattern: str) -> str:
        self.page.wait_for_function(
            "p => new RegExp(p).test(document.querySelector('#verdict').innerText)", arg=pattern, timeout=60_000
        )
        return str(self.page.inner_text("#verdict"))


@pytest.fixture
def seen(chromium: Any, address: str) -> Iterator[Seen]:
    tab = Seen(chromium, address)
    yield tab
    assert tab.said == []
    assert tab.asked == []
    tab.page.close()


def test_numbers_agree_with_the_library(seen: Seen) -> None:
    seen.type("v", "5040 km/h")
    said = seen.verdict("roots found grow")
    view = look(read_problem(FILE).problem.changed("v", 1400))
    assert said.startswith(f"{view.growing} of")
    shown = sorted(float(mark.get_attribute("data-re")) for mark in seen.page.locator("#plane [data-root]").all())
    assert shown == pytest.approx(sorted(view.roots.real), rel=1e-5)


def test_a_slider_moves_and_undo_comes_back(seen: Seen) -> None:
    slider = seen.page.locator("#slider-v [tabindex='0']").first
    slider.focus()
    before = seen.page.input_value("#field-v")
    for _ in range(30):
        seen.page.keyboard.press("ArrowRight")
    seen.page.wait_for_function("v => document.querySelector('#field-v').value !== v", arg=before, timeout=60_000)
    time.sleep(0.5)
    assert float(seen.page.input_value("#field-v")) > float(before)
    for _ in range(8):  # one step where the machine is quick
        seen.page.click("#undo")
        time.sleep(0.3)
        if seen.page.input_value("#field-v") == before:
            break
    seen.page.wait_for_function("v => document.querySelector('#field-v').value === v", arg=before, timeout=60_000)


def test_a_slider_stands_for_every_parameter_and_where_a_field_says(seen: Seen) -> None:
    assert seen.page.locator("input[id^=field-]").count() == seen.page.locator("[id^=slider-]").count() > 10
    seen.type("track-eta", "0.0001")  # it was 0
    seen.page.wait_for_function(
        """() => { const root = document.querySelector('#slider-track-eta');
        const e = root.matches('[aria-valuenow]') ? root : root.querySelector('[aria-valuenow]');
        return e && +e.getAttribute('aria-valuenow') > 10 }"""
    )
    assert float(seen.page.input_value("#field-track-eta")) == 0.0001


def test_what_is_left_out_is_put_in_and_taken_out(seen: Seen, tmp_path: Path) -> None:
    """A body comes with its spring; emptied fields make a contact rigid; the file is that of the state."""
    page, before = seen.page, read_problem(FILE).problem
    body = page.locator("#field-vehicles-0-body")
    assert (body.input_value(), body.get_attribute("placeholder")) == ("", "left out: no body")
    seen.type("vehicles-0-body", "5 t")
    seen.verdict("k2.*waits")
    seen.type("vehicles-0-k2", "1 MN/m")
    page.wait_for_function("document.querySelector('#field-vehicles-0-body').value === '5000'")
    seen.verdict("No growing")
    seen.type("vehicles-0-k_contact", "")
    time.sleep(0.5)
    with page.expect_download() as loading:
        page.click("#save")
    loading.value.save_as(tmp_path / "state.toml")
    vehicle = vehicles.Bogie(**before.vehicles[0].vehicle.parameters | {"body": 5000, "k2": "1e6", "k_contact": None})
    assert read_problem(tmp_path / "state.toml").problem == Problem(
        before.track, vehicle.at(before.vehicles[0].position), before.v
    )
    page.click("#undo")
    page.wait_for_function("document.querySelector('#field-vehicles-0-k_contact').value !== ''")


def test_a_force_that_may_be_negative_slides_to_both_sides(seen: Seen) -> None:
    slider = seen.page.locator("#slider-track-N [tabindex='0']").first
    slider.focus()
    for _ in range(5):
        seen.page.keyboard.press("ArrowLeft")
    seen.page.wait_for_function("+document.querySelector('#field-track-N').value < 0")


def test_a_hundred_quick_changes_end_at_the_last(seen: Seen) -> None:
    for k in range(100):
        seen.type("v", str(100 + k))
    seen.type("v", "1400")
    assert seen.verdict("4 of the roots found grow")


def test_what_cannot_be_is_said(seen: Seen) -> None:
    seen.type("v", "12 kg")
    assert "v" in seen.verdict("kg")


def test_it_proves_and_hands_out_a_certificate_that_verifies(seen: Seen, tmp_path: Path) -> None:
    seen.page.click("#prove")
    seen.page.wait_for_selector("#certificate", state="visible", timeout=60_000)
    assert "STABLE" in seen.page.inner_text("#proof")
    with seen.page.expect_download() as loading:
        seen.page.click("#certificate")
    path = tmp_path / "certificate.json"
    loading.value.save_as(path)
    assert verify(path).valid
    with seen.page.expect_download() as loading:
        seen.page.click("#save")
    loading.value.save_as(tmp_path / "state.toml")
    assert read_problem(tmp_path / "state.toml").problem == read_problem(FILE).problem


def test_the_proved_region_is_marked_and_a_report_handed_out(seen: Seen, tmp_path: Path) -> None:
    seen.page.click("#prove")
    seen.page.wait_for_selector("#chart path.sure", state="attached", timeout=90_000)
    seen.page.wait_for_function("document.querySelector('#proof').innerText.includes('Stable all over')")
    with seen.page.expect_download(timeout=240_000) as loading:
        seen.page.click("#report")
    loading.value.save_as(tmp_path / "report.html")
    text = (tmp_path / "report.html").read_text("utf-8")
    assert "STABLE" in text
    assert 'id="limits"' in text


def test_the_keyboard_and_a_screen_reader_reach_everything(seen: Seen) -> None:
    """Every control has a name; Tab comes to the fields, a slider and the proof; the verdict is announced."""
    names = seen.page.evaluate(
        """() => [...document.querySelectorAll('button, input, [role=slider], [role=combobox]')].filter(e =>
        e.offsetParent !== null && !(e.innerText || e.getAttribute('aria-label') || (e.labels && e.labels.length) ||
        e.closest('[aria-label]') || e.closest('label'))).map(e => e.outerHTML.slice(0, 120))"""
    )
    assert names == []
    assert seen.page.get_attribute("#verdict", "aria-live") == "polite"
    reached = set()
    for _ in range(120):
        seen.page.keyboard.press("Tab")
        reached.add(
            seen.page.evaluate(
                "(document.activeElement.closest('[id]') || {}).id + ' ' + document.activeElement.tagName"
            )
        )
    found = " ".join(map(str, reached))
    assert all(name in found for name in ("undo", "save", "field-v", "prove", "report", "draw-chart"))


def test_a_preset_is_opened(seen: Seen) -> None:
    seen.page.click("#sources")
    seen.page.get_by_label("Track", exact=True).click()
    seen.page.get_by_role("option", name="paper").click()
    seen.page.click("#open-preset")
    seen.page.wait_for_selector("#field-track-c", timeout=30_000)
    assert float(seen.page.input_value("#field-v")) == 100
    assert "gap" in seen.page.inner_text("main")
    seen.page.get_by_label("and over", exact=True).click()
    assert seen.page.get_by_role("option", name="(track.c)").count() == 1  # axes are those of the new problem


def test_the_motion_is_shown(seen: Seen) -> None:
    seen.page.fill("#duration", "0.1 s")
    seen.page.click("#draw-motion")
    seen.page.wait_for_selector("#motion svg", timeout=60_000)
    assert seen.page.locator("#motion svg").count() == 2


NOW = "+document.querySelector('#moving input').value"
RAIL = "document.querySelector('#moving polyline').animatedPoints[40].y"


def test_the_shape_in_time_plays_and_rests_by_keyboard(seen: Seen) -> None:
    page = seen.page
    page.fill("#duration", "0.1 s")
    page.click("#draw-motion")
    page.wait_for_selector("#moving svg", timeout=60_000)
    page.wait_for_function(f"{NOW} > 0.002")  # it plays
    assert page.evaluate("document.querySelector('#moving output').textContent").endswith(" s")
    button = page.locator("#moving button")
    button.focus()
    page.keyboard.press("Enter")
    assert button.inner_text() == "Play"
    at = page.evaluate(NOW)
    time.sleep(0.3)
    assert page.evaluate(NOW) == at
    page.locator("#moving input").focus()
    page.keyboard.press("Home")
    rest = page.evaluate(RAIL)
    for _ in range(30):
        page.keyboard.press("ArrowRight")
    page.wait_for_function(f"{RAIL} > {rest} + 5")  # the rail has gone down
    assert page.evaluate(NOW) == pytest.approx(0.03)
    button.focus()
    page.keyboard.press("Space")
    page.wait_for_function(f"{NOW} > 0.032")
    seen.type("v", "90")
    page.wait_for_selector("#moving svg", state="detached")


def test_nothing_moves_by_itself_where_less_motion_is_asked_for(seen: Seen) -> None:
    page = seen.page
    page.emulate_media(reduced_motion="reduce")
    page.reload()
    page.wait_for_selector("#shape svg animate", state="attached")
    page.wait_for_function("document.querySelector('#shape svg').animationsPaused()")
    page.fill("#duration", "0.1 s")
    page.click("#draw-motion")
    page.wait_for_selector("#moving button", timeout=60_000)
    assert page.inner_text("#moving button") == "Play"
    time.sleep(0.3)
    assert page.evaluate(NOW) == 0
    page.click("#moving button")
    page.wait_for_function(f"{NOW} > 0.001")


def test_two_tabs_do_not_share(chromium: Any, address: str, seen: Seen) -> None:
    other = Seen(chromium, address)
    other.type("v", "1400")
    other.verdict("4 of the roots found grow")
    assert "No growing" in seen.page.inner_text("#verdict")
    other.page.close()


def test_a_phone_can_read_it(seen: Seen) -> None:
    seen.page.set_viewport_size({"width": 390, "height": 844})
    time.sleep(0.3)
    assert seen.page.evaluate("document.documentElement.scrollWidth") <= 390


def test_it_is_bound_to_this_machine(address: str) -> None:
    """At 127.0.0.2 a server that listens everywhere answers too."""
    port = int(address.rsplit(":", 1)[1].strip("/"))
    others = {entry[4][0] for entry in socket.getaddrinfo(socket.gethostname(), None, socket.AF_INET)} - {"127.0.0.1"}
    for other in {*others, "127.0.0.2"}:
        with closing(socket.socket()) as probe:
            probe.settimeout(2)
            assert probe.connect_ex((other, port)) != 0

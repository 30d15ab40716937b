"""The page in a real browser: it opens without a message, and what it shows and hands out is what was proved."""

from __future__ import annotations

import json
import re
import subprocess
import time
import xml.etree.ElementTree as ET
from fractions import Fraction
from html import unescape
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from mpsolve import InputError, verify
from mpsolve.files import write_whole
from mpsolve.model.parameters import PhysicalCase
from mpsolve.report.answer import Source
from mpsolve.report.page import report_page
from mpsolve.report.page_parts import gather
from mpsolve.report.pdf import browser

# much damping makes a case that is decided quickly
CASE = PhysicalCase(EI="6.4e6", m=60, k="1e6", v=300, c=9000, masses=[(1000, 0)])
QUIET = [
    *("--headless", "--no-sandbox", "--disable-gpu", "--disable-quic", "--no-first-run", "--disable-sync"),
    *("--disable-background-networking", "--disable-component-update", "--enable-logging=stderr", "--v=0"),
]
SVG = "{http://www.w3.org/2000/svg}"
NO_BROWSER = "no Chromium, Chrome or Edge is installed"


def installed() -> str | None:
    try:
        return browser()
    except InputError:
        return None


BROWSER = installed()
pytestmark = pytest.mark.skipif(BROWSER is None, reason=NO_BROWSER)


@pytest.fixture(scope="module")
def page(tmp_path_factory: pytest.TempPathFactory) -> Path:
    parts = gather(Source(CASE.dimensionless, CASE, "Rail"), 30, None, None, 2, (Fraction(1),))
    return write_whole(tmp_path_factory.mktemp("page") / "rail.html", report_page(parts, "rail"))


def opened(file: Path, profile: Path, *options: str) -> tuple[str, list[str]]:
    """The document as the browser has it, and what it wrote on its console."""
    assert BROWSER is not None
    command = [BROWSER, *QUIET, f"--user-data-dir={profile}", *options, "--dump-dom", file.as_uri()]
    done = subprocess.run(command, capture_output=True, text=True, timeout=120, check=True)
    return done.stdout, [line for line in done.stderr.splitlines() if "CONSOLE" in line]


def positions(dom: str, figure: str, name: str) -> np.ndarray[Any, Any]:
    """The points of a mark or line of a figure, from its place on the page and the limits of its axes."""
    (text,) = re.findall(rf'<figure id="figure-{figure}">\s*(<svg.*?</svg>)', dom, flags=re.DOTALL)
    elements = {element.get("id"): element for element in ET.fromstring(unescape_names(text)).iter()}
    axes = elements[f"{figure}-axes"]
    frame = axes.find(f"{SVG}g/{SVG}path")
    assert frame is not None
    corners = np.array(re.findall(r"[ML] (\S+) (\S+)", frame.attrib["d"]), float)
    (left, top), (right, bottom) = corners.min(0), corners.max(0)
    x0, x1, y0, y1 = (float(axes.attrib[f"data-{key}"]) for key in ("x0", "x1", "y0", "y1"))
    group = elements[f"{figure}-{name}"]
    places = [(float(one.attrib["x"]), float(one.attrib["y"])) for one in group.iter(f"{SVG}use")]
    if not places:
        path = group.find(f"{SVG}path")
        assert path is not None
        places = [(float(a), float(b)) for a, b in re.findall(r"[ML] (\S+) (\S+)", path.attrib["d"])]
    x, y = np.array(places).T
    return np.array([x0 + (x - left) / (right - left) * (x1 - x0), y1 + (y - top) / (bottom - top) * (y0 - y1)])


def unescape_names(text: str) -> str:
    """HTML writes a few characters by names that XML does not know."""
    return text.replace("&nbsp;", "\u00a0")


def test_it_opens_shows_its_numbers_and_hands_out_its_certificates(page: Path, tmp_path: Path) -> None:
    dom, console = opened(page, tmp_path / "profile")
    assert console == []
    for name in (
        "verdict",
        "case",
        "roots",
        "plane",
        "lines",
        "chart",
        "response",
        "contact",
        "proof",
        "certificate",
    ):
        assert f'<section id="{name}"' in dom
    (text,) = re.findall(r'<script type="application/json" id="data">(.*?)</script>', dom, flags=re.DOTALL)
    data = json.loads(text)

    for k, root in enumerate(data["report"]["roots"], 1):
        x, y = positions(dom, "plane", f"root-{k}")[:, 0]
        assert abs(x - float(root["re"]["value"])) < 1e-5
        assert abs(y - float(root["im"]["value"])) < 1e-6
    right = [root for root in data["report"]["roots"] if float(root["re"]["value"]) > 0]
    for k, root in enumerate(sorted(right, key=lambda root: float(root["re"]["value"])), 1):
        assert f'id="q{k}-re">±{root["re"]["value"]}<' in dom
        x, y = positions(dom, "zoom", f"zoom-{k}")[:, 0]
        assert abs(x - float(root["re"]["value"])) < 1e-6
    cut = positions(dom, "plane", "cut-right")[:, 0]  # where it begins
    assert np.allclose(cut, (data["q_lm"], 9000 / (2 * (60 * 1e6) ** 0.5)), atol=1e-4)
    for k, line in enumerate(data["lines"]["lines"], 1):
        # a line is followed by the marks of its points
        shown = positions(dom, "frequency", f"line-{k}")
        assert np.allclose(shown[0], [float(Fraction(alpha)) for alpha in line["alpha"]], atol=1e-4)
        assert np.allclose(shown[1], [float(re_q) for re_q in line["re"]], atol=1e-3)
    star = positions(dom, "chart", "case-mark")[:, 0]
    assert np.allclose(star, (1, 300 / (4 * 1e6 * 6.4e6 / 60**2) ** 0.25), atol=1e-3)
    motion = data["response"]
    for figure, name, key in (
        ("displacement", "w", "w"),
        ("displacement", "envelope", None),
        ("contact", "force", "contact_force"),
    ):
        for k in range(1, 1 + len(motion["w"])):
            t, shown = positions(dom, figure, f"{name}-{k}")
            values = (
                np.array(motion[key][k - 1]) if key else np.add(motion["steady"][k - 1], motion["envelope"][k - 1])
            )
            assert np.allclose(shown, np.interp(t, motion["t"], values), atol=4e-3 * np.ptp(values))
    for k, loss in enumerate(motion["contact_loss"], 1):
        if loss is not None:
            assert abs(positions(dom, "contact", f"loss-{k}")[0, 0] - loss) < 1e-2


def test_the_certificate_is_downloaded_and_valid(page: Path, tmp_path: Path) -> None:
    """A click on the link, by a script that is put into a copy of the page, brings the file that verifies."""
    assert BROWSER is not None
    text = page.read_text("utf-8")
    policy = re.compile(r'<meta http-equiv="Content-Security-Policy"[^>]*>')
    assert policy.search(text)
    click = "<script>document.querySelector('a[download]').click()</script></body>"
    copy = tmp_path / "copy.html"
    copy.write_text(policy.sub("", text).replace("</body>", click), "utf-8")
    folder, profile = tmp_path / "downloads", tmp_path / "profile"
    folder.mkdir()
    (profile / "Default").mkdir(parents=True)
    wanted = {"download": {"default_directory": str(folder), "prompt_for_download": False}}
    (profile / "Default" / "Preferences").write_text(json.dumps(wanted), "utf-8")
    command = [BROWSER, *QUIET, f"--user-data-dir={profile}", "--remote-debugging-port=0", copy.as_uri()]
    with subprocess.Popen(command, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL) as process:
        try:
            file = folder / "rail.certificate.json"
            for _ in range(400):
                if file.exists():
                    break
                time.sleep(0.1)
        finally:
            process.terminate()
    assert file.exists(), f"the browser saved {[one.name for one in folder.iterdir()]}"
    verdict = verify(file)
    assert verdict.valid, verdict.reason
    (wanted_digest,) = re.findall(
        r'"certificates": \[\{"file": "rail.certificate.json",.*?"sha256": "(\w+)"', unescape(text)
    )
    assert json.loads(file.read_text("ascii"))["sha256"] == wanted_digest


def test_every_picture_is_drawn_and_nothing_is_wider_than_a_phone(page: Path, tmp_path: Path) -> None:
    """The page in a frame as wide as a phone, which a script measures."""
    frame = tmp_path / "frame.html"
    policy = re.compile(r'<meta http-equiv="Content-Security-Policy"[^>]*>')
    inner = tmp_path / "inner.html"
    measure = """<script>
    const wide = [...document.querySelectorAll('section > *, figure, svg, p, pre')].map(
      e => e.getBoundingClientRect());
    document.body.dataset.width = document.documentElement.scrollWidth;
    document.body.dataset.most = Math.max(...wide.map(r => r.right));
    document.body.dataset.least = Math.min(...[...document.querySelectorAll('svg')].map(
      e => Math.min(e.getBoundingClientRect().width, e.getBoundingClientRect().height)));
    parent.postMessage(JSON.stringify({...document.body.dataset}), '*');
    </script></body>"""
    inner.write_text(policy.sub("", page.read_text("utf-8")).replace("</body>", measure), "utf-8")
    frame.write_text(
        "<!DOCTYPE html><html><body><script>addEventListener('message', e => {"
        " document.body.dataset.found = e.data; });</script>"
        f"<iframe src='{inner.as_uri()}' style='width:390px;height:800px;border:0'></iframe></body></html>",
        "utf-8",
    )
    dom, _ = opened(frame, tmp_path / "profile", "--virtual-time-budget=5000")
    (found,) = re.findall(r'data-found="([^"]*)"', dom)
    sizes = json.loads(unescape(found))
    assert float(sizes["width"]) <= 390
    assert float(sizes["most"]) <= 390
    assert float(sizes["least"]) > 100

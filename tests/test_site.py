"""The documentation: each page has its place, leads to what exists, and asks no other host for anything."""

from __future__ import annotations

import importlib
import importlib.util
import os
import re
import subprocess
import sys
from pathlib import Path

import pytest
from site_pages import asked, broken, main, of_page, of_style, unfilled

from mpsolve.presets.written import names, preset

ROOT = Path(__file__).parents[1]
DOCS = ROOT / "docs"
MADE = ("_build", "_generated", "_extensions", "_static", "jupyter_execute")
PAGES = sorted(path for path in DOCS.rglob("*.md") if not set(path.relative_to(DOCS).parts) & set(MADE))
NEEDED = (
    "sphinx",
    "myst_nb",
    "pydata_sphinx_theme",
    "sphinx_copybutton",
    "sphinx_design",
    "latex2mathml",
    "ipykernel",
)
MISSING = [name for name in NEEDED if importlib.util.find_spec(name) is None]


def below(page: Path) -> list[Path]:
    """The pages that the toctrees of this page name."""
    trees = re.findall(r"^```\{toctree\}\n(.*?)^```", page.read_text("utf-8"), flags=re.DOTALL | re.MULTILINE)
    rows = [row.strip() for tree in trees for row in tree.splitlines()]
    return [page.parent / f"{row}.md" for row in rows if row and not row.startswith(":")]


def test_every_page_is_in_a_toctree() -> None:
    reached, open_ = set(), [DOCS / "index.md"]
    while open_:
        page = open_.pop()
        reached.add(page)
        open_ += [one for one in below(page) if one.exists() and one not in reached]
    assert [str(page.relative_to(DOCS)) for page in PAGES if page not in reached] == []


@pytest.mark.parametrize("page", PAGES, ids=lambda page: str(page.relative_to(DOCS)))
def test_a_page_leads_to_what_exists(page: Path) -> None:
    named = [one for one in below(page) if "_generated" not in one.parts]
    text = re.sub(r"^```.*?^```", "", page.read_text("utf-8"), flags=re.DOTALL | re.MULTILINE)
    links = re.findall(r"\]\((?!https?:)([^)#\s]+)(?:#[^)]*)?\)", text)
    named += [page.parent / link for link in links if "_generated" not in link]
    assert [str(one) for one in named if not one.exists()] == []


def test_every_specification_has_a_page() -> None:
    shown = (DOCS / "reference/certificates.md").read_text("utf-8")
    assert ":glob:\n\n_generated/spec*\n" in shown
    assert len(list((ROOT / "certs").glob("SPEC*.md"))) > 1


def test_other_hosts_are_seen(tmp_path: Path) -> None:
    """A script, a font or a picture from elsewhere is found out; a link that a reader may follow is none of these."""
    page = """<a href="https://a.org">x</a> <link rel="canonical" href="https://b.org"> <img src="x.svg">
    <script src="//c.org/x.js"></script> <link rel="stylesheet" href="https://d.org/x.css">
    <img srcset="x.png 1x, https://e.org/y.png 2x"> <p style="background: url('http://f.org/z')">
    <style>@import "https://g.org/s.css"; p { color: red }</style>"""
    assert [re.findall(r"\w\.org", place)[0][0] for place in of_page(page)] == ["c", "d", "e", "f", "g"]
    assert of_style("@font-face { src: url(fonts/a.woff2), url(https://h.org/a.woff2) }") == ["https://h.org/a.woff2"]
    (tmp_path / "index.html").write_text(page, "utf-8")
    assert list(asked(tmp_path)) == ["index.html"]
    assert main(tmp_path) == main(tmp_path / "nothing") == 1
    (tmp_path / "index.html").write_text("<p>quiet</p>", "utf-8")
    assert main(tmp_path) == 0


def test_links_that_lead_nowhere_are_seen(tmp_path: Path) -> None:
    (tmp_path / "a").mkdir()
    (tmp_path / "a" / "index.html").write_text('<h1 id="here">x</h1> <a href="../index.html#top">y</a>', "utf-8")
    good = '<p id="top"><a href="a/#here">x</a> <a href="#top">x</a> <a href="https://b.org#z">y</a>'
    (tmp_path / "index.html").write_text(good, "utf-8")
    assert broken(tmp_path) == {}
    bad = good + '<a href="a/index.html#gone">x</a> <a href="none.html">y</a> <a href="#away">z</a>'
    (tmp_path / "index.html").write_text(bad, "utf-8")
    assert broken(tmp_path) == {"index.html": ["a/index.html#gone", "none.html", "#away"]}
    assert main(tmp_path) == 1


def test_a_picture_that_is_not_there_and_a_number_that_was_not_filled_in_are_seen(tmp_path: Path) -> None:
    (tmp_path / "a.svg").write_text("<svg/>", "utf-8")
    (tmp_path / "index.html").write_text('<p>3 m/s <code>{"v": 1}</code> <img src="a.svg"></p>', "utf-8")
    assert main(tmp_path) == 0
    (tmp_path / "index.html").write_text('<p>{onset[0]} m/s, {eval} <img src="b.svg"> Todo</p>', "utf-8")
    assert broken(tmp_path) == {"index.html": ["b.svg"]}
    assert unfilled(tmp_path) == {"index.html": ["{onset[0]}", "{eval}", "Todo"]}


def test_the_gallery_of_presets_is_that_of_the_library(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """Every preset stands in it, with a drawing, its sources and the verdict of `certify`, not typed."""
    monkeypatch.syspath_prepend(str(DOCS / "_extensions"))
    made = importlib.import_module("presets_page").presets_page(tmp_path)
    for name in names("track"):
        assert f"`mpsolve new {name}`" in made
        assert (tmp_path / f"preset-{name}.svg").read_text("utf-8").rstrip().endswith("</svg>")
        assert all(source in made for source in preset("track", name).sources)
    assert all(f"- `{name}`: " in made for name in names("vehicle"))
    assert made.count("**STABLE at ") == len(names("track"))  # the ice road too, whose long waves meet at q = 0


def test_papers_have_addresses_that_are_well_formed() -> None:
    """Each entry but two, whose addresses are not known to us, has a DOI, and the link is to that very DOI."""
    entries = (DOCS / "theory/papers.md").read_text("utf-8").split("\n- ")[1:]
    without = [entry[:20] for entry in entries if "doi" not in entry]
    assert without == ["Z. Dimitrovová, *Dyn", "Kruse, Metrikine, Po"]
    for shown, target in re.findall(r"\[doi:([^\]]*)\]\(https://doi\.org/([^)]*)\)", "".join(entries)):
        assert shown == target
        assert re.fullmatch(r"10\.\d{4,}/\S+", shown)


def test_links_outside_are_the_papers_and_no_others() -> None:
    outside = {page.name: re.findall(r"https?://[^)\s>`]+", page.read_text("utf-8")) for page in PAGES}
    assert {name for name, links in outside.items() if links} == {"papers.md"}
    assert all(link.startswith("https://doi.org/10.") for link in outside["papers.md"])


def test_every_figure_of_paper_and_findings_is_in_the_gallery() -> None:
    """Each module of figures can be drawn and checked; the gallery takes all that can."""
    helpers = {"comparison", "induced", "kernels", "style", "vibration"}
    for folder in ("figures", "findings"):
        for source in (ROOT / "examples" / folder).glob("*.py"):
            text = source.read_text("utf-8")
            assert ("def visualize(" in text and "def check(" in text) == (source.stem not in helpers), source


@pytest.mark.slow
@pytest.mark.skipif(bool(MISSING), reason=f"not installed: {', '.join(MISSING)} (the extra docs)")
def test_the_site_is_built_without_a_warning_and_asks_no_host(tmp_path: Path) -> None:
    """-W makes a link inside the site that leads nowhere, or a notebook that fails, an error."""
    words = ("-m", "sphinx", "-W", "--keep-going", "-q", "-j", "4", "-b", "html", str(DOCS), str(tmp_path))
    places = {"PYTHONPATH": os.pathsep.join((str(ROOT), os.environ.get("PYTHONPATH", "")))}
    made = subprocess.run(
        (sys.executable, *words), capture_output=True, text=True, env=os.environ | places, check=False
    )
    assert made.returncode == 0, made.stderr[-3000:]
    assert asked(tmp_path) == {}
    assert broken(tmp_path.resolve()) == {}
    assert unfilled(tmp_path) == {}

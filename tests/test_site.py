"""The documentation: each page has its place, leads to what exists, and asks no other host for anything."""

from __future__ import annotations

import importlib.util
import os
import re
import subprocess
import sys
from pathlib import Path

import pytest
from site_pages import asked, main, of_page, of_style

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
    for path in (ROOT / "certs").glob("SPEC*.md"):
        assert f"_generated/{path.stem.lower()}\n" in shown


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


@pytest.mark.slow
@pytest.mark.skipif(bool(MISSING), reason=f"not installed: {', '.join(MISSING)} (the extra docs)")
def test_the_site_is_built_without_a_warning_and_asks_no_host(tmp_path: Path) -> None:
    """-W makes a link inside the site that leads nowhere, or a notebook that fails, an error."""
    words = ("-m", "sphinx", "-W", "--keep-going", "-q", "-b", "html", str(DOCS), str(tmp_path))
    places = {"PYTHONPATH": os.pathsep.join((str(ROOT), os.environ.get("PYTHONPATH", "")))}
    made = subprocess.run(
        (sys.executable, *words), capture_output=True, text=True, env=os.environ | places, check=False
    )
    assert made.returncode == 0, made.stderr[-3000:]
    assert asked(tmp_path) == {}

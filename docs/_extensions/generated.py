"""Pages that the library writes about itself before the site is built."""

from __future__ import annotations

from pathlib import Path
from typing import Any

from gallery_page import galleries
from layout_page import layout_page
from presets_page import presets_page
from reference_pages import commands, models, names, schemas

ROOT = Path(__file__).resolve().parents[2]
DOCS = ROOT / "docs"


def generate(_app: Any) -> None:
    reference, gallery = (DOCS / name / "_generated" for name in ("reference", "gallery"))
    for name, made in (("models", models), ("commands", commands), ("library", names)):
        write(reference / f"{name}.md", made())
    write(reference / "schemas.md", schemas(reference / "schemas"))
    specifications = {one.name.lower(): one for one in (ROOT / "certs").glob("SPEC*.md")}
    for name, source in specifications.items():  # the formats, as they stand beside the certificates
        write(reference / name, source.read_text(encoding="utf-8"))
    for gone in {one.name for one in reference.glob("spec*.md")} - set(specifications):
        (reference / gone).unlink()
    write(DOCS / "about" / "_generated" / "layout.md", layout_page())
    for name, page in galleries(gallery).items():
        write(gallery / f"{name}.md", page)
    write(gallery / "presets.md", presets_page(gallery))


def write(path: Path, text: str) -> None:
    path.parent.mkdir(parents=True, exist_ok=True)
    if not path.exists() or path.read_text(encoding="utf-8") != text:
        path.write_text(text, encoding="utf-8")


def tidy(app: Any, _error: Exception | None) -> None:
    """The theme leaves a template among the files of the site: it is no page."""
    (Path(app.outdir) / "_static" / "webpack-macros.html").unlink(missing_ok=True)


def setup(app: Any) -> dict[str, bool]:
    app.connect("builder-inited", generate)
    app.connect("build-finished", tidy)
    return {"parallel_read_safe": True, "parallel_write_safe": True}

"""The page on paper: a PDF with page numbers and the certificates attached, by WeasyPrint; no browser is needed.

Compared with a printing browser: WeasyPrint numbers the pages and attaches files, and a browser does neither. It does
not know the colours of a page inside a drawing, so each drawing gets them written into it.
"""

from __future__ import annotations

import re
from html import escape
from importlib import import_module
from pathlib import Path
from typing import Any

from mpsolve.errors import InputError
from mpsolve.files import write_whole
from mpsolve.page.page import downloads, page_html
from mpsolve.page.parts import Parts
from mpsolve.pictures.axes import plain

_PRINT = {
    "--ink": "#000000", "--card": "#ffffff", "--blue": "#0072b2", "--red": "#c44e00", "--green": "#00805f",
    "--pink": "#a8588a", "--faint": "#6d747b", "--soft": "#555555", "--line": "#bbbbbb",
}  # fmt: skip
_PAGES = """
@page { @bottom-right { content: counter(page) " / " counter(pages); font: 9pt sans-serif; color: #555; }
        @bottom-left { content: string(title); font: 9pt sans-serif; color: #555; } }
h1 { string-set: title content(); }
figure svg { max-height: 80mm; }
"""


def require_printer() -> Any:
    """WeasyPrint; InputError says what is missing."""
    try:
        return import_module("weasyprint")
    except ImportError:
        raise InputError("--pdf", "needs WeasyPrint, which is not installed: pip install 'mpsolve[pdf]'") from None
    except OSError as error:  # its drawing library
        raise InputError("--pdf", f"needs the library Pango, which WeasyPrint does not find ({error})") from None


def save_pdf(parts: Parts, stem: str, path: Path) -> Path:
    """Writes the page as a PDF, whole or not at all; InputError where WeasyPrint is not installed."""
    printer = require_printer()
    attached = [
        printer.Attachment(url=one.address, name=one.name, description=f"certificate of {one.proves}")
        for one in downloads(parts, stem)
    ]
    page = with_colours(page_html(parts, stem))
    content = printer.HTML(string=page).write_pdf(stylesheets=[printer.CSS(string=_PAGES)], attachments=attached)
    return write_whole(path, content)


def with_colours(page: str) -> str:
    """The page with its styles written into each drawing, in the colours of paper."""
    style = (
        plain(_PRINT)
        .replace(".picture .", ".")
        .replace(".picture text", "text")
        .replace("font: 13px", "font-size: 13px")
    )
    inside = f"<style>{escape(style, quote=False)}</style>"
    page = re.sub(r"<animate [^>]*/>", "", page)
    return re.sub(r"(<svg [^>]*>)", rf"\1{inside}", page)

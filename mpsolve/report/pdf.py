"""The page as a PDF: a browser that is installed prints it, as its own print command would."""

from __future__ import annotations

import os
import shutil
import subprocess
import tempfile
from pathlib import Path

from mpsolve.errors import CertificateError, InputError
from mpsolve.files import write_whole

VARIABLE = "MPSOLVE_BROWSER"
SECONDS = 180
_NAMES = (
    *("chromium", "chromium-browser", "google-chrome", "google-chrome-stable", "chrome"),
    *("microsoft-edge", "microsoft-edge-stable", "msedge"),
)
_PLACES = (
    "/Applications/Google Chrome.app/Contents/MacOS/Google Chrome",
    "/Applications/Chromium.app/Contents/MacOS/Chromium",
    "/Applications/Microsoft Edge.app/Contents/MacOS/Microsoft Edge",
    *(
        rf"{os.environ.get(root, '')}\{name}"
        for root in ("PROGRAMFILES", "PROGRAMFILES(X86)", "LOCALAPPDATA")
        for name in (r"Google\Chrome\Application\chrome.exe", r"Microsoft\Edge\Application\msedge.exe")
    ),
)
_QUIET = (
    *("--headless", "--disable-gpu", "--disable-quic", "--no-first-run", "--disable-sync"),
    *("--disable-background-networking", "--disable-component-update", "--no-pdf-header-footer"),
)


def browser() -> str:
    """The program that prints: the one that MPSOLVE_BROWSER names, else the first Chromium, Chrome or Edge found.

    Raises InputError, which says what to do, if there is none.
    """
    named = os.environ.get(VARIABLE)
    if named:
        found = shutil.which(named)
        if found is None:
            raise InputError(
                VARIABLE, f"is {named!r}, which is no program: give the path of Chromium, Chrome or Edge"
            )
        return found
    known = (*map(shutil.which, _NAMES), *map(shutil.which, _PLACES))
    for program in known:
        if program is not None:
            return program
    raise InputError(
        "--pdf",
        "needs Chromium, Chrome or Edge, and none is found: install one, or name it by the variable "
        f"{VARIABLE}, or print the page to PDF from any browser",
    )


def save_pdf(page: str, path: Path, program: str) -> Path:
    """Prints the page (HTML) by `program` (see `browser`) and writes the PDF to `path`, whole or not at all.

    Raises CertificateError if the browser fails, or the file cannot be written.
    """
    # beside the PDF: some browsers are not allowed to see the system's folder for temporary files
    try:
        folder = tempfile.TemporaryDirectory(dir=path.parent, prefix="mpsolve-", ignore_cleanup_errors=True)
    except OSError as error:
        raise CertificateError(f"{path} cannot be written: {error.strerror}; nothing was changed there") from error
    with folder as name:
        source, printed = Path(name, "page.html").resolve(), Path(name, "page.pdf").resolve()
        source.write_text(page, "utf-8")
        options = [*_QUIET, *_unboxed(), f"--user-data-dir={Path(name, 'profile').resolve()}"]
        said = _run([program, *options, f"--print-to-pdf={printed}", source.as_uri()])
        content = printed.read_bytes() if printed.is_file() else b""
    if not content.startswith(b"%PDF-"):
        raise CertificateError(f"{path} is not written: {program} printed no PDF ({said})")
    return write_whole(path, content)


def _unboxed() -> tuple[str, ...]:
    """Chromium refuses to run its sandbox for root; the page is our own and holds no script."""
    return ("--no-sandbox",) if hasattr(os, "geteuid") and os.geteuid() == 0 else ()


def _run(command: list[str]) -> str:
    """What to say if nothing was printed."""
    try:
        done = subprocess.run(command, capture_output=True, timeout=SECONDS, check=False)
    except subprocess.TimeoutExpired:
        return f"it was stopped after {SECONDS} s"
    except OSError as error:
        return error.strerror or str(error)
    return f"exit status {done.returncode}"

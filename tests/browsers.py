"""A real browser for tests of pages: the first Chromium, Chrome or Edge that is installed, driven by playwright."""

from __future__ import annotations

import os
import shutil
import sys

NAMES = (
    *("chromium", "chromium-browser", "google-chrome", "google-chrome-stable", "chrome"),
    *("microsoft-edge", "microsoft-edge-stable", "msedge"),
)
NONE = "no Chromium, Chrome or Edge is installed"


def browser() -> str | None:
    """The path of the browser; MPSOLVE_BROWSER names another one."""
    wanted = os.environ.get("MPSOLVE_BROWSER")
    return shutil.which(wanted) if wanted else next(filter(None, map(shutil.which, NAMES)), None)


if __name__ == "__main__":
    print(browser() or NONE)
    sys.exit(browser() is None)

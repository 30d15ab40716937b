"""What a built site asks of other hosts: `python tests/site_pages.py docs/_build` exits with 1 if anything."""

from __future__ import annotations

import re
import sys
from html.parser import HTMLParser
from pathlib import Path

OTHER = re.compile(r"^\s*(?:https?:|wss?:|//)", re.IGNORECASE)
LOADS = (
    "src",
    "srcset",
    "poster",
    "data",
    "action",
    "formaction",
    "background",
)  # what a browser fetches or sends to
NO_REQUEST = {"canonical", "alternate", "license", "author", "next", "prev", "search", "index", "help"}
IN_STYLES = re.compile(r"""(?:url\(\s*|@import\s+)["']?([^"')\s;]+)""", re.IGNORECASE)


class _Page(HTMLParser):
    """Collects what one page loads; a link that a reader may follow loads nothing."""

    def __init__(self) -> None:
        super().__init__()
        self.asked: list[str] = []

    def handle_starttag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
        given = {name: value or "" for name, value in attrs}
        wanted = [given[name] for name in LOADS if name in given]
        if tag == "link" and not set(given.get("rel", "").split()) & NO_REQUEST:
            wanted.append(given.get("href", ""))
        wanted += IN_STYLES.findall(given.get("style", ""))
        self.asked += [place for one in wanted for place in one.split(",") if OTHER.match(place)]


def of_page(text: str) -> list[str]:
    """The places on other hosts that a page loads."""
    page = _Page()
    page.feed(text)
    styles = re.findall(r"<style[^>]*>(.*?)</style>", text, flags=re.DOTALL | re.IGNORECASE)
    return page.asked + [place for style in styles for place in of_style(style)]


def of_style(text: str) -> list[str]:
    """The places on other hosts that a style sheet loads."""
    return [place for place in IN_STYLES.findall(text) if OTHER.match(place)]


def asked(site: Path) -> dict[str, list[str]]:
    """By file of the site: the places on other hosts that it loads."""
    found = {path: of_page(path.read_text("utf-8")) for path in sorted(site.rglob("*.html"))}
    found |= {path: of_style(path.read_text("utf-8")) for path in sorted(site.rglob("*.css"))}
    return {str(path.relative_to(site)): places for path, places in found.items() if places}


def main(site: Path) -> int:
    if not (site / "index.html").exists():
        print(f"{site} is no built site")
        return 1
    for path, places in (found := asked(site)).items():
        print(path, *places)
    return int(bool(found))


if __name__ == "__main__":
    sys.exit(main(Path(sys.argv[1])))

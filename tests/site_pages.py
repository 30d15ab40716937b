"""What is wrong with a built site: `python tests/site_pages.py docs/_build` exits with 1 if it asks other hosts for
anything, a link to one of its own pages, places or pictures leads nowhere, or a place for a number stayed empty.
"""

from __future__ import annotations

import re
import sys
from html import unescape
from html.parser import HTMLParser
from pathlib import Path
from urllib.parse import unquote

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
EMPTY = re.compile(
    r"(?<![\^_])\{(?:[a-z_]{4,}|[a-z_]+\[[^}]*|[a-z]+:[a-z]+)\}|\b(?:TODO|FIXME|TBD|lorem ipsum|coming soon)\b",
    re.IGNORECASE,
)
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


def broken(site: Path) -> dict[str, list[str]]:
    """By file of the site: the links to its own pages, to places in them, or to pictures, that lead nowhere."""
    places = {path: _Links.of(path) for path in sorted(site.rglob("*.html"))}
    found: dict[str, list[str]] = {}
    for path, links in places.items():
        bad = [href for href in links.hrefs if not _leads(path, href, places)]
        if bad:
            found[str(path.relative_to(site))] = bad
    return found


def _leads(path: Path, href: str, places: dict[Path, _Links]) -> bool:
    if OTHER.match(href) or re.match(r"\w+:", href):
        return True
    file, _, place = unquote(href).partition("#")
    target = (path.parent / file.partition("?")[0]).resolve() if file else path
    if target.is_dir():
        target /= "index.html"
    if target not in places:
        return target.exists()
    return not place or place in places[target].names


class _Links(HTMLParser):
    """Where a page leads to, and the places in it."""

    def __init__(self) -> None:
        super().__init__()
        self.hrefs: list[str] = []
        self.names: set[str] = set()

    @classmethod
    def of(cls, path: Path) -> _Links:
        page = cls()
        page.feed(path.read_text("utf-8"))
        return page

    def handle_starttag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
        given = {name: value or "" for name, value in attrs}
        self.names |= {given[name] for name in ("id", "name") if name in given}
        wanted = {"a": "href", "link": "href", "img": "src", "script": "src", "source": "src"}.get(tag, "")
        if given.get(wanted):
            self.hrefs.append(given[wanted])


def unfilled(site: Path) -> dict[str, list[str]]:
    """By file of the site: what its words still leave open outside of code: names in braces, roles, notes to do."""
    found = {path: EMPTY.findall(words(path.read_text("utf-8"))) for path in sorted(site.rglob("*.html"))}
    return {str(path.relative_to(site)): places for path, places in found.items() if places}


def words(text: str) -> str:
    """What a reader sees of a page, without scripts and code."""
    text = re.sub(r"<(script|style|pre|code|math)\b.*?</\1>", " ", text, flags=re.DOTALL | re.IGNORECASE)
    return unescape(re.sub(r"<[^>]*>", " ", text))


def main(site: Path) -> int:
    if not (site / "index.html").exists():
        print(f"{site} is no built site")
        return 1
    site = site.resolve()
    found = [("asks another host for", asked(site)), ("leads nowhere with", broken(site)), ("leaves", unfilled(site))]
    for told, pages in found:
        for path, places in pages.items():
            print(path, told, *places)
    return int(any(pages for _, pages in found))


if __name__ == "__main__":
    sys.exit(main(Path(sys.argv[1])))

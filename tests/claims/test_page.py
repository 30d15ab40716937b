"""The page is whole, says what was found, and loads nothing."""

from __future__ import annotations

from html.parser import HTMLParser

from mpsolve.claims.page import page
from mpsolve.claims.report import Report


class Links(HTMLParser):
    """Everything that a page would load or lead to, and the open tags."""

    def __init__(self) -> None:
        super().__init__()
        self.targets: list[str] = []
        self.open: list[str] = []

    def handle_starttag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
        self.targets += [value or "" for name, value in attrs if name in ("src", "href")]
        if tag not in ("meta", "link", "br"):
            self.open.append(tag)

    def handle_endtag(self, tag: str) -> None:
        assert self.open.pop() == tag


def test_the_page_is_whole_and_loads_nothing(toy_report: Report) -> None:
    text, reader = page(toy_report), Links()
    reader.feed(text)
    assert reader.open == []
    assert all(target.startswith("#") for target in reader.targets)
    assert "url(" not in text
    assert "<script" not in text
    assert all(f'id="{claim.id}"' in text for claim, _ in toy_report.entries)
    assert all(name in text for name in toy_report.certificates)


def test_texts_are_escaped_and_tried_words_stand_beside_those_printed(toy_report: Report) -> None:
    text = page(toy_report)
    assert "One mass &amp; its &lt;roots&gt;" in text
    assert "<li>2 &amp; more</li>" in text
    assert "<blockquote>Two roots were found.</blockquote>\n<p>Tried: There are 2 roots.</p>" in text
    assert text.count("Tried:") == 1
    assert "No certificate: nothing is proved" in text

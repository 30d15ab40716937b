"""What an audit found, with one certificate file for each distinct content: on a terminal, as JSON, as a page."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from html import escape
from pathlib import Path
from typing import Any

from rich.box import SIMPLE_HEAD
from rich.console import Group
from rich.table import Table
from rich.text import Text

from mpsolve.certificate.format import Certificate
from mpsolve.claims.claim import Claim, Finding, Paper, Verdict
from mpsolve.errors import CertificateError

_COLOUR = {"good": "green", "bad": "bold red", "half": "yellow", "open": "magenta", "slip": "cyan"}
_CLAIM_WIDTH = 160  # characters of a claim in the table; all of it stands in the JSON and on the page
_STYLE = """
:root { color-scheme: light dark; }
body { font: 16px/1.5 system-ui, sans-serif; max-width: 62rem; margin: 2rem auto; padding: 0 1rem; }
h1 { font-size: 1.5rem; }
h2 { font-size: 1.05rem; margin: 0 0 .3rem; }
article { border-left: .4rem solid; padding: .4rem 0 .4rem 1rem; margin: 1.4rem 0; }
blockquote { margin: .3rem 0; font-style: italic; overflow-wrap: anywhere; }
table { border-collapse: collapse; }
td { padding: .1rem .8rem .1rem 0; vertical-align: top; overflow-wrap: anywhere; }
td:last-child { font-family: ui-monospace, monospace; }
code { font-size: .9em; }
nav a { margin-right: .6rem; white-space: nowrap; }
.good { border-color: #1a7f37; } .bad { border-color: #cf222e; } .half { border-color: #bf8700; }
.open { border-color: #8250df; } .slip { border-color: #0598bc; }
.verdict { font-weight: 600; }
"""
_HEAD = """<!doctype html>
<html lang="en">
<head><meta charset="utf-8"><meta name="viewport" content="width=device-width, initial-scale=1">
<title>The paper on trial: {title}</title><style>{style}</style></head>
<body>
<h1>The paper on trial</h1>
<p>{paper}. Each verdict was computed when this page was made; every digit of a number is proved,
unless the verdict says computed or the line says float64. Certificates are checked
with <code>mpsolve verify</code>.</p>
<p>{notation}</p>
<p>{summary}</p>
<nav>{links}</nav>
"""


@dataclass(frozen=True)
class Report:
    """The claims with what was found; `certificates` by file name, and `files`, those of each claim."""

    paper: Paper
    entries: tuple[tuple[Claim, Finding], ...]
    certificates: dict[str, Certificate]
    files: dict[str, tuple[str, ...]]

    def count(self, verdict: Verdict) -> int:
        return sum(finding.verdict is verdict for _, finding in self.entries)

    @property
    def complete(self) -> bool:
        """Whether every check came to its end."""
        return not any(finding.stopped for _, finding in self.entries)

    @property
    def summary(self) -> str:
        """How many claims have each verdict."""
        counts = ((verdict, self.count(verdict)) for verdict in Verdict)
        said = [
            f"{n} {'slips of the print' if each is Verdict.SLIP and n > 1 else each.value}" for each, n in counts if n
        ]
        return f"{len(self.entries)} claims: " + ", ".join(said) + "."

    def without_certificate(self, claim: Claim, finding: Finding) -> str:
        """What stands in place of certificates where the finding has none."""
        how = finding.uncertified
        return how and f"No certificate: {how}; recompute with {self.paper.command} --only {claim.id}"

    def save_certificates(self, folder: Path) -> list[Path]:
        """A file for each certificate. CertificateError if one cannot be written."""
        try:
            folder.mkdir(parents=True, exist_ok=True)
        except OSError as error:
            raise CertificateError(f"{folder} cannot be made: {error.strerror or error}") from error
        return [certificate.save(folder / name) for name, certificate in self.certificates.items()]


def collected(paper: Paper, entries: Sequence[tuple[Claim, Finding]]) -> Report:
    """The report; certificates of equal content share one file, named by the first claim that has it."""
    files, certificates = {}, {}
    known: dict[str, str] = {}
    for claim, finding in entries:
        names = []
        for name, certificate in finding.certificates:
            if certificate is None:
                continue
            digest = certificate.content["sha256"]
            if digest not in known:
                known[digest] = f"{name}.json" if f"{name}.json" not in certificates else f"{name}_{digest[:8]}.json"
                certificates[known[digest]] = certificate
            names.append(known[digest])
        files[claim.id] = tuple(dict.fromkeys(names))
    return Report(paper, tuple(entries), certificates, files)


def document(report: Report) -> Group:
    """A table with one row a claim, and the summary."""
    table = Table(box=SIMPLE_HEAD, show_lines=True, pad_edge=False)
    table.add_column("claim", no_wrap=True)
    table.add_column("verdict", max_width=12)
    table.add_column("as printed, and what is found", overflow="fold")
    for claim, finding in report.entries:
        verdict = Text(finding.verdict.value, style=_COLOUR[finding.verdict.tone])
        table.add_row(claim.id, verdict, _body(report, claim, finding))
    return Group(table, Text(report.summary, style="bold"))


def _body(report: Report, claim: Claim, finding: Finding) -> Text:
    quote = report.paper.quote(claim)
    text = quote if len(quote) <= _CLAIM_WIDTH else f"{quote[: _CLAIM_WIDTH - 1]}…"
    body = Text(f"{text}\n", style="italic")
    body.append(finding.sentence, style="not italic")
    for line in (*(f"→ {found}" for found in finding.search[:3]), report.without_certificate(claim, finding)):
        body.append(f"\n{line}" if line else "", style="not italic")
    return body


def as_data(report: Report) -> dict[str, Any]:
    """Everything, as JSON takes it."""
    return {
        "format": "mpsolve audit",
        "version": 1,
        "title": report.paper.title,
        "paper": report.paper.citation,
        "notation": report.paper.notation,
        "summary": {verdict.value: report.count(verdict) for verdict in Verdict},
        "complete": report.complete,
        "claims": [
            {
                "id": claim.id,
                "place": claim.place,
                "claim": report.paper.quote(claim),
                "tried": claim.text,
                "printed": {name: list(values) for name, values in claim.printed.items()},
                "looked at": {name: list(values) for name, values in claim.at.items()},
                "verdict": finding.verdict.value,
                "sentence": finding.sentence,
                "numbers": [{"what": what, "value": value} for what, value in finding.numbers],
                "proof": list(finding.steps),
                "search": list(finding.search),
                "certificates": list(report.files[claim.id]),
                "no certificate": report.without_certificate(claim, finding),
            }
            for claim, finding in report.entries
        ],
    }


def page(report: Report) -> str:
    """The whole page."""
    links = " ".join(f'<a href="#{escape(claim.id)}">{escape(claim.id)}</a>' for claim, _ in report.entries)
    texts = {"title": report.paper.title, "paper": report.paper.citation, "notation": report.paper.notation}
    texts["summary"] = report.summary
    head = _HEAD.format(style=_STYLE, links=links, **{name: escape(text) for name, text in texts.items()})
    articles = "\n".join(_article(report, claim, finding) for claim, finding in report.entries)
    return f"{head}{articles}\n</body>\n</html>\n"


def _article(report: Report, claim: Claim, finding: Finding) -> str:
    quote, files = report.paper.quote(claim), report.files[claim.id]
    parts = [
        f'<article id="{escape(claim.id)}" class="{finding.verdict.tone}">',
        f"<h2>{escape(claim.id)} · {escape(claim.place)}</h2>",
        f"<blockquote>{escape(quote)}</blockquote>",
        f"<p>Tried: {escape(claim.text)}</p>" if claim.text != quote else "",
        f'<p><span class="verdict">{escape(finding.verdict.value)}.</span> {escape(finding.sentence)}</p>',
    ]
    if finding.search:
        parts.append(_list("What would reproduce it", finding.search, "ul"))
    if finding.steps:
        parts.append(_details("Proof", _list("", finding.steps, "ol")))
    if finding.numbers:
        rows = "".join(f"<tr><td>{escape(what)}</td><td>{escape(value)}</td></tr>" for what, value in finding.numbers)
        parts.append(_details(f"Numbers ({len(finding.numbers)})", f"<table>{rows}</table>"))
    if files:
        parts.append(_details(f"Certificates ({len(files)})", _list("", files, "ul")))
    if without := report.without_certificate(claim, finding):
        parts.append(f"<p>{escape(without)}.</p>")
    return "\n".join([*filter(None, parts), "</article>"])


def _list(title: str, lines: Sequence[str], kind: str) -> str:
    items = "".join(f"<li>{escape(line)}</li>" for line in lines)
    return (f"<p>{escape(title)}:</p>" if title else "") + f"<{kind}>{items}</{kind}>"


def _details(title: str, body: str) -> str:
    return f"<details><summary>{escape(title)}</summary>{body}</details>"

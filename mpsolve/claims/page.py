"""The report as one self-contained HTML page: no script, no network."""

from __future__ import annotations

from collections.abc import Sequence
from html import escape

from mpsolve.claims.claim import Claim
from mpsolve.claims.finding import Finding
from mpsolve.claims.report import Report

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

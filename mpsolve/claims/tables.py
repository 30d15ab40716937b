"""The report for terminals and for machines."""

from __future__ import annotations

from typing import Any

from rich.box import SIMPLE_HEAD
from rich.console import Group
from rich.table import Table
from rich.text import Text

from mpsolve.claims.claim import Claim
from mpsolve.claims.finding import Finding, Verdict
from mpsolve.claims.report import Report

_COLOUR = {"good": "green", "bad": "bold red", "half": "yellow", "open": "magenta", "slip": "cyan"}
_CLAIM_WIDTH = 160  # characters of a claim in the table; all of it stands in the JSON and on the page


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

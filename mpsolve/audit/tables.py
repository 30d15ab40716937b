"""The report for terminals and for machines."""

from __future__ import annotations

from typing import Any

from rich.box import SIMPLE_HEAD
from rich.console import Group
from rich.table import Table
from rich.text import Text

from mpsolve.audit.claims import Claim, Finding, Verdict
from mpsolve.audit.run import Report

PAPER = "Dimitrovová, two moving proximate masses on a beam on a Pasternak viscoelastic foundation"
_COLOUR = {
    Verdict.PROVED: "green",
    Verdict.REFUTED: "bold red",
    Verdict.CONDITIONAL: "yellow",
    Verdict.UNDECIDABLE: "magenta",
    Verdict.SLIP: "cyan",
    Verdict.AGREES: "green",
    Verdict.DISAGREES: "bold red",
}
NOTATION = (
    "Equations are written as code: d(f, x, 2) is f with two derivatives by x, delta Dirac's or Kronecker's, x_2 the "
    "dimensionless distance d̂, P the constant P_C1 as a scale, F_1 and F_2 those of (22); u_k, u1_k, u2_k are "
    "w_k, w_k,x, w_k,xx at the rear mass (vt), v_k, v1_k, v2_k (v3_k: w_k,xxx) the same at the front mass (vt + "
    "d), q0, q1, q2 are q_k, q_k,t, q_k,tt; D_pp is D_,pp, and h_pp, h_ppp are derivatives of h = D²."
)
_CLAIM_WIDTH = 160  # characters of a claim in the table; all of it stands in the JSON and on the page


def summary(report: Report) -> str:
    """How many claims have each verdict."""
    counts = ((verdict, report.count(verdict)) for verdict in Verdict)
    said = [
        f"{n} {'slips of the print' if each is Verdict.SLIP and n > 1 else each.value}" for each, n in counts if n
    ]
    return f"{len(report.entries)} claims: " + ", ".join(said) + "."


def document(report: Report) -> Group:
    """A table with one row a claim, and the summary."""
    table = Table(box=SIMPLE_HEAD, show_lines=True, pad_edge=False)
    table.add_column("claim", no_wrap=True)
    table.add_column("verdict", max_width=12)
    table.add_column("as printed, and what is found", overflow="fold")
    for claim, finding in report.entries:
        table.add_row(claim.id, Text(finding.verdict.value, style=_COLOUR[finding.verdict]), _body(claim, finding))
    return Group(table, Text(summary(report), style="bold"))


def _body(claim: Claim, finding: Finding) -> Text:
    text = claim.quote if len(claim.quote) <= _CLAIM_WIDTH else f"{claim.quote[: _CLAIM_WIDTH - 1]}…"
    body = Text(f"{text}\n", style="italic")
    body.append(finding.sentence, style="not italic")
    for line in (*(f"→ {found}" for found in finding.search[:3]), claim.without_certificate(finding)):
        body.append(f"\n{line}" if line else "", style="not italic")
    return body


def as_data(report: Report) -> dict[str, Any]:
    """Everything, as JSON takes it."""
    return {
        "paper": PAPER,
        "notation": NOTATION,
        "summary": {verdict.value: report.count(verdict) for verdict in Verdict},
        "complete": report.complete,
        "claims": [
            {
                "id": claim.id,
                "place": claim.place,
                "claim": claim.quote,
                "tried": claim.text,
                "printed": {name: list(values) for name, values in claim.printed.items()},
                "looked at": {name: list(values) for name, values in claim.at.items()},
                "verdict": finding.verdict.value,
                "sentence": finding.sentence,
                "numbers": [{"what": what, "value": value} for what, value in finding.numbers],
                "proof": list(finding.steps),
                "search": list(finding.search),
                "certificates": list(report.files[claim.id]),
                "no certificate": claim.without_certificate(finding),
            }
            for claim, finding in report.entries
        ],
    }

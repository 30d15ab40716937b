"""What an audit found, with one certificate file for each distinct content: on a terminal, as JSON, as a page."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from mpsolve.certificate.format import Certificate
from mpsolve.claims.claim import Claim, Finding, Paper, Verdict
from mpsolve.errors import CertificateError
from mpsolve.report.blocks import Document, Line, Section
from mpsolve.report.template import rendered

_COLOUR = {"good": "bold green", "bad": "bold red", "half": "yellow", "open": "magenta", "slip": "cyan"}
_CLAIM_WIDTH = 160  # characters of a claim on the terminal; all of it stands in the JSON and on the page


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


def document(report: Report) -> Document:
    """A section for each claim, as printed and what is found, and the summary."""
    blocks: list[Line | Section] = []
    for claim, finding in report.entries:
        quote = report.paper.quote(claim)
        printed = quote if len(quote) <= _CLAIM_WIDTH else f"{quote[: _CLAIM_WIDTH - 1]}…"
        found = (*(f"→ {one}" for one in finding.search[:3]), report.without_certificate(claim, finding))
        text = "\n".join(filter(None, [printed, finding.sentence, *found]))
        blocks.append(Section(f"{claim.id}: {finding.verdict.value}", text, _COLOUR[finding.verdict.tone]))
    return Document((*blocks, Line(report.summary, "bold")))


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
    tones = [finding.verdict.tone for _, finding in report.entries]
    claims = [one | {"tone": tone} for one, tone in zip(as_data(report)["claims"], tones, strict=True)]
    return rendered("audit.html.j2", paper=report.paper, summary=report.summary, claims=claims)

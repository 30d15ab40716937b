"""What an audit found, with one certificate file for each distinct content."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

from mpsolve.certificate.format import Certificate
from mpsolve.claims.claim import Claim
from mpsolve.claims.finding import Finding, Verdict
from mpsolve.claims.paper import Paper
from mpsolve.errors import CertificateError


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

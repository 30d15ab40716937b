"""The audit: every claim checked, in several processes, with one certificate file for each distinct content."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from importlib import import_module
from pathlib import Path

from mpsolve.audit.claims import Claim, Finding, Verdict
from mpsolve.certificate.format import Certificate
from mpsolve.errors import CertificateError, InputError, MpsolveError
from mpsolve.parallel.pool import run
from mpsolve.progress import Progress

_LISTS = (
    "undamped_list damped_list figure_9 instability onset_list motion_list superposition history captions "
    "figure_list premises equation_list modal"
)
_LONG = ("i", "xi-smooth-high", "xi-smooth-low", "iii", "fig-12-text", "xi")  # take longest: first


@dataclass(frozen=True)
class Report:
    """The claims with what was found; `certificates` by file name, and `files`, those of each claim."""

    entries: tuple[tuple[Claim, Finding], ...]
    certificates: dict[str, Certificate]
    files: dict[str, tuple[str, ...]]

    def count(self, verdict: Verdict) -> int:
        return sum(finding.verdict is verdict for _, finding in self.entries)

    @property
    def complete(self) -> bool:
        """Whether every check came to its end."""
        return not any(finding.stopped for _, finding in self.entries)

    def save_certificates(self, folder: Path) -> list[Path]:
        """A file for each certificate. CertificateError if one cannot be written."""
        try:
            folder.mkdir(parents=True, exist_ok=True)
        except OSError as error:
            raise CertificateError(f"{folder} cannot be made: {error.strerror or error}") from error
        return [certificate.save(folder / name) for name, certificate in self.certificates.items()]


def all_claims() -> tuple[Claim, ...]:
    """Every claim, in the order of the report."""
    modules = (import_module(f"mpsolve.audit.{name}") for name in _LISTS.split())
    return tuple(claim for module in modules for claim in module.CLAIMS)


def chosen(only: Sequence[str]) -> tuple[Claim, ...]:
    """The claims of these names, and of names that go on with "-", as "xii" has xii-a. InputError if none has."""
    claims = all_claims()
    for name in only:
        if not any(_named(claim, name) for claim in claims):
            known = ", ".join(claim.id for claim in claims)
            raise InputError("only", f"{name!r} is no claim: give one of {known}, or the beginning up to a hyphen")
    return tuple(claim for claim in claims if not only or any(_named(claim, name) for name in only))


def _named(claim: Claim, name: str) -> bool:
    return claim.id == name or claim.id.startswith(f"{name}-")


def audit(claims: Sequence[Claim], workers: int | None = None, tell: Progress | None = None) -> Report:
    """The findings of the claims, the same for any number of workers. InputError, MpsolveError as `pool.run`."""
    order = sorted(
        range(len(claims)), key=lambda k: _LONG.index(claims[k].id) if claims[k].id in _LONG else len(_LONG)
    )
    found = run(checked, [claims[k] for k in order], workers, tell, "checking")
    by_place = dict(zip(order, found, strict=True))
    return collected([(claim, by_place[k]) for k, claim in enumerate(claims)])


def checked(claim: Claim) -> Finding:
    """The finding; a check that comes to no end is a finding too, with its reason."""
    try:
        return claim.check(claim)
    except MpsolveError as error:
        return Finding(Verdict.UNDECIDABLE, f"The check came to no end: {error}", stopped=True)


def collected(entries: Sequence[tuple[Claim, Finding]]) -> Report:
    """The report; certificates of equal content share one file, named by the first claim that has it."""
    files, certificates, known = {}, {}, {}
    for claim, finding in entries:
        names = []
        for name, certificate in finding.certificates:
            digest = certificate.content["sha256"]
            if digest not in known:
                known[digest] = f"{name}.json"
                certificates[known[digest]] = certificate
            names.append(known[digest])
        files[claim.id] = tuple(dict.fromkeys(names))
    return Report(tuple(entries), certificates, files)

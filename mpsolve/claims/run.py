"""The audit: every claim of a paper checked, in several processes."""

from __future__ import annotations

from collections.abc import Sequence

from mpsolve.claims.claim import Claim
from mpsolve.claims.finding import Finding, Verdict
from mpsolve.claims.load import load
from mpsolve.claims.paper import Paper
from mpsolve.claims.report import Report, collected
from mpsolve.errors import MpsolveError
from mpsolve.parallel.pool import run
from mpsolve.progress import Progress


def audit(paper: Paper, only: Sequence[str] = (), workers: int | None = None, tell: Progress | None = None) -> Report:
    """The findings of the claims that `only` names (all by default), the same for any number of workers.

    A paper that was loaded from its folder is loaded anew in each process; the checks of another must be functions of
    a module. InputError, MpsolveError as `pool.run`.
    """
    claims = paper.chosen(only)
    order = sorted(claims, key=lambda claim: _rank(paper, claim))
    if paper.where:
        jobs = [(paper.where, claim.id) for claim in order]
        findings = run(_checked_there, jobs, workers, tell, "checking")
    else:
        findings = run(checked, order, workers, tell, "checking")
    found = {claim.id: finding for claim, finding in zip(order, findings, strict=True)}
    return collected(paper, [(claim, found[claim.id]) for claim in claims])


def _rank(paper: Paper, claim: Claim) -> int:
    return paper.slow.index(claim.id) if claim.id in paper.slow else len(paper.slow)


def _checked_there(job: tuple[str, str]) -> Finding:
    """The finding of a claim by the place of its paper and its name, which travel between processes."""
    where, name = job
    return checked(load(where).claim(name))


def checked(claim: Claim) -> Finding:
    """The finding; a check that comes to no end is a finding too, with its reason."""
    try:
        return claim.check(claim)
    except MpsolveError as error:
        return Finding(Verdict.UNDECIDABLE, f"The check came to no end: {error}", stopped=True)

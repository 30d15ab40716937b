"""What `roots` and `real_roots` share: the effort they may take, and the verifier's word on their certificates."""

from __future__ import annotations

from dataclasses import replace
from typing import TYPE_CHECKING

from mpsolve.outcome import Reason, Status
from mpsolve.progress import Progress
from mpsolve.proof.effort import Effort, begun
from mpsolve.proof.in_time import in_time
from mpsolve.zeros.answer import Zeros

if TYPE_CHECKING:
    from mpsolve.certificate.format import Certificate

_EVALUATIONS = 400_000
_REMEDY = "report this as a fault, with the input"


def budget_of(effort: Effort | None) -> Effort:
    """A fresh effort of the size that is asked for."""
    return begun(effort, _EVALUATIONS)


def checked(answer: Zeros, certificate: Certificate, budget: Effort | None, tell: Progress) -> Zeros:
    """The answer with the verifier's word on its certificate, within the effort; None: it is not asked."""
    if budget is None:
        return replace(answer, certificate=certificate)
    from mpsolve.certificate.verify_roots import verify_bytes

    tell("verifying", 0.0)
    verdict, why, seconds = in_time(lambda: verify_bytes(certificate.text.encode("ascii")), budget)
    cost = replace(answer.cost, verification=seconds)
    if verdict is None:
        return replace(answer, certificate=certificate, verified=why, cost=cost)
    if verdict.valid:
        return replace(answer, status=Status.PROVED, certificate=certificate, verified=verdict.claim, cost=cost)
    message = f"the standalone verifier does not accept the proof: {verdict.reason}"
    reason = Reason("verifier", message, {}, _REMEDY)
    return replace(
        answer, status=Status.UNDECIDED, reason=reason, count=None, roots=(), certificate=certificate, cost=cost
    )

"""The effort is fresh for each call; an answer is proved only by the verifier's word."""

from __future__ import annotations

import json

import pytest

from mpsolve import Effort, InputError, Rectangle, Status, roots
from mpsolve.certificate.format import Certificate, digest
from mpsolve.certificate.roots_check import budget_of, checked
from mpsolve.progress import silent


def test_an_effort_is_not_spent_twice() -> None:
    given = Effort(evaluations=50)
    given.spend(40)
    assert budget_of(given).spent == 0
    with pytest.raises(InputError):
        budget_of(3)  # type: ignore[arg-type]


def test_a_certificate_that_the_verifier_refuses_leaves_nothing_proved() -> None:
    answer = roots("sin(z)", Rectangle(-4, 4, -1, 1), check=False)
    assert answer.status is Status.UNVERIFIED
    assert checked(answer, answer.certificate, Effort(), silent).status is Status.PROVED
    content = json.loads(answer.certificate.text)
    content["claim"]["count"] = 2
    content["sha256"] = digest({key: value for key, value in content.items() if key != "sha256"})
    refused = checked(answer, Certificate(content), Effort(), silent)
    assert refused.status is Status.UNDECIDED
    assert refused.count is None

import signal

import pytest

from mpsolve import Effort, Status
from mpsolve.certificate.format import Certificate
from mpsolve.errors import CertificateError
from mpsolve.ranges.verified import verified


def test_what_is_not_asked_for_is_not_made() -> None:
    def never() -> Certificate:
        raise AssertionError

    made = verified(never, 10, None)
    assert (made.status, made.certificate) == (Status.UNVERIFIED, None)
    assert "not asked" in made.note


def test_a_certificate_that_cannot_be_made_says_why() -> None:
    def fails() -> Certificate:
        raise CertificateError("no power of two")

    made = verified(fails, 10, Effort())
    assert (made.status, made.certificate, made.note) == (Status.UNVERIFIED, None, "no power of two")


def test_a_certificate_that_is_refused_is_none() -> None:
    made = verified(lambda: Certificate({"kind": "stable"}), 10, Effort())
    assert (made.status, made.certificate) == (Status.UNVERIFIED, None)
    assert made.note.startswith("the verifier does not pass one")


@pytest.mark.skipif(not hasattr(signal, "setitimer"), reason="there is no such timer here")
def test_what_takes_longer_than_the_effort_is_none(monkeypatch: pytest.MonkeyPatch) -> None:
    def slow(*_: object) -> None:
        while True:
            pass

    monkeypatch.setattr("mpsolve.certificate.verify_ranges.verify_bytes", slow)
    made = verified(lambda: Certificate({"kind": "stable"}), 10, Effort(seconds=0.2))
    assert (made.status, made.certificate) == (Status.UNVERIFIED, None)
    assert "the effort of 0.2 s" in made.note
    assert 0.1 < made.seconds < 1
